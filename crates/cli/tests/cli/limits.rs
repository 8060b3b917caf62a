//! Tests `frictiongen limits`.

use crate::common::{BLOCK, FRAME, cells, json, output};
use std::f64::consts::FRAC_PI_4;

#[test]
fn table() {
    let text = output("", &["limits", FRAME, "--r", "0,0.2:0.2:0.6"]);
    let expected = "\
Frame: 2 masses, contact upper - wall, base motion, modal damping on absolute velocities, stiction 1.2

natural frequencies (rad/s)     11.980928     32.125314
resonances r                     0.628045      1.684022
groups                       r = omega sqrt(m1/k1), beta = F/(k1 Y)

  r  continuous limit  without search      per mode  sliding limit
             beta_lim        beta_lim      beta_lim      beta*_lim
---  ----------------  --------------  ------------  -------------
0.0                 0               0             0       0.438719
0.2          0.019982        0.020868      0.017163       0.447188
0.4          0.219029        0.219029      0.219029       0.474678
0.6          0.508154        0.508154      0.504957       0.528859
";
    assert_eq!(text, expected);
}

#[test]
fn one_mass_on_a_wall_at_its_resonance() {
    let text = output(BLOCK, &["limits", "--r", "1", "--csv"]);
    let cells = cells(&text);
    assert_eq!(
        cells[0],
        [
            "r",
            "continuous_limit",
            "continuous_limit_without_search",
            "continuous_limit_per_mode",
            "sliding_limit"
        ]
    );
    for limit in &cells[1][1..4] {
        let limit: f64 = limit.parse().unwrap();
        assert!((limit - FRAC_PI_4).abs() < 1e-15, "{limit}");
    }
    assert_eq!(cells[1][0], "1.0");
    assert_eq!(cells[1][4], "1.0");
    assert!(output(BLOCK, &["limits", "--r", "1"]).contains("0.785398"));
}

#[test]
fn csv_gives_every_digit_and_infinity() {
    let scene = BLOCK
        .replace("block - wall", "block - base")
        .replace("excitation: block", "excitation: base");
    let text = output(&scene, &["limits", "-", "--r", "0.5:0.25:1,inf", "--csv"]);
    let cells = cells(&text);
    assert_eq!(cells.len(), 5);
    assert_eq!(cells[4], ["inf", "inf", "inf", "inf", "inf"]);
    let table = output(&scene, &["limits", "-", "--r", "inf"]);
    assert_eq!(table.matches("inf").count(), 5);
}

#[test]
fn json_has_the_numbers_of_the_csv() {
    let arguments = ["limits", FRAME, "--r", "0:0.1:3,inf"];
    let csv = output("", &[&arguments[..], &["--csv"]].concat());
    let json = json(&output("", &[&arguments[..], &["--json"]].concat()));
    assert_eq!(json["scene"], "Frame");
    assert_eq!(json["natural_frequencies"].as_array().unwrap().len(), 2);
    assert_eq!(json["resonances"][0], 0.628_045_137_155_601_2);
    let cells = cells(&csv);
    let points = json["points"].as_array().unwrap();
    assert_eq!(points.len(), cells.len() - 1);
    for (point, line) in points.iter().zip(&cells[1..]) {
        for (name, cell) in cells[0].iter().zip(line) {
            match *cell {
                "inf" => assert_eq!(point[name], "inf"),
                _ => assert_eq!(point[name], cell.parse::<f64>().unwrap()),
            }
        }
    }
}

#[test]
fn fields_of_the_json_keep_their_order() {
    let text = output(BLOCK, &["limits", "--r", "1", "--json"]);
    let names = [
        "scene",
        "natural_frequencies",
        "resonances",
        "points",
        "continuous_limit",
        "continuous_limit_per_mode",
        "continuous_limit_without_search",
        "\"r\"",
        "sliding_limit",
    ];
    let places: Vec<usize> = names.iter().map(|name| text.find(name).unwrap()).collect();
    assert!(places.is_sorted(), "{text}");
}

#[test]
fn many_natural_frequencies_are_cut_short() {
    let masses: Vec<String> = (0..12).map(|index| format!("m{index}: 1")).collect();
    let springs: Vec<String> = (1..12)
        .map(|index| format!("m{} - m{index}: 1", index - 1))
        .collect();
    let scene = format!(
        "struct Chain {{ masses: {{ {} }}, springs: {{ base - m0: 1, {} }},
         contact: m0 - m1, excitation: m11, damping: rayleigh(0, 0.01) }}",
        masses.join(", "),
        springs.join(", ")
    );
    let text = output(&scene, &["limits", "--r", "1"]);
    let first = "Chain: 12 masses, contact m0 - m1, force on m11, Rayleigh damping, stiction 1.0\n";
    assert!(text.starts_with(first), "{text}");
    assert_eq!(text.matches("... (12 in all)").count(), 2);
    let json = json(&output(&scene, &["limits", "--r", "1", "--json"]));
    assert_eq!(json["resonances"].as_array().unwrap().len(), 12);
}

#[test]
fn runs_are_repeatable() {
    for format in ["--csv", "--json"] {
        let arguments = ["limits", FRAME, "--r", "0:0.01:3", format];
        assert_eq!(output("", &arguments), output("", &arguments));
    }
}

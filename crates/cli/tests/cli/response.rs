//! Tests `frictiongen response`.

use crate::common::{BLOCK, FRAME, cells, json, output};
use std::f64::consts::{FRAC_PI_2, PI};

/// Description of two masses in a row, of which the first mass rubs.
const PAIR: &str = "struct Pair {
    masses: { a: 1, b: 1 },
    springs: { base - a: 1, a - b: 1 },
    contact: a - wall,
    excitation: b,
}";

#[test]
fn table() {
    let arguments = ["response", FRAME, "--r", "0.8,1.4", "--beta", "0.05,0.5"];
    let text = output("", &arguments);
    let table = text
        .split_once("\n\n")
        .unwrap()
        .1
        .split_once("\n\n")
        .unwrap()
        .1;
    let expected = "
  r  beta  regime            margin  answer                 offset  motion      amplitude         phase   fundamental  monoharmonic
                                                            (of Y)                 (of Y)         (rad)         (rad)        (of Y)
---  ----  ----------  ------------  ---------------  ------------  -------  ------------  ------------  ------------  ------------
0.8  0.05  continuous     -0.890516  closed form                 0  contact      2.054975      3.008603      3.022042      2.054975
                                                                    lower        0.882671      2.937084      2.931494      0.882670
                                                                    upper        2.054975      3.008603      3.022042      2.054975
0.8  0.50  stick-slip      0.094845  orbit: stable               0  contact      0.517832      1.798835      2.260305
                                                                    lower        0.532463      0.632451      0.706257
                                                                    upper        0.517832      1.798835      2.260305
1.4  0.05  continuous     -0.955801  closed form                 0  contact      0.812203     -3.122866     -3.113081      0.812203
                                                                    lower        0.616396      0.171608      0.172037      0.616393
                                                                    upper        0.812203     -3.122866     -3.113081      0.812203
1.4  0.50  continuous     -0.558008  closed form                 0  contact      0.782628      2.992048      3.093234      0.782628
                                                                    lower        0.877175      0.707945      0.705123      0.875084
                                                                    upper        0.782628      2.992048      3.093234      0.782628
";
    assert_eq!(format!("\n{table}"), expected);
}

#[test]
fn table_of_one_mass_with_harmonics() {
    let arguments = ["response", "--r", "2", "--beta", "0.2", "--harmonics", "4"];
    let text = output(BLOCK, &[&arguments[..], &["--mass", "block"]].concat());
    assert!(text.contains("beta = F/P"), "{text}");
    let lines: Vec<&str> = text.lines().skip(6).collect();
    for name in ["|X_1|", "lag X_1", "|X_3|", "lag X_3"] {
        assert!(lines[0].contains(name), "{text}");
    }
    assert!(!lines[0].contains("X_5"), "{text}");
    assert!(lines[1].contains("(of P/k1)"), "{text}");
    assert_eq!(lines.len(), 5, "{text}");
}

#[test]
fn one_mass_follows_the_closed_form() {
    let arguments = ["response", "--r", "2", "--beta", "0.2", "--csv"];
    let text = output(BLOCK, &arguments);
    let cells = cells(&text);
    let value = |name: &str| -> f64 {
        let place = cells[0].iter().position(|cell| *cell == name);
        cells[1][place.unwrap()].parse().unwrap()
    };
    // The closed form is Z² = V² − (βU)² with V = 1/(1 − r²), U = tan(π/2r)/r.
    let (v, u) = (-1.0 / 3.0_f64, 0.2 * 0.5);
    let amplitude = (v * v - u * u).sqrt();
    let phase = (-u).atan2(amplitude) + PI;
    for part in ["contact", "block"] {
        assert!((value(&format!("{part}.amplitude")) - amplitude).abs() < 1e-15);
        assert!((value(&format!("{part}.amplitude_monoharmonic")) - amplitude).abs() < 1e-15);
        assert!((value(&format!("{part}.phase")) - phase).abs() < 1e-15);
    }
    assert_eq!(cells[1][2], "continuous");
}

#[test]
fn csv_leaves_cells_empty_where_there_is_no_answer() {
    let arguments = [
        "response",
        "--r",
        "0,1",
        "--beta",
        "0.2,4",
        "--harmonics",
        "1",
    ];
    let text = output(BLOCK, &[&arguments[..], &["--csv"]].concat());
    let expected = "\
r,beta,regime,margin,answer,offset,marginal,from_rest,\
contact.amplitude,contact.phase,contact.fundamental_phase,contact.amplitude_monoharmonic,\
contact.X1.amplitude,contact.X1.phase,\
block.amplitude,block.phase,block.fundamental_phase,block.amplitude_monoharmonic,\
block.X1.amplitude,block.X1.phase";
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], expected);
    assert_eq!(lines[1], "0.0,0.2,stick-slip,inf,no cycle,,,,,,,,,,,,,,,");
    // A mass that does not move has no phase.
    assert_eq!(
        lines[2],
        "0.0,4.0,stuck,inf,closed form,0.0,true,true,,,,,,,0.0,,,,,"
    );
    assert!(lines[3].starts_with("1.0,0.2,unbounded,-0.74535"), "{text}");
    assert!(lines[3].ends_with(",unbounded,,,,,,,,,,,,,,,"), "{text}");
    assert!(lines[4].starts_with("1.0,4.0,stuck,4.0929"), "{text}");
    assert!(cells(&text).iter().all(|line| line.len() == 20));
}

#[test]
fn json_says_null_where_there_is_no_motion() {
    let arguments = [
        "response",
        "--r",
        "0",
        "--beta",
        "0.2",
        "--harmonics",
        "1",
        "--json",
    ];
    let json = json(&output(BLOCK, &arguments));
    let point = &json["points"][0];
    assert_eq!(point["regime"], "stick-slip");
    assert_eq!(point["margin"], "inf");
    for part in [&point["contacts"][0], &point["masses"][0]] {
        for name in ["amplitude", "phase", "amplitude_monoharmonic", "harmonics"] {
            assert!(part.get(name).unwrap().is_null(), "{point}");
        }
    }
    assert_eq!(point["masses"][0]["name"], "block");
}

#[test]
fn json_has_harmonics_that_sum_to_the_motion() {
    let arguments = [
        "response", FRAME, "--r", "0.9", "--beta", "0.2", "--mass", "lower",
    ];
    let more = ["--harmonics", "999", "--json"];
    let json = json(&output("", &[&arguments[..], &more].concat()));
    let lower = &json["points"][0]["masses"][0];
    let phase = lower["phase"].as_f64().unwrap();
    let harmonics = lower["harmonics"].as_array().unwrap();
    assert_eq!(harmonics.len(), 500);
    // `sum` is the series Re Σ X_n e^{inτ} at the phase of the largest displacement.
    let mut sum = 0.0;
    for harmonic in harmonics {
        let field = |name: &str| harmonic[name].as_f64().unwrap();
        let angle = field("n") * phase;
        sum += field("re") * angle.cos() - field("im") * angle.sin();
        assert!((field("amplitude") - field("re").hypot(field("im"))).abs() < 1e-15);
        assert!((field("amplitude") * field("phase").cos() - field("re")).abs() < 1e-15);
        assert!((field("amplitude") * field("phase").sin() + field("im")).abs() < 1e-15);
    }
    assert!(
        (sum - lower["amplitude"].as_f64().unwrap()).abs() < 1e-8,
        "{sum}"
    );
    assert_eq!(json["points"][0]["masses"].as_array().unwrap().len(), 1);
}

#[test]
fn stuck_masses_have_an_amplitude_and_a_lag() {
    let arguments = [
        "response", "-", "--r", "1,2", "--beta", "9", "--mass", "b", "--csv",
    ];
    let text = output(PAIR, &arguments);
    let cells = cells(&text);
    // If a sticks, b moves alone with amplitude 1/(1 − r²). At its resonance r = 1 no friction keeps a stuck.
    assert_eq!(cells[2][2], "stuck");
    let value = |column: usize| -> f64 { cells[2][column].parse().unwrap() };
    assert!((value(12) - 1.0 / 3.0).abs() < 1e-15, "{text}");
    assert_eq!(value(13), PI, "{text}");
    assert_eq!(cells[1][2], "stick-slip", "{text}");
    let text = output(PAIR, &arguments[..8]);
    let line = text.lines().last().unwrap();
    let expected = "2     9  stuck          38.474122  closed form                 0  b            0.333333      3.141593      3.141593";
    assert_eq!(line, expected);
}

#[test]
fn an_undamped_resonance_is_unbounded() {
    let json_text = output(PAIR, &["limits", "--r", "1", "--json"]);
    let json = json(&json_text);
    let r = json["resonances"][1].to_string();
    let text = output(PAIR, &["response", "--r", &r, "--beta", "0.1", "--csv"]);
    let cells = cells(&text);
    assert_eq!(cells[1][0], r);
    assert_eq!(cells[1][2], "unbounded");
    assert_eq!(cells[1][4], "unbounded");
    assert!(cells[1][5..].iter().all(|cell| cell.is_empty()), "{text}");
}

#[test]
fn masses_come_in_the_order_asked_for_and_once() {
    let masses = ["--mass", "upper", "--mass", "lower", "--mass", "upper"];
    let arguments = ["response", FRAME, "--r", "0.9", "--beta", "0.2", "--csv"];
    let text = output("", &[&arguments[..], &masses].concat());
    let cells = cells(&text);
    let names: Vec<&str> = cells[0]
        .iter()
        .filter_map(|name| name.strip_suffix(".phase"))
        .collect();
    assert_eq!(names, ["contact", "upper", "lower"]);
}

#[test]
fn phases_stay_in_their_interval() {
    let arguments = [
        "response", "-", "--r", "0:0.05:3", "--beta", "0:0.1:3", "--csv",
    ];
    let text = output(PAIR, &arguments);
    let cells = cells(&text);
    let phases: Vec<usize> = (0..cells[0].len())
        .filter(|at| cells[0][*at].ends_with("phase"))
        .collect();
    let mut regimes = std::collections::BTreeSet::new();
    for line in &cells[1..] {
        regimes.insert(line[2]);
        for at in &phases {
            let phase: f64 = line[*at].parse().unwrap_or(FRAC_PI_2);
            assert!(-PI < phase && phase <= PI, "{line:?}");
        }
        let margin: f64 = line[3].parse().unwrap();
        assert_eq!(margin < 0.0, line[2] == "continuous", "{line:?}");
    }
    assert_eq!(
        regimes.into_iter().collect::<Vec<_>>(),
        ["continuous", "stick-slip", "stuck"]
    );
    assert_eq!(cells.len(), 61 * 31 + 1);
}

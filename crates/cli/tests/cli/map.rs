//! Tests pictures of maps. Their legend states which values lie beyond the colour scale.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{FRAME, output};
use std::path::PathBuf;

/// Returns the text of a drawn map, and the amplitudes of `lower` in mm from the CSV of the same map.
fn drawn(hz: &str, shade: &str, base: &str) -> (String, Vec<f64>) {
    let grid = [
        "--hz",
        hz,
        "--friction",
        "0.05:0.1:2.05",
        "--base",
        base,
        "--of",
        "lower",
    ];
    let name = format!("map-{}-{shade}-{base}.svg", hz.replace(':', "-"));
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let path = path.to_str().unwrap();
    let options = ["--shade", shade, "-o", path];
    output("", &[&["map", FRAME][..], &grid, &options].concat());
    let csv = output("", &[&["map", FRAME, "--csv"][..], &grid].concat());
    let mut lines = csv.lines();
    let names = lines.next().unwrap().split(',');
    let place = names
        .clone()
        .position(|name| name == "lower.amplitude_m")
        .unwrap();
    let cell = |line: &str| line.split(',').nth(place).unwrap().parse::<f64>().ok();
    let sizes = lines.filter_map(cell).map(|metres| 1e3 * metres).collect();
    (std::fs::read_to_string(path).unwrap(), sizes)
}

/// Returns the number after a word in a picture without its tags.
fn after(picture: &str, word: &str) -> Option<f64> {
    let (_, rest) = picture.split_once(word)?;
    let digits = |letter: char| letter.is_ascii_digit() || letter == '.';
    let text: String = rest
        .trim_start()
        .chars()
        .take_while(|c| digits(*c))
        .collect();
    text.parse().ok()
}

/// Checks that next to a resonance the colours end below the largest amplitude. The legend states the value of the last
/// colour and the largest amplitude.
#[test]
fn a_clipped_scale_says_so() {
    let (picture, sizes) = drawn("1:0.05:4", "amplitude", "0.001");
    let most = sizes.iter().copied().fold(0.0, f64::max);
    let end = after(&picture, "top colour ≥").unwrap();
    let largest = after(&picture, "largest").unwrap();
    // The legend prints four digits.
    assert!((largest / most - 1.0).abs() < 1e-3, "{largest} for {most}");
    assert!(end < 0.7 * most, "{end} of {most}: nothing is clipped");
    let beyond = sizes.iter().filter(|size| end < **size).count();
    assert!(
        0 < beyond && beyond * 10 <= sizes.len(),
        "{beyond} of {}",
        sizes.len()
    );
}

/// Checks that without a resonance the colour scale covers all values, and that the legend has no remark about it.
#[test]
fn a_whole_scale_says_nothing() {
    for (hz, shade) in [("4.6:0.1:5", "amplitude"), ("1:0.05:4", "stuck")] {
        let (picture, _) = drawn(hz, shade, "0.001");
        assert!(!picture.contains("top colour"), "{hz}, {shade}");
    }
}

/// Returns the cells of some columns of a table in CSV, line by line.
fn cells(csv: &str, names: &[&str]) -> Vec<Vec<String>> {
    let head: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    let place = |name: &&str| head.iter().position(|other| other == name).unwrap();
    let places: Vec<usize> = names.iter().map(place).collect();
    let line = |line: &str| {
        let all: Vec<&str> = line.split(',').collect();
        places.iter().map(|place| all[*place].to_owned()).collect()
    };
    csv.lines().skip(1).map(line).collect()
}

/// Compares two tables: words must be equal, and numbers within a relative error of 1e-9.
fn same(found: &[Vec<String>], other: &[Vec<String>]) {
    assert_eq!(found.len(), other.len());
    for (a, b) in found.iter().flatten().zip(other.iter().flatten()) {
        match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(x), Ok(y)) => assert!((x - y).abs() <= 1e-9 * x.abs().max(y.abs()), "{a} {b}"),
            _ => assert_eq!(a, b),
        }
    }
}

/// Checks a map under loads whose amplitude depends on frequency. At each frequency it has the columns of `response`
/// under the same load. The maps of one frequency have a constant amplitude, by a formula of this test.
#[test]
fn a_load_over_frequency() {
    let rotor = "struct Rotor { masses: { rotor: 50, frame: 20 },
        springs: { base - frame: 4e4, frame - rotor: 9e4 }, contact: base - frame, excitation: rotor,
        damping: modal(0.02) }";
    let frame = std::fs::read_to_string(FRAME).unwrap();
    let square = |hertz: f64| (std::f64::consts::TAU * hertz).powi(2);
    let acceleration = |hertz: f64| format!("{:?}", 0.2 * 9.80665 / square(hertz));
    let velocity = |hertz: f64| format!("{:?}", 0.05 / square(hertz).sqrt());
    let unbalance = |hertz: f64| format!("{:?}", 0.02 * square(hertz));
    type Amplitude<'a> = (&'a str, &'a dyn Fn(f64) -> String);
    type Case<'a> = (&'a str, [&'a str; 2], Amplitude<'a>, &'a str, &'a str);
    let cases: [Case<'_>; 3] = [
        (
            &frame,
            ["--base", "0.2g"],
            ("--base", &acceleration),
            "2:9:40",
            "lower",
        ),
        (
            &frame,
            ["--base", "0.05 m/s"],
            ("--base", &velocity),
            "0.3:1.1:4",
            "lower",
        ),
        (
            rotor,
            ["--unbalance", "0.02"],
            ("--force", &unbalance),
            "1:9:37",
            "rotor",
        ),
    ];
    for (text, load, (option, amplitude), frictions, mass) in cases {
        let part = format!("{mass}.amplitude_m");
        let names = [
            "frequency_Hz",
            "friction_N",
            "beta",
            "regime",
            "from_rest",
            &part,
        ];
        let asked = |command: &str, hertz: &str, load: [&str; 2]| {
            let line = [command, "--hz", hertz, "--friction", frictions, "--csv"];
            let csv = output(text, &[&line[..], &load].concat());
            cells(&csv, &names)
        };
        let all = asked("map", "1.5,2.5,5.5", load);
        same(&all, &asked("response", "1.5,2.5,5.5", load));
        let regimes: Vec<&String> = all.iter().map(|row| &row[3]).collect();
        assert!(
            regimes.iter().any(|regime| *regime != regimes[0]),
            "{regimes:?}"
        );
        let count = all.len() / 3;
        for (hertz, here) in [1.5, 2.5, 5.5].into_iter().zip(all.chunks(count)) {
            let (one, constant) = (hertz.to_string(), amplitude(hertz));
            same(here, &asked("map", &one, [option, &constant]));
            let boundaries = |load: [&str; 2]| {
                let line = [
                    "map",
                    "--hz",
                    &one,
                    "--friction",
                    "1:3:61",
                    "--boundaries",
                    "6",
                ];
                let csv = output(text, &[&line[..], &["--csv"], &load].concat());
                cells(&csv, &["friction_N", "below", "above"])
            };
            let [found, other] = [load, [option, &constant]].map(boundaries);
            // The boundaries have six digits.
            assert!(!found.is_empty(), "{load:?} {hertz}");
            assert_eq!(found.len(), other.len());
            for (a, b) in found.iter().zip(&other) {
                let [x, y] = [a, b].map(|row| row[0].parse::<f64>().unwrap());
                assert!(
                    (x / y - 1.0).abs() < 3e-6 && a[1..] == b[1..],
                    "{a:?} {b:?}"
                );
            }
        }
    }
    // The picture has the amplitudes of the table.
    let (picture, sizes) = drawn("1:0.05:4", "amplitude", "0.2g");
    let most = sizes.iter().copied().fold(0.0, f64::max);
    let largest = after(&picture, "largest").unwrap();
    assert!((largest / most - 1.0).abs() < 1e-3, "{largest} for {most}");
}

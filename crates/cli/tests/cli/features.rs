//! Tests the output of `frictiongen features`, and the requests that it refuses.

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{BLOCK, FRAME, cells, failure, json, output, words};

const UPPER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/thesis/two_m2.friction");

/// Parses the rows of a CSV as maps from column names to cells.
fn rows(csv: &str) -> Vec<std::collections::HashMap<String, String>> {
    let cells = cells(csv);
    let each = cells[1..].iter().map(|row| {
        assert_eq!(row.len(), cells[0].len());
        let named = cells[0].iter().zip(row);
        named
            .map(|(name, cell)| ((*name).to_owned(), (*cell).to_owned()))
            .collect()
    });
    each.collect()
}

/// Checks that the three formats agree, and that Hz, N and m are the groups times their units.
#[test]
fn in_units_and_in_three_formats() {
    let groups = rows(&output(
        "",
        &[
            "features", FRAME, "--r", "0.35:2.3", "--beta", "0.3", "--csv",
        ],
    ));
    let hertz = |r: f64| r * (1190.0_f64 / 3.27).sqrt() / std::f64::consts::TAU;
    let range = format!("{:?}:{:?}", hertz(0.35), hertz(2.3));
    let friction = format!("{:?}", 0.3 * 1.19);
    let line = [
        "features",
        FRAME,
        "--hz",
        &range,
        "--base",
        "0.001",
        "--friction",
        &friction,
    ];
    let physical = rows(&output("", &[&line[..], &["--csv"]].concat()));
    let parsed = json(&output("", &[&line[..], &["--json"]].concat()));
    let points = parsed["points"].as_array().unwrap();
    assert_eq!(
        (groups.len(), points.len()),
        (physical.len(), physical.len())
    );
    assert!(20 < groups.len());
    let number = |text: &String| text.parse::<f64>().ok();
    for ((own, other), point) in groups.iter().zip(&physical).zip(points) {
        for name in ["feature", "of", "detail", "found"] {
            assert_eq!(own[name], other[name]);
            assert_eq!(point[name].as_str(), Some(other[name].as_str()));
        }
        let close = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => assert!((a - b).abs() <= 1e-7 * b.abs(), "{a} {b} {own:?}"),
            (a, b) => assert_eq!(a, b),
        };
        close(number(&own["r"]), number(&other["r"]));
        close(number(&own["r"]).map(hertz), number(&other["frequency_Hz"]));
        close(
            number(&own["beta"]).map(|beta| beta * 1.19),
            number(&other["friction_N"]),
        );
        close(
            number(&own["amplitude"]).map(|x| x * 0.001),
            number(&other["amplitude_m"]),
        );
        close(point["r"].as_f64(), number(&other["r"]));
        assert!(point["derivatives"].is_object());
    }
    let table = output("", &line);
    assert!(table.contains("resonance if stuck") && table.contains("1 % of"));
}

/// Checks that the features equal those that section 6.3.3 of the thesis prints.
#[test]
fn of_the_thesis() {
    let rows = rows(&output("", &["features", UPPER, "--r", "0.62:4", "--csv"]));
    let of = |feature: &str, of: &str, detail: &str| -> Vec<f64> {
        let found = rows.iter().filter(|row| {
            row["feature"] == feature && row["of"] == of && row["detail"].starts_with(detail)
        });
        found.map(|row| row["r"].parse().unwrap()).collect()
    };
    let close = |found: Vec<f64>, wanted: &[f64]| {
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        for (found, want) in found.iter().zip(wanted) {
            assert!((found - want).abs() < 5e-4, "{found} {want}");
        }
    };
    close(of("invariant point", "contact", "amplitude"), &[1.450]);
    close(of("invariant point", "m1", "amplitude"), &[0.828, 1.549]);
    close(of("grows with friction", "m1", "amplitude"), &[0.828]);
    close(of("resonance if stuck", "", ""), &[2.0_f64.sqrt()]);
}

#[test]
fn refused() {
    let told = |input: &str, line: &str| failure(input, &words(line)).join("\n");
    for (line, words) in [
        ("features --r 0:2", "--r"),
        ("features --r 2:1", "write 1:2"),
        ("features --r 0.5:0.1:2", "without a step"),
        ("features --r 1e-9:2", "crowd"),
        (
            "features --friction 1",
            "--friction needs the amplitude of the load: give --force",
        ),
        ("features --beta nan", "--beta"),
        ("features --beta -1", "--beta"),
        ("features --beta 0:0.01:1", "at most 16 frictions"),
        ("features --of nobody", "there is no mass `nobody`"),
        ("features --base 0.1", "--base"),
        ("features --force 0", "above 0"),
        ("features -o answer.txt", "must end in"),
    ] {
        let told = told(BLOCK, line);
        assert!(told.contains(words), "{line}: {told}");
        assert_eq!(told.lines().count(), 1, "{line}: {told}");
    }
    assert!(!told("struct", "features").is_empty());
}

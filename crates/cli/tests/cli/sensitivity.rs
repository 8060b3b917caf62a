//! Tests `frictiongen sensitivity`: a line for each parameter, three formats, and requests that it refuses.

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{
    BLOCK, FRAME, cells, column_with_gaps as column, failure, json, output, words,
};

const STOPS: &str = "--hz 2.5 --friction 2 --base 0.003 --of upper";

fn run(line: &str, format: &[&str]) -> String {
    output(
        "",
        &[&["sensitivity", FRAME], &words(line)[..], format].concat(),
    )
}

/// Checks that derivatives with respect to friction, load and frequency equal difference quotients of `response`.
#[test]
fn as_the_response_moves() {
    let csv = run(STOPS, &["--csv"]);
    let rows = cells(&csv);
    let parameters: Vec<&str> = rows[1..].iter().map(|row| row[6]).collect();
    assert_eq!(
        parameters,
        [
            "m lower",
            "m upper",
            "k base - lower",
            "k lower - upper",
            "zeta 1",
            "zeta 2",
            "mu",
            "F",
            "Y",
            "f"
        ]
    );
    let units: Vec<&str> = rows[1..].iter().map(|row| row[8]).collect();
    assert_eq!(
        units,
        ["kg", "kg", "N/m", "N/m", "", "", "", "N", "m", "Hz"]
    );
    let moved = |hz: &str, friction: &str, base: &str| {
        let line = format!("--hz {hz} --friction {friction} --base {base} --mass upper --csv");
        let text = output("", &[&["response", FRAME], &words(&line)[..]].concat());
        let of = |name| column(&text, name)[0];
        (of("upper.amplitude_m"), of("upper.phase_deg"))
    };
    let amplitudes = column(&csv, "amplitude_m.derivative");
    let phases = column(&csv, "phase_deg.derivative");
    for (place, h, above, below) in [
        (
            7,
            1e-4,
            moved("2.5", "2.0001", "0.003"),
            moved("2.5", "1.9999", "0.003"),
        ),
        (
            8,
            1e-7,
            moved("2.5", "2", "0.0030001"),
            moved("2.5", "2", "0.0029999"),
        ),
        (
            9,
            1e-4,
            moved("2.5001", "2", "0.003"),
            moved("2.4999", "2", "0.003"),
        ),
    ] {
        for (derivative, difference) in [
            (amplitudes[place], (above.0 - below.0) / (h + h)),
            (phases[place], (above.1 - below.1) / (h + h)),
        ] {
            // The relative error of the difference quotient is of second order in a step of about 5e-5, times a
            // curvature of some hundreds.
            assert!(
                (derivative / difference - 1.0).abs() < 1e-6,
                "{place}: {derivative} {difference}"
            );
        }
    }
    // Relative derivatives are p/X·dX/dp for the amplitude, and p·dφ/dp for the phase.
    let (values, own) = (column(&csv, "value"), column(&csv, "amplitude_m"));
    let relative = column(&csv, "amplitude_m.relative");
    let of_phase = column(&csv, "phase_deg.relative");
    for place in 0..values.len() {
        let expected = values[place] / own[place] * amplitudes[place];
        assert!((relative[place] - expected).abs() <= 1e-12 * expected.abs());
        let expected = values[place] * phases[place];
        assert!((of_phase[place] - expected).abs() <= 1e-12 * expected.abs());
    }
}

/// Checks that the table and the JSON have the content of the CSV.
#[test]
fn in_three_formats() {
    let csv = run(STOPS, &["--csv"]);
    let rows = cells(&csv);
    let parsed = json(&run(STOPS, &["--json"]));
    let points = parsed["points"].as_array().expect("points");
    assert_eq!(points.len(), rows.len() - 1);
    for (point, row) in points.iter().zip(&rows[1..]) {
        for (name, cell) in rows[0].iter().zip(row) {
            match &point[name] {
                serde_json::Value::Number(number) => {
                    assert_eq!(number.as_f64(), cell.parse().ok(), "{name}");
                }
                serde_json::Value::Null => assert_eq!(*cell, ""),
                text => assert_eq!(text.as_str(), Some(*cell)),
            }
        }
    }
    let table = run(STOPS, &[]);
    assert!(
        table.contains("amplitude upper") && table.contains("the answer"),
        "{table}"
    );
    let line = table.lines().find(|line| line.contains("k base - lower"));
    assert!(
        line.is_some_and(|line| line.contains("2.31543e-6") && line.contains("N/m")),
        "{table}"
    );
}

/// Checks that without a load the derivatives are those at constant r and β. They exist for the contact's own motion,
/// and in every regime.
#[test]
fn in_groups_and_in_every_regime() {
    for (line, regime) in [
        ("--r 0.9 --beta 0.3 --of contact", "continuous"),
        ("--r 0.4 --beta 0.3 --of contact", "stick-slip"),
        ("--r 0.4 --beta 2 --of lower", "stuck"),
    ] {
        let csv = run(line, &["--csv"]);
        let rows = cells(&csv);
        assert!(
            rows[1..]
                .iter()
                .all(|row| row[2] == regime && row[3] == "exact"),
            "{csv}"
        );
        let parameters: Vec<&str> = rows[1..].iter().map(|row| row[4]).collect();
        assert_eq!(parameters[7..], ["beta", "r"]);
        // The motion of a stuck chain does not depend on friction.
        let friction = column(&csv, "amplitude.derivative")[7];
        assert_eq!(friction == 0.0, regime == "stuck", "{csv}");
    }
    // A stuck contact does not move, so it has no phase.
    let csv = run("--r 0.4 --beta 2 --of contact", &["--csv"]);
    assert!(column(&csv, "amplitude").iter().all(|value| *value == 0.0));
    assert!(column(&csv, "phase").iter().all(|value| value.is_nan()));
}

/// Checks that the line gives the reason if a derivative does not exist.
#[test]
fn where_there_is_none() {
    let line = "sensitivity --r 1,0.3 --beta 0.1 --of block --csv";
    let text = output(BLOCK, &words(line));
    let rows = cells(&text);
    let answers: Vec<(&str, &str)> = rows[1..].iter().map(|row| (row[0], row[3])).collect();
    assert_eq!(answers[0], ("1.0", "unbounded"));
    assert!(
        answers[1..]
            .iter()
            .all(|answer| *answer == ("0.3", "exact"))
    );
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
}

#[test]
fn what_is_wrong_is_named() {
    let told = |line: &str| {
        let lines = failure(BLOCK, &words(line));
        assert_eq!(lines.len(), 1, "{lines:?}");
        lines[0].clone()
    };
    for (line, message) in [
        (
            "--r 1 --beta 1 --of roof",
            "--of: there is no mass `roof`; the masses are block",
        ),
        (
            "--r 1 --friction 1 --of block",
            "--friction needs the amplitude of the load: give --force",
        ),
        (
            "--r 1 --friction 1 --base 1 --of block",
            "--base: the scene is driven by a force on `block`; its load is given by --force",
        ),
        (
            "--r 1 --friction 1 --force -1 --of block",
            "--force `-1`: the amplitude of a load must be above 0 and finite",
        ),
        (
            "--hz 1 --beta -1 --of block",
            "--beta `-1`: a friction ratio must not be negative",
        ),
        (
            "--hz x --beta 1 --of block",
            "--hz `x`: `x` is not a number",
        ),
    ] {
        assert_eq!(
            told(&format!("sensitivity {line}")),
            format!("frictiongen: {message}")
        );
    }
    for frequency in ["0", "inf"] {
        let line = told(&format!("sensitivity --hz {frequency} --beta 1 --of block"));
        assert!(
            line.contains("above 0 and below infinity") || line.contains("below infinity"),
            "{line}"
        );
    }
    // The option for the motion is missing, so clap reports it with the usage.
    let lines = failure(BLOCK, &words("sensitivity --r 1 --beta 1"));
    assert!(
        lines[0].contains("required") && lines[1].contains("--of"),
        "{lines:?}"
    );
}

//! Tests against problems that users met in their first hour.

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{BLOCK, FRAME, cells, failure, json, output, run_with};

/// Returns the values of a column.
fn column<'a>(cells: &[Vec<&'a str>], name: &str) -> Vec<&'a str> {
    let place = cells[0].iter().position(|cell| *cell == name).unwrap();
    cells[1..].iter().map(|row| row[place]).collect()
}

#[test]
fn a_decimal_grid_has_the_decimal_numbers() {
    let arguments = [
        "response",
        "--r",
        "0.05:0.05:1",
        "--beta",
        "0.1:0.1:0.5",
        "--csv",
    ];
    let text = output(BLOCK, &arguments);
    let cells = cells(&text);
    let betas = column(&cells, "beta");
    assert_eq!(betas[..5], ["0.1", "0.2", "0.3", "0.4", "0.5"]);
    let (mut compared, ratios) = (0, column(&cells, "r"));
    for (index, r) in ratios.iter().step_by(5).enumerate() {
        let hundredths = 5 * (index + 1);
        let expected = if hundredths == 100 {
            "1.0".to_owned()
        } else {
            let text = format!("0.{hundredths:02}");
            text.trim_end_matches('0').to_owned()
        };
        assert_eq!(*r, expected);
        compared += 1;
    }
    assert_eq!((compared, ratios.len()), (20, 100));
}

/// Checks that a point has the same regime in the output of every command.
#[test]
fn a_point_has_one_regime() {
    let absorber = "struct A { masses: { a: 1, b: 1 }, springs: { base - a: 1, a - b: 1 },
        contact: a - wall, excitation: a }";
    let (mut compared, mut unbounded) = (0, 0);
    for scene in [BLOCK, absorber] {
        let grid = |command| {
            let grids = [
                "--r",
                "0.2:0.1:1.8,0.6180339887498949",
                "--beta",
                "0:0.1:1.5",
                "--csv",
            ];
            output(scene, &[&[command][..], &grids].concat())
        };
        let (response, orbit) = (grid("response"), grid("orbit"));
        let (response, orbit) = (cells(&response), cells(&orbit));
        let (of_response, of_orbit) = (column(&response, "regime"), column(&orbit, "regime"));
        assert_eq!(of_response, of_orbit);
        let states = column(&orbit, "state");
        for (regime, state) in of_orbit.iter().zip(states) {
            assert!(*regime != "unbounded" || ["unbounded", "undamped"].contains(&state));
            unbounded += usize::from(*regime == "unbounded");
            compared += 1;
        }
    }
    println!("{compared} points, {unbounded} of them unbounded");
    assert!(compared == 2 * 18 * 16 && unbounded > 10);
}

/// Checks that every cell of a point with a steady state has a value, and that the row names its origin.
#[test]
fn a_curve_in_one_command() {
    let grids = ["--r", "0.1:0.05:2.5", "--beta", "0.4", "--csv"];
    let text = output("", &[&["response", FRAME][..], &grids].concat());
    let cells_ = cells(&text);
    let orbits = output("", &[&["orbit", FRAME][..], &grids].concat());
    let orbits = cells(&orbits);
    let (answers, regimes) = (column(&cells_, "answer"), column(&cells_, "regime"));
    let (upper, expected) = (
        column(&cells_, "upper.amplitude"),
        column(&orbits, "upper.amplitude"),
    );
    let mut counts = [0; 3];
    for (((answer, regime), upper), expected) in
        answers.iter().zip(regimes).zip(upper).zip(expected)
    {
        if regime == "stick-slip" && !upper.is_empty() {
            let filled = ["orbit: ", "subharmonic", "last 64 cycles"];
            assert!(
                filled.iter().any(|word| answer.starts_with(word)),
                "{answer}"
            );
            assert_eq!(upper, expected);
            counts[0] += 1;
        } else if upper.is_empty() {
            assert_eq!(*answer, "unsettled");
            counts[1] += 1;
        } else {
            assert_eq!(*answer, "closed form");
            let (upper, expected): (f64, f64) = (upper.parse().unwrap(), expected.parse().unwrap());
            assert!(
                (upper - expected).abs() < 1e-9 * upper.abs().max(1e-3),
                "{upper} {expected}"
            );
            counts[2] += 1;
        }
    }
    println!("{counts:?}: orbits, none, closed forms");
    assert!(counts[0] > 5 && counts[2] > 20 && counts.iter().sum::<i32>() == 49);
}

/// Checks that the values of a subharmonic state are taken over its two cycles, and those of a motion that does not
/// settle over its last 64 cycles.
#[test]
fn beyond_one_cycle() {
    let rubbing = |stiction: &str| {
        format!(
            "struct Block {{ masses: {{ block: 1 }}, springs: {{ base - block: 1 }}, contact: block - base,
             excitation: base, stiction: {stiction} }}"
        )
    };
    let points = [
        ("2", "0.4076", "0.01787", "stable", "2", "subharmonic"),
        (
            "3",
            "0.3333333333333333",
            "0.01395",
            "unsettled",
            "",
            "last 64 cycles",
        ),
    ];
    for (stiction, r, beta, state, period, answer) in points {
        let scene = rubbing(stiction);
        let asked = ["-", "--r", r, "--beta", beta, "--csv"];
        let orbit = output(&scene, &[&["orbit"][..], &asked].concat());
        let orbit = cells(&orbit);
        assert_eq!(column(&orbit, "state"), [state]);
        assert_eq!(column(&orbit, "period"), [period]);
        let response = output(&scene, &[&["response"][..], &asked].concat());
        let response = cells(&response);
        assert_eq!(column(&response, "answer"), [answer]);
        let amplitudes =
            [&orbit, &response].map(|cells| column(cells, "block.amplitude")[0].to_owned());
        assert_eq!(amplitudes[0], amplitudes[1]);
        let amplitude: f64 = amplitudes[0].parse().unwrap();
        assert!(amplitude > 1.0, "{amplitude}");
        let json = output(&scene, &["orbit", "-", "--r", r, "--beta", beta, "--json"]);
        assert!(
            json.contains(if period.is_empty() {
                "\"period\":null"
            } else {
                "\"period\":2"
            }),
            "{json}"
        );
    }
}

#[test]
fn at_infinity_nothing_moves() {
    for format in ["--csv", "--json"] {
        let arguments = [
            "response",
            "--r",
            "inf",
            "--beta",
            "0.1",
            "--harmonics",
            "3",
            format,
        ];
        let text = output(BLOCK, &arguments);
        if format == "--csv" {
            let cells = cells(&text);
            for name in [
                "block.amplitude",
                "contact.amplitude_monoharmonic",
                "block.X3.amplitude",
            ] {
                assert_eq!(column(&cells, name), ["0.0"], "{name}");
            }
        } else {
            let point = &json(&text)["points"][0];
            assert_eq!(point["masses"][0]["amplitude"], 0.0);
        }
    }
    // At r = ∞ the mass does not move, so the relative motion in the contact is the motion of the base.
    let shaken = "struct S { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - base, excitation: base }";
    let text = output(
        shaken,
        &["response", "--r", "inf", "--beta", "0.1", "--csv"],
    );
    let cells = cells(&text);
    assert_eq!(column(&cells, "contact.amplitude"), ["1.0"]);
    assert_eq!(column(&cells, "a.amplitude"), ["0.0"]);
}

#[test]
fn no_advice_that_is_refused() {
    let told = |arguments: &[&str]| failure(BLOCK, arguments).join("\n");
    let beta = told(&["response", "--r", "1", "--beta", "1e400"]);
    assert_eq!(beta, "frictiongen: --beta `1e400`: `1e400` is too large");
    let orbit = told(&["orbit", "--r", "1e400", "--beta", "1"]);
    assert_eq!(orbit, "frictiongen: --r `1e400`: `1e400` is too large");
    let range = told(&["limits", "--r", "1:1:1e400"]);
    assert_eq!(range, "frictiongen: --r `1:1:1e400`: `1e400` is too large");
    let limits = told(&["limits", "--r", "1e400"]);
    assert!(limits.ends_with("write inf for infinity"));
    output(BLOCK, &["limits", "--r", "inf"]);
    let help = run_with("", &["orbit", "--help"]).out;
    assert!(!help.contains("may be 0 and inf") && help.contains("above 0 and below infinity"));
}

/// Checks that every command refuses an incomplete declaration, and prints nothing on standard output.
#[test]
fn what_is_said_by_halves_is_refused() {
    for (field, told) in [
        ("accuracy: 1e-6", "needs a range of frequency ratios"),
        (
            "range: { r: 0.1..2, beta: 0..1 }",
            "`range` has an effect only with an accuracy",
        ),
    ] {
        let scene = BLOCK.replace("excitation: block,", &format!("excitation: block, {field}"));
        let points: &[&str] = &["--r", "1", "--beta", "1"];
        for (command, rest) in [
            ("expand", &[][..]),
            ("limits", &points[..2]),
            ("response", points),
            ("orbit", points),
        ] {
            let run = run_with(&scene, &[&[command][..], rest].concat());
            assert_eq!(
                (run.status, run.out.as_str()),
                (Some(2), ""),
                "{command}: {field}"
            );
            assert!(run.err.contains(told), "{command}: {}", run.err);
            assert_eq!(run.err.lines().count(), 1);
        }
    }
    output(
        &BLOCK.replace("excitation: block,", "excitation: block, accuracy: exact"),
        &["expand"],
    );
}

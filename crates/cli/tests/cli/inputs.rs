//! Tests motions under inputs in closed form (`--input`).

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{FRAME, column, failure, output, texts};

/// A block on the floor.
const BLOCK: &str =
    "struct Block { masses: { block: 2 }, contacts: { floor: block - wall { stiction: 1.5 } },
    excitation: block }";

/// A force of 5 N for 1 s.
const STEP: [&str; 6] = [
    "--input",
    "step 5 N from 0.5 s for 1 s",
    "--until",
    "2.5",
    "--friction",
    "3",
];

fn line<'a>(command: &'a str, file: &'a str, rest: &[&'a str]) -> Vec<&'a str> {
    let mut line = vec![command, file];
    line.extend(rest);
    line
}

#[test]
fn a_block_slides_under_a_step() {
    let asked = line(
        "time",
        "-",
        &[&STEP[..], &["--samples", "10", "--csv"]].concat(),
    );
    let samples = output(BLOCK, &asked);
    let (times, speeds) = (
        column(&samples, "time_s"),
        column(&samples, "block.velocity_m_s"),
    );
    // v = (P − F)t/m until 1.5 s, then friction alone.
    for (time, speed) in times.iter().zip(&speeds) {
        let slid = (time - 0.5).clamp(0.0, 1.0);
        let braked = 1.5 * (time - 1.5).max(0.0);
        assert!(
            (speed - (slid - braked).max(0.0)).abs() < 1e-12,
            "{time}: {speed}"
        );
    }
    let asked = line("time", "-", &[&STEP[..], &["--events", "--csv"]].concat());
    let events = output(BLOCK, &asked);
    assert_eq!(texts(&events, "event"), ["slip", "stop"]);
    assert!((column(&events, "time_s")[1] - 13.0 / 6.0).abs() < 1e-12);
    let text = output(BLOCK, &line("time", "-", &STEP));
    assert!(
        text.contains("inputs over time") && text.contains("input                        step 5 N")
    );

    // `drive` has the same motion at the same instants, and the energies: 3 N over 5/6 m.
    let asked = line(
        "drive",
        "-",
        &[&STEP[..], &["--samples", "10", "--csv"]].concat(),
    );
    let driven = output(BLOCK, &asked);
    assert_eq!(column(&driven, "block.velocity_m_s"), speeds);
    let energies = column(&driven, "floor.energy_J");
    assert!((energies[10] - 2.5).abs() < 1e-12);
    let json = output(
        BLOCK,
        &line("drive", "-", &[&STEP[..], &["--json"]].concat()),
    );
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert!((json["work"]["load_J"].as_f64().expect("a number") - 2.5).abs() < 1e-12);
    assert_eq!(json["samples"].as_array().map_or(1001, Vec::len), 1001);
}

#[test]
fn a_pulse_of_the_base_has_its_peaks() {
    // Without friction in the contact, a short pulse of the acceleration a gives the relative velocity 2aT/π.
    let scene = "struct S { masses: { m: 1 }, springs: { base - m: 1 }, contact: m - wall, excitation: base }";
    let input = [
        "--input",
        "half-sine 10 g for 1 ms",
        "--until",
        "4",
        "--friction",
        "0,0.001",
    ];
    let asked = line(
        "drive",
        "-",
        &[&input[..], &["--peaks", "--of", "m-base", "--csv"]].concat(),
    );
    let peaks = output(scene, &asked);
    let peak = column(&peaks, "peak");
    let expected = 2.0 * 98.0665 * 1e-3 / std::f64::consts::PI;
    assert!((peak[0].abs() / expected - 1.0).abs() < 1e-6, "{peak:?}");
    assert!(peak[1] != peak[0]);
}

#[test]
fn what_is_refused() {
    for (command, rest, says) in [
        (
            "time",
            &["--until", "1", "--friction", "1"][..],
            "an input over time, --input",
        ),
        (
            "time",
            &["--input", "step 1 mm", "--friction", "1"],
            "--until <S>",
        ),
        (
            "time",
            &["--input", "leap 1 mm", "--until", "1", "--friction", "1"],
            "`leap` is no shape",
        ),
        (
            "time",
            &["--input", "step 1 N", "--until", "1", "--friction", "1"],
            "name a mass as in `on lower`",
        ),
        (
            "time",
            &[
                "--input",
                "step 1 mm",
                "--until",
                "1",
                "--friction",
                "1",
                "--base",
                "1mm",
            ],
            "cannot be used with",
        ),
        ("drive", &["--friction", "1"], "<RECORDING>"),
        (
            "drive",
            &["--input", "step 1 mm", "--until", "1"],
            "--friction <F>",
        ),
        (
            "drive",
            &["--input", "step 1 mm", "--friction", "1"],
            "--until <S>",
        ),
        (
            "drive",
            &[
                "--input",
                "step 1 mm",
                "--input",
                "step 1 g",
                "--until",
                "1",
                "--friction",
                "1",
            ],
            "only one input can move the base",
        ),
        (
            "drive",
            &[
                "--input",
                "step 1 mm",
                "--until",
                "1e6",
                "--samples",
                "2",
                "--friction",
                "1",
            ],
            "too far for the fastest mode",
        ),
        (
            "drive",
            &[
                "x.csv",
                "--input",
                "step 1 mm",
                "--until",
                "1",
                "--friction",
                "1",
            ],
            "cannot be used with",
        ),
    ] {
        let message = failure("", &line(command, FRAME, rest)).join("\n");
        assert!(message.contains(says), "{command} {rest:?}: {message}");
    }
}

//! Tests `frictiongen drive`.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{FRAME, column, failure, file, output};
use std::fs;

/// Returns a recording of the base's acceleration with samples at intervals of 0.01 s. The base moves and then rests.
fn shaken() -> String {
    let mut text = String::from("time_s,base_m_s2\n");
    for sample in 0..200_u32 {
        let time = 0.01 * f64::from(sample);
        let acceleration = if sample < 60 {
            3.0 * (9.0 * time).sin()
        } else {
            0.0
        };
        text += &format!("{time},{acceleration}\n");
    }
    text
}

#[test]
fn tells_work_and_writes_pictures() {
    let path = file("work.csv", &shaken());
    let text = output("", &["drive", FRAME, &path, "--friction", "0.8", "--json"]);
    let answer: serde_json::Value = serde_json::from_str(&text).unwrap();
    let work = |name: &str| answer["work"][name].as_f64().unwrap();
    let left = work("load_J") - work("friction_J") - work("damping_J") - work("stored_J");
    assert!(left.abs() < 1e-12 * work("load_J"), "{left}");
    assert!(0.0 < work("friction_J") && 0.0 < work("damping_J"));
    let energy = answer["friction_energy"]["contact_J"].as_f64().unwrap();
    assert!((energy - work("friction_J")).abs() < 1e-12 * energy);
    let picture = format!("{path}.svg");
    output(
        "",
        &["drive", FRAME, &path, "--friction", "0.8", "-o", &picture],
    );
    let drawn = fs::read_to_string(&picture).unwrap();
    for file in [path, picture] {
        fs::remove_file(file).unwrap();
    }
    assert!(drawn.contains("forces of the contacts"), "{drawn}");
    // The picture shows a base that moves as recorded, and springs with their own stiffnesses.
    let words = text_of(&drawn);
    assert!(words.contains("y(t)") && !words.contains("cos"), "{words}");
    assert!(words.contains("k1") && words.contains("k2"), "{words}");
}

/// Returns the visible text of a picture.
fn text_of(picture: &str) -> String {
    let pieces = picture.split('<').filter_map(|tag| tag.split_once('>'));
    pieces.map(|(_, text)| text).collect()
}

/// Checks that the help of `drive` does not require a driving frequency, because its recording is an arbitrary input.
#[test]
fn help_asks_for_no_driving_frequency() {
    let help = output("", &["drive", "--help"]);
    assert!(
        help.contains("as CSV or UFF58") && !help.contains("driving frequency"),
        "{help}"
    );
    let help = output("", &["identify", "--help"]);
    assert!(
        help.contains("A recording must have one driving frequency"),
        "{help}"
    );
}

/// A unit in the header of a column may be written as in a name or as in a text.
#[test]
fn units_as_in_a_text() {
    let driven_by = |record: &str| {
        let path = file("unit.csv", record);
        let text = output("", &["drive", FRAME, &path, "--friction", "0.8", "--csv"]);
        fs::remove_file(path).unwrap();
        text
    };
    let driven = |unit: &str| driven_by(&shaken().replacen("m_s2", unit, 1));
    let expected = driven("m_s2");
    for unit in ["m/s2", "m/s^2", "m/s²"] {
        assert_eq!(driven(unit), expected, "{unit}");
    }
    for (unit, size) in [
        ("gal", 0.01),
        ("Gal", 0.01),
        ("cm/s²", 0.01),
        ("cm_s2", 0.01),
        ("in_s2", 0.0254),
        ("in/s^2", 0.0254),
        ("ft_s2", 0.3048),
    ] {
        let lower = |csv: &str| column(csv, "lower-base.displacement_m");
        let record =
            shaken()
                .lines()
                .skip(1)
                .fold(format!("time_s,base_{unit}\n"), |text, line| {
                    let (time, value) = line.split_once(',').unwrap();
                    text + &format!("{time},{}\n", value.parse::<f64>().unwrap() / size)
                });
        let found = lower(&driven_by(&record));
        for (found, expected) in found.iter().zip(lower(&expected)) {
            assert!(
                (found - expected).abs() < 1e-14,
                "{unit}: {found} {expected}"
            );
        }
    }
}

#[test]
fn says_what_is_wrong_with_a_recording() {
    for (name, text, friction, told) in [
        (
            "none",
            "time_s,base_mm\n0,0\n0.01,1\n",
            None,
            "no friction force is given",
        ),
        (
            "nan",
            "time_s,base_mm\n0,0\n0.01,NaN\n",
            Some("1"),
            "line 3: `NaN` of `base_mm`",
        ),
        (
            "newton",
            "time_s,base_N\n0,0\n0.01,1\n",
            Some("1"),
            "the channel `base` is in N, but here it must be a motion",
        ),
        (
            "slow",
            "time_s,base_mm\n0,0\n1000,1\n",
            Some("1"),
            "too far for the fastest mode",
        ),
        (
            "force",
            "time_s,force_N\n0,0\n0.01,1\n",
            Some("1"),
            "`force` does not belong to this scene",
        ),
        ("one", "time_s,base_mm\n0,0\n", Some("1"), "too short"),
        (
            "minus",
            "time_s,base_mm\n0,0\n0.01,1\n",
            Some("-1"),
            "not negative is needed",
        ),
        (
            "twice",
            "time_s,base_mm,friction_N\n0,0,1\n0.01,1,1\n",
            Some("1"),
            "the friction force is given as a number and as the channel `friction`",
        ),
        (
            "back",
            "time_s,base_mm\n0,0\n0.005,1\n0.003,0\n",
            Some("1"),
            "the time step changes from 0.005 s to -0.002 s at line 4",
        ),
        (
            "below",
            "time_s,base_mm,friction_N\n0,0,1\n0.01,1,-1\n",
            None,
            "sample 1 of the input",
        ),
    ] {
        let path = file(name, text);
        let mut command = vec!["drive", FRAME, &path];
        if let Some(force) = friction {
            command.extend(["--friction", force]);
        }
        let lines = failure("", &command);
        fs::remove_file(&path).unwrap();
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(lines[0].contains(told), "{name}: {lines:?}");
    }
}

/// A record whose steps differ moves the scene as the even record with the same straight lines. Only the spectrum needs
/// even steps.
#[test]
fn a_record_with_uneven_steps() {
    let at = |time: f64| (20.0 * time).min(3.0 - 10.0 * time);
    let record = |times: &[f64]| {
        let lines = times.iter().map(|time| format!("{time},{}\n", at(*time)));
        file(
            "steps.csv",
            &format!("time_s,base_m_s2\n{}", lines.collect::<String>()),
        )
    };
    let even: Vec<f64> = (0..=40).map(|sample| 0.01 * f64::from(sample)).collect();
    let uneven = [0.0, 0.05, 0.06, 0.1, 0.25, 0.39, 0.4];
    let driven = |path: &str| {
        let line = [
            "drive",
            FRAME,
            path,
            "--friction",
            "0.3",
            "--after",
            "1",
            "--csv",
        ];
        output("", &line)
    };
    let [all, few] = [record(&even), record(&uneven)].map(|path| (driven(&path), path));
    for name in [
        "upper-base.displacement_m",
        "contact.energy_J",
        "contact.velocity_m_s",
    ] {
        let (expected, found) = (column(&all.0, name), column(&few.0, name));
        let size = expected
            .iter()
            .fold(0.0_f64, |size, value| size.max(value.abs()));
        for (time, found) in uneven.iter().zip(&found) {
            let error = (found - expected[(100.0 * time).round() as usize]).abs();
            assert!(
                error < 1e-12 * size,
                "{name} at {time} s: {error:e} of {size:e}"
            );
        }
        let ends = [&expected, &found].map(|all| all[all.len() - 1]);
        assert!((ends[0] - ends[1]).abs() < 1e-12 * size, "{name}: {ends:?}");
    }
    let refused = failure("", &["drive", FRAME, &few.1, "--spectrum", "0.05"]).join("\n");
    assert!(refused.contains("not evenly spaced"), "{refused}");
}

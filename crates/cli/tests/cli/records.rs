//! Tests of the formats of records that `drive` reads, and of response spectra.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test fails by it"
)]

use crate::common::{FRAME, failure, file, output};
use frictiongen::System;
use frictiongen::study::SystemInput;
use std::fs;

/// Accelerations in g at intervals of 0.01 s, with five decimals. The base rests at the end.
fn accelerations() -> Vec<String> {
    let value = |sample: u32| {
        let time = 0.01 * f64::from(sample);
        if sample < 160 {
            0.3 * (9.0 * time).sin() * (1.0 + time)
        } else {
            0.0
        }
    };
    (0..240)
        .map(|sample| format!("{:.5}", value(sample)))
        .collect()
}

/// Writes the accelerations line by line, each after its time, with a separator between them.
fn lines(separator: &str, comma: bool) -> String {
    let values = accelerations();
    let lines = values.iter().enumerate().map(|(sample, value)| {
        let line = format!("{:.2}{separator}{value}\n", 0.01 * sample as f64);
        if comma { line.replace('.', ",") } else { line }
    });
    lines.collect()
}

/// Writes the accelerations as a PEER AT2 record, with the header given.
fn at2(header: &str) -> String {
    let mut text = format!(
        "PEER NGA STRONG MOTION DATABASE RECORD\nMade for a test, 180\nACCELERATION TIME SERIES IN UNITS OF G\n{header}\n"
    );
    for values in accelerations().chunks(5) {
        text += &format!("  {}\n", values.join("  "));
    }
    text
}

/// Every format gives the motion that the same record as CSV gives.
#[test]
fn every_format_gives_the_same_motion() {
    let drive = |name: &str, text: &str, more: &[&str]| {
        let path = file(name, text);
        let mut command = vec!["drive", FRAME, &path, "--friction", "0.8", "--csv"];
        command.extend(more);
        let found = output("", &command);
        fs::remove_file(path).unwrap();
        found
    };
    let expected = drive("csv", &format!("time_s,base_g\n{}", lines(",", false)), &[]);
    assert!(expected.lines().count() == 241, "{expected}");
    let second = ["--channel", "base=2:g"];
    let alone: String = accelerations().join("\n");
    let alone_with_commas = alone.replace('.', ",");
    let rate = ["--rate", "100", "--channel", "base=1:g"];
    for (name, text, more) in [
        ("new.at2", at2("NPTS=    240, DT=   .0100 SEC,"), &[][..]),
        ("old.at2", at2("  240    0.0100    NPTS, DT"), &[]),
        ("blanks", lines("   ", false), &second),
        ("tabs", lines("\t", false), &second),
        ("semicolons", lines("; ", false), &second),
        ("commas", lines(", ", false), &second),
        ("decimal-blanks", lines("  ", true), &second),
        ("decimal-tabs", lines("\t", true), &second),
        ("decimal-semicolons", lines(";", true), &second),
        (
            "named-decimal",
            format!("time_s;base_g\n{}", lines(";", true)),
            &[],
        ),
        (
            "remarks",
            format!("# from a logger\n{}", lines(" ", false)),
            &second,
        ),
        ("one", alone, &rate),
        ("one-decimal", alone_with_commas, &rate),
    ] {
        let found = drive(name, &text, more);
        assert_eq!(found.lines().count(), 241, "{name}");
        for (found, expected) in found.lines().zip(expected.lines()).skip(1) {
            for (found, expected) in found.split(',').zip(expected.split(',')) {
                let numbers = (found.parse::<f64>(), expected.parse::<f64>());
                let (Ok(found), Ok(expected)) = numbers else {
                    assert_eq!(found, expected, "{name}");
                    continue;
                };
                // The mean step of the written times differs from 0.01 s by rounding.
                assert!(
                    (found - expected).abs() < 1e-9,
                    "{name}: {found} {expected}"
                );
            }
        }
    }
}

/// Under an acceleration the absolute displacement drifts with the base. The default is therefore relative to the base,
/// in every format.
#[test]
fn displacements_are_relative_to_a_moving_base_by_default() {
    let path = file("relative", &at2("NPTS= 240, DT= .01 SEC"));
    let drive = |more: &[&str]| {
        let mut command = vec!["drive", FRAME, &path, "--friction", "0.8", "--csv"];
        command.extend(more);
        output("", &command)
    };
    let (found, absolute) = (drive(&[]), drive(&["--of", "upper", "--of", "upper-base"]));
    fs::remove_file(&path).unwrap();
    let column = |text: &str, name: &str| -> Vec<f64> {
        let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let names = rows.next().unwrap();
        let place = names.iter().position(|found| *found == name);
        let place = place.unwrap_or_else(|| panic!("{name} is not in {names:?}"));
        rows.map(|row| row[place].parse().unwrap()).collect()
    };
    let relative = column(&found, "upper-base.displacement_m");
    assert_eq!(relative, column(&absolute, "upper-base.displacement_m"));
    let most = |values: &[f64]| {
        values
            .iter()
            .fold(0.0, |most: f64, value| most.max(value.abs()))
    };
    let absolute = column(&absolute, "upper.displacement_m");
    assert!(
        most(&relative) < 0.2 * most(&absolute),
        "{}",
        most(&absolute)
    );
}

/// The spectrum is that of a chain of one mass without friction, which the stepper follows.
#[test]
fn a_spectrum_is_what_the_stepper_gives_for_one_mass() {
    let path = file("spectrum", &at2("NPTS= 240, DT= .01 SEC"));
    let answer = output("", &["drive", FRAME, &path, "--spectrum", "0.05", "--json"]);
    let picture = format!("{path}.svg");
    output(
        "",
        &["drive", FRAME, &path, "--spectrum", "0.05", "-o", &picture],
    );
    let drawn = fs::read_to_string(&picture).unwrap();
    for file in [path, picture] {
        fs::remove_file(file).unwrap();
    }
    assert!(drawn.contains("pseudo-acceleration"), "{drawn}");
    let answer: serde_json::Value = serde_json::from_str(&answer).unwrap();
    let points = answer["points"].as_array().unwrap();
    let frame: System = fs::read_to_string(FRAME).unwrap().parse().unwrap();
    let own = frame.natural_frequencies();
    let modes = points.iter().filter(|point| !point["mode"].is_null());
    assert_eq!(modes.count(), own.len());
    let values: Vec<f64> = accelerations()
        .iter()
        .map(|text| text.parse().unwrap())
        .collect();
    for (point, omega) in points.iter().zip(own) {
        let period = point["period_s"].as_f64().unwrap();
        assert!((period * omega / std::f64::consts::TAU - 1.0).abs() < 1e-12);
        let block: System = format!(
            "struct Block {{ masses: {{ block: 1 }}, springs: {{ base - block: {:?} }}, contact: block - wall,
              excitation: base, damping: modal(0.05), damping_from: base }}",
            omega * omega
        )
        .parse()
        .unwrap();
        // Twenty steps to a sample show the reversals of the displacement.
        let (dt, parts) = (0.01 / 20.0, 20_u32);
        let mut step = block.stepper(dt).unwrap();
        let (mut place, mut velocity, mut largest) = (0.0, 0.0, 0.0_f64);
        for pair in values.windows(2) {
            let at = |part: u32| {
                9.80665 * (pair[0] + (pair[1] - pair[0]) * f64::from(part) / f64::from(parts))
            };
            for part in 0..parts {
                let (last, now) = (at(part), at(part + 1));
                place += dt * velocity + dt * dt * (last / 3.0 + now / 6.0);
                velocity += dt * 0.5 * (last + now);
                step.advance(SystemInput::base(place, velocity).friction(0.0))
                    .unwrap();
                let relative = step.mass("block").unwrap().displacement() - place;
                largest = largest.max(relative.abs());
            }
        }
        let found = point["displacement_m"].as_f64().unwrap();
        // Between two of the finer steps the displacement exceeds the largest by (ω dt)²/8 at most, 3e-6.
        assert!((found / largest - 1.0).abs() < 5e-6, "{found} {largest}");
        let pseudo = point["pseudo_acceleration_m_s2"].as_f64().unwrap();
        assert!((pseudo / (found * omega * omega) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn says_which_formats_are_read_and_where_reading_stopped() {
    let formats = "the formats of a recording are CSV with a line of names and units, columns of numbers alone";
    let short = at2("NPTS=    241, DT=   .0100 SEC");
    let velocity = short.replace("UNITS OF G", "UNITS OF CM/S");
    for (name, text, more, told) in [
        (
            "words",
            "A strong motion\nrecord of words\n",
            &[][..],
            format!("line 2: `record of words` of `A strong motion` is not a finite number; {formats}"),
        ),
        ("empty", "", &[], format!("line 1: the file is empty; {formats}")),
        (
            "unnamed",
            "0 1\n0.01 2\n",
            &[],
            "the columns have no names; write names in the first line, or give the column".to_owned(),
        ),
        (
            "ragged",
            "0 1\n0.01 2\n0.02\n",
            &["--channel", "base=2:g"],
            "line 3: it has 1 numbers, but the first line has 2".to_owned(),
        ),
        (
            "word",
            "0 1\n0.01 2\n0.02 x\n",
            &["--channel", "base=2:g"],
            "line 3: `0.02 x` is not a line of numbers like the first one".to_owned(),
        ),
        (
            "rateless",
            "1\n2\n3\n",
            &["--channel", "base=1:g"],
            "the sampling rate is unknown".to_owned(),
        ),
        (
            "short",
            &short,
            &[],
            "line 52: the file ends here with 240 samples, but NPTS is 241".to_owned(),
        ),
        (
            "velocity",
            &velocity,
            &[],
            "line 4: the samples are in CM/S; of PEER records only accelerations in g (AT2) are read"
                .to_owned(),
        ),
        (
            "channel",
            &short,
            &["--channel", "base=1:g"],
            "leave --channel out".to_owned(),
        ),
    ] {
        let path = file(name, text);
        let mut command = vec!["drive", FRAME, &path, "--friction", "1"];
        command.extend(more);
        let lines = failure("", &command);
        fs::remove_file(&path).unwrap();
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(lines[0].contains(&told), "{name}: {lines:?}");
    }
}

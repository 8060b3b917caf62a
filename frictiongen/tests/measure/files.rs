//! Tests of CSV and UFF58 files, which are written and then read.

use crate::made::Noise;
use frictiongen::measure::{Channel, CsvColumn, CsvRequest, MeasureError, Recording, Unit};

fn some() -> Recording {
    let mut noise = Noise::new(9);
    let mut channel = |name: &str, unit: &str, size: f64| Channel {
        name: name.into(),
        unit: unit.parse().unwrap(),
        samples: (0..1001).map(|_| size * noise.next()).collect(),
    };
    let channels = vec![
        channel("base", "mm", 1.0),
        channel("lower", "m/s", 1e-7),
        channel("upper_storey", "m/s2", 1e12),
        channel("force", "N", 3.0),
    ];
    Recording::new(2000.0, channels).unwrap()
}

#[test]
fn a_csv_comes_back_bit_for_bit() {
    let recording = some();
    let read = Recording::from_csv(&recording.to_csv(), &CsvRequest::default()).unwrap();
    assert_eq!(read.channels(), recording.channels());
    assert!((read.rate() - 2000.0).abs() < 1e-9);
}

#[test]
fn other_programs_write_it_otherwise() {
    let data = "0,1,2\n0.5,3,4\n1,5,7\n";
    let more: String = (3..40)
        .map(|i| format!("{},{},{}\n", f64::from(i) / 2.0, i % 7, i % 5))
        .collect();
    let body = format!("{data}{more}");
    let plain = Recording::from_csv(
        &format!("time_s,base_mm,plate_mm\n{body}"),
        &CsvRequest::default(),
    )
    .unwrap();
    for text in [
        format!(
            "\u{feff}# a rig\ntime_s;base (mm);plate [mm]\n{}",
            body.replace(',', ";")
        ),
        format!(
            "time\tbase\tplate.displacement\ns\tmm\tmm\n{}",
            body.replace(',', "\t")
        ),
        format!(
            "\"time (s)\", \"base_mm\", \"plate_mm\"\r\n{}",
            body.replace('\n', "\r\n")
        ),
    ] {
        assert_eq!(
            Recording::from_csv(&text, &CsvRequest::default()).unwrap(),
            plain,
            "{text}"
        );
    }
    // The header does not name the columns, so the request does.
    let column = |name: &str, column: &str| CsvColumn {
        name: name.into(),
        column: column.into(),
        unit: Some(Unit::MILLIMETRE),
    };
    let request = CsvRequest {
        rate: Some(2.0),
        columns: vec![column("base", "AI0"), column("plate", "3")],
    };
    let read = Recording::from_csv(&format!("clock,AI0,AI1\n{body}"), &request).unwrap();
    assert_eq!(read, plain);
}

#[test]
fn a_universal_file_comes_back_to_its_thirteen_digits() {
    let recording = some();
    let text = recording.to_uff58();
    let read = Recording::from_uff58(&text, &CsvRequest::default()).unwrap();
    assert_eq!(read.rate(), 2000.0);
    assert_eq!(read.len(), recording.len());
    for (read, written) in read.channels().iter().zip(recording.channels()) {
        assert_eq!((&read.name, read.unit), (&written.name, written.unit));
        for (a, b) in read.samples.iter().zip(&written.samples) {
            // The file has 13 digits, so the error is half a unit of the last digit.
            assert!((a - b).abs() <= 5.1e-13 * b.abs(), "{a} for {b}");
        }
    }
    // Writing the recording again gives the same bytes.
    assert_eq!(read.to_uff58(), text);
}

/// Reads the format of other programs: single precision, six values a line, other data sets between, and uneven spacing
/// as pairs.
#[test]
fn a_universal_file_of_another_program() {
    let head = |name: &str, unit: &str, kind: i32, count: usize, even: i32| {
        format!(
            "    -1\n    58\n{name}\nNONE\n22-Nov-26 12:00:00\nNONE\nNONE\n    1         0    0         0 {name:<10}         1   1 NONE               0   0\n{kind:>10}{count:>10}{even:>10}  0.00000E+00  5.00000E-04  0.00000E+00\n        17    0    0    0 NONE                 s                   \n         8    0    0    0 NONE                 {unit:<20}\n         0    0    0    0 NONE                 NONE                \n         0    0    0    0 NONE                 NONE                \n"
        )
    };
    let values: Vec<f64> = (0..32).map(|i| f64::from(i * i % 17) - 8.25).collect();
    let single: String = values
        .chunks(6)
        .map(|line| {
            line.iter()
                .map(|v| format!("{v:>13.5}"))
                .collect::<String>()
                + "\n"
        })
        .collect();
    let pairs: String = values
        .iter()
        .enumerate()
        .map(|(i, v)| format!("{:>13.7}{v:>20.11}\n", i as f64 * 5e-4))
        .collect();
    let other = "    -1\n   151\nmodel\nNONE\n    -1\n";
    let text = format!(
        "{other}{}{single}    -1\n{}{pairs}    -1\n",
        head("base", "mm", 2, 32, 1),
        head("plate", "mm", 4, 32, 0)
    );
    let read = Recording::from_uff58(&text, &CsvRequest::default()).unwrap();
    assert_eq!(read.rate(), 2000.0);
    assert_eq!(read.channel("base").unwrap().samples, values);
    assert_eq!(read.channel("plate").unwrap().samples, values);
    // The file has no unit, so the error asks for it.
    let error = Recording::from_uff58(&text.replace("mm  ", "NONE"), &CsvRequest::default());
    assert!(error.unwrap_err().to_string().contains("has no unit"));
    // The two channels of this file have different sampling rates.
    let mixed = text.replacen("5.00000E-04", "1.00000E-03", 1);
    let error = Recording::from_uff58(&mixed, &CsvRequest::default()).unwrap_err();
    assert!(error.to_string().contains("not evenly spaced"), "{error}");
    // The file is cut off.
    let cut = &text[..text.len() / 2];
    assert!(Recording::from_uff58(cut, &CsvRequest::default()).is_err());
}

/// The first mark of a text distinguishes a universal file from a CSV file.
#[test]
fn either_is_read_as_what_it_is() {
    let recording = some();
    let request = CsvRequest::default();
    let csv = Recording::from_text(&recording.to_csv(), &request).unwrap();
    let universal = Recording::from_text(&recording.to_uff58(), &request).unwrap();
    assert_eq!(csv.channels(), recording.channels());
    assert_eq!(
        universal,
        Recording::from_uff58(&recording.to_uff58(), &request).unwrap()
    );
    assert_eq!(universal.channels().len(), 4);
    assert!(Recording::from_text("", &request).is_err());
}

#[test]
fn a_rate_of_times() {
    let times = |step: f64| {
        (0..100)
            .map(|i| 3.0 + step * f64::from(i))
            .collect::<Vec<_>>()
    };
    // Times near 3 are rounded to 4e-16, over 99 steps of 0.01.
    assert!((Recording::rate_of(&times(0.01)).unwrap() - 100.0).abs() < 1e-10);
    for (wrong, told) in [
        (vec![], "too short: 0 times"),
        (vec![1.0], "too short: 1 times"),
        (
            vec![0.0, 1.0, 3.0],
            "not evenly spaced: the time step changes from 1 s to 2 s at sample 2",
        ),
        (vec![0.0, f64::NAN, 1.0], "at sample 1"),
        (vec![1.0, 0.0], "at sample 1"),
        (vec![0.0, 0.0], "at sample 1"),
        (vec![0.0, f64::INFINITY], "at sample 1"),
    ] {
        let error = Recording::rate_of(&wrong).unwrap_err().to_string();
        assert!(error.contains(told), "{wrong:?}: {error}");
    }
}

/// A clock slows by 2 % after 30 samples. Each step then lies within 1 % of the first step or of the mean step. The
/// mean step itself differs from the first by more than 1 %.
#[test]
fn a_clock_that_slows() {
    let times = |steps: &dyn Fn(u32) -> f64| -> Vec<f64> {
        let steps = (0..330).scan(0.0, |time, index| {
            *time += steps(index);
            Some(*time)
        });
        std::iter::once(0.0).chain(steps).collect()
    };
    let slows = times(&|index| if index < 30 { 0.01 } else { 0.0102 });
    let error = Recording::rate_of(&slows).unwrap_err();
    let MeasureError::MixedRates {
        place,
        before,
        after,
    } = &error
    else {
        panic!("{error}");
    };
    assert_eq!(place, "its end");
    // The sums of 330 steps are rounded at a value near 3.
    let mean = (30.0 * 0.01 + 300.0 * 0.0102) / 330.0;
    assert!((before - 0.01).abs() < 1e-12 && (after - mean).abs() < 1e-12);
    // If the first step alone is too long, the clock rounds. The rate is then still found.
    let rounds = times(&|index| if index == 0 { 0.0102 } else { 0.01 });
    let rate = Recording::rate_of(&rounds).unwrap();
    assert!((rate - 330.0 / (0.0102 + 329.0 * 0.01)).abs() < 1e-9);
}

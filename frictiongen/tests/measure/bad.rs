//! Recordings from which nothing can be identified. Each must return one clear error.

use crate::made::{Noise, RATE, Y, rig};
use frictiongen::measure::{Channel, CsvRequest, MeasureError, Measured, Recording, Unit};
use std::f64::consts::TAU;

/// Returns channels of base and plate, 20 s long with a little noise. `change` gives each sample from the channel and
/// the time.
fn channels(change: impl Fn(usize, f64) -> f64) -> Vec<Channel> {
    let mut noise = Noise::new(3);
    let mut channel = |place: usize, name: &str| Channel {
        name: name.into(),
        unit: Unit::MILLIMETRE,
        samples: (0..40_000)
            .map(|i| change(place, f64::from(i) / RATE) + 1e-3 * noise.next())
            .collect(),
    };
    vec![channel(0, "base"), channel(1, "plate")]
}

fn good(place: usize, t: f64) -> f64 {
    let [size, lag] = [[1e3 * Y, 0.0], [2.0, 0.5]][place];
    size * (TAU * 4.0 * t - lag).cos()
}

fn measured(channels: Vec<Channel>) -> Result<Measured, MeasureError> {
    Measured::of(&Recording::new(RATE, channels)?, rig("").scene())
}

fn told(result: Result<Measured, MeasureError>, words: &str) {
    let error = result.expect_err(words).to_string();
    assert!(error.contains(words), "{error}");
}

#[test]
fn a_good_one_is_good() {
    assert!(measured(channels(good)).is_ok());
}

#[test]
fn constant() {
    let mut all = channels(good);
    all[1].samples.fill(0.7);
    told(measured(all), "`plate` never changes");
}

#[test]
fn clipped() {
    for limit in [1.9, 1.5, 0.3] {
        let mut all = channels(good);
        for value in &mut all[1].samples {
            *value = value.clamp(-limit, limit);
        }
        told(measured(all), "`plate` is clipped at");
    }
    // The signal is clipped on one side only.
    let mut all = channels(good);
    for value in &mut all[0].samples {
        *value = value.min(1.5);
    }
    told(measured(all), "`base` is clipped at 1.5");
}

/// A contact that stops at its extreme position is not clipping, and neither is a coarse converter.
#[test]
fn flat_but_not_clipped() {
    use crate::made::{How, NATURAL, motions};
    let system = rig("");
    let how = How {
        hertz: 0.5 * NATURAL,
        beta: 0.6,
        rate: 1000.0,
        seconds: 20.0,
        skip: 50.0,
    };
    let all = motions(&system, how);
    let channel = |name: &str, motion: &[f64], step: f64| Channel {
        name: name.into(),
        unit: Unit::MILLIMETRE,
        samples: motion
            .iter()
            .map(|x| (1e3 * Y * x / step).round() * step)
            .collect(),
    };
    for step in [1e-12, 0.01, 0.05] {
        let channels = vec![
            channel("base", &all[0], step),
            channel("plate", &all[1], step),
        ];
        let recording = Recording::new(1000.0, channels);
        assert!(recording.is_ok(), "step {step}: {}", recording.unwrap_err());
        assert!(Measured::of(&recording.unwrap(), system.scene()).is_ok());
    }
}

#[test]
fn two_samples() {
    let mut all = channels(good);
    for channel in &mut all {
        channel.samples.truncate(2);
    }
    told(measured(all), "too short: 2 samples");
    // The recording has two cycles.
    let mut all = channels(good);
    for channel in &mut all {
        channel.samples.truncate(1000);
    }
    told(measured(all), "too short");
}

#[test]
fn not_a_number() {
    let mut all = channels(good);
    all[1].samples[777] = f64::NAN;
    told(
        measured(all),
        "sample 777 of `plate` is not a finite number",
    );
    let text = "time_s,base_mm,plate_mm\n0,1,2\n0.1,inf,2\n";
    let error = Recording::from_csv(text, &CsvRequest::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 3: `inf` of `base_mm` is not a finite number"
    );
    let error =
        Recording::from_csv("time_s,base_mm\n0,1\n0.1,\n", &CsvRequest::default()).unwrap_err();
    assert!(
        error.to_string().starts_with("line 3: `` of `base_mm`"),
        "{error}"
    );
    // Between semicolons a comma is a decimal comma, but not beside a decimal point.
    let read = |text| Recording::inputs_from_csv(text, &CsvRequest::default());
    let recording = read("time_s;base_mm\n0;1,5\n0,1;2\n").unwrap();
    assert_eq!(recording.rate(), 10.0);
    assert_eq!(recording.channels()[0].samples, [1.5, 2.0]);
    let error = read("time_s;base_mm\n0;1\n0,1;1.000,5\n").unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 3: `1.000,5` of `base_mm` is not a finite number"
    );
}

#[test]
fn wrong_column() {
    let mut all = channels(good);
    all[1].name = "plat".into();
    told(
        measured(all),
        "`plat` does not belong to this scene, which has base, plate",
    );
    let mut all = channels(good);
    all[1].unit = Unit::NEWTON;
    told(
        measured(all),
        "`plate` is in N, but here it must be a motion",
    );
    let mut all = channels(good);
    all[1].name = "base".into();
    told(measured(all), "`base` is given twice");
    let all = channels(good);
    told(measured(all[1..].to_vec()), "a channel `base` is needed");
    told(
        measured(all[..1].to_vec()),
        "no motion of a mass was recorded",
    );
    let error =
        Recording::from_csv("time_s,base,plate_mm\n0,1,2\n", &CsvRequest::default()).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("the channel `base` has no unit"),
        "{error}"
    );
    let error = Recording::from_csv("0,1,2\n", &CsvRequest::default()).unwrap_err();
    assert!(
        error.to_string().contains(
            "the columns have no names; write names in the first line, or give the column"
        ),
        "{error}"
    );
    let error = Recording::from_csv("base_mm,plate_mm\n1,2\n", &CsvRequest::default()).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("the sampling rate is unknown"),
        "{error}"
    );
}

#[test]
fn mixed_rates() {
    let mut text = "time_s,base_mm,plate_mm\n".to_owned();
    let mut t = 0.0;
    for i in 0..4000 {
        text += &format!("{t:.6},{:.6},{:.6}\n", good(0, t), good(1, t));
        t += if i < 2000 { 1e-3 } else { 2e-3 };
    }
    let error = Recording::from_csv(&text, &CsvRequest::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the samples are not evenly spaced: the time step changes from 0.001 s to 0.002 s at line 2003"
    );
    let mut all = channels(good);
    all[1].samples.truncate(20_000);
    told(
        measured(all),
        "`plate` does not have the same number of samples",
    );
}

#[test]
fn a_drive_that_drifts() {
    // The frequency drifts from 4 Hz to 4.4 Hz, and then from 4 Hz to 4.02 Hz.
    for rate in [0.02, 0.001] {
        let drifting = |place: usize, t: f64| {
            let [size, lag] = [[1e3 * Y, 0.0], [2.0, 0.5]][place];
            size * (TAU * (4.0 * t + 0.5 * rate * t * t) - lag).cos()
        };
        told(
            measured(channels(drifting)),
            "the frequency of the excitation drifts from 4.",
        );
    }
    let swelling = |place: usize, t: f64| good(place, t) * (1.0 + 0.02 * t);
    told(
        measured(channels(swelling)),
        "the amplitude of the excitation changes by",
    );
}

#[test]
fn no_drive() {
    let silent = |place: usize, t: f64| if place == 0 { 0.0 } else { good(place, t) };
    let error = measured(channels(silent)).unwrap_err();
    assert!(
        matches!(
            error,
            MeasureError::Silent(_) | MeasureError::TooShort { .. } | MeasureError::TooSlow { .. }
        ),
        "{error}"
    );
}

#[test]
fn never_steady() {
    let swelling = |place: usize, t: f64| good(place, t) * (1.0 + 0.05 * t * place as f64);
    told(measured(channels(swelling)), "`plate` goes on changing");
}

/// A short recording has few blocks. The check must not take a trend over them for scatter.
#[test]
fn never_steady_in_a_short_time() {
    for seconds in [5, 10] {
        let mut all = channels(|place, t| good(place, t) * (1.0 + 0.05 * t * place as f64));
        for channel in &mut all {
            channel.samples.truncate(seconds * RATE as usize);
        }
        told(measured(all), "`plate` goes on changing");
    }
}

#[test]
fn too_slow() {
    let mut all = channels(good);
    for channel in &mut all {
        channel.samples = channel.samples.iter().step_by(150).copied().collect();
    }
    let error =
        Measured::of(&Recording::new(RATE / 150.0, all).unwrap(), rig("").scene()).unwrap_err();
    assert!(error.to_string().contains("are too few for 4.0"), "{error}");
}

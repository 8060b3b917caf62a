//! Frequency, transmissibility, phase and harmonics of recordings.

use crate::made::{How, NATURAL, Noise, RATE, Y, motions, recording, rig};
use frictiongen::Of;
use frictiongen::measure::{Channel, Measured, Recording, Unit};
use std::f64::consts::TAU;

/// The figures of chapter 4, from 60 s at 2 kHz and 40 dB.
#[test]
fn transmissibility_and_phase_are_those_of_the_steady_state() {
    let system = rig("");
    let mut noise = Noise::new(1);
    for (r, beta) in [(0.5, 0.4), (0.85, 0.2), (1.25, 0.6), (2.3, 0.2)] {
        let how = How {
            hertz: r * NATURAL,
            beta,
            rate: RATE,
            seconds: 60.0,
            skip: 100.3,
        };
        let recording = recording(&system, &motions(&system, how), RATE, 100.0, &mut noise);
        let measured = Measured::of(&recording, system.scene()).unwrap();
        let found = measured.transmissibility(0).unwrap();
        let at = system.at(r).unwrap();
        let response = at.response(beta).unwrap();
        let expected = response.harmonic(Of::Mass(0), 1).unwrap();
        // The bound is five standard deviations, which chance exceeds once in a million. The seed is fixed.
        let error = (found.value - expected).norm();
        assert!(
            error < 5.0 * found.deviation,
            "r = {r}: {error} of {}",
            found.deviation
        );
        assert!(
            found.deviation < 2e-4 * expected.norm().max(1.0),
            "{}",
            found.deviation
        );
        assert!((measured.hertz - how.hertz).abs() < 5.0 * measured.hertz_deviation);
        assert!(measured.hertz_deviation < 1e-6 * how.hertz);
        let third = measured.harmonic(0, 3).unwrap();
        let error = (third - response.harmonic(Of::Mass(0), 3).unwrap()).norm();
        assert!(
            error < 6.0 * found.deviation,
            "third harmonic at r = {r}: {error}"
        );
        assert!((measured.drive_amplitude() - Y).abs() < 5.0 * measured.drive.deviation);
    }
}

/// The reported deviation equals the scatter of repeats. With white noise of 1 % it is σ√(2·1.5/N) in closed form.
#[test]
fn the_deviation_is_that_of_repeats() {
    let scene = rig("");
    let (count, repeats) = (2000, 400);
    let (mut squares, mut claimed) = (0.0, 0.0);
    for seed in 0..repeats {
        let mut noise = Noise::new(seed);
        let wave = |lag: f64, size: f64| {
            (0..count).map(move |i| size * (TAU * 3.3 * i as f64 / 500.0 - lag).cos())
        };
        let mut channel = |name: &str, lag, size| {
            let mut samples: Vec<f64> = wave(lag, size).collect();
            noise.add(&mut samples, 0.01);
            Channel {
                name: name.into(),
                unit: Unit::METRE,
                samples,
            }
        };
        let channels = vec![channel("base", 0.0, 1.0), channel("plate", 0.7, 2.0)];
        let recording = Recording::new(500.0, channels).unwrap();
        let measured = Measured::of(&recording, scene.scene()).unwrap();
        assert_eq!(measured.steady.0, 0.0, "all of it is steady");
        let found = measured.transmissibility(0).unwrap();
        let error = found.value - 2.0 * num(0.7);
        squares += error.norm_sqr() / 2.0;
        claimed += found.deviation * found.deviation;
    }
    let repeats = f64::from(u32::try_from(repeats).unwrap());
    let (seen, claimed) = ((squares / repeats).sqrt(), (claimed / repeats).sqrt());
    // √(1 + |T|²) is due to the noise of both channels. 800 numbers determine a deviation to 2.5 %, and the bound is
    // three times that.
    let expected = 0.01 * (3.0 / f64::from(count)).sqrt() * 5.0_f64.sqrt();
    assert!(
        (seen / expected - 1.0).abs() < 0.08,
        "{seen} for {expected}"
    );
    assert!(
        (claimed / expected - 1.0).abs() < 0.05,
        "{claimed} for {expected}"
    );
}

/// The driving frequency scatters by its reported deviation. 150 repeats determine a deviation to 6 %, and the bound is
/// three times that.
#[test]
fn the_frequency_scatters_as_it_says() {
    let scene = rig("");
    let (rate, repeats) = (500.0, 150_u32);
    let (mut squares, mut claimed) = (0.0, 0.0);
    for seed in 0..repeats {
        let mut noise = Noise::new(u64::from(seed));
        let mut channel = |name: &str| {
            let wave = (0..2000).map(|i| (TAU * 3.3 * f64::from(i) / rate).cos());
            let mut samples: Vec<f64> = wave.collect();
            noise.add(&mut samples, 0.01);
            Channel {
                name: name.into(),
                unit: Unit::METRE,
                samples,
            }
        };
        let channels = vec![channel("base"), channel("plate")];
        let recording = Recording::new(rate, channels).unwrap();
        let measured = Measured::of(&recording, scene.scene()).unwrap();
        squares += (measured.hertz - 3.3).powi(2);
        claimed += measured.hertz_deviation.powi(2);
    }
    let seen = (squares / f64::from(repeats)).sqrt();
    let claimed = (claimed / f64::from(repeats)).sqrt();
    println!("seen {seen:.3e}, claimed {claimed:.3e}");
    assert!((claimed / seen - 1.0).abs() < 0.18, "{claimed} for {seen}");
}

/// Returns e^{−i lag}.
fn num(lag: f64) -> frictiongen::Complex<f64> {
    frictiongen::Complex::new(lag.cos(), -lag.sin())
}

/// The measurement leaves out a transient, and the remaining interval gives the steady amplitude.
#[test]
fn the_steady_part_is_found() {
    let system = rig("damping: modal(0.02),");
    let how = How {
        hertz: 1.3 * NATURAL,
        beta: 0.1,
        rate: 500.0,
        seconds: 60.0,
        skip: 0.0,
    };
    let mut noise = Noise::new(5);
    let recording = recording(&system, &motions(&system, how), 500.0, 1000.0, &mut noise);
    let measured = Measured::of(&recording, system.scene()).unwrap();
    // Free vibration decays as e^{−ζω_n t}, and by friction.
    assert!(
        (1.0..20.0).contains(&measured.steady.0),
        "{:?}",
        measured.steady
    );
    let found = measured.transmissibility(0).unwrap();
    let expected = system.at(1.3).unwrap().response(0.1).unwrap();
    let expected = expected.harmonic(Of::Mass(0), 1).unwrap();
    // At the start of the steady interval the rest of the transient is below 2e-3, and the window suppresses most of
    // it.
    assert!((found.value - expected).norm() < 5e-4 * expected.norm());
}

/// Velocities and accelerations give the same result as displacements.
#[test]
fn any_kind_of_sensor() {
    let system = rig("");
    let omega = TAU * 4.0;
    let wave = |shift: f64, size: f64| -> Vec<f64> {
        (0..4000)
            .map(|i| size * (omega * f64::from(i) / 800.0 - 0.4 + shift).cos())
            .collect()
    };
    let base = Channel {
        name: "base".into(),
        unit: "um".parse().unwrap(),
        samples: (0..4000)
            .map(|i| 1750.0 * (omega * f64::from(i) / 800.0).cos())
            .collect(),
    };
    let quarter = TAU / 4.0;
    let kinds = [
        ("mm", wave(0.0, 3.5)),
        ("m/s", wave(quarter, 3.5e-3 * omega)),
        ("mm/s^2", wave(2.0 * quarter, 3.5 * omega * omega)),
        ("g", wave(2.0 * quarter, 3.5e-3 * omega * omega / 9.80665)),
    ];
    for (unit, samples) in kinds {
        let plate = Channel {
            name: "plate".into(),
            unit: unit.parse().unwrap(),
            samples,
        };
        let recording = Recording::new(800.0, vec![base.clone(), plate]).unwrap();
        let measured = Measured::of(&recording, system.scene()).unwrap();
        let found = measured.transmissibility(0).unwrap();
        assert!((found.amplitude() - 2.0).abs() < 1e-9, "{unit}: {found:?}");
        assert!((found.lag() - 0.4).abs() < 1e-9, "{unit}: {found:?}");
    }
}

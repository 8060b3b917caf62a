//! Tests of periodic loads: their samples, and tables that are invalid.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use super::{BaseTable, Harmonic, PeriodicError, PeriodicLoad, PeriodicRequest};
use crate::Of;
use crate::study::System;
use std::f64::consts::TAU;

const BLOCK: &str = "struct Block { masses: { m: 2 }, springs: { base - m: 800 },
    contact: m - wall, excitation: EXCITED, damping: modal(0.05) }";

fn block(excited: &str) -> System {
    BLOCK.replace("EXCITED", excited).parse().unwrap()
}

/// Checks that tables of a sine's accelerations, velocities and displacements give nearly the same motion of the base,
/// and that each motion is periodic.
#[test]
fn tables_of_the_base_agree() {
    let system = block("base");
    let (count, omega) = (64, 3.0);
    let step = TAU / omega / f64::from(count);
    let loads = [
        (BaseTable::Displacement, 1.0, 0.0),
        (BaseTable::Velocity, omega, 0.25),
        (BaseTable::Acceleration, omega * omega, 0.5),
    ];
    for (quantity, size, ahead) in loads {
        let samples: Vec<f64> = (0..=count)
            .map(|k| size * (TAU * (f64::from(k) / f64::from(count) + ahead)).sin())
            .collect();
        let load = PeriodicLoad::base(step, &samples, quantity).unwrap();
        let sampled = load.sampled(&system).unwrap();
        let points = sampled.points.len() / 64;
        for k in 0..64 {
            let [place, rate] = sampled.at(k * points).base;
            let angle = omega * step * k as f64;
            // The interpolation between 64 samples has errors of about (2π/64)²/12 in velocity and acceleration.
            assert!((place - angle.sin()).abs() < 1.7e-3, "{quantity:?} {place}");
            assert!(
                (rate / omega - angle.cos()).abs() < 1.7e-3,
                "{quantity:?} {rate}"
            );
        }
    }
}

#[test]
fn tables_that_mean_nothing() {
    let open = PeriodicLoad::forces(0.1, &[0.0, 1.0, 0.5]);
    assert_eq!(open, Err(PeriodicError::Open(0.0, 0.5)));
    let message = open.unwrap_err().to_string();
    assert!(
        message.contains("its first sample is 0 and its last one 0.5"),
        "{message}"
    );
    assert_eq!(
        PeriodicLoad::forces(0.1, &[1.0, 1.0]),
        Err(PeriodicError::Short)
    );
    assert_eq!(
        PeriodicLoad::forces(0.0, &[1.0, 2.0, 1.0]),
        Err(PeriodicError::Number)
    );
    assert_eq!(
        PeriodicLoad::forces(0.1, &[1.0, f64::NAN, 1.0]),
        Err(PeriodicError::Number)
    );
    let drifts = PeriodicLoad::base(0.1, &[0.0, 1.0, 0.0], BaseTable::Acceleration);
    assert_eq!(drifts, Err(PeriodicError::Drifts("acceleration", 0.5)));
    assert_eq!(
        PeriodicLoad::harmonics(1.0, &[]),
        Err(PeriodicError::NoHarmonics)
    );
    let one = Harmonic {
        order: 1,
        amplitude: 1.0,
        lag: 0.0,
    };
    let high = Harmonic { order: 1001, ..one };
    assert_eq!(
        PeriodicLoad::harmonics(1.0, &[high]),
        Err(PeriodicError::Order(1001))
    );
    assert_eq!(
        PeriodicLoad::harmonics(0.0, &[one]),
        Err(PeriodicError::Number)
    );
    let asked = |load: &PeriodicLoad, excited: &str, more: &str| {
        let text = BLOCK
            .replace("EXCITED", excited)
            .replace("damping:", &format!("{more} damping:"));
        let system: System = text.parse().unwrap();
        let request = PeriodicRequest {
            load: load.clone(),
            friction: 1.0,
            of: vec![Of::Contact],
        };
        system.periodic(&request).map(|state| state.period())
    };
    let force = PeriodicLoad::forces(0.1, &[0.0, 1.0, 0.0]).unwrap();
    let base = PeriodicLoad::base(0.1, &[0.0, 1.0, 0.0], BaseTable::Displacement).unwrap();
    assert_eq!(asked(&force, "base", ""), Err(PeriodicError::BaseMoves));
    assert_eq!(asked(&base, "m", ""), Err(PeriodicError::BaseAtRest));
    assert_eq!(
        asked(&base, "base", "input: hold, provide: [stepper],"),
        Err(PeriodicError::Held)
    );
    let long = PeriodicLoad::forces(1e4, &[0.0, 1.0, 0.0]).unwrap();
    assert_eq!(asked(&long, "m", ""), Err(PeriodicError::Long));
    let system = block("m");
    let request = PeriodicRequest {
        load: force,
        friction: 1.0,
        of: vec![Of::Mass(7)],
    };
    let error = system.periodic(&request).map(|state| state.period());
    assert_eq!(error, Err(PeriodicError::NoSuchMotion(Of::Mass(7))));
    let request = PeriodicRequest {
        friction: -1.0,
        of: vec![],
        ..request
    };
    assert!(matches!(
        system.periodic(&request),
        Err(PeriodicError::Step(_))
    ));
}

//! Identification of mass and friction of an axis without a spring.

use crate::made::Noise;
use frictiongen::measure::{Channel, Recording, Unit};
use std::f64::consts::TAU;

/// A simulated recording replaces the EMPS benchmark (electro-mechanical positioning system), whose data is not
/// available here. A controller moves an axis with the published parameters to and fro for 25 s at 1 kHz. Position and
/// force are noisy.
#[test]
fn an_axis_without_a_spring() {
    let truth = [95.1089, 203.5034, 20.3935, -3.1648];
    let [mass, viscous, coulomb, offset] = truth;
    let (rate, steps) = (1000.0, 100);
    let dt = 1.0 / (rate * f64::from(steps));
    let (mut q, mut v, mut sum) = (0.0_f64, 0.0_f64, 0.0_f64);
    let (mut positions, mut forces) = (Vec::new(), Vec::new());
    let mut noise = Noise::new(95);
    for sample in 0..25_000 {
        let t = f64::from(sample) / rate;
        // The path goes to 0.25 m and back with a faster wave on top, because the trajectories of the bench mix slow
        // and fast motion.
        let wanted = 0.125 * (1.0 - (TAU * 0.16 * t).cos())
            + 0.006 * (TAU * 0.9 * t).sin() * (TAU * 0.04 * t).sin();
        let error = wanted - q;
        sum += error / rate;
        let force = 4.0e4 * error - 1.6e3 * v + 2.0e4 * sum;
        forces.push(force + 1.0 * noise.next());
        for step in 0..steps {
            if 2 * step == steps {
                // The position is sampled in the middle of the interval in which the force is constant.
                positions.push(q + 2e-6 * noise.next());
            }
            let push = force - offset - viscous * v;
            if v == 0.0 && push.abs() <= coulomb {
                continue;
            }
            let side = if v == 0.0 { push.signum() } else { v.signum() };
            let next = v + dt * (push - coulomb * side) / mass;
            v = if v != 0.0 && (next < 0.0) != (v < 0.0) {
                0.0
            } else {
                next
            };
            q += dt * v;
        }
    }
    let channel = |name: &str, unit: Unit, samples| Channel {
        name: name.into(),
        unit,
        samples,
    };
    let channels = vec![
        channel("axis", Unit::METRE, positions),
        channel("force", Unit::NEWTON, forces),
    ];
    let recording = Recording::new(rate, channels).unwrap();
    let found = recording.regression("axis", 0.05).unwrap();
    let mut failed = false;
    for (name, found, truth, part) in [
        ("M", found.mass, mass, 0.01),
        ("Fv", found.viscous, viscous, 0.01),
        ("Fc", found.coulomb, coulomb, 0.01),
        ("offset", found.offset, offset, 0.03),
    ] {
        println!("{name}: {found:?} for {truth}");
        failed |= !((found.value / truth - 1.0).abs() < part);
        failed |= !found.holds(truth);
    }
    assert!(!failed, "{found:?}");
    // An axis that moves in one direction only does not determine its friction.
    let along: Vec<f64> = (0..4000).map(|i| f64::from(i) * 1e-4).collect();
    let forces: Vec<f64> = (0..4000).map(|i| 20.0 + f64::from(i % 3)).collect();
    let channels = vec![
        channel("axis", Unit::METRE, along),
        channel("force", Unit::NEWTON, forces),
    ];
    let error = Recording::new(rate, channels)
        .unwrap()
        .regression("axis", 0.05)
        .unwrap_err();
    assert!(
        error
            .to_string()
            .contains("does not separate mass and friction"),
        "{error}"
    );
}

//! Tests a frame under a ground motion: the energy that damping takes, with both meanings of damping.

use crate::stepper::both::Both;
use crate::stepper::rig::{LINEAR, Load, scene};
use fuzzing::Random;

/// Five storeys with a damping ratio of one per cent. A friction damper joins the base and the first floor.
const FRAME: &str = "struct Five {
    masses: { f1: 2000, f2: 2000, f3: 2000, f4: 2000, f5: 2000 },
    springs: { base - f1: 1.5e6, f1 - f2: 1.5e6, f2 - f3: 1.5e6, f3 - f4: 1.5e6, f4 - f5: 1.5e6 },
    contact: base - f1, excitation: base, damping: modal(0.01), damping_from: FROM }";

const STEP: f64 = 0.005;

/// Returns a ground motion of 25 s as displacement and velocity at a time. It consists of sixty waves of 0.1 to 12 Hz
/// from a fixed seed, under an envelope that rises and falls. The velocity is the exact derivative of the
/// displacement.
fn ground() -> impl Fn(f64) -> [f64; 2] {
    let mut random = Random(44);
    let waves: Vec<[f64; 3]> = (0..60)
        .map(|_| {
            let omega = std::f64::consts::TAU * random.power(-1.0, 1.08);
            [
                omega,
                SIZE * random.unit() / (omega * (1.0 + omega / 12.0)),
                random.between(0.0, 6.3),
            ]
        })
        .collect();
    move |t: f64| {
        let (decay, rate) = ((-t / 5.0).exp(), 1.0 / 5.0);
        let envelope = t * t * decay / 8.0;
        let slope = (2.0 * t - rate * t * t) * decay / 8.0;
        let mut motion = [0.0; 2];
        for [omega, size, phase] in &waves {
            let (sine, cosine) = (omega * t + phase).sin_cos();
            motion[0] += envelope * size * sine;
            motion[1] += size * (slope * sine + envelope * omega * cosine);
        }
        motion
    }
}

/// Velocity amplitude of the largest wave, in m/s.
const SIZE: f64 = 0.06424;

/// Returns the energy in J that damping takes, according to the stepper and according to the integrator with dense
/// matrices.
fn lost(from: &str) -> [f64; 2] {
    let scene = scene(&FRAME.replace("FROM", from));
    let ground = ground();
    let load = |step: u32| Load {
        base: ground(STEP * f64::from(step)),
        forces: vec![0.0; 5],
        friction: 11_421.0,
    };
    let mut both = Both::new(&scene, LINEAR, STEP, &load(0));
    for step in 1..=5000 {
        both.advance(&load(step));
    }
    let (own, plain) = (both.rig.work(), both.plain.work);
    assert!(both.error() < 1e-11, "{:e}", both.error());
    let balance = own.load - own.friction - own.damping - own.stored;
    assert!(balance.abs() < 1e-9 * own.load, "{own:?}");
    assert!(
        (own.friction / plain.friction - 1.0).abs() < 1e-10,
        "{own:?} {plain:?}"
    );
    println!("{from}: {own:?}, {} events", both.plain.events);
    [own.damping, plain.damping]
}

#[test]
fn energy_of_damping() {
    let [own, plain] = lost("base");
    assert!((own / plain - 1.0).abs() < 1e-9, "{own} {plain}");
    assert!((own / 650.0 - 1.0).abs() < 0.01, "{own}");
    // Damping on absolute velocities resists the motion of the ground, so it takes more energy.
    let [absolute, other] = lost("rest");
    assert!((absolute / other - 1.0).abs() < 1e-9, "{absolute} {other}");
    assert!(absolute > 5.0 * own, "{absolute} {own}");
}

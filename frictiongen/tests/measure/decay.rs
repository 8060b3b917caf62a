//! Free vibrations, compared with an independent integration.

use crate::intervals::hold;
use crate::made::{NATURAL, Noise, rig};
use frictiongen::measure::{Channel, Estimate, MeasureError, Recording, Unit};
use std::f64::consts::TAU;

/// Returns the displacement in m of a mass that is fixed at x₀ for 0.3 s and then released. The function integrates ẍ =
/// −ω²(x − c) − 2ζωẋ − ω²ℓ sgn ẋ in small steps.
fn vibration(zeta: f64, length: f64, rate: f64, seconds: f64) -> Vec<f64> {
    let omega = TAU * NATURAL;
    let steps = 400;
    let dt = 1.0 / (rate * f64::from(steps));
    let (mut x, mut v) = (10e-3_f64, 0.0_f64);
    let (middle, mut stuck) = (0.4e-3, false);
    let mut all = vec![x; (0.3 * rate) as usize];
    while (all.len() as f64) < seconds * rate {
        for _ in 0..steps {
            if stuck {
                continue;
            }
            let free = -omega * omega * (x - middle);
            let side = if v == 0.0 { -free.signum() } else { v.signum() };
            if v == 0.0 && free.abs() <= omega * omega * length {
                stuck = true;
                continue;
            }
            let push = if v == 0.0 { free.signum() } else { side };
            let acceleration = |x: f64, v: f64| {
                -omega * omega * (x - middle)
                    - 2.0 * zeta * omega * v
                    - omega * omega * length * push
            };
            // The midpoint rule applies. In a step in which the mass turns, it applies up to the turning point.
            let a = acceleration(x, v);
            let vm = v + 0.5 * dt * a;
            let next = v + dt * acceleration(x + 0.5 * dt * v, vm);
            if v != 0.0 && (next < 0.0) != (v < 0.0) {
                let part = v / (v - next);
                x += 0.5 * part * dt * v;
                v = 0.0;
                // The rest of that step goes the other way, if the spring overcomes friction.
                let free = -omega * omega * (x - middle);
                let left = (1.0 - part) * dt;
                if free.abs() > omega * omega * length {
                    v = left * (free - free.signum() * omega * omega * length);
                    x += 0.5 * left * v;
                }
            } else {
                x += dt * vm;
                v = next;
            }
        }
        all.push(x);
    }
    all
}

fn recording(samples: Vec<f64>, rate: f64) -> Recording {
    let samples = samples.into_iter().map(|x| 1e3 * x).collect();
    let channel = Channel {
        name: "plate".into(),
        unit: Unit::MILLIMETRE,
        samples,
    };
    Recording::new(rate, vec![channel]).unwrap()
}

#[test]
fn friction_alone_and_with_damping() {
    let system = rig("");
    let stiffness = system.scene().springs[0].stiffness;
    for (zeta, length) in [(0.0, 0.35e-3), (0.01, 0.2e-3), (0.03, 0.05e-3)] {
        let clean = vibration(zeta, length, 1000.0, 6.0);
        let found = system
            .free_decay(&recording(clean.clone(), 1000.0), None)
            .unwrap();
        // The tolerance allows for the integration's own error at a step of 2.5 µs.
        assert!(
            (found.length.value / length - 1.0).abs() < 2e-4,
            "ζ = {zeta}: {found:?}"
        );
        assert!(
            (found.damping.value - zeta).abs() < 2e-6,
            "ζ = {zeta}: {:?}",
            found.damping
        );
        assert!(
            (found.hertz.value / NATURAL - 1.0).abs() < 2e-5,
            "{:?}",
            found.hertz
        );
        assert!((found.friction.value - found.length.value * stiffness).abs() < 1e-12);
        assert!((found.friction_ratio(1.75e-3) - found.length.value / 1.75e-3).abs() < 1e-12);
        if zeta == 0.0 {
            // Without damping the linear decrement is the same, up to the error of extremes that fall between samples.
            assert!(
                (found.linear_decrement / length - 1.0).abs() < 1e-3,
                "{found:?}"
            );
        } else {
            // The caller knows the damping.
            let known = system
                .free_decay(&recording(clean, 1000.0), Some(zeta))
                .unwrap();
            assert!((known.length.value / length - 1.0).abs() < 2e-4);
            assert_eq!(known.damping.from, known.damping.to);
        }
    }
}

#[test]
fn intervals_of_a_decay() {
    let system = rig("");
    let clean = vibration(0.01, 0.2e-3, 250.0, 4.0);
    let (mut friction, mut damping, mut hertz) = (Vec::new(), Vec::new(), Vec::<Estimate>::new());
    for seed in 0..1000 {
        let mut samples = clean.clone();
        // The noise is 40 dB below the first swing.
        Noise::new(seed).add(&mut samples, 0.1e-3 / 2.0_f64.sqrt());
        let found = system.free_decay(&recording(samples, 250.0), None).unwrap();
        friction.push(found.length);
        damping.push(found.damping);
        hertz.push(found.hertz);
    }
    hold("F/k of a decay", 0.2e-3, &friction);
    hold("ζ of a decay", 0.01, &damping);
    hold("f_n of a decay", NATURAL, &hertz);
}

#[test]
fn no_decay_to_read() {
    let system = rig("");
    let told = |samples: Vec<f64>| {
        system
            .free_decay(&recording(samples, 1000.0), None)
            .unwrap_err()
    };
    // The mass sticks at once.
    let error = told(vibration(0.0, 4e-3, 1000.0, 3.0));
    assert!(matches!(error, MeasureError::FewPeaks(_)), "{error}");
    let growing =
        |i: i32| 1e-3 * (1.0 + f64::from(i) / 1000.0) * (TAU * 3.0 * f64::from(i) / 1000.0).cos();
    let error = told((0..4000).map(growing).collect());
    assert!(matches!(error, MeasureError::NoDecay), "{error}");
    // The vibration is steady up to rounding.
    let steady = |i: i32| 3.5e-3 * (25.0 * f64::from(i) / 500.0 - 0.3).cos();
    let error = told((0..5000).map(steady).collect());
    assert!(matches!(error, MeasureError::NoDecay), "{error}");
    let noise = {
        let mut samples = vec![0.0; 3000];
        Noise::new(1).add(&mut samples, 1e-4);
        samples
    };
    let error = told(noise);
    assert!(matches!(error, MeasureError::FewPeaks(_)), "{error}");
    let pair: frictiongen::System = "struct Pair {
        masses: { plate: 1, top: 1 }, springs: { base - plate: 1, plate - top: 1 }, contact: top - wall, excitation: base,
    }"
    .parse()
    .unwrap();
    let error = pair
        .free_decay(&recording(vibration(0.0, 1e-4, 500.0, 3.0), 500.0), None)
        .unwrap_err();
    assert!(error.to_string().contains("several masses beat"), "{error}");
}

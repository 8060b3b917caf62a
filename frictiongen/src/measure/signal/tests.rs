//! Tests motions under signals against closed forms.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use super::{Signal, SignalInputs};
use crate::measure::MeasureError;
use crate::study::System;
use crate::study::joined::JoinedHistory;
use std::f64::consts::{PI, TAU};

/// Mass 2 kg on a spring of 200 N/m: ω = 10 rad/s.
const SPRUNG: &str = "struct S {
    masses: { m: 2 }, springs: { base - m: 200 }, contact: m - wall, excitation: m,
}";
const OMEGA: f64 = 10.0;
const STIFFNESS: f64 = 200.0;

fn history(
    scene: &str,
    texts: &[&str],
    (until, samples): (f64, usize),
    friction: f64,
) -> JoinedHistory {
    let system: System = scene.parse().unwrap();
    let signals = texts
        .iter()
        .map(|text| Signal::parse(text, &system).unwrap());
    let signals: Vec<Signal> = signals.collect();
    let inputs = SignalInputs::new(&signals, (until, samples), friction).unwrap();
    inputs.history(&system.joined().unwrap(), None).unwrap()
}

/// Signals that act together, and the displacement in closed form.
type Case<'c> = (&'c [&'c str], &'c dyn Fn(f64) -> f64);

/// Compares the displacements of the first mass with a closed form. Returns the largest difference.
fn largest_error(history: &JoinedHistory, exact: impl Fn(f64) -> f64) -> f64 {
    let samples = history.taus.iter().zip(&history.states);
    let errors = samples.map(|(time, (x, _))| (x[0] - exact(*time)).abs());
    errors.fold(0.0, f64::max)
}

fn sprung(texts: &[&str], exact: impl Fn(f64) -> f64) -> f64 {
    largest_error(&history(SPRUNG, texts, (3.0, 700), 0.0), exact)
}

/// Response of the mass on its spring to a force that is 1 from the time 0 on.
fn step(t: f64) -> f64 {
    if t <= 0.0 {
        0.0
    } else {
        (1.0 - (OMEGA * t).cos()) / STIFFNESS
    }
}

/// Response to a force t from the time 0 on.
fn ramp(t: f64) -> f64 {
    if t <= 0.0 {
        0.0
    } else {
        (t - (OMEGA * t).sin() / OMEGA) / STIFFNESS
    }
}

/// Response to a force sin νt from the time 0 on.
fn sine(nu: f64, t: f64) -> f64 {
    if t <= 0.0 {
        return 0.0;
    }
    let ratio = nu / OMEGA;
    ((nu * t).sin() - ratio * (OMEGA * t).sin()) / (1.0 - ratio * ratio) / STIFFNESS
}

#[test]
fn a_mass_on_a_spring() {
    let cases: [Case<'_>; 8] = [
        (&["const 3 N"], &|t| 3.0 * step(t)),
        (&["step 3 N from 0.5 s"], &|t| 3.0 * step(t - 0.5)),
        (&["rectangle 3 kN from 0.5 s for 250 ms"], &|t| {
            3e3 * (step(t - 0.5) - step(t - 0.75))
        }),
        (&["ramp 3 N from 0.5 s for 0.7 s"], &|t| {
            3.0 / 0.7 * (ramp(t - 0.5) - ramp(t - 1.2))
        }),
        (&["sine 3 N at 2 Hz from 0.25 s"], &|t| {
            3.0 * sine(2.0 * TAU, t - 0.25)
        }),
        // A half wave is a sine plus the same sine half a period later.
        (&["half-sine 3 N from 0.5 s for 0.2 s"], &|t| {
            3.0 * (sine(PI / 0.2, t - 0.5) + sine(PI / 0.2, t - 0.7))
        }),
        // Five half waves end like one.
        (&["sine 3 N, at 2.5 Hz, from 0.5 s, for 1 s"], &|t| {
            3.0 * (sine(2.5 * TAU, t - 0.5) + sine(2.5 * TAU, t - 1.5))
        }),
        (
            &["sine 3 N at 2 Hz", "sine -1N at 3Hz from 1s", "step 2 N"],
            &|t| 3.0 * sine(2.0 * TAU, t) - sine(3.0 * TAU, t - 1.0) + 2.0 * step(t),
        ),
    ];
    for (texts, exact) in cases {
        let error = sprung(texts, exact);
        let size = (0..300)
            .map(|i| exact(0.01 * f64::from(i)).abs())
            .fold(0.0, f64::max);
        println!("{texts:?}: {:.1e}", error / size);
        assert!(error < 1e-12 * size, "{texts:?}: {error:e} of {size:e}");
    }
}

/// A block on the floor: it stays below the static friction force, then v = (P − F)t/m, and it stops after the force.
#[test]
fn a_sliding_block() {
    let block = "struct B { masses: { m: 2 }, contacts: { floor: m - wall { stiction: 1.5 } }, excitation: m }";
    let history = history(
        block,
        &["step 5 N from 0.5 s for 1 s", "ramp 4 N from 4 s for 2 s"],
        (6.0, 600),
        3.0,
    );
    let at = |time: f64| {
        let (x, v) = &history.states[(100.0 * time).round() as usize];
        (x[0], v[0])
    };
    let (x, v) = at(1.25);
    assert!((v - 0.75).abs() < 1e-13 && (x - 0.5 * 0.75 * 0.75).abs() < 1e-13);
    // The force ends at the speed 1 m/s, and friction stops the block 2/3 s later.
    let words: Vec<&str> = history.events.iter().map(|event| event.word()).collect();
    assert_eq!(words, ["slip", "stop"]);
    assert!((history.events[1].tau - (1.5 + 2.0 / 3.0)).abs() < 1e-12);
    assert!((at(6.0).0 - (0.5 + 1.0 / 3.0)).abs() < 1e-12);
    // The ramp of 4 N stays below the static friction force of 4.5 N.
    assert!((history.contacts[500][0].force - 2.0).abs() < 1e-12);
}

/// A base that moves by a displacement, a velocity or an acceleration.
#[test]
fn a_moving_base() {
    let scene = SPRUNG.replace("excitation: m", "excitation: base");
    let moved = |text: &str| history(&scene, &[text], (3.0, 700), 0.0);
    // A displacement y of the base is a force ky.
    let cases: [(&str, &dyn Fn(f64) -> f64); 6] = [
        ("step 2 mm from 0.5 s for 1 s", &|t| {
            2e-3 * STIFFNESS * (step(t - 0.5) - step(t - 1.5))
        }),
        ("half-sine 2 mm from 0.5 s for 0.2 s", &|t| {
            2e-3 * STIFFNESS * (sine(PI / 0.2, t - 0.5) + sine(PI / 0.2, t - 0.7))
        }),
        ("step 0.1 m/s from 0.5 s for 1 s", &|t| {
            0.1 * STIFFNESS * (ramp(t - 0.5) - ramp(t - 1.5))
        }),
        // The displacement under the velocity sin νt is (1 − cos νt)/ν.
        ("sine 0.1 m/s at 2 Hz from 0.5 s", &|t| {
            let (nu, t) = (2.0 * TAU, t - 0.5);
            if t <= 0.0 {
                return 0.0;
            }
            let ratio = nu / OMEGA;
            let cosine = ((nu * t).cos() - (OMEGA * t).cos()) / (1.0 - ratio * ratio);
            0.1 / nu * (1.0 - (OMEGA * t).cos() - cosine)
        }),
        // The displacement under the acceleration sin νt is t/ν − sin νt/ν².
        ("sine 2 m/s2 at 2 Hz from 0.5 s", &|t| {
            let nu = 2.0 * TAU;
            2.0 * STIFFNESS * (ramp(t - 0.5) / nu - sine(nu, t - 0.5) / (nu * nu))
        }),
        // Half the square of the time is the solution x − (1 − cos ωt)/ω² of the oscillator.
        ("step 2 m/s2 from 0.5 s", &|t| {
            let t = (t - 0.5).max(0.0);
            t * t - 2.0 * step(t) * STIFFNESS / (OMEGA * OMEGA)
        }),
    ];
    for (text, exact) in cases {
        let error = largest_error(&moved(text), exact);
        let size = (0..300)
            .map(|i| exact(0.01 * f64::from(i)).abs())
            .fold(0.0, f64::max);
        println!("{text}: {:.1e}", error / size);
        assert!(error < 1e-11 * size, "{text}: {error:e} of {size:e}");
    }
}

/// A block that sticks on a base whose velocity jumps slides until it has the velocity of the base.
#[test]
fn a_contact_with_a_moving_base() {
    let scene = "struct B { masses: { m: 2 }, contacts: { floor: m - base }, excitation: base }";
    let history = history(scene, &["step 0.6 m/s from 0.5 s"], (2.0, 200), 3.0);
    // The friction force accelerates the block with 1.5 m/s² for 0.4 s.
    let (x, v) = &history.states[200];
    assert!((v[0] - 0.6).abs() < 1e-13);
    assert!((x[0] - (0.5 * 1.5 * 0.16 + 0.6 * 1.1)).abs() < 1e-12);
    assert!((history.events.last().unwrap().tau - 0.9).abs() < 1e-12);
}

/// A chirp against an integration with small steps. The error is that of its pieces.
#[test]
fn a_chirp() {
    let history = history(
        SPRUNG,
        &["chirp 3 N at 0.5 Hz to 4 Hz for 3 s"],
        (3.0, 300),
        0.0,
    );
    let force = |t: f64| 3.0 * (TAU * (0.5 * t + 3.5 / 6.0 * t * t)).sin();
    let slope = |t: f64, [x, v]: [f64; 2]| [v, (force(t) - STIFFNESS * x) / 2.0];
    let (mut y, h) = ([0.0; 2], 1e-4);
    let (mut worst, mut size) = (0.0_f64, 0.0_f64);
    for i in 0..30_000 {
        if i % 100 == 0 {
            worst = worst.max((history.states[i / 100].0[0] - y[0]).abs());
            size = size.max(y[0].abs());
        }
        let t = h * i as f64;
        let add = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
        let a = slope(t, y);
        let b = slope(t + h / 2.0, add(y, a, h / 2.0));
        let c = slope(t + h / 2.0, add(y, b, h / 2.0));
        let d = slope(t + h, add(y, c, h));
        for (k, weight) in [(a, 1.0), (b, 2.0), (c, 2.0), (d, 1.0)] {
            y = add(y, k, h / 6.0 * weight);
        }
    }
    println!("{:.1e}", worst / size);
    assert!(worst < 2e-6 * size, "{worst:e} of {size:e}");
}

/// The energy balance: on a linear chain the work of the load is what damping dissipates and the chain stores.
#[test]
fn work_of_a_sine() {
    let system: System = SPRUNG.parse().unwrap();
    let signals = [Signal::parse("sine 3 N at 2 Hz", &system).unwrap()];
    let inputs = SignalInputs::new(&signals, (1.3, 13), 0.4).unwrap();
    let joined = system.joined().unwrap();
    let mut step = inputs.stepper(&joined, None).unwrap();
    super::super::Drive::follow(&inputs, &mut step, &joined, &mut |_, _, _| true).unwrap();
    let work = step.work();
    let energy = step.contact_named("contact").unwrap().energy;
    let [x, v] = step.masses()[0];
    assert!((work.stored - (v * v + 100.0 * x * x)).abs() < 1e-13);
    assert!((work.friction - energy).abs() < 1e-13);
    assert!(work.load > 0.0 && work.damping.abs() < 1e-13, "{work:?}");
}

#[test]
fn what_is_refused() {
    let system: System = SPRUNG.parse().unwrap();
    let shaken: System = SPRUNG
        .replace("excitation: m", "excitation: base")
        .parse()
        .unwrap();
    let refused = |system: &System, text: &str| {
        let error = Signal::parse(text, system).unwrap_err();
        assert!(matches!(error, MeasureError::Signal { .. }));
        error.to_string()
    };
    for (text, says) in [
        ("", "is no shape"),
        ("pulse 5 N for 1 s", "a pulse is `half-sine` or `rectangle`"),
        ("step", "it lacks an amplitude"),
        ("step 5", "`5` has no unit"),
        ("step 5 s", "`s` is no unit of an amplitude"),
        ("step 5 N at 1 s", "the start is `from … s`"),
        ("step nan N", "must be a finite number"),
        ("sine 5 N", "`sine` needs `at … Hz`"),
        ("sine 5 N at 0 Hz", "must be above 0 Hz"),
        ("ramp 5 N", "`ramp` needs `for … s`"),
        ("half-sine 5 N for 0 s", "must be above 0 s"),
        ("step 5 N from -1 s", "must be at least 0 s"),
        ("step 5 N from 1 s from 2 s", "`from` stands twice"),
        ("const 5 N from 1 s", "write `step`"),
        ("step 5 N on roof", "`roof` is no mass; the masses are m"),
        ("step 5 mm", "the base of this scene is at rest"),
        ("step 5 N soon", "`soon` is not understood"),
        (
            "chirp 5 N at 1 Hz to 1e9 Hz for 1e4 s",
            "pieces of constant frequency",
        ),
    ] {
        let error = refused(&system, text);
        assert!(error.contains(says), "{text}: {error}");
    }
    for (text, says) in [
        ("step 5 N", "name a mass as in `on m`"),
        ("step 5 mm on m", "`on` belongs to a force"),
        (
            "chirp 5 mm at 1 Hz to 2 Hz for 1 s",
            "is a velocity or an acceleration",
        ),
    ] {
        let error = refused(&shaken, text);
        assert!(error.contains(says), "{text}: {error}");
    }
    let twice = [
        Signal::parse("step 5 mm", &shaken).unwrap(),
        Signal::parse("step 1 g", &shaken).unwrap(),
    ];
    assert!(SignalInputs::new(&twice, (1.0, 10), 0.0).is_err());
    assert!(SignalInputs::new(&[], (0.0, 10), 0.0).is_err());
}

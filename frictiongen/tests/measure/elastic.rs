//! Friction force and stiffness of an elastic contact from recordings. The recordings come from a plain integrator in
//! the test, which shares no code with the solver.

use crate::made::{NATURAL, Noise, Y};
use frictiongen::System;
use frictiongen::measure::{
    Channel, IdentifyRequest, Inputs, MeasureError, Measured, Observation, Recording, Unit,
    Unknown, Verdict,
};
use frictiongen::study::sensitivity::Quantity;
use std::f64::consts::TAU;

/// Mass of the plate in kg, its damping ratio, and the stiffness of the contact in N/m.
const MASS: f64 = 2.0;
const ZETA: f64 = 0.01;
const STIFFNESS: f64 = 2.0e3;
/// Friction force in N.
const FORCE: f64 = 0.6;

/// Returns the rig of chapter 4 with an elastic contact of this stiffness.
fn rig(stiffness: f64) -> System {
    let omega = TAU * NATURAL;
    format!(
        "struct Rig {{ masses: {{ plate: {MASS:?} }}, springs: {{ base - plate: {:?} }}, contact: plate - wall,
            stiffness: {stiffness:?}, excitation: base, damping: modal[{ZETA:?}], provide: [orbit, simulation] }}",
        MASS * omega * omega
    )
    .parse()
    .unwrap()
}

/// Steps of the integrator in one sample.
const STEPS: u32 = 40;

/// Integrates the plate with its Jenkins element by the leapfrog method. `base` is the motion of the base. Returns the
/// displacement of the plate at every sample after `skip` samples, and the force of the contact.
fn integrated(
    base: impl Fn(f64) -> f64,
    (rate, skip, count): (f64, usize, usize),
    (stiffness, friction): (f64, f64),
) -> (Vec<f64>, Vec<f64>) {
    let omega = TAU * NATURAL;
    let h = 1.0 / (rate * f64::from(STEPS));
    let (mut x, mut v, mut force) = (0.0_f64, 0.0_f64, 0.0_f64);
    let (mut places, mut forces) = (Vec::new(), Vec::new());
    for sample in 0..skip + count {
        if skip <= sample {
            places.push(x);
            forces.push(force);
        }
        for step in 0..STEPS {
            let time = sample as f64 / rate + h * f64::from(step);
            let half = x + 0.5 * h * v;
            let trial = (force + 0.5 * stiffness * h * v).clamp(-friction, friction);
            let pull = omega * omega * (base(time + 0.5 * h) - half) - trial / MASS;
            // The damping term is implicit, so that the method stays of second order.
            let damping = ZETA * omega * h;
            let next = (v * (1.0 - damping) + h * pull) / (1.0 + damping);
            x = half + 0.5 * h * next;
            force = (trial + 0.5 * stiffness * h * next).clamp(-friction, friction);
            v = next;
        }
    }
    (places, forces)
}

fn observed(system: &System, hertz: f64, friction: f64, noise: &mut Noise) -> Observation {
    let rate = 200.0;
    let base = |time: f64| Y * (TAU * hertz * time).cos();
    // The transient of ζ = 0.01 has died out to e⁻⁹ after 45 s.
    let shape = (rate, 9_000, 6_000);
    let (plate, _) = integrated(base, shape, (STIFFNESS, friction));
    let start = shape.1;
    let base = (start..start + plate.len()).map(|sample| base(sample as f64 / rate));
    let channels = [("base", base.collect::<Vec<_>>()), ("plate", plate)];
    let channels = channels.map(|(name, mut samples)| {
        noise.add(&mut samples, 0.005 * Y);
        let samples = samples.into_iter().map(|x| 1e3 * x).collect();
        Channel {
            name: name.to_owned(),
            unit: Unit::MILLIMETRE,
            samples,
        }
    });
    let recording = Recording::new(rate, channels.to_vec()).unwrap();
    Observation::of(
        &Measured::of(&recording, system.scene()).unwrap(),
        system,
        1,
    )
}

const K: Unknown = Unknown::Quantity(Quantity::ContactStiffness);

fn both() -> IdentifyRequest {
    IdentifyRequest {
        unknowns: vec![K],
        ..IdentifyRequest::default()
    }
}

/// Force and stiffness are found from three recordings, although the description has a stiffness that is wrong by a
/// factor of six. The noise is 0.5 % of the base's amplitude.
#[test]
fn force_and_stiffness_are_found_together() {
    let mut noise = Noise::new(45);
    for guess in [STIFFNESS, STIFFNESS / 6.0, STIFFNESS * 6.0] {
        let guess = rig(guess);
        let seen = [0.7, 1.15, 1.5].map(|r| observed(&guess, r * NATURAL, FORCE, &mut noise));
        let found = guess.identify(&seen, &both()).unwrap();
        assert_eq!(found.verdict, Verdict::Determined);
        let (unknown, stiffness) = found.unknowns[0];
        println!("F = {:?}, k = {stiffness:?}", found.friction);
        assert_eq!(unknown, K);
        // A standard deviation of the intervals is about 0.013 % of F and 0.05 % of k, so that four of them are allowed.
        assert!((found.friction.value / FORCE - 1.0).abs() < 5e-4);
        assert!((stiffness.value / STIFFNESS - 1.0).abs() < 2e-3);
        assert!(stiffness.to - stiffness.from < 4e-3 * STIFFNESS);
        assert_eq!(found.system.scene().stiffness, Some(stiffness.value));
    }
}

/// With the known stiffness the force alone is found. A contact that never slides determines the stiffness, and the
/// least force that holds it.
#[test]
fn a_stuck_contact_determines_its_stiffness_alone() {
    let mut noise = Noise::new(46);
    let system = rig(STIFFNESS);
    let slides = observed(&system, 1.15 * NATURAL, FORCE, &mut noise);
    let alone = system
        .identify(&[slides], &IdentifyRequest::default())
        .unwrap();
    assert_eq!(alone.verdict, Verdict::Determined);
    assert!((alone.friction.value / FORCE - 1.0).abs() < 1e-3);

    let stuck = [1.15, 1.5].map(|r| observed(&system, r * NATURAL, 40.0, &mut noise));
    let alone = system.identify(&stuck, &IdentifyRequest::default());
    assert_eq!(alone.unwrap().verdict, Verdict::Stuck);
    let found = rig(STIFFNESS * 1.5).identify(&stuck, &both()).unwrap();
    let (_, stiffness) = found.unknowns[0];
    println!(
        "stuck: {:?}, F = {:?}, k = {stiffness:?}",
        found.verdict, found.friction
    );
    // The interval is ± 0.02 % wide.
    assert!((stiffness.value / STIFFNESS - 1.0).abs() < 1e-3);
    assert!(found.friction.to.is_infinite());
    assert_ne!(found.verdict, Verdict::Determined);
}

/// A recorded base motion drives the stepper as it drives the plain integrator. The base moves in straight lines through
/// samples of a pulse train.
#[test]
fn a_recording_drives_an_elastic_contact() {
    let system = rig(STIFFNESS);
    let rate = 200.0;
    let pulses = |time: f64| Y * (1.0 - (TAU * 2.0 * time).cos()) * (1.0 - (-time).exp());
    let base = |time: f64| {
        let (from, place) = ((rate * time).floor(), rate * time);
        let [before, after] = [from, from + 1.0].map(|sample| pulses(sample / rate));
        before + (after - before) * (place - from)
    };
    let count = 800;
    let (plate, forces) = integrated(base, (rate, 0, count), (STIFFNESS, FORCE));
    let samples: Vec<f64> = (0..count)
        .map(|sample| pulses(sample as f64 / rate))
        .collect();
    let channel = Channel {
        name: "base".to_owned(),
        unit: "m".parse().unwrap(),
        samples,
    };
    let recording = Recording::new(rate, vec![channel]).unwrap();
    let inputs = Inputs::of(&recording, &system, Some(FORCE)).unwrap();
    let mut step = inputs.stepper(&system).unwrap();
    let (mut worst, mut events, mut slid) = ([0.0_f64; 2], 0, 0);
    for sample in 1..count {
        events += step.advance(inputs.at(sample)).unwrap().events;
        let apart = (step.mass("plate").unwrap().displacement() - plate[sample]).abs() / Y;
        let force = (step.contact().force() - forces[sample]).abs() / FORCE;
        worst = [worst[0].max(apart), worst[1].max(force)];
        slid += usize::from(forces[sample].abs() == FORCE);
    }
    println!("{events} events, {slid} samples slide, differences {worst:?}");
    // The integrator's step h is 1.25e-4 s. It shifts frequencies by (ωh)²/24 = 1e-6 for ω = 37 1/s of the plate with its
    // spring. Differences of a few millionths are therefore expected.
    assert!(worst[0] < 5e-6 && worst[1] < 2e-5, "{worst:?}");
    assert!(10 < events && 100 < slid && slid < 700);
}

/// A free vibration is refused by name, because its extremes do not decrease by equal steps.
#[test]
fn a_free_vibration_is_refused_by_name() {
    let channel = Channel {
        name: "plate".to_owned(),
        unit: Unit::MILLIMETRE,
        samples: (0..500).map(|i| (0.1 * f64::from(i)).cos()).collect(),
    };
    let recording = Recording::new(100.0, vec![channel]).unwrap();
    let refused = rig(STIFFNESS).free_decay(&recording, None).unwrap_err();
    assert!(matches!(refused, MeasureError::Asked(told) if told.contains("has `stiffness`")));
}

//! Tests that runs of a million events miss no event, and that their phase does not drift.

use frictiongen::System;
use frictiongen::kernel::simulation::{Contact, Event};

/// Number of events of a run, which is the same in every build profile.
const EVENTS: u64 = 1_000_000;

/// Asserts that after the transient every cycle has `per_cycle` events. Their phases must equal those of the steady
/// state, which the solver finds as a fixed point of the cycle map, without this run.
fn run(text: &str, r: f64, beta: f64, per_cycle: u64) {
    let system: System = text.parse().expect("a scene");
    let mut run = system.simulation(r, beta).expect("in the domain");
    while run.run().cycles() < 500 {
        let _ = run.next();
    }
    let from = run.run().cycles();
    let orbit = system
        .at(r)
        .expect("in the domain")
        .orbit(beta)
        .expect("steady");
    let mut phases: Vec<f64> = orbit
        .sticking_intervals()
        .flat_map(|(start, length)| [start, start + length])
        .collect();
    for phase in &mut phases {
        *phase = phase.rem_euclid(std::f64::consts::TAU);
    }
    assert_eq!(phases.len() as u64, per_cycle);
    let (mut events, mut worst) = (0, 0.0_f64);
    let mut contact = run.run().contact();
    while events < EVENTS {
        let segment = run.next().expect("it never ends");
        assert_eq!(segment.contact, contact);
        contact = run.run().contact();
        let event = segment.event.expect("an event ends each segment");
        events += 1;
        // An event must match the state of the contact before and after it.
        match event {
            Event::Stop => assert!(segment.contact != Contact::Stuck && contact == Contact::Stuck),
            Event::Slip => assert!(segment.contact == Contact::Stuck && contact != Contact::Stuck),
            Event::Reversal => assert_eq!(contact, segment.contact.reversed()),
        }
        let phase = run.run().phase();
        let nearest = phases.iter().map(|expected| {
            let apart = (phase - expected).abs();
            apart.min(std::f64::consts::TAU - apart)
        });
        worst = worst.max(nearest.fold(f64::MAX, f64::min));
    }
    println!("{events} events compared, none skipped, worst {worst:e}");
    // The number of cycles must correspond to exactly this number of events.
    assert_eq!(run.run().cycles() - from, EVENTS / per_cycle, "{text}");
    // The last event must be as accurate as the first event. If the velocity reaches zero with zero slope, the instant
    // of a stop is known only to half of the digits.
    assert!(worst < 1e-9, "{text}: {worst:e}");
}

#[test]
fn one_mass() {
    let block = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
        contact: block - wall, excitation: block }";
    run(block, 0.3, 0.4, 4);
    run(block, 0.1, 0.2, 8);
}

#[test]
fn two_masses_with_stiction() {
    let frame = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2 }";
    run(frame, 0.3, 0.4, 4);
}

//! A run in time does not depend on the lengths of its steps.

use core::fmt::Debug;
use frictiongen::kernel::Plain;
use frictiongen::kernel::simulation::{Contact, Event};
use frictiongen::study::simulation::SystemSimulation;
use frictiongen::{Given, OutOfDomain, System, friction_system};
use fuzzing::Random;

const BLOCK: &str = "struct Block {
    masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall, excitation: block }";

/// Scenes of each contact, damped and undamped, with μ = 1 and above, and points (r, β) between their limits.
const SCENES: [(&str, &[(f64, f64)]); 4] = [
    (BLOCK, &[(0.3, 0.4), (0.5, 0.6), (0.7, 0.3), (1.4, 0.3)]),
    (
        "struct Shaken { masses: { a: 1, b: 0.7 }, springs: { base - a: 1, a - b: 2 },
            contact: b - base, excitation: base, damping: modal[0.02, 0.05], stiction: 1.3 }",
        &[(0.4, 0.2), (0.6, 0.3), (1.1, 0.4)],
    ),
    (
        "struct Between { masses: { a: 1, b: 2, c: 0.5 },
            springs: { wall - a: 1, a - b: 0.8, b - c: 1.7, c - wall: 0.4 },
            contact: a - b, excitation: c, damping: rayleigh(0.02, 0.03) }",
        &[(0.4, 0.3), (0.9, 0.1), (1.6, 0.2)],
    ),
    (
        "struct Frame { masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190, lower - upper: 1323 }, contact: upper - wall,
            excitation: base, damping: modal[0.010, 0.012], stiction: 1.2 }",
        &[(0.3, 0.4), (0.5, 0.5), (0.9, 0.5)],
    ),
];

/// An event: its time, the event, the contact's state before it, and the displacements of the masses.
type Happened<S> = (f64, Event, Contact, Vec<S>);

/// Returns the events up to `until` in τ and the final displacements, in a run that advances by `step`.
fn events<S: Plain>(
    system: &System<S>,
    (r, beta): (f64, f64),
    until: f64,
    mut step: impl FnMut() -> f64,
) -> (Vec<Happened<S>>, Vec<S>) {
    let run = system.simulation(S::constant(r), S::constant(beta));
    let mut run = run.expect("in the domain");
    let place = |run: &SystemSimulation<'_, S>| {
        let masses = system.scene().masses.iter();
        let moment = |name: &str| run.mass(name).expect("a mass");
        masses
            .map(|mass| moment(&mass.name).displacement())
            .collect()
    };
    let (mut events, mut passed) = (Vec::new(), 0.0);
    while passed < until - 1e-9 {
        let mut left = step().min(until - passed);
        loop {
            let segment = run.advance(S::constant(left)).expect("a reach");
            let length = segment.length.to_f64();
            (passed, left) = (passed + length, (left - length).max(0.0));
            let Some(event) = segment.event else { break };
            events.push((passed, event, segment.contact, place(&run)));
        }
    }
    let ends = place(&run);
    (events, ends)
}

/// Returns steps of 0.01, with a step of 0 after every seventh.
fn trial() -> impl FnMut() -> f64 {
    let mut count = 0;
    move || {
        count += 1;
        if count % 8 == 0 { 0.0 } else { 0.01 }
    }
}

/// Returns steps of any size, from far below rounding to more than a cycle.
fn any(seed: u64) -> impl FnMut() -> f64 {
    let mut random = Random(seed);
    move || match (4.0 * random.unit()) as u8 {
        0 => 0.0,
        1 => 10_f64.powf(-18.0 + 16.0 * random.unit()),
        2 => 0.1 * random.unit(),
        _ => 8.0 * random.unit(),
    }
}

fn differences<S: Plain + Debug>(most: f64) {
    let (mut compared, mut places) = (0, 0);
    for (text, points) in SCENES {
        let system: System<S> = text.parse().expect("a sound scene");
        for &(r, beta) in points {
            let until = 80.0;
            let (expected, ends) = events(&system, (r, beta), until, || until);
            assert!(
                expected.len() > 10,
                "{text}, {r}, {beta}: {}",
                expected.len()
            );
            for seed in 0..6 {
                let (found, found_ends) = match seed {
                    0 => events(&system, (r, beta), until, trial()),
                    _ => events(&system, (r, beta), until, any(seed)),
                };
                assert_eq!(found.len(), expected.len(), "{text}, {r}, {beta}, {seed}");
                for (found, expected) in found.iter().zip(&expected) {
                    assert_eq!((found.1, found.2), (expected.1, expected.2));
                    assert!(
                        (found.0 - expected.0).abs() < most,
                        "{found:?} {expected:?}"
                    );
                    for (found, expected) in found.3.iter().zip(&expected.3) {
                        let apart = (*found - *expected).to_f64().abs();
                        assert!(apart < most, "{text}, {r}, {beta}: {apart}");
                        places += 1;
                    }
                    compared += 1;
                }
                for (found, expected) in found_ends.iter().zip(&ends) {
                    assert!((*found - *expected).to_f64().abs() < most);
                    places += 1;
                }
            }
        }
    }
    println!("{compared} events and {places} displacements compared, none skipped");
    assert!(compared > 1000 && places > compared);
}

/// The events have the same times, and the masses the same positions. The runs differ in where a segment without events
/// is cut, and in the test's own sum of lengths. The tolerance of 1e-11 is thousands of roundings.
#[test]
fn steps_change_neither_events_nor_motion() {
    differences::<f64>(1e-11);
}

/// In single precision the test keeps its sum of steps in double precision, because the rounding of a sum near 80 would
/// be too large. Each length is rounded once, to 4e-7.
#[test]
fn nor_in_single_precision() {
    differences::<f32>(2e-4);
}

/// 20,000 steps of 0.01 with a step of 0 after every seventh give the motion and the number of events of one long step.
#[test]
fn a_step_of_nothing_does_nothing() {
    let system: System = BLOCK.parse().expect("a sound scene");
    let (expected, ends) = events(&system, (0.3, 0.4), 200.0, || 200.0);
    let (found, found_ends) = events(&system, (0.3, 0.4), 200.0, trial());
    println!("{} events, {} in steps", expected.len(), found.len());
    assert_eq!((expected.len(), found.len()), (128, 128));
    assert!((found_ends[0] - ends[0]).abs() < 1e-11);
    let mut run = system.simulation(0.3, 0.4).expect("in the domain");
    run.advance(1.234).expect("a reach");
    let before = format!("{run:?}");
    let nothing = run.advance(0.0).expect("a reach");
    assert_eq!((nothing.length, nothing.event), (0.0, None));
    assert_eq!(format!("{run:?}"), before);
}

friction_system! {
    struct Single {
        masses: { block: 1 },
        springs: { base - block: 1 },
        contact: block - wall,
        excitation: block,
        scalar: f32,
        provide: [simulation],
    }
}

#[test]
fn what_is_no_reach_changes_nothing() {
    let system: System = BLOCK.parse().expect("a sound scene");
    let mut run = system.simulation(0.3, 0.4).expect("in the domain");
    let mut emitted = Single::simulation(0.3, 0.4).expect("in the domain");
    let mut refused = 0;
    for step in [0.0, 0.5, 2.0, 7.0, 20.0] {
        run.advance(step).expect("a reach");
        emitted.advance(step as f32).expect("a reach");
        let before = (format!("{run:?}"), format!("{emitted:?}"));
        for reach in [
            -0.001,
            -0.0 - f64::MIN_POSITIVE,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
        ] {
            let error = run.advance(reach).expect_err("no reach");
            assert_eq!(error, OutOfDomain::Duration(Given::of(reach)));
            assert!(
                error.to_string().contains("finite number, not negative"),
                "{error}"
            );
            // The smallest f64 is 0 in single precision.
            if reach as f32 != 0.0 {
                emitted.advance(reach as f32).expect_err("no reach");
            }
            refused += 1;
        }
        assert_eq!(before, (format!("{run:?}"), format!("{emitted:?}")));
    }
    assert_eq!(refused, 25);
}

/// After 200,000 steps of 0.01, which are 318 cycles, the phase has not collected the rounding of the steps.
#[test]
fn the_phase_does_not_collect_the_rounding_of_steps() {
    let mut run = Single::simulation(0.3, 0.4).expect("in the domain");
    let (mut passed, mut events, mut worst) = (0.0_f64, 0, 0.0_f64);
    for _ in 0..200_000 {
        let mut left = 0.01_f32;
        loop {
            let segment = run.advance(left).expect("a reach");
            passed += f64::from(segment.length);
            left -= segment.length;
            if segment.event.is_none() {
                break;
            }
            events += 1;
        }
        let phase = run.cycles() as f64 * core::f64::consts::TAU + f64::from(run.phase());
        worst = worst.max((phase - passed).abs());
    }
    println!(
        "{} cycles, {events} events, phase within {worst:e} rad",
        run.cycles()
    );
    assert_eq!(run.cycles(), 318);
    // The phase has a rounding of 5e-7. Each event adds the rounding of the length up to it, below 1e-9.
    assert!(events > 1000 && worst < 4e-6, "{worst}");
}

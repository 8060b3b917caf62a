//! Tests of sampled loads, which are straight lines between samples, or jump.

use super::super::Motion;
use super::{Chain, Joint, Random, Wave, rigid};
use frictiongen_model::scene::Node::{Base, Mass, Wall};

/// Checks a free block under a rising force. The block starts to move when the force reaches the static friction force
/// μF. With μ = 1, its displacement then grows with the third power of time.
#[test]
fn block_under_a_rising_force() {
    for (stiction, side) in [(1.0, 1.0), (1.0, -1.0), (1.5, 1.0)] {
        let (mass, level, slope) = (2.0, 3.0, 4.0);
        let chain = Chain {
            masses: vec![mass],
            contacts: vec![rigid((Mass(0), Wall), level, stiction)],
            loads: vec![(0, Wave::line((0.0, 0.0), (1.0, side * slope)))],
            ..Chain::default()
        };
        let mut motion = Motion::from_rest(&chain).expect("a chain");
        let events = motion.run(5.0, &mut |_, _, _| {}).expect("a motion");
        let start = stiction * level / slope;
        assert_eq!(events.len(), 1);
        assert!((events[0].time - start).abs() < 1e-14, "{events:?}");
        let time = 5.0 - start;
        let jump = (stiction - 1.0) * level;
        let expected = side * (jump * time.powi(2) / 2.0 + slope * time.powi(3) / 6.0) / mass;
        let got = motion.state().x[0];
        assert!(
            (got - expected).abs() < 1e-13 * expected.abs(),
            "{got} {expected}"
        );
    }
}

/// Creates a chain of five storeys. Each storey has a friction damper in a brace, and each floor has a sampled force.
fn storeys() -> Chain {
    let node = |i: usize| if i == 0 { Base } else { Mass(i - 1) };
    let mut chain = Chain {
        masses: vec![2.0; 5],
        springs: (0..5).map(|i| (node(i), Mass(i), 3000.0)).collect(),
        contacts: (0..5)
            .map(|i| Joint {
                stiffness: Some(6000.0),
                speed: 0.0,
                ..rigid((Mass(i), node(i)), 9.0 - i as f64, 1.0)
            })
            .collect(),
        loads: (0..5).map(|i| (i, Wave::default())).collect(),
        ..Chain::default()
    };
    // In addition to the dampers, the fifth floor has a friction pad on the wall. The pad sticks most of the time.
    chain.contacts.push(rigid((Mass(4), Wall), 6.0, 1.3));
    chain.damp_modes(&[0.02; 5]).expect("ratios");
    chain
}

/// Applies the forces of a record to every floor. The motion advances in `parts` calls for each step of the record.
/// Returns the last state and the number of events.
fn run(chain: &Chain, record: &[f64], step: f64, parts: usize) -> (Motion, usize) {
    let mut motion = Motion::from_rest(chain).expect("a chain");
    let mut events = 0;
    for (index, pair) in record.windows(2).enumerate() {
        let (start, end) = (index as f64 * step, (index + 1) as f64 * step);
        for load in 0..5 {
            let line = Wave::line((start, pair[0]), (end, pair[1]));
            motion.set_load(load, line).expect("a load");
        }
        for part in 1..=parts {
            let until = start + step * part as f64 / parts as f64;
            events += motion
                .run(until, &mut |_, _, _| {})
                .expect("a motion")
                .len();
        }
    }
    (motion, events)
}

#[test]
fn parts_of_a_step_do_not_change_a_motion() {
    let mut random = Random::new(17);
    let record: Vec<f64> = (0..400).map(|_| random.between(-14.0, 14.0)).collect();
    let chain = storeys();
    let (whole, events) = run(&chain, &record, 0.02, 1);
    let (parts, same) = run(&chain, &record, 0.02, 3);
    println!("{events} events");
    assert!(events > 200, "{events}");
    assert_eq!(events, same);
    let size = whole.state().x.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (a, b) in whole.state().x.iter().zip(&parts.state().x) {
        assert!((a - b).abs() < 1e-11 * size, "{a} {b}");
    }
}

/// Checks a block under a load that jumps. After a jump above the static friction force, the block slides at once.
/// After a jump back to zero, the block does not stop at once.
#[test]
fn a_load_that_jumps() {
    let chain = Chain {
        masses: vec![2.0],
        contacts: vec![rigid((Mass(0), Wall), 3.0, 1.2)],
        loads: vec![(0, Wave::default())],
        ..Chain::default()
    };
    let mut motion = Motion::from_rest(&chain).expect("a chain");
    let mut events = motion.run(1.0, &mut |_, _, _| {}).expect("a motion");
    motion.set_load(0, Wave::constant(5.0)).expect("a load");
    events.extend(motion.run(2.0, &mut |_, _, _| {}).expect("a motion"));
    motion.set_load(0, Wave::default()).expect("a load");
    events.extend(motion.run(4.0, &mut |_, _, _| {}).expect("a motion"));
    let times: Vec<f64> = events.iter().map(|event| event.time).collect();
    // The block accelerates by (5 − 3)/2 m/s² for one second, and then by −3/2 m/s². It is at rest after another 2/3 s.
    assert_eq!(times.len(), 2, "{events:?}");
    assert!((times[0] - 1.0).abs() < 1e-15 && (times[1] - (2.0 + 2.0 / 3.0)).abs() < 1e-14);
    assert!((motion.state().x[0] - (0.5 + 1.0 / 3.0)).abs() < 1e-14);
}

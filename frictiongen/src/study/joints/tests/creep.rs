//! Tests that a sticking contact neither moves nor creeps.

use super::super::Motion;
use super::{Chain, Joint, Wave, rigid};
use frictiongen_model::scene::Node::{Mass, Wall};

/// Checks that the contacts in `stuck` neither move nor creep over a number of cycles, while other contacts slide.
fn creeps(chain: &Chain, stuck: &[usize], cycles: usize) {
    let mut motion = Motion::from_rest(chain).expect("a chain");
    let period = std::f64::consts::TAU / 31.0;
    let start: Vec<f64> = stuck.iter().map(|&j| motion.relative(j).1).collect();
    let mut slid = 0;
    for cycle in 1..=cycles {
        slid += motion
            .run(cycle as f64 * period, &mut |_, _, _| {})
            .expect("a motion")
            .len();
        for (&j, start) in stuck.iter().zip(&start) {
            let (speed, place) = motion.relative(j);
            assert_eq!((speed, place), (0.0, *start), "contact {j}, cycle {cycle}");
        }
    }
    assert!(slid > cycles / 4, "{slid}");
}

#[test]
fn contacts_that_stick_do_not_creep() {
    creep_under_constant_loads(300);
}

/// Repeats `contacts_that_stick_do_not_creep` with 20,000 cycles.
#[test]
#[ignore = "half a minute"]
fn contacts_that_stick_do_not_creep_long() {
    creep_under_constant_loads(20_000);
}

fn creep_under_constant_loads(cycles: usize) {
    for share in [0.2, 0.3, 0.95] {
        let held = |ends| rigid(ends, 30.0 / share, 1.0);
        let chain = Chain {
            masses: vec![1.0, 2.0, 1.5, 0.7],
            springs: vec![(Mass(1), Mass(2), 900.0)],
            contacts: vec![
                held((Mass(0), Wall)),
                rigid((Mass(1), Mass(0)), 2.0, 1.0),
                rigid((Mass(2), Wall), 0.5, 1.2),
                Joint {
                    stiffness: Some(700.0),
                    speed: 0.0,
                    ..rigid((Mass(3), Mass(2)), 0.4, 1.0)
                },
            ],
            // The force in the first contact is at most 30: 28 from the constant load and 2 from the sliding contact.
            loads: vec![
                (0, Wave::constant(28.0)),
                (1, Wave::harmonic(12.0, 31.0)),
                (3, Wave::harmonic(3.0, 31.0)),
            ],
            ..Chain::default()
        };
        creeps(&chain, &[0], cycles);
    }
}

/// Checks that masses with a sticking contact between them have the same velocity to the last bit.
#[test]
fn masses_that_stick_together_travel_together() {
    let chain = Chain {
        masses: vec![1.0, 2.0, 1.5],
        springs: vec![(Mass(1), Mass(2), 900.0)],
        contacts: vec![
            rigid((Mass(1), Mass(0)), 40.0, 1.0),
            rigid((Mass(2), Wall), 0.5, 1.2),
        ],
        loads: vec![(
            0,
            Wave {
                constant: 0.9,
                amplitude: 12.0,
                omega: 31.0,
                phase: 0.4,
                ..Wave::default()
            },
        )],
        ..Chain::default()
    };
    creeps(&chain, &[0], 300);
}

//! Compares motions with published results and with formulas.

use super::super::{JointError, Motion, Series, State};
use super::energy::gauss;
use super::{Chain, Joint, Wave, rigid};
use frictiongen_model::scene::Node::{self, Base, Mass, Wall};
use std::f64::consts::{PI, TAU};

/// Compares a motion with the example `CoupledClutches` of the Modelica Standard Library, which is a reference for
/// friction models.
#[test]
fn coupled_clutches() {
    let clutch = |index| Joint {
        ends: (Mass(index), Mass(index + 1)),
        level: Wave::default(),
        stiction: 1.1,
        stiffness: None,
        speed: 0.0,
    };
    // The torque is 10 sin 10πt.
    let torque = Wave {
        amplitude: 10.0,
        omega: 10.0 * PI,
        phase: -PI / 2.0,
        ..Wave::default()
    };
    let mut chain = Chain {
        masses: vec![1.0; 4],
        contacts: (0..3).map(clutch).collect(),
        loads: vec![(0, torque)],
        ..Chain::default()
    };
    chain.contacts[0].level = Wave::harmonic(10.0, 0.4 * PI);
    let mut motion = Motion::from(&chain, &[0.0; 4], &[10.0, 0.0, 0.0, 0.0]).expect("a chain");
    let mut events = Vec::new();
    for (until, clutch, level) in [
        (0.4, 1, 10.0),
        (0.9, 2, 10.0),
        (1.25, 0, 0.0),
        (1.5, 0, 0.0),
    ] {
        events.extend(motion.run(until, &mut |_, _, _| {}).expect("a motion"));
        motion
            .set_level(clutch, Wave::constant(level))
            .expect("a level");
    }
    let changes = events.iter().map(|event| {
        let changed = (0..3).find(|&j| event.before[j] != event.after[j]);
        let changed = changed.expect("a change");
        (changed + 1, event.after[changed] == 0, event.time)
    });
    let changes: Vec<_> = changes.collect();
    let expected = [
        (2, true, 0.709_621_474_693_7),
        (1, true, 0.791_662_359_154_8),
        (1, false, 0.831_108_506_137_6),
        (1, true, 0.906_850_192_797_9),
        (1, false, 1.000_295_859_894_6),
        (3, true, 1.143_967_492_473_1),
    ];
    println!("{changes:?} {:?}", motion.state().v);
    assert_eq!(changes.len(), expected.len(), "{changes:?}");
    // The published digits determine the instants to 5e-14.
    for (got, expected) in changes.iter().zip(expected) {
        assert_eq!((got.0, got.1), (expected.0, expected.1));
        assert!((got.2 - expected.2).abs() < 1e-12, "{got:?} {expected:?}");
    }
    let v = &motion.state().v;
    assert!((v[0] - 3.247_058_272_419).abs() < 1e-12, "{v:?}");
    // Only ten digits of the other velocities are published. The angular momentum below checks further digits.
    assert!((2.463_187_166..2.463_187_167).contains(&v[1]), "{v:?}");
    assert!(v[1] == v[2] && v[2] == v[3], "{v:?}");
    // The angular momentum must equal the integral of the torque plus the momentum at the start.
    let momentum: f64 = v.iter().sum();
    let torque = 10.0 + (1.0 - (15.0 * PI).cos()) / PI;
    assert!((momentum - torque).abs() < 1e-12, "{momentum} {torque}");
}

/// Compares a decaying oscillator with an example of the program Siconos. The amplitude falls by 2F/k in each half
/// period.
#[test]
fn oscillator_that_comes_to_rest() {
    let chain = Chain {
        masses: vec![1.0],
        springs: vec![(Mass(0), Wall, 1.0)],
        contacts: vec![rigid((Mass(0), Wall), 1.0, 1.0)],
        ..Chain::default()
    };
    let mut motion = Motion::from(&chain, &[12.0], &[6.0]).expect("a chain");
    motion.run(100.0, &mut |_, _, _| {}).expect("a motion");
    let expected = 15.0 - 205.0_f64.sqrt();
    let got = motion.state().x[0];
    assert!((got - expected).abs() < 1e-13, "{got} {expected}");
    assert_eq!(*motion.state().v, [0.0]);
}

/// Checks the hysteresis loop of an elastic contact whose displacement goes from −5 to 5 and back. The area of the loop
/// must be 4F(X − F/k), with the friction force F = 3, X = 5 and the stiffness k = 2.
#[test]
fn loop_of_an_elastic_contact() {
    // The mass is so heavy that it stays at rest. The base moves as 5 sin t.
    let chain = Chain {
        masses: vec![1e18],
        contacts: vec![Joint {
            ends: (Mass(0), Base),
            level: Wave::constant(3.0),
            stiction: 1.0,
            stiffness: Some(2.0),
            speed: 0.0,
        }],
        base: Wave {
            amplitude: 5.0,
            omega: 1.0,
            phase: -PI / 2.0,
            ..Wave::default()
        },
        ..Chain::default()
    };
    let mut motion = Motion::from_rest(&chain).expect("a chain");
    let angle = |displacement: f64| (displacement / 5.0).asin();
    // The displacements at these instants are 5, 3.5, 2, −5, −3.5, −2 and 5. The next cycle repeats them.
    let instants = [
        (PI / 2.0, 3.0),
        (PI - angle(3.5), 0.0),
        (PI - angle(2.0), -3.0),
        (1.5 * PI, -3.0),
        (TAU + angle(-3.5), 0.0),
        (TAU + angle(-2.0), 3.0),
        (2.5 * PI, 3.0),
        (4.5 * PI, 3.0),
    ];
    let mut work = Vec::new();
    for (instant, expected) in instants {
        let (mut force, mut area) = (0.0, 0.0);
        let watch = &mut |series: &Series, end: f64, _: &State| {
            force = -series.force(0, end);
            for (node, weight) in gauss() {
                let speed = series.base(end * node).1;
                area += weight * end * series.length * -series.force(0, end * node) * speed;
            }
        };
        motion.run(instant, watch).expect("a motion");
        work.push(area);
        assert!(
            (force - expected).abs() < 1e-13,
            "{instant}: {force} {expected}"
        );
    }
    let cycles = [work[1..7].iter().sum::<f64>(), work[7]];
    for cycle in cycles {
        assert!((cycle - 4.0 * 3.0 * (5.0 - 1.5)).abs() < 1e-12, "{cycle}");
    }
}

/// Checks a chain of two identical halves, with one contact in each half and a mass between the halves. The two
/// contacts must have their events at equal instants.
#[test]
fn symmetric_halves_share_their_events() {
    let chain = Chain {
        masses: vec![1.3, 2.0, 1.3],
        springs: vec![
            (Wall, Mass(0), 900.0),
            (Mass(0), Mass(1), 1500.0),
            (Mass(1), Mass(2), 1500.0),
            (Mass(2), Wall, 900.0),
        ],
        contacts: vec![
            rigid((Mass(0), Wall), 6.0, 1.2),
            rigid((Mass(2), Wall), 6.0, 1.2),
        ],
        loads: vec![(1, Wave::harmonic(30.0, 17.0))],
        ..Chain::default()
    };
    // This chain is one half of the symmetric chain. It has one half of the middle mass and of the load.
    let half = Chain {
        masses: vec![1.3, 1.0],
        springs: vec![(Wall, Mass(0), 900.0), (Mass(0), Mass(1), 1500.0)],
        contacts: vec![rigid((Mass(0), Wall), 6.0, 1.2)],
        loads: vec![(1, Wave::harmonic(15.0, 17.0))],
        ..Chain::default()
    };
    let run = |chain: &Chain| {
        let mut motion = Motion::from_rest(chain).expect("a chain");
        let events = motion
            .run(10.0 * TAU / 17.0, &mut |_, _, _| {})
            .expect("a motion");
        (events, motion)
    };
    let ((events, whole), (halves, half)) = (run(&chain), run(&half));
    assert!(halves.len() > 20, "{}", halves.len());
    assert_eq!(events.len(), halves.len());
    for (event, half) in events.iter().zip(&halves) {
        assert_eq!(event.after[0], event.after[1], "{event:?}");
        assert_eq!(event.after[0], half.after[0], "{event:?} {half:?}");
        assert!((event.time - half.time).abs() < 1e-11, "{event:?} {half:?}");
    }
    assert!((whole.state().x[0] - half.state().x[0]).abs() < 1e-12);
}

/// Checks a free block under a constant force. A force of 0.3 times the static friction force does not move it. A force
/// of 1.3 times the static friction force moves it in proportion to t².
#[test]
fn block_on_the_floor() {
    for (share, expected) in [(0.3, 0.0), (1.3, 0.3 * 4.0 / 2.0 / 2.0 * 9.0)] {
        let chain = Chain {
            masses: vec![2.0],
            contacts: vec![rigid((Mass(0), Wall), 4.0, 1.0)],
            loads: vec![(0, Wave::constant(share * 4.0))],
            ..Chain::default()
        };
        let mut motion = Motion::from_rest(&chain).expect("a chain");
        motion.run(3.0, &mut |_, _, _| {}).expect("a motion");
        let got = motion.state().x[0];
        assert!(
            (got - expected).abs() <= 1e-15 * expected,
            "{got} {expected}"
        );
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let chain = |contacts: Vec<Joint>| Chain {
        masses: vec![1.0, 2.0],
        springs: vec![(Base, Mass(0), 10.0), (Mass(0), Mass(1), 10.0)],
        contacts,
        ..Chain::default()
    };
    let elastic = |ends: (Node, Node)| Joint {
        stiffness: Some(1.0),
        speed: 0.0,
        ..rigid(ends, 1.0, 1.0)
    };
    let redundant = chain(vec![
        rigid((Mass(0), Wall), 1.0, 1.0),
        elastic((Mass(0), Wall)),
        rigid((Mass(1), Mass(0)), 1.0, 1.0),
        rigid((Mass(1), Base), 1.0, 1.0),
    ]);
    let error = redundant.model().expect_err("redundant");
    assert_eq!(error, JointError::Redundant(vec![0, 2, 3]));
    let mut with_stiffness = redundant.clone();
    with_stiffness.contacts[3].stiffness = Some(5.0);
    assert!(with_stiffness.model().is_ok());
    let cases = [
        (
            chain(vec![rigid((Mass(0), Mass(2)), 1.0, 1.0)]),
            JointError::Ends("a contact"),
        ),
        (
            chain(vec![rigid((Mass(0), Mass(0)), 1.0, 1.0)]),
            JointError::Ends("a contact"),
        ),
        (
            chain(vec![rigid((Base, Wall), 1.0, 1.0)]),
            JointError::Ends("a contact"),
        ),
        (
            chain(vec![rigid((Mass(0), Wall), 1.0, 0.9)]),
            JointError::Number("the stiction of a contact"),
        ),
        (
            chain(vec![rigid((Mass(0), Wall), -1.0, 1.0)]),
            JointError::Number("the level of a contact"),
        ),
        (chain(vec![elastic((Mass(0), Wall)); 17]), JointError::Size),
        (Chain::default(), JointError::Size),
    ];
    for (chain, error) in cases {
        assert_eq!(chain.model().map(|_| ()), Err(error));
    }
    let mut motion = Motion::from_rest(&chain(vec![elastic((Mass(0), Wall))])).expect("a chain");
    for level in [
        Wave::constant(-1.0),
        Wave::constant(f64::NAN),
        Wave::harmonic(1.0, 2.0),
    ] {
        let refused = motion.set_level(0, level);
        assert_eq!(refused, Err(JointError::Number("the level of a contact")));
    }
}

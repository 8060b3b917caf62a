//! Provokes every error that is returned in place of a steady state, in emitted scenes and at run time.

use frictiongen::{Given, NoOrbit, OutOfDomain, System};

/// Emits a scene. Asks the emitted scene, and the run-time system of its description, for a steady state. The scene and
/// the system must refuse it.
macro_rules! refused {
    ($test:ident, $error:expr, ($($points:tt)*), struct $name:ident { $($body:tt)* }) => {
        mod $test {
            frictiongen::friction_system! {
                pub struct $name { $($body)* provide: [limits, orbit], }
            }
        }

        #[test]
        fn $test() {
            let text = stringify!(struct $name { $($body)* provide: [limits, orbit], });
            let system: System = text.parse().expect("a scene");
            let mut asked = 0;
            for (r, beta) in [$($points)*] {
                let emitted = $test::$name::at(r).expect("in the domain");
                let emitted = emitted.orbit(beta).map(|orbit| orbit.stops());
                assert_eq!(emitted, Err($error), "emitted, r = {r}, β = {beta}");
                let at = system.at(r).expect("in the domain");
                let found = at.orbit(beta).map(|orbit| orbit.stops());
                assert_eq!(found, Err($error), "at run time, r = {r}, β = {beta}");
                let error: frictiongen::Error = $error.into();
                assert!(error.to_string().starts_with($crate::stick_slip::errors::first_words($error)));
                asked += 2;
            }
            println!("{asked} answers compared, none skipped");
        }
    };
}

/// Returns the first words of the message.
fn first_words(error: NoOrbit) -> &'static str {
    match error {
        NoOrbit::OutOfDomain(_) => "the friction ratio beta is",
        _ => "no steady state",
    }
}

refused!(
    no_number, NoOrbit::OutOfDomain(OutOfDomain::FrictionRatio(Given::NotANumber)), ((0.5, f64::NAN)),
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - wall, excitation: block,
    }
);
refused!(
    negative, NoOrbit::OutOfDomain(OutOfDomain::FrictionRatio(Given::Negative)), ((0.5, -1.0)),
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - wall, excitation: block,
    }
);
refused!(
    infinite, NoOrbit::OutOfDomain(OutOfDomain::FrictionRatio(Given::Infinite)), ((0.5, f64::INFINITY)),
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - wall, excitation: block,
    }
);
refused!(
    unbounded, NoOrbit::Unbounded, ((1.0, 0.5), (1.0, 0.785)),
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - wall, excitation: block,
    }
);
// At these r a cycle has more than 4096 segments.
refused!(
    too_many_events, NoOrbit::TooManyEvents, ((0.000_05, 0.5), (0.000_04, 0.3)),
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - wall, excitation: block,
    }
);

/// Checks motions with more than 64 segments in a cycle. An emitted solver has no memory for them. The expected
/// amplitude is that of an independent program.
#[test]
fn more_segments_than_emitted_code_records() {
    let text =
        "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall,
        excitation: block }";
    let system: System = text.parse().expect("a scene");
    let (r, beta) = (0.01, 0.3);
    let emitted = too_many_events::Block::at(r).expect("in the domain");
    let found = emitted.orbit(beta).map(|orbit| orbit.stops());
    assert_eq!(found, Err(NoOrbit::TooManyEvents));
    let at = system.at(r).expect("in the domain");
    let orbit = at.orbit(beta).expect("a steady state");
    assert_eq!((orbit.stops(), orbit.reversals()), (36, 0));
    assert!((orbit.contact().amplitude() - 0.700_246_09).abs() < 5e-9);
}
// The load of this scene drives a mode that the contact does not touch.
refused!(
    undamped, NoOrbit::Undamped(0), ((0.6, 0.1), (1.3, 0.2)),
    struct Pair {
        masses: { left: 1.0, right: 1.0 },
        springs: { base - left: 1.0, left - right: 1.0, right - wall: 1.0 },
        contact: left - right, excitation: left,
    }
);
refused!(
    unstable, NoOrbit::Unstable, ((1.0 / 3.0, 0.01395),),
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - base, excitation: base, stiction: 3.0,
    }
);
// This motion wanders for more than 16,000 cycles, and Newton's method finds no stable state on the way. No stuck state
// exists.
refused!(
    unsettled, NoOrbit::Unsettled, ((0.490_800_340_619_510_83, 0.238_257_509_569_926_28),),
    struct Pair {
        masses: { m1: 0.5357, m2: 0.6386 }, springs: { base - m1: 2.0350, m1 - m2: 0.6217 },
        contact: m1 - base, excitation: m1, damping: rayleigh(0.01832, 0.00143), stiction: 2.5003,
    }
);

/// Checks that emitted and run-time solvers refuse a state with NaN or infinity.
#[test]
fn a_state_out_of_domain() {
    let text = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
        contact: block - wall, excitation: block }";
    let system: System = text.parse().expect("a scene");
    let at = system.at(0.5).expect("in the domain");
    let wanted = Err(NoOrbit::OutOfDomain(OutOfDomain::State));
    for (x, v) in [(f64::NAN, 0.0), (0.0, f64::INFINITY)] {
        let found = at.orbit_from(0.3, (&[x], &[v])).map(|orbit| orbit.stops());
        assert_eq!(found, wanted);
        let emitted = negative::Block::at(0.5).expect("in the domain");
        let found = emitted
            .orbit_from(0.3, (&[x], &[v]))
            .map(|orbit| orbit.stops());
        assert_eq!(found, wanted);
    }
    let found = at
        .orbit_from(0.3, (&[0.0, 0.0], &[0.0]))
        .map(|orbit| orbit.stops());
    assert_eq!(found, wanted);
}

/// Checks a large free vibration beside which the friction is below rounding, so that the vibration seems steady. The
/// solver must not return it as the steady state.
#[test]
fn nothing_larger_than_the_motion() {
    let text = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
        contact: block - wall, excitation: block, stiction: 2 }";
    let system: System = text.parse().expect("a scene");
    let mut settled = 0;
    for beta in [0.000_025_1, 0.0001, 0.000_5, 0.002] {
        let found = system.at(0.2).expect("in the domain").orbit(beta);
        match found.map(|orbit| (orbit.contact().amplitude(), orbit.reversals())) {
            // The amplitude is 0.993884883 at β = 0.005, and 1 without friction.
            Ok((amplitude, reversals)) => {
                assert!(
                    (0.99..1.01).contains(&amplitude) && reversals == 6,
                    "β = {beta}: {amplitude}"
                );
                settled += 1;
            }
            Err(error) => assert_eq!(error, NoOrbit::Unsettled, "β = {beta}"),
        }
    }
    assert!(settled >= 2, "{settled}");
}

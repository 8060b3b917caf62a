//! Tests of emitted code within difficult user code: names, lints, editions, fragments.
//!
//! `names` has user items with the names of emitted items. `places` has scenes in different modules and with
//! different visibilities. `fragments` has scenes that macros produce, and `crates` has separate crates.
#![deny(warnings, unused, nonstandard_style, rust_2018_idioms)]
#![deny(
    unreachable_pub,
    unused_qualifications,
    unused_results,
    single_use_lifetimes
)]
#![deny(
    missing_debug_implementations,
    missing_copy_implementations,
    trivial_casts
)]
#![warn(clippy::pedantic, clippy::nursery)]
#![allow(
    clippy::redundant_pub_crate,
    reason = "it wants what `unreachable_pub` refuses"
)]

use frictiongen::friction_system;

friction_system! {
    /// The scene with which the tests compare all other scenes.
    pub(crate) struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
    }
}

/// Compares limits, a motion and a stuck response with those of [`Frame`].
macro_rules! same_as_frame {
    ($scene:path, $upper:ident) => {{
        let (expected, found) = (crate::Frame::at(0.9), <$scene>::at(0.9));
        let (expected, found) = (
            expected.expect("in the domain"),
            found.expect("in the domain"),
        );
        assert!(expected.continuous_limit().to_bits() == found.continuous_limit().to_bits());
        let stuck = expected.stuck().expect("damped").upper();
        assert!(stuck == found.stuck().expect("damped").$upper());
        let expected = expected.motion(0.3).expect("continuous").upper();
        let found = found.motion(0.3).expect("continuous").$upper();
        assert!(expected.amplitude().to_bits() == found.amplitude().to_bits());
        assert!(expected.phase().to_bits() == found.phase().to_bits());
        let (expected, found) = (crate::Frame::at(0.3), <$scene>::at(0.3));
        let expected = expected.expect("in the domain").orbit(0.4);
        let found = found.expect("in the domain").orbit(0.4);
        let (expected, found) = (expected.expect("steady"), found.expect("steady"));
        assert!(expected.stops() == 2 && found.stops() == 2);
        let (expected, found) = (expected.upper().amplitude(), found.$upper().amplitude());
        assert!(expected.to_bits() == found.to_bits());
        let mut expected = crate::Frame::simulation(0.3, 0.4).expect("in the domain");
        let mut found = <$scene>::simulation(0.3, 0.4).expect("in the domain");
        let ends = (expected.advance(9.0), found.advance(9.0));
        assert!(ends.0 == ends.1 && expected.upper() == found.$upper());
        let mut expected = crate::Frame::stepper(0.01).expect("a step");
        let mut found = <$scene>::stepper(0.01).expect("a step");
        let load = frictiongen::StepLoad {
            base: [0.1, 0.3],
            ..frictiongen::StepLoad::friction(2.0)
        };
        let one = frictiongen::Stepping::step(&mut expected, &load);
        assert!(one.is_ok() && one == frictiongen::Stepping::step(&mut found, &load));
        assert!(expected.upper() == found.$upper());
    }};
}

mod crates;
mod fragments;
mod names;
mod places;

//! Emitted code among user code that makes life hard for it: names, lints, editions, fragments.
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

#[path = "hygiene/crates.rs"]
mod crates;

use frictiongen::friction_system;

friction_system! {
    /// The scene that the others are compared with.
    pub(crate) struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        provide: [limits, motion, stuck, orbit, simulation, stepper],
    }
}

/// Compares limits, a motion and a stuck response with those of [`Frame`].
macro_rules! same_as_frame {
    ($scene:path, $upper:ident) => {{
        let (expected, found) = (Frame::at(0.9), <$scene>::at(0.9));
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
        let (expected, found) = (Frame::at(0.3), <$scene>::at(0.3));
        let expected = expected.expect("in the domain").orbit(0.4);
        let found = found.expect("in the domain").orbit(0.4);
        let (expected, found) = (expected.expect("steady"), found.expect("steady"));
        assert!(expected.stops() == 2 && found.stops() == 2);
        let (expected, found) = (expected.upper().amplitude(), found.$upper().amplitude());
        assert!(expected.to_bits() == found.to_bits());
        let mut expected = Frame::simulation(0.3, 0.4).expect("in the domain");
        let mut found = <$scene>::simulation(0.3, 0.4).expect("in the domain");
        let ends = (expected.advance(9.0), found.advance(9.0));
        assert!(ends.0 == ends.1 && expected.upper() == found.$upper());
        let mut expected = Frame::stepper(0.01).expect("a step");
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

mod facade {
    pub(crate) use ::frictiongen as renamed;
}

mod with_a_renamed_facade {
    crate::facade::renamed::friction_system! {
        /// The facade under another path.
        pub(super) struct Frame {
            crate: crate::facade::renamed,
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }
}

#[test]
fn the_facade_has_another_name() {
    same_as_frame!(with_a_renamed_facade::Frame, upper);
}

mod without_a_prelude {
    #![no_implicit_prelude]

    ::frictiongen::friction_system! {
        /// Nothing is in scope.
        pub(super) struct Frame {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }

    ::frictiongen::friction_system! {
        /// Emitted in passes.
        pub(super) struct Five {
            masses: { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0 },
            springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - d: 1.0, d - e: 1.0 },
            contact: e - wall,
            excitation: base,
            damping: modal(0.01),
            scalar: f32,
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }
}

#[test]
fn nothing_is_in_scope() {
    same_as_frame!(without_a_prelude::Frame, upper);
    let at = without_a_prelude::Five::at(0.5).expect("in the domain");
    assert!(at.continuous_limit() > 0.0);
    assert!(at.motion(0.01).expect("continuous").a().amplitude() > 0.0);
}

mod among_types_of_the_same_names {
    #![allow(dead_code, non_camel_case_types, reason = "they only stand in the way")]

    /// A type in the way.
    macro_rules! in_the_way {
        ($($name:ident)*) => { $(#[derive(Clone, Copy, Debug)] pub(super) struct $name {})* };
    }
    in_the_way! {
        Result Option Ok Err Some None Box Vec String Default Error Copied Into From
        Scalar Float Mode Modes ModeAt ModeResponse Kind Chain ContactAt Damped Undamped Decay
        Fundamental Friction ModalCoefficients Motion Wave Complex Regime NotContinuous OutOfDomain StuckResonance
        Orbit OrbitMotion NoOrbit Simulation Segment Moment Part Dynamics HeldMode
        Iterator IntoIterator Steady LimitsAt FrictionSystem Of f32 usize str bool u8
    }

    /// Modules in the way.
    pub(super) mod core {}
    pub(super) mod std {}
    pub(super) mod kernel {}
    pub(super) mod regime {}
    pub(super) mod steady {}
    pub(super) mod orbit {}
    pub(super) mod simulation {}
    pub(super) mod frictiongen {}

    ::frictiongen::friction_system! {
        /// Each name that it uses is taken.
        pub(super) struct Frame {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }
}

#[test]
fn types_have_the_names_that_emitted_code_uses() {
    same_as_frame!(among_types_of_the_same_names::Frame, upper);
}

mod among_macros_of_the_same_names {
    #![allow(unused_macros, reason = "they only stand in the way")]

    macro_rules! concat {
        () => {};
    }
    macro_rules! env {
        () => {};
    }
    macro_rules! include_bytes {
        () => {};
    }
    macro_rules! compile_error {
        () => {};
    }

    frictiongen::friction_system!("scenes/braced.friction");
}

#[test]
fn macros_have_the_names_that_emitted_code_uses() {
    let at = among_macros_of_the_same_names::BracedFile::at(0.9).expect("in the domain");
    assert!(at.sliding_limit() > 0.0);
}

mod with_masses_called_like_variables {
    frictiongen::friction_system! {
        /// In straight lines.
        pub(super) struct Frame {
            masses: { x: 3.27, r: 3.25 },
            springs: { base - x: 1190.0, x - r: 1323.0 },
            contact: r - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }

    frictiongen::friction_system! {
        /// In straight lines.
        pub(super) struct Four {
            masses: { mode_1: 1.0, inverse_r: 1.0, limit: 1.0, friction: 1.0 },
            springs: {
                base - mode_1: 1.0, mode_1 - inverse_r: 1.0, inverse_r - limit: 1.0, limit - friction: 1.0,
            },
            contact: mode_1 - limit,
            excitation: inverse_r,
            damping: modal(0.01),
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }

    frictiongen::friction_system! {
        /// In passes.
        pub(super) struct Many {
            masses: {
                u: 1.0, beta: 1.0, modes: 1.0, fundamental: 1.0, scale: 1.0, mode: 1.0, response: 1.0,
                responses: 1.0, sum: 1.0, others: 1.0, waves: 1.0, constraint: 1.0, index: 1.0,
                question: 1.0, of: 1.0, rs: 1.0, v: 1.0, g: 1.0, h: 1.0, ask: 1.0, map: 1.0, get: 1.0,
                stuck_mass: 1.0, masses: 1.0, springs: 1.0, modal: 1.0, limited: 1.0, name: 1.0,
            },
            springs: {
                base - u: 1.0, u - beta: 1.0, beta - modes: 1.0, modes - fundamental: 1.0,
                fundamental - scale: 1.0, scale - mode: 1.0, mode - response: 1.0,
                response - responses: 1.0, responses - sum: 1.0, sum - others: 1.0,
                others - waves: 1.0, waves - constraint: 1.0, constraint - index: 1.0,
                index - question: 1.0, question - of: 1.0, of - rs: 1.0, rs - v: 1.0, v - g: 1.0,
                g - h: 1.0, h - ask: 1.0, ask - map: 1.0, map - get: 1.0, get - stuck_mass: 1.0,
                stuck_mass - masses: 1.0, masses - springs: 1.0, springs - modal: 1.0,
                modal - limited: 1.0, limited - name: 1.0,
            },
            contact: name - wall,
            excitation: u,
            damping: modal(0.01),
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }
}

#[test]
fn masses_have_the_names_of_variables() {
    use with_masses_called_like_variables::{Four, Frame as Renamed, Many};
    same_as_frame!(Renamed, r);
    let at = Four::at(0.7).expect("in the domain");
    assert!(at.motion(1e-3).expect("continuous").friction().amplitude() > 0.0);
    let at = Many::at(0.1).expect("in the domain");
    assert!(at.motion(1e-9).expect("continuous").modes().amplitude() > 0.0);
    assert!(at.stuck().expect("damped").beta().re.is_finite());
    assert!(at.orbit(1e-9).expect("steady").map().amplitude() > 0.0);
    let run = Many::simulation(0.1, 1e-9).expect("in the domain");
    assert!(run.map().displacement() == 0.0);
}

/// Nothing but the limits is used: no method is dead code.
mod hardly_used {
    frictiongen::friction_system! {
        struct Private {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }

    pub(super) fn limit() -> Option<f64> {
        Private::at(0.9).ok().map(|at| at.sliding_limit())
    }
}

/// Not used at all.
mod unused {
    frictiongen::friction_system! {
        struct Unused {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
        }
    }
}

#[test]
fn what_is_not_used_is_no_warning() {
    assert!(hardly_used::limit().expect("in the domain") > 0.0);
}

/// Several scenes in one module, with the same masses, and in a function.
#[test]
fn scenes_side_by_side_and_inside_functions() {
    friction_system! {
        struct Outer {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper],
        }
    }
    friction_system! {
        struct Other {
            masses: { lower: 1.0, upper: 1.0 },
            springs: { base - lower: 1.0, lower - upper: 1.0 },
            contact: lower - wall,
            excitation: upper,
        }
    }
    fn deeper() -> f64 {
        friction_system! {
            struct Outer {
                masses: { lower: 1.0 },
                springs: { base - lower: 1.0 },
                contact: lower - wall,
                excitation: lower,
            }
        }
        Outer::at(1.0).map_or(f64::NAN, |at| at.continuous_limit())
    }
    same_as_frame!(Outer, upper);
    let other = Other::at(0.3).expect("in the domain");
    assert!(other.continuous_limit() > 0.0);
    assert!((deeper() - core::f64::consts::FRAC_PI_4).abs() < 1e-15);
}

mod seen_from {
    pub(super) mod inside {
        frictiongen::friction_system! {
            pub(in crate::seen_from) struct Frame {
                masses: { lower: 3.27, upper: 3.25 },
                springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                contact: upper - wall,
                excitation: base,
                damping: modal[0.010, 0.012],
                provide: [limits, motion, stuck, orbit, simulation, stepper],
            }
        }
    }

    pub(super) fn check() {
        use super::Frame;
        same_as_frame!(inside::Frame, upper);
        let at: inside::FrameAt = inside::Frame::at(0.9).expect("in the domain");
        let motion: inside::FrameMotion = at.motion(0.3).expect("continuous");
        let stuck: inside::FrameStuck = at.stuck().expect("damped");
        let orbit: inside::FrameOrbit = at.orbit(0.3).expect("steady");
        let run: inside::FrameSimulation =
            inside::Frame::simulation(0.9, 0.3).expect("in the domain");
        let _ = (motion, stuck, orbit, run);
    }
}

#[test]
fn visibility_holds_for_every_type() {
    seen_from::check();
}

/// A scene made of the fragments of a macro.
macro_rules! scene {
    ($visibility:vis $name:ident { $lower:ident: $mass:expr, $upper:ident: $number:literal } $spring:tt $facade:path) => {
        friction_system! {
            /// Made of fragments.
            $visibility struct $name {
                crate: $facade,
                masses: { $lower: $mass, $upper: $number },
                springs: { base - $lower: 2 * $spring, $lower - $upper: 1323.0 },
                contact: $upper - wall,
                excitation: base,
                damping: modal[0.010, 0.012],
                provide: [limits, motion, stuck, orbit, simulation, stepper],
            }
        }
    };
}

/// A scene with everything but its name from within a macro.
macro_rules! frame {
    ($name:ident) => {
        friction_system! {
            struct $name {
                masses: { lower: 3.27, upper: 3.25 },
                springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                contact: upper - wall,
                excitation: base,
                damping: modal[0.010, 0.012],
                provide: [limits, motion, stuck, orbit, simulation, stepper],
            }
        }
    };
}

/// A whole description handed on.
macro_rules! handed_on {
    ($($tokens:tt)*) => { friction_system! { $($tokens)* } };
}

scene! { pub(crate) Fragments { below: 3.0 + 0.27, above: 3.25 } (500.0 + 95.0) ::frictiongen }
frame! { Named }
handed_on! {
    struct HandedOn {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        provide: [limits, motion, stuck, orbit, simulation, stepper],
    }
}

#[test]
fn scenes_come_out_of_macros() {
    same_as_frame!(Fragments, above);
    same_as_frame!(Named, upper);
    same_as_frame!(HandedOn, upper);
}

/// What the user wrote before `struct` stands before the type.
#[test]
fn documentation_and_lint_levels_are_carried_through() {
    use frictiongen_codegen::{Limits, parse_text, pretty};
    let text = "/// Two storeys.\n#[allow(dead_code)]\npub(super) struct Frame {
        masses: { lower: 1 }, springs: { base - lower: 1 }, contact: lower - wall, excitation: base }";
    let description = parse_text(text, &Limits::MACRO).expect("a valid scene");
    let source = pretty(&description).expect("Rust");
    let head = source.split("struct Frame;").next().expect("a head");
    assert!(
        head.starts_with("/// Two storeys.\n#[allow(dead_code)]\n"),
        "{head}"
    );
    for name in ["Frame;", "FrameAt(", "FrameMotion("] {
        assert!(
            source.contains(&format!("\npub(super) struct {name}")),
            "{name}"
        );
    }
}

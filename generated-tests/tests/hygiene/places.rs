//! Tests scenes in unusual positions: hardly used, several in one module, in functions, and with restricted
//! visibility. One test has items before `struct`.

use frictiongen::friction_system;

/// A scene of which only the limits are used. None of its methods may be reported as dead code.
mod hardly_used {
    frictiongen::friction_system! {
        struct Private {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
        }
    }

    pub(super) fn limit() -> Option<f64> {
        Private::at(0.9).ok().map(|at| at.sliding_limit())
    }
}

/// A scene that is not used at all.
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

/// Checks several scenes with the same masses in one module, and a scene in a function.
#[test]
fn scenes_side_by_side_and_inside_functions() {
    friction_system! {
        struct Outer {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
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
            pub(in crate::places::seen_from) struct Frame {
                masses: { lower: 3.27, upper: 3.25 },
                springs: { base - lower: 1190.0, lower - upper: 1323.0 },
                contact: upper - wall,
                excitation: base,
                damping: modal[0.010, 0.012],
                provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
            }
        }
    }

    pub(super) fn check() {
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

/// Checks that doc comments and attributes before `struct` become those of the emitted type.
#[test]
fn documentation_and_lint_levels_are_carried_through() {
    use frictiongen_codegen::{SizeLimits, parse_text, pretty};
    let text = "/// Two storeys.\n#[allow(dead_code)]\npub(super) struct Frame {
        masses: { lower: 1 }, springs: { base - lower: 1 }, contact: lower - wall, excitation: base }";
    let description = parse_text(text, &SizeLimits::MACRO).expect("a valid scene");
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

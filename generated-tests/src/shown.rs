//! Scenes that show each specialisation of the emitted code. Snapshots keep their source, and this crate compiles and
//! runs the same source.

/// Emits the scenes, and lists them with their texts.
macro_rules! shown {
    ($($(#[doc = $doc:literal])* struct $name:ident { $($body:tt)* })*) => {
        $(::frictiongen::friction_system! {
            $(#[doc = $doc])*
            pub struct $name { $($body)* }
        })*
        /// Name and text of every scene.
        pub const SCENES: &[(&str, &str)] = &[
            $((
                stringify!($name),
                concat!($("///", $doc, "\n",)* stringify!(pub struct $name { $($body)* })),
            )),*
        ];
    };
}

shown! {
    /// One mass on a spring, rubbing on a wall: no sums, no damping.
    struct SdofWall {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - wall,
        excitation: block,
    }

    /// One mass, rubbing on the base that moves it.
    struct SdofBase {
        masses: { block: 2.0 },
        springs: { base - block: 50.0 },
        contact: block - base,
        excitation: base,
    }

    /// One mass, damped: the exponentials appear.
    struct SdofDamped {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - wall,
        excitation: block,
        damping: modal(0.05),
    }

    /// One mass, over-critically damped: no oscillation is left.
    struct SdofOverdamped {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - wall,
        excitation: block,
        damping: modal(1.5),
    }

    /// Two masses, the contact on a wall.
    struct PairWall {
        masses: { lower: 1.0, upper: 1.0 },
        springs: { base - lower: 1.0, lower - upper: 1.0 },
        contact: upper - wall,
        excitation: lower,
    }

    /// Two masses, the contact on the moving base.
    struct PairBase {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: lower - base,
        excitation: base,
    }

    /// Two masses, rubbing on each other, with static friction above kinetic.
    struct PairMasses {
        masses: { inner: 1.0, outer: 0.5 },
        springs: { base - inner: 1.0, inner - outer: 0.5 },
        contact: inner - outer,
        excitation: inner,
        stiction: 1.2,
        provide: [limits, motion, stuck],
    }

    /// The thesis's three masses (figure 6.1).
    struct Thesis {
        masses: { first: 1.0, second: 1.0, third: 1.0 },
        springs: { base - first: 1.0, first - second: 1.0, second - third: 1.0 },
        contact: second - wall,
        excitation: first,
    }

    /// Five masses, damped: sums over modes are calls, the frequency stage is straight lines.
    struct Five {
        masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0 },
        springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0 },
        contact: m1 - wall,
        excitation: m1,
        damping: modal(0.01),
        provide: [limits, motion(m5), stuck],
    }

    /// Seventeen masses: passes over the modes instead of straight lines.
    struct Tall {
        masses: {
            m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1, m11: 1, m12: 1,
            m13: 1, m14: 1, m15: 1, m16: 1, m17: 1,
        },
        springs: {
            base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 - m7: 1,
            m7 - m8: 1, m8 - m9: 1, m9 - m10: 1, m10 - m11: 1, m11 - m12: 1, m12 - m13: 1,
            m13 - m14: 1, m14 - m15: 1, m15 - m16: 1, m16 - m17: 1,
        },
        contact: m2 - wall,
        excitation: m1,
        damping: modal(0.02),
        provide: [limits, motion(m3)],
    }

    /// Single precision.
    struct Single {
        masses: { lower: 1.0, upper: 1.0 },
        springs: { base - lower: 1.0, lower - upper: 1.0 },
        contact: upper - wall,
        excitation: lower,
        scalar: f32,
    }

    /// A spring graph with a wall spring, a second base spring and Rayleigh damping.
    struct Braced {
        masses: { left: 1.0, right: 0.4 },
        springs: { base - left: 1.0, left - right: 0.34, left - wall: 0.41, base - right: 0.25 },
        contact: right - wall,
        excitation: base,
        damping: rayleigh(0.0037, 0.17),
    }

    /// A symmetric chain whose second mode the load at its middle does not drive, and the contact
    /// there does not touch: the mode is gone from the emitted code.
    struct Symmetric {
        masses: { left: 1.0, middle: 1.0, right: 1.0 },
        springs: { base - left: 1.0, left - middle: 1.0, middle - right: 1.0, right - wall: 1.0 },
        contact: middle - wall,
        excitation: middle,
        provide: [limits, motion, stuck],
    }

    /// The two limits alone.
    struct LimitsOnly {
        masses: { lower: 1.0, upper: 1.0 },
        springs: { base - lower: 1.0, lower - upper: 1.0 },
        contact: upper - wall,
        excitation: lower,
        scalar: f32,
        provide: [limits],
    }

    /// The motion of one of three masses.
    struct OneMotion {
        masses: { m1: 1.0, m2: 2.0, m3: 0.7 },
        springs: { base - m1: 1.0, m1 - m2: 0.4, m2 - m3: 1.5 },
        contact: m2 - wall,
        excitation: base,
        damping: modal[0.01, 0.02, 0.03],
        stiction: 1.5,
        provide: [motion(m3)],
    }
    /// The motion in time and the steady state in any regime.
    struct Stopping {
        masses: { lower: 1.0, upper: 0.9 },
        springs: { base - lower: 1.0, lower - upper: 1.1 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        stiction: 1.2,
        provide: [orbit, simulation],
    }

    /// Two masses on a moving base, by steps of a millisecond: constant tables, and nothing at a frequency.
    struct Shaken {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        stiction: 1.2,
        provide: [stepper],
        step: 1e-3,
    }

    /// One mass under a force that is held over a step, in single precision.
    struct Pushed {
        masses: { block: 0.5 },
        springs: { base - block: 200.0 },
        contact: block - wall,
        excitation: block,
        scalar: f32,
        provide: [stepper],
        input: hold,
    }

    /// Two masses that rub on each other, both loaded, with friction that falls with the speed.
    struct Bowed {
        masses: { string: 0.1, bow: 0.4 },
        springs: { base - string: 400.0, string - wall: 100.0, bow - wall: 30.0 },
        contact: string - bow,
        excitation: bow,
        damping: modal(0.02),
        stiction: 1.2,
        friction: stribeck(0.05: 0.6, 0.5: 0.3),
        provide: [stepper],
        force: { string },
        step: 5e-4,
    }

    /// A block whose kinetic friction falls with the speed, from event to event.
    struct Rubbed {
        masses: { block: 2.0 },
        springs: { base - block: 800.0 },
        contact: block - wall,
        excitation: block,
        stiction: 1.2,
        friction: stribeck(0.02: 0.7, 0.1: 0.55),
        provide: [simulation],
    }

    /// Two masses with an elastic contact (Jenkins element): the stuck state, the steady state, the motion in time and a
    /// stepper.
    struct Sprung {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        stiffness: 5.0e3,
        excitation: base,
        damping: modal[0.010, 0.012],
        provide: [stuck, orbit, simulation, stepper],
        step: 1e-3,
    }
}

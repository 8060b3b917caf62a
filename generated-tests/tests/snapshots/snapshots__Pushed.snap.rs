/// One mass under a force that is held over a step, in single precision.
///
/// Emitted by frictiongen 0.1.0 from scene 41220f0eb63f241c.
/// Numbers in brackets are equations of L. Marino, *Dynamic analysis of mechanical systems with Coulomb friction*, Oxford 2021.
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::Eq,
    ::core::cmp::PartialEq,
    ::core::default::Default,
    ::core::hash::Hash
)]
pub struct Pushed;
/// The motion of [`Pushed`] by steps of one length, under any input; `advance` takes a step.
///
/// A step of dt, in s, has ⌈20.00·dt⌉ parts, at most 1024.
/// A part in which the contact certainly keeps sliding, or keeps sticking, is one product with tables.
/// Any other is followed from event to event, for at most 8 events and, where the friction law bends, 64 stretches;
/// what is left of a part after that passes without creating energy, and `exceeded` tells.
///
/// A part has at most 132 floating-point operations by the tables, about 7896 with one event, never
/// more than 1559192.  A Cortex-M4F takes up to 4 instructions for each, and 400 for a part.
#[allow(deprecated, non_camel_case_types)]
pub struct PushedStepper(
    ::frictiongen::kernel::stepper::FixedStepper<::core::primitive::f32, 1, 1, 0, 1>,
);
/// What acts on [`Pushed`] at an instant, in the scene's units.
#[allow(deprecated, non_camel_case_types, non_snake_case)]
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq,
    ::core::default::Default
)]
pub struct PushedInput {
    /// The force on mass `block`.
    pub force: ::core::primitive::f32,
    /// The kinetic friction force F, not negative; at rest the contact holds up to μF.
    pub friction: ::core::primitive::f32,
}
#[automatically_derived]
#[allow(
    deprecated,
    non_snake_case,
    non_camel_case_types,
    unused_imports,
    unused_qualifications,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    clippy::restriction
)]
const _: () = {
    use ::frictiongen::kernel::emitted::*;
    impl Pushed {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f32; 1] = [20.0];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f32; 1] = [1.0];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f32; 1]; 1] = [[1.0]];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f32> = Chain {
            damped: false,
            on_moving_base: None,
            inverse_mass: 1.0,
            stiction: 1.0,
        };
        /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f32) -> f32 {
            omega / 20.0
        }
        /// β = F/P of a kinetic friction force F; `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f32, load: f32) -> f32 {
            friction / load
        }
        /// φ of all modes, [mass][mode].
        const ALL_SHAPES: [[f32; 1]; 1] = transposed(&Self::MODE_SHAPES);
        /// The motion in time: all modes, those that the contact drives first, and the modes of the chain with its contact
        /// held.  Of a held mode `frequency` is √λ, `force` −(contact force)/y, and `inverse` the symmetric matrix
        /// [m₁₁, m₁₂, m₂₂] that takes the products of a motion with its two states to y and u.  `participations`: how far
        /// each free mode takes part in y and u of each held one; `shapes`: φ, mass after mass; `weights`: φᵀΓ, mode after
        /// mode.
        const DYNAMICS: Dynamics<'static, f32> = Dynamics {
            chain: Self::CHAIN,
            modes: &[
                Mode {
                    kind: Kind::Undamped,
                    in_contact: true,
                    resonance: 1.0,
                    zeta: 0.0,
                    q: 1.0,
                    q_defect: 0.0,
                    load: 1.0,
                    contact: 1.0,
                    residue: 1.0,
                    inverse_mass: 1.0,
                    static_residue: 1.0,
                },
            ],
            held: &[],
            participations: &[],
            shapes: Self::ALL_SHAPES.as_flattened(),
            weights: &[1.0],
            rubbing: Some(0),
        };
        /// What a stepper is told of the scene: `units`: k₁, √(k₁/m₁) in rad/s and the springs to the base over k₁;
        /// `forces`: the loaded masses; `law`: Stribeck's points, speed and kinetic friction over F.
        const STEP_SCENE: StepScene<'static, f32> = StepScene {
            dynamics: Self::DYNAMICS,
            units: Units {
                stiffness: 200.0,
                rate: 20.0,
                support: 1.0,
            },
            on_base: false,
            forces: &[0],
            input: Input::Hold,
            law: &[],
        };
        #[inline]
        fn step_tables(dt: f32) -> Result<FixedTables<f32, 1, 1, 0, 1>, OutOfDomain> {
            FixedTables::new(&Self::STEP_SCENE, dt)
        }
        /// The motion by steps of dt, in s, from rest under no load.
        ///
        /// # Errors
        /// `OutOfDomain` for a step that is not positive and finite, or too long.
        #[inline]
        pub fn stepper(dt: f32) -> Result<PushedStepper, OutOfDomain> {
            let tables = Self::step_tables(dt)?;
            Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), None)
                .map(From::from)
        }
        /// The same from a state: displacement and velocity of every mass.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        #[inline]
        pub fn stepper_from(
            dt: f32,
            state: (&[f32; 1], &[f32; 1]),
        ) -> Result<PushedStepper, OutOfDomain> {
            let tables = Self::step_tables(dt)?;
            let state = Some((&state.0[..], &state.1[..]));
            Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), state)
                .map(From::from)
        }
    }
    ::frictiongen::kernel::not_provided!(Pushed : limits, simulation);
    ::frictiongen::kernel::wraps!(PushedStepper, FixedStepper of f32, 1, 1, 0, 1);
    impl PushedStepper {
        /// Says what the input is before the first step; otherwise it is none.  The contact answers for it at once.
        ///
        /// # Errors
        /// `OutOfDomain` as of `advance`, and after the first step.
        pub fn begin(&mut self, input: PushedInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [0.0; 2],
                    forces: &[input.force],
                    friction: input.friction,
                })
        }
        /// Takes a step under an input that is held over it.
        /// [`PushedStepper`] says what it costs.
        ///
        /// # Errors
        /// `OutOfDomain` for what is NaN or infinite, for friction below zero, for numbers whose squares
        /// overflow, and before the work does: the stepper is then what it was.
        pub fn advance(
            &mut self,
            input: PushedInput,
        ) -> Result<Stepped<f32>, OutOfDomain> {
            self.0
                .advance(Sample {
                    base: [0.0; 2],
                    forces: &[input.force],
                    friction: input.friction,
                })
        }
        /// Displacement and velocity of mass `block` now.
        #[must_use]
        pub fn block(&self) -> MassNow<f32> {
            self.mass(0)
        }
    }
    impl ::core::ops::DerefMut for PushedStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    ::frictiongen::emitted_stepper!(Pushed, PushedStepper, f32, false, [0]);
};

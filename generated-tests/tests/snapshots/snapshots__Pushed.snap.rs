/// One mass under a force that is held over a step, in single precision.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene 41220f0eb63f241c.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Pushed
/// {
///     masses: { block: 0.5 }, springs: { base - block: 200.0 }, contact: block -
///     wall, excitation: block, scalar: f32, provide: [stepper], input: hold,
/// }
/// ```
///
/// The motion in the contact is the displacement of `block`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `stepper(dt)`, `stepper_from(dt, state)` and `stepper_from_image(image)` return [`PushedStepper`], the motion by steps under any [`PushedInput`], with `begin(input)`, `advance(input)`, `image()`, `contact()` and `block()`
///
/// Counts of operations do not include operations whose operands are all constants, because the compiler computes them.  An expression that stands several times counts once, and an `if` as a comparison and a choice.
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
/// Stepper: motion of [`Pushed`] in time, by steps of one length, under any input.  `advance` takes a step.
///
/// A step of dt, in s, has ⌈20.00·dt⌉ parts, at most 1024.  20.00 is the largest ω(1 + 2ζ) of a mode, in rad/s: in a part, the phase of the fastest mode advances by at most 1 rad.
/// A part in which the contact certainly keeps sliding, or keeps sticking, is a product of its state with tables.
/// In any other part the stepper searches the events, at most 8.
/// After these events, a contact at rest stays stuck to the end of the part, and in any other contact the friction force is constant there.  This force opposes the displacement of the contact in the part, so that it creates no energy.  `exceeded()` counts the step.
///
/// A part has at most 132 floating-point operations if all parts are such products, about 7896 with one event, never
/// more than 1559192.  `set_event_budget(n)` limits the events of a step to n, and `cost().most` is then the bound.  A Cortex-M4F takes up to 4 instructions for each operation, and 400 more for a part.
/// The numbers in its type: 1 coefficient of an input over a part, 1 mode, 0 modes with the contact stuck, 1 input.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct PushedStepper(
    ::frictiongen::kernel::stepper::FixedStepper<::core::primitive::f32, 1, 1, 0, 1>,
);
/// Loads on [`Pushed`] at an instant, in the units of the scene: the input of a step.
#[allow(
    deprecated,
    non_camel_case_types,
    non_snake_case,
    reason = "names and attributes are those of the description"
)]
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq,
    ::core::default::Default
)]
pub struct PushedInput {
    /// Force on mass `block`.
    pub force: ::core::primitive::f32,
    /// Kinetic friction force F, not negative.  A stuck contact holds up to μF.
    pub friction: ::core::primitive::f32,
}
/// With the feature `serde` of frictiongen, serde writes and reads these fields by name.
::frictiongen::kernel::written!(PushedInput, force, friction);
#[allow(
    deprecated,
    non_snake_case,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
#[allow(
    unused_doc_comments,
    clippy::doc_markdown,
    reason = "comments above statements explain them by formulas"
)]
#[allow(
    clippy::unreadable_literal,
    clippy::excessive_precision,
    clippy::approx_constant,
    clippy::similar_names,
    clippy::too_many_lines,
    reason = "numbers have all their digits, and formulas are written out"
)]
#[allow(
    clippy::suboptimal_flops,
    clippy::assign_op_pattern,
    clippy::suspicious_operation_groupings,
    reason = "operations and their order are those of the tested formulas"
)]
#[allow(
    clippy::wildcard_imports,
    clippy::inline_always,
    reason = "one import serves every scene, and the compiler folds constants after inlining"
)]
#[allow(
    clippy::expl_impl_clone_on_copy,
    reason = "`wraps!` implements both traits for types that stand outside this block"
)]
const _: () = {
    use ::frictiongen::kernel::emitted::*;
    impl Pushed {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0x4122_0f0e_b63f_241c;
        /// k₁, the stiffness of the spring `base - block`: N/m, if springs are in N/m.
        pub const K1: f32 = 200.0;
        /// m₁, the mass `block`: kg, if masses are in kg.
        pub const M1: f32 = 0.5;
        /// √(k₁/m₁), by which angular frequencies are divided: rad/s.
        const REFERENCE: f32 = 20.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f32; 1] = [3.1830988];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f32; 1] = [20.0];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f32; 1] = [1.0];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f32; 1]; 1] = [[1.0]];
        /// Constants of the chain.
        const CHAIN: Chain<f32> = Chain {
            /// true if a mode is damped
            damped: false,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 1.0,
            /// μ, static over kinetic friction
            stiction: 1.0,
        };
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f32) -> f32 {
            omega / Self::REFERENCE
        }
        /// Returns β = F/P of a kinetic friction force F.  `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f32, load: f32) -> f32 {
            friction / load
        }
        /// φ of all modes, [mass][mode].
        const ALL_SHAPES: [[f32; 1]; 1] = transposed(&Self::MODE_SHAPES);
        /// Constants of the motion in time.
        const DYNAMICS: Dynamics<'static, f32> = Dynamics {
            /// constants of the chain
            chain: Self::CHAIN,
            /// all modes, those that the contact drives first
            modes: &[
                Mode {
                    /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                    kind: Kind::Undamped,
                    /// true if the contact drives the mode: φᵀw is not 0
                    in_contact: true,
                    /// √λ, the frequency ratio r of the undamped resonance
                    resonance: 1.0,
                    /// ζ, the modal damping ratio
                    zeta: 0.0,
                    /// √|1 − ζ²|
                    q: 1.0,
                    /// 1 − q
                    q_defect: 0.0,
                    /// φᵀp, with p the load on each mass over P
                    load: 1.0,
                    /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                    contact: 1.0,
                    /// (φᵀp)(φᵀw)
                    residue: 1.0,
                    /// (φᵀw)², the term of m*
                    contact_squared: 1.0,
                    /// (φᵀp)(φᵀw)/λ
                    static_residue: 1.0,
                },
            ],
            /// modes of the chain with its contact stuck; the state of a mode is y and u = y′/Ω
            held: &[],
            /// displacement of a mode of the chain per unit of y and of u: for each mode of `held` in turn, one pair for each mode that the contact drives; the largest number of a held mode has the modulus 1
            participations: &[],
            /// φ, mass after mass
            shapes: Self::ALL_SHAPES.as_flattened(),
            /// φᵀΓ, mode after mode
            weights: &[1.0],
            /// index of the mass that rubs on a support
            rubbing: Some(0),
        };
        /// Constants of the stepper.
        const STEP_SCENE: StepScene<'static, f32> = StepScene {
            /// modes of the chain, and of the chain with its contact stuck
            dynamics: Self::DYNAMICS,
            /// factors to the units of the scene
            units: Units {
                /// k₁
                stiffness: Self::K1,
                /// √(k₁/m₁), rad/s
                rate: Self::REFERENCE,
                /// sum of the springs to the base, over k₁
                support: 1.0,
            },
            /// true if the base moves
            on_base: false,
            /// indices of the loaded masses
            forces: &[0],
            /// course of the inputs during a step: constant with `Hold`; with `Linear` forces are linear, and a base follows a cubic
            input: Input::Hold,
            /// points of a friction law over the speed: speed, kinetic friction over F; without points the kinetic friction is F
            law: &[],
        };
        /// Computes the tables for the step dt, s.
        #[inline]
        fn step_tables(dt: f32) -> Result<FixedTables<f32, 1, 1, 0, 1>, OutOfDomain> {
            FixedTables::new(&Self::STEP_SCENE, dt)
        }
        /// Creates a stepper with the step dt, s, for a chain at rest without load.
        ///
        /// # Errors
        /// `OutOfDomain` for a step that is not positive and finite, or too long.
        #[inline]
        pub fn stepper(dt: f32) -> Result<PushedStepper, OutOfDomain> {
            let tables = Self::step_tables(dt)?;
            Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), None)
                .map(From::from)
        }
        /// Creates a stepper that starts from a state: absolute displacements and velocities of all masses, in the order of the
        /// description.  The unit of time is the second.
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
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(Pushed : limits, simulation, self_check);
    /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(PushedStepper, FixedStepper of f32, 1, 1, 0, 1);
    impl PushedStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(&mut self, input: PushedInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [0.0; 2],
                    forces: &[input.force],
                    friction: input.friction,
                })
        }
        /// Takes a step, over which the input is constant.
        /// Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`PushedStepper`] gives the number of operations.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
        /// that `work()` returns would overflow.  The stepper then keeps its state.
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
        /// Absolute displacement and velocity of mass `block` now.
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
    /// The traits `Steps` and `Stepping`, and the functions `image` and `stepper_from_image`, which write and read the state
    /// as bytes.  `true` stands for a moving base.  The list contains the indices of the loaded masses.
    ::frictiongen::emitted_stepper!(Pushed, PushedStepper, f32, false, [0]);
};

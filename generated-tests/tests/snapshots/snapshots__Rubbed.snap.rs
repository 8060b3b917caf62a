/// A block whose kinetic friction falls with the speed, from event to event.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene 0c93a0f50ccc50b4.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Rubbed
/// {
///     masses: { block: 2.0 }, springs: { base - block: 800.0 }, contact: block -
///     wall, excitation: block, stiction: 1.2, friction:
///     stribeck(0.02: 0.7, 0.1: 0.55), provide: [simulation],
/// }
/// ```
///
/// The motion in the contact is the displacement of `block`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `simulation_under(r, beta, amplitude)` and `simulation_under_from(r, beta, amplitude, state)` return [`RubbedSimulation`], the motion in time from event to event, with `next()` and `block()`
///
/// Answers of the simulation are non-dimensional: displacements are over P/k₁, with P the amplitude of the force, and forces over P.  The time is τ = ωt.
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
pub struct Rubbed;
/// Exact motion of [`Rubbed`] in time, from event to event.  `next` returns its segments and never ends.
///
/// Worst case of `advance`: 4096 stretches of at most 128 steps, or of 4000 where the kinetic friction is constant; a step is a sum over at most 1 mode, those of the chain and of the stuck chain.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct RubbedSimulation(
    ::frictiongen::kernel::simulation::FixedLinesSimulation<::core::primitive::f64, 1>,
);
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
    impl Rubbed {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0x0c93_a0f5_0ccc_50b4;
        /// k₁, the stiffness of the spring `base - block`: N/m, if springs are in N/m.
        pub const K1: f64 = 800.0;
        /// m₁, the mass `block`: kg, if masses are in kg.
        pub const M1: f64 = 2.0;
        /// √(k₁/m₁), by which angular frequencies are divided: rad/s.
        const REFERENCE: f64 = 20.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 1] = [3.183098861837907];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 1] = [20.0];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 1] = [1.0];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 1]; 1] = [[1.0]];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
            /// true if a mode is damped
            damped: false,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 1.0,
            /// μ, static over kinetic friction
            stiction: 1.2,
        };
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega / Self::REFERENCE
        }
        /// Returns β = F/P of a kinetic friction force F.  `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// φ of all modes, [mass][mode].
        const ALL_SHAPES: [[f64; 1]; 1] = transposed(&Self::MODE_SHAPES);
        /// Constants of the motion in time.
        const DYNAMICS: Dynamics<'static, f64> = Dynamics {
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
        /// Points of the friction law: speed, and kinetic friction over F.
        const LAW: &'static [[f64; 2]] = &[[0.02, 0.7], [0.1, 0.55]];
        /// Relative velocity at dz̄/dτ = 1, for r = 1 and a load of amplitude 1.
        const SPEED: f64 = 0.025;
        /// Starts the exact motion in time from rest, at a maximum of the excitation.  `amplitude` is that of the load, in
        /// the units of the scene; β is the kinetic friction at vanishing speed.
        ///
        /// # Errors
        /// `OutOfDomain` unless r and the amplitude are positive and finite, and β finite and not negative; and for a
        /// friction law that is too steep under this load.
        pub fn simulation_under(
            r: f64,
            beta: f64,
            amplitude: f64,
        ) -> Result<RubbedSimulation, OutOfDomain> {
            Self::started(r, beta, amplitude, None)
        }
        /// Starts from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass, in the order of the description.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        pub fn simulation_under_from(
            r: f64,
            beta: f64,
            amplitude: f64,
            state: (&[f64; 1], &[f64; 1]),
        ) -> Result<RubbedSimulation, OutOfDomain> {
            Self::started(r, beta, amplitude, Some((&state.0[..], &state.1[..])))
        }
        fn started(
            r: f64,
            beta: f64,
            amplitude: f64,
            state: Option<(&[f64], &[f64])>,
        ) -> Result<RubbedSimulation, OutOfDomain> {
            let lines = Lines::under(Self::LAW, r, amplitude, Self::SPEED);
            let parts = [Part::empty(); 1];
            Simulation::along(Self::DYNAMICS, r, beta, lines, state, parts)
                .map(From::from)
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(Rubbed : limits, stepper, self_check);
    /// `Clone`, `Debug`, `From` and `Deref`: the simulation has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(RubbedSimulation, FixedLinesSimulation of f64, 1);
    impl RubbedSimulation {
        /// Displacement and velocity of mass `block` at the present instant.
        #[must_use]
        pub fn block(&self) -> Moment<f64> {
            self.mass(0)
        }
    }
    impl ::frictiongen::SimulatesUnder for Rubbed {
        type Scalar = f64;
        type Run<'a> = RubbedSimulation;
        fn simulation_under(
            &self,
            r: f64,
            beta: f64,
            amplitude: f64,
        ) -> Result<RubbedSimulation, OutOfDomain> {
            Self::simulation_under(r, beta, amplitude)
        }
    }
    impl ::core::ops::DerefMut for RubbedSimulation {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    impl<'a> IntoIterator for &'a mut RubbedSimulation {
        type Item = Segment<f64>;
        type IntoIter = &'a mut FixedLinesSimulation<f64, 1>;
        fn into_iter(self) -> Self::IntoIter {
            &mut self.0
        }
    }
};

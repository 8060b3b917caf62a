/// A block whose kinetic friction falls with the speed, from event to event.
///
/// Emitted by frictiongen 0.1.0 from scene 0c93a0f50ccc50b4.
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
pub struct Rubbed;
/// The exact motion of [`Rubbed`] in time, from event to event; `next` gives its segments.
#[allow(deprecated, non_camel_case_types)]
pub struct RubbedSimulation(
    ::frictiongen::kernel::simulation::FixedLinesSimulation<::core::primitive::f64, 1>,
);
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
    impl Rubbed {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 1] = [20.0];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 1] = [1.0];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 1]; 1] = [[1.0]];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f64> = Chain {
            damped: false,
            on_moving_base: None,
            inverse_mass: 1.0,
            stiction: 1.2,
        };
        /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega / 20.0
        }
        /// β = F/P of a kinetic friction force F; `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// φ of all modes, [mass][mode].
        const ALL_SHAPES: [[f64; 1]; 1] = transposed(&Self::MODE_SHAPES);
        /// The motion in time: all modes, those that the contact drives first, and the modes of the chain with its contact
        /// held.  Of a held mode `frequency` is √λ, `force` −(contact force)/y, and `inverse` the symmetric matrix
        /// [m₁₁, m₁₂, m₂₂] that takes the products of a motion with its two states to y and u.  `participations`: how far
        /// each free mode takes part in y and u of each held one; `shapes`: φ, mass after mass; `weights`: φᵀΓ, mode after
        /// mode.
        const DYNAMICS: Dynamics<'static, f64> = Dynamics {
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
        /// The points of the friction law: speed, and kinetic friction over F.
        const LAW: &'static [[f64; 2]] = &[[0.02, 0.7], [0.1, 0.55]];
        /// The velocity for which dz̄/dτ is 1, where r and the load's amplitude are.
        const SPEED: f64 = 0.025;
        /// The exact motion in time from rest, the excitation at its maximum, under a load of this amplitude in the
        /// scene's units; β is the kinetic friction at vanishing speed.
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
        /// The same from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass.
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
    ::frictiongen::kernel::not_provided!(Rubbed : limits, stepper);
    ::frictiongen::kernel::wraps!(RubbedSimulation, FixedLinesSimulation of f64, 1);
    impl RubbedSimulation {
        /// Displacement and velocity of mass `block` now.
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

//! Traits for the exact motion in time, from one event of the contact (stop, break-away or reversal) to the next.
//! Emitted solvers and the run-time `System` implement these traits.

use crate::{FrictionSystem, OutOfDomain};
use core::ops::DerefMut;
use frictiongen_kernel::Float;
use frictiongen_kernel::motion::{Contact, ContactChain, KineticLaw, Part};
use frictiongen_kernel::simulation::{Moment, Segment, Simulation};

/// A scene that provides its exact motion in time, in addition to the limits. The motion advances from one event of
/// the contact (stop, break-away or reversal) to the next.
///
/// ```
/// use frictiongen::{FrictionSystem, OutOfDomain, Run, Simulates, friction_system};
///
/// friction_system! {
///     struct Block {
///         masses: { block: 1.0 },
///         springs: { base - block: 1.0 },
///         contact: block - wall,
///         excitation: block,
///         provide: [simulation],
///     }
/// }
///
/// /// Returns the displacement of the first mass after a number of steps from rest, for any system.
/// fn after<F: Simulates<Scalar = f64>>(system: &F, steps: u32) -> Result<f64, OutOfDomain> {
///     let mut run = system.simulation(0.3, 0.4)?;
///     for _ in 0..steps {
///         let mut left = 0.01;
///         while left > 0.0 {
///             // An event ends a step early.
///             left -= run.advance(left)?.length;
///         }
///     }
///     Ok(run.moment(0).displacement())
/// }
///
/// assert!(after(&Block, 1000)?.abs() < 1.0);
/// # Ok::<(), OutOfDomain>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` gives no motion in time",
    label = "add `simulation` to the scene's `provide: [...]`"
)]
pub trait Simulates: FrictionSystem {
    /// Type of the simulation that [`simulation`](Self::simulation) returns.
    type Run<'a>: Run<Scalar = Self::Scalar>
    where
        Self: 'a;

    /// Starts the exact motion in time from rest, with the excitation at its maximum.
    ///
    /// # Errors
    /// [`OutOfDomain`] unless r is positive and finite, and β is finite and not negative.
    fn simulation(&self, r: Self::Scalar, beta: Self::Scalar)
    -> Result<Self::Run<'_>, OutOfDomain>;
}

/// A scene whose exact motion in time depends on the amplitude of the load. Emitted scenes with `friction: stribeck`
/// and all run-time systems implement the trait.
#[diagnostic::on_unimplemented(
    message = "`{Self}` gives no motion in time under a load of known amplitude",
    label = "add `simulation` to the scene's `provide: [...]`; without `friction: stribeck` it is `Simulates`"
)]
pub trait SimulatesUnder {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;
    /// Type of the simulation that [`simulation_under`](Self::simulation_under) returns.
    type Run<'a>: Run<Scalar = Self::Scalar>
    where
        Self: 'a;

    /// Starts the exact motion in time from rest, with the excitation at its maximum. `amplitude` is the amplitude of
    /// the load in the scene's units.
    ///
    /// # Errors
    /// [`OutOfDomain`] unless r and the amplitude are positive and finite, and β is finite and not negative.
    /// [`OutOfDomain`] also for a friction law that is too steep.
    fn simulation_under(
        &self,
        r: Self::Scalar,
        beta: Self::Scalar,
        amplitude: Self::Scalar,
    ) -> Result<Self::Run<'_>, OutOfDomain>;
}

/// An exact simulation in time, which advances from one event of the contact (stop, break-away or reversal) to the
/// next.
pub trait Run {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;

    /// Advances to the next event of the contact, but by at most `reach` (rad) in the phase τ = ωt. If `reach` is 0,
    /// the simulation does not advance.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a reach that is negative, infinite or NaN. The simulation then stays unchanged.
    fn advance(&mut self, reach: Self::Scalar) -> Result<Segment<Self::Scalar>, OutOfDomain>;
    /// Returns the number of excitation cycles that the simulation has completed.
    fn cycles(&self) -> u64;
    /// Returns the present phase τ = ωt of the excitation in its cycle, in rad, in [0, 2π).
    fn phase(&self) -> Self::Scalar;
    /// Returns the state of the contact just after the present instant: sticking, or sliding in a direction.
    fn contact(&self) -> Contact;
    /// Returns the present relative displacement z̄ of the contact, and its relative velocity dz̄/dτ.
    fn relative(&self) -> (Self::Scalar, Self::Scalar);
    /// Returns the present friction force in the contact, divided by the load amplitude P.
    fn friction(&self) -> Self::Scalar;
    /// Returns the present displacement x̄ and velocity dx̄/dτ of a mass. `mass` is the index in the scene description.
    /// For an invalid index, displacement and velocity are 0.
    fn moment(&self, mass: usize) -> Moment<Self::Scalar>;
}

/// Implements [`Run`] for the simulations of emitted scenes and of a `System`. The types of these simulations deref to
/// the kernel's simulation.
impl<'a, S, P, L, K, R> Run for R
where
    S: Float,
    P: AsRef<[Part<S>]> + AsMut<[Part<S>]> + 'a,
    L: KineticLaw<'a, S>,
    K: ContactChain<S> + 'a,
    R: DerefMut<Target = Simulation<'a, S, P, L, K>>,
{
    type Scalar = S;

    fn advance(&mut self, reach: S) -> Result<Segment<S>, OutOfDomain> {
        (**self).advance(reach)
    }
    fn cycles(&self) -> u64 {
        (**self).cycles()
    }
    fn phase(&self) -> S {
        (**self).phase()
    }
    fn contact(&self) -> Contact {
        (**self).contact()
    }
    fn relative(&self) -> (S, S) {
        (**self).relative()
    }
    fn friction(&self) -> S {
        (**self).friction()
    }
    fn moment(&self, mass: usize) -> Moment<S> {
        (**self).mass(mass)
    }
}

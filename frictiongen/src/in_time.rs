//! Steady states, of emitted solvers and of the run-time `System` alike.

use crate::targets::Settles;
use crate::{Complex, LimitsAt, NoOrbit, Of};
use core::ops::Deref;
use frictiongen_kernel::Float;
use frictiongen_kernel::orbit::{Orbit, OrbitMotion};
use frictiongen_kernel::simulation::Part;

/// A scene at one frequency ratio that also gives steady states in any regime.
///
/// ```
/// use frictiongen::{FrictionSystem, Of, OrbitAt, SteadyState, friction_system};
///
/// friction_system! {
///     struct Block {
///         masses: { block: 1.0 },
///         springs: { base - block: 1.0 },
///         contact: block - wall,
///         excitation: block,
///         provide: [orbit],
///     }
/// }
///
/// /// The amplitude of a mass with stops or without, of any system.
/// fn amplitude<F>(system: &F, r: f64, beta: f64, mass: usize) -> Option<f64>
/// where
///     F: FrictionSystem<Scalar = f64>,
///     for<'a> F::At<'a>: OrbitAt,
/// {
///     let at = system.at(r).ok()?;
///     let orbit = at.orbit(beta).ok()?;
///     orbit.ask(Of::Mass(mass), |motion| motion.amplitude())
/// }
///
/// assert!(amplitude(&Block, 0.3, 0.4, 0).is_some_and(|amplitude| amplitude > 0.8));
/// assert!(amplitude(&Block, 0.3, 0.4, 1).is_none());
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` gives no steady states",
    label = "add `orbit` to the scene's `provide: [...]`"
)]
pub trait OrbitAt: LimitsAt {
    /// The steady state at one friction ratio.
    type Orbit<'o>: SteadyState<Scalar = Self::Scalar>
    where
        Self: 'o;

    /// The steady state at β = F/P that is reached from rest.
    ///
    /// # Errors
    /// [`NoOrbit`] says why there is none.
    fn orbit(&self, beta: Self::Scalar) -> Result<Self::Orbit<'_>, NoOrbit>;

    /// The steady state as [`orbit`](Self::orbit) gives it.  Where the motion from rest does not settle, its last 64
    /// cycles stand in its place, and [`SteadyState::is_settled`] is false.
    ///
    /// # Errors
    /// [`NoOrbit`] if the motion is unbounded, if following it takes too many steps, or if β is negative or not finite.
    fn orbit_or_last_cycles(&self, beta: Self::Scalar) -> Result<Self::Orbit<'_>, NoOrbit>;
}

/// A steady state in any regime.
pub trait SteadyState {
    /// The scene's scalar.
    type Scalar: Float;

    /// After how many cycles of the excitation it repeats: 1, or up to 64 for a subharmonic state.
    fn period(&self) -> u32;
    /// Whether the motion repeats; otherwise this is what it does in its last 64 cycles.
    fn is_settled(&self) -> bool;
    /// How often the contact stops in a period.
    fn stops(&self) -> usize;
    /// How often the direction of sliding changes in a period without a stop.
    fn reversals(&self) -> usize;
    /// The part of the period for which the contact sticks.
    fn stuck_fraction(&self) -> Self::Scalar;
    /// Whether every motion repeats with the opposite sign after half a period.
    fn is_symmetric(&self) -> bool;
    /// Whether no small deviation grows.
    fn is_stable(&self) -> bool;
    /// Whether the state is a member of a continuum, or at its end.
    fn is_marginal(&self) -> bool;
    /// The Floquet multipliers.
    fn multipliers(&self) -> &[Complex<Self::Scalar>];
    /// Puts a question to the contact's or a mass's motion; `None` if there is no such mass.
    fn ask<T>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Periodic<Scalar = Self::Scalar>) -> T,
    ) -> Option<T>;
}

/// The queries of the kernel's steady state.  [`SteadyState`] is for whatever derefs to it, and the kernel's type could
/// come to do so itself: hence a trait of its own.
#[doc(hidden)]
pub trait Kept {
    type Scalar: Float;

    fn period(&self) -> u32;
    fn is_settled(&self) -> bool;
    fn stops(&self) -> usize;
    fn reversals(&self) -> usize;
    fn stuck_fraction(&self) -> Self::Scalar;
    fn is_symmetric(&self) -> bool;
    fn is_stable(&self) -> bool;
    fn is_marginal(&self) -> bool;
    fn multipliers(&self) -> &[Complex<Self::Scalar>];
    fn ask<T>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Periodic<Scalar = Self::Scalar>) -> T,
    ) -> Option<T>;
}

impl<S, P, V, C> Kept for Orbit<'_, S, P, V, C>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
{
    type Scalar = S;

    fn period(&self) -> u32 {
        Orbit::period(self)
    }
    fn is_settled(&self) -> bool {
        Orbit::is_settled(self)
    }
    fn stops(&self) -> usize {
        Orbit::stops(self)
    }
    fn reversals(&self) -> usize {
        Orbit::reversals(self)
    }
    fn stuck_fraction(&self) -> S {
        Orbit::stuck_fraction(self)
    }
    fn is_symmetric(&self) -> bool {
        Orbit::is_symmetric(self)
    }
    fn is_stable(&self) -> bool {
        Orbit::is_stable(self)
    }
    fn is_marginal(&self) -> bool {
        Orbit::is_marginal(self)
    }
    fn multipliers(&self) -> &[Complex<S>] {
        Orbit::multipliers(self)
    }
    fn ask<T>(&self, of: Of, question: impl FnOnce(&dyn Periodic<Scalar = S>) -> T) -> Option<T> {
        let motion = match of {
            Of::Contact => self.contact(),
            Of::Mass(index) => self.mass_at(index)?,
        };
        Some(question(&motion))
    }
}

/// Emitted steady states and those of a `System` hold the kernel's.
impl<O: Deref<Target: Kept>> SteadyState for O {
    type Scalar = <O::Target as Kept>::Scalar;

    fn period(&self) -> u32 {
        Kept::period(&**self)
    }
    fn is_settled(&self) -> bool {
        Kept::is_settled(&**self)
    }
    fn stops(&self) -> usize {
        Kept::stops(&**self)
    }
    fn reversals(&self) -> usize {
        Kept::reversals(&**self)
    }
    fn stuck_fraction(&self) -> Self::Scalar {
        Kept::stuck_fraction(&**self)
    }
    fn is_symmetric(&self) -> bool {
        Kept::is_symmetric(&**self)
    }
    fn is_stable(&self) -> bool {
        Kept::is_stable(&**self)
    }
    fn is_marginal(&self) -> bool {
        Kept::is_marginal(&**self)
    }
    fn multipliers(&self) -> &[Complex<Self::Scalar>] {
        Kept::multipliers(&**self)
    }
    fn ask<T>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Periodic<Scalar = Self::Scalar>) -> T,
    ) -> Option<T> {
        Kept::ask(&**self, of, question)
    }
}

impl<A: Deref<Target: Settles>> OrbitAt for A
where
    <A::Target as Settles>::Orbit: SteadyState<Scalar = Self::Scalar>,
{
    type Orbit<'o>
        = <A::Target as Settles>::Orbit
    where
        Self: 'o;

    fn orbit(&self, beta: Self::Scalar) -> Result<<A::Target as Settles>::Orbit, NoOrbit> {
        Settles::orbit(&**self, beta)
    }
    fn orbit_or_last_cycles(
        &self,
        beta: Self::Scalar,
    ) -> Result<<A::Target as Settles>::Orbit, NoOrbit> {
        Settles::orbit_or_last_cycles(&**self, beta)
    }
}

/// The motion of the contact or of a mass in a steady state.
pub trait Periodic {
    /// The scene's scalar.
    type Scalar: Float;

    /// The largest |x̄| of the period.
    fn amplitude(&self) -> Self::Scalar;
    /// Lag of its maximum behind the excitation's, rad, in (−π, π].
    fn phase(&self) -> Self::Scalar;
    /// x̄ at τ, from a maximum of the contact's relative motion.
    fn displacement(&self, tau: Self::Scalar) -> Self::Scalar;
    /// dx̄/dτ at τ, from a maximum of the contact's relative motion.
    fn velocity(&self, tau: Self::Scalar) -> Self::Scalar;
    /// X_n with x̄ = Re Σ X_n e^{inτ_e}, τ_e from a maximum of the excitation; X_0 is the mean.
    fn harmonic(&self, n: u32) -> Complex<Self::Scalar>;
    /// The component that turns k times in a period of the motion; every [`SteadyState::period`]-th is a harmonic.
    fn subharmonic(&self, k: u32) -> Complex<Self::Scalar>;
}

impl<S, P, V, C> Periodic for OrbitMotion<'_, '_, S, P, V, C>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
{
    type Scalar = S;

    fn amplitude(&self) -> S {
        OrbitMotion::amplitude(self)
    }
    fn phase(&self) -> S {
        OrbitMotion::phase(self)
    }
    fn displacement(&self, tau: S) -> S {
        OrbitMotion::displacement(self, tau)
    }
    fn velocity(&self, tau: S) -> S {
        OrbitMotion::velocity(self, tau)
    }
    fn harmonic(&self, n: u32) -> Complex<S> {
        OrbitMotion::harmonic(self, n)
    }
    fn subharmonic(&self, k: u32) -> Complex<S> {
        OrbitMotion::subharmonic(self, k)
    }
}

//! Traits for steady states in any regime. Emitted solvers and the run-time `System` implement these traits.

use crate::targets::Settles;
use crate::{Complex, LimitsAt, NoOrbit, Of};
use core::ops::Deref;
use frictiongen_kernel::Float;
use frictiongen_kernel::motion::{ContactChain, Part};
use frictiongen_kernel::orbit::{Orbit, OrbitMotion};

/// A scene at one frequency ratio that provides steady states in any regime (continuous, stick-slip or stuck), in
/// addition to the limits.
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
/// /// Returns the amplitude of a mass in the steady state of any system, with stops of the contact or without.
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
    /// Type of the steady state that [`orbit`](Self::orbit) returns.
    type Orbit<'o>: SteadyState<Scalar = Self::Scalar>
    where
        Self: 'o;

    /// Returns the steady state that the motion from rest reaches at the friction ratio β = F/P.
    ///
    /// # Errors
    /// [`NoOrbit`], with the reason why motion from rest reaches no steady state.
    fn orbit(&self, beta: Self::Scalar) -> Result<Self::Orbit<'_>, NoOrbit>;

    /// Returns the steady state of [`orbit`](Self::orbit). If the motion from rest does not settle, returns the last 64
    /// cycles of this motion, and [`SteadyState::is_settled`] is false.
    ///
    /// # Errors
    /// [`NoOrbit`] if the motion is unbounded, if the search takes too many steps, or if β is negative or not finite.
    fn orbit_or_last_cycles(&self, beta: Self::Scalar) -> Result<Self::Orbit<'_>, NoOrbit>;
}

/// A steady state of a scene at one frequency and one friction ratio, in any regime.
pub trait SteadyState {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;

    /// Returns the number of excitation cycles after which the motion repeats: 1, or up to 64 for a subharmonic state.
    fn period(&self) -> u32;
    /// Returns true if the motion repeats. If the result is false, this state contains the last 64 computed cycles.
    fn is_settled(&self) -> bool;
    /// Returns the number of stops of the contact in a period. At a stop the contact starts to stick.
    fn stops(&self) -> usize;
    /// Returns the number of times in a period that the sliding direction changes without a stop.
    fn reversals(&self) -> usize;
    /// Returns the fraction of the period during which the contact sticks.
    fn stuck_fraction(&self) -> Self::Scalar;
    /// Returns true if every motion repeats with the opposite sign after half a period.
    fn is_symmetric(&self) -> bool;
    /// Returns true if the steady state is stable: no small deviation from the motion grows.
    fn is_stable(&self) -> bool;
    /// Returns true if the steady state belongs to a continuum of steady states, or is the end of a continuum. In a
    /// continuum, each state lies arbitrarily close to others.
    fn is_marginal(&self) -> bool;
    /// Returns the Floquet multipliers: the complex factors by which small deviations from the motion change in a
    /// period.
    fn multipliers(&self) -> &[Complex<Self::Scalar>];
    /// Calls `question` with the motion of the contact or of a mass, and returns the result of `question`. Returns
    /// `None` if the scene does not have the mass.
    fn ask<T>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Periodic<Scalar = Self::Scalar>) -> T,
    ) -> Option<T>;
}

/// Methods of a steady state in the kernel. [`SteadyState`] is implemented for every type that derefs to a type with
/// `KernelSteady`. Without this separate trait, a later `Deref` of the kernel's type would cause two conflicting
/// implementations of [`SteadyState`].
#[doc(hidden)]
pub trait KernelSteady {
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

impl<S, P, V, C, K> KernelSteady for Orbit<'_, S, P, V, C, K>
where
    K: ContactChain<S>,
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
            _ => return None,
        };
        Some(question(&motion))
    }
}

/// Implements [`SteadyState`] for the steady states of emitted scenes and of a `System`. The types of these states
/// deref to the kernel's steady state.
impl<O: Deref<Target: KernelSteady>> SteadyState for O {
    type Scalar = <O::Target as KernelSteady>::Scalar;

    fn period(&self) -> u32 {
        KernelSteady::period(&**self)
    }
    fn is_settled(&self) -> bool {
        KernelSteady::is_settled(&**self)
    }
    fn stops(&self) -> usize {
        KernelSteady::stops(&**self)
    }
    fn reversals(&self) -> usize {
        KernelSteady::reversals(&**self)
    }
    fn stuck_fraction(&self) -> Self::Scalar {
        KernelSteady::stuck_fraction(&**self)
    }
    fn is_symmetric(&self) -> bool {
        KernelSteady::is_symmetric(&**self)
    }
    fn is_stable(&self) -> bool {
        KernelSteady::is_stable(&**self)
    }
    fn is_marginal(&self) -> bool {
        KernelSteady::is_marginal(&**self)
    }
    fn multipliers(&self) -> &[Complex<Self::Scalar>] {
        KernelSteady::multipliers(&**self)
    }
    fn ask<T>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Periodic<Scalar = Self::Scalar>) -> T,
    ) -> Option<T> {
        KernelSteady::ask(&**self, of, question)
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

/// Motion of the contact or of a mass in a steady state. Displacements are non-dimensional: x̄ = x/(P/k₁), or x/Y for
/// base motion.
pub trait Periodic {
    /// Number type of the scene, such as `f64` or `f32`.
    type Scalar: Float;

    /// Returns the largest |x̄| in the period of the motion.
    fn amplitude(&self) -> Self::Scalar;
    /// Returns the lag of the maximum of x̄ behind the maximum of the excitation, in rad, in (−π, π].
    fn phase(&self) -> Self::Scalar;
    /// Returns the displacement x̄ at the phase τ in rad. At τ = 0 the contact's relative motion has a maximum.
    fn displacement(&self, tau: Self::Scalar) -> Self::Scalar;
    /// Returns the velocity dx̄/dτ at the phase τ in rad. At τ = 0 the contact's relative motion has a maximum.
    fn velocity(&self, tau: Self::Scalar) -> Self::Scalar;
    /// Returns X_n, the complex amplitude of harmonic n in x̄ = Re Σ X_n e^{inτ_e}. The phase τ_e is 0 at a maximum of
    /// the excitation. X_0 is the mean.
    fn harmonic(&self, n: u32) -> Complex<Self::Scalar>;
    /// Returns the complex amplitude of the component with k cycles in a period of the motion. If the period has N
    /// cycles of the excitation, component k = nN is harmonic n.
    fn subharmonic(&self, k: u32) -> Complex<Self::Scalar>;
}

impl<S, P, V, C, K> Periodic for OrbitMotion<'_, '_, S, P, V, C, K>
where
    K: ContactChain<S>,
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

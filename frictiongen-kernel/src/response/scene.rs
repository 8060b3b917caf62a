//! Interface that a scene implements for its steady response.

use super::numbers::Numbers;
use crate::contact::regime::{self, Limits};
use crate::contact::sums::{ContactAt, ModeAt};
use crate::modal_sum::wave::Wave;
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

/// A scene, with its constants and the formulas that may be specialised for it.
///
/// The default bodies are valid for every chain. A generator writes its own where constants save work. The results have
/// the same bits.
pub trait Scene: Clone {
    /// Number type: `f64`, `f32`, or a wider scalar.
    type Scalar: Float;
    /// Kind of decay of the modes. A scene without damping evaluates no exponentials.
    type Decay: Decay<Self::Scalar>;
    /// Storage for each mode's functions at one frequency.
    type Modes: AsRef<[ModeAt<Self::Scalar>]> + Clone + core::fmt::Debug;
    /// Storage for the [`Wave`] of each mode, its term in a sum over the modes.
    type Waves: AsRef<[Wave<Self::Scalar, Self::Decay>]>
        + AsMut<[Wave<Self::Scalar, Self::Decay>]>
        + Clone;

    /// Returns the constants of the scene.
    fn numbers(&self) -> Numbers<'_, Self::Scalar>;

    /// Returns the components of a mass in the mode shapes. Returns `None` if the scene has no such mass, or provides
    /// nothing for it.
    fn shape(&self, mass: usize) -> Option<&[Self::Scalar]>;

    /// Returns true if the scene provides the motion of a mass, as long as `shape` has the mass.
    #[inline]
    fn moves(&self, mass: usize) -> bool {
        let _ = mass;
        true
    }

    /// Returns the smallest and the largest 1/r at which the formulas are evaluated.
    #[inline]
    fn inverse_ratio_range(&self) -> (Self::Scalar, Self::Scalar) {
        let modes = self.numbers().modes.iter();
        regime::inverse_ratio_range(modes.map(|mode| mode.resonance))
    }

    /// Returns the sums over all modes at 1/r, and each mode's functions.
    fn frequency_stage(&self, inverse_r: Self::Scalar) -> (ContactAt<Self::Scalar>, Self::Modes);

    /// Returns the same sums as [`frequency_stage`](Self::frequency_stage) without the modes and without G, which the
    /// limits do not need.
    #[inline]
    fn contact_without_g(&self, inverse_r: Self::Scalar) -> ContactAt<Self::Scalar> {
        self.frequency_stage(inverse_r).0
    }

    /// Returns one [`Wave`] for each mode, with all coefficients 0, as working space for the searches. A wave is the
    /// term of one mode in a sum over the modes.
    fn idle(&self) -> Self::Waves;

    /// Copies the modes' functions, so that a motion can own them. A generator writes a plain copy. Optimised for size,
    /// the compiler turns `clone` into a loop over the modes, which costs time in a stuck response.
    #[inline]
    fn kept(modes: &Self::Modes) -> Self::Modes {
        modes.clone()
    }

    /// Runs a search with one [`Wave`] for each mode as working space. All coefficients of the waves are 0 at the
    /// start. The call drops the waves afterwards.
    #[inline]
    fn with_idle<R>(&self, search: impl FnOnce(&mut [Wave<Self::Scalar, Self::Decay>]) -> R) -> R {
        search(self.idle().as_mut())
    }

    /// Returns r²E(H_c + μm*/r²), the contact force needed for break-away at a reversal (5.63, 7.47).
    #[inline]
    fn break_away(&self, contact: &ContactAt<Self::Scalar>) -> Self::Scalar {
        self.numbers().chain.break_away(contact)
    }

    /// Returns β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²). The argument `constraint` is r²E times that maximum (5.65,
    /// 5.80, 5.96, 7.49).
    #[inline]
    fn continuous_limit(
        &self,
        contact: &ContactAt<Self::Scalar>,
        constraint: Self::Scalar,
    ) -> Self::Scalar {
        self.numbers().chain.continuous_limit(contact, constraint)
    }

    /// Returns β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
    #[inline]
    fn sliding_limit(&self, contact: &ContactAt<Self::Scalar>) -> Self::Scalar {
        self.numbers().chain.sliding_limit(contact)
    }

    /// Returns β_lim without search and β*_lim at 1/r, for an r that is neither 0 nor infinite, and without regard to
    /// an absorber. It also returns the real part of H, multiplied by r² and by the scale E of [`ContactAt`]. The
    /// caller decides from this number whether masses may act as an absorber.
    #[inline]
    fn limits_without_search(
        &self,
        inverse_r: Self::Scalar,
    ) -> (Limits<Self::Scalar>, Self::Scalar) {
        limits_of_sums(self, inverse_r)
    }
}

/// Computes [`Scene::limits_without_search`] from the contact's sums.
#[inline(always)]
pub fn limits_of_sums<T: Scene>(scene: &T, inverse_r: T::Scalar) -> (Limits<T::Scalar>, T::Scalar) {
    let contact = scene.contact_without_g(inverse_r);
    let limits = Limits {
        continuous: scene.continuous_limit(&contact, scene.break_away(&contact)),
        sliding: scene.sliding_limit(&contact),
    };
    (limits, contact.h.re)
}

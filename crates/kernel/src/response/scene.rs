//! Trait of a scene. An implementation provides the constants from which this crate computes the steady response of the
//! scene.

use super::numbers::Numbers;
use crate::contact::regime::{self, Limits};
use crate::contact::sums::{ContactAt, ModeAt};
use crate::modal_sum::wave::Wave;
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

/// Constants of a scene for its steady response, and formulas that the code generator may replace.
///
/// The default methods are valid for every chain. The code generator writes its own methods if the constants of the
/// scene save work. The default and the generated methods return results with the same bits.
pub trait Scene: Clone {
    /// Number type of the scene: `f64`, `f32` or another scalar.
    type Scalar: Float;
    /// Damping of the modes, as a type. A scene without damping evaluates no exponential functions.
    type Decay: Decay<Self::Scalar>;
    /// Storage for the response and damping functions of each mode at one frequency ratio.
    type Modes: AsRef<[ModeAt<Self::Scalar>]> + Clone + core::fmt::Debug;
    /// Storage for one [`Wave`] for each mode. A wave is the term of one mode in a sum over the modes.
    type Waves: AsRef<[Wave<Self::Scalar, Self::Decay>]>
        + AsMut<[Wave<Self::Scalar, Self::Decay>]>
        + Clone;

    /// Returns all constants on which the steady response of the scene depends.
    fn numbers(&self) -> Numbers<'_, Self::Scalar>;

    /// Returns the component of a mass in each mode shape. Returns `None` if the scene has no mass with this index, or
    /// does not provide the motion of this mass.
    fn shape(&self, mass: usize) -> Option<&[Self::Scalar]>;

    /// Returns the loads in quadrature (90° out of phase) with the motion of the base, in the form of
    /// [`Quadratures`](crate::contact::quadrature). If no damping acts on velocities relative to the moving base, the
    /// list is empty.
    #[inline]
    fn quadratures(&self) -> &[[Self::Scalar; 2]] {
        &[]
    }

    /// Returns the compliance ρ of an elastic contact, or `None` for a rigid contact. ρ is k₁ divided by the stiffness
    /// of the spring in series with the slider of the contact. The contact's receptance H contains ρ as a term.
    #[inline]
    fn compliance(&self) -> Option<Self::Scalar> {
        None
    }

    /// Returns true if the scene provides the motion of a mass. The result is valid only for a mass for which `shape`
    /// returns components.
    #[inline]
    fn moves(&self, mass: usize) -> bool {
        let _ = mass;
        true
    }

    /// Returns the smallest and the largest 1/r at which the code evaluates the formulas, where r is the frequency
    /// ratio. The code clamps every other 1/r to this range.
    #[inline]
    fn inverse_ratio_range(&self) -> (Self::Scalar, Self::Scalar) {
        let modes = self.numbers().modes.iter();
        regime::inverse_ratio_range(modes.map(|mode| mode.resonance))
    }

    /// Returns the contact's sums over all modes at 1/r, and the response and damping functions of each mode. r is the
    /// frequency ratio.
    fn frequency_stage(&self, inverse_r: Self::Scalar) -> (ContactAt<Self::Scalar>, Self::Modes);

    /// Returns the contact's sums of [`frequency_stage`](Self::frequency_stage), but not the functions of the modes
    /// and not the sum G. G is the displacement at a reversal that a square wave of friction of unit amplitude causes
    /// in the contact. The limits β_lim and β*_lim do not need G.
    #[inline]
    fn contact_without_g(&self, inverse_r: Self::Scalar) -> ContactAt<Self::Scalar> {
        self.frequency_stage(inverse_r).0
    }

    /// Returns working memory for a search: one [`Wave`] for each mode, with all coefficients 0. A wave is the term of
    /// one mode in a sum over the modes.
    fn idle(&self) -> Self::Waves;

    /// Copies the response and damping functions of the modes, so that a motion can own the copy. The code generator
    /// writes a plain copy of the array instead, because a compiler that optimises for size makes a slow loop from
    /// `clone`.
    #[inline]
    fn kept(modes: &Self::Modes) -> Self::Modes {
        modes.clone()
    }

    /// Calls `search` with one [`Wave`] for each mode as working memory. At the start all coefficients of the waves are
    /// 0.
    #[inline]
    fn with_idle<R>(&self, search: impl FnOnce(&mut [Wave<Self::Scalar, Self::Decay>]) -> R) -> R {
        search(self.idle().as_mut())
    }

    /// Returns the break-away term H_c + μm*/r² (5.63, 7.47). The contact breaks away at a reversal if Z + βG exceeds
    /// β times this term. Z is the amplitude of the contact's motion and G its damping function. The result is
    /// multiplied by r² and by the scale E of [`ContactAt`].
    #[inline]
    fn break_away(&self, contact: &ContactAt<Self::Scalar>) -> Self::Scalar {
        self.numbers().chain.break_away(contact)
    }

    /// Returns β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²), the limit of continuous motion (5.65, 5.80, 5.96, 7.49). V
    /// is the response of the contact to the load. U is the velocity at a reversal that a square wave of friction of
    /// unit amplitude causes in the contact. S is the velocity constraint. The argument `constraint` is max(S, H_c +
    /// μm*/r²), multiplied by r² and by the scale E of [`ContactAt`].
    #[inline]
    fn continuous_limit(
        &self,
        contact: &ContactAt<Self::Scalar>,
        constraint: Self::Scalar,
    ) -> Self::Scalar {
        self.numbers().chain.continuous_limit(contact, constraint)
    }

    /// Returns β*_lim = |V|/(μ|H|), the limit of sliding (6.11, 6.27, 6.33). V is the response of the contact to the
    /// load, and H its receptance. The result contains no correction for masses that act as an absorber.
    #[inline]
    fn sliding_limit(&self, contact: &ContactAt<Self::Scalar>) -> Self::Scalar {
        self.numbers().chain.sliding_limit(contact)
    }

    /// Returns an upper bound on β_lim, and β*_lim, without a search. r must be neither 0 nor infinite. The value of
    /// β*_lim contains no correction for masses that act as an absorber.
    ///
    /// The second result is the real part of H, the receptance of the contact, multiplied by r² and by the scale E of
    /// [`ContactAt`]. If the second result is small, masses may act as an absorber.
    #[inline]
    fn limits_without_search(
        &self,
        inverse_r: Self::Scalar,
    ) -> (Limits<Self::Scalar>, Self::Scalar) {
        limits_of_sums(self, inverse_r)
    }
}

/// Computes the results of [`Scene::limits_without_search`] from the contact's sums over the modes.
#[inline(always)]
pub fn limits_of_sums<T: Scene>(scene: &T, inverse_r: T::Scalar) -> (Limits<T::Scalar>, T::Scalar) {
    let contact = scene.contact_without_g(inverse_r);
    let limits = Limits {
        continuous: scene.continuous_limit(&contact, scene.break_away(&contact)),
        sliding: scene.sliding_limit(&contact),
    };
    (limits, contact.h.re)
}

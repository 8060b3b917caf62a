//! What a scene has to say for its steady response.

use super::numbers::Numbers;
use crate::contact::regime::{self, Limits};
use crate::contact::sums::{ContactAt, ModeAt};
use crate::modal_sum::wave::Wave;
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

/// A scene: its numbers, and the formulas that may be specialised for it.
///
/// The formulas that have a body here are those of every chain.  A generator writes its own where constants leave
/// less to do; the bits are the same.
pub trait Scene: Clone {
    /// `f64`, `f32`, or a wider scalar.
    type Scalar: Float;
    /// How modes decay: a scene without damping carries no exponentials.
    type Decay: Decay<Self::Scalar>;
    /// A place for each mode's functions at one frequency.
    type Modes: AsRef<[ModeAt<Self::Scalar>]> + Clone + core::fmt::Debug;
    /// A place for each mode's part in a motion.
    type Waves: AsRef<[Wave<Self::Scalar, Self::Decay>]>
        + AsMut<[Wave<Self::Scalar, Self::Decay>]>
        + Clone;

    /// Its numbers.
    fn numbers(&self) -> Numbers<'_, Self::Scalar>;

    /// The components of a mass in the modes' shapes; none if there is no such mass, or nothing is asked of it.
    fn shape(&self, mass: usize) -> Option<&[Self::Scalar]>;

    /// Whether the motion of a mass is provided, if it has a shape.
    #[inline]
    fn moves(&self, mass: usize) -> bool {
        let _ = mass;
        true
    }

    /// The smallest and the largest 1/r at which the formulas are evaluated.
    #[inline]
    fn inverse_ratio_range(&self) -> (Self::Scalar, Self::Scalar) {
        let modes = self.numbers().modes.iter();
        regime::inverse_ratio_range(modes.map(|mode| mode.resonance))
    }

    /// The sums over all modes at 1/r, and each mode's functions.
    fn frequency_stage(&self, inverse_r: Self::Scalar) -> (ContactAt<Self::Scalar>, Self::Modes);

    /// The same sums without G, which the limits do without, and without the modes.
    #[inline]
    fn contact_without_g(&self, inverse_r: Self::Scalar) -> ContactAt<Self::Scalar> {
        self.frequency_stage(inverse_r).0
    }

    /// A wave at rest for each mode: working space of the searches.
    fn idle(&self) -> Self::Waves;

    /// The modes' functions once more, for a motion to keep.  A generator's is a plain copy: where size counts, the compiler
    /// makes a loop over the modes of a clone, which took half as long as the rest of a stuck response.
    #[inline]
    fn kept(modes: &Self::Modes) -> Self::Modes {
        modes.clone()
    }

    /// Lets a search work on a wave for each mode, at rest; nothing is kept of them.
    #[inline]
    fn with_idle<R>(&self, search: impl FnOnce(&mut [Wave<Self::Scalar, Self::Decay>]) -> R) -> R {
        search(self.idle().as_mut())
    }

    /// r²E(H_c + μm*/r²), what the contact force needs for break-away at a reversal (5.63, 7.47).
    #[inline]
    fn break_away(&self, contact: &ContactAt<Self::Scalar>) -> Self::Scalar {
        self.numbers().chain.break_away(contact)
    }

    /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²), for `constraint` = r²E times that maximum (5.65, 5.80, 5.96,
    /// 7.49).
    #[inline]
    fn continuous_limit(
        &self,
        contact: &ContactAt<Self::Scalar>,
        constraint: Self::Scalar,
    ) -> Self::Scalar {
        self.numbers().chain.continuous_limit(contact, constraint)
    }

    /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
    #[inline]
    fn sliding_limit(&self, contact: &ContactAt<Self::Scalar>) -> Self::Scalar {
        self.numbers().chain.sliding_limit(contact)
    }

    /// β_lim without search and β*_lim at 1/r, for r that is neither 0 nor infinite and as if nothing absorbed; and
    /// the real part of H times r²E, which tells whether something may.
    #[inline]
    fn limits_without_search(
        &self,
        inverse_r: Self::Scalar,
    ) -> (Limits<Self::Scalar>, Self::Scalar) {
        limits_of_sums(self, inverse_r)
    }
}

/// [`Scene::limits_without_search`] from the contact's sums.
#[inline(always)]
pub fn limits_of_sums<T: Scene>(scene: &T, inverse_r: T::Scalar) -> (Limits<T::Scalar>, T::Scalar) {
    let contact = scene.contact_without_g(inverse_r);
    let limits = Limits {
        continuous: scene.continuous_limit(&contact, scene.break_away(&contact)),
        sliding: scene.sliding_limit(&contact),
    };
    (limits, contact.h.re)
}

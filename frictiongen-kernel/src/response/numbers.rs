//! The numbers of a scene, which depend neither on r nor on β.

use crate::contact::sums::Chain;
use crate::number::scalar::Float;
use crate::oscillator::mode::Mode;

/// The limits at r = 0 and r = ∞ (6.4, 6.28 and the high-frequency limits of section 6 of `docs/derivation.md`).
#[derive(Clone, Copy, Debug)]
pub struct Ends<S> {
    /// β*_lim at r = 0; β_lim is 0 there.
    pub sliding_at_rest: S,
    /// β_∞, the continuous limit for r → ∞.
    pub continuous_at_infinity: S,
    /// β*_∞, the sliding limit for r → ∞.
    pub sliding_at_infinity: S,
}

/// Everything that the steady response of a scene rests on.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'a, S> {
    /// The modes that the load or the contact drives, ascending.
    pub modes: &'a [Mode<S>],
    /// What the scene says beyond its modes.
    pub chain: Chain<S>,
    /// The limits at both ends of the frequency range.
    pub ends: Ends<S>,
    /// The mass that rubs on a support; none where two masses rub on each other.
    pub rubbing: Option<usize>,
    /// Whether masses beyond the contact may absorb: V and H may then have zeros in common.
    pub absorbs: bool,
    /// The undamped resonances that the load drives.
    pub unbounded: &'a [S],
    /// Those of them that the contact does not touch.
    pub invisible: &'a [S],
}

impl<S: Float> Numbers<'_, S> {
    /// Whether the motion of this mass is the contact's: it rubs on a support at rest.
    #[inline]
    #[must_use]
    pub fn moves_as_contact(&self, mass: usize) -> bool {
        self.chain.on_moving_base.is_none() && self.rubbing == Some(mass)
    }

    /// The amplitude of a mass that a stuck contact ties to its support, 0 or the base's; none for the others.
    #[inline]
    #[must_use]
    pub fn tied(&self, mass: usize) -> Option<S> {
        let amplitude = if self.chain.on_moving_base.is_some() {
            1.0
        } else {
            0.0
        };
        (self.rubbing == Some(mass)).then_some(S::constant(amplitude))
    }
}

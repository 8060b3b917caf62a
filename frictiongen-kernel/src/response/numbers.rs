//! Constants of a scene, which depend neither on r nor on β.

use crate::contact::sums::Chain;
use crate::number::scalar::Float;
use crate::oscillator::mode::Mode;

/// Values of the limits at r = 0 and r = ∞ (6.4, 6.28 and the high-frequency limits of section 6 of
/// `docs/derivation.md`).
#[derive(Clone, Copy, Debug)]
pub struct Ends<S> {
    /// β*_lim at r = 0. β_lim is 0 there.
    pub sliding_at_rest: S,
    /// β_∞, the continuous limit for r → ∞.
    pub continuous_at_infinity: S,
    /// β*_∞, the sliding limit for r → ∞.
    pub sliding_at_infinity: S,
}

/// All constants that the steady response of a scene depends on.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'a, S> {
    /// Modes that the load or the contact drives, in ascending order of resonance.
    pub modes: &'a [Mode<S>],
    /// Constants of the scene that do not belong to one mode.
    pub chain: Chain<S>,
    /// Values of the limits at r = 0 and r = ∞.
    pub ends: Ends<S>,
    /// Mass that slides on a support; `None` where two masses slide on each other.
    pub rubbing: Option<usize>,
    /// True if masses beyond the contact may act as an absorber. V and H may then have common zeros.
    pub absorbs: bool,
    /// Frequency ratios of the undamped resonances that the load drives.
    pub unbounded: &'a [S],
    /// Frequency ratios among `unbounded` whose modes the contact does not drive.
    pub invisible: &'a [S],
}

impl<S: Float> Numbers<'_, S> {
    /// Returns true if this mass moves as the contact does. This is so for the mass that slides on a support at rest.
    #[inline]
    #[must_use]
    pub fn moves_as_contact(&self, mass: usize) -> bool {
        self.chain.on_moving_base.is_none() && self.rubbing == Some(mass)
    }

    /// Returns the amplitude of a mass that a stuck contact fixes to its support. It is 0 on a wall and 1 on a moving
    /// base. Returns `None` for the other masses.
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

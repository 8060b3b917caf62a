//! Constants of a scene that depend neither on the frequency ratio r nor on the friction ratio β.

use crate::contact::sums::Chain;
use crate::number::scalar::Float;
use crate::oscillator::mode::Mode;

/// Limiting values of β_lim and β*_lim for the frequency ratios r = 0 and r → ∞ (6.4, 6.28). Section 6 of
/// `docs/derivation.md` gives the high-frequency limits.
#[derive(Clone, Copy, Debug)]
pub struct Ends<S> {
    /// Limit of sliding β*_lim at the frequency ratio r = 0. The limit of continuous motion β_lim is 0 at r = 0.
    pub sliding_at_rest: S,
    /// Limit of continuous motion β_lim for the frequency ratio r → ∞, named β_∞.
    pub continuous_at_infinity: S,
    /// Limit of sliding β*_lim for the frequency ratio r → ∞, named β*_∞.
    pub sliding_at_infinity: S,
}

/// All constants on which the steady response of a scene depends.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'a, S> {
    /// Modes that the load or the contact drives, in the order of increasing resonance.
    pub modes: &'a [Mode<S>],
    /// Constants of the whole chain, which belong to no single mode.
    pub chain: Chain<S>,
    /// Limiting values of β_lim and β*_lim for the frequency ratios r = 0 and r → ∞.
    pub ends: Ends<S>,
    /// Index of the mass that slides on a wall or base. `None` if two masses slide on each other.
    pub rubbing: Option<usize>,
    /// True if the masses beyond a stuck contact (seen from the load) may act as an absorber. V and H may then vanish
    /// at the same frequency. V is the response of the contact to the load, and H its response to a force in the
    /// contact.
    pub absorbs: bool,
    /// Frequency ratios of the undamped resonances that the load drives. At these frequency ratios the response may be
    /// unbounded.
    pub unbounded: &'a [S],
    /// Frequency ratios in `unbounded` at which the contact does not act on the resonant mode. Friction then cannot
    /// bound the response.
    pub invisible: &'a [S],
}

impl<S: Float> Numbers<'_, S> {
    /// Returns true if this mass moves exactly as the contact does. The result is true only for a mass that slides on a
    /// support at rest.
    #[inline]
    #[must_use]
    pub fn moves_as_contact(&self, mass: usize) -> bool {
        self.chain.on_moving_base.is_none() && self.rubbing == Some(mass)
    }

    /// Returns the amplitude of a mass that the stuck contact fixes to its support. The amplitude is 0 on a wall and 1
    /// on a moving base. Returns `None` for every other mass.
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

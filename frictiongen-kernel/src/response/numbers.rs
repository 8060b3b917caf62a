//! Constants of a scene that depend neither on the frequency ratio r nor on the friction ratio β.

use crate::contact::sums::Chain;
use crate::number::scalar::Float;
use crate::oscillator::mode::Mode;

/// Limiting values of β_lim and β*_lim at r = 0 and r → ∞ (6.4, 6.28 and the high-frequency limits of section 6 of
/// `docs/derivation.md`).
#[derive(Clone, Copy, Debug)]
pub struct Ends<S> {
    /// Limit of sliding β*_lim at r = 0. The limit of continuous motion β_lim is 0 at r = 0.
    pub sliding_at_rest: S,
    /// Limit of continuous motion β_lim for r → ∞, named β_∞.
    pub continuous_at_infinity: S,
    /// Limit of sliding β*_lim for r → ∞, named β*_∞.
    pub sliding_at_infinity: S,
}

/// All constants on which the steady response of a scene depends.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'a, S> {
    /// Modes that the load or the contact drives, in ascending order of resonance.
    pub modes: &'a [Mode<S>],
    /// Constants of the whole chain, which belong to no single mode.
    pub chain: Chain<S>,
    /// Limiting values of β_lim and β*_lim at r = 0 and r → ∞.
    pub ends: Ends<S>,
    /// Index of the mass that slides on a wall or base. `None` if two masses slide on each other.
    pub rubbing: Option<usize>,
    /// True if the masses beyond a stuck contact may act as an absorber. V and H may then vanish at the same frequency.
    /// V and H are the responses of the contact to the load and to a contact force.
    pub absorbs: bool,
    /// Frequency ratios of the undamped resonances that the load drives. The response at these resonances may be
    /// unbounded.
    pub unbounded: &'a [S],
    /// Those frequency ratios of `unbounded` at which friction in the contact does not act on the resonant mode.
    pub invisible: &'a [S],
}

impl<S: Float> Numbers<'_, S> {
    /// Returns true if this mass moves exactly as the contact does. This is so only for a mass that slides on a support
    /// at rest.
    #[inline]
    #[must_use]
    pub fn moves_as_contact(&self, mass: usize) -> bool {
        self.chain.on_moving_base.is_none() && self.rubbing == Some(mass)
    }

    /// Returns the amplitude of a mass that the stuck contact fixes to its support: 0 on a wall, 1 on a moving base.
    /// Returns `None` for every other mass.
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

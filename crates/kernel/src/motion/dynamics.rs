//! Data of a scene for its motion in time: the modes of the chain, and the modes of the chain with its contact stuck.

use super::contact::ContactChain;
use crate::contact::sums::Chain;
use crate::number::complex::Complex;
use crate::number::scalar::Float;
use crate::oscillator::mode::{Kind, Mode};

/// A mode of the chain with its contact stuck. Its state is the displacement y and the scaled velocity u = ẏ/ω. The
/// derivative ẏ is with respect to the time t√(k₁/m₁), and ω is the natural frequency of the mode.
#[derive(Clone, Copy, Debug)]
pub struct HeldMode<S> {
    /// Kind of damping of the mode, which selects the closed form.
    pub kind: Kind,
    /// Undamped natural frequency ω of the mode, as a frequency ratio r.
    pub frequency: S,
    /// Modal damping ratio ζ of the mode.
    pub zeta: S,
    /// √|1 − ζ²|. For ζ < 1, this number is the damped natural frequency of the mode divided by its undamped natural
    /// frequency.
    pub q: S,
    /// Contact force that a unit displacement y of the mode causes, with the opposite sign.
    pub force: S,
    /// Symmetric matrix [m₁₁, m₁₂, m₂₂] from which `state` computes the displacement y and the scaled velocity u. The
    /// matrix multiplies the two scalar products of the chain's motion with the two state vectors of the mode.
    pub inverse: [S; 3],
}

/// Data of a scene for its motion in time. The data do not depend on r or β.
#[derive(Clone, Copy, Debug)]
pub struct Dynamics<'a, S, K = Chain<S>> {
    /// Constants of the scene other than its modes. Their type selects the law of the contact.
    pub chain: K,
    /// All modes of the chain. The modes that the contact drives come first.
    pub modes: &'a [Mode<S>],
    /// Modes of the chain with its contact stuck (stuck chain). If the contact drives n modes, the stuck chain has n −
    /// 1 modes for a rigid contact, and n for an elastic contact.
    pub held: &'a [HeldMode<S>],
    /// Participation factors of the chain's modes in the modes of the chain with its contact stuck (stuck chain). Each
    /// pair has a factor for the displacement y and one for the scaled velocity u. For each mode of the stuck chain,
    /// the list has one pair for each mode of the chain that the contact drives.
    pub participations: &'a [[S; 2]],
    /// Mode shapes φ. The components of the first mass in all modes come first. The components of the second mass
    /// follow, and so on.
    pub shapes: &'a [S],
    /// Products φᵀΓ of each mode, one mode after the other. φ is the mode shape, and Γ is the mass matrix divided by
    /// m₁. If damping acts relative to the moving base, the list also contains the loads in quadrature (90° out of
    /// phase with the base).
    pub weights: &'a [S],
    /// Index of the mass that slides on a support, or `None` if two masses slide on each other.
    pub rubbing: Option<usize>,
}

impl<'a, S: Copy, K> Dynamics<'a, S, K> {
    /// Returns this data with other constants of the chain, which select another law of the contact.
    #[must_use]
    pub fn with<J>(&self, chain: J) -> Dynamics<'a, S, J> {
        Dynamics {
            chain,
            modes: self.modes,
            held: self.held,
            participations: self.participations,
            shapes: self.shapes,
            weights: self.weights,
            rubbing: self.rubbing,
        }
    }
}

impl<'a, S: Float, K: ContactChain<S>> Dynamics<'a, S, K> {
    /// Returns the constants of the chain that do not belong to the law of its contact.
    #[inline]
    pub(crate) fn chain(&self) -> &Chain<S> {
        self.chain.chain()
    }

    /// Returns the number of modes that the contact drives.
    #[must_use]
    pub fn in_contact(&self) -> usize {
        self.held.len() + self.chain.lost_modes()
    }

    /// Returns the number of scalars in a state of the motion: two for each mode that the contact drives, and the
    /// scalars that the contact itself stores.
    #[must_use]
    pub fn state_size(&self) -> usize {
        2 * self.in_contact() + self.chain.remembered()
    }

    /// Returns the number of oscillators: the modes of the chain, and the modes of the chain with its contact stuck.
    #[must_use]
    pub fn oscillators(&self) -> usize {
        self.modes.len() + self.held.len()
    }

    /// Returns the modes that the contact drives.
    pub(crate) fn driven(&self) -> &'a [Mode<S>] {
        self.modes.get(..self.in_contact()).unwrap_or_default()
    }

    /// Returns wᵀK̄⁻¹w, the displacement of the contact per unit of steady contact force. This receptance is the sum of
    /// (φᵀw)²/λ over the modes, with the mode shape φ, the contact's direction vector w and the squared frequency ratio
    /// λ.
    pub(crate) fn receptance(&self) -> S {
        let terms = self.driven().iter();
        terms.fold(S::constant(0.0), |sum, mode| {
            sum + mode.contact_squared / (mode.resonance * mode.resonance)
        })
    }

    /// Returns the loads in quadrature (90° out of phase) with the motion of the base, in the form of
    /// [`Quadratures`](crate::contact::quadrature). The list is empty unless damping acts on velocities relative to the
    /// moving base.
    pub(crate) fn quadratures(&self) -> &'a [[S; 2]] {
        let modes = self.modes.len();
        let (quadratures, _) = self
            .weights
            .get(modes * modes..)
            .unwrap_or_default()
            .as_chunks();
        quadratures
    }

    /// Returns the complex amplitude of the load on a mode at the frequency ratio r.
    pub(crate) fn load(&self, mode: usize, r: S) -> Complex<S> {
        let zero = S::constant(0.0);
        let Some(constants) = self.modes.get(mode) else {
            return Complex::new(zero, zero);
        };
        let quadrature = self.quadratures().get(mode);
        let quadrature = quadrature.map_or(zero, |[load, _]| *load * (r / constants.resonance));
        Complex::new(constants.load, quadrature)
    }

    /// Returns the components of a mass in all mode shapes, or an empty slice if no mass has this index.
    pub(crate) fn shape(&self, mass: usize) -> &'a [S] {
        let modes = self.modes.len();
        let mut shapes = self.shapes.chunks_exact(modes.max(1));
        shapes.nth(mass).unwrap_or_default()
    }

    /// Returns true if this mass moves exactly as the contact does, for example a mass that slides on a support at
    /// rest.
    pub(crate) fn moves_as_contact(&self, mass: usize) -> bool {
        self.chain().on_moving_base.is_none() && self.rubbing == Some(mass)
    }

    /// Returns the modes of the chain with its contact stuck. Each mode comes with the participation factors of all
    /// modes of the chain that the contact drives.
    pub(crate) fn held_modes(&self) -> impl Iterator<Item = (&'a HeldMode<S>, &'a [[S; 2]])> {
        // The code uses ranges. An iterator over chunks could panic if the compiler does not know the size of the
        // chunks.
        let (participations, size) = (self.participations, self.in_contact());
        let held = self.held.iter().enumerate();
        held.map(move |(index, mode)| {
            let start = index * size;
            (
                mode,
                participations.get(start..start + size).unwrap_or_default(),
            )
        })
    }
}

impl<S: Float> HeldMode<S> {
    /// Returns the displacement y and the scaled velocity u of a mode of the chain with its contact stuck. `first` and
    /// `second` are the products of the chain's motion with the two state vectors of the mode.
    pub(crate) fn state(&self, first: S, second: S) -> (S, S) {
        let [m11, m12, m22] = self.inverse;
        (m11 * first + m12 * second, m12 * first + m22 * second)
    }
}

/// Returns the displacement of a mode per unit of displacement of the stuck contact, if no other force acts.
pub(crate) fn lift<S: Float>(mode: &Mode<S>, receptance: S) -> S {
    mode.contact / (mode.resonance * mode.resonance * receptance)
}

/// Returns Re(a·e^{iτ_e}) from sine and cosine of the excitation's angle τ_e.
#[inline]
pub(crate) fn rotated<S: Float>(a: Complex<S>, sine: S, cosine: S) -> S {
    a.re * cosine - a.im * sine
}

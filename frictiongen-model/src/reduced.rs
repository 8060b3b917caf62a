//! What the steady response needs of a scene, in a solver's own scalar; and the kernel's scene over it.

use frictiongen_kernel::Float;
use frictiongen_kernel::contact::sums::{Chain, ContactAt, ModeAt};
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::oscillator::decay::Damped;
use frictiongen_kernel::oscillator::mode::Mode;
use frictiongen_kernel::response::{
    Continuous, Ends, Numbers, ProvidesMotion, ProvidesStuck, Scene, Stuck,
};

/// The kernel's [`Numbers`], with their vectors.
#[derive(Clone, Debug)]
pub struct Reduced<S> {
    /// The modes that the load or the contact drives, ascending.
    pub modes: Vec<Mode<S>>,
    /// φ of those modes, mass after mass.
    pub shapes: Vec<S>,
    /// What the scene says beyond its modes.
    pub chain: Chain<S>,
    /// The limits at the ends of the frequency range.
    pub ends: Ends<S>,
    /// The mass that rubs on a support; none where two masses rub on each other.
    pub rubbing: Option<usize>,
    /// Whether masses beyond the contact may absorb.
    pub absorbs: bool,
    /// The undamped resonances that the load drives.
    pub unbounded: Vec<S>,
    /// Those of them that the contact does not touch.
    pub invisible: Vec<S>,
}

impl<S> Reduced<S> {
    /// The components of a mass in the modes' shapes; empty if there is no such mass.
    #[must_use]
    pub fn shape(&self, mass: usize) -> &[S] {
        let mut shapes = self.shapes.chunks_exact(self.modes.len().max(1));
        shapes.nth(mass).unwrap_or_default()
    }
}

impl<S: Float> Reduced<S> {
    /// The same as the kernel reads it.
    #[must_use]
    pub fn numbers(&self) -> Numbers<'_, S> {
        Numbers {
            modes: &self.modes,
            chain: self.chain,
            ends: self.ends,
            rubbing: self.rubbing,
            absorbs: self.absorbs,
            unbounded: &self.unbounded,
            invisible: &self.invisible,
        }
    }
}

impl<S: Float> Scene for &Reduced<S> {
    type Scalar = S;
    type Decay = Damped<S>;
    type Modes = Vec<ModeAt<S>>;
    type Waves = Vec<Wave<S, Damped<S>>>;

    fn numbers(&self) -> Numbers<'_, S> {
        Reduced::numbers(self)
    }

    fn shape(&self, mass: usize) -> Option<&[S]> {
        Some(Reduced::shape(self, mass)).filter(|shape| !shape.is_empty())
    }

    fn frequency_stage(&self, inverse_r: S) -> (ContactAt<S>, Vec<ModeAt<S>>) {
        let mut at = Vec::with_capacity(self.modes.len());
        let contact = self
            .chain
            .contact(&self.modes, inverse_r, |mode| at.push(mode));
        (contact, at)
    }

    fn contact_without_g(&self, inverse_r: S) -> ContactAt<S> {
        self.chain.contact_without_g(&self.modes, inverse_r)
    }

    fn idle(&self) -> Vec<Wave<S, Damped<S>>> {
        self.modes.iter().map(Wave::idle).collect()
    }
}

impl<S: Float> ProvidesMotion for &Reduced<S> {
    type Motion = Continuous<Self>;
}

impl<S: Float> ProvidesStuck for &Reduced<S> {
    type Stuck = Stuck<Self>;
}

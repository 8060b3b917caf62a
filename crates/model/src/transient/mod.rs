//! Data of a scene for the motion in time, in addition to the modal analysis: every mode of the sliding chain, and the
//! *held modes*. Held modes are the modes of the chain with its contact stuck. The data do not depend on the frequency.

mod held;
mod plain;

use crate::modal::Modal;
use crate::reduced;
use crate::roots;
use crate::scene::{Damping, Precision, Scene};
use frictiongen_kernel::contact::sums::Chain;
use frictiongen_kernel::motion::{AnyContact, Dynamics, ElasticChain, HeldMode};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::oscillator::mode::Mode;
use frictiongen_kernel::{Float, Scalar};
use plain::{EQUAL, SlidingMode, close, driven, in_contact, plain_modes, sorted, turned};

/// Modal damping ratio above which the frequencies of the held modes may be close to one another. The held modes are
/// the modes of the chain with its contact stuck. If no damping ratio exceeds this value, chains of up to 64 masses
/// have rounding errors of only a few units.
const NEAR_CRITICAL: f64 = 0.9;

/// Returns the largest relative rounding error in a motion of the scene if the contact sticks and is immediately
/// released ([`Transient::excess_loss`]). Returns `None` if the error is acceptable. An error up to √ε of the scene's
/// number type is acceptable, because it keeps half of the digits.
#[must_use]
pub fn excess_loss(scene: &Scene) -> Option<f64> {
    let near_critical = |ratio: f64| NEAR_CRITICAL <= ratio;
    let may_lose = match &scene.damping {
        Damping::None => false,
        Damping::Uniform(ratio) => near_critical(*ratio),
        Damping::Modal(ratios) => ratios.iter().copied().any(near_critical),
        Damping::Rayleigh { .. } => true,
    };
    if !may_lose {
        return None;
    }
    let modal = Modal::of(scene);
    let ratios = modal.damping_ratios.iter();
    if !ratios.map(|ratio| ratio.to_f64()).any(near_critical) {
        return None;
    }
    match scene.precision {
        Precision::F64 => Transient::of(scene, &modal, |value| value.hi).excess_loss(),
        Precision::F32 => {
            let single = Transient::of(scene, &modal, |value| f32::constant(value.to_f64()));
            single.excess_loss().map(f64::from)
        }
    }
}

/// Modes of a scene for the motion in time: the modes with the contact sliding, and the modes with the contact stuck.
#[derive(Clone, Debug)]
pub struct Transient<S> {
    /// All modes of the sliding chain. The modes that the contact drives come first, then the other modes. Both groups
    /// are in ascending order of resonance. The contact drives only one of several equal modes.
    pub modes: Vec<Mode<S>>,
    /// Mode shapes φ: for each mass in turn, the mass's component in each mode.
    pub shapes: Vec<S>,
    /// Weights φᵀΓ of the masses, for each mode in turn. The weights convert displacements of the masses to modal
    /// coordinates. If damping acts relative to the moving base, the list also contains the loads in quadrature, two
    /// numbers for each mode.
    pub weights: Vec<S>,
    /// Held modes, which are the modes of the chain with its contact stuck.
    pub held: Vec<HeldMode<S>>,
    /// Participations (g, h) of the modes of the sliding chain in the held modes, which are the modes with the contact
    /// stuck. For each held mode in turn, the list has one pair for each mode of the sliding chain.
    pub participations: Vec<[S; 2]>,
    /// Constants of the whole chain, which belong to no single mode.
    pub chain: Chain<S>,
    /// k₁ divided by the stiffness of an elastic contact. `None` for a rigid contact.
    pub compliance: Option<S>,
    /// Index of the mass that slides on a support. `None` if two masses slide on each other.
    pub rubbing: Option<usize>,
}

impl<S: Scalar> Transient<S> {
    /// Creates the data from the modal analysis of a scene. `to` rounds each number once from double-double.
    #[must_use]
    pub fn of(scene: &Scene, modal: &Modal, to: impl Fn(Dd) -> S) -> Self {
        let plain = sorted(turned(plain_modes(modal)));
        let compliance = modal.compliance.unwrap_or(Dd::ZERO);
        let pairs = roots::pairs(&driven(&plain, |value| value), compliance);
        let pairs: Vec<(Dd, Dd)> = pairs.iter().map(|pair| (pair.omega, pair.zeta)).collect();
        Self::with_pairs((scene, compliance), modal, &plain, &pairs, to)
    }

    fn with_pairs<T: Float>(
        (scene, compliance): (&Scene, T),
        modal: &Modal<T>,
        plain: &[SlidingMode<T>],
        pairs: &[(T, T)],
        to: impl Fn(T) -> S,
    ) -> Self {
        let in_contact: Vec<&SlidingMode<T>> = in_contact(plain).collect();
        let chain = modal.reduced(&to).chain;
        let (held, participations) =
            held::held(&in_contact, (modal.inverse_mass, compliance), pairs, &to);
        let m1 = scene.masses.first().map_or(1.0, |mass| mass.value);
        let gamma: Vec<T> = scene
            .masses
            .iter()
            .map(|mass| T::constant(mass.value) / T::constant(m1))
            .collect();
        let mut shapes = Vec::new();
        for mass in 0..gamma.len() {
            let components = plain.iter().filter_map(|mode| mode.shape.get(mass));
            shapes.extend(components.map(|component| to(*component)));
        }
        let mut weights = Vec::new();
        for mode in plain {
            let products = mode.shape.iter().zip(&gamma);
            weights.extend(products.map(|(component, gamma)| to(*component * *gamma)));
        }
        if !modal.participations.is_empty() {
            let quadratures = plain.iter().flat_map(|mode| {
                let [participation, wall] = mode.base;
                let oscillator = (mode.resonance, mode.zeta);
                reduced::quadrature(oscillator, mode.contact, (participation, wall), &to)
            });
            weights.extend(quadratures);
        }
        let modes = plain
            .iter()
            .map(|mode| reduced::mode(mode.resonance, mode.zeta, mode.load, mode.contact, &to))
            .collect();
        Self {
            modes,
            shapes,
            weights,
            held,
            participations,
            chain,
            compliance: modal.compliance.map(|_| to(compliance)),
            rubbing: modal.rubbing(),
        }
    }

    /// Returns the largest relative rounding error in a motion if the contact sticks and is immediately released
    /// ([`held_loss`](Dynamics::held_loss)). Returns `None` if the error is at most √ε of the number type, which keeps
    /// half of the digits. With a larger error no result in the time domain is useful. Only modes near or above
    /// critical damping cause a larger error.
    #[must_use]
    pub fn excess_loss(&self) -> Option<S>
    where
        S: Float,
    {
        let dynamics = self.contact_dynamics();
        let driven = dynamics.in_contact();
        let mut modes = self.modes.iter().take(driven);
        if !modes.any(|mode| S::constant(NEAR_CRITICAL) <= mode.zeta) {
            return None;
        }
        let zero = S::constant(0.0);
        let (mut states, mut held) = (vec![[zero; 2]; driven], vec![[zero; 2]; self.held.len()]);
        let loss = dynamics.held_loss(&mut states, &mut held);
        // With this comparison, a loss of NaN counts as too large.
        let kept = loss * loss <= S::constant(S::EPSILON);
        (!kept).then_some(loss)
    }

    /// Returns the data of a rigid contact as [`Dynamics`] of the kernel crate.
    #[must_use]
    pub fn dynamics(&self) -> Dynamics<'_, S> {
        Dynamics {
            chain: self.chain,
            modes: &self.modes,
            held: &self.held,
            participations: &self.participations,
            shapes: &self.shapes,
            weights: &self.weights,
            rubbing: self.rubbing,
        }
    }

    /// Returns the data as [`Dynamics`] for either law of the contact, rigid or elastic.
    #[must_use]
    pub fn contact_dynamics(&self) -> Dynamics<'_, S, AnyContact<S>>
    where
        S: Copy,
    {
        self.dynamics().with(match self.compliance {
            None => AnyContact::Rigid(self.chain),
            Some(compliance) => AnyContact::Elastic(ElasticChain {
                chain: self.chain,
                compliance,
            }),
        })
    }
}

impl<S: Scalar> Transient<S> {
    /// Creates the data from modal data with derivatives, including the derivatives of the held modes (contact stuck).
    /// The weights get no derivatives, because they only give first guesses of a state. `to` rounds each number once.
    ///
    /// Returns `None` if single modes have no derivative. Single modes have no derivative in three cases: two equal
    /// modes become different, two held modes are equal, or the contact begins to drive a mode.
    #[must_use]
    pub fn along(
        scene: &Scene,
        modal: &Modal<Dual<Dd>>,
        to: impl Fn(Dual<Dd>) -> S,
    ) -> Option<Self> {
        let plain = plain_modes(modal);
        let parts = |a: &SlidingMode<Dual<Dd>>, b: &SlidingMode<Dual<Dd>>| {
            let size = (a.resonance.slope.abs() + b.resonance.slope.abs()) * Dd::from(EQUAL);
            let damping = (a.zeta.slope.abs() + b.zeta.slope.abs()) * Dd::from(EQUAL);
            close(a.resonance, b.resonance)
                && close(a.zeta, b.zeta)
                && (size < (a.resonance.slope - b.resonance.slope).abs()
                    || damping < (a.zeta.slope - b.zeta.slope).abs())
        };
        for (index, mode) in plain.iter().enumerate() {
            let mut before = plain.iter().take(index);
            let grazed = mode.contact.is_zero() && !mode.contact.vanishes();
            if grazed || before.any(|other| parts(other, mode)) {
                return None;
            }
        }
        let plain = sorted(turned(plain));
        let compliance = modal.compliance.unwrap_or(Dual::fixed(Dd::ZERO));
        let pairs = held::moving(
            &driven(&plain, |of| of.value),
            &in_contact(&plain).collect::<Vec<_>>(),
            compliance,
        )?;
        let scene = (scene, compliance);
        Some(Self::with_pairs(scene, modal, &plain, &pairs, to))
    }
}

#[cfg(test)]
mod tests;

//! What the motion in time needs beyond the modal analysis: every mode, and the chain with its
//! contact held.  None of it depends on the frequency.

mod held;

use crate::modal::{self, Modal};
use crate::scene::Scene;
use frictiongen_kernel::Scalar;
use frictiongen_kernel::contact::sums::Chain;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::oscillator::mode::Mode;
use frictiongen_kernel::simulation::{Dynamics, HeldMode};

/// Modes whose constants agree to this count as equal: beyond, rounding alone tells them apart.
const EQUAL: f64 = 1e-24;
/// Below this share of the largest that it could be, a component is rounding noise.
const NOISE: f64 = 1e-26;

/// The modes of a scene for its motion in time, and those of the chain with its contact held.
#[derive(Clone, Debug)]
pub struct Transient<S> {
    /// All modes, those that the contact drives first, ascending.  Of equal modes only one is driven
    /// by the contact.
    pub modes: Vec<Mode<S>>,
    /// φ for each mass, one component a mode, mass after mass.
    pub shapes: Vec<S>,
    /// φᵀΓ for each mode, one component a mass, mode after mode.
    pub weights: Vec<S>,
    /// The modes of the chain with its contact held.
    pub held: Vec<HeldMode<S>>,
    /// How far each mode takes part in each held mode, held mode after held mode.
    pub shares: Vec<[S; 2]>,
    /// What the scene says beyond its modes.
    pub chain: Chain<S>,
    /// The mass that rubs on a support; none where two masses rub on each other.
    pub rubbing: Option<usize>,
}

/// A mode in double-double.
#[derive(Clone, Debug)]
struct Plain {
    resonance: Dd,
    zeta: Dd,
    load: Dd,
    contact: Dd,
    shape: Vec<Dd>,
}

impl<S: Scalar> Transient<S> {
    /// From the modal analysis of a scene, rounded once from double-double by `to`.
    #[must_use]
    pub fn of(scene: &Scene, modal: &Modal, to: impl Fn(Dd) -> S) -> Self {
        let zero = Dd::ZERO;
        let mut plain = turned(plain_modes(modal));
        // A stable sort: both groups stay ascending.
        plain.sort_by_key(|mode| mode.contact == zero);
        let in_contact: Vec<&Plain> = plain.iter().filter(|mode| mode.contact != zero).collect();
        let chain = modal.reduced(&to).chain;
        let (held, shares) = held::held(&in_contact, modal, &to);
        let m1 = scene.masses.first().map_or(1.0, |mass| mass.value);
        let gamma: Vec<Dd> = scene
            .masses
            .iter()
            .map(|mass| Dd::from(mass.value) / Dd::from(m1))
            .collect();
        let mut shapes = Vec::new();
        for mass in 0..gamma.len() {
            let components = plain.iter().filter_map(|mode| mode.shape.get(mass));
            shapes.extend(components.map(|component| to(*component)));
        }
        let mut weights = Vec::new();
        for mode in &plain {
            let products = mode.shape.iter().zip(&gamma);
            weights.extend(products.map(|(component, gamma)| to(*component * *gamma)));
        }
        let modes = plain
            .iter()
            .map(|mode| modal::mode(mode.resonance, mode.zeta, mode.load, mode.contact, &to))
            .collect();
        Self {
            modes,
            shapes,
            weights,
            held,
            shares,
            chain,
            rubbing: modal.rubbing(),
        }
    }

    /// The same as the kernel reads it.
    #[must_use]
    pub fn dynamics(&self) -> Dynamics<'_, S> {
        Dynamics {
            chain: self.chain,
            modes: &self.modes,
            held: &self.held,
            shares: &self.shares,
            shapes: &self.shapes,
            weights: &self.weights,
            rubbing: self.rubbing,
        }
    }
}

fn plain_modes(modal: &Modal) -> Vec<Plain> {
    let pick = |of: &[Dd], i: usize| of.get(i).copied().unwrap_or_default();
    modal
        .shapes
        .iter()
        .enumerate()
        .map(|(i, shape)| Plain {
            resonance: pick(&modal.resonances, i),
            zeta: pick(&modal.damping_ratios, i),
            load: pick(&modal.loads, i),
            contact: pick(&modal.contacts, i),
            shape: shape.clone(),
        })
        .collect()
}

/// Equal modes may be mixed at will: they are turned so that the contact drives one alone, since
/// the others then move on freely whatever the contact does.
fn turned(modes: Vec<Plain>) -> Vec<Plain> {
    let close = |a: Dd, b: Dd| (a - b).abs() <= (a.abs() + b.abs()) * Dd::from(EQUAL);
    let mut out: Vec<Plain> = Vec::with_capacity(modes.len());
    for mut mode in modes {
        let zero = Dd::ZERO;
        let twin = out.iter_mut().find(|known| {
            known.contact != zero
                && mode.contact != zero
                && close(known.resonance, mode.resonance)
                && close(known.zeta, mode.zeta)
        });
        if let Some(twin) = twin {
            let length = (twin.contact * twin.contact + mode.contact * mode.contact).sqrt();
            let (c, s) = (twin.contact / length, mode.contact / length);
            let mix = |a: &mut Dd, b: &mut Dd| {
                let size = a.abs() + b.abs();
                let (first, second) = (*a * c + *b * s, *b * c - *a * s);
                let clean = |value: Dd| {
                    if value.abs() <= size * Dd::from(NOISE) {
                        zero
                    } else {
                        value
                    }
                };
                (*a, *b) = (clean(first), clean(second));
            };
            mix(&mut twin.load, &mut mode.load);
            for (a, b) in twin.shape.iter_mut().zip(&mut mode.shape) {
                mix(a, b);
            }
            (twin.contact, mode.contact) = (length, zero);
        }
        out.push(mode);
    }
    out
}

#[cfg(test)]
mod tests;

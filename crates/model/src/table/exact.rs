//! Exact values of the functions in a table. Fits approximate these values, and checks compare tables with them.

use super::zeros::{ContactMode, contact_modes};
use crate::modal::Modal;
use crate::reduced::Reduced;
use frictiongen_kernel::Complex;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::response::At;
use frictiongen_kernel::table::ContactTable;
use std::collections::HashMap;

/// Index of arg V among the functions of a table, where V is the response of the contact to the load. The lower indices
/// are those of β_lim, β_lim·U/|V| and β_lim·G/|V|.
pub const ANGLE: usize = 3;
/// Index of |V| among the functions of a table, if the table has this function. V is the response of the contact to the
/// load.
pub const SIZE: usize = 4;
/// A sum has lost significant digits by cancellation if it is smaller than this fraction of its terms.
const CANCELS: f64 = 1e-2;

/// Exact functions at one frequency ratio: β_lim, a = β_lim·U/|V|, g = β_lim·G/|V| and arg V. V is the response of the
/// contact to the load. U and G are the velocity and displacement of the contact that friction causes at a reversal.
/// For an undamped chain arg V is 0, and a contains the factor sgn V, so that a is smooth across a resonance.
#[derive(Clone, Copy, Debug)]
pub struct ExactValues {
    /// β_lim, the limit of continuous motion.
    pub limit: f64,
    quadrature: f64,
    displacement: f64,
    direction: f64,
    /// Phase τ in the half period at which the velocity constraint is largest. `None` if the largest value is the limit
    /// for τ → 0.
    pub tau: Option<f64>,
}

/// Evaluator of a table's functions for one scene. It computes exact values, and stores them for later calls.
pub struct Exact<'a> {
    /// The modal analysis of the scene.
    pub modal: &'a Modal,
    /// The constants of the scene in double precision.
    pub reduced: Reduced<f64>,
    contact_modes: Vec<ContactMode>,
    seen: HashMap<u64, ExactValues>,
    excitations: HashMap<u64, f64>,
}

impl<'a> Exact<'a> {
    /// Creates the evaluator for a scene, without stored values.
    #[must_use]
    pub fn new(modal: &'a Modal) -> Self {
        Self {
            modal,
            // Macros build tables, and macros run without optimisation. Without optimisation the sums are slower if
            // they process two modes at the same time.
            reduced: Reduced {
                two_at_once: false,
                ..modal.reduced(|value| value.to_f64())
            },
            contact_modes: contact_modes(modal),
            seen: HashMap::new(),
            excitations: HashMap::new(),
        }
    }

    /// Returns the modes that the contact drives.
    pub fn contact_modes(&self) -> &[ContactMode] {
        &self.contact_modes
    }

    /// Returns true if any mode is damped.
    #[must_use]
    pub fn damped(&self) -> bool {
        self.reduced.chain.damped
    }

    /// Returns true if every mode that the contact drives is damped. The response of the contact then has no pole at a
    /// real r.
    pub fn all_damped(&self) -> bool {
        let mut contact_modes = self.contact_modes.iter();
        contact_modes.all(|mode| !mode.driven.zeta.is_zero())
    }

    /// Returns the number of frequency ratios at which exact values were computed.
    pub fn looked_at(&self) -> usize {
        self.seen.len()
    }

    /// Returns the exact functions at r. Returns `None` if r is NaN or negative.
    pub fn at(&mut self, r: f64) -> Option<ExactValues> {
        if let Some(sample) = self.seen.get(&r.to_bits()) {
            return Some(*sample);
        }
        let at = At::new(&self.reduced, r).ok()?;
        let contact = at.contact_sums();
        let peak = at.velocity_constraint();
        let [place, ..] = peak.places;
        let constraint = peak.value;
        let mut limit = self.reduced.chain.continuous_limit(contact, constraint);
        let mut negative = contact.v.re < 0.0;
        if self.cancels(&at) {
            // The sum for V, the response of the contact to the load, has lost digits in double precision. The code
            // therefore computes V in double-double.
            negative = self.excitation(r) < 0.0;
            let square = at.inverse_ratio() * at.inverse_ratio();
            let own = complex::modulus(contact.v, self.damped());
            limit *= self.excitation(r).abs() * contact.scale / square / own;
        }
        let all = (contact.u * contact.u + constraint * constraint).sqrt();
        let (mut quadrature, mut direction) = (contact.u / all, 0.0);
        if self.damped() {
            direction = contact.v.im.atan2(contact.v.re);
        } else if negative {
            quadrature = -quadrature;
        }
        let sample = ExactValues {
            limit,
            quadrature,
            displacement: contact.g / all,
            direction,
            tau: place.map(|place| place.tau),
        };
        self.seen.insert(r.to_bits(), sample);
        Some(sample)
    }

    /// Returns true if the modal terms of V nearly cancel, as they do near a zero of V. V is the response of the
    /// contact to the load.
    fn cancels(&self, at: &At<&Reduced<f64>>) -> bool {
        let chain = &self.reduced.chain;

        let contact = at.contact_sums();
        let at_rest = chain.on_moving_base.map(f64::abs);
        let quadratures = self.reduced.quadratures.iter().copied();
        let quadratures = quadratures.chain(std::iter::repeat([0.0; 2]));
        let modes = self.reduced.modes.iter().zip(at.modes()).zip(quadratures);
        let terms = modes.map(|((mode, at), [load, wall])| {
            let residue = if at_rest.is_some() {
                mode.static_residue.abs() + (2.0 * mode.zeta * at.x * wall).abs()
            } else {
                mode.residue.abs() + (mode.contact * load / at.x).abs()
            };
            residue * complex::modulus(at.response, chain.damped)
        });
        let terms = terms.sum::<f64>() + at_rest.unwrap_or(0.0) * contact.scale;
        let left = complex::modulus(contact.v, chain.damped);
        let left = if at_rest.is_some() {
            left * at.inverse_ratio() * at.inverse_ratio()
        } else {
            left
        };
        0.0 < left && left < CANCELS * terms
    }

    /// Returns the responses of the contact at r in double-double: V to the load, and H to a force in the contact.
    pub fn receptances(&self, r: f64) -> [Complex<Dd>; 2] {
        let (r, two) = (Dd::from(r), Dd::from(2.0));
        let direct = if self.modal.on_moving_base { -1.0 } else { 0.0 };
        let mut excitation = complex::real(Dd::from(direct));
        let mut receptance = complex::real(Dd::ZERO);
        for mode in &self.contact_modes {
            let driven = &mode.driven;
            let re = (driven.sigma - r) * (driven.sigma + r);
            let im = two * driven.zeta * driven.sigma * r;
            let inverse = complex::reciprocal(Complex::new(re, im), true);
            let load = Complex::new(mode.residue, mode.along * r);
            excitation = complex::add(excitation, complex::mul(inverse, load, true));
            receptance = complex::add(receptance, complex::scale(inverse, driven.inverse_mass));
        }
        [excitation, receptance]
    }

    /// Returns the exact value of one of a table's functions at r. `place` is the index of the function in the table.
    pub fn function(&mut self, place: usize, r: f64) -> Option<f64> {
        let sample = self.at(r)?;
        let functions = [
            sample.limit,
            sample.quadrature,
            sample.displacement,
            sample.direction,
        ];
        if place == SIZE {
            return Some(self.known_excitation(r));
        }
        functions.get(place).copied()
    }

    /// Returns the same result as [`excitation`](Self::excitation), and stores it for later calls.
    fn known_excitation(&mut self, r: f64) -> f64 {
        let known = self.excitations.get(&r.to_bits()).copied();
        let excitation = known.unwrap_or_else(|| self.excitation(r));
        self.excitations.insert(r.to_bits(), excitation);
        excitation
    }

    /// Returns the exact values from which amplitude and phase of the contact follow at any β.
    pub fn contact(&mut self, sample: &ExactValues, r: f64) -> ContactTable<f64> {
        let excitation = self.known_excitation(r);
        if self.damped() {
            let ExactValues {
                limit,
                quadrature,
                displacement,
                direction,
                ..
            } = *sample;
            ContactTable::damped([limit, quadrature, displacement, direction], excitation)
        } else {
            ContactTable::undamped([sample.limit, sample.quadrature], excitation)
        }
    }

    /// Returns the stuck limit β*_lim at the frequency ratio r, exact to the last digits. `At` in the kernel also
    /// corrects the limit for masses that act as a vibration absorber. This function does not.
    pub fn sliding_limit(&self, r: f64) -> f64 {
        let [excitation, receptance] = self.receptances(r);
        let ratio = complex::modulus(excitation, true) / complex::modulus(receptance, true);
        (ratio / self.modal.stiction).to_f64()
    }

    /// Returns |V|, the amplitude of the contact without friction, to the last digits. For an undamped chain the result
    /// is V with its sign.
    pub fn excitation(&self, r: f64) -> f64 {
        let [excitation, _] = self.receptances(r);
        if self.damped() {
            complex::modulus(excitation, true).to_f64()
        } else {
            excitation.re.to_f64()
        }
    }
}

//! The exact values that tables are made from and compared with.

use super::zeros::{ContactMode, contact_modes};
use crate::modal::Modal;
use crate::reduced::Reduced;
use frictiongen_kernel::Complex;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::response::At;
use frictiongen_kernel::table::ContactTable;
use std::collections::HashMap;

/// The place of arg V among the functions; those before it are divided by |V|/β_lim.
pub(super) const ANGLE: usize = 3;
/// The place of |V|, where it is among them.
pub(super) const SIZE: usize = 4;
/// Below this share of its terms a sum has lost digits that count.
const CANCELS: f64 = 1e-2;

/// The functions of r at one r: β_lim, a = β_lim·U/|V|, g = β_lim·G/|V| and arg V; |V| is known besides.  Of an undamped chain a is times
/// sgn V, with which it is smooth across a resonance, and arg V is 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub limit: f64,
    quadrature: f64,
    displacement: f64,
    direction: f64,
    /// Where in the half period the velocity constraint is largest; none where its start decides.
    pub tau: Option<f64>,
}

/// A scene that answers exactly, and remembers its answers.
pub(super) struct Exact<'a> {
    pub modal: &'a Modal,
    pub reduced: Reduced<f64>,
    contact_modes: Vec<ContactMode>,
    seen: HashMap<u64, Sample>,
    excitations: HashMap<u64, f64>,
}

impl<'a> Exact<'a> {
    pub fn new(modal: &'a Modal) -> Self {
        Self {
            modal,
            // A macro makes tables, and macros run without optimisation.
            reduced: Reduced {
                two_at_once: false,
                ..modal.reduced(|value| value.to_f64())
            },
            contact_modes: contact_modes(modal),
            seen: HashMap::new(),
            excitations: HashMap::new(),
        }
    }

    /// The modes that the contact drives.
    pub fn contact_modes(&self) -> &[ContactMode] {
        &self.contact_modes
    }

    pub fn damped(&self) -> bool {
        self.reduced.chain.damped
    }

    /// Whether every mode that the contact drives is damped: |V| is then finite at every r.
    pub fn all_damped(&self) -> bool {
        let mut contact_modes = self.contact_modes.iter();
        contact_modes.all(|mode| !mode.driven.zeta.is_zero())
    }

    /// How many points have been looked at.
    pub fn looked_at(&self) -> usize {
        self.seen.len()
    }

    /// The functions at r, a number in the domain.
    pub fn at(&mut self, r: f64) -> Option<Sample> {
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
            // V by its own digits, which the sums over modes have lost.
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
        let sample = Sample {
            limit,
            quadrature,
            displacement: contact.g / all,
            direction,
            tau: place.map(|place| place.tau),
        };
        self.seen.insert(r.to_bits(), sample);
        Some(sample)
    }

    /// Whether little is left of the sum V: beside its zeros.
    fn cancels(&self, at: &At<&Reduced<f64>>) -> bool {
        let chain = &self.reduced.chain;
        let contact = at.contact_sums();
        let at_rest = chain.on_moving_base.map(f64::abs);
        let terms = self.reduced.modes.iter().zip(at.modes()).map(|(mode, at)| {
            let residue = if at_rest.is_some() {
                mode.static_residue
            } else {
                mode.residue
            };
            residue.abs() * complex::modulus(at.response, chain.damped)
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

    /// V and H at r in double-double, by their sums over modes.
    pub fn receptances(&self, r: f64) -> [Complex<Dd>; 2] {
        let (r, two) = (Dd::from(r), Dd::from(2.0));
        let direct = if self.modal.on_moving_base { -1.0 } else { 0.0 };
        let mut excitation = complex::real(Dd::from(direct));
        let mut receptance = complex::real(Dd::ZERO);
        for ContactMode { driven, residue } in &self.contact_modes {
            let re = (driven.sigma - r) * (driven.sigma + r);
            let im = two * driven.zeta * driven.sigma * r;
            let inverse = complex::reciprocal(Complex::new(re, im), true);
            excitation = complex::add(excitation, complex::scale(inverse, *residue));
            receptance = complex::add(receptance, complex::scale(inverse, driven.inverse_mass));
        }
        [excitation, receptance]
    }

    /// A function at r by its place in a table.
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

    /// V as of [`excitation`](Self::excitation), remembered.
    fn known_excitation(&mut self, r: f64) -> f64 {
        let known = self.excitations.get(&r.to_bits()).copied();
        let excitation = known.unwrap_or_else(|| self.excitation(r));
        self.excitations.insert(r.to_bits(), excitation);
        excitation
    }

    /// What the contact's motion follows from, with |V| to the last digits.
    pub fn contact(&mut self, sample: &Sample, r: f64) -> ContactTable<f64> {
        let excitation = self.known_excitation(r);
        if self.damped() {
            let Sample {
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

    /// β*_lim at r, to the last digits.
    pub fn sliding_limit(&self, r: f64) -> f64 {
        let [excitation, receptance] = self.receptances(r);
        let ratio = complex::modulus(excitation, true) / complex::modulus(receptance, true);
        (ratio / self.modal.stiction).to_f64()
    }

    /// |V| at r, to the last digits; of an undamped chain V with its sign.
    pub fn excitation(&self, r: f64) -> f64 {
        let [excitation, _] = self.receptances(r);
        if self.damped() {
            complex::modulus(excitation, true).to_f64()
        } else {
            excitation.re.to_f64()
        }
    }
}

//! Motions and forces of springs in steady states of scenes with several contacts: relative displacements, velocities,
//! accelerations, and the base shear.

use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::units::AnswerUnits;
use super::waveform::Course;
use crate::study::joints::Series;
use crate::study::response::MotionQuantity;
use crate::{Complex, Of};
use frictiongen_kernel::joints::{Poly, TERMS, extremes, slope};
use frictiongen_model::joined::numbered;
use frictiongen_model::scene::{Excitation, Node, Scene};
use std::f64::consts::TAU;

/// A sum of relative displacements, each times a factor, or a derivative of this sum.
#[derive(Clone, Debug)]
pub(in crate::study) struct Combination {
    /// Factor, and the numbers of the nodes with a positive and a negative sign.
    terms: Vec<(f64, usize, usize)>,
    /// Order of the derivative with respect to the phase τ.
    order: usize,
    is_force: bool,
    /// Number of the node of the base.
    base: usize,
    is_base_driven: bool,
}

impl Combination {
    /// Returns the quantity of a motion. Returns `None` for a force in a contact, an energy or a damping ratio.
    pub fn of(scene: &Scene, of: Of, size: MotionQuantity) -> Option<Self> {
        let masses = scene.masses.len();
        let (wall, base) = (masses, masses + 1);
        let spring = |from: Node, to: Node, stiffness: f64| {
            let (plus, minus) = numbered(masses, from, to)?;
            Some((stiffness, plus, minus))
        };
        let terms = match of {
            Of::Contact => return None,
            Of::ContactAt(index) => {
                let sides = scene.sides_of_contact(index)?;
                let (plus, minus) = numbered(masses, sides.from, sides.to)?;
                let sign = if sides.is_reversed() { -1.0 } else { 1.0 };
                vec![(sign, plus, minus)]
            }
            Of::Mass(mass) => vec![(1.0, mass, wall)],
            Of::Relative(mass, other) => vec![(1.0, mass, other)],
            Of::FromBase(mass) => vec![(1.0, mass, base)],
            Of::Spring(index) => {
                let of = scene.springs.get(index)?;
                vec![spring(of.from, of.to, of.stiffness)?]
            }
            Of::Shear => {
                let springs = scene.springs.iter();
                let on_base =
                    springs.filter(|spring| [spring.from, spring.to].contains(&Node::Base));
                let terms = on_base.filter_map(|of| spring(of.from, of.to, of.stiffness));
                terms.collect()
            }
        };
        let order = match size {
            MotionQuantity::Displacement => 0,
            MotionQuantity::Velocity => 1,
            MotionQuantity::Acceleration => 2,
            MotionQuantity::Force | MotionQuantity::Energy | MotionQuantity::Damping => {
                return None;
            }
        };
        Some(Self {
            terms,
            order,
            is_force: of.is_force(),
            base,
            is_base_driven: scene.excitation == Excitation::Base,
        })
    }

    /// Returns the amplitude in a linear response. `displacement` returns the complex amplitude of a mass over the unit of
    /// displacement.
    pub fn of_linear(
        &self,
        displacement: impl Fn(usize) -> Complex<f64>,
        units: AnswerUnits,
    ) -> f64 {
        let base = if self.is_base_driven { 1.0 } else { 0.0 };
        let node = |node: usize| match node {
            node if node == self.base => Complex::new(base, 0.0),
            node if node + 1 == self.base => Complex::new(0.0, 0.0),
            mass => displacement(mass),
        };
        let terms = self.terms.iter();
        let sum = terms.fold(
            Complex::new(0.0, 0.0),
            |sum: Complex<f64>, (factor, plus, minus)| sum + (node(*plus) - node(*minus)) * *factor,
        );
        self.in_force(sum.norm(), units)
    }

    /// Returns an upper bound on the largest absolute value of a motion in which each mass has its largest displacement
    /// in `largest`. Rates count as those of a harmonic motion.
    pub fn at_most(&self, largest: &[f64], units: AnswerUnits) -> f64 {
        let base = if self.is_base_driven { 1.0 } else { 0.0 };
        let node = |node: usize| match largest.get(node) {
            Some(size) => *size,
            None if node == self.base => base,
            None => 0.0,
        };
        let terms = self.terms.iter();
        let sum = terms.map(|(factor, plus, minus)| factor * (node(*plus) + node(*minus)));
        self.in_force(sum.sum(), units)
    }

    /// Converts a displacement over its unit to a force over its unit, if the quantity is a force.
    fn in_force(&self, value: f64, units: AnswerUnits) -> f64 {
        if self.is_force {
            value * units.length / units.force
        } else {
            value
        }
    }

    /// Converts the largest value of the quantity in the units of the description to the units of the results.
    pub fn in_units(&self, largest: f64, (omega, units): (f64, AnswerUnits)) -> f64 {
        let rates = omega.powi(i32::try_from(self.order).unwrap_or(0));
        let unit = if self.is_force {
            units.force
        } else {
            units.length
        };
        largest / (rates * unit)
    }

    /// Returns the power series of the quantity in a stretch.
    pub fn terms_of(&self, series: &Series) -> Poly<f64> {
        let mut sum = [0.0; TERMS];
        for (factor, plus, minus) in &self.terms {
            let terms = match self.order {
                0 => series.place_terms(*plus, *minus),
                1 => series.speed_terms(*plus, *minus),
                _ => slope(&series.speed_terms(*plus, *minus)).map(|term| term / series.length),
            };
            for (sum, term) in sum.iter_mut().zip(terms) {
                *sum += factor * term;
            }
        }
        sum
    }
}

/// Returns the point between 0 and `end` at which a polynomial has its largest absolute value, and its value there.
pub fn extreme_between(terms: &Poly<f64>, end: f64) -> (f64, f64) {
    let mut most = (0.0, 0.0_f64);
    extremes(terms, end, |at, value| {
        if most.1.abs() < value.abs() {
            most = (at, value);
        }
    });
    most
}

impl JoinedOrbit<'_> {
    /// Returns the largest absolute value of a quantity in a period, as [`largest_of`](Self::largest_of) does for several.
    ///
    /// # Errors
    /// Same errors as [`largest_of`](Self::largest_of).
    pub fn largest(&self, of: Of, size: MotionQuantity) -> Result<f64, JoinedError> {
        let largest = self.largest_of(&[(of, size)])?;
        largest.first().copied().ok_or(JoinedError::Quantity)
    }

    /// Returns the largest absolute value of each quantity in a period: of a displacement, of its derivative with respect
    /// to τ, of the force in a spring, or of the force in a contact. For the displacement of a mass this is its
    /// [`amplitude`](Self::amplitude). An energy is that which a contact dissipates in a cycle of the load, and a damping
    /// ratio is that of [`MotionQuantity::Damping`].
    ///
    /// # Errors
    /// [`JoinedError::Quantity`] for a quantity that the motion does not have, and [`JoinedError::Engine`] if the solver
    /// does not support the chain.
    pub fn largest_of(&self, quantities: &[(Of, MotionQuantity)]) -> Result<Vec<f64>, JoinedError> {
        let (joined, omega, units) = self.setting();
        let amplitudes = self.amplitudes();
        let damping = quantities
            .iter()
            .filter(|(_, size)| *size == MotionQuantity::Damping)
            .map(|(of, _)| Ok((*of, self.damping(*of)?)))
            .collect::<Result<Vec<_>, JoinedError>>()?;
        let known = |&(of, size): &(Of, MotionQuantity)| match (of, size) {
            (Of::Mass(mass), MotionQuantity::Displacement) => amplitudes.get(mass).copied(),
            (Of::ContactAt(index), MotionQuantity::Displacement) => {
                Some(self.contacts().nth(index)?.displacement())
            }
            (Of::ContactAt(index), MotionQuantity::Force) => {
                Some(self.contacts().nth(index)?.force())
            }
            (Of::ContactAt(index), MotionQuantity::Energy) => self.energy_of_cycle(index),
            (of, MotionQuantity::Damping) => damping
                .iter()
                .find(|found| found.0 == of)
                .map(|found| found.1),
            _ => None,
        };
        let mut followed = Vec::new();
        for quantity in quantities
            .iter()
            .filter(|quantity| known(quantity).is_none())
        {
            let combination = Combination::of(joined.scene(), quantity.0, quantity.1);
            followed.push((combination.ok_or(JoinedError::Quantity)?, 0.0_f64));
        }
        if !followed.is_empty() {
            let period = TAU / omega * self.period() as f64;
            self.motion()?.run(period, &mut |series, end, _| {
                for (combination, largest) in &mut followed {
                    let (_, value) = extreme_between(&combination.terms_of(series), end);
                    *largest = largest.max(value.abs());
                }
            })?;
        }
        let mut followed = followed.into_iter();
        let values = quantities.iter().map(|quantity| {
            known(quantity).or_else(|| {
                let (combination, largest) = followed.next()?;
                Some(combination.in_units(largest, (omega, units)))
            })
        });
        values.collect::<Option<_>>().ok_or(JoinedError::Quantity)
    }

    /// Returns the energy that a contact dissipates in a cycle of the load.
    fn energy_of_cycle(&self, contact: usize) -> Option<f64> {
        Some(self.contacts().nth(contact)?.energy() / self.period() as f64)
    }

    /// Returns the equivalent viscous damping ratio of all contacts, or of one contact if `of` is this contact. The strain
    /// energy is that of all springs, or of one spring if `of` is this spring. The ratio is 0 if no spring is deformed.
    fn damping(&self, of: Of) -> Result<f64, JoinedError> {
        let (joined, _, units) = self.setting();
        let scene = joined.scene();
        let energies = (0..self.contacts().count()).filter(|index| match of {
            Of::ContactAt(own) => own == *index,
            _ => true,
        });
        let energies = energies.filter_map(|index| self.energy_of_cycle(index));
        let springs: Vec<usize> = match of {
            Of::Spring(index) => vec![index],
            Of::Contact | Of::ContactAt(_) => (0..scene.springs.len()).collect(),
            _ => return Err(JoinedError::Quantity),
        };
        let courses = springs
            .iter()
            .map(|index| Course::of(joined, Of::Spring(*index), MotionQuantity::Displacement));
        let courses = courses.collect::<Option<Vec<_>>>();
        let forces = self.waveforms(&courses.ok_or(JoinedError::Quantity)?)?;
        let strains = springs.iter().zip(&forces).filter_map(|(index, force)| {
            let stiffness = scene.springs.get(*index)?.stiffness * units.length / units.force;
            let force = force.centred_amplitude();
            Some(0.5 * force * force / stiffness)
        });
        let (energy, strain): (f64, f64) = (energies.sum(), strains.sum());
        Ok(if strain > 0.0 {
            energy / (2.0 * TAU * strain)
        } else {
            0.0
        })
    }
}

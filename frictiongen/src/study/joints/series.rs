//! The power series of the motion over one stretch.

use super::Wave;
use super::model::{Model, add, at};
use super::roots::value;
use super::run::{FREE, STUCK, State};
use super::tree::{Tree, set};

/// Terms of a series. Over one radian the first term left out is below 1/22! = 1e-21 of the first.
pub const TERMS: usize = 22;

/// The terms of one quantity over a stretch, in the fraction of the stretch.
pub type Poly = [f64; TERMS];

/// Returns the terms of a wave or of its derivatives over a stretch.
pub fn wave_terms(wave: &Wave, time: f64, length: f64, derivative: usize) -> Poly {
    let angle = wave.omega * time + wave.phase;
    let (sin, cos) = angle.sin_cos();
    let derivatives = [cos, -sin, -cos, sin];
    let mut factor = wave.amplitude * wave.omega.powi(derivative as i32);
    let mut terms = [0.0; TERMS];
    for (order, term) in terms.iter_mut().enumerate() {
        *term = factor * at(&derivatives, (order + derivative) % 4);
        factor *= wave.omega * length / (order + 1) as f64;
    }
    let line = match derivative {
        0 => [wave.constant + wave.slope * time, wave.slope * length],
        1 => [wave.slope, 0.0],
        _ => [0.0, 0.0],
    };
    for (term, line) in terms.iter_mut().zip(line) {
        *term += line;
    }
    terms
}

/// The motion over one stretch.
#[derive(Clone, Debug)]
pub struct Series {
    /// Start of the stretch.
    pub start: f64,
    /// Length of the stretch.
    pub length: f64,
    x: Vec<Poly>,
    v: Vec<Poly>,
    forces: Vec<Poly>,
}

impl Series {
    /// Computes the series from a state.
    pub fn new(model: &Model, state: &State, tree: &Tree, span: (f64, f64)) -> Self {
        let (start, length) = span;
        let nodes = model.masses.len() + 2;
        let base: [Poly; 3] = [0, 1, 2].map(|d| wave_terms(&model.base, start, length, d));
        let [place, speed, lift] = &base;
        let (mut x, mut v) = (state.x.clone(), state.v.clone());
        x.extend([0.0, at(place, 0)]);
        v.extend([0.0, at(speed, 0)]);
        tree.place(&mut x, &mut v, &state.places);
        let loads = model.load_terms(start, length);
        let mut series = Self {
            start,
            length,
            x: vec![[0.0; TERMS]; nodes],
            v: vec![[0.0; TERMS]; nodes],
            forces: contact_levels(model, state, span),
        };
        for order in 0..TERMS {
            keep(&mut series.x, order, &x);
            keep(&mut series.v, order, &v);
            let terms: Vec<f64> = loads.iter().map(|load| at(load, order)).collect();
            let mut forces = model.forces(&x, &v, &terms, None);
            for (contact, terms) in model.contacts.iter().zip(&series.forces) {
                contact.pull(&mut forces, at(terms, order));
            }
            let mut holds = vec![f64::NAN; model.contacts.len()];
            let a = tree.accelerate(model, &forces, at(lift, order), &mut holds);
            let next = length / (order + 1) as f64;
            for (j, contact) in model.contacts.iter().enumerate() {
                let Some(terms) = series.forces.get_mut(j) else {
                    continue;
                };
                if state.phase(j) != STUCK {
                    continue;
                }
                match contact.stiffness {
                    None => set(terms, order, at(&holds, j)),
                    Some(stiffness) => set(terms, order + 1, stiffness * next * contact.across(&v)),
                }
            }
            x = v.iter().map(|v| next * v).collect();
            v = a.iter().map(|a| next * a).collect();
        }
        series
    }

    /// Returns displacements and velocities of the masses at a fraction of the stretch.
    pub fn motion(&self, fraction: f64) -> (Vec<f64>, Vec<f64>) {
        let masses = self.x.len().saturating_sub(2);
        let values = |terms: &[Poly]| {
            let terms = terms.iter().take(masses);
            terms.map(|terms| value(terms, fraction)).collect()
        };
        (values(&self.x), values(&self.v))
    }

    /// Returns the displacement and the velocity of the base at a fraction of the stretch.
    pub fn base(&self, fraction: f64) -> (f64, f64) {
        let last = |terms: &[Poly]| terms.last().map_or(0.0, |terms| value(terms, fraction));
        (last(&self.x), last(&self.v))
    }

    /// Returns the force of a contact at a fraction of the stretch.
    pub fn force(&self, contact: usize, fraction: f64) -> f64 {
        self.forces
            .get(contact)
            .map_or(0.0, |terms| value(terms, fraction))
    }

    /// Returns the terms of the force of a contact.
    pub fn force_terms(&self, contact: usize) -> Poly {
        self.forces.get(contact).copied().unwrap_or([0.0; TERMS])
    }

    /// Returns the terms of the relative velocity of a contact.
    pub fn speed_terms(&self, plus: usize, minus: usize) -> Poly {
        difference(&self.v, plus, minus)
    }

    /// Returns the terms of the displacement of a mass.
    pub fn displacement_terms(&self, mass: usize) -> Poly {
        self.x.get(mass).copied().unwrap_or([0.0; TERMS])
    }

    /// Returns the terms of the velocity of a mass.
    pub fn velocity_terms(&self, mass: usize) -> Poly {
        self.v.get(mass).copied().unwrap_or([0.0; TERMS])
    }

    /// Returns the terms of the relative displacement of two nodes.
    pub fn place_terms(&self, plus: usize, minus: usize) -> Poly {
        difference(&self.x, plus, minus)
    }

    /// Returns the relative displacement of two nodes at a fraction of the stretch.
    pub fn place(&self, (plus, minus): (usize, usize), fraction: f64) -> f64 {
        value(&difference(&self.x, plus, minus), fraction)
    }
}

/// Subtracts the terms of two nodes.
fn difference(nodes: &[Poly], plus: usize, minus: usize) -> Poly {
    let mut terms = nodes.get(plus).copied().unwrap_or([0.0; TERMS]);
    for (order, term) in nodes.get(minus).into_iter().flatten().enumerate() {
        add(&mut terms, order, -term);
    }
    terms
}

/// Stores one order of all nodes.
fn keep(series: &mut [Poly], order: usize, values: &[f64]) {
    for (terms, value) in series.iter_mut().zip(values) {
        set(terms, order, *value);
    }
}

/// Returns the terms of the forces that are known beforehand: those of sliding contacts, and the first of elastic ones.
fn contact_levels(model: &Model, state: &State, (start, length): (f64, f64)) -> Vec<Poly> {
    let contacts = model.contacts.iter().enumerate();
    let levels = contacts.map(|(j, contact)| {
        let phase = state.phase(j);
        let mut terms = [0.0; TERMS];
        if phase == FREE {
            return terms;
        }
        if phase == STUCK {
            if !contact.is_rigid() {
                set(&mut terms, 0, at(&state.forces, j));
            }
            return terms;
        }
        terms = wave_terms(&contact.level, start, length, 0);
        terms.map(|term| f64::from(phase) * term)
    });
    levels.collect()
}

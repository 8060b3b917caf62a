//! Amplitudes of the masses, and stops, slip, force and energy of the contacts, over one period of a motion.

use super::model::{Model, add};
use super::roots::{first_negative, value};
use super::run::{STUCK, State, Transition};
use super::series::{Poly, Series, TERMS};

/// Events, slip, force and energy of one contact over a period.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactCycle {
    /// Number of transitions from sliding to sticking.
    pub stops: usize,
    /// Number of transitions from sliding in one direction to sliding in the other.
    pub reversals: usize,
    /// Fraction of the period in which the contact sticks.
    pub stuck_fraction: f64,
    /// Distance that the slider travels, in both directions together.
    pub slip: f64,
    /// Largest absolute relative displacement.
    pub displacement: f64,
    /// Largest absolute force.
    pub force: f64,
    /// Energy that friction dissipates in the contact.
    pub energy: f64,
}

/// Amplitudes of the masses, and results of each contact, over a period.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cycle {
    /// Largest |x| of each mass.
    pub amplitudes: Vec<f64>,
    /// Half the distance between the least and the largest displacement of each mass. A constant velocity is taken out
    /// beforehand where nothing holds the mass.
    pub centred: Vec<f64>,
    /// Result of each contact, in the order of the chain.
    pub contacts: Vec<ContactCycle>,
    /// Number of instants with an event.
    pub events: usize,
}

/// Collects the results of a period, stretch by stretch.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    ends: Vec<(usize, usize)>,
    cycle: Cycle,
    slides: Vec<bool>,
    /// The least and the largest displacement of each mass.
    spans: Vec<(f64, f64)>,
    /// A velocity of each mass that is taken out of its displacement.
    drifts: Vec<f64>,
    /// The time that was seen.
    passed: f64,
}

impl Watch {
    /// Starts a period.
    pub fn new(model: &Model) -> Self {
        let contacts = model.contacts.len();
        Self {
            ends: model.contacts.iter().map(|c| (c.plus, c.minus)).collect(),
            cycle: Cycle {
                amplitudes: vec![0.0; model.masses.len()],
                centred: Vec::new(),
                contacts: vec![ContactCycle::default(); contacts],
                events: 0,
            },
            slides: vec![false; contacts],
            spans: vec![(f64::INFINITY, f64::NEG_INFINITY); model.masses.len()],
            drifts: vec![0.0; model.masses.len()],
            passed: 0.0,
        }
    }

    /// Starts a period in which each mass has a constant velocity besides its vibration.
    pub fn drifting(model: &Model, drifts: Vec<f64>) -> Self {
        Self {
            drifts,
            ..Self::new(model)
        }
    }

    /// Returns for each contact whether it has slid.
    pub fn slides(&self) -> Vec<bool> {
        self.slides.clone()
    }

    /// Adds a stretch of the motion, from its start to `end`.
    pub fn see(&mut self, series: &Series, end: f64, state: &State) {
        for (mass, amplitude) in self.cycle.amplitudes.iter_mut().enumerate() {
            let most = largest(
                &series.displacement_terms(mass),
                &series.velocity_terms(mass),
                end,
            );
            *amplitude = amplitude.max(most);
        }
        let masses = self.spans.iter_mut().zip(&self.drifts).enumerate();
        for (mass, (span, drift)) in masses {
            let mut x = series.displacement_terms(mass);
            let mut v = series.velocity_terms(mass).map(|term| series.length * term);
            add(&mut x, 0, -drift * self.passed);
            add(&mut x, 1, -drift * series.length);
            add(&mut v, 0, -drift * series.length);
            for value in extremes(&x, &v, end) {
                *span = (span.0.min(value), span.1.max(value));
            }
        }
        self.passed += end * series.length;
        let contacts = self
            .cycle
            .contacts
            .iter_mut()
            .zip(&self.ends)
            .zip(&mut self.slides);
        for (j, ((contact, &(plus, minus)), slides)) in contacts.enumerate() {
            let force = series.force_terms(j);
            contact.force = contact.force.max(largest(&force, &slope(&force), end));
            let place = series.place_terms(plus, minus);
            let most = largest(&place, &series.speed_terms(plus, minus), end);
            contact.displacement = contact.displacement.max(most);
            if state.phase(j) == STUCK {
                contact.stuck_fraction += end * series.length;
                continue;
            }
            *slides |= end > 0.0;
            let speed = series.speed_terms(plus, minus);
            contact.slip += series.length * integral(&speed, end).abs();
            contact.energy += series.length * integral(&product(&force, &speed), end);
        }
    }

    /// Adds the events of a cycle.
    pub fn events(&mut self, events: &[Transition]) {
        self.cycle.events += events.len();
        for event in events {
            let phases = event.before.iter().zip(&event.after);
            for (contact, (&before, &after)) in self.cycle.contacts.iter_mut().zip(phases) {
                contact.stops += usize::from(before != STUCK && after == STUCK);
                contact.reversals += usize::from(before * after == -1);
            }
        }
    }

    /// Returns the results after a period of this length.
    pub fn cycle(mut self, length: f64) -> Cycle {
        for contact in &mut self.cycle.contacts {
            contact.stuck_fraction /= length;
        }
        let spans = self.spans.iter();
        self.cycle.centred = spans.map(|(least, most)| 0.5 * (most - least)).collect();
        self.cycle
    }
}

/// Returns the largest absolute value of a quantity, whose slope is known up to a factor, from 0 to `end`.
fn largest(terms: &Poly, slope: &Poly, end: f64) -> f64 {
    let values = extremes(terms, slope, end);
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}

/// Returns the values of a quantity at 0, at `end`, and where its slope changes its sign between them.
fn extremes(terms: &Poly, slope: &Poly, end: f64) -> [f64; 3] {
    let rises = slope
        .iter()
        .find(|&&term| term != 0.0)
        .is_some_and(|&term| term > 0.0);
    let turn = first_negative(&slope.map(|term| if rises { term } else { -term }), 0);
    let turn = turn.map_or(end, |turn| turn.min(end));
    [0.0, end, turn].map(|at| value(terms, at))
}

/// Returns the terms of the derivative.
fn slope(terms: &Poly) -> Poly {
    let mut slope = [0.0; TERMS];
    for (order, (slope, term)) in slope.iter_mut().zip(terms.iter().skip(1)).enumerate() {
        *slope = (order + 1) as f64 * term;
    }
    slope
}

/// Returns the integral of a polynomial from 0 to `end`.
fn integral(terms: &[f64], end: f64) -> f64 {
    let terms = terms.iter().enumerate().rev();
    terms.fold(0.0, |sum, (order, term)| {
        (sum + term / (order + 1) as f64) * end
    })
}

/// Returns the terms of a product.
fn product(a: &Poly, b: &Poly) -> Vec<f64> {
    let mut product = vec![0.0; 2 * TERMS];
    for (i, a) in a.iter().enumerate() {
        for (sum, b) in product.iter_mut().skip(i).zip(b) {
            *sum += a * b;
        }
    }
    product
}

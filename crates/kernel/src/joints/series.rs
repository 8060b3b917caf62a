//! Power series of the motion over one *stretch*: the time interval over which the solver uses one power series.

use super::model::{Contact, Model, Sides, Stop};
use super::poly::{Poly, nothing, terms_of, value};
use super::size::{Size, add, at, set};
use super::state::{FREE, STUCK, State};
use super::tree::Tree;
use crate::Float;

/// Power series of the motion of all nodes over one time interval. The nodes are the masses, the wall and the base.
#[derive(Clone, Debug)]
pub struct Series<S: Float, Z: Size> {
    /// Time at the start of the time interval.
    pub start: S,
    /// Duration of the time interval.
    pub length: S,
    /// Number of coefficients. All further coefficients are 0.
    pub(super) count: usize,
    x: Z::Nodes<Poly<S>>,
    v: Z::Nodes<Poly<S>>,
    forces: Z::Contacts<Poly<S>>,
}

impl<S: Float, Z: Size> Series<S, Z> {
    /// Computes the power series of the motion from the state at the start of the time interval. `tree` contains the
    /// groups of masses that sticking rigid contacts connect.
    pub fn new(
        model: &Model<S, Z>,
        state: &State<S, Z>,
        tree: &Tree<S, Z>,
        (start, length): (S, S),
    ) -> Self {
        let (mut x, mut v) = state.nodes(model, start);
        tree.place_moving(model, (x.as_mut(), v.as_mut()), state.places.as_ref());
        let lift = model.base.terms(start, length, 2);
        let mut loads = model.size.loads(nothing());
        for (terms, load) in loads
            .as_mut()
            .iter_mut()
            .zip(model.load_terms(start, length))
        {
            *terms = load;
        }
        let count = model.terms_within(length, if model.base.bends() { 3 } else { 2 });
        let mut series = Self {
            count,
            forces: contact_levels(model, state, (start, length)),
            ..Self::nothing(model, (start, length))
        };
        let zero = S::constant(0.0);
        let (mut forces, mut rest) = (model.size.nodes(zero), model.size.nodes(zero));
        let (mut a, mut holds) = (model.size.nodes(zero), model.size.contacts(zero));
        for order in 0..count {
            keep(series.x.as_mut(), order, x.as_ref());
            keep(series.v.as_mut(), order, v.as_ref());
            let load = |index| term(loads.as_ref(), index, order);
            forces.as_mut().fill(zero);
            model.put_forces(x.as_ref(), v.as_ref(), load, |node, value| {
                add(forces.as_mut(), node, value);
            });
            series.follow_lines(model, state, order);
            for (contact, terms) in model.contacts().iter().zip(series.forces.as_ref()) {
                contact.pull(forces.as_mut(), at(terms, order));
            }
            model.pull_dashpots(state, v.as_ref(), forces.as_mut());
            let known = (forces.as_ref(), at(&lift, order));
            let results = (a.as_mut(), holds.as_mut());
            tree.accelerate_in(model, known, rest.as_mut(), results);
            let next = length / S::whole(order + 1);
            let contacts = model.contacts().iter().zip(series.forces.as_mut());
            for (j, (contact, terms)) in contacts.enumerate() {
                match contact.stiffness {
                    _ if state.phase(j) != STUCK => {}
                    None => set(terms, order, at(holds.as_ref(), j)),
                    Some(stiffness) => {
                        let speed = if order == 0 {
                            model.slip(contact, v.as_ref())
                        } else {
                            contact.across(v.as_ref())
                        };
                        let rate = stiffness * next * speed;
                        if order + 1 < count {
                            set(terms, order + 1, rate);
                        }
                    }
                }
            }
            for ((x, v), a) in x.as_mut().iter_mut().zip(v.as_mut()).zip(a.as_ref()) {
                *x = next * *v;
                *v = next * *a;
            }
        }
        series
    }

    /// Returns a power series whose coefficients are 0.
    pub(super) fn nothing(model: &Model<S, Z>, (start, length): (S, S)) -> Self {
        Self {
            start,
            length,
            count: terms_of::<S>(),
            x: model.size.nodes(nothing()),
            v: model.size.nodes(nothing()),
            forces: model.size.contacts(nothing()),
        }
    }

    /// Sets the coefficients of one order. `motion` contains those of the displacements and of the velocities of the masses,
    /// `base` those of the base, and `forces` those of the contacts.
    pub(super) fn put(&mut self, order: usize, motion: &[S], (base, forces): ([S; 2], &[S])) {
        let masses = self.x.as_ref().len().saturating_sub(2);
        let (places, rest) = motion.split_at_checked(masses).unwrap_or_default();
        let speeds = rest.get(..masses).unwrap_or_default();
        let [place, speed] = base;
        for (series, values, of_base) in
            [(&mut self.x, places, place), (&mut self.v, speeds, speed)]
        {
            keep(series.as_mut(), order, values);
            if let Some(terms) = series.as_mut().last_mut() {
                set(terms, order, of_base);
            }
        }
        keep(self.forces.as_mut(), order, forces);
    }

    /// Sets the coefficient of the given order in the force of each sliding contact whose friction depends on the
    /// speed.
    fn follow_lines(&mut self, model: &Model<S, Z>, state: &State<S, Z>, order: usize) {
        for (j, contact) in model.contacts().iter().enumerate() {
            let side = state.phase(j);
            if [STUCK, FREE].contains(&side) || !model.has_lines(contact) {
                continue;
            }
            let speeds = self.slip_terms(contact.sides());
            let line = model.line(contact, at(&speeds, 0));
            let time = (self.start, self.length);
            let force = model.force_term(contact, (&line, side), time, (&speeds, order));
            if let Some(terms) = self.forces.as_mut().get_mut(j) {
                set(terms, order, force);
            }
        }
    }

    /// Returns the displacements and the velocities of the masses after the given fraction of the time interval.
    pub fn motion(&self, model: &Model<S, Z>, fraction: S) -> (Z::Masses<S>, Z::Masses<S>) {
        let values = |series: &[Poly<S>]| {
            let mut values = model.size.masses(S::constant(0.0));
            for (mass, of_mass) in values.as_mut().iter_mut().enumerate() {
                *of_mass = value(self.used(series, mass), fraction);
            }
            values
        };
        (values(self.x.as_ref()), values(self.v.as_ref()))
    }

    /// Returns the displacement and the velocity of the base after the given fraction of the time interval.
    pub fn base(&self, fraction: S) -> (S, S) {
        let last = |terms: &[Poly<S>]| {
            let terms = terms.last();
            terms.map_or(S::constant(0.0), |terms| value(terms, fraction))
        };
        (last(self.x.as_ref()), last(self.v.as_ref()))
    }

    /// Returns the force of a contact after the given fraction of the time interval.
    pub fn force(&self, contact: usize, fraction: S) -> S {
        value(self.used(self.forces.as_ref(), contact), fraction)
    }

    /// Returns the used coefficients of one power series.
    fn used<'s>(&self, series: &'s [Poly<S>], index: usize) -> &'s [S] {
        let terms = series.get(index);
        terms.map_or(&[], |terms| self.used_of(terms))
    }

    /// Returns the used coefficients of a power series over the same time interval.
    pub(super) fn used_of<'s>(&self, terms: &'s Poly<S>) -> &'s [S] {
        terms.get(..self.count).unwrap_or(terms)
    }

    /// Returns the power series of the force of a contact over the time interval.
    pub fn force_terms(&self, contact: usize) -> Poly<S> {
        terms(self.forces.as_ref(), contact)
    }

    /// Returns the power series of the velocity of the node `plus` minus that of the node `minus`.
    pub fn speed_terms(&self, plus: usize, minus: usize) -> Poly<S> {
        self.difference(self.v.as_ref(), plus, minus)
    }

    /// Returns the power series of the relative velocity of a contact over the time interval.
    pub(super) fn slip_terms(&self, sides: Sides<S>) -> Poly<S> {
        let mut terms = self.speed_terms(sides.plus, sides.minus);
        if Z::HAS_PARTS {
            add(&mut terms, 0, -sides.speed);
        }
        terms
    }

    /// Returns the power series of the distance by which a stop is open. It is negative where the stop acts.
    pub(super) fn opening_terms(&self, contact: &Contact<S>, stop: &Stop<S>) -> Poly<S> {
        let terms = self.place_terms(contact.plus, contact.minus);
        let mut opening = terms.map(|term| -stop.side * term);
        add(&mut opening, 0, stop.gap);
        opening
    }

    /// Returns the power series of the displacement of a mass over the time interval.
    pub fn displacement_terms(&self, mass: usize) -> Poly<S> {
        terms(self.x.as_ref(), mass)
    }

    /// Returns the power series of the velocity of a mass over the time interval.
    pub fn velocity_terms(&self, mass: usize) -> Poly<S> {
        terms(self.v.as_ref(), mass)
    }

    /// Returns the power series of the displacement of the node `plus` minus that of the node `minus`.
    pub fn place_terms(&self, plus: usize, minus: usize) -> Poly<S> {
        self.difference(self.x.as_ref(), plus, minus)
    }

    /// Returns the power series of the displacements and velocities of all nodes.
    pub(super) fn nodes(&self) -> (&[Poly<S>], &[Poly<S>]) {
        (self.x.as_ref(), self.v.as_ref())
    }

    /// Returns the coefficients of the node `plus` minus those of the node `minus`.
    fn difference(&self, nodes: &[Poly<S>], plus: usize, minus: usize) -> Poly<S> {
        let mut difference = terms(nodes, plus);
        for (term, other) in difference.iter_mut().zip(self.used(nodes, minus)) {
            *term = *term - *other;
        }
        difference
    }

    /// Returns the displacement of a node at the start of the time interval.
    pub(super) fn displacement_at_start(&self, node: usize) -> S {
        term(self.x.as_ref(), node, 0)
    }

    /// Returns the velocity of a node at the start of the time interval.
    pub(super) fn speed_at_start(&self, node: usize) -> S {
        term(self.v.as_ref(), node, 0)
    }

    /// Returns the displacement of the node `plus` minus that of the node `minus`, after the given fraction of the time
    /// interval.
    pub fn place(&self, (plus, minus): (usize, usize), fraction: S) -> S {
        let terms = self.place_terms(plus, minus);
        value(self.used_of(&terms), fraction)
    }
}

/// Returns the coefficients of the power series with the given index, or zeros for an invalid index.
fn terms<S: Float>(series: &[Poly<S>], index: usize) -> Poly<S> {
    series.get(index).copied().unwrap_or(nothing())
}

/// Returns one coefficient of the power series with the given index, or 0 for an invalid index.
fn term<S: Float>(series: &[Poly<S>], index: usize, order: usize) -> S {
    let terms = series.get(index);
    terms.map_or(S::constant(0.0), |terms| at(terms, order))
}

/// Stores the coefficient of the given order in the power series of each node.
fn keep<S: Float>(series: &mut [Poly<S>], order: usize, values: &[S]) {
    for (terms, value) in series.iter_mut().zip(values) {
        set(terms, order, *value);
    }
}

/// Returns the power series of the contact forces that do not depend on the motion. These are the forces of sliding
/// contacts, and the initial forces of sticking elastic contacts. If the friction of a sliding contact depends on the
/// speed, `follow_lines` later replaces its force.
fn contact_levels<S: Float, Z: Size>(
    model: &Model<S, Z>,
    state: &State<S, Z>,
    (start, length): (S, S),
) -> Z::Contacts<Poly<S>> {
    let mut levels = model.size.contacts(nothing());
    let contacts = model.contacts().iter().zip(levels.as_mut());
    for (j, (contact, terms)) in contacts.enumerate() {
        match state.phase(j) {
            FREE => {}
            STUCK if contact.is_rigid() => {}
            STUCK => set(terms, 0, at(state.forces.as_ref(), j)),
            side => {
                *terms = contact.level.terms(start, length, 0);
                for term in terms.iter_mut().filter(|_| side < 0) {
                    *term = -*term;
                }
            }
        }
    }
    levels
}

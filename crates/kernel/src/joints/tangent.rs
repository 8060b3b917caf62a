//! Derivatives of a motion with respect to its initial state. This module computes them for chains in which all
//! contacts are elastic with μ = 1.
//!
//! Between two events, a small deviation from a motion satisfies the homogeneous linear equations. At an event of an
//! elastic contact with μ = 1, the force, the displacements, the velocities and the accelerations do not jump. The
//! deviations of displacements and velocities therefore do not jump either. The deviation of the force is 0 while the
//! contact slides, and starts from 0 when the contact sticks again.

use super::model::Model;
use super::poly::terms_of;
use super::run::Observe;
use super::series::Series;
use super::size::{Size, at};
use super::state::{STUCK, State};
use super::unknowns::Unknowns;
use crate::Float;

/// Duration of a shot (a motion that the shooting method follows).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ShotSpan {
    /// The shot lasts half a cycle of the load. The code then multiplies the state by −1. A motion that repeats with
    /// the opposite sign after half a cycle therefore ends in its initial state.
    Half,
    /// The shot lasts the given number of cycles of the load.
    Cycles(usize),
}

/// Observer of a motion that advances one small deviation for each unknown of a steady state.
pub(super) struct Tangent<'m, S: Float, Z: Size> {
    model: &'m Model<S, Z>,
    /// Deviations from the motion, with one column for each unknown. The rows are the displacements of the masses, the
    /// velocities of the masses, and the forces of the contacts.
    rows: Z::Square<S>,
    /// Coefficients of one order in the power series of the deviations in `rows`.
    term: Z::Square<S>,
    /// Deviations of the forces on the masses, with one row for each mass and one column for each unknown.
    forces: Z::Square<S>,
    /// Number of columns of each matrix. Each mass has one column for its displacement and one for its velocity, and
    /// each contact has one column.
    width: usize,
}

impl<'m, S: Float, Z: Size> Tangent<'m, S, Z> {
    /// Returns true if this observer can compute the derivatives for all contacts of a chain. This is possible if all
    /// contacts are elastic with μ = 1.
    pub(super) fn follows(model: &Model<S, Z>) -> bool {
        let one = S::constant(1.0);
        let mut contacts = model.contacts().iter();
        contacts.all(|contact| !contact.is_rigid() && contact.stiction == one)
    }

    /// Starts to observe a motion at a state. Each column begins with a deviation of 1 in the unknown of the column.
    pub(super) fn new(
        model: &'m Model<S, Z>,
        state: &State<S, Z>,
        unknowns: &Unknowns<'_, S, Z>,
    ) -> Self {
        let zero = S::constant(0.0);
        let mut tangent = Self {
            model,
            rows: model.size.square(zero),
            term: model.size.square(zero),
            forces: model.size.square(zero),
            width: 2 * model.wall() + model.contacts().len(),
        };
        let masses = model.wall();
        for mass in 0..masses {
            tangent.put(mass, mass, unknowns.place);
            tangent.put(masses + mass, masses + mass, unknowns.speed);
        }
        for (j, contact) in model.contacts().iter().enumerate() {
            let Some(stiffness) = contact.stiffness.filter(|_| state.phase(j) == STUCK) else {
                continue;
            };
            let force = stiffness * unknowns.place;
            for (node, force) in [(contact.plus, force), (contact.minus, -force)] {
                if node < masses {
                    tangent.put(2 * masses + j, node, force);
                }
            }
            tangent.put(2 * masses + j, 2 * masses + j, -force);
        }
        tangent
    }

    /// Sets the deviation in one row and one column.
    fn put(&mut self, row: usize, column: usize, value: S) {
        if let Some(entry) = self.rows.as_mut().get_mut(row * self.width + column) {
            *entry = value;
        }
    }

    /// Returns the deviation in one row and one column, or 0 if the matrix has no such entry.
    fn get(&self, row: usize, column: usize) -> S {
        at(self.rows.as_ref(), row * self.width + column)
    }

    /// Returns the derivatives of the unknowns at the end of a shot with respect to those at its start, column by
    /// column. The position of a contact that does not slide is not an unknown.
    pub(super) fn derivatives(
        &self,
        unknowns: &Unknowns<'_, S, Z>,
        span: ShotSpan,
    ) -> Z::Square<S> {
        let zero = S::constant(0.0);
        let turn = S::constant(if span == ShotSpan::Half { -1.0 } else { 1.0 });
        let mut matrix = self.model.size.square(zero);
        let masses = self.model.wall();
        let size = self.model.size.unknowns(zero).as_ref().len().max(1);
        // `column_of` returns the column of an unknown. A contact has two unknowns. An elastic contact uses the first
        // unknown if the contact slides.
        let column_of = |index: usize| match index.checked_sub(2 * masses) {
            None => Some(index),
            Some(index) if index % 2 == 0 && unknowns.moves(index / 2) => {
                Some(2 * masses + index / 2)
            }
            Some(_) => None,
        };
        for (index, entries) in matrix.as_mut().chunks_exact_mut(size).enumerate() {
            let Some(column) = column_of(index) else {
                continue;
            };
            for (row, entry) in entries.iter_mut().enumerate() {
                let Some(row) = column_of(row) else {
                    continue;
                };
                *entry = turn
                    * if row < masses {
                        self.get(row, column) / unknowns.place
                    } else if row < 2 * masses {
                        self.get(row, column) / unknowns.speed
                    } else {
                        self.slider(row - 2 * masses, column) / unknowns.place
                    };
            }
        }
        matrix
    }

    /// Returns the deviation of the position of an elastic contact's slider.
    fn slider(&self, j: usize, column: usize) -> S {
        let masses = self.model.wall();
        let Some((contact, stiffness)) = self
            .model
            .contact(j)
            .and_then(|contact| Some((contact, contact.stiffness?)))
        else {
            return S::constant(0.0);
        };
        let place = |node: usize| {
            if node < masses {
                self.get(node, column)
            } else {
                S::constant(0.0)
            }
        };
        let force = self.get(2 * masses + j, column);
        place(contact.plus) - place(contact.minus) - force / stiffness
    }

    /// Computes the field `forces`, the deviations of the forces on the masses, for the coefficients in the field
    /// `term`.
    fn sum_forces(&mut self, state: &State<S, Z>) {
        let (width, masses) = (self.width, self.model.wall());
        let Some((xs, vs, fs)) = parts(self.term.as_ref(), masses * width) else {
            return;
        };
        let forces = self.forces.as_mut();
        if let Some(forces) = forces.get_mut(..masses * width) {
            forces.fill(S::constant(0.0));
        }
        let row = |index: usize| index * width..(index + 1) * width;
        let springs = self.model.springs.as_ref().iter().map(|link| (link, xs));
        let dashpots = self.model.dashpots.as_ref().iter().map(|link| (link, vs));
        for (&(plus, minus, value), rows) in springs.chain(dashpots) {
            // The supports (wall and base) have no deviation.
            match (rows.get(row(plus)), rows.get(row(minus))) {
                (Some(one), Some(other)) => {
                    add_difference(forces, plus * width, (one, other, -value));
                    add_difference(forces, minus * width, (one, other, value));
                }
                (Some(one), None) => add_rows(forces, plus * width, (one, -value)),
                (None, Some(other)) => add_rows(forces, minus * width, (other, -value)),
                (None, None) => {}
            }
        }
        for (row_of, coefficients) in self.model.damping_rows().enumerate() {
            for (coefficient, v) in coefficients.iter().zip(vs.chunks_exact(width.max(1))) {
                add_rows(forces, row_of * width, (v, -*coefficient));
            }
        }
        let contacts = self.model.contacts().iter().enumerate();
        for (j, contact) in contacts.filter(|(j, _)| state.phase(*j) == STUCK) {
            let pull = fs.get(row(j)).unwrap_or_default();
            // A factor in `f64` would become an operation of double precision in `f32` code.
            let one = S::constant(1.0);
            for (node, factor) in [(contact.plus, -one), (contact.minus, one)] {
                if node < masses {
                    add_rows(forces, node * width, (pull, factor));
                }
            }
        }
    }

    /// Replaces the coefficients in the field `term` by those of the next order.
    fn raise(&mut self, state: &State<S, Z>, next: S) {
        let (width, masses) = (self.width, self.model.wall());
        let Some((xs, others)) = self.term.as_mut().split_at_mut_checked(masses * width) else {
            return;
        };
        let Some((vs, fs)) = others.split_at_mut_checked(masses * width) else {
            return;
        };
        let size = width.max(1);
        let contacts = self.model.contacts().iter().enumerate();
        for ((j, contact), force) in contacts.zip(fs.chunks_exact_mut(size)) {
            force.fill(S::constant(0.0));
            let Some(stiffness) = contact.stiffness.filter(|_| state.phase(j) == STUCK) else {
                continue;
            };
            for (node, factor) in [(contact.plus, stiffness), (contact.minus, -stiffness)] {
                if let Some(speed) = vs.get(node * width..(node + 1) * width) {
                    add_rows(force, 0, (speed, factor * next));
                }
            }
        }
        for (x, v) in xs.iter_mut().zip(vs.iter()) {
            *x = next * *v;
        }
        let rows = vs
            .chunks_exact_mut(size)
            .zip(self.forces.as_ref().chunks_exact(size));
        for ((speeds, forces), mass) in rows.zip(self.model.masses()) {
            let factor = next / *mass;
            for (v, force) in speeds.iter_mut().zip(forces) {
                *v = factor * *force;
            }
        }
    }
}

/// Divides a matrix into the rows of displacements, of velocities, and of forces.
fn parts<S>(matrix: &[S], size: usize) -> Option<(&[S], &[S], &[S])> {
    let (xs, others) = matrix.split_at_checked(size)?;
    let (vs, fs) = others.split_at_checked(size)?;
    Some((xs, vs, fs))
}

/// Adds a row times `factor` to the row of a matrix that begins at the index `start`.
fn add_rows<S: Float>(matrix: &mut [S], start: usize, (row, factor): (&[S], S)) {
    let entries = matrix.get_mut(start..).unwrap_or_default();
    for (entry, value) in entries.iter_mut().zip(row) {
        *entry = *entry + factor * *value;
    }
}

/// Adds the difference of two rows times `factor` to the row of a matrix that begins at the index `start`.
fn add_difference<S: Float>(matrix: &mut [S], start: usize, (one, other, factor): (&[S], &[S], S)) {
    let entries = matrix.get_mut(start..).unwrap_or_default();
    for (entry, (one, other)) in entries.iter_mut().zip(one.iter().zip(other)) {
        *entry = *entry + factor * (*one - *other);
    }
}

impl<S: Float, Z: Size> Observe<S, Z> for Tangent<'_, S, Z> {
    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        let length = end * series.length;
        let (width, masses) = (self.width, self.model.wall());
        let forces = self.rows.as_mut().get_mut(2 * masses * width..);
        let forces = forces.unwrap_or_default().chunks_exact_mut(width.max(1));
        for (j, force) in forces.enumerate() {
            if state.phase(j) != STUCK {
                force.fill(S::constant(0.0));
            }
        }
        let used = width * width;
        let rows = self.rows.as_mut().get_mut(..used).unwrap_or_default();
        let term = self.term.as_mut().get_mut(..used).unwrap_or_default();
        for (term, row) in term.iter_mut().zip(rows) {
            *term = *row;
        }
        let ratio = length / self.model.stretch;
        let mut size = S::constant(1.0);
        for order in 0..terms_of::<S>() {
            self.sum_forces(state);
            let order = S::whole(order + 1);
            self.raise(state, length / order);
            let rows = self.rows.as_mut().iter_mut().take(used);
            for (sum, term) in rows.zip(self.term.as_ref()) {
                *sum = *sum + *term;
            }
            size = size * ratio / order;
            if size < S::constant(S::EPSILON) {
                return;
            }
        }
    }
}

/// Observer of a motion that consists of two other observers.
pub(super) struct Both<'o, A, B>(pub(super) &'o mut A, pub(super) &'o mut B);

impl<S: Float, Z: Size, A: Observe<S, Z>, B: Observe<S, Z>> Observe<S, Z> for Both<'_, A, B> {
    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        self.0.stretch(series, end, state);
        self.1.stretch(series, end, state);
    }

    fn event(&mut self, time: S, before: &Z::Contacts<i8>, after: &Z::Contacts<i8>) {
        self.0.event(time, before, after);
        self.1.event(time, before, after);
    }
}

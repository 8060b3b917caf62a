//! Linear equations of motion for one set of sticking contacts, as dense matrices.
//!
//! A *deviation* is the difference of two motions that slide in the same directions. It has the coordinates
//! (δx, δv, δf): the displacements and velocities of the masses, and the forces of the contacts. Its width is
//! W = 2N + M for N masses and M contacts.

use super::model::Model;
use super::size::{Size, at, set};
use super::state::{FREE, STUCK, State};
use super::table::Table;
use super::tree::Tree;
use crate::Float;

/// Accelerations and holding forces as linear functions of a deviation, while no contact changes its phase.
#[derive(Clone, Debug)]
pub(super) struct Rates<S: Float, Z: Size> {
    /// Acceleration of each mass: a row of W entries for each mass.
    accelerations: Z::Square<S>,
    /// Force of each rigid contact that sticks: a row of W entries for each contact.
    holds: Z::Square<S>,
    width: usize,
}

/// Forces on the nodes and motion of the base for one coordinate of value 1, with all other coordinates 0.
pub(super) struct UnitMotion<'m, S: Float, Z: Size> {
    model: &'m Model<S, Z>,
    state: &'m State<S, Z>,
    tree: &'m Tree<S, Z>,
    x: Z::Nodes<S>,
    v: Z::Nodes<S>,
    /// Accelerations of all nodes.
    pub(super) accelerations: Z::Nodes<S>,
    /// Forces of the rigid contacts that stick.
    pub(super) holds: Z::Contacts<S>,
}

impl<'m, S: Float, Z: Size> UnitMotion<'m, S, Z> {
    pub(super) fn new(
        model: &'m Model<S, Z>,
        state: &'m State<S, Z>,
        tree: &'m Tree<S, Z>,
    ) -> Self {
        let zero = S::constant(0.0);
        Self {
            model,
            state,
            tree,
            x: model.size.nodes(zero),
            v: model.size.nodes(zero),
            accelerations: model.size.nodes(zero),
            holds: model.size.contacts(zero),
        }
    }

    /// Computes the accelerations and holding forces for displacements `x` and velocities `v` of single nodes, and
    /// unit forces of one load or of one contact.
    pub(super) fn solve(&mut self, time: S, unit: Unit<S>) {
        let (model, state) = (self.model, self.state);
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        self.x.as_mut().fill(zero);
        self.v.as_mut().fill(zero);
        self.holds.as_mut().fill(zero);
        let mut lift = zero;
        let mut load = None;
        match unit {
            Unit::Displacement(mass) => set(self.x.as_mut(), mass, one),
            Unit::Velocity(mass) => set(self.v.as_mut(), mass, one),
            Unit::Base { x, v, a } => {
                let base = model.base_node();
                set(self.x.as_mut(), base, x);
                set(self.v.as_mut(), base, v);
                lift = a;
            }
            Unit::Load(index) => load = Some(index),
            Unit::Contact(_) => {}
        }
        let loads = |index| if load == Some(index) { one } else { zero };
        let mut forces = model.forces(self.x.as_ref(), self.v.as_ref(), loads, None);
        for (j, contact) in model.contacts().iter().enumerate() {
            let force = match state.phase(j) {
                STUCK if contact.is_rigid() => continue,
                _ if matches!(unit, Unit::Contact(other) if other == j) => one,
                STUCK | FREE => continue,
                _ => model.drag(contact, state, time) * contact.across(self.v.as_ref()),
            };
            contact.pull(forces.as_mut(), force);
        }
        model.pull_dashpots(state, self.v.as_ref(), forces.as_mut());
        self.accelerations =
            self.tree
                .accelerate(model, forces.as_ref(), lift, self.holds.as_mut());
    }
}

/// The one coordinate that is not 0.
#[derive(Clone, Copy)]
pub(super) enum Unit<S> {
    /// Displacement of a mass.
    Displacement(usize),
    /// Velocity of a mass.
    Velocity(usize),
    /// Force of a contact.
    Contact(usize),
    /// Value of a load.
    Load(usize),
    /// Displacement, velocity and acceleration of the base.
    Base { x: S, v: S, a: S },
}

impl<S: Float> Unit<S> {
    /// Returns the coordinate of a deviation with the given index.
    pub(super) fn of_deviation<Z: Size>(model: &Model<S, Z>, index: usize) -> Self {
        let masses = model.wall();
        match index.checked_sub(masses) {
            None => Self::Displacement(index),
            Some(mass) if mass < masses => Self::Velocity(mass),
            Some(rest) => Self::Contact(rest - masses),
        }
    }
}

impl<S: Float, Z: Size> Rates<S, Z> {
    /// Computes the matrices for the phases in `state`, at an instant `time`.
    pub(super) fn new(
        model: &Model<S, Z>,
        state: &State<S, Z>,
        tree: &Tree<S, Z>,
        time: S,
    ) -> Self {
        let zero = S::constant(0.0);
        let masses = model.wall();
        let width = model.width();
        let mut rates = Self {
            accelerations: model.size.square(zero),
            holds: model.size.square(zero),
            width,
        };
        let mut unit = UnitMotion::new(model, state, tree);
        for column in 0..width {
            let coordinate = Unit::of_deviation(model, column);
            unit.solve(time, coordinate);
            for mass in 0..masses {
                let value = at(unit.accelerations.as_ref(), mass);
                set(rates.accelerations.as_mut(), mass * width + column, value);
            }
            for (j, hold) in unit.holds.as_ref().iter().enumerate() {
                set(rates.holds.as_mut(), j * width + column, *hold);
            }
        }
        rates
    }

    /// Takes the matrices from a table.
    pub(super) fn of(model: &Model<S, Z>, table: &Table<S, Z>) -> Self {
        let zero = S::constant(0.0);
        let width = model.width();
        let mut rates = Self {
            accelerations: model.size.square(zero),
            holds: model.size.square(zero),
            width,
        };
        let rows = rates.accelerations.as_mut().chunks_exact_mut(width.max(1));
        for (own, row) in rows.zip(table.accelerations()) {
            for (own, entry) in own.iter_mut().zip(row) {
                *own = *entry;
            }
        }
        let rows = rates.holds.as_mut().chunks_exact_mut(width.max(1));
        for (j, own) in rows.take(model.contacts().len()).enumerate() {
            for (own, entry) in own.iter_mut().zip(table.hold(j)) {
                *own = *entry;
            }
        }
        rates
    }

    /// Returns the row of a mass's acceleration.
    pub(super) fn acceleration(&self, mass: usize) -> &[S] {
        self.row(self.accelerations.as_ref(), mass)
    }

    /// Returns the row of the force of a rigid contact that sticks.
    pub(super) fn hold(&self, contact: usize) -> &[S] {
        self.row(self.holds.as_ref(), contact)
    }

    fn row<'r>(&self, rows: &'r [S], index: usize) -> &'r [S] {
        let row = rows.get(index * self.width..(index + 1) * self.width);
        row.unwrap_or_default()
    }
}

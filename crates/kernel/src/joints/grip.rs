//! Proves that no contact ever slides while a chain vibrates about a steady state in which all its contacts stick.
//!
//! The difference of the two motions obeys the equations of the chain without loads. Its energy therefore never grows.
//! The force that it adds to a contact is a sum of spring forces and damping forces with constant coefficients. The
//! inequality of Cauchy and Schwarz bounds this sum by the energy.

use super::model::Link;
use super::rates::{Unit, UnitMotion};
use super::run::Motion;
use super::size::{Size, add, at};
use super::state::{FREE, STUCK};
use super::steady::Steady;
use crate::Float;

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Returns true if all contacts certainly stick for ever. The motion is at the start of a period of `steady`, in
    /// which no contact slides. The contacts have the same positions in both motions.
    pub(super) fn sticks_for_ever(&self, steady: &Steady<S, Z>) -> bool {
        let model = self.model();
        let contacts = || model.contacts().iter().enumerate();
        let sticks = |j: usize| match (self.state.phase(j), steady.state.phase(j)) {
            (FREE, FREE) => true,
            (own, other) => own == STUCK && other == STUCK,
        };
        let is_simple = !model.has_stops() && !model.has_belts();
        if !is_simple || !contacts().all(|(j, own)| sticks(j) && own.has_constant_level()) {
            return false;
        }
        let energy = self.energy_beside(steady);
        contacts()
            .filter(|(j, _)| self.state.phase(*j) == STUCK)
            .all(|(j, own)| {
                let share = own.stiffness.unwrap_or_else(|| self.force_per_energy(j));
                let most = steady.cycle.contacts.as_ref().get(j);
                let most = most.map_or(S::constant(f64::INFINITY), |own| own.force);
                // The factor is far larger than 1 plus rounding errors.
                let more = S::constant(1.01) * (share * energy).sqrt();
                most + more < model.static_friction(j, S::constant(0.0))
            })
    }

    /// Returns the springs of the chain and those of the elastic contacts that stick.
    fn stuck_springs(&self) -> impl Iterator<Item = Link<S>> {
        let model = self.model();
        let contacts = model.contacts().iter().enumerate();
        let contacts = contacts.filter(|(j, _)| self.state.phase(*j) == STUCK);
        let elastic = contacts.filter_map(|(_, own)| {
            let stiffness = own.stiffness?;
            Some((own.plus, own.minus, stiffness))
        });
        model.springs.as_ref().iter().copied().chain(elastic)
    }

    /// Returns twice the energy of the difference from a steady state.
    fn energy_beside(&self, steady: &Steady<S, Z>) -> S {
        let beside = |own: &[S], other: &[S], index: usize| at(own, index) - at(other, index);
        let (own, other) = (&self.state, &steady.state);
        let place = |node| beside(own.x.as_ref(), other.x.as_ref(), node);
        let potential = self.stuck_springs().map(|(plus, minus, stiffness)| {
            let stretch = place(plus) - place(minus);
            stiffness * stretch * stretch
        });
        let masses = self.model().masses().iter().enumerate();
        let kinetic = masses.map(|(node, mass)| {
            let speed = beside(own.v.as_ref(), other.v.as_ref(), node);
            *mass * speed * speed
        });
        potential
            .chain(kinetic)
            .fold(S::constant(0.0), |sum, part| sum + part)
    }

    /// Returns an upper bound on the squared force of a rigid contact that sticks, divided by twice the energy.
    fn force_per_energy(&self, contact: usize) -> S {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let model = self.model();
        let mut sum = zero;
        for (plus, minus, stiffness) in self.stuck_springs() {
            let mut forces = model.size.nodes(zero);
            add(forces.as_mut(), plus, -one);
            add(forces.as_mut(), minus, one);
            let mut holds = model.size.contacts(zero);
            self.tree
                .accelerate(model, forces.as_ref(), zero, holds.as_mut());
            let hold = at(holds.as_ref(), contact);
            sum = sum + stiffness * hold * hold;
        }
        let mut unit = UnitMotion::new(model, &self.state, &self.tree);
        for (node, mass) in model.masses().iter().enumerate() {
            unit.solve(zero, Unit::Velocity(node));
            let hold = at(unit.holds.as_ref(), contact);
            sum = sum + hold * hold / *mass;
        }
        sum
    }
}

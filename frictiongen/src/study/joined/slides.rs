//! Adds up the distances that the sliders of the contacts travel, and the energies that friction dissipates in the
//! contacts.

use super::peaks::Peaks;
use crate::study::joints::{Heap, Model, Series, State, Transition};
use crate::study::response::MotionQuantity;
use frictiongen_kernel::joints::{FREE, Observe, Poly, STUCK, Short};

/// Travelled distance and dissipated energy of each contact since the start of a motion, and the events since the last
/// call of `take_events`.
#[derive(Clone, Debug)]
pub(super) struct Slides {
    contacts: Vec<Slide>,
    /// Displacement of each mass at the end of the last stretch (time interval of a power series).
    places: Vec<f64>,
    events: Vec<(Transition, Vec<f64>)>,
    /// Largest values of quantities.
    pub peaks: Peaks,
}

/// Travelled distance and dissipated energy of one contact since the start of a motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slide {
    /// The two nodes between which the contact acts.
    ends: (usize, usize),
    /// Velocity of a moving surface of the contact.
    speed: f64,
    /// Coefficient of the dashpot of a stop. `None` for a contact with friction.
    dashpot: Option<f64>,
    /// Kinetic friction force of the contact. It is that at the end of the step, if it changes during a step.
    level: f64,
    /// Stiffness of an elastic contact.
    stiffness: Option<f64>,
    /// True if the kinetic friction force depends on the sliding speed.
    has_law: bool,
    /// True if the kinetic friction force changes during the present step.
    changes: bool,
    /// Energy that an elastic contact dissipates at a break-away, divided by the square of the kinetic friction force.
    /// 0 for a rigid contact.
    drop: f64,
    /// Distance that the slider has travelled, added over both directions.
    pub slip: f64,
    /// Energy that friction has dissipated in the contact.
    pub energy: f64,
}

impl Slide {
    /// Returns the power series of a displacement or a force in a stretch, or `None` for an energy.
    pub fn terms(
        &self,
        series: &Series,
        (index, is_shut): (usize, bool),
        size: MotionQuantity,
    ) -> Option<Poly<f64>> {
        let (plus, minus) = self.ends;
        match size {
            MotionQuantity::Displacement => Some(series.place_terms(plus, minus)),
            MotionQuantity::Force => {
                let mut force = series.force_terms(index);
                let dashpot = self.dashpot.filter(|_| is_shut).unwrap_or(0.0);
                for (force, speed) in force.iter_mut().zip(series.speed_terms(plus, minus)) {
                    *force += dashpot * speed;
                }
                Some(force)
            }
            _ => None,
        }
    }
}

impl Slides {
    /// Creates an entry for each contact of the model, with its kinetic friction force. The distances and energies of
    /// all entries are 0.
    pub fn new(model: &Model) -> Self {
        let contacts = model.contacts.iter().map(|contact| Slide {
            ends: (contact.plus, contact.minus),
            speed: contact.speed,
            dashpot: contact.stop.map(|stop| stop.damping),
            level: contact.level.constant,
            stiffness: contact.stiffness,
            has_law: contact.is_rigid() && !model.law.is_empty(),
            changes: false,
            // At the break-away the force falls from μF to F. Friction then dissipates the energy (μ² − 1)F²/(2k) that
            // the spring of the contact loses.
            drop: contact.stiffness.map_or(0.0, |stiffness| {
                (contact.stiction * contact.stiction - 1.0) / (2.0 * stiffness)
            }),
            slip: 0.0,
            energy: 0.0,
        });
        Self {
            contacts: contacts.collect(),
            places: vec![0.0; model.masses.len()],
            events: Vec::new(),
            peaks: Peaks::default(),
        }
    }

    /// Returns the sliding distance and the dissipated energy of each contact.
    pub fn contacts(&self) -> &[Slide] {
        &self.contacts
    }

    /// Sets the kinetic friction force of a contact to `level`, by a jump at the present instant. If the `force` of an
    /// elastic contact exceeds `limit`, it falls to `level`. The method adds the energy that the spring of the contact
    /// then loses to the dissipated energy.
    pub fn set_level(&mut self, index: usize, level: f64, (force, limit): (f64, f64)) {
        let Some(slide) = self.contacts.get_mut(index) else {
            return;
        };
        if let Some(stiffness) = slide.stiffness
            && limit < force.abs()
        {
            slide.energy += (force * force - level * level) / (2.0 * stiffness);
        }
        (slide.level, slide.changes) = (level, false);
    }

    /// Sets the kinetic friction force of a contact at the end of the next step. It changes linearly during the step.
    pub fn lead_level(&mut self, index: usize, level: f64) {
        if let Some(slide) = self.contacts.get_mut(index) {
            slide.changes = level != slide.level;
            slide.level = level;
        }
    }

    /// Returns the events since the last call, each with the displacements of the masses at its instant.
    pub fn take_events(&mut self) -> Vec<(Transition, Vec<f64>)> {
        std::mem::take(&mut self.events)
    }
}

impl Observe<f64, Heap> for Slides {
    fn stretch(&mut self, series: &Series, end: f64, state: &State) {
        let wall = self.places.len();
        for (mass, place) in self.places.iter_mut().enumerate() {
            *place = series.place((mass, wall), end);
        }
        for (index, slide) in self.contacts.iter_mut().enumerate() {
            if let Some(dashpot) = slide.dashpot {
                if state.phase(index) == STUCK {
                    slide.energy += dashpot * series.squared_speed(slide.ends, end);
                }
                continue;
            }
            if ![STUCK, FREE].contains(&state.phase(index)) {
                // A contact does not reverse during a stretch (time interval of a power series). The distance is
                // therefore the difference of two displacements.
                let moved = series.place(slide.ends, end) - series.place(slide.ends, 0.0);
                let carried = slide.speed * series.length * end;
                let travel = moved - carried;
                let stored =
                    |force: f64| slide.stiffness.map_or(0.0, |k| force * force / (2.0 * k));
                slide.slip += travel.abs();
                slide.energy += if slide.has_law || slide.changes {
                    let [from, to] = [0.0, end].map(|at| stored(series.force(index, at)));
                    series.work(index, (slide.ends, slide.speed), end) - (to - from)
                } else {
                    slide.level * travel.abs()
                };
            }
        }
        self.peaks.stretch((series, end), state, &self.contacts);
    }

    fn event(&mut self, time: f64, before: &Short<i8>, after: &Short<i8>) {
        let phases = before.iter().zip(after);
        for (slide, (before, after)) in self.contacts.iter_mut().zip(phases) {
            if *before == STUCK && ![STUCK, FREE].contains(after) {
                slide.energy += slide.drop * slide.level * slide.level;
            }
        }
        let transition = Transition {
            time,
            before: before.to_vec(),
            after: after.to_vec(),
        };
        self.events.push((transition, self.places.clone()));
    }
}

//! Events: which phases contacts have after them.

use super::JointError;
use super::decide::{Decision, add_contact};
use super::model::{Contact, at};
use super::run::{FREE, Motion, STUCK};
use super::series::{Series, wave_terms};
use super::tree::set;

impl Motion {
    /// Changes the phases at an event.
    pub(super) fn pass(
        &mut self,
        series: &Series,
        fraction: f64,
        hits: &[(usize, i8)],
    ) -> Result<(), JointError> {
        let (mut arrived, mut broke) = (Vec::new(), Vec::new());
        for &(j, side) in hits {
            let Some(contact) = self.model.contacts.get(j) else {
                continue;
            };
            let stuck = self.state.phase(j) == STUCK;
            match (contact.stiffness, stuck) {
                (None, true) => broke.push((j, side)),
                (None, false) => {
                    let ends = (contact.plus, contact.minus);
                    set(&mut self.state.places, j, series.place(ends, fraction));
                    arrived.push(j);
                }
                (Some(_), true) => {
                    let force = f64::from(side) * contact.level.constant;
                    set(&mut self.state.forces, j, force);
                    set_phase(&mut self.state.phases, j, side);
                }
                (Some(_), false) => {
                    set_phase(&mut self.state.phases, j, STUCK);
                    let zeros = if contact.stiction == 1.0 { 2 } else { 0 };
                    set_zeros(&mut self.state.zeros, j, (zeros, side));
                }
            }
        }
        self.ask(&arrived, &broke)
    }

    /// Sets the phases of the first instant.
    pub(super) fn begin(&mut self) -> Result<(), JointError> {
        let (x, v) = self.nodes();
        for (j, contact) in self.model.contacts.iter().enumerate() {
            let speed = contact.across(&v);
            let slides = contact.is_rigid() && speed != 0.0;
            let phase = match slides {
                _ if contact.is_free() => FREE,
                true => speed.signum() as i8,
                false => STUCK,
            };
            set_phase(&mut self.state.phases, j, phase);
            set(&mut self.state.places, j, contact.across(&x));
        }
        self.ask(&[], &[])
    }

    /// Decides all rigid contacts without relative velocity together: those that stick, and those that arrive.
    pub(super) fn ask(
        &mut self,
        arrived: &[usize],
        broke: &[(usize, i8)],
    ) -> Result<(), JointError> {
        let asks = |(j, contact): &(usize, &Contact)| {
            let stops = self.state.phase(*j) == STUCK || arrived.contains(j);
            contact.is_rigid() && stops
        };
        let contacts = self.model.contacts.iter().enumerate();
        let asked: Vec<usize> = contacts.filter(asks).map(|(j, _)| j).collect();
        if asked.is_empty() {
            self.join();
            return Ok(());
        }
        let decision = self.decision(&asked, broke);
        let pattern = decision.decide()?;
        let (contacts, phases): (Vec<usize>, Vec<i8>) = pattern.iter().copied().unzip();
        let (accelerations, holds) = decision.accelerations(&contacts, &phases);
        let zeros = pattern.iter().map(|&(j, phase)| {
            let contact = self.model.contacts.get(j);
            let rate = contact.map_or(0.0, |c| c.across(&accelerations));
            if phase != STUCK {
                let sure = f64::from(phase) * rate > decision.noise(j);
                return (if sure { 1 } else { 2 }, phase);
            }
            let most = contact.map_or(0.0, |c| c.stiction) * at(&decision.levels, j);
            let hold = at(&holds, j);
            let at_limit = most - hold.abs() <= decision.rounding();
            (usize::from(at_limit), if hold > 0.0 { 1 } else { -1 })
        });
        let zeros: Vec<_> = zeros.collect();
        for (&(j, phase), zeros) in pattern.iter().zip(zeros) {
            let was_stuck = self.state.phase(j) == STUCK;
            set_phase(&mut self.state.phases, j, phase);
            if phase != STUCK || !was_stuck || zeros.0 > 0 {
                set_zeros(&mut self.state.zeros, j, zeros);
            }
        }
        self.join();
        let (_, mut v) = self.nodes();
        self.tree.meet(&self.model, &mut v);
        v.truncate(self.model.wall());
        self.state.v = v;
        Ok(())
    }

    /// Returns the question at this instant.
    fn decision(&self, asked: &[usize], broke: &[(usize, i8)]) -> Decision<'_> {
        let (x, v) = self.nodes();
        let mut sizes = vec![0.0; x.len()];
        let loads = self.model.load_values(self.time);
        let mut forces = self.model.forces(&x, &v, &loads, Some(&mut sizes));
        let contacts = self.model.contacts.iter();
        let levels: Vec<f64> = contacts
            .map(|c| at(&wave_terms(&c.level, self.time, 0.0, 0), 0))
            .collect();
        for (j, contact) in self.model.contacts.iter().enumerate() {
            let phase = self.state.phase(j);
            let force = match phase {
                FREE => 0.0,
                _ if !contact.is_rigid() => at(&self.state.forces, j),
                phase => f64::from(phase) * at(&levels, j),
            };
            if !asked.contains(&j) {
                add_contact(&self.model, j, force, (&mut forces, &mut sizes));
            }
        }
        let asked_levels: f64 = asked.iter().map(|&j| at(&levels, j)).sum();
        Decision {
            model: &self.model,
            forces,
            size: sizes.iter().sum::<f64>() + asked_levels,
            base: at(&wave_terms(&self.model.base, self.time, 0.0, 2), 0),
            levels,
            asked: asked.to_vec(),
            broke: broke.to_vec(),
        }
    }
}

/// Sets the phase of a contact.
pub fn set_phase(phases: &mut [i8], contact: usize, phase: i8) {
    if let Some(of) = phases.get_mut(contact) {
        *of = phase;
    }
}

/// Sets which terms of a contact's next event are 0.
fn set_zeros(zeros: &mut [(usize, i8)], contact: usize, value: (usize, i8)) {
    if let Some(of) = zeros.get_mut(contact) {
        *of = value;
    }
}

//! Functions for a search for periodic motions: steps with forces that are cubic functions of time, and access to the
//! numbers of the state.

use super::Input;
use super::drive::{Sample, SubInterval, base_motion};
use super::interval::StepInterval;
use super::law::StepContact;
use super::state::Store;
use super::table::StepTables;
use super::types::{Stepped, Stepper};
use crate::errors::OutOfDomain;
use crate::motion::Contact;
use crate::number::scalar::Float;

impl<S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'_, S, D, T, V, K>
{
    /// Advances the stepper by one step under forces that are cubic functions of time. Apart from the forces, the
    /// function works as [`advance`](Self::advance) does with linear input. `slopes` contains the time derivative of
    /// each force at the start and at the end of the step, per second.
    ///
    /// # Errors
    /// The errors of [`advance`](Self::advance).
    pub fn advance_cubic(
        &mut self,
        sample: Sample<'_, S>,
        slopes: &[[S; 2]],
    ) -> Result<Stepped<S>, OutOfDomain> {
        sample.check(&self.scene, self.status.stiction)?;
        self.check_work()?;
        let pace = self.tables.view().pace;
        let stiffness = self.scene.units.stiffness;
        #[cfg(feature = "event-times")]
        {
            self.status.last_event = None;
        }
        self.status.level = sample.friction / stiffness;
        let per_step = |[place, rate]: [S; 2]| [place, rate * pace.step];
        let base = [self.status.base, sample.base].map(per_step);
        let motion = base_motion(Input::Linear, base[0], base[1]);
        let mut stepped = Stepped {
            contact: Contact::Stuck,
            force: S::constant(0.0),
            events: 0,
            exceeded: false,
        };
        for part in 0..pace.parts {
            let stretch = SubInterval::nth(part, pace.parts);
            let base = self.write_inputs(&sample, motion, stretch);
            let store = self.store.change();
            let moving = store.last.len().saturating_sub(sample.forces.len());
            let channels = store.drive.iter_mut().zip(&*store.last).skip(moving);
            for (((drive, last), force), [from, to]) in
                channels.zip(sample.forces).zip(slopes.iter().copied())
            {
                let ends = [[*last, from], [*force / stiffness, to]];
                let [from, to] = ends.map(|[force, slope]| [force, slope / stiffness]);
                let cubic = base_motion(Input::Linear, per_step(from), per_step(to));
                for (term, value) in drive.iter_mut().zip(stretch.cubic(cubic)) {
                    *term = value;
                }
            }
            let mut interval = StepInterval {
                scene: &self.scene,
                table: self.tables.view(),
                store,
                status: &mut self.status,
                base,
                progress: S::constant(0.0),
                events: 0,
                exceeded: false,
                #[cfg(feature = "event-times")]
                stretch,
            };
            interval.advance();
            stepped.events += interval.events;
            stepped.exceeded |= interval.exceeded;
        }
        self.keep_sample(&sample);
        if self.status.level.is_zero() {
            self.status.contact = self.direction();
        }
        self.status.given = S::constant(0.0);
        self.status.steps = self.status.steps.wrapping_add(1);
        self.status.exceeded += u64::from(stepped.exceeded);
        stepped.contact = self.status.contact;
        stepped.force = self.force();
        Ok(stepped)
    }

    /// Calls `visit` with every number that determines the later motion. These numbers are the displacement and the
    /// scaled velocity of each oscillator, and have the dimension of a displacement. While the contact sticks, the
    /// position of the contact is one more number. For an elastic contact this number is the position of the slider.
    pub fn visit_state(&mut self, mut visit: impl FnMut(&mut S)) {
        let sticks = self.status.contact == Contact::Stuck && !self.status.unknown;
        let driven = self.scene.dynamics.in_contact();
        let store = self.store.change();
        let first = if sticks { driven } else { 0 };
        let held = if sticks { store.held } else { &mut [] };
        let modes = store.modes.iter_mut().skip(first);
        for value in held.iter_mut().chain(modes).flatten() {
            visit(value);
        }
        if sticks {
            visit(&mut self.status.stuck_at);
        }
        // The flag `wedged` belongs to the previous state, and is not valid for the changed state.
        self.status.wedged = false;
    }

    /// Restarts the energy balance at this instant: the work of the load and the dissipated energy become 0.
    pub fn restart_work(&mut self) {
        self.status.load = crate::motion::Total::zero();
        self.status.dissipated = crate::motion::Total::zero();
        self.status.energy = self.energy();
        self.status.pull = self.pull();
    }
}

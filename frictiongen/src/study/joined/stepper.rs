//! Motion of scenes with several contacts in time steps of equal length, under sampled forces.

use super::error::{JoinedError, UnknownContact};
use super::peaks::{Peak, Peaks};
use super::scene::Joined;
use super::simulation::{JoinedContactNow, JoinedEvent};
use super::slides::Slides;
use crate::study::joints::{Chain, Heap, Wave};
use crate::study::response::MotionQuantity;
use crate::{Given, Of, OutOfDomain};
use frictiongen_kernel::joints::{Curve, Sample, Span, Stepper};
use frictiongen_kernel::stepper::Work;
use frictiongen_model::scene::{Excitation, StepInput};

/// Input of one step of a stepper, in the units of the scene description.
#[derive(Clone, Copy, Debug, Default)]
pub struct JoinedInput<'i> {
    /// Displacement and velocity of the base at the end of the step, or at its start with `input: hold`. Both are 0
    /// for a base that does not move.
    pub base: [f64; 2],
    /// Velocity of the base at the start of the step, if it jumps there. `None` means that the step starts at the
    /// velocity of the last input. `begin` and `input: hold` ignore this velocity.
    pub start_velocity: Option<f64>,
    /// Forces on masses at the end of the step, or during the whole step with `input: hold`. Each force has the name
    /// of its mass. Forces on the same mass add up. A mass without an entry has no force.
    pub forces: &'i [(&'i str, f64)],
    /// Kinetic friction forces of contacts at the end of the step, or during the whole step with `input: hold`, each
    /// with the name of its contact. A contact with the friction force 0 has no effect. A contact without an entry
    /// keeps its friction force.
    pub frictions: &'i [(&'i str, f64)],
}

/// Input of one step of any length, in the units of the scene description. The time of all functions is 0 at the start of
/// the step.
#[derive(Clone, Copy, Debug)]
pub struct JoinedSpan<'i> {
    /// Time at the end of the step since the start of the motion, in s.
    pub end: f64,
    /// Displacement of the base.
    pub base: Curve<f64>,
    /// True if the displacement or the velocity of the base jumps at the start of the step.
    pub jolts: bool,
    /// Force of each load of the stepper, in the order of [`Joined::stepper_loaded`].
    pub forces: &'i [Wave],
    /// Kinetic friction force of each contact, with the name of the contact. A contact without an entry keeps its
    /// friction force.
    pub frictions: &'i [(&'i str, Wave)],
}

/// Advances a scene with several contacts in time steps of equal length. The units are those of the scene description.
#[derive(Clone, Debug)]
pub struct JoinedStepper<'a> {
    joined: Joined<'a>,
    stepper: Stepper<f64, Heap, Vec<f64>>,
    /// Kinetic friction force of each contact in the last step.
    frictions: Vec<f64>,
    /// For each contact, the distance that the slider has travelled, and the energy that friction has dissipated.
    slides: Slides,
    /// Index of the mass on which each load acts.
    loads: Vec<usize>,
    /// Time in s at the end of the last step of a length of its own.
    now: Option<f64>,
    /// All events since the start, if the caller requests them.
    events: Option<Vec<JoinedEvent>>,
}

/// Forces on the masses and friction forces of the contacts in one step, in the order of the scene description.
struct Ordered {
    forces: Vec<f64>,
    frictions: Vec<f64>,
}

impl<'a> Joined<'a> {
    /// Returns a stepper that starts from rest. A force can act on every mass. Every contact has its own friction
    /// force, which is 0 until an input sets it.
    ///
    /// The field `input` of the scene description determines forces and friction forces between two samples: linear, or
    /// constant (`hold`). A base that drives the scene follows a cubic between two samples. With `hold`, the base instead
    /// starts from the displacement of the new sample and moves with the velocity of this sample.
    ///
    /// # Errors
    /// [`OutOfDomain`](crate::OutOfDomain) for a step that is 0, negative, infinite, NaN, or too long.
    pub fn stepper(&self, dt: f64) -> Result<JoinedStepper<'a>, JoinedError> {
        self.stepper_from(dt, (&[], &[]))
    }

    /// Returns a stepper that starts from a given state: the displacements and velocities of all masses.
    ///
    /// # Errors
    /// Same errors as [`stepper`](Self::stepper).
    #[doc(hidden)]
    pub fn stepper_from(
        &self,
        dt: f64,
        state: (&[f64], &[f64]),
    ) -> Result<JoinedStepper<'a>, JoinedError> {
        let masses = self.chain().masses.len();
        self.stepper_loaded(dt, state, (0..masses).collect())
    }

    /// Returns a stepper that starts from a given state, with one load for each index of a mass in `loads`. Several loads
    /// may act on one mass.
    ///
    /// # Errors
    /// Same errors as [`stepper`](Self::stepper).
    #[doc(hidden)]
    pub fn stepper_loaded(
        &self,
        dt: f64,
        (x, v): (&[f64], &[f64]),
        loads: Vec<usize>,
    ) -> Result<JoinedStepper<'a>, JoinedError> {
        let mut chain: Chain = self.chain().clone();
        let of_mass = loads.iter().map(|mass| (*mass, Wave::default()));
        chain.loads = of_mass.collect();
        let input = self.scene().stepping.input.into();
        let on_base = self.scene().excitation == Excitation::Base;
        // Without tables the stepper follows power series, from which the distances and energies come.
        let tables = Vec::new();
        let stepper = Stepper::from_state(chain.model()?, (dt, input, on_base), tables, (x, v))?;
        Ok(JoinedStepper {
            slides: Slides::new(stepper.motion().model()),
            stepper,
            joined: self.clone(),
            frictions: vec![0.0; chain.contacts.len()],
            loads,
            now: None,
            events: None,
        })
    }
}

impl JoinedStepper<'_> {
    /// Advances by one step. Returns the number of events in the step.
    ///
    /// # Errors
    /// [`OutOfDomain`](crate::OutOfDomain) for a force or a base motion whose square is not finite, and for a base motion in a
    /// scene that a force drives. [`OutOfDomain`](crate::OutOfDomain) also for a step in which the motion exceeds a
    /// bound of the solver. [`JoinedError::Friction`] for a friction force that is negative or not finite.
    /// [`JoinedError::UnknownMass`] and
    /// [`JoinedError::UnknownContact`] for a name that the scene does not have. After an error the stepper is
    /// unchanged, except for a velocity of the base that the input sets.
    pub fn advance(&mut self, input: JoinedInput<'_>) -> Result<usize, JoinedError> {
        let Ordered { forces, frictions } = self.ordered(&input)?;
        if let Some(velocity) = input.start_velocity {
            self.stepper.set_base_velocity(velocity)?;
        }
        let mut slides = self.slides.clone();
        slides.peaks.start = self.time();
        match self.joined.scene().stepping.input {
            StepInput::Hold => self.relax(&mut slides, &frictions),
            StepInput::Linear => {
                for (index, friction) in frictions.iter().enumerate() {
                    slides.lead_level(index, *friction);
                }
            }
        }
        let sample = Sample {
            base: input.base,
            forces: &forces,
            frictions: &frictions,
        };
        let stepped = self.stepper.advance_with(sample, &mut slides)?;
        slides.take_events();
        (self.slides, self.frictions) = (slides, frictions);
        Ok(stepped.events as usize)
    }

    /// Advances by one step whose end `span` gives. Returns the number of events in the step.
    ///
    /// # Errors
    /// Same errors as [`advance`](Self::advance), and [`OutOfDomain::Step`] for a step that is 0, negative or too long.
    /// After an error the stepper is unchanged.
    pub fn advance_over(&mut self, span: JoinedSpan<'_>) -> Result<usize, JoinedError> {
        let start = self.time();
        let length = span.end - start;
        let known = self.joined.contact_names();
        let mut levels: Vec<Wave> = self.frictions.iter().copied().map(Wave::constant).collect();
        for (name, level) in span.frictions {
            if let Some(own) = levels.get_mut(self.joined.contact_index(name)?) {
                *own = *level;
            }
        }
        for (level, name) in levels.iter().zip(&known) {
            let ends = [0.0, length].map(|time| level.value(time, 0));
            if let Some(friction) = ends.iter().find(|end| !(0.0 <= **end && end.is_finite())) {
                return Err(JoinedError::Friction(name.clone(), Given::of(*friction)));
            }
        }
        let mut slides = self.slides.clone();
        slides.peaks.start = start;
        let starts: Vec<f64> = levels.iter().map(|level| level.value(0.0, 0)).collect();
        self.relax(&mut slides, &starts);
        let ends: Vec<f64> = levels.iter().map(|level| level.value(length, 0)).collect();
        for (index, friction) in ends.iter().enumerate() {
            slides.lead_level(index, *friction);
        }
        let span_end = span.end;
        let span = Span {
            length,
            base: span.base,
            jolts: span.jolts,
            forces: span.forces,
            frictions: &levels,
        };
        let stepped = self.stepper.advance_over(span, &mut slides)?;
        let transitions = slides.take_events();
        if let Some(events) = &mut self.events {
            events.extend(self.joined.events(&transitions, &|time| start + time, 1.0));
        }
        (self.slides, self.frictions) = (slides, ends);
        self.now = Some(span_end);
        Ok(stepped.events as usize)
    }

    /// Advances by one step that ends at the time `end` in s since the start. `before` has the forces and friction forces at
    /// the start of the step. The step is otherwise that of [`advance`](Self::advance).
    ///
    /// # Errors
    /// Same errors as [`advance_over`](Self::advance_over).
    pub fn advance_between(
        &mut self,
        before: JoinedInput<'_>,
        input: JoinedInput<'_>,
        end: f64,
    ) -> Result<usize, JoinedError> {
        let length = end - self.time();
        let scene = self.joined.scene();
        let holds = scene.stepping.input == StepInput::Hold;
        let from = self.ordered(if holds { &input } else { &before })?;
        let to = self.ordered(&input)?;
        let lines = |from: &[f64], to: &[f64]| -> Vec<Wave> {
            let pairs = from.iter().zip(to);
            pairs
                .map(|(from, to)| Wave::line((0.0, *from), (length, *to)))
                .collect()
        };
        let (base, jolts) = match (scene.excitation, input.start_velocity) {
            (Excitation::Force(_), _) => (Curve::zero(), false),
            (Excitation::Base, _) if holds => (Curve::straight(input.base), true),
            (Excitation::Base, jump) => {
                let [place, velocity] = self.base();
                let start = [place, jump.unwrap_or(velocity)];
                let curve = Curve::through(start, input.base, length);
                (curve, jump.is_some())
            }
        };
        let names = self.joined.contact_names();
        let frictions = names.iter().map(String::as_str);
        let frictions = frictions.zip(lines(&from.frictions, &to.frictions));
        self.advance_over(JoinedSpan {
            end,
            base,
            jolts,
            forces: &lines(&from.forces, &to.forces),
            frictions: &frictions.collect::<Vec<_>>(),
        })
    }

    /// Keeps the events of all later steps of [`advance_over`](Self::advance_over).
    pub fn keep_events(&mut self) {
        self.events = Some(Vec::new());
    }

    /// Returns the events since [`keep_events`](Self::keep_events), with their times in s.
    #[must_use]
    pub fn events(self) -> Vec<JoinedEvent> {
        self.events.unwrap_or_default()
    }

    /// Returns displacement and velocity of the base at the end of the last step.
    #[must_use]
    pub fn base(&self) -> [f64; 2] {
        self.stepper.base()
    }

    /// Sets the input at the start of the first step. Without this call, the input at the start is 0. After the call,
    /// the methods of the stepper return the state at the start under this input.
    ///
    /// # Errors
    /// Same errors as [`advance`](Self::advance), and [`OutOfDomain::Begun`] after the first step.
    pub fn begin(&mut self, input: JoinedInput<'_>) -> Result<(), JoinedError> {
        let Ordered { forces, frictions } = self.ordered(&input)?;
        self.stepper.begin(Sample {
            base: input.base,
            forces: &forces,
            frictions: &frictions,
        })?;
        let mut slides = self.slides.clone();
        self.relax(&mut slides, &frictions);
        (self.slides, self.frictions) = (slides, frictions);
        Ok(())
    }

    /// Returns the forces on masses and the friction forces of an input in the order of the scene description.
    fn ordered(&self, input: &JoinedInput<'_>) -> Result<Ordered, JoinedError> {
        let on_base = self.joined.scene().excitation == Excitation::Base;
        if !on_base && (input.base != [0.0; 2] || input.start_velocity.is_some()) {
            return Err(OutOfDomain::BaseAtRest.into());
        }
        // The energies contain the squares.
        let is_large = |value: &&f64| !(**value * **value).is_finite();
        if let Some(value) = input.base.iter().find(is_large) {
            return Err(OutOfDomain::BaseMotion(Given::of(*value)).into());
        }
        let mut forces = vec![0.0; self.loads.len()];
        for (name, force) in input.forces {
            let mass = self.joined.mass_index(name)?;
            let load = self.loads.iter().position(|own| *own == mass);
            if let Some(own) = load.and_then(|load| forces.get_mut(load)) {
                *own += *force;
            }
        }
        if let Some(force) = forces.iter().find(is_large) {
            return Err(OutOfDomain::Force(Given::of(*force)).into());
        }
        let mut frictions = self.frictions.clone();
        for (name, friction) in input.frictions {
            if let Some(own) = frictions.get_mut(self.joined.contact_index(name)?) {
                if !(0.0 <= *friction && friction.is_finite()) {
                    let given = Given::of(*friction);
                    return Err(JoinedError::Friction((*name).to_owned(), given));
                }
                *own = *friction;
            }
        }
        Ok(Ordered { forces, frictions })
    }

    /// Adds to the dissipated energies what a jump of the friction forces dissipates. If an elastic contact cannot keep
    /// its present force, its spring loses a part of its energy.
    fn relax(&self, slides: &mut Slides, frictions: &[f64]) {
        for (index, friction) in frictions.iter().enumerate() {
            let now = self.stepper.contact(index);
            let stiction = self.stepper.stiction(index).filter(|_| now.is_sticking());
            let limit = stiction.unwrap_or(1.0) * friction;
            slides.set_level(index, *friction, (now.force(), limit));
        }
    }

    /// Returns the time since the start at the end of the last step, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.now
            .unwrap_or_else(|| self.stepper.steps() as f64 * self.stepper.dt())
    }

    /// Follows the largest absolute values of quantities from the next step on: of a displacement, a velocity, an
    /// acceleration, the force in a spring, or the displacement, the force or the energy of a contact or a stop. The third
    /// entry is the index of this contact or stop. The values are exact between samples.
    ///
    /// ```
    /// use frictiongen::study::{joined::JoinedInput, response::MotionQuantity};
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { m: 1.0 }, springs: { base - m: 100.0 }, contact: m - wall, excitation: m,
    /// }".parse()?;
    /// let joined = block.joined()?;
    /// let mut step = joined.stepper(0.05)?;
    /// step.follow_peaks(&[(Of::Mass(0), MotionQuantity::Displacement, 0)])?;
    /// let input = JoinedInput { forces: &[("m", 5.0)], ..JoinedInput::default() };
    /// step.begin(input)?;
    /// for _ in 0..10 {
    ///     step.advance(input)?;
    /// }
    /// // Without friction, x = P/k (1 − cos ωt) with ω = 10 rad/s.
    /// let peak = step.peaks()[0];
    /// assert!((peak.value - 0.1).abs() < 1e-12 && (peak.time - 0.314159).abs() < 1e-5);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`JoinedError::Quantity`] for a quantity that the scene does not have.
    pub fn follow_peaks(
        &mut self,
        quantities: &[(Of, MotionQuantity, usize)],
    ) -> Result<(), JoinedError> {
        self.slides.peaks = Peaks::of(&self.joined, quantities)?;
        Ok(())
    }

    /// Returns the peak of each quantity of [`follow_peaks`](Self::follow_peaks), in the units of the scene description.
    #[must_use]
    pub fn peaks(&self) -> Vec<Peak> {
        self.slides.peaks.found()
    }

    /// Returns the energy balance since the start, in the unit of force times the unit of length.
    #[must_use]
    pub fn work(&self) -> Work<f64> {
        self.stepper.work()
    }

    /// Returns the number of steps with more events than the stepper follows.
    #[must_use]
    pub fn exceeded(&self) -> u64 {
        self.stepper.exceeded()
    }

    /// Returns displacement and velocity of the mass called `name` at the end of the last step.
    ///
    /// # Errors
    /// [`JoinedError::UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<(f64, f64), JoinedError> {
        let mass = self.stepper.mass(self.joined.mass_index(name)?);
        Ok((mass.displacement(), mass.velocity()))
    }

    /// Returns the state of the contact called `name` at the end of the last step. A jump of the base (`input: hold`)
    /// adds nothing to the slip and to the energy.
    ///
    /// # Errors
    /// [`JoinedError::UnknownContact`] if no contact has this name.
    pub fn contact_named(&self, name: &str) -> Result<JoinedContactNow, JoinedError> {
        let index = self.joined.contact_index(name)?;
        let now = self.contacts().get(index).copied();
        Ok(now.ok_or_else(|| UnknownContact {
            name: name.to_owned(),
            known: self.joined.contact_names(),
        })?)
    }

    /// Returns the state of every contact at the end of the last step, in the order of the scene description.
    #[must_use]
    pub fn contacts(&self) -> Vec<JoinedContactNow> {
        let slides = self.slides.contacts().iter().enumerate();
        let contacts = slides.map(|(index, slide)| {
            let now = self.stepper.contact(index);
            JoinedContactNow {
                displacement: now.displacement(),
                velocity: now.velocity(),
                force: now.force(),
                slip: slide.slip,
                energy: slide.energy,
                is_sticking: now.is_sticking(),
            }
        });
        contacts.collect()
    }

    /// Returns displacement and velocity of each mass at the end of the last step, in the order of the scene
    /// description.
    #[must_use]
    pub fn masses(&self) -> Vec<[f64; 2]> {
        let masses = (0..self.joined.scene().masses.len()).map(|mass| self.stepper.mass(mass));
        let masses = masses.map(|now| [now.displacement(), now.velocity()]);
        masses.collect()
    }
}

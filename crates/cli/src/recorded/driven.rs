//! Computes the motion of a scene under a recorded input, sample by sample.

use crate::failure::Failure;
use crate::number::computed;
use crate::output::{ResultTable, Visitor};
use frictiongen::System;
use frictiongen::answer::Work;
use frictiongen::measure::Inputs;
use frictiongen::measure::columns::{DrivenSample, DrivenTable};
use frictiongen::study::columns::Column;
use frictiongen::study::joined::{Joined, JoinedInput, JoinedStepper};
use frictiongen::study::scene::Excitation;
use serde_json::{Value as Json, json};

/// Motion of a scene under a recorded input, with the options for the output.
pub struct DrivenReport<'s> {
    /// The motions that the output contains.
    pub table: DrivenTable<'s>,
    /// Motion of the scene at every sample of the recording.
    pub samples: Vec<DrivenSample>,
    work: Work<f64>,
    exceeded: u64,
}

/// Returns a stepper at the first sample of the recorded input.
pub fn start<'s>(
    joined: &Joined<'s>,
    system: &System,
    inputs: &Inputs<'_>,
) -> Result<JoinedStepper<'s>, Failure> {
    let (displacements, velocities) = inputs.initial_state(system);
    let step = joined.stepper_from(inputs.dt(), (&displacements, &velocities));
    step.map_err(|_| {
        Failure::new(format_args!(
            "the samples are {} s apart: too far for the fastest mode of the scene",
            computed(inputs.dt())
        ))
    })
}

/// Follows the motion of a scene under the recorded input. Calls `visit` at every sample with the stepper, the
/// displacement and the velocity of the base, and the number of events since the previous sample.
pub fn follow(
    step: &mut JoinedStepper<'_>,
    system: &System,
    inputs: &Inputs<'_>,
    mut visit: impl FnMut(&JoinedStepper<'_>, [f64; 2], usize),
) -> Result<(), Failure> {
    let scene = system.scene();
    let excited = match scene.excitation {
        Excitation::Force(mass) => scene.masses.get(mass).map(|mass| mass.name.as_str()),
        Excitation::Base => None,
    };
    let contacts = scene.named_contacts();
    for sample in 0..inputs.len() {
        let input = inputs.sample(sample);
        let mut forces = input.others;
        forces.extend(excited.map(|mass| (mass, input.force)));
        let frictions = contacts.iter().map(|contact| {
            let friction = contact.law.share * input.friction;
            (contact.name.as_str(), friction)
        });
        let frictions: Vec<(&str, f64)> = frictions.collect();
        let now = JoinedInput {
            base: input.base,
            start_velocity: input.start_velocity,
            forces: &forces,
            frictions: &frictions,
        };
        let events = match sample {
            0 => step.begin(now).map(|()| 0),
            _ => step.advance(now),
        };
        let events = events.map_err(|error| {
            Failure::new(format_args!("sample {sample} of the recording: {error}"))
        })?;
        visit(step, input.end, events);
    }
    Ok(())
}

impl<'s> DrivenReport<'s> {
    /// Computes the motion of the scene under the recorded input.
    pub fn of(
        joined: &Joined<'_>,
        inputs: &Inputs<'_>,
        table: DrivenTable<'s>,
    ) -> Result<Self, Failure> {
        let signs = (0..table.names.len()).map(|contact| joined.sign(contact));
        let signs: Vec<f64> = signs.collect();
        let mut samples = Vec::with_capacity(inputs.len());
        let mut step = start(joined, table.system, inputs)?;
        follow(&mut step, table.system, inputs, |step, base, events| {
            let contacts = step.contacts().into_iter().zip(&signs);
            let contacts = contacts.map(|(now, sign)| now.signed(*sign)).collect();
            let instant = (step.time(), events);
            samples.push(table.sample(instant, (base, &step.masses()), contacts));
        })?;
        Ok(Self {
            table,
            samples,
            work: step.work(),
            exceeded: step.exceeded(),
        })
    }

    /// Returns the terms of the energy balance, each as a name and an energy in J.
    fn sums(&self) -> [(&'static str, f64); 4] {
        let Work {
            load,
            friction,
            damping,
            stored,
        } = self.work;
        [
            ("load", load),
            ("friction", friction),
            ("damping", damping),
            ("stored", stored),
        ]
    }

    /// Returns the energy that friction has dissipated in each contact, with the name of the contact.
    fn energies(&self) -> impl Iterator<Item = (&str, f64)> {
        let last = self.samples.last().into_iter();
        let last = last.flat_map(|sample| &sample.contacts);
        let names = self.table.names.iter().map(String::as_str);
        names.zip(last.map(|now| now.energy))
    }

    /// Returns a sentence about the energy balance of the motion.
    fn account(&self) -> String {
        let mut text = listed(self.sums());
        if 0 < self.exceeded {
            text += &format!(
                "; {} steps had more events than the stepper follows",
                self.exceeded
            );
        }
        text
    }
}

/// Returns energies with their names as a text.
fn listed<'n>(energies: impl IntoIterator<Item = (&'n str, f64)>) -> String {
    let energies = energies.into_iter();
    let all: Vec<String> = energies
        .map(|(name, energy)| format!("{name} {} J", computed(energy)))
        .collect();
    all.join(", ")
}

/// Returns energies with their names as a JSON object.
fn object<'n>(energies: impl IntoIterator<Item = (&'n str, f64)>) -> Json {
    let energies = energies.into_iter();
    let fields = energies.map(|(name, energy)| (format!("{name}_J"), json!(energy)));
    Json::Object(fields.collect())
}

impl ResultTable for DrivenReport<'_> {
    type Row = DrivenSample;

    fn len(&self) -> usize {
        self.samples.len()
    }

    fn each(&self, visit: Visitor<'_, DrivenSample>) -> Result<(), Failure> {
        self.samples.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, DrivenSample>> {
        self.table.columns()
    }

    fn head(&self) -> Vec<(String, Json)> {
        vec![
            ("work".to_owned(), object(self.sums())),
            ("friction_energy".to_owned(), object(self.energies())),
            ("exceeded".to_owned(), json!(self.exceeded)),
        ]
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        vec![
            ("work", self.account()),
            ("friction energy", listed(self.energies())),
        ]
    }
}

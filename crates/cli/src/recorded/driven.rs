//! Computes the motion of a scene under a recorded input, sample by sample.

use crate::asked::MovingPart;
use crate::failure::Failure;
use crate::number::computed;
use crate::output::{ResultTable, Visitor};
use frictiongen::answer::Work;
use frictiongen::measure::Inputs;
use frictiongen::measure::columns::{Driven, DrivenRow};
use frictiongen::study::StudyError;
use frictiongen::study::columns::Column;
use frictiongen::{Error, OutOfDomain, System};
use serde_json::{Value as Json, json};

/// Motion of a scene under a recorded input, with the options for the output.
pub struct DrivenReport<'s> {
    system: &'s System,
    /// The contact and masses whose motions the output contains.
    pub parts: Vec<MovingPart>,
    /// Motion of the scene at every sample of the recording.
    pub motion: Driven,
    work: Work<f64>,
    exceeded: u64,
}

impl<'s> DrivenReport<'s> {
    /// Computes the motion of the scene under the recorded input.
    pub fn of(
        system: &'s System,
        inputs: &Inputs<'_>,
        parts: Vec<MovingPart>,
    ) -> Result<Self, Failure> {
        let turned = system.contact_is_reversed();
        let mut step = inputs.stepper(system).map_err(|error| match error {
            StudyError::Solver(Error::OutOfDomain(OutOfDomain::Step(_))) => {
                Failure::new(format_args!(
                    "the samples are {} s apart: too far for the fastest mode of the scene",
                    computed(inputs.dt())
                ))
            }
            error => Failure::new(error),
        })?;
        let mut motion = Driven::new(&parts);
        motion.push(&step, &parts, turned, 0);
        for sample in 1..inputs.len() {
            let stepped = step.advance(inputs.at(sample)).map_err(|error| {
                Failure::new(format_args!("sample {sample} of the recording: {error}"))
            })?;
            motion.push(&step, &parts, turned, stepped.events);
        }
        Ok(Self {
            system,
            parts,
            motion,
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
            ("load_J", load),
            ("friction_J", friction),
            ("damping_J", damping),
            ("stored_J", stored),
        ]
    }

    /// Returns a sentence about the energy balance of the motion.
    pub fn account(&self) -> String {
        let Work {
            load,
            friction,
            damping,
            stored,
        } = self.work;
        let mut text = format!(
            "load {} J; friction {} J, damping {} J, stored {} J",
            computed(load),
            computed(friction),
            computed(damping),
            computed(stored)
        );
        if 0 < self.exceeded {
            text += &format!(
                "; {} steps had more events than the stepper follows",
                self.exceeded
            );
        }
        text
    }
}

impl<'d> ResultTable for &'d DrivenReport<'_> {
    type Row = DrivenRow<'d>;

    fn len(&self) -> usize {
        self.motion.time.len()
    }

    fn each(&self, visit: Visitor<'_, DrivenRow<'d>>) -> Result<(), Failure> {
        self.motion.rows().try_for_each(|row| visit(&row))
    }

    fn columns(&self) -> Vec<Column<'_, DrivenRow<'d>>> {
        Driven::columns(self.system, &self.parts)
    }

    fn head(&self) -> Vec<(String, Json)> {
        let sums = self.sums().into_iter();
        let work: serde_json::Map<String, Json> = sums
            .map(|(name, value)| (name.to_owned(), json!(value)))
            .collect();
        vec![
            ("work".to_owned(), Json::Object(work)),
            ("exceeded".to_owned(), json!(self.exceeded)),
        ]
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        vec![("work", self.account())]
    }
}

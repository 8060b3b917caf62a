//! Table of the motion of a scene under a recorded input.

use crate::failure::Failure;
use crate::number::computed;
use crate::output::{ResultTable, Visitor};
use frictiongen::answer::Work;
use frictiongen::measure::DrivenMotion;
use frictiongen::measure::columns::{DrivenSample, DrivenTable};
use frictiongen::study::columns::Column;
use serde_json::{Value as Json, json};

/// Motion of a scene under a recorded input, with the options for the output.
pub struct DrivenReport<'s> {
    /// The motions that the output contains.
    pub table: DrivenTable<'s>,
    /// The motion at every sample of the recording.
    pub motion: DrivenMotion,
}

impl DrivenReport<'_> {
    /// Returns the terms of the energy balance, each as a name and an energy in J.
    fn sums(&self) -> [(&'static str, f64); 4] {
        let Work {
            load,
            friction,
            damping,
            stored,
        } = self.motion.work;
        [
            ("load", load),
            ("friction", friction),
            ("damping", damping),
            ("stored", stored),
        ]
    }

    /// Returns the energy that friction has dissipated in each contact, with the name of the contact.
    fn energies(&self) -> Vec<(&str, f64)> {
        self.motion.energies(self.table.names)
    }

    /// Returns a sentence about the energy balance of the motion.
    fn account(&self) -> String {
        let mut text = listed(self.sums());
        if 0 < self.motion.exceeded {
            text += &format!(
                "; {} steps had more events than the stepper follows",
                self.motion.exceeded
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
        self.motion.samples.len()
    }

    fn each(&self, visit: Visitor<'_, DrivenSample>) -> Result<(), Failure> {
        self.motion.samples.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, DrivenSample>> {
        self.table.columns()
    }

    fn head(&self) -> Vec<(String, Json)> {
        vec![
            ("work".to_owned(), object(self.sums())),
            ("friction_energy".to_owned(), object(self.energies())),
            ("exceeded".to_owned(), json!(self.motion.exceeded)),
        ]
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        vec![
            ("work", self.account()),
            ("friction energy", listed(self.energies())),
        ]
    }
}

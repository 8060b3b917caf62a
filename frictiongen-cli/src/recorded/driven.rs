//! The motion of a scene under a recorded input, sample by sample.

use crate::asked::{CONTACT, Part};
use crate::failure::Failure;
use crate::number::{Cell, Exact as _, computed};
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::kernel::stepper::Work;
use frictiongen::measure::Inputs;
use frictiongen::study::{SystemStepper, words};
use frictiongen::{Of, System};
use serde_json::{Value as Json, json};

/// The motion under the recorded inputs.
pub struct Driven {
    /// The moving parts.
    pub parts: Vec<Part>,
    /// The samples in order.
    pub samples: Vec<Sample>,
    work: Work<f64>,
    exceeded: u64,
}

/// State at one sample.
pub struct Sample {
    /// Time, in s.
    pub time: f64,
    /// Displacement and velocity of each part, in m and m/s.
    pub motions: Vec<[f64; 2]>,
    /// Friction force, in N.
    pub force: f64,
    state: &'static str,
    events: u32,
}

impl Driven {
    pub fn of(system: &System, inputs: &Inputs<'_>, parts: Vec<Part>) -> Result<Self, Failure> {
        let turned = system.contact_is_reversed();
        let mut step = system.stepper(inputs.dt()).map_err(|_| {
            Failure::new(format_args!(
                "the samples are {} s apart: too far for the fastest mode of the scene",
                computed(inputs.dt())
            ))
        })?;
        step.begin(inputs.at(0)).map_err(Failure::new)?;
        let mut samples = vec![Sample::of(&step, &parts, turned, 0.0, 0)];
        for sample in 1..inputs.len() {
            let stepped = step.advance(inputs.at(sample)).map_err(|error| {
                Failure::new(format_args!("sample {sample} of the recording: {error}"))
            })?;
            let time = sample as f64 * inputs.dt();
            samples.push(Sample::of(&step, &parts, turned, time, stepped.events));
        }
        Ok(Self {
            parts,
            samples,
            work: step.work(),
            exceeded: step.exceeded(),
        })
    }

    /// Returns the terms of the energy balance, each with its name.
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

    /// Returns the energy balance in words.
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

impl Sample {
    fn of(step: &SystemStepper<'_>, parts: &[Part], turned: bool, time: f64, events: u32) -> Self {
        let contact = step.contact();
        let sign = if turned { -1.0 } else { 1.0 };
        let motions = parts.iter().map(|part| match part.of {
            Of::Contact => [sign * contact.displacement(), sign * contact.velocity()],
            Of::Mass(index) => {
                let mass = step.mass_at(index);
                [mass.displacement(), mass.velocity()]
            }
        });
        let slides = if turned {
            contact.contact().reversed()
        } else {
            contact.contact()
        };
        Self {
            time,
            motions: motions.collect(),
            force: sign * contact.force(),
            state: words::contact(slides),
            events,
        }
    }
}

impl Report for Driven {
    type Point = Sample;

    fn len(&self) -> usize {
        self.samples.len()
    }

    fn each(&self, visit: Visitor<'_, Sample>) -> Result<(), Failure> {
        self.samples.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column> {
        let mut columns = vec![Column::computed(&["time", "(s)"])];
        columns.extend(self.parts.iter().flat_map(|part| {
            [
                Column::computed(&[&part.name, "displacement", "(m)"]),
                Column::computed(&[&part.name, "velocity", "(m/s)"]),
            ]
        }));
        columns.extend([
            Column::computed(&[CONTACT, "friction", "(N)"]),
            Column::words(&[CONTACT, "state"], ["backward"]),
            Column::computed(&["events"]),
        ]);
        columns
    }

    fn rows<'a>(&'a self, sample: &'a Sample) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(sample)]
    }

    fn names(&self) -> Vec<String> {
        let mut names = vec!["time_s".to_owned()];
        names.extend(self.parts.iter().flat_map(|part| {
            [
                format!("{}.displacement_m", part.name),
                format!("{}.velocity_m_per_s", part.name),
            ]
        }));
        names.extend(["friction_N", "state"].map(|what| format!("{CONTACT}.{what}")));
        names.push("events".to_owned());
        names
    }

    fn record<'a>(&'a self, sample: &'a Sample) -> Vec<Cell<'a>> {
        let mut record: Vec<Cell<'a>> = vec![sample.time.into()];
        record.extend(sample.motions.iter().flatten().map(|value| (*value).into()));
        record.extend([
            sample.force.into(),
            sample.state.into(),
            f64::from(sample.events).into(),
        ]);
        record
    }

    fn head(&self) -> Vec<(String, Json)> {
        let work: serde_json::Map<String, Json> = self
            .sums()
            .into_iter()
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

    fn json(&self, sample: &Sample) -> Json {
        self.names()
            .into_iter()
            .zip(self.record(sample))
            .map(|(name, value)| (name, value.json()))
            .collect()
    }
}

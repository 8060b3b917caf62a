//! Writes motions over time of a scene with several contacts.

use super::{Asked, Question};
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::from::{self, state};
use crate::layout::Layout;
use crate::output::{self, ResultTable, Visitor};
#[cfg(feature = "pictures")]
use crate::picture::short;
use crate::recorded::signals;
use crate::time::asked::TimeRequest as Length;
use frictiongen::study::columns::{Column, Frequency, JoinedEventRow, JoinedSample};
use frictiongen::study::joined::JoinedHistory;
use frictiongen::study::scene::Scene;
use serde_json::{Value as Json, json};
use std::io::Write;

/// Length, initial state and form of a motion over time.
pub struct OfTime<'a> {
    /// Number of cycles and of samples, with a flag for one period of a steady state instead of a run.
    pub asked: Length,
    /// Initial state of the motion, as the text of the option `--from`.
    pub from: Option<&'a str>,
    /// End in s of a free vibration or of a motion under `inputs`. `None` for a motion under a harmonic load.
    pub until: Option<f64>,
    /// Inputs over time, as the texts of the option `--input`.
    pub inputs: &'a [String],
    /// True if the output contains the events instead of samples.
    pub events: bool,
}

impl Asked<'_> {
    /// Writes a motion over time of a scene with several contacts.
    pub fn time(
        self,
        scene: Scene,
        time: &OfTime<'_>,
        form: OutputFormat,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        self.question(scene, |question| write(question, time, form, out))
    }
}

/// Writes a motion over time: its samples, its events or a picture.
pub(super) fn write(
    question: &Question<'_>,
    time: &OfTime<'_>,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    question
        .table()
        .check_in_time("--of")
        .map_err(Failure::new)?;
    let draws = form.is_picture();
    let (history, frequency) = history(question, time, draws)?;
    let omega = frequency.omega;
    #[cfg(feature = "pictures")]
    if draws {
        let caption = caption(question, time, frequency)?;
        let motion = (&history, frequency);
        return super::draw::motion(question, motion, &caption, (form, out));
    }
    let (history, mut summary) = (&history, question.summary());
    let inputs = time.inputs;
    if !inputs.is_empty() {
        summary = summary.under_inputs(question.system.scene());
    }
    if time.events {
        let report = EventsReport {
            question,
            history,
            omega,
            inputs,
        };
        return output::write(&report, &summary, form, out);
    }
    let report = SamplesReport {
        question,
        history,
        omega,
        inputs,
    };
    output::write(&report, &summary, form, out)
}

/// Returns the caption of a figure over time: frequency, friction, and the kind of motion (run or steady state).
#[cfg(feature = "pictures")]
fn caption(
    question: &Question<'_>,
    time: &OfTime<'_>,
    frequency: Frequency,
) -> Result<String, Failure> {
    let friction = question.frictions.only()?;
    let friction = friction.at(&question.measure, frequency);
    let frequency = match question.frequencies.are_physical() {
        true => format!("{} Hz", short(frequency.hertz)),
        false => format!("r = {}", short(frequency.r)),
    };
    let friction = match question.measure.scale() {
        Some(_) => format!("F = {} N", short(question.measure.force(friction.beta))),
        None => format!("β = {}", short(friction.beta)),
    };
    if time.until.is_some() {
        let kind = match time.inputs {
            [] => "free vibration".to_owned(),
            inputs => inputs.join("; "),
        };
        return Ok(format!("{friction}; {kind}"));
    }
    let kind = match (time.asked.steady, time.from) {
        (true, _) => "steady state, one period",
        (_, Some(_)) => "motion from a state",
        (_, None) => "motion from rest",
    };
    Ok(format!("{frequency}; {friction}; {kind}"))
}

/// Returns a motion over time and its frequency. If `draws` is true, the motion has additional samples at the events.
fn history(
    question: &Question<'_>,
    time: &OfTime<'_>,
    draws: bool,
) -> Result<(JoinedHistory, Frequency), Failure> {
    let mut frequency = question.frequencies.only(question.system)?;
    let friction = question.frictions.only()?;
    if let Some(until) = time.until {
        // The history has times in s in place of phases.
        frequency.omega = 1.0;
        let from = time.from.filter(|text| text.trim() != from::REST);
        let state = from.map(|text| state(text, question.system, question.measure.scale(), 1.0));
        let state = state.transpose()?;
        let samples = time.asked.samples as usize;
        if !time.inputs.is_empty() {
            let signals = signals::parsed(question.system, time.inputs)?;
            let inputs = signals::inputs(&signals, (until, samples), friction.force())?;
            let state = state.as_ref().map(|(x, v)| (x.as_slice(), v.as_slice()));
            let history = inputs.history(question.joined, state);
            return Ok((history.map_err(Failure::new)?, frequency));
        }
        let masses = question.system.scene().masses.len();
        let (x, v) = state.unwrap_or_else(|| (vec![0.0; masses], vec![0.0; masses]));
        let run = question.joined;
        let run = run.simulation_without_load(friction.force(), (&x, &v));
        let mut run = run.map_err(Failure::new)?;
        let history = run.until(until, time.asked.samples, draws);
        return Ok((history.map_err(Failure::new)?, frequency));
    }
    let friction = friction.at(&question.measure, frequency).beta;
    let at = question.table().at(frequency).map_err(Failure::new)?;
    let asked = &time.asked;
    let (mut run, skip, cycles) = if asked.steady {
        let orbit = at.orbit(friction).map_err(Failure::new)?;
        let cycles = u32::try_from(orbit.period()).unwrap_or(u32::MAX);
        (orbit.simulation().map_err(Failure::new)?, 0, cycles)
    } else {
        let run = match time.from {
            None => at.simulation(friction),
            Some(text) => {
                let scale = question.measure.scale_at(frequency.omega);
                let (x, v) = state(text, question.system, scale, frequency.omega)?;
                at.simulation_from(friction, (&x, &v))
            }
        };
        (run.map_err(Failure::new)?, asked.skip, asked.cycles)
    };
    let history = match draws {
        true => run.path(skip, cycles, asked.samples),
        false => run.history(skip, cycles, asked.samples),
    };
    Ok((history.map_err(Failure::new)?, frequency))
}

/// Returns the JSON fields of the inputs over time.
fn head(inputs: &[String]) -> Vec<(String, Json)> {
    match inputs {
        [] => Vec::new(),
        inputs => vec![("inputs".to_owned(), json!(inputs))],
    }
}

/// Returns the lines of the inputs over time before a table.
fn preamble(inputs: &[String]) -> Vec<(&'static str, String)> {
    inputs.iter().map(|text| ("input", text.clone())).collect()
}

/// The samples of a motion over time, with the options for the output.
struct SamplesReport<'m> {
    question: &'m Question<'m>,
    history: &'m JoinedHistory,
    omega: f64,
    inputs: &'m [String],
}

/// The events of a motion over time, with the options for the output.
struct EventsReport<'m> {
    question: &'m Question<'m>,
    history: &'m JoinedHistory,
    omega: f64,
    inputs: &'m [String],
}

impl<'m> ResultTable for SamplesReport<'m> {
    type Row = JoinedSample<'m>;

    fn len(&self) -> usize {
        self.history.taus.len()
    }

    fn each(&self, visit: Visitor<'_, JoinedSample<'m>>) -> Result<(), Failure> {
        (0..self.len()).try_for_each(|index| {
            visit(&JoinedSample {
                history: self.history,
                index,
                omega: self.omega,
            })
        })
    }

    fn columns(&self) -> Vec<Column<'_, JoinedSample<'m>>> {
        self.question.table().sample_columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lists
    }

    fn head(&self) -> Vec<(String, Json)> {
        head(self.inputs)
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        preamble(self.inputs)
    }
}

impl<'m> ResultTable for EventsReport<'m> {
    type Row = JoinedEventRow<'m>;

    fn len(&self) -> usize {
        self.history.events.len()
    }

    fn each(&self, visit: Visitor<'_, JoinedEventRow<'m>>) -> Result<(), Failure> {
        (0..self.len()).try_for_each(|index| {
            visit(&JoinedEventRow {
                history: self.history,
                index,
                omega: self.omega,
            })
        })
    }

    fn columns(&self) -> Vec<Column<'_, JoinedEventRow<'m>>> {
        self.question.table().event_columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lists
    }

    fn head(&self) -> Vec<(String, Json)> {
        head(self.inputs)
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        preamble(self.inputs)
    }
}

//! A motion over time in non-dimensional groups, with the units of the output.

use super::asked::TimeRequest;
use super::course::RunSettings;
use crate::asked::MOST_HARMONICS;
use crate::failure::Failure;
use crate::from::StateGroups;
use crate::number::{Cell, Lossless as _, computed};
use frictiongen::study::{
    history::{FreeRequest, History, HistoryError, HistoryRequest, Spectrum},
    words,
};
use frictiongen::{NoOrbit, Of};
use serde_json::{Value as Json, json};

/// A motion over time, with the options for the output.
pub struct RunMotion<'a> {
    /// Settings of the motion: frequency, friction, units, and the list of motions.
    pub course: RunSettings<'a>,
    /// Samples and events of the motion.
    pub history: History,
    /// Exact spectrum of each motion. The list is empty unless the user has requested the spectrum of a steady state.
    pub exact: Vec<Spectrum>,
    /// Words for the start of the motion: from rest, from a given state, or a steady state.
    kind: &'static str,
    /// Regime of the motion, if the motion is a steady state. Otherwise `None`.
    regime: Option<&'static str>,
}

impl<'a> RunMotion<'a> {
    /// Computes the motion over time that the user requests.
    pub fn of(
        course: RunSettings<'a>,
        asked: &TimeRequest,
        from: Option<StateGroups>,
    ) -> Result<Self, Failure> {
        let system = course.system;
        let (r, beta) = (course.frequency.r, course.friction.beta);
        let of: Vec<Of> = course.parts.iter().map(|part| part.of).collect();
        let mut exact = Vec::new();
        let mut regime = None;
        let kind = match (asked.steady, &from) {
            (true, _) => "steady",
            (_, Some(_)) => "from a state",
            (_, None) => "from rest",
        };
        let history = if asked.steady {
            let at = system.at(r).map_err(Failure::new)?;
            let response = at.response(beta).map_err(Failure::new)?;
            regime = Some(words::regime(response.regime()));
            let history = response.history(&of, asked.samples).map_err(told)?;
            if asked.spectrum {
                let highest = (asked.samples / 2).min(MOST_HARMONICS);
                let spectra = of.iter();
                exact.extend(spectra.filter_map(|of| response.spectrum(*of, highest)));
            }
            history
        } else {
            let request = HistoryRequest {
                of,
                from,
                amplitude: course.measure.load().map(|load| load.amplitude()),
                skip: asked.skip.into(),
                cycles: asked.cycles,
                samples: asked.samples,
            };
            system.history(r, beta, &request).map_err(told)?
        };
        Ok(Self {
            course,
            history,
            exact,
            kind,
            regime,
        })
    }

    /// Computes the free vibration from a state, with its friction, in SI units.
    pub fn free(
        course: RunSettings<'a>,
        (from, until): (StateGroups, f64),
        samples: u32,
    ) -> Result<Self, Failure> {
        let request = FreeRequest {
            of: course.parts.iter().map(|part| part.of).collect(),
            from,
            until,
            samples,
        };
        let history = course
            .system
            .free_vibration(course.friction.force(), &request);
        Ok(Self {
            history: history.map_err(told)?,
            course,
            exact: Vec::new(),
            kind: "free vibration",
            regime: None,
        })
    }

    /// Returns the frequency and the friction of the motion, each as a name and a value.
    fn point(&self) -> impl Iterator<Item = (String, Cell<'static>)> {
        let (course, setting) = (&self.course, self.course.table().setting);
        let frequency = setting.frequency_columns().into_iter();
        let frequency =
            frequency.map(|column| (column.key(), column.read(&course.frequency).into_owned()));
        let friction = setting.friction_columns().into_iter();
        let friction =
            friction.map(|column| (column.key(), column.read(&course.friction).into_owned()));
        frequency.chain(friction)
    }

    /// Returns the JSON fields that describe the whole motion, not one of its samples.
    pub fn head(&self) -> Vec<(String, Json)> {
        let history = &self.history;
        if self.course.measure.is_free() {
            return vec![
                ("friction_N".to_owned(), json!(self.course.friction.force())),
                ("motion".to_owned(), json!(self.kind)),
                ("until_s".to_owned(), json!(history.cycle)),
                ("samples".to_owned(), json!(history.samples)),
            ];
        }
        let point = self.point();
        let point = point.map(|(name, value)| (name, value.json()));
        let mut head: Vec<(String, Json)> = point.collect();
        head.extend([
            ("motion".to_owned(), json!(self.kind)),
            ("regime".to_owned(), json!(self.regime)),
            ("cycles".to_owned(), json!(history.cycles)),
            ("skipped".to_owned(), json!(history.skipped)),
            ("samples_per_cycle".to_owned(), json!(history.samples)),
        ]);
        head
    }

    /// Returns the lines before the printed table of the motion.
    pub fn preamble(&self) -> Vec<(&'static str, String)> {
        let history = &self.history;
        if self.course.measure.is_free() {
            let friction = computed(self.course.friction.force());
            let (until, samples) = (computed(history.cycle), history.samples);
            return vec![
                ("at", format!("friction_N = {friction}")),
                (
                    "motion",
                    format!("{}, {until} s, {samples} samples", self.kind),
                ),
            ];
        }
        let number = |value: &Cell<'_>| match value {
            Cell::Number(value) | Cell::Within { value, .. } => computed(*value),
            other => other.exact().into_owned(),
        };
        let point = self.point();
        let point: Vec<String> = point
            .map(|(name, value)| format!("{name} = {}", number(&value)))
            .collect();
        let (skipped, cycles) = (history.skipped, u64::from(history.cycles));
        let cycles = match (self.regime, cycles) {
            (Some(regime), 1) => format!("{regime}, one period of 1 cycle"),
            (Some(regime), cycles) => format!("{regime}, one period of {cycles} cycles"),
            (None, cycles) => format!("cycles {skipped} to {}", skipped + cycles),
        };
        vec![
            ("at", point.join(", ")),
            (
                "motion",
                format!(
                    "{}, {cycles}, {} samples a cycle",
                    self.kind, history.samples
                ),
            ),
        ]
    }
}

/// Returns an error message that contains the names of the command's options.
fn told(error: HistoryError) -> Failure {
    match error {
        HistoryError::TooManySamples => {
            Failure::new(format_args!("--cycles and --samples: {error}"))
        }
        HistoryError::Solver(frictiongen::Error::NoOrbit(NoOrbit::Unsettled)) => Failure::new(
            format_args!("--steady: {error}; leave --steady out to see a run"),
        ),
        error => Failure::new(error),
    }
}

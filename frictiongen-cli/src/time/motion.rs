//! A motion over time in non-dimensional groups, with the units in which it is written.

use super::asked::{Asked, Start};
use super::course::Course;
use crate::asked::{CONTACT, MOST_HARMONICS, Part};
use crate::failure::Failure;
use crate::json::object;
use crate::number::{Cell, Exact as _, computed};
use crate::table::Column;
use frictiongen::kernel::simulation::Contact;
use frictiongen::study::{History, HistoryError, HistoryRequest, Spectrum, units, words};
use frictiongen::{NoOrbit, Of, System};
use serde_json::{Map, Value as Json, json};

/// A motion over time.
pub struct Motion {
    /// Frequency, friction, parts and units.
    pub course: Course,
    /// Samples and events.
    pub history: History,
    /// Exact spectrum of each motion, if the user requests the spectrum of a steady state.
    pub exact: Vec<Spectrum>,
    /// Start of the motion in words: from rest, from a state, or a steady state.
    kind: &'static str,
    /// Regime of a steady state.
    regime: Option<&'static str>,
}

impl Motion {
    /// Computes the motion.
    pub fn of(
        system: &System,
        course: Course,
        asked: &Asked,
        from: Option<Start>,
    ) -> Result<Self, Failure> {
        let (r, beta) = (course.frequency.1.r, course.friction.1.beta);
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

    /// Returns whether the sign of the values of this part is reversed.
    pub fn is_turned(&self, of: Of) -> bool {
        of == Of::Contact && self.course.measure.turns_contact()
    }

    /// Returns a value of a part with the sign in which it is asked for.
    pub fn signed(&self, of: Of, value: f64) -> f64 {
        // The subtraction avoids −0.
        if self.is_turned(of) {
            0.0 - value
        } else {
            value
        }
    }

    /// Returns a displacement of a part in its unit.
    pub fn displacement(&self, of: Of, value: f64) -> Cell<'static> {
        let value = self.signed(of, value);
        self.course.measure.length(value).into()
    }

    /// Returns the state of the contact in a word.
    pub fn state(&self, contact: Contact) -> &'static str {
        let contact = match self.is_turned(Of::Contact) {
            true => contact.reversed(),
            false => contact,
        };
        words::contact(contact)
    }

    /// Returns the cells of an instant.
    pub fn time(&self, tau: f64) -> Vec<Cell<'static>> {
        let seconds = units::seconds(tau, self.course.omega);
        let seconds = self.course.in_seconds.then_some(seconds);
        seconds.into_iter().chain([tau]).map(Cell::from).collect()
    }

    /// Returns the names of the cells of an instant.
    pub fn time_names(&self) -> &'static [&'static str] {
        match self.course.in_seconds {
            true => &["time_s", "tau"],
            false => &["tau"],
        }
    }

    /// Returns the columns of an instant.
    pub fn time_columns(&self) -> Vec<Column> {
        let seconds = self.course.in_seconds;
        let seconds = seconds.then(|| Column::computed(&["time", "(s)"]));
        let tau = Column::computed(&["tau"]);
        seconds.into_iter().chain([tau]).collect()
    }

    /// Returns the column of the contact's state.
    pub fn state_column() -> Column {
        Column::words(&[CONTACT, "state"], ["backward"])
    }

    /// Returns the name of a cell of a part.
    pub fn name(part: &Part, what: &str) -> String {
        format!("{}.{what}", part.name)
    }

    /// Returns a point as JSON, with an object for the contact and a list for the masses.
    pub fn json(&self, names: Vec<String>, values: &[Cell<'_>]) -> Json {
        let (mut point, mut contact) = (Map::new(), Map::new());
        let mut masses: Vec<Map<String, Json>> = Vec::new();
        for (name, value) in names.iter().zip(values) {
            let value = value.json();
            match name.split_once('.') {
                None => drop(point.insert(name.clone(), value)),
                Some((CONTACT, what)) => drop(contact.insert(what.to_owned(), value)),
                Some((mass, what)) => {
                    let is_same =
                        |last: &&mut Map<String, Json>| last.get("name") == Some(&mass.into());
                    if let Some(last) = masses.last_mut().filter(is_same) {
                        last.insert(what.to_owned(), value);
                    } else {
                        masses.push(object([("name", mass.into()), (what, value)]));
                    }
                }
            }
        }
        if !contact.is_empty() {
            point.insert(CONTACT.to_owned(), Json::Object(contact));
        }
        let masses = masses.into_iter().map(Json::Object);
        point.insert("masses".to_owned(), masses.collect());
        Json::Object(point)
    }

    /// Returns frequency and friction with their names.
    fn point(&self) -> impl Iterator<Item = (&'static str, Cell<'static>)> {
        let (names, frequency) = self.course.frequency;
        let frequency = names.iter().copied().zip(frequency.values());
        let (names, friction) = self.course.friction;
        frequency.chain(names.iter().copied().zip(friction.values()))
    }

    /// Returns the fields that the JSON has once.
    pub fn head(&self) -> Vec<(String, Json)> {
        let history = &self.history;
        let point = self.point();
        let point = point.map(|(name, value)| (name.to_owned(), value.json()));
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

    /// Returns the lines that a table has once.
    pub fn preamble(&self) -> Vec<(&'static str, String)> {
        let history = &self.history;
        let number = |value: &Cell<'_>| match value {
            Cell::Number(value) => computed(*value),
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

/// Makes the message for an error, with the names of the options.
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

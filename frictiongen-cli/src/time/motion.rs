//! The motion over time that is written, in groups, and what it is counted in.

use super::asked::{Asked, Start};
use super::course::Course;
use crate::asked::{CONTACT, MOST_HARMONICS, Part};
use crate::failure::Failure;
use crate::json::object;
use crate::number::{Value, computed};
use crate::table::Column;
use frictiongen::kernel::simulation::Contact;
use frictiongen::study::{History, HistoryError, HistoryRequest, Spectrum, units, words};
use frictiongen::{NoOrbit, Of, System};
use serde_json::{Map, Value as Json, json};

/// A motion over time.
pub struct Motion {
    /// Where and whose.
    pub course: Course,
    /// Its samples and events.
    pub history: History,
    /// Of a steady state whose spectrum is asked for, that of each motion.
    pub exact: Vec<Spectrum>,
    /// From rest, from a state, or a steady state.
    kind: &'static str,
    /// The regime of a steady state.
    regime: Option<&'static str>,
}

impl Motion {
    /// Computes it.
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

    /// Whether the sign of what belongs to this part is turned round.
    pub fn is_turned(&self, of: Of) -> bool {
        of == Of::Contact && self.course.measure.turns_contact()
    }

    /// A number of a part, with the sign that it is asked for with.
    pub fn signed(&self, of: Of, value: f64) -> f64 {
        // Not −0.
        if self.is_turned(of) {
            0.0 - value
        } else {
            value
        }
    }

    /// A displacement of a part.
    pub fn displacement(&self, of: Of, value: f64) -> Value<'static> {
        let value = self.signed(of, value);
        self.course.measure.length(value).into()
    }

    /// What the contact does, in a word.
    pub fn state(&self, contact: Contact) -> &'static str {
        let contact = match self.is_turned(Of::Contact) {
            true => contact.reversed(),
            false => contact,
        };
        words::contact(contact)
    }

    /// The cells of an instant.
    pub fn time(&self, tau: f64) -> Vec<Value<'static>> {
        let seconds = units::seconds(tau, self.course.omega);
        let seconds = self.course.in_seconds.then_some(seconds);
        seconds.into_iter().chain([tau]).map(Value::from).collect()
    }

    /// The names of those.
    pub fn time_names(&self) -> &'static [&'static str] {
        match self.course.in_seconds {
            true => &["time_s", "tau"],
            false => &["tau"],
        }
    }

    /// The columns of those.
    pub fn time_columns(&self) -> Vec<Column> {
        let seconds = self.course.in_seconds;
        let seconds = seconds.then(|| Column::computed(&["time", "(s)"]));
        let tau = Column::computed(&["tau"]);
        seconds.into_iter().chain([tau]).collect()
    }

    /// The column of the contact's state.
    pub fn state_column() -> Column {
        Column::words(&[CONTACT, "state"], ["backward"])
    }

    /// The name of a cell of a part.
    pub fn name(part: &Part, what: &str) -> String {
        format!("{}.{what}", part.name)
    }

    /// A point in the JSON: what belongs to the contact in an object, what belongs to masses in a list.
    pub fn json(&self, names: Vec<String>, values: &[Value<'_>]) -> Json {
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

    /// Frequency and friction, by their names.
    fn point(&self) -> impl Iterator<Item = (&'static str, Value<'static>)> {
        let (names, frequency) = self.course.frequency;
        let frequency = names.iter().copied().zip(frequency.values());
        let (names, friction) = self.course.friction;
        frequency.chain(names.iter().copied().zip(friction.values()))
    }

    /// What the JSON says once.
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

    /// What a table says once.
    pub fn preamble(&self) -> Vec<(&'static str, String)> {
        let history = &self.history;
        let number = |value: &Value<'_>| match value {
            Value::Number(value) => computed(*value),
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

/// What the options have to say to an error.
fn told(error: HistoryError) -> Failure {
    match error {
        HistoryError::TooManySamples => {
            Failure::new(format_args!("--cycles and --samples: {error}"))
        }
        HistoryError::Solver(frictiongen::Error::NoOrbit(NoOrbit::Unsettled)) => Failure::new(
            format_args!("--steady: {error}; without --steady a run shows it"),
        ),
        error => Failure::new(error),
    }
}

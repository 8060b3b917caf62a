//! Rows and columns of the derivatives of steady states with several contacts.

use super::builder::Columns;
use super::column::{Column, Head, Row, Shown};
use super::joined::reason;
use super::measure::Dimension;
use super::sensitivity::ITSELF;
use super::setting::{AtFrequency, AtFriction, Frequency, Friction, Setting};
use crate::study::StudyError;
use crate::study::joined::{Joined, JoinedError, JoinedSensitivity};
use crate::study::parameter::Slope;
use crate::study::sensitivity::OperatingPoint;
use crate::study::words;

/// A row: the derivatives of one number with respect to one parameter at one operating point.
#[derive(Clone, Debug)]
pub struct JoinedSensitivityRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// The common friction, as ratio β and, under a load, as force in N.
    pub friction: Friction,
    /// Regime: continuous, stick-slip or stuck.
    pub regime: &'static str,
    /// The word `exact`, or the reason why there are no derivatives.
    pub answer: &'static str,
    found: Option<FoundSlope>,
}

#[derive(Clone, Debug)]
struct FoundSlope {
    symbol: String,
    unit: &'static str,
    value: f64,
    slope: Slope,
    /// True for the row with the value itself instead of its derivatives.
    itself: bool,
}

/// Number whose derivatives the table contains.
#[derive(Clone, Debug, PartialEq)]
pub enum JoinedNumber {
    /// The amplitude of the mass with this index and this name.
    Amplitude(usize, String),
    /// The energy that the contact with this index and this name dissipates in a period.
    Energy(usize, String),
}

/// The table of derivatives with respect to the parameters, at points of frequency and friction.
#[derive(Clone, Copy)]
pub struct JoinedSensitivityTable<'a> {
    /// System, units, and frequencies and frictions as the user gave them.
    pub setting: Setting<'a>,
    /// The scene's contacts and masses.
    pub joined: &'a Joined<'a>,
    /// The number whose derivatives the table contains.
    pub of: &'a JoinedNumber,
}

impl Row for JoinedSensitivityRow {}

impl AtFrequency for JoinedSensitivityRow {
    fn frequency(&self) -> Frequency {
        self.frequency
    }
}

impl AtFriction for JoinedSensitivityRow {
    fn friction(&self) -> Friction {
        self.friction
    }
}

impl JoinedNumber {
    /// Returns the number with its derivative.
    fn read(&self, of: &JoinedSensitivity) -> Option<Slope> {
        match self {
            Self::Amplitude(mass, _) => of.amplitudes.get(*mass).copied(),
            Self::Energy(contact, _) => of.energies.get(*contact).copied(),
        }
    }

    /// Returns the word for the number, its dimension, and the name of its mass or contact.
    fn told(&self) -> (&'static str, Dimension, &str) {
        match self {
            Self::Amplitude(_, name) => ("amplitude", Dimension::Length, name),
            Self::Energy(_, name) => ("energy", Dimension::Energy, name),
        }
    }
}

impl JoinedSensitivityRow {
    /// Returns the row with the value itself instead of its derivatives. Returns `None` if there is no value.
    #[must_use]
    pub fn itself(&self) -> Option<Self> {
        let mut row = self.clone();
        let found = row.found.as_mut()?;
        ITSELF.clone_into(&mut found.symbol);
        found.itself = true;
        Some(row)
    }

    /// Returns the parameter of the row. Returns `None` for the row with the value itself.
    fn parameter(&self) -> Option<&FoundSlope> {
        self.found.as_ref().filter(|found| !found.itself)
    }
}

impl<'a> JoinedSensitivityTable<'a> {
    /// Returns the operating point at a frequency and a friction.
    fn point(&self, frequency: Frequency, friction: Friction) -> OperatingPoint {
        match self.setting.measure.load() {
            Some(load) => OperatingPoint::Physical {
                hertz: frequency.hertz,
                friction: friction.force(),
                load,
            },
            None => OperatingPoint::Groups {
                r: frequency.r,
                beta: friction.beta,
            },
        }
    }

    /// Computes the rows at an operating point, one for each parameter. If no derivatives exist, a single row contains
    /// the reason.
    ///
    /// # Errors
    /// [`JoinedError`] for a frequency or a friction outside the domain.
    pub fn rows(
        &self,
        frequency: Frequency,
        friction: Friction,
    ) -> Result<Vec<JoinedSensitivityRow>, JoinedError> {
        let friction = friction.at(&self.setting.measure, frequency);
        let point = self.point(frequency, friction);
        let row = |regime, answer, found| JoinedSensitivityRow {
            frequency,
            friction,
            regime,
            answer,
            found,
        };
        let none = |answer| Ok(vec![row("", answer, None)]);
        let known = match self.joined.sensitivities(point) {
            Ok(known) => known,
            Err(JoinedError::NoDerivative(error)) => {
                let word = words::no_derivative(&StudyError::NoDerivative(error));
                return none(word.unwrap_or("bend"));
            }
            Err(JoinedError::Engine(error)) => return none(reason(&error)),
            Err(error) => return Err(error),
        };
        let scene = self.joined.scene();
        let regime = words::regime(known.regime);
        let found = known.parameters.iter().filter_map(|of| {
            let found = FoundSlope {
                symbol: of.parameter.symbol(scene, &point),
                unit: of.parameter.unit(&point),
                value: of.value,
                slope: self.of.read(of)?,
                itself: false,
            };
            Some(row(regime, "exact", Some(found)))
        });
        Ok(found.collect())
    }

    /// Returns the columns.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, JoinedSensitivityRow>> {
        let measure = self.setting.measure;
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("regime", "continuous", |row: &JoinedSensitivityRow| {
            Some(row.regime)
        });
        columns.word("answer", "unsettled", |row| Some(row.answer));
        let head = Head::new("parameter").titled(&["parameter", "p"]);
        columns.word(head, &self.widest(), |row: &JoinedSensitivityRow| {
            Some(&row.found.as_ref()?.symbol)
        });
        columns.number("value", |row| Some(row.parameter()?.value));
        columns.word("unit", "N s/m", |row: &JoinedSensitivityRow| {
            Some(row.parameter()?.unit)
        });
        let (name, dimension, of) = self.of.told();
        let value = |row: &JoinedSensitivityRow| Some(row.found.as_ref()?.slope.value);
        columns.show(Shown::Files);
        columns.converted(Head::of(name, dimension), value);
        columns.show(Shown::Everywhere);
        let title = format!("{name} {of}");
        let own = measure.name(name, dimension);
        let unit = measure.title(dimension);
        let head = Head::new(format!("{own}.derivative"));
        let head = head.titled(&[&title, &format!("X {unit}, d/dp")]);
        columns.number(head, move |row| match row.parameter() {
            Some(found) => Some(found.slope.derivative),
            None => value(row),
        });
        let head = Head::new(format!("{own}.relative")).titled(&["", "(p/X) d/dp"]);
        columns.number(head, |row| {
            let found = row.parameter()?;
            found.slope.relative(found.value)
        });
        columns.done()
    }

    /// Returns a word that is as long as the longest symbol of a parameter. The table uses it to set the width of the
    /// column.
    fn widest(&self) -> String {
        let scene = self.joined.scene();
        let masses = scene.masses.iter().map(|mass| mass.name.len() + 2);
        let contacts = self.joined.contact_names().into_iter();
        let contacts = contacts.map(|name| name.len() + "stiffness ".len());
        let springs = scene.springs.iter().map(|spring| (spring.from, spring.to));
        let dampers = scene.joints.dampers.iter();
        let links = springs.chain(dampers.map(|damper| (damper.from, damper.to)));
        let links =
            links.map(|(from, to)| scene.node_name(from).len() + scene.node_name(to).len() + 5);
        let widest = masses.chain(contacts).chain(links).max().unwrap_or(0);
        "-".repeat(widest.max(ITSELF.len()))
    }
}

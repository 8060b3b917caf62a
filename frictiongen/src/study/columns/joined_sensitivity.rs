//! Rows and columns of the derivatives of steady states with several contacts.

use super::builder::Columns;
use super::column::{Column, Head, Shown};
use super::joined::reason;
use super::measure::PhysicalQuantity;
use super::sensitivity::{FoundSlope, SensitivityRow, of_parameter, widest};
use super::setting::{Frequency, FrictionSetting, Setting};
use crate::study::StudyError;
use crate::study::joined::{Joined, JoinedError, JoinedSensitivity};
use crate::study::parameter::Slope;
use crate::study::words;

/// A row of the table: one number and its derivative with respect to one parameter at one operating point.
pub type JoinedSensitivityRow = SensitivityRow<Slope>;

/// The number whose derivatives the table contains.
#[derive(Clone, Debug, PartialEq)]
pub enum JoinedNumber {
    /// The amplitude of a mass, given by its index and its name.
    Amplitude(usize, String),
    /// The energy that the contact with this index and this name dissipates in a period.
    Energy(usize, String),
}

/// The table of derivatives of a steady state with several contacts, with respect to the parameters, at points of
/// frequency and friction.
#[derive(Clone, Copy)]
pub struct JoinedSensitivityTable<'a> {
    /// System, units, and frequencies and frictions as the user gave them.
    pub setting: Setting<'a>,
    /// The scene's contacts and masses.
    pub joined: &'a Joined<'a>,
    /// The number whose derivatives the table contains.
    pub of: &'a JoinedNumber,
}

impl JoinedNumber {
    /// Returns the energy that the contact called `name` dissipates, or the amplitude of the mass called `name`.
    ///
    /// # Errors
    /// A message, which begins with the name of the `argument` that contains the name.
    pub fn named(joined: &Joined<'_>, argument: &str, name: &str) -> Result<Self, String> {
        let contacts = joined.contact_names();
        if let Some(contact) = contacts.iter().position(|known| known == name) {
            return Ok(Self::Energy(contact, name.to_owned()));
        }
        let masses = || joined.scene().masses.iter();
        match masses().position(|mass| mass.name == name) {
            Some(mass) => Ok(Self::Amplitude(mass, name.to_owned())),
            None => Err(format!(
                "{argument} `{name}`: it is neither a mass nor a contact; give one of the masses {} or of the contacts {}",
                masses()
                    .map(|mass| mass.name.as_str())
                    .collect::<Vec<_>>()
                    .join(", "),
                contacts.join(", ")
            )),
        }
    }

    /// Reads the number of the table, with its derivative, from the sensitivities.
    fn read(&self, of: &JoinedSensitivity) -> Option<Slope> {
        match self {
            Self::Amplitude(mass, _) => of.amplitudes.get(*mass).copied(),
            Self::Energy(contact, _) => of.energies.get(*contact).copied(),
        }
    }

    /// Returns three items for the number of the table: its word, its physical quantity, and the name of the mass or
    /// contact.
    fn told(&self) -> (&'static str, PhysicalQuantity, &str) {
        match self {
            Self::Amplitude(_, name) => ("amplitude", PhysicalQuantity::Length, name),
            Self::Energy(_, name) => ("energy", PhysicalQuantity::Energy, name),
        }
    }
}

impl<'a> JoinedSensitivityTable<'a> {
    /// Computes the rows at an operating point, one for each parameter. If no derivatives exist, a single row contains
    /// the reason.
    ///
    /// # Errors
    /// [`JoinedError`] for a frequency or a friction outside the domain.
    pub fn rows(
        &self,
        frequency: Frequency,
        friction: FrictionSetting,
    ) -> Result<Vec<JoinedSensitivityRow>, JoinedError> {
        let friction = friction.at(&self.setting.measure, frequency);
        let point = self.setting.point(frequency, friction);
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
                answers: self.of.read(of)?,
                itself: false,
            };
            Some(row(regime, "difference", Some(found)))
        });
        Ok(found.collect())
    }

    /// Returns the columns of the table of derivatives.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, JoinedSensitivityRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("regime", "continuous", |row: &JoinedSensitivityRow| {
            Some(row.regime)
        });
        columns.word("answer", "unsettled", |row| Some(row.answer));
        self.add(&mut columns);
        columns.done()
    }

    /// Returns the columns of the parameters, without the columns of the operating point.
    #[must_use]
    pub fn parameter_columns(&self) -> Vec<Column<'a, JoinedSensitivityRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.add(&mut columns);
        columns.done()
    }

    fn add(&self, columns: &mut Columns<'a, JoinedSensitivityRow>) {
        let measure = self.setting.measure;
        of_parameter(columns, &self.widest(), "N s/m");
        let (name, dimension, of) = self.of.told();
        let value = |row: &JoinedSensitivityRow| Some(row.found.as_ref()?.answers.value);
        columns.show(Shown::Files);
        columns.converted(Head::of(name, dimension), value);
        columns.show(Shown::Everywhere);
        let title = format!("{name} {of}");
        let own = measure.name(name, dimension);
        let unit = measure.title(dimension);
        let head = Head::new(format!("{own}.derivative"));
        let head = head.titled(&[&title, &format!("X {unit}, d/dp")]);
        columns.number(head, move |row| match row.parameter() {
            Some(found) => Some(found.answers.derivative),
            None => value(row),
        });
        let head = Head::new(format!("{own}.relative")).titled(&["", "(p/X) d/dp"]);
        columns.number(head, |row| {
            let found = row.parameter()?;
            found.answers.relative(found.value)
        });
    }

    /// Returns a word that is as long as the longest symbol of a parameter.
    fn widest(&self) -> String {
        let scene = self.joined.scene();
        let contacts = self.joined.contact_names().into_iter();
        let contacts = contacts.map(|name| name.len() + "stiffness ".len());
        let dampers = scene.joints.dampers.iter().map(|damper| {
            scene.node_name(damper.from).len() + scene.node_name(damper.to).len() + 5
        });
        widest(scene, contacts.chain(dampers))
    }
}

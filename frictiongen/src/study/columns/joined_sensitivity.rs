//! Rows and columns of the derivatives of steady states with several contacts.

use super::builder::Columns;
use super::column::Column;
use super::joined::reason;
use super::measure::PhysicalQuantity;
use super::sensitivity::{FoundSlope, SensitivityRow, SlopedAnswer, of_parameter, widest};
use super::setting::{Frequency, FrictionSetting, Setting};
use crate::study::StudyError;
use crate::study::joined::{ContactSensitivity, Joined, JoinedError, JoinedSensitivity};
use crate::study::parameter::Slope;
use crate::study::words;

/// A row of the table: the derivatives of a steady state with respect to one parameter at one operating point.
pub type JoinedSensitivityRow = SensitivityRow<JoinedSensitivity>;

/// The mass or contact whose derivatives the table contains, by its index and its name.
#[derive(Clone, Debug, PartialEq)]
pub enum JoinedPart {
    /// The amplitude and the phase of a mass.
    Mass(usize, String),
    /// The energy, force, slip, displacement and stuck fraction of a contact or stop.
    Contact(usize, String),
}

/// The table of derivatives of a steady state with several contacts, with respect to the parameters, at points of
/// frequency and friction.
#[derive(Clone, Copy)]
pub struct JoinedSensitivityTable<'a> {
    /// System, units, and frequencies and frictions as the user gave them.
    pub setting: Setting<'a>,
    /// The scene's contacts and masses.
    pub joined: &'a Joined<'a>,
    /// The mass or contact whose derivatives the table contains.
    pub of: &'a JoinedPart,
}

/// A number of a contact, whose derivatives the table contains.
type OfContact = (
    &'static str,
    PhysicalQuantity,
    fn(&ContactSensitivity) -> Slope,
);

/// The numbers of a contact, in the order of their columns.
const OF_CONTACT: [OfContact; 5] = [
    ("energy", PhysicalQuantity::Energy, |own| own.energy),
    ("force", PhysicalQuantity::Force, |own| own.force),
    ("slip", PhysicalQuantity::Length, |own| own.slip),
    ("displacement", PhysicalQuantity::Length, |own| {
        own.displacement
    }),
    ("stuck_fraction", PhysicalQuantity::One, |own| {
        own.stuck_fraction
    }),
];

impl JoinedPart {
    /// Returns the contact or the mass called `name`.
    ///
    /// # Errors
    /// A message, which begins with the name of the `argument` that contains the name.
    pub fn named(joined: &Joined<'_>, argument: &str, name: &str) -> Result<Self, String> {
        let contacts = joined.contact_names();
        if let Some(contact) = contacts.iter().position(|known| known == name) {
            return Ok(Self::Contact(contact, name.to_owned()));
        }
        let masses = || joined.scene().masses.iter();
        match masses().position(|mass| mass.name == name) {
            Some(mass) => Ok(Self::Mass(mass, name.to_owned())),
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
        let found = known.parameters.into_iter().map(|of| {
            let found = FoundSlope {
                symbol: of.parameter.symbol(scene, &point),
                unit: of.parameter.unit(&point),
                value: of.value,
                answers: of,
                itself: false,
            };
            row(regime, "exact", Some(found))
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
        match self.of {
            JoinedPart::Mass(mass, name) => {
                let mass = *mass;
                let amplitude = SlopedAnswer {
                    name: "amplitude",
                    dimension: PhysicalQuantity::Length,
                    read: move |of: &JoinedSensitivity| of.amplitudes.get(mass).copied(),
                };
                let title = format!("amplitude {name}");
                amplitude.add(
                    columns,
                    &measure,
                    (&title, measure.title(PhysicalQuantity::Length)),
                );
                let phase = SlopedAnswer {
                    name: "phase",
                    dimension: PhysicalQuantity::Angle,
                    read: move |of: &JoinedSensitivity| *of.phases.get(mass)?,
                };
                phase.add(
                    columns,
                    &measure,
                    ("phase", measure.title(PhysicalQuantity::Angle)),
                );
            }
            JoinedPart::Contact(contact, of) => {
                let contact = *contact;
                for (place, (name, dimension, read)) in OF_CONTACT.into_iter().enumerate() {
                    let answer = SlopedAnswer {
                        name,
                        dimension,
                        read: move |of: &JoinedSensitivity| of.contacts.get(contact).map(read),
                    };
                    let title = name.replace('_', " ");
                    let title = if place == 0 {
                        format!("{title} {of}")
                    } else {
                        title
                    };
                    answer.add(columns, &measure, (&title, measure.title(dimension)));
                }
            }
        }
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

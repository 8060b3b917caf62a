//! Rows and columns of the table of derivatives with respect to the parameters.

use super::builder::Columns;
use super::column::{Column, Head, Shown, TableRow};
use super::measure::{Measure, PhysicalQuantity};
use super::setting::{AtFrequency, AtFriction, Frequency, FrictionSetting, Setting};
use crate::study::{
    StudyError,
    sensitivity::{ParameterSensitivity, ResponseSensitivities, Slope},
    words,
};
use frictiongen_model::scene::Scene;

/// Symbol in the row that contains the answers instead of their derivatives. An answer is a result such as the
/// amplitude.
const ITSELF: &str = "the answer";

/// A row of the table: the derivatives of the answers (amplitude, phase, limits of friction) with respect to one
/// parameter at one operating point. `D` contains the answers with their derivatives.
#[derive(Clone, Debug)]
pub struct SensitivityRow<D = ParameterSensitivity> {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Friction, as ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// Regime of the response: continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// The word `exact`, or the reason why there are no derivatives.
    pub answer: &'static str,
    pub(super) found: Option<FoundSlope<D>>,
}

/// A parameter, and the answers with their derivatives with respect to this parameter.
#[derive(Clone, Debug)]
pub(super) struct FoundSlope<D> {
    pub symbol: String,
    pub unit: &'static str,
    /// Value of the parameter with respect to which the row has derivatives.
    pub value: f64,
    pub answers: D,
    /// True for the row that contains the answers instead of their derivatives.
    pub itself: bool,
}

/// The table of derivatives with respect to the parameters, at points of frequency and friction.
#[derive(Clone, Copy)]
pub struct SensitivityTable<'a> {
    /// System, units, and the contact or mass whose motion is differentiated.
    pub setting: Setting<'a>,
}

/// An answer X, such as an amplitude, whose derivatives a table contains.
#[derive(Clone, Copy)]
pub(super) struct SlopedAnswer<R> {
    pub name: &'static str,
    pub dimension: PhysicalQuantity,
    /// Reads the answer with its derivative.
    pub read: R,
}

/// Function that reads an answer of a scene with one contact.
type Read = fn(&ParameterSensitivity) -> Option<Slope>;

/// The answers of the table, in the order of their columns.
const ANSWERS: [SlopedAnswer<Read>; 4] = [
    SlopedAnswer {
        name: "amplitude",
        dimension: PhysicalQuantity::Length,
        read: |of| Some(of.amplitude),
    },
    SlopedAnswer {
        name: "phase",
        dimension: PhysicalQuantity::Angle,
        read: |of| of.phase,
    },
    SlopedAnswer {
        name: "continuous_limit",
        dimension: PhysicalQuantity::Force,
        read: |of| of.continuous_limit,
    },
    SlopedAnswer {
        name: "sliding_limit",
        dimension: PhysicalQuantity::Force,
        read: |of| of.sliding_limit,
    },
];

impl<D> TableRow for SensitivityRow<D> {}

impl<D> AtFrequency for SensitivityRow<D> {
    fn frequency(&self) -> Frequency {
        self.frequency
    }
}

impl<D> AtFriction for SensitivityRow<D> {
    fn friction(&self) -> FrictionSetting {
        self.friction
    }
}

impl<D: Clone> SensitivityRow<D> {
    /// Returns the row that contains the answers instead of their derivatives. Returns `None` if there are no answers.
    #[must_use]
    pub fn itself(&self) -> Option<Self> {
        let mut row = self.clone();
        let found = row.found.as_mut()?;
        ITSELF.clone_into(&mut found.symbol);
        found.itself = true;
        Some(row)
    }

    /// Returns the parameter of the row. Returns `None` for the row that contains the answers instead of derivatives.
    pub(super) fn parameter(&self) -> Option<&FoundSlope<D>> {
        self.found.as_ref().filter(|found| !found.itself)
    }
}

/// Adds the columns with symbol, value and unit of the parameter. The column of symbols is as wide as `widest`, and the
/// column of units as wide as `unit`.
pub(super) fn of_parameter<'a, D: Clone + 'a>(
    columns: &mut Columns<'a, SensitivityRow<D>>,
    widest: &str,
    unit: &str,
) {
    let head = Head::new("parameter").titled(&["parameter", "p"]);
    columns.word(head, widest, |row: &SensitivityRow<D>| {
        Some(&row.found.as_ref()?.symbol)
    });
    columns.number("value", |row| Some(row.parameter()?.value));
    columns.word("unit", unit, |row: &SensitivityRow<D>| {
        Some(row.parameter()?.unit)
    });
}

/// Returns a word that is as long as the longest symbol of a parameter. Tables take the width of the column from this
/// word. `others` contains the lengths of all symbols that denote neither a mass nor a spring.
pub(super) fn widest(scene: &Scene, others: impl Iterator<Item = usize>) -> String {
    let masses = scene.masses.iter().map(|mass| mass.name.len() + 2);
    let springs = scene
        .springs
        .iter()
        .map(|spring| scene.node_name(spring.from).len() + scene.node_name(spring.to).len() + 5);
    let widest = masses.chain(springs).chain(others).max().unwrap_or(0);
    "-".repeat(widest.max(ITSELF.len()))
}

impl<'a> SensitivityTable<'a> {
    /// Returns the rows at an operating point, one for each parameter. If no derivatives exist, a single row contains
    /// the reason.
    ///
    /// # Errors
    /// An error of the computation, if the table has no word for this error.
    pub fn rows(
        &self,
        frequency: Frequency,
        friction: FrictionSetting,
        known: Result<ResponseSensitivities, StudyError>,
    ) -> Result<Vec<SensitivityRow>, StudyError> {
        let row = |regime, answer, found| SensitivityRow {
            frequency,
            friction,
            regime,
            answer,
            found,
        };
        let known = match known {
            Ok(known) => known,
            Err(error) => {
                return match words::no_derivative(&error) {
                    Some(answer) => Ok(vec![row("", answer, None)]),
                    None => Err(error),
                };
            }
        };
        let (point, regime) = (
            self.setting.point(frequency, friction),
            words::regime(known.regime),
        );
        let scene = self.setting.system.scene();
        let found = known.parameters.into_iter().map(|sensitivity| FoundSlope {
            symbol: sensitivity.parameter.symbol(scene, &point),
            unit: sensitivity.parameter.unit(&point),
            value: sensitivity.value,
            answers: sensitivity,
            itself: false,
        });
        Ok(found
            .map(|found| row(regime, "exact", Some(found)))
            .collect())
    }

    /// Returns all columns: those of frequency, friction and regime, and those of the parameters.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, SensitivityRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("regime", "continuous", |row: &SensitivityRow| {
            Some(row.regime)
        });
        columns.word("answer", "degenerate", |row| Some(row.answer));
        self.add(&mut columns);
        columns.done()
    }

    /// Returns the columns of the parameters, without the columns of the operating point.
    #[must_use]
    pub fn parameter_columns(&self) -> Vec<Column<'a, SensitivityRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.add(&mut columns);
        columns.done()
    }

    fn add(&self, columns: &mut Columns<'a, SensitivityRow>) {
        let scene = self.setting.system.scene();
        of_parameter(columns, &widest(scene, std::iter::empty()), "N/m");
        for (place, answer) in ANSWERS.into_iter().enumerate() {
            let title = answer.name.replace('_', " ");
            let title = match self.setting.parts.first() {
                Some(part) if place == 0 => format!("{title} {}", part.name),
                _ => title,
            };
            let measure = self.setting.measure;
            let unit = match (answer.dimension, measure.scale()) {
                (PhysicalQuantity::Force, None) => "(beta)",
                (dimension, _) => measure.title(dimension),
            };
            answer.add(columns, &measure, (&title, unit));
        }
    }
}

impl<R> SlopedAnswer<R> {
    /// Adds the columns of an answer: value, derivative, and relative derivative. `told` contains the heading and the unit.
    /// Under a load, all numbers are already in SI units, but phases are in rad.
    pub(super) fn add<'a, D: Clone + 'a>(
        self,
        columns: &mut Columns<'a, SensitivityRow<D>>,
        measure: &Measure,
        (title, unit): (&str, &str),
    ) where
        R: Fn(&D) -> Option<Slope> + Copy + 'a,
    {
        let (measure, read) = (*measure, self.read);
        let is_phase = self.dimension == PhysicalQuantity::Angle;
        let counted = move |value: f64| match is_phase {
            true => measure.angle(value),
            false => value,
        };
        let slope = move |row: &SensitivityRow<D>| {
            let found = row.found.as_ref()?;
            Some((found.value, read(&found.answers)?))
        };
        let value = move |row: &SensitivityRow<D>| Some(counted(slope(row)?.1.value));
        let name = measure.name(self.name, self.dimension);
        columns.show(Shown::Files);
        columns.converted(Head::of(self.name, self.dimension), value);
        columns.show(Shown::Everywhere);
        let head = Head::new(format!("{name}.derivative"));
        let head = head.titled(&[title, &format!("X {unit}, d/dp")]);
        columns.number(head, move |row| match row.parameter() {
            Some(_) => Some(counted(slope(row)?.1.derivative)),
            None => value(row),
        });
        let relative = if is_phase { "p d/dp" } else { "(p/X) d/dp" };
        let head = Head::new(format!("{name}.relative")).titled(&["", relative]);
        columns.number(head, move |row| {
            row.parameter()?;
            let (parameter, slope) = slope(row)?;
            match is_phase {
                true => Some(parameter * counted(slope.derivative)),
                false => slope.relative(parameter),
            }
        });
    }
}

//! The setting that all tables have in common: system, units, frequencies, frictions and motions.

use super::builder::Columns;
use super::column::{Column, ColumnAxis, Head, TableRow};
use super::measure::{Measure, PhysicalQuantity};
use crate::Of;
use crate::study::sensitivity::OperatingPoint;
use crate::study::{
    System, UnknownMotion,
    response::MotionQuantity,
    scene::Excitation,
    units::{self, LoadScale},
};

/// A moving part (the contact, a mass, or a combination of masses and base), and a quantity of its motion.
#[derive(Clone, Debug)]
pub struct MovingPart {
    /// Selects the contact, a mass, or a combination such as the difference of two masses.
    pub of: Of,
    /// The requested quantity: displacement, velocity or acceleration of the motion, or the force, energy or equivalent
    /// damping ratio of the contact.
    pub size: MotionQuantity,
    /// Name of the contact, of the mass or of the combination, such as `roof-base`.
    pub name: String,
}

impl MovingPart {
    /// Returns the contact, mass or combination with this name, as [`System::quantity_named`] reads it.
    ///
    /// # Errors
    /// Same errors as [`System::quantity_named`].
    pub fn named(system: &System, name: &str) -> Result<Self, UnknownMotion> {
        let (of, size) = system.quantity_named(name)?;
        let name = name.trim().to_owned();
        Ok(Self { of, size, name })
    }

    /// Returns the motions with these names, each once, for a scene with several contacts. Without names, returns all
    /// masses. The tables of such a scene have every contact in any case.
    ///
    /// # Errors
    /// A message, which begins with the name of the `argument` that contains the names.
    pub fn of_joined(
        system: &System,
        argument: &str,
        names: &[String],
    ) -> Result<Vec<Self>, String> {
        let scene = system.scene();
        if names.is_empty() {
            let masses = (0..scene.masses.len()).map(Of::Mass);
            let masses = masses.map(|of| Self {
                of,
                size: MotionQuantity::Displacement,
                name: system.name_of_motion(of),
            });
            return Ok(masses.collect());
        }
        let mut parts: Vec<Self> = Vec::new();
        for name in names {
            if parts.iter().any(|part| part.name == name.trim()) {
                return Err(format!("{argument} `{name}`: it is given twice"));
            }
            let part = Self::named(system, name);
            parts.push(part.map_err(|error| format!("{argument}: {error}"))?);
        }
        Ok(parts)
    }

    /// Returns the motion of a mass relative to the base if the base moves. Returns any other motion unchanged.
    #[must_use]
    pub fn from_base(self, system: &System) -> Self {
        match (self.of, system.scene().excitation) {
            (Of::Mass(index), Excitation::Base) => {
                let of = Of::FromBase(index);
                let name = system.name_of_motion(of);
                Self { of, name, ..self }
            }
            _ => self,
        }
    }

    /// Returns the motion from the displacements or the velocities of all masses. Returns `None` unless it is that of a
    /// mass, or of one mass relative to another.
    #[must_use]
    pub fn among(&self, masses: &[f64]) -> Option<f64> {
        let mass = |index: usize| masses.get(index).copied();
        match (self.of, self.size) {
            (Of::Mass(index), MotionQuantity::Displacement) => mass(index),
            (Of::Relative(index, other), MotionQuantity::Displacement) => {
                Some(mass(index)? - mass(other)?)
            }
            _ => None,
        }
    }

    /// Returns true if the requested quantity is not a displacement. It is then a velocity, an acceleration, or the
    /// force, the energy or the equivalent damping of the contact.
    #[must_use]
    pub fn has_rate(&self) -> bool {
        self.size != MotionQuantity::Displacement
    }

    /// Returns the dimension of the amplitude: a force for a spring and for the base shear, otherwise a length.
    #[must_use]
    pub fn dimension(&self) -> PhysicalQuantity {
        match self.size {
            MotionQuantity::Displacement if self.of.is_force() => PhysicalQuantity::Force,
            MotionQuantity::Displacement => PhysicalQuantity::Length,
            MotionQuantity::Velocity => PhysicalQuantity::Velocity,
            MotionQuantity::Acceleration => PhysicalQuantity::Acceleration,
            MotionQuantity::Force => PhysicalQuantity::Force,
            MotionQuantity::Energy => PhysicalQuantity::Energy,
            MotionQuantity::Damping => PhysicalQuantity::One,
        }
    }

    /// Returns the contact as a moving part, with its displacement as the quantity.
    #[must_use]
    pub fn contact(system: &System) -> Self {
        Self {
            of: Of::Contact,
            size: MotionQuantity::Displacement,
            name: system.name_of_motion(Of::Contact),
        }
    }
}

/// The unit in which the user gives frequencies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrequencyUnit {
    /// The user gives frequency ratios r.
    Ratio,
    /// The user gives frequency ratios r and a load. Tables then also contain the frequency in Hz.
    RatioUnderLoad,
    /// The user gives frequencies in Hz.
    Hertz,
    /// The user gives angular frequencies in rad/s.
    AngularFrequency,
}

impl FrequencyUnit {
    /// Returns the unit for tables under a load. Tables under a load contain the frequency in Hz next to the frequency
    /// ratio.
    #[must_use]
    pub fn under(self, measure: &Measure) -> Self {
        match (self, measure.scale()) {
            (Self::Ratio, Some(_)) => Self::RatioUnderLoad,
            (unit, _) => unit,
        }
    }

    /// Returns true if the user gave the frequencies in Hz or rad/s.
    #[must_use]
    pub fn is_physical(self) -> bool {
        matches!(self, Self::Hertz | Self::AngularFrequency)
    }

    /// Returns true if tables contain the frequency in Hz in addition to r.
    #[must_use]
    pub fn has_hertz(self) -> bool {
        self != Self::Ratio
    }

    /// Returns the frequency that the number `given` denotes in this unit.
    #[must_use]
    pub fn given(self, system: &System, given: f64) -> Frequency {
        match self {
            Self::Ratio | Self::RatioUnderLoad => Frequency::at(system, given),
            Self::Hertz => Frequency {
                hertz: given,
                ..Frequency::at(system, system.frequency_ratio_at_hertz(given))
            },
            Self::AngularFrequency => Frequency {
                hertz: units::hertz(given),
                given_omega: given,
                ..Frequency::at(system, system.frequency_ratio(given))
            },
        }
    }
}

/// Number of frequencies in a range without a step.
const SPREAD: u32 = 200;

/// Returns the evenly spaced numbers of a range that a curve of a scene with several contacts has.
#[must_use]
pub fn spread(from: f64, to: f64) -> Vec<f64> {
    let number = |index: u32| from + (to - from) * f64::from(index) / f64::from(SPREAD - 1);
    (0..SPREAD).map(number).collect()
}

/// A frequency of the excitation, as ratio r, in Hz and in rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frequency {
    /// Frequency ratio r = ω√(m₁/k₁) of the excitation.
    pub r: f64,
    /// Frequency in Hz, as given or computed from r.
    pub hertz: f64,
    /// Angular frequency in rad/s, computed from r.
    pub omega: f64,
    /// Angular frequency in rad/s, as given or computed from r.
    given_omega: f64,
}

impl Frequency {
    /// Returns the frequency with the frequency ratio r.
    #[must_use]
    pub fn at(system: &System, r: f64) -> Self {
        let omega = system.angular_frequency(r);
        Self {
            r,
            hertz: units::hertz(omega),
            omega,
            given_omega: omega,
        }
    }
}

/// A friction in the contact, as friction ratio β and as force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionSetting {
    /// Friction ratio β = F/P (F/(k₁Y) for base motion).
    pub beta: f64,
    /// Friction force in N, if the load is known.
    force: Option<f64>,
    /// True if the user gave the force, false if the user gave β.
    is_force: bool,
}

impl FrictionSetting {
    /// Returns the friction with the friction ratio β. `scale` gives the unit of force under a load.
    #[must_use]
    pub fn of_ratio(beta: f64, scale: Option<LoadScale>) -> Self {
        Self {
            beta,
            force: scale.map(|scale| scale.friction(beta)),
            is_force: false,
        }
    }

    /// Returns the friction with this force in N. `scale` gives the unit of force under a load.
    #[must_use]
    pub fn of_force(force: f64, scale: LoadScale) -> Self {
        Self {
            beta: scale.friction_ratio(force),
            force: Some(force),
            is_force: true,
        }
    }

    /// Returns the friction at a frequency. If the amplitude of the load depends on frequency, the number that the
    /// user gave (F or β) stays the same, and the other number changes.
    #[must_use]
    pub fn at(self, measure: &Measure, frequency: Frequency) -> Self {
        match measure.scale_at(frequency.omega) {
            Some(scale) if measure.fall() != 0 => match self.force {
                Some(force) if self.is_force => Self::of_force(force, scale),
                _ => Self::of_ratio(self.beta, Some(scale)),
            },
            _ => self,
        }
    }

    /// Returns the exponent n of β ∝ rⁿ, where r is the frequency ratio. n is not 0 if the user gave a friction force,
    /// and the amplitude of the load depends on frequency. If the user gave β, n is 0.
    #[must_use]
    pub fn rise(&self, measure: &Measure) -> i32 {
        if self.is_force { measure.fall() } else { 0 }
    }

    /// Returns the friction force in N if the load is known. Otherwise returns the friction ratio β.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force.unwrap_or(self.beta)
    }
}

/// The setting that all tables have in common.
#[derive(Clone, Copy)]
pub struct Setting<'a> {
    /// The system of the results.
    pub system: &'a System,
    /// Units of the results: SI units if the amplitude of the load is given, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The unit in which the user gave the frequencies.
    pub frequency: FrequencyUnit,
    /// The frequencies as the user gave them, in the unit [`frequency`](Self::frequency). The slice is empty for a band
    /// of frequencies.
    pub frequencies: &'a [f64],
    /// The frictions as the user gave them: forces in N if [`forces`](Self::forces) is true, otherwise friction ratios.
    pub frictions: &'a [f64],
    /// True if the user gave the frictions as forces.
    pub forces: bool,
    /// The contact and masses whose motions the table contains.
    pub parts: &'a [MovingPart],
}

/// A row of a table for one frequency.
pub trait AtFrequency: TableRow {
    /// Returns the frequency of the row.
    fn frequency(&self) -> Frequency;
}

/// Implements the traits of a row for one frequency, which is its field `frequency`.
macro_rules! at {
    ($($row:ty),*) => {$(
        impl $crate::study::columns::column::TableRow for $row {
            fn omega(&self) -> f64 {
                self.frequency.omega
            }
        }

        impl $crate::study::columns::setting::AtFrequency for $row {
            fn frequency(&self) -> $crate::study::columns::setting::Frequency {
                self.frequency
            }
        }
    )*};
}
pub(super) use at;

/// A row of a table for one value of the friction.
pub trait AtFriction: TableRow {
    /// Returns the friction of the row.
    fn friction(&self) -> FrictionSetting;
}

impl TableRow for Frequency {
    fn omega(&self) -> f64 {
        self.omega
    }
}

impl AtFrequency for Frequency {
    fn frequency(&self) -> Frequency {
        *self
    }
}

impl TableRow for FrictionSetting {}

impl AtFriction for FrictionSetting {
    fn friction(&self) -> FrictionSetting {
        *self
    }
}

impl<'a> Setting<'a> {
    /// Returns the setting without given frequencies, frictions and motions.
    #[must_use]
    pub fn new(system: &'a System, measure: Measure, frequency: FrequencyUnit) -> Self {
        Self {
            system,
            measure,
            frequency,
            frequencies: &[],
            frictions: &[],
            forces: false,
            parts: &[],
        }
    }

    /// Returns the operating point at a frequency and a friction.
    #[must_use]
    pub fn point(&self, frequency: Frequency, friction: FrictionSetting) -> OperatingPoint {
        match self.measure.load() {
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

    /// Returns the columns of the frequency as a table of its own.
    #[must_use]
    pub fn frequency_columns(&self) -> Vec<Column<'a, Frequency>> {
        let mut columns = Columns::new(&self.measure);
        self.frequency(&mut columns);
        columns.done()
    }

    /// Returns the columns of the friction as a table of its own.
    #[must_use]
    pub fn friction_columns(&self) -> Vec<Column<'a, FrictionSetting>> {
        let mut columns = Columns::new(&self.measure);
        self.friction(&mut columns);
        columns.done()
    }

    /// Adds the columns of the frequency to a table.
    pub fn frequency<R: AtFrequency + 'a>(&self, columns: &mut Columns<'a, R>) {
        let given = |unit: FrequencyUnit| -> &'a [f64] {
            let ratios =
                |unit| matches!(unit, FrequencyUnit::Ratio | FrequencyUnit::RatioUnderLoad);
            let is_given = self.frequency == unit || ratios(self.frequency) && ratios(unit);
            if is_given { self.frequencies } else { &[] }
        };
        columns.along(ColumnAxis::Frequency);
        if self.frequency.has_hertz() {
            let head = Head::of("frequency", PhysicalQuantity::Hertz);
            columns.given(head, given(FrequencyUnit::Hertz), |row: &R| {
                Some(row.frequency().hertz)
            });
        }
        if self.frequency == FrequencyUnit::AngularFrequency {
            let head = Head::of("omega", PhysicalQuantity::AngularFrequency);
            columns.given(head, given(FrequencyUnit::AngularFrequency), |row: &R| {
                Some(row.frequency().given_omega)
            });
        }
        columns.given("r", given(FrequencyUnit::Ratio), |row: &R| {
            Some(row.frequency().r)
        });
        columns.along(ColumnAxis::Row);
    }

    /// Adds the columns of the friction force and of the friction ratio β to a table. β is the friction force divided
    /// by the amplitude P of the load (by k₁Y for base motion). If this amplitude depends on frequency, β has a value
    /// of its own in each row.
    pub fn friction<R: AtFriction + 'a>(&self, columns: &mut Columns<'a, R>) {
        let given = |forces: bool| -> &'a [f64] {
            if self.forces == forces {
                self.frictions
            } else {
                &[]
            }
        };
        columns.along(ColumnAxis::Friction);
        if self.measure.scale().is_some() {
            let head = Head::of("friction", PhysicalQuantity::Force);
            columns.given(head, given(true), |row: &R| row.friction().force);
        }
        if self.measure.fall() != 0 {
            columns.along(ColumnAxis::Row);
        }
        columns.given("beta", given(false), |row: &R| Some(row.friction().beta));
        columns.along(ColumnAxis::Row);
    }
}

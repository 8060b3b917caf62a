//! The frequencies asked for: ratios r, Hz or rad/s.

use crate::args::FrequencyArguments;
use crate::failure::Failure;
use crate::grid::{self, Quantity};
use crate::number::{Value, survives};
use crate::table::Column;
use frictiongen::System;
use frictiongen::study::units;

/// What the frequencies are given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    Ratio,
    Hertz,
    Omega,
}

/// A grid of frequencies.
#[derive(Clone, Debug)]
pub struct Frequencies {
    given: Vec<f64>,
    unit: Unit,
    /// What it is read as.
    pub quantity: Quantity,
}

/// One frequency.
#[derive(Clone, Copy, Debug)]
pub struct Frequency {
    /// r.
    pub r: f64,
    /// In Hz, where it was given in a unit.
    hertz: Option<f64>,
    /// In rad/s, where it was given so.
    omega: Option<f64>,
}

impl Frequency {
    /// In Hz, as given or from r.
    pub fn hertz(&self, system: &System) -> f64 {
        self.hertz.unwrap_or_else(|| system.hertz(self.r))
    }

    /// Its cells.
    pub fn values(&self) -> Vec<Value<'static>> {
        let before = [self.hertz, self.omega].into_iter().flatten();
        before.chain([self.r]).map(Value::from).collect()
    }
}

impl Frequencies {
    /// The grid; of a motion in time, which needs a cycle, or not.
    pub fn parse(arguments: &FrequencyArguments, in_time: bool) -> Result<Self, Failure> {
        let (text, unit) = match (&arguments.r, &arguments.hz, &arguments.omega) {
            (Some(r), ..) => (r, Unit::Ratio),
            (_, Some(hz), _) => (hz, Unit::Hertz),
            (.., Some(omega)) => (omega, Unit::Omega),
            (None, None, None) => return Err(Failure::new("give --r, --hz or --omega")),
        };
        let quantity = match (unit, in_time) {
            (Unit::Ratio, false) => Quantity::FrequencyRatio,
            (Unit::Ratio, true) => Quantity::FrequencyRatioInTime,
            (Unit::Hertz, false) => Quantity::Hertz,
            (Unit::Hertz, true) => Quantity::HertzInTime,
            (Unit::Omega, false) => Quantity::Omega,
            (Unit::Omega, true) => Quantity::OmegaInTime,
        };
        Ok(Self {
            given: grid::parse(text, quantity).map_err(Failure::new)?,
            unit,
            quantity,
        })
    }

    /// Nothing, if every frequency has a ratio to compute with.
    pub fn check(&self, system: &System) -> Result<(), Failure> {
        let lost = |given: &&f64| !survives(**given, self.of(system, **given).r);
        match self.given.iter().find(lost) {
            None => Ok(()),
            Some(given) => Err(Failure::new(format_args!(
                "{} `{given:?}`: its frequency ratio is too small or too large to compute with",
                self.quantity.option()
            ))),
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.given.len()
    }

    /// Whether they are given in a unit.
    pub fn are_physical(&self) -> bool {
        self.unit != Unit::Ratio
    }

    /// The frequencies, in the order written.
    pub fn iter<'a>(&'a self, system: &'a System) -> impl Iterator<Item = Frequency> + 'a {
        self.given.iter().map(|given| self.of(system, *given))
    }

    fn of(&self, system: &System, given: f64) -> Frequency {
        match self.unit {
            Unit::Ratio => Frequency {
                r: given,
                hertz: None,
                omega: None,
            },
            Unit::Hertz => Frequency {
                r: system.frequency_ratio_at_hertz(given),
                hertz: Some(given),
                omega: None,
            },
            Unit::Omega => Frequency {
                r: system.frequency_ratio(given),
                hertz: Some(units::hertz(given)),
                omega: Some(given),
            },
        }
    }

    /// The columns of the table.
    pub fn columns(&self) -> Vec<Column> {
        let given = |title: &[&str]| Column::given(title, &self.given);
        match self.unit {
            Unit::Ratio => vec![given(&["r"])],
            Unit::Hertz => vec![given(&["frequency", "(Hz)"]), Column::computed(&["r"])],
            Unit::Omega => vec![
                Column::computed(&["frequency", "(Hz)"]),
                given(&["omega", "(rad/s)"]),
                Column::computed(&["r"]),
            ],
        }
    }

    /// The names of the cells.
    pub fn names(&self) -> &'static [&'static str] {
        match self.unit {
            Unit::Ratio => &["r"],
            Unit::Hertz => &["frequency_Hz", "r"],
            Unit::Omega => &["frequency_Hz", "omega_rad_s", "r"],
        }
    }
}

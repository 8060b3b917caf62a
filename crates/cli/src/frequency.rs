//! Frequencies on the command line: ratios r, Hz or rad/s.

use crate::args::FrequencyArguments;
use crate::failure::Failure;
use crate::grid::{self, GridQuantity};
use crate::measure::Measure;
use crate::number::survives;
use frictiongen::System;
use frictiongen::study::columns::{Frequency, FrequencyUnit as Unit, spread};
#[cfg(feature = "report")]
use frictiongen::study::units;

/// A continuous range of frequencies, and the unit in which the user gave the range.
#[derive(Clone, Debug)]
pub struct Band {
    /// Lowest frequency ratio r of the range.
    pub from: f64,
    /// Highest frequency ratio r of the range.
    pub to: f64,
    /// Largest distance between neighbouring points, in r. `None` if the user gave no step.
    pub widest: Option<f64>,
    unit: Unit,
}

impl Band {
    /// Parses a range a:b or a:step:b of frequencies.
    pub fn parse(arguments: &FrequencyArguments, system: &System) -> Result<Self, Failure> {
        let (text, unit) = given(arguments)?;
        let quantity = quantity(unit, true);
        let [from, step, to] = grid::band(text, quantity).map_err(Failure::new)?;
        let ratio = |value: f64| unit.given(system, value).r;
        let band = Self {
            from: ratio(from),
            to: ratio(to),
            widest: (0.0 < step).then(|| ratio(step)),
            unit,
        };
        let lost = [from, to]
            .into_iter()
            .find(|value| !survives(*value, ratio(*value)));
        match lost {
            Some(value) => Err(too_far(quantity, value)),
            None => Ok(band),
        }
    }

    /// Returns the default range of frequencies, from below the lowest resonance to above the highest.
    pub fn about_resonances(system: &System, in_hertz: bool) -> Self {
        let [from, to] = system.about_resonances();
        Self {
            from,
            to,
            widest: None,
            unit: if in_hertz { Unit::Hertz } else { Unit::Ratio },
        }
    }

    /// Returns the range between two frequency ratios. If `in_hertz` is true, tables print frequencies in Hz.
    #[cfg(feature = "report")]
    pub fn between(from: f64, to: f64, in_hertz: bool) -> Self {
        Self {
            from,
            to,
            widest: None,
            unit: if in_hertz { Unit::Hertz } else { Unit::Ratio },
        }
    }

    /// Returns the range for results under this load. If the load has units, tables contain frequencies in Hz next to
    /// r.
    pub fn under(mut self, measure: &Measure) -> Self {
        self.unit = self.unit.under(measure);
        self
    }

    /// Returns true if the user gave the range in Hz or rad/s.
    pub fn is_physical(&self) -> bool {
        self.unit.is_physical()
    }

    /// Returns true if tables contain the frequency in Hz next to r.
    pub fn tells_hertz(&self) -> bool {
        self.unit.has_hertz()
    }

    /// Returns the unit in which the user gave the range.
    pub fn unit(&self) -> Unit {
        self.unit
    }
}

/// Returns the text of the frequency option that the user gave, and its unit.
fn given(arguments: &FrequencyArguments) -> Result<(&str, Unit), Failure> {
    match (&arguments.r, &arguments.hz, &arguments.omega) {
        (Some(r), ..) => Ok((r, Unit::Ratio)),
        (_, Some(hz), _) => Ok((hz, Unit::Hertz)),
        (.., Some(omega)) => Ok((omega, Unit::AngularFrequency)),
        (None, None, None) => Err(Failure::new("give --r, --hz or --omega")),
    }
}

fn too_far(quantity: GridQuantity, given: f64) -> Failure {
    Failure::new(format_args!(
        "{} `{given:?}`: its frequency ratio is too small or too large to compute with",
        quantity.option()
    ))
}

/// Returns the quantity (ratio r, Hz or rad/s) of frequencies that the user gives in this unit. If `in_time` is true,
/// the parser rejects a frequency that is 0 or infinite.
fn quantity(unit: Unit, in_time: bool) -> GridQuantity {
    match (unit, in_time) {
        (Unit::Ratio | Unit::RatioUnderLoad, false) => GridQuantity::FrequencyRatio,
        (Unit::Ratio | Unit::RatioUnderLoad, true) => GridQuantity::FrequencyRatioInTime,
        (Unit::Hertz, false) => GridQuantity::Hertz,
        (Unit::Hertz, true) => GridQuantity::HertzInTime,
        (Unit::AngularFrequency, false) => GridQuantity::Omega,
        (Unit::AngularFrequency, true) => GridQuantity::OmegaInTime,
    }
}

/// A grid of frequencies, and the unit in which the user gave the frequencies.
#[derive(Clone, Debug)]
pub struct Frequencies {
    given: Vec<f64>,
    unit: Unit,
    /// Quantity (r, Hz or rad/s) as which the parser has read the frequencies.
    pub quantity: GridQuantity,
}

impl Frequencies {
    /// Parses a grid of frequencies. If `in_time` is true, every frequency must be above 0 and finite.
    pub fn parse(arguments: &FrequencyArguments, in_time: bool) -> Result<Self, Failure> {
        let (text, unit) = given(arguments)?;
        let quantity = quantity(unit, in_time);
        Ok(Self {
            given: grid::parse(text, quantity).map_err(Failure::new)?,
            unit,
            quantity,
        })
    }

    /// Stands for the missing frequency of a free vibration, whose times are in s.
    pub fn none() -> Self {
        Self {
            given: vec![1.0],
            unit: Unit::Hertz,
            quantity: GridQuantity::HertzInTime,
        }
    }

    /// Parses a range a:b or a:step:b as a grid. A range without a step is [`spread`].
    pub fn spread(arguments: &FrequencyArguments) -> Result<Self, Failure> {
        let (text, unit) = given(arguments)?;
        let quantity = quantity(unit, true);
        let [from, step, to] = grid::band(text, quantity).map_err(Failure::new)?;
        if 0.0 < step {
            return Self::parse(arguments, true);
        }
        Ok(Self {
            given: spread(from, to),
            unit,
            quantity,
        })
    }

    /// Returns `count` evenly spaced frequencies over a range, including both ends. The frequencies are in Hz if the
    /// user gave the range in Hz or rad/s.
    #[cfg(feature = "report")]
    pub fn evenly(system: &System, band: &Band, count: usize) -> Self {
        let unit = match band.is_physical() {
            true => Unit::Hertz,
            false => Unit::Ratio,
        };
        let steps = count.max(2) - 1;
        let given = (0..=steps).map(|step| {
            let r = band.from + (band.to - band.from) * step as f64 / steps as f64;
            match unit {
                Unit::Hertz => units::hertz(system.angular_frequency(r)),
                _ => r,
            }
        });
        Self {
            given: given.collect(),
            unit,
            quantity: quantity(unit, true),
        }
    }

    /// Fails if the frequency ratio r of a frequency is out of the range of `f64`.
    pub fn check(&self, system: &System) -> Result<(), Failure> {
        let lost = |given: &&f64| !survives(**given, self.of(system, **given).r);
        match self.given.iter().find(lost) {
            None => Ok(()),
            Some(given) => Err(too_far(self.quantity, *given)),
        }
    }

    /// Returns the only frequency of the grid, or an error if there are several.
    pub fn only(&self, system: &System) -> Result<Frequency, Failure> {
        match *self.given {
            [given] => Ok(self.of(system, given)),
            _ => Err(grid::several(self.quantity, self.len())),
        }
    }

    /// Returns the number of frequencies in the grid.
    pub fn len(&self) -> usize {
        self.given.len()
    }

    /// Returns the grid for results under this load. If the load has units, tables contain frequencies in Hz next to r.
    pub fn under(mut self, measure: &Measure) -> Self {
        self.unit = self.unit.under(measure);
        self
    }

    /// Returns the unit in which the user gave the frequencies.
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// Returns the frequencies in the user's unit.
    pub fn given(&self) -> &[f64] {
        &self.given
    }

    /// Returns all frequencies of the grid in the user's order.
    pub fn all<'a>(&'a self, system: &'a System) -> impl Iterator<Item = Frequency> + 'a {
        self.given.iter().map(|given| self.of(system, *given))
    }

    /// Returns true if the user gave the frequencies in Hz or rad/s.
    pub fn are_physical(&self) -> bool {
        self.unit.is_physical()
    }

    fn of(&self, system: &System, given: f64) -> Frequency {
        self.unit.given(system, given)
    }
}

//! Frictions on the command line: friction ratios β, or forces in N.

use crate::args::FrictionArguments;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::grid::{self, GridError, GridQuantity, MOST_POINTS};
use crate::measure::{self, Measure};
use crate::number::survives;
use frictiongen::study::columns::FrictionSetting;
use frictiongen::study::units::LoadScale;

/// A grid of frictions: friction ratios β, or forces in N.
#[derive(Clone, Debug)]
pub struct Frictions {
    given: Vec<f64>,
    quantity: GridQuantity,
    scale: Option<LoadScale>,
}

impl Frictions {
    /// Parses a grid of frictions. If the command also has a grid of frequencies, the number of frequencies times the
    /// number of frictions must not exceed a limit.
    pub fn parse(
        arguments: &FrictionArguments,
        frequencies: Option<&Frequencies>,
    ) -> Result<Self, Failure> {
        Self::read(arguments, frequencies, grid::parse)
    }

    /// Parses a grid of frictions for a map. This grid may contain a range `a:b` without a step.
    pub fn of_map(
        arguments: &FrictionArguments,
        frequencies: &Frequencies,
    ) -> Result<Self, Failure> {
        Self::read(arguments, Some(frequencies), grid::parse_ranges)
    }

    fn read(
        arguments: &FrictionArguments,
        frequencies: Option<&Frequencies>,
        grid: fn(&str, GridQuantity) -> Result<Vec<f64>, GridError>,
    ) -> Result<Self, Failure> {
        let (text, quantity) = match (&arguments.beta, &arguments.friction) {
            (Some(beta), _) => (beta, GridQuantity::FrictionRatio),
            (_, Some(friction)) => (friction, GridQuantity::FrictionForce),
            (None, None) => return Err(Failure::new("give --beta or --friction")),
        };
        let given = grid(text, quantity).map_err(Failure::new)?;
        let crowded = |of: &&Frequencies| MOST_POINTS < of.len().saturating_mul(given.len());
        if let Some(frequencies) = frequencies.filter(crowded) {
            let (first, second) = (frequencies.quantity.option(), quantity.option());
            return Err(Failure::new(format_args!(
                "{first} and {second}: together they have more than {MOST_POINTS} points, the largest possible number"
            )));
        }
        Ok(Self {
            given,
            quantity,
            scale: None,
        })
    }

    /// Stores the load, which converts between friction ratios β and forces in N, and returns the grid. Fails for
    /// forces without a load, for ratios under a load whose amplitude depends on frequency, and if a conversion
    /// overflows or underflows.
    pub fn under(mut self, measure: &Measure) -> Result<Self, Failure> {
        self.scale = measure.scale();
        if self.scale.is_none() && self.are_forces() {
            return Err(Failure::new(format_args!(
                "--friction needs the amplitude of the load: give {}",
                measure::option(measure)
            )));
        }
        if measure.fall() != 0 && !self.are_forces() {
            return Err(Failure::new(
                "--beta: the amplitude of this load depends on frequency, so that one friction ratio is another force at each frequency; give --friction in N",
            ));
        }
        let lost = |given: &&f64| {
            let friction = self.of(**given);
            let force = friction.force();
            !(survives(**given, friction.beta) && survives(**given, force))
        };
        if let Some(given) = self.given.iter().find(lost) {
            return Err(Failure::new(format_args!(
                "{} `{given:?}`: with this load its friction {} is too small or too large to compute with",
                self.quantity.option(),
                if self.are_forces() { "ratio" } else { "force" }
            )));
        }
        Ok(self)
    }

    /// Returns the frictions in the user's unit: friction ratios β, or forces in N.
    pub fn given(&self) -> &[f64] {
        &self.given
    }

    /// Returns all frictions of the grid in the user's order.
    pub fn all(&self) -> impl Iterator<Item = FrictionSetting> + Clone + '_ {
        self.given.iter().map(|given| self.of(*given))
    }

    /// Returns true if the user gave the frictions as forces.
    pub fn are_forces(&self) -> bool {
        self.quantity == GridQuantity::FrictionForce
    }

    /// Returns the only friction of the grid, or an error if there are several.
    pub fn only(&self) -> Result<FrictionSetting, Failure> {
        match *self.given {
            [given] => Ok(self.of(given)),
            _ => Err(grid::several(self.quantity, self.len())),
        }
    }

    /// Returns the number of frictions in the grid.
    pub fn len(&self) -> usize {
        self.given.len()
    }

    fn of(&self, given: f64) -> FrictionSetting {
        match self.scale {
            Some(scale) if self.are_forces() => FrictionSetting::of_force(given, scale),
            scale => FrictionSetting::of_ratio(given, scale),
        }
    }
}

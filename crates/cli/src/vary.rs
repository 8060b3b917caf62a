//! The option `--vary NAME=a:b` of `frictiongen optimum`.

use crate::failure::Failure;
use frictiongen::System;
use frictiongen::study::optimum::Tuning;
use std::fmt::Display;

/// The text of the option `--vary`, divided into a name and an interval.
pub struct Vary<'t> {
    text: &'t str,
    /// Name of the number in the scene description that the search varies.
    name: &'t str,
    interval: &'t str,
}

impl<'t> Vary<'t> {
    /// Divides the text of the option into the name and the interval.
    pub fn parsed(text: &'t str) -> Result<Self, Failure> {
        let (name, interval) = text.rsplit_once('=').ok_or_else(|| {
            wrong(
                text,
                &"a number of the description and an interval are needed, NAME=a:b",
            )
        })?;
        Ok(Self {
            text,
            name,
            interval,
        })
    }

    /// Returns the lower and the upper bound of the interval.
    fn ends(&self) -> Result<(f64, f64), Failure> {
        let (from, to) = self
            .interval
            .split_once(':')
            .ok_or_else(|| self.wrong(&"an interval a:b is needed"))?;
        let end = |end: &str| {
            let number = end.trim().parse::<f64>();
            number.map_err(|_| self.wrong(&format_args!("`{}` is not a number", end.trim())))
        };
        Ok((end(from)?, end(to)?))
    }

    /// Returns the numbers of the scene description that vary, with the interval of their values.
    pub fn tunings(&self, system: &System) -> Result<Vec<Tuning>, Failure> {
        let named = system.tunables_named(self.name);
        let named = named.map_err(|error| self.wrong(&error))?;
        let (from, to) = self.ends()?;
        let tunings = named.into_iter().map(|of| Tuning { of, from, to });
        Ok(tunings.collect())
    }

    /// Returns the failure for an error in the option `--vary`.
    pub fn wrong(&self, problem: &dyn Display) -> Failure {
        wrong(self.text, problem)
    }
}

fn wrong(text: &str, problem: &dyn Display) -> Failure {
    Failure::new(format_args!("--vary `{text}`: {problem}"))
}

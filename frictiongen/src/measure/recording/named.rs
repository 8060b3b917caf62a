//! Units in the column names of files.

use super::unit::{UNITS, Unit};
use crate::measure::MeasureError;

impl Unit {
    /// Splits the header of a column into name and unit. If several endings of the header are units, the function
    /// takes the longest ending. The unit may also stand as in a text, for example `base_m/s^2`.
    pub(super) fn split(header: &str) -> (&str, Option<Self>) {
        if let Some((name, unit)) = bracketed(header) {
            return (name, unit.parse().ok());
        }
        let ends = |ending: &str| {
            let rest = header.strip_suffix(ending)?;
            rest.strip_suffix('_').filter(|rest| !rest.is_empty())
        };
        let fitting = UNITS
            .iter()
            .filter_map(|unit| Some((ends(unit.1)?, Self::of(*unit))));
        let longest = fitting.min_by_key(|(rest, _)| rest.len());
        if let Some((rest, unit)) = longest {
            return (rest, Some(unit));
        }
        let written = header.rsplit_once('_').filter(|(rest, _)| !rest.is_empty());
        let parsed = written.and_then(|(rest, unit)| Some((rest, Some(unit.parse().ok()?))));
        parsed.unwrap_or((header, None))
    }
}

/// Splits a header of the form `name (unit)` or `name [unit]`.
fn bracketed(header: &str) -> Option<(&str, &str)> {
    [('(', ')'), ('[', ']')]
        .into_iter()
        .find_map(|(open, close)| {
            let (name, unit) = header.strip_suffix(close)?.rsplit_once(open)?;
            Some((name.trim(), unit.trim()))
        })
}

impl std::str::FromStr for Unit {
    type Err = MeasureError;

    fn from_str(text: &str) -> Result<Self, MeasureError> {
        let plain = text.trim().replace(['^', ' '], "").replace('²', "2");
        let plain = plain.replace("s**2", "s2").replace(['µ', 'μ'], "u");
        let found = UNITS.iter().find(|unit| {
            unit.0 == plain || unit.1 == plain || unit.0.replace("s2", "s/s") == plain
        });
        found
            .map(|unit| Self::of(*unit))
            .ok_or_else(|| MeasureError::UnknownUnit(text.trim().to_owned()))
    }
}

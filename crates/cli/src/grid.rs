//! Parses grids of numbers: a number, a range `a:step:b` or `a:b`, or a comma-separated list of numbers and ranges.

use crate::decimal::{Decimal, Decimals};
use crate::failure::Failure;
use crate::hint;
use std::fmt;

/// Largest number of points of a grid. With two grids, it is the largest product of their numbers of points.
pub const MOST_POINTS: usize = 10_000_000;

/// Number of equal steps in a range `a:b` without a step.
pub const STEPS: u32 = 100;

/// Physical quantity of the numbers in a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GridQuantity {
    /// The numbers are frequency ratios r. A number may be 0 or infinite.
    FrequencyRatio,
    /// The numbers are frequency ratios r of a motion in time. Each must be above 0 and finite, so that the excitation
    /// has a cycle.
    FrequencyRatioInTime,
    /// The numbers are frequencies in Hz. A number may be 0 or infinite.
    Hertz,
    /// The numbers are frequencies in Hz of a motion in time. Each must be above 0 and finite, so that the excitation
    /// has a cycle.
    HertzInTime,
    /// The numbers are angular frequencies in rad/s. A number may be 0 or infinite.
    Omega,
    /// The numbers are angular frequencies in rad/s of a motion in time. Each must be above 0 and finite, so that the
    /// excitation has a cycle.
    OmegaInTime,
    /// The numbers are friction ratios β. Each must be finite.
    FrictionRatio,
    /// The numbers are friction forces in N. Each must be finite.
    FrictionForce,
}

impl GridQuantity {
    /// Returns the command-line option that takes numbers of this quantity.
    pub fn option(self) -> &'static str {
        match self {
            Self::FrequencyRatio | Self::FrequencyRatioInTime => "--r",
            Self::Hertz | Self::HertzInTime => "--hz",
            Self::Omega | Self::OmegaInTime => "--omega",
            Self::FrictionRatio => "--beta",
            Self::FrictionForce => "--friction",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::FrequencyRatio | Self::FrequencyRatioInTime => "frequency ratio",
            Self::Hertz | Self::HertzInTime => "frequency",
            Self::Omega | Self::OmegaInTime => "angular frequency",
            Self::FrictionRatio => "friction ratio",
            Self::FrictionForce => "friction force",
        }
    }

    fn article(self) -> &'static str {
        match self {
            Self::Omega | Self::OmegaInTime => "an",
            _ => "a",
        }
    }

    /// Returns true if the quantity is a frequency of a motion in time.
    fn in_time(self) -> bool {
        matches!(
            self,
            Self::FrequencyRatioInTime | Self::HertzInTime | Self::OmegaInTime
        )
    }

    /// Returns true if the quantity is a frequency. The user may give a range of frequencies without a step.
    fn is_frequency(self) -> bool {
        !matches!(self, Self::FrictionRatio | Self::FrictionForce)
    }

    /// Returns true if the quantity may be infinite.
    fn may_be_infinite(self) -> bool {
        matches!(self, Self::FrequencyRatio | Self::Hertz | Self::Omega)
    }
}

/// An error in the text of a grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridError {
    option: &'static str,
    entry: String,
    problem: String,
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} `{}`: {}", self.option, self.entry, self.problem)
    }
}

/// Parses a grid of numbers. Returns at least one point, in the order of the text. A range `a:b` of frequencies has
/// [`STEPS`] steps.
pub fn parse(text: &str, quantity: GridQuantity) -> Result<Vec<f64>, GridError> {
    points(text, quantity, quantity.is_frequency())
}

/// Parses a grid as [`parse`] does, but also permits ranges `a:b` of frictions.
pub fn parse_ranges(text: &str, quantity: GridQuantity) -> Result<Vec<f64>, GridError> {
    points(text, quantity, true)
}

/// Parses a grid. If `open` is true, the text may contain ranges without a step.
fn points(text: &str, quantity: GridQuantity, open: bool) -> Result<Vec<f64>, GridError> {
    let mut points = Vec::new();
    for entry in text.split(',').map(str::trim) {
        extend(&mut points, entry, quantity, open).map_err(|problem| GridError {
            option: quantity.option(),
            entry: entry.to_owned(),
            problem,
        })?;
    }
    Ok(points)
}

/// Parses a range a:b or a:step:b of frequencies. Returns the first number, the last number and the step. The step is 0
/// if the text gives none.
pub fn band(text: &str, quantity: GridQuantity) -> Result<[f64; 3], GridError> {
    let parts: Vec<&str> = text.split(':').collect();
    let ends = |first: &str, step: &str, last: &str| -> Result<[f64; 3], String> {
        let [first, last] = [number(first, quantity)?, number(last, quantity)?];
        let step = number(step, GridQuantity::FrictionRatio)?;
        admit(first, quantity)?;
        admit(last, quantity)?;
        if last < first {
            return Err(format!(
                "a range goes from its lower end to its upper one: write {last}:{first}"
            ));
        }
        if !(first < last) {
            return Err(format!("the range from {first:?} to {last:?} has no width"));
        }
        if !(0.0 <= step && step.is_finite()) {
            return Err("the step must be above 0".to_owned());
        }
        if 0.0 < step {
            room(0, (last - first) / step)?;
        }
        Ok([first, step, last])
    };
    let found = match parts.as_slice() {
        [first, last] => ends(first, "0", last),
        [first, step, last] if step.trim().parse() == Ok(0.0) => {
            ends(first, "0", last).and(Err("the step must not be 0".to_owned()))
        }
        [first, step, last] => ends(first, step, last),
        _ => Err("a range a:b or a:step:b is needed".to_owned()),
    };
    found.map_err(|problem| GridError {
        option: quantity.option(),
        entry: text.to_owned(),
        problem,
    })
}

/// Returns the error of a command that needs a single point but gets a grid of `points` points.
pub fn several(quantity: GridQuantity, points: usize) -> Failure {
    Failure::new(format_args!(
        "{}: one {} is needed, but this is a grid of {points}",
        quantity.option(),
        quantity.name()
    ))
}

/// Adds the points of one entry of the comma-separated list to `points`.
fn extend(
    points: &mut Vec<f64>,
    entry: &str,
    quantity: GridQuantity,
    open: bool,
) -> Result<(), String> {
    let mut parts = entry.split(':');
    match (parts.next(), parts.next(), parts.next(), parts.next()) {
        (Some(text), None, ..) => {
            let value = number(text, quantity)?;
            admit(value, quantity)?;
            room(points.len(), 1.0)?;
            points.push(value);
        }
        (Some(first), Some(step), Some(last), None) => {
            let texts = [first, step, last];
            let [first, step, last] = texts.map(|text| number(text, GridQuantity::FrictionRatio));
            let range = GridRange::new(first?, step?, last?, quantity)?;
            let count = room(points.len(), range.steps + 1.0)?;
            match decimals(texts) {
                Some(exact) => {
                    let count = room(points.len(), exact.steps as f64 + 1.0)?;
                    let indices = (0..).take(count);
                    // Adding 0 turns a negative zero into a zero.
                    points.extend(indices.map(|index| exact.point(index) + 0.0));
                }
                None => points.extend((0..count).map(|index| range.point(index))),
            }
        }
        (Some(first), Some(last), None, None) if open => {
            let [low, high] = [first, last].map(|text| number(text, GridQuantity::FrictionRatio));
            let (low, high) = (low?, high?);
            if low == high {
                return Err(format!("the range from {low:?} to {high:?} has no width"));
            }
            let range = GridRange::new(low, (high - low) / f64::from(STEPS), high, quantity)?;
            let count = room(points.len(), f64::from(STEPS) + 1.0)?;
            let exact = Decimal::parse(first).zip(Decimal::parse(last));
            match exact.and_then(|(first, last)| Decimals::hundredths(first, last)) {
                Some(exact) => {
                    points.extend((0..).take(count).map(|index| exact.point(index) + 0.0));
                }
                None => points.extend((0..count).map(|index| range.point(index))),
            }
        }
        (Some(_), Some(_), None, None) => {
            return Err(format!(
                "a range of frictions needs its step in the middle, a:step:b; without a step, `map` takes {STEPS} equal steps"
            ));
        }
        _ => return Err("a grid is a number, or a range a:step:b".to_owned()),
    }
    Ok(())
}

/// Returns the range as decimal numbers, if all three texts are decimal numbers.
fn decimals(texts: [&str; 3]) -> Option<Decimals> {
    let [first, step, last] = texts.map(Decimal::parse);
    Decimals::new(first?, step?, last?)
}

/// Checks that `more` new points fit into a grid that already has `already` points, and returns `more` as an integer.
/// The grid may have at most `MOST_POINTS` points.
fn room(already: usize, more: f64) -> Result<usize, String> {
    // Both conversions are exact, because the numbers are whole numbers and small enough.
    if more <= MOST_POINTS.saturating_sub(already) as f64 {
        Ok(more as usize)
    } else {
        Err(format!(
            "more than {MOST_POINTS} points, the largest possible number"
        ))
    }
}

/// A range of floating-point numbers with its number of steps.
struct GridRange {
    first: f64,
    step: f64,
    last: f64,
    steps: f64,
    ends_at_last: bool,
}

impl GridRange {
    fn new(first: f64, step: f64, last: f64, quantity: GridQuantity) -> Result<Self, String> {
        if !(first.is_finite() && step.is_finite() && last.is_finite()) {
            return Err("a range needs finite numbers".to_owned());
        }
        admit(first, quantity)?;
        admit(last, quantity)?;
        if step == 0.0 {
            return Err("the step must not be 0".to_owned());
        }
        let ratio = (last - first) / step;
        if ratio < 0.0 {
            let sign = if step < 0.0 { "positive" } else { "negative" };
            return Err(format!(
                "from {first:?} to {last:?} the step must be {sign}"
            ));
        }
        // `blur` is the largest error of `ratio` that rounding of `first`, `step` and `last` can cause.
        let blur = 4.0 * f64::EPSILON * ((first.abs() + last.abs()) / step.abs() + ratio);
        let whole = ratio.round();
        let ends_at_last = (ratio - whole).abs() <= blur;
        let steps = if ends_at_last { whole } else { ratio.floor() };
        Ok(Self {
            first,
            step,
            last,
            steps,
            ends_at_last,
        })
    }

    fn point(&self, index: usize) -> f64 {
        let index = index as f64;
        if self.ends_at_last && index == self.steps {
            // The user wrote the last point, so the grid contains exactly this number. The computed point differs from
            // it by rounding.
            self.last
        } else {
            self.first + index * self.step
        }
    }
}

/// Parses a number of a grid. Replaces −0 by 0.
fn number(text: &str, quantity: GridQuantity) -> Result<f64, String> {
    let text = text.trim();
    let value: f64 = text.parse().map_err(|_| {
        if text.is_empty() {
            "a number is missing".to_owned()
        } else {
            format!("`{text}` is not a number{}", hint::of(text))
        }
    })?;
    if value.is_nan() {
        return Err("a number is needed, not NaN".to_owned());
    }
    if value.is_infinite() && text.contains(|letter: char| letter.is_ascii_digit()) {
        return Err(if quantity.may_be_infinite() {
            format!("`{text}` is too large; write inf for infinity")
        } else {
            format!("`{text}` is too large")
        });
    }
    Ok(value + 0.0)
}

/// Fails if the quantity cannot have this value, such as a negative friction.
fn admit(value: f64, quantity: GridQuantity) -> Result<(), String> {
    let (article, name) = (quantity.article(), quantity.name());
    if value < 0.0 {
        Err(format!("{article} {name} must not be negative"))
    } else if quantity.in_time() && (value == 0.0 || value.is_infinite()) {
        Err(format!(
            "a motion in time needs {article} {name} above 0 and below infinity; at 0 and infinity, use `limits` or `response`"
        ))
    } else if value.is_infinite() && !quantity.may_be_infinite() {
        Err(format!("{article} {name} must be finite"))
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests;

//! Axes: labels, ranges and scales.

use crate::label::Label;

/// The scale of an axis: linear or logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Linear scale: equal distances on paper are equal differences of values.
    #[default]
    Linear,
    /// Logarithmic scale: equal distances on paper are equal ratios of values. The figure does not show zero and
    /// negative values.
    Log,
}

/// The unit of a linear axis. Its ticks are at round multiples of this unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TickUnit {
    /// Plain numbers. Ticks are at 1, 2 and 5 times powers of ten.
    #[default]
    Plain,
    /// Angles in degrees. Ticks are at fractions of a circle: 0, 90, 180, 270.
    Degrees,
    /// Angles in radians. Ticks are at fractions of a circle: 0, π/2, π.
    Pi,
}

/// An axis of a panel: its label, range and scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Text along the axis: the name of the quantity and its unit.
    pub label: Label,
    /// Value at the lower end of the axis: at the left or at the bottom of the panel.
    pub low: f64,
    /// Value at the upper end of the axis: at the right or at the top of the panel.
    pub high: f64,
    /// Spacing of the values along the axis: linear or logarithmic.
    pub scale: Scale,
    /// The unit that determines at which values the axis has ticks.
    pub unit: TickUnit,
}

impl Axis {
    /// Creates a linear axis from `low` to `high`.
    #[must_use]
    pub fn new(label: impl Into<Label>, low: f64, high: f64) -> Self {
        Self {
            label: label.into(),
            low,
            high,
            scale: Scale::Linear,
            unit: TickUnit::Plain,
        }
    }

    /// Creates a logarithmic axis from `low` to `high`.
    #[must_use]
    pub fn log(label: impl Into<Label>, low: f64, high: f64) -> Self {
        Self {
            scale: Scale::Log,
            ..Self::new(label, low, high)
        }
    }

    /// Creates a linear axis that shows all finite values, with a margin of 4 % of their range at each end. The axis
    /// begins at zero if no value is negative and the smallest is at most 0.3 of the largest. The axis ends at zero if
    /// no value is positive and the smallest |value| is at most 0.3 of the largest |value|.
    #[must_use]
    pub fn fitted(label: impl Into<Label>, values: impl IntoIterator<Item = f64>) -> Self {
        let Some((low, high)) = ends(values, f64::MIN) else {
            return Self::new(label, 0.0, 1.0);
        };
        let pad = 0.04 * (0.5 * high - 0.5 * low) * 2.0;
        let near = |end: f64, other: f64| 0.0 <= end && end <= 0.3 * other;
        let from = if near(low, high) { 0.0 } else { low - pad };
        let to = if near(-high, -low) { 0.0 } else { high + pad };
        Self::new(label, from.max(f64::MIN), to.min(f64::MAX))
    }

    /// Creates a logarithmic axis that shows all positive finite values.
    #[must_use]
    pub fn fitted_log(label: impl Into<Label>, values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = ends(values, f64::MIN_POSITIVE).unwrap_or((1.0, 10.0));
        let pad = libm::exp10(0.04 * (libm::log10(high) - libm::log10(low)));
        Self::log(
            label,
            (low / pad).max(f64::MIN_POSITIVE),
            (high * pad).min(f64::MAX),
        )
    }

    /// Returns this axis with ticks in degrees.
    #[must_use]
    pub fn degrees(self) -> Self {
        Self {
            unit: TickUnit::Degrees,
            ..self
        }
    }

    /// Returns this axis with ticks in multiples of π.
    #[must_use]
    pub fn in_pi(self) -> Self {
        Self {
            unit: TickUnit::Pi,
            ..self
        }
    }

    /// Returns the lower and upper end of the axis as the figure draws it. If the given ends cannot be drawn, the
    /// function changes them. The ends in the result are finite and ascending, and positive on a logarithmic axis.
    /// Their distance is larger than rounding errors.
    pub(crate) fn range(&self) -> (f64, f64) {
        if !self.low.is_finite() || !self.high.is_finite() {
            return if self.scale == Scale::Log {
                (1.0, 10.0)
            } else {
                (0.0, 1.0)
            };
        }
        let (low, high) = (self.low.min(self.high), self.low.max(self.high));
        match self.scale {
            Scale::Linear => {
                let size = low.abs().max(high.abs());
                if (1e-12 * size).max(SMALLEST) < 0.5 * high - 0.5 * low {
                    return (low, high);
                }
                let pad = if SMALLEST < size { 0.1 * size } else { 1.0 };
                ((low - pad).max(f64::MIN), (high + pad).min(f64::MAX))
            }
            Scale::Log => {
                if high < f64::MIN_POSITIVE {
                    return (1.0, 10.0);
                }
                let low = if low < f64::MIN_POSITIVE {
                    1e-3 * high
                } else {
                    low
                };
                let low = low.max(f64::MIN_POSITIVE);
                if low * (1.0 + 1e-12) < high {
                    (low, high)
                } else {
                    (
                        (low * 0.5).max(f64::MIN_POSITIVE),
                        (high * 2.0).min(f64::MAX),
                    )
                }
            }
        }
    }
}

/// Smallest difference between the ends of a linear axis. On a narrower axis the steps between ticks would be
/// subnormal numbers, which have fewer digits.
const SMALLEST: f64 = 1e-304;

/// Returns the smallest and the largest of the finite values that are at least `least`. Returns `None` if no value is
/// finite and at least `least`.
fn ends(values: impl IntoIterator<Item = f64>, least: f64) -> Option<(f64, f64)> {
    values
        .into_iter()
        .filter(|value| value.is_finite() && least <= *value)
        .fold(None, |ends, value| {
            let (low, high) = ends.unwrap_or((value, value));
            Some((value.min(low), value.max(high)))
        })
}

/// Converts values on an axis to positions on paper.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mapping {
    scale: Scale,
    /// Converted value at the lower end of the axis. On a linear axis the converted value is half the value, so that
    /// the width of the range stays finite. On a logarithmic axis it is the decimal logarithm. `span` is the difference
    /// of the converted values at both ends.
    low: f64,
    span: f64,
    from: f64,
    to: f64,
}

/// Largest distance of a position from the paper's origin, in pixels. The code moves a farther position to this
/// distance, far outside the paper of a few thousand pixels.
const FAR: f64 = 1e7;

impl Mapping {
    /// Creates the conversion that places the lower end of an axis at the position `from` on paper, and the upper end
    /// at `to`.
    pub(crate) fn new(axis: &Axis, from: f64, to: f64) -> Self {
        let (low, high) = axis.range();
        let scale = axis.scale;
        let low_at = Self::inner(scale, low);
        Self {
            scale,
            low: low_at,
            span: Self::inner(scale, high) - low_at,
            from,
            to,
        }
    }

    fn inner(scale: Scale, value: f64) -> f64 {
        match scale {
            Scale::Linear => 0.5 * value,
            Scale::Log => libm::log10(value),
        }
    }

    /// Returns the position of a value along an axis, in pixels. Returns `None` if the axis cannot show the value,
    /// such as a negative value on a logarithmic axis.
    pub(crate) fn at(&self, value: f64) -> Option<f64> {
        if !value.is_finite() || (self.scale == Scale::Log && value <= 0.0) {
            return None;
        }
        let share = (Self::inner(self.scale, value) - self.low) / self.span;
        let place = self.from + share * (self.to - self.from);
        (!place.is_nan()).then(|| place.clamp(-FAR, FAR))
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Mapping};

    #[test]
    fn fits_data() {
        let ends = |values: &[f64]| {
            let axis = Axis::fitted("", values.iter().copied());
            (axis.low, axis.high)
        };
        assert_eq!(ends(&[0.1, 2.0]), (0.0, 2.0 + 0.04 * 1.9));
        assert_eq!(ends(&[10.0, 11.0]), (9.96, 11.04));
        assert_eq!(ends(&[-2.0, -0.1]), (-2.0 - 0.04 * 1.9, 0.0));
        assert_eq!(ends(&[f64::NAN, f64::INFINITY]), (0.0, 1.0));
        assert_eq!(ends(&[1.0, f64::NAN, 3.0]), (0.92, 3.08));
        assert_eq!(ends(&[]), (0.0, 1.0));
        let log = Axis::fitted_log("", [-1.0, 0.0, 1e-3, 10.0]);
        assert!((5e-4..1e-3).contains(&log.low) && (10.0..20.0).contains(&log.high));
    }

    #[test]
    fn every_range_can_be_drawn() {
        let odd = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            1e-300,
            5e-324,
            1e300,
            f64::MAX,
            f64::MIN,
            f64::NAN,
            f64::INFINITY,
            1.0 + 1e-16,
        ];
        for low in odd {
            for high in odd {
                for axis in [Axis::new("", low, high), Axis::log("", low, high)] {
                    let (from, to) = axis.range();
                    assert!(
                        from < to && from.is_finite() && to.is_finite(),
                        "{low} {high}"
                    );
                    let mapping = Mapping::new(&axis, 0.0, 100.0);
                    let places = [from, to].map(|end| mapping.at(end).unwrap());
                    assert!(
                        (places[0]).abs() < 1e-6 && (places[1] - 100.0).abs() < 1e-6,
                        "{low} {high} {places:?}"
                    );
                    for value in odd.into_iter().filter_map(|value| mapping.at(value)) {
                        assert!(value.is_finite());
                    }
                }
            }
        }
    }

    #[test]
    fn what_has_no_logarithm_has_no_place() {
        let mapping = Mapping::new(&Axis::log("", 1.0, 100.0), 0.0, 200.0);
        assert_eq!(mapping.at(10.0), Some(100.0));
        assert_eq!(
            [0.0, -1.0, f64::NAN, f64::INFINITY].map(|value| mapping.at(value)),
            [None; 4]
        );
    }
}

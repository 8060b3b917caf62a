//! Positions and labels of the ticks of an axis.

use crate::axis::{Axis, Scale, TickUnit};
use crate::label::Label;
use crate::number::{decimal, exponent, number, of_pi, scientific};
use std::f64::consts::PI;

/// A tick of an axis: its position and its label.
#[derive(Clone, Debug)]
pub(crate) struct Tick {
    pub value: f64,
    /// Label of the tick. It is empty for a tick between labelled ticks.
    pub label: Label,
}

/// Returns the ticks of an axis. At most about `count` ticks have labels.
pub(crate) fn ticks(axis: &Axis, count: usize) -> Vec<Tick> {
    let (low, high) = axis.range();
    let count = count.max(2);
    // An axis of angles has at most five ticks, at round fractions of a circle.
    let parts = count.min(5);
    match (axis.scale, axis.unit) {
        (Scale::Log, _) => log(low, high, count),
        (Scale::Linear, TickUnit::Plain) => plain(low, high, count),
        (Scale::Linear, TickUnit::Degrees) => {
            let steps = [1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720, 1440];
            let step = steps
                .into_iter()
                .find(|step| multiples(low, high, f64::from(*step)) <= parts as f64);
            match step {
                Some(step) if 3.0 <= multiples(low, high, f64::from(step)) => {
                    whole(low, high, f64::from(step), |k| {
                        number(k * i64::from(step), 0)
                    })
                }
                _ => plain(low, high, count),
            }
        }
        (Scale::Linear, TickUnit::Pi) => {
            let steps = [
                (1, 12),
                (1, 6),
                (1, 4),
                (1, 2),
                (1, 1),
                (2, 1),
                (5, 1),
                (10, 1),
                (20, 1),
                (50, 1),
            ];
            let size = |(up, down): (i64, i64)| PI * up as f64 / down as f64;
            let step = steps
                .into_iter()
                .find(|step| multiples(low, high, size(*step)) <= parts as f64);
            match step {
                Some((up, down)) if 3.0 <= multiples(low, high, size((up, down))) => {
                    whole(low, high, size((up, down)), |k| of_pi(k * up, down))
                }
                _ => plain(low / PI, high / PI, count)
                    .into_iter()
                    .map(|tick| Tick {
                        value: (tick.value * PI).clamp(low, high),
                        label: if tick.value == 0.0 {
                            tick.label
                        } else {
                            tick.label.then(&Label::verbatim("π"))
                        },
                    })
                    .collect(),
            }
        }
    }
}

/// Returns the number of multiples of a step in the range from `low` to `high`. A multiple that lies outside the range
/// only by rounding counts as well.
fn multiples(low: f64, high: f64, step: f64) -> f64 {
    let (from, to) = bounds(low, high, step);
    to - from + 1.0
}

fn bounds(low: f64, high: f64, step: f64) -> (f64, f64) {
    let slack = 1e-9 * (high / step - low / step).abs();
    ((low / step - slack).ceil(), (high / step + slack).floor())
}

fn whole(low: f64, high: f64, step: f64, label: impl Fn(i64) -> Label) -> Vec<Tick> {
    let (from, to) = bounds(low, high, step);
    // The caller has checked the number of multiples. The upper bound 64 ends the loop for any range, however large.
    (0..=64)
        .map(|i| from as i64 + i)
        .take_while(|k| *k as f64 <= to)
        .map(|k| Tick {
            value: (k as f64 * step).clamp(low, high),
            label: label(k),
        })
        .collect()
}

/// Returns the ticks of a linear axis, at multiples of 1, 2 or 5 times a power of ten. At most `count` multiples lie
/// in the range.
fn plain(low: f64, high: f64, count: usize) -> Vec<Tick> {
    let span = 2.0 * (0.5 * high / count as f64 - 0.5 * low / count as f64);
    let first = exponent(span);
    for power in first..=first + 1 {
        for digit in [1_i64, 2, 5] {
            let step = decimal(digit, power);
            if 0.0 < step && step.is_finite() && multiples(low, high, step) <= count as f64 {
                let (from, to) = bounds(low, high, step);
                return (0..=64)
                    .map(|i| from as i64 + i)
                    .take_while(|k| *k as f64 <= to)
                    .map(|k| Tick {
                        value: decimal(k * digit, power).clamp(low, high),
                        label: number(k * digit, power),
                    })
                    .collect();
            }
        }
    }
    [low, high]
        .map(|value| Tick {
            value,
            label: Label::verbatim(&format!("{value:e}")),
        })
        .to_vec()
}

/// Returns the ticks of a logarithmic axis. Powers of ten have labels. In a long range, only every n-th power has a
/// label. In a range of less than two decades, 2 and 5 times a power of ten also have labels. A range of less than 0.7
/// decades has the ticks of a linear axis.
fn log(low: f64, high: f64, count: usize) -> Vec<Tick> {
    let (first, last) = (exponent(low), exponent(high));
    let decades = libm::log10(high) - libm::log10(low);
    if decades < 0.7 {
        return plain(low, high, count);
    }
    let every = ((last - first + 1) as usize).div_ceil(count).max(1) as i32;
    let digits: &[i64] = if decades < 2.0 { &[1, 2, 5] } else { &[1] };
    let between = if decades < 7.0 { 9 } else { 1 };
    let simple = -2 <= first && last <= 4;
    let mut ticks = Vec::new();
    for power in first..=last {
        for digit in 1..=between {
            let value = decimal(digit, power);
            if !(low * (1.0 - 1e-9) <= value && value <= high * (1.0 + 1e-9)) {
                continue;
            }
            let named = digits.contains(&digit) && power.rem_euclid(every) == 0;
            let label = match (named, simple) {
                (false, _) => Label::default(),
                (true, true) => number(digit, power),
                (true, false) => scientific(digit, power),
            };
            ticks.push(Tick {
                value: value.clamp(low, high),
                label,
            });
        }
    }
    ticks
}

#[cfg(test)]
mod tests {
    use super::ticks;
    use crate::axis::Axis;

    fn said(axis: &Axis, count: usize) -> Vec<String> {
        let named = ticks(axis, count)
            .into_iter()
            .filter(|tick| !tick.label.is_empty());
        named.map(|tick| tick.label.plain()).collect()
    }

    #[test]
    fn linear_axes() {
        assert_eq!(
            said(&Axis::new("", 0.0, 2.5), 7),
            ["0", "0.5", "1", "1.5", "2", "2.5"]
        );
        assert_eq!(
            said(&Axis::new("", -0.3, 0.1), 6),
            ["−0.3", "−0.2", "−0.1", "0", "0.1"]
        );
        assert_eq!(
            said(&Axis::new("", 0.0, 0.3), 4),
            ["0", "0.1", "0.2", "0.3"]
        );
        assert_eq!(
            said(&Axis::new("", 0.0, 40_000.0), 5),
            ["0", "10000", "20000", "30000", "40000"]
        );
        assert_eq!(
            said(&Axis::new("", 0.0, 2e6), 5),
            ["0", "5×105", "106", "1.5×106", "2×106"]
        );
        assert_eq!(
            said(&Axis::new("", 0.0, 1e-300), 3),
            ["0", "5×10−301", "10−300"]
        );
        assert_eq!(said(&Axis::new("", 5.0, 1.0), 5), ["1", "2", "3", "4", "5"]);
    }

    #[test]
    fn degrees_and_multiples_of_pi() {
        let degrees = |low, high| said(&Axis::new("", low, high).degrees(), 7);
        assert_eq!(degrees(0.0, 270.0), ["0", "90", "180", "270"]);
        assert_eq!(degrees(0.0, 180.0), ["0", "45", "90", "135", "180"]);
        assert_eq!(
            said(&Axis::new("", -90.0, 270.0).degrees(), 6),
            ["−90", "0", "90", "180", "270"]
        );
        assert_eq!(degrees(0.0, 0.5), ["0", "0.1", "0.2", "0.3", "0.4", "0.5"]);
        let pi = std::f64::consts::PI;
        let turns = |low: f64, high: f64| said(&Axis::new("", low, high).in_pi(), 7);
        assert_eq!(turns(0.0, 2.0 * pi), ["0", "π/2", "π", "3π/2", "2π"]);
        assert_eq!(turns(-pi, pi / 2.0), ["−π", "−π/2", "0", "π/2"]);
        assert_eq!(turns(0.0, 4.0 * pi), ["0", "π", "2π", "3π", "4π"]);
        assert_eq!(
            turns(0.0, 0.1 * pi),
            ["0", "0.02π", "0.04π", "0.06π", "0.08π", "0.1π"]
        );
    }

    #[test]
    fn logarithmic_axes() {
        assert_eq!(
            said(&Axis::log("", 0.01, 100.0), 7),
            ["0.01", "0.1", "1", "10", "100"]
        );
        assert_eq!(
            said(&Axis::log("", 1e-6, 1.0), 8),
            ["10−6", "10−5", "10−4", "10−3", "10−2", "10−1", "100"]
        );
        assert_eq!(
            said(&Axis::log("", 1e-12, 1.0), 5),
            ["10−12", "10−9", "10−6", "10−3", "100"]
        );
        assert_eq!(
            said(&Axis::log("", 0.1, 2.0), 7),
            ["0.1", "0.2", "0.5", "1", "2"]
        );
        assert_eq!(
            said(&Axis::log("", 1.0, 3.0), 5),
            ["1", "1.5", "2", "2.5", "3"]
        );
        assert!(20 < ticks(&Axis::log("", 0.01, 100.0), 7).len());
    }

    #[test]
    fn any_range_has_a_few_ticks_inside() {
        let odd = [
            0.0,
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
            0.1,
            123_456.789,
        ];
        let mut checked = 0;
        for low in odd {
            for high in odd {
                let linear = Axis::new("", low, high);
                for axis in [
                    linear.clone().degrees(),
                    linear.clone().in_pi(),
                    Axis::log("", low, high),
                    linear,
                ] {
                    let found = ticks(&axis, 7);
                    let (from, to) = axis.range();
                    let named = found.iter().filter(|tick| !tick.label.is_empty()).count();
                    assert!((2..=9).contains(&named), "{axis:?}: {named}");
                    assert!(
                        found
                            .iter()
                            .all(|tick| from <= tick.value && tick.value <= to),
                        "{axis:?}"
                    );
                    let said = found.iter().map(|tick| tick.label.plain());
                    assert!(
                        said.into_iter()
                            .all(|text| !text.contains("NaN") && !text.contains("inf"))
                    );
                    checked += 1;
                }
            }
        }
        assert_eq!(checked, 4 * 13 * 13);
    }
}

//! Computes derivatives by differences with Richardson extrapolation, and compares them with the slope of a dual
//! number.
//!
//! The tolerance is the error of the difference. This error is ten times the last change by extrapolation, plus the
//! rounding of the values divided by the smallest step. The rounding is 2^-84 of the values, because a search
//! distinguishes instants to 2^-90. The non-dimensional terms of an answer are of order 1, so no answer is rounded to
//! less than 2^-100, even where the terms cancel to 0.

use crate::sensitivities::answers::{Answers, is_phase};
use frictiongen::study::sensitivity::Sensitive;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;

const LEVELS: usize = 4;
/// Largest tolerance, as a fraction of the slope plus the value divided by the `unit` of [`compare`]. A comparison
/// with a larger tolerance would prove nothing.
const VACUOUS: f64 = 1e-9;
/// Replaces the size of a value that is 0.
const OF_NOTHING: f64 = 1e-20;

/// Side from which a difference is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Both,
    /// The difference uses larger values only, because a quantity such as ζ = 0 is at the lower bound of its range.
    Above,
}

/// A derivative from differences, with a bound on its error.
struct Difference {
    value: Dd,
    error: f64,
}

/// Extrapolates difference quotients to the step h = 0. `values` has f(x + h_k) and f(x − h_k) for the steps h_k =
/// h/2^k; a one-sided difference has f(x) in place of f(x − h_k).
fn extrapolated(values: &[[Dd; 2]], h: Dd, side: Side, size: f64) -> Difference {
    let two = Dd::from(2.0);
    let mut step = h;
    let mut row: Vec<Dd> = Vec::new();
    for [above, below] in values {
        let span = if side == Side::Both {
            step + step
        } else {
            step
        };
        row.push((*above - *below) / span);
        step = step / two;
    }
    let smallest = step.to_f64();
    let mut error = f64::INFINITY;
    for k in 1..values.len() {
        let order = if side == Side::Both { 2 * k } else { k };
        let factor = Dd::from((order as f64).exp2());
        let next: Vec<Dd> = row
            .windows(2)
            .map(|pair| (pair[1] * factor - pair[0]) / (factor - Dd::ONE))
            .collect();
        error = (next[next.len() - 1] - row[row.len() - 1]).abs().to_f64();
        row = next;
    }
    Difference {
        value: row[0],
        error: 10.0 * error + (size * (-84f64).exp2() + (-100f64).exp2()) / smallest,
    }
}

/// Results of a comparison of slopes with differences.
#[derive(Default)]
pub struct Outcome {
    pub compared: usize,
    /// Number of answers that only one of the two evaluations has.
    pub skipped: usize,
    pub worst: f64,
    /// Largest tolerance that occurred, as a fraction of the slope plus the value divided by the `unit` of
    /// [`compare`].
    pub widest: f64,
    pub failures: Vec<String>,
}

impl Outcome {
    pub fn join(&mut self, other: Self) {
        self.compared += other.compared;
        self.skipped += other.skipped;
        self.worst = self.worst.max(other.worst);
        self.widest = self.widest.max(other.widest);
        self.failures.extend(other.failures);
    }

    /// Prints the results, and asserts the numbers of compared and of skipped answers.
    pub fn report(&self, title: &str, counts: (usize, usize)) {
        println!(
            "{title}: {} derivatives, {} skipped that one reading does not have; worst {:.3} of the difference's own error, which is {:.1e} of \
             the derivative at most",
            self.compared, self.skipped, self.worst, self.widest
        );
        let first: Vec<&String> = self.failures.iter().take(20).collect();
        let count = self.failures.len();
        assert!(self.failures.is_empty(), "{count} failures: {first:#?}");
        assert_eq!((self.compared, self.skipped), counts, "{title}");
    }
}

fn turned(value: Dd, by: Dd) -> Dd {
    let turn = Dd::PI + Dd::PI;
    let turns = Float::floor((value - by) / turn + Dd::from(0.5));
    value - turns * turn
}

/// Compares slopes with differences, for the answers that both evaluations have. `at` returns the answers with the
/// variable shifted by its argument. `unit` is the size of a shift that changes the answers noticeably.
pub fn compare(
    name: &str,
    dual: &Answers<Sensitive>,
    at: impl Fn(Dd) -> Answers<Dd>,
    unit: f64,
    side: Side,
) -> Outcome {
    let h = Dd::from((unit.log2().floor() - 13.0).exp2());
    let centre = at(Dd::ZERO);
    let pairs: Vec<[Answers<Dd>; 2]> = (0..LEVELS)
        .map(|k| {
            let step = h * Dd::from((-(k as f64)).exp2());
            let below = match side {
                Side::Both => at(-step),
                Side::Above => centre.clone(),
            };
            [at(step), below]
        })
        .collect();
    let mut outcome = Outcome::default();
    for (place, (asked, middle)) in centre.iter().enumerate() {
        let Some((_, answer)) = dual.iter().find(|(name, _)| name == asked) else {
            outcome.skipped += 1;
            continue;
        };
        let values: Vec<[Dd; 2]> = pairs
            .iter()
            .map(|pair| {
                [0, 1].map(|i| {
                    let value = pair[i][place].1;
                    if is_phase(asked) {
                        turned(value, *middle)
                    } else {
                        value
                    }
                })
            })
            .collect();
        let size = if is_phase(asked) {
            std::f64::consts::PI
        } else {
            middle.abs().to_f64()
        };
        let difference = extrapolated(&values, h, side, size);
        let off = (answer.slope - difference.value).abs().to_f64();
        let scale = difference.value.abs().to_f64() + size / unit;
        let exact = if is_phase(asked) {
            turned(answer.value, *middle)
        } else {
            answer.value
        };
        outcome.compared += 1;
        let same = (exact - *middle).abs().to_f64() <= 1e-24 * size;
        if !(off <= difference.error)
            || !same
            || !(difference.error <= VACUOUS * scale + OF_NOTHING)
        {
            outcome.failures.push(format!(
                "{name}: {asked} = {:e}, slope {:e}, difference {:e} ± {:.1e}, off by {off:.1e}{}",
                middle.to_f64(),
                answer.slope.to_f64(),
                difference.value.to_f64(),
                difference.error,
                if same { "" } else { ", values differ" },
            ));
        }
        let ratio = off / difference.error;
        if ratio.is_finite() {
            outcome.worst = outcome.worst.max(ratio);
        }
        if difference.error > OF_NOTHING {
            outcome.widest = outcome.widest.max(difference.error / scale);
        }
    }
    outcome
}

//! A witness: an instant, as a polynomial in r, at which the velocity constraint is nearly largest. The module also
//! computes β_lim from the constraint of the witness.

use crate::series::IntervalSeries;
use crate::stage::ChainStage;
use crate::{early, force};
use frictiongen_model::interval::Interval;

/// Assumed position of the largest velocity constraint, for all r of an interval.
#[derive(Clone, Debug)]
pub(crate) enum Witness {
    /// The break-away term. For μ = 1 it equals the constraint at the start of the half period.
    BreakAway,
    /// The witness is the instant τ = πt, where t is a polynomial in r − r₀ with these coefficients. Its velocity
    /// constraint is F/sin τ.
    Instant(Vec<f64>),
    /// The witness is the instant τ = πt near the start of the half period, where t is a polynomial in r − r₀ with
    /// these coefficients. A Taylor series in τ gives its velocity constraint.
    Early(Vec<f64>),
}

impl Witness {
    /// Returns the instant t of the witness at r₀ + `away`.
    pub fn path<const N: usize>(&self, away: Interval) -> IntervalSeries<N> {
        let coefficients: &[f64] = match self {
            Self::BreakAway => &[0.5],
            Self::Instant(coefficients) | Self::Early(coefficients) => coefficients,
        };
        polynomial(coefficients, IntervalSeries::variable(away))
    }
}

/// Returns the value Σ c_k tᵏ of a polynomial at a series t.
pub(crate) fn polynomial<const N: usize>(
    coefficients: &[f64],
    t: IntervalSeries<N>,
) -> IntervalSeries<N> {
    let zero = IntervalSeries::fixed(Interval::ZERO);
    coefficients.iter().rev().fold(zero, |sum, coefficient| {
        sum * t + IntervalSeries::fixed(Interval::point(*coefficient))
    })
}

/// The values of a witness at the frequency ratios of an interval.
///
/// N is slightly above the constraint of the witness. The proof must show that D = N sin τ − F is positive at all other
/// instants. For a witness near the start, D/τ takes the place of D.
#[derive(Clone, Debug)]
pub(crate) struct WitnessInstant<const N: usize> {
    /// The instant t = τ/π, in half-turns.
    pub t: IntervalSeries<N>,
    /// sin τ, or sin τ/τ for a witness near the start.
    pub weight: IntervalSeries<N>,
    /// The slope in τ of `weight`.
    pub turn: IntervalSeries<N>,
    /// κ times the velocity constraint of the witness. The largest constraint is at least as large.
    pub constraint: IntervalSeries<N>,
    /// (κU)² + (κQ)². U is the velocity of the contact that friction causes, and Q the constraint of the witness.
    pub size: IntervalSeries<N>,
    /// The slope in τ of D, or of D/τ for a witness near the start. In this D, the witness's constraint takes the place
    /// of N.
    pub rise: IntervalSeries<N>,
}

impl<const N: usize> WitnessInstant<N> {
    /// Evaluates a witness. `rest` is the result of [`early::rest`] for a witness near the start.
    pub fn of(
        witness: &Witness,
        stage: &ChainStage<N>,
        away: Interval,
        rest: [Interval; 2],
    ) -> Self {
        let t = witness.path::<N>(away);
        let zero = IntervalSeries::fixed(Interval::ZERO);
        let (weight, turn, constraint, rise);
        match witness {
            Witness::BreakAway => {
                (weight, turn, constraint, rise) = (zero, zero, stage.break_away, zero);
            }
            Witness::Instant(_) => {
                (weight, turn) = t.sine_cosine();
                let motions = force::motions(stage, &t);
                constraint = force::value(stage, &motions, &turn) / weight;
                rise = constraint * turn - force::slope(stage, &motions, &weight);
            }
            Witness::Early(_) => {
                let tau = t.times(Interval::pi());
                (weight, turn) = early::sinc(&tau);
                let (value, slope) = early::over_tau(stage, &tau);
                let [of_value, of_slope] = rest.map(IntervalSeries::fixed);
                constraint = (value + of_value) / weight;
                rise = constraint * turn - (slope + of_slope);
            }
        }
        let size = stage.quadrature.squared() + constraint.squared();
        Self {
            t,
            weight,
            turn,
            constraint,
            size,
            rise,
        }
    }

    /// Makes the series over an interval narrower, by means of the series `at` a point in the interval.
    pub fn refine(&mut self, at: &Self, away: Interval) {
        self.constraint = self.constraint.refined(&at.constraint, away);
        self.size = self.size.refined(&at.size, away);
        self.rise = self.rise.refined(&at.rise, away);
    }
}

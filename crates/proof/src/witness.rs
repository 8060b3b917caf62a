//! Defines the witness, an instant near the largest velocity constraint, as a polynomial in r, and evaluates the
//! functions at the witness.

use crate::series::IntervalSeries;
use crate::stage::ChainStage;
use crate::{early, force};
use frictiongen_model::interval::Interval;

/// An instant that the proof takes for the position of the largest velocity constraint, for all r of an interval.
#[derive(Clone, Debug)]
pub(crate) enum Witness {
    /// No instant: the break-away term takes the place of the largest velocity constraint. For μ = 1 this term equals
    /// the velocity constraint at the start of the half period.
    BreakAway,
    /// The instant τ = πt, where t is a polynomial in r − r₀ with these coefficients. The velocity constraint at this
    /// instant is F/sin τ, where F is a sum over the modes.
    Instant(Vec<f64>),
    /// The instant τ = πt near the start of the half period, where t is a polynomial in r − r₀ with these
    /// coefficients. A Taylor series in τ gives its velocity constraint.
    Early(Vec<f64>),
}

impl Witness {
    /// Returns the instant t = τ/π of this witness at r₀ + `away`, as a series in r. r₀ is the centre of the interval
    /// of r.
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

/// The functions at a witness (an instant near the largest velocity constraint), as series in r at a point or over an
/// interval.
///
/// N is a number slightly above the velocity constraint F/sin τ of the witness. The proof must show that D = N sin τ −
/// F is positive at all instants. For a witness near the start of the half period, D/τ takes the place of D.
#[derive(Clone, Debug)]
pub(crate) struct WitnessInstant<const N: usize> {
    /// The instant t = τ/π of the witness, in half-turns.
    pub t: IntervalSeries<N>,
    /// sin τ at the `Witness`, or sin τ/τ for a witness near the start of the half period.
    pub weight: IntervalSeries<N>,
    /// The slope in τ of `weight`.
    pub turn: IntervalSeries<N>,
    /// κ times the velocity constraint Q of the `Witness`, where κ is the common factor of `ChainStage`. The largest
    /// constraint is at least Q.
    pub constraint: IntervalSeries<N>,
    /// (κr²U)² + (κQ)², where κ is the common factor of `ChainStage`. Q is the velocity constraint F/sin τ at the
    /// `Witness`. U is the part of the contact's velocity at a reversal that the friction force causes.
    pub size: IntervalSeries<N>,
    /// The slope in τ of D = N sin τ − F, with the velocity constraint of the `Witness` in place of N. F/sin τ is the
    /// velocity constraint. For a witness near the start of the half period, this field has the slope of D/τ.
    pub rise: IntervalSeries<N>,
}

impl<const N: usize> WitnessInstant<N> {
    /// Evaluates the functions at a `Witness`. For a witness near the start of the half period, `rest` is the result of
    /// [`early::rest`]. Otherwise `rest` is 0.
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

    /// Makes the coefficients over an interval of r narrower, by means of the series `at` a point in the interval.
    /// `away` is the interval minus that point.
    pub fn refine(&mut self, at: &Self, away: Interval) {
        self.constraint = self.constraint.refined(&at.constraint, away);
        self.size = self.size.refined(&at.size, away);
        self.rise = self.rise.refined(&at.rise, away);
    }
}

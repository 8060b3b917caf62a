//! The data of the proof for the cells of a half period, over an interval of r. The proof must show that the function
//! D(τ, r) = N(r) sin τ − F(τ, r) is positive. F is the sum of the velocity constraint over the modes (module
//! `force`). N is slightly above the value of F/sin τ at the witness, an instant near the largest F/sin τ.

use crate::force;
use crate::found::Budget;
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, IntervalChain, ORDER};
use crate::witness::{Witness, WitnessInstant};
use frictiongen_model::interval::Interval;
use std::f64::consts::PI;

/// Length of a step that widens the interval of τ about a witness (an instant near the largest velocity constraint), as
/// a fraction of √(N/D″). [`HalfPeriodCells`] defines the level N, and the function D(τ) that must be positive. The
/// value is tuned. A longer step widens the interval faster, but gives wider bounds of D″.
const TUBE_STEP: f64 = 0.3;
/// Largest number of steps that widen the interval of τ about a witness, before and after the witness. A witness is an
/// instant near the largest velocity constraint. The value is tuned. It limits the work for one interval of τ.
const TUBE_STEPS: usize = 8;
/// Largest first step that widens the interval of τ about a witness, as a fraction of the distance from the witness to
/// the end of the half period. A witness is an instant near the largest velocity constraint. The value is tuned. For a
/// flat maximum, a step in proportion to √(N/D″) alone would be too long.
const TUBE_FIRST: f64 = 0.2;
/// Largest sum of the steps that widen the interval of τ about a witness, as a fraction of the distance from the
/// witness to the end of the half period. A witness is an instant near the largest velocity constraint. The interval
/// must end before the half period does.
const TUBE_MOST: f64 = 0.9;
/// Relative allowance for the rounding of an instant, of a bound of an interval of τ, or of r. It is thousands of
/// rounding units.
pub(crate) const ROUNDING: f64 = 1e-12;

/// Smallest D″ in an interval of τ about an instant, as a fraction of D″ at the instant. D is the function of τ that
/// the proof must show to be positive ([`HalfPeriodCells`]). The value is tuned. A smaller fraction gives a wider
/// interval, but a flatter parabola as lower bound on D.
pub(crate) const BENT: f64 = 0.15;

/// The chain and the witness at the centre of an interval of r (fields with `at`), and over the whole interval
/// (fields with `over`). The witness is an instant near the largest velocity constraint.
pub(crate) struct CellData<'a> {
    pub chain: &'a IntervalChain,
    pub witness: &'a Witness,
    /// The interval of r minus its centre.
    pub away: Interval,
    pub at: &'a ChainStage<ORDER>,
    pub over: &'a ChainStage<ORDER>,
    pub seen_at: &'a WitnessInstant<ORDER>,
    pub seen_over: &'a WitnessInstant<ORDER>,
    /// Relative distance of the two proven bounds on β_lim. The exact β_lim is between b/(1 + `share`) and b. Here b is
    /// the β_lim that follows from the witness, an instant near the largest velocity constraint F/sin τ. F is the
    /// function of [`HalfPeriodCells`].
    ///
    /// The exact β_lim is inversely proportional to √(U² + S²), where S is the largest F/sin τ. U is the part of the
    /// contact's velocity at a reversal that the friction force causes. For b, the value Q of F/sin τ at the witness
    /// takes the place of S. The proof must show that F/sin τ is below a level N everywhere. N = Q would fail at the
    /// witness itself. N is therefore above Q, such that √(U² + N²) = (1 + `share`) √(U² + Q²).
    pub share: f64,
}

/// The half period before or after the witness, which is an instant near the largest velocity constraint. A `share` is
/// a position in this range of instants. It is 0 at the end of the half period (τ = 0 or τ = π), and 1 at the witness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Flank {
    Before,
    After,
}

/// Data of the chain and of the witness, over an interval of r, for the proof in the cells of the half period.
///
/// Cells are intervals of τ. The proof must show in each cell that D = N sin τ − F is positive. F/sin τ is the velocity
/// constraint at τ, for 0 < τ < π. N is a level slightly above the value of F/sin τ at the witness, which is an instant
/// near the largest F/sin τ.
pub(crate) struct HalfPeriodCells<'a> {
    /// The chain at the centre of the interval of r.
    pub thin: ChainStage<1>,
    /// The chain over the interval of r, with derivatives with respect to r.
    pub wide: ChainStage<2>,
    /// The chain over the interval of r, without derivatives.
    pub flat: ChainStage<1>,
    /// The number N, slightly above the velocity constraint of the `Witness`. `level_at` is N at the centre of the
    /// interval of r, and `level_over` is N over the interval.
    pub level_at: IntervalSeries<1>,
    pub level_over: IntervalSeries<2>,
    pub full_at: IntervalSeries<ORDER>,
    pub full_over: IntervalSeries<ORDER>,
    pub path_at: Interval,
    pub path_over: IntervalSeries<2>,
    pub part: &'a CellData<'a>,
}

/// Returns κN. N is the level for which √(U² + N²) is 1 + `share` times √(U² + Q²). Q is the velocity constraint
/// F/sin τ at the witness. U is the part of the contact's velocity at a reversal that the friction force causes. κ is
/// the product of cosines in [`ChainStage`].
fn level<const N: usize>(seen: &WitnessInstant<N>, share: f64) -> IntervalSeries<N> {
    let share = Interval::point(share);
    let more = share + share + share * share;
    (seen.constraint.squared() + seen.size.times(more)).sqrt()
}

impl<'a> HalfPeriodCells<'a> {
    pub fn of(part: &'a CellData<'a>) -> Self {
        let (level_at, level_over) = (
            level(part.seen_at, part.share),
            level(part.seen_over, part.share),
        );
        Self {
            thin: part.at.truncated(),
            wide: part.over.truncated(),
            flat: part.over.truncated(),
            level_at: level_at.truncated(),
            level_over: level_over.truncated(),
            full_at: level_at,
            full_over: level_over,
            path_at: part.seen_at.t.value(),
            path_over: part.seen_over.t.truncated(),
            part,
        }
    }

    /// Returns F as a series in r with its slope, over intervals of t = τ/π and of r. F is the sum of the velocity
    /// constraint over the modes. The other results are the derivatives F′, F″ and F‴ in τ, then sin τ and cos τ.
    pub fn boxed(&self, t: Interval) -> (IntervalSeries<2>, [Interval; 3], (Interval, Interval)) {
        let at = IntervalSeries::<2>::fixed(t);
        let (sine, cosine) = t.sine_cosine();
        let motions = force::motions(&self.wide, &at);
        let value = force::value(&self.wide, &motions, &IntervalSeries::fixed(cosine));
        let derivatives = force::derivatives(&self.wide, &motions, (sine, cosine));
        (value, derivatives, (sine, cosine))
    }

    /// Returns the derivatives F′, F″ and F‴ in τ = πt over intervals of t and r, then sin τ and cos τ. F is the sum
    /// of the velocity constraint over the modes.
    pub fn derivatives(&self, t: Interval) -> ([Interval; 3], (Interval, Interval)) {
        let waves = t.sine_cosine();
        let motions = force::motions(&self.flat, &IntervalSeries::fixed(t));
        (force::derivatives(&self.flat, &motions, waves), waves)
    }

    /// Returns D″, the second derivative in τ of the function D of [`HalfPeriodCells`], over an interval of t = τ/π and
    /// the whole interval of r.
    pub fn bend(&self, t: Interval, budget: &mut Budget) -> Interval {
        budget.spend(2 * self.wide.modes.len());
        let level = self.level_over.value();
        let ([_, second, third], (sine, cosine)) = self.derivatives(t);
        let plain = -(level * sine) - second;
        // The mean value form about the middle of the interval of t makes the bound narrower.
        let middle = Interval::point(t.middle());
        let ([_, second, _], (sine, _)) = self.derivatives(middle);
        let moves = (-(level * cosine) - third) * (t - middle) * Interval::pi();
        plain.both(-(level * sine) - second + moves)
    }

    /// Returns an interval of τ about an instant in which D″ stays above the fraction `bent` of its value at the
    /// instant. D is the function of τ that must be positive ([`HalfPeriodCells`]). The first result has the lengths of
    /// the interval before and after the instant, in half-turns. The second is the smallest D″ in the interval.
    pub fn widened(
        &self,
        t: Interval,
        curve: Interval,
        bent: f64,
        budget: &mut Budget,
    ) -> ([f64; 2], f64) {
        let length = TUBE_STEP * (self.level_over.value().high / curve.middle()).sqrt() / PI;
        let (mut least, mut reach) = (curve.low, [0.0_f64; 2]);
        for (place, reach) in reach.iter_mut().enumerate() {
            let room = if place == 0 { t.low } else { 1.0 - t.high };
            let mut step = length.min(TUBE_FIRST * room);
            for _ in 0..TUBE_STEPS {
                let far = *reach + step;
                let all = if place == 0 {
                    Interval::new(t.low - far, t.high - *reach)
                } else {
                    Interval::new(t.low + *reach, t.high + far)
                };
                let bend = self.bend(all, budget).low;
                if far < TUBE_MOST * room && bend > bent * curve.low {
                    least = least.min(bend);
                    *reach = far;
                } else {
                    step *= 0.5;
                }
            }
        }
        (reach, least)
    }

    /// Returns the instant t = τ/π at the position `share`, which is 0 at an end of the half period and 1 at the
    /// `Witness`. The results are t over the whole interval of r, the slope of t with respect to r, and t at the centre
    /// of the interval.
    pub fn instant(&self, side: Flank, share: Interval) -> (Interval, Interval, Interval) {
        let (path, slope) = (self.path_over.value(), self.path_over.term(1));
        match side {
            Flank::Before => (path * share, slope * share, self.path_at * share),
            Flank::After => {
                let rest = |path: Interval| Interval::ONE - (Interval::ONE - path) * share;
                (rest(path), slope * share, rest(self.path_at))
            }
        }
    }
}

//! Compares the polynomial of a table's piece with the β_lim that follows from the witness, over an interval of r. The
//! witness is an instant near the largest velocity constraint.

use crate::series::IntervalSeries;
use crate::stage::{ChainStage, ORDER};
use crate::witness::{WitnessInstant, polynomial};
use frictiongen_kernel::Float;
use frictiongen_model::interval::Interval;
use frictiongen_model::scene::Side;
use frictiongen_model::table::Fitted;
use frictiongen_model::table::Request;
use frictiongen_model::table::Worst;
use frictiongen_model::table::building::rounding;

/// Number of terms of a series after its division by the distance from a zero of β_lim. The division loses one term.
pub(crate) const SHORT: usize = ORDER - 1;
/// Number of cells into which the code divides an interval of r to bound a polynomial. The value is tuned. More cells
/// give narrower bounds, but take more work.
pub(crate) const CELLS: usize = 8;
/// Largest fraction of the accuracy that the uncertain position of a zero of β_lim may use up. The value is tuned. The
/// proof does not cover a neighbourhood of the zero. The length of this neighbourhood is inversely proportional to the
/// fraction.
const UNCERTAIN: f64 = 0.01;
/// Smallest distance from a zero of β_lim, divided by r, down to which the proof covers r. It is hundreds of rounding
/// units.
const NEAREST: f64 = 1e-13;
/// Relative rounding error, or angle in rad, up to which the bounds are valid. A larger error exceeds every permitted
/// accuracy, so the comparison fails in any case.
pub(crate) const SMALL: f64 = 0.1;

/// Result of the comparison of a table's β_lim with the β_lim from the `Witness`, over an interval of r.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ComparedLimit {
    /// Largest possible relative error of the table's β_lim, with the r at which it occurs.
    pub worst: Worst,
    /// Neighbourhood of a zero of β_lim in which the comparison proves nothing, as an interval of r. `None` without a
    /// zero.
    pub gap: Option<(f64, f64)>,
    /// The interval of r that the comparison proves, minus the centre of the series.
    pub away: Interval,
    /// Square of the quotient p/β_lim. p is the polynomial of the table, and β_lim comes from the `Witness`. The first
    /// series is at the centre of the interval of r, the second over the interval.
    pub square: [IntervalSeries<SHORT>; 2],
    /// Largest rounding error in the evaluation of the table's polynomial p, divided by p.
    pub rounding: f64,
}

/// Returns a series divided by r − r₀, where r₀ is the centre of the series. The function of the series must be zero at
/// r₀, so the code ignores the first coefficient.
pub(crate) fn divided(series: &IntervalSeries<ORDER>) -> IntervalSeries<SHORT> {
    let mut terms = [Interval::ZERO; SHORT];
    for (term, own) in terms.iter_mut().zip(series.terms.iter().skip(1)) {
        *term = *own;
    }
    IntervalSeries { terms }
}

/// Compares the polynomial of a piece with β_lim over an interval of r. Returns `None` if the polynomial is not proven
/// to be within the accuracy. The exact β_lim is at most the β_lim from the `Witness`, and smaller by at most the
/// fraction `share`.
pub(crate) fn compared<S: Float>(
    piece: &Fitted<S>,
    request: &Request,
    (from, to): (f64, f64),
    zero: Option<f64>,
    [at, over]: [&ChainStage<ORDER>; 2],
    [seen_at, seen_over]: [&WitnessInstant<ORDER>; 2],
    share: f64,
) -> Option<ComparedLimit> {
    let coefficients: Vec<f64> = piece
        .coefficients
        .first()?
        .iter()
        .map(|coefficient| coefficient.to_f64())
        .collect();
    let origin = piece.origin.to_f64();
    let centre = zero.unwrap_or(0.5 * (from + to));
    let r = Interval::new(from.min(centre), to.max(centre));
    let table = |r: Interval| {
        let t =
            IntervalSeries::<ORDER>::variable(r) - IntervalSeries::fixed(Interval::point(origin));
        polynomial(&coefficients, t)
    };
    let (own_at, own_over) = (table(Interval::point(centre)), table(r));
    let accuracy = request.accuracy;
    // `nearest` is the distance from the zero of β_lim down to which the proof covers r.
    let (mut nearest, mut gap) = (0.0, None);
    if zero.is_some() {
        let size = |place: usize| {
            let [re, im] = at.excitation.map(|part| part.term(place));
            re.size().hypot(im.size())
        };
        let table = own_at.value().size() / own_at.term(1).size();
        let place = (size(0) / size(1)).max(table);
        let rounded = (origin - centre).abs();
        nearest = (place / (UNCERTAIN * accuracy))
            .max(NEAREST * centre)
            .max(rounded);
        if !(nearest < 0.5 * (to - from)) {
            return None;
        }
        gap = if centre < 0.5 * (from + to) {
            (from < centre + nearest).then_some((from, centre + nearest))
        } else {
            (centre - nearest < to).then_some((centre - nearest, to))
        };
    }
    let away = {
        let all = Interval::new(from, to) - Interval::point(centre);
        match zero {
            None => all,
            Some(_) if centre < 0.5 * (from + to) => Interval::new(nearest.max(all.low), all.high),
            Some(_) => Interval::new(all.low, (-nearest).min(all.high)),
        }
    };
    let ratio =
        |own: &IntervalSeries<ORDER>, stage: &ChainStage<ORDER>, seen: &WitnessInstant<ORDER>| {
            if zero.is_some() {
                let part = |series: &IntervalSeries<ORDER>, first: Interval| {
                    divided(series) + IntervalSeries::fixed(first / away)
                };
                let [re, im] = [0, 1].map(|place| {
                    let of = |stage: &ChainStage<ORDER>| stage.excitation.get(place).copied();
                    let zero = IntervalSeries::fixed(Interval::ZERO);
                    let (own, first) = (of(stage).unwrap_or(zero), of(at).unwrap_or(zero));
                    part(&own, first.value())
                });
                let own = part(own, own_at.value());
                own.squared() * seen.size.truncated() / (re.squared() + im.squared())
            } else {
                let [re, im] = stage.excitation.map(|part| part.truncated());
                let own = own.truncated::<SHORT>();
                own.squared() * seen.size.truncated() / (re.squared() + im.squared())
            }
        };
    let squares = [
        ratio(&own_at, at, seen_at),
        ratio(&own_over, over, seen_over),
    ];
    let [square_at, square_over] = &squares;
    let joined = IntervalSeries::joined(square_at, square_over);
    // `own` contains the values of the polynomial over the interval. Near a zero, it contains the polynomial divided
    // by the distance from the zero.
    let own = match zero {
        None => IntervalSeries::joined(&own_at, &own_over).range(away),
        Some(_) => {
            let own = IntervalSeries::joined(&divided(&own_at), &divided(&own_over)).range(away);
            own + own_at.value() / away
        }
    };
    let sign = if zero.is_some() { away.sign() } else { 1 };
    if own.sign() != sign {
        return None;
    }
    let least = own.low.abs().min(own.high.abs());
    let rounding = rounding::<S>(&coefficients, origin, (from, to), zero.map(|_| away)) / least;
    if !(rounding < SMALL) {
        return None;
    }
    let (up, down) = (
        (Interval::ONE + Interval::point(share)) * (Interval::ONE + Interval::point(rounding)),
        Interval::ONE - Interval::point(rounding),
    );
    let mut worst = Worst {
        error: 0.0,
        at: from,
    };
    for cell in away.parts(CELLS) {
        let square = joined.range(cell);
        if !(0.0 < square.low && square.high.is_finite()) {
            return None;
        }
        let ratio = square.sqrt();
        let (most, least) = ((ratio * up).high, (ratio * down).low);
        let above = match request.side {
            Side::Near => 1.0 + accuracy,
            Side::Safe => 1.0,
        };
        if !(most <= above && 1.0 - accuracy <= least) {
            return None;
        }
        let error = (most - 1.0).max(1.0 - least);
        if error > worst.error {
            worst = Worst {
                error,
                at: centre + cell.middle(),
            };
        }
    }
    Some(ComparedLimit {
        worst,
        gap,
        away,
        square: squares,
        rounding,
    })
}

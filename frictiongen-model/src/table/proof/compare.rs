//! Compares the polynomial of a piece with β_lim of a witness, over an interval of r.

use super::super::fit::Fitted;
use super::super::request::{Request, is_single};
use super::super::worst::Worst;
use super::stage::{ORDER, Stage};
use super::witness::{Seen, polynomial};
use crate::interval::{Interval, Series};
use crate::scene::Side;
use frictiongen_kernel::Float;

/// Number of terms after a division by the distance from a zero, which costs one term.
pub(super) const SHORT: usize = ORDER - 1;
/// Number of cells into which an interval is divided to bound a polynomial.
pub(super) const CELLS: usize = 8;
/// Largest share of the accuracy that the uncertain position of a zero of β_lim may use.
const UNCERTAIN: f64 = 0.01;
/// Smallest distance from a zero, relative to r, at which anything is proven.
const NEAREST: f64 = 1e-13;
/// Allowance for products that underflow in a polynomial, in single and in double precision: some of the smallest
/// numbers.
const UNDERFLOW_SINGLE: f64 = 1e-43;
const UNDERFLOW: f64 = 1e-321;
/// Factor on a sum of roundings, for their products and for the roundings of the sum itself.
const UP: f64 = 1.001;

/// Result of a proof over an interval of r.
#[derive(Clone, Copy, Debug)]
pub(super) struct Compared {
    /// The largest possible error, with its r.
    pub worst: Worst,
    /// The neighbourhood of a zero that is left open.
    pub gap: Option<(f64, f64)>,
    /// The proven interval, relative to the centre of the series.
    pub away: Interval,
    /// The square of the polynomial over β_lim of the witness, at the centre and over the interval.
    pub square: [Series<SHORT>; 2],
    /// Largest rounding error of the evaluation, relative.
    pub rounding: f64,
}

/// Returns the largest number of roundings of the term c_k tᵏ in the emitted evaluation.
///
/// A pair c_2j + c_2j+1·t has one rounding for its sum, and its second term has one more. The sum with the higher terms
/// has one. Each of the j products with t² adds three: the product, the rounding of t², and a sum. The difference r −
/// origin is exact if both are within a factor of two. Otherwise it adds a rounding for each power.
fn counts(power: usize, exact_difference: bool) -> f64 {
    let of_difference = if exact_difference { 0 } else { power };
    (power % 2 + 2 + 3 * (power / 2) + of_difference) as f64
}

/// Returns the series divided by the distance from the centre, without the term of the value at the centre.
pub(super) fn divided(series: &Series<ORDER>) -> Series<SHORT> {
    let mut terms = [Interval::ZERO; SHORT];
    for (term, own) in terms.iter_mut().zip(series.terms.iter().skip(1)) {
        *term = *own;
    }
    Series { terms }
}

/// Returns the comparison of the emitted polynomial with β_lim, or `None` if it is not within the accuracy. β_lim is
/// that of the witness, or less by at most `share`.
pub(super) fn compared<S: Float>(
    piece: &Fitted<S>,
    request: &Request,
    (from, to): (f64, f64),
    zero: Option<f64>,
    [at, over]: [&Stage<ORDER>; 2],
    [seen_at, seen_over]: [&Seen<ORDER>; 2],
    share: f64,
) -> Option<Compared> {
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
        let t = Series::<ORDER>::variable(r) - Series::fixed(Interval::point(origin));
        polynomial(&coefficients, t)
    };
    let (own_at, own_over) = (table(Interval::point(centre)), table(r));
    let accuracy = request.accuracy;
    // The proof stops at this distance from the zero.
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
    let ratio = |own: &Series<ORDER>, stage: &Stage<ORDER>, seen: &Seen<ORDER>| {
        if zero.is_some() {
            let part = |series: &Series<ORDER>, first: Interval| {
                divided(series) + Series::fixed(first / away)
            };
            let [re, im] = [0, 1].map(|place| {
                let of = |stage: &Stage<ORDER>| stage.excitation.get(place).copied();
                let zero = Series::fixed(Interval::ZERO);
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
    let joined = Series::joined(square_at, square_over);
    // The smallest value of the polynomial, divided near a zero by the distance from it, and its rounding error.
    let own = match zero {
        None => Series::joined(&own_at, &own_over).range(away),
        Some(_) => {
            let own = Series::joined(&divided(&own_at), &divided(&own_over)).range(away);
            own + own_at.value() / away
        }
    };
    let sign = if zero.is_some() { away.sign() } else { 1 };
    if own.sign() != sign {
        return None;
    }
    let least = own.low.abs().min(own.high.abs());
    let rounding = rounding::<S>(&coefficients, origin, (from, to), zero.map(|_| away)) / least;
    if !(rounding < 0.1) {
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
    Some(Compared {
        worst,
        gap,
        away,
        square: squares,
        rounding,
    })
}

/// Returns the largest rounding error of the evaluation in the table's scalar. Near a zero, returns it divided by the
/// distance from the zero.
pub(in crate::table) fn rounding<S: Float>(
    coefficients: &[f64],
    origin: f64,
    (from, to): (f64, f64),
    away: Option<Interval>,
) -> f64 {
    let unit = 0.5 * S::EPSILON;
    let t = (from - origin).abs().max((to - origin).abs());
    let exact = 0.5 * origin <= from && to <= 2.0 * origin;
    let nearest = away.map(|away| away.low.abs().min(away.high.abs()));
    let mut sum = 0.0;
    let mut power = 1.0;
    for (k, coefficient) in coefficients.iter().enumerate() {
        let term = coefficient.abs() * counts(k, exact) * unit;
        sum += match nearest {
            None => term * power,
            // For k > 0, tᵏ over the distance grows with the distance, apart from the offset of the origin.
            Some(nearest) if k == 0 => term / nearest,
            Some(_) => term * power / t * 2.0,
        };
        power *= t;
    }
    // Allowance for products that underflow and for the roundings of this function.
    let smallest = if is_single::<S>() {
        UNDERFLOW_SINGLE
    } else {
        UNDERFLOW
    };
    let lost = smallest / nearest.unwrap_or(1.0);
    UP * sum + lost
}

#[cfg(test)]
mod tests {
    use super::super::super::fit::Fitted;
    use super::super::tests::random;
    use super::rounding;

    /// The rounding errors of the emitted evaluation in single precision must stay within the bound, and come near it.
    #[test]
    fn roundings_are_within_their_bound() {
        let (mut state, mut nearest) = (3, 0.0_f64);
        for round in 0..8000 {
            let terms = [4, 6, 8, 10][round % 4];
            let mut number = || random(&mut state);
            let origin = (0.2 + 2.0 * number()) as f32;
            let (from, to) = (origin * (0.3 + 0.7 * number() as f32), origin * 1.3);
            let coefficients = (0..terms).map(|_| (number() - 0.3) as f32);
            let coefficients: Vec<f32> = coefficients.collect();
            let r = (from + (to - from) * number() as f32).clamp(from, to);
            let wide: Vec<f64> = coefficients.iter().map(|c| f64::from(*c)).collect();
            let ends = (f64::from(from), f64::from(to));
            let bound = rounding::<f32>(&wide, f64::from(origin), ends, None);
            let t = f64::from(r) - f64::from(origin);
            let exact = wide.iter().rev().fold(0.0, |sum, c| sum * t + c);
            let piece = Fitted {
                from,
                origin,
                coefficients: vec![coefficients],
            };
            let off = (f64::from(piece.value(0, r)) - exact).abs();
            assert!(off <= bound, "{off:e} for {bound:e}: {piece:?} at {r}");
            nearest = nearest.max(off / bound);
        }
        assert!(nearest > 0.2, "{nearest}");
    }
}

//! Bounds on the errors of the contact's amplitude and phase, for every β, over an interval of r. These errors depend
//! on all polynomials of a piece of the table, except the polynomial of β_lim.
//!
//! The amplitude is |V|(√(1 − ρ²α²) − ργ), with α = β_lim·U/|V|, γ = β_lim·G/|V| and ρ = β/β_lim. V is the response of
//! the contact to the load. U and G are its velocity and displacement at a reversal that the friction force causes. The
//! table has the polynomials a and g in place of α and γ. They were fitted together with the table's own β_lim, called
//! β_table. The code therefore compares a·β_lim/β_table with α, and g·β_lim/β_table with γ. It takes β_lim from the
//! witness, an instant near the largest velocity constraint. This β_lim exceeds the exact β_lim by at most the relative
//! margin `share`. The bounds include this margin.

use crate::compare::{CELLS, ComparedLimit, SHORT, SMALL, divided};
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, ORDER};
use crate::witness::{WitnessInstant, polynomial};
use frictiongen_kernel::{Float, Scalar};
use frictiongen_model::interval::Interval;
use frictiongen_model::table::FRICTION_SHARES;
use frictiongen_model::table::Fitted;
use frictiongen_model::table::Worst;
use frictiongen_model::table::building::{ANGLE, SIZE, rounding};
use std::f64::consts::PI;

/// Ends of the intervals of β over which the code bounds the errors of amplitude and phase, as fractions of the
/// largest β. The values are tuned. The intervals are shorter near the largest β, because the amplitude changes faster.
const SHARES: [f64; 11] = [
    0.0, 0.4, 0.65, 0.8, 0.88, 0.93, 0.96, 0.98, 0.99, 0.997, 1.0,
];
/// Allowance, in rounding units, for a few operations of the emitted amplitude: a and g times β/β_lim, the root, and
/// the product with |V|. It also covers an arc tangent in double precision.
const FEW: f64 = 4.0;
/// Allowance, in rounding units, for the operations of the emitted phase, including its arc tangent.
const OF_PHASE: f64 = 64.0;
/// Upper bound on the factor by which a quotient changes if its divisor has a relative error of up to [`SMALL`].
const WITH_PRODUCTS: f64 = 1.0 / (1.0 - SMALL);
/// Upper bound on an angle divided by its sine, for angles up to [`SMALL`] rad. The exact largest quotient is below
/// 1.0017.
const OVER_SINE: f64 = 1.01;
/// Factor on an upper bound. It covers the rounding of the bounds themselves, with room for millions of rounding
/// units.
const UP: f64 = 1.0 + 1e-9;

/// Data with which the errors of amplitude and phase are bounded over an interval of r.
pub(crate) struct MotionProof<'a, S> {
    pub piece: &'a Fitted<S>,
    /// Largest relative error of |V|, if |V| is a product over zeros and poles.
    pub excitation: f64,
    /// Largest allowed error of the amplitude (relative) and of the phase (rad).
    pub accuracy: f64,
    /// The two ends of the interval of r.
    pub ends: (f64, f64),
    /// Frequency ratio r about which the series are expanded.
    pub centre: f64,
    /// True if the centre of the series is a zero of β_lim.
    pub beside_zero: bool,
    /// Relative margin of β_lim. The exact β_lim is between b/(1 + `share`) and b, where b is the β_lim from the
    /// witness, an instant near the largest velocity constraint.
    pub share: f64,
}

/// Errors and exact values of a table's functions over a cell of r, for the errors of amplitude and phase.
struct MotionCell {
    /// Errors of the polynomials a and g.
    off: [Interval; 2],
    /// Exact values α = β_lim·U/|V| and γ = β_lim·G/|V|. V is the response of the contact to the load. Friction causes
    /// the velocity U and the displacement G of the contact at a reversal.
    exact: [Interval; 2],
    /// Relative error of the table's |V|. V is the response of the contact to the load.
    size: Interval,
    /// Error of the table's angle arg V, in rad. V is the response of the contact to the load.
    turned: Interval,
    /// Smallest quotient, over the cell, of the table's β_lim and the β_lim from the `Witness`.
    least: f64,
}

/// Errors and exact values of a table's functions, as series in r.
struct Functions {
    /// Error of the table's polynomial a, and its exact value α = β_lim·U/|V|. The error is a·b/β_table − α, where b
    /// is the β_lim from the `Witness` and β_table that of the table. V is the response of the contact to the load,
    /// and U its velocity at a reversal that friction causes.
    quadrature: [IntervalSeries<SHORT>; 2],
    /// Error of the table's polynomial g, and its exact value γ = β_lim·G/|V|. The error is g·b/β_table − γ, where b
    /// is the β_lim from the `Witness` and β_table that of the table. V is the response of the contact to the load,
    /// and G its displacement at a reversal that friction causes.
    displacement: [IntervalSeries<SHORT>; 2],
    /// Error of the angle arg V, in rad: the table's polynomial minus the exact value. V is the response of the contact
    /// to the load.
    angle: IntervalSeries<SHORT>,
}

impl<S: Float> MotionProof<'_, S> {
    /// Returns the largest error of amplitude and phase over the interval of r. Returns `None` if the error may exceed
    /// the accuracy.
    pub fn compared(
        &self,
        limit: &ComparedLimit,
        [at, over]: [&ChainStage<ORDER>; 2],
        [seen_at, seen_over]: [&WitnessInstant<ORDER>; 2],
    ) -> Option<Worst> {
        let away = limit.away;
        let (from, to) = self.ends;
        let r = Interval::new(from.min(self.centre), to.max(self.centre));
        let [square_at, square_over] = &limit.square;
        let sign = self.sign(at, over, away)?;
        let (angle, uncertain) = self.angle(at, over, away)?;
        let size = self.size([at, over], r, away)?;
        let point = Interval::point(self.centre);
        let at = self.functions(at, seen_at, square_at, point, sign, &angle[0]);
        let over = self.functions(over, seen_over, square_over, r, sign, &angle[1]);
        let joined = |pick: fn(&Functions) -> IntervalSeries<SHORT>| {
            IntervalSeries::joined(&pick(&at), &pick(&over))
        };
        let quadrature = [joined(|of| of.quadrature[0]), joined(|of| of.quadrature[1])];
        let displacement = [
            joined(|of| of.displacement[0]),
            joined(|of| of.displacement[1]),
        ];
        let angle = joined(|of| of.angle);
        let ratio = IntervalSeries::joined(square_at, square_over);
        let mut worst = Worst {
            error: 0.0,
            at: from,
        };
        for cell in away.parts(CELLS) {
            let error = self.error(
                &MotionCell {
                    off: [quadrature[0].range(cell), displacement[0].range(cell)],
                    exact: [quadrature[1].range(cell), displacement[1].range(cell)],
                    size: size.0.range(cell) + Interval::within(size.1),
                    turned: self.turned(angle.range(cell), uncertain),
                    least: ratio.range(cell).sqrt().low,
                },
                limit.rounding,
            )?;
            if error > worst.error {
                worst = Worst {
                    error,
                    at: self.centre + cell.middle(),
                };
            }
        }
        Some(worst)
    }

    /// Returns the largest error of amplitude and phase over a cell of r. Returns `None` if the error may exceed the
    /// accuracy. `of_limit` is the largest relative rounding error of the table's β_lim.
    fn error(&self, cell: &MotionCell, of_limit: f64) -> Option<f64> {
        let MotionCell {
            off,
            exact,
            size,
            turned,
            least,
        } = *cell;
        let unit = 0.5 * S::EPSILON;
        // The exact β_lim is between b/(1 + `share`) and b, where b is the β_lim from the `Witness`.
        let fewer = Interval::new(1.0 / (1.0 + self.share) * (2.0 - UP), 1.0);
        let [alpha, gamma] = exact.map(|exact| exact * fewer);
        // Adds the rounding errors of a polynomial (a or g) divided by β_table, those of β_table itself, and those of
        // the product with β. β_table is the β_lim of the table.
        let with_roundings = |function: usize, off: Interval, exact: Interval| {
            let most = exact.size() + off.size();
            let own =
                self.rounding(function) / least + most * (WITH_PRODUCTS * of_limit + FEW * unit);
            off * fewer + Interval::within(own * UP)
        };
        let of_alpha = with_roundings(1, off[0], alpha);
        let of_gamma = with_roundings(2, off[1], gamma);
        let tabled = alpha + of_alpha;
        let highest = FRICTION_SHARES.iter().copied().fold(0.0, f64::max);
        let mut worst = 0.0_f64;
        for pair in SHARES.windows(2) {
            let [low, high] = pair else { continue };
            let share = Interval::new(low * highest, high * highest);
            let root = |of: Interval| (Interval::ONE - (share * of).squared()).sqrt();
            let (own, other) = (root(alpha), root(tabled));
            let amplitude = own - share * gamma;
            if !(0.0 < own.low && 0.0 < other.low && 0.0 < amplitude.low) {
                return None;
            }
            // The difference of two roots is the difference of their squares, divided by the sum of the roots.
            let of_root = share * of_alpha * share * (alpha + tabled) / (own + other);
            let off = -(of_root + share * of_gamma) / amplitude;
            let rounded = FEW * unit * own.high / amplitude.low;
            let off = off + Interval::within(rounded * UP);
            // The amplitude is |V| times a factor. The errors of |V| and of the factor keep their signs, because they
            // may compensate each other.
            let of_size = size + Interval::within(self.excitation);
            let off = (off + of_size + off * of_size).size() + FEW * unit;
            // The phase lag of the contact is −asin ρα − arg V, with ρ = β/β_lim and α = β_lim·U/|V|. V is the response
            // of the contact to the load, and U its velocity at a reversal that friction causes.
            let lag = share * of_alpha / own.hull(other) + turned;
            worst = worst.max(off * UP).max((lag.size() + OF_PHASE * unit) * UP);
        }
        (worst <= self.accuracy).then_some(worst)
    }

    fn is_damped(&self) -> bool {
        self.piece.coefficients.len() > ANGLE
    }

    /// Returns the largest rounding error in the evaluation of one of the piece's polynomials.
    fn rounding(&self, function: usize) -> f64 {
        if self.piece.coefficients.len() <= function {
            return 0.0;
        }
        let origin = self.piece.origin.to_f64();
        rounding::<S>(&self.coefficients(function), origin, self.ends, None)
    }

    fn coefficients(&self, function: usize) -> Vec<f64> {
        let of = self.piece.coefficients.get(function).into_iter().flatten();
        of.map(|coefficient| coefficient.to_f64()).collect()
    }

    /// Returns one of the piece's polynomials as a series in r.
    fn table(&self, function: usize, r: Interval) -> IntervalSeries<SHORT> {
        let origin = IntervalSeries::fixed(Interval::point(self.piece.origin.to_f64()));
        polynomial(
            &self.coefficients(function),
            IntervalSeries::variable(r) - origin,
        )
    }

    fn functions(
        &self,
        stage: &ChainStage<ORDER>,
        seen: &WitnessInstant<ORDER>,
        square: &IntervalSeries<SHORT>,
        r: Interval,
        sign: Interval,
        angle: &IntervalSeries<SHORT>,
    ) -> Functions {
        let (ratio, size) = (square.sqrt(), seen.size.truncated::<SHORT>().sqrt());
        let nothing = IntervalSeries::fixed(Interval::ZERO);
        let quadrature = (stage.quadrature.truncated() / size).times(sign);
        let own = [self.table(1, r) / ratio - quadrature, quadrature];
        if !self.is_damped() {
            return Functions {
                quadrature: own,
                displacement: [nothing; 2],
                angle: nothing,
            };
        }
        let displacement = stage.displacement.truncated() / size;
        Functions {
            quadrature: own,
            displacement: [self.table(2, r) / ratio - displacement, displacement],
            angle: self.table(ANGLE, r) - *angle,
        }
    }

    /// Returns the relative error of the table's |V|, if the table contains |V| as a polynomial. The first result is
    /// the error as a series in r. The second is the relative rounding error of the polynomial's evaluation.
    fn size(
        &self,
        stages: [&ChainStage<ORDER>; 2],
        r: Interval,
        away: Interval,
    ) -> Option<(IntervalSeries<SHORT>, f64)> {
        let one = IntervalSeries::fixed(Interval::ONE);
        if self.piece.coefficients.len() <= SIZE {
            return Some((IntervalSeries::fixed(Interval::ZERO), 0.0));
        }
        let coefficients = self.coefficients(SIZE);
        let origin = self.piece.origin.to_f64();
        let [at, over] = stages;
        // Near a zero of V, the response of the contact to the load, the code divides |V| and its polynomial by the
        // distance from the zero.
        let part = |series: &IntervalSeries<ORDER>, at: &IntervalSeries<ORDER>| {
            if self.beside_zero {
                divided(series) + IntervalSeries::fixed(at.value() / away)
            } else {
                series.truncated()
            }
        };
        let table = |r: Interval| {
            let t = IntervalSeries::<ORDER>::variable(r)
                - IntervalSeries::fixed(Interval::point(origin));
            polynomial(&coefficients, t)
        };
        let own = table(Interval::point(self.centre));
        let sign = if self.beside_zero { away.sign() } else { 1 };
        let side = Interval::point(f64::from(sign));
        // The code multiplies the table's |V| by r², because `ChainStage` contains r²V, not V.
        let ratio = |r: Interval, stage: &ChainStage<ORDER>| {
            let [re, im] = [0, 1].map(|place| {
                let of = |stage: &ChainStage<ORDER>| stage.excitation.get(place).copied();
                let zero = IntervalSeries::fixed(Interval::ZERO);
                part(&of(stage).unwrap_or(zero), &of(at).unwrap_or(zero))
            });
            let exact = (re.squared() + im.squared()).sqrt();
            let table = part(&table(r), &own).times(side);
            (table * IntervalSeries::variable(r).squared() / exact, table)
        };
        let (first, table_at) = ratio(Interval::point(self.centre), at);
        let (all, table_over) = ratio(r, over);
        let least = IntervalSeries::joined(&table_at, &table_over)
            .range(away)
            .low;
        if !(0.0 < least) {
            return None;
        }
        let nearest = self.beside_zero.then_some(away);
        let rounded = rounding::<S>(&coefficients, origin, self.ends, nearest) / least;
        let off = IntervalSeries::joined(&(first - one), &(all - one));
        // The rounding errors are relative to the |V| of the table. The factor makes them relative to the exact |V|.
        let most = 1.0 + off.range(away).size();
        (rounded < SMALL).then_some((off, rounded * most * UP))
    }

    /// Returns the sign of κV in an undamped chain. V is the response of the contact to the load, and κ the common
    /// factor of `ChainStage`. The polynomial a of the table contains this sign.
    fn sign(
        &self,
        at: &ChainStage<ORDER>,
        over: &ChainStage<ORDER>,
        away: Interval,
    ) -> Option<Interval> {
        if self.is_damped() {
            return Some(Interval::ONE);
        }
        let ([own, _], [all, _]) = (at.excitation, over.excitation);
        let sign = if self.beside_zero {
            let slope = IntervalSeries::joined(&divided(&own), &divided(&all)).range(away);
            let first = own.value() / away;
            (slope + first).sign() * away.sign()
        } else {
            IntervalSeries::joined(&own, &all).range(away).sign()
        };
        (sign != 0).then(|| Interval::point(f64::from(sign)))
    }

    /// Returns the angle arg V as series at the centre and over the interval of r, up to whole turns. V is the response
    /// of the contact to the load. The last result is the error of arg V, in rad, that the uncertain position of a zero
    /// causes.
    fn angle(
        &self,
        at: &ChainStage<ORDER>,
        over: &ChainStage<ORDER>,
        away: Interval,
    ) -> Option<([IntervalSeries<SHORT>; 2], f64)> {
        if !self.is_damped() {
            return Some(([IntervalSeries::fixed(Interval::ZERO); 2], 0.0));
        }
        let side = Interval::point(f64::from(away.sign()));
        let parts = |stage: &ChainStage<ORDER>| {
            stage.excitation.map(|part| {
                if self.beside_zero {
                    divided(&part).times(side)
                } else {
                    part.truncated::<SHORT>()
                }
            })
        };
        let (own, all) = (parts(at), parts(over));
        let size = |parts: &[IntervalSeries<SHORT>; 2]| {
            let [re, im] = parts.map(|part| part.value().squared());
            (re + im).sqrt()
        };
        let mut uncertain = 0.0;
        if self.beside_zero {
            let [re, im] = at.excitation.map(|part| part.value().size());
            let nearest = away.low.abs().min(away.high.abs());
            uncertain = WITH_PRODUCTS * (re + im) / nearest / size(&all).low;
            if !(uncertain < SMALL) {
                return None;
            }
        }
        let [re, im] = own.map(|part| part.value());
        let about = Scalar::atan2(im.middle(), re.middle());
        let width = (re.high - re.low) + (im.high - im.low);
        let off = OVER_SINE * width / size(&own).low + FEW * f64::EPSILON;
        if !(off < SMALL) {
            return None;
        }
        let value = Interval::new(about - off, about + off);
        Some(([turning(own, value), turning(all, value)], uncertain))
    }

    /// Returns the error `angle` without whole turns, widened by rounding and by the uncertain position of a zero.
    fn turned(&self, angle: Interval, uncertain: f64) -> Interval {
        if !self.is_damped() {
            return Interval::ZERO;
        }
        let turns = (angle.middle() / (2.0 * PI)).round();
        let whole = Interval::pi() * Interval::point(2.0 * turns);
        angle - whole + Interval::within(self.rounding(ANGLE) + uncertain)
    }
}

/// Returns the series of the angle of the complex function re + i·im. `value` is the first term of the angle. The
/// slope of the angle is (re·im′ − im·re′)/(re² + im²).
fn turning([re, im]: [IntervalSeries<SHORT>; 2], value: Interval) -> IntervalSeries<SHORT> {
    let slope = |series: &IntervalSeries<SHORT>| {
        let mut slope = IntervalSeries::fixed(Interval::ZERO);
        let higher = series.terms.iter().enumerate().skip(1);
        for (own, (power, term)) in slope.terms.iter_mut().zip(higher) {
            *own = *term * Interval::point(power as f64);
        }
        slope
    };
    let rate = (re * slope(&im) - im * slope(&re)) / (re.squared() + im.squared());
    let mut angle = IntervalSeries::fixed(value);
    for (power, (own, term)) in angle.terms.iter_mut().skip(1).zip(&rate.terms).enumerate() {
        *own = *term / Interval::point((power + 1) as f64);
    }
    angle
}

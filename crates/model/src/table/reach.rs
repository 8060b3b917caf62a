//! Regimes that, according to the tables, cannot occur at the permitted friction ratios.

use super::bounds::unit;
use super::product::Product;
use super::rounding::rounding;
use super::tables::Tables;
use crate::interval::{Arithmetic, Interval, Jet};
use crate::scene::{Beyond, Scene};
use frictiongen_kernel::Float;
use frictiongen_kernel::table::Factor;

/// Largest number of times that an interval of r is halved in the proof that a limit exceeds a friction ratio. If
/// more are needed, the proof fails.
const HALVINGS: u32 = 12;
/// Number of equal intervals of r at the start of the proof that a limit exceeds a friction ratio.
const PARTS: usize = 64;

/// Regimes that cannot occur at any r in the range of a table, and at any friction ratio up to a given largest one.
///
/// A flag is true only if a proof covers every number of the scalar type in the range of r, in the emitted
/// arithmetic. If a flag is false, the regime may occur.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reach {
    /// True if β_lim exceeds every friction ratio up to the given largest one. The closed form of the continuous motion
    /// is then always valid.
    pub always_continuous: bool,
    /// True if β*_lim exceeds every friction ratio up to the given largest one. A stuck state then never exists.
    pub never_stuck: bool,
}

impl<S: Float> Tables<S> {
    /// Returns the regimes that cannot occur at any declared friction ratio. If the scene uses the exact formulas
    /// outside the declared range, both flags are false.
    #[must_use]
    pub fn declared_reach(&self, scene: &Scene) -> Reach {
        let declared = &scene.declared;
        match (declared.beyond, declared.range) {
            (Beyond::Error, Some(range)) => self.reach(scene.stiction, range.beta.1),
            _ => Reach::default(),
        }
    }

    /// Returns the regimes that cannot occur at any friction ratio from 0 to `most`, including `most`. `stiction` is
    /// μ.
    #[must_use]
    pub fn reach(&self, stiction: f64, most: f64) -> Reach {
        let most = S::constant(most).to_f64();
        if !most.is_finite() {
            return Reach::default();
        }
        let always_continuous = self.limit_is_above(most);
        let sliding = self.sliding.as_ref();
        // For μ ≤ 1 no stuck state exists at a β below β_lim. The kernel uses this fact too.
        let decides = always_continuous && stiction <= 1.0;
        Reach {
            always_continuous,
            never_stuck: decides || sliding.is_some_and(|product| self.is_above(product, most)),
        }
    }

    /// Returns the bounds of the range of r, rounded to the scalar type as in a lookup.
    fn ends(&self) -> (f64, f64) {
        let (low, high) = self.request.r;
        (S::constant(low).to_f64(), S::constant(high).to_f64())
    }

    /// Returns true if a proof shows that the emitted β_lim exceeds `most` in the whole range of r.
    fn limit_is_above(&self, most: f64) -> bool {
        let (low, high) = self.ends();
        let mut above = !self.pieces.is_empty();
        for (place, piece) in self.pieces.iter().enumerate() {
            let next = self.pieces.get(place + 1);
            let to = next.map_or(high, |next| next.from.to_f64());
            let from = piece.from.to_f64().max(low);
            let own = piece.coefficients.first();
            let coefficients = own.into_iter().flatten().map(|of| of.to_f64());
            let coefficients: Vec<f64> = coefficients.collect();
            let origin = piece.origin.to_f64();
            let off = rounding::<S>(&coefficients, origin, (from, to), None);
            let least = |r: Interval| {
                let middle = Interval::point(r.middle());
                let at = polynomial(&coefficients, middle - Interval::point(origin));
                let t = Jet::variable(r - Interval::point(origin));
                let slope = polynomial(&coefficients, t).slope;
                (at + slope * (r - middle)).low - off
            };
            above = above && exceeds(Interval::new(from, to), HALVINGS, &least, most);
        }
        above
    }

    /// Returns true if a proof shows that an emitted product over zeros and poles exceeds `most` in the whole range
    /// of r.
    fn is_above(&self, product: &Product<S>, most: f64) -> bool {
        let (low, high) = self.ends();
        let least = |r: Interval| size::<S>(product, r).low;
        let mut parts = Interval::new(low, high).parts(PARTS);
        parts.all(|part| exceeds(part, HALVINGS, &least, most))
    }
}

/// Returns the polynomial Σ c_k tᵏ at t.
fn polynomial<T: Arithmetic>(coefficients: &[f64], t: T) -> T {
    let zero = T::number(0.0);
    coefficients
        .iter()
        .rev()
        .fold(zero, |sum, coefficient| sum * t + T::number(*coefficient))
}

/// Returns true if a function of r is proven to exceed the number `most` in the interval `r`. `least` returns a lower
/// bound on the function in an interval.
fn exceeds(r: Interval, halvings: u32, least: &impl Fn(Interval) -> f64, most: f64) -> bool {
    if most < least(r) {
        return true;
    }
    let middle = r.middle();
    // If the lower bound is too small even at a single r, further halving is useless.
    if halvings == 0 || !(most < least(Interval::point(middle))) {
        return false;
    }
    let halves = [Interval::new(r.low, middle), Interval::new(middle, r.high)];
    let mut halves = halves.into_iter();
    halves.all(|half| exceeds(half, halvings - 1, least, most))
}

/// Widens an interval that contains the exact result of an operation by the rounding error of the scalar type `S`.
fn rounded<S: Float>(exact: Interval) -> Interval {
    let (unit, smallest) = unit::<S>();
    exact * (Interval::ONE + Interval::within(2.0 * unit)) + Interval::within(smallest)
}

/// Returns an interval that contains the modulus of an emitted product for every r of an interval, including all
/// rounding errors.
fn size<S: Float>(product: &Product<S>, r: Interval) -> Interval {
    let of = |factors: &[Factor<S>]| {
        factors.iter().fold(Interval::ONE, |all, factor| {
            rounded::<S>(all * value(factor, r))
        })
    };
    let quotient = rounded::<S>(of(&product.numerator) / of(&product.denominator));
    let root = if product.squared {
        rounded::<S>(quotient.sqrt())
    } else {
        quotient
    };
    let value = rounded::<S>(Interval::point(product.gain.to_f64()) * root);
    // The emitted result is the absolute value.
    if value.high < 0.0 { -value } else { value }
}

/// Returns an interval that contains the value of an emitted factor for every r of an interval, including all
/// rounding errors.
fn value<S: Float>(factor: &Factor<S>, r: Interval) -> Interval {
    let point = |value: S| Interval::point(value.to_f64());
    let beside = |at: S, rest: S| {
        let away = rounded::<S>(rounded::<S>(r - point(at)) - point(rest));
        rounded::<S>(away * rounded::<S>(r + point(at)))
    };
    match *factor {
        Factor::Zero { at, rest } => beside(at, rest),
        Factor::Pair {
            at,
            rest,
            off,
            least,
        } => {
            let beside = rounded::<S>(beside(at, rest) + point(off));
            rounded::<S>(rounded::<S>(beside.squared()) + point(least))
        }
        Factor::Real { off } => rounded::<S>(rounded::<S>(r.squared()) + point(off)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Reach, Request, Tables};
    use crate::samples::{random, request, scene};
    use crate::scene::Side;
    use frictiongen_kernel::Float;

    /// Returns the smallest emitted β_lim and the smallest emitted β*_lim at many random frequency ratios.
    fn least<S: Float>(tables: &Tables<S>) -> [f64; 2] {
        let (low, high) = tables.request.r;
        let mut state = 3;
        let mut least = [f64::INFINITY; 2];
        for place in 0..20_000 {
            let share = match place {
                0 => 0.0,
                1 => 1.0,
                _ => random(&mut state),
            };
            let r = S::constant(low + (high - low) * share);
            let place = tables.pieces.partition_point(|piece| piece.from <= r);
            let limit = tables.pieces[place.saturating_sub(1)].value(0, r).to_f64();
            let sliding = tables
                .sliding
                .as_ref()
                .unwrap()
                .quotient()
                .magnitude(r)
                .to_f64();
            least = [least[0].min(limit), least[1].min(sliding)];
        }
        least
    }

    fn told<S: Float>(kind: &str, count: usize, zeta: f64, stiction: f64) {
        let modal = scene(kind, count, zeta, stiction);
        let tables = Tables::<S>::build(&modal, request(1e-3, Side::Near)).unwrap();
        let [limit, sliding] = least(&tables);
        let name = format!("{kind}{count}, {zeta}, {stiction}: {limit} and {sliding}");
        let reach = |most| tables.reach(stiction, most);
        // Close to the limit, the bound on the rounding errors may leave undecided whether the friction ratio is below
        // the limit.
        for (share, is_below) in [(0.5, true), (0.99, true), (1.001, false), (2.0, false)] {
            assert_eq!(reach(share * limit).always_continuous, is_below, "{name}");
            assert_eq!(reach(share * sliding).never_stuck, is_below, "{name}");
        }
        assert_eq!(reach(f64::INFINITY), Reach::default());
        // The search finds the largest friction ratio that is reported as continuous. This friction ratio must be below
        // every β_lim that the emitted code computes, rounding errors included.
        let (mut said, mut unsaid) = (0.99 * limit, 1.001 * limit);
        for _ in 0..40 {
            let middle = 0.5 * (said + unsaid);
            if reach(middle).always_continuous {
                said = middle;
            } else {
                unsaid = middle;
            }
        }
        assert!(S::constant(said).to_f64() < limit, "{name}: {said}");
    }

    #[test]
    fn up_to_the_least_limit() {
        for (kind, count, zeta, stiction) in [
            ("Wall", 1, 0.02, 1.0),
            ("Wall", 2, 0.05, 1.2),
            ("Base", 2, 0.02, 1.0),
            ("Pair", 3, 0.1, 1.3),
            ("Base", 2, 1.7, 1.0),
        ] {
            told::<f64>(kind, count, zeta, stiction);
            told::<f32>(kind, count, zeta, stiction);
        }
    }

    /// Checks that the proof examines every piece up to its end. In this test β_lim is smallest at the end of the last
    /// piece, which is the end of the range.
    #[test]
    fn up_to_the_end_of_the_range() {
        let modal = scene("Wall", 1, 0.02, 1.0);
        let request = Request {
            r: (1.2, 2.5),
            ..request(1e-3, Side::Near)
        };
        let tables = Tables::<f64>::build(&modal, request).unwrap();
        let last = tables.pieces.last().unwrap();
        let (begins, ends) = (last.value(0, last.from), last.value(0, 2.5));
        assert!(ends < 0.6 && 0.6 < begins, "{begins} to {ends}");
        assert!(tables.reach(1.0, 0.999 * ends).always_continuous);
        assert!(!tables.reach(1.0, 0.6).always_continuous);
    }

    /// Checks the flags for a mass on a wall with μ = 2, at r from 0.9 to 1.1. β*_lim is 1/2 there, and β_lim is
    /// larger. For β between the two limits, a stuck state exists in addition to the continuous motion.
    #[test]
    fn a_stuck_state_beside_the_closed_form() {
        let modal = scene("Wall", 1, 0.05, 2.0);
        let request = Request {
            r: (0.9, 1.1),
            ..request(1e-3, Side::Near)
        };
        let tables = Tables::<f64>::build(&modal, request).unwrap();
        for (most, never_stuck) in [(0.49, true), (0.52, false)] {
            let reach = tables.reach(2.0, most);
            assert!(reach.always_continuous, "{most}");
            assert_eq!(reach.never_stuck, never_stuck, "{most}");
        }
    }

    /// Checks that the proof excludes no regime if β_lim has a zero within the range.
    #[test]
    fn beside_a_zero() {
        let modal = scene("Wall", 1, 0.0, 1.0);
        let tables = Tables::<f64>::build(&modal, request(1e-3, Side::Near)).unwrap();
        assert!(!tables.reach(1.0, 1e-6).always_continuous);
    }
}

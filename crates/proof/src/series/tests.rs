//! Compares interval series with double-double numbers.

use super::IntervalSeries;
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::interval::Interval;
use frictiongen_model::samples::{RandomNumbers, contains};

/// Evaluates a formula that uses every operation, as a series. `formula_at` evaluates it in double-double.
fn formula(h: IntervalSeries<6>) -> IntervalSeries<6> {
    let one = IntervalSeries::fixed(Interval::ONE);
    let (sine, cosine) = h.sine_cosine();
    let root = (h.squared() + one).sqrt();
    (sine * h - cosine.squared()) / root + (-(h * h)).exp() - h.times(Interval::point(3.0)).sinc()
}

fn formula_at(h: Dd) -> Dd {
    let one = Dd::ONE;
    let (sine, cosine) = h.sin_cos_pi();
    let angle = Dd::PI * Dd::from(3.0) * h;
    let (turned, _) = (Dd::from(3.0) * h).sin_cos_pi();
    (sine * h - cosine * cosine) / Scalar::sqrt(h * h + one) + Scalar::exp(-(h * h))
        - turned / angle
}

/// Checks that a joined series contains the function everywhere in its interval, as Taylor's formula predicts.
#[test]
fn series_hold_what_they_should() {
    let mut numbers = RandomNumbers(7);
    let mut widest = 0.0_f64;
    for _ in 0..3_000 {
        let centre = 0.2 * numbers.unit() + 0.05;
        let half = 0.03 * numbers.unit();
        let all = Interval::new(centre - half, centre + half);
        let at = formula(IntervalSeries::variable(Interval::point(centre)));
        let over = formula(IntervalSeries::variable(all));
        let joined = IntervalSeries::joined(&at, &over);
        let range = joined.range(all - Interval::point(centre));
        for _ in 0..8 {
            let x = numbers.within(all);
            let value = formula_at(Dd::from(x));
            let t = Interval::point(x) - Interval::point(centre);
            assert!(contains(joined.range(t), value), "at {x} about {centre}");
            assert!(contains(range, value), "{range:?} at {x}");
            assert!(contains(over.value(), value));
            widest = widest.max(joined.range(t).high - joined.range(t).low);
        }
    }
    // An interval of all numbers would also pass the test, so the width is checked too.
    assert!(widest < 1e-2, "{widest:e}");
}

/// Checks the coefficients of a series over an interval. Each coefficient, which is an interval, must contain the
/// divided differences of its order between points of the interval.
#[test]
fn coefficients() {
    let mut numbers = RandomNumbers(9);
    for _ in 0..500 {
        let low = 0.2 * numbers.unit() + 0.05;
        let step = 0.01;
        let all = Interval::new(low, low + 5.0 * step);
        let over = formula(IntervalSeries::variable(all));
        let mut differences: Vec<Dd> = (0..6)
            .map(|k| formula_at(Dd::from(low + step * f64::from(k))))
            .collect();
        for order in 0..6 {
            // The divided difference f[x_0, …, x_k] is f⁽ᵏ⁾/k! at some point between x_0 and x_k.
            let interval = over.term(order);
            let slack = 1e-12 * 100_f64.powi(order as i32);
            for difference in &differences {
                let value = difference.to_f64();
                assert!(
                    interval.low - slack <= value && value <= interval.high + slack,
                    "{order}"
                );
            }
            differences = differences
                .windows(2)
                .map(|pair| (pair[1] - pair[0]) / Dd::from(step * (order + 1) as f64))
                .collect();
        }
    }
}

/// Checks products of series whose coefficients are 0, narrow, wide or unbounded. The products must contain those of
/// numbers in the coefficients.
#[test]
fn products() {
    let mut numbers = RandomNumbers(11);
    let mut bounded = 0;
    for round in 0..20_000 {
        let series = |numbers: &mut RandomNumbers| {
            let length = (7.0 * numbers.unit()) as usize;
            let terms = std::array::from_fn(|place| {
                if length <= place {
                    Interval::ZERO
                } else if round % 8 == 0 && numbers.unit() < 0.2 {
                    Interval::new(numbers.end(), f64::INFINITY)
                } else if round % 16 == 1 {
                    // Products of these terms underflow.
                    let tiny = numbers.interval();
                    Interval::new(tiny.low * 1e-162, tiny.high * 1e-162)
                } else {
                    numbers.interval()
                }
            });
            IntervalSeries::<6> { terms }
        };
        let (a, b) = (series(&mut numbers), series(&mut numbers));
        let (product, square) = (a * b, a.squared());
        let within = |numbers: &mut RandomNumbers, series: &IntervalSeries<6>| {
            series.terms.map(|term| {
                let end = term.high.min(1e6_f64.max(term.low));
                numbers.within(Interval::new(term.low, end))
            })
        };
        let (x, y) = (within(&mut numbers, &a), within(&mut numbers, &b));
        for k in 0..6 {
            let sum = |x: &[f64; 6], y: &[f64; 6]| {
                let terms = (0..=k).map(|j| Dd::from(x[j]) * Dd::from(y[k - j]));
                terms.fold(Dd::ZERO, |sum, term| sum + term)
            };
            assert!(contains(product.term(k), sum(&x, &y)), "{a:?} {b:?} {k}");
            assert!(contains(square.term(k), sum(&x, &x)), "{a:?} squared, {k}");
            bounded += usize::from(product.term(k).size() < f64::INFINITY);
        }
    }
    assert!(100_000 < bounded, "{bounded}");
}

/// Checks that a coefficient that is exactly 0 stays exactly 0 in a product, because sums leave out such
/// coefficients.
#[test]
fn products_with_nothing() {
    let nothing = IntervalSeries::<6>::fixed(Interval::ZERO);
    let all = IntervalSeries::<6> {
        terms: [Interval::ALL; 6],
    };
    let product = nothing * all;
    assert!(product.terms.iter().all(Interval::is_nothing));
    let line = IntervalSeries::<6>::variable(Interval::new(1.0, 2.0));
    let square = line * line;
    assert!(square.terms.iter().skip(3).all(Interval::is_nothing));
    assert!(!square.term(2).is_nothing());
}

/// Checks the coefficients that `refined` has made narrower. They must contain the exact coefficients at any point,
/// and be within the original coefficients.
#[test]
fn refined() {
    let mut numbers = RandomNumbers(13);
    let mut narrower = 0.0_f64;
    for _ in 0..3_000 {
        let (low, length) = (0.2 * numbers.unit() + 0.05, 0.03 * numbers.unit());
        let all = Interval::new(low, low + length);
        let centre = numbers.within(all);
        let at = formula(IntervalSeries::variable(Interval::point(centre)));
        let over = formula(IntervalSeries::variable(all));
        let refined = over.refined(&at, all - Interval::point(centre));
        let there = formula(IntervalSeries::variable(Interval::point(
            numbers.within(all),
        )));
        for k in 0..6 {
            let (plain, own, there) = (over.term(k), refined.term(k), there.term(k));
            narrower = narrower.max((plain.high - plain.low) / (own.high - own.low));
            assert!(plain.low <= own.low && own.high <= plain.high);
            // Both results are uncertain by some roundings. They must overlap.
            assert!(
                own.low <= there.high && there.low <= own.high,
                "{k}: {own:?} {there:?}"
            );
        }
    }
    assert!(2.0 < narrower, "{narrower}");
}

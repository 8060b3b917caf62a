//! The scalar functions against an independent table, and against double-double.
//!
//! `data/scalar_reference.csv` was written by `tools/coefficients.py reference` with mpmath at
//! 1400 bits: arguments and results are sums of two `f64`, so a result has about 32 digits.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::special::{exp_m1_minus, versine_pi};
use frictiongen_kernel::number::trig::single;
use frictiongen_kernel::{Float, Scalar};
use fuzzing::Random;

const TABLE: &str = include_str!("data/scalar_reference.csv");

/// What the arithmetic of double-double, and what its functions may be off, relatively.
const DD_BUDGETS: [f64; 2] = [2.5e-32, 2e-31];

/// Every function of the table, with the units in the last place that `f64` may be off, and `f32`.
const FUNCTIONS: [(&str, f64, f64); 13] = [
    ("sin_cos_pi", 1.1, 1.1),
    ("sin_cos_pi_minus", 1.2, 1.2),
    ("exp", 1.0, 1.0),
    ("exp_m1", 1.0, 1.0),
    ("atan2", 1.5, 1.5),
    ("one_minus_sinc_pi", 1.5, 1.5),
    ("versine_pi", 2.5, 2.5),
    ("scaled_sinh_defect", 4.0, 4.0),
    ("exp_m1_minus", 3.5, 3.5),
    ("add", 0.5, 0.5),
    ("multiply", 0.5, 0.5),
    ("divide", 0.5, 0.5),
    ("sqrt", 0.5, 0.5),
];

fn evaluate<T: Float>(name: &str, x: T, y: T) -> [T; 2] {
    let none = T::constant(0.0);
    match name {
        "sin_cos_pi" => x.sin_cos_pi().into(),
        "sin_cos_pi_minus" => x.sin_cos_pi_minus(y).into(),
        "exp" => [x.exp(), none],
        "exp_m1" => [x.exp_m1(), none],
        "atan2" => [x.atan2(y), none],
        "one_minus_sinc_pi" => [x.one_minus_sinc_pi(), none],
        "versine_pi" => [versine_pi(x), none],
        "scaled_sinh_defect" => [x.scaled_sinh_defect(), none],
        "exp_m1_minus" => [exp_m1_minus(x), none],
        "add" => [x + y, none],
        "multiply" => [x * y, none],
        "divide" => [x / y, none],
        "sqrt" => [x.sqrt(), none],
        _ => panic!("no function {name}"),
    }
}

struct Row {
    name: &'static str,
    x: Dd,
    y: Dd,
    results: [Dd; 2],
}

fn rows() -> Vec<Row> {
    let lines = TABLE.lines().filter(|line| !line.starts_with('#'));
    let row = |line: &'static str| {
        let mut fields = line.split(',');
        let name = fields.next().unwrap();
        let n: Vec<f64> = fields.map(|field| field.parse().unwrap()).collect();
        assert_eq!(n.len(), 8);
        Row {
            name,
            x: Dd::new(n[0], n[1]),
            y: Dd::new(n[2], n[3]),
            results: [Dd::new(n[4], n[5]), Dd::new(n[6], n[7])],
        }
    };
    lines.map(row).collect()
}

/// got − want without the subtraction of [`Dd`], which is under test itself.
fn difference(got: Dd, want: Dd) -> f64 {
    (got.hi - want.hi) + (got.lo - want.lo)
}

/// One unit in the last place of the nearest number of `bits` bits, exponents from `least` on.
fn place(value: f64, bits: i32, least: i32) -> f64 {
    let exponent = ((value.abs().to_bits() >> 52) as i32 - 1023).max(least);
    2.0_f64.powi(exponent - bits + 1)
}

/// The error of an `f64` in units in the last place.
fn error(got: f64, want: Dd) -> f64 {
    if got == want.hi && want.lo == 0.0 {
        return 0.0;
    }
    difference(Dd::from(got), want).abs() / place(want.hi, 53, -1022)
}

fn error_f32(got: f32, want: Dd) -> f64 {
    if f64::from(got) == want.hi && want.lo == 0.0 {
        return 0.0;
    }
    difference(Dd::from(f64::from(got)), want).abs() / place(want.hi, 24, -126)
}

/// The largest error of some function, and where.
#[derive(Default)]
struct Worst {
    error: f64,
    at: String,
    points: usize,
}

impl Worst {
    fn see(&mut self, error: f64, at: impl FnOnce() -> String) {
        self.points += 1;
        // A NaN is the worst of all.
        if error.is_nan() || error > self.error {
            self.error = if error.is_nan() { f64::INFINITY } else { error };
            self.at = at();
        }
    }

    fn check(&self, what: &str, budget: f64, points: usize) {
        println!(
            "{what}: {:.4e} of {budget} at {} ({} points)",
            self.error, self.at, self.points
        );
        assert!(self.points >= points, "{what}: only {} points", self.points);
        assert!(
            self.error <= budget,
            "{what}: {} exceeds {budget} at {}",
            self.error,
            self.at
        );
    }
}

/// A generator of reproducible arguments.
struct Source(Random);

impl Source {
    /// Of random sign, with an exponent evenly spread over the range.
    fn spread(&mut self, low: f64, high: f64) -> f64 {
        let size = (low + (high - low) * self.0.unit()).exp2();
        if self.0.bits() & 1 == 0 { size } else { -size }
    }

    /// Arguments fit for the function, in half-turns or radians as it wants them.
    fn arguments(&mut self, name: &str, reach: f64) -> (f64, f64) {
        let near = (self.0.bits() % 41) as f64 / 4.0;
        match name {
            "sin_cos_pi" | "one_minus_sinc_pi" | "versine_pi" => match self.0.bits() % 4 {
                0 => (self.spread(-reach, reach), 0.0),
                1 => (near + self.spread(-50.0, -2.0), 0.0),
                _ => (4.0 * self.0.unit() - 2.0, 0.0),
            },
            "sin_cos_pi_minus" => match self.0.bits() % 4 {
                0 => (self.spread(-reach, reach), self.spread(-reach, reach)),
                1 => (near + 4.0 * self.0.unit(), near),
                2 => (near + self.0.unit(), self.spread(-40.0, 0.0)),
                _ => (4.0 * self.0.unit() - 2.0, 4.0 * self.0.unit() - 2.0),
            },
            "exp" | "exp_m1" | "exp_m1_minus" => match self.0.bits() % 2 {
                0 => (self.spread(-reach / 4.0, 6.3), 0.0),
                _ => (8.0 * self.0.unit() - 4.0, 0.0),
            },
            "scaled_sinh_defect" => match self.0.bits() % 2 {
                0 => (self.spread(-reach / 4.0, 10.0).abs(), 0.0),
                _ => (6.0 * self.0.unit(), 0.0),
            },
            "sqrt" => (self.spread(-reach, reach).abs(), 0.0),
            _ => match self.0.bits() % 2 {
                0 => (
                    self.spread(-reach / 3.0, reach / 3.0),
                    self.spread(-reach / 3.0, reach / 3.0),
                ),
                _ => (self.spread(-2.0, 2.0), self.spread(-2.0, 2.0)),
            },
        }
    }
}

#[test]
fn the_measures_see_an_error() {
    let (x, y) = (0.7_f64, 0.7_f32);
    assert_eq!(error(x.next_up(), Dd::from(x)), 1.0);
    assert_eq!(error_f32(y.next_down(), Dd::from(f64::from(y))), 1.0);
    let mut worst = Worst::default();
    worst.see(f64::NAN, String::new);
    assert_eq!(worst.error, f64::INFINITY);
}

#[test]
fn double_double_meets_the_table() {
    for (name, ..) in FUNCTIONS {
        let mut worst = Worst::default();
        for row in rows().iter().filter(|row| row.name == name) {
            let got = evaluate(name, row.x, row.y);
            for (got, want) in got.into_iter().zip(row.results) {
                let off = difference(got, want).abs();
                let relative = if off == 0.0 { 0.0 } else { off / want.hi.abs() };
                worst.see(relative, || format!("{:?}, {:?}", row.x, row.y));
            }
        }
        let arithmetic = ["add", "multiply", "divide", "sqrt"].contains(&name);
        worst.check(name, DD_BUDGETS[usize::from(!arithmetic)], 150);
    }
}

#[test]
fn f64_meets_the_table() {
    for (name, budget, _) in FUNCTIONS {
        let mut worst = Worst::default();
        for row in rows() {
            if row.name != name || row.x.lo != 0.0 || row.y.lo != 0.0 {
                continue;
            }
            let got = evaluate(name, row.x.hi, row.y.hi);
            for (got, want) in got.into_iter().zip(row.results) {
                worst.see(error(got, want), || {
                    format!("{:e}, {:e}", row.x.hi, row.y.hi)
                });
            }
        }
        worst.check(name, budget, 60);
    }
}

#[test]
fn f64_meets_double_double() {
    for (name, budget, _) in FUNCTIONS {
        let (mut worst, mut source) = (Worst::default(), Source(Random(1)));
        for _ in 0..100_000 {
            let (x, y) = source.arguments(name, 300.0);
            let got = evaluate(name, x, y);
            for (got, want) in got
                .into_iter()
                .zip(evaluate(name, Dd::from(x), Dd::from(y)))
            {
                worst.see(error(got, want), || format!("{x:e}, {y:e}"));
            }
        }
        // What was meant to be half a unit may pass it by what the reference lacks.
        worst.check(name, budget + 1e-12, 200_000);
    }
}

#[test]
fn f32_meets_double_double() {
    for (name, _, budget) in FUNCTIONS {
        let (mut worst, mut source) = (Worst::default(), Source(Random(2)));
        for _ in 0..50_000 {
            let (x, y) = source.arguments(name, 60.0);
            let (x, y) = (x as f32, y as f32);
            let got = evaluate(name, x, y);
            let want = evaluate(name, Dd::from(f64::from(x)), Dd::from(f64::from(y)));
            for (got, want) in got.into_iter().zip(want) {
                if want.hi.abs() < f64::from(f32::MAX) {
                    worst.see(error_f32(got, want), || format!("{x:e}, {y:e}"));
                }
            }
        }
        worst.check(name, budget + 1e-12, 70_000);
    }
}

/// A stride through all bit patterns, so through every exponent and both signs.
#[test]
fn f32_trigonometry_on_all_exponents() {
    let (mut pair, mut sinc) = (Worst::default(), Worst::default());
    for bits in (0..=u32::MAX).step_by(20_011) {
        let h = f32::from_bits(bits);
        let (sin, cos) = single::sin_cos_pi(h);
        if !h.is_finite() {
            assert!(sin.is_nan() && cos.is_nan() && single::sin_pi(h).is_nan());
            continue;
        }
        let exact = Dd::from(f64::from(h));
        let (s, c) = exact.sin_cos_pi();
        pair.see(error_f32(sin, s), || format!("{h:e}"));
        pair.see(error_f32(cos, c), || format!("{h:e}"));
        let want = exact.one_minus_sinc_pi();
        let off = error_f32(h.one_minus_sinc_pi(), want);
        // Among the subnormals every term of the sum is rounded to the same place.
        let terms = if want.hi < 4.0 * f64::from(f32::MIN_POSITIVE) {
            3.0
        } else {
            1.0
        };
        sinc.see(off / terms, || format!("{h:e}"));
    }
    pair.check("sin_cos_pi", 1.1, 200_000);
    sinc.check("one_minus_sinc_pi", 1.5, 200_000);
}

fn exact_points<T: Float>() {
    let number = T::constant;
    for (h, sin, cos) in [
        (0.0, 0.0, 1.0),
        (0.5, 1.0, 0.0),
        (1.0, 0.0, -1.0),
        (-0.5, -1.0, 0.0),
        (1001.5, -1.0, 0.0),
        (-7.0, 0.0, -1.0),
        (16_777_215.0, 0.0, -1.0),
        (1e30, 0.0, 1.0),
    ] {
        assert_eq!(number(h).sin_cos_pi(), (number(sin), number(cos)), "{h}");
        assert_eq!(
            number(h).sin_cos_pi_minus(number(-2.0)),
            (number(sin), number(cos)),
            "{h}"
        );
        assert_eq!(
            number(0.0).sin_cos_pi_minus(number(-h)),
            (number(sin), number(cos)),
            "{h}"
        );
    }
    assert_eq!(number(0.0).one_minus_sinc_pi(), number(0.0));
    assert_eq!(number(0.0).scaled_sinh_defect(), number(0.0));
    assert_eq!(number(f64::INFINITY).scaled_sinh_defect(), number(1.0));
    assert_eq!(number(1e30).scaled_sinh_defect(), number(1.0));
    assert_eq!(
        number(1.0).sin_pi().atan2(number(-1.0)),
        number(0.0).atan2(number(-1.0))
    );
    assert!(number(0.0).atan2(number(-1.0)) > number(3.0));
    assert_eq!(number(f64::NEG_INFINITY).exp(), number(0.0));
    assert_eq!(exp_m1_minus(number(f64::INFINITY)).to_f64(), f64::INFINITY);
    assert_eq!(number(2.0).copysign(number(-0.0)), number(-2.0));
    assert!(number(0.0).abs().to_f64().is_sign_positive());
    for bad in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let (sin, cos) = number(bad).sin_cos_pi();
        assert!(sin.to_f64().is_nan() && cos.to_f64().is_nan());
        for (h, d) in [(bad, 1.0), (1.0, bad)] {
            let (sin, cos) = number(h).sin_cos_pi_minus(number(d));
            assert!(sin.to_f64().is_nan() && cos.to_f64().is_nan());
        }
    }
    assert!(number(f64::NAN).scaled_sinh_defect().to_f64().is_nan());
}

#[test]
fn exact_points_of_every_type() {
    exact_points::<f64>();
    exact_points::<f32>();
    exact_points::<Dd>();
}

#[test]
fn double_double_at_the_ends_of_the_range() {
    let large = Dd::from(1e305);
    assert_eq!(large * Dd::from(1e-5), Dd::product(1e305, 1e-5));
    let quotient = large / Dd::from(1e300);
    assert!(difference(quotient * Dd::from(1e300), large).abs() < 1e-30 * 1e305);
    assert_eq!((large * large).hi, f64::INFINITY);
    assert_eq!((large * large).lo, 0.0);
    let root = large.sqrt();
    assert!(difference(root * root, large).abs() < 1e-30 * 1e305);
    assert_eq!(Dd::from(1e-300).sqrt().to_f64(), 1e-150);
    assert!(Dd::sum(1.0, -1e-30) < Dd::ONE);
    assert_eq!(Dd::sum(1.0, -1e-30).max(Dd::ONE), Dd::ONE);
    assert_eq!(format!("{:.5}", Dd::from(9.999_999)), "1.00000e1");
    assert_eq!(format!("{:.3}", Dd::from(-1.5e-200)), "-1.500e-200");
    assert_eq!(format!("{}", Dd::from(0.0)), "0e0");
}

/// A power of two changes no quotient by more than its error, whichever of the two is next to overflow.
#[test]
fn double_double_divides_next_to_overflow() {
    let (mut source, mut points) = (Source(Random(4)), 0);
    let number = |source: &mut Source| {
        let hi = 1.0 + source.0.unit();
        Dd::sum(hi, hi * 2.0_f64.powi(-54) * source.0.unit())
    };
    for _ in 0..10_000 {
        let (x, y) = (number(&mut source), number(&mut source));
        let want = x / y;
        let mut power = |most: f64| 2.0_f64.powf((most + 1.0 - 50.0 * source.0.unit()).floor());
        // A quotient of 2^−1013 has a first digit that is still normal.
        let (up, down) = (power(1023.0), power(1012.0));
        for (up, down) in [(up, 1.0), (1.0, down), (up, down)] {
            let scaled = |value: Dd, by: f64| Dd::new(value.hi * by, value.lo * by);
            let back = |value: f64| value * (down / up);
            let got = scaled(x, up) / scaled(y, down);
            // A digit close to the least number loses its own end, and in the product with it some more.
            let lost = 16.0 * 2.0_f64.powi(-1074) * (down / up);
            // Both quotients may be off by 2^−103.
            let budget = 2.0 * 2.0_f64.powi(-103) * want.hi + lost;
            let off = difference(Dd::new(back(got.hi), back(got.lo)), want);
            assert!(
                off.abs() <= budget,
                "{x:?} · {up:e} / {y:?} · {down:e}: {off:e}"
            );
            points += 1;
        }
    }
    // The largest number: its product with the first digit, or a part of it, rounds up to infinity.
    let (largest, half) = (Dd::from(f64::MAX), Dd::from(f64::MAX / 2.0));
    for by in (3..2003).step_by(2) {
        let by = Dd::from(f64::from(by));
        let (got, want) = (largest / by, half / by);
        let off = difference(Dd::new(got.hi / 2.0, got.lo / 2.0), want);
        assert!(off.abs() <= 2.0 * 2.0_f64.powi(-103) * want.hi, "{by:?}");
        points += 1;
    }
    println!("quotients next to overflow: {points} points");
    assert_eq!(points, 31_000);
}

/// The exact product's error term must not loop on what cannot be split.
#[test]
fn double_double_infinities_end() {
    let infinite = Dd::from(f64::INFINITY);
    let product = infinite * Dd::from(3.0);
    assert!(!product.to_f64().is_finite());
    assert!(!(infinite / Dd::from(3.0)).to_f64().is_finite());
    assert_eq!((Dd::from(3.0) / infinite).to_f64(), 0.0);
}

/// What is left of an integer by its second part counts.
#[test]
fn double_double_rounds_down() {
    let tiny = 2.0_f64.powi(-60);
    let points = [
        (Dd::sum(3.0, 0.0), 3.0),
        (Dd::sum(3.0, tiny), 3.0),
        (Dd::sum(3.0, -tiny), 2.0),
        (Dd::sum(-3.0, -tiny), -4.0),
        (Dd::sum(-3.0, tiny), -3.0),
        (Dd::sum(2.75, tiny), 2.0),
        (Dd::sum(-2.75, -tiny), -3.0),
        (Dd::sum(0.0, 0.0), 0.0),
    ];
    for (value, expected) in points {
        let found = Float::floor(value);
        assert_eq!((found.hi, found.lo), (expected, 0.0), "⌊{value:?}⌋");
    }
    // Beyond 2⁵³ the second part has a fraction of its own.
    let found = Float::floor(Dd::sum(2.0_f64.powi(60), -0.5));
    assert_eq!((found.hi, found.lo), (2.0_f64.powi(60), -1.0));
}

/// Only the ratio of its arguments counts, however large or small they are.
#[test]
fn double_double_angles_of_any_size() {
    let three = Dd::from(3.0);
    let expected = three.atan2(Dd::from(4.0));
    for power in [-900, -500, -340, 340, 500, 900] {
        let size = 2.0_f64.powi(power);
        let found = Dd::from(3.0 * size).atan2(Dd::from(4.0 * size));
        let error = (found - expected).abs().hi;
        assert!(error < 1e-31, "2^{power}: {error:e}");
    }
    // Their hypotenuse overflows.
    let largest = Dd::from(f64::MAX);
    let error = (largest.atan2(largest) - Dd::PI * Dd::from(0.25)).abs().hi;
    assert!(error < 1e-31, "{error:e}");
}

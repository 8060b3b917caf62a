//! The scalar functions against an independent table, and against double-double.
//!
//! `tools/coefficients.py reference` wrote `data/scalar_reference.csv` with mpmath at 1400 bits.  Arguments and results
//! are sums of two `f64`, so that a result has about 32 digits.
//!
//! This file compares every function with the table and with double-double.  `exact` has arguments whose results are
//! known.  `double_double` tests what only that type has to keep.  `arguments` has the arguments, and `measure` the
//! errors.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod arguments;
mod double_double;
mod exact;
mod measure;

use arguments::{Source, rows};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::special::{exp_m1_minus, versine_pi};
use frictiongen_kernel::number::trig::single;
use frictiongen_kernel::{Float, Scalar};
use fuzzing::Random;
use measure::{Worst, difference, error, error_f32};

/// Largest relative errors of double-double: of its arithmetic, and of its functions.
const DD_BUDGETS: [f64; 2] = [2.5e-32, 2e-31];

/// Every function of the table, with its largest error in units in the last place, for `f64` and for `f32`.
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
        // A result rounded at half a unit may exceed that budget by the error of the reference.
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

/// The stride visits all exponents and both signs among the bit patterns.
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
        // Among the subnormals every term of the sum is rounded to the same digit.
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

//! Tests that only double-double needs: the limits of its range, and its second component.

use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Float, Scalar};
use fuzzing::Random;

/// Returns got − want without the subtraction of [`Dd`], which is itself under test.
fn difference(got: Dd, want: Dd) -> f64 {
    (got.hi - want.hi) + (got.lo - want.lo)
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

/// Scaling by a power of two changes no quotient by more than its error, whichever operand is close to overflow.
#[test]
fn double_double_divides_next_to_overflow() {
    let (mut random, mut points) = (Random(4), 0);
    let number = |random: &mut Random| {
        let hi = 1.0 + random.unit();
        Dd::sum(hi, hi * 2.0_f64.powi(-54) * random.unit())
    };
    for _ in 0..10_000 {
        let (x, y) = (number(&mut random), number(&mut random));
        let want = x / y;
        let mut power = |most: f64| 2.0_f64.powf((most + 1.0 - 50.0 * random.unit()).floor());
        // A quotient of 2^−1013 has a first component that is still normal.
        let (up, down) = (power(1023.0), power(1012.0));
        for (up, down) in [(up, 1.0), (1.0, down), (up, down)] {
            let scaled = |value: Dd, by: f64| Dd::new(value.hi * by, value.lo * by);
            let back = |value: f64| value * (down / up);
            let got = scaled(x, up) / scaled(y, down);
            // A component close to the least number loses its last bits, and the product with such a component loses
            // more.
            let lost = 16.0 * 2.0_f64.powi(-1074) * (down / up);
            // Each of both quotients may have an error of 2^−103.
            let budget = 2.0 * 2.0_f64.powi(-103) * want.hi + lost;
            let off = difference(Dd::new(back(got.hi), back(got.lo)), want);
            assert!(
                off.abs() <= budget,
                "{x:?} · {up:e} / {y:?} · {down:e}: {off:e}"
            );
            points += 1;
        }
    }
    // For the largest number, the product with the first component, or a term of that product, rounds up to infinity.
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

/// The error term of an exact product must not loop on a number that cannot be split.
#[test]
fn double_double_infinities_end() {
    let infinite = Dd::from(f64::INFINITY);
    let product = infinite * Dd::from(3.0);
    assert!(!product.to_f64().is_finite());
    assert!(!(infinite / Dd::from(3.0)).to_f64().is_finite());
    assert_eq!((Dd::from(3.0) / infinite).to_f64(), 0.0);
}

/// The second component decides the rounding where the first component is an integer.
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
    // Beyond 2⁵³ the second component has a fraction of its own.
    let found = Float::floor(Dd::sum(2.0_f64.powi(60), -0.5));
    assert_eq!((found.hi, found.lo), (2.0_f64.powi(60), -1.0));
}

/// Only the ratio of the arguments counts, however large or small they are.
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
    // The hypotenuse of both arguments overflows.
    let largest = Dd::from(f64::MAX);
    let error = (largest.atan2(largest) - Dd::PI * Dd::from(0.25)).abs().hi;
    assert!(error < 1e-31, "{error:e}");
}

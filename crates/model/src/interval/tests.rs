//! Tests interval results against values in double-double.

use super::{Interval, TINY};
use crate::samples::{RandomNumbers, contains};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;

#[test]
fn arithmetic() {
    let mut numbers = RandomNumbers(3);
    let mut seen = 0;
    for _ in 0..100_000 {
        let (a, b) = (numbers.interval(), numbers.interval());
        let (x, y) = (numbers.within(a), numbers.within(b));
        let (dx, dy) = (Dd::from(x), Dd::from(y));
        assert!(contains(a + b, dx + dy), "{a:?} + {b:?}");
        assert!(contains(a - b, dx - dy), "{a:?} - {b:?}");
        assert!(contains(a * b, dx * dy), "{a:?} {b:?} at {x} {y}");
        assert!(contains(a.squared(), dx * dx), "{a:?} squared");
        if !b.holds_zero() {
            assert!(contains(a / b, dx / dy), "{a:?} / {b:?}");
            seen += 1;
        }
        if 0.0 <= a.low {
            assert!(contains(a.sqrt(), Scalar::sqrt(dx)), "root of {a:?}");
            seen += 1;
        }
    }
    assert!(seen > 50_000, "{seen}");
    assert_eq!(Interval::ONE / Interval::new(-1.0, 2.0), Interval::ALL);
    let nothing = Interval::ZERO * Interval::ALL;
    assert!(nothing.low <= 0.0 && 0.0 <= nothing.high && nothing.size() <= TINY);
}

#[test]
fn functions() {
    let mut numbers = RandomNumbers(5);
    for _ in 0..50_000 {
        let low = 40.0 * numbers.unit() - 30.0;
        let width = if numbers.unit() < 0.5 { 1e-9 } else { 2.5 };
        let interval = Interval::new(low, low + width * numbers.unit());
        let x = numbers.within(interval);
        let (sine, cosine) = interval.sine_cosine();
        let (own_sine, own_cosine) = Dd::from(x).sin_cos_pi();
        assert!(contains(sine, own_sine), "sine over {interval:?} at {x}");
        assert!(
            contains(cosine, own_cosine),
            "cosine over {interval:?} at {x}"
        );
        assert!(sine.size() <= 1.0 && cosine.size() <= 1.0);
        assert!(
            contains(interval.exp(), Scalar::exp(Dd::from(x))),
            "e^{interval:?} at {x}"
        );
    }
    // The bounds of the tested intervals lie on an extreme of the cosine, or one rounding away from the extreme.
    for whole in [-3.0, -1.0, 0.0, 2.0, 5.0_f64] {
        for end in [whole - 0.5, whole, whole + 0.5] {
            let interval = Interval::new(end.next_down(), end.next_down());
            let x = Dd::from(end.next_down());
            assert!(contains(interval.sine_cosine().0, x.sin_cos_pi().0));
            assert!(contains(interval.sine_cosine().1, x.sin_cos_pi().1));
        }
    }
}

#[test]
fn cotangent() {
    for i in 1..100 {
        let z = 0.01 * f64::from(i);
        let interval = Interval::new(-z, z).cotangent_times();
        assert!(interval.low <= z / z.tan() && z / z.tan() <= interval.high);
    }
    assert!(Interval::new(-1.0, 0.1).cotangent_times().low.is_infinite());
}

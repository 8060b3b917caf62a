//! Tests interval results against values in double-double.

use super::{Interval, TINY};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;

/// A generator of random numbers and intervals.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
    /// Returns a random bound of an interval: a number of either sign over ten decades, and sometimes 0.
    fn end(&mut self) -> f64 {
        let size = 10_f64.powf(10.0 * self.next() - 5.0);
        match (16.0 * self.next()) as u32 {
            0 => 0.0,
            even if even % 2 == 0 => size,
            _ => -size,
        }
    }
    fn interval(&mut self) -> Interval {
        let (a, b) = (self.end(), self.end());
        // Two in five random intervals are narrow.
        if self.next() < 0.4 {
            Interval::new(a, a + a.abs() * 1e-12 * self.next())
        } else {
            Interval::new(a.min(b), a.max(b))
        }
    }
    fn within(&mut self, interval: Interval) -> f64 {
        match (4.0 * self.next()) as u32 {
            0 => interval.low,
            1 => interval.high,
            _ => (interval.low + (interval.high - interval.low) * self.next())
                .clamp(interval.low, interval.high),
        }
    }
}

/// Returns true if an interval contains a number to about its 31 digits. The tolerance is far below one rounding of a
/// double.
fn holds(interval: Interval, value: Dd) -> bool {
    let slack = value.abs() * Dd::from(1e-28);
    !(value + slack < Dd::from(interval.low)) && !(Dd::from(interval.high) < value - slack)
}

#[test]
fn arithmetic() {
    let mut numbers = Numbers(3);
    let mut seen = 0;
    for _ in 0..100_000 {
        let (a, b) = (numbers.interval(), numbers.interval());
        let (x, y) = (numbers.within(a), numbers.within(b));
        let (dx, dy) = (Dd::from(x), Dd::from(y));
        assert!(holds(a + b, dx + dy), "{a:?} + {b:?}");
        assert!(holds(a - b, dx - dy), "{a:?} - {b:?}");
        assert!(holds(a * b, dx * dy), "{a:?} {b:?} at {x} {y}");
        assert!(holds(a.squared(), dx * dx), "{a:?} squared");
        if !b.holds_zero() {
            assert!(holds(a / b, dx / dy), "{a:?} / {b:?}");
            seen += 1;
        }
        if 0.0 <= a.low {
            assert!(holds(a.sqrt(), Scalar::sqrt(dx)), "root of {a:?}");
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
    let mut numbers = Numbers(5);
    for _ in 0..50_000 {
        let low = 40.0 * numbers.next() - 30.0;
        let width = if numbers.next() < 0.5 { 1e-9 } else { 2.5 };
        let interval = Interval::new(low, low + width * numbers.next());
        let x = numbers.within(interval);
        let (sine, cosine) = interval.sine_cosine();
        let (own_sine, own_cosine) = Dd::from(x).sin_cos_pi();
        assert!(holds(sine, own_sine), "sine over {interval:?} at {x}");
        assert!(holds(cosine, own_cosine), "cosine over {interval:?} at {x}");
        assert!(sine.size() <= 1.0 && cosine.size() <= 1.0);
        assert!(
            holds(interval.exp(), Scalar::exp(Dd::from(x))),
            "e^{interval:?} at {x}"
        );
    }
    // The bounds of the tested intervals lie on an extreme of the cosine, or one rounding away from it.
    for whole in [-3.0, -1.0, 0.0, 2.0, 5.0_f64] {
        for end in [whole - 0.5, whole, whole + 0.5] {
            let interval = Interval::new(end.next_down(), end.next_down());
            let x = Dd::from(end.next_down());
            assert!(holds(interval.sine_cosine().0, x.sin_cos_pi().0));
            assert!(holds(interval.sine_cosine().1, x.sin_cos_pi().1));
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

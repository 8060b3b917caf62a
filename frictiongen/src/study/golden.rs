//! Searches an interval by golden sections, without derivatives, and by parabolas where the function is smooth.

/// Larger of the two fractions into which a golden section divides an interval.
pub(super) const GOLDEN: f64 = 0.618_033_988_749_894_8;
/// Largest number of steps of [`largest`]. A golden-section step reduces the interval to at most 0.62 of its length.
const STEPS: usize = 90;

/// Returns the position and the value of the minimum of the function `of` between `low` and `high`. The search takes
/// at most `steps` golden sections, and ends earlier if the interval is shorter than `width`.
///
/// # Errors
/// The first error that the function `of` returns.
pub(crate) fn smallest<E>(
    (mut low, mut high): (f64, f64),
    (steps, width): (usize, f64),
    mut of: impl FnMut(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    let (mut left, mut right) = (high - (high - low) * GOLDEN, low + (high - low) * GOLDEN);
    let (mut at_left, mut at_right) = (of(left)?, of(right)?);
    for _ in 0..steps {
        if high - low < width {
            break;
        }
        if at_right < at_left {
            (low, left, at_left) = (left, right, at_right);
            right = low + (high - low) * GOLDEN;
            at_right = of(right)?;
        } else {
            (high, right, at_right) = (right, left, at_left);
            left = high - (high - low) * GOLDEN;
            at_left = of(left)?;
        }
    }
    Ok(if at_right < at_left {
        (right, at_right)
    } else {
        (left, at_left)
    })
}

/// Searches for a position between `low` and `high` whose value is `enough`, and goes towards the larger value. Returns
/// `None` if `steps` golden sections find no such position.
pub(super) fn reached(
    [mut low, mut high]: [f64; 2],
    steps: usize,
    value: impl Fn(f64) -> f64,
    enough: impl Fn(f64) -> bool,
) -> Option<f64> {
    for _ in 0..steps {
        let (left, right) = (high - (high - low) * GOLDEN, low + (high - low) * GOLDEN);
        let (at_left, at_right) = (value(left), value(right));
        match (enough(at_left), enough(at_right)) {
            (true, _) => return Some(left),
            (_, true) => return Some(right),
            _ if at_left < at_right => low = left,
            _ => high = right,
        }
    }
    None
}

/// Returns the position and height of a function's maximum on [a, b], by Brent's method from a starting position within
/// the interval. The method fits parabolas, and uses golden sections where parabolas fail. `relative` is the relative
/// tolerance of the position. `f` must return −∞ where it is undefined.
pub(super) fn largest(
    mut f: impl FnMut(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    (start, value): (f64, f64),
    relative: f64,
) -> (f64, f64) {
    let (mut x, mut fx) = (start, value);
    let (mut w, mut fw, mut v, mut fv) = (x, fx, x, fx);
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    for _ in 0..STEPS {
        let middle = 0.5 * (a + b);
        let near = relative * x.abs();
        if (x - middle).abs() <= 2.0 * near - 0.5 * (b - a) {
            break;
        }
        let mut golden = true;
        if near < before.abs() {
            let (r, q) = ((x - w) * (fx - fv), (x - v) * (fx - fw));
            let (p, q) = ((x - v) * q - (x - w) * r, 2.0 * (q - r));
            let move_by = -p / q;
            let to = x + move_by;
            if move_by.abs() < 0.5 * before.abs() && a < to && to < b {
                (before, step, golden) = (step, move_by, false);
                if to - a < 2.0 * near || b - to < 2.0 * near {
                    step = near.copysign(middle - x);
                }
            }
        }
        if golden {
            before = if x < middle { b - x } else { a - x };
            step = (1.0 - GOLDEN) * before;
        }
        let u = if step.abs() < near {
            x + near.copysign(step)
        } else {
            x + step
        };
        let fu = f(u);
        if fu >= fx {
            if u < x {
                b = x
            } else {
                a = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                a = u
            } else {
                b = u
            }
            if fu >= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu >= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    (x, fx)
}

#[cfg(test)]
mod tests {
    use super::largest;

    #[test]
    fn smooth_and_bent() {
        let mut count = 0;
        let hill = |x: f64| 1.0 / (1e-4 + (x - 1.234).powi(2));
        let (x, value) = largest(
            |x| {
                count += 1;
                hill(x)
            },
            [1.0, 2.0],
            (1.4, hill(1.4)),
            1e-9,
        );
        assert!(
            (x - 1.234).abs() < 1e-8 && (value - 1e4).abs() < 1e-8,
            "{x} {value}"
        );
        assert!(count < 60, "{count}");
        let roof = |x: f64| -(x - 0.3).abs();
        let (x, _) = largest(roof, [0.0, 1.0], (0.5, roof(0.5)), 1e-12);
        assert!((x - 0.3).abs() < 1e-9, "{x}");
        // The function x has its maximum at the upper bound of the interval.
        let (x, _) = largest(|x| x, [0.0, 1.0], (0.5, 0.5), 1e-12);
        assert!(x > 1.0 - 1e-9, "{x}");
    }
}

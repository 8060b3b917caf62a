//! Length of a step over which a positive function stays positive, from a bound on its third derivative.

use crate::number::scalar::Float;

/// Upper bound on the number of Newton steps towards a root of the cubic.
const STEPS: usize = 12;
/// Largest relative Newton step at which the root of the cubic counts as found. A smaller tolerance would only cost
/// time, because the search continues from the root.
const CLOSE: f64 = 0.1;

/// Returns a step over which a function f stays positive if |f‴| ≤ B.
///
/// `f`, `slope` and `curve` are f, f′ and f″ at the start, and `bound` is B. The caller must pass f ≥ 0, and f′ > 0 if
/// f = 0. The cubic p(h) = f + f′h + f″h²/2 − Bh³/6 is a lower bound on f. The function f is therefore positive up to
/// the smallest positive root of p. The result is close to this root, and exceeds the root at most by rounding. The
/// result never exceeds `most`.
pub(crate) fn safe<S: Float>(f: S, slope: S, curve: S, bound: S, most: S) -> S {
    let (zero, half) = (S::constant(0.0), S::constant(0.5));
    let sixth = S::constant(1.0 / 6.0);
    let value = |h: S| f + h * (slope + h * (curve * half - bound * h * sixth));
    let tangent = |h: S| slope + h * (curve - bound * h * half);
    if zero < value(most) && (zero <= slope || zero < least(f, slope, curve, bound)) {
        return most;
    }
    // The cubic p is convex before its inflection point and concave after it.
    let inflection = (curve / bound).max(zero);
    let discriminant = curve * curve + (bound + bound) * slope;
    let mut from = inflection;
    if zero < discriminant {
        let root = discriminant.sqrt();
        if slope < zero && zero < curve {
            // The minimum of the cubic p is at the smaller root of the derivative p′. The code uses the form of this
            // root in which no terms cancel.
            let dip = -(slope + slope) / (curve + root);
            if value(dip) <= zero {
                return from_left(value, tangent);
            }
        }
        if curve < zero {
            // This expression is another form of the root (curve + root)/bound of p′. If the bound is small, the terms
            // of that form would cancel, and the root would be lost.
            from = ((slope + slope) / (root - curve)).max(zero);
        } else if zero < curve + root {
            from = (curve + root) / bound;
        }
    } else if !(zero < value(inflection)) {
        return from_left(value, tangent);
    }
    // At distances of more than `from`, the cubic p falls ever more steeply. If Newton's method starts after the root
    // of p, the method therefore stays after the root.
    let top = value(from);
    let fall = tangent(from);
    let steep = -(curve - bound * from);
    // The code takes the smallest of three upper bounds on the root. The bounds come from the tangent at `from`, from
    // the curvature at `from`, and from the cubic term alone.
    let mut h = from + (top * S::constant(6.0) / bound).max(S::constant(1.0));
    if fall < zero {
        h = h.min(from - top / fall);
    }
    if zero < steep {
        h = h.min(from + ((top + top) / steep).sqrt());
    }
    if most < h {
        h = most;
        if zero <= value(h) {
            return h;
        }
    }
    for _ in 0..STEPS {
        let (p, q) = (value(h), tangent(h));
        if !(p < zero) || !(q < zero) {
            break;
        }
        let next = (h - p / q).max(from);
        if !(next < h) {
            break;
        }
        let close = h - next <= h * S::constant(CLOSE);
        h = next;
        if close {
            break;
        }
    }
    let p = value(h);
    if p < zero {
        // The chord of a concave function reaches zero earlier than the function. A step to the zero of the chord is
        // therefore safe.
        from + (h - from) * (top / (top - p))
    } else {
        h
    }
}

/// Returns the value of the cubic p of [`safe`] at its minimum. If p has no minimum ahead, returns the present value
/// f.
fn least<S: Float>(f: S, slope: S, curve: S, bound: S) -> S {
    let discriminant = curve * curve + (bound + bound) * slope;
    let zero = S::constant(0.0);
    if slope < zero && zero < curve && zero < discriminant {
        let dip = -(slope + slope) / (curve + discriminant.sqrt());
        f + dip * (slope + dip * (curve * S::constant(0.5) - bound * dip * S::constant(1.0 / 6.0)))
    } else {
        f
    }
}

/// Finds the root of a convex, decreasing function by Newton's method, starting at 0. For a convex, decreasing function
/// no step passes the root.
fn from_left<S: Float>(value: impl Fn(S) -> S, tangent: impl Fn(S) -> S) -> S {
    let zero = S::constant(0.0);
    let mut h = zero;
    for _ in 0..STEPS {
        let (p, q) = (value(h), tangent(h));
        if !(zero < p) || !(q < zero) {
            break;
        }
        let step = -(p / q);
        h = h + step;
        if step <= h * S::constant(CLOSE) {
            break;
        }
    }
    h
}

#[cfg(test)]
mod tests {
    use super::safe;

    #[test]
    fn a_slight_bound_leaves_a_fall_its_root() {
        // The cubic is 2h − h²/2 minus a tiny term in h³. Its maximum is at 2, and its root near 4. Newton's method
        // must approach this root from larger h.
        for bound in [1e-12_f32, 1e-9, 1e-7, 1e-4] {
            let h = safe(0.0, 2.0, -1.0, bound, 10.0);
            // The result is close to 4. This value comes from the chord at the last Newton step, which is nearer to the
            // root than the step itself.
            assert!((3.99..=4.000_001).contains(&h), "{bound:e}: {h}");
        }
        // The maximum of the cubic 1 − h − h²/2 is at a negative h.
        let h = safe(1.0, -1.0, -1.0, 1e-9_f32, 10.0);
        assert!((0.731..=0.732_06).contains(&h), "{h}");
    }
}

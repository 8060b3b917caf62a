//! Finds the first zero of a polynomial. A bound on all derivatives proves that an interval has no zero. All other
//! intervals are halved, so no zero is missed.

/// Returns the value of Σ c_k tᵏ.
pub fn value(c: &[f64], t: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * t + c)
}

/// Returns the coefficients of the polynomial's derivative.
pub fn slope(c: &[f64]) -> Vec<f64> {
    let rest = c.iter().enumerate().skip(1);
    rest.map(|(k, c)| k as f64 * c).collect()
}

/// Returns the coefficients of the same polynomial in powers of the distance from the point t.
pub fn shifted(c: &[f64], t: f64) -> Vec<f64> {
    let mut c = c.to_vec();
    for low in 0..c.len() {
        for k in (low..c.len().saturating_sub(1)).rev() {
            c[k] += t * c[k + 1];
        }
    }
    c
}

/// Returns the first zero, between `from` and `to`, of a polynomial that is positive at `from`. A double zero, where
/// the sign does not change, counts.
pub fn first(c: &[f64], from: f64, to: f64) -> Option<f64> {
    let half = 0.5 * (to - from);
    let middle = from + half;
    let about = shifted(c, middle);
    let mut power = 1.0;
    let rest: f64 = about
        .iter()
        .skip(1)
        .map(|c| {
            power *= half;
            c.abs() * power
        })
        .sum();
    if about[0] > rest {
        return None;
    }
    // An interval that is as short as a rounding unit and has no change of sign contains a double zero.
    if half <= 1e-15 * to.abs() || half < 1e-300 {
        return (about[0] <= rest).then_some(middle);
    }
    // The polynomial is steep and monotone here, so bisection needs no bounds.
    let steep: f64 = {
        let mut power = 1.0;
        let terms = about.iter().enumerate().skip(2);
        terms
            .map(|(k, c)| {
                power *= half;
                k as f64 * c.abs() * power
            })
            .sum()
    };
    if about.len() > 1 && about[1].abs() > steep {
        return monotone(c, from, to);
    }
    first(c, from, middle).or_else(|| first(c, middle, to))
}

fn monotone(c: &[f64], from: f64, to: f64) -> Option<f64> {
    if value(c, from) <= 0.0 {
        return Some(from);
    }
    if value(c, to) > 0.0 {
        return None;
    }
    let (mut low, mut high) = (from, to);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if value(c, middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(high)
}

#[test]
fn zeros_of_known_polynomials() {
    // The polynomial (t − 1/4)(t − 3/4) is tested three times: from the left of both zeros, from between them with the
    // opposite sign, and on an interval without zeros.
    let c = [0.1875, -1.0, 1.0];
    assert!((first(&c, 0.0, 1.0).expect("a zero") - 0.25).abs() < 1e-15);
    assert!((first(&c.map(|c| -c), 0.3, 1.0).expect("a zero") - 0.75).abs() < 1e-15);
    assert_eq!(first(&c, 0.0, 0.2), None);
    // (t − 1/2)² + 1e-10 has no zero. (t − 1/2)² − 1e-10 has two zeros near each other.
    assert_eq!(first(&[0.25 + 1e-10, -1.0, 1.0], 0.0, 1.0), None);
    let near = first(&[0.25 - 1e-10, -1.0, 1.0], 0.0, 1.0).expect("a zero");
    assert!((near - (0.5 - 1e-5)).abs() < 1e-10);
}

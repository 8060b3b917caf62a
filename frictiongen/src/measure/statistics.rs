//! Quantiles for intervals of 95 %.

/// Of the normal distribution, two-sided.
pub(super) const NORMAL: f64 = 1.959_963_984_540_054;
/// Of χ² with one degree of freedom: the square.
pub(super) const CHI: f64 = NORMAL * NORMAL;

/// What the variances of a fit are multiplied by: its sum of squares over the degrees of freedom where that is more than
/// chance, three of its deviations above 1; else 1, because the deviations are known.
pub(super) fn excess(misfit: Option<f64>, freedom: usize) -> f64 {
    let chance = 1.0 + 3.0 * (2.0 / freedom.max(1) as f64).sqrt();
    misfit.filter(|misfit| chance < *misfit).unwrap_or(1.0)
}

/// Of Student's distribution with so many degrees of freedom, two-sided.
pub(super) fn student(freedom: usize) -> f64 {
    if freedom == 0 {
        return f64::INFINITY;
    }
    // The probability within ±t is known in closed form (Abramowitz and Stegun, 26.7.3 and 26.7.4).
    let (mut low, mut high) = (NORMAL, 13.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if within(middle, freedom) < 0.95 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Beyond so many degrees the normal distribution is as good, to 2e-4.
const MANY: usize = 10_000;

fn within(t: f64, freedom: usize) -> f64 {
    let n = freedom.min(MANY) as f64;
    let angle = (t / n.sqrt()).atan();
    let cosine_squared = angle.cos().powi(2);
    let odd = !freedom.min(MANY).is_multiple_of(2);
    // 1 + (1/2)c² + (1·3/2·4)c⁴ + … or, odd, c + (2/3)c³ + …
    let (mut term, mut k) = if odd { (angle.cos(), 1.0) } else { (1.0, 0.0) };
    let mut sum = 0.0;
    while k <= n - 2.0 {
        sum += term;
        term *= cosine_squared * (k + 1.0) / (k + 2.0);
        k += 2.0;
    }
    if odd {
        (angle + angle.sin() * sum) * std::f64::consts::FRAC_2_PI
    } else {
        angle.sin() * sum
    }
}

#[cfg(test)]
mod tests {
    use super::student;

    /// The table of any textbook.
    #[test]
    fn quantiles() {
        for (freedom, expected) in [
            (1, 12.706),
            (2, 4.303),
            (3, 3.182),
            (10, 2.228),
            (30, 2.042),
            (120, 1.980),
        ] {
            assert!((student(freedom) - expected).abs() < 5e-4, "{freedom}");
        }
        assert!((student(1_000_000) - 1.96).abs() < 5e-4);
        assert!(student(0).is_infinite());
    }
}

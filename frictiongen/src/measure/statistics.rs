//! Quantiles for confidence intervals at the 95 % level.

/// Two-sided 95 % quantile of the normal distribution.
pub(super) const NORMAL: f64 = 1.959_963_984_540_054;
/// 95 % quantile of χ² with one degree of freedom, the square of [`NORMAL`].
pub(super) const CHI: f64 = NORMAL * NORMAL;

/// Number that a variable with the standard normal distribution exceeds with probability 1/1000.
const RARE: f64 = 3.090_232_306_167_813;

/// Returns an upper bound on the misfit of a fit to data with noise of known deviations. The misfit is the sum of
/// squared residuals divided by the degrees of freedom. By chance, one of 1000 recordings exceeds the bound. The bound
/// is the χ² quantile by Wilson and Hilferty's approximation (Abramowitz and Stegun, 26.4.17). It is 3 % above the
/// exact quantile for one degree of freedom, and 0.6 % above it for ten.
fn most_by_chance(freedom: usize) -> f64 {
    let spread = 2.0 / (9.0 * freedom.max(1) as f64);
    (1.0 - spread + RARE * spread.sqrt()).powi(3)
}

/// Returns true if noise explains a misfit, which is the sum of squared residuals divided by the degrees of freedom.
/// Without degrees of freedom the result is true.
pub(super) fn is_chance(misfit: Option<f64>, freedom: usize) -> bool {
    misfit.is_none_or(|misfit| misfit <= most_by_chance(freedom))
}

/// Returns the factor by which a fit must multiply its variances. The factor is the misfit if noise does not explain
/// the misfit. Otherwise the factor is 1, because the deviations of the data are known.
pub(super) fn excess(misfit: Option<f64>, freedom: usize) -> f64 {
    let unexplained = misfit.filter(|misfit| !is_chance(Some(*misfit), freedom));
    unexplained.unwrap_or(1.0)
}

/// Returns the two-sided 95 % quantile of Student's t distribution for a number of degrees of freedom.
pub(super) fn student(freedom: usize) -> f64 {
    if freedom == 0 {
        return f64::INFINITY;
    }
    // The probability within ±t has a closed form (Abramowitz and Stegun, 26.7.3 and 26.7.4).
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

/// Largest number of degrees of freedom for which the code evaluates Student's distribution. For more degrees of
/// freedom, the code uses the distribution for this number. The error of the quantile is then about 2e-4 at most.
const MANY: usize = 10_000;

fn within(t: f64, freedom: usize) -> f64 {
    let n = freedom.min(MANY) as f64;
    let angle = (t / n.sqrt()).atan();
    let cosine_squared = angle.cos().powi(2);
    let odd = !freedom.min(MANY).is_multiple_of(2);
    // With the cosine c of `angle`, the sum is 1 + c²/2 + 3c⁴/8 + … for an even number of degrees of freedom. For an
    // odd number it is c + 2c³/3 + ….
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
    use super::{most_by_chance, student};

    /// Compares the upper bound on the misfit with a textbook table of χ². Noise exceeds the values of this table with
    /// probability 0.001.
    #[test]
    fn rare_sums_of_squares() {
        for (freedom, expected, apart) in [
            (1, 10.828, 0.035),
            (2, 13.816, 0.025),
            (10, 29.588, 7e-3),
            (30, 59.703, 2e-3),
            (100, 149.449, 1e-3),
        ] {
            let sum = most_by_chance(freedom) * freedom as f64;
            assert!((sum / expected - 1.0).abs() < apart, "{freedom}: {sum}");
        }
    }

    /// Compares the quantiles with a textbook table of Student's distribution.
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

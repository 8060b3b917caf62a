//! Straight lines in place of a smooth friction law.

/// Accuracy of the lines, as a fraction of F, if a description gives none.
pub const ACCURACY: f64 = 1e-3;
/// Smallest accuracy of the lines, as a fraction of F.
pub const FINEST: f64 = 1e-6;
/// Largest friction at rest over F.
pub const HIGHEST: f64 = 100.0;
/// Largest error of the lines for 1 − e⁻ˣ. A larger error would leave no line that falls.
const COARSEST: f64 = 0.25;
/// Number of halvings in a bisection. The interval then has the length of a rounding unit.
const HALVINGS: u32 = 60;

/// Straight lines for a kinetic friction force that decays with the speed, from `rest`·F to F:
/// F(v) = F (1 + (rest − 1) exp(−v/speed)).
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothLaw {
    /// Friction at rest over F.
    pub rest: f64,
    /// Points (v, f) of the lines behind (0, 1). f is the kinetic friction over its value at rest. From the last point on
    /// the friction is F.
    pub points: Vec<[f64; 2]>,
    /// Largest difference between the lines and the law, as a fraction of F.
    pub error: f64,
}

impl SmoothLaw {
    /// Finds lines whose difference from the law is at most `accuracy`, as a fraction of F. `rest` must exceed 1, and
    /// `speed` must be above 0.
    ///
    /// All corners but the last are on the law. Each line is as long as the accuracy permits, and the last one ends at F.
    ///
    /// ```
    /// use frictiongen_model::stribeck::SmoothLaw;
    ///
    /// let law = SmoothLaw::decaying(1.5, 0.1, 1e-2);
    /// assert_eq!(law.points.len(), 5);
    /// assert!(law.error <= 1e-2);
    /// ```
    #[must_use]
    pub fn decaying(rest: f64, speed: f64, accuracy: f64) -> Self {
        let height = rest - 1.0;
        // The lines are those of e⁻ˣ, with x = v/speed.
        let error = (accuracy / height).min(COARSEST);
        let mut corners = vec![[0.0, 1.0_f64]];
        let mut largest = 0.0_f64;
        while let Some(&[x, y]) = corners.last() {
            let last = (y / error).ln();
            let above = above(last);
            let (length, end, found) = if y * above <= error {
                (last, 0.0, (y * above).max(error))
            } else {
                let length = chord(error / y);
                (length, y * (-length).exp(), y * bulge(length))
            };
            largest = largest.max(found);
            corners.push([x + length, end]);
            if end == 0.0 {
                break;
            }
        }
        let points = corners.iter().skip(1);
        let points = points.map(|[x, y]| [speed * x, (1.0 + height * y) / rest]);
        Self {
            rest,
            points: points.collect(),
            error: height * largest,
        }
    }
}

/// Returns the largest excess over e⁻ˣ of the line from (0, 1) to (`length`, 0).
fn above(length: f64) -> f64 {
    if length <= 1.0 {
        return 0.0;
    }
    1.0 - (1.0 + length.ln()) / length
}

/// Returns the largest excess over e⁻ˣ of its chord from 0 to `length`.
fn bulge(length: f64) -> f64 {
    let slope = -(-length).exp_m1() / length;
    1.0 - slope * (1.0 - slope.ln())
}

/// Returns the length of the chord of e⁻ˣ from 0 on with the largest excess `error`.
fn chord(error: f64) -> f64 {
    // For short chords the excess is length²/8. It is always less.
    let (mut low, mut high) = (0.0, 1.0);
    while bulge(high) < error {
        high *= 2.0;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if bulge(middle) <= error {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::SmoothLaw;

    /// Returns the friction over F on the lines.
    fn on_lines(law: &SmoothLaw, speed: f64) -> f64 {
        let mut before = [0.0, 1.0];
        for point in &law.points {
            if speed < point[0] {
                let share = (speed - before[0]) / (point[0] - before[0]);
                return law.rest * (before[1] + share * (point[1] - before[1]));
            }
            before = *point;
        }
        law.rest * before[1]
    }

    /// Samples the lines densely. The stated error must be the largest difference, and at most the accuracy.
    #[test]
    fn the_error_is_the_largest_difference() {
        for (rest, speed) in [(1.3, 0.05), (1.001, 2.0), (7.0, 1e-3)] {
            for accuracy in [1e-1, 1e-2, 1e-3, 1e-5] {
                let law = SmoothLaw::decaying(rest, speed, accuracy);
                let worst = (0..=200_000).map(|index| {
                    let v = 20.0 * speed * f64::from(index) / 200_000.0;
                    let exact = 1.0 + (rest - 1.0) * (-v / speed).exp();
                    (on_lines(&law, v) - exact).abs()
                });
                let worst = worst.fold(0.0, f64::max);
                println!(
                    "{rest}, {accuracy}: {} lines, error {:.3e}, found {worst:.3e}",
                    law.points.len() + 1,
                    law.error
                );
                assert!(law.error <= accuracy * (1.0 + 1e-9), "{law:?}");
                assert!(
                    worst <= law.error * (1.0 + 1e-6),
                    "{worst} of {}",
                    law.error
                );
                assert!(0.99 * law.error <= worst, "{worst} of {}", law.error);
                // Halving the length of each line quarters the error: about 0.71 √(height/accuracy) lines.
                let expected = 0.71 * ((rest - 1.0) / accuracy).sqrt();
                let lines = law.points.len() as f64;
                assert!(lines < expected + 2.0, "{lines} lines for {expected}");
                let ascends = law.points.windows(2).all(|pair| pair[0][0] < pair[1][0]);
                assert!(ascends && law.points.len() < 2000);
                let last = law.points.last().map(|point| point[1] * rest);
                assert!(last.is_some_and(|last| (last - 1.0).abs() < 1e-15));
            }
        }
    }
}

//! Converts phases to (−180, 180] degrees, as in the tables of the program.

use crate::Point;

/// Largest difference of two phases, in degrees, that counts as a rounding error.
const SEAM: f64 = 1e-6;

/// Adds whole turns to a phase in degrees, so that the result lies in (−180, 180]. The tables of the program show the
/// same value.
#[must_use]
pub fn principal(phase: f64) -> f64 {
    phase - 360.0 * ((phase - 180.0 - SEAM) / 360.0).ceil()
}

/// Folds phase curves in degrees into (−180, 180]. Each list of points in `runs` is a curve. A curve that leaves the
/// range at one end continues as a new curve at the other end. The function leaves out curves of a single point,
/// because no line can show them.
#[must_use]
pub fn folded(runs: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let mut folded: Vec<Vec<Point>> = Vec::new();
    for run in runs {
        let mut current: Vec<Point> = Vec::new();
        let mut last: Option<(Point, f64)> = None;
        for &(x, phase) in run {
            let turn = principal(phase) - phase;
            if let Some(((last_x, last_phase), last_turn)) = last
                && last_turn != turn
            {
                // The line crosses this end of the range, and then continues at the opposite end.
                let border = if last_phase < phase { 180.0 } else { -180.0 };
                let share = (border - last_turn - last_phase) / (phase - last_phase);
                let middle = last_x + share.clamp(0.0, 1.0) * (x - last_x);
                current.push((middle, border));
                folded.push(std::mem::take(&mut current));
                current.push((middle, -border));
            }
            current.push((x, phase + turn));
            last = Some(((x, phase), turn));
        }
        folded.push(current);
    }
    folded.retain(|run| 1 < run.len());
    folded
}

/// Returns the range of a phase axis in degrees: 0 to 180 if no phase is negative, otherwise −180 to 180.
#[must_use]
pub fn phase_ends(phases: impl Iterator<Item = f64>) -> (f64, f64) {
    // A phase may differ from 0 by rounding.
    let leads = phases.fold(0.0_f64, f64::min) < -SEAM;
    (if leads { -180.0 } else { 0.0 }, 180.0)
}

#[cfg(test)]
mod tests {
    use super::{folded, principal};

    #[test]
    fn phases_are_those_of_the_table() {
        for (given, expected) in [
            (0.0, 0.0),
            (180.0, 180.0),
            (180.0 + 1e-9, 180.0 + 1e-9),
            (-180.0, 180.0),
            (190.0, -170.0),
            (-190.0, 170.0),
            (900.0, 180.0),
            (-541.0, 179.0),
        ] {
            assert!((principal(given) - expected).abs() < 1e-9, "{given}");
        }
        let run = vec![(0.0, 170.0), (1.0, 190.0), (2.0, 200.0), (3.0, 170.0)];
        assert_eq!(
            folded(&[run, vec![(9.0, 1.0)]]),
            [
                vec![(0.0, 170.0), (0.5, 180.0)],
                vec![
                    (0.5, -180.0),
                    (1.0, -170.0),
                    (2.0, -160.0),
                    (2.0 + 2.0 / 3.0, -180.0)
                ],
                vec![(2.0 + 2.0 / 3.0, 180.0), (3.0, 170.0)],
            ]
        );
        // Rounding next to 180 degrees makes no jump.
        let flat = vec![(0.0, 180.0), (1.0, 180.0 + 1e-12), (2.0, 180.0 - 1e-12)];
        assert_eq!(folded(std::slice::from_ref(&flat)), [flat]);
    }
}

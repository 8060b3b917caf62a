//! Tests the ranges in which friction enlarges a motion, against the computed growth.

use super::dense;
use crate::features::scenes::{random, shown};
use frictiongen::study::features::{Edge, InvariantQuantity};
use frictiongen::{LimitsAt, Of};
use fuzzing::Random;

/// Checks that friction enlarges the motion within the ranges and not outside them. The growth of the estimate and of
/// the fundamental is computed directly.
#[test]
fn inversions() {
    let mut random_numbers = Random(23);
    let (mut inside, mut outside) = (0, 0);
    for scene in 0..40 {
        let system = random(&mut random_numbers, 6, false);
        let largest = *system.resonances().last().unwrap();
        let range = [0.2 * largest, 1.5 * largest];
        let mass = scene % system.scene().masses.len();
        let (of, what) = (Of::Mass(mass), shown(&system));
        let features = system.features(None).unwrap();
        for measured in [InvariantQuantity::Amplitude, InvariantQuantity::Fundamental] {
            let found = features.inversions(of, measured, range).unwrap();
            for pair in found.windows(2) {
                assert!(pair[0].to < pair[1].from, "{what}");
            }
            for r in dense(range, 300) {
                let at = system.at(r).unwrap();
                let limit = at.limits();
                let beta = 0.9 * limit.continuous.min(limit.sliding);
                let size = |beta: f64| -> Option<f64> {
                    let motion = at.motion(beta).ok()?;
                    let motion = motion.mass_at(mass)?;
                    Some(match measured {
                        InvariantQuantity::Amplitude => motion.amplitude_monoharmonic(),
                        InvariantQuantity::Fundamental => motion.harmonic(1).norm(),
                    })
                };
                let (Some(with), Some(without)) = (size(beta), size(0.0)) else {
                    continue;
                };
                let growth = (with - without) / without.max(1e-300);
                if growth.abs() < 1e-9 {
                    continue;
                }
                let is_inside = found.iter().any(|found| found.from < r && r < found.to);
                let edges = found.iter().flat_map(|found| [found.from, found.to]);
                let beside = edges.into_iter().any(|edge| (edge / r - 1.0).abs() < 1e-7);
                assert!(
                    beside || is_inside == (growth > 0.0),
                    "{measured:?} of {mass} at {r}: {growth:e}; {found:?}; {what}"
                );
                if is_inside {
                    inside += 1;
                } else {
                    outside += 1;
                }
            }
            for found in &found {
                assert!(found.from_edge != Edge::Range || found.from == range[0]);
            }
        }
    }
    println!("{inside} places inside, {outside} outside");
    assert!(inside > 1_000 && outside > 5_000, "{inside} {outside}");
}

//! Simulates a free vibration with friction.

use super::{NATURAL, Noise};
use std::f64::consts::PI;

/// Returns samples of a free vibration in mm, which starts at 20 mm. Its centre is +F/k and −F/k in turn (4.2).
/// `length` is F/k in mm.
#[must_use]
pub fn decay(length: f64, rate: f64, seconds: f64, noise: &mut Noise) -> Vec<f64> {
    let half = 0.5 / NATURAL;
    let mut samples = Vec::new();
    for index in 0..(rate * seconds) as u32 {
        // The block is held for half a second and then released.
        let since = (f64::from(index) / rate - 0.5).max(0.0);
        let (mut swing, mut extreme) = (0.0, 20.0_f64);
        while swing + 1.0 <= since / half && length < extreme.abs() {
            extreme = 2.0 * length * extreme.signum() - extreme;
            swing += 1.0;
        }
        let centre = length * extreme.signum();
        let moves = length < extreme.abs();
        let x = if moves {
            centre + (extreme - centre) * (PI * (since / half - swing)).cos()
        } else {
            extreme
        };
        samples.push(x + 0.02 * noise.draw());
    }
    samples
}

//! Tests features of random scenes against dense samples.

mod count;
mod damped;
mod inversions;
mod regimes;
mod sums;
mod zeros;

/// Number of samples over a range of r.
const DENSE: usize = 4_000;

/// Returns frequency ratios that are evenly spaced in 1/r, as subharmonics are.
fn dense([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let share = |i: usize| i as f64 / count as f64;
    (0..=count)
        .map(|i| (1.0 / (1.0 / to + (1.0 / from - 1.0 / to) * share(i))).clamp(from, to))
        .rev()
        .collect()
}

//! Invariant points: frequencies at which an amplitude does not depend on friction.

use frictiongen::{Of, System};

/// Returns by how much friction changes the estimated amplitude (5.50) at the frequency ratio r. If the change is
/// positive, the amplitude grows with β.
fn gain(system: &System, of: Of, r: f64) -> Option<f64> {
    let at = system.at(r).ok()?;
    // Half of β_lim keeps the motion continuous. It changes the amplitude by enough for a comparison.
    let beta = 0.5 * at.limits().continuous;
    let estimate = |beta: f64| {
        let motion = at.motion(beta).ok()?;
        Some(motion.motion_of(of)?.amplitude_monoharmonic())
    };
    Some((estimate(beta)? - estimate(0.0)?) / beta)
}

/// Finds the frequency ratios in a range at which the estimated amplitude does not depend on β. They are the roots of
/// (6.10).
pub fn invariant(system: &System, of: Of, (from, to): (f64, f64)) -> Vec<f64> {
    let steps = 1000;
    let place = |i: u32| from + (to - from) * f64::from(i) / f64::from(steps);
    let mut roots = Vec::new();
    for i in 0..steps {
        let (mut low, mut high) = (place(i), place(i + 1));
        let ends = (gain(system, of, low), gain(system, of, high));
        let (Some(left), Some(right)) = ends else {
            continue;
        };
        if (left < 0.0) == (right < 0.0) {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match gain(system, of, middle) {
                Some(value) if (value < 0.0) == (left < 0.0) => low = middle,
                Some(_) => high = middle,
                None => break,
            }
        }
        let root = 0.5 * (low + high);
        // A pole changes the sign too, but is not a root.
        if gain(system, of, root).is_some_and(|value| value.abs() < 1e-6) {
            roots.push(root);
        }
    }
    roots
}

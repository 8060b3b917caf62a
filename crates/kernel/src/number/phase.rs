//! Reduction of phases to one cycle.

use super::scalar::{Float, Scalar};

/// Shifts an angle in rad by one full turn if this shift brings the angle into (−π, π]. The angle must be at most one
/// turn outside this interval.
#[inline]
pub(crate) fn wrapped<S: Scalar>(angle: S) -> S {
    let (pi, turn) = (S::pi(), (S::pi() + S::pi()));
    let angle = S::select(pi.lt(angle), angle - turn, angle).named("phase", "φ, at most π", None);
    S::select((-pi).lt(angle), angle, angle + turn)
}

/// Subtracts all whole cycles from a phase in half-turns (units of π rad). A cycle has two half-turns. The result is in
/// [0, 2], and equals 2 only by rounding.
#[inline]
pub(crate) fn within_cycle<S: Float>(t: S) -> S {
    t - (t * S::constant(0.5)).floor() * S::constant(2.0)
}

#[cfg(test)]
mod tests {
    use super::{within_cycle, wrapped};
    use core::f64::consts::PI;

    #[test]
    fn angles_end_within_half_a_turn() {
        for (angle, expected) in [
            (0.0, 0.0),
            (PI, PI),
            (-PI, PI),
            (-3.0, -3.0),
            (4.0, 4.0 - 2.0 * PI),
            (-4.0, 2.0 * PI - 4.0),
            (3.0 * PI, PI),
            (-9.0, 2.0 * PI - 9.0),
        ] {
            assert!((wrapped(angle) - expected).abs() < 1e-14, "{angle}");
        }
    }

    #[test]
    fn phases_end_within_a_cycle() {
        for (t, expected) in [
            (0.0, 0.0),
            (2.0, 0.0),
            (-0.5, 1.5),
            (7.25, 1.25),
            (-1e-30, 2.0),
        ] {
            assert_eq!(within_cycle(t), expected, "{t}");
        }
    }
}

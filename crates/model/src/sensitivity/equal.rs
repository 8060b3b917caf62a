//! Chooses a basis for modes with equal frequencies. The chosen basis changes smoothly if the scene changes.

use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;

/// Two modes count as equal in frequency if their resonances √λ differ by at most this fraction of their sum.
const EQUAL: f64 = 1e-24;

/// Upper bound on the number of sweeps of Jacobi rotations in a group of equal modes. Each sweep squares the remaining
/// coupling.
const MAX_SWEEPS: usize = 30;

pub(super) fn equal(a: Dd, b: Dd) -> bool {
    (a - b).abs() <= Dd::from(EQUAL) * (a + b)
}

/// Rotates each group of modes with equal frequencies to the basis in which the change of the scene does not couple
/// these modes. Every basis of the group is valid, but only this basis changes smoothly with the scene.
///
/// Returns one flag for each mode, which is true if the function rotated the mode.
pub(super) fn adapt_equal_modes(
    matrix: &mut [Vec<Dd>],
    shapes: &mut [Vec<Dd>],
    resonances: &[Dd],
) -> Vec<bool> {
    let n = resonances.len();
    let mut which = vec![false; n];
    let at = |matrix: &[Vec<Dd>], i: usize, j: usize| {
        matrix
            .get(i)
            .and_then(|row| row.get(j))
            .copied()
            .unwrap_or_default()
    };
    for _ in 0..MAX_SWEEPS {
        let mut turned = false;
        for right in 1..n {
            for left in 0..right {
                let pair = [left, right].map(|k| resonances.get(k).copied().unwrap_or_default());
                let (a, b, c) = (
                    at(matrix, left, left),
                    at(matrix, right, right),
                    at(matrix, left, right),
                );
                if !equal(pair[0], pair[1]) || c.abs() <= Dd::from(1e-29) * (a.abs() + b.abs()) {
                    continue;
                }
                let one = Dd::from(1.0);
                let zeta = (b - a) / (c + c);
                let t = one / (zeta.abs() + (one + zeta * zeta).sqrt());
                let t = t.copysign(zeta);
                let cosine = one / (one + t * t).sqrt();
                let sine = cosine * t;
                turn(shapes, left, right, cosine, sine);
                turn(matrix, left, right, cosine, sine);
                for row in matrix.iter_mut() {
                    let pair = (row.get(left).copied(), row.get(right).copied());
                    if let (Some(a), Some(b)) = pair {
                        row.splice(left..=left, [cosine * a - sine * b]);
                        row.splice(right..=right, [sine * a + cosine * b]);
                    }
                }
                turned = true;
                for (place, which) in which.iter_mut().enumerate() {
                    *which |= place == left || place == right;
                }
            }
        }
        if !turned {
            break;
        }
    }
    which
}

/// Rotates two rows in the plane that they span.
fn turn(rows: &mut [Vec<Dd>], left: usize, right: usize, cosine: Dd, sine: Dd) {
    let (head, tail) = rows.split_at_mut(right);
    if let (Some(a), Some(b)) = (head.get_mut(left), tail.first_mut()) {
        for (a, b) in a.iter_mut().zip(b) {
            (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
        }
    }
}

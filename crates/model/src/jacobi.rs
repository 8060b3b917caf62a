//! One-sided Jacobi method: singular values and right singular vectors of a matrix, in double-double.
//!
//! The natural frequencies are the singular values of G = diag(√κ)·E·diag(1/√γ). E is the incidence matrix of the
//! springs. The Jacobi method on the columns of G computes every natural frequency to full relative accuracy, for any
//! spread of masses and stiffnesses. An eigensolver on K̄ = GᵀG loses the small frequencies.

use frictiongen_kernel::number::dd::Dd;

/// A matrix, stored as a list of columns.
pub type ColumnMatrix = Vec<Vec<Dd>>;

/// Largest |cosine| of the angle between two columns that count as orthogonal.
const ORTHOGONAL: f64 = 1e-30;
/// Upper bound on the number of sweeps. The method converges quadratically and needs far fewer. The bound only
/// prevents an endless loop.
const MAX_SWEEPS: usize = 60;

/// Returns the scalar product of two vectors.
pub fn dot(a: &[Dd], b: &[Dd]) -> Dd {
    a.iter()
        .zip(b)
        .fold(Dd::from(0.0), |sum, (a, b)| sum + *a * *b)
}

/// Returns the singular values of a matrix in ascending order, and its right singular vectors as columns.
pub fn singular(mut g: ColumnMatrix) -> (Vec<Dd>, ColumnMatrix) {
    let n = g.len();
    let (zero, one) = (Dd::from(0.0), Dd::from(1.0));
    let mut v: ColumnMatrix = (0..n)
        .map(|i| (0..n).map(|j| if i == j { one } else { zero }).collect())
        .collect();
    // With the large columns first, the rotations among the columns with small singular values stay small.
    let mut norms: Vec<Dd> = g.iter().map(|column| dot(column, column)).collect();
    sort(&mut g, &mut v, &mut norms, |a, b| b < a);
    for _ in 0..MAX_SWEEPS {
        let mut rotated = false;
        for right in 1..n {
            for left in 0..right {
                rotated |= rotate(&mut g, &mut v, left, right);
            }
        }
        if !rotated {
            break;
        }
    }
    norms = g.iter().map(|column| dot(column, column).sqrt()).collect();
    sort(&mut g, &mut v, &mut norms, |a, b| a < b);
    (norms, v)
}

/// Rotates two columns to make them orthogonal. Returns false if the columns are orthogonal already.
fn rotate(g: &mut ColumnMatrix, v: &mut ColumnMatrix, left: usize, right: usize) -> bool {
    let (Some(a), Some(b)) = (g.get(left), g.get(right)) else {
        return false;
    };
    let (aa, bb, ab) = (dot(a, a), dot(b, b), dot(a, b));
    let limit = (aa * bb).sqrt() * Dd::from(ORTHOGONAL);
    if ab.abs() <= limit {
        return false;
    }
    let one = Dd::from(1.0);
    let zeta = (bb - aa) / (ab + ab);
    let magnitude = one / (zeta.abs() + (one + zeta * zeta).sqrt());
    let t = if zeta < Dd::from(0.0) {
        -magnitude
    } else {
        magnitude
    };
    let c = one / (one + t * t).sqrt();
    let s = c * t;
    turn(g, left, right, c, s);
    turn(v, left, right, c, s);
    true
}

fn turn(columns: &mut ColumnMatrix, left: usize, right: usize, c: Dd, s: Dd) {
    let (head, tail) = columns.split_at_mut(right);
    if let (Some(a), Some(b)) = (head.get_mut(left), tail.first_mut()) {
        for (a, b) in a.iter_mut().zip(b) {
            (*a, *b) = (c * *a - s * *b, s * *a + c * *b);
        }
    }
}

/// Sorts the columns of `g` and `v` by the norms of the columns of `g`. The sort is a stable insertion sort.
fn sort(
    g: &mut ColumnMatrix,
    v: &mut ColumnMatrix,
    norms: &mut [Dd],
    before: impl Fn(Dd, Dd) -> bool,
) {
    for end in 1..norms.len() {
        let mut at = end;
        while let (Some(here), Some(previous)) = (
            norms.get(at).copied(),
            at.checked_sub(1).and_then(|p| norms.get(p).copied()),
        ) {
            if !before(here, previous) {
                break;
            }
            norms.swap(at, at - 1);
            g.swap(at, at - 1);
            v.swap(at, at - 1);
            at -= 1;
        }
    }
}

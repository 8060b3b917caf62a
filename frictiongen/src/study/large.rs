//! Modal analysis of large scenes by nalgebra's symmetric eigensolver, followed by one-sided Jacobi sweeps.
//!
//! Let G be the matrix whose singular values are the frequency ratios √λ, and V the eigenvectors of GᵀG = Γ^−½K̄Γ^−½.
//! The product GᵀG loses digits, especially those of a low frequency next to high frequencies. Apart from these digits,
//! the columns of G·V are orthogonal. One or two sweeps of one-sided Jacobi rotations on these columns, in double
//! precision, restore the digits.

use frictiongen_model::modal::Modal;
use frictiongen_model::scene::Scene;
use nalgebra::DMatrix;

/// Largest number of masses for which the modal analysis is in double-double arithmetic.
pub(super) const LARGEST_EXACT: usize = 64;
/// Limit of rounding errors in modal values, for example in the components of mode shapes. The limit is relative to
/// the largest value that the modal value can have. A modal value below the limit becomes 0.
const NOISE: f64 = 1e-13;
/// Largest cosine of the angle between two columns of a matrix at which the two columns are treated as orthogonal.
const ORTHOGONAL: f64 = 1e-15;
/// Largest number of Jacobi sweeps. A sweep rotates each pair of columns once.
const MAX_SWEEPS: usize = 12;

/// Returns the modal analysis of a scene with any number of masses.
pub(super) fn modal(scene: &Scene) -> Modal {
    if scene.masses.len() <= LARGEST_EXACT {
        return Modal::of(scene);
    }
    Modal::solved_by(scene, NOISE, singular)
}

/// Returns the singular values of the matrix G in ascending order, and its right singular vectors. `g` lists the
/// columns of G.
pub(super) fn singular(g: &[Vec<f64>]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let n = g.len();
    let rows = g.first().map_or(0, Vec::len);
    let g = DMatrix::from_iterator(rows, n, g.iter().flatten().copied());
    let eigen = (g.transpose() * &g).symmetric_eigen();
    let vectors = eigen.eigenvectors;
    let turned = &g * &vectors;
    let columns = |matrix: &DMatrix<f64>| -> Vec<Vec<f64>> {
        matrix
            .column_iter()
            .map(|column| column.iter().copied().collect())
            .collect()
    };
    let (mut turned, mut vectors) = (columns(&turned), columns(&vectors));
    for _ in 0..MAX_SWEEPS {
        if !sweep(&mut turned, &mut vectors) {
            break;
        }
    }
    let mut pairs: Vec<(f64, Vec<f64>)> = turned
        .iter()
        .map(|column| dot(column, column).sqrt())
        .zip(vectors)
        .collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    pairs.into_iter().unzip()
}

/// Rotates each pair of columns once, so that the two columns become orthogonal. Returns false if all pairs were
/// orthogonal already.
fn sweep(turned: &mut [Vec<f64>], vectors: &mut [Vec<f64>]) -> bool {
    let mut squares: Vec<f64> = turned.iter().map(|column| dot(column, column)).collect();
    let mut rotated = false;
    for right in 1..turned.len() {
        let (left_turned, right_turned) = turned.split_at_mut(right);
        let (left_vectors, right_vectors) = vectors.split_at_mut(right);
        let (left_squares, right_squares) = squares.split_at_mut(right);
        let (Some(b), Some(vb), Some(bb)) = (
            right_turned.first_mut(),
            right_vectors.first_mut(),
            right_squares.first_mut(),
        ) else {
            return rotated;
        };
        for ((a, va), aa) in left_turned.iter_mut().zip(left_vectors).zip(left_squares) {
            let ab = dot(a, b);
            if ab.abs() <= (*aa * *bb).sqrt() * ORTHOGONAL {
                continue;
            }
            rotated = true;
            let zeta = (*bb - *aa) / (2.0 * ab);
            let t = (1.0 / (zeta.abs() + zeta.hypot(1.0))).copysign(zeta);
            let c = 1.0 / t.hypot(1.0);
            turn(a, b, c, c * t);
            turn(va, vb, c, c * t);
            (*aa, *bb) = (dot(a, a), dot(b, b));
        }
    }
    rotated
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    // The processor adds to eight independent sums in parallel. In a single sum, each addition would wait for the
    // previous addition.
    let mut sums = [0.0; 8];
    let (chunks_a, chunks_b) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest = chunks_a
        .remainder()
        .iter()
        .zip(chunks_b.remainder())
        .map(|(a, b)| a * b)
        .sum::<f64>();
    for (a, b) in chunks_a.zip(chunks_b) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    rest + sums.iter().sum::<f64>()
}

fn turn(a: &mut [f64], b: &mut [f64], c: f64, s: f64) {
    for (a, b) in a.iter_mut().zip(b) {
        (*a, *b) = (c * *a - s * *b, s * *a + c * *b);
    }
}

//! Finds the shortest solution of linear equations whose matrix may be singular.

use super::size::{add, at, set};
use crate::{Float, Scalar};

/// Largest number of sweeps over all pairs of columns. Each sweep squares the cosines of the angles between the
/// columns, so that a few sweeps are enough.
const SWEEPS: usize = 40;

/// Solves A x = b. If A is singular, x is the shortest solution. This solution has no component in a direction whose
/// singular value is at most `rank`. A is square and stored column by column. The function overwrites A. `turns` is
/// working memory for a matrix of the same size.
///
/// Rotations of pairs of columns make all columns orthogonal (one-sided Jacobi method). The singular values are then
/// the lengths of the columns.
pub(super) fn solve<S: Float>(columns: &mut [S], turns: &mut [S], b: &[S], rank: S, x: &mut [S]) {
    let count = b.len();
    for (index, entry) in turns.iter_mut().enumerate() {
        let diagonal = count > 0 && index / count == index % count;
        *entry = S::whole(usize::from(diagonal));
    }
    for _ in 0..SWEEPS {
        if !sweep(columns, turns, count) {
            break;
        }
    }
    x.fill(S::constant(0.0));
    let size = count.max(1);
    for (column, turn) in columns.chunks_exact(size).zip(turns.chunks_exact(size)) {
        let square = dot(column, column);
        if square.sqrt() <= rank {
            continue;
        }
        let part = dot(column, b) / square;
        for (row, turn) in turn.iter().enumerate() {
            add(x, row, part * *turn);
        }
    }
}

/// Rotates each pair of columns once, so that the two columns become orthogonal. Returns false if all pairs were
/// already orthogonal.
fn sweep<S: Float>(columns: &mut [S], turns: &mut [S], count: usize) -> bool {
    let mut rotated = false;
    for second in 1..count {
        for first in 0..second {
            let Some((one, other)) = pair(columns, count, (first, second)) else {
                continue;
            };
            let (alpha, beta, gamma) = (dot(one, one), dot(other, other), dot(one, other));
            let small = S::constant(S::EPSILON) * alpha.sqrt() * beta.sqrt();
            // This form of the comparison is also true for NaN.
            if !(gamma.abs() > small) {
                continue;
            }
            rotated = true;
            let one_ = S::constant(1.0);
            let zeta = (beta - alpha) / (S::constant(2.0) * gamma);
            let tangent = (one_ / (zeta.abs() + (one_ + zeta * zeta).sqrt())).copysign(zeta);
            let cosine = one_ / (one_ + tangent * tangent).sqrt();
            let sine = cosine * tangent;
            rotate(one, other, (cosine, sine));
            if let Some((one, other)) = pair(turns, count, (first, second)) {
                rotate(one, other, (cosine, sine));
            }
        }
    }
    rotated
}

/// Returns two columns of a matrix as mutable slices.
fn pair<S>(
    columns: &mut [S],
    count: usize,
    (first, second): (usize, usize),
) -> Option<(&mut [S], &mut [S])> {
    let (head, tail) = columns.split_at_mut_checked(second * count)?;
    let one = head.get_mut(first * count..)?.get_mut(..count)?;
    Some((one, tail.get_mut(..count)?))
}

/// Rotates two columns in the plane that they span. `cosine` and `sine` belong to the angle of the rotation.
fn rotate<S: Float>(one: &mut [S], other: &mut [S], (cosine, sine): (S, S)) {
    for (a, b) in one.iter_mut().zip(other) {
        (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
    }
}

/// Returns the sum of the products of corresponding entries.
pub(super) fn dot<S: Float>(a: &[S], b: &[S]) -> S {
    let products = a.iter().zip(b);
    products.fold(S::constant(0.0), |sum, (a, b)| sum + *a * *b)
}

/// Sorts `values` in the order of increasing `key`.
pub(super) fn sort_by<T: Copy, S: Float>(values: &mut [T], key: impl Fn(&T) -> S) {
    for end in 1..values.len() {
        for place in (1..=end).rev() {
            let (Some(&low), Some(&high)) = (values.get(place - 1), values.get(place)) else {
                break;
            };
            if key(&low) <= key(&high) {
                break;
            }
            set(values, place - 1, high);
            set(values, place, low);
        }
    }
}

/// Returns the largest absolute difference between corresponding entries of two slices.
pub(super) fn apart<S: Float>(a: &[S], b: &[S]) -> S {
    let mut largest = S::constant(0.0);
    for (index, a) in a.iter().enumerate() {
        largest = Scalar::max(largest, (*a - at(b, index)).abs());
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::solve;
    use fuzzing::Random;

    /// Multiplies the square matrix `matrix` by the vector `x`.
    fn image(matrix: &[f64], x: &[f64]) -> Vec<f64> {
        let n = x.len();
        let row = |row: usize| {
            (0..n)
                .map(|column| matrix[column * n + row] * x[column])
                .sum()
        };
        (0..n).map(row).collect()
    }

    /// Checks that the solution satisfies the equations, and that it is orthogonal to its difference from another
    /// solution. The matrix is a sum of `rank` products of vectors.
    #[test]
    fn the_solution_fits_and_is_the_shortest() {
        let mut random = Random(11);
        for (n, rank) in [(1, 1), (2, 1), (5, 5), (6, 3), (16, 12), (24, 24)] {
            let mut draw = |count: usize| -> Vec<Vec<f64>> {
                let vector = |random: &mut Random| (0..n).map(|_| random.signed()).collect();
                (0..count).map(|_| vector(&mut random)).collect()
            };
            let (left, right) = (draw(rank), draw(rank));
            let mut matrix = vec![0.0; n * n];
            for (left, right) in left.iter().zip(&right) {
                for column in 0..n {
                    for row in 0..n {
                        matrix[column * n + row] += left[row] * right[column];
                    }
                }
            }
            let some = draw(1).remove(0);
            let b = image(&matrix, &some);
            let (mut work, mut turns, mut x) = (matrix.clone(), matrix.clone(), vec![0.0; n]);
            solve(&mut work, &mut turns, &b, 1e-9, &mut x);
            for (got, want) in image(&matrix, &x).iter().zip(&b) {
                // The condition number of these random factors is below 1e4.
                assert!((got - want).abs() < 1e-10, "{n} {rank}: {got} {want}");
            }
            // The matrix maps the difference of two solutions to 0. The shortest solution is orthogonal to this
            // difference.
            let other = some.iter().zip(&x).map(|(some, x)| some - x);
            let product: f64 = other.zip(&x).map(|(other, x)| other * x).sum();
            assert!(product.abs() < 1e-9, "{n} {rank}: {product}");
        }
    }
}

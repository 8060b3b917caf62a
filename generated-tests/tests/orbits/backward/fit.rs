//! Finds the smallest displacement of the inputs for which all answers at a point are exact.

use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;

/// Largest number of times that the fit changes its weights.
const ROUNDS: usize = 60;
/// Number of weight changes in plain double precision. At most points they are enough.
const QUICK_ROUNDS: usize = 4;
/// Number of weight changes if the result of the fit exceeds the accepted error by the factor `FAR`. The equations
/// then do not yet belong to the right displacement, so more weight changes would be wasted.
const FAR_ROUNDS: usize = 4;
const FAR: f64 = 100.0;
/// Fraction of the accepted error below which a fit is not improved further.
const ENOUGH: f64 = 0.25;
/// Smallest weight, as a fraction of the largest weight. A weight of zero could not grow.
const FAINT: f64 = 1e-9;

/// Returns the smallest k that the fit finds such that some displacements δ of the inputs with |δ_j| ≤ k leave every
/// residual |b_i − Σ a_ij δ_j| at most k. The fit stops at a k well below the accepted error `bar`.
///
/// It is a Chebyshev fit by Lawson's iteration, which is weighted least squares whose weights grow with the residuals.
/// Every δ proves its own k, so the result is an upper bound.
pub fn fit(a: &[Vec<Dd>], b: &[Dd], bar: f64) -> f64 {
    let plain: Vec<Vec<f64>> = a.iter().map(|row| to_f64(row)).collect();
    let quick = lawson(a, b, bar, QUICK_ROUNDS, |b, inputs, answers| {
        // A second solution, with the residuals of the first solution as right-hand side, removes the rounding errors
        // of the first solution.
        let moved = shortest(&plain, &to_f64(b), inputs, answers)?;
        let more = shortest(&plain, &left(a, b, &moved), inputs, answers)?;
        Some(
            moved
                .iter()
                .zip(&more)
                .map(|(moved, more)| moved + more)
                .collect(),
        )
    });
    if quick <= ENOUGH * bar {
        return quick;
    }
    quick.min(lawson(a, b, bar, ROUNDS, |b, inputs, answers| {
        let moved = shortest(a, b, inputs, answers)?;
        Some(to_f64(&moved))
    }))
}

/// Runs Lawson's iteration. `shortest` returns the δ for given weights.
fn lawson(
    a: &[Vec<Dd>],
    b: &[Dd],
    bar: f64,
    rounds: usize,
    shortest: impl Fn(&[Dd], &[f64], &[f64]) -> Option<Vec<f64>>,
) -> f64 {
    let inputs = a.first().map_or(0, Vec::len);
    let mut best = worst(to_f64(b).into_iter());
    let mut input_weights = vec![1.0; inputs];
    let mut answer_weights = vec![1.0; b.len()];
    for round in 0..rounds {
        let hopeless = round >= FAR_ROUNDS && best > FAR * bar && bar > 0.0;
        if best <= ENOUGH * bar || hopeless {
            break;
        }
        let Some(moved) = shortest(b, &input_weights, &answer_weights) else {
            break;
        };
        let left = left(a, b, &moved);
        let roundings = worst(moved.iter().chain(&left).copied());
        best = best.min(roundings);
        let of_largest = |value: f64| (value.abs() / roundings).max(FAINT);
        let weights = input_weights.iter_mut().chain(&mut answer_weights);
        for (weight, value) in weights.zip(moved.iter().chain(&left)) {
            *weight *= of_largest(*value);
        }
        let all = || input_weights.iter().chain(&answer_weights);
        let largest = all().fold(0.0, |most: f64, weight| most.max(*weight));
        for weight in input_weights.iter_mut().chain(&mut answer_weights) {
            *weight = (*weight / largest).max(FAINT);
        }
    }
    best
}

fn to_f64(values: &[Dd]) -> Vec<f64> {
    values.iter().map(|value| value.to_f64()).collect()
}

/// Returns the residuals b − aδ.
fn left(a: &[Vec<Dd>], b: &[Dd], moved: &[f64]) -> Vec<f64> {
    let left = a.iter().zip(b).map(|(row, b)| {
        let moves = row.iter().zip(moved);
        moves
            .fold(*b, |left, (a, moved)| left - *a * Dd::from(*moved))
            .to_f64()
    });
    left.collect()
}

/// Returns the largest absolute value, or infinity if any value is NaN.
fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |most: f64, value| {
        if value.is_nan() {
            f64::INFINITY
        } else {
            most.max(value.abs())
        }
    })
}

/// Returns the δ that minimises Σ w_j δ_j² + Σ v_i (b_i − a_i·δ)². The solution uses orthogonal columns, so it does
/// not square the condition number. Answers near a pole change by 10¹⁶ times the relative change of an input.
pub fn shortest<S: Float>(
    a: &[Vec<S>],
    b: &[S],
    input_weights: &[f64],
    answer_weights: &[f64],
) -> Option<Vec<S>> {
    let root = |weight: &f64| S::constant(*weight).sqrt();
    let inputs: Vec<S> = input_weights.iter().map(root).collect();
    let answers: Vec<S> = answer_weights.iter().map(root).collect();
    let zero = S::constant(0.0);
    if inputs.len() < answers.len() {
        // The least-squares system is (√v a, √w) δ ≈ (√v b, 0).
        let columns = (0..inputs.len()).map(|j| {
            let weighted = a.iter().zip(&answers);
            let mut column: Vec<S> = weighted.map(|(row, root)| row[j] * *root).collect();
            column.resize(answers.len() + inputs.len(), zero);
            column[answers.len() + j] = inputs[j];
            column
        });
        let mut aim: Vec<S> = b.iter().zip(&answers).map(|(b, root)| *b * *root).collect();
        aim.resize(answers.len() + inputs.len(), zero);
        let [q, r] = orthogonal(columns)?;
        let mut moved = vec![zero; inputs.len()];
        for j in (0..inputs.len()).rev() {
            // The part of the right-hand side that this column does not explain remains for the next columns.
            let along = dot(&q[j], &aim);
            for (value, q) in aim.iter_mut().zip(&q[j]) {
                *value = *value - along * *q;
            }
            moved[j] = along;
        }
        for j in (0..inputs.len()).rev() {
            let others = (j + 1..inputs.len()).map(|k| r[k][j] * moved[k]);
            moved[j] = others.fold(moved[j], |sum, other| sum - other) / r[j][j];
        }
        return Some(moved);
    }
    // The unknown is the shortest z with Mᵀz = b. Its elements are √w δ and √v times the residuals. Column i of M
    // belongs to answer i, and contains the a_ij/√w_j and 1/√v_i.
    let columns = a.iter().zip(&answers).enumerate().map(|(i, (row, root))| {
        let mut column: Vec<S> = row.iter().zip(&inputs).map(|(a, w)| *a / *w).collect();
        column.resize(inputs.len() + answers.len(), zero);
        column[inputs.len() + i] = S::constant(1.0) / *root;
        column
    });
    let [q, r] = orthogonal(columns)?;
    let mut z = vec![zero; inputs.len()];
    let mut along = Vec::new();
    for ((b, q), r) in b.iter().zip(&q).zip(&r) {
        let rest = dot(&r[..along.len()], &along);
        along.push((*b - rest) / r[along.len()]);
        for (z, q) in z.iter_mut().zip(q) {
            *z = *z + along[along.len() - 1] * *q;
        }
    }
    Some(z.iter().zip(&inputs).map(|(z, w)| *z / *w).collect())
}

fn dot<S: Float>(a: &[S], b: &[S]) -> S {
    let products = a.iter().zip(b);
    products.fold(S::constant(0.0), |sum, (a, b)| sum + *a * *b)
}

/// Returns orthonormal columns, and the coefficients of each given column in them, by modified Gram-Schmidt.
fn orthogonal<S: Float>(columns: impl Iterator<Item = Vec<S>>) -> Option<[Vec<Vec<S>>; 2]> {
    let (mut all, mut parts): (Vec<Vec<S>>, Vec<Vec<S>>) = (Vec::new(), Vec::new());
    for mut column in columns {
        let mut part = Vec::new();
        for q in &all {
            let along = dot(q, &column);
            for (value, q) in column.iter_mut().zip(q) {
                *value = *value - along * *q;
            }
            part.push(along);
        }
        let length = dot(&column, &column).sqrt();
        if !(length.to_f64() > 0.0) {
            return None;
        }
        let inverse = S::constant(1.0) / length;
        column
            .iter_mut()
            .for_each(|value| *value = *value * inverse);
        part.push(length);
        all.push(column);
        parts.push(part);
    }
    Some([all, parts])
}

/// Checks that one input does not explain two answers that it changes in the same way, if their errors have opposite
/// signs.
#[test]
fn nothing_is_explained_twice() {
    let dd = Dd::from;
    let a = [vec![dd(1e6)], vec![dd(1e6)]];
    let alike = fit(&a, &[dd(1e6), dd(1e6)], 0.0);
    assert!((alike - 1.0).abs() < 1e-3, "{alike:?}");
    let opposite = fit(&a, &[dd(1e6), dd(-1e6)], 0.0);
    assert!(opposite > 0.99e6, "{opposite:?}");
}

/// Checks that for one answer the fit gives k = |b|/(1 + Σ|a|), which was derived by hand.
#[test]
fn one_answer() {
    let dd = Dd::from;
    let found = fit(&[vec![dd(3.0), dd(-6.0)]], &[dd(100.0)], 0.0);
    assert!((found - 10.0).abs() < 1e-3, "{found:?}");
}

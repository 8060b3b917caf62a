//! The smallest displacement of the inputs that explains all answers of a place at once.

use frictiongen_kernel::dd::Dd;

/// So often are the weights changed.
const ROUNDS: usize = 60;
/// So often where the bar is far away, and by how much: there the equations are not yet those of the right place.
const FAR_ROUNDS: usize = 4;
const FAR: f64 = 100.0;
/// A fit that keeps this part of the bar is not improved.
const ENOUGH: f64 = 0.25;
/// No weight is less than this share of the largest: what carries none could not come back.
const FAINT: f64 = 1e-9;

/// The smallest k found such that some inputs δ with |δ_j| ≤ k leave |b_i − Σ a_ij δ_j| ≤ k, up to one that is
/// well below the bar: a Chebyshev fit by Lawson's iteration, weighted least squares whose weights grow with what they leave.
/// Every δ proves its own k, so that what is found is an upper bound.
pub fn fit(a: &[Vec<Dd>], b: &[Dd], bar: f64) -> f64 {
    let inputs = a.first().map_or(0, Vec::len);
    let mut best = worst(b.iter().map(|b| b.to_f64()));
    let mut input_weights = vec![1.0; inputs];
    let mut answer_weights = vec![1.0; b.len()];
    for round in 0..ROUNDS {
        let hopeless = round >= FAR_ROUNDS && best > FAR * bar && bar > 0.0;
        if best <= ENOUGH * bar || hopeless {
            break;
        }
        let Some((moved, left)) = least_squares(a, b, &input_weights, &answer_weights) else {
            break;
        };
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

/// The largest modulus; infinite if any is NaN.
fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |most: f64, value| {
        if value.is_nan() {
            f64::INFINITY
        } else {
            most.max(value.abs())
        }
    })
}

/// min Σ w_j δ_j² + Σ v_i (b_i − a_i·δ)²: the shortest z with Mᵀz = b, where z is √w δ and √v times what is left, and
/// a column of M is an answer's a_ij/√w_j and 1/√v_i.  By M = QR, whose condition is not squared: answers beside a pole
/// move by 10¹⁶ of what they differ by.
pub fn least_squares(
    a: &[Vec<Dd>],
    b: &[Dd],
    input_weights: &[f64],
    answer_weights: &[f64],
) -> Option<(Vec<f64>, Vec<f64>)> {
    let zero = Dd::from(0.0);
    let inputs = input_weights.len();
    let roots: Vec<Dd> = input_weights.iter().map(|w| Dd::from(*w).sqrt()).collect();
    let dot = |a: &[Dd], b: &[Dd]| {
        let products = a.iter().zip(b);
        products.fold(zero, |sum, (a, b)| sum + *a * *b)
    };
    let mut q: Vec<Vec<Dd>> = Vec::new();
    let mut z = vec![zero; inputs + b.len()];
    let mut y: Vec<Dd> = Vec::new();
    for (i, (row, b)) in a.iter().zip(b).enumerate() {
        let mut column: Vec<Dd> = row.iter().zip(&roots).map(|(a, w)| *a / *w).collect();
        column.resize(inputs + i, zero);
        column.push(Dd::from(1.0) / Dd::from(answer_weights[i]).sqrt());
        let mut rest = *b;
        for (q, y) in q.iter().zip(&y) {
            let along = dot(q, &column);
            for (value, q) in column.iter_mut().zip(q) {
                *value = *value - along * *q;
            }
            rest = rest - along * *y;
        }
        let length = dot(&column, &column).sqrt();
        if !(length.to_f64() > 0.0) {
            return None;
        }
        column.iter_mut().for_each(|value| *value = *value / length);
        let y_here = rest / length;
        for (z, q) in z.iter_mut().zip(&column) {
            *z = *z + y_here * *q;
        }
        y.push(y_here);
        q.push(column);
    }
    let moved: Vec<Dd> = z.iter().zip(&roots).map(|(z, w)| *z / *w).collect();
    // What is left of δ itself, whatever the iteration has lost.
    let left = a
        .iter()
        .zip(b)
        .map(|(row, b)| (*b - dot(row, &moved)).to_f64());
    Some((
        moved.iter().map(|moved| moved.to_f64()).collect(),
        left.collect(),
    ))
}

/// Two answers that one input moves the same way and that are off by opposite amounts are not explained by it.
#[test]
fn nothing_is_explained_twice() {
    let dd = Dd::from;
    let a = [vec![dd(1e6)], vec![dd(1e6)]];
    let alike = fit(&a, &[dd(1e6), dd(1e6)], 0.0);
    assert!((alike - 1.0).abs() < 1e-3, "{alike:?}");
    let opposite = fit(&a, &[dd(1e6), dd(-1e6)], 0.0);
    assert!(opposite > 0.99e6, "{opposite:?}");
}

/// k = |b|/(1 + Σ|a|) for one answer, by hand.
#[test]
fn one_answer() {
    let dd = Dd::from;
    let found = fit(&[vec![dd(3.0), dd(-6.0)]], &[dd(100.0)], 0.0);
    assert!((found - 10.0).abs() < 1e-3, "{found:?}");
}

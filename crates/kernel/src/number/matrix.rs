//! Small square matrices, stored in a slice column by column. The module solves linear equations and computes
//! eigenvalues.

use crate::number::complex::Complex;
use crate::number::scalar::Float;

/// A square matrix in a slice, stored column by column.
pub(crate) struct SquareMatrix<'a, S> {
    entries: &'a mut [S],
    size: usize,
}

impl<'a, S: Float> SquareMatrix<'a, S> {
    /// Creates a matrix from the first size² entries of a slice.
    pub(crate) fn new(entries: &'a mut [S], size: usize) -> Self {
        Self { entries, size }
    }

    fn at(&self, row: usize, column: usize) -> S {
        let entry = self.entries.get(column * self.size + row);
        entry.copied().unwrap_or(S::constant(0.0))
    }

    fn set(&mut self, row: usize, column: usize, value: S) {
        if let Some(entry) = self.entries.get_mut(column * self.size + row) {
            *entry = value;
        }
    }

    fn swap_rows(&mut self, a: usize, b: usize, from: usize) {
        for column in from..self.size {
            let (left, right) = (self.at(a, column), self.at(b, column));
            self.set(a, column, right);
            self.set(b, column, left);
        }
    }

    /// Solves the linear equations (shift·1 − M)x = b, where M is this matrix and 1 the identity matrix. The solution x
    /// replaces `b`, and the elimination overwrites the matrix. Returns false if the matrix shift·1 − M is singular.
    pub(crate) fn solve_shifted(&mut self, shift: S, b: &mut [S]) -> bool {
        let n = self.size;
        for column in 0..n {
            for row in 0..n {
                let own = if row == column {
                    shift
                } else {
                    S::constant(0.0)
                };
                self.set(row, column, own - self.at(row, column));
            }
        }
        for k in 0..n {
            let mut pivot = k;
            for row in k + 1..n {
                if self.at(pivot, k).abs() < self.at(row, k).abs() {
                    pivot = row;
                }
            }
            if self.at(pivot, k).is_zero() || !self.at(pivot, k).is_finite() {
                return false;
            }
            if pivot != k {
                self.swap_rows(pivot, k, k);
                let (one, other) = (value(b, pivot), value(b, k));
                give(b, pivot, other);
                give(b, k, one);
            }
            let (diagonal, own) = (self.at(k, k), value(b, k));
            for row in k + 1..n {
                let factor = self.at(row, k) / diagonal;
                if factor.is_zero() {
                    continue;
                }
                for column in k + 1..n {
                    let reduced = self.at(row, column) - factor * self.at(k, column);
                    self.set(row, column, reduced);
                }
                if let Some(b) = b.get_mut(row) {
                    *b = *b - factor * own;
                }
            }
        }
        for k in (0..n).rev() {
            let mut sum = value(b, k);
            for column in k + 1..n {
                sum = sum - self.at(k, column) * value(b, column);
            }
            if let Some(b) = b.get_mut(k) {
                *b = sum / self.at(k, k);
            }
        }
        true
    }

    /// Computes the eigenvalues, writes them to `out`, and overwrites the matrix. The method first reduces the matrix
    /// to Hessenberg form by elimination, and then applies the double-shift QR iteration of Francis.
    pub(crate) fn eigenvalues(&mut self, out: &mut [Complex<S>]) {
        self.reduce();
        let mut end = self.size;
        let mut rounds = 0;
        while end > 0 {
            let start = self.last_block(end);
            if start + 1 == end {
                put(
                    out,
                    end - 1,
                    Complex::new(self.at(end - 1, end - 1), S::constant(0.0)),
                );
                (end, rounds) = (end - 1, 0);
            } else if start + 2 == end || rounds >= 60 {
                // No matrix is known that needs sixty iterations. After sixty iterations, the code accepts the
                // eigenvalues of the last 2 × 2 block as they are.
                let (first, second) = self.pair(end - 2);
                put(out, end - 2, first);
                put(out, end - 1, second);
                (end, rounds) = (end - 2, 0);
            } else {
                self.francis(start, end, rounds);
                rounds += 1;
            }
        }
    }

    fn reduce(&mut self) {
        let n = self.size;
        for k in 1..n.saturating_sub(1) {
            let mut pivot = k;
            for row in k..n {
                if self.at(pivot, k - 1).abs() < self.at(row, k - 1).abs() {
                    pivot = row;
                }
            }
            let top = self.at(pivot, k - 1);
            if top.is_zero() {
                continue;
            }
            if pivot != k {
                self.swap_rows(pivot, k, k - 1);
                for row in 0..n {
                    let (left, right) = (self.at(row, pivot), self.at(row, k));
                    self.set(row, pivot, right);
                    self.set(row, k, left);
                }
            }
            for row in k + 1..n {
                let factor = self.at(row, k - 1) / top;
                if factor.is_zero() {
                    continue;
                }
                self.set(row, k - 1, S::constant(0.0));
                for column in k..n {
                    let reduced = self.at(row, column) - factor * self.at(k, column);
                    self.set(row, column, reduced);
                }
                for other in 0..n {
                    let grown = self.at(other, k) + factor * self.at(other, row);
                    self.set(other, k, grown);
                }
            }
        }
    }

    /// Returns the first row of the diagonal block whose last row is `end` − 1. A negligible subdiagonal entry
    /// separates the block from the rows before it.
    fn last_block(&mut self, end: usize) -> usize {
        for k in (1..end).rev() {
            let size = self.at(k - 1, k - 1).abs() + self.at(k, k).abs();
            let small = S::constant(S::EPSILON) * size;
            let entry = self.at(k, k - 1).abs();
            if entry <= small || entry.is_zero() {
                self.set(k, k - 1, S::constant(0.0));
                return k;
            }
        }
        0
    }

    /// Returns the two eigenvalues of the 2 × 2 block that starts at row k.
    fn pair(&self, k: usize) -> (Complex<S>, Complex<S>) {
        let (zero, half) = (S::constant(0.0), S::constant(0.5));
        let (a, d) = (self.at(k, k), self.at(k + 1, k + 1));
        let product = self.at(k, k + 1) * self.at(k + 1, k);
        let difference = (a - d) * half;
        let discriminant = difference * difference + product;
        let middle = (a + d) * half;
        if discriminant < zero {
            let im = (-discriminant).sqrt();
            return (Complex::new(middle, im), Complex::new(middle, -im));
        }
        // The two terms of `shift` have the same sign and do not cancel. Both eigenvalues follow from `shift`.
        let shift = difference + discriminant.sqrt().copysign(difference);
        let first = d + shift;
        let second = if shift.is_zero() {
            d
        } else {
            d - product / shift
        };
        (Complex::new(first, zero), Complex::new(second, zero))
    }

    /// Makes one double-shift QR step on the diagonal block of the rows from `start` to `end` − 1.
    fn francis(&mut self, start: usize, end: usize, rounds: u32) {
        let m = end - 1;
        let (mut s, mut t) = (
            self.at(m - 1, m - 1) + self.at(m, m),
            self.at(m - 1, m - 1) * self.at(m, m) - self.at(m - 1, m) * self.at(m, m - 1),
        );
        if rounds % 10 == 9 {
            // The usual shifts may repeat in a cycle without convergence. An exceptional shift breaks the cycle.
            let w = self.at(m, m - 1).abs() + self.at(m - 1, m - 2).abs();
            (s, t) = (S::constant(1.5) * w, w * w);
        }
        let (a, b) = (self.at(start, start), self.at(start, start + 1));
        let (c, d) = (self.at(start + 1, start), self.at(start + 1, start + 1));
        let mut x = a * a + b * c - s * a + t;
        let mut y = c * (a + d - s);
        let mut z = c * self.at(start + 2, start + 1);
        for k in start..m {
            let three = k + 2 < end;
            let last = if three { z } else { S::constant(0.0) };
            if let Some((v, tau)) = reflector([x, y, last]) {
                let rows = if three { 3 } else { 2 };
                let first = if k > start { k - 1 } else { start };
                for column in first..self.size {
                    self.reflect(&v, tau, rows, |i| (k + i, column));
                }
                let bottom = end.min(k + 4);
                for row in 0..bottom {
                    self.reflect(&v, tau, rows, |i| (row, k + i));
                }
            }
            x = self.at(k + 1, k);
            y = self.at(k + 2, k);
            z = self.at(k + 3, k);
            if k + 3 >= end {
                z = S::constant(0.0);
            }
            if k > start {
                self.set(k + 1, k - 1, S::constant(0.0));
                if three {
                    self.set(k + 2, k - 1, S::constant(0.0));
                }
            }
        }
    }

    /// Applies the reflection (1 − τ v vᵀ) to the first `rows` (2 or 3) of the entries that `place` selects.
    fn reflect(
        &mut self,
        v: &[S; 3],
        tau: S,
        rows: usize,
        place: impl Fn(usize) -> (usize, usize),
    ) {
        let mut sum = S::constant(0.0);
        for (i, v) in v.iter().enumerate().take(rows) {
            let (row, column) = place(i);
            sum = sum + *v * self.at(row, column);
        }
        for (i, v) in v.iter().enumerate().take(rows) {
            let (row, column) = place(i);
            let entry = self.at(row, column) - tau * sum * *v;
            self.set(row, column, entry);
        }
    }
}

/// Returns v and τ of the reflection (1 − τ v vᵀ) that turns x into a multiple of the first unit vector. Returns `None`
/// if x is already a multiple of the first unit vector.
fn reflector<S: Float>(x: [S; 3]) -> Option<([S; 3], S)> {
    let [a, b, c] = x;
    let size = a.abs() + b.abs() + c.abs();
    if size.is_zero() || (b.is_zero() && c.is_zero()) {
        return None;
    }
    let (a, b, c) = (a / size, b / size, c / size);
    let norm = (a * a + b * b + c * c).sqrt().copysign(a);
    let v = [a + norm, b, c];
    Some((v, S::constant(1.0) / (norm * (a + norm))))
}

fn value<S: Float>(b: &[S], k: usize) -> S {
    b.get(k).copied().unwrap_or(S::constant(0.0))
}

fn give<S>(b: &mut [S], k: usize, value: S) {
    if let Some(b) = b.get_mut(k) {
        *b = value;
    }
}

fn put<S: Float>(out: &mut [Complex<S>], k: usize, eigenvalue: Complex<S>) {
    if let Some(out) = out.get_mut(k) {
        *out = eigenvalue;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fuzzing::Random;

    /// Compares the eigenvalues λ with the traces of the matrix M: Σλ = tr M, Σλ² = tr M², Σλ³ = tr M³.
    #[test]
    fn eigenvalues_have_the_traces() {
        let mut random = Random(7);
        for size in [1, 2, 3, 4, 6, 10, 23, 40] {
            let m: Vec<f64> = (0..size * size).map(|_| 0.5 * random.signed()).collect();
            let product = |a: &[f64], b: &[f64]| -> Vec<f64> {
                let mut c = vec![0.0; size * size];
                for j in 0..size {
                    for i in 0..size {
                        c[j * size + i] =
                            (0..size).map(|k| a[k * size + i] * b[j * size + k]).sum();
                    }
                }
                c
            };
            let trace = |a: &[f64]| (0..size).map(|i| a[i * size + i]).sum::<f64>();
            let (second, mut work) = (product(&m, &m), m.clone());
            let third = product(&second, &m);
            let mut out = vec![Complex::new(0.0, 0.0); size];
            SquareMatrix::new(&mut work, size).eigenvalues(&mut out);
            let sum = |power: u32| out.iter().map(|value| value.powu(power).re).sum::<f64>();
            for (power, want) in [(1, trace(&m)), (2, trace(&second)), (3, trace(&third))] {
                let got = sum(power);
                assert!(
                    (got - want).abs() < 1e-12 * size as f64,
                    "{size}, {power}: {got} {want}"
                );
            }
        }
    }

    #[test]
    fn solution_satisfies_the_equations() {
        let mut random = Random(3);
        for size in [1, 2, 5, 12] {
            let m: Vec<f64> = (0..size * size).map(|_| 0.5 * random.signed()).collect();
            let b: Vec<f64> = (0..size).map(|_| 0.5 * random.signed()).collect();
            let (mut work, mut x) = (m.clone(), b.clone());
            assert!(SquareMatrix::new(&mut work, size).solve_shifted(2.0, &mut x));
            for i in 0..size {
                let image: f64 = (0..size).map(|j| m[j * size + i] * x[j]).sum();
                assert!((2.0 * x[i] - image - b[i]).abs() < 1e-14);
            }
        }
    }
}

//! The textbook method. The mode shapes of the thesis contain the frequency ratio r. The method therefore solves a
//! new eigenproblem at each r, and then computes the printed sums.

use super::{dot, vectors};
use crate::methods::{Fill, Method};
use crate::scenes::Label;
use nalgebra::DMatrix;
use num_complex::Complex;
use std::f64::consts::PI;

/// Quantities that the textbook method computes.
pub const METHODS: [Method; 1] = [Method::WithoutSearch];

/// Creates the function that computes both limits without search. With equal masses the matrix Γ is the identity.
pub fn filler(label: Label) -> Fill<f64> {
    let n = label.masses;
    let stiffness = DMatrix::from_fn(n, n, |i, k| match i.abs_diff(k) {
        0 if i + 1 == n => 1.0,
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    });
    let (load, contact, base) = vectors(&label);
    Box::new(move |method, points, out| {
        if method != Method::WithoutSearch {
            return;
        }
        for ([r, _], out) in points.iter().zip(out) {
            *out = limits(&stiffness, &load, &contact, base, label.zeta, *r);
        }
    })
}

fn limits(
    k: &DMatrix<f64>,
    load: &[f64],
    contact: &[f64],
    base: f64,
    zeta: f64,
    r: f64,
) -> [f64; 2] {
    // The matrix solves K̄ψ = r²Γψ/R² with ψᵀΓψ = 1/r².
    let eigen = (k / (r * r)).symmetric_eigen();
    let q = (1.0 - zeta * zeta).sqrt();
    let (mut v, mut h) = (Complex::new(-base, 0.0), Complex::new(0.0, 0.0));
    let (mut u, mut start) = (0.0, 0.0);
    for (square, shape) in eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter())
    {
        let ratio = 1.0 / square.sqrt();
        let shape: Vec<f64> = shape.iter().map(|x| x / r).collect();
        let (p, w) = (dot(&shape, load), dot(&shape, contact));
        let response =
            Complex::new(1.0 - ratio * ratio, 2.0 * zeta * ratio).inv() * (ratio * ratio);
        v += response * (w * p);
        h += response * (w * w);
        let (sine, cosine) = (PI * q / ratio).sin_cos();
        let below = (PI * zeta / ratio).cosh() + cosine;
        let u_mode = sine / (ratio * q * below);
        let g_mode = ((PI * zeta / ratio).sinh() - zeta / q * sine) / below;
        u += w * w * ratio * ratio * u_mode;
        start += w * w * (1.0 + g_mode + 2.0 * zeta * ratio * u_mode);
    }
    [v.norm() / u.hypot(start), v.norm() / h.norm()]
}

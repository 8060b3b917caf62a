//! Harmonic balance. The friction force −β·ż/√(ż² + ε²) is expanded in odd harmonics up to an order. Its coefficients
//! are sampled over half a cycle. Newton's method with the exact derivative starts from the response without friction.

use super::Modal;
use crate::methods::{Fill, Method};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;
use std::f64::consts::PI;

/// Highest harmonics of the expansions that are compared.
pub const ORDERS: [usize; 4] = [1, 3, 9, 25];
/// The width ε of the regularised friction force, divided by the largest velocity without friction.
const WIDTH: f64 = 0.02;
const MOST_STEPS: usize = 60;
const REPEATS: f64 = 1e-10;
/// Smallest fraction of a step of Newton's method that is tried.
const SHORTEST: f64 = 1.0 / 64.0;

/// Creates the function that computes the amplitude of the observed mass with harmonics up to `order`.
pub fn filler(modal: Modal, order: usize) -> Fill<f64> {
    let half = Half::new(order);
    Box::new(move |method, points, out| {
        if method != Method::Amplitude {
            return;
        }
        for ([r, beta], out) in points.iter().zip(out) {
            *out = [amplitude(&modal, &half, *r, *beta).unwrap_or(f64::NAN); 2];
        }
    })
}

/// Returns the response of a motion to a harmonic force at the frequency ratio r. It is the sum over the modes of
/// their shares, each divided by 1 − R² + 2iζR. R is r divided by the natural frequency ratio of the mode.
fn response(modal: &Modal, shares: &[f64], r: f64) -> Complex<f64> {
    let terms = shares.iter().zip(&modal.root).map(|(share, root)| {
        let ratio = r / root;
        *share / Complex::new(1.0 - ratio * ratio, 2.0 * modal.zeta * ratio)
    });
    terms.sum()
}

/// Samples of half a cycle. For each sample and each harmonic n they have the value e^{int}.
struct Half {
    orders: Vec<usize>,
    waves: Vec<Vec<Complex<f64>>>,
}

impl Half {
    fn new(order: usize) -> Self {
        let orders: Vec<usize> = (1..=order).step_by(2).collect();
        let samples = (10 * order).max(64);
        let wave = |j: usize, n: &usize| Complex::cis(PI * (j * n) as f64 / samples as f64);
        let waves = (0..samples).map(|j| orders.iter().map(|n| wave(j, n)).collect());
        Self {
            waves: waves.collect(),
            orders,
        }
    }

    /// Returns the largest |Re Σ X_n e^{int}| at the samples.
    fn largest(&self, harmonics: &[Complex<f64>]) -> f64 {
        let value = |waves: &Vec<Complex<f64>>| -> f64 {
            waves.iter().zip(harmonics).map(|(w, x)| (w * x).re).sum()
        };
        self.waves
            .iter()
            .map(|w| value(w).abs())
            .fold(0.0, f64::max)
    }
}

fn amplitude(modal: &Modal, half: &Half, r: f64, beta: f64) -> Option<f64> {
    let load = response(modal, &modal.load, r) - modal.base;
    let receptances: Vec<Complex<f64>> = half
        .orders
        .iter()
        .map(|n| response(modal, &modal.friction, r * *n as f64) * beta)
        .collect();
    let width = WIDTH * load.norm();
    let mut z = vec![Complex::new(0.0, 0.0); half.orders.len()];
    z[0] = load;
    let mut system = balanced(half, &receptances, load, width, &z);
    for _ in 0..MOST_STEPS {
        let step = system.1.clone().lu().solve(&system.0)?;
        let mut share = 1.0;
        loop {
            let next: Vec<Complex<f64>> = z
                .iter()
                .enumerate()
                .map(|(i, z)| z - Complex::new(step[2 * i], step[2 * i + 1]) * share)
                .collect();
            let trial = balanced(half, &receptances, load, width, &next);
            if trial.0.norm() < system.0.norm() || share <= SHORTEST {
                z = next;
                system = trial;
                break;
            }
            share /= 2.0;
        }
        if step.norm() <= REPEATS * load.norm() {
            return Some(far(modal, half, r, beta, width, &z));
        }
    }
    None
}

/// Returns a pair of numbers at each sample: the friction force divided by β, and its derivative with respect to the
/// velocity.
fn force(half: &Half, width: f64, z: &[Complex<f64>]) -> Vec<(f64, f64)> {
    let velocity = |waves: &Vec<Complex<f64>>| -> f64 {
        let terms = waves.iter().zip(z).zip(&half.orders);
        terms.map(|((w, z), n)| -(*n as f64) * (w * z).im).sum()
    };
    let values = half.waves.iter().map(|waves| {
        let v = velocity(waves);
        let size = v.hypot(width);
        // The pair is the force and its derivative with respect to the velocity.
        (v / size, width * width / (size * size * size))
    });
    values.collect()
}

fn coefficient(half: &Half, force: &[(f64, f64)], index: usize) -> Complex<f64> {
    let terms = half
        .waves
        .iter()
        .zip(force)
        .map(|(waves, (f, _))| waves[index].conj() * *f);
    terms.sum::<Complex<f64>>() * (2.0 / half.waves.len() as f64)
}

/// Returns the residual of the harmonic balance and its derivative, for given harmonics.
fn balanced(
    half: &Half,
    receptances: &[Complex<f64>],
    load: Complex<f64>,
    width: f64,
    z: &[Complex<f64>],
) -> (DVector<f64>, DMatrix<f64>) {
    let count = z.len();
    let force = force(half, width, z);
    let mut rest = DVector::zeros(2 * count);
    let mut slope = DMatrix::identity(2 * count, 2 * count);
    let scale = 2.0 / half.waves.len() as f64;
    for (i, receptance) in receptances.iter().enumerate() {
        let mut out = z[i] + receptance * coefficient(half, &force, i);
        if i == 0 {
            out -= load;
        }
        rest[2 * i] = out.re;
        rest[2 * i + 1] = out.im;
        for (k, n) in half.orders.iter().enumerate() {
            let (mut by_re, mut by_im) = (Complex::new(0.0, 0.0), Complex::new(0.0, 0.0));
            for (waves, (_, slope)) in half.waves.iter().zip(&force) {
                let share = waves[i].conj() * (-slope * *n as f64);
                by_re += share * waves[k].im;
                by_im += share * waves[k].re;
            }
            for (column, by) in [(2 * k, by_re), (2 * k + 1, by_im)] {
                let entry = receptance * by * scale;
                slope[(2 * i, column)] += entry.re;
                slope[(2 * i + 1, column)] += entry.im;
            }
        }
    }
    (rest, slope)
}

fn far(modal: &Modal, half: &Half, r: f64, beta: f64, width: f64, z: &[Complex<f64>]) -> f64 {
    let force = force(half, width, z);
    let harmonics: Vec<Complex<f64>> = half
        .orders
        .iter()
        .enumerate()
        .map(|(i, n)| {
            let load = if i == 0 {
                response(modal, &modal.far_load, r)
            } else {
                Complex::new(0.0, 0.0)
            };
            let receptance = response(modal, &modal.far_friction, r * *n as f64);
            load - receptance * coefficient(half, &force, i) * beta
        })
        .collect();
    half.largest(&harmonics)
}

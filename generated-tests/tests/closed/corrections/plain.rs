//! Solves the governing equations in plain ways. The tests judge the printed forms by these solutions.
//!
//! The matrices follow directly from the scene's numbers, and linear solves give V and H. u and g are the thesis's
//! own forms (7.11) and (7.12). Finite differences give the residual of the equation of motion, and the classical
//! Runge-Kutta method integrates the equation. The module uses none of the project's code except the reader of
//! scenes.

use frictiongen::study::System;
use nalgebra::{Complex, DMatrix, DVector, SymmetricEigen};
use std::f64::consts::PI;

/// The bodies between which the contact slides. Masses count from 0.
#[derive(Clone, Copy, Debug)]
pub enum Contact {
    Wall(usize),
    Base(usize),
    Between(usize, usize),
}

/// A chain base - m1 - m2 - … and its friction contact.
#[derive(Clone, Debug)]
pub struct Scene {
    pub gamma: Vec<f64>,
    pub kappa: Vec<f64>,
    pub contact: Contact,
    /// The mass on which the force acts, or `None` if the base moves.
    pub load: Option<usize>,
    /// Modal damping ratio of every mode.
    pub zeta: f64,
    pub mu: f64,
}

/// Returns the largest argument for which the condition `holds` is true, by bisection. The condition must be true at
/// `low` and false at `high`.
pub fn bisect(holds: impl Fn(f64) -> bool, mut low: f64, mut high: f64) -> f64 {
    assert!(!holds(high), "it still holds at {high}");
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Returns a chain with n equal masses and springs, the force on the first mass, no damping and μ = 1.
pub fn unit(n: usize, contact: Contact) -> Scene {
    Scene {
        gamma: vec![1.0; n],
        kappa: vec![1.0; n],
        contact,
        load: match contact {
            Contact::Base(_) => None,
            _ => Some(0),
        },
        zeta: 0.0,
        mu: 1.0,
    }
}

impl Scene {
    pub fn damped(self, zeta: f64) -> Self {
        Self { zeta, ..self }
    }

    pub fn stiction(self, mu: f64) -> Self {
        Self { mu, ..self }
    }

    /// Returns this scene as a run-time system of the project.
    pub fn system(&self) -> System {
        let name = |i: usize| format!("m{}", i + 1);
        let masses: Vec<String> = (0..self.gamma.len())
            .map(|i| format!("{}: {:?}", name(i), self.gamma[i]))
            .collect();
        let springs: Vec<String> = (0..self.kappa.len())
            .map(|i| {
                let below = if i == 0 { "base".into() } else { name(i - 1) };
                format!("{below} - {}: {:?}", name(i), self.kappa[i])
            })
            .collect();
        let contact = match self.contact {
            Contact::Wall(j) => format!("{} - wall", name(j)),
            Contact::Base(j) => format!("{} - base", name(j)),
            Contact::Between(a, b) => format!("{} - {}", name(a), name(b)),
        };
        let excitation = self.load.map_or("base".into(), name);
        let damping = if self.zeta > 0.0 {
            format!("damping: modal({:?}),", self.zeta)
        } else {
            String::new()
        };
        let text = format!(
            "struct Scene {{ masses: {{ {} }}, springs: {{ {} }}, contact: {contact}, \
             excitation: {excitation}, {damping} stiction: {:?}, }}",
            masses.join(", "),
            springs.join(", "),
            self.mu,
        );
        text.parse().expect("a valid scene")
    }

    /// Returns β_lim as the project computes it.
    pub fn limit(&self, r: f64) -> f64 {
        self.system()
            .at(r)
            .expect("in the domain")
            .continuous_limit()
    }

    /// Returns β*_lim as the project computes it.
    pub fn sliding_limit(&self, r: f64) -> f64 {
        self.system().at(r).expect("in the domain").sliding_limit()
    }

    /// Returns the equations of motion at the frequency ratio r.
    pub fn at(&self, r: f64) -> Plain {
        let n = self.gamma.len();
        let mut k = DMatrix::<f64>::zeros(n, n);
        for (i, kappa) in self.kappa.iter().enumerate() {
            k[(i, i)] += kappa;
            if i > 0 {
                k[(i - 1, i - 1)] += kappa;
                k[(i, i - 1)] -= kappa;
                k[(i - 1, i)] -= kappa;
            }
        }
        let unit = |i: usize| DVector::from_fn(n, |row, _| if row == i { 1.0 } else { 0.0 });
        let (w, on_base) = match self.contact {
            Contact::Wall(j) => (unit(j), false),
            Contact::Base(j) => (unit(j), self.load.is_none()),
            Contact::Between(a, b) => (unit(b) - unit(a), false),
        };
        let gamma = DVector::from_vec(self.gamma.clone());
        // The eigenproblem K̄φ = λΓφ becomes the symmetric eigenproblem of Γ^−½K̄Γ^−½.
        let root = gamma.map(|gamma| 1.0 / gamma.sqrt());
        let scaled = DMatrix::from_fn(n, n, |i, j| k[(i, j)] * root[i] * root[j]);
        let eigen = SymmetricEigen::new(scaled);
        let phi = DMatrix::from_fn(n, n, |i, j| eigen.eigenvectors[(i, j)] * root[i]);
        let lambda: DVector<f64> = eigen.eigenvalues;
        let mut c = DMatrix::<f64>::zeros(n, n);
        for (i, lambda) in lambda.iter().enumerate() {
            let shape = phi.column(i).component_mul(&gamma);
            c += 2.0 * self.zeta * r * lambda.sqrt() * &shape * shape.transpose();
        }
        Plain {
            r,
            zeta: self.zeta,
            mu: self.mu,
            s: if on_base { 1.0 } else { 0.0 },
            p: self.load.map_or_else(|| unit(0) * self.kappa[0], unit),
            gamma,
            k,
            c,
            w,
            lambda,
            phi,
        }
    }
}

/// The equations of motion r²Γx̄″ + C̄x̄′ + K̄x̄ + wβ sgn z̄′ = p cos τ_e, with their modes.
#[derive(Clone, Debug)]
pub struct Plain {
    pub r: f64,
    pub zeta: f64,
    pub mu: f64,
    pub s: f64,
    pub gamma: DVector<f64>,
    pub k: DMatrix<f64>,
    pub c: DMatrix<f64>,
    pub w: DVector<f64>,
    pub p: DVector<f64>,
    pub lambda: DVector<f64>,
    pub phi: DMatrix<f64>,
}

/// Returns u and g of a mode, in the form that (7.11) and (7.12) print.
pub fn u_g(big_r: f64, zeta: f64) -> (f64, f64) {
    let root = (1.0 - zeta * zeta).sqrt();
    let (theta, decay) = (PI * root / big_r, zeta * PI / big_r);
    let denominator = decay.cosh() + theta.cos();
    (
        theta.sin() / (big_r * root * denominator),
        (decay.sinh() - zeta / root * theta.sin()) / denominator,
    )
}

/// Returns d and q of a mode, by (B.8).
pub fn d_q(big_r: f64, zeta: f64, tau: f64) -> (f64, f64) {
    let root = (1.0 - zeta * zeta).sqrt();
    let (sin, cos) = (tau * root / big_r).sin_cos();
    let e = (-zeta * tau / big_r).exp();
    (e * (cos + zeta / root * sin), e * sin / root)
}

impl Plain {
    pub fn n(&self) -> usize {
        self.gamma.len()
    }

    /// Returns the complex amplitudes of all masses under a harmonic load of these complex amplitudes, by a linear
    /// solve.
    fn response(&self, load: &DVector<f64>) -> DVector<Complex<f64>> {
        let n = self.n();
        let dynamic = DMatrix::from_fn(n, n, |i, j| {
            let inertia = if i == j {
                self.r.powi(2) * self.gamma[i]
            } else {
                0.0
            };
            Complex::new(self.k[(i, j)] - inertia, self.c[(i, j)])
        });
        let load = load.map(|p| Complex::new(p, 0.0));
        dynamic.lu().solve(&load).expect("off a resonance")
    }

    /// Returns V_k of every mass, the response to the excitation.
    pub fn v(&self) -> DVector<Complex<f64>> {
        self.response(&self.p)
    }

    /// Returns H_k of every mass, the response to a harmonic force in the contact.
    pub fn h(&self) -> DVector<Complex<f64>> {
        self.response(&self.w)
    }

    /// Returns wᵀx, the relative displacement in the contact, where x has the complex amplitudes of the masses.
    pub fn on_contact(&self, x: &DVector<Complex<f64>>) -> Complex<f64> {
        self.w.iter().zip(x.iter()).map(|(w, x)| *x * *w).sum()
    }

    /// Returns V of the contact, the response of its relative displacement to the excitation.
    pub fn v_contact(&self) -> Complex<f64> {
        self.on_contact(&self.v()) - self.s
    }

    /// Returns R_i = r/√λ_i, the ratio of the excitation frequency to the natural frequency of mode i.
    pub fn big_r(&self, mode: usize) -> f64 {
        self.r / self.lambda[mode].sqrt()
    }

    /// Returns c_i = (φ_iᵀw)², the mode's inverse mass at the contact.
    pub fn inverse_mass_of(&self, mode: usize) -> f64 {
        self.phi.column(mode).dot(&self.w).powi(2)
    }

    /// Returns Σ_i b_ki f(R_i) for every mass k, where b_ki = φ_ki (φ_iᵀw)/λ_i.
    pub fn by_modes(&self, f: impl Fn(f64) -> f64) -> DVector<f64> {
        let mut sum = DVector::zeros(self.n());
        for i in 0..self.n() {
            let shape = self.phi.column(i);
            sum += shape * (shape.dot(&self.w) / self.lambda[i] * f(self.big_r(i)));
        }
        sum
    }

    /// Returns U_k of every mass: at a reversal, its velocity under a square wave of friction in the contact.
    pub fn u(&self) -> DVector<f64> {
        self.by_modes(|big_r| u_g(big_r, self.zeta).0)
    }

    /// Returns G_k of every mass: at a reversal, its displacement under a square wave of friction in the contact.
    pub fn g(&self) -> DVector<f64> {
        self.by_modes(|big_r| u_g(big_r, self.zeta).1)
    }

    /// Returns the amplitude Z and the phase φ (rad) of the contact's relative motion at the friction ratio β.
    pub fn amplitude_phase(&self, beta: f64) -> (f64, f64) {
        let (u, g) = (self.w.dot(&self.u()), self.w.dot(&self.g()));
        let v = self.v_contact();
        let root = (v.norm_sqr() - (beta * u).powi(2)).sqrt();
        (root - beta * g, (-beta * u).atan2(root) - v.arg())
    }

    /// Returns the displacement x̄_k(τ) of the formal continuous motion, as a function of k and τ. [`Plain::defect`]
    /// shows whether this motion satisfies the equations of motion.
    pub fn motion(&self, beta: f64) -> impl Fn(usize, f64) -> f64 {
        let (v, phi) = (self.v(), self.amplitude_phase(beta).1);
        let plain = self.clone();
        move |k, tau| {
            let h = |big_r| {
                let (d, q) = d_q(big_r, plain.zeta, tau);
                let (u, g) = u_g(big_r, plain.zeta);
                1.0 - (1.0 + g) * d - u * big_r * q
            };
            v[k].norm() * (tau + phi + v[k].arg()).cos() + beta * plain.by_modes(h)[k]
        }
    }

    /// Returns the largest β for which z̄′ < 0 at all instants of a grid between the reversals.
    ///
    /// The grid misses extremes between two of its instants, and extremes within 1e-4 rad of a reversal.
    pub fn velocity_limit(&self, high: f64) -> f64 {
        let h = 1e-5;
        let slides = |beta: f64| {
            let (x, phi) = (self.motion(beta), self.amplitude_phase(beta).1);
            let z = |tau: f64| {
                let all = (0..self.n()).map(|k| self.w[k] * x(k, tau));
                all.sum::<f64>() - self.s * (tau + phi).cos()
            };
            // Near the reversals the constraint can exceed its values on a coarse grid.
            let grid = (1..200).map(|i| PI * f64::from(i) / 200.0);
            let ends = [1e-4, 3e-4, 1e-3, 3e-3, 8e-3];
            let instants = grid.chain(ends).chain(ends.map(|end| PI - end));
            instants.into_iter().all(|tau| z(tau + h) < z(tau - h))
        };
        bisect(slides, 0.0, high)
    }

    /// Returns the largest β for which the contact breaks away at its reversal, by bisection up to `high`.
    pub fn break_away_limit(&self, high: f64) -> f64 {
        let breaks = |beta: f64| self.force_at_reversal(beta).abs() > self.mu * beta;
        bisect(breaks, 0.0, high)
    }

    /// Returns the force, over P, that would keep the contact stuck at the reversal τ = 0 of its continuous motion.
    pub fn force_at_reversal(&self, beta: f64) -> f64 {
        let (x, phi) = (self.motion(beta), self.amplitude_phase(beta).1);
        let h = 1e-4;
        let start = DVector::from_fn(self.n(), |k, _| x(k, 0.0));
        let velocity = DVector::from_fn(self.n(), |k, _| (x(k, h) - x(k, -h)) / (2.0 * h));
        self.holding_force(phi, &start, &velocity)
    }

    /// Returns the complex amplitudes of the masses while the contact is stuck, and the force in the contact.
    pub fn stuck(&self) -> (DVector<Complex<f64>>, Complex<f64>) {
        // The constraint wᵀx = s is added to Γ, C̄, K̄ as a row, and the contact force as one more unknown.
        let n = self.n();
        let bordered = DMatrix::from_fn(n + 1, n + 1, |i, j| match (i == n, j == n) {
            (true, true) => Complex::new(0.0, 0.0),
            (true, false) => Complex::new(self.w[j], 0.0),
            (false, true) => Complex::new(self.w[i], 0.0),
            (false, false) => {
                let inertia = if i == j {
                    self.r.powi(2) * self.gamma[i]
                } else {
                    0.0
                };
                Complex::new(self.k[(i, j)] - inertia, self.c[(i, j)])
            }
        });
        let load = DVector::from_fn(n + 1, |i, _| {
            Complex::new(if i == n { self.s } else { self.p[i] }, 0.0)
        });
        let all = bordered.lu().solve(&load).expect("off a resonance");
        (all.rows(0, n).into_owned(), all[n])
    }

    /// Returns the defect of a motion x of every mass on 0 ≤ τ ≤ π. τ = 0 is a maximum of the contact's motion.
    ///
    /// The defect is the largest violation of the equations of motion, or of the antiperiodicity of displacement and
    /// velocity. The function computes derivatives by differences of fourth order with a step of 1e-3. For
    /// frequencies of order 1, the error of the differences is about 1e-9.
    pub fn defect(&self, beta: f64, phi: f64, x: impl Fn(usize, f64) -> f64) -> f64 {
        let h = 1e-3;
        let sample = |k: usize, tau: f64| {
            let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|i| x(k, tau + i * h));
            let first = (a - 8.0 * b + 8.0 * d - e) / (12.0 * h);
            let second = (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / (12.0 * h * h);
            (c, first, second)
        };
        let mut worst = 0.0_f64;
        for tau in [0.0, 0.4, 1.1, 1.7, 2.3, 2.9, PI] {
            let all: Vec<_> = (0..self.n()).map(|k| sample(k, tau)).collect();
            for row in 0..self.n() {
                let mut sum = self.r.powi(2) * self.gamma[row] * all[row].2;
                for (k, (displacement, velocity, _)) in all.iter().enumerate() {
                    sum += self.c[(row, k)] * velocity + self.k[(row, k)] * displacement;
                }
                let load = self.w[row] * beta + self.p[row] * (tau + phi).cos();
                worst = worst.max((sum - load).abs());
            }
        }
        for k in 0..self.n() {
            let (start, end) = (sample(k, 0.0), sample(k, PI));
            worst = worst.max((start.0 + end.0).abs());
            worst = worst.max((start.1 + end.1).abs());
        }
        worst
    }

    /// Returns the contact force that keeps z̄′ constant (z̄″ = 0), for the excitation at the angle t, displacements
    /// x and velocities v.
    pub fn holding_force(&self, t: f64, x: &DVector<f64>, v: &DVector<f64>) -> f64 {
        let load = &self.p * t.cos() - &self.c * v - &self.k * x;
        let weights = self.w.component_div(&self.gamma);
        (weights.dot(&load) + self.r.powi(2) * self.s * t.cos()) / weights.dot(&self.w)
    }
}

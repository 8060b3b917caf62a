//! Evaluates the functions of both searches by the printed formulas, and finds their maxima by brute force.

use frictiongen::study::System;
use std::f64::consts::PI;

/// A damped mode, whose functions are those that sections 3 and 4 of the physics page print. For ζ > 1, q is
/// imaginary.
#[derive(Clone, Debug)]
pub struct Mode {
    /// The ratio 1/R = √λ/r of the mode.
    pub x: f64,
    pub zeta: f64,
    pub u: f64,
    pub g: f64,
    /// The constant c = (φᵀw)² of the mode.
    pub c: f64,
    /// The load φᵀp on the mode.
    pub p: f64,
    /// The relative displacement φᵀw of the contact in the mode.
    pub w: f64,
    pub lambda: f64,
    /// The component φ of every mass in the mode.
    pub phi: Vec<f64>,
    /// Real and imaginary part of v = 1/(1 − R² + 2iζR).
    pub v: (f64, f64),
}

/// Returns the pair (d, q̃) at y = τ/R: d = e^{−ζy}[cos qy + (ζ/q) sin qy], q̃ = e^{−ζy} sin(qy)/q.
pub fn decay(zeta: f64, y: f64) -> (f64, f64) {
    let q2 = 1.0 - zeta * zeta;
    if q2 > 0.0 {
        let q = q2.sqrt();
        let e = (-zeta * y).exp();
        (
            e * ((q * y).cos() + zeta / q * (q * y).sin()),
            e * (q * y).sin() / q,
        )
    } else {
        let q = (-q2).sqrt();
        let (slow, fast) = ((-(zeta - q) * y).exp(), (-(zeta + q) * y).exp());
        let q_tilde = (slow - fast) / (2.0 * q);
        (0.5 * (slow + fast) + zeta * q_tilde, q_tilde)
    }
}

impl Mode {
    pub fn at(x: f64, zeta: f64, w: f64, p: f64, lambda: f64, phi: Vec<f64>) -> Self {
        let ratio = 1.0 / x;
        let (u, g);
        if zeta == 0.0 {
            // The code removes whole turns from the argument of tan(π/2R) first. This removal is exact.
            u = (0.5 * PI * (x % 2.0)).tan() / ratio;
            g = 0.0;
        } else {
            let e = (-PI * zeta * x).exp();
            let (d, sine) = decay(zeta, PI * x);
            let cosine = d - zeta * sine;
            let below = 1.0 + e * e + 2.0 * cosine;
            u = 2.0 * sine / (ratio * below);
            g = (1.0 - e * e - 2.0 * zeta * sine) / below;
        }
        let (re, im) = (1.0 - ratio * ratio, 2.0 * zeta * ratio);
        let size = re * re + im * im;
        Self {
            x,
            zeta,
            u,
            g,
            c: w * w,
            p,
            w,
            lambda,
            phi,
            v: (re / size, -im / size),
        }
    }

    /// Returns (1+g)Rq̃ + uR²[cos τ − e^{−ζτ/R}(cos qτ/R − (ζ/q) sin qτ/R)], the term of this mode in the velocity
    /// constraint.
    pub fn constraint(&self, tau: f64) -> f64 {
        let (ratio, y) = (1.0 / self.x, tau * self.x);
        if self.zeta == 0.0 {
            // As a product, cos τ − cos y is accurate also near τ = 0.
            let forced_slope = 2.0 * (0.5 * (y + tau)).sin() * (0.5 * (y - tau)).sin();
            return ratio * y.sin() + self.u * ratio * ratio * forced_slope;
        }
        let (d, q_tilde) = decay(self.zeta, y);
        let turned = d - 2.0 * self.zeta * q_tilde;
        (1.0 + self.g) * ratio * q_tilde + self.u * ratio * ratio * (tau.cos() - turned)
    }

    /// Returns h(τ), the contribution of friction in this mode to the displacement.
    pub fn h(&self, tau: f64) -> f64 {
        if self.zeta == 0.0 {
            return 1.0 - ((tau - 0.5 * PI) * self.x).cos() / (0.5 * PI * (self.x % 4.0)).cos();
        }
        let (d, q_tilde) = decay(self.zeta, tau * self.x);
        1.0 - (1.0 + self.g) * d - self.u * q_tilde / self.x
    }
}

/// A scene at one frequency ratio, described by its modal data.
pub struct Plain {
    pub modes: Vec<Mode>,
    pub r: f64,
    pub of_base: f64,
    pub inverse_mass: f64,
    pub mu: f64,
}

/// Result of the brute-force search for β_lim.
pub struct Limit {
    pub beta: f64,
    /// True if the search mattered, because S, the largest velocity constraint, is above the break-away term.
    pub searched: bool,
    /// Condition number: the relative change of β for relative changes of the resonances, plus the cancellation in V.
    pub condition: f64,
}

impl Plain {
    /// Returns the scene with its resonances shifted by a relative `jitter`. Neighbouring modes are shifted in opposite
    /// directions if `alternate` is set.
    pub fn new(system: &System, r: f64, jitter: f64, alternate: bool) -> Self {
        let modal = system.modal();
        let modes = (0..modal.resonances.len())
            .map(|i| {
                let sign = if alternate && i % 2 == 1 { -1.0 } else { 1.0 };
                let resonance = modal.resonances[i].to_f64() * (1.0 + sign * jitter);
                Mode::at(
                    resonance / r,
                    modal.damping_ratios[i].to_f64(),
                    modal.contacts[i].to_f64(),
                    modal.loads[i].to_f64(),
                    resonance * resonance,
                    modal.shapes[i].iter().map(|value| value.to_f64()).collect(),
                )
            })
            .collect();
        Self {
            modes,
            r,
            of_base: if modal.on_moving_base { 1.0 } else { 0.0 },
            inverse_mass: modal.inverse_mass.to_f64(),
            mu: modal.stiction.to_f64(),
        }
    }

    pub fn constraint(&self, tau: f64) -> f64 {
        let sum: f64 = self
            .modes
            .iter()
            .map(|mode| mode.c * mode.constraint(tau))
            .sum();
        sum / (self.r * self.r * tau.sin())
    }

    /// Returns V, U and G of the contact, and the size of the largest term in V.
    pub fn contact(&self) -> ((f64, f64), f64, f64, f64) {
        let (mut v, mut u, mut g, mut size) = ((-self.of_base, 0.0), 0.0, 0.0, self.of_base);
        for mode in &self.modes {
            let a = mode.w * mode.p / mode.lambda;
            v = (v.0 + a * mode.v.0, v.1 + a * mode.v.1);
            size += (a * mode.v.0).hypot(a * mode.v.1);
            u += mode.c / mode.lambda * mode.u;
            g += mode.c / mode.lambda * mode.g;
        }
        (v, u, g, size)
    }

    /// Returns H_c of the contact, which decides whether it breaks away at a reversal.
    pub fn reversal(&self) -> f64 {
        let sum: f64 = self
            .modes
            .iter()
            .map(|m| m.c * (m.g + 2.0 * m.zeta / m.x * m.u))
            .sum();
        sum / (self.r * self.r)
    }

    /// Returns a number of grid points, at least `least`, that gives 24 points to each turn of the fastest mode.
    pub fn points(&self, least: usize) -> usize {
        let fastest = self
            .modes
            .iter()
            .fold(1.0, |most: f64, mode| most.max(mode.x));
        least.max((12.0 * fastest) as usize + 1)
    }

    pub fn beta_with(&self, s: f64) -> f64 {
        let (v, u, _, _) = self.contact();
        let mass = self.inverse_mass / (self.r * self.r);
        let demand = s.max(self.reversal() + self.mu * mass);
        v.0.hypot(v.1) / u.hypot(demand)
    }

    /// Returns β_lim, with S (the largest velocity constraint) from a grid of at least `least` points.
    pub fn limit(&self, system: &System, least: usize) -> Limit {
        let (tau, searched_s) = largest(|tau| self.constraint(tau), self.points(least));
        let mass = self.inverse_mass / (self.r * self.r);
        // The limit of S at τ → 0 is one of the values of S.
        let s = searched_s.max(mass + self.reversal());
        let beta = self.beta_with(s);
        let at_start = searched_s < mass + self.reversal();
        let (v, _, _, size) = self.contact();
        // The condition number compares β for shifted resonances at the same τ, because the constraint is stationary
        // at τ.
        let mut condition = size / v.0.hypot(v.1);
        let step = 1e-9;
        for alternate in [false, true] {
            let moved = Plain::new(system, self.r, step, alternate);
            let value = if at_start {
                moved.inverse_mass / (moved.r * moved.r) + moved.reversal()
            } else {
                moved.constraint(tau)
            };
            condition += (moved.beta_with(value) / beta - 1.0).abs() / step;
        }
        let searched = s > self.reversal() + self.mu * mass;
        Limit {
            beta,
            searched,
            condition,
        }
    }
}

/// Returns the instant and value of the maximum of a function on (0, π). A grid finds the peaks, and golden section
/// refines every grid maximum that may be the largest.
pub fn largest(f: impl Fn(f64) -> f64, points: usize) -> (f64, f64) {
    let step = PI / points as f64;
    let values: Vec<f64> = (0..=points)
        .map(|i| {
            // The constraint is 0/0 at both end points, so these grid points are shifted inside by half a thousandth of
            // a step.
            let tau = (i as f64 * step).clamp(0.0005 * step, PI - 0.0005 * step);
            f(tau)
        })
        .collect();
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut best = (0.0, f64::NEG_INFINITY);
    for i in 0..=points {
        let before = if i > 0 {
            values[i - 1]
        } else {
            f64::NEG_INFINITY
        };
        let after = values.get(i + 1).copied().unwrap_or(f64::NEG_INFINITY);
        // With 24 points to a turn, a grid maximum is below its peak by at most 1 % of the height from trough to peak.
        // A margin of 5 % of the largest value is wide.
        if values[i] < before || values[i] < after || values[i] < most - 0.05 * most.abs() {
            continue;
        }
        let mut low = ((i as f64 - 1.0) * step).max(0.0005 * step);
        let mut high = ((i as f64 + 1.0) * step).min(PI - 0.0005 * step);
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        // The search ends at 1e-8 of the bracket. At a maximum the value then is exact to rounding.
        for _ in 0..40 {
            let width = golden * (high - low);
            if f(high - width) < f(low + width) {
                low = high - width
            } else {
                high = low + width
            }
        }
        for (tau, value) in [
            (0.5 * (low + high), f(0.5 * (low + high))),
            (i as f64 * step, values[i]),
        ] {
            if best.1 < value {
                best = (tau, value);
            }
        }
    }
    best
}

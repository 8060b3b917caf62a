//! Integrates the motion of the tour's frame in time by a plain method: fourth-order Runge-Kutta from rest, with
//! bisection for the reversals of the contact. It uses the masses, springs and modal damping of the frame, and none of
//! the closed forms.

use std::f64::consts::TAU;

const MASS: [f64; 2] = [3.27, 3.25];
const SPRING: [f64; 2] = [1190.0, 1323.0];
const DAMPING: [f64; 2] = [0.010, 0.012];
const STEPS: usize = 400;
const CYCLES: usize = 500;

/// Displacements of the two floors, then their velocities.
type State = [f64; 4];

struct Equations {
    stiffness: [[f64; 2]; 2],
    damping: [[f64; 2]; 2],
    load: f64,
    omega: f64,
    friction: f64,
}

impl Equations {
    /// Creates the equations of motion in units in which k₁Y = P = 1. The amplitude Y of the base is then 1/k₁.
    fn new(r: f64, beta: f64) -> Self {
        let [m1, m2] = MASS;
        let [k1, k2] = SPRING;
        let stiffness = [[k1 + k2, -k2], [-k2, k2]];
        // The two ω² are the roots of the characteristic polynomial. The modal damping matrix is C = Σ 2ζω (Mφ)(Mφ)ᵀ
        // with φᵀMφ = 1.
        let (a, b) = (m1 * m2, m1 * k2 + m2 * (k1 + k2));
        let root = (b * b - 4.0 * a * k1 * k2).sqrt();
        let mut damping = [[0.0; 2]; 2];
        for (square, zeta) in [(b - root) / (2.0 * a), (b + root) / (2.0 * a)]
            .into_iter()
            .zip(DAMPING)
        {
            let shape = [k2, k1 + k2 - square * m1];
            let norm = m1 * shape[0] * shape[0] + m2 * shape[1] * shape[1];
            let momentum = [m1 * shape[0], m2 * shape[1]];
            for (row, left) in damping.iter_mut().zip(momentum) {
                for (entry, right) in row.iter_mut().zip(momentum) {
                    *entry += 2.0 * zeta * square.sqrt() * left * right / norm;
                }
            }
        }
        Self {
            stiffness,
            damping,
            load: 1.0,
            omega: r * (k1 / m1).sqrt(),
            friction: beta,
        }
    }

    fn slope(&self, time: f64, state: State, direction: f64) -> State {
        let [x1, x2, v1, v2] = state;
        let force = |row: usize| {
            let ([k1, k2], [c1, c2]) = (self.stiffness[row], self.damping[row]);
            -(k1 * x1 + k2 * x2 + c1 * v1 + c2 * v2)
        };
        let lower = force(0) + self.load * (self.omega * time).cos();
        let upper = force(1) - self.friction * direction;
        [v1, v2, lower / MASS[0], upper / MASS[1]]
    }

    fn step(&self, time: f64, state: State, h: f64, direction: f64) -> State {
        let moved = |slope: State, h: f64| {
            let mut next = state;
            for (next, slope) in next.iter_mut().zip(slope) {
                *next += h * slope;
            }
            next
        };
        let k1 = self.slope(time, state, direction);
        let k2 = self.slope(time + h / 2.0, moved(k1, h / 2.0), direction);
        let k3 = self.slope(time + h / 2.0, moved(k2, h / 2.0), direction);
        let k4 = self.slope(time + h, moved(k3, h), direction);
        let mut next = state;
        for (((next, a), b), (c, d)) in next.iter_mut().zip(k1).zip(k2).zip(k3.into_iter().zip(k4))
        {
            *next += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
        next
    }
}

/// Returns the largest |x̄| of each floor in the last of many cycles, at the frequency ratio r and the friction ratio
/// β.
pub fn amplitudes(r: f64, beta: f64) -> [f64; 2] {
    let equations = Equations::new(r, beta);
    let h = TAU / equations.omega / STEPS as f64;
    let mut state: State = [0.0; 4];
    let mut direction = 1.0;
    let mut largest = [0.0_f64; 2];
    for step in 0..STEPS * CYCLES {
        let time = step as f64 * h;
        let mut next = equations.step(time, state, h, direction);
        if next[3] * direction < 0.0 {
            // The contact reverses within the step. The integration stops at the reversal, then continues with the
            // friction force reversed.
            let (mut before, mut after) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (before + after);
                if equations.step(time, state, middle, direction)[3] * direction < 0.0 {
                    after = middle;
                } else {
                    before = middle;
                }
            }
            let reversal = equations.step(time, state, after, direction);
            direction = -direction;
            next = equations.step(time + after, reversal, h - after, direction);
            // The contact has no velocity at this instant, so its displacement is an extreme.
            if step >= STEPS * (CYCLES - 1) {
                largest[1] = largest[1].max(reversal[1].abs());
            }
        }
        if step >= STEPS * (CYCLES - 1) {
            largest[0] = largest[0].max(extreme(state[0], state[2], next[0], next[2], h));
        }
        state = next;
    }
    largest.map(|value| value * SPRING[0])
}

/// Returns the largest |x| over a time step, from the cubic through displacements and velocities at both ends.
fn extreme(x0: f64, v0: f64, x1: f64, v1: f64, h: f64) -> f64 {
    let ends = x0.abs().max(x1.abs());
    if v0 * v1 >= 0.0 {
        return ends;
    }
    let (mut before, mut after) = (0.0, 1.0);
    let cubic = |s: f64| {
        let (a, b) = (
            2.0 * (x0 - x1) + h * (v0 + v1),
            3.0 * (x1 - x0) - h * (2.0 * v0 + v1),
        );
        (
            ((a * s + b) * s + h * v0) * s + x0,
            (3.0 * a * s + 2.0 * b) * s + h * v0,
        )
    };
    for _ in 0..50 {
        let middle = 0.5 * (before + after);
        if cubic(middle).1 * v0 > 0.0 {
            before = middle
        } else {
            after = middle
        }
    }
    ends.max(cubic(before).0.abs())
}

//! Defines the equations of motion of a scene, and the step and the tolerance of the comparison.

/// Number of steps in a half period.
pub const STEPS: usize = 2000;
/// Tolerance of every comparison, relative to the size of the motion.
pub const TOLERANCE: f64 = 1e-10;

/// A scene as equations: r²Γx̄″ + C̄x̄′ + K̄x̄ + wf = p cos τ_e and z̄ = wᵀx̄ − s cos τ_e.
#[derive(Clone)]
pub struct Chain {
    /// Number of masses, up to three. The arrays have three elements, and the elements beyond this number are unused.
    pub n: usize,
    pub gamma: [f64; 3],
    pub c: [[f64; 3]; 3],
    pub k: [[f64; 3]; 3],
    pub w: [f64; 3],
    pub p: [f64; 3],
    pub s: f64,
    pub mu: f64,
    pub r: f64,
    pub beta: f64,
}

/// The displacements of all masses, then their velocities with respect to τ.
pub type State = [f64; 6];

/// State of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// The contact slides in the direction of this sign.
    Slides(f64),
    Holds,
}

pub fn dot(a: &[f64; 3], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Chain {
    /// Returns p cos τ_e − C̄x̄′ − K̄x̄, the force that is left for inertia and contact.
    pub fn load(&self, t: f64, y: &State) -> [f64; 3] {
        std::array::from_fn(|i| {
            self.p[i] * t.cos() - dot(&self.c[i], &y[3..]) - dot(&self.k[i], &y[..3])
        })
    }

    /// Returns the contact force that keeps z̄′ constant, which follows from z̄″ = 0.
    pub fn holding_force(&self, t: f64, y: &State) -> f64 {
        let load = self.load(t, y);
        let free: f64 = (0..self.n)
            .map(|i| self.w[i] * load[i] / self.gamma[i])
            .sum();
        let inverse_mass: f64 = (0..self.n)
            .map(|i| self.w[i] * self.w[i] / self.gamma[i])
            .sum();
        (free + self.r * self.r * self.s * t.cos()) / inverse_mass
    }

    pub fn derivative(&self, t: f64, y: &State, contact: Contact) -> State {
        let force = match contact {
            Contact::Slides(sign) => self.beta * sign,
            Contact::Holds => self.holding_force(t, y),
        };
        let load = self.load(t, y);
        let mut out = [0.0; 6];
        for i in 0..self.n {
            out[i] = y[3 + i];
            out[3 + i] = (load[i] - self.w[i] * force) / (self.r * self.r * self.gamma[i]);
        }
        out
    }

    /// Returns the state after one step of the classical Runge-Kutta method.
    pub fn step(&self, t: f64, y: &State, h: f64, contact: Contact) -> State {
        let add = |k: &State, by: f64| -> State { std::array::from_fn(|i| y[i] + by * k[i]) };
        let k1 = self.derivative(t, y, contact);
        let k2 = self.derivative(t + 0.5 * h, &add(&k1, 0.5 * h), contact);
        let k3 = self.derivative(t + 0.5 * h, &add(&k2, 0.5 * h), contact);
        let k4 = self.derivative(t + h, &add(&k3, h), contact);
        std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }

    pub fn relative(&self, t: f64, y: &State) -> f64 {
        dot(&self.w, &y[..3]) - self.s * t.cos()
    }

    pub fn relative_velocity(&self, t: f64, y: &State) -> f64 {
        dot(&self.w, &y[3..]) + self.s * t.sin()
    }

    /// Returns the state at τ_e of the response without friction, from which an integration starts. The response
    /// exists only for equations that are [`Chain::linear`].
    pub fn frictionless(&self, t: f64) -> State {
        let n = self.n;
        // The equations are [K̄ − r²Γ, C̄; −C̄, K̄ − r²Γ][a; b] = [p; 0] with x̄ = a cos τ_e + b sin τ_e.
        let rows: Vec<Vec<f64>> = (0..2 * n)
            .map(|row| {
                let (i, lower) = (row % n, row >= n);
                let mut line = vec![0.0; 2 * n + 1];
                for j in 0..n {
                    let dynamic = self.k[i][j]
                        - if i == j {
                            self.r * self.r * self.gamma[i]
                        } else {
                            0.0
                        };
                    line[j] = if lower { -self.c[i][j] } else { dynamic };
                    line[n + j] = if lower { dynamic } else { self.c[i][j] };
                }
                line[2 * n] = if lower { 0.0 } else { self.p[i] };
                line
            })
            .collect();
        let ab = solve(rows);
        let mut y = [0.0; 6];
        for i in 0..n {
            y[i] = ab[i] * t.cos() + ab[n + i] * t.sin();
            y[3 + i] = ab[n + i] * t.cos() - ab[i] * t.sin();
        }
        y
    }
}

/// Solves a linear system by Gaussian elimination with pivoting. Each row ends with its right-hand side.
pub fn solve(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for column in 0..n {
        let pivot = (column..n)
            .max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))
            .unwrap();
        rows.swap(column, pivot);
        for row in 0..n {
            if row != column {
                let factor = rows[row][column] / rows[column][column];
                for j in column..=n {
                    rows[row][j] -= factor * rows[column][j];
                }
            }
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

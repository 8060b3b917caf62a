mod attracted;
mod creep;
mod energy;
mod fixed;
mod known;
mod patterns;
mod records;
mod reference;
mod rooms;
mod settled;
mod steady;
mod stops;
mod stribeck;

use super::{Approach, Chain, Joint, JointError, Motion, Place, Steady, Wave, steady_state};
use frictiongen_model::scene::Node;

/// Returns the steady state that the motion from rest reaches.
fn steady_from_rest(chain: &Chain, omega: f64) -> Result<Steady, JointError> {
    reached(steady_state(
        Motion::from_rest(chain)?,
        omega,
        (Place::Centred, None),
    )?)
}

/// Returns the steady state that a motion reaches. A contact that never slides stays where the motion has left it.
fn steady_state_from(motion: Motion, omega: f64) -> Result<Steady, JointError> {
    reached(steady_state(motion, omega, (Place::Reached, None))?)
}

/// Returns the steady state if the motion ends in it.
fn reached(steady: Steady) -> Result<Steady, JointError> {
    match steady.approach {
        Approach::Reached => Ok(steady),
        _ => Err(JointError::NotSteady),
    }
}

/// Returns eigenvalues in ascending order and orthonormal eigenvectors (columns) of a symmetric matrix, by Jacobi
/// rotations.
pub fn eigen(mut a: Vec<Vec<f64>>) -> (Vec<f64>, Vec<Vec<f64>>) {
    let n = a.len();
    let mut v: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect())
        .collect();
    for _ in 0..60 {
        for p in 0..n {
            for q in p + 1..n {
                if a[p][q] == 0.0 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for row in a.iter_mut().chain(v.iter_mut()) {
                    let (x, y) = (row[p], row[q]);
                    row[p] = c * x - s * y;
                    row[q] = s * x + c * y;
                }
                let (x, y) = (a[p].clone(), a[q].clone());
                for k in 0..n {
                    a[p][k] = c * x[k] - s * y[k];
                    a[q][k] = s * x[k] + c * y[k];
                }
            }
        }
    }
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    let values = order.iter().map(|&i| a[i][i]).collect();
    let vectors = order.iter().map(|&i| v.iter().map(|row| row[i]).collect());
    (values, vectors.collect())
}

/// Returns the stiffness matrix of a list of springs, each with its two nodes and its stiffness.
pub fn stiffness(masses: usize, springs: &[(Node, Node, f64)]) -> Vec<Vec<f64>> {
    let mut k = vec![vec![0.0; masses]; masses];
    for &(from, to, value) in springs {
        let ends = [from, to].map(|node| match node {
            Node::Mass(i) => Some(i),
            _ => None,
        });
        for (sign, a, b) in [(1.0, 0, 0), (1.0, 1, 1), (-1.0, 0, 1), (-1.0, 1, 0)] {
            if let (Some(a), Some(b)) = (ends[a], ends[b]) {
                k[a][b] += sign * value;
            }
        }
    }
    k
}

/// Returns the matrix of modal damping, MΦ diag(2ζσ) ΦᵀM. M is the mass matrix, Φ the matrix of mode shapes, and σ a
/// natural frequency in rad/s.
pub fn modal(masses: &[f64], springs: &[(Node, Node, f64)], zeta: &[f64]) -> Vec<Vec<f64>> {
    let n = masses.len();
    let mut k = stiffness(n, springs);
    for (i, row) in k.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value /= (masses[i] * masses[j]).sqrt();
        }
    }
    let (values, vectors) = eigen(k);
    let mut c = vec![vec![0.0; n]; n];
    for ((value, vector), zeta) in values.iter().zip(&vectors).zip(zeta) {
        let sigma = if *value > 1e-9 * values[n - 1] {
            value.sqrt()
        } else {
            0.0
        };
        for i in 0..n {
            for j in 0..n {
                c[i][j] +=
                    2.0 * zeta * sigma * vector[i] * vector[j] * (masses[i] * masses[j]).sqrt();
            }
        }
    }
    c
}

/// Creates a rigid contact between two nodes, with a constant kinetic friction force and the ratio μ.
pub fn rigid(ends: (Node, Node), level: f64, stiction: f64) -> Joint {
    Joint {
        ends,
        level: Wave::constant(level),
        stiction,
        stiffness: None,
        speed: 0.0,
    }
}

/// A generator of pseudo-random numbers (xorshift) that returns the same numbers in every run.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Returns a number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }
}

/// Creates a random chain of 1 to 6 masses with at most 4 contacts, rigid or elastic. A chain without a support has no
/// spring to the base.
pub fn random_chain(random: &mut Random) -> (Chain, f64) {
    let n = 1 + random.below(6);
    let free = random.unit() < 0.3;
    let masses: Vec<f64> = (0..n).map(|_| random.between(0.5, 4.0)).collect();
    let mut springs = Vec::new();
    for i in usize::from(free)..n {
        let from = if i == 0 {
            Node::Base
        } else {
            Node::Mass(i - 1)
        };
        springs.push((from, Node::Mass(i), random.between(400.0, 4000.0)));
    }
    let zeta: Vec<f64> = (0..n).map(|_| random.between(0.0, 0.05)).collect();
    let mut contacts = Vec::new();
    // Each mass has at most one contact, to the wall or to the previous mass. Rigid contacts therefore form no loop.
    for i in 0..n {
        if random.unit() < 0.6 && contacts.len() < 4 {
            let other = if i > 0 && random.unit() < 0.5 {
                Node::Mass(i - 1)
            } else {
                Node::Wall
            };
            let elastic = random.unit() < 0.5;
            contacts.push(Joint {
                ends: (Node::Mass(i), other),
                level: Wave::constant(random.between(0.5, 12.0)),
                stiction: if random.unit() < 0.5 {
                    1.0
                } else {
                    random.between(1.0, 1.6)
                },
                stiffness: elastic.then(|| random.between(500.0, 20000.0)),
                speed: 0.0,
            });
        }
    }
    let mut dashpots = Vec::new();
    if n > 1 && random.unit() < 0.5 {
        dashpots.push((Node::Mass(0), Node::Mass(n - 1), random.between(1.0, 40.0)));
    }
    let omega = random.between(3.0, 60.0);
    let moves = !free && random.unit() < 0.4;
    let chain = Chain {
        damping: modal(&masses, &springs, &zeta),
        masses,
        springs,
        dashpots,
        contacts,
        loads: if moves {
            vec![]
        } else {
            vec![(random.below(n), Wave::harmonic(20.0, omega))]
        },
        base: if moves {
            Wave::harmonic(0.01, omega)
        } else {
            Wave::default()
        },
        ..Chain::default()
    };
    (chain, omega)
}

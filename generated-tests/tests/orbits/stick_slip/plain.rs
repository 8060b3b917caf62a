//! Integrates the motion from rest by dense matrix exponentials. The integrator halves a step until it has located an
//! event.
//!
//! The integrator shares no formula with the project. It has no modes of the chain with a stuck contact, no series, no
//! search with bounds and no Newton's method.

use frictiongen::study::scene::{Damping, Excitation, Node, Scene};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Number of steps in a cycle.
const STEPS: u32 = 256;
/// Largest number of halvings of a step. An event is then located to 2e-11 rad.
const HALVINGS: usize = 30;
/// Time, in τ, after a break-away or reversal. Within this time rounding would decide the sign of the velocity.
const GRACE: f64 = 2e-6;

/// Number of halvings up to which the integrator also looks for pairs of events within one step.
const GRAZES: usize = 14;
/// If the distance of the force from the break-away level is below this fraction of the level, the step is halved.
const NEAR: f64 = 1e-6;

/// Returns the minimum over the unit interval of a cubic polynomial, from value and slope at both ends of the
/// interval.
fn lowest([a, slope_a]: [f64; 2], [b, slope_b]: [f64; 2]) -> f64 {
    let (quadratic, cubic) = (
        3.0 * (b - a) - 2.0 * slope_a - slope_b,
        2.0 * (a - b) + slope_a + slope_b,
    );
    let root = (quadratic * quadratic - 3.0 * cubic * slope_a).sqrt();
    let places = [
        (-quadratic + root) / (3.0 * cubic),
        slope_a / (-quadratic - root),
    ];
    let places = places
        .into_iter()
        .filter(|place| (0.0..1.0).contains(place));
    let value = |t: f64| a + t * (slope_a + t * (quadratic + t * cubic));
    places.map(value).fold(a.min(b), f64::min)
}

/// A scene at one frequency ratio and one friction ratio. A state vector has x, dx/dτ, cos τ, sin τ and 1.
pub struct Plain {
    masses: usize,
    /// Matrices exp(A·step/2^k), one for each number k of halvings, for a contact that slides backward, sticks or
    /// slides forward.
    moves: [Vec<DMatrix<f64>>; 3],
    /// `rate` and `holding` are row vectors that multiply the state. `rate` gives the velocity of z̄. `holding` gives
    /// the contact force that keeps this velocity constant.
    rate: DVector<f64>,
    holding: DVector<f64>,
    /// Row vectors that give the derivative of the quantity that decides the next event, for a contact that slides
    /// backward, sticks or slides forward.
    slopes: [DVector<f64>; 3],
    /// Γ⁻¹w/m*, the change of the masses' velocities for a unit change of the contact's velocity.
    lift: DVector<f64>,
    grip: f64,
}

/// A run in time.
pub struct Run<'p> {
    plain: &'p Plain,
    pub state: DVector<f64>,
    /// Direction of sliding: −1, 0 (stuck) or 1.
    pub way: i32,
    grace: f64,
    pub stops: usize,
    pub reversals: usize,
    pub stuck: f64,
    /// Largest |x| of each mass; `None` if the run does not record it.
    pub largest: Option<Vec<f64>>,
}

/// Mass matrix divided by m₁, stiffness by k₁, damping by √(m₁k₁), the load and contact vectors, and the coefficient
/// s of the base motion.
type Matrices = (
    DMatrix<f64>,
    DMatrix<f64>,
    DMatrix<f64>,
    [DVector<f64>; 2],
    f64,
);

fn matrices(scene: &Scene) -> Matrices {
    let n = scene.masses.len();
    let (m1, k1) = (scene.masses[0].value, scene.springs[0].stiffness);
    let mass = DMatrix::from_fn(n, n, |i, j| {
        if i == j {
            scene.masses[i].value / m1
        } else {
            0.0
        }
    });
    let mut stiffness = DMatrix::zeros(n, n);
    let (mut load, mut contact) = (DVector::zeros(n), DVector::zeros(n));
    let on_base = scene.excitation == Excitation::Base;
    for spring in &scene.springs {
        let k = spring.stiffness / k1;
        let ends = [spring.from, spring.to];
        for (end, other) in [(ends[0], ends[1]), (ends[1], ends[0])] {
            let Node::Mass(i) = end else { continue };
            stiffness[(i, i)] += k;
            match other {
                Node::Mass(j) => stiffness[(i, j)] -= k,
                Node::Base if on_base => load[i] += k,
                _ => {}
            }
        }
    }
    if let Excitation::Force(i) = scene.excitation {
        load[i] = 1.0;
    }
    let mut share = 0.0;
    let ends = [scene.contact.from, scene.contact.to];
    match ends {
        [Node::Mass(a), Node::Mass(b)] => {
            contact[a.min(b)] = -1.0;
            contact[a.max(b)] = 1.0;
        }
        [Node::Mass(a), other] | [other, Node::Mass(a)] => {
            contact[a] = 1.0;
            share = f64::from(u8::from(other == Node::Base && on_base));
        }
        _ => panic!("a contact without a mass"),
    }
    let root = mass.map(f64::sqrt);
    let inverse = root.map(|value| if value > 0.0 { 1.0 / value } else { 0.0 });
    let eigen = (&inverse * &stiffness * &inverse).symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let mut damping = DMatrix::zeros(n, n);
    let unit = (m1 / k1).sqrt();
    for (place, mode) in order.into_iter().enumerate() {
        let sigma = eigen.eigenvalues[mode].sqrt();
        let zeta = match &scene.damping {
            Damping::None => 0.0,
            Damping::Uniform(zeta) => *zeta,
            Damping::Modal(zetas) => zetas[place],
            Damping::Rayleigh { mass, stiffness } => {
                (mass * unit / sigma + stiffness / unit * sigma) / 2.0
            }
        };
        let shape = &root * eigen.eigenvectors.column(mode);
        damping += 2.0 * zeta * sigma * &shape * shape.transpose();
    }
    (mass, stiffness, damping, [load, contact], share)
}

impl Plain {
    pub fn new(scene: &Scene, r: f64, beta: f64) -> Self {
        let (mass, stiffness, damping, [load, contact], share) = matrices(scene);
        let n = mass.nrows();
        let size = 2 * n + 3;
        let weights = mass.map(|value| if value > 0.0 { 1.0 / value } else { 0.0 });
        let mobility = (contact.transpose() * &weights * &contact)[(0, 0)];
        let lift = &weights * &contact / mobility;
        // This matrix times the state is dv/dτ without the contact force.
        let mut free = DMatrix::zeros(n, size);
        free.view_mut((0, 0), (n, n))
            .copy_from(&(-&weights * &stiffness / (r * r)));
        free.view_mut((0, n), (n, n))
            .copy_from(&(-&weights * &damping / r));
        free.view_mut((0, 2 * n), (n, 1))
            .copy_from(&(&weights * &load / (r * r)));
        let row = |values: &DVector<f64>, from: usize| {
            let mut row = DVector::zeros(size);
            row.rows_mut(from, n).copy_from(values);
            row
        };
        let mut rate = row(&contact, n);
        rate[2 * n + 1] = share;
        // This row vector times the state is wᵀv′ + s cos τ, divided by its change for a unit of contact force.
        let mut holding = free.transpose() * &contact;
        holding[2 * n] += share;
        holding *= r * r / mobility;
        let rates = [-1, 0, 1].map(|way| {
            let mut rates = DMatrix::zeros(size, size);
            rates.view_mut((0, n), (n, n)).fill_with_identity();
            let mut acceleration = free.clone();
            let push = &weights * &contact / (r * r);
            if way == 0 {
                acceleration -= &push * holding.transpose();
            } else {
                let mut column = acceleration.column_mut(2 * n + 2);
                column -= &push * (f64::from(way) * beta);
            }
            rates.view_mut((n, 0), (n, size)).copy_from(&acceleration);
            rates[(2 * n, 2 * n + 1)] = -1.0;
            rates[(2 * n + 1, 2 * n)] = 1.0;
            rates
        });
        let slopes = [&rate, &holding, &rate];
        let slopes = [0, 1, 2].map(|i| rates[i].transpose() * slopes[i]);
        let moves = rates.map(|rates| {
            let step = TAU / f64::from(STEPS);
            let halved = |k: usize| (&rates * (step / (1_u64 << k) as f64)).exp();
            (0..=HALVINGS).map(halved).collect()
        });
        let grip = beta * scene.stiction;
        Self {
            masses: n,
            moves,
            rate,
            holding,
            slopes,
            lift,
            grip,
        }
    }

    /// Returns a run that starts at rest at a maximum of the excitation.
    pub fn rest(&self) -> Run<'_> {
        self.from(&vec![0.0; 2 * self.masses])
    }

    /// Returns a run that starts at a maximum of the excitation with the given displacements and velocities. The contact
    /// slides, or has no velocity.
    pub fn from(&self, start: &[f64]) -> Run<'_> {
        let mut state = DVector::zeros(2 * self.masses + 3);
        state.rows_mut(0, start.len()).copy_from_slice(start);
        (state[2 * self.masses], state[2 * self.masses + 2]) = (1.0, 1.0);
        let (rate, force) = (self.rate.dot(&state), self.holding.dot(&state));
        let way = if rate != 0.0 {
            rate.signum() as i32
        } else if force.abs() <= self.grip {
            0
        } else {
            force.signum() as i32
        };
        let (stops, reversals, stuck, largest) = (0, 0, 0.0, None);
        Run {
            plain: self,
            state,
            way,
            grace: GRACE,
            stops,
            reversals,
            stuck,
            largest,
        }
    }
}

impl Run<'_> {
    /// Advances the run by a cycle of the excitation.
    pub fn cycle(&mut self) {
        for _ in 0..STEPS {
            self.step(0);
        }
        // The state gets the exact value of the excitation, which is more accurate than that of the matrix
        // exponential.
        let n = self.plain.masses;
        (self.state[2 * n], self.state[2 * n + 1]) = (1.0, 0.0);
    }

    /// Resets the counts of events, and begins to record the largest displacements of the masses.
    pub fn count(&mut self) {
        (self.stops, self.reversals, self.stuck) = (0, 0, 0.0);
        self.largest = Some(vec![0.0; self.plain.masses]);
    }

    fn step(&mut self, halvings: usize) {
        let plain = self.plain;
        let length = TAU / f64::from(STEPS) / (1_u64 << halvings) as f64;
        let next = &plain.moves[(self.way + 1) as usize][halvings] * &self.state;
        let row = if self.way == 0 {
            &plain.holding
        } else {
            &plain.rate
        };
        let slope = &plain.slopes[(self.way + 1) as usize];
        let [from, to] =
            [&self.state, &next].map(|state| [row.dot(state), length * slope.dot(state)]);
        // The closure returns the distance from the next event at the end of the step, and the smallest distance within
        // the step. The distance is a velocity while the contact slides, and a force while it sticks.
        let room = |sign: f64, limit: f64| {
            let [from, to] = [from, to].map(|[value, slope]| [limit - sign * value, -sign * slope]);
            (
                to[0],
                if halvings < GRAZES {
                    lowest(from, to)
                } else {
                    to[0]
                },
            )
        };
        let (at_end, within) = if self.way == 0 {
            let (a, b) = (room(1.0, plain.grip), room(-1.0, plain.grip));
            (a.0.min(b.0), a.1.min(b.1) - NEAR * plain.grip)
        } else if self.grace < length {
            room(-f64::from(self.way), 0.0)
        } else {
            (1.0, 1.0)
        };
        let happens = at_end < 0.0;
        if within < 0.0 && halvings < GRAZES {
            self.step(halvings + 1);
            return self.step(halvings + 1);
        }
        if happens && halvings < HALVINGS {
            self.step(halvings + 1);
            return self.step(halvings + 1);
        }
        self.note_peaks(&next, halvings);
        self.state = next;
        self.grace -= length;
        if self.way == 0 {
            self.stuck += length;
        }
        if happens {
            self.turn();
        }
    }

    /// Applies an event: a break-away, a stop or a reversal.
    fn turn(&mut self) {
        let plain = self.plain;
        let n = plain.masses;
        let rate = plain.rate.dot(&self.state);
        let mut rates = self.state.rows_mut(n, n);
        rates -= &plain.lift * rate;
        let force = plain.holding.dot(&self.state);
        if self.way == 0 {
            self.way = force.signum() as i32;
        } else if force.abs() <= plain.grip {
            self.way = 0;
            self.stops += 1;
        } else {
            let way = force.signum() as i32;
            self.reversals += usize::from(way != self.way);
            self.way = way;
        }
        self.grace = GRACE;
    }

    /// Records the largest |x| of each mass within a step: at its end points, and where a velocity changes its sign.
    fn note_peaks(&mut self, next: &DVector<f64>, halvings: usize) {
        let Some(mut largest) = self.largest.take() else {
            return;
        };
        let n = self.plain.masses;
        let moves = &self.plain.moves[(self.way + 1) as usize];
        for (mass, largest) in largest.iter_mut().enumerate() {
            let mut state = self.state.clone();
            if state[n + mass] * next[n + mass] < 0.0 {
                for halved in &moves[halvings + 1..] {
                    let on = halved * &state;
                    if on[n + mass] * next[n + mass] <= 0.0 {
                        state = on;
                    }
                }
            }
            for value in [state[mass], next[mass]] {
                *largest = largest.max(value.abs());
            }
        }
        self.largest = Some(largest);
    }
}

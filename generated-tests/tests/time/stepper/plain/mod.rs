//! Integrates the motion in time, with an integrator that shares no code with this project.
//!
//! The displacements of the masses are Taylor series, which follow from the equations of motion with dense matrices.
//! The force in a stuck contact follows from the constraint. Events are zeros of polynomials. Bounds prove that
//! intervals have no zero, so the integrator misses none.
//!
//! A step is divided into sub-steps. The sub-steps are so short, and the series so long, that the remainder is below
//! rounding.

pub mod chain;
mod work;
pub mod zeros;

use chain::Chain;
use nalgebra::DVector;
use zeros::{first, shifted, slope, value};

/// Largest length of a sub-step, as the angle in rad by which the fastest mode turns.
const PART: f64 = 0.4;

/// Returns the number of terms of a series over a sub-step in which the fastest mode turns by `radians`. The
/// remainder of the series is below 1e-22 of the motion.
fn order(radians: f64) -> usize {
    let (mut term, mut order) = (1.0, 0);
    while term > 1e-22 || order < 5 {
        order += 1;
        term *= radians / order as f64;
    }
    order
}

/// State of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slip {
    Stuck,
    /// The contact slides in the direction of this sign, on this line of the friction law.
    Slides(f64, usize),
}

/// The input over one step, as polynomials of the time since the start of the step.
#[derive(Clone, Debug)]
pub struct Input {
    /// Force on each mass: its value at the start and its slope.
    pub forces: Vec<[f64; 2]>,
    /// Displacement of the base.
    pub base: [f64; 4],
    /// Kinetic friction force F.
    pub friction: f64,
}

/// Work and losses in J since the start of the run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// Work of the forces, ∫ p ẋ, and of the base through its springs, ∫ (k_base y) ẋ. The force k_base y has no
    /// potential, because y is prescribed.
    pub load: f64,
    /// Work that goes into the contact, ∫ f ż.
    pub friction: f64,
    /// Loss by damping, ∫ (ẋ − e ẏ)ᵀC(ẋ − e ẏ).
    pub damping: f64,
    /// Work of the base through the contact, ∫ s f ẏ.
    pub carried: f64,
}

/// A run of the integrator.
#[derive(Clone, Debug)]
pub struct Plain {
    pub chain: Chain,
    pub x: DVector<f64>,
    pub v: DVector<f64>,
    pub slip: Slip,
    pub work: Work,
    /// Number of stops, break-aways and reversals since the start of the run.
    pub events: u64,
    /// Contact force at the end of the last step.
    pub force: f64,
    /// `held_at` is z while the contact sticks. `base_rate` is the velocity of the base at the end of the last step.
    /// `wedged` is true if the force has reached the break-away level without a slip.
    held_at: f64,
    base_rate: f64,
    /// Largest term in the sum for `base_rate`. It measures the rounding error of `base_rate`, which may itself be
    /// zero.
    base_rate_size: f64,
    wedged: bool,
    order: usize,
    /// True if the run computes the work.
    pub metered: bool,
}

/// Series over a sub-step: displacements and contact force.
struct Series {
    x: Vec<DVector<f64>>,
    /// Coefficients of z as a polynomial of the time.
    z: Vec<f64>,
    force: Vec<f64>,
}

impl Plain {
    /// Creates a run from a state of the masses and of the base.
    pub fn new(chain: Chain, (x, v): (&[f64], &[f64]), base: [f64; 2]) -> Self {
        let mut run = Self {
            x: DVector::from_column_slice(x),
            v: DVector::from_column_slice(v),
            chain,
            slip: Slip::Stuck,
            work: Work::default(),
            events: 0,
            force: 0.0,
            held_at: 0.0,
            base_rate: base[1],
            base_rate_size: base[1].abs(),
            wedged: false,
            order: 0,
            metered: true,
        };
        let [z, velocity] = run.relative(base);
        run.held_at = z;
        if velocity != 0.0 {
            run.slip = Slip::Slides(velocity.signum(), run.piece(velocity.abs()));
        }
        run
    }

    /// Returns z and ż of the contact, for this displacement and velocity of the base.
    pub fn relative(&self, base: [f64; 2]) -> [f64; 2] {
        let chain = &self.chain;
        [
            chain.w.dot(&self.x) - chain.s * base[0],
            chain.w.dot(&self.v) - chain.s * base[1],
        ]
    }

    /// Returns the energy ½ẋᵀMẋ + ½xᵀKx.
    pub fn stored(&self) -> f64 {
        let kinetic = self.v.component_mul(&self.chain.m).dot(&self.v);
        0.5 * (kinetic + (&self.chain.k * &self.x).dot(&self.x))
    }

    /// Returns the index of the line of the friction law that contains this speed.
    fn piece(&self, speed: f64) -> usize {
        let law = &self.chain.law;
        law.iter()
            .rposition(|point| point[0] <= speed)
            .expect("the law starts at 0")
    }

    /// Returns the kinetic friction force, divided by F, on a line of the friction law. The results are the value of
    /// the line at speed 0 and its slope.
    fn level(&self, piece: usize) -> [f64; 2] {
        let law = &self.chain.law;
        let [v0, f0] = law[piece];
        let Some([v1, f1]) = law.get(piece + 1) else {
            return [f0, 0.0];
        };
        let slope = (f1 - f0) / (v1 - v0);
        [f0 - slope * v0, slope]
    }

    /// Advances the run by one step with this input.
    pub fn advance(&mut self, input: &Input, dt: f64) {
        let [place, rate, ..] = input.base;
        let [z, relative] = self.relative([place, rate]);
        // A jump of the base's displacement does not move the masses. A jump of the base's velocity may reverse the
        // contact.
        self.held_at = z;
        let jump = (rate - self.base_rate).abs();
        let jumps = jump > 1e-9 * rate.abs().max(self.base_rate_size);
        if self.chain.s != 0.0 && jumps {
            self.slip = Slip::Slides(relative.signum(), self.piece(relative.abs()));
        }
        let forces: Vec<Vec<f64>> = input.forces.iter().map(|force| force.to_vec()).collect();
        self.advance_along(&input.base, &forces, input.friction, dt);
    }

    /// Advances the run over a time `dt`. Polynomials give the base's displacement and the forces. They continue
    /// those of the previous call without a jump.
    pub fn advance_along(&mut self, motion: &[f64], forces: &[Vec<f64>], friction: f64, dt: f64) {
        let radians = dt * self.chain.rate(friction);
        let parts = (radians / PART).ceil().max(1.0);
        self.order = order(radians / parts).max(motion.len());
        let rates = slope(motion);
        self.base_rate = value(&rates, dt);
        let terms = rates.iter().enumerate();
        self.base_rate_size = terms.fold(0.0, |size, (power, rate)| {
            size.max((rate * dt.powi(power as i32)).abs())
        });
        for part in 0..parts as usize {
            // Polynomials of the input about the start of the sub-step.
            let from = dt * part as f64 / parts;
            let span = dt * (part + 1) as f64 / parts - from;
            let base = shifted(motion, from);
            let loads = forces.iter().map(|force| shifted(force, from));
            self.part(base, loads.collect(), friction, span);
        }
    }

    /// Advances the run by one sub-step, from event to event.
    fn part(&mut self, mut base: Vec<f64>, mut loads: Vec<Vec<f64>>, friction: f64, span: f64) {
        let mut left = span;
        let mut known: Option<f64> = None;
        let grip = self.chain.mu * friction;
        for _ in 0..100_000 {
            let mut series = self.series(&base, &loads, friction);
            if self.slip == Slip::Stuck && series.force[0].abs() > grip * (1.0 + 1e-13) {
                let sign = series.force[0].signum();
                known = Some(series.force[0].abs() - friction);
                self.slip = Slip::Slides(sign, 0);
                self.events += 1;
                series = self.series(&base, &loads, friction);
            }
            let (at, next) = self.next(&series, friction, left, known.take());
            self.collect(&series, &base, &loads, at);
            (self.x, self.v) = Self::at(&series, at);
            self.force = value(&series.force, at);
            left -= at;
            base = shifted(&base, at);
            for load in &mut loads {
                *load = shifted(load, at);
            }
            if self.slip == Slip::Stuck {
                self.pin(&base);
            }
            match next {
                Next::End => return,
                Next::Slips(sign) => {
                    self.slip = Slip::Slides(sign, 0);
                    self.events += 1;
                    known = Some(grip - friction);
                }
                Next::Piece(piece) => {
                    if let Slip::Slides(sign, _) = self.slip {
                        self.slip = Slip::Slides(sign, piece);
                    }
                }
                Next::Holds => {
                    self.slip = Slip::Stuck;
                    self.wedged = true;
                    self.events -= 1;
                    self.rest(&base);
                }
                Next::Halts => {
                    self.rest(&base);
                    self.slip = Slip::Stuck;
                    self.wedged = false;
                    let holding = self.series(&base, &loads, friction).force[0];
                    self.events += 1;
                    if holding.abs() > grip {
                        self.slip = Slip::Slides(holding.signum(), 0);
                        known = Some(holding.abs() - friction);
                    }
                }
            }
            if left <= 0.0 {
                return;
            }
        }
        panic!("events without end");
    }

    /// Moves the contact back to its stuck position, to remove rounding errors.
    fn pin(&mut self, base: &[f64]) {
        let [z, _] = self.relative([base[0], base[1]]);
        let held_at = self.held_at;
        let chain = &self.chain;
        self.x -= chain.w.component_div(&chain.m) * ((z - held_at) / chain.inverse_mass);
        self.rest(base);
        self.held_at = held_at;
    }

    /// Sets the relative velocity to exactly 0, by an impulse at the contact.
    fn rest(&mut self, base: &[f64]) {
        let [z, rate] = self.relative([base[0], base[1]]);
        let chain = &self.chain;
        self.v -= chain.w.component_div(&chain.m) * (rate / chain.inverse_mass);
        self.held_at = z;
    }

    fn series(&self, base: &[f64], loads: &[Vec<f64>], friction: f64) -> Series {
        let chain = &self.chain;
        let mut x = vec![self.x.clone(), self.v.clone()];
        let of_base = |k: usize| base.get(k).copied().unwrap_or(0.0);
        let mut z = vec![
            chain.w.dot(&x[0]) - chain.s * of_base(0),
            chain.w.dot(&x[1]) - chain.s * of_base(1),
        ];
        let mut force = Vec::new();
        for k in 0..self.order {
            let both = ((k + 1) * (k + 2)) as f64;
            let load = DVector::from_iterator(
                loads.len(),
                loads.iter().map(|load| load.get(k).copied().unwrap_or(0.0)),
            );
            let moved = &x[k + 1] - &chain.carried * of_base(k + 1);
            let free = (load + &chain.to_base * of_base(k)
                - &chain.c * moved * (k + 1) as f64
                - &chain.k * &x[k])
                .component_div(&chain.m);
            let f = match self.slip {
                Slip::Stuck => {
                    (chain.w.dot(&free) - chain.s * both * of_base(k + 2)) / chain.inverse_mass
                }
                Slip::Slides(sign, piece) => {
                    let [level, steep] = self.level(piece);
                    let constant = if k == 0 { sign * friction * level } else { 0.0 };
                    constant + friction * steep * (k + 1) as f64 * z[k + 1]
                }
            };
            let next = (free - chain.w.component_div(&chain.m) * f) / both;
            z.push(if self.slip == Slip::Stuck {
                0.0
            } else {
                chain.w.dot(&next) - chain.s * of_base(k + 2)
            });
            x.push(next);
            force.push(f);
        }
        Series { x, z, force }
    }

    /// Returns the time to the next event, and the event. If the contact has just left rest, `excess` is the contact
    /// force minus the friction force.
    fn next(&self, series: &Series, friction: f64, left: f64, excess: Option<f64>) -> (f64, Next) {
        let Slip::Slides(sign, piece) = self.slip else {
            let size = 1.0 + if self.wedged { 1e-13 } else { 0.0 };
            let grip = self.chain.mu * friction * size;
            let reach = |side: f64| {
                let mut c: Vec<f64> = series.force.iter().map(|f| -side * f).collect();
                c[0] = (grip + c[0]).max(0.0);
                first(&c, 0.0, left).map(|at| (at, side))
            };
            let found = [1.0, -1.0].into_iter().filter_map(reach);
            return match found.min_by(|a, b| a.0.total_cmp(&b.0)) {
                Some((at, side)) => (at, Next::Slips(side)),
                None => (left, Next::End),
            };
        };
        let mut speed: Vec<f64> = slope(&series.z).iter().map(|rate| sign * rate).collect();
        let halt;
        if let Some(excess) = excess {
            // After a rest the first coefficients are known exactly. A division by t or t² removes the zero of the
            // polynomial at the start.
            speed[0] = 0.0;
            speed[1] = self.chain.inverse_mass * excess;
            let lead = if excess > 0.0 { 1 } else { 2 };
            if speed[lead] <= 0.0 {
                return (0.0, Next::Holds);
            }
            halt = first(&speed[lead..], 0.0, left);
        } else if speed[0] <= 0.0 {
            return (0.0, Next::Halts);
        } else {
            halt = first(&speed, 0.0, left);
        }
        let mut best = halt.map_or((left, Next::End), |at| (at, Next::Halts));
        let law = &self.chain.law;
        let mut cross = |c: &[f64], next: usize, edge: f64| {
            let found = if c[0].abs() > 1e-13 * edge {
                first(c, 0.0, best.0)
            } else if c[1] < 0.0 {
                Some(0.0)
            } else {
                // The speed is exactly that of a point of the law, and moves away from it along this line. A division
                // removes the zero of the polynomial at the start.
                first(&c[1..], 0.0, best.0)
            };
            if let Some(at) = found.filter(|at| *at < best.0 || best.1 == Next::End) {
                best = (at, Next::Piece(next));
            }
        };
        if let Some([above, _]) = law.get(piece + 1) {
            let mut c: Vec<f64> = speed.iter().map(|speed| -speed).collect();
            c[0] += above;
            cross(&c, piece + 1, *above);
        }
        if piece > 0 {
            let mut c = speed.clone();
            c[0] -= law[piece][0];
            cross(&c, piece - 1, law[piece][0]);
        }
        best
    }

    /// Returns displacements and velocities of the masses at an instant of a series.
    fn at(series: &Series, t: f64) -> (DVector<f64>, DVector<f64>) {
        let mut terms = series.x.iter().enumerate().rev();
        let (last, top) = terms.next().expect("terms");
        let (mut x, mut v) = (top.clone(), top * last as f64);
        for (k, term) in terms {
            x = x * t + term;
            if k > 0 {
                v = v * t + term * k as f64;
            }
        }
        (x, v)
    }
}

/// Event or bound at which a piece of motion without events ends.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Next {
    End,
    Halts,
    Holds,
    Slips(f64),
    Piece(usize),
}

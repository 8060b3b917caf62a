//! Integrates the equations of motion by Runge-Kutta steps of fourth order. A step ends where the contact reaches a
//! point of its law, stops or breaks away. Bisection finds that instant.

use crate::stepper::plain::chain::Chain;
use nalgebra::DVector;

/// State of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Slip {
    Stuck,
    /// The contact slides in the direction of this sign, on this line of the friction law.
    Slides(f64, usize),
}

/// A harmonic load on a mass, or a harmonic motion of the base.
#[derive(Clone, Copy, Debug)]
pub struct Load {
    pub on: Option<usize>,
    pub amplitude: f64,
    pub omega: f64,
    /// Kinetic friction force F.
    pub friction: f64,
}

/// A run from rest, with the load at its maximum at the start.
#[derive(Debug)]
pub struct Run {
    pub chain: Chain,
    load: Load,
    pub x: DVector<f64>,
    pub v: DVector<f64>,
    slip: Slip,
    time: f64,
    /// Number of stops, break-aways and reversals since the start.
    pub events: usize,
    /// Number of times that the speed has reached a point of the law.
    pub crossed: usize,
}

type State = (DVector<f64>, DVector<f64>);

impl Run {
    pub fn new(chain: Chain, load: Load) -> Self {
        let rest = DVector::zeros(chain.m.len());
        let mut run = Self {
            x: rest.clone(),
            v: rest,
            chain,
            load,
            slip: Slip::Stuck,
            time: 0.0,
            events: 0,
            crossed: 0,
        };
        let force = run.holding(&(run.x.clone(), run.v.clone()), 0.0);
        if force.abs() > run.grip() {
            run.slip = Slip::Slides(force.signum(), 0);
        }
        run
    }

    fn grip(&self) -> f64 {
        self.chain.mu * self.load.friction
    }

    /// Returns displacement, velocity and acceleration of the base.
    fn base(&self, time: f64) -> [f64; 3] {
        let Load {
            amplitude,
            omega,
            on,
            ..
        } = self.load;
        let (sine, cosine) = (omega * time).sin_cos();
        match on {
            Some(_) => [0.0; 3],
            None => [
                amplitude * cosine,
                -amplitude * omega * sine,
                -amplitude * omega * omega * cosine,
            ],
        }
    }

    /// Returns M times the acceleration of the masses without the contact force.
    fn pull(&self, (x, v): &State, time: f64) -> DVector<f64> {
        let mut sum = -(&self.chain.k * x) - &self.chain.c * v;
        sum += &self.chain.to_base * self.base(time)[0];
        if let Some(mass) = self.load.on {
            sum[mass] += self.load.amplitude * (self.load.omega * time).cos();
        }
        sum
    }

    /// Returns the contact force that keeps the relative velocity constant.
    fn holding(&self, state: &State, time: f64) -> f64 {
        let free = self.pull(state, time).component_div(&self.chain.m);
        let own = self.chain.s * self.base(time)[2];
        (self.chain.w.dot(&free) - own) / self.chain.inverse_mass
    }

    fn velocity(&self, (_, v): &State, time: f64) -> f64 {
        self.chain.w.dot(v) - self.chain.s * self.base(time)[1]
    }

    fn force(&self, state: &State, time: f64) -> f64 {
        match self.slip {
            Slip::Stuck => self.holding(state, time),
            Slip::Slides(sign, line) => {
                let law = &self.chain.law;
                let [v0, f0] = law[line];
                let slope = law
                    .get(line + 1)
                    .map_or(0.0, |[v1, f1]| (f1 - f0) / (v1 - v0));
                let speed = sign * self.velocity(state, time);
                sign * self.load.friction * (f0 + slope * (speed - v0))
            }
        }
    }

    fn rates(&self, state: &State, time: f64) -> State {
        let force = self.force(state, time);
        let pull = self.pull(state, time) - &self.chain.w * force;
        (state.1.clone(), pull.component_div(&self.chain.m))
    }

    fn moved(&self, h: f64) -> State {
        let start = (self.x.clone(), self.v.clone());
        let plus = |(x, v): &State, h: f64| (&start.0 + x * h, &start.1 + v * h);
        let half = self.time + 0.5 * h;
        let a = self.rates(&start, self.time);
        let b = self.rates(&plus(&a, 0.5 * h), half);
        let c = self.rates(&plus(&b, 0.5 * h), half);
        let d = self.rates(&plus(&c, h), self.time + h);
        (
            &start.0 + (a.0 + (b.0 + c.0) * 2.0 + d.0) * (h / 6.0),
            &start.1 + (a.1 + (b.1 + c.1) * 2.0 + d.1) * (h / 6.0),
        )
    }

    /// Returns two numbers that stay positive while the contact does not change its state: the distance from the
    /// lower bound, and the distance from the upper bound.
    fn room(&self, state: &State, time: f64) -> [f64; 2] {
        match self.slip {
            Slip::Stuck => {
                let force = self.holding(state, time);
                [self.grip() + force, self.grip() - force]
            }
            Slip::Slides(sign, line) => {
                let law = &self.chain.law;
                let speed = sign * self.velocity(state, time);
                let above = law.get(line + 1).map_or(f64::INFINITY, |[v, _]| v - speed);
                [speed - law[line][0], above]
            }
        }
    }

    /// Advances the run by step `number` of length h.
    pub fn step(&mut self, number: usize, h: f64) {
        // The time follows from the number of the step, so that rounding errors do not add up.
        self.time = number as f64 * h;
        let mut left = h;
        while left > 0.0 {
            left -= self.cut(left);
        }
    }

    fn cut(&mut self, h: f64) -> f64 {
        let inside = |run: &Self, h: f64| {
            let state = run.moved(h);
            run.room(&state, run.time + h).map(|room| room >= 0.0)
        };
        let mut length = h;
        let mut met = inside(self, h);
        if met != [true; 2] {
            // `low` is the last instant before the event, and `high` is the first instant after it.
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let there = inside(self, middle);
                if there == [true; 2] {
                    low = middle;
                } else {
                    (high, met) = (middle, there);
                }
            }
            length = high;
        }
        (self.x, self.v) = self.moved(length);
        self.time += length;
        if let Some(side) = met.iter().position(|inside| !inside) {
            self.meet(side);
        }
        length
    }

    fn meet(&mut self, side: usize) {
        let state = (self.x.clone(), self.v.clone());
        self.slip = match self.slip {
            Slip::Stuck => {
                self.events += 1;
                // Side 0 is the lower bound −μF.
                Slip::Slides(if side == 0 { -1.0 } else { 1.0 }, 0)
            }
            Slip::Slides(sign, line) if side == 1 => {
                self.crossed += 1;
                Slip::Slides(sign, line + 1)
            }
            Slip::Slides(sign, line) if line > 0 => {
                self.crossed += 1;
                Slip::Slides(sign, line - 1)
            }
            Slip::Slides(sign, _) => {
                self.events += 1;
                let force = self.holding(&state, self.time);
                if force.abs() <= self.grip() {
                    Slip::Stuck
                } else {
                    Slip::Slides(if force * sign > 0.0 { sign } else { -sign }, 0)
                }
            }
        };
    }
}

//! Samples of a history, compared with a Runge-Kutta integrator that knows only masses and springs.

use crate::scenes::{SCENES, all, system};
use frictiongen::kernel::simulation::Contact;
use frictiongen::study::history::{History, HistoryRequest};
use frictiongen::study::scene::{Damping, Excitation, Node, Scene};
use std::f64::consts::TAU;

/// The equations of motion ω²Mx″ + ωCx′ + Kx + wf = p cos τ, with m₁ = k₁ = 1, so that ω = r.
struct Equations {
    r: f64,
    beta: f64,
    stiction: f64,
    mass: Vec<f64>,
    stiffness: Vec<Vec<f64>>,
    damping: Vec<Vec<f64>>,
    load: Vec<f64>,
    /// Direction vector w of the contact. `base` is the coefficient s of the base motion in z̄.
    direction: Vec<f64>,
    base: f64,
}

/// Displacements x and velocities dx/dτ of the masses.
type State = (Vec<f64>, Vec<f64>);

impl Equations {
    fn of(scene: &Scene, r: f64, beta: f64) -> Self {
        let count = scene.masses.len();
        let mass: Vec<f64> = scene.masses.iter().map(|mass| mass.value).collect();
        assert_eq!((mass[0], scene.springs[0].stiffness), (1.0, 1.0));
        let mut stiffness = vec![vec![0.0; count]; count];
        let mut load = vec![0.0; count];
        for spring in &scene.springs {
            let k = spring.stiffness;
            let (from, to) = (spring.from, spring.to);
            for (one, other) in [(from, to), (to, from)] {
                let Node::Mass(one) = one else { continue };
                stiffness[one][one] += k;
                match other {
                    Node::Mass(other) => stiffness[one][other] -= k,
                    Node::Base if scene.excitation == Excitation::Base => load[one] += k,
                    _ => {}
                }
            }
        }
        if let Excitation::Force(index) = scene.excitation {
            load[index] = 1.0;
        }
        let mut damping = vec![vec![0.0; count]; count];
        match &scene.damping {
            Damping::None => {}
            Damping::Uniform(zeta) if count == 1 => {
                damping[0][0] = 2.0 * zeta * stiffness[0][0].sqrt()
            }
            Damping::Modal(zeta) if count == 1 => {
                damping[0][0] = 2.0 * zeta[0] * stiffness[0][0].sqrt()
            }
            Damping::Rayleigh {
                mass: a,
                stiffness: b,
            } => {
                for i in 0..count {
                    damping[i][i] += a * mass[i];
                    for j in 0..count {
                        damping[i][j] += b * stiffness[i][j];
                    }
                }
            }
            _ => panic!("another damping"),
        }
        let mut direction = vec![0.0; count];
        let mut base = 0.0;
        let (from, to) = (scene.contact.from, scene.contact.to);
        match (from, to) {
            (Node::Mass(from), Node::Mass(to)) => {
                direction[from.min(to)] = -1.0;
                direction[from.max(to)] = 1.0;
            }
            (Node::Mass(mass), other) | (other, Node::Mass(mass)) => {
                direction[mass] = 1.0;
                if other == Node::Base && scene.excitation == Excitation::Base {
                    base = 1.0;
                }
            }
            _ => panic!("no contact"),
        }
        Self {
            r,
            beta,
            stiction: scene.stiction,
            mass,
            stiffness,
            damping,
            load,
            direction,
            base,
        }
    }

    /// Returns the accelerations of the masses without friction.
    fn free(&self, (x, v): &State, tau: f64) -> Vec<f64> {
        let row = |row: &[f64], of: &[f64]| -> f64 { row.iter().zip(of).map(|(a, b)| a * b).sum() };
        let force = |i: usize| {
            self.load[i] * tau.cos()
                - row(&self.stiffness[i], x)
                - self.r * row(&self.damping[i], v)
        };
        (0..x.len()).map(|i| force(i) / self.mass[i]).collect()
    }

    fn relative(&self, (x, v): &State, tau: f64) -> (f64, f64) {
        let along =
            |of: &[f64]| -> f64 { self.direction.iter().zip(of).map(|(w, of)| w * of).sum() };
        (
            along(x) - self.base * tau.cos(),
            along(v) + self.base * tau.sin(),
        )
    }

    /// Returns the friction force that keeps the relative velocity constant.
    fn holding(&self, state: &State, tau: f64) -> f64 {
        let free = self.free(state, tau);
        let w = self.direction.iter().zip(&self.mass);
        let inverse: f64 = w.map(|(w, mass)| w * w / mass).sum();
        let along: f64 = self.direction.iter().zip(&free).map(|(w, a)| w * a).sum();
        (along + self.base * self.r * self.r * tau.cos()) / inverse
    }

    fn friction(&self, state: &State, tau: f64, contact: Contact) -> f64 {
        match contact {
            Contact::Stuck => self.holding(state, tau),
            Contact::Forward => self.beta,
            Contact::Backward => -self.beta,
        }
    }

    fn rates(&self, state: &State, tau: f64, contact: Contact) -> State {
        let force = self.friction(state, tau, contact);
        let free = self.free(state, tau);
        let parts = free.iter().zip(&self.direction).zip(&self.mass);
        let accelerations =
            parts.map(|((free, w), mass)| (free - w * force / mass) / (self.r * self.r));
        (state.1.clone(), accelerations.collect())
    }

    /// Advances the state by one Runge-Kutta step of fourth order.
    fn step(&self, state: &State, tau: f64, h: f64, contact: Contact) -> State {
        let plus = |rates: &State, h: f64| -> State {
            let add = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + h * b).collect();
            (add(&state.0, &rates.0), add(&state.1, &rates.1))
        };
        let k1 = self.rates(state, tau, contact);
        let k2 = self.rates(&plus(&k1, h / 2.0), tau + h / 2.0, contact);
        let k3 = self.rates(&plus(&k2, h / 2.0), tau + h / 2.0, contact);
        let k4 = self.rates(&plus(&k3, h), tau + h, contact);
        let mean = |a: &[f64], b: &[f64], c: &[f64], d: &[f64]| -> Vec<f64> {
            (0..a.len())
                .map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0)
                .collect()
        };
        let rates = (
            mean(&k1.0, &k2.0, &k3.0, &k4.0),
            mean(&k1.1, &k2.1, &k3.1, &k4.1),
        );
        plus(&rates, h)
    }

    /// Returns a margin that is positive as long as the contact stays in its state.
    fn margin(&self, state: &State, tau: f64, contact: Contact) -> f64 {
        match contact {
            Contact::Stuck => self.stiction * self.beta - self.holding(state, tau).abs(),
            Contact::Forward => self.relative(state, tau).1,
            Contact::Backward => -self.relative(state, tau).1,
        }
    }

    /// Returns the state that the contact takes where its relative velocity vanishes.
    fn halted(&self, state: &State, tau: f64) -> Contact {
        let force = self.holding(state, tau);
        if force.abs() <= self.stiction * self.beta {
            Contact::Stuck
        } else if force > 0.0 {
            Contact::Forward
        } else {
            Contact::Backward
        }
    }

    /// Advances the state by h, through events, and counts the events.
    fn pass(&self, state: &mut State, tau: f64, h: f64, contact: &mut Contact, events: &mut usize) {
        let next = self.step(state, tau, h, *contact);
        // Just after an event the relative velocity is zero. Only its first half step then shows the direction.
        if self.margin(&next, tau + h, *contact) >= 0.0 {
            *state = next;
            return;
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let there = self.step(state, tau, middle, *contact);
            if self.margin(&there, tau + middle, *contact) >= 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        *state = self.step(state, tau, high, *contact);
        let at = tau + high;
        *contact = match *contact {
            Contact::Stuck if self.holding(state, at) > 0.0 => Contact::Forward,
            Contact::Stuck => Contact::Backward,
            _ => self.halted(state, at),
        };
        *events += 1;
        let rest = h - high;
        if rest > 0.0 {
            *state = self.step(state, at, rest, *contact);
        }
    }
}

/// Returns the largest differences of displacements, velocities and forces, and the number of compared values.
fn compare(equations: &Equations, history: &History, start: State) -> ([f64; 3], usize) {
    let masses = start.0.len();
    let mut state = start;
    let mut contact = if equations.relative(&state, 0.0).1 == 0.0 {
        equations.halted(&state, 0.0)
    } else {
        Contact::along_of(equations.relative(&state, 0.0).1)
    };
    let (mut worst, mut compared, mut events) = ([0.0_f64; 3], 0, 0);
    let steps = 40;
    let h = TAU / f64::from(history.samples) / f64::from(steps);
    for index in 0..history.len() {
        let tau = history.tau(index);
        let relative = equations.relative(&state, tau);
        for (track, motion) in history.tracks.iter().zip(
            std::iter::once(relative).chain((0..masses).map(|mass| (state.0[mass], state.1[mass]))),
        ) {
            worst[0] = worst[0].max((track.displacement[index] - motion.0).abs());
            worst[1] = worst[1].max((track.velocity[index] - motion.1).abs());
            compared += 2;
        }
        // The force jumps at an event, so samples next to one are left out.
        let beside = history
            .events
            .iter()
            .any(|event| (event.tau - tau).abs() < 1e-6);
        if !beside {
            assert_eq!(history.contact[index], contact, "τ = {tau}");
            let force = equations.friction(&state, tau, contact);
            worst[2] = worst[2].max((history.friction[index] - force).abs());
            compared += 1;
        }
        if index + 1 < history.len() {
            for step in 0..steps {
                let from = tau + h * f64::from(step);
                equations.pass(&mut state, from, h, &mut contact, &mut events);
            }
        }
    }
    assert_eq!(events, history.events.len());
    (worst, compared)
}

trait Along {
    fn along_of(velocity: f64) -> Self;
}

impl Along for Contact {
    fn along_of(velocity: f64) -> Self {
        if velocity < 0.0 {
            Self::Backward
        } else {
            Self::Forward
        }
    }
}

#[test]
fn samples_are_those_of_an_integrator() {
    let (mut worst, mut compared, mut runs) = ([0.0_f64; 3], 0, 0);
    for (text, points) in SCENES {
        let system = system(text);
        let masses = system.scene().masses.len();
        let rest = (vec![0.0; masses], vec![0.0; masses]);
        let thrown = (
            vec![0.3; masses],
            (0..masses).map(|mass| 0.4 - 0.7 * mass as f64).collect(),
        );
        for (r, beta) in points {
            for from in [None, Some(thrown.clone())] {
                let request = HistoryRequest {
                    cycles: 5,
                    samples: 100,
                    from: from.clone(),
                    ..HistoryRequest::new(&all(&system))
                };
                let history = system.history(*r, *beta, &request).unwrap();
                let equations = Equations::of(system.scene(), *r, *beta);
                let start = from.unwrap_or_else(|| rest.clone());
                let (differences, count) = compare(&equations, &history, start);
                for (worst, difference) in worst.iter_mut().zip(differences) {
                    *worst = worst.max(difference);
                }
                compared += count;
                runs += 1;
            }
        }
    }
    println!(
        "{runs} runs, {compared} values: displacements to {:.1e}, velocities to {:.1e}, forces to {:.1e}",
        worst[0], worst[1], worst[2]
    );
    assert!(compared > 90_000);
    assert!(worst[0] < 1e-7 && worst[1] < 1e-7 && worst[2] < 1e-7);
}

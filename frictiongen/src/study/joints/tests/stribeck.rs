//! Tests of chains with elastic contacts, and with rigid contacts whose kinetic friction depends on the sliding speed.

use super::super::{Motion, Series, State, Transition};
use super::{Chain, Joint, Random, Wave, random_chain, rigid};
use frictiongen_kernel::joints::value;
use frictiongen_model::scene::Node::{Base, Mass, Wall};
use std::f64::consts::TAU;

/// Number of small steps that replace a step of the Runge–Kutta method in which a sliding speed passes a point of the
/// friction law.
const KINK: u32 = 4096;
const LAW: [[f64; 2]; 3] = [[0.05, 0.75], [0.2, 0.5], [0.6, 0.9]];

/// Returns φ(|v|) of `LAW`, the kinetic friction force at the speed |v| divided by that at zero speed.
fn law(speed: f64) -> f64 {
    let mut before = [0.0, 1.0];
    for point in LAW {
        if speed < point[0] {
            let share = (speed - before[0]) / (point[0] - before[0]);
            return before[1] + share * (point[1] - before[1]);
        }
        before = point;
    }
    before[1]
}

/// Checks the force of each sliding rigid contact in random scenes. The force must follow the friction law at points
/// of every stretch (time interval of a power series). The test `a_frame_moves_as_by_small_steps` checks the equations
/// of motion.
#[test]
fn forces_follow_the_law() {
    let mut random = Random::new(31);
    let (mut worst, mut points, mut lines) = (0.0_f64, 0, [0; 4]);
    for _ in 0..60 {
        let (mut chain, omega) = random_chain(&mut random);
        chain.law = LAW.to_vec();
        let contacts = chain.contacts.clone();
        let mut motion = Motion::from_rest(&chain).expect("a chain");
        let model = motion.model().clone();
        let watch = &mut |series: &Series, end: f64, state: &State| {
            for (j, joint) in contacts.iter().enumerate() {
                let phase = f64::from(state.phases[j]);
                if joint.stiffness.is_some() || phase.abs() != 1.0 {
                    continue;
                }
                let contact = model.contacts[j];
                let speed = series.speed_terms(contact.plus, contact.minus);
                for part in 0..=4 {
                    let at = end * f64::from(part) / 4.0;
                    let v = value(&speed, at);
                    let size = series.velocity_terms(0)[0].abs().max(1e-3);
                    let want = phase * joint.level.constant * law(v.abs());
                    let miss = (series.force(j, at) - want).abs() / joint.level.constant;
                    assert!(miss < 1e-11 * (1.0 + size), "{miss:e} at the speed {v}");
                    worst = worst.max(miss);
                    points += 1;
                    lines[LAW.iter().take_while(|p| p[0] < v.abs()).count()] += 1;
                }
            }
        };
        motion.run(6.0 * TAU / omega, watch).expect("a motion");
    }
    println!("{points} forces, on the lines {lines:?}: {worst:.1e}");
    assert!(lines.iter().all(|count| *count > 200), "{lines:?}");
}

/// A frame with a rigid contact on the wall, a rigid contact on the base, and a brace (an elastic contact) between the
/// two masses.
fn frame(omega: f64) -> Chain {
    Chain {
        masses: vec![2.0, 1.5],
        springs: vec![(Base, Mass(0), 1500.0), (Mass(0), Mass(1), 1200.0)],
        dashpots: vec![(Mass(0), Mass(1), 1.5)],
        contacts: vec![
            rigid((Mass(0), Base), 4.0, 1.1),
            rigid((Mass(1), Wall), 3.0, 1.0),
            Joint {
                stiffness: Some(2500.0),
                speed: 0.0,
                ..rigid((Mass(0), Mass(1)), 5.0, 1.0)
            },
        ],
        law: LAW.to_vec(),
        loads: vec![(1, Wave::harmonic(22.0, omega))],
        ..Chain::default()
    }
}

/// Motion of `frame` by a Runge–Kutta method. The rigid contacts are between a mass and a support at rest. A mass
/// whose rigid contact sticks is therefore at rest.
struct Plain {
    omega: f64,
    time: f64,
    /// Displacements and velocities of the masses, and the force of the brace.
    state: [f64; 5],
}

impl Plain {
    fn rates(&self, time: f64, [x, y, v, w, brace]: [f64; 5], phases: &[i8]) -> [f64; 5] {
        let friction = |j: usize, level: f64, v: f64| f64::from(phases[j]) * level * law(v.abs());
        let between = 1200.0 * (y - x) + 1.5 * (w - v) + brace;
        let lower = -1500.0 * x + between - friction(0, 4.0, v);
        let upper = 22.0 * (self.omega * time).cos() - between - friction(1, 3.0, w);
        let moves = |j: usize| f64::from(u8::from(phases[j] != 0));
        let elastic = if phases[2] == 0 {
            2500.0 * (w - v)
        } else {
            0.0
        };
        [
            v,
            w,
            moves(0) * lower / 2.0,
            moves(1) * upper / 1.5,
            elastic,
        ]
    }

    /// Returns the index of the straight line of the law in which the speed of each mass lies.
    fn lines(&self) -> [usize; 2] {
        [2, 3].map(|i| LAW.partition_point(|point| point[0] < self.state[i].abs()))
    }

    /// Advances by one step.
    fn step(&mut self, step: f64, phases: &[i8]) {
        let add = |rates: [f64; 5], factor: f64| {
            std::array::from_fn(|i| self.state[i] + factor * rates[i])
        };
        let a = self.rates(self.time, self.state, phases);
        let b = self.rates(self.time + step / 2.0, add(a, step / 2.0), phases);
        let c = self.rates(self.time + step / 2.0, add(b, step / 2.0), phases);
        let d = self.rates(self.time + step, add(c, step), phases);
        for (i, value) in self.state.iter_mut().enumerate() {
            *value += step / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        }
        self.time += step;
    }

    /// Advances to the instant `until` while the contacts keep their phases. A mass whose rigid contact sticks has no
    /// velocity.
    fn run(&mut self, until: f64, phases: &[i8], longest: f64) {
        for (velocity, phase) in self.state[2..4].iter_mut().zip(phases) {
            if *phase == 0 {
                *velocity = 0.0;
            }
        }
        let steps = ((until - self.time) / longest).ceil().max(1.0);
        let step = (until - self.time) / steps;
        for _ in 0..steps as usize {
            let start = (self.time, self.state);
            let lines = self.lines();
            self.step(step, phases);
            if self.lines() != lines {
                // The force has a kink in this step. The code therefore repeats the step in small steps.
                (self.time, self.state) = start;
                for _ in 0..KINK {
                    self.step(step / f64::from(KINK), phases);
                }
            }
        }
        self.time = until;
    }
}

/// Compares the motion of `frame` with a Runge–Kutta method. The method uses the instants of the events from the
/// solver. At each event the state of the method must agree. A contact that stops has no velocity, and the force of a
/// contact that breaks away is at its limit.
#[test]
fn a_frame_moves_as_by_small_steps() {
    let (mut events, mut kinds) = (0, [0; 3]);
    for omega in [9.0, 17.0, 41.0] {
        let chain = frame(omega);
        let mut motion = Motion::from_rest(&chain).expect("a chain");
        let found = motion
            .run(5.0 * TAU / omega, &mut |_, _, _| {})
            .expect("a motion");
        let mut plain = Plain {
            omega,
            time: 0.0,
            state: [0.0; 5],
        };
        let mut phases = found.first().expect("an event").before.clone();
        for Transition {
            time,
            before,
            after,
        } in &found
        {
            assert_eq!(&phases, before);
            plain.run(*time, before, 4e-5);
            for j in 0..3 {
                if before[j] == after[j] {
                    continue;
                }
                let [x, y, v, w, brace] = plain.state;
                let loads = plain.rates(*time, plain.state, &[1, 1, before[2]]);
                let miss = match (j, before[j]) {
                    (0, 0) => (2.0 * loads[2] + 4.0).abs() - 1.1 * 4.0,
                    (1, 0) => (1.5 * loads[3] + 3.0).abs() - 3.0,
                    (2, 0) => brace.abs() - 5.0,
                    (0, _) => v,
                    (1, _) => w,
                    _ => w - v,
                };
                assert!(miss.abs() < 2e-6, "contact {j} at {time}: {miss:e} {x} {y}");
                kinds[j] += 1;
            }
            phases.clone_from(after);
            events += 1;
        }
        plain.run(5.0 * TAU / omega, &phases, 4e-5);
        let (x, v) = (&motion.state().x, &motion.state().v);
        let now = [x[0], x[1], v[0], v[1]];
        for (i, (got, want)) in now.iter().zip(plain.state).enumerate() {
            let size = if i < 2 { 1e-2 } else { 1e-2 * omega };
            let miss = (got - want).abs() / size;
            println!("ω {omega}, number {i}: {got:.6e}, {miss:.1e}");
            assert!(miss < 1e-9, "ω {omega}, number {i}: {got} {want}");
        }
    }
    println!("{events} events, by contact {kinds:?}");
    assert!(kinds.iter().all(|kind| *kind > 10), "{kinds:?}");
}

//! Runs a stepper under a sampled cosine. The motion must approach the steady state of `orbit`. From rest, it must
//! follow the event-driven motion in time. Both errors must have the order of the input's interpolation.

use crate::stepper::rig::{HOLD, Kind, LINEAR, Load, Rig, advance, begin, rig};
use crate::stepper::scenes::{BASE, ONE_ON_BASE, PAIR, WALL, WALL_BASE, sticky};
use frictiongen::System;
use frictiongen_model::scene::{Excitation, Scene};
use std::f64::consts::TAU;

/// A cosine load or base motion that is sampled `steps` times in a cycle.
struct Wave {
    steps: u32,
    dt: f64,
    omega: f64,
    amplitude: f64,
    excited: Option<usize>,
    masses: usize,
    friction: f64,
    k1: f64,
}

impl Wave {
    fn of(scene: &Scene, [r, beta]: [f64; 2], steps: u32) -> Self {
        let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
        let omega = r * (k1 / m1).sqrt();
        let amplitude = 0.01;
        Self {
            steps,
            dt: TAU / omega / f64::from(steps),
            omega,
            amplitude,
            excited: match scene.excitation {
                Excitation::Force(mass) => Some(mass),
                Excitation::Base => None,
            },
            masses: scene.masses.len(),
            friction: beta * k1 * amplitude,
            k1,
        }
    }

    fn at(&self, step: u32) -> Load {
        let (sine, cosine) = (TAU * f64::from(step % self.steps) / f64::from(self.steps)).sin_cos();
        let mut forces = vec![0.0; self.masses];
        let mut base = [0.0; 2];
        if let Some(mass) = self.excited {
            forces[mass] = self.k1 * self.amplitude * cosine;
        } else {
            base = [self.amplitude * cosine, -self.amplitude * self.omega * sine];
        }
        Load {
            base,
            forces,
            friction: self.friction,
        }
    }

    /// Takes the step with the number `step`. With zero-order hold the input is the sample at the start of the step.
    /// With linear input it is the sample at the end of the step.
    fn drive(&self, rig: &mut Rig<f64>, kind: Kind<'_>, step: u32) {
        let hold = kind.input == frictiongen_kernel::stepper::Input::Hold;
        advance(rig, &self.at(if hold { step } else { step + 1 }));
    }
}

/// Returns the largest distance of the last cycle from the steady state, divided by the amplitude, and the number of
/// stops.
fn from_orbit(
    text: &str,
    kind: Kind<'_>,
    at: [f64; 2],
    steps: u32,
    cycles: u32,
) -> (f64, u32, usize) {
    let system: System = text.parse().expect("a scene");
    let scene = system.scene();
    let frequency = system.at(at[0]).expect("in the domain");
    let orbit = frequency.orbit(at[1]).expect("a steady state");
    let wave = Wave::of(scene, at, steps);
    let mut rig = rig::<f64>(scene, kind, wave.dt);
    begin(&mut rig, &wave.at(0));
    for step in 0..(cycles - 1) * steps {
        wave.drive(&mut rig, kind, step);
    }
    let (mut worst, mut stops) = (0.0_f64, 0);
    let mut stuck = rig.contact().is_sticking();
    for step in 0..steps {
        wave.drive(&mut rig, kind, step);
        let now = rig.contact().is_sticking();
        stops += u32::from(now && !stuck);
        stuck = now;
        let tau = TAU * f64::from(step + 1) / f64::from(steps) - orbit.origin();
        for mass in 0..scene.masses.len() {
            let motion = orbit.mass_at(mass).expect("a mass");
            let found = rig.mass(mass).displacement() / wave.amplitude;
            worst = worst.max((found - motion.displacement(tau)).abs() / motion.amplitude());
        }
    }
    (worst, stops, orbit.stops())
}

/// Checks the order of the error with 50, 200 and 1000 steps in a cycle. The order must be 2 with linear input and 1
/// with zero-order hold. With cubics for the base it must be at least 2.
#[test]
fn tends_to_the_steady_state() {
    for (text, at, mu) in [
        (WALL, [0.9, 0.35], 1.0),
        (PAIR, [0.6, 0.3], 1.0),
        (PAIR, [0.25, 0.1], 1.2),
        (BASE, [0.7, 0.5], 1.0),
        (ONE_ON_BASE, [0.3, 0.05], 1.0),
        (WALL_BASE, [0.4, 0.3], 1.0),
    ] {
        let text = sticky(text, mu);
        let of = |kind, steps| from_orbit(&text, kind, at, steps, 120);
        let linear = [50, 200, 1000].map(|steps| of(LINEAR, steps));
        let hold = [50, 200, 1000].map(|steps| of(HOLD, steps));
        let order = |from: f64, to: f64, times: f64| (from / to).ln() / times.ln();
        let orders = [
            order(linear[0].0, linear[1].0, 4.0),
            order(linear[1].0, linear[2].0, 5.0),
            order(hold[1].0, hold[2].0, 5.0),
        ];
        println!("{at:?}, μ = {mu}: linear {linear:?}, hold {hold:?}, orders {orders:.2?}");
        assert!(linear[2].0 < 2e-5, "{text}: {linear:?}");
        assert!(orders[1] > 1.7, "{text}: {orders:?}");
        for (_, stops, want) in linear {
            assert_eq!(stops as usize, want, "{text}");
        }
        // With zero-order hold the base jumps, and the contact jumps with it.
        if !text.contains("excitation: base") {
            assert!((0.8..1.3).contains(&orders[2]), "{text}: {orders:?}");
        }
    }
}

/// Compares the stepper from rest, at every step, with the exact motion under the cosine itself.
#[test]
fn follows_the_event_driven_motion() {
    for (text, at, mu) in [
        (WALL, [0.9, 0.35], 1.0),
        (WALL, [0.3, 0.2], 1.0),
        (PAIR, [0.4, 0.2], 1.0),
        (WALL_BASE, [0.5, 0.3], 1.3),
    ] {
        let text = sticky(text, mu);
        let system: System = text.parse().expect("a scene");
        let off = |steps: u32| {
            let scene = system.scene();
            let wave = Wave::of(scene, at, steps);
            let mut rig = rig::<f64>(scene, LINEAR, wave.dt);
            begin(&mut rig, &wave.at(0));
            let mut exact = system.simulation(at[0], at[1]).expect("a run");
            let mut worst = 0.0_f64;
            for step in 0..6 * steps {
                wave.drive(&mut rig, LINEAR, step);
                let mut left = TAU / f64::from(steps);
                while left > 0.0 {
                    left -= exact.advance(left).expect("a reach").length;
                }
                for mass in 0..scene.masses.len() {
                    let found = rig.mass(mass).displacement() / wave.amplitude;
                    worst = worst.max((found - exact.run().mass(mass).displacement()).abs());
                }
            }
            worst
        };
        let [coarse, fine] = [200, 1600].map(off);
        let order = (coarse / fine).log2() / 3.0;
        println!("{at:?}, μ = {mu}: {coarse:.1e}, {fine:.1e}, order {order:.2}");
        assert!(fine < 1e-5 && order > 1.7, "{text}: {coarse:e}, {fine:e}");
    }
}

//! Runs the stepper and the plain integrator under the same input.

use crate::stepper::plain::chain::Chain;
use crate::stepper::plain::{Input as Polynomials, Plain};
use crate::stepper::plain_itself::hermite;
use crate::stepper::rig::{Kind, Load, Rig, advance, begin, rig};
use frictiongen_kernel::stepper::Input;
use frictiongen_model::scene::Scene;

/// A stepper and a plain integrator that both start from rest.
pub struct Both {
    pub plain: Plain,
    pub rig: Rig<f64>,
    kind: Input,
    last: Load,
    dt: f64,
    /// Largest displacement and velocity of any mass (`size`), and largest differences of displacements and velocities
    /// (`apart`).
    pub size: [f64; 2],
    pub apart: [f64; 2],
    /// Number of events of the stepper (`events`), and number of steps in which the integrator has another number of
    /// events (`otherwise`).
    pub events: u64,
    pub otherwise: u32,
}

impl Both {
    pub fn new(scene: &Scene, kind: Kind<'_>, dt: f64, start: &Load) -> Self {
        let rest = vec![0.0; scene.masses.len()];
        let mut rig = rig(scene, kind, dt);
        begin(&mut rig, start);
        Self {
            plain: Plain::new(Chain::of(scene, kind.law), (&rest, &rest), start.base),
            rig,
            kind: kind.input,
            last: start.clone(),
            dt,
            size: [0.0; 2],
            apart: [0.0; 2],
            events: 0,
            otherwise: 0,
        }
    }

    pub fn advance(&mut self, load: &Load) {
        let dt = self.dt;
        let polynomials = match self.kind {
            Input::Hold => Polynomials {
                forces: load.forces.iter().map(|force| [*force, 0.0]).collect(),
                base: [load.base[0], load.base[1], 0.0, 0.0],
                friction: load.friction,
            },
            Input::Linear => Polynomials {
                forces: self
                    .last
                    .forces
                    .iter()
                    .zip(&load.forces)
                    .map(|(from, to)| [*from, (to - from) / dt])
                    .collect(),
                base: hermite(self.last.base, load.base, dt),
                friction: load.friction,
            },
        };
        let before = self.plain.events;
        self.plain.advance(&polynomials, dt);
        let events = u64::from(advance(&mut self.rig, load).events);
        self.events += events;
        self.otherwise += u32::from(events != self.plain.events - before);
        self.last = load.clone();
        for mass in 0..load.forces.len() {
            let now = self.rig.mass(mass);
            let plain = [self.plain.x[mass], self.plain.v[mass]];
            for (k, found) in [now.displacement(), now.velocity()].into_iter().enumerate() {
                self.size[k] = self.size[k].max(plain[k].abs());
                self.apart[k] = self.apart[k].max((found - plain[k]).abs());
            }
        }
    }

    /// Returns the larger of two relative differences: of displacements, divided by the largest displacement, and of
    /// velocities, divided by the largest velocity.
    pub fn error(&self) -> f64 {
        (self.apart[0] / self.size[0]).max(self.apart[1] / self.size[1])
    }
}

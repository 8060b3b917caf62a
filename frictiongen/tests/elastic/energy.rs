//! Energy of a motion: the work of the load equals the change of energy plus the losses.

use frictiongen::System;
use frictiongen::answer::{Contact, Event};
use frictiongen::study::scene::{Excitation, Node};
use std::f64::consts::TAU;

/// Nodes and weights of Gauss's quadrature on [−1, 1] with ten points, one half of them.
const GAUSS: [[f64; 2]; 5] = [
    [0.148_874_338_981_631_22, 0.295_524_224_714_752_87],
    [0.433_395_394_129_247_2, 0.269_266_719_309_996_35],
    [0.679_409_568_299_024_4, 0.219_086_362_515_982_04],
    [0.865_063_366_688_984_5, 0.149_451_349_150_580_6],
    [0.973_906_528_517_171_7, 0.066_671_344_308_688_14],
];

/// Returns the points of Gauss's quadrature in the interval from 0 to `length`, ascending, with their weights.
pub fn gauss(length: f64) -> Vec<(f64, f64)> {
    let side = |sign: f64| {
        GAUSS.map(|[node, weight]| (0.5 * length * (1.0 + sign * node), 0.5 * length * weight))
    };
    let mut all = [side(-1.0), side(1.0)].concat();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// The chain in non-dimensional form.
struct Chain<'a> {
    system: &'a System,
    r: f64,
    gamma: Vec<f64>,
    /// Ends and stiffness over k₁ of each spring.
    springs: Vec<(Node, Node, f64)>,
    /// Compliance k₁/k of the contact.
    compliance: f64,
    contact_on_base: bool,
}

impl<'a> Chain<'a> {
    fn new(system: &'a System, r: f64) -> Self {
        let scene = system.scene();
        let (m1, k1) = (scene.masses[0].value, scene.springs[0].stiffness);
        let base_moves = scene.excitation == Excitation::Base;
        let sides = [scene.contact.from, scene.contact.to];
        Self {
            system,
            r,
            gamma: scene.masses.iter().map(|mass| mass.value / m1).collect(),
            springs: scene
                .springs
                .iter()
                .map(|s| (s.from, s.to, s.stiffness / k1))
                .collect(),
            compliance: scene.stiffness.map_or(0.0, |k| k1 / k),
            contact_on_base: base_moves && sides.contains(&Node::Base),
        }
    }

    /// Kinetic energy, energy of the springs with the base at rest, and energy of the contact's spring.
    fn energy(&self, x: &[f64], v: &[f64], force: f64) -> f64 {
        let at = |node: Node| if let Node::Mass(i) = node { x[i] } else { 0.0 };
        let kinetic: f64 = self.gamma.iter().zip(v).map(|(m, v)| m * v * v).sum();
        let springs: f64 = self
            .springs
            .iter()
            .map(|(a, b, k)| k * (at(*a) - at(*b)).powi(2))
            .sum();
        0.5 * (self.r * self.r * kinetic + springs + self.compliance * force * force)
    }

    /// Power of the load, of the damping, and of the contact force on the moving base.
    fn powers(&self, v: &[f64], force: f64, phase: f64) -> [f64; 3] {
        let load: f64 = if let Excitation::Force(mass) = self.system.scene().excitation {
            v[mass]
        } else {
            let of = |(a, b, k): &(Node, Node, f64)| match (*a, *b) {
                (Node::Base, Node::Mass(i)) | (Node::Mass(i), Node::Base) => k * v[i],
                _ => 0.0,
            };
            self.springs.iter().map(of).sum()
        };
        let modal = self.system.modal();
        let ratios = modal.damping_ratios.iter().map(|ratio| ratio.to_f64());
        let shapes = self.system.mode_shapes();
        let modes = shapes.iter().zip(self.system.resonances()).zip(ratios);
        let damping = modes.map(|((shape, sigma), zeta)| {
            let masses = shape.iter().zip(&self.gamma).zip(v);
            let rate: f64 = masses.map(|((phi, m), v)| phi * m * v).sum();
            2.0 * zeta * self.r * sigma * rate * rate
        });
        let base = if self.contact_on_base {
            -force * phase.sin()
        } else {
            0.0
        };
        [load * phase.cos(), damping.sum(), base]
    }
}

/// Follows some cycles from rest.  Returns what the energy balance lacks, over the sum of all its terms, and the number
/// of events.
pub fn unbalanced(system: &System, r: f64, beta: f64, cycles: f64) -> (f64, usize) {
    let chain = Chain::new(system, r);
    let names: Vec<String> = system
        .scene()
        .masses
        .iter()
        .map(|mass| mass.name.clone())
        .collect();
    let fastest = system
        .resonances()
        .iter()
        .fold(1.0_f64, |most, sigma| most.max(sigma / r));
    let inverse_mass = system.modal().inverse_mass.to_f64();
    let fastest = fastest.max((inverse_mass / chain.compliance).sqrt() / r);
    // The segments of the motion come from a first run, whose steps the quadrature does not cut.
    let mut run = system.simulation(r, beta).expect("a run");
    let (mut passed, mut segments, mut events) = (0.0, Vec::new(), 0);
    while passed < TAU * cycles {
        let segment = run.advance(TAU * cycles - passed).expect("a segment");
        passed += segment.length;
        events += usize::from(segment.event.is_some());
        segments.push((segment.length, segment.event));
    }
    let mut run = system.simulation(r, beta).expect("a run");
    let states = |run: &frictiongen::study::simulation::SystemSimulation<'_>| {
        let moments = names.iter().map(|name| run.mass(name).expect("a mass"));
        moments
            .map(|moment| (moment.displacement(), moment.velocity()))
            .unzip::<_, _, Vec<_>, Vec<_>>()
    };
    let start = {
        let (x, v) = states(&run);
        chain.energy(&x, &v, run.friction())
    };
    let (mut work, mut damping, mut base, mut slid, mut size) = (0.0, 0.0, 0.0, 0.0, start);
    let mut phase = 0.0;
    for (length, event) in segments {
        let from = run.relative().0;
        let contact = run.contact();
        let panels = (length * fastest / 1.5).ceil().max(1.0);
        let width = length / panels;
        let mut done = 0.0;
        for panel in 0..panels as usize {
            for (node, weight) in gauss(width) {
                let to = panel as f64 * width + node;
                run.advance(to - done).expect("a step");
                done = to;
                let (_, v) = states(&run);
                let [load, damped, on_base] = chain.powers(&v, run.friction(), phase + to);
                work += weight * load;
                damping += weight * damped;
                base += weight * on_base;
                size += weight * (load.abs() + on_base.abs());
            }
        }
        let mut over = false;
        while done < length && !over {
            let step = run.advance(length - done).expect("a step");
            done += step.length;
            over = step.event.is_some();
        }
        if event.is_some() && !over {
            // By rounding the event is still ahead.
            assert!(run.advance(1e-9).expect("a step").event.is_some());
        }
        phase += length;
        if event == Some(Event::Slip) {
            // With μ > 1 the force falls from μβ to β, while the slider jumps.
            let stiction = system.scene().stiction;
            slid += 0.5 * chain.compliance * beta * (stiction * stiction - 1.0);
        }
        if contact != Contact::Stuck {
            slid += (run.relative().0 - from).abs();
        }
    }
    let (x, v) = states(&run);
    let end = chain.energy(&x, &v, run.friction());
    let lacking = work - (end - start) - damping - beta * slid - base;
    (lacking.abs() / (size + end), events)
}

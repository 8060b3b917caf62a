//! Compares three results for the energy that the contact takes in a cycle: the quantity `energy(contact)`, the area
//! of the loop of contact force over displacement, and the work of the load less the loss by damping. Only the first of
//! these numbers uses the friction law. The contact force of the loop follows from the equations of motion, which are
//! dense matrices in this test.

use frictiongen::study::orbit::SystemOrbit;
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::scene::{Excitation, Node};
use frictiongen::{Of, Regime, System};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Nodes and weights of Gauss's quadrature rule with eight points.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Returns x̄ and x̄′ of every mass at a maximum of the excitation.
pub fn section(system: &System, orbit: &SystemOrbit<'_>) -> (Vec<f64>, Vec<f64>) {
    let tau = -orbit.origin();
    let masses = 0..system.scene().masses.len();
    masses
        .map(|mass| {
            let motion = orbit.mass_at(mass).expect("a mass");
            (motion.displacement(tau), motion.velocity(tau))
        })
        .unzip()
}

/// The equations r²Γẍ + C̄(ẋ − e ẏ) + K̄x + w f = p cos τ at one frequency ratio, for base motion y and contact force
/// f.
struct Equations {
    inertia: DVector<f64>,
    damping: DMatrix<f64>,
    stiffness: DMatrix<f64>,
    /// Load on each mass, including the force of the springs to a moving base.
    load: DVector<f64>,
    /// Stiffness of the springs between each mass and the wall.
    to_wall: DVector<f64>,
    contact: DVector<f64>,
    /// 1 if the contact rubs on the moving base.
    on_base: f64,
    /// First number: 1 if the base moves, otherwise 0. Second number: 1 if damping acts relative to the base,
    /// otherwise 0.
    base: [f64; 2],
    driven: Option<usize>,
}

/// Powers at one instant: energy per unit of τ.
struct Powers {
    load: f64,
    damping: f64,
    contact: f64,
}

impl Equations {
    fn of(system: &System, r: f64) -> Self {
        let scene = system.scene();
        let n = scene.masses.len();
        let (m1, k1) = (scene.masses[0].value, scene.springs[0].stiffness);
        let gamma = DVector::from_iterator(n, scene.masses.iter().map(|mass| mass.value / m1));
        let mut stiffness = DMatrix::zeros(n, n);
        let (mut to_base, mut to_wall) = (DVector::zeros(n), DVector::zeros(n));
        for spring in &scene.springs {
            let kappa = spring.stiffness / k1;
            for (one, other) in [(spring.from, spring.to), (spring.to, spring.from)] {
                let Node::Mass(i) = one else { continue };
                stiffness[(i, i)] += kappa;
                match other {
                    Node::Mass(j) => stiffness[(i, j)] -= kappa,
                    Node::Base => to_base[i] += kappa,
                    Node::Wall => to_wall[i] += kappa,
                }
            }
        }
        let modal = system.modal();
        let mut damping = DMatrix::zeros(n, n);
        for (mode, shape) in modal.shapes.iter().enumerate() {
            let shape = DVector::from_iterator(n, shape.iter().map(|value| value.to_f64()));
            let shape = shape.component_mul(&gamma);
            let zeta = modal.damping_ratios[mode].to_f64();
            damping +=
                &shape * shape.transpose() * (2.0 * zeta * r * modal.resonances[mode].to_f64());
        }
        let (driven, load) = match scene.excitation {
            Excitation::Force(mass) => {
                let load = DVector::from_fn(n, |i, _| f64::from(u8::from(i == mass)));
                (Some(mass), load)
            }
            Excitation::Base => (None, to_base),
        };
        let moves = driven.is_none();
        let (mut contact, mut on_base) = (DVector::zeros(n), 0.0);
        match [scene.contact.from, scene.contact.to] {
            [Node::Mass(a), Node::Mass(b)] => {
                contact[a.min(b)] = -1.0;
                contact[a.max(b)] = 1.0;
            }
            [Node::Mass(j), support] | [support, Node::Mass(j)] => {
                contact[j] = 1.0;
                on_base = f64::from(u8::from(moves && support == Node::Base));
            }
            _ => panic!("a contact without a mass"),
        }
        let relative = moves && scene.is_damped_from_base();
        Self {
            inertia: gamma * (r * r),
            damping,
            stiffness,
            load,
            to_wall,
            contact,
            on_base,
            base: [moves, relative].map(|yes| f64::from(u8::from(yes))),
            driven,
        }
    }

    /// Returns the powers at the phase τ of the excitation, for displacements, velocities and accelerations of all
    /// masses.
    fn powers(&self, tau: f64, [x, v, a]: [&DVector<f64>; 3]) -> Powers {
        let (sine, cosine) = tau.sin_cos();
        let base_rate = -sine * self.base[0];
        let slip = v.add_scalar(-base_rate * self.base[1]);
        let drag = &self.damping * &slip;
        let residual =
            &self.load * cosine - &self.stiffness * x - &drag - self.inertia.component_mul(a);
        // The residual is zero for every mass that is not in the contact, so this is the contact force along w.
        let force = residual.dot(&self.contact) / self.contact.dot(&self.contact);
        let load = match self.driven {
            Some(mass) => cosine * v[mass],
            // The load is the force of the base on the chain. If the contact rubs on the base, this force follows
            // from the momentum of all masses and the forces of the wall, without the contact force.
            None if self.on_base == 1.0 => {
                let to_ground = drag.sum() * (1.0 - self.base[1]);
                base_rate * (self.inertia.dot(a) + self.to_wall.dot(x) + to_ground)
            }
            None => {
                let springs = self.load.sum() * cosine - self.load.dot(x);
                base_rate * (springs - drag.sum() * self.base[1])
            }
        };
        Powers {
            load,
            damping: drag.dot(&slip),
            contact: force * (self.contact.dot(v) - self.on_base * base_rate),
        }
    }
}

/// Returns the lengths of the intervals between events in a whole period that starts at a maximum of the excitation.
fn intervals(system: &System, (r, beta): (f64, f64), orbit: &SystemOrbit<'_>) -> Vec<f64> {
    let mut left = TAU * f64::from(orbit.period());
    if orbit.never_slides() {
        return vec![left];
    }
    let (x, v) = section(system, orbit);
    let run = system.simulation_from(r, beta, (&x, &v));
    let mut run = run.expect("in the domain");
    let mut lengths = Vec::new();
    while left > 1e-13 {
        let segment = run.advance(left).expect("a reach");
        lengths.push(segment.length);
        left -= segment.length;
    }
    lengths
}

/// Returns three energies for each cycle: work of the load, loss by damping, and area of the loop.
fn cycle(system: &System, (r, beta): (f64, f64), orbit: &SystemOrbit<'_>) -> [f64; 3] {
    let equations = Equations::of(system, r);
    let n = equations.inertia.len();
    let (mut sums, mut at) = ([0.0; 3], 0.0);
    for length in intervals(system, (r, beta), orbit) {
        let panels = (length * 4.0 * (1.0 + 3.0 / r)).ceil();
        let width = length / panels;
        for panel in 0..panels as usize {
            for (node, weight) in GAUSS {
                for side in [-node, node] {
                    let tau = at + width * (panel as f64 + (1.0 + side) * 0.5);
                    let mut state = [(); 3].map(|()| DVector::zeros(n));
                    for mass in 0..n {
                        let motion = orbit.mass_at(mass).expect("a mass");
                        let since = tau - orbit.origin();
                        state[0][mass] = motion.displacement(since);
                        state[1][mass] = motion.velocity(since);
                        state[2][mass] = motion.acceleration(since);
                    }
                    let powers = equations.powers(tau, state.each_ref());
                    let rates = [powers.load, powers.damping, powers.contact];
                    for (sum, rate) in sums.iter_mut().zip(rates) {
                        *sum += rate * weight * width * 0.5;
                    }
                }
            }
        }
        at += length;
    }
    sums.map(|sum| sum / f64::from(orbit.period()))
}

const BLOCK: &str = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
    contact: block - SIDE, excitation: DRIVEN, stiction: MU, damping: modal(ZETA) }";
const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0, upper - wall: 95.0 },
    contact: CONTACT, excitation: DRIVEN, damping: modal[0.010, 0.052], stiction: 1.2, damping_from: FROM }";

fn block(side: &str, driven: &str, mu: &str, zeta: &str) -> String {
    let text = BLOCK.replace("SIDE", side).replace("DRIVEN", driven);
    text.replace("MU", mu).replace("ZETA", zeta)
}

/// Numbers of compared states of each kind. With them the test checks that no regime is missing.
#[derive(Debug, Default)]
struct Seen {
    regimes: Vec<(Regime, usize)>,
    asymmetric: usize,
    subharmonic: usize,
    damped: f64,
    worst: f64,
}

impl Seen {
    fn compare(&mut self, text: &str, r: f64, beta: f64) {
        let system: System = text.parse().expect("a scene");
        let at = system.at(r).expect("in the domain");
        let orbit = at.orbit(beta).expect("a steady state");
        let response = at.response(beta).expect("a response");
        let energy = response
            .largest(Of::Contact, MotionQuantity::Energy)
            .expect("an energy");
        let [load, damping, area] = cycle(&system, (r, beta), &orbit);
        let what = format!("{text}\nr = {r}, β = {beta}: {energy} {area} {load} {damping}");
        let size = load.abs().max(energy).max(damping);
        // If no work remains over the cycle, the size is that of the largest power times a cycle, about 1e-3.
        let size = size.max(1e-3);
        for other in [area, load - damping] {
            let error = (energy - other).abs() / size;
            assert!(error < 1e-10, "{what}");
            self.worst = self.worst.max(error);
        }
        self.damped = self.damped.max(damping / size);
        let regime = response.regime();
        match self.regimes.iter_mut().find(|(seen, _)| *seen == regime) {
            Some((_, count)) => *count += 1,
            None => self.regimes.push((regime, 1)),
        }
        self.asymmetric += usize::from(!orbit.is_symmetric() && orbit.period() == 1);
        self.subharmonic += usize::from(orbit.period() > 1);
    }
}

#[test]
fn is_the_area_of_the_loop_and_the_work_of_the_load() {
    let mut seen = Seen::default();
    for (r, beta) in [(0.3, 0.4), (0.9, 0.3), (2.0, 0.7), (0.8, 2.0)] {
        seen.compare(&block("wall", "block", "1", "0"), r, beta);
    }
    // The next states are members of a continuum, states off their centre, and motions that repeat after two, three
    // and five cycles.
    seen.compare(&block("wall", "block", "1", "0"), 0.5, 0.2);
    seen.compare(&block("base", "base", "2", "0"), 0.4076, 0.01787);
    seen.compare(&block("wall", "block", "2", "0"), 0.352, 0.1563);
    seen.compare(&block("wall", "base", "3", "0.03443"), 0.25, 0.1521);
    for contact in [
        "upper - wall",
        "base - lower",
        "lower - upper",
        "upper - base",
    ] {
        for (driven, from) in [("base", "rest"), ("base", "base"), ("upper", "rest")] {
            let text = FRAME.replace("CONTACT", contact);
            let text = text.replace("DRIVEN", driven).replace("FROM", from);
            for (r, share) in [(0.33, 0.5), (0.7, 1.02), (0.9, 0.6), (1.5, 0.3), (0.5, 1.6)] {
                let system: System = text.parse().expect("a scene");
                let limits = system.at(r).expect("in the domain").limits();
                let beta = share * limits.sliding;
                seen.compare(&text, r, beta);
            }
        }
    }
    println!("{seen:?}");
    let count: usize = seen.regimes.iter().map(|(_, count)| count).sum();
    assert_eq!(count, 8 + 60);
    let of = |regime| seen.regimes.iter().find(|(of, _)| *of == regime);
    for regime in [Regime::Continuous, Regime::StickSlip, Regime::Stuck] {
        assert!(of(regime).is_some_and(|(_, count)| *count > 5), "{seen:?}");
    }
    assert!(seen.asymmetric > 0 && seen.subharmonic >= 3 && seen.damped > 0.2);
}

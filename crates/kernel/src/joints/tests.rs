//! Checks the energy balance of the stepper. The work of the loads and of the base must equal the change of the stored
//! energy plus the energy that friction, dashpots and damping dissipate.

use super::{
    Contact, Curve, Fixed, Model, Observe, Sample, Series, State, Stepper, TERMS, Wave,
    first_negative, value,
};
use crate::number::dual::Dual;
use crate::stepper::Input;
use fuzzing::Random;

type Size = Fixed<3, 5, 4, 2>;
type Chain = Model<f64, Size>;

const WALL: usize = 3;
const BASE: usize = 4;
const DT: f64 = 0.01;
const MASSES: [f64; 3] = [2.0, 1.5, 1.0];
const SPRINGS: [(usize, usize, f64); 3] = [(0, BASE, 900.0), (1, 0, 700.0), (2, 1, 500.0)];
const DASHPOTS: [(usize, usize, f64); 2] = [(0, BASE, 1.5), (2, 1, 0.8)];
/// Matrix of Rayleigh damping 0.1 M, row after row. It acts on absolute velocities.
const DAMPING: [f64; 9] = [0.2, 0.0, 0.0, 0.0, 0.15, 0.0, 0.0, 0.0, 0.1];
/// Indices of the masses on which a load acts.
const LOADED: [usize; 2] = [0, 2];

/// Returns a chain of three masses with two elastic and two rigid contacts. Two of the contacts, one elastic and one
/// rigid, have μ > 1.
fn chain() -> Chain {
    let contact = |(plus, minus), stiction, stiffness| Contact {
        plus,
        minus,
        level: Wave::zero(),
        stiction,
        stiffness,
        speed: 0.0,
        stop: None,
    };
    Model {
        size: Fixed,
        masses: &MASSES,
        springs: &SPRINGS,
        dashpots: &DASHPOTS,
        damping: &DAMPING,
        damping_from_base: false,
        contacts: [
            contact((0, BASE), 1.2, Some(4000.0)),
            contact((1, 0), 1.0, None),
            contact((2, WALL), 1.0, Some(2500.0)),
            contact((2, 1), 1.3, None),
        ],
        law: [],
        loads: LOADED.map(|mass| (mass, Wave::zero())),
        base: Curve::zero(),
        stretch: 0.0,
    }
}

/// Returns the points and the weights of the Gaussian rule with 12 points on [0, 1]. The points are roots of Legendre's
/// polynomial, which Newton's method finds. The rule is exact for polynomials up to degree 23.
fn gauss() -> Vec<(f64, f64)> {
    let count = 12;
    let nodes = (0..count).map(|index| {
        let angle = (f64::from(index) + 0.75) / (f64::from(count) + 0.5);
        let (mut x, mut slope) = ((core::f64::consts::PI * angle).cos(), 1.0);
        for _ in 0..50 {
            let (mut before, mut value) = (1.0, x);
            for order in 1..count {
                let order = f64::from(order);
                let next = ((2.0 * order + 1.0) * x * value - order * before) / (order + 1.0);
                (before, value) = (value, next);
            }
            slope = f64::from(count) * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    });
    nodes.collect()
}

/// Sums of the energy balance over the steps.
struct Account {
    gauss: Vec<(f64, f64)>,
    model: Chain,
    /// Force of each load at the start and at the end of the step.
    forces: [[f64; 2]; 2],
    /// Friction force of each contact in this step.
    levels: [f64; 4],
    load: f64,
    friction: f64,
    damping: f64,
    /// Sum of the absolute values of all amounts of work.
    size: f64,
    events: usize,
}

impl Account {
    /// Returns the power of the loads and of the base, and the power that dashpots and damping dissipate.
    fn powers(&self, series: &Series<f64, Size>, at: f64) -> (f64, f64) {
        let (x, v) = series.motion(&self.model, at);
        let (y, dy) = series.base(at);
        let x = [x[0], x[1], x[2], 0.0, y];
        let v = [v[0], v[1], v[2], 0.0, dy];
        let time = series.start + at * series.length;
        let mut input = 0.0;
        for ([before, after], mass) in self.forces.iter().zip(LOADED) {
            input += (before + (after - before) * time / DT) * v[mass];
        }
        // The first spring, dashpot and contact have the base as their node `minus`.
        input += SPRINGS[0].2 * (x[BASE] - x[0]) * dy + DASHPOTS[0].2 * (v[BASE] - v[0]) * dy;
        input -= series.force(0, at) * dy;
        let dashpots = DASHPOTS.iter();
        let dashpots = dashpots.map(|(plus, minus, c)| c * (v[*plus] - v[*minus]).powi(2));
        let damping = (0..3).map(|mass| DAMPING[4 * mass] * v[mass] * v[mass]);
        (input, dashpots.chain(damping).sum())
    }

    /// Returns the kinetic and the elastic energy at the end of a step.
    fn stored(&self, stepper: &Stepper<f64, Size, [f64; 0]>, base: f64) -> f64 {
        let state = stepper.motion().state();
        let x = [state.x[0], state.x[1], state.x[2], 0.0, base];
        let kinetic = MASSES.iter().zip(&state.v).map(|(m, v)| m * v * v / 2.0);
        let springs = SPRINGS.iter();
        let springs = springs.map(|(plus, minus, k)| k * (x[*plus] - x[*minus]).powi(2) / 2.0);
        let contacts = self.model.contacts.iter().zip(&state.forces);
        let contacts = contacts.filter_map(|(c, f)| c.stiffness.map(|k| f * f / k / 2.0));
        kinetic.chain(springs).chain(contacts).sum()
    }
}

impl Observe<f64, Size> for Account {
    fn stretch(&mut self, series: &Series<f64, Size>, end: f64, state: &State<f64, Size>) {
        for index in 0..self.gauss.len() {
            let (node, weight) = self.gauss[index];
            let (at, weight) = (node * end, weight * end * series.length);
            let (input, lost) = self.powers(series, at);
            self.load += weight * input;
            self.damping += weight * lost;
            self.size += weight * (input.abs() + lost);
            for (j, contact) in self.model.contacts.iter().enumerate() {
                if state.phases[j].abs() == 1 {
                    let speed = value(&series.speed_terms(contact.plus, contact.minus), at);
                    let power = series.force(j, at) * speed;
                    assert!(power > -1e-9, "contact {j} gives energy: {power}");
                    self.friction += weight * power;
                }
            }
        }
    }

    fn event(&mut self, _: f64, before: &[i8; 4], after: &[i8; 4]) {
        self.events += 1;
        // If an elastic contact breaks away, its force drops from μF to F at once.
        for (j, contact) in self.model.contacts.iter().enumerate() {
            if let Some(stiffness) = contact.stiffness
                && (before[j], after[j].abs()) == (0, 1)
            {
                let drop = (contact.stiction * contact.stiction - 1.0) * self.levels[j].powi(2);
                self.friction += drop / stiffness / 2.0;
            }
        }
    }
}

#[test]
fn ten_thousand_random_steps_keep_their_energy() {
    let mut random = Random(46);
    let mut stepper = Stepper::new(chain(), (DT, Input::Linear, true), []).expect("a stepper");
    let mut account = Account {
        gauss: gauss(),
        model: chain(),
        forces: [[0.0; 2]; 2],
        levels: [9.0, 5.0, 4.0, 2.5],
        load: 0.0,
        friction: 0.0,
        damping: 0.0,
        size: 0.0,
        events: 0,
    };
    let (mut force, mut base, mut worst) = ([0.0; 2], [0.0; 2], 0.0_f64);
    let begun = stepper.begin(Sample {
        base,
        forces: &force,
        frictions: &account.levels,
    });
    begun.expect("the input at the start");
    for step in 0..10_000 {
        if step % 20 == 0 {
            force = force.map(|_: f64| random.between(-40.0, 40.0));
        }
        if step % 50 == 0 {
            // The contacts 1 and 3 are rigid. A change of the friction force would change the energy stored in an
            // elastic contact. It takes one step.
            account.levels[1] = random.between(-1.0, 8.0).max(0.0);
            account.levels[3] = random.between(-1.0, 4.0).max(0.0);
        }
        base = [
            0.9 * base[0] + 2e-3 * random.signed(),
            0.1 * random.signed(),
        ];
        account.forces = account.forces.map(|[_, after]| [after, after]);
        for (forces, force) in account.forces.iter_mut().zip(force) {
            forces[1] = force;
        }
        let levels = account.levels;
        let sample = Sample {
            base,
            forces: &force,
            frictions: &levels,
        };
        let taken = stepper.advance_with(sample, &mut account);
        taken.expect("a step");
        let stored = account.stored(&stepper, base[0]);
        let missing = account.load - account.friction - account.damping - stored;
        worst = worst.max(missing.abs() / account.size);
        let work = stepper.work();
        let pairs = [
            (work.load, account.load),
            (work.friction, account.friction),
            (work.damping, account.damping),
        ];
        for (told, own) in pairs {
            worst = worst.max((told - own).abs() / account.size);
        }
    }
    println!(
        "{} events, work of the loads {:.3}, friction {:.3}, damping {:.3}: {worst:.1e}",
        account.events, account.load, account.friction, account.damping
    );
    assert!(account.events > 2000, "{}", account.events);
    assert!(account.friction > 0.3 * account.load);
    // Each step adds some rounding errors of 1e-16 of the kinetic energy. These errors add up.
    assert!(worst < 1e-12, "{worst}");
}

/// Compares the root of p − t² and its derivative with √p and 1/(2√p).
#[test]
fn a_root_has_the_derivative_of_its_polynomial() {
    let mut terms = [Dual::fixed(0.0_f64); TERMS];
    terms[0] = Dual::variable(0.25);
    terms[2] = Dual::fixed(-1.0);
    let root = first_negative(&terms, 0).unwrap();
    assert!((root.value - 0.5).abs() < 1e-15, "{root:?}");
    assert!((root.slope - 1.0).abs() < 1e-14, "{root:?}");
}

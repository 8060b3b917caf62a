//! Compares motions of a chain stored in arrays of fixed length, as in emitted code, with motions of the same chain
//! stored in `Vec`s. Both use the same functions, so that the results must be equal to the last bit. The module also
//! tests `f32`.

use super::super::{Chain, Model, Motion, Wave};
use super::{Joint, rigid};
use frictiongen_kernel::Float;
use frictiongen_kernel::joints::{self, Bounds, Contact, Fixed, Observe, Series, Size, State};
use frictiongen_model::scene::Node::{Base, Mass, Wall};

/// Size of a chain with three masses, three contacts and one load. One rigid contact is on the wall, another between
/// two masses, and the third contact is elastic.
type Small = Fixed<3, 5, 3, 1>;

fn scene(amplitude: f64) -> Chain {
    Chain {
        masses: vec![1.0, 0.7, 1.6],
        springs: vec![(Base, Mass(0), 90.0), (Mass(1), Mass(2), 40.0)],
        dashpots: vec![(Mass(0), Mass(2), 0.3)],
        damping: vec![
            vec![0.2, -0.1, 0.0],
            vec![-0.1, 0.3, -0.1],
            vec![0.0, -0.1, 0.2],
        ],
        damping_from_base: true,
        contacts: vec![
            rigid((Mass(0), Wall), 0.6, 1.3),
            rigid((Mass(1), Mass(0)), 0.9, 1.0),
            Joint {
                stiffness: Some(70.0),
                speed: 0.0,
                ..rigid((Mass(2), Wall), 0.5, 1.1)
            },
        ],
        law: Vec::new(),
        loads: vec![(2, Wave::harmonic(amplitude, 7.0))],
        base: Wave::harmonic(0.02, 5.0),
        ..Chain::default()
    }
}

fn number<S: Float>(value: f64) -> S {
    S::constant(value)
}

fn wave<S: Float>(wave: &Wave) -> joints::Wave<S> {
    joints::Wave {
        constant: number(wave.constant),
        slope: number(wave.slope),
        amplitude: number(wave.amplitude),
        omega: number(wave.omega),
        phase: number(wave.phase),
    }
}

/// Copies a model into arrays of fixed length.
fn fixed<S: Float>(model: &Model) -> joints::Model<S, Small> {
    let contact = |j: usize| {
        let c: &Contact<f64> = &model.contacts[j];
        Contact {
            plus: c.plus,
            minus: c.minus,
            level: wave(&c.level),
            stiction: number(c.stiction),
            stiffness: c.stiffness.map(number),
            speed: S::constant(0.0),
            stop: None,
        }
    };
    let links = |links: &[joints::Link<f64>]| {
        let links = links.iter().map(|&(a, b, value)| (a, b, number(value)));
        &*Vec::leak(links.collect())
    };
    let numbers = |values: &[f64]| &*Vec::leak(values.iter().map(|v| number(*v)).collect());
    joints::Model {
        size: Fixed,
        masses: numbers(&model.masses),
        springs: links(&model.springs),
        dashpots: links(&model.dashpots),
        damping: numbers(&model.damping),
        damping_from_base: model.damping_from_base,
        contacts: [contact(0), contact(1), contact(2)],
        law: [],
        loads: [(model.loads[0].0, wave(&model.loads[0].1))],
        base: wave(&model.base.wave).into(),
        stretch: number(model.stretch),
    }
}

/// Counts the events of a motion.
struct Count(usize);

impl<S: Float, Z: Size> Observe<S, Z> for Count {
    fn stretch(&mut self, _: &Series<S, Z>, _: S, _: &State<S, Z>) {}

    fn event(&mut self, _: S, _: &Z::Contacts<i8>, _: &Z::Contacts<i8>) {
        self.0 += 1;
    }
}

const BOUNDS: Bounds = Bounds {
    events: 1000,
    stretches: 10_000,
};

#[test]
fn arrays_and_vectors_give_the_same_bits() {
    let chain = scene(3.0);
    let model = chain.model().expect("a chain");
    let mut vectors = Motion::from_rest(&chain).expect("a motion");
    let mut arrays = joints::Motion::<f64, Small>::new(fixed(&model), &[], &[]).expect("a motion");
    let mut events = 0;
    for step in 1..=200 {
        let until = 0.05 * f64::from(step);
        events += vectors
            .run(until, &mut |_, _, _| {})
            .expect("a motion")
            .len();
        let mut count = Count(0);
        arrays.run(until, BOUNDS, &mut count).expect("a motion");
        let (a, b) = (arrays.state(), vectors.state());
        assert_eq!((&a.x[..], &a.v[..]), (&b.x[..], &b.v[..]), "{until}");
        assert_eq!(
            (&a.forces[..], &a.phases[..]),
            (&b.forces[..], &b.phases[..])
        );
        assert_eq!(arrays.forces()[..], vectors.forces()[..], "{until}");
    }
    assert!(events > 40, "{events}");
}

/// Checks that motions in `f32` have the same events as in `f64`, as long as rounding errors are small.
#[test]
fn single_precision_follows_double_precision() {
    let chain = scene(3.0);
    let model = chain.model().expect("a chain");
    let mut double = Motion::from_rest(&chain).expect("a motion");
    let mut single = joints::Motion::<f32, Small>::new(fixed(&model), &[], &[]).expect("a motion");
    let (mut events, mut count, mut worst, mut size) = (0, Count(0), 0.0_f64, 0.0_f64);
    for step in 1..=40 {
        let until = 0.05 * f64::from(step);
        events += double
            .run(until, &mut |_, _, _| {})
            .expect("a motion")
            .len();
        single
            .run(until as f32, BOUNDS, &mut count)
            .expect("a motion");
        for (a, b) in single.state().x.iter().zip(&double.state().x) {
            worst = worst.max((f64::from(*a) - b).abs());
            size = size.max(b.abs());
        }
    }
    println!(
        "f32: {:.1e} of the largest displacement, {events} events",
        worst / size
    );
    assert_eq!(count.0, events);
    // The tolerance is 100 machine epsilons of `f32`, times the largest displacement.
    assert!(
        worst < 100.0 * f64::from(f32::EPSILON) * size,
        "{worst} {size}"
    );
}

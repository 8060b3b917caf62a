//! A slice of another length is an error, and no element is ignored.

use frictiongen::kernel::Complex;
use frictiongen::kernel::orbit::{Orbit, Start, numbers};
use frictiongen::kernel::simulation::{Dynamics, HeldMode, Part, Simulation};
use frictiongen::kernel::{
    contact::sums::Chain,
    oscillator::mode::{Kind, Mode},
};
use frictiongen::{NoOrbit, OutOfDomain, Slice, friction_system};

friction_system! {
    struct Pair {
        masses: { a: 1, b: 1 },
        springs: { base - a: 1, a - b: 1 },
        contact: b - wall,
        excitation: a,
    }
}

#[test]
fn limits_into_slices_of_other_lengths() {
    let ratios = [0.5, 0.8, 1.1];
    let mut compared = 0;
    for continuous in 0..5 {
        for sliding in 0..5 {
            let (mut first, mut second) = (vec![-1.0; continuous], vec![-1.0; sliding]);
            let told = Pair::limits_into(&ratios, &mut first, &mut second);
            let wrong = [(continuous, Slice::Continuous), (sliding, Slice::Sliding)];
            match wrong.iter().find(|(room, _)| *room != 3) {
                Some((_, slice)) => {
                    assert_eq!(told, Err(OutOfDomain::Length(*slice)));
                    assert!(first.iter().chain(&second).all(|value| *value == -1.0));
                }
                None => {
                    assert_eq!(told, Ok(()));
                    assert!(first.iter().chain(&second).all(|value| *value > 0.0));
                }
            }
            compared += 1;
        }
    }
    assert_eq!(compared, 25);
    let told = OutOfDomain::Length(Slice::Sliding).to_string();
    assert!(told.contains("one element for each r"), "{told}");
}

/// One mass and one mode, written by hand.
const MODES: [Mode<f64>; 1] = [Mode {
    kind: Kind::Undamped,
    in_contact: true,
    resonance: 1.0,
    zeta: 0.0,
    q: 1.0,
    q_defect: 0.0,
    load: 1.0,
    contact: 1.0,
    residue: 1.0,
    contact_squared: 1.0,
    static_residue: 1.0,
}];
const HELD: [HeldMode<f64>; 0] = [];
const DYNAMICS: Dynamics<'static, f64> = Dynamics {
    chain: Chain {
        damped: false,
        on_moving_base: None,
        inverse_mass: 1.0,
        stiction: 1.0,
    },
    modes: &MODES,
    held: &HELD,
    participations: &[],
    shapes: &[1.0],
    weights: &[1.0],
    rubbing: None,
};

#[test]
fn room_of_another_size() {
    let run = |parts: usize, state: Option<(&[f64], &[f64])>| {
        let parts = vec![Part::empty(); parts];
        Simulation::new(DYNAMICS, 0.3, 0.4, state, parts).map(|_| ())
    };
    let oscillators = Err(OutOfDomain::Length(Slice::Oscillators));
    assert_eq!(run(1, None), Ok(()));
    assert_eq!(run(0, None), oscillators);
    assert_eq!(run(2, None), oscillators);
    assert_eq!(run(1, Some((&[0.1], &[0.2]))), Ok(()));
    assert_eq!(run(1, Some((&[], &[0.2]))), Err(OutOfDomain::State));
    assert_eq!(run(1, Some((&[0.1, 0.2], &[0.2]))), Err(OutOfDomain::State));
    let orbit = |room: usize, multipliers: usize, start: Start<'_, f64>| {
        let parts = vec![Part::empty(); 1];
        let room = vec![0.0; room];
        let multipliers = vec![Complex { re: 0.0, im: 0.0 }; multipliers];
        Orbit::new(
            DYNAMICS,
            0.3,
            0.4,
            1.0989,
            start,
            false,
            parts,
            room,
            multipliers,
        )
        .map(|_| ())
    };
    let none = |error| Err(NoOrbit::OutOfDomain(error));
    let (storage, multipliers) = (Slice::Storage, Slice::Multipliers);
    let room = numbers(1, 1);
    assert_eq!(orbit(room, 2, Start::Rest), Ok(()));
    assert_eq!(
        orbit(room - 1, 2, Start::Rest),
        none(OutOfDomain::Length(storage))
    );
    assert_eq!(
        orbit(room + 1, 2, Start::Rest),
        none(OutOfDomain::Length(storage))
    );
    assert_eq!(
        orbit(room, 1, Start::Rest),
        none(OutOfDomain::Length(multipliers))
    );
    assert_eq!(
        orbit(room, 2, Start::State(&[0.1], &[])),
        none(OutOfDomain::State)
    );
}

use super::*;
use crate::scene::{CONTACT, ContactSides, Damping, Excitation, Mass, Node, Precision, Spring};

/// Returns the scene of a chain base - m1 - m2 - …, with the contact on one mass and the load on the last mass.
fn chain(masses: &[f64], springs: &[f64], contact: usize, damping: Damping) -> Scene {
    let mass = |(i, value): (usize, &f64)| Mass {
        name: format!("m{i}"),
        value: *value,
    };
    let spring = |(i, stiffness): (usize, &f64)| Spring {
        from: i.checked_sub(1).map_or(Node::Base, Node::Mass),
        to: Node::Mass(i),
        stiffness: *stiffness,
    };
    Scene {
        name: "Chain".to_owned(),
        masses: masses.iter().enumerate().map(mass).collect(),
        springs: springs.iter().enumerate().map(spring).collect(),
        contact: ContactSides {
            from: Node::Mass(contact),
            to: Node::Wall,
        },
        contact_name: CONTACT.to_owned(),
        excitation: Excitation::Force(masses.len() - 1),
        damping,
        damping_from: Default::default(),
        stiffness: None,
        stiction: 1.0,
        precision: Precision::F64,
        provide: Vec::new(),
        declared: crate::scene::Declared::default(),
        friction: crate::scene::FrictionLaw::default(),
        stepping: crate::scene::StepperOptions::default(),
        joints: Default::default(),
    }
}

/// Returns the largest relative displacement of the contact in a held mode, divided by the participations of the modes.
/// A held mode is a mode of the chain with its contact stuck. The exact value is 0. Rounding in double-double and close
/// frequencies cause other values.
fn worst_slip(scene: &Scene) -> f64 {
    let transient: Transient<Dd> = Transient::of(scene, &Modal::of(scene), |value| value);
    let driven = transient.held.len() + 1;
    assert_eq!(
        transient.participations.len(),
        driven * transient.held.len()
    );
    let mut worst = 0.0_f64;
    for participations in transient.participations.chunks(driven) {
        for state in 0..2 {
            let moved = transient
                .modes
                .iter()
                .zip(participations)
                .fold(Dd::ZERO, |sum, (mode, participation)| {
                    sum + mode.contact * participation[state]
                });
            worst = worst.max(moved.abs().to_f64());
        }
    }
    worst
}

#[test]
fn held_modes_hold_the_contact() {
    let uneven = [1.0, 2.5, 0.3, 1.7, 0.9, 4.0];
    let springs = [1.0, 0.4, 3.0, 1.1, 0.7, 2.0];
    let heavy = Damping::Rayleigh {
        mass: 3.0,
        stiffness: 1.5,
    };
    let uniform = Damping::Uniform(0.7);
    let modal = Damping::Modal(vec![0.0, 0.3, 1.0, 0.01, 2.0, 0.05]);
    for damping in [Damping::None, Damping::Uniform(0.01), uniform, heavy, modal] {
        for contact in [0, 2, 5] {
            let worst = worst_slip(&chain(&uneven, &springs, contact, damping.clone()));
            assert!(worst < 1e-26, "{damping:?}, contact {contact}: {worst:e}");
        }
    }
}

#[test]
fn undamped_held_modes_are_those_of_the_cut_chain() {
    // The middle mass of three equal masses is stuck. The first mass swings between two springs, and the last on one
    // spring.
    let scene = chain(&[1.0; 3], &[1.0; 3], 1, Damping::None);
    let transient: Transient<f64> = Transient::of(&scene, &Modal::of(&scene), |value| value.hi);
    let frequencies: Vec<f64> = transient.held.iter().map(|mode| mode.frequency).collect();
    assert_eq!(frequencies, [1.0, 2.0_f64.sqrt()]);
}

#[test]
fn many_masses_spread_over_twelve_decades() {
    let masses: Vec<f64> = (0..24).map(|i| 10.0_f64.powi((i * 7) % 13 - 6)).collect();
    let springs: Vec<f64> = (0..24).map(|i| 10.0_f64.powi((i * 5) % 13 - 6)).collect();
    for damping in [Damping::None, Damping::Uniform(0.02)] {
        let worst = worst_slip(&chain(&masses, &springs, 11, damping));
        // In this test participations are at most 1 and contact components at most 1e3. Frequencies that differ by only
        // 1e-12 cost half of the digits.
        assert!(worst < 1e-12, "{worst:e}");
    }
}

/// Checks the change of a motion from the modes of the sliding chain to the held modes (contact stuck) and back. The
/// change must keep half of the digits. Otherwise the transient must report the loss.
#[test]
fn a_loss_is_seen() {
    let uneven = |n: u32, zeta: f64| {
        let masses: Vec<f64> = (0..n).map(|i| 1.0 + 0.3 * f64::from(i * 7 % 5)).collect();
        let springs: Vec<f64> = (0..n).map(|i| 1.0 - 0.1 * f64::from(i * 3 % 4)).collect();
        chain(&masses, &springs, (n / 2) as usize, Damping::Uniform(zeta))
    };
    let excess = |scene: &Scene| {
        let double = Transient::of(scene, &Modal::of(scene), |value| value.hi);
        #[allow(clippy::cast_possible_truncation, reason = "single precision is meant")]
        let single = Transient::of(scene, &Modal::of(scene), |value| value.hi as f32);
        (double.excess_loss(), single.excess_loss())
    };
    for zeta in [0.0, 0.05, 0.5, 0.9, 0.99] {
        for n in [2, 8, 32] {
            assert_eq!(excess(&uneven(n, zeta)), (None, None), "{n} {zeta}");
        }
    }
    // In f64 two overdamped modes keep half of the digits. In f32 eight overdamped modes lose more than half. With 64
    // critically damped modes, f32 and f64 both lose more than half.
    assert_eq!(excess(&uneven(2, 10.0)).0, None);
    let (double, single) = excess(&uneven(8, 1.5));
    assert_eq!(double, None);
    assert!(single.is_some_and(|loss| 1e-3 < loss), "{single:?}");
    let (double, single) = excess(&uneven(64, 1.0));
    assert!(
        double.is_some() && single.is_some(),
        "{double:?} {single:?}"
    );
}

/// Stiffnesses k of an elastic contact divided by k₁, from 1e-6 to 1e9. The compliance of the contact is k₁/k.
const STIFFNESSES: [f64; 6] = [1e-6, 1e-3, 0.3, 1e2, 1e5, 1e9];

/// Checks that an undamped chain with a stuck elastic contact equals a chain with one more spring. The natural
/// frequencies of the chain with one more spring come from its modal analysis, which does not use the equation under
/// test.
#[test]
fn an_elastic_contact_is_one_more_spring() {
    let uneven = [1.0, 2.5, 0.3, 1.7, 0.9, 4.0];
    let springs = [1.0, 0.4, 3.0, 1.1, 0.7, 2.0];
    let mut compared = 0;
    for (masses, springs) in [
        (&uneven[..], &springs[..]),
        (&[1.0; 3], &[1.0; 3]),
        (&[2.0], &[3.0]),
    ] {
        for stiffness in STIFFNESSES {
            for contact in [0, masses.len() / 2, masses.len() - 1] {
                let mut scene = chain(masses, springs, contact, Damping::None);
                scene.stiffness = Some(stiffness);
                let transient: Transient<f64> =
                    Transient::of(&scene, &Modal::of(&scene), |value| value.hi);
                let found = transient.held.iter().map(|mode| mode.frequency);
                scene.springs.push(Spring {
                    from: Node::Mass(contact),
                    to: Node::Wall,
                    stiffness,
                });
                let expected = Modal::of(&scene).resonances;
                // The longer chain has additional modes, which the contact does not drive. They do not occur in
                // `found`.
                for frequency in found {
                    let nearest = expected.iter().map(|of| (of.to_f64() - frequency).abs());
                    let error = nearest.fold(f64::INFINITY, f64::min);
                    assert!(
                        error <= 2e-16 * frequency,
                        "k = {stiffness}, {contact}: {frequency}, {error:e}"
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 150, "{compared}");
}

/// Checks that in every mode of the stuck chain the displacement of the contact is the compliance times its force. The
/// test covers all kinds of damping, equal modes and both number types.
#[test]
fn the_spring_of_an_elastic_contact_has_the_contact_force() {
    let uneven = [1.0, 2.5, 0.3, 1.7, 0.9, 4.0];
    let springs = [1.0, 0.4, 3.0, 1.1, 0.7, 2.0];
    let heavy = Damping::Rayleigh {
        mass: 3.0,
        stiffness: 1.5,
    };
    let modal = Damping::Modal(vec![0.0, 0.3, 1.0, 0.01, 2.0, 0.05]);
    let mut compared = 0;
    for damping in [
        Damping::None,
        Damping::Uniform(0.01),
        Damping::Uniform(0.7),
        heavy,
        modal,
    ] {
        for stiffness in STIFFNESSES {
            for contact in [0, 2, 5] {
                let mut scene = chain(&uneven, &springs, contact, damping.clone());
                scene.stiffness = Some(stiffness);
                let transient: Transient<Dd> =
                    Transient::of(&scene, &Modal::of(&scene), |value| value);
                let driven = transient.held.len();
                assert_eq!(transient.participations.len(), driven * driven);
                for (mode, participations) in transient
                    .held
                    .iter()
                    .zip(transient.participations.chunks(driven))
                {
                    let spring = mode.force / Dd::from(stiffness);
                    for (state, expected) in [-spring, Dd::ZERO].into_iter().enumerate() {
                        let terms = transient.modes.iter().zip(participations);
                        let (moved, size) =
                            terms.fold((Dd::ZERO, spring.abs()), |(sum, size), (mode, of)| {
                                let term = mode.contact * of[state];
                                (sum + term, size + term.abs())
                            });
                        let error = ((moved - expected) / size).abs().to_f64();
                        assert!(
                            error < 1e-26,
                            "{damping:?}, k = {stiffness}, {contact}: {error:e}"
                        );
                        compared += 1;
                    }
                }
                let single = |value: Dd| f32::constant(value.to_f64());
                let single = Transient::of(&scene, &Modal::of(&scene), single);
                for (mode, single) in transient.held.iter().zip(&single.held) {
                    let error = (mode.force.to_f64() / f64::from(single.force) - 1.0).abs();
                    assert!(error < 1e-7, "{error:e}");
                }
            }
        }
    }
    assert_eq!(compared, 5 * 6 * 3 * 6 * 2);
}

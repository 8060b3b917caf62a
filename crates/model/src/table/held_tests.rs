//! Tests of the responses while the contact is stuck: chains of every kind, two masses solved by hand, and the effect
//! of wrong numbers.

use super::held::{Held, HeldForm};
use crate::samples::scene;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::{Factor, Root};

const RANGE: (f64, f64) = (0.2, 2.5);

/// Checks the stuck responses of chains with every kind of contact and damping, as products over zeros and poles. The
/// products must have the accuracy `finest`: 1e-12, and 1e-5 in single precision. A product has up to sixty factors
/// with a few roundings each.
fn of_chains<S: Float>(finest: f64) {
    for kind in ["Wall", "Base", "Pair"] {
        for count in 1..=16 {
            if kind == "Pair" && count == 1 {
                continue;
            }
            for zeta in [0.0, 0.02, 0.3, 1.3, -0.02] {
                let held = Held::<S>::of(&scene(kind, count, zeta, 1.0), RANGE);
                let held = held.unwrap_or_else(|| panic!("{kind}{count}, {zeta}: none"));
                assert!(held.keeps(finest), "{kind}{count}, {zeta}: {}", held.told());
                assert_eq!(held.masses.len(), count);
                assert!(held.points > 64);
            }
        }
    }
}

#[test]
fn of_double_precision() {
    of_chains::<f64>(1e-12);
}

#[test]
fn of_single_precision() {
    of_chains::<f32>(1e-5);
}

/// Checks two masses that rub on each other and that the base drives. Stuck together, they are a mass of 2 on a spring
/// of 1, with a damper of 0.1 in the damped case. For the undamped chain `Held::of` must return `None`, so that the
/// table uses the exact formulas.
#[test]
fn driven_by_the_base() {
    let mut modal = scene("Pair", 2, 0.0, 1.0);
    modal.loads = modal.shapes.iter().map(|shape| shape[0]).collect();
    assert!(Held::<f64>::of(&modal, RANGE).is_none());
    // With 2ζ_iσ_i = 0.1σ_i² the damping is proportional to the stiffness, so that each spring has a damper in
    // parallel.
    modal.damping_ratios = modal
        .resonances
        .iter()
        .map(|sigma| *sigma * Dd::from(0.05))
        .collect();
    let held = Held::<f64>::of(&modal, RANGE).unwrap();
    for k in 0..1000 {
        let r = 0.2 + 0.0023 * f64::from(k);
        let (re, im) = (1.0 - 2.0 * r * r, 0.1 * r);
        let size = re * re + im * im;
        for mass in &held.masses {
            let value = mass.response().value(r);
            let off = (value.re - re / size).hypot(value.im + im / size);
            assert!(off * size.sqrt() < 1e-13, "{r}: {value}");
        }
    }
}

/// Checks two masses by hand. The second mass is stuck to the wall, so the first mass is on two springs. Its response
/// is 1/(2 − r²), and the contact force has the same value.
#[test]
fn two_masses_by_hand() {
    let held = Held::<f64>::of(&scene("Wall", 2, 0.0, 1.0), RANGE).unwrap();
    for k in 0..1000 {
        let r = 0.2 + 0.0023 * f64::from(k);
        let expected = 1.0 / (2.0 - r * r);
        let values = [
            held.masses[0].response().value(r),
            held.force.response().value(r),
        ];
        for value in values {
            assert_eq!(value.im, 0.0);
            // The tolerance covers a few roundings of the response, and the roundings of 2 − r² in this test.
            let allowed = f64::EPSILON * (4.0 + 4.0 * expected.abs());
            assert!((value.re / expected - 1.0).abs() < allowed, "{r}: {value}");
        }
        assert_eq!(held.masses[1].response().value(r).re, 0.0);
    }
    assert!(held.resonances.is_empty());
    // The resonance r = 1 of this stuck chain is exactly a number of the type `f64`.
    let on = Held::<f64>::of(&scene("Pair", 16, 0.0, 1.0), RANGE).unwrap();
    assert_eq!(on.resonances, [1.0]);
}

/// Returns a change of a zero's imaginary part y by which the zero's factor changes by about 100 % somewhere in the
/// range of r.
fn reach(y: f64) -> f64 {
    let r = y.clamp(RANGE.0, RANGE.1);
    if r == y {
        y
    } else {
        (r * r - y * y).abs() / (2.0 * y)
    }
}

/// Returns the numbers that a factor stores, each with a change by which the factor changes by about 100 %.
fn of_root(root: &mut Root<f64>) -> Vec<(&mut f64, f64)> {
    let before = *root;
    let size = |r: f64| {
        let value = before.value(r);
        value.re.hypot(value.im)
    };
    match root {
        Root::Pair { at, rate, .. } => {
            let r = at.clamp(RANGE.0, RANGE.1);
            let reach = size(r) / (2.0 * *at);
            vec![(at, reach), (rate, size(r) / r)]
        }
        Root::Real { rate } => vec![(rate, size(RANGE.0))],
    }
}

/// Returns all numbers that a response stores, each with a change by which the response changes by about 100 %.
fn numbers(form: &mut HeldForm<f64>) -> Vec<(&mut f64, f64)> {
    let of_factor = |factor| match factor {
        &mut Factor::Zero { ref mut at, .. } => {
            let size = reach(*at);
            vec![(at, size)]
        }
        factor => panic!("an undamped chain has {factor:?}"),
    };
    match form {
        HeldForm::Fixed(_) => Vec::new(),
        HeldForm::Undamped(product) => {
            let size = product.gain;
            let all = product.numerator.iter_mut().chain(&mut product.denominator);
            let own = all.flat_map(of_factor);
            own.chain([(&mut product.gain, size)]).collect()
        }
        HeldForm::Damped {
            gain,
            numerator,
            denominator,
        } => {
            let size = *gain;
            let own = numerator.iter_mut().chain(denominator).flat_map(of_root);
            own.chain([(gain, size)]).collect()
        }
    }
}

/// Checks that the check of the tables finds a number whose error changes a response by ten times the accuracy.
#[test]
fn a_wrong_number() {
    let mut moved = 0;
    for (kind, count, zeta) in [
        ("Wall", 2, 0.0),
        ("Pair", 3, 0.0),
        ("Base", 5, 0.02),
        ("Pair", 5, 1.3),
    ] {
        let modal = scene(kind, count, zeta, 1.0);
        let sound = Held::<f64>::of(&modal, RANGE).unwrap();
        assert_eq!(sound.verify(&modal, RANGE), Some(sound.worst));
        for accuracy in [1e-2, 1e-4, 1e-6, 1e-9] {
            for form in 0..=sound.masses.len() {
                for place in 0.. {
                    let mut wrong = sound.clone();
                    let form = wrong.masses.get_mut(form);
                    let form = form.unwrap_or(&mut wrong.force);
                    let mut all = numbers(form);
                    let Some((number, size)) = all.get_mut(place) else {
                        break;
                    };
                    let before = **number;
                    **number += 10.0 * accuracy * *size;
                    let found = wrong.verify(&modal, RANGE).unwrap().error;
                    assert!(
                        found > accuracy,
                        "{kind}{count}, {zeta}, {accuracy:e}: {before} is off, {found:e}"
                    );
                    moved += 1;
                }
            }
        }
    }
    assert!(moved > 300, "{moved}");
}

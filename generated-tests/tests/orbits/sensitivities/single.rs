//! Compares derivatives with respect to r, β and single modal quantities with differences. The differences shift one
//! modal quantity alone, so their modal data belongs to no scene.

use crate::sensitivities::answers::{of_data, of_system};
use crate::sensitivities::differences::{Outcome, Side, compare};
use crate::sensitivities::scene::{SCENES, place};
use frictiongen::study::{System, sensitivity::Quantity};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::modal::Modal;
use generated_tests::data::Data;

/// Returns modal data with one quantity shifted by `by`, and with the sums that depend on it: m* = Σ(φᵀw)², wᵀΓ⁻¹p =
/// Σ(φᵀw)(φᵀp), and the static sums.
fn moved(modal: &Modal, quantity: Quantity, by: Dd) -> Modal {
    let mut modal = modal.clone();
    let value = match quantity {
        Quantity::Resonance(mode) => &mut modal.resonances[mode],
        Quantity::DampingRatio(mode) => &mut modal.damping_ratios[mode],
        Quantity::Load(mode) => &mut modal.loads[mode],
        Quantity::Contact(mode) => &mut modal.contacts[mode],
        Quantity::Shape { mode, mass } => &mut modal.shapes[mode][mass],
        other => panic!("{other:?} is not modal"),
    };
    *value = *value + by;
    let sum = |term: &dyn Fn(usize) -> Dd| {
        (0..modal.loads.len()).fold(Dd::ZERO, |sum, mode| sum + term(mode))
    };
    let contact = |mode: usize| modal.contacts[mode];
    let lambda = |mode: usize| modal.resonances[mode] * modal.resonances[mode];
    let inverse_mass = sum(&|mode| contact(mode) * contact(mode));
    let inertial = sum(&|mode| contact(mode) * modal.loads[mode]);
    let motion = sum(&|mode| contact(mode) * modal.loads[mode] / lambda(mode));
    let receptance = sum(&|mode| contact(mode) * contact(mode) / lambda(mode));
    let of_base = if modal.on_moving_base {
        Dd::ONE
    } else {
        Dd::ZERO
    };
    modal.inverse_mass = inverse_mass;
    modal.inertial_load = inertial;
    modal.static_motion = motion - of_base;
    modal.static_receptance = receptance;
    modal
}

fn data(modal: &Modal) -> Data<Dd> {
    Data {
        reduced: modal.reduced(|value| value),
    }
}

fn modal_quantities(modal: &Modal) -> Vec<(Quantity, Dd)> {
    let mut all = Vec::new();
    for mode in 0..modal.resonances.len() {
        all.extend([
            (Quantity::Resonance(mode), modal.resonances[mode]),
            (Quantity::DampingRatio(mode), modal.damping_ratios[mode]),
            (Quantity::Load(mode), modal.loads[mode]),
            (Quantity::Contact(mode), modal.contacts[mode]),
        ]);
        all.extend(
            (0..modal.shapes[mode].len())
                .map(|mass| (Quantity::Shape { mode, mass }, modal.shapes[mode][mass])),
        );
    }
    all
}

#[test]
fn modal_data() {
    let (mut outcome, mut left) = (Outcome::default(), 0);
    for (scene, text, ratios) in SCENES {
        let system: System = text.parse().expect("a valid scene");
        let modal = system.modal();
        left += ratios.len() - 2;
        for r in ratios.iter().take(2) {
            let beta = place(&system, *r);
            let (exact_r, exact_beta) = (Dd::from(*r), Dd::from(beta));
            for (quantity, value) in modal_quantities(modal) {
                let varied = system.along(quantity).expect("a quantity of the scene");
                let at = varied.at(Dual::fixed(exact_r)).expect("in the domain");
                let dual = of_system(&at, modal.loads.len(), Dual::fixed(exact_beta));
                // ζ = 0 is a bound of the damping ratio's range, but ζ = 1 is not.
                let damping = matches!(quantity, Quantity::DampingRatio(_));
                let side = if damping && value.is_zero() {
                    Side::Above
                } else {
                    Side::Both
                };
                let unit = if value.is_zero() {
                    0.01
                } else {
                    value.abs().to_f64()
                };
                outcome.join(compare(
                    &format!("{scene}, r = {r}, {quantity:?}"),
                    &dual,
                    |by| of_data(&data(&moved(modal, quantity, by)), exact_r, exact_beta),
                    unit.min(0.1),
                    side,
                ));
            }
        }
    }
    println!("skipped: the third ratio of {left} scenes");
    assert_eq!(left, 4);
    outcome.report("modal data", (11_702, 0));
}

#[test]
fn frequency_and_friction_ratio() {
    let mut outcome = Outcome::default();
    for (scene, text, ratios) in SCENES {
        let system: System = text.parse().expect("a valid scene");
        let exact: System<Dd> = text.parse().expect("a valid scene");
        let masses = system.modal().loads.len();
        let unvaried = system.unvaried();
        for r in *ratios {
            let beta = place(&system, *r);
            let (exact_r, exact_beta) = (Dd::from(*r), Dd::from(beta));
            let answers =
                |r: Dd, beta: Dd| of_system(&exact.at(r).expect("in the domain"), masses, beta);
            let at = unvaried.at(Dual::variable(exact_r)).expect("in the domain");
            outcome.join(compare(
                &format!("{scene}, r = {r}, r"),
                &of_system(&at, masses, Dual::fixed(exact_beta)),
                |by| answers(exact_r + by, exact_beta),
                0.1,
                Side::Both,
            ));
            let at = unvaried.at(Dual::fixed(exact_r)).expect("in the domain");
            outcome.join(compare(
                &format!("{scene}, r = {r}, β"),
                &of_system(&at, masses, Dual::variable(exact_beta)),
                |by| answers(exact_r, exact_beta + by),
                beta,
                Side::Both,
            ));
        }
    }
    outcome.report("r and β", (1560, 0));
}

/// Checks that a search for S (the largest velocity constraint) with hundreds of steps gives a finite derivative. The
/// derivative with respect to r must not grow from step to step.
#[test]
fn a_long_search() {
    let text = "struct A { masses: { a: 0.93, b: 3.2, c: 1.2, d: 1.6, e: 0.39, f: 0.88, g: 0.55, h: 2.7,
         i: 1.6, j: 1.7, k: 1.5, l: 1.4, m: 0.96, n: 1.9 },
         springs: { base - a: 0.72, a - b: 0.53, b - c: 1.1, c - d: 1.4, d - e: 0.83, e - f: 1.9, f - g: 0.43,
         g - h: 1.2, h - i: 1.5, i - j: 0.63, j - k: 0.56, k - l: 1.2, l - m: 0.46, m - n: 0.47 },
         contact: m - base, excitation: g, damping: modal[2.4, 7e-3, 2e-9, 1e-6, 3e-5, 8e-8, 7.7, 1.0, 9e-9,
         1e-3, 0.99994, 0.36, 0.07, 2e-9] }";
    let exact: System<Dd> = text.parse().expect("a valid scene");
    let limit = |r: Dd| exact.at(r).expect("in the domain").continuous_limit();
    // r is near the thirty-first subharmonic of the third mode, whose damping nearly vanishes.
    let r = exact.resonances()[2] / Dd::from(31.0) * Dd::from(1.0 - 3e-8);
    let unvaried = exact.unvaried();
    let at = unvaried.at(Dual::variable(r)).expect("in the domain");
    let slope = at.continuous_limit().slope;
    // Near this r, β_lim is smooth over a range of r of about 1e-8. A central difference with the step 1e-12
    // therefore has a relative error of (1e-12/1e-8)².
    let h = r * Dd::from(1e-12);
    let difference = (limit(r + h) - limit(r - h)) / (h + h);
    assert!(
        ((slope - difference) / difference).abs().to_f64() < 1e-6,
        "{slope:?}, by differences {difference:?}"
    );
}

//! r, β, and the modal quantities, each alone: the difference is of modal data that no scene has.

use crate::answers::{of_data, of_system};
use crate::differences::{Outcome, Side, compare};
use crate::scene::{SCENES, place};
use frictiongen::study::{Quantity, System};
use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::dual::Dual;
use frictiongen_model::modal::Modal;
use generated_tests::data::Data;

/// A modal quantity moved, with what is made of it: m* = Σ(φᵀw)², wᵀΓ⁻¹p = Σ(φᵀw)(φᵀp), and the static
/// sums.
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
    let mobility = sum(&|mode| contact(mode) * contact(mode));
    let inertial = sum(&|mode| contact(mode) * modal.loads[mode]);
    let motion = sum(&|mode| contact(mode) * modal.loads[mode] / lambda(mode));
    let receptance = sum(&|mode| contact(mode) * contact(mode) / lambda(mode));
    let share = if modal.on_moving_base {
        Dd::ONE
    } else {
        Dd::ZERO
    };
    modal.mobility = mobility;
    modal.inertial_load = inertial;
    modal.static_motion = motion - share;
    modal.static_receptance = receptance;
    modal
}

fn data(modal: &Modal) -> Data<Dd> {
    Data {
        reduced: modal.reduced(|value| value),
        contact: modal.contact,
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
    let mut outcome = Outcome::default();
    for (scene, text, ratios) in SCENES {
        let system: System = text.parse().expect("a valid scene");
        let modal = system.modal();
        for r in ratios.iter().take(2) {
            let beta = place(&system, *r);
            let (exact_r, exact_beta) = (Dd::from(*r), Dd::from(beta));
            for (quantity, value) in modal_quantities(modal) {
                let varied = system.along(quantity).expect("a quantity of the scene");
                let at = varied.at(Dual::fixed(exact_r)).expect("in the domain");
                let dual = of_system(&at, modal.loads.len(), Dual::fixed(exact_beta));
                // ζ = 0 is an end of its range; ζ = 1 is none.
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
    outcome.report("modal data");
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
    outcome.report("r and β");
}

//! Compares derivatives with respect to masses, springs, damping and stiction with differences of the answers of
//! changed descriptions.

use crate::sensitivities::answers::{Answers, of_system};
use crate::sensitivities::differences::{Outcome, Side, compare};
use frictiongen::study::scene::Scene;
use frictiongen::study::{
    System,
    scene::Damping,
    sensitivity::{Quantity, Sensitive},
};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::modal::Modal;

/// Scenes, each with its frequency ratios. The scenes have contacts with the wall, the base and another mass. Damping
/// is absent, modal (with ζ = 0, 1 and above) or Rayleigh. Some scenes have exactly equal modes, because equal masses
/// are on equal springs.
pub const SCENES: &[(&str, &str, &[f64])] = &[
    (
        "pair",
        "struct A { masses: { a: 3.25, b: 3.5 }, springs: { base - a: 1190.0, a - b: 1323.0 },
         contact: b - wall, excitation: base, damping: modal[0.01, 0.02], stiction: 1.25, }",
        &[0.37, 0.93, 2.1],
    ),
    (
        "undamped three",
        "struct A { masses: { a: 1.0, b: 0.75, c: 1.5 },
         springs: { base - a: 1.0, a - b: 0.5, b - c: 0.375, c - wall: 0.25 }, contact: a - c,
         excitation: b, }",
        &[0.23, 0.61, 1.9],
    ),
    (
        "Rayleigh on base",
        "struct A { masses: { a: 1.0, b: 0.375, c: 1.75 },
         springs: { base - a: 1.0, a - b: 0.34, b - c: 0.8, a - wall: 0.41, base - c: 0.25 },
         contact: c - base, excitation: base, damping: rayleigh(0.0037, 0.17), stiction: 1.5, }",
        &[0.31, 0.8, 1.7],
    ),
    (
        "mixed damping",
        "struct A { masses: { a: 1.0, b: 2.0, c: 0.75 },
         springs: { base - a: 1.0, a - b: 0.4, b - c: 1.5 }, contact: b - wall, excitation: a,
         damping: modal[0.05, 1.0, 1.5], stiction: 1.25, }",
        &[0.3, 1.1],
    ),
    (
        "no and some damping",
        "struct A { masses: { a: 1.0, b: 2.0 }, springs: { base - a: 1.0, a - b: 0.4 },
         contact: b - wall, excitation: a, damping: modal[0, 0.125], }",
        &[0.29, 0.9],
    ),
    (
        "twins",
        "struct A { masses: { a: 1.0, b: 1.0 }, springs: { base - a: 1.0, base - b: 1.0 },
         contact: a - b, excitation: a, damping: modal(0.05), stiction: 1.25, }",
        &[0.4, 0.9, 1.3],
    ),
    (
        "satellites",
        "struct A { masses: { c: 1.0, x: 0.5, y: 0.5, z: 0.5 },
         springs: { base - c: 1.0, c - x: 0.25, c - y: 0.25, c - z: 0.25 }, contact: x - c,
         excitation: z, damping: rayleigh(0.0625, 0.03125), }",
        &[0.35, 0.8],
    ),
];

/// Returns a friction ratio well inside the continuous regime.
pub fn place<S: Float>(system: &System<S>, r: f64) -> f64 {
    let at = system.at(S::constant(r)).expect("in the domain");
    0.4 * at.continuous_limit().min(at.sliding_limit()).to_f64()
}

/// Returns the answers that do not depend on r or β: natural frequencies, the limits at r = 0 and r = ∞, and the
/// friction ratios from which resonances are bounded.
fn special<S: Float>(modal: &Modal<S>, equal: bool) -> Answers<S> {
    let ends = modal.ends();
    let mut all = vec![
        (String::from("at rest"), ends.sliding_at_rest),
        (String::from("continuous at ∞"), ends.continuous_at_infinity),
        (String::from("sliding at ∞"), ends.sliding_at_infinity),
    ];
    // Equal modes have no order that changes smoothly, so the list leaves out their frequencies.
    if !equal {
        let frequencies = modal.natural_frequencies().into_iter().enumerate();
        all.extend(frequencies.map(|(i, omega)| (format!("frequency {i}"), omega)));
        let thresholds = modal.resonance_thresholds().into_iter().enumerate();
        all.extend(thresholds.filter_map(|(i, beta)| Some((format!("threshold {i}"), beta?))));
        for (i, shape) in modal.shapes.iter().enumerate() {
            let shape = shape.iter().enumerate();
            all.extend(shape.map(|(k, value)| (format!("shape {i} {k}"), *value)));
        }
    }
    all.retain(|(_, value)| value.is_finite());
    all
}

/// Returns the quantities of a description that have derivatives, each with its value.
pub fn quantities(scene: &Scene) -> Vec<(Quantity, f64)> {
    let masses = scene.masses.iter().enumerate();
    let mut all: Vec<_> = masses
        .map(|(i, mass)| (Quantity::Mass(i), mass.value))
        .collect();
    let springs = scene.springs.iter().enumerate();
    all.extend(springs.map(|(i, spring)| (Quantity::Stiffness(i), spring.stiffness)));
    if let Damping::Rayleigh { mass, stiffness } = scene.damping {
        all.push((Quantity::MassDamping, mass));
        all.push((Quantity::StiffnessDamping, stiffness));
    }
    all.push((Quantity::Stiction, scene.stiction));
    all
}

/// Returns the scene with a quantity shifted by `by`. The shifted number must be exact in double precision.
pub fn moved(scene: &Scene, quantity: Quantity, by: f64) -> Scene {
    let mut scene = scene.clone();
    let value = match (quantity, &mut scene.damping) {
        (Quantity::Mass(i), _) => &mut scene.masses[i].value,
        (Quantity::Stiffness(i), _) => &mut scene.springs[i].stiffness,
        (Quantity::Stiction, _) => &mut scene.stiction,
        (Quantity::MassDamping, Damping::Rayleigh { mass, .. }) => mass,
        (Quantity::StiffnessDamping, Damping::Rayleigh { stiffness, .. }) => stiffness,
        (other, _) => panic!("the description does not say {other:?}"),
    };
    assert_eq!((*value + by) - *value, by, "{quantity:?}");
    *value += by;
    scene
}

/// Returns a number with its last twenty bits cleared, so that a test can shift it without rounding.
fn short(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & !0xF_FFFF)
}

/// Returns the scene with numbers that a test can shift without rounding, and with no quantity at a bound of its
/// range.
pub fn shortened(text: &str) -> Scene {
    let system: System = text.parse().expect("a valid scene");
    let mut scene = system.scene().clone();
    for mass in &mut scene.masses {
        mass.value = short(mass.value);
    }
    for spring in &mut scene.springs {
        spring.stiffness = short(spring.stiffness);
    }
    if let Damping::Rayleigh { mass, stiffness } = &mut scene.damping {
        (*mass, *stiffness) = (short(*mass), short(*stiffness));
    }
    if scene.stiction == 1.0 {
        scene.stiction = 1.0625;
    }
    scene
}

#[test]
fn of_the_description() {
    let mut outcome = Outcome::default();
    let (mut of_equal, mut none) = (0, 0);
    for (name, text, ratios) in SCENES {
        let scene = shortened(text);
        let system = System::<f64>::try_from(scene.clone()).expect("a valid scene");
        let masses = scene.masses.len();
        let equal = ["twins", "satellites"].contains(name);
        let exact = |quantity: Quantity, by: Dd| {
            let scene = moved(&scene, quantity, by.to_f64());
            System::<Dd>::try_from(scene).expect("a valid scene")
        };
        for (quantity, value) in quantities(&scene) {
            let varied = system.along(quantity).expect("a quantity of the scene");
            let special_values = special(varied.modal(), equal);
            let left = 3 + 2 * masses + masses * masses - special_values.len();
            *(if equal { &mut of_equal } else { &mut none }) += left;
            outcome.join(compare(
                &format!("{name}, {quantity:?}"),
                &special_values,
                |by| special(&exact_modal(&exact(quantity, by)), equal),
                value,
                Side::Both,
            ));
            for r in *ratios {
                let beta = Dd::from(place(&system, *r));
                let r = Dd::from(*r);
                let at = varied.at(Dual::fixed(r)).expect("in the domain");
                let dual: Answers<Sensitive> = of_system(&at, masses, Dual::fixed(beta));
                outcome.join(compare(
                    &format!("{name}, r = {}, {quantity:?}", r.to_f64()),
                    &dual,
                    |by| {
                        let system = exact(quantity, by);
                        of_system(&system.at(r).expect("in the domain"), masses, beta)
                    },
                    value,
                    Side::Both,
                ));
            }
        }
    }
    println!("skipped: {of_equal} of scenes with equal modes, {none} infinite or not there");
    assert_eq!((of_equal, none), (304, 22));
    outcome.report("description", (6657, 0));
}

fn exact_modal(system: &System<Dd>) -> Modal {
    system.modal().clone()
}

/// Checks that `sensitivities` lists every quantity of the description, with the slopes that `along` gives.
#[test]
fn the_whole_gradient() {
    let mut compared = 0;
    for (_, text, ratios) in SCENES {
        let system: System = text.parse().expect("a valid scene");
        let r = Dual::fixed(Dd::from(ratios[0]));
        let gradient = system
            .sensitivities(|varied| {
                Ok::<_, frictiongen::OutOfDomain>(varied.at(r)?.continuous_limit())
            })
            .expect("in the domain");
        let listed: Vec<Quantity> = gradient.iter().map(|(quantity, _)| *quantity).collect();
        for (quantity, _) in quantities(system.scene()) {
            assert!(listed.contains(&quantity), "{quantity:?}");
        }
        let limit = system
            .at(ratios[0])
            .expect("in the domain")
            .continuous_limit();
        for (quantity, value) in gradient {
            let varied = system.along(quantity).expect("a quantity of the scene");
            let at = varied.at(r).expect("in the domain");
            assert_eq!(
                at.continuous_limit().slope.to_f64(),
                value.slope,
                "{quantity:?}"
            );
            assert!((value.value / limit - 1.0).abs() < 1e-13);
            compared += 1;
        }
    }
    println!("{compared} slopes compared, none skipped");
    assert_eq!(compared, 61);
}

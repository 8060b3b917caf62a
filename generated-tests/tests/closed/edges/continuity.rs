//! Tests that answers have no step at four places: at ζ = 0, at ζ = 1, at zeros and poles of u, and where a residue
//! vanishes.
//!
//! The bound on the difference of two answers has two terms. The first is twice the distance of the arguments times
//! the larger derivative at both points. The second is 2 × `ROUNDINGS` rounding units times the condition number,
//! half of it for each point.

use crate::edges::condition::{
    Asked, Question, along, along_place, modal_condition, scene_condition,
};
use crate::edges::scenes::{SCENES, system};
use frictiongen::study::{System, scene::Damping, sensitivity::Quantity};
use frictiongen_kernel::number::dd::Dd;

const ROUNDINGS: f64 = 8.0;

const CONTACT: [Asked; 5] = [
    Asked::ContinuousLimit,
    Asked::WithoutSearch,
    Asked::SlidingLimit,
    Asked::ContactAmplitude,
    Asked::ContactPhase,
];

/// Returns both limits, β_lim without search, and amplitude and phase of the contact, through the public interface.
fn answers(system: &System, r: f64, beta: f64) -> [f64; 5] {
    let at = system.at(r).expect("in the domain");
    let motion = at
        .motion(beta)
        .unwrap_or_else(|error| panic!("r = {r:?}, beta = {beta:?}: {error}"));
    [
        at.continuous_limit(),
        at.continuous_limit_without_search(),
        at.sliding_limit(),
        motion.contact().amplitude(),
        motion.contact().phase(),
    ]
}

fn apart(a: f64, b: f64, asked: Asked) -> f64 {
    let difference = a - b;
    if asked.is_angle() {
        let turn = std::f64::consts::TAU;
        (difference - turn * (difference / turn).round()).abs()
    } else {
        difference.abs()
    }
}

/// Numbers of compared and of omitted differences, and the largest difference divided by its bound.
#[derive(Default)]
struct Steps {
    count: usize,
    /// Number of scenes that were omitted because they have too many masses.
    large: usize,
    /// Number of frequency ratios that were omitted because they are a resonance.
    resonant: usize,
    worst: f64,
}

impl Steps {
    fn check(&mut self, step: f64, slope: f64, condition: f64, place: impl FnOnce() -> String) {
        let bound = 2.0 * slope + 2.0 * ROUNDINGS * f64::EPSILON * condition;
        self.count += 1;
        self.worst = self.worst.max(step / bound);
        assert!(step <= bound, "{}: {step:e} above {bound:e}", place());
    }

    /// Prints the results, and asserts the numbers of compared and of omitted differences.
    fn report(&self, title: &str, counts: (usize, usize, usize)) {
        println!(
            "{title}: {} steps compared, worst {:.2} of its bound; skipped: {} large scenes, {} ratios on a resonance",
            self.count, self.worst, self.large, self.resonant
        );
        assert_eq!((self.count, self.large, self.resonant), counts, "{title}");
    }
}

/// Returns the scenes with at most `most` masses. Larger scenes would take too long, because each difference needs a
/// condition number in double-double.
fn small(most: usize, steps: &mut Steps) -> Vec<&'static (&'static str, &'static str)> {
    let masses = |text: &str| system::<f64>(text).modal().loads.len();
    let scenes = SCENES.iter().filter(|scene| masses(scene.1) <= most);
    let scenes: Vec<_> = scenes.collect();
    steps.large = SCENES.len() - scenes.len();
    scenes
}

/// Returns the scene with the damping ratio ζ in every mode.
fn damped(text: &str, zeta: f64) -> System {
    let mut scene = system::<f64>(text).scene().clone();
    scene.damping = Damping::Uniform(zeta);
    System::try_from(scene).expect("a valid scene")
}

/// Returns Σ_i |∂f/∂ζ_i|, the sensitivity of an answer f to the damping ratios of all modes i.
fn damping_slope(system: &System, question: Question) -> f64 {
    let modes = 0..system.modal().resonances.len();
    modes
        .map(|i| {
            along(system, question, Quantity::DampingRatio(i))
                .slope
                .abs()
                .to_f64()
        })
        .sum()
}

fn beta_of(system: &System, r: f64) -> f64 {
    let at = system.at(r).expect("in the domain");
    0.3 * at.continuous_limit().min(at.sliding_limit())
}

/// Returns frequency ratios between the resonances, and some within 1e-3 of a resonance.
fn between(system: &System, steps: &mut Steps) -> Vec<f64> {
    let mut ratios = vec![0.57, 1.31];
    for pole in system.resonances() {
        ratios.extend([pole * 0.999, pole / 2.0, pole / 3.0 * 1.001]);
    }
    // Half of a resonance may be another resonance, where an undamped motion is unbounded.
    let all = ratios.len();
    ratios.retain(|r| !system.resonances().contains(r));
    steps.resonant += all - ratios.len();
    ratios
}

fn across(zetas: &[f64], centre: f64, title: &str, counts: (usize, usize, usize)) {
    let mut steps = Steps::default();
    for (name, text) in small(3, &mut steps) {
        let middle = damped(text, centre);
        for r in between(&middle, &mut steps) {
            let beta = beta_of(&middle, r);
            let here = answers(&middle, r, beta);
            for (asked, here) in CONTACT.into_iter().zip(here) {
                let question = Question::at(r, beta, asked);
                let condition = modal_condition(&middle, question);
                let slope = damping_slope(&middle, question);
                for zeta in zetas {
                    let there = damped(text, *zeta);
                    let place = CONTACT.iter().position(|other| *other == asked);
                    let there = answers(&there, r, beta)[place.expect("one of them")];
                    let distance = (zeta - centre).abs();
                    steps.check(
                        apart(there, here, asked),
                        slope * distance,
                        condition,
                        || {
                            format!(
                                "{name}, {asked:?}, r = {r}, zeta = {zeta:e}: {there:e}, {here:e}"
                            )
                        },
                    );
                }
            }
        }
    }
    steps.report(title, counts);
}

/// Checks answers for ζ → 0. Their change is O(ζ Σ|∂f/∂ζ|). For ζ of 1e-18 and less the change is rounding alone.
#[test]
fn vanishing_damping() {
    across(&[1e-300, 1e-18, 1e-12, 1e-9], 0.0, "zeta = 0", (1780, 3, 1));
}

#[test]
fn critical_damping() {
    let zetas = [
        1.0f64.next_down(),
        1.0f64.next_up(),
        1.0 - 1e-15,
        1.0 + 1e-15,
        1.0 - 1e-12,
        1.0 + 1e-12,
        1.0 - 1e-8,
        1.0 + 1e-8,
    ];
    across(&zetas, 1.0, "zeta = 1", (3560, 3, 1));
}

/// Checks the limits without search (closed formulas) of undamped scenes at odd and even subharmonics.
///
/// U has a pole at an odd subharmonic, so that β_lim falls to 0. At an even subharmonic the u of a mode is 0. The test
/// does not search for S. At these frequencies S is small compared with U, and its condition number in double-double
/// takes minutes.
#[test]
fn sub_harmonics() {
    let mut steps = Steps::default();
    for (name, text) in small(3, &mut steps) {
        let system = damped(text, 0.0);
        for (mode, pole) in system.resonances().iter().enumerate() {
            for n in [2, 3, 7] {
                let on = pole / f64::from(n);
                for distance in [f64::EPSILON, 1e-12] {
                    for side in [-1.0, 1.0] {
                        let r = on * (1.0 + side * distance);
                        for asked in [Asked::WithoutSearch, Asked::SlidingLimit] {
                            let ask = |r: f64| {
                                let at = system.at(r).expect("in the domain");
                                match asked {
                                    Asked::SlidingLimit => at.sliding_limit(),
                                    _ => at.continuous_limit_without_search(),
                                }
                            };
                            let (there, here) = (ask(r), ask(on));
                            // On the subharmonic itself the derivative jumps, so the test takes the derivative next
                            // to the subharmonic.
                            let question = Question::at(r, 0.0, asked);
                            let slope = along_place(&system, question).1.abs().to_f64();
                            let condition = modal_condition(&system, question);
                            steps.check(
                                apart(there, here, asked),
                                slope * (r - on).abs(),
                                condition,
                                || format!("{name}, {asked:?}, mode {mode}/{n}, r = {r}: {there:e}, {here:e}"),
                            );
                        }
                    }
                }
            }
        }
    }
    steps.report("sub-harmonics", (528, 3, 0));
}

fn moved(system: &System, quantity: Quantity, by: f64) -> System {
    let mut scene = system.scene().clone();
    match quantity {
        Quantity::Mass(i) => scene.masses[i].value += by,
        Quantity::Stiffness(i) => scene.springs[i].stiffness += by,
        other => panic!("{other:?}"),
    }
    System::try_from(scene).expect("a valid scene")
}

/// Checks a mode with a node at the contact. The residue of this mode in the contact's sums is 0. It differs from 0
/// if a mass or a spring changes by a rounding unit.
#[test]
fn a_node_at_the_contact() {
    let scenes = [
        SCENES
            .iter()
            .find(|scene| scene.0 == "symmetric three")
            .expect("it")
            .1
            .to_owned(),
        String::from(
            "struct A { masses: { a: 1.0, b: 2.0, c: 1.0 },
             springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - wall: 1.0 }, contact: b - wall,
             excitation: b, damping: modal(0.02), stiction: 1.25, }",
        ),
        String::from(
            "struct A { masses: { a: 1.0, b: 0.5, c: 1.0 },
             springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - wall: 1.0 }, contact: a - c,
             excitation: a, damping: modal(0.01), }",
        ),
    ];
    let mut steps = Steps::default();
    for text in &scenes {
        let on = system::<f64>(text);
        let nodes = on
            .modal()
            .contacts
            .iter()
            .filter(|contact| contact.is_zero());
        assert!(nodes.count() > 0, "no node: {text}");
        let quantities = [Quantity::Mass(2), Quantity::Stiffness(3)];
        let distances = [f64::EPSILON, -0.5 * f64::EPSILON, 1e-12, -1e-12, 1e-9];
        for r in between(&on, &mut steps) {
            let beta = beta_of(&on, r);
            let here = answers(&on, r, beta);
            for (place, asked) in CONTACT.into_iter().enumerate() {
                let question = Question::at(r, beta, asked);
                let condition = scene_condition(&on, question).max(modal_condition(&on, question));
                for quantity in quantities {
                    let slope = along(&on, question, quantity).slope;
                    for distance in distances {
                        let beside = moved(&on, quantity, distance);
                        let there = answers(&beside, r, beta)[place];
                        steps.check(
                            apart(there, here[place], asked),
                            (slope * Dd::from(distance)).abs().to_f64(),
                            condition,
                            || format!("{text}, {quantity:?} by {distance:e}, {asked:?}, r = {r}"),
                        );
                    }
                }
            }
        }
    }
    steps.report("a node at the contact", (1650, 0, 0));
}

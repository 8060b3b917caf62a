//! Compares the answers of run-time systems and of emitted code with the reference values of
//! `reference/closed_form.json` and of the wedges in `reference/several_states.json`. A wedge is the range of
//! friction ratios between β*_lim and β_lim.

use frictiongen::System;
use frictiongen::study::scene::Scene;
use frictiongen_codegen::{SizeLimits, parse_text};
use frictiongen_kernel::number::dd::Dd;
use generated_tests::larger;
use generated_tests::reference::{
    Worst, closed_form, compare, compare_extremes, compare_wedge, description, extremes, wedges,
};
use generated_tests::scenes::{NUMBERS, TEXTS, compare_double, compare_single};

/// Tolerance in double precision: 1e-12 of the scale of each quantity, which is about 4500 rounding units.
///
/// The tolerance covers two losses. Within 1e-2 of a subharmonic, a point loses up to three of the sixteen digits. At
/// r far above the resonances, the modal terms of a mass several springs away from load and contact cancel to 1e-4 of
/// their size. An example is mass 4 of scene 20 at r = 5.3.
const DOUBLE: f64 = 1e-12;

/// Tolerance in single precision: 2e-4 of the scale of each quantity, which is about 1700 rounding units.
const SINGLE: f64 = 2e-4;
/// Numbers of the scenes whose points lose too many digits for the tolerance 2e-4 in single precision.
///
/// Scenes 11 and 20 have far masses above the resonances, and scene 30 has limits near a subharmonic. At the points of
/// these scenes, the rounding of r and λ to single precision alone changes the limits by more than 2e-4.
const ILL_CONDITIONED: [usize; 3] = [11, 20, 30];

/// Returns the number of compared values of each kind, for scenes with this number of masses in total. A scene has
/// three points, and a point has two motions.
fn compared(scenes: usize, masses: usize) -> [(&'static str, usize); 11] {
    [
        ("amplitude", 6 * masses),
        ("contact amplitude", 6 * scenes),
        ("contact phase", 6 * scenes),
        ("continuous limit", 3 * scenes),
        ("displacement", 3 * 6 * masses),
        ("harmonic", 6 * 6 * masses),
        ("natural frequency", masses),
        ("phase", 6 * masses),
        ("sliding limit", 3 * scenes),
        ("stuck", 6 * masses),
        ("without search", 3 * scenes),
    ]
}

/// Number of scenes of the reference, and of their masses.
const ALL: (usize, usize) = (38, 141);
/// Number of emitted scenes, and of their masses.
const EMITTED: (usize, usize) = (8, 30);

/// Asserts that every value was compared and is within its tolerance.
#[track_caller]
fn all_within(worst: &Worst, (scenes, masses): (usize, usize), tolerance: f64) {
    println!("{worst}");
    assert_eq!(worst.compared(), compared(scenes, masses));
    assert_eq!(worst.beyond(|_| tolerance), Vec::<String>::new());
}

/// Asserts the same for results in single precision, whose scenes have these numbers in the reference.
#[track_caller]
fn all_within_in_single(
    results: impl IntoIterator<Item = (usize, Worst)>,
    (scenes, masses): (usize, usize),
) {
    let (mut worst, mut ill) = (Worst::default(), Worst::default());
    let mut beyond = Vec::new();
    for (number, scene) in results {
        let failed = scene.beyond(|_| SINGLE);
        if ILL_CONDITIONED.contains(&number) {
            // For the points of these scenes, five times the tolerance is enough.
            assert_eq!(scene.beyond(|_| 5.0 * SINGLE), Vec::<String>::new());
            ill.join(scene);
        } else if failed.is_empty() {
            worst.join(scene);
        } else {
            beyond.push((number, failed));
        }
    }
    println!("{worst}");
    println!("scenes {ILL_CONDITIONED:?}, to five times the bar:\n{ill}");
    assert_eq!(beyond, Vec::new());
    worst.join(ill);
    assert_eq!(worst.compared(), compared(scenes, masses));
}

#[test]
fn run_time_system() {
    let mut worst = Worst::default();
    let mut single = Vec::new();
    for (index, reference) in closed_form().iter().enumerate() {
        let text = description(reference);
        let system: System = text.parse().expect("a valid scene");
        worst.join(compare(&system, reference));
        let system: System<f32> = text.parse().expect("a valid scene");
        single.push((index + 1, compare(&system, reference)));
    }
    all_within(&worst, ALL, DOUBLE);
    all_within_in_single(single, ALL);
}

/// Tolerance for the wedges, as a multiple of the scale of a quantity: 64 rounding units ε = 2⁻⁵².
///
/// The scale is the modulus of the value itself, with three exceptions. For a displacement or harmonic it is the
/// amplitude of the mass. For a stuck response it is the largest stuck response of the scene. For a phase it is one
/// radian.
const WEDGE: f64 = 64.0 * f64::EPSILON;
/// Number of compared values of each kind in the wedges: 22 points of 14 scenes, 44 motions of 80 masses.
const WEDGES: [(&str, usize); 10] = [
    ("amplitude", 80),
    ("contact amplitude", 44),
    ("contact phase", 44),
    ("continuous limit", 22),
    ("displacement", 3 * 80),
    ("harmonic", 6 * 80),
    ("phase", 80),
    ("sliding limit", 22),
    ("stuck", 80),
    ("without search", 22),
];

#[track_caller]
fn all_wedges_within(worst: &Worst, tolerance: impl Fn(&str) -> f64) {
    println!("{worst}");
    assert_eq!(worst.compared(), WEDGES);
    assert_eq!(worst.beyond(tolerance), Vec::<String>::new());
}

/// Checks that with μ > 1 the closed form is a steady state for every β < β_lim, including β above β*_lim.
#[test]
fn wedges_at_run_time() {
    let (mut worst, mut wide) = (Worst::default(), Worst::default());
    for reference in wedges() {
        let text = description(&reference);
        let system: System = text.parse().expect("a valid scene");
        worst.join(compare_wedge(&system, &reference));
        let system: System<Dd> = text.parse().expect("a valid scene");
        wide.join(compare_wedge(&system, &reference));
    }
    all_wedges_within(&worst, |_| WEDGE);
    all_wedges_within(&wide, |kind| if kind == "phase" { PLACES } else { DIGITS });
}

/// Tolerance in double-double: half a unit of the reference's 20th digit, 5e-20, plus the same amount for the
/// comparison.
const DIGITS: f64 = 1e-19;
/// Tolerance for phases in double-double, in rad. The reference gives the instant of a maximum to 1e-16, which is
/// less accurate than its height. The worst phase is that of scene 31, r = 0.445156, mass 3: in 50 digits it is
/// −3.113282548776704094, and the reference ends in …4180.
const PLACES: f64 = 2e-16;

/// Checks that the formulas in double-double agree with the digits of the JSON file. Other tests use these formulas
/// as the reference.
#[test]
fn read_in_double_double() {
    let mut worst = Worst::default();
    for reference in closed_form() {
        let system: System<Dd> = description(&reference).parse().expect("a valid scene");
        worst.join(compare(&system, &reference));
    }
    println!("{worst}");
    assert_eq!(worst.compared(), compared(ALL.0, ALL.1));
    let beyond = worst.beyond(|kind| if kind == "phase" { PLACES } else { DIGITS });
    assert_eq!(beyond, Vec::<String>::new());
}

/// Checks the values of `extremes.json` in double-double. They are near poles, where up to ten of the 31 digits are
/// lost.
#[test]
fn extremes_read_in_double_double() {
    let mut all = Worst::default();
    let (mut usual, mut ends, mut vanishing) = (all.clone(), all.clone(), all.clone());
    for reference in extremes() {
        let name = reference["name"].as_str().expect("a name");
        let system: System<Dd> = description(&reference).parse().expect("a valid scene");
        let scene = compare_extremes(&system, &reference);
        all.join(scene.clone());
        if name.starts_with("ends") {
            ends.join(scene);
        } else if name.starts_with("damping 1e-300") {
            vanishing.join(scene);
        } else {
            usual.join(scene);
        }
    }
    println!("{usual}\nr = 0 and r = ∞:\n{ends}\nζ = 1e-300:\n{vanishing}");
    // There are 272 points. Nine have no β_lim by search, and ten at both bounds of the range have no β_lim without
    // search. At 253 points the reference has two motions.
    let compared = [
        ("contact amplitude", 506),
        ("contact phase", 506),
        ("continuous limit", 263),
        ("displacement", 548),
        ("natural frequency", 63),
        ("sliding limit", 272),
        ("without search", 262),
    ];
    assert_eq!(all.compared(), compared);
    assert_eq!(usual.beyond(|_| DIGITS), Vec::<String>::new());
    // At both bounds of the range the reference has only 17 digits.
    assert_eq!(ends.beyond(|_| 5e-17), Vec::<String>::new());
    // Below 1e-290 the low word of a double-double underflows, so only double precision remains.
    assert_eq!(vanishing.beyond(|_| f64::EPSILON), Vec::<String>::new());
}

/// Returns the references of the emitted scenes.
fn emitted() -> Vec<serde_json::Value> {
    let all = closed_form();
    NUMBERS.map(|number| all[number - 1].clone()).to_vec()
}

#[test]
fn emitted_double() {
    let mut worst = Worst::default();
    for scene in compare_double(&emitted()) {
        worst.join(scene);
    }
    all_within(&worst, EMITTED, DOUBLE);
}

#[test]
fn emitted_single() {
    let results = NUMBERS.into_iter().zip(compare_single(&emitted()));
    all_within_in_single(results, EMITTED);
}

/// Checks that the macro has received exactly the scenes of the reference.
#[test]
fn texts_are_the_references() {
    let references = emitted();
    assert_eq!(TEXTS.len(), references.len());
    for (text, reference) in TEXTS.iter().zip(&references) {
        assert_eq!(read(text), read(description(reference)));
    }
}

/// Reads a scene and removes its name, which may differ between two texts of the same scene.
fn read(text: &str) -> Scene {
    let scene = parse_text(text, &SizeLimits::MACRO).expect("a valid scene");
    Scene {
        name: String::new(),
        ..scene.scene
    }
}

/// Checks that with one mass the sum of the modes' own maxima equals the maximum of the sum.
#[test]
fn one_mode_has_its_own_maximum() {
    let (mut compared, mut searched, mut worst) = (0, 0, 0.0);
    for damping in [
        "none",
        "modal(0.02)",
        "modal(0.3)",
        "modal(0.7)",
        "modal(1)",
        "modal(1.6)",
    ] {
        for base in [false, true] {
            let (contact, excitation) = if base {
                ("base", "base")
            } else {
                ("wall", "block")
            };
            let system: System = format!(
                "struct Block {{ masses: {{ block: 1 }}, springs: {{ base - block: 1 }},
                contact: block - {contact}, excitation: {excitation}, damping: {damping} }}"
            )
            .parse()
            .expect("a scene");
            for step in 1..200 {
                let at = system.at(0.0137 * f64::from(step)).expect("in the domain");
                let (exact, per_mode) = (at.continuous_limit(), at.continuous_limit_per_mode());
                worst = larger(worst, (exact - per_mode).abs() / exact);
                compared += 1;
                searched += usize::from(at.velocity_constraint().places[0].is_some());
            }
        }
    }
    println!("{compared} values compared, worst {worst:.1e}; {searched} with a search");
    // The two compared searches find S, the largest velocity constraint, to a few rounding units. The sum U² + S² may
    // double this error.
    assert!(worst < 1e-14);
    assert_eq!(compared, 6 * 2 * 199);
    // The test counts only searches in which S exceeds its value at the start of the half period.
    assert!(searched > 100, "{searched}");
}

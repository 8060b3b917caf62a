//! The reference values of `reference/closed_form.json` at run time and through the macro.

use frictiongen::System;
use frictiongen_codegen::{Limits, parse_text};
use frictiongen_kernel::dd::Dd;
use generated_tests::reference::{Worst, closed_form, compare};
use generated_tests::scenes::{TEXTS, compare_double, compare_single};

/// Double precision: 1e-12 of each quantity's scale, some 4500 roundings.  A point within 1e-2 of a
/// sub-harmonic takes up to three digits of the sixteen; at r far above the resonances the modal terms of a
/// mass several springs away from load and contact cancel to 1e-4 of themselves (scene 20, mass 4, r = 5.3).
const DOUBLE: f64 = 1e-12;

/// Single precision: 2e-4, some 1700 roundings.
const SINGLE: f64 = 2e-4;
/// The scenes whose points take more digits than single precision has for 2e-4, by number: far
/// masses above the resonances (11, 20) and limits beside a sub-harmonic, where
/// rounding r and λ to single precision alone moves them by more (30).
const ILL_CONDITIONED: [usize; 3] = [11, 20, 30];

#[test]
fn run_time_system() {
    let mut worst = Worst::default();
    for reference in closed_form() {
        let text = reference["description"].as_str().expect("a description");
        let system: System = text.parse().expect("a valid scene");
        worst.join(compare(&system, &reference));
    }
    println!("{worst}");
    assert_eq!(worst.beyond(|_| DOUBLE), Vec::<String>::new());
}

/// The same formulas read in double-double: what is left is the rounding of the comparison itself.
#[test]
fn read_in_double_double() {
    let mut worst = Worst::default();
    for reference in closed_form() {
        let text = reference["description"].as_str().expect("a description");
        let system: System<Dd> = text.parse().expect("a valid scene");
        worst.join(compare(&system, &reference));
    }
    println!("{worst}");
    assert_eq!(worst.beyond(|_| 1e-15), Vec::<String>::new());
}

#[test]
fn emitted_double() {
    let mut worst = Worst::default();
    for scene in compare_double(&closed_form()) {
        worst.join(scene);
    }
    println!("{worst}");
    assert_eq!(worst.beyond(|_| DOUBLE), Vec::<String>::new());
}

#[test]
fn emitted_single() {
    let mut worst = Worst::default();
    let mut beyond = Vec::new();
    for (index, scene) in compare_single(&closed_form()).into_iter().enumerate() {
        let failed = scene.beyond(|_| SINGLE);
        if ILL_CONDITIONED.contains(&(index + 1)) {
            // Five times the bar still holds there.
            assert_eq!(scene.beyond(|_| 5.0 * SINGLE), Vec::<String>::new());
        } else if failed.is_empty() {
            worst.join(scene);
        } else {
            beyond.push((index + 1, failed));
        }
    }
    println!("{worst}");
    assert_eq!(beyond, Vec::new());
}

/// The macro has seen the reference's scenes and no others.
#[test]
fn texts_are_the_references() {
    let references = closed_form();
    assert_eq!(TEXTS.len(), references.len());
    for (text, reference) in TEXTS.iter().zip(&references) {
        let read = |text: &str| {
            parse_text(text, &Limits::MACRO)
                .expect("a valid scene")
                .scene
        };
        let description = reference["description"].as_str().expect("a description");
        assert_eq!(read(text), read(description));
    }
}

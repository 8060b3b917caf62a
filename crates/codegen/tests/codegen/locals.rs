//! Tests that no pattern of emitted code can refer to a constant of the user.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use frictiongen_codegen::{SizeLimits, emit, parse_text};
use frictiongen_kernel::emitted::locals::NAMES;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::ops::RangeInclusive;
use syn::visit::Visit;

/// The names that patterns bind, and the functions that hide constants of the same names.
#[derive(Default)]
struct Seen {
    bound: BTreeSet<String>,
    functions: BTreeSet<String>,
}

impl<'ast> Visit<'ast> for Seen {
    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        self.bound.insert(pattern.ident.to_string());
        syn::visit::visit_pat_ident(self, pattern);
    }

    fn visit_item_fn(&mut self, function: &'ast syn::ItemFn) {
        self.functions.insert(function.sig.ident.to_string());
        syn::visit::visit_item_fn(self, function);
    }
}

/// Returns a chain of masses. The masses are joined to the base and to the wall alternately, so that no two modes are
/// alike.
fn scene(masses: usize, contact: &str, excitation: &str, rest: &str) -> String {
    let mut text = String::from("struct Scene { masses: {");
    for mass in 0..masses {
        let _ = write!(
            text,
            " a{mass}: {},",
            1.0 + 0.37 * (mass as f64 + 1.0).sin()
        );
    }
    text.push_str(" }, springs: { base - a0: 1,");
    for mass in 1..masses {
        let stiffness = 1.0 + 0.4 * (1.7 * mass as f64).cos();
        let _ = write!(text, " a{} - a{mass}: {stiffness},", mass - 1);
    }
    let _ = write!(
        text,
        " }}, contact: {contact}, excitation: {excitation}, {rest} }}"
    );
    text
}

/// Checks one scene, and returns the number of bound names. Collects the names that the scene hides with functions of
/// its own.
fn check(text: &str, emitted: &mut BTreeSet<String>) -> usize {
    let description =
        parse_text(text, &SizeLimits::MACRO).unwrap_or_else(|told| panic!("{told}\n{text}"));
    let file: syn::File = syn::parse2(emit(&description)).expect("emitted Rust");
    let mut seen = Seen::default();
    seen.visit_file(&file);
    for name in &seen.bound {
        let of_a_mode = name.starts_with("mode_") && name.matches('_').count() > 1;
        let hidden = NAMES.contains(&name.as_str()) || seen.functions.contains(name);
        assert!(
            hidden || of_a_mode || name == "self",
            "`{name}` is bound by\n{text}"
        );
    }
    emitted.extend(seen.functions);
    seen.bound.len()
}

const PROVIDE: [&str; 8] = [
    "[limits]",
    "[motion]",
    "[motion(a0), stuck]",
    "[orbit]",
    "[simulation]",
    "[stepper], step: 1e-2",
    "[limits, motion, stuck, orbit, simulation, stepper]",
    // Its names do not depend on the number of masses, and its answers of many masses take seconds.
    "[limits, motion, stuck, self_check]",
];
const CROWDED: &str = "[limits, motion, stuck]";
const DAMPING: [&str; 4] = ["none", "modal(0.02)", "rayleigh(0.01, 0.02)", "modal(1)"];

/// Checks scenes of these numbers of masses, and returns how many scenes and bound names there were.
fn check_all(range: RangeInclusive<usize>) -> (usize, usize) {
    let (mut scenes, mut names, mut emitted) = (0, 0, BTreeSet::new());
    for masses in range {
        let (last, middle) = (masses - 1, masses / 2);
        let mut pictures = vec![
            (format!("a{last} - wall"), "a0".to_owned()),
            (format!("a{middle} - base"), "base".to_owned()),
            (format!("base - a{middle}"), format!("a{last}")),
        ];
        if masses > 1 {
            pictures.push((format!("a{} - a{last}", last - 1), "base".to_owned()));
            pictures.push((format!("a0 - a{last}"), format!("a{middle}")));
        }
        for (picture, (contact, excitation)) in pictures.iter().enumerate() {
            // Up to four masses, where modes are written out, all combinations are tested. Beyond that, combinations
            // are tested in turn.
            let all = masses <= 4;
            for (kind, damping) in DAMPING.iter().enumerate() {
                for (item, provide) in PROVIDE.iter().enumerate() {
                    let turn = (masses + picture) % 4 == kind && item == 6 && picture < 4;
                    let everything = (masses <= 8 || (15..=17).contains(&masses)) && item == 6;
                    if !(all || everything || (turn && picture == masses % 4)) {
                        continue;
                    }
                    let scalar = ["f64", "f32"][(kind + item) % 2];
                    // The macro refuses time-domain solvers of many critically damped modes.
                    let crowded = masses > 4 && *damping == "modal(1)";
                    let provide = if crowded { CROWDED } else { provide };
                    let rest = format!(
                        "damping: {damping}, stiction: {}, provide: {provide}, scalar: {scalar}",
                        1 + masses % 2
                    );
                    names += check(&scene(masses, contact, excitation, &rest), &mut emitted);
                    scenes += 1;
                }
            }
        }
    }
    println!("{names} names in {scenes} scenes; emitted beside the library's: {emitted:?}");
    (scenes, names)
}

// The test is divided into two, because two threads need half the time.
#[test]
fn every_name_that_a_pattern_of_a_small_scene_binds_is_hidden() {
    let (scenes, names) = check_all(1..=8);
    assert!(scenes > 400 && names > 12_000, "{scenes} {names}");
}

#[test]
fn every_name_that_a_pattern_of_a_large_scene_binds_is_hidden() {
    let (scenes, names) = check_all(9..=64);
    assert!(scenes > 50 && names > 5_000, "{scenes} {names}");
}

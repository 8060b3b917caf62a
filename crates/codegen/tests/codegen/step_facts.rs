//! Checks the facts about emitted steppers that `step_facts` returns.
#![cfg(feature = "pretty")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use frictiongen_codegen::{SizeLimits, parse_text, step_facts};

/// Returns the numbers of the step tables that are 0, by their places, and the number of all numbers.
fn zeros(contact: &str, fields: &str) -> (Vec<String>, usize) {
    let text = format!(
        "struct Scene {{ masses: {{ a: 1.1, b: 2.3, c: 1.7 }}, springs: {{ base - a: 100, a - b: 57, b - c: 41 }},
         contact: {contact}, damping: modal(0.02), provide: [stepper], step: 0.01, {fields} }}"
    );
    let description = parse_text(&text, &SizeLimits::MACRO).unwrap_or_else(|_| panic!("{text}"));
    let facts = step_facts(&description).unwrap();
    let zeros = facts.numbers.iter().filter(|(_, number)| *number == 0.0);
    (
        zeros.map(|(place, _)| place.clone()).collect(),
        facts.numbers.len(),
    )
}

/// The comment above the tables says which numbers are 0 in every scene. All other numbers are not 0, unless a force has
/// no part in a motion of the contact.
#[test]
fn numbers_that_are_zero_in_every_scene() {
    for (contact, fields, on_base) in [
        ("c - wall", "excitation: base", false),
        ("b - base", "excitation: base", true),
        ("b - base", "excitation: base, damping_from: base", true),
        ("c - wall", "excitation: a", false),
        ("a - b", "excitation: a, input: hold", false),
    ] {
        let (zeros, all) = zeros(contact, fields);
        let name = format!("{contact} {fields}: {zeros:?} of {all}");
        let of = |modes: &str, suffix: &str| {
            let places = zeros.iter();
            let places = places.filter(|place| place.starts_with(modes) && place.ends_with(suffix));
            places.count()
        };
        // Three modes of the chain, two of the chain with its contact stuck.
        assert_eq!(of("modes", ".moments[0].drive[0]"), 3, "{name}");
        assert_eq!(of("held", ".moments[0].drive[1][0]"), 2, "{name}");
        let from_base = zeros.iter().filter(|place| place.contains("from_base"));
        assert_eq!(from_base.count(), if on_base { 0 } else { 8 }, "{name}");
        let in_oscillators = of("modes", "") + of("held", "");
        assert_eq!(in_oscillators, if on_base { 5 } else { 13 }, "{name}");
    }
}

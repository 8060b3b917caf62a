//! Tests texts of scenes with the run-time parser, and with the function that the macro calls.

use crate::fuzz::{long, none};
use frictiongen::System;
use fuzzing::Mutator;
use proc_macro2::TokenStream;

/// Words of the scene language, and some words that are not part of it.
const WORDS: &[&str] = &[
    "struct",
    "pub",
    "pub(crate)",
    "masses",
    "springs",
    "contact",
    "excitation",
    "damping",
    "stiction",
    "scalar",
    "provide",
    "accuracy",
    "range",
    "friction",
    "step",
    "input",
    "force",
    "crate",
    "base",
    "wall",
    "none",
    "modal",
    "rayleigh",
    "f32",
    "f64",
    "limits",
    "motion",
    "stuck",
    "orbit",
    "simulation",
    "stepper",
    "exact",
    "coulomb",
    "stribeck",
    "hold",
    "linear",
    "r",
    "beta",
    "self",
    "Self",
    "_",
    "r#type",
    "'a",
    "\"x\"",
    "b\"",
    "r#\"",
    "/*",
    "*/",
    "//",
    "///",
    "#[",
    "#![",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "<",
    ">",
    ":",
    "::",
    ",",
    ";",
    "-",
    "+",
    "*",
    "/",
    "..",
    "..=",
    "...",
    "=",
    "$",
    "0",
    "-0.0",
    "1e999",
    "1e-999",
    "1e",
    "1.",
    ".5",
    "0x",
    "1_",
    "1f32",
    "NaN",
    "inf",
    "340282e60",
    "\n",
];

/// Checks that a text gives a scene, or errors that are located in the text.
pub fn read(text: &str) -> Result<(), String> {
    let Err(diagnostics) = text.parse::<System>() else {
        return Ok(());
    };
    if diagnostics.list.is_empty() {
        return Err("refused without a reason".to_owned());
    }
    for diagnostic in &diagnostics.list {
        // A missing token is reported one column after the last character.
        let lines = text.split('\n').count();
        let columns = text
            .split('\n')
            .nth(diagnostic.line.wrapping_sub(1))
            .map(|line| line.chars().count());
        if diagnostic.message.is_empty()
            || !(1..=lines).contains(&diagnostic.line)
            || !columns.is_some_and(|columns| (1..=columns + 1).contains(&diagnostic.column))
        {
            return Err(format!("an error without a place: {diagnostic}"));
        }
    }
    Ok(())
}

/// Checks that the macro's output is valid Rust for every text that can be tokenised.
pub fn expanded(text: &str) -> Result<(), String> {
    let outcome = match text.parse::<TokenStream>() {
        Ok(tokens) => {
            let emitted = frictiongen_codegen::expand(tokens);
            syn::parse2::<syn::File>(emitted)
                .map(drop)
                .map_err(|error| format!("no Rust: {error}"))
        }
        Err(_) => Ok(()),
    };
    // The texts of spans would otherwise stay in memory.
    proc_macro2::extra::invalidate_current_thread_spans();
    outcome
}

fn fuzz(target: &str, count: u64, seed: u64, check: fn(&str) -> Result<(), String>) {
    let corpus = fuzzing::corpus("scenes").expect("the corpus");
    for scene in &corpus {
        check(&String::from_utf8_lossy(scene)).expect("the corpus itself");
    }
    let mut mutator = Mutator::new(corpus, WORDS, seed);
    let next = || String::from_utf8_lossy(&mutator.input()).into_owned();
    none(target, &fuzzing::run(count, next, |text| check(text)));
}

#[test]
fn texts_are_scenes_or_have_located_errors() {
    fuzz("run-time text", 3_000, 1, read);
}

#[test]
fn the_macro_expands_to_rust() {
    fuzz("macro", 1_000, 2, expanded);
}

#[test]
#[ignore = "a million texts: minutes"]
fn a_million_texts() {
    fuzz("run-time text", long(), 3, read);
}

#[test]
#[ignore = "a million macro calls: many minutes"]
fn a_million_macro_calls() {
    fuzz("macro", long(), 4, expanded);
}

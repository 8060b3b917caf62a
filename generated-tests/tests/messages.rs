//! Tests of every message of the scene language: its text, its position in the description, and the replacement that it
//! suggests, for each way to give a description.
//!
//! A case is a file in `messages/` with its cause in a sentence, a faulty description, the messages for it, and the
//! corrected description. Two ignored tests give the cases to the compiler.

#[path = "messages/harness/case.rs"]
mod case;
#[path = "messages/harness/rust.rs"]
mod rust;
#[path = "messages/harness/sources.rs"]
mod sources;

use case::{Door, cases};
use frictiongen::System;
use frictiongen_codegen::{SizeLimits, expand, parse_text};
use frictiongen_model::scene::{
    CONTACT, ContactSides, Damping, Declared, Excitation, FrictionLaw, Mass, Node, Precision,
    Provide, Scene, Spring, StepperOptions,
};
use frictiongen_model::validate::validate;
use proc_macro2::{Literal, TokenTree};
use std::path::Path;

/// Checks that the parser gives the messages of each case with line and column, and accepts the corrected description.
#[test]
fn of_a_text() {
    for case in cases() {
        if case.door.takes_text() {
            let told = parse_text(&case.faulty, &SizeLimits::MACRO)
                .expect_err(&case.name)
                .to_string();
            assert_eq!(told, case.told.join("\n"), "{}", case.name);
        } else if case.door == Door::Macro {
            // The macro must refuse the faulty text. It reads texts with its own limits.
            parse_text(&case.faulty, &SizeLimits::MACRO).expect_err(&case.name);
        }
        if case.door.is_description() {
            // The macro emits code for fewer scenes with several contacts than a `System` solves.
            let limits = SizeLimits {
                emitted: matches!(case.door, Door::Emitted | Door::Macro),
                ..SizeLimits::MACRO
            };
            parse_text(&case.cured, &limits)
                .unwrap_or_else(|told| panic!("the cure of {} is none:\n{told}", case.name));
        }
    }
}

/// Checks that a run-time system gives the same messages as the parser. It accepts larger scenes, and scenes for which
/// the macro cannot emit code.
#[test]
fn of_a_system() {
    for case in cases() {
        if case.door == Door::Emitted {
            let accepted = case.faulty.parse::<System>();
            accepted.unwrap_or_else(|told| panic!("{}: {told}", case.name));
        } else if case.door.takes_text() && !case.name.ends_with("too-many-masses") {
            let told = case
                .faulty
                .parse::<System>()
                .expect_err(&case.name)
                .to_string();
            assert_eq!(told, case.told.join("\n"), "{}", case.name);
        }
    }
}

/// Checks that the macro gives the same messages for a description in a file. The compiler shows them at the path's
/// token, with the position in the file.
#[test]
fn of_a_file() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("faulty.friction");
    let shown = path.display().to_string();
    for case in cases() {
        if case.door.takes_text() {
            std::fs::write(&path, &case.faulty).expect("a file for the text");
            let expected: Vec<_> = case
                .told
                .iter()
                .map(|told| format!("{shown}:{told}"))
                .collect();
            assert_eq!(told_by_expansion(&shown), expected, "{}", case.name);
        }
    }
}

#[test]
fn of_a_file_that_is_not_there() {
    for case in cases() {
        if case.door == Door::File {
            let folder = env!("CARGO_MANIFEST_DIR");
            let expected: Vec<_> = case
                .told
                .iter()
                .map(|told| told.replace("{folder}", folder))
                .collect();
            let path = case.faulty.split('"').nth(1).expect("a path");
            assert_eq!(told_by_expansion(path), expected);
        }
    }
}

/// Returns the errors that the macro reports for a file.
fn told_by_expansion(path: &str) -> Vec<String> {
    let path = TokenTree::from(Literal::string(path));
    let mut told = Vec::new();
    sources::each_string(expand(path.into()), &mut |before, text| {
        if before == "compile_error" {
            told.push(text);
        }
    });
    told
}

/// Checks errors that only a scene built in code can contain.
#[test]
fn of_a_scene_made_in_code() {
    let faulty = |name: &str| {
        let mut scene = frame();
        match name {
            "708-not-finite" => scene.masses[0].value = f64::NAN,
            "779-infinite-stiffness-of-the-contact" => scene.stiffness = Some(f64::INFINITY),
            "785-stiffness-of-the-contact-not-a-number" => {
                scene.stiffness = Some(f64::NAN);
                scene.provide = vec![Provide::Orbit];
            }
            "712-no-such-mass" => scene.excitation = Excitation::Force(6),
            other => panic!("{other} is not known here"),
        }
        scene
    };
    for case in cases() {
        if case.door == Door::Code {
            let errors = validate(&faulty(&case.name)).expect_err(&case.name);
            let told: Vec<_> = errors.iter().map(ToString::to_string).collect();
            assert_eq!(told, case.told, "{}", case.name);
        }
    }
}

fn frame() -> Scene {
    let mass = |name: &str, value| Mass {
        name: name.to_owned(),
        value,
    };
    let spring = |from, to, stiffness| Spring {
        from,
        to,
        stiffness,
    };
    Scene {
        name: "Frame".to_owned(),
        masses: vec![mass("lower", 3.27), mass("upper", 3.25)],
        springs: vec![
            spring(Node::Base, Node::Mass(0), 1190.0),
            spring(Node::Mass(0), Node::Mass(1), 1323.0),
        ],
        contact: ContactSides {
            from: Node::Mass(1),
            to: Node::Wall,
        },
        contact_name: CONTACT.to_owned(),
        excitation: Excitation::Base,
        damping: Damping::None,
        damping_from: Default::default(),
        stiffness: None,
        stiction: 1.0,
        precision: Precision::F64,
        provide: vec![Provide::Limits],
        declared: Declared::default(),
        friction: FrictionLaw::default(),
        stepping: StepperOptions::default(),
        joints: Default::default(),
    }
}

/// Checks that the compiler shows the message of each case at the right token.
#[test]
#[ignore = "builds a crate: half a minute"]
fn of_a_macro_at_the_right_places() {
    rust::check_places(&cases());
}

#[test]
#[ignore = "builds a crate: half a minute"]
fn of_a_method_that_is_not_provided() {
    rust::check_missing_methods();
}

/// Checks that every message has a case. Each text in the sources that is part of a message must occur in the messages
/// of a case.
#[test]
fn every_message_has_a_case() {
    let told: Vec<String> = cases()
        .iter()
        .flat_map(|case| case.told.iter().map(|line| case.message(line).to_owned()))
        .collect();
    let texts = sources::texts();
    let missing: Vec<_> = texts
        .iter()
        .filter(|text| !told.iter().any(|told| text.is_part_of(told)))
        .map(|text| format!("{}: {:?}", text.file, text.text))
        .collect();
    assert!(
        missing.is_empty(),
        "no case in generated-tests/tests/messages/ shows\n{}",
        missing.join("\n")
    );
    let whole = texts
        .iter()
        .filter(|text| told.iter().any(|told| text.is_whole(told)))
        .count();
    let count = cases().len();
    println!(
        "{whole} messages, {} parts of messages, {count} cases",
        texts.len() - whole
    );
    assert!(
        whole >= 110,
        "the scan of the sources finds too few messages: {whole}"
    );
}

/// Checks that no case occurs twice.
#[test]
fn no_case_twice() {
    let cases = cases();
    for (index, case) in cases.iter().enumerate() {
        assert!(!case.told.is_empty(), "{}", case.name);
        assert_ne!(case.faulty, case.cured, "{}", case.name);
        for other in &cases[index + 1..] {
            assert!(
                case.faulty != other.faulty && case.cause != other.cause,
                "{} and {}",
                case.name,
                other.name
            );
        }
    }
}

//! Tests of every message of the scene language: its text, its position in the description, and the replacement that it
//! suggests, for each way to give a description.
//!
//! A case is a file in `messages/` with its cause in a sentence, a faulty description, the messages for it, and the
//! corrected description. The cases generate `../refused/tests/messages/*.rs`, which the compiler reads. After a change:
//!
//! ```sh
//! UPDATE_DOCS=1 cargo test -p generated-tests --test messages
//! TRYBUILD=overwrite cargo test -p refused-scenes
//! ```

#[path = "messages/harness/case.rs"]
mod case;
#[path = "messages/harness/rust.rs"]
mod rust;
#[path = "messages/harness/sources.rs"]
mod sources;

use case::{Case, Door, cases};
use frictiongen::System;
use frictiongen_codegen::{SizeLimits, expand, parse_text};
use frictiongen_model::scene::{
    ContactSides, Damping, Declared, Excitation, FrictionLaw, Mass, Node, Precision, Provide,
    Scene, Spring, StepperOptions,
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
            // The cure may be a scene with several contacts for a `System` at run time, of which the macro emits less.
            let limits = SizeLimits {
                joints: true,
                ..SizeLimits::MACRO
            };
            parse_text(&case.cured, &limits)
                .unwrap_or_else(|told| panic!("the cure of {} is none:\n{told}", case.name));
        }
    }
}

/// Checks that a run-time system gives the same messages as the parser. It accepts larger scenes.
#[test]
fn of_a_system() {
    for case in cases() {
        if case.door.takes_text() && !case.name.ends_with("too-many-masses") {
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

/// Checks that the files of `refused-scenes`, which the compiler reads, contain these cases.
#[test]
fn of_a_macro() {
    rust::write_or_check(&cases());
}

/// Checks that the recorded output of the compiler has the message of each case at the right position. A message at the
/// wrong token, or an extra message, cannot be recorded unnoticed.
#[test]
fn of_a_macro_at_the_right_places() {
    rust::check_places(&cases());
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

/// Writes a file if `UPDATE_DOCS` is set, and otherwise fails if the file is out of date.
fn write_or_compare(path: &Path, text: &str) {
    if std::env::var_os("UPDATE_DOCS").is_some() {
        let folder = path.parent().expect("a folder");
        std::fs::create_dir_all(folder).expect("the folder can be made");
        std::fs::write(path, text).expect("the file can be written");
        return;
    }
    let found = std::fs::read_to_string(path).unwrap_or_default();
    assert!(
        found == text,
        "{} is out of date; run `UPDATE_DOCS=1 cargo test -p generated-tests --test messages`",
        path.display()
    );
}

/// Returns the cases of each group, by the first digit of their number.
fn groups(cases: &[Case]) -> impl Iterator<Item = (&'static Group, Vec<&Case>)> {
    GROUPS.iter().map(|group| {
        let own = cases
            .iter()
            .filter(|case| case.name.starts_with(group.digit))
            .collect();
        (group, own)
    })
}

/// A group of related cases.
struct Group {
    digit: char,
    /// Files that the compiler reads, each with the number of its first case.
    files: &'static [(&'static str, &'static str)],
}

impl Group {
    /// Returns the cases of each file.
    fn of_files<'c>(&self, cases: &[&'c Case]) -> Vec<(&'static str, Vec<&'c Case>)> {
        let next = self.files.iter().skip(1).map(|(_, first)| *first);
        let next = next.map(Some).chain([None]);
        let of_file = |((file, first), next): (&(&'static str, &str), Option<&str>)| {
            let own = cases.iter().filter(|case| {
                let name = case.name.as_str();
                *first <= name && next.is_none_or(|next| name < next)
            });
            (*file, own.copied().collect())
        };
        self.files.iter().zip(next).map(of_file).collect()
    }
}

const GROUPS: [Group; 8] = [
    Group {
        digit: '1',
        files: &[("text", "101")],
    },
    Group {
        digit: '2',
        files: &[("around", "201")],
    },
    Group {
        digit: '3',
        files: &[("fields", "301")],
    },
    Group {
        digit: '4',
        files: &[("picture", "401")],
    },
    Group {
        digit: '5',
        files: &[("settings", "501"), ("settings_in_time", "525")],
    },
    Group {
        digit: '6',
        files: &[("numbers", "601")],
    },
    Group {
        digit: '7',
        files: &[
            ("scenes", "701"),
            ("scenes_provided", "730"),
            ("scenes_in_time", "753"),
            ("scenes_joined", "780"),
        ],
    },
    Group {
        digit: '8',
        files: &[("files", "801")],
    },
];

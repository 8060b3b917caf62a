//! Tests the self-check of emitted files: its known answers are right, and it finds a wrong digit in each kind of
//! number.

use super::{cc, folder, run, rustc, source, write_c};
use frictiongen::System;
use frictiongen_codegen::known::{AnswersRequest, MotionKind, known};
use frictiongen_codegen::standalone::{known_answers, rust_source};
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::Precision;
use std::process::Command;

const SCENE: &str = "struct Scene {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - base, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2,
    provide: [limits, motion, stuck], accuracy: 1e-3, range: { r: 0.2..2.5 },
}";

const C_MAIN: &str = "#include <stdio.h>\n#include \"scene.h\"\nint main(void);\n\
    int main(void) {\n    printf(\"%d\\n\", (int)scene_self_check());\n    return 0;\n}\n";

const RUST_MAIN: &str =
    "mod tables;\nfn main() {\n    println!(\"{:?}\", tables::self_check());\n}\n";

/// Returns a text in which the last digit of the first number after `mark` is changed.
fn with_a_wrong_digit(text: &str, mark: &str) -> String {
    let from = text.find(mark).unwrap_or_else(|| panic!("no {mark}")) + mark.len();
    let is_part = |letter: char| letter.is_ascii_digit() || letter == '.';
    let start = from + text[from..].find(|c: char| c.is_ascii_digit()).unwrap();
    let end = start + text[start..].find(|c: char| !is_part(c)).unwrap();
    let digit = text[start..end]
        .rfind(|c: char| c.is_ascii_digit())
        .unwrap()
        + start;
    let other = if &text[digit..=digit] == "3" {
        "4"
    } else {
        "3"
    };
    let mut wrong = text.to_owned();
    wrong.replace_range(digit..=digit, other);
    wrong
}

/// Checks that the known answers agree with the exact formulas of the run-time system, and include every kind of
/// motion.
#[test]
fn known_answers_are_right() {
    let system: System = SCENE.parse().expect("a scene");
    let compiled = system.compile(0.2..2.5, 1e-3).expect("tables");
    let (tolerance, known) = known_answers(&source(system.scene(), compiled.tables()));
    assert!((1e-3..1.001e-3).contains(&tolerance), "{tolerance}");
    assert_eq!(known.len(), 10);
    let mut seen = [0; 3];
    // At these frequencies no answer depends on rounding, so double precision keeps more than ten digits.
    let close = |one: f64, other: f64, size: f64| {
        assert!((one - other).abs() <= 1e-10 * size, "{one} for {other}");
    };
    for known in &known {
        let at = system.at(known.r).expect("in the range");
        let limits = at.limits();
        close(known.continuous, limits.continuous, limits.continuous);
        close(known.sliding, limits.sliding, limits.sliding);
        let motion = known.motion.as_ref().expect("a motion");
        seen[motion.outcome as usize] += 1;
        if motion.outcome == MotionKind::Continuous {
            let own = at.motion(motion.beta).expect("continuous");
            let [amplitude, phase] = motion.contact;
            close(amplitude, own.contact().amplitude(), amplitude);
            close(phase, own.contact().phase(), 1.0);
        } else {
            assert!(at.motion(motion.beta).is_err());
        }
        let stuck = at.stuck().expect("no resonance");
        let own = ["lower", "upper"].map(|name| stuck.mass(name).expect("a mass"));
        let own = own.into_iter().chain([stuck.contact_force()]);
        for (own, [re, im]) in own.zip(&known.stuck) {
            close(*re, own.re, re.hypot(*im));
            close(*im, own.im, re.hypot(*im));
        }
    }
    assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
}

/// Checks that each tenth of the range of r has a known answer. This holds above the highest resonance too. It also
/// holds in undamped chains, whose answers depend on rounding at most frequencies. The answers agree with those of
/// the run-time system within the error that the self-check allows.
#[test]
fn known_answers_cover_the_range() {
    let chain = |masses: usize, damping: &str| {
        let masses: Vec<usize> = (1..=masses).collect();
        let named = masses
            .iter()
            .map(|mass| format!("m{mass}: {}", 3.0 + 0.1 * (mass * 7 % 10) as f64));
        let springs = masses
            .iter()
            .skip(1)
            .map(|mass| format!(", m{} - m{mass}: {}", mass - 1, 1190 + 50 * (mass * 3 % 10)));
        format!(
            "struct Chain {{ masses: {{ {} }}, springs: {{ base - m1: 1190{} }}, contact: m1 - wall, excitation: base,
             damping: {damping} }}",
            named.collect::<Vec<_>>().join(", "),
            springs.collect::<String>()
        )
    };
    const WIDEST: f64 = 65536.0 * f64::EPSILON;
    let mut compared = 0;
    for (masses, damping) in [
        (1, "none"),
        (2, "modal(0.02)"),
        (3, "none"),
        (10, "none"),
        (10, "modal(0.02)"),
    ] {
        let system: System = chain(masses, damping).parse().expect("a scene");
        let modal = Modal::of(system.scene());
        let resonances: Vec<f64> = modal.resonances.iter().map(|own| own.hi).collect();
        let highest = *resonances.last().expect("a mode");
        let (low, high) = (0.2 * resonances[0], 1.5 * highest);
        let all = known(
            &modal,
            &AnswersRequest {
                precision: Precision::F64,
                r: (low, high),
                beta: (0.0, f64::MAX),
                tolerance: 4096.0 * f64::EPSILON,
                widest: WIDEST,
                motion: true,
                stuck: false,
            },
        );
        let parts: Vec<usize> = all
            .iter()
            .map(|own| (10.0 * (own.r - low) / (high - low)) as usize)
            .collect();
        assert_eq!(parts, (0..10).collect::<Vec<_>>(), "{masses} {damping}");
        assert!(all.iter().filter(|own| highest < own.r).count() >= 3);
        for own in &all {
            let allowed = own.needs().max(4096.0 * f64::EPSILON);
            assert!(allowed <= WIDEST);
            let at = system.at(own.r).expect("in the range");
            let limits = at.limits();
            for (one, other) in [
                (own.continuous, limits.continuous),
                (own.sliding, limits.sliding),
            ] {
                assert!((one - other).abs() <= allowed * one, "{one} for {other}");
                compared += 1;
            }
            let motion = own.motion.as_ref().expect("a motion");
            if motion.outcome == MotionKind::Continuous {
                let amplitude = at
                    .motion(motion.beta)
                    .expect("continuous")
                    .contact()
                    .amplitude();
                assert!((motion.contact[0] - amplitude).abs() <= allowed * amplitude);
                compared += 1;
            }
        }
    }
    println!("{compared} known answers compared");
    assert!(compared > 120);
}

/// A file, a change of its text, and the status that the self-check must then return.
type Wrong<'f> = (&'f str, &'f dyn Fn(&str) -> String, i32);

/// Checks that the self-check in C finds a wrong digit in a number, or a wrong sign in a formula. The status must be
/// the number of the fault in the header.
#[test]
fn faults_in_c() {
    let system: System = SCENE.parse().expect("a scene");
    let compiled = system.compile(0.2..2.5, 1e-3).expect("tables");
    let folder = folder("check_c");
    write_c(
        &folder,
        "scene",
        &source(system.scene(), compiled.tables()),
        "scene",
    );
    std::fs::write(folder.join("main.c"), C_MAIN).expect("written");
    let found = || {
        cc(&folder, &["-o", "program", "main.c", "scene.c", "-lm"]);
        run(&mut Command::new(folder.join("program")))
    };
    assert_eq!(found(), "0\n");
    let wrong: [Wrong<'_>; 11] = [
        (
            "scene_tables.h",
            &|text| with_a_wrong_digit(text, "buckets[BUCKETS] = {"),
            1,
        ),
        (
            "scene_tables.h",
            &|text| with_a_wrong_digit(text, "pieces[PIECES] = {"),
            2,
        ),
        (
            "scene_tables.h",
            &|text| with_a_wrong_digit(text, "SLIDING_GAIN = "),
            3,
        ),
        (
            "scene_tables.h",
            &|text| with_a_wrong_digit(text, "HELD_POLE_1 = "),
            3,
        ),
        (
            "scene_tables.h",
            &|text| with_a_wrong_digit(text, "REFERENCE = "),
            4,
        ),
        ("scene.h", &|text| with_a_wrong_digit(text, "SCENE_K1 "), 4),
        (
            "scene_tables.h",
            &|text| with_a_wrong_digit(text, "known[KNOWN] = {"),
            5,
        ),
        (
            "scene.c",
            &|text| text.replace("(in_phase - (share", "(in_phase + (share"),
            8,
        ),
        (
            "scene_tables.h",
            &|text| with_a_wrong_digit(text, "TOLERANCE = "),
            5,
        ),
        (
            "scene.c",
            &|text| text.replace("return omega / ", "return 1.000001 * omega / "),
            6,
        ),
        (
            "scene.c",
            &|text| text.replace("return friction / load", "return friction * load"),
            6,
        ),
    ];
    for (file, change, number) in wrong {
        let path = folder.join(file);
        let right = std::fs::read_to_string(&path).expect("a file");
        let changed = change(&right);
        assert_ne!(changed, right, "{file}, fault {number}");
        std::fs::write(&path, changed).expect("written");
        assert_eq!(found(), format!("{number}\n"), "{file}");
        std::fs::write(&path, right).expect("written");
    }
}

/// Checks that the self-check in Rust finds such faults. The error must name the number or the function.
#[test]
fn faults_in_rust() {
    let system: System = SCENE.parse().expect("a scene");
    let compiled = system.compile(0.2..2.5, 1e-3).expect("tables");
    let folder = folder("check_rust");
    let right = rust_source(&source(system.scene(), compiled.tables()));
    let right = right.expect("a form of its own");
    std::fs::write(folder.join("main.rs"), RUST_MAIN).expect("written");
    let found = |text: &str| {
        std::fs::write(folder.join("tables.rs"), text).expect("written");
        rustc(&folder, &["main.rs", "-o", "program"]);
        run(&mut Command::new(folder.join("program")))
    };
    assert_eq!(found(&right), "Ok(())\n");
    let buckets = right.find("static BUCKETS").expect("buckets");
    let list = buckets + right[buckets..].find("= [").expect("a list");
    let buckets = &right[buckets..list];
    let numbers = [
        (buckets, "BUCKETS"),
        ("            from: ", "PIECES"),
        ("SLIDING_GAIN: f64 = ", "CONSTANTS"),
        ("pub const K1: f64 = ", "UNITS"),
        ("            head: [", "KNOWN"),
        ("const TOLERANCE: f64 = ", "KNOWN"),
    ];
    for (mark, name) in numbers {
        let wrong = with_a_wrong_digit(&right, mark);
        assert_eq!(found(&wrong), format!("Err(Numbers(\"{name}\"))\n"));
    }
    for (from, to, function) in [
        ("(in_phase - share", "(in_phase + share", "contact"),
        ("friction / load", "friction * load", "friction_ratio"),
    ] {
        let wrong = right.replace(from, to);
        assert_ne!(wrong, right);
        assert_eq!(found(&wrong), format!("Err(Answer(\"{function}\"))\n"));
    }
}

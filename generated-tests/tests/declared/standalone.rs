//! The C and the Rust that `frictiongen compile` writes, compiled and compared with the library bit for bit.
//!
//! Phases go by the platform's arc tangent: within two roundings of a radian.

use super::scenes::scene;
use frictiongen::System;
use frictiongen::study::CompiledSystem;
use frictiongen_codegen::standalone::{c_header, c_source, rust_source};
use frictiongen_kernel::Float;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const POINTS: u32 = 2000;

/// r, β, both limits, amplitude and phase at a point; amplitude and phase NaN where there is no motion.
type Line = [f64; 6];

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("standalone")
        .join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Whether a compiler is at hand; a visible line where not.
fn has(compiler: &str) -> bool {
    let found = Command::new(compiler)
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    let found = found.is_ok_and(|status| status.success());
    if !found {
        println!("SKIPPED: no `{compiler}` here");
    }
    found
}

fn run(command: &mut Command) -> String {
    let output = command.output().expect("runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("text")
}

/// The r of the programs.
fn ratios<S: Float>() -> impl Iterator<Item = S> {
    let (low, high) = (S::constant(0.2), S::constant(2.5));
    let points = S::constant(f64::from(POINTS));
    (0..=POINTS).map(move |k| (low + (high - low) * S::constant(f64::from(k)) / points).min(high))
}

/// What the library answers at the points of the programs.
fn expected<S: Float>(compiled: &CompiledSystem<'_, S>) -> Vec<Line> {
    ratios::<S>()
        .map(|r| {
            let at = compiled.at(r).expect("in the range");
            let limits = at.limits();
            let beta = S::constant(0.5) * limits.continuous;
            let (amplitude, phase) = match at.motion(beta) {
                Ok(motion) => {
                    let largest = motion.contact().largest();
                    (largest.amplitude, largest.phase)
                }
                Err(_) => (S::constant(f64::NAN), S::constant(f64::NAN)),
            };
            [r, beta, limits.continuous, limits.sliding, amplitude, phase].map(Float::to_f64)
        })
        .collect()
}

fn compare(what: &str, output: &str, expected: &[Line], epsilon: f64) {
    let lines: Vec<&str> = output.lines().collect();
    assert_eq!(lines.len(), expected.len(), "{what}");
    let mut motions = 0;
    for (line, expected) in lines.into_iter().zip(expected) {
        let numbers: Vec<f64> = line
            .split(' ')
            .map(|text| f64::from_bits(u64::from_str_radix(text, 16).expect("bits")))
            .collect();
        let [r, _, continuous, sliding, amplitude, phase] = *expected;
        assert_eq!(numbers[0].to_bits(), r.to_bits(), "{what}: r");
        assert_eq!(
            numbers[1].to_bits(),
            continuous.to_bits(),
            "{what}: limit at r = {r}"
        );
        assert_eq!(
            numbers[2].to_bits(),
            sliding.to_bits(),
            "{what}: sliding limit at r = {r}"
        );
        if amplitude.is_nan() {
            assert!(numbers[3].is_nan(), "{what}: a motion at r = {r}");
            continue;
        }
        motions += 1;
        assert_eq!(
            numbers[3].to_bits(),
            amplitude.to_bits(),
            "{what}: amplitude at r = {r}"
        );
        assert!(
            (numbers[4] - phase).abs() <= 8.0 * epsilon,
            "{what}: phase at r = {r}: {} for {phase}",
            numbers[4]
        );
    }
    assert!(motions > POINTS / 2, "{what}: {motions} motions");
}

const C_MAIN: &str = r#"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "SCENE.h"
static void bits(double value) { unsigned long long b; memcpy(&b, &value, 8); printf("%llx", b); }
int main(void) {
    for (int k = 0; k <= POINTS; k++) {
        REAL r = (REAL)0.2 + ((REAL)2.5 - (REAL)0.2) * (REAL)k / (REAL)POINTS;
        if ((REAL)2.5 < r) r = (REAL)2.5;
        REAL c, s, a = NAN, p = NAN;
        if (SCENE_limits(r, &c, &s) != 0) return 1;
        if (SCENE_contact(r, (REAL)0.5 * c, &a, &p) != 0) { a = NAN; p = NAN; }
        bits(r); printf(" "); bits(c); printf(" "); bits(s); printf(" "); bits(a); printf(" "); bits(p); printf("\n");
    }
    REAL c = 7, s = 7;
    if (SCENE_limits((REAL)0.1, &c, &s) != -1 || SCENE_limits((REAL)NAN, &c, &s) != -1 || c != 7 || s != 7) return 2;
    if (SCENE_contact(1, (REAL)-1, &c, &s) != -1 || SCENE_contact(1, (REAL)1e6, &c, &s) != 2 || c != 7) return 3;
    return 0;
}
"#;

const RUST_MAIN: &str = r#"
#[path = "SCENE.rs"]
mod tables;
fn main() {
    for k in 0..=POINTS {
        let r: REAL = 0.2 + (2.5 - 0.2) * k as REAL / POINTS as REAL;
        let r = if 2.5 < r { 2.5 } else { r };
        let (c, s) = tables::limits(r).expect("in the range");
        let (a, p) = tables::contact(r, 0.5 * c).unwrap_or((REAL::NAN, REAL::NAN));
        println!("{:x} {:x} {:x} {:x} {:x}", f64::from(r).to_bits(), f64::from(c).to_bits(), f64::from(s).to_bits(), f64::from(a).to_bits(), f64::from(p).to_bits());
    }
    assert!(tables::limits(0.1).is_none() && tables::limits(REAL::NAN).is_none());
    assert_eq!(tables::contact(1.0, 1e6), Err(tables::NotContinuous::Stuck));
    assert_eq!(tables::contact(1.0, -1.0), Err(tables::NotContinuous::OutOfDomain));
}
"#;

fn check<S: Float>(kind: &str, count: usize, damping: &str) {
    let single = S::EPSILON > 1e-10;
    let (scalar, real) = if single {
        ("f32", "float")
    } else {
        ("f64", "double")
    };
    let system: System<S> = scene(kind, count, damping, "1.2", scalar)
        .parse()
        .expect("a scene");
    let compiled = system.compile(0.2..2.5, 1e-4).expect("tables");
    let expected = expected(&compiled);
    let name = format!("{}{count}", kind.to_lowercase());
    let what = format!("{kind}{count} {damping} {scalar}");
    let folder = folder(&what.replace([' ', '(', ')'], "_"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("written");
    let fill = |text: &str, real: &str| {
        text.replace("SCENE", &name)
            .replace("REAL", real)
            .replace("POINTS", &POINTS.to_string())
    };
    if has("cc") {
        write(
            &format!("{name}.h"),
            &c_header(system.scene(), compiled.tables()),
        );
        let source = c_source(
            system.scene(),
            compiled.tables(),
            Some(&format!("{name}.h")),
        );
        write(&format!("{name}.c"), &source.expect("a form of its own"));
        write("main.c", &fill(C_MAIN, real));
        run(Command::new("cc").current_dir(&folder).args([
            "-std=c99",
            "-O2",
            "-ffp-contract=off",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-Wpedantic",
            "-o",
            "program",
            "main.c",
            &format!("{name}.c"),
            "-lm",
        ]));
        compare(
            &format!("{what} in C"),
            &run(&mut Command::new(folder.join("program"))),
            &expected,
            S::EPSILON,
        );
        // The same text without a header is whole by itself.
        write(
            "alone.c",
            &c_source(system.scene(), compiled.tables(), None).expect("a form of its own"),
        );
        run(Command::new("cc")
            .current_dir(&folder)
            .args(["-std=c99", "-Wall", "-Werror", "-c", "alone.c"]));
    }
    if has("rustc") {
        write(
            &format!("{name}.rs"),
            &rust_source(system.scene(), compiled.tables()).expect("a form of its own"),
        );
        write("main.rs", &fill(RUST_MAIN, scalar));
        run(Command::new("rustc").current_dir(&folder).args([
            "--edition=2024",
            "-O",
            "-Dwarnings",
            "main.rs",
            "-o",
            "program_rs",
        ]));
        compare(
            &format!("{what} in Rust"),
            &run(&mut Command::new(folder.join("program_rs"))),
            &expected,
            S::EPSILON,
        );
    }
}

#[test]
fn in_double_precision() {
    check::<f64>("Wall", 1, "none");
    check::<f64>("Base", 2, "modal(0.02)");
    check::<f64>("Pair", 5, "none");
}

#[test]
fn in_single_precision() {
    check::<f32>("Wall", 2, "none");
    check::<f32>("Pair", 5, "modal(0.02)");
}

const C_STUCK: &str = r#"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "scene.h"
static void bits(double value) { unsigned long long b; memcpy(&b, &value, 8); printf(" %llx", b); }
int main(void) {
    for (int k = 0; k <= POINTS; k++) {
        REAL r = (REAL)0.2 + ((REAL)2.5 - (REAL)0.2) * (REAL)k / (REAL)POINTS;
        if ((REAL)2.5 < r) r = (REAL)2.5;
        REAL re, im;
        bits(r);
        CALLS
        printf("\n");
    }
    REAL re = 7, im = 7;
    if (scene_holding_force((REAL)0.1, &re, &im) != -1 || scene_holding_force((REAL)NAN, &re, &im) != -1) return 2;
    if (scene_stuck_FIRST((REAL)2.6, &re, &im) != -1 || re != 7 || im != 7) return 3;
    if (RESONANT && (scene_stuck_FIRST((REAL)2, &re, &im) != 1 || scene_holding_force((REAL)2, &re, &im) != 1 || re != 7)) return 4;
    return 0;
}
"#;

const RUST_STUCK: &str = r#"
#[path = "scene.rs"]
mod tables;
fn main() {
    for k in 0..=POINTS {
        let r: REAL = 0.2 + (2.5 - 0.2) * k as REAL / POINTS as REAL;
        let r = if 2.5 < r { 2.5 } else { r };
        print!(" {:x}", f64::from(r).to_bits());
        let shown = |answer: Option<(REAL, REAL)>| match answer {
            Some((re, im)) => print!(" {:x} {:x}", f64::from(re).to_bits(), f64::from(im).to_bits()),
            None => unreachable!("no r of these is a resonance"),
        };
        CALLS
        println!();
    }
    assert!(tables::holding_force(0.1).is_none() && tables::holding_force(REAL::NAN).is_none());
    assert!(tables::stuck_FIRST(2.6).is_none());
    assert!(RESONANT == 0 || tables::stuck_FIRST(2.0).is_none() && tables::holding_force(2.0).is_none());
}
"#;

/// Stuck responses of a scene; whether they resonate at r = 2.
fn check_stuck<S: Float>(name: &str, text: &str, resonant: bool) {
    let single = S::EPSILON > 1e-10;
    let (scalar, real) = if single {
        ("f32", "float")
    } else {
        ("f64", "double")
    };
    let text = format!(
        "struct Scene {{ {text}, scalar: {scalar}, provide: [limits, stuck], accuracy: 1e-4, range: {{ r: 0.2..2.5 }} }}"
    );
    let system: System<S> = text.parse().expect("a scene");
    let compiled = system.compile(0.2..2.5, 1e-4).expect("tables");
    assert!(compiled.tables().held.is_some(), "{text}");
    let masses = &system.scene().masses;
    let names: Vec<&str> = masses.iter().map(|mass| mass.name.as_str()).collect();
    let mut expected = String::new();
    for r in ratios::<S>() {
        write!(expected, " {:x}", r.to_f64().to_bits()).unwrap();
        let stuck = compiled.at(r).expect("in the range").stuck();
        let stuck = stuck.expect("no resonance");
        let masses = names.iter().map(|name| stuck.mass(name).expect("a mass"));
        for value in masses.chain([stuck.contact_force()]) {
            let (re, im) = (value.re.to_f64().to_bits(), value.im.to_f64().to_bits());
            write!(expected, " {re:x} {im:x}").unwrap();
        }
        expected.push('\n');
    }
    let two = compiled.at(S::constant(2.0)).expect("in the range").stuck();
    assert_eq!(two.is_err(), resonant, "{text}");
    let folder = folder(&format!("stuck_{name}_{scalar}"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("written");
    let fill = |text: &str, real: &str, call: &dyn Fn(&str) -> String| {
        let calls = names.iter().map(|name| format!("stuck_{name}"));
        let calls = calls.chain(["holding_force".to_owned()]);
        let calls: String = calls.map(|name| call(&name)).collect();
        let text = text.replace("CALLS", &calls).replace("FIRST", names[0]);
        let text = text.replace("REAL", real);
        let text = text.replace("RESONANT", if resonant { "1" } else { "0" });
        text.replace("POINTS", &POINTS.to_string())
    };
    let same = |program: &str| {
        let output = run(&mut Command::new(folder.join(program)));
        for (own, expected) in output.lines().zip(expected.lines()) {
            assert_eq!(own, expected, "{text}: {program}");
        }
        assert_eq!(output.len(), expected.len(), "{text}: {program}");
    };
    if has("cc") {
        write("scene.h", &c_header(system.scene(), compiled.tables()));
        let source = c_source(system.scene(), compiled.tables(), Some("scene.h"));
        let source = source.expect("a form of its own");
        // Complex numbers of damped chains alone.
        assert_eq!(source.contains("struct number"), text.contains("damping"));
        write("scene.c", &source);
        let call = |name: &str| {
            format!("if (scene_{name}(r, &re, &im) != 0) return 1;\nbits(re); bits(im);\n")
        };
        write("main.c", &fill(C_STUCK, real, &call));
        let flags = "-std=c99 -O2 -ffp-contract=off -Wall -Wextra -Werror -Wpedantic -o program";
        run(Command::new("cc")
            .current_dir(&folder)
            .args(flags.split(' '))
            .args(["main.c", "scene.c", "-lm"]));
        same("program");
    }
    if has("rustc") {
        let source = rust_source(system.scene(), compiled.tables());
        write("scene.rs", &source.expect("a form of its own"));
        let call = |name: &str| format!("shown(tables::{name}(r));\n");
        write("main.rs", &fill(RUST_STUCK, scalar, &call));
        let flags = "--edition=2024 -O -Dwarnings main.rs -o program_rs";
        run(Command::new("rustc")
            .current_dir(&folder)
            .args(flags.split(' ')));
        same("program_rs");
    }
}

#[test]
fn stuck_responses() {
    let one = "masses: { m0: 1 }, springs: { base - m0: 1 }, contact: m0 - wall, excitation: m0";
    check_stuck::<f64>("one", one, false);
    // Held, the first mass resonates at r = √(1 + 3) = 2.
    let two = "masses: { m0: 1, m1: 1 }, springs: { base - m0: 1, m0 - m1: 3 }, contact: m1 - wall, excitation: m0";
    check_stuck::<f64>("two", two, true);
    check_stuck::<f32>(
        "two_damped",
        &format!("{two}, damping: modal[0.02, 1.5]"),
        false,
    );
    // Names of masses that lints refuse, and one that is a function of the files.
    let rubbing = "masses: { Lower: 1, times: 2, a__b: 1 }, springs: { base - Lower: 1, Lower - times: 1, times - a__b: 2 }, contact: Lower - times, excitation: a__b";
    check_stuck::<f64>("rubbing", rubbing, false);
    check_stuck::<f64>(
        "rubbing_damped",
        &format!("{rubbing}, damping: modal(0.03)"),
        false,
    );
    check_stuck::<f32>(
        "rubbing_damped",
        &format!("{rubbing}, damping: modal(0.03)"),
        false,
    );
}

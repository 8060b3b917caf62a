//! Tests the limits, and the contact's motion or the reason why it does not exist, of emitted C and Rust files.

use super::super::scenes::scene;
use super::{POINTS, cc, folder, ratios, run, rustc, source, write_c};
use frictiongen::study::compiled::CompiledSystem;
use frictiongen::{NotContinuous, Regime, System};
use frictiongen_codegen::standalone::{c_source, rust_source};
use frictiongen_kernel::Float;
use std::process::Command;

/// Tested β, divided by each limit: far from the limit, within the accuracy on both sides of it, and equal to it.
const SHARES: [f64; 6] = [0.5, 0.98, 0.99999, 1.0, 1.00001, 1.5];

/// Results at one r: r itself, both limits, and for each friction ratio the return code, the amplitude and the phase.
struct Point {
    head: [f64; 3],
    answers: Vec<(i32, f64, f64)>,
}

/// Returns the library's results at the compared points, and four counts: how often the code is 0, 1 and 2, and how
/// often it is 0 in a bistable regime.
fn expected<S: Float>(compiled: &CompiledSystem<'_, S>) -> (Vec<Point>, [usize; 4]) {
    let mut seen = [0; 4];
    let point = |r: S| {
        let at = compiled.at(r).expect("in the range");
        let limits = at.limits();
        let both = [limits.continuous, limits.sliding];
        let betas = both.map(|limit| SHARES.map(|share| S::constant(share) * limit));
        let answers = betas.as_flattened().iter().map(|beta| {
            let (number, [amplitude, phase]) = match at.motion(*beta) {
                Ok(motion) => {
                    let largest = motion.contact().largest();
                    (0, [largest.amplitude, largest.phase])
                }
                Err(error) => {
                    let number = match error {
                        NotContinuous::StickSlip => 1,
                        NotContinuous::Stuck => 2,
                        NotContinuous::Unbounded => 3,
                        _ => -1,
                    };
                    (number, [S::constant(7.0); 2])
                }
            };
            if let Some(seen) = usize::try_from(number).ok().and_then(|n| seen.get_mut(n)) {
                *seen += 1;
            }
            let bistable = at.regime(*beta) == Ok(Regime::Bistable);
            assert!(!bistable || number == 0, "r = {r:?}, beta = {beta:?}");
            seen[3] += usize::from(bistable);
            (number, amplitude.to_f64(), phase.to_f64())
        });
        Point {
            answers: answers.collect(),
            head: [r, limits.continuous, limits.sliding].map(Float::to_f64),
        }
    };
    (ratios::<S>().map(point).collect(), seen)
}

fn compare(what: &str, output: &str, expected: &[Point], epsilon: f64) {
    let lines: Vec<&str> = output.lines().collect();
    assert_eq!(lines.len(), expected.len(), "{what}");
    for (line, expected) in lines.into_iter().zip(expected) {
        let mut words = line.split(' ');
        let mut number = || {
            let bits = words.next().expect("a number");
            f64::from_bits(u64::from_str_radix(bits, 16).expect("bits"))
        };
        let what = format!("{what}, r = {}", expected.head[0]);
        for head in expected.head {
            assert_eq!(number().to_bits(), head.to_bits(), "{what}");
        }
        for (place, (status, amplitude, phase)) in expected.answers.iter().enumerate() {
            let (own, size, lag) = (number(), number(), number());
            assert_eq!(own, f64::from(*status), "{what}: friction {place}");
            assert_eq!(size.to_bits(), amplitude.to_bits(), "{what}: {place}");
            assert!(
                (lag - phase).abs() <= 8.0 * epsilon,
                "{what}: phase {lag} for {phase}"
            );
        }
    }
}

const C_MAIN: &str = r#"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "SCENE.h"
static void bits(double value) { unsigned long long b; memcpy(&b, &value, 8); printf("%llx ", b); }
int main(void);
int main(void) {
    const REAL shares[] = { SHARES };
    for (int k = 0; k <= POINTS; k++) {
        REAL r = (REAL)0.2 + ((REAL)2.5 - (REAL)0.2) * (REAL)k / (REAL)POINTS;
        if ((REAL)2.5 < r) r = (REAL)2.5;
        REAL limits[2];
        if (SCENE_limits(r, &limits[0], &limits[1]) != UPPER_OK) return 1;
        bits(r); bits(limits[0]); bits(limits[1]);
        for (int of = 0; of < 2; of++)
            for (unsigned i = 0; i < sizeof shares / sizeof shares[0]; i++) {
                REAL a = 7, p = 7;
                const enum SCENE_status status = SCENE_contact(r, shares[i] * limits[of], &a, &p);
                bits((int)status); bits(a); bits(p);
            }
        printf("\n");
    }
    REAL c = 7, s = 7;
    if (SCENE_limits((REAL)0.1, &c, &s) != UPPER_OUT_OF_DOMAIN || SCENE_limits((REAL)NAN, &c, &s) != -1) return 2;
    if (c < 7 || c > 7 || s < 7 || s > 7) return 3;
    return 0;
}
"#;

const RUST_MAIN: &str = r#"
TABLES
fn main() {
    let shares: &[REAL] = &[SHARES];
    for k in 0..=POINTS {
        let r: REAL = 0.2 + (2.5 - 0.2) * k as REAL / POINTS as REAL;
        let r = if 2.5 < r { 2.5 } else { r };
        let (c, s) = tables::limits(r).expect("in the range");
        let bits = |value: f64| print!("{:x} ", value.to_bits());
        for head in [r, c, s] { bits(f64::from(head)); }
        for limit in [c, s] {
            for share in shares {
                let (status, (a, p)) = match tables::contact(r, share * limit) {
                    Ok(answer) => (0, answer),
                    Err(error) => (error as i8, (7.0, 7.0)),
                };
                bits(f64::from(status)); bits(f64::from(a)); bits(f64::from(p));
            }
        }
        println!();
    }
    let out = Err(tables::Error::OutOfDomain);
    assert!(tables::limits(0.1) == out && tables::limits(REAL::NAN) == out);
}
"#;

/// Compares a scene. Returns how often the library's code is 0, 1 and 2, and how often it is 0 in a bistable regime.
fn check<S: Float>(kind: &str, count: usize, damping: &str, stiction: &str) -> [usize; 4] {
    let single = S::EPSILON > 1e-10;
    let (scalar, real) = if single {
        ("f32", "float")
    } else {
        ("f64", "double")
    };
    let system: System<S> = scene(kind, count, damping, stiction, scalar)
        .parse()
        .expect("a scene");
    let compiled = system.compile(0.2..2.5, 1e-4).expect("tables");
    let (expected, seen) = expected(&compiled);
    let name = format!("{}{count}", kind.to_lowercase());
    let what = format!("{kind}{count} {damping} {stiction} {scalar}");
    let folder = folder(&what.replace([' ', '(', ')'], "_"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("written");
    let (scene, tables) = (system.scene(), compiled.tables());
    let suffix = |literal: f64| {
        if single {
            format!("{literal:?}f")
        } else {
            format!("{literal:?}")
        }
    };
    let fill = |text: &str, real: &str, shares: &str| {
        text.replace("SHARES", shares)
            .replace("SCENE", &name)
            .replace("UPPER", &name.to_uppercase())
            .replace("REAL", real)
            .replace("POINTS", &POINTS.to_string())
    };
    let source = source(scene, tables);
    write_c(&folder, &name, &source, &name);
    write(
        "main.c",
        &fill(C_MAIN, real, &SHARES.map(suffix).join(", ")),
    );
    cc(
        &folder,
        &["-o", "program", "main.c", &format!("{name}.c"), "-lm"],
    );
    let same = |language: &str, program: &str| {
        let output = run(&mut Command::new(folder.join(program)));
        compare(
            &format!("{what} in {language}"),
            &output,
            &expected,
            S::EPSILON,
        );
    };
    same("C", "program");
    // The source must compile without its header.
    let alone = c_source(&source, &name, None).expect("a form of its own");
    write("alone.c", &alone);
    cc(&folder, &["-c", "alone.c"]);

    let rust = rust_source(&source).expect("a form of its own");
    write("tables.rs", &rust);
    let shares = SHARES.map(|share| format!("{share:?}")).join(", ");
    let main = fill(RUST_MAIN, scalar, &shares);
    write("main.rs", &main.replace("TABLES", "mod tables;"));
    rustc(&folder, &["main.rs", "-o", "program_rs"]);
    same("Rust", "program_rs");
    // If the library has no std, it uses the file's own square root and arc tangent.
    write(
        "lib.rs",
        "#![no_std]\n#![forbid(unsafe_code)]\npub mod tables;\n",
    );
    rustc(
        &folder,
        &["--crate-type=rlib", "--crate-name=core_alone", "lib.rs"],
    );
    write(
        "over.rs",
        &main.replace("TABLES", "use core_alone::tables;"),
    );
    rustc(
        &folder,
        &[
            "--extern",
            "core_alone=libcore_alone.rlib",
            "over.rs",
            "-o",
            "program_core",
        ],
    );
    same("Rust without std", "program_core");
    seen
}

#[test]
fn in_double_precision() {
    let mut seen = [0; 4];
    for (kind, count, damping, stiction) in [
        ("Wall", 1, "none", "1"),
        ("Base", 2, "modal(0.02)", "1.2"),
        ("Pair", 5, "none", "1.2"),
        ("Base", 1, "modal(0.05)", "2"),
    ] {
        let own = check::<f64>(kind, count, damping, stiction);
        seen = [0, 1, 2, 3].map(|k| seen[k] + own[k]);
    }
    println!("answers, stick-slip, stuck, answers beside a stuck state: {seen:?}");
    assert!(seen.iter().all(|count| *count > 1000), "{seen:?}");
}

#[test]
fn in_single_precision() {
    let mut seen = [0; 4];
    for (kind, count, damping, stiction) in
        [("Wall", 2, "none", "1.2"), ("Pair", 5, "modal(0.02)", "2")]
    {
        let own = check::<f32>(kind, count, damping, stiction);
        seen = [0, 1, 2, 3].map(|k| seen[k] + own[k]);
    }
    assert!(seen.iter().all(|count| *count > 300), "{seen:?}");
}

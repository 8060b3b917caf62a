//! Compares the stuck responses of emitted C and Rust files with those of the library, bit for bit.

use super::{POINTS, cc, folder, ratios, run, rustc, source, write_c};
use frictiongen::System;
use frictiongen_codegen::standalone::{c_source, rust_source};
use frictiongen_kernel::Float;
use std::fmt::Write as _;
use std::process::Command;

const C_STUCK: &str = r#"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "scene.h"
static void bits(double value) { unsigned long long b; memcpy(&b, &value, 8); printf(" %llx", b); }
int main(void);
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
    if (scene_holding_force((REAL)0.1, &re, &im) != SCENE_OUT_OF_DOMAIN || scene_holding_force((REAL)NAN, &re, &im) != -1) return 2;
    if (scene_stuck_FIRST((REAL)2.6, &re, &im) != -1 || re < 7 || re > 7 || im < 7 || im > 7) return 3;
    if (RESONANT && (scene_stuck_FIRST((REAL)2, &re, &im) != SCENE_UNBOUNDED || scene_holding_force((REAL)2, &re, &im) != SCENE_UNBOUNDED || re < 7 || re > 7)) return 4;
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
        let shown = |answer: Result<(REAL, REAL), tables::Error>| match answer {
            Ok((re, im)) => print!(" {:x} {:x}", f64::from(re).to_bits(), f64::from(im).to_bits()),
            Err(_) => unreachable!("no r of these is a resonance"),
        };
        CALLS
        println!();
    }
    let (out, unbounded) = (Err(tables::Error::OutOfDomain), Err(tables::Error::Unbounded));
    assert!(tables::holding_force(0.1) == out && tables::holding_force(REAL::NAN) == out);
    assert_eq!(tables::stuck_FIRST(2.6), out);
    assert!(RESONANT == 0 || tables::stuck_FIRST(2.0) == unbounded && tables::holding_force(2.0) == unbounded);
}
"#;

/// Checks the stuck responses of a scene. `resonant` tells whether they have a resonance at r = 2.
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
    let own = source(system.scene(), compiled.tables());
    {
        write_c(&folder, "scene", &own, "scene");
        let code = c_source(&own, "scene", None).expect("a form of its own");
        // Only damped chains need complex numbers.
        assert_eq!(code.contains("struct number"), text.contains("damping"));
        let call = |name: &str| {
            format!("if (scene_{name}(r, &re, &im) != 0) return 1;\nbits(re); bits(im);\n")
        };
        write("main.c", &fill(C_STUCK, real, &call));
        cc(&folder, &["-o", "program", "main.c", "scene.c", "-lm"]);
        same("program");
    }
    {
        write("scene.rs", &rust_source(&own).expect("a form of its own"));
        let call = |name: &str| format!("shown(tables::{name}(r));\n");
        write("main.rs", &fill(RUST_STUCK, scalar, &call));
        rustc(&folder, &["main.rs", "-o", "program_rs"]);
        same("program_rs");
    }
}

#[test]
fn stuck_responses() {
    let one = "masses: { m0: 1 }, springs: { base - m0: 1 }, contact: m0 - wall, excitation: m0";
    check_stuck::<f64>("one", one, false);
    // With the contact stuck, the first mass resonates at r = √(1 + 3) = 2.
    let two = "masses: { m0: 1, m1: 1 }, springs: { base - m0: 1, m0 - m1: 3 }, contact: m1 - wall, excitation: m0";
    check_stuck::<f64>("two", two, true);
    check_stuck::<f32>(
        "two_damped",
        &format!("{two}, damping: modal[0.02, 1.5]"),
        false,
    );
    // The scene has names of masses that lints reject, and one name that is also a function of the files.
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
    // Every response has its own poles. The first mass has none. The other masses have the poles of the chain above
    // the contact. The force has all poles.
    let moving = "masses: { a: 1, b: 2, c: 1 }, springs: { base - a: 1, a - b: 1, b - c: 1 }, contact: b - base, excitation: base";
    check_stuck::<f64>("moving", moving, false);
    check_stuck::<f64>(
        "moving_damped",
        &format!("{moving}, damping: rayleigh(0.02, 0.03)"),
        false,
    );
}

//! Compares the square root and the arc tangent of a Rust file that is built without std with those of std.

use super::{folder, run, rustc, source};
use frictiongen::System;
use frictiongen_codegen::standalone::rust_source;
use frictiongen_kernel::Float;
use std::process::Command;

/// Program that compares the functions. Square roots must agree in every bit. Angles must agree to two rounding units
/// of a radian.
const MAIN: &str = r#"
mod tables;
use std::hint::black_box;
fn main() {
    let mut state = 7_u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state >> 11
    };
    let (mut subnormal, mut worst) = (0, 0.0);
    let special = [0.0, 1.0, 2.0, 4.0, 0.25, REAL::MIN_POSITIVE, REAL::MAX, REAL::EPSILON, REAL::INFINITY, REAL::from_bits(1)];
    for k in 0..200_000 {
        // Every positive number may occur. Every fourth one is subnormal.
        let bits = (random() ^ (random() << 13)) as BITS & (BITS::MAX >> 1);
        let any = REAL::from_bits(if k % 4 == 0 { bits & ((1 << FRACTION) - 1) } else { bits });
        let x = *special.get(k).unwrap_or(&any);
        if x.is_nan() {
            continue;
        }
        subnormal += usize::from(x.is_subnormal());
        let (own, root) = (tables::own_root(x), black_box(x).sqrt());
        assert_eq!(own.to_bits(), root.to_bits(), "{x:e}: {own:e} for {root:e}");
        let unit = random() as REAL / (1_u64 << 53) as REAL;
        let y = 4.0 * (random() as REAL / (1_u64 << 53) as REAL - 0.5);
        let (own, angle) = (tables::own_angle(y, unit), black_box(y).atan2(unit));
        worst = REAL::max(worst, (own - angle).abs());
    }
    for (y, x) in [(0.0, 1.0), (1.0, 0.0), (-1.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (1e-30, 1.0), (1.0, 1e-30), (0.0, 0.0)] {
        worst = REAL::max(worst, (tables::own_angle(y, x) - REAL::atan2(y, x)).abs());
    }
    assert!(subnormal > 40_000, "{subnormal}");
    println!("{:e}", worst as f64);
}
"#;

fn check<S: Float>(bits: &str, fraction: u32) {
    let real = bits.replace('u', "f");
    let text = format!(
        "struct Scene {{ masses: {{ a: 1 }}, springs: {{ base - a: 1 }}, contact: a - wall, excitation: a, damping: modal(0.05), scalar: {real} }}"
    );
    let system: System<S> = text.parse().expect("a scene");
    let compiled = system.compile(0.5..2.0, 1e-2).expect("tables");
    let source = rust_source(&source(system.scene(), compiled.tables()));
    let source = source.expect("a form of its own");
    let folder = folder(&format!("lacking_{real}"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("written");
    let own = format!(
        "{source}\npub fn own_root(x: {real}) -> {real} {{\n    Lacking::sqrt(x)\n}}\n\n\
         pub fn own_angle(y: {real}, x: {real}) -> {real} {{\n    Lacking::atan2(y, x)\n}}\n"
    );
    write("tables.rs", &own);
    let main = MAIN.replace("REAL", &real).replace("BITS", bits);
    write("main.rs", &main.replace("FRACTION", &fraction.to_string()));
    rustc(&folder, &["main.rs", "-o", "program"]);
    let output = run(&mut Command::new(folder.join("program")));
    let worst: f64 = output.trim().parse().expect("a number");
    println!("{real}: {worst:e}");
    assert!(worst <= 2.0 * S::EPSILON, "{worst:e}");
}

#[test]
fn the_root_and_the_angle_of_core_alone() {
    check::<f64>("u64", 52);
    check::<f32>("u32", 23);
}

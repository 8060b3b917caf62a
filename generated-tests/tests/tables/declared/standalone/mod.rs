//! Tests the C and Rust files that `frictiongen compile` writes. They are compiled and compared with the library bit
//! for bit.
//!
//! Phases use another arc tangent, and agree to eight roundings of a radian. These tests fail on a machine without `cc`
//! or `rustc`.
//! tests.

mod lacking;
mod motion;
mod names;
mod refused;
mod stuck;

use frictiongen_kernel::Float;
use std::path::{Path, PathBuf};
use std::process::Command;

const POINTS: u32 = 2000;

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("standalone")
        .join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

#[track_caller]
fn run(command: &mut Command) -> String {
    let output = command.output();
    let output = output.unwrap_or_else(|error| panic!("{command:?} does not run: {error}"));
    assert!(
        output.status.success(),
        "{command:?}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("text")
}

/// Compiles C99, and fails if the compiler warns.
#[track_caller]
fn cc(folder: &Path, arguments: &[&str]) {
    let flags = "-std=c99 -O2 -ffp-contract=off -Wall -Wextra -Werror -Wpedantic";
    let mut command = Command::new("cc");
    run(command
        .current_dir(folder)
        .args(flags.split(' '))
        .args(arguments));
}

/// Compiles Rust, and fails if the compiler warns.
#[track_caller]
fn rustc(folder: &Path, arguments: &[&str]) {
    let mut command = Command::new("rustc");
    run(command
        .current_dir(folder)
        .args(["--edition=2024", "-O", "-Dwarnings"])
        .args(arguments));
}

/// Returns the frequency ratios at which the programs are compared.
fn ratios<S: Float>() -> impl Iterator<Item = S> {
    let (low, high) = (S::constant(0.2), S::constant(2.5));
    let points = S::constant(f64::from(POINTS));
    (0..=POINTS).map(move |k| (low + (high - low) * S::constant(f64::from(k)) / points).min(high))
}

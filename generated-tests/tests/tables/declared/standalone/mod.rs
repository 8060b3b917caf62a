//! Tests the C and Rust files that `frictiongen compile` writes. The tests compile the files, and compare their
//! results with those of the library bit for bit.
//!
//! Phases use another arc tangent, so they agree only to eight rounding units of a radian. These tests fail on a
//! machine without `cc` or `rustc`.

mod check;
mod lacking;
mod motion;
mod names;
mod refused;
mod stuck;

use frictiongen::study::scene::Scene;
use frictiongen::study::table::Tables;
use frictiongen_codegen::standalone::{
    Origin, Source, c_header, c_source, c_tables, c_tables_name,
};
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

/// Returns a scene with its tables. The description in the result has no effect on the numbers.
fn source<'a, S>(scene: &'a Scene, tables: &'a Tables<S>) -> Source<'a, S> {
    Source {
        scene,
        tables,
        origin: Origin {
            description: "struct Written { /* as it was */ }",
            command: "frictiongen compile written.friction",
        },
    }
}

/// Writes the three files of a scene in C: `NAME.h`, `NAME_tables.h` and `NAME.c`, in which names begin with `name`.
fn write_c<S: Float>(folder: &Path, file: &str, source: &Source<'_, S>, name: &str) {
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("written");
    let header = format!("{file}.h");
    write(&header, &c_header(source, name));
    let tables = c_tables(source, name).expect("a form of its own");
    write(&c_tables_name(&header), &tables);
    let code = c_source(source, name, Some(&header)).expect("a form of its own");
    write(&format!("{file}.c"), &code);
}

/// Compiles C99. Any warning is an error, including warnings about conversions and comparisons of numbers.
#[track_caller]
fn cc(folder: &Path, arguments: &[&str]) {
    let flags = "-std=c99 -O2 -ffp-contract=off -Wall -Wextra -Werror -Wpedantic -Wconversion -Wfloat-equal -Wshadow -Wundef -Wmissing-prototypes";
    let mut command = Command::new("cc");
    run(command
        .current_dir(folder)
        .args(flags.split(' '))
        .args(arguments));
}

/// Compiles Rust. Any warning is an error.
#[track_caller]
fn rustc(folder: &Path, arguments: &[&str]) {
    let mut command = Command::new("rustc");
    run(command
        .current_dir(folder)
        .args(["--edition=2024", "-O", "-Dwarnings"])
        .args(arguments));
}

/// Returns the frequency ratios at which the tests compare the compiled files with the library.
fn ratios<S: Float>() -> impl Iterator<Item = S> {
    let (low, high) = (S::constant(0.2), S::constant(2.5));
    let points = S::constant(f64::from(POINTS));
    (0..=POINTS).map(move |k| (low + (high - low) * S::constant(f64::from(k)) / points).min(high))
}

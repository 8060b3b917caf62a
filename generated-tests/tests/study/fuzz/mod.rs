//! Fuzzing with texts and numbers that are mutated from the corpus in `generated-tests/fuzzing/corpus`. A text must give a scene, or
//! errors with positions. Functions of numbers must return numbers, without NaN or a panic. These tests take some
//! seconds. The long form is `.ci/nightly fuzz`.

mod emitted;
mod found;
mod functions;
mod moving;
mod systems;
mod text;

/// Returns the number of inputs for each target in the long form. The environment variable COUNT sets it. The default
/// is a million.
fn long() -> u64 {
    let count = std::env::var("COUNT").ok();
    count.map_or(1_000_000, |count| count.parse().expect("COUNT is a number"))
}

/// Returns true for one in `often` numbers.
fn once_in(often: u64, number: u64) -> bool {
    number.is_multiple_of(often)
}

/// Fails if the run has findings, and prints them.
fn none(target: &str, outcome: &fuzzing::Outcome) {
    let fuzzing::Outcome { count, findings } = outcome;
    assert!(findings.is_empty(), "{target}:\n{}", findings.join("\n"));
    println!("{target}: {count} inputs, nothing found");
    // The bound on memory covers all tests of this program together. The tables of the largest accepted scene take
    // several MiB.
    if let Some(most) = fuzzing::most_memory() {
        println!("{target}: at most {} MiB held", most >> 20);
        assert!(most < 1 << 30, "{most} bytes were held");
    }
}

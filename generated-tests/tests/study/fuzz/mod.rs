//! Texts and numbers of every kind, mutated from the corpus in `fuzzing/corpus`: a text is a scene or
//! has located errors, a number is answered by a number.  Some seconds here; the long form is
//! `scripts/fuzz`.

mod emitted;
mod found;
mod functions;
mod moving;
mod systems;
mod text;

/// The inputs of the long form, for each target: the environment's COUNT, else a million.
fn long() -> u64 {
    let count = std::env::var("COUNT").ok();
    count.map_or(1_000_000, |count| count.parse().expect("COUNT is a number"))
}

/// True for one number in `often`.
fn once_in(often: u64, number: u64) -> bool {
    number.is_multiple_of(often)
}

/// Fails with what was found.
fn none(target: &str, outcome: &fuzzing::Outcome) {
    let fuzzing::Outcome { count, findings } = outcome;
    assert!(findings.is_empty(), "{target}:\n{}", findings.join("\n"));
    println!("{target}: {count} inputs, nothing found");
    // The tests of this file together; the tables of the largest accepted scene are some MiB.
    if let Some(most) = fuzzing::most_memory() {
        println!("{target}: at most {} MiB held", most >> 20);
        assert!(most < 1 << 30, "{most} bytes were held");
    }
}

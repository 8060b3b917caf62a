//! Where the printed thesis must not be followed: one test for each row of `docs/corrections.md`.
//!
//! Each test writes the printed form out, shows that it fails against the governing equations, and
//! that the right form holds.  What "fails" and "holds" are judged by is in `plain` and
//! `integration`, which share no formula with the project.

mod chains;
mod damped;
mod integration;
mod oscillating;
mod page;
mod plain;
mod resonance;
mod single;
mod stuck;

/// The printed form and the right one, at most `tolerance` from the truth, which tells them apart.
#[track_caller]
fn judged(printed: f64, right: f64, truth: f64, tolerance: f64) {
    assert!(
        (right - truth).abs() <= tolerance,
        "the right form gives {right}, not {truth} to {tolerance}"
    );
    assert!(
        (printed - truth).abs() > 20.0 * tolerance && (printed - truth).abs() > 1e-4,
        "the printed form gives {printed}, which is not clearly off {truth} to {tolerance}"
    );
}

#[track_caller]
fn close(got: f64, want: f64, tolerance: f64) {
    assert!(
        (got - want).abs() <= tolerance,
        "{got} instead of {want} to {tolerance}"
    );
}

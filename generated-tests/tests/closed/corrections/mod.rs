//! Tests that some printed forms of the thesis are wrong. Each correction on `docs/thesis.md` has one test.
//!
//! Each test evaluates the printed form and shows that it violates the governing equations. Then the test shows that
//! the right form satisfies these equations. `plain` and `integration` solve these equations for the tests, and share
//! no formula with the project.

mod chains;
mod damped;
mod integration;
mod oscillating;
mod page;
mod plain;
mod resonance;
mod single;
mod stuck;

/// Asserts that the right form is within `tolerance` of the true value, and that the printed form is much farther
/// away from the true value.
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

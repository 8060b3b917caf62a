//! Compares the two guaranteed searches, for the velocity constraint and for the largest displacement, with brute
//! force on random scenes.
//!
//! The reference evaluates the functions by the printed formulas, from modal data alone. A fine grid with a
//! golden-section refinement finds their maxima. This is slow, but so plain that it cannot have the errors of a
//! search with bounds.

mod bound;
mod findings;
mod led;
mod plain;
mod random;

use findings::{Findings, compare, report, within};
use frictiongen::study::System;
use fuzzing::Random;
use plain::Plain;

/// Compares random scenes of at most `most` masses with brute force on a grid of at least `least` points.
fn run(seed: u64, scenes: usize, least: usize, most: usize, listed: usize) -> Findings {
    let mut random = Random(seed);
    let mut findings = Findings::default();
    for _ in 0..scenes {
        compare(&mut random, &mut findings, least, most);
    }
    report(&mut findings, listed);
    findings
}

/// Checks that rounding at small τ does not count as a maximum of the velocity constraint. In this scene the constraint
/// falls from its limit at τ → 0. At tiny τ it is a quotient of rounding errors. The expected β_lim, with 20 digits, is
/// from 40-digit arithmetic.
#[test]
fn rounding_at_the_start_is_no_peak() {
    let pair = "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1 },
                contact: a - b, excitation: a, damping: modal(0.2) }";
    let system: System = pair.parse().unwrap();
    let limit = system.at(0.059).unwrap().continuous_limit();
    // V is a difference of two numbers that are 10³ times as large.
    let error = limit / 2.152_674_283_808_898_4e-5 - 1.0;
    assert!(error.abs() < 1e-11, "{limit}: off by {error:e}");
    // The result of the search over a sweep is compared with the plain function. If modes decay fast, the constraint
    // falls over the whole half period.
    let one = "struct One { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall,
               excitation: a, damping: modal(0.2) }";
    let mut compared = 0;
    for text in [pair, one] {
        let system: System = text.parse().unwrap();
        for i in 1..400 {
            let r = 0.0005 * f64::from(i);
            let plain = Plain::new(&system, r, 0.0, false);
            let limit = plain.limit(&system, 400);
            let found = system.at(r).unwrap().continuous_limit();
            let tolerance = 1e-9f64.max(500.0 * f64::EPSILON * limit.condition);
            let error = found / limit.beta - 1.0;
            assert!(
                error.abs() < tolerance,
                "r = {r}: {found} against {}: {error:e}\n{text}",
                limit.beta
            );
            compared += 1;
        }
    }
    println!("{compared} limits compared, none skipped");
    assert_eq!(compared, 2 * 399);
}

/// Asserts that limits, amplitudes and phases agree, and asserts the numbers of comparisons. The bounds on the
/// numbers of evaluations (median, 99 % quantile, maximum) are a quarter above the measured numbers.
fn agreed(findings: &mut Findings, scenes: usize) {
    assert!(
        findings.disagreements.is_empty(),
        "{} disagreements: {}",
        findings.disagreements.len(),
        findings.disagreements[0]
    );
    assert_eq!(findings.scenes, scenes);
    assert_eq!(findings.constraint_counts.len(), scenes);
    assert!(findings.masses >= scenes);
    assert_eq!(findings.masses, findings.phases);
    assert_eq!(findings.masses, findings.amplitude_counts.len());
    // No random r is, bit for bit, an undamped resonance.
    assert_eq!(findings.unbounded, 0);
    assert!(
        findings.ill * 20 < scenes,
        "{} ill-conditioned",
        findings.ill
    );
}

#[test]
fn no_maximum_is_missed() {
    let mut findings = run(20_210_719, 300, 400, 10, 1);
    agreed(&mut findings, 300);
    within(
        "velocity constraint",
        &mut findings.constraint_counts,
        (6, 25, 44),
    );
    within("amplitude", &mut findings.amplitude_counts, (11, 30, 44));
    // If the start of the half period always decided the limit, the test would check no search.
    assert!(findings.searched > 60, "{}", findings.searched);
    findings.led.agreed();
}

#[test]
fn no_maximum_is_missed_of_many_masses() {
    let mut findings = run(7_301_995, 300, 400, 16, 1);
    agreed(&mut findings, 300);
    within(
        "velocity constraint",
        &mut findings.constraint_counts,
        (6, 25, 44),
    );
    within("amplitude", &mut findings.amplitude_counts, (11, 30, 44));
    assert!(findings.searched > 60, "{}", findings.searched);
}

#[test]
#[ignore = "ten thousand scenes: some minutes"]
fn evaluations_per_search() {
    let mut findings = run(5_551_202, 10_000, 2_000, 10, 5);
    agreed(&mut findings, 10_000);
    within(
        "velocity constraint",
        &mut findings.constraint_counts,
        (5, 23, 44),
    );
    within("amplitude", &mut findings.amplitude_counts, (10, 28, 42));
}

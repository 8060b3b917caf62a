//! The two guaranteed searches (velocity constraint, largest displacement) against brute force on
//! random scenes.
//!
//! The functions searched are written here from the printed formulas, from modal data alone, and
//! their largest values are found on a fine grid with a golden-section refinement: slow, and too
//! plain to be wrong in the same way as a search that walks with bounds.

mod findings;
mod plain;
mod random;

use findings::{CEILING, Findings, compare, report};
use frictiongen::study::System;
use plain::Plain;
use random::Lcg;

fn run(seed: u64, scenes: usize, least: usize, listed: usize) -> Findings {
    let mut random = Lcg(seed);
    let mut findings = Findings::default();
    for _ in 0..scenes {
        compare(&mut random, &mut findings, least);
    }
    report(&mut findings, listed);
    findings
}

/// Where S falls from its limit at τ → 0 on, nothing but rounding is left of the quotient at tiny
/// τ, and that must not pass for a higher peak.  β_lim to 20 digits is from 40-digit arithmetic.
#[test]
fn rounding_at_the_start_is_no_peak() {
    let pair = "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1 },
                contact: a - b, excitation: a, damping: modal(0.2) }";
    let system: System = pair.parse().unwrap();
    let limit = system.at(0.059).unwrap().continuous_limit();
    // V is a difference of numbers 10³ times as large.
    let error = limit / 2.152_674_283_808_898_4e-5 - 1.0;
    assert!(error.abs() < 1e-11, "{limit}: off by {error:e}");
    // The same over a sweep, by itself: the constraint falls all the way where modes decay fast.
    let one = "struct One { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall,
               excitation: a, damping: modal(0.2) }";
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
        }
    }
}

#[test]
fn no_maximum_is_missed() {
    let findings = run(20_210_719, 300, 400, 1);
    assert!(
        findings.disagreements.is_empty(),
        "{}",
        findings.disagreements[0]
    );
    assert!(findings.constraint_counts[0].0 < CEILING && findings.amplitude_counts[0].0 < CEILING);
    // The test tests nothing if the start of the half period always decides.
    assert!(findings.searched > 60, "{}", findings.searched);
}

#[test]
#[ignore = "ten thousand scenes: some minutes"]
fn evaluations_per_search() {
    let findings = run(5_551_202, 10_000, 2_000, 5);
    assert!(
        findings.disagreements.is_empty(),
        "{}",
        findings.disagreements[0]
    );
    assert!(findings.constraint_counts[0].0 < CEILING && findings.amplitude_counts[0].0 < CEILING);
}

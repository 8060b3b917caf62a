//! Tests the search for the best shares of several contacts.

use super::system;
use crate::study::joined::{JoinedError, ShareRange};
use std::cell::Cell;

/// A block with a brace and a pair of pads.
const BLOCK: &str = "struct Block { masses: { block: 1.0 }, springs: { base - block: 1.0 },
    contacts: { brace: base - block { stiffness: 2.0 }, pads: block - wall { share: 0.2, stiffness: 1.0 } },
    damping: modal(0.02), excitation: block }";

const BAND: (f64, f64) = (0.6, 2.4);

fn range(from: f64, to: f64) -> [ShareRange; 1] {
    [ShareRange {
        contact: 1,
        from,
        to,
    }]
}

/// Checks that a search that stops early returns a distribution no worse than that of the scene description. The peak
/// of the result must be the largest amplitude over the band.
#[test]
fn a_stopped_search_keeps_its_best_distribution() {
    let block = system(BLOCK);
    let joined = block.joined().expect("answers");
    let alone = joined.optimum("block", BAND).expect("an optimum");
    let allowed = alone.evaluations + 400;
    let count = Cell::new(0);
    let watch = || {
        count.set(count.get() + 1);
        count.get() <= allowed
    };
    let found = joined.best_shares("block", BAND, &range(0.02, 2.0), &watch);
    let found = found.expect("a distribution");
    assert!(!found.optimum.is_complete && found.before.is_complete);
    assert_eq!(found.before.evaluations, alone.evaluations);
    let before = found.before.amplitude;
    assert!(found.optimum.amplitude < before, "{found:?}");
    assert_eq!(found.shares.first(), Some(&1.0));
    let tuned = joined.with_shares(&found.shares);
    let amplitude = |r: f64| {
        let at = tuned.at(r).expect("r");
        let orbit = at.orbit(found.optimum.friction).expect("an orbit");
        orbit.amplitude("block").expect("a mass")
    };
    let peak = (0..=1800).map(|place| amplitude(0.6 + 1e-3 * f64::from(place)));
    let peak = peak.fold(0.0, f64::max);
    println!("{:.5} for {:.5}, shares {:?}", peak, before, found.shares);
    // The frequencies are 1e-3 apart, so that their largest amplitude may be below the peak.
    assert!((peak - found.optimum.amplitude).abs() < 1e-3 * peak);
    // The result must contain the frequency and the count of this distribution, not those of the scene description.
    let told = found.optimum.amplitude;
    assert!((amplitude(found.optimum.r) - told).abs() < 1e-9 * told);
    assert_eq!(found.optimum.evaluations, allowed);
}

/// Checks that a search that stops at once has no result, and that an interval of shares must begin above 0.
#[test]
fn searches_without_an_answer() {
    let block = system(BLOCK);
    let joined = block.joined().expect("answers");
    let stopped = joined.best_shares("block", BAND, &range(0.1, 1.0), &|| false);
    assert_eq!(stopped.err(), Some(JoinedError::Stopped));
    for (from, to) in [(0.0, 1.0), (1.0, 1.0), (0.5, f64::INFINITY)] {
        let refused = joined.best_shares("block", BAND, &range(from, to), &|| true);
        assert_eq!(refused.err(), Some(JoinedError::Shares));
    }
}

/// Runs the whole search. Checks that no neighbour of its result has a peak that is smaller by more than a thousandth.
#[test]
#[ignore = "a minute of steady states; the search that stops early is the short form"]
fn neighbours_of_the_best_distribution_are_no_better() {
    let block = system(BLOCK);
    let joined = block.joined().expect("answers");
    let found = joined.best_shares("block", BAND, &range(0.02, 2.0), &|| true);
    let found = found.expect("a distribution");
    assert!(found.optimum.is_complete);
    println!("{found:?}");
    for (share, friction) in [(0.9, 1.0), (1.1, 1.0), (1.0, 0.9), (1.0, 1.1)] {
        let shares: Vec<f64> = vec![1.0, share * found.shares[1].clamp(0.02, 2.0)];
        let tuned = joined.with_shares(&shares);
        let peak = (0..=200).map(|place| {
            let at = tuned.at(0.6 + 0.005 * f64::from(place)).expect("r");
            let orbit = at.orbit(friction * found.optimum.friction);
            orbit.map_or(0.0, |orbit| orbit.amplitude("block").expect("a mass"))
        });
        let peak = peak.fold(0.0, f64::max);
        // The grid of the search misses a peak by less than a thousandth.
        assert!(
            found.optimum.amplitude < 1.001 * peak,
            "{share} {friction}: {peak}"
        );
    }
}

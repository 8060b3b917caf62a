//! Tests the search for the best shares of several contacts.

use super::system;
use crate::Of;
use crate::study::System;
use crate::study::joined::JoinedError;
use crate::study::optimum::{
    FrequencyBand, OptimumEnd, OptimumError, OptimumRequest, ShareRange, SharesOptimum,
};
use crate::study::response::MotionQuantity;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A block with a brace and a pair of pads.
const BLOCK: &str = "struct Block { masses: { block: 1.0 }, springs: { base - block: 1.0 },
    contacts: { brace: base - block { stiffness: 2.0 }, pads: block - wall { share: 0.2, stiffness: 1.0 } },
    damping: modal(0.02), excitation: block }";

fn request() -> OptimumRequest {
    OptimumRequest {
        of: Of::Mass(0),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(0.6, 2.4),
        load: None,
    }
}

fn range(from: f64, to: f64) -> [ShareRange; 1] {
    [ShareRange {
        contact: 1,
        from,
        to,
    }]
}

/// Returns the largest amplitude at a grid of frequencies, with steps of `step` in r.
fn peak(block: &System, found: &SharesOptimum, friction: f64, step: f64) -> f64 {
    let joined = block.joined().expect("answers");
    let tuned = joined.with_shares(&found.shares);
    let steps = (1.8 / step).round() as u32;
    let amplitudes = (0..=steps).map(|place| {
        let at = tuned.at(0.6 + step * f64::from(place)).expect("r");
        let orbit = at.orbit(friction);
        orbit.map_or(0.0, |orbit| orbit.amplitude("block").expect("a mass"))
    });
    amplitudes.fold(0.0, f64::max)
}

/// Checks that a search that stops early returns a distribution no worse than that of the scene description. The peak
/// of the result must be the largest amplitude over the band.
#[test]
fn a_stopped_search_keeps_its_best_distribution() {
    let block = system(BLOCK);
    let count = AtomicUsize::new(0);
    let counted = || count.fetch_add(1, Ordering::Relaxed) < usize::MAX;
    block
        .optimum_watched(&request(), &counted)
        .expect("an optimum");
    // The search of the shares begins with the same search of the friction.
    let allowed = count.swap(0, Ordering::Relaxed) + 300;
    let watch = || count.fetch_add(1, Ordering::Relaxed) < allowed;
    let found = block.best_shares(&request(), &range(0.02, 2.0), &watch);
    let found = found.expect("a distribution");
    assert_eq!(found.optimum.end, OptimumEnd::Stopped);
    assert!(found.optimum.amplitude < found.before, "{found:?}");
    assert_eq!(found.shares.first(), Some(&1.0));
    let peak = peak(&block, &found, found.optimum.beta, 2e-3);
    println!(
        "{peak:.5} for {:.5}, shares {:?}",
        found.before, found.shares
    );
    // The frequencies are 2e-3 apart, so that their largest amplitude may be below the peak.
    assert!((peak - found.optimum.amplitude).abs() < 1e-3 * peak);
}

/// Checks that a search that stops at once has no result, and that an interval of shares must begin above 0.
#[test]
fn searches_without_an_answer() {
    let block = system(BLOCK);
    let stopped = block.best_shares(&request(), &range(0.1, 1.0), &|| false);
    assert_eq!(stopped.err(), Some(OptimumError::Stopped));
    for (from, to) in [(0.0, 1.0), (1.0, 1.0), (0.5, f64::INFINITY)] {
        let refused = block.best_shares(&request(), &range(from, to), &|| true);
        assert_eq!(
            refused.err(),
            Some(OptimumError::Joined(JoinedError::Shares))
        );
    }
}

/// Runs the whole search. Checks that no neighbour of its result has a peak that is smaller by more than a thousandth.
#[test]
#[ignore = "a minute of steady states; the search that stops early is the short form"]
fn neighbours_of_the_best_distribution_are_no_better() {
    let block = system(BLOCK);
    let found = block.best_shares(&request(), &range(0.02, 2.0), &|| true);
    let found = found.expect("a distribution");
    println!("{found:?}");
    for (share, friction) in [(0.9, 1.0), (1.1, 1.0), (1.0, 0.9), (1.0, 1.1)] {
        let share = share * found.shares[1].clamp(0.02, 2.0);
        let other = SharesOptimum {
            shares: vec![1.0, share],
            ..found.clone()
        };
        let peak = peak(&block, &other, friction * found.optimum.beta, 0.005);
        // The grid misses a peak by less than a thousandth.
        assert!(
            found.optimum.amplitude < 1.001 * peak,
            "{share} {friction}: {peak}"
        );
    }
}

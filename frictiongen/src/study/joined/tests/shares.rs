//! Tests the search for the best shares of several contacts.

use super::system;
use crate::Of;
use crate::study::System;
use crate::study::joined::JoinedParameter;
use crate::study::optimum::{
    FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumOptions, OptimumRequest, Tunable,
    Tuning,
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

/// Finds the best friction with the best share of the pads between two bounds.
fn found(
    block: &System,
    (from, to): (f64, f64),
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Optimum, OptimumError> {
    let of = block.tunable_named("share pads").expect("a share");
    assert_eq!(of, Tunable::Joined(JoinedParameter::Share(1)));
    let options = OptimumOptions {
        vary: &[Tuning { of, from, to }],
        watch: Some(watch),
        ..OptimumOptions::default()
    };
    block.optimum_with(&request(), &options)
}

/// Returns the largest amplitude at a grid of frequencies, with steps of `step` in r.
fn peak(block: &System, share: f64, friction: f64, step: f64) -> f64 {
    let joined = block.joined().expect("answers");
    let tuned = joined.with_shares(&[1.0, share]);
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
    let options = OptimumOptions {
        watch: Some(&counted),
        ..OptimumOptions::default()
    };
    block
        .optimum_with(&request(), &options)
        .expect("an optimum");
    // The search of the shares begins with the same search of the friction.
    let allowed = count.swap(0, Ordering::Relaxed) + 300;
    let watch = || count.fetch_add(1, Ordering::Relaxed) < allowed;
    let found = found(&block, (0.02, 2.0), &watch).expect("a distribution");
    assert_eq!(found.end, OptimumEnd::Stopped);
    let before = found.before.expect("an amplitude");
    assert!(found.amplitude < before, "{found:?}");
    let [brace, pads] = found.tuned[..] else {
        panic!("{:?}", found.tuned)
    };
    assert_eq!(brace.value, 1.0);
    let peak = peak(&block, pads.value, found.beta, 2e-3);
    println!("{peak:.5} for {before:.5}, share {}", pads.value);
    // The frequencies are 2e-3 apart, so that their largest amplitude may be below the peak.
    assert!((peak - found.amplitude).abs() < 1e-3 * peak);
}

/// Checks that a search that stops at once has no result, and that an interval of shares must begin above 0.
#[test]
fn searches_without_an_answer() {
    let block = system(BLOCK);
    let refused = |range: (f64, f64), go_on: bool| {
        let found = found(&block, range, &|| go_on);
        found.expect_err("no distribution")
    };
    assert_eq!(refused((0.1, 1.0), false), OptimumError::Stopped);
    assert_eq!(refused((1.0, 1.0), true), OptimumError::Interval);
    assert_eq!(refused((0.5, f64::INFINITY), true), OptimumError::Interval);
    assert!(matches!(refused((0.0, 1.0), true), OptimumError::Scene(_)));
}

/// Runs the whole search. Checks that no neighbour of its result has a peak that is smaller by more than a thousandth.
#[test]
#[ignore = "a minute of steady states; the search that stops early is the short form"]
fn neighbours_of_the_best_distribution_are_no_better() {
    let block = system(BLOCK);
    let found = found(&block, (0.02, 2.0), &|| true).expect("a distribution");
    println!("{found:?}");
    let best = found.tuned[1].value;
    for (share, friction) in [(0.9, 1.0), (1.1, 1.0), (1.0, 0.9), (1.0, 1.1)] {
        let peak = peak(&block, share * best, friction * found.beta, 0.005);
        // The grid misses a peak by less than a thousandth.
        assert!(found.amplitude < 1.001 * peak, "{share} {friction}: {peak}");
    }
}

/// Checks that the numbers of contacts and dashpots have names, and that each name changes its own number.
#[test]
fn numbers_of_contacts_and_dashpots() {
    let text = |numbers: [&str; 4]| {
        let [share, stiffness, mu, dashpot] = numbers;
        format!(
            "struct Pair {{ masses: {{ a: 1.0, b: 2.0 }}, springs: {{ base - a: 1.0, a - b: 3.0 }}, excitation: a,
             contacts: {{ brace: base - a {{ stiffness: {stiffness} }},
                 pads: b - wall {{ share: {share}, stiction: {mu} }} }}, dampers: {{ a - b: {dashpot} }} }}"
        )
    };
    let described = ["0.5", "2.0", "1.2", "0.1"];
    let pair = system(&text(described));
    let names = ["share pads", "stiffness brace", "mu pads", "c b - a"];
    for (index, name) in names.into_iter().enumerate() {
        let of = pair.tunable_named(name).expect("a number");
        let changed = pair.with_value(of, 1.5).expect("a scene");
        let mut numbers = described;
        numbers[index] = "1.5";
        assert_eq!(changed.scene(), system(&text(numbers)).scene(), "{name}");
    }
    // The fields `stiction` and `stiffness` of a scene with a single contact have no effect here.
    for name in ["mu", "stiffness", "share", "speed pads"] {
        assert!(pair.tunable_named(name).is_err(), "{name}");
    }
    let shares = pair.tunables_named("share").expect("shares");
    assert_eq!(shares, [pair.tunable_named("share pads").expect("a share")]);
}

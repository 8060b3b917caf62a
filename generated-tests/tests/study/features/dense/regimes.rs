//! Compares sliding ranges and regimes with the limits β_lim and β*_lim.

use super::{DENSE, dense};
use crate::features::scenes::{random, shown};
use frictiongen::study::features::{Certainty, RegimeEnd};
use frictiongen::{FrictionSystem, LimitsAt, Regime};
use fuzzing::Random;

/// Returns true if a limit equals β at r to a relative 1e-9, or if a steep limit crosses β within a relative distance
/// of 1e-12 from r.
fn is_at(limit: impl Fn(f64) -> f64, r: f64, beta: f64) -> bool {
    let [left, right] = [1.0 - 1e-12, 1.0 + 1e-12].map(|factor| limit(r * factor) - beta);
    (limit(r) / beta - 1.0).abs() < 1e-9 || left * right <= 0.0
}

/// Checks at dense frequencies that the sliding ranges are those where β*_lim exceeds β, in damped and undamped
/// chains.
#[test]
fn sliding_ranges() {
    let mut random_numbers = Random(24);
    let (mut bounds, mut seen) = (0, 0);
    for scene in 0..60 {
        let system = random(&mut random_numbers, 10, scene % 2 == 0);
        let largest = *system.resonances().last().unwrap();
        let range = [0.02 * largest, 2.0 * largest];
        let beta = random_numbers.log_uniform(0.02, 3.0);
        let features = system.features(None).unwrap();
        let ranges = features.sliding_ranges(beta, range).unwrap();
        let places = dense(range, DENSE);
        let mut wanted = Vec::new();
        let margin = |r: f64| system.at(r).unwrap().sliding_limit() - beta;
        for r in &places {
            let inside = ranges
                .iter()
                .any(|range| range.from <= *r && *r <= range.to);
            let margin = margin(*r);
            if margin.abs() > 1e-9 * beta {
                assert_eq!(inside, margin > 0.0, "{r}, β = {beta}, {}", shown(&system));
                seen += 1;
            }
        }
        for pair in places.windows(2) {
            if margin(pair[0]) * margin(pair[1]) < 0.0 {
                wanted.push(pair[0]);
            }
        }
        let ends = ranges
            .iter()
            .flat_map(|range| [&range.from_frequency, &range.to_frequency]);
        let found = ends.flatten().count();
        assert!(wanted.len() <= found, "{} {found}", wanted.len());
        for end in ranges.iter().flat_map(|range| {
            let ends = [
                (range.from, &range.from_frequency),
                (range.to, &range.to_frequency),
            ];
            ends.into_iter()
                .filter_map(|(r, sensed)| sensed.as_ref().map(|_| r))
                .collect::<Vec<_>>()
        }) {
            let limit = |r: f64| system.at(r).unwrap().sliding_limit();
            assert!(is_at(limit, end, beta), "{end}, {beta}, {}", shown(&system));
        }
        bounds += found;
    }
    println!("{bounds} ends, {seen} places");
    assert!(bounds > 150 && seen > 150_000, "{bounds} {seen}");
}

/// Checks at dense frequencies that the regime is that of the list.
#[test]
fn regimes() {
    let mut random_numbers = Random(25);
    let (mut changes, mut seen, mut proven) = (0, 0, 0);
    for scene in 0..30 {
        let system = random(&mut random_numbers, 6, scene % 3 == 0);
        let largest = *system.resonances().last().unwrap();
        let lowest = if scene % 2 == 0 { 0.5 } else { 0.15 };
        let range = [lowest * largest, 2.0 * largest];
        let beta = random_numbers.log_uniform(0.05, 1.5);
        let features = system.features(None).unwrap();
        let (ranges, certainty) = features.regimes(beta, range).unwrap();
        assert_eq!(
            (ranges[0].from, ranges.last().unwrap().to),
            (range[0], range[1])
        );
        for pair in ranges.windows(2) {
            assert!(pair[0].to == pair[1].from && pair[0].regime != pair[1].regime);
        }
        proven += usize::from(certainty == Certainty::Proven);
        for r in dense(range, 1_000) {
            let own = ranges
                .iter()
                .find(|range| range.from <= r && r <= range.to)
                .unwrap();
            let beside = [own.from, own.to]
                .into_iter()
                .any(|end| (end / r - 1.0).abs() < 1e-9);
            let regime: Regime = FrictionSystem::at(&system, r)
                .unwrap()
                .regime(beta)
                .unwrap();
            assert!(
                beside || own.regime == regime,
                "{r}, β = {beta}: {regime:?} in {own:?}, {}",
                shown(&system)
            );
            seen += 1;
        }
        for range in &ranges {
            let at = |r: f64| system.at(r).unwrap();
            let (end, what) = (range.to, shown(&system));
            match range.end {
                RegimeEnd::Range => {}
                RegimeEnd::Continuous(_) => {
                    assert!(
                        is_at(|r| at(r).continuous_limit(), end, beta),
                        "{end}, {beta}, {what}"
                    );
                }
                RegimeEnd::Sliding(_) => {
                    assert!(
                        is_at(|r| at(r).sliding_limit(), end, beta),
                        "{end}, {beta}, {what}"
                    );
                }
            }
        }
        changes += ranges.len() - 1;
    }
    println!("{changes} changes, {seen} places, {proven} proven");
    assert!(
        changes > 60 && seen > 25_000 && proven > 5,
        "{changes} {seen} {proven}"
    );
}

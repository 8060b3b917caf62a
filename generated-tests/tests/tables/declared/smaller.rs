//! Tests which of the limits β_lim and β*_lim is smaller (section 10 of `docs/derivation.md`). With μ = 1 it is β_lim,
//! so β_lim alone decides whether a continuous motion exists.

use super::random;
use super::scenes::scenes;
use frictiongen::{LimitsAt, NotContinuous, Regime, System};
use fuzzing::Random;

/// Relative difference up to which rounding may exchange the order of two equal limits.
const ROUNDINGS: f64 = 1e-9;

/// Compares the limits for r from 0.02 to 20, and returns the r at which β*_lim is smaller by at least a per cent.
/// `seen` counts all comparisons, and the comparisons at these r.
fn compared(text: &str, random: &mut Random, seen: &mut [usize; 2]) -> Vec<f64> {
    let system: System = text.parse().unwrap();
    let mut turned = Vec::new();
    for _ in 0..150 {
        let r = random.power(-1.7, 1.3);
        let limits = system.at(r).unwrap().limits();
        if system.scene().stiction == 1.0 {
            assert!(
                limits.continuous <= limits.sliding * (1.0 + ROUNDINGS),
                "{limits:?} at r = {r} of {text}"
            );
        }
        seen[0] += 1;
        if limits.sliding < 0.99 * limits.continuous {
            seen[1] += 1;
            turned.push(r);
        }
    }
    turned
}

/// Checks that with μ = 1 the contact cannot stick at an r and β at which it can slide all the time.
#[test]
fn beta_lim_without_stiction() {
    let mut random = Random(31);
    let mut seen = [0; 2];
    for (name, text) in scenes("f64") {
        if name.ends_with(", 1") {
            compared(&text, &mut random, &mut seen);
        }
    }
    for _ in 0..40 {
        let text = random::scene(&mut random);
        let Some((before, _)) = text.split_once("stiction: ") else {
            continue;
        };
        compared(&format!("{before}stiction: 1 }}"), &mut random, &mut seen);
    }
    assert!(seen[0] > 60 * 150 && seen[1] == 0, "{seen:?}");
}

/// Checks that with a larger μ the closed form and a stuck state may both exist. Near a resonance this happens from μ
/// = 4/π on, for tables as for the exact formulas.
#[test]
fn both_where_both_are_possible() {
    let mut random = Random(32);
    let (mut seen, mut answered) = ([0; 2], 0);
    for (name, text) in scenes("f64") {
        if !name.ends_with(", 1.2") || !name.contains("0.02") {
            continue;
        }
        let text = text.replace("stiction: 1.2", "stiction: 1.5");
        let turned = compared(&text, &mut random, &mut seen);
        let system: System = text.parse().unwrap();
        let within = turned.into_iter().filter(|r| (0.2..2.5).contains(r));
        let within: Vec<f64> = within.take(5).collect();
        if within.is_empty() {
            continue;
        }
        let compiled = system.compile(0.2..2.5, 1e-3).unwrap();
        for r in within {
            let limits = system.at(r).unwrap().limits();
            let (exact, at) = (system.at(r).unwrap(), compiled.at(r).unwrap());
            let beta = 0.5 * (limits.continuous + limits.sliding);
            assert_eq!(at.regime(beta), Ok(Regime::Bistable), "{name}");
            let motion = at.motion(beta).unwrap().contact().largest();
            let expected = exact.motion(beta).unwrap().contact().largest();
            let error = (motion.amplitude / expected.amplitude - 1.0).abs();
            assert!(
                error < 1e-3,
                "{name}: {motion:?} for {expected:?} at r = {r}"
            );
            // If β is below both limits or above both limits, only one state exists.
            let (below, above) = (0.99 * limits.sliding, 1.01 * limits.continuous);
            assert_eq!(at.regime(below), Ok(Regime::Continuous), "{name}");
            assert!(at.motion(below).is_ok(), "{name}");
            assert_eq!(at.regime(above), Ok(Regime::Stuck), "{name}");
            assert_eq!(at.motion(above).err(), Some(NotContinuous::Stuck), "{name}");
            answered += 1;
        }
    }
    assert!(answered > 10, "{answered}, {seen:?}");
}

//! Compares numbers of contacts between moving bodies, and of the two-storey rig: F27, F28, F30, F32.

use super::ask::{antiresonances, ask, chain, crossings, invariant_points, one_of};
use super::chapter4::ONE_STOREY;
use super::row::{Row, added, claim, formula, number, words};
use super::walls::thresholds;
use crate::rig::STOREYS;
use frictiongen::Of;
use frictiongen::study::{System, features::InvariantQuantity};
use std::f64::consts::TAU;

/// Mass ratio γ = m₂/m₁ of the two-storey rig, as printed.
pub const GAMMA: f64 = STOREYS[0];
/// Stiffness ratio κ = k₂/k₁ of the two-storey rig, as printed.
pub const KAPPA: f64 = STOREYS[1];
/// Coefficient 0.3419 s that is printed in r₁ = (0.3419 s)ω. It is r₁ at 1 Hz, so it belongs to the frequency in Hz
/// (F30).
pub const RATIO: f64 = STOREYS[2];

pub(super) fn rows() -> Vec<Row> {
    let system = chain(&[1.0, 0.5], &[1.0, 0.5], "m1 - m2", "m1", "");
    vec![limits(&system), invariants(&system), rig(), relative()]
}

fn limits(system: &System) -> Row {
    let (continuous, sliding) = system.high_frequency_limits();
    let mut entries = thresholds(system, &["0.785", "0.393"]);
    entries.push(number("β_∞", "0.179", continuous, 6));
    entries.push(number("β*_∞", "0.333", sliding, 6));
    Row {
        id: "F27",
        claim: "two masses, γ = κ = 0.5, contact m₁-m₂, force on m₁: thresholds, limits at r → ∞",
        place: "6.5.1, (6.26), (6.28), (6.29)",
        entries,
        reason: "",
    }
}

fn invariants(system: &System) -> Row {
    let points = invariant_points(
        system,
        Of::Mass(0),
        InvariantQuantity::Amplitude,
        [0.71, 4.0],
    );
    let mut entries = vec![
        number("estimate, first", "0.778", one_of(&points, 2, 0), 6),
        number("second", "1.213", one_of(&points, 2, 1), 6),
    ];
    // The count includes only those pairs of figure 6.23 whose motions both slide all the time.
    let betas = [0.0, 0.1, 0.2, 0.3, 0.4, 0.6];
    for (name, printed, low, high) in [("first", 0.770, 0.74, 0.8), ("second", 1.226, 1.2, 1.24)] {
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for (i, one) in betas.iter().enumerate() {
            for other in &betas[..i] {
                // `crossings` finds none where the larger β does not slide all the time.
                for (crossing, _) in crossings(system, Of::Mass(0), [*one, *other], [low, high]) {
                    (least, most) = (least.min(crossing), most.max(crossing));
                }
            }
        }
        let inside = least <= printed && printed <= most;
        let what = format!("exact, {name} region");
        let text = format!("about {printed:.3}");
        entries.push(claim(&format!("{what}, from"), &text, least, 4, inside));
        entries.push(claim("to", &text, most, 4, inside));
    }
    Row {
        id: "F28",
        claim: "scene of F27: invariant points of m₁",
        place: "6.5.1, (5.74)",
        entries,
        reason: "1.2135 was truncated instead of rounded",
    }
}

/// Returns the two-storey rig whose reference frequency √(k₁/m₁) is `omega`, in rad/s.
#[must_use]
pub fn rig_with(omega: f64) -> System {
    let mass = 3.27;
    let stiffness = mass * omega * omega;
    chain(
        &[mass, GAMMA * mass],
        &[stiffness, KAPPA * stiffness],
        "m1 - base",
        "base",
        "",
    )
}

fn rig() -> Row {
    let system = rig_with(TAU / RATIO);
    let natural = system.natural_frequencies();
    let product = natural[0] * natural[1];
    // At the antiresonance ω₀ mass m₁ does not move without friction. At ω_z0 mass m₁ moves with the base.
    let to_omega = TAU / RATIO;
    let range = [0.1, 4.0];
    let antiresonance = to_omega * one_of(&antiresonances(&system, Of::Mass(0), range), 1, 0);
    let relative = to_omega * one_of(&antiresonances(&system, Of::Contact, range), 1, 0);
    let gamma = (relative / antiresonance).powi(2) - 1.0;
    let kappa = gamma * (antiresonance.powi(2) / product).powi(2);
    let ratio = antiresonance / product;
    let [hertz, radians] = [1.0 / RATIO, 1.0 / (TAU * RATIO)];
    // The one-storey rig of F31 has the same plates and bars.
    let near = |frequency: f64| (frequency / ONE_STOREY - 1.0).abs() < 0.1;
    Row {
        id: "F30",
        claim: "rig, two storeys, fitted to tests: r₁/ω, γ, κ",
        place: "6.4.2, (6.17) to (6.19)",
        entries: vec![
            words(
                "r₁/ω, ω in rad/s",
                "0.3419 s",
                format!(
                    "√(k₁/m₁)/2π is {radians:.4} Hz with this value, {hertz:.3} Hz if the frequency is in Hz, \
                     and {ONE_STOREY} Hz for the storey of F31"
                ),
                near(radians) || !near(hertz),
            ),
            number("r₁/f from ω₀, ω₁, ω₂, s", "0.3419", TAU * ratio, 6),
            number("γ", "0.9772", gamma, 6),
            number("κ", "1.1119", kappa, 6),
        ],
        reason: "0.3419 s is the value for the frequency in Hz",
    }
}

fn relative() -> Row {
    let system = chain(&[1.0, GAMMA], &[1.0, KAPPA], "m1 - base", "base", "");
    let fundamental = |r: f64, beta: f64| {
        ask(&system, r, beta, |motion| {
            motion.contact().harmonic(1).norm()
        })
    };
    let points = invariant_points(
        &system,
        Of::Contact,
        InvariantQuantity::Fundamental,
        [1.04, 1.1],
    );
    let place = one_of(&points, 1, 0);
    let free = (KAPPA / GAMMA).sqrt();
    Row {
        id: "F32",
        claim: "the rig, contact m₁-base, base excitation: relative motion independent of β at r",
        place: "6.5.3, figure 6.29",
        entries: vec![
            number("r", "1.09", place, 6),
            formula("√(κ/γ)", ("", free), place, 1e-9, 6),
            added("fundamental there, β = 0.3", fundamental(free, 0.3), 6),
        ],
        reason: "√(κ/γ), where m₂ swings freely",
    }
}

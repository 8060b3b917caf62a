//! Compares numbers of first harmonics and of the one-storey rig: F07, F13, F31.

use super::ask::{
    ask, base, chain, fundamental, growth, invariant_points, inversions, one_of, wall,
};
use super::row::{ROUNDING, Row, formula, number, words};
use frictiongen::Of;
use frictiongen::study::features::InvariantQuantity;
use std::f64::consts::TAU;

pub(super) fn rows() -> Vec<Row> {
    vec![moving(), fixed(), storey()]
}

fn moving() -> Row {
    let system = base(1.0);
    let points = invariant_points(
        &system,
        Of::Mass(0),
        InvariantQuantity::Fundamental,
        [1.2, 2.0],
    );
    Row {
        id: "F07",
        claim: "one mass on its base: fundamental transmissibility independent of β at r",
        place: "4.4.2, figure 4.10",
        entries: vec![number("for every β", "1.504", one_of(&points, 1, 0), 6)],
        reason: "one point for every β, where U = −(2/π)V",
    }
}

fn fixed() -> Row {
    let system = wall("");
    let growth = |r: f64| growth(&system, |r, beta| fundamental(&system, "m1", r, beta), r);
    let ends = inversions(
        &system,
        Of::Contact,
        InvariantQuantity::Fundamental,
        [0.31, 3.0],
    );
    let (begin, end) = (one_of(&ends, 2, 0), one_of(&ends, 2, 1));
    let grows = (1..100).all(|i| growth(begin + 0.01 * f64::from(i) * (end - begin)) > 0.0);
    let falls = growth(begin - 1e-3) < 0.0 && growth(end + 0.01) < 0.0 && growth(0.7) < 0.0;
    Row {
        id: "F13",
        claim: "one mass, wall: range of r in which the fundamental amplitude grows with β",
        place: "4.4.1, figure 4.7",
        entries: vec![
            number("from", "0.334", begin, 6),
            number("to", "0.604", end, 6),
            words(
                "between",
                "",
                if grows && falls {
                    "grows inside, falls outside"
                } else {
                    "not so"
                }
                .into(),
                grows && falls,
            ),
        ],
        reason: "from the pole of U at 1/3 to where U = −(2/π)V",
    }
}

/// Printed natural frequency of the one-storey rig, in Hz. The thesis fitted it to a test, so only its consequences
/// can be computed.
pub const ONE_STOREY: f64 = 3.086;

fn storey() -> Row {
    // The result does not depend on the mass.
    let (mass, omega) = (3.25, TAU * ONE_STOREY);
    let system = chain(&[mass], &[mass * omega * omega], "m1 - wall", "base", "");
    let frequency = system.natural_frequencies()[0] / TAU;
    let r = system.frequency_ratio(2.0 * omega);
    let free = ask(&system, r, 0.0, |motion| motion.contact().amplitude());
    Row {
        id: "F31",
        claim: "rig, one storey: f_n, fitted to tests; amplitude of a scene with this f_n",
        place: "4.3.1",
        entries: vec![
            number("f_n, Hz", "3.086", frequency, 3),
            formula(
                "X̄ at 2f_n without friction",
                ("1/abs(1 − r²)", 1.0 / (1.0 - r * r).abs()),
                free,
                ROUNDING,
                6,
            ),
        ],
        reason: "",
    }
}

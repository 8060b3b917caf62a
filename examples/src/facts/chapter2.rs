//! Compares numbers of one mass against a fixed wall: F01 to F03, F11 (and with it F12), F35 to F37.

use super::ask::{base, limit, orbit, orbit_amplitude, wall};
use super::row::{Entry, ROUNDING, Row, added, claim, formula, formula_at, number, words};
use crate::two_stops::TwoStops;
use frictiongen::study::{System, orbit::SystemOrbit};
use std::f64::consts::{FRAC_PI_4, PI};

pub(super) fn rows() -> Vec<Row> {
    vec![
        resonance(),
        high_frequencies(),
        constraint(),
        Row {
            id: "F11",
            claim: "one mass, wall, r = 1/2: asymmetric continuous responses for β up to",
            place: "2.5.1, (3.33), 4.5",
            entries: asymmetric(&wall(""), |end| {
                formula("β_lim(1/2)", ("1/3", 1.0 / 3.0), end, ROUNDING, 6)
            }),
            reason: "",
        },
        Row {
            id: "F12",
            claim: "one mass on its base, r = 1/2: asymmetric continuous responses for β up to",
            place: "3.6.2, (3.34)",
            entries: asymmetric(&base(1.0), |end| number("β_lim(1/2)", "0.083", end, 6)),
            reason: "",
        },
        without_stops(
            "F35",
            "one mass, wall, r = 1/3: sticking for any β > 0",
            (1.0 / 3.0, 0.01),
        ),
        without_stops(
            "F36",
            "one mass, wall, r = 1/5: sticking for any β > 0",
            (0.2, 0.005),
        ),
        two_stops(),
    ]
}

fn resonance() -> Row {
    let system = wall("");
    let threshold = system.resonance_thresholds()[0].unwrap_or(f64::NAN);
    let pi_4 = ("π/4", FRAC_PI_4);
    Row {
        id: "F01",
        claim: "one mass, wall: β_lim at r → 1",
        place: "2.5.1, (2.30)",
        entries: vec![
            formula("β_lim(1)", pi_4, limit(&system, 1.0), ROUNDING, 6),
            formula("threshold (6.2)", pi_4, threshold, ROUNDING, 6),
        ],
        reason: "",
    }
}

fn high_frequencies() -> Row {
    let [one, more] = [1.0, 1.5].map(|mu| {
        let system = wall(&format!("stiction: {mu:?}"));
        limit(&system, f64::INFINITY)
    });
    let printed = 2.0 / (4.0 * 1.5 + PI * PI).sqrt();
    let text = format!("{printed:.3} by (2.31)");
    Row {
        id: "F02",
        claim: "one mass, wall: β_lim at r → ∞",
        place: "2.5.1, (2.31); 6.2.3, (6.8)",
        entries: vec![
            number("μ = 1", "0.537", one, 6),
            formula("μ = 1.5", (&text, printed), more, ROUNDING, 6),
        ],
        reason: "4μ² instead of 4μ in (2.31) and (6.8)",
    }
}

/// Returns the velocity constraint S divided by its limit m*/r² for τ → 0. S follows from β_lim = |V|/√(U² + S²) with
/// μ = 1 (2.26), and m* is 1.
#[must_use]
pub fn constraint_ratio(system: &System, r: f64) -> f64 {
    let (v, u) = (1.0 / (1.0 - r * r), (PI / (2.0 * r)).tan() / r);
    r * r * ((v / limit(system, r)).powi(2) - u * u).sqrt()
}

fn constraint() -> Row {
    let system = wall("");
    let points = [0.51, 0.55, 0.6, 0.7, 0.9, 1.1, 1.5, 2.0, 3.0];
    let points = points.map(|r| (1.0, constraint_ratio(&system, r)));
    Row {
        id: "F03",
        claim: "one mass: velocity constraint S/(m*/r²)",
        place: "3.4.1, figure 3.3",
        entries: vec![
            formula_at("r from 0.51 to 3", "1", &points, ROUNDING, 6),
            added("r = 0.4", constraint_ratio(&system, 0.4), 6),
        ],
        reason: "",
    }
}

/// Returns the entries about the friction ratio at which the continuum of marginal motions without stops ends.
fn asymmetric(system: &System, beside: impl Fn(f64) -> Entry) -> Vec<Entry> {
    let end = limit(system, 0.5);
    let marginal = |share: f64| {
        orbit(system, 0.5, share * end).is_some_and(|orbit| {
            !orbit.is_symmetric()
                && orbit.is_marginal()
                && (orbit.stops(), orbit.reversals()) == (0, 2)
        })
    };
    let below = [0.2, 0.6, 0.98].into_iter().all(marginal);
    let beyond = orbit(system, 0.5, 1.02 * end)
        .is_some_and(|orbit| orbit.is_symmetric() && !orbit.is_marginal() && orbit.stops() == 2);
    let said = if below && beyond {
        "asymmetric and marginal up to 0.98 β_lim, symmetric from 1.02 β_lim"
    } else {
        "not so"
    };
    vec![
        beside(end),
        words("response", "", said.into(), below && beyond),
    ]
}

fn without_stops(id: &'static str, claimed: &'static str, (r, beta): (f64, f64)) -> Row {
    let system = wall("");
    let found = orbit(&system, r, beta);
    let ask = |question: fn(&SystemOrbit<'_>) -> f64| found.as_ref().map_or(f64::NAN, question);
    let stops = ask(|orbit| f64::from(u8::try_from(orbit.stops()).unwrap_or(u8::MAX)));
    let reversals = ask(|orbit| f64::from(u8::try_from(orbit.reversals()).unwrap_or(u8::MAX)));
    Row {
        id,
        claim: claimed,
        place: "2.5.1",
        entries: vec![
            claim(
                &format!("stops a cycle, β = {beta}"),
                "some",
                stops,
                0,
                stops > 0.0,
            ),
            added("reversals a cycle", reversals, 0),
            added("max abs(x̄)", ask(|orbit| orbit_amplitude(orbit, "m1")), 9),
        ],
        reason: "above β_lim, small friction reverses the motion without a stop",
    }
}

fn two_stops() -> Row {
    let (r, beta) = (0.3, 0.4);
    let system = wall("");
    let found = orbit(&system, r, beta);
    let (stops, largest) = found.as_ref().map_or((0, f64::NAN), |orbit| {
        (orbit.stops(), orbit_amplitude(orbit, "m1"))
    });
    let den_hartog = TwoStops::new(r, beta).map_or(f64::NAN, |motion| motion.amplitude());
    Row {
        id: "F37",
        claim: "one mass, wall, r = 0.3, β = 0.4: stops a cycle, max abs(x̄)",
        place: "2.5.1, (2.32)",
        entries: vec![
            words("stops", "2", stops.to_string(), stops == 2),
            formula(
                "max abs(x̄)",
                ("by (2.32)", den_hartog),
                largest,
                ROUNDING,
                13,
            ),
        ],
        reason: "",
    }
}

//! Compares numbers of chains that rub on a fixed wall: rows F14 to F26.

use super::ask::{
    amplitude, chain, continuous, fundamental, invariant_points, inversions, limit, one_of, peak,
    root, sliding_ranges, stuck, unit,
};
use super::row::{Entry, ROUNDING, Row, added, formula, formula_at, number, words};
use crate::rig::STOREYS;
use frictiongen::Of;
use frictiongen::study::{
    System,
    features::{Condition, InvariantQuantity},
};
use std::f64::consts::SQRT_2;

const CONTACT: Of = Of::Contact;

pub(super) fn rows() -> Vec<Row> {
    let mut rows = three();
    rows.extend(lower());
    rows.extend(upper());
    rows.push(five());
    rows
}

/// Compares the resonance thresholds β_n,i of a system with the printed thresholds.
pub(super) fn thresholds(system: &System, printed: &[&str]) -> Vec<Entry> {
    (1..)
        .zip(system.resonance_thresholds())
        .zip(printed)
        .map(|((i, beta), printed)| {
            number(&format!("β_n,{i}"), printed, beta.unwrap_or(f64::NAN), 6)
        })
        .collect()
}

/// Returns the rows F14 to F16: three equal masses, contact on m₂, force on m₁.
fn three() -> Vec<Row> {
    let system = unit(3, "m2 - wall", "m1");
    let start = |beta: f64| system.quasi_static_start(beta).unwrap_or_default();
    let starts = |mass: usize, share: f64| -> Vec<(f64, f64)> {
        [0.3, 0.0, 0.1, 0.49]
            .into_iter()
            .filter_map(|beta| Some((1.0 - share * beta, *start(beta).get(mass)?)))
            .collect()
    };
    let resting = [0.9_f64, 0.3, 1.3, 1.5, 2.0, 3.0];
    let resting = resting.map(|r| (1.0 / (2.0 - r * r).abs(), stuck(&system, "m1", r)));
    // The range begins just above r = 0.
    let edge = |end: usize, sign: f64| -> Vec<(f64, f64)> {
        let of = |beta: f64| {
            let ends = sliding_ranges(&system, beta, [0.01, 4.0]);
            (((2.0 * beta + sign) / beta).sqrt(), one_of(&ends, 2, end))
        };
        [0.8, 0.6, 1.0, 2.0].into_iter().map(of).collect()
    };
    vec![
        Row {
            id: "F14",
            claim: "three unit masses, contact m₂-wall, force on m₁: resonance thresholds",
            place: "6.2.1, (6.2)",
            entries: thresholds(&system, &["0.436", "1.765", "0.630"]),
            reason: "",
        },
        Row {
            id: "F15",
            claim: "scene of F14: quasi-static start",
            place: "6.2.2, (6.5)",
            entries: vec![
                formula_at("x̄₁ at β = 0.3", "1 − β", &starts(0, 1.0), ROUNDING, 6),
                formula_at("x̄₂", "1 − 2β", &starts(1, 2.0), ROUNDING, 6),
                formula_at("x̄₃", "1 − 2β", &starts(2, 2.0), ROUNDING, 6),
            ],
            reason: "",
        },
        Row {
            id: "F16",
            claim: "scene of F14: stuck transmissibility of m₁; sliding range of r",
            place: "6.2.5, (6.12), (6.13)",
            entries: vec![
                formula_at("at r = 0.9", "1/abs(2 − r²)", &resting, ROUNDING, 6),
                formula_at(
                    "from, at β = 0.8",
                    "√((2β−1)/β)",
                    &edge(0, -1.0),
                    ROUNDING,
                    6,
                ),
                formula_at("to", "√((2β+1)/β)", &edge(1, 1.0), ROUNDING, 6),
            ],
            reason: "",
        },
    ]
}

/// Returns the rows F17 to F20: two equal masses, contact and force on m₁.
fn lower() -> Vec<Row> {
    let system = unit(2, "m1 - wall", "m1");
    let points = invariant_points(&system, CONTACT, InvariantQuantity::Amplitude, [0.5, 4.0]);
    let grows = inversions(
        &system,
        Of::Mass(1),
        InvariantQuantity::Amplitude,
        [0.5, 4.0],
    );
    let without = |r: f64| {
        let at = system.at(r);
        at.map_or(f64::NAN, |at| at.continuous_limit_without_search()) - 0.2
    };
    let found = continuous(&system, 0.2, [0.34, 0.53]);
    let (begin, end) = (one_of(&found, 2, 0), one_of(&found, 2, 1));
    let higher = continuous(&system, 0.4, [0.53, 0.7]);
    let inside =
        (1..100).all(|i| limit(&system, begin + (end - begin) * 0.01 * f64::from(i)) > 0.2);
    vec![
        Row {
            id: "F17",
            claim: "two unit masses, contact m₁-wall, force on m₁: invariant points of m₁, r > 0.5",
            place: "6.3.2, (6.9)",
            entries: vec![
                number("first", "0.559", one_of(&points, 2, 0), 6),
                number("second", "1.123", one_of(&points, 2, 1), 6),
            ],
            reason: "(6.9) gives √5/4 and √5/2",
        },
        Row {
            id: "F18",
            claim: "scene of F17: ranges of r in which the estimated amplitude of m₂ grows with β",
            place: "6.3.2, (6.10)",
            entries: vec![
                number("first from", "0.527", one_of(&grows, 4, 0), 6),
                number("to", "0.576", one_of(&grows, 4, 1), 6),
                number("second from", "1", one_of(&grows, 4, 2), 6),
                number("to", "1.201", one_of(&grows, 4, 3), 6),
            ],
            reason: "0.5276 was truncated instead of rounded",
        },
        Row {
            id: "F19",
            claim: "scene of F17, β = 0.2: range of low r with continuous motion",
            place: "6.3.2, figure 6.6",
            entries: vec![
                number("from", "0.372", begin, 4),
                number("to", "0.524", end, 4),
                words(
                    "between",
                    "",
                    if inside {
                        "β_lim > 0.2 between"
                    } else {
                        "not so"
                    }
                    .into(),
                    inside,
                ),
                added(
                    "from, if the velocity constraint is left out",
                    root(without, 0.35, 0.42),
                    4,
                ),
            ],
            reason: "0.378 with the velocity constraint, 0.374 without",
        },
        Row {
            id: "F20",
            claim: "scene of F17, β = 0.4: r from which the motion is continuous",
            place: "6.3.2, figure 6.6",
            entries: vec![number("r", "0.559", one_of(&higher, 2, 0), 5)],
            reason: "",
        },
    ]
}

/// Finds the frequency ratios at which H = 0. At these frequency ratios the contact does not respond to a harmonic
/// force in the contact.
fn receptance(system: &System) -> Vec<f64> {
    let features = system.features(None).ok();
    let points = features.and_then(|all| {
        all.invariant_points(CONTACT, InvariantQuantity::Fundamental, [1.0, 4.0])
            .ok()
    });
    let points = points.unwrap_or_default().into_iter();
    points
        .filter(|point| point.condition == Condition::Receptance)
        .map(|point| point.r)
        .collect()
}

/// Returns the rows F21 to F25: two equal masses, contact on m₂, force on m₁.
fn upper() -> Vec<Row> {
    let system = unit(2, "m2 - wall", "m1");
    let points = invariant_points(&system, CONTACT, InvariantQuantity::Amplitude, [0.65, 4.0]);
    let of_m1 = invariant_points(
        &system,
        Of::Mass(0),
        InvariantQuantity::Amplitude,
        [0.65, 4.0],
    );
    let meet = |beta: f64, low: f64, high: f64| {
        let difference = |r| amplitude(&system, "m2", r, beta) - amplitude(&system, "m2", r, 0.0);
        // The curves touch at this r and do not cross, because friction lowers the contact's amplitude on both sides.
        peak(difference, low, high)
    };
    let of_m2 = |r, beta| fundamental(&system, "m2", r, beta);
    let [gamma, kappa, _] = STOREYS;
    let rig = chain(&[1.0, gamma], &[1.0, kappa], "m2 - wall", "base", "");
    let mut resting = Vec::new();
    for kappa in [1.0, 0.2, 3.5] {
        let system = chain(&[1.0, 1.0], &[1.0, kappa], "m2 - wall", "m1", "");
        for r in [0.4_f64, 1.0, 1.7, 2.6] {
            let want = 1.0 / (1.0 + kappa - r * r).abs();
            resting.push((want, stuck(&system, "m1", r)));
        }
    }
    let all = "two unit masses, contact m₂-wall, force on m₁: resonance thresholds";
    vec![
        Row {
            id: "F21",
            claim: all,
            place: "6.3.3, (6.2)",
            entries: thresholds(&system, &["0.485", "1.271"]),
            reason: "",
        },
        Row {
            id: "F22",
            claim: "scene of F21: all curves of m₂ meet at r",
            place: "6.3.3, (6.9)",
            entries: vec![
                number("phase, β = 0.3", "1.450", one_of(&points, 1, 0), 5),
                number("amplitude, β = 0.3", "1.450", meet(0.3, 1.43, 1.47), 5),
            ],
            reason: "",
        },
        Row {
            id: "F23",
            claim: "scene of F21: invariant points of m₁, estimated, r > 0.6",
            place: "6.3.3, (6.10)",
            entries: vec![
                number("first", "0.828", one_of(&of_m1, 2, 0), 6),
                number("second", "1.549", one_of(&of_m1, 2, 1), 6),
            ],
            reason: "",
        },
        Row {
            id: "F24",
            claim: "scene of F21: fundamental of m₂ independent of β at r",
            place: "6.4.3, figure 6.21",
            entries: vec![
                formula(
                    "r",
                    ("√2", SQRT_2),
                    one_of(&receptance(&system), 1, 0),
                    ROUNDING,
                    6,
                ),
                added("fundamental there, β = 0.4", of_m2(SQRT_2, 0.4), 6),
                added(
                    "r with the rig's γ and κ, √(1 + κ)",
                    one_of(&receptance(&rig), 1, 0),
                    6,
                ),
            ],
            reason: "",
        },
        Row {
            id: "F25",
            claim: "scene of F21, any κ: stuck transmissibility of m₁",
            place: "6.3.3, (6.14)",
            entries: vec![formula_at(
                "κ = 1, r = 0.4, and 11 more",
                "1/abs(1 + κ − r²)",
                &resting,
                ROUNDING,
                6,
            )],
            reason: "",
        },
    ]
}

/// Finds the maxima of a limit over the frequency ratio from 1/4 to 3 that are above 0.7. Returns pairs of frequency
/// ratio and height.
pub fn maxima(limit: &dyn Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let step = 5e-4;
    let mut found = Vec::new();
    let mut last = [limit(499.0 * step), limit(500.0 * step)];
    for i in 500..6000 {
        let r = step * f64::from(i);
        let next = limit(r + step);
        if last[0] < last[1] && last[1] >= next && last[1] > 0.7 {
            let r = peak(limit, r - step, r + step);
            found.push((r, limit(r)));
        }
        last = [last[1], next];
    }
    found
}

/// Returns row F26: five equal masses, contact and force on m₁.
fn five() -> Row {
    let system = unit(5, "m1 - wall", "m1");
    let exact = maxima(&|r| limit(&system, r));
    let per_mode = maxima(&|r| {
        let at = system.at(r);
        at.map_or(f64::NAN, |at| at.continuous_limit_per_mode())
    });
    let mut entries = vec![words(
        "number of maxima",
        "five",
        exact.len().to_string(),
        exact.len() == 5,
    )];
    for (r, beta) in &exact {
        entries.push(number(&format!("at r = {r:.4}"), "about 0.83", *beta, 4));
    }
    // On both sides of a smooth maximum, the limit falls with the square of the distance. If it falls linearly, the
    // maximum is a kink.
    let kinks = exact.iter().filter(|(r, beta)| {
        let fall = |h: f64| beta - limit(&system, r + h);
        let near = 1e-5;
        fall(near) / near > 0.1 || fall(-near) / near > 0.1
    });
    let kinks: Vec<String> = kinks.map(|(r, _)| format!("{r:.4}")).collect();
    let lowest = exact.first().map(|(r, _)| format!("{r:.4}"));
    entries.push(words(
        "maxima that are not smooth",
        "the lowest",
        format!("at r = {}", kinks.join(", ")),
        kinks.len() == 1 && kinks.first() == lowest.as_ref(),
    ));
    for (r, beta) in per_mode.iter().take(2) {
        let what = format!("with S as (5.55) prints it, at r = {r:.4}");
        entries.push(added(&what, *beta, 4));
    }
    Row {
        id: "F26",
        claim: "five unit masses, contact m₁-wall, force on m₁: maxima of β_lim",
        place: "6.3.2, figure 6.10",
        entries,
        reason: "the maxima fall with r; (5.55) is the sum of maxima, not the maximum of the sum",
    }
}

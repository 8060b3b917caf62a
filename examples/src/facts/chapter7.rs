//! Compares numbers of modal damping and friction together: F29, F34.

use super::ask::{amplitude, chain, limit, wall};
use super::row::{Entry, Row, added, claim, number, words};
use crate::draw::from_rest;
use frictiongen::study::units::polar;
use frictiongen::{Of, System};
use std::f64::consts::{PI, TAU};

pub(super) fn rows() -> Vec<Row> {
    vec![resonance(), responses()]
}

fn resonance() -> Row {
    let beta = 0.3;
    let mut entries = Vec::new();
    for zeta in [0.01, 0.1] {
        let system = wall(&format!("damping: modal({zeta:?})"));
        let (sinh, cosh) = ((zeta * PI).sinh(), (zeta * PI).cosh());
        let found = system.features(None).ok();
        let found = found.and_then(|all| all.resonant_peaks(Of::Mass(0), beta).ok());
        let found = found.and_then(|mut found| found.pop());
        let (printed, highest) = found.map_or((f64::NAN, f64::NAN), |found| {
            let (estimate, peak) = (found.estimate, found.peak);
            (
                estimate.map_or(f64::NAN, |estimate| estimate.value),
                peak.map_or(f64::NAN, |peak| peak.amplitude.value),
            )
        });
        entries.push(by_formula(
            &format!("peak at ζ = {zeta}, β = 0.3"),
            ("7.61", printed),
            highest,
        ));
        entries.push(added(
            "amplitude at r = 1",
            amplitude(&system, "m1", 1.0, beta),
            4,
        ));
        entries.push(by_formula(
            &format!("threshold at r = 1, ζ = {zeta}"),
            ("7.62", (cosh - 1.0) / (2.0 * zeta * sinh)),
            limit(&system, 1.0),
        ));
    }
    Row {
        id: "F29",
        claim: "one mass, wall, damped: resonant peak; threshold at resonance",
        place: "7.4.1, (7.61), (7.62)",
        entries,
        reason: "approximations for small ζ; (7.62) leaves out the break-away term",
    }
}

/// Compares a computed number with a printed formula, to four digits.
fn by_formula(what: &str, (equation, printed): (&str, f64), value: f64) -> Entry {
    let shown = format!("{printed:.4}");
    Entry {
        printed: format!("{shown} by ({equation})"),
        ..number(what, &shown, value, 4)
    }
}

const FIVE: [Of; 5] = [
    Of::Mass(0),
    Of::Mass(1),
    Of::Mass(2),
    Of::Mass(3),
    Of::Mass(4),
];

/// Returns the largest values of two differences over a cycle and all masses. The first is that between closed form
/// and simulation. The second is that between a phase and motion in phase or in opposition with the contact, in
/// degrees.
#[must_use]
pub fn differences(system: &System, r: f64, beta: f64) -> Option<(f64, f64)> {
    let angles: Vec<f64> = (0..24).map(|i| TAU * f64::from(i) / 24.0).collect();
    let motion = system.at(r).ok()?.motion(beta).ok()?;
    let contact = motion.contact();
    let origin = contact.phase();
    let lag = |x| polar(x).1.to_degrees();
    let simulated = from_rest(system, (r, beta), &FIVE, &angles)?;
    let (mut apart, mut turned) = (0.0_f64, 0.0_f64);
    for (mass, simulated) in simulated.iter().enumerate() {
        let closed = motion.mass_at(mass)?;
        for (angle, simulated) in angles.iter().zip(simulated) {
            apart = apart.max((closed.displacement(angle - origin) - simulated).abs());
        }
        let beside = (lag(closed.harmonic(1)) - lag(contact.harmonic(1))).rem_euclid(180.0);
        turned = turned.max(beside.min(180.0 - beside));
    }
    Some((apart, turned))
}

fn responses() -> Row {
    // A printed statement about phases, with the bounds in degrees within which the statement counts as true.
    type Phases = Option<(&'static str, f64, f64)>;
    let (nearly, lost) = (("nearly so", 0.0, 10.0), ("lost", 30.0, 90.0));
    let scenes: [(&str, &str, f64, Phases); 4] = [
        ("m₁, ζ = 0.01", "m1", 0.01, Some(nearly)),
        ("m₁, ζ = 0.1", "m1", 0.1, Some(lost)),
        ("m₃, ζ = 0.01", "m3", 0.01, None),
        ("m₃, ζ = 0.1", "m3", 0.1, None),
    ];
    let mut entries = Vec::new();
    for (name, mass, zeta, printed) in scenes {
        let (contact, damping) = (
            format!("{mass} - wall"),
            format!("damping: modal({zeta:?})"),
        );
        let system = chain(&[1.0; 5], &[1.0; 5], &contact, "m1", &damping);
        let found = differences(&system, 0.9, 0.2);
        let (apart, turned) = found.unwrap_or((f64::NAN, f64::NAN));
        let amplitude = amplitude(&system, mass, 0.9, 0.2);
        // After 1000 cycles the transient is below the accumulated rounding error.
        let same = apart < 1e-9;
        let said = if same {
            "less than 1e-9 apart"
        } else {
            "not so"
        };
        entries.push(words(
            &format!("contact {name}: closed form and simulation"),
            "excellent agreement",
            said.into(),
            same,
        ));
        entries.push(added("amplitude in the contact", amplitude, 6));
        let what = "largest difference from in-phase or opposite-phase motion, degrees";
        entries.push(match printed {
            Some((printed, least, most)) => {
                let agrees = least <= turned && turned < most;
                claim(what, printed, turned, 1, agrees)
            }
            None => added(what, turned, 1),
        });
    }
    Row {
        id: "F34",
        claim: "five unit masses, force on m₁, r = 0.9, β = 0.2: time responses",
        place: "7.3, figures 7.1, 7.2",
        entries,
        reason: "",
    }
}

//! Compares a steady state with its reference, value by value.

use super::points::{Point, count, number};
use frictiongen::study::orbit::{SystemOrbit, SystemOrbitMotion};
use serde_json::Value;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Tolerance for values. The reference ends Newton's method at a step of 1e-14 to 1e-12 of the state. It finds the
/// time of each event to 1e-15, divided by the slope of the velocity. The tolerance is twenty times the resulting
/// error.
const TOLERANCE: f64 = 1e-11;
/// Tolerance for phases, in rad. The instant of a smooth maximum is known to half of the digits of its value. The
/// instant of a maximum at a stop is known as accurately as an event.
const PHASES: f64 = 1e-7;
/// Tolerance for multipliers. The reference computes them by central differences with a step of 1e-6 of the state.
const MULTIPLIERS: f64 = 1e-4;

/// Numbers of compared and skipped values, and the worst error of each kind of value.
#[derive(Default)]
pub struct Tally {
    compared: usize,
    skipped: BTreeMap<&'static str, usize>,
    worst: BTreeMap<&'static str, (f64, String)>,
}

impl Tally {
    pub fn note(&mut self, kind: &'static str, found: f64, expected: f64, scale: f64, what: &str) {
        self.compared += 1;
        let error = (found - expected).abs() / scale;
        let error = if error.is_nan() { f64::INFINITY } else { error };
        let worst = self.worst.entry(kind).or_insert((0.0, String::new()));
        if worst.0 <= error {
            *worst = (error, format!("{what}: {found} instead of {expected}"));
        }
    }

    pub fn skip(&mut self, why: &'static str) {
        *self.skipped.entry(why).or_insert(0) += 1;
    }

    /// Prints the results, and asserts that every kind of value is within its tolerance.
    pub fn end(&self, bar: impl Fn(&str) -> f64) {
        println!(
            "{} values compared, skipped: {:?}",
            self.compared, self.skipped
        );
        for (kind, (error, what)) in &self.worst {
            println!("{kind}: {error:.1e} at {what}");
        }
        for (kind, (error, what)) in &self.worst {
            assert!(*error <= bar(kind), "{kind}: {error:e} at {what}");
        }
    }
}

/// Compares a motion with its reference.
fn compare(
    motion: SystemOrbitMotion<'_, '_>,
    expected: &Value,
    phases: bool,
    tally: &mut Tally,
    what: &str,
) {
    let amplitude = number(&expected["amplitude"]);
    tally.note("amplitude", motion.amplitude(), amplitude, amplitude, what);
    tally.note(
        "mean",
        motion.harmonic(0).re,
        number(&expected["mean"]),
        amplitude,
        what,
    );
    for (n, name) in [(1, "fundamental"), (3, "third")] {
        let Some(parts) = expected[name].as_array() else {
            tally.skip("no third harmonic of a marginal reference");
            continue;
        };
        let found = motion.harmonic(n);
        tally.note(name, found.re, number(&parts[0]), amplitude, what);
        tally.note(name, found.im, number(&parts[1]), amplitude, what);
    }
    if !phases {
        tally.skip("no phase of a marginal reference");
    } else if expected["phase"].is_null() {
        tally.skip("no phase where two maxima are equal");
    } else {
        let apart = (motion.phase() - number(&expected["phase"])).rem_euclid(TAU);
        tally.note("phase", (apart + PI).rem_euclid(TAU) - PI, 0.0, 1.0, what);
    }
}

pub fn all_motions(orbit: &SystemOrbit<'_>, point: &Point, phases: bool, tally: &mut Tally) {
    let (expected, what) = (&point.expected, &point.what);
    let masses = expected["masses"].as_array().expect("masses");
    let contact = &expected["contact"];
    compare(orbit.contact(), contact, phases, tally, what);
    assert_eq!(masses.len(), point.system.scene().masses.len(), "{what}");
    for (mass, expected) in masses.iter().enumerate() {
        let motion = orbit.mass_at(mass).expect("a mass");
        compare(motion, expected, phases, tally, what);
    }
}

/// Compares a steady state with its reference, value by value.
pub fn all_values(point: &Point, tally: &mut Tally) {
    let (expected, what) = (&point.expected, &point.what);
    let orbit = point
        .orbit()
        .unwrap_or_else(|error| panic!("{what}: {error}"));
    let counts = ["period", "stops", "reversals"].map(|name| count(&expected[name]));
    let found = [orbit.period() as usize, orbit.stops(), orbit.reversals()];
    assert_eq!(found, counts, "{what}");
    let symmetric = expected["symmetric"].as_bool().expect("a flag");
    assert_eq!(orbit.is_symmetric(), symmetric, "{what}");
    assert!(orbit.is_stable() && !orbit.is_marginal(), "{what}");
    let stuck = number(&expected["stuck_fraction"]);
    tally.note("stuck fraction", orbit.stuck_fraction(), stuck, 1.0, what);
    let moduli = orbit.multipliers().iter().map(|value| value.norm());
    let largest = moduli.fold(0.0, f64::max);
    let multiplier = number(&expected["multiplier"]);
    tally.note("multiplier", largest, multiplier, 1.0, what);
    if expected["origin"].is_null() {
        tally.skip("no origin where two maxima are equal");
    } else {
        let apart = (orbit.origin() - number(&expected["origin"])).rem_euclid(TAU);
        tally.note("origin", (apart + PI).rem_euclid(TAU) - PI, 0.0, 1.0, what);
    }
    all_motions(&orbit, point, true, tally);
}

pub fn bars(kind: &str) -> f64 {
    match kind {
        "phase" => PHASES,
        "multiplier" => MULTIPLIERS,
        _ => TOLERANCE,
    }
}

//! Compares steady states with `reference/orbits_more.json`. The reference comes from an integrator that shares no
//! code with this project (`reference/tools`). Its states are asymmetric, subharmonic, unstable or marginal, or have
//! many segments.
//!
//! This module has the tests. `points` reads the references, and `values` compares them.

mod points;
mod values;

use frictiongen::NoOrbit;
pub use points::number;
use points::{Point, count, points};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use values::{Tally, all_motions, all_values, bars};

/// Tolerance for states that a motion approaches as 1/√n after n cycles. The reference extrapolates them from 4096
/// cycles.
const CONTINUED: f64 = 2e-6;

fn reported(point: &Point) -> bool {
    point.kind() == "steady"
        && count(&point.expected["period"]) == 1
        && count(&point.expected["segments"]) <= 64
}

/// Compares states that repeat after one cycle.
#[test]
fn of_one_cycle() {
    let points = points(reported);
    let mut tally = Tally::default();
    let (mut asymmetric, mut many, mut turning, mut between) = (0, 0, 0, 0);
    for point in &points {
        all_values(point, &mut tally);
        let expected = &point.expected;
        asymmetric += usize::from(expected["symmetric"] == false);
        many += usize::from(count(&expected["stops"]) >= 3);
        turning += usize::from(count(&expected["reversals"]) >= 6);
        between += usize::from(count(&expected["held_between"]) > 0);
    }
    println!(
        "{} states: {asymmetric} asymmetric, {many} of three stops and more, {turning} of six reversals \
         and more, {between} with stops under forces between β and μβ",
        points.len()
    );
    assert!(points.len() >= 60 && asymmetric >= 20 && many >= 30 && turning >= 3 && between >= 15);
    tally.end(bars);
}

/// Checks that z̄ has the same bits at the end of a stop as at its beginning. The extremes of the contact include the ends
/// of stops, and the amplitude only their beginnings. The larger extreme must have the bits of the amplitude.
#[test]
fn a_stop_keeps_the_bits_of_the_displacement() {
    let points = points(reported);
    for point in &points {
        let orbit = point.orbit().expect("a steady state");
        let (least, most) = orbit.contact().extremes();
        let (largest, amplitude) = (most.max(-least), orbit.contact().amplitude());
        assert_eq!(largest.to_bits(), amplitude.to_bits(), "{}", point.what);
    }
}

/// Checks that τ counts from the largest maximum of z̄, if z̄ has several maxima.
#[test]
fn counted_from_the_largest() {
    let several = |point: &Point| {
        reported(point)
            && point.expected["others_below"]
                .as_f64()
                .is_some_and(|below| below > 1e-3)
    };
    let points = points(several);
    for point in &points {
        let orbit = point.orbit().expect("a steady state");
        let (contact, what) = (orbit.contact(), &point.what);
        let start = contact.displacement(0.0);
        let samples = (0..2000).map(|k| contact.displacement(TAU * f64::from(k) / 2000.0));
        let largest = samples.fold(f64::MIN, f64::max);
        // A sample must not exceed the maximum by more than rounding.
        assert!(
            largest <= start + 1e-12 * start.abs().max(1.0),
            "{what}: {largest} above {start}"
        );
    }
    println!("{} states with maxima of different height", points.len());
    assert!(points.len() >= 20);
}

/// Checks references in which the force at a stop lies between β and μβ. A rule that used β in place of μβ would give
/// other states for them.
#[test]
fn the_rule_matters() {
    let (mut other, mut none) = (0, 0);
    for point in points(|point| {
        point.expected["held_between"]
            .as_u64()
            .is_some_and(|held| held > 0)
    }) {
        let wrong = &point.expected["by_beta"];
        if wrong["stops"].is_null() {
            none += 1;
            continue;
        }
        let stops = (count(&wrong["stops"]), count(&wrong["reversals"]));
        let own = (
            count(&point.expected["stops"]),
            count(&point.expected["reversals"]),
        );
        let amplitude = number(&point.expected["contact"]["amplitude"]);
        let apart = (number(&wrong["contact_amplitude"]) / amplitude - 1.0).abs();
        if stops != own || apart > 1e-3 {
            other += 1;
        }
        assert!(point.mu() > 1.0, "{}", point.what);
    }
    println!("{other} would have other stops or another amplitude, {none} would not settle");
    assert!(other >= 20);
}

/// Compares states that repeat after several cycles.
#[test]
fn of_several_cycles() {
    let mut tally = Tally::default();
    let (mut told, mut followed) = (BTreeMap::new(), 0);
    for point in points(|point| point.kind() == "steady" && count(&point.expected["period"]) > 1) {
        all_values(&point, &mut tally);
        *told.entry(count(&point.expected["period"])).or_insert(0) += 1;
        // The motion has more segments than the orbit can store, so the orbit recomputes some segments when the test
        // asks for them.
        followed += usize::from(count(&point.expected["segments"]) > 64);
    }
    println!("periods and how many: {told:?}; {followed} of more than 64 segments");
    assert!(told.len() >= 12 && told.values().sum::<usize>() >= 40 && followed >= 10);
    tally.end(|kind| match kind {
        // Central differences lose more digits over this many stops.
        "multiplier" => 1e-3,
        _ => bars(kind),
    });
}

/// Checks that a motion that starts on an unstable orbit is reported as unstable. Motion from rest that neither
/// repeats nor settles must also be reported as unstable, or as motion beside another state that is stable.
#[test]
fn unstable() {
    let points = points(|point| point.kind() == "unstable");
    let (mut longer, mut bounded, mut left, mut beside) = (0, 0, 0, 0);
    for point in &points {
        let (expected, what) = (&point.expected, &point.what);
        assert!(number(&expected["multiplier"]) > 1.01, "{what}");
        let at = point.system.at(point.r).expect("in the domain");
        match point.orbit() {
            Ok(orbit) if !orbit.is_from_rest() => {
                assert!(orbit.is_stable() && !orbit.is_marginal(), "{what}");
                beside += 1;
            }
            // The program that made the reference looked only for periods up to 16 cycles.
            Ok(orbit) => {
                assert!(orbit.period() > 16 && orbit.is_stable(), "{what}");
                assert!(repeats(point, orbit.period()) < 1e-9, "{what}");
                longer += 1;
            }
            Err(error) => {
                assert_eq!(error, NoOrbit::Unstable, "{what}");
                let seen = at.orbit_or_last_cycles(point.beta).expect("a motion");
                assert!(!seen.is_settled() && !seen.is_stable(), "{what}");
                let largest = largest_seen(point);
                let amplitude = seen.contact().amplitude();
                // The motion has no period. The largest value of the run may occur in cycles that the orbit does not
                // contain.
                assert!(
                    (amplitude / largest - 1.0).abs() < 0.25,
                    "{what}: {amplitude}, {largest}"
                );
                bounded += 1;
            }
        }
        let state: Vec<f64> = expected["state"]
            .as_array()
            .expect("a state")
            .iter()
            .map(number)
            .collect();
        let (x, v) = state.split_at(state.len() / 2);
        match at.orbit_from(point.beta, (x, v)) {
            Ok(orbit) if !orbit.is_from_rest() => assert!(orbit.is_stable(), "{what}"),
            // Rounding grows on the unstable orbit, and may lead to the state that motion from rest reaches.
            Ok(orbit) => {
                let rest = point.orbit().expect("what the motion from rest tends to");
                assert!(orbit.period() > 16 && orbit.is_stable(), "{what}");
                assert_eq!(
                    (orbit.period(), orbit.stops()),
                    (rest.period(), rest.stops()),
                    "{what}"
                );
                let (one, other) = (orbit.contact().amplitude(), rest.contact().amplitude());
                assert!((one / other - 1.0).abs() < 1e-9, "{what}: {one} {other}");
                left += 1;
            }
            Err(error) => assert_eq!(error, NoOrbit::Unstable, "{what}, from the fixed point"),
        }
    }
    println!(
        "{} unstable fixed points; from rest {longer} come to repeat after more than 16 cycles, {bounded} do not, \
         {beside} do not beside a stable state",
        points.len()
    );
    assert!(points.len() >= 4 && longer >= 1 && bounded + beside >= 3 && left <= longer);
}

/// Returns two relative displacements for each cycle of a run from rest: the displacement at the end of the cycle, and
/// the largest displacement at its events.
fn cycles(point: &Point, count: usize) -> Vec<(f64, f64)> {
    let mut run = point.system.simulation(point.r, point.beta).expect("a run");
    let one = |_| {
        let (mut left, mut largest) = (TAU, 0.0_f64);
        while left > 1e-12 {
            left -= run.advance(left).expect("a reach").length;
            largest = largest.max(run.relative().0.abs());
        }
        (run.relative().0, largest)
    };
    (0..count).map(one).collect()
}

/// Returns the change of a run from rest over `period` cycles, after the run has settled.
fn repeats(point: &Point, period: u32) -> f64 {
    let cycles = cycles(point, 6000);
    let (early, late) = cycles.split_at(cycles.len() - period as usize);
    let early = early.iter().rev().zip(late.iter().rev());
    early.fold(0.0, |most, (a, b)| most.max((a.0 - b.0).abs()))
}

/// Returns the largest relative displacement of a run from rest, over many cycles.
fn largest_seen(point: &Point) -> f64 {
    let cycles = cycles(point, 3000);
    cycles[2500..].iter().fold(0.0, |most, one| most.max(one.1))
}

/// Compares states with more segments in a cycle than emitted code can record.
#[test]
fn many_events() {
    let beyond = |point: &Point| {
        point.expected["segments"]
            .as_u64()
            .is_some_and(|count| count > 64)
    };
    let points = points(|point| beyond(point) && count(&point.expected["period"]) == 1);
    let mut tally = Tally::default();
    for point in &points {
        all_values(point, &mut tally);
    }
    println!("{} states of more than 64 segments", points.len());
    assert!(!points.is_empty());
    tally.end(bars);
}

/// Compares states that a motion approaches while its stops become ever shorter.
#[test]
fn marginal() {
    let points = points(|point| point.kind() == "marginal");
    let mut tally = Tally::default();
    for point in &points {
        let what = &point.what;
        let orbit = point
            .orbit()
            .unwrap_or_else(|error| panic!("{what}: {error}"));
        assert!(orbit.is_marginal() && orbit.is_stable(), "{what}");
        assert_eq!(orbit.stops(), 0, "{what}");
        assert!(
            number(&point.expected["stuck_fraction"]).abs() < 1e-6,
            "{what}"
        );
        assert!(number(&point.expected["known_to"]) < CONTINUED, "{what}");
        all_motions(&orbit, point, false, &mut tally);
    }
    println!("{} marginal states", points.len());
    assert!(points.len() >= 4);
    tally.end(|_| CONTINUED);
}

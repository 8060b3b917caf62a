//! Tests the search for a friction and one number of the description that together minimise the largest amplitude
//! over a band. The reference is a map by brute force. It builds a new description for each value, and computes the
//! non-dimensional groups itself.
//!
//! `case` has the chains. `brute_force` has the maps and the golden section searches.
//!
//! ```sh
//! cargo test --release -p generated-tests --test study tuned_optimum:: -- --include-ignored --nocapture
//! ```

mod brute_force;
mod case;
mod kept;
mod numbers;

use brute_force::{Tried, golden};
use case::{ABSORBER, BLOCK, FIRST_SPRING, SHARP};
use frictiongen::study::optimum::{
    FrequencyBand, OptimumError, OptimumKind, OptimumOptions, OptimumRequest, Tuning,
};
use frictiongen::study::response::MotionQuantity;
use std::time::Instant;

fn off(a: f64, b: f64) -> f64 {
    (a - b).abs() / a.abs().max(b.abs()).max(f64::MIN_POSITIVE)
}

/// Compares the optimum with the minimum near it over number and force, by nested golden section searches.
#[test]
#[ignore = "a million responses: minutes"]
fn two_masses_as_by_brute_force() {
    for (case, described, sharp) in [
        (&ABSORBER, 0.085, false),
        (&FIRST_SPRING, 1.0, false),
        (&SHARP, 0.1, true),
    ] {
        let start = Instant::now();
        let found = case.tuned(described);
        let tuned = found.tuned[0];
        let seconds = start.elapsed().as_secs_f64();
        assert!(!tuned.at_end, "{}: {}", case.name, tuned.value);
        let [force, amplitude] = case.physical(described, &found);
        let start = Instant::now();
        let mut count = 0;
        // The found value is not a point of the scan.
        let interval = [0.971, 1.032].map(|share| share * tuned.value);
        // The position of a flat minimum is known only to the square root of the rounding.
        let near = if sharp { 1e-10 } else { 1e-6 };
        let (value, least) = golden(interval, 6, near, |value| {
            let mut tried = Tried::new(case, value);
            let found = tried.least(force).1;
            count += tried.count;
            found
        });
        let (best, there) = Tried::new(case, tuned.value).least(force);
        let [in_value, in_force, in_amplitude, in_depth] = [
            off(tuned.value, value),
            off(force, best),
            off(amplitude, there),
            off(amplitude, least),
        ];
        println!(
            "{} = {} ({in_value:.1e} off), {force} N ({in_force:.1e} off), {amplitude} m ({in_amplitude:.1e} off, {in_depth:.1e} \
             from the least), {:?}; {} amplitudes in {seconds:.1} s, by brute force {count} in {:.0} s",
            case.name,
            tuned.value,
            found.kind,
            found.evaluations,
            start.elapsed().as_secs_f64()
        );
        assert!(in_force < 1e-6 && in_amplitude < 1e-9 && in_depth < 1e-9);
        assert!(in_value < if sharp { 1e-8 } else { 1e-4 });
    }
}

/// Compares the sharp case with its receptances: at both bounds of the band the undamped main mass has equal
/// amplitudes.
#[test]
#[ignore = "many optima: a minute without optimisation"]
fn sharp_as_by_receptances() {
    let found = SHARP.tuned(0.1);
    let tuned = found.tuned[0];
    let amplitude = |mass: f64, omega: f64| {
        let square = omega * omega;
        let (main, own) = (1.085 - square, 0.085 - mass * square);
        (own / (main * own - 0.085 * 0.085)).abs()
    };
    let higher = |mass: f64| {
        let [low, high] = SHARP.band.map(|omega| amplitude(mass, omega));
        low - high
    };
    let (mut a, mut b) = (0.1, 0.12);
    assert!(higher(a) * higher(b) < 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (a + b);
        if higher(a) * higher(middle) <= 0.0 {
            b = middle;
        } else {
            a = middle;
        }
    }
    let least = amplitude(a, SHARP.band[0]);
    println!("{} ({:.1e} off), {least}", tuned.value, off(tuned.value, a));
    assert_eq!(found.kind, OptimumKind::NoFriction);
    assert!(found.beta == 0.0 && off(tuned.value, a) < 1e-9);
    assert!(off(found.amplitude, least) < 1e-9);
}

/// Checks one mass. With a softer spring to its base it moves less, so the best value is the bound of the interval.
/// The friction there is that of a map. On a map of the whole interval no amplitude is smaller.
#[test]
fn one_mass_as_by_a_coarse_map() {
    one_mass([6, 8]);
}

/// Compares one mass with a map of a million responses.
#[test]
#[ignore = "a map of a million responses: a minute"]
fn one_mass_as_by_brute_force() {
    one_mass([16, 31]);
}

fn one_mass([values, forces]: [u32; 2]) {
    let found = BLOCK.tuned(1.0);
    let tuned = found.tuned[0];
    assert!(tuned.at_end && tuned.value == 0.1, "{}", tuned.value);
    let kind = found.kind;
    assert!(!matches!(kind, OptimumKind::Stuck | OptimumKind::Trivial));
    let [force, amplitude] = BLOCK.physical(1.0, &found);
    let mut tried = Tried::new(&BLOCK, tuned.value);
    let (best, least) = tried.least(force);
    let offs = [off(force, best), off(amplitude, least)];
    println!(
        "{force} N ({:.1e} off), {amplitude} m ({:.1e} off)",
        offs[0], offs[1]
    );
    assert!(offs[0] < 1e-6 && offs[1] < 1e-9, "{offs:?}");
    let mut count = 0;
    for place in 0..values {
        let value = 0.1 * 30.0_f64.powf(f64::from(place) / f64::from(values - 1));
        let mut tried = Tried::new(&BLOCK, value);
        for step in 0..forces {
            let share = f64::from(step) / f64::from(forces - 1);
            let there = tried.largest(0.12 * share * share);
            assert!(amplitude <= there * (1.0 + 1e-9), "{value}: {there}");
        }
        count += tried.count;
    }
    println!("nowhere less among {count} responses");
}

/// Checks that for each value the scan contains the result of `optimum`, in the units of the described scene. The
/// value of the varied number in the description does not matter.
#[test]
#[ignore = "many optima: half a minute without optimisation"]
fn whatever_is_described() {
    let [one, other] = [0.9, 1.1].map(|described| (described, FIRST_SPRING.tuned(described)));
    let [a, b] = [&one, &other].map(|(described, tuned)| FIRST_SPRING.physical(*described, tuned));
    assert!(off(one.1.tuned[0].value, other.1.tuned[0].value) < 1e-6);
    assert!(
        off(a[0], b[0]) < 1e-6 && off(a[1], b[1]) < 1e-12,
        "{a:?} {b:?}"
    );
    let point = one.1.scan[4];
    let system = FIRST_SPRING.system(point.value);
    let request = OptimumRequest {
        of: system.motion_named("a").expect("a"),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(
            FIRST_SPRING.band[0] / point.value.sqrt(),
            FIRST_SPRING.band[1] / point.value.sqrt(),
        ),
        load: None,
    };
    let there = system.optimum(&request).expect("an optimum");
    // The unit of β is P, and the unit of amplitudes is P/k₁.
    assert!(off(there.beta, point.beta) < 1e-7, "{there:?} {point:?}");
    let amplitude = there.amplitude * 0.9 / point.value;
    assert!(
        off(amplitude, point.amplitude) < 1e-10,
        "{amplitude} {point:?}"
    );
}

/// Checks that each senseless request gives its own error.
#[test]
fn what_makes_no_sense() {
    let system = ABSORBER.system(0.085);
    let request = OptimumRequest {
        of: system.motion_named("a").expect("a"),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(0.5, 1.6),
        load: None,
    };
    let of = system.tunable_named("k2").expect("a spring");
    assert_eq!(system.tunable_named(" k  b-a "), Ok(of));
    let tuned = |request: &OptimumRequest, from: f64, to: f64| {
        let vary = [Tuning { of, from, to }];
        let options = OptimumOptions {
            vary: &vary,
            ..OptimumOptions::default()
        };
        system.optimum_with(request, &options)
    };
    let asked = |from: f64, to: f64| tuned(&request, from, to).expect_err("nonsense");
    for (from, to) in [
        (0.2, 0.1),
        (0.1, 0.1),
        (f64::NAN, 1.0),
        (0.1, f64::INFINITY),
    ] {
        assert_eq!(asked(from, to), OptimumError::Interval, "{from} {to}");
    }
    for (from, to) in [(-0.1, 0.1), (0.0, 0.1), (0.1, 1e30)] {
        assert!(
            matches!(asked(from, to), OptimumError::Scene(_)),
            "{from} {to}"
        );
    }
    let unknown = system.tunable_named("k a - c").expect_err("no such spring");
    assert_eq!(
        unknown.known,
        [
            "m a",
            "m b",
            "k base - a",
            "k a - b",
            "mu",
            "zeta",
            "zeta 1",
            "zeta 2",
            "a",
            "b"
        ]
    );
    let band = OptimumRequest {
        band: FrequencyBand::Ratio(1.0, 1.0),
        ..request.clone()
    };
    let found = tuned(&band, 0.1, 0.2);
    assert_eq!(found.err(), Some(OptimumError::Width));
}

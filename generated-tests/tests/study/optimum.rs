//! Compares the friction that minimises the largest amplitude over a frequency band with maps by brute force.
//!
//! ```sh
//! cargo test --release -p generated-tests --test study optimum:: -- --ignored --nocapture
//! ```

use frictiongen::Of;
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::{
    InitialState, System,
    optimum::{FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumKind, OptimumRequest},
    units::Load,
};
use std::f64::consts::FRAC_PI_4;
use std::time::Instant;

/// Frame of the tour, a frame of two storeys.
const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, excitation: base,
    damping: modal[0.010, 0.012], stiction: 1.2 }";
/// One undamped mass that rubs on a wall.
const WALL: &str =
    "struct Wall { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall,
    excitation: block }";
/// An absorber mass that rubs on the main mass. The contact alone damps the resonances.
const ABSORBER: &str = "struct Absorber { masses: { a: 1.0, b: 0.1 },
    springs: { base - a: 1.0, a - b: 0.085 }, contact: a - b, excitation: a }";
/// One mass that rubs on the moving base.
const BLOCK: &str =
    "struct Block { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - base,
    excitation: base, damping: modal(0.02) }";

fn asked(text: &str, name: &str, from: f64, to: f64) -> (System, OptimumRequest) {
    let system: System = text.parse().expect("a valid scene");
    let request = OptimumRequest {
        of: system.motion_named(name).expect("a motion"),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(from, to),
        load: None,
    };
    (system, request)
}

fn amplitude(system: &System, of: Of, r: f64, beta: f64, count: &mut usize) -> f64 {
    *count += 1;
    let at = system.at(r).expect("in the domain");
    at.response(beta).map_or(f64::INFINITY, |response| {
        response.swing(of).expect("a motion").amplitude
    })
}

/// Returns the largest amplitude over a band by samples only. The function refines every interval of a grid that may
/// contain the maximum.
fn largest(system: &System, of: Of, [from, to]: [f64; 2], beta: f64, count: &mut usize) -> f64 {
    const GRID: usize = 600;
    let grid = |a: f64, b: f64, cells: usize| -> Vec<f64> {
        (0..=cells)
            .map(|place| a + (b - a) * place as f64 / cells as f64)
            .collect()
    };
    let places = grid(from, to, GRID);
    let values: Vec<f64> = places
        .iter()
        .map(|r| amplitude(system, of, *r, beta, count))
        .collect();
    let most = values.iter().copied().fold(0.0, f64::max);
    let mut best = most;
    for place in 0..=GRID {
        let (before, after) = (place.saturating_sub(1), (place + 1).min(GRID));
        let top = values[before] <= values[place] && values[after] <= values[place];
        if !top || values[place] < 0.9 * most {
            continue;
        }
        let (mut a, mut b) = (places[before], places[after]);
        while b - a > 1e-8 * b {
            let finer = grid(a, b, 20);
            let found = finer.iter().map(|r| amplitude(system, of, *r, beta, count));
            let (at, value) = found
                .enumerate()
                .max_by(|(_, x), (_, y)| x.total_cmp(y))
                .expect("places");
            best = best.max(value);
            (a, b) = (finer[at.saturating_sub(1)], finer[(at + 1).min(20)]);
        }
    }
    best
}

/// Returns the friction ratio with the smallest value of `largest`, and that value. The function samples 40 friction
/// ratios, then 40 near the best of these, and so on.
fn by_map(
    system: &System,
    of: Of,
    band: [f64; 2],
    [mut low, mut high]: [f64; 2],
) -> (f64, f64, usize) {
    let mut count = 0;
    let (mut best, mut least) = (f64::NAN, f64::INFINITY);
    // At the crossing of two peaks, the amplitude has the same relative error as the friction.
    while high - low > 2e-9 * high {
        let cell = (high - low) / 40.0;
        for place in 0..=40 {
            let beta = low + cell * f64::from(place);
            let value = largest(system, of, band, beta, &mut count);
            if value < least {
                (best, least) = (beta, value);
            }
        }
        (low, high) = ((best - 1.5 * cell).max(0.0), best + 1.5 * cell);
    }
    (best, least, count)
}

fn optimum(system: &System, request: &OptimumRequest) -> (Optimum, f64) {
    let start = Instant::now();
    let optimum = system.optimum(request).expect("an optimum");
    (optimum, start.elapsed().as_secs_f64())
}

/// Checks an optimum at which two peaks cross. The peaks are equal to rounding. With more friction one peak falls and
/// the other peak rises, so every other friction is worse.
#[test]
fn two_equal_peaks() {
    let (system, request) = asked(ABSORBER, "a", 0.75, 1.25);
    let (optimum, seconds) = optimum(&system, &request);
    assert_eq!(optimum.kind, OptimumKind::EqualPeaks);
    assert_eq!(optimum.peaks.len(), 2);
    let [a, b] = [optimum.peaks[0], optimum.peaks[1]];
    assert!((a.amplitude - b.amplitude).abs() < 1e-12 * a.amplitude);
    let slopes = [a, b].map(|peak| peak.slope.expect("a derivative"));
    assert!(slopes[0] * slopes[1] < 0.0, "{slopes:?}");
    let mut count = 0;
    for share in [1.0 - 1e-4, 1.0 + 1e-4] {
        let beside = largest(
            &system,
            request.of,
            [0.75, 1.25],
            optimum.beta * share,
            &mut count,
        );
        assert!(optimum.amplitude < beside, "{share}: {beside}");
    }
    // Without damping the amplitude is unbounded in two cases: without friction, and while the contact is stuck.
    assert!(optimum.without_friction.is_infinite() && optimum.with_contact_locked.is_infinite());
    assert!(optimum.locked.is_infinite());
    println!(
        "β = {}, {}, peaks at {} and {}; {} amplitudes in {seconds:.2} s",
        optimum.beta, optimum.amplitude, a.r, b.r, optimum.evaluations
    );
}

/// Checks three floors on an isolator with stiction under a base acceleration of 0.1 g. At the best friction, two peaks of
/// the roof's acceleration are equally high: one near the resonance of the isolator, one near a resonance of the floors. With 3 % more or less friction, and over a coarse map, the largest acceleration is higher.
#[test]
fn an_isolator_of_three_floors() {
    let text = "struct Isolated { masses: { first: 558201, second: 485438, roof: 378684 },
        springs: { base - first: 6.1635e6, first - second: 3.1086e8, second - roof: 3.4075e8 },
        contact: base - first, excitation: base, damping: modal(0.024), damping_from: base, stiction: 1.3 }";
    let system: System = text.parse().expect("a valid scene");
    let of = system.motion_named("roof").expect("a mass");
    let level = 0.980_665;
    let request = OptimumRequest {
        of,
        size: MotionQuantity::Acceleration,
        band: FrequencyBand::Hertz(0.2, 3.0),
        load: Some(Load::BaseAcceleration(level)),
    };
    let (optimum, seconds) = optimum(&system, &request);
    println!(
        "β = {}, {} in {seconds:.1} s",
        optimum.beta, optimum.amplitude
    );
    assert_eq!(optimum.kind, OptimumKind::EqualPeaks);
    let [from, to] = [0.2, 3.0].map(|hertz| system.frequency_ratio_at_hertz(hertz));
    // The amplitude of the base and its friction ratio change with frequency: Y = a/ω², β = F/(k₁Y).
    let largest = |friction: f64, frequencies: u32| {
        let places = (0..=frequencies).map(|place| f64::from(place) / f64::from(frequencies));
        let values = places.map(|place| {
            let r = from * (to / from).powf(place);
            let response = system.at(r).expect("r").response(friction * r * r);
            let value = response
                .expect("a motion")
                .largest(of, MotionQuantity::Acceleration);
            value.expect("an acceleration")
        });
        values.fold(0.0, f64::max)
    };
    let best = largest(optimum.beta, 1500);
    assert!((best / optimum.amplitude - 1.0).abs() < 2e-3, "{best}");
    for share in [0.3, 0.5, 0.7, 0.9, 0.97, 1.03, 1.1, 1.4, 2.0, 4.0] {
        let other = largest(share * optimum.beta, 300);
        assert!(optimum.amplitude < other, "{share}: {other}");
    }
}

/// Checks the frame in a band that ends just below its second resonance. At the best friction the largest amplitude
/// must not be above that at neighbouring friction ratios, where steady states with stops appear and disappear.
#[test]
#[ignore = "a sweep, ten seconds or more: .ci/nightly"]
fn where_steady_states_jump() {
    let (system, request) = asked(FRAME, "lower", 0.33, 1.3);
    let (optimum, seconds) = optimum(&system, &request);
    println!(
        "β = {}, {}, {:?}; {} amplitudes in {seconds:.2} s",
        optimum.beta, optimum.amplitude, optimum.kind, optimum.evaluations
    );
    let mut count = 0;
    for place in 0..=40 {
        let beta = 0.52 + 0.0005 * f64::from(place);
        let there = largest(&system, request.of, [0.33, 1.3], beta, &mut count);
        assert!(optimum.amplitude <= there * (1.0 + 1e-9), "{beta}: {there}");
    }
}

/// Checks one mass on a moving base, with motion from rest. With more friction it sticks off the centre of the base,
/// farther off at low frequencies. With less friction it resonates. Friction slightly above or below the best is
/// worse. Without an initial state, a stuck mass moves with the base, and the amplitude Y is the least.
#[test]
fn one_mass_between_its_resonance_and_its_offset() {
    let (system, request) = asked(BLOCK, "a", 0.3, 2.0);
    let middle = system.optimum(&request).expect("an optimum");
    let locked = middle.with_contact_locked;
    assert!((middle.amplitude - 1.0).abs() < 1e-12 && (locked - 1.0).abs() < 1e-12);
    let system = system.starting_from(InitialState::rest(1));
    let (optimum, _) = optimum(&system, &request);
    assert_eq!(optimum.kind, OptimumKind::EqualPeaks);
    assert_eq!(optimum.end, OptimumEnd::Converged);
    // If the mass sticks from the start, when the base is at its maximum, it moves between 0 and −2Y.
    assert!((optimum.with_contact_locked - 2.0).abs() < 1e-12);
    let mut count = 0;
    for share in [0.5, 0.99, 1.01, 2.0] {
        let beside = largest(
            &system,
            request.of,
            [0.3, 2.0],
            optimum.beta * share,
            &mut count,
        );
        assert!(optimum.amplitude < beside, "{share}: {beside}");
    }
}

/// Checks one undamped mass that rubs on a wall. Its resonance is unbounded for β < π/4 and bounded for β > π/4. From
/// β = 1 on the mass is at rest. For β just below 1 the motions are too small to settle, and the search leaves them
/// out.
#[test]
fn an_undamped_mass_is_held() {
    let (system, request) = asked(WALL, "block", 0.5, 1.5);
    let (optimum, _) = optimum(&system, &request);
    assert_eq!(optimum.kind, OptimumKind::Trivial);
    assert!((optimum.beta - 1.0).abs() < 1e-12 && optimum.amplitude == 0.0);
    assert!((optimum.unbounded_to - FRAC_PI_4).abs() < 1e-15);
    assert!(optimum.without_friction.is_infinite() && optimum.with_contact_locked == 0.0);
    assert!(optimum.evaluations < 20_000, "{}", optimum.evaluations);
    let mut count = 0;
    let mut at = |beta: f64| amplitude(&system, request.of, 1.0, beta, &mut count);
    assert!(at(FRAC_PI_4 * (1.0 - 1e-9)).is_infinite());
    assert!(at(FRAC_PI_4 * (1.0 + 1e-9)).is_finite());
}

/// Checks one mass that rubs on its base and has a spring to a wall. The best friction is a 250th of the friction
/// from which the contact sticks. The minimum is between two steps of the scan over friction. At the upper step the
/// maximum over frequency is flat, so the tangents at both steps do not cross between the steps.
#[test]
fn a_least_that_a_scan_hides() {
    let text =
        "struct Block { masses: { block: 1 }, springs: { base - block: 0.1, block - wall: 1 },
        contact: block - base, excitation: base, damping: modal(0.05) }";
    let band = [0.95, 11.0];
    let (system, request) = asked(text, "block", band[0], band[1]);
    let (optimum, seconds) = optimum(&system, &request);
    let (beta, least, count) = by_map(&system, request.of, band, [0.3, 0.7]);
    println!(
        "β = {}, {}; by a map {beta}, {least}; {} amplitudes in {seconds:.2} s, by a map {count}",
        optimum.beta, optimum.amplitude, optimum.evaluations
    );
    assert!(
        (optimum.beta / beta - 1.0).abs() < 1e-6 && (optimum.amplitude / least - 1.0).abs() < 1e-9
    );
}

/// Returns a chain of three masses, of which the middle mass rubs. If both halves are equal, the contact does not touch
/// the second mode.
fn chain(last: f64) -> String {
    format!(
        "struct Chain {{ masses: {{ a: 1, b: 1, c: 1 }}, contact: b - wall, excitation: a,
        springs: {{ base - a: 1, a - b: 1, b - c: 1, c - wall: {last:?} }} }}"
    )
}

/// Checks a mode that neither damping nor the contact dissipates. It is unbounded at every friction, whatever the
/// band is.
#[test]
fn a_mode_that_the_contact_does_not_touch() {
    for [from, to] in [[1.2, 1.6], [0.3, 0.5]] {
        let (system, request) = asked(&chain(1.0), "a", from, to);
        let found = system.optimum(&request);
        assert_eq!(found.err(), Some(OptimumError::Undamped(1)));
    }
}

/// Checks a search with a bound on its work. The contact hardly moves one mode, so hundreds of motions do not settle.
/// The search returns the best friction that it has found.
#[test]
#[ignore = "all the work that is allowed: some seconds"]
fn a_search_whose_work_is_bounded_keeps_the_best() {
    let (system, request) = asked(&chain(1.001), "a", 1.41, 1.42);
    let start = Instant::now();
    let found = system.optimum(&request);
    println!("{found:?} after {:.1} s", start.elapsed().as_secs_f64());
    let found = found.expect("the best so far");
    assert!(found.amplitude.is_finite() && found.bracket[0] <= found.beta);
}

/// Compares the frame of the tour and the absorber with maps.
#[test]
#[ignore = "maps of a million responses: some minutes"]
fn as_by_brute_force() {
    for (text, name, band, window) in [
        (FRAME, "lower", [0.3, 2.0], [0.0, 8.0]),
        (ABSORBER, "a", [0.5, 1.6], [0.1, 0.6]),
    ] {
        let (system, request) = asked(text, name, band[0], band[1]);
        let (optimum, seconds) = optimum(&system, &request);
        let start = Instant::now();
        let (beta, least, count) = by_map(&system, request.of, band, window);
        let longer = start.elapsed().as_secs_f64();
        let (force, height) = (
            (optimum.beta / beta - 1.0).abs(),
            (optimum.amplitude / least - 1.0).abs(),
        );
        println!(
            "{name}: β = {} ({force:.1e} off), {} ({height:.1e} off); {} amplitudes in {seconds:.2} s, by maps {count} in \
             {longer:.2} s: {:.0} times as long",
            optimum.beta,
            optimum.amplitude,
            optimum.evaluations,
            longer / seconds
        );
        assert!(force < 1e-6 && height < 1e-9, "{beta} {least}");
    }
}

//! Tests motions exactly on the boundary between two sequences of events: at the limit of sticking, from a start at
//! the break-away level, with two equal maxima, and with a stop of zero length.

use frictiongen::System;
use frictiongen::kernel::simulation::{Contact, Event};
use frictiongen::study::orbit::SystemOrbit;
use std::f64::consts::{PI, TAU};

fn system(text: &str) -> System {
    text.parse().expect("a scene")
}

fn block(rest: &str) -> System {
    system(&format!(
        "struct Block {{ masses: {{ block: 1 }}, springs: {{ base - block: 1 }},
        contact: block - wall, excitation: block, {rest} }}"
    ))
}

/// Checks a stuck contact whose force is cos τ. At μβ = 1 the force just reaches the break-away level once in each
/// half cycle. The contact must never slide.
#[test]
fn at_the_level_exactly() {
    let mut seen = 0;
    for (mu, beta) in [("1", 1.0), ("2", 0.5), ("1.25", 0.8), ("4", 0.25)] {
        let wall = block(&format!("stiction: {mu}"));
        for r in [0.1, 0.37, 0.9, 1.0, 2.6] {
            let mut run = wall.simulation(r, beta).expect("in the domain");
            while run.run().cycles() < 200 {
                let segment = run.next().expect("it never ends");
                assert_eq!(
                    (segment.contact, segment.event),
                    (Contact::Stuck, None),
                    "μ = {mu}, r = {r}"
                );
            }
            assert_eq!(run.mass("block").expect("a mass").displacement(), 0.0);
            seen += 1;
        }
    }
    println!("{seen} runs of 200 cycles at the level, none skipped");
}

/// Checks a motion without friction whose relative velocity touches zero but keeps its sign. The touch must not count
/// as a reversal.
///
/// At r = 1/2, x̄ = 4/3 (cos τ − ½ sin 2τ) has x̄′ = −4/3 (sin τ + cos 2τ) = −4/3 (1 − sin τ)(1 + 2 sin τ). This
/// velocity has a zero of second order at π/2, and simple zeros at 7π/6 and 11π/6.
#[test]
fn a_velocity_that_touches_zero() {
    let wall = block("");
    let size = 4.0 / 3.0;
    let start = ([size], [-size]);
    let run = wall.simulation_from(0.5, 0.0, (&start.0, &start.1));
    let mut run = run.expect("in the domain");
    let (mut reversals, mut phase) = (0, 0.0);
    for _ in 0..400 {
        let segment = run.next().expect("it never ends");
        phase += segment.length;
        if segment.event == Some(Event::Reversal) {
            let within = phase.rem_euclid(TAU);
            let [first, second] = [7.0, 11.0].map(|sixths| (within - sixths * PI / 6.0).abs());
            // The tolerance allows for the rounding of a sum of 400 lengths.
            assert!(first.min(second) < 1e-9, "a reversal at {within}");
            reversals += 1;
        } else {
            assert_eq!(segment.event, None);
        }
    }
    let cycles = run.run().cycles();
    println!("{reversals} reversals in {cycles} cycles, each compared");
    assert!(cycles >= 100 && reversals + 1 >= 2 * cycles && reversals <= 2 * cycles + 2);
}

/// Checks a start whose contact force is exactly at the break-away level, with zero slope, and then grows. Because of
/// rounding the contact may seem to stay stuck at first, but it must slide.
#[test]
fn from_the_level_itself() {
    let pair = system(
        "struct Pair { masses: { a: 1, b: 1 }, springs: { base - a: 1, a - b: 1 },
        contact: a - wall, excitation: b }",
    );
    let mut compared = 0;
    for (r, beta) in [
        (0.7, 0.25),
        (0.7, 0.3),
        (1.3, 0.1),
        (0.4, 0.6),
        (2.1, 0.45),
        (0.9, 0.7),
    ] {
        // The contact force is F = x̄_b − 2x̄_a. It grows, because x̄_b″ = (1 − x̄_b)/r² > 0.
        let mut lengths: Vec<Vec<f64>> = Vec::new();
        for velocity in [0.0, 1e-18, -1e-18, 3e-17, -3e-17, 1e-16, 1e-9] {
            let what = format!("r = {r}, β = {beta}, from {velocity:e}");
            let start = ([0.0, beta], [0.0, velocity]);
            let mut run = pair
                .simulation_from(r, beta, (&start.0, &start.1))
                .expect("in the domain");
            let mut found = Vec::new();
            let mut tries = 0;
            while found.len() < 6 {
                let segment = run.next().expect("it never ends");
                tries += 1;
                // The event at the end of a segment must match the state of the contact in the segment.
                let stuck = segment.contact == Contact::Stuck;
                assert_eq!(
                    segment.event == Some(Event::Slip),
                    stuck,
                    "{what}: {segment:?}"
                );
                assert!(tries < 100, "{what}: it does not come away");
                if segment.length > 1e-3 {
                    found.push(segment.length);
                }
            }
            lengths.push(found);
        }
        // A change of the start velocity by 1e-9 changes the first segment by the same order. The divergence of the
        // motions multiplies this change for later segments.
        let last = lengths.pop().expect("a run");
        for other in &lengths {
            for (a, b) in other.iter().zip(&last) {
                assert!((a - b).abs() < 1e-6, "r = {r}, β = {beta}: {a} against {b}");
                compared += 1;
            }
        }
    }
    println!("{compared} lengths compared, none skipped");
    assert_eq!(compared, 6 * 6 * 6);
}

/// Checks a stop whose middle coincides with the minimum of the load. The beginning and the end of the stop have lags of
/// equal size with opposite signs. The phase must be the lag of the beginning.
#[test]
fn a_stop_has_the_lag_of_its_beginning() {
    let chain = system(
        "struct Chain { masses: { a: 1, b: 2.289, c: 1.466 },
        springs: { base - a: 1, a - b: 1.526, b - c: 1.69 }, contact: a - wall, excitation: b,
        damping: modal[0.02019, 0.2092, 0.004776], stiction: 3 }",
    );
    let at = chain.at(0.617).expect("in the domain");
    let orbit = |beta: f64| at.orbit(beta).expect("a steady state");
    // The closure returns the start of the stop at the largest z̄, and the distance of the stop's middle from π.
    let stop = |orbit: &SystemOrbit<'_>| {
        let positive =
            |start: f64| orbit.contact().displacement(start + 1e-3 - orbit.origin()) > 0.0;
        let mut intervals = orbit.sticking_intervals();
        let (start, length) = intervals
            .find(|(start, _)| positive(*start))
            .expect("a stop");
        let start = start.rem_euclid(TAU);
        (start, start + length * 0.5 - PI)
    };
    let (mut low, mut high) = (0.15, 0.45);
    let (at_low, at_high) = (stop(&orbit(low)).1, stop(&orbit(high)).1);
    assert!(
        at_low * at_high < 0.0,
        "{at_low} at {low}, {at_high} at {high}"
    );
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if (stop(&orbit(middle)).1 < 0.0) == (at_low < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let found = orbit(low);
    let (start, past) = stop(&found);
    println!("β = {low}: a stop from {start}, its middle {past:e} past π");
    assert!(past.abs() < 1e-12 && start < PI - 0.1);
    for motion in [found.contact(), found.mass_at(0).expect("a mass")] {
        assert!(
            (motion.phase() - start).abs() < 1e-9,
            "{} instead of {start}",
            motion.phase()
        );
    }
}

/// Checks that with μ = 1 every start, and every section at which the search cuts the motion, leads to the same
/// steady state. Some of the tested stops are shorter than 1/1000 rad in τ.
#[test]
fn a_short_stop_from_anywhere() {
    let wall = block("damping: modal(0.02)");
    let at = wall.at(0.6).expect("in the domain");
    let stuck = |beta: f64| at.orbit(beta).expect("a steady state").stuck_fraction() * TAU / 2.0;
    // Just above β_lim the stop is arbitrarily short.
    let (mut low, mut high) = (at.continuous_limit(), at.continuous_limit() * 1.05);
    assert!(stuck(low * (1.0 - 1e-9)) == 0.0 && stuck(high) > 1e-3);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if stuck(middle) < 8e-4 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let beta = low;
    let expected = at.orbit(beta).expect("a steady state");
    println!(
        "β = {beta}: stops of {}, {} stops",
        stuck(beta),
        expected.stops()
    );
    assert!(stuck(beta) > 1e-4 && expected.stops() >= 2);
    let mut compared = 0;
    for k in 0..60_000_u32 {
        let angle = f64::from(k) * 2.399_963;
        let size = 0.05 + 8.0 * f64::from(k) / 60_000.0;
        let state = ([size * angle.cos()], [size * angle.sin()]);
        let orbit = at
            .orbit_from(beta, (&state.0, &state.1))
            .expect("a steady state");
        let counts = (orbit.stops(), orbit.reversals());
        assert_eq!(
            counts,
            (expected.stops(), expected.reversals()),
            "from {state:?}"
        );
        let apart = (orbit.stuck_fraction() - expected.stuck_fraction()).abs();
        // The length of a short stop is the square root of a difference, so its tolerance is wide.
        assert!(apart < 1e-9, "from {state:?}: {apart:e}");
        compared += 1;
    }
    println!("{compared} starts, none skipped");
    assert_eq!(compared, 60_000);
}

/// Checks that a block without friction follows 1/(1 − r² + 2iζr). Very near the resonance the motion is computed
/// from differences; there the check counts too.
#[test]
fn next_to_a_resonance_without_friction() {
    let mut compared = 0;
    for zeta in [1e-6, 1e-3, 0.008, 0.04] {
        let wall = block(&format!("damping: modal[{zeta}]"));
        for r in [0.99, 0.999, 1.0 - 1e-9, 1.0, 1.0 + 1e-6, 1.004, 1.05] {
            let orbit = wall.at(r).expect("in the domain").orbit(0.0);
            let orbit = orbit.unwrap_or_else(|error| panic!("ζ = {zeta}, r = {r}: {error}"));
            let mass = orbit.mass_at(0).expect("a mass");
            let (re, im) = ((1.0 - r) * (1.0 + r), 2.0 * zeta * r);
            let (size, lag) = (1.0 / re.hypot(im), im.atan2(re));
            // ζ and r are rounded to 1.1e-16, and the detuning is a product of rounded numbers.
            let budget = 1e-12_f64.max(4e-16 * size);
            assert!(
                (mass.amplitude() - size).abs() < budget * size,
                "ζ = {zeta}, r = {r}: {} instead of {size}",
                mass.amplitude()
            );
            assert!(
                (mass.phase() - lag).abs() < budget.max(1e-9),
                "ζ = {zeta}, r = {r}: {} instead of {lag}",
                mass.phase()
            );
            compared += 1;
        }
    }
    println!("{compared} motions compared, none skipped");
    assert_eq!(compared, 28);
}

/// Checks that a mode that the contact does not touch keeps its own steady motion in stops, in slips and in sticking.
#[test]
fn a_mode_that_the_contact_does_not_touch() {
    let pair = system(
        "struct Pair { masses: { left: 1, right: 1 },
        springs: { base - left: 1, left - right: 0.7, right - wall: 1 },
        contact: left - right, excitation: left, damping: modal(0.08) }",
    );
    let mut worst: f64 = 0.0;
    let points = [(0.6, 0.05), (0.6, 0.2), (1.3, 0.15), (0.9, 5.0), (0.7, 0.0)];
    for (r, beta) in points {
        let orbit = pair.at(r).expect("in the domain").orbit(beta);
        let orbit = orbit.expect("a steady state");
        // The symmetric motion of both masses under a unit load on one mass is x̄₁ + x̄₂ = cos τ/(1 − r² + 2iζr).
        let answer = frictiongen::Complex::new(1.0 - r * r, 0.16 * r).inv();
        for step in 0..40 {
            let tau = TAU * f64::from(step) / 40.0;
            let angle = tau + orbit.origin();
            let both = ["left", "right"].map(|name| orbit.mass(name).expect("a mass"));
            let sum = both[0].displacement(tau) + both[1].displacement(tau);
            let expected = answer.re * angle.cos() - answer.im * angle.sin();
            worst = worst.max((sum - expected).abs());
        }
    }
    println!("{} displacements, {worst:e} off", 40 * points.len());
    assert!(worst < 1e-13, "{worst:e}");
}

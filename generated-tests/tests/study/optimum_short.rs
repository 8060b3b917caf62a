//! Compares the best friction with maps near it, and tests the counts in the result of the search.

use frictiongen::Of;
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::{
    System,
    optimum::{FrequencyBand, Optimum, OptimumKind, OptimumRequest},
    sensitivity::{Parameter, Quantity},
    units::Load,
};

fn optimum(text: &str, name: &str, band: [f64; 2]) -> (System, Of, Optimum) {
    let system: System = text.parse().expect("a valid scene");
    let of = system.motion_named(name).expect("a motion");
    let request = OptimumRequest {
        of,
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(band[0], band[1]),
        load: None,
    };
    let optimum = system.optimum(&request).expect("an optimum");
    (system, of, optimum)
}

/// Returns the largest amplitude at 2001 frequencies of a band. Golden section search refines each maximum.
fn largest(system: &System, of: Of, band: [f64; 2], beta: f64) -> f64 {
    largest_of::<2000>(system, of, band, beta)
}

fn largest_of<const CELLS: u32>(system: &System, of: Of, [from, to]: [f64; 2], beta: f64) -> f64 {
    let at = |r: f64| {
        let at = system.at(r).expect("in the domain");
        let response = at.response(beta);
        response.map_or(f64::INFINITY, |response| {
            response.swing(of).expect("a motion").amplitude
        })
    };
    let place = |i: u32| from + (to - from) * f64::from(i) / f64::from(CELLS);
    let values: Vec<f64> = (0..=CELLS).map(|i| at(place(i))).collect();
    let mut best = values.iter().copied().fold(0.0, f64::max);
    for i in 1..CELLS {
        let [before, here, after] = [i - 1, i, i + 1].map(|place| values[place as usize]);
        if here < before || here < after || here < 0.99 * best {
            continue;
        }
        let (mut low, mut high) = (place(i - 1), place(i + 1));
        for _ in 0..30 {
            let step = 0.381_966 * (high - low);
            let (a, b) = (low + step, high - step);
            if at(a) < at(b) { low = a } else { high = b }
        }
        best = best.max(at(0.5 * (low + high)));
    }
    best
}

/// Checks an absorber that rubs on the main mass. Friction slightly above or below the best raises the largest
/// amplitude, as the tangents of both peaks predict. Between half and twice the best friction, no friction is better.
#[test]
fn absorber_as_by_a_map() {
    let text = "struct Absorber { masses: { a: 1.0, b: 0.1 },
        springs: { base - a: 1.0, a - b: 0.085 }, contact: a - b, excitation: a }";
    let band = [0.75, 1.25];
    let (system, of, optimum) = optimum(text, "a", band);
    let there = largest(&system, of, band, optimum.beta);
    // Golden section search finds the frequency of a flat maximum to 1e-9, which is no error in its height.
    assert!((there / optimum.amplitude - 1.0).abs() < 1e-12, "{there}");
    for step in 1..=8 {
        for share in [
            1.0 + 0.125 * f64::from(step),
            1.0 - 0.0625 * f64::from(step),
        ] {
            let other = largest(&system, of, band, share * optimum.beta);
            assert!(optimum.amplitude < other, "{share}: {other}");
        }
    }
    for share in [1.0 - 1e-5, 1.0 + 1e-5] {
        let other = largest(&system, of, band, share * optimum.beta);
        let by = (share - 1.0) * optimum.beta;
        let slopes = optimum.peaks.iter().filter_map(|peak| peak.slope);
        let expected = slopes.map(|slope| slope * by).fold(0.0, f64::max);
        // The curvature of a peak changes the difference by a relative 1e-5.
        let found = other - optimum.amplitude;
        assert!(
            (found / expected - 1.0).abs() < 1e-3,
            "{found} for {expected}"
        );
    }
}

/// Checks that a resonance below the band does not make the amplitudes in the band unbounded.
#[test]
fn a_resonance_below_the_band() {
    let text = "struct Pair { masses: { a: 1, b: 1 }, springs: { base - a: 1, a - b: 1 },
        contact: b - wall, excitation: a }";
    let (system, _, found) = optimum(text, "a", [1.7, 3.0]);
    assert!(system.resonances().iter().all(|r| *r < 1.7));
    assert_eq!(found.unbounded_to, 0.0);
    let (system, _, found) = optimum(text, "a", [1.3, 3.0]);
    let thresholds = system.resonance_thresholds();
    assert_eq!(Some(found.unbounded_to), thresholds[1]);
}

/// Checks that at both ends of a tolerance range the largest amplitude exceeds the best amplitude by the stated
/// percentage.
#[test]
fn tolerances_end_at_their_excess() {
    let text = "struct Absorber { masses: { a: 1.0, b: 0.1 },
        springs: { base - a: 1.0, a - b: 0.085 }, contact: a - b, excitation: a }";
    let band = [0.75, 1.25];
    let (system, of, optimum) = optimum(text, "a", band);
    let excesses: Vec<f64> = optimum.tolerances.iter().map(|one| one.excess).collect();
    assert_eq!(excesses, [0.01, 0.05, 0.1]);
    for tolerance in &optimum.tolerances {
        let level = optimum.amplitude * (1.0 + tolerance.excess);
        assert!(tolerance.from < optimum.beta && optimum.beta < tolerance.to);
        for end in [tolerance.from, tolerance.to] {
            // An end is known to 1e-8 of β. The relative change of the amplitude is a few times as large.
            let there = largest_of::<200>(&system, of, band, end);
            assert!((there / level - 1.0).abs() < 1e-6, "{tolerance:?}: {there}");
        }
    }
}

/// Checks the derivative of the optimum at two equal peaks. It includes the change of the best friction, so it must
/// equal the difference quotient of the optima of neighbouring absorbers.
#[test]
fn sensitivities_of_two_equal_peaks() {
    let solved = |mass: f64| {
        let text = format!(
            "struct Absorber {{ masses: {{ a: 1.0, b: {mass:?} }},
             springs: {{ base - a: 1.0, a - b: 0.085 }}, contact: a - b, excitation: a }}"
        );
        let system: System = text.parse().expect("a valid scene");
        let request = OptimumRequest {
            of: Of::Mass(0),
            size: MotionQuantity::Displacement,
            band: FrequencyBand::Ratio(0.75, 1.25),
            load: Some(Load::Force(2.0)),
        };
        system.optimum(&request).expect("an optimum")
    };
    let (mass, step) = (0.1, 1e-5);
    let (here, heavier) = (solved(mass), solved(mass * (1.0 + step)));
    assert_eq!(here.kind, OptimumKind::EqualPeaks);
    let expected = (heavier.amplitude / here.amplitude).ln() / step;
    let parameter = Parameter::Quantity(Quantity::Mass(1));
    let mut all = here.sensitivities.iter();
    let found = all.find(|(of, _)| *of == parameter);
    let (_, found) = found.expect("a derivative");
    // The difference quotient has an error of its step times a second derivative of about ten.
    assert!((found - expected).abs() < 1e-4, "{found} for {expected}");
}

/// Checks that with μ > 1 the stuck state begins at a friction ratio below the limit of the closed form. A mass on a
/// moving base sticks from that lower friction ratio on.
#[test]
fn nothing_sticks_below_the_lower_limit() {
    let text = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
        contact: block - base, excitation: base, stiction: 2 }";
    let (_, _, found) = optimum(text, "block", [1.1, 1.5]);
    // The expected value is β*_lim = r²/μ.
    let expected = 1.1 * 1.1 / 2.0;
    assert!(
        (found.free_of_sticking - expected).abs() < 1e-12,
        "{} for {expected}",
        found.free_of_sticking
    );
}

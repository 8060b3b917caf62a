//! The best friction against maps near by, and what its answer counts.

use frictiongen::Of;
use frictiongen::study::{FrequencyBand, Optimum, OptimumRequest, System};

fn optimum(text: &str, name: &str, band: [f64; 2]) -> (System, Of, Optimum) {
    let system: System = text.parse().expect("a valid scene");
    let of = system.motion_named(name).expect("a motion");
    let request = OptimumRequest {
        of,
        band: FrequencyBand::Ratio(band[0], band[1]),
        load: None,
    };
    let optimum = system.optimum(&request).expect("an optimum");
    (system, of, optimum)
}

/// The largest amplitude at 2001 frequencies of a band, each top made sharp by golden sections.
fn largest(system: &System, of: Of, [from, to]: [f64; 2], beta: f64) -> f64 {
    let at = |r: f64| {
        let at = system.at(r).expect("in the domain");
        let response = at.response(beta);
        response.map_or(f64::INFINITY, |response| {
            response.swing(of).expect("a motion").amplitude
        })
    };
    let place = |i: u32| from + (to - from) * f64::from(i) / 2000.0;
    let values: Vec<f64> = (0..=2000).map(|i| at(place(i))).collect();
    let mut best = values.iter().copied().fold(0.0, f64::max);
    for i in 1..2000_u32 {
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

/// A mass that rubs on the main one: friction a little more or less makes the largest amplitude larger, by as much as the tangents
/// of both peaks say, and from half to twice the friction nothing is better.
#[test]
fn absorber_as_by_a_map() {
    let text = "struct Absorber { masses: { a: 1.0, b: 0.1 },
        springs: { base - a: 1.0, a - b: 0.085 }, contact: a - b, excitation: a }";
    let band = [0.75, 1.25];
    let (system, of, optimum) = optimum(text, "a", band);
    let there = largest(&system, of, band, optimum.beta);
    // Golden sections leave 1e-9 of a flat top, and nothing of its height.
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
        // Curvature adds 1e-5 of it.
        let found = other - optimum.amplitude;
        assert!(
            (found / expected - 1.0).abs() < 1e-3,
            "{found} for {expected}"
        );
    }
}

/// A resonance below the band does not make the band's amplitudes unbounded.
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

//! Features of a response with an elastic contact: resonances of the stuck chain, ranges in which the contact slides, and
//! peaks.

use frictiongen::study::features::InvariantQuantity;
use frictiongen::study::sensitivity::{Parameter, Quantity};
use frictiongen::study::{System, features::Certainty};
use frictiongen::{Of, Regime};

/// Chains with the three kinds of contacts, of one to three masses. `K` stands for the stiffness of the contact.
const SCENES: [&str; 4] = [
    "struct One { masses: { a: 2.0 }, springs: { base - a: 50.0 }, contact: a - wall, stiffness: K, excitation: a,
        provide: [orbit] }",
    "struct Two { masses: { a: 3.27, b: 3.25 }, springs: { base - a: 1190.0, a - b: 1323.0 }, contact: b - wall,
        stiffness: K, excitation: base, damping: modal[0.01, 0.012], provide: [orbit] }",
    "struct Three { masses: { a: 1.0, b: 2.0, c: 1.5 }, springs: { base - a: 100.0, a - b: 150.0, b - c: 80.0 },
        contact: a - c, stiffness: K, excitation: b, provide: [orbit] }",
    "struct Moving { masses: { a: 1.0, b: 2.0 }, springs: { base - a: 100.0, a - b: 150.0 }, contact: b - base,
        stiffness: K, excitation: base, damping: rayleigh(0.1, 1e-3), provide: [orbit] }",
];

fn systems() -> impl Iterator<Item = System> {
    SCENES.into_iter().flat_map(|text| {
        ["20.0", "150.0", "4.0e3"]
            .map(|k| text.replace(": K,", &format!(": {k},")).parse().unwrap())
    })
}

/// Without damping the stuck chain is a chain with one more spring, whose resonances are found without a contact.
#[test]
fn the_stuck_chain_has_one_more_spring() {
    let plain =
        "struct Chain { masses: { a: 3.27, b: 3.25 }, springs: { base - a: 1190.0, a - b: 1323.0";
    let rest = "excitation: base }";
    for k in ["1.0e-2", "700.0", "2.0e6"] {
        let elastic: System =
            format!("{plain} }}, contact: b - wall, stiffness: {k}, provide: [orbit], {rest}")
                .parse()
                .unwrap();
        let braced: System = format!("{plain}, b - wall: {k} }}, contact: b - wall, {rest}")
            .parse()
            .unwrap();
        let found = elastic.features(None).unwrap().held_resonances();
        assert_eq!(found.len(), 2);
        for (held, exact) in found.iter().zip(braced.resonances()) {
            assert!(held.new);
            // The two results come from double-double arithmetic, rounded once.
            assert!(
                (held.r / exact - 1.0).abs() < 4e-16,
                "{k}: {} {exact}",
                held.r
            );
        }
    }
}

/// The ranges of sliding end where β*_lim equals β. Their number is that of a scan of β*_lim. β*_lim comes from the
/// kernel's formulas, the ranges from interval arithmetic over sums of their own.
#[test]
fn ranges_of_sliding_end_at_the_limit() {
    let (mut compared, mut moved) = (0, 0);
    for system in systems() {
        let features = system.features(None).unwrap();
        let [from, to] = system.about_resonances();
        let limit = |r: f64| system.at(r).unwrap().sliding_limit();
        for beta in [0.2, 0.9, 3.0] {
            let ranges = features.sliding_ranges(beta, [from, to]).unwrap();
            let places = (0..=20_000).map(|i| from + (to - from) * f64::from(i) / 20_000.0);
            let slides: Vec<bool> = places.map(|r| beta < limit(r)).collect();
            let changes = slides.windows(2).filter(|pair| pair[0] != pair[1]).count();
            let ends = ranges.iter().flat_map(|range| {
                [
                    (range.from, &range.from_frequency),
                    (range.to, &range.to_frequency),
                ]
            });
            let ends: Vec<_> = ends.filter(|(r, _)| from < *r && *r < to).collect();
            // A scan misses ranges narrower than its step, so that it may count two changes less for each.
            assert!(changes <= ends.len() && (ends.len() - changes).is_multiple_of(2));
            for (r, frequency) in ends {
                // Next to a steep limit one rounding of r changes β*_lim by more than a rounding.
                let steep = (limit(r * (1.0 + 1e-9)) - limit(r)).abs() / (1e-9 * beta);
                assert!(
                    (limit(r) / beta - 1.0).abs() < 1e-14 * (10.0 + steep),
                    "{beta} {r}"
                );
                compared += 1;
                moved += usize::from(agrees(&system, beta, r, frequency.as_ref().unwrap()));
            }
            let (regimes, certainty) = features.regimes(beta, [from, to]).unwrap();
            assert_eq!(certainty, Certainty::Proven);
            let stick_slip = regimes
                .iter()
                .filter(|range| range.regime == Regime::StickSlip);
            assert_eq!(stick_slip.count(), ranges.len());
            assert!(
                regimes
                    .iter()
                    .all(|range| range.regime != Regime::Continuous)
            );
        }
    }
    assert!(40 < compared && 30 < moved, "{compared} {moved}");
}

/// Compares the derivative of a frequency with respect to the stiffness with a difference over 1e-6 of the stiffness.
/// Returns false where the difference has too few digits.
fn agrees(
    system: &System,
    beta: f64,
    r: f64,
    frequency: &frictiongen::study::features::Sensed,
) -> bool {
    let parameter = Parameter::Quantity(Quantity::ContactStiffness);
    let slope = frequency.relative(parameter).unwrap_or(0.0);
    let stiffness = system.scene().stiffness.unwrap();
    let near = |factor: f64| {
        let mut scene = system.scene().clone();
        scene.stiffness = Some(stiffness * factor);
        let moved = System::<f64>::try_from(scene).unwrap();
        let [from, to] = [0.999 * r, 1.001 * r];
        let ranges = moved
            .features(None)
            .unwrap()
            .sliding_ranges(beta, [from, to])
            .unwrap();
        let mut ends = ranges.iter().flat_map(|range| [range.from, range.to]);
        ends.find(|end| from < *end && *end < to)
    };
    let (Some(above), Some(below)) = (near(1.0 + 1e-6), near(1.0 - 1e-6)) else {
        return false;
    };
    let difference = (above - below) / (2e-6 * r);
    // Rounding of r by 1e-16 over a step of 1e-6 leaves an error of 1e-10. The third derivative adds 1e-12 of itself.
    assert!(
        (slope - difference).abs() < 1e-8 * (1.0 + slope.abs()),
        "{slope} {difference}"
    );
    slope.abs() > 1e-6
}

/// A true peak is not below any sampled amplitude around its resonance, and the share of sticking is that of the orbit.
#[test]
fn peaks_are_the_largest_amplitudes() {
    let text = SCENES[1].replace(": K,", ": 4.0e3,");
    let system: System = text.parse().unwrap();
    let features = system.features(None).unwrap();
    let peaks = features.resonant_peaks(Of::Mass(1), 0.6).unwrap();
    assert_eq!(peaks.len(), 2);
    for peak in &peaks {
        assert_eq!(peak.estimate, None);
        let found = peak.peak.as_ref().unwrap();
        assert_eq!(found.regime, Some(Regime::StickSlip));
        let amplitude = |r: f64| {
            let orbit = system.at(r).unwrap().orbit(0.6).unwrap();
            orbit.mass("b").unwrap().amplitude()
        };
        let around = (-40..=40).map(|i| amplitude(found.r * (1.0 + 2e-3 * f64::from(i))));
        let largest = around.fold(0.0, f64::max);
        // The middle sample is the peak itself.
        assert!(
            (largest / found.amplitude.value - 1.0).abs() < 1e-12,
            "{largest}"
        );
    }
    for measured in [InvariantQuantity::Amplitude, InvariantQuantity::Fundamental] {
        let undamped: System = SCENES[2].replace(": K,", ": 150.0,").parse().unwrap();
        let features = undamped.features(None).unwrap();
        assert!(
            features
                .invariant_points(Of::Contact, measured, [0.1, 3.0])
                .unwrap()
                .is_empty()
        );
        assert!(
            features
                .inversions(Of::Mass(0), measured, [0.1, 3.0])
                .unwrap()
                .is_empty()
        );
        assert!(
            !features
                .antiresonances(Of::Mass(1), [0.1, 3.0])
                .unwrap()
                .is_empty()
        );
    }
}

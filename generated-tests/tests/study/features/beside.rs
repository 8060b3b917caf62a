//! Tests zeros of a response next to a pole, and common zeros of two responses.

use crate::features::scenes::unit;
use frictiongen::study::{
    System,
    features::{Edge, InvariantQuantity},
};
use frictiongen::{Of, Regime};

/// Checks two weakly coupled oscillators. The receptance of the first oscillator has a zero at the natural frequency of
/// the second oscillator, and a pole at a distance of ε²/2·0.69·1.69 from this zero. The search must find both down to
/// a relative distance of 1e-13.
#[test]
fn a_zero_beside_a_pole() {
    for (coupling, apart) in [(1e-3_f64, 4e-7), (1.5e-6, 9.6e-13)] {
        let text = format!(
            "struct Pair {{ masses: {{ a: 1, b: 1 }}, contact: a - wall, excitation: a,
             springs: {{ base - a: 1, base - b: 1.69, a - b: {coupling:?} }} }}"
        );
        let system: System = text.parse().unwrap();
        let expected = (1.69 + coupling).sqrt();
        let pole = system.resonances()[1];
        let gap = (pole / expected - 1.0).abs();
        assert!((0.8 * apart..1.2 * apart).contains(&gap), "{gap:e}");
        let features = system.features(None).unwrap();
        let found = features.antiresonances(Of::Mass(0), [1.1, 2.0]).unwrap();
        assert_eq!(found.len(), 1, "{coupling}: {found:?}");
        // The expected value is computed from numbers that are rounded once.
        assert!((found[0].r / expected - 1.0).abs() < 1e-15, "{found:?}");
    }
}

/// Checks a frequency at which the contact does not move. Load and contact act on the same mass. Where the other mass
/// acts as an absorber, the motion and the receptance of the contact vanish together. Only on one side of that
/// frequency does more friction enlarge the fundamental. The features must report the bound of this range as a
/// frequency at which the contact does not move.
#[test]
fn where_the_contact_is_still() {
    let system = unit(2, "m1 - wall", "m1");
    let features = system.features(None).unwrap();
    let found = features
        .inversions(Of::Contact, InvariantQuantity::Fundamental, [0.7, 1.3])
        .unwrap();
    let edges: Vec<(f64, Edge)> = found
        .iter()
        .flat_map(|range| [(range.from, range.from_edge), (range.to, range.to_edge)])
        .collect();
    let still: Vec<_> = edges
        .iter()
        .filter(|(r, _)| (r - 1.0).abs() < 1e-12)
        .collect();
    assert_eq!(still.len(), 1, "{edges:?}");
    assert_eq!(still[0].1, Edge::Still, "{edges:?}");
    // The steady states confirm the range: within the range, more friction gives a larger motion.
    for range in found {
        let r = 0.5 * (range.from + range.to);
        let at = system.at(r).unwrap();
        let limit = at.limits().continuous;
        let [less, more] = [0.2, 0.3].map(|share| {
            let response = at.response(share * limit).unwrap();
            assert_eq!(response.regime(), Regime::Continuous);
            response.harmonic(Of::Contact, 1).unwrap().norm()
        });
        assert!(less < more, "{r}: {less}, {more}");
    }
}

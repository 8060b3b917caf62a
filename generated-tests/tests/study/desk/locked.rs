//! Compares every answer for a contact that never slides with the closed form of the locked chain.

use frictiongen::study::curve::CurveRequest;
use frictiongen::study::map::MapRequest;
use frictiongen::study::optimum::{FrequencyBand, OptimumRequest};
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::sensitivity::OperatingPoint;
use frictiongen::{Of, Regime, System};

/// Friction ratio that locks the contact at every frequency of the test.
const LOCKED: f64 = 100.0;
/// Relative error of a modal sum of two modes.
const ROUNDING: f64 = 1e-12;

/// Masses and springs of the two floors: m_a, m_b, base − a, a − b.
const FLOORS: [f64; 4] = [2.0, 3.0, 50.0, 30.0];

/// Returns the amplitude of floor b over Y, from the stiffness matrix of two floors. A brace of stiffness k acts between
/// the base and floor a. With `rigid` floor a moves with the base.
fn floor_b(omega: f64, brace: f64, rigid: bool) -> f64 {
    let [m_a, m_b, k_a, k_b] = FLOORS;
    let upper = k_b - m_b * omega * omega;
    if rigid {
        return (k_b / upper).abs();
    }
    let lower = k_a + brace + k_b - m_a * omega * omega;
    ((k_a + brace) * k_b / (lower * upper - k_b * k_b)).abs()
}

/// Checks that amplitudes of orbit, response, curve, map, derivatives and optimum are the same number: the amplitude of
/// the locked chain. Motion from rest would leave the contact away from its middle.
#[test]
fn one_amplitude_of_a_locked_contact() {
    let of = Of::Mass(1);
    for (contact, brace, rigid) in [
        ("base - a, stiffness: 70", 70.0, false),
        ("base - a", 0.0, true),
    ] {
        let [m_a, m_b, k_a, k_b] = FLOORS;
        let text = format!(
            "struct Frame {{ masses: {{ a: {m_a}, b: {m_b} }}, springs: {{ base - a: {k_a}, a - b: {k_b} }},
             contact: {contact}, excitation: base, provide: [orbit] }}"
        );
        let system: System = text.parse().unwrap();
        let band = [0.2, 0.5];
        let expected = |r: f64| floor_b(r * (k_a / m_a).sqrt(), brace, rigid);
        let same = |what: &str, r: f64, found: f64| {
            let error = (found / expected(r) - 1.0).abs();
            assert!(
                error < ROUNDING,
                "{contact}, {what} at {r}: {found} for {}",
                expected(r)
            );
        };
        for r in [0.2, 0.35, 0.5] {
            let at = system.at(r).unwrap();
            let response = at.response(LOCKED).unwrap();
            assert_eq!(response.regime(), Regime::Stuck);
            assert!(0.5 < response.offset().abs());
            same("response", r, response.swing(of).unwrap().amplitude);
            same(
                "orbit",
                r,
                at.orbit(LOCKED).unwrap().mass("b").unwrap().amplitude(),
            );
            let point = OperatingPoint::Groups { r, beta: LOCKED };
            let derivatives = system.response_sensitivities(point, of).unwrap();
            same("derivatives", r, derivatives.parameters[0].amplitude.value);
        }
        let curve = system
            .curve(&CurveRequest::new(band[0], band[1], &[of]), LOCKED)
            .unwrap();
        for point in curve.pieces.iter().flat_map(|piece| &piece.points) {
            same("curve", point.r, point.movements[0].swing.amplitude);
        }
        let request = MapRequest {
            r: band.to_vec(),
            beta: vec![LOCKED],
            of: vec![of],
        };
        for (r, _, point) in system.map(&request, |_| true).unwrap().points() {
            same("map", r, point.as_ref().unwrap().amplitudes[0]);
        }
        let request = OptimumRequest {
            of,
            size: MotionQuantity::Displacement,
            band: FrequencyBand::Ratio(band[0], band[1]),
            load: None,
        };
        // Below its first resonance, the locked chain moves most at the upper bound of the band.
        let optimum = system.optimum(&request).unwrap();
        same("optimum", band[1], optimum.with_contact_locked);
        let largest = |beta: f64| {
            let curve = system
                .curve(&CurveRequest::new(band[0], band[1], &[of]), beta)
                .unwrap();
            let points = curve.pieces.iter().flat_map(|piece| &piece.points);
            points.fold(0.0, |most: f64, point| {
                most.max(point.movements[0].swing.amplitude)
            })
        };
        let by_curve = largest(optimum.beta);
        // A curve has points within 0.05 % of its peak.
        assert!(
            (optimum.amplitude / by_curve - 1.0).abs() < 1e-3,
            "{optimum:?} {by_curve}"
        );
    }
}

/// Checks a mass with an elastic contact to the wall. Motion from rest leaves a residual in the contact at some
/// frequencies, so that its largest amplitude is up to half as large again as that of the answer in the middle.
#[test]
fn a_residual_is_no_answer() {
    let system: System =
        "struct S { masses: { m: 1 }, springs: { base - m: 1 }, contact: m - wall, stiffness: 10,
        excitation: m, damping: modal(0.02), provide: [orbit] }"
            .parse()
            .unwrap();
    let largest = |system: &System, beta: f64| {
        let curve = system
            .curve(&CurveRequest::new(0.5, 1.5, &[Of::Mass(0)]), beta)
            .unwrap();
        let points = curve.pieces.iter().flat_map(|piece| &piece.points);
        points.fold(0.0, |most: f64, point| {
            most.max(point.movements[0].swing.amplitude)
        })
    };
    let rest = system
        .clone()
        .starting_from(frictiongen::study::InitialState::rest(1));
    // The report has the residual to four digits.
    for (beta, middle, residual) in [
        (1.11, 0.114162, None),
        (1.1138, 0.114156, Some(0.1502)),
        (1.1428, 0.114283, Some(0.1719)),
        (2.2, 0.114283, Some(0.1143)),
    ] {
        let found = largest(&system, beta);
        assert!((found - middle).abs() < 1e-6, "{beta}: {found}");
        if let Some(residual) = residual {
            let left = largest(&rest, beta);
            assert!((left - residual).abs() < 1e-4, "{beta}: {left}");
        }
    }
    let request = OptimumRequest {
        of: Of::Mass(0),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(0.5, 1.5),
        load: None,
    };
    let optimum = system.optimum(&request).unwrap();
    assert!(
        (optimum.amplitude / largest(&system, optimum.beta) - 1.0).abs() < 1e-3,
        "{optimum:?}"
    );
}

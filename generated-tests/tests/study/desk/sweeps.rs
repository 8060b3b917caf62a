//! Tests the frequencies at which a state ends in sweeps up and down. The reference is the closed form of one
//! undamped mass on a moving base.

use frictiongen::study::curve::{Curve, CurvePiece, CurveRequest, CurveStart, PieceEnd};
use frictiongen::{Of, Regime, System};
use std::f64::consts::PI;

const MU: f64 = 2.0;
const BLOCK: &str = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
    contact: block - base, excitation: base, stiction: 2 }";
/// Tolerance of the frequency ratio r of a jump. The sweep locates a jump to 1e-7.
const PLACE: f64 = 2e-7;

/// Returns V and U of Den Hartog's solution for the relative motion, whose load is r²Y.
fn solution(r: f64) -> (f64, f64) {
    let angle = PI / r;
    (1.0 / (1.0 - r * r), angle.sin() / (r * (1.0 + angle.cos())))
}

/// Returns the amplitude of the relative motion, divided by Y, if the contact slides all the time.
fn amplitude(r: f64, beta: f64) -> f64 {
    let (v, u) = solution(r);
    let load = r * r;
    load * (v * v - (beta / load * u).powi(2)).sqrt()
}

/// Returns the friction ratio β from which the contact stops at its reversals. The force that keeps the contact stuck
/// is r²z̄₀ = μβ.
fn continuous_limit(r: f64) -> f64 {
    let (v, u) = solution(r);
    let load = r * r;
    load * v.abs() / (u * u + (MU / load).powi(2)).sqrt()
}

/// Returns the frequency ratio between `low` and `high` at which `continuous_limit` equals β.
fn ends_at(beta: f64, mut low: f64, mut high: f64) -> f64 {
    assert!(continuous_limit(low) < beta && beta < continuous_limit(high));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if continuous_limit(middle) < beta {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

fn swept(system: &System, (from, to): (f64, f64), beta: f64, start: CurveStart) -> Curve {
    let request = CurveRequest {
        start,
        accuracy: 2e-3,
        ..CurveRequest::new(from, to, &[Of::Contact, Of::Mass(0)])
    };
    system.curve(&request, beta).expect("a curve")
}

fn of(curve: &Curve, regime: Regime) -> Vec<&CurvePiece> {
    let pieces = curve.pieces.iter();
    pieces.filter(|piece| piece.regime == regime).collect()
}

fn told(curve: &Curve) -> String {
    let pieces = curve.pieces.iter().map(|piece| {
        let (first, last) = (&piece.points[0], &piece.points[piece.points.len() - 1]);
        format!(
            "{:?} {:.9} {:?} to {:.9} {:?}, {} points, offset {:.3}",
            piece.regime,
            first.r,
            piece.start,
            last.r,
            piece.end,
            piece.points.len(),
            last.offset
        )
    });
    pieces.collect::<Vec<_>>().join("\n")
}

/// Checks a block on a moving base. In a sweep up it sticks while r² is below μβ minus the spring force of its
/// offset. In a sweep down it slides as long as the closed form exists. Between these two frequencies both states
/// exist.
#[test]
fn a_stuck_and_a_sliding_block() {
    let system: System = BLOCK.parse().expect("a scene");
    for beta in [0.85, 0.95, 1.2] {
        let range = (1.01, 1.75);
        let (up, down) = (
            swept(&system, range, beta, CurveStart::Up),
            swept(&system, range, beta, CurveStart::Down),
        );
        println!("β = {beta}, up:\n{}\ndown:\n{}", told(&up), told(&down));
        let stuck = of(&up, Regime::Stuck);
        let held = stuck[stuck.len() - 1];
        let last = &held.points[held.points.len() - 1];
        assert!(matches!(held.end, PieceEnd::Jump | PieceEnd::Boundary));
        // The balance of forces is μβ = r² + |offset|, with all terms divided by k₁Y.
        let departure = (MU * beta - last.offset.abs()).sqrt();
        assert!(
            (last.r / departure - 1.0).abs() < PLACE,
            "β = {beta}: {} for {departure}",
            last.r
        );
        let ends = ends_at(beta, 1.01, 1.7);
        let sliding = of(&down, Regime::Continuous);
        let slid = sliding[sliding.len() - 1];
        let first = &slid.points[0];
        assert!(
            (first.r / ends - 1.0).abs() < PLACE,
            "β = {beta}: {} for {ends}",
            first.r
        );
        assert!(ends < departure, "β = {beta}: no hysteresis");
        let mut compared = 0;
        for point in &slid.points {
            let expected = amplitude(point.r, beta);
            let found = point.movements[0].swing.amplitude;
            assert!((found / expected - 1.0).abs() < 1e-9, "r = {}", point.r);
            compared += u32::from(ends < point.r && point.r < departure);
        }
        for point in &held.points {
            // A stuck block moves with its base.
            let moved = point.movements[1].swing.amplitude;
            assert!((moved - 1.0 - point.offset.abs()).abs() < 1e-12);
        }
        assert!(compared > 3, "β = {beta}: {compared}");
    }
}

/// Checks a sweep whose work does not suffice for refinement. It goes directly from one frequency of the grid to the next,
/// and still takes the last state as its start. The block therefore slides at frequencies at which it would not slide from
/// rest.
#[test]
fn a_sweep_without_work_keeps_its_state() {
    let system: System = BLOCK.parse().expect("a scene");
    let beta = 1.2;
    let request = CurveRequest {
        start: CurveStart::Down,
        work: 0,
        ..CurveRequest::new(1.01, 1.75, &[Of::Contact])
    };
    let down = system.curve(&request, beta).expect("a curve");
    println!("{}", told(&down));
    assert!(!down.refined);
    let (ends, departure) = (ends_at(beta, 1.01, 1.7), (MU * beta).sqrt());
    let pieces = of(&down, Regime::Continuous);
    let points = pieces.iter().flat_map(|piece| &piece.points);
    let between = points.filter(|point| ends < point.r && point.r < 0.99 * departure);
    let from_rest = |r: f64| {
        let at = system.at(r).expect("in the domain");
        at.response(beta).expect("a response").regime()
    };
    let kept = between.filter(|point| from_rest(point.r) == Regime::Stuck);
    assert!(kept.count() > 3);
}

/// Checks that a sweep of a chain with one steady state gives the curve from rest. The sweep takes the last state of
/// one frequency as the start at the next.
#[test]
fn one_state_however_it_is_reached() {
    let system: System =
        "struct Frame { masses: { a: 3.27, b: 3.25 }, springs: { base - a: 1190, a - b: 1323 },
        contact: b - wall, excitation: base, damping: modal(0.02) }"
            .parse()
            .expect("a scene");
    let mut compared = 0;
    for start in [CurveStart::Up, CurveStart::Down] {
        let curve = swept(&system, (0.4, 1.6), 0.35, start);
        let mut before = 0.0;
        for point in curve.pieces.iter().flat_map(|piece| &piece.points) {
            assert!(before < point.r);
            before = point.r;
            if point.regime == Regime::Stuck || !point.settled {
                continue;
            }
            let response = system.at(point.r).expect("in the domain").response(0.35);
            let expected = response
                .expect("a response")
                .swing(Of::Mass(0))
                .expect("a mass");
            let found = point.movements[1].swing.amplitude;
            // The two searches end Newton's method at a relative step of about 1e-12. Steep responses lose some digits.
            assert!(
                (found / expected.amplitude - 1.0).abs() < 1e-8,
                "r = {}: {found} for {}",
                point.r,
                expected.amplitude
            );
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

/// Checks a sweep across a pole. If friction is below the threshold of a resonance, the amplitude has a pole at this
/// resonance. A sweep in either direction ends on one side of the pole, and continues on the other side.
#[test]
fn a_sweep_across_a_pole() {
    let system: System = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
        contact: block - wall, excitation: block }"
        .parse()
        .expect("a scene");
    for start in [CurveStart::Up, CurveStart::Down] {
        let curve = swept(&system, (0.95, 1.05), 0.3, start);
        let told = told(&curve);
        let [below, above] = curve.pieces.as_slice() else {
            panic!("{start:?}:\n{told}");
        };
        assert_eq!(
            (below.end, above.start),
            (PieceEnd::Pole, PieceEnd::Pole),
            "{told}"
        );
        let sides = [&below.points[below.points.len() - 1], &above.points[0]];
        for (side, expected) in sides.into_iter().zip([1.0 - 1e-5, 1.0 + 1e-5]) {
            assert!((side.r - expected).abs() < 1e-15, "{start:?}:\n{told}");
        }
    }
}

//! The rigid contact as the limit of a stiff one.

use frictiongen::System;
use frictiongen::answer::Event;
use std::f64::consts::TAU;

const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall,
    excitation: base, damping: modal[0.10, 0.12], provide: [orbit, simulation] }";

fn with(stiffness: f64) -> System {
    let text = FRAME.replace(
        "upper - wall,",
        &format!("upper - wall, stiffness: {stiffness:?},"),
    );
    text.parse().expect("a scene")
}

/// Returns amplitudes and stuck fractions of the rigid contact (`None`) or of an elastic one.
fn answers(stiffness: Option<f64>, beta: f64) -> [f64; 2] {
    let system = stiffness.map_or_else(|| FRAME.parse().expect("a scene"), with);
    let orbit = system.steady_state(0.9, beta).expect("a state");
    [
        orbit.mass("lower").expect("a mass").amplitude(),
        orbit.stuck_fraction(),
    ]
}

/// Over six decades of the stiffness, β*_lim of an elastic contact differs from that of a rigid contact by a multiple
/// of 1/k.
#[test]
fn limits_differ_by_the_compliance() {
    let rigid: System = FRAME.parse().expect("a scene");
    let limit = rigid.at(0.9).expect("in the domain").sliding_limit();
    assert!((rigid.stuck_limit(0.9).expect("no resonance") - limit).abs() < 1e-15);
    let mut last: Option<f64> = None;
    for decade in 2..=8 {
        let elastic = with(1190.0 * 10_f64.powi(decade));
        let difference = elastic.stuck_limit(0.9).expect("no resonance") - limit;
        println!("k = 1e{decade} k1: {difference}");
        assert!(last.is_none_or(|last| (9.9..10.1).contains(&(last / difference))));
        last = Some(difference);
    }
}

/// Returns the ratios of the differences to the rigid contact from one decade of the stiffness to the next.
fn falls(beta: f64, decades: std::ops::RangeInclusive<i32>) -> Vec<[f64; 2]> {
    let rigid = answers(None, beta);
    let differences: Vec<[f64; 2]> = decades
        .map(|decade| {
            let elastic = answers(Some(1190.0 * 10_f64.powi(decade)), beta);
            let differences = [elastic[0] - rigid[0], elastic[1] - rigid[1]];
            println!("beta = {beta}, k = 1e{decade} k1: {differences:?}");
            differences
        })
        .collect();
    let pairs = differences.windows(2);
    pairs
        .map(|pair| [pair[0][0] / pair[1][0], pair[0][1] / pair[1][1]])
        .collect()
}

/// Where a rigid contact slides all the time, an elastic one sticks after each reversal until its acceleration has moved it
/// by 2F/k.  Amplitude and stuck fraction therefore differ by multiples of 1/√k, over six decades.
#[test]
fn reversals_differ_by_the_root_of_the_compliance() {
    for fell in falls(0.3, 2..=8) {
        assert!(
            fell.iter().all(|ratio| (3.1..3.2).contains(ratio)),
            "{fell:?}"
        );
    }
}

/// Where a rigid contact stops, the amplitude with an elastic one differs by a multiple of 1/k.
#[test]
fn stops_differ_by_the_compliance() {
    for fell in falls(0.6, 2..=4) {
        assert!((9.0..12.0).contains(&fell[0]), "{fell:?}");
    }
}

/// With a stuck elastic contact, amplitude and phase of masses differ from those with a stuck rigid contact by a
/// multiple of 1/k, over six decades.
#[test]
fn stuck_responses_differ_by_the_compliance() {
    let rigid: System = FRAME.parse().expect("a scene");
    let stuck = |system: &System| {
        let at = system.at(0.9).expect("in the domain");
        at.stuck()
            .expect("no resonance")
            .mass("lower")
            .expect("a mass")
    };
    let exact = stuck(&rigid);
    let mut last: Option<f64> = None;
    for decade in 2..=8 {
        let difference = (stuck(&with(1190.0 * 10_f64.powi(decade))) - exact).norm();
        println!("k = 1e{decade} k1: {difference}");
        assert!(last.is_none_or(|last| (9.9..10.1).contains(&(last / difference))));
        last = Some(difference);
    }
}

/// Returns the times of all stops and of all break-aways of a motion from rest, in radians of the excitation.
fn events(system: &System, cycles: f64) -> [Vec<f64>; 2] {
    let mut run = system.simulation(0.9, 0.6).expect("a run");
    let (mut passed, mut times) = (0.0, [Vec::new(), Vec::new()]);
    while passed < TAU * cycles {
        let segment = run.advance(TAU * cycles - passed).expect("finite");
        passed += segment.length;
        match segment.event {
            Some(Event::Stop) => times[0].push(passed),
            Some(Event::Slip) => times[1].push(passed),
            _ => {}
        }
    }
    times
}

/// A stiff contact rings while it sticks, and may slip several times before it stays.  The stops and break-aways nearest
/// to those of a rigid contact are compared.  Stops differ by multiples of 1/k: at a stop the velocity is a straight line
/// through 0.  Break-aways differ by multiples of 1/√k, the period of the ringing.
#[test]
fn event_times_tend_to_those_of_a_rigid_contact() {
    let rigid = events(&FRAME.parse().expect("a scene"), 3.0);
    assert_eq!(rigid.each_ref().map(Vec::len), [6, 7]);
    for decade in 2..=8 {
        let ratio = 10_f64.powi(decade);
        let elastic = events(&with(1190.0 * ratio), 3.0);
        let latest = [0, 1].map(|kind| {
            let nearest = |time: &f64| {
                let differences = elastic[kind].iter().map(|other| (other - time).abs());
                differences.fold(f64::INFINITY, f64::min)
            };
            rigid[kind].iter().map(nearest).fold(0.0, f64::max)
        });
        println!(
            "k = 1e{decade} k1: stops differ by {:.1e}, break-aways by {:.1e}",
            latest[0], latest[1]
        );
        let scaled = [latest[0] * ratio, latest[1] * ratio.sqrt()];
        assert!(
            (3.0..12.0).contains(&scaled[0]) && (1.0..4.0).contains(&scaled[1]),
            "{scaled:?}"
        );
    }
}

//! Tests states with an offset: contacts that come to rest off their centre, and members of a continuum. One test
//! checks the phase of a contact that stops at its largest displacement.

use frictiongen::study::InitialState;
use frictiongen::study::sensitivity::{OperatingPoint, Parameter};
use frictiongen::{Of, Regime, Run as _, System};
use std::f64::consts::TAU;

fn system(text: &str) -> System {
    text.parse().expect("a scene")
}

fn block() -> System {
    system(
        "struct Block { masses: { m: 1 }, springs: { base - m: 1 }, contact: m - wall, excitation: m }",
    )
}

/// Checks that at r = 1/2n, where an undamped motion keeps a free vibration, every call returns the same member of the
/// continuum: the member that motion from rest approaches.
#[test]
fn one_rule_at_half_the_resonance() {
    let block = block();
    let at = block.at(0.5).expect("in the domain");
    let response = at.response(0.2).expect("a response");
    assert_eq!(response.regime(), Regime::Continuous);
    assert!(response.is_marginal() && response.is_from_rest());
    let amplitude = |of| response.swing(of).expect("a motion").amplitude;
    // The closed form is the symmetric member of the continuum, with amplitude 4/3. The member at the other end has
    // an offset of 2/15.
    for found in [
        amplitude(Of::Contact),
        amplitude(Of::Mass(0)),
        at.orbit(0.2).expect("an orbit").contact().amplitude(),
    ] {
        assert!((found - 22.0 / 15.0).abs() < 1e-12, "{found}");
    }
    let symmetric = at.motion(0.2).expect("a motion").contact().amplitude();
    assert!((symmetric - 4.0 / 3.0).abs() < 1e-12);
    let range = response.offset_range().expect("a continuum");
    assert!((range - 2.0 / 15.0).abs() < 1e-12, "{range}");
    assert!((response.offset().abs() - range).abs() < 1e-12);
    let history = response.history(&[Of::Mass(0)], 4096).expect("a history");
    let values = history.tracks[0].displacement.iter();
    let largest = values.fold(0.0_f64, |most, value| most.max(value.abs()));
    assert!((largest - 22.0 / 15.0).abs() < 1e-5, "{largest}");
    // A motion that starts with an offset smaller than that of this member keeps its offset.
    let motion = at.motion(0.2).expect("a motion");
    let early = -motion.contact().phase();
    let [x, v] = [
        motion.contact().displacement(early) + 0.05,
        motion.contact().velocity(early),
    ];
    let half = at.orbit_from(0.2, (&[x], &[v])).expect("an orbit");
    assert!(half.is_marginal() && half.offset().abs() < 0.5 * range);
    let wider = half.offset_range().expect("a continuum");
    assert!((wider - range).abs() < 1e-9, "{wider}");
}

/// Compares stuck states from rest with runs in time: the offset of the contact, and the largest displacements with that
/// offset. Without an initial state, the stuck state is the one in the middle, and has the same offset.
#[test]
fn where_a_contact_comes_to_rest() {
    let frame = system(
        "struct Frame {
            masses: { a: 12, b: 5 }, springs: { wall - a: 3.2e4, a - b: 1.1e4 }, contact: a - b,
            excitation: b, damping: rayleigh(0.4, 1e-5), stiction: 1.25,
        }",
    );
    let base = system(
        "struct Two {
            masses: { a: 1, b: 0.7 }, springs: { base - a: 1, a - b: 0.6 }, contact: b - base,
            excitation: base, damping: modal[0.05, 0.08],
        }",
    );
    let (mut compared, mut off_centre) = (0, 0);
    for system in [&frame, &base] {
        let from_rest = system.clone().starting_from(InitialState::rest(2));
        for r in [0.6, 0.8, 1.0, 1.2, 1.4] {
            for over in [1.15, 1.5, 3.0] {
                let at = system.at(r).expect("in the domain");
                let beta = over * at.sliding_limit();
                let rest = from_rest.at(r).expect("in the domain");
                let response = rest.response(beta).expect("a response");
                let middle = at.response(beta).expect("a response");
                assert_eq!(middle.offset(), response.offset());
                // If motion from rest never settles, it has no offset to compare.
                if response.regime() != Regime::Stuck || !response.is_from_rest() {
                    continue;
                }
                let mut run = system.simulation(r, beta).expect("a run");
                let mut largest = [0.0_f64; 2];
                for cycle in 0..2000 {
                    let mut left = TAU;
                    while left > 1e-12 {
                        let reach = if cycle < 1999 { left } else { left.min(0.01) };
                        left -= run.advance(reach).expect("it goes on").length;
                        if cycle == 1999 {
                            for (mass, largest) in largest.iter_mut().enumerate() {
                                *largest = largest.max(run.moment(mass).displacement().abs());
                            }
                        }
                    }
                }
                let what = format!("{}, r = {r}, {over}", system.scene().name);
                // With μ = 1 the run approaches the offset at which friction just suffices to hold the contact. After
                // n cycles the distance from this offset is of the order 1/n.
                let crawls = system.scene().stiction == 1.0
                    && response.offset().abs() == response.offset_range().expect("a range");
                let bar = if crawls { 1e-2 } else { 1e-9 };
                let apart = run.relative().0 - response.offset();
                assert!(apart.abs() < bar, "{what}: {apart:e}");
                for (mass, largest) in largest.into_iter().enumerate() {
                    let told = response.swing(Of::Mass(mass)).expect("a mass").amplitude;
                    // Samples at intervals of 0.01 rad miss a maximum by at most 1e-5 of its value.
                    let low = told * (1.0 - 2e-5) - bar;
                    assert!(
                        (low..=told + bar).contains(&largest),
                        "{what}: {largest} {told}"
                    );
                    let centred = middle.swing(Of::Mass(mass)).expect("a mass").amplitude;
                    let stuck = at.stuck().expect("a response").mass_at(mass);
                    assert!((centred - stuck.expect("a mass").norm()).abs() < 1e-14);
                    compared += 1;
                }
                off_centre += usize::from(response.offset().abs() > 1e-3);
            }
        }
    }
    println!("{compared} motions compared, {off_centre} contacts off their centres");
    assert!(compared > 40 && off_centre > 8, "{compared} {off_centre}");
}

/// Checks one mass on a moving base with μ = 1. The contact starts with an offset of Y, and its slips become ever
/// smaller. It approaches the offset at which friction just suffices, β = r² + |z̄|.
#[test]
fn slips_that_shrink_without_end() {
    let block = system(
        "struct Block { masses: { m: 1 }, springs: { base - m: 1 }, contact: m - base, excitation: base }",
    );
    for r in [0.3, 0.55, 0.8, 1.0, 1.1] {
        let beta = 1.25;
        let orbit = block.at(r).expect("in the domain").orbit(beta);
        let orbit = orbit.expect("it sticks");
        let held = (beta - r * r).min(1.0);
        assert!(
            (orbit.offset() + held).abs() < 1e-14,
            "{r}: {}",
            orbit.offset()
        );
        let range = orbit.offset_range().expect("a continuum");
        assert!((range - (beta - r * r)).abs() < 1e-14, "{r}: {range}");
    }
}

/// Checks a mass whose offset from its base stays Y, so that its displacement is cos τ − 1 from rest and cos τ about the
/// middle. The motion starts from zero, where rounding may give the displacement either sign.
#[test]
fn from_zero_and_back() {
    let chain = system(
        "struct Chain {
            masses: { m1: 0.6599, m2: 1.4362, m3: 1.1297, m4: 1.1642 },
            springs: { base - m1: 0.5094, m1 - m2: 0.5303, m2 - m3: 0.3715, m3 - m4: 0.6222 },
            contact: m2 - base, excitation: base, damping: modal[0.03353, 0.06080, 0.12038, 0.11700],
        }",
    );
    for step in 0..200 {
        let r = 2.5 + 0.005 * f64::from(step);
        let at = chain.at(r).expect("in the domain");
        let beta = 1.2 * at.sliding_limit() + 2.0;
        let rest = at.orbit_from(beta, (&[0.0; 4], &[0.0; 4]));
        for (orbit, moved) in [(at.orbit(beta), 1.0), (rest, 2.0)] {
            let orbit = orbit.expect("it sticks");
            assert_eq!(orbit.offset(), -1.0, "{r}");
            let amplitude = orbit.mass_at(1).expect("a mass").amplitude();
            assert!((amplitude - moved).abs() < 1e-13, "{r}: {amplitude}");
        }
    }
}

/// Checks the phase of a contact that stops at its largest displacement. It is the lag of the beginning of the stop.
/// The phase is continuous in β, and its derivative agrees with differences.
#[test]
fn the_phase_of_a_stop() {
    let block = block();
    let phase = |beta: f64| {
        let orbit = block.at(0.3).expect("in the domain").orbit(beta);
        orbit.expect("an orbit").contact().phase()
    };
    // In all three cases the stop contains the maximum of the load.
    for (beta, lag) in [(0.5, -0.348), (0.7, -0.132), (0.78, -0.026)] {
        assert!((phase(beta) - lag).abs() < 5e-4, "{beta}: {}", phase(beta));
    }
    let mut last = phase(0.40);
    for step in 1..=580 {
        let next = phase(0.40 + 1e-3 * f64::from(step));
        assert!((next - last).abs() < 0.02, "{step}: {last} {next}");
        last = next;
    }
    for beta in [0.5, 0.7, 0.78, 0.9] {
        let point = OperatingPoint::Groups { r: 0.3, beta };
        let found = block.response_sensitivities(point, Of::Contact);
        let found = found.expect("derivatives").parameters;
        let friction = found.iter().find(|of| of.parameter == Parameter::Friction);
        let slope = friction
            .and_then(|of| of.phase)
            .expect("a phase")
            .derivative;
        let h = 1e-5;
        let difference = (phase(beta + h) - phase(beta - h)) / (2.0 * h);
        // The tolerance covers two errors: numbers known to 1e-12 divided by the step 2e-5, and the third derivative.
        assert!(
            (slope - difference).abs() < 1e-6,
            "{beta}: {slope} {difference}"
        );
    }
    // The phase of the fundamental component is another number.
    let orbit = block
        .at(0.3)
        .expect("in the domain")
        .orbit(0.5)
        .expect("an orbit");
    let first = orbit.contact().harmonic(1);
    let apart = orbit.contact().fundamental_phase() + first.im.atan2(first.re);
    assert!(apart.abs() < 1e-14, "{apart:e}");
}

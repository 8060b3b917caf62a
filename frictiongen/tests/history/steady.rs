//! Late in a run the motion is the steady state, in its displacements, velocities, forces and events.

use crate::scenes::{BETWEEN, DAMPED, ELASTIC, FRAME, SHAKEN, all, system};
use frictiongen::kernel::simulation::Event;
use frictiongen::study::{history::HistoryRequest, response::SystemResponse};
use frictiongen::{Of, Regime};

#[test]
fn a_late_run_is_the_steady_state() {
    let scenes: [(&str, &[(f64, f64)]); 5] = [
        (
            DAMPED,
            &[(0.3, 0.4), (0.3, 0.01), (0.8, 0.2), (2.0, 0.1), (0.5, 2.0)],
        ),
        (
            SHAKEN,
            &[(0.4, 0.05), (0.6, 0.3), (1.1, 0.4), (1.3, 0.01), (0.4, 9.0)],
        ),
        (
            BETWEEN,
            &[(0.4, 0.3), (0.9, 0.1), (1.6, 0.2), (0.5, 0.01), (0.7, 5.0)],
        ),
        (FRAME, &[(0.3, 0.4), (0.5, 0.5), (0.9, 0.1), (0.7, 9.0)]),
        (ELASTIC, &[(0.4, 0.05), (0.6, 0.3), (1.1, 0.4)]),
    ];
    let (mut worst, mut compared, mut events) = (0.0_f64, 0, 0);
    let mut regimes = [0; 3];
    for (text, points) in scenes {
        let system = system(text);
        let of = all(&system);
        for (r, beta) in points {
            let response = system.at(*r).unwrap().response(*beta).unwrap();
            let steady = response.history(&of, 120).unwrap();
            // A contact stays stuck where it stops, which depends on the start. A stuck run therefore starts from a
            // state of the steady response.
            let start = steady.tracks.iter().skip(1);
            let start = start.map(|track| (track.displacement[0], track.velocity[0]));
            let stuck = response.regime() == Regime::Stuck;
            let request = HistoryRequest {
                from: stuck.then(|| start.unzip()),
                skip: 600,
                cycles: steady.cycles,
                samples: 120,
                ..HistoryRequest::new(&of)
            };
            let run = system.history(*r, *beta, &request).unwrap();
            regimes[match response.regime() {
                Regime::Continuous => 0,
                Regime::StickSlip => 1,
                _ => 2,
            }] += 1;
            assert_eq!(run.len(), steady.len());
            for index in 0..run.len() {
                for (run, steady) in run.tracks.iter().zip(&steady.tracks) {
                    let displacement = run.displacement[index] - steady.displacement[index];
                    let velocity = run.velocity[index] - steady.velocity[index];
                    worst = worst.max(displacement.abs()).max(velocity.abs());
                    compared += 2;
                }
                let tau = steady.tau(index);
                let beside = steady.events.iter().any(|event| {
                    let apart = (event.tau - tau).abs();
                    apart.min((apart - steady.tau(steady.len() - 1)).abs()) < 1e-9
                });
                if !beside {
                    assert_eq!(
                        run.contact[index], steady.contact[index],
                        "r = {r}, β = {beta}"
                    );
                    worst = worst.max((run.friction[index] - steady.friction[index]).abs());
                    compared += 1;
                }
            }
            assert_eq!(run.events.len(), steady.events.len(), "r = {r}, β = {beta}");
            for (run_event, event) in run.events.iter().zip(&steady.events) {
                assert_eq!(
                    (run_event.event, run_event.contact),
                    (event.event, event.contact)
                );
                let tau = run_event.tau - run.tau(0);
                worst = worst.max((tau - event.tau).abs());
                for (one, other) in run_event.displacements.iter().zip(&event.displacements) {
                    worst = worst.max((one - other).abs());
                }
                events += 1;
            }
        }
    }
    println!("{compared} values and {events} events of {regimes:?} points, to {worst:.1e}");
    assert!(compared > 10_000 && events > 30 && regimes.iter().all(|count| *count > 1));
    assert!(worst < 1e-10);
}

/// The motion and its events repeat after three cycles.
#[test]
fn a_subharmonic_state_has_its_period() {
    let system = system(
        "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall,
         excitation: block, stiction: 2 }",
    );
    let response = system.at(0.352).unwrap().response(0.1563).unwrap();
    assert_eq!(response.period(), 3);
    let history = response.history(&[Of::Contact, Of::Mass(0)], 64).unwrap();
    assert_eq!((history.cycles, history.len()), (3, 193));
    let track = &history.tracks[1];
    let back = |cycles: usize| (track.displacement[64 * cycles] - track.displacement[0]).abs();
    assert!(back(3) < 1e-12 && back(1) > 1e-3 && back(2) > 1e-3);
    let stops = history
        .events
        .iter()
        .filter(|event| event.event == Event::Stop);
    let slips = history
        .events
        .iter()
        .filter(|event| event.event == Event::Slip);
    let (stops, slips) = (stops.count(), slips.count());
    assert!(stops > 0 && stops == slips);
    // A run from one of the states of the orbit is the same motion.
    let request = HistoryRequest {
        from: Some((vec![track.displacement[64]], vec![track.velocity[64]])),
        cycles: 2,
        samples: 64,
        ..HistoryRequest::new(&[Of::Mass(0)])
    };
    let run = system.history(0.352, 0.1563, &request).unwrap();
    for index in 0..run.len() {
        let apart = run.tracks[0].displacement[index] - track.displacement[64 + index];
        assert!(apart.abs() < 1e-10, "{index}: {apart}");
    }
}

/// The force in a stuck contact has the modulus of the sliding limit, and a run reports the same force. Both also hold
/// where masses beyond the contact act as an absorber, so that V and H vanish together.
#[test]
fn what_holds_a_stuck_contact() {
    let absorber =
        "struct Absorber { masses: { a: 1, b: 0.5 }, springs: { base - a: 1, a - b: 0.32 },
        contact: a - wall, excitation: a }";
    let (mut worst, mut compared) = (0.0_f64, 0);
    let own = 0.8;
    for (text, r) in [
        (absorber, own),
        (absorber, own + 1e-7),
        (absorber, 0.5),
        (SHAKEN, 0.5),
        (SHAKEN, 1.4),
        (BETWEEN, 0.9),
        (FRAME, 0.7),
    ] {
        let system = system(text);
        let at = system.at(r).unwrap();
        let beta = 3.0 * at.sliding_limit();
        let response = at.response(beta).unwrap();
        let SystemResponse::Stuck(stuck) = &response else {
            panic!("it slides")
        };
        let limit = at.sliding_limit() * system.scene().stiction;
        worst = worst.max((stuck.contact_force().norm() / limit - 1.0).abs());
        let of = all(&system);
        let steady = response.history(&of, 36).unwrap();
        let start = steady.tracks.iter().skip(1);
        let start = start.map(|track| (track.displacement[0], track.velocity[0]));
        let request = HistoryRequest {
            from: Some(start.unzip()),
            cycles: 1,
            samples: 36,
            ..HistoryRequest::new(&of)
        };
        let run = system.history(r, beta, &request).unwrap();
        // The contact sticks only after the rounding of its velocity has died out, so the first sample is left out.
        for (run, steady) in run.friction.iter().zip(&steady.friction).skip(1) {
            worst = worst.max((run - steady).abs() / limit);
            compared += 1;
        }
    }
    println!("{compared} forces, to {worst:.1e} of the largest");
    assert!(compared == 7 * 36 && worst < 1e-12);
}

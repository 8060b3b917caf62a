//! A history depends neither on its number of samples nor on the instant of its first sample.

use crate::scenes::{SCENES, all, system};
use frictiongen::study::history::{History, HistoryRequest};

/// Returns the largest difference of two histories at their common instants, and the number of compared values.
fn apart(coarse: &History, fine: &History, offset: usize) -> (f64, usize) {
    let every = (fine.samples / coarse.samples) as usize;
    let (mut worst, mut compared) = (0.0_f64, 0);
    for index in 0..coarse.len() {
        let other = (index + offset) * every;
        assert!((coarse.tau(index) - fine.tau(other)).abs() <= 1e-12);
        for (one, two) in coarse.tracks.iter().zip(&fine.tracks) {
            let displacement = one.displacement[index] - two.displacement[other];
            let velocity = one.velocity[index] - two.velocity[other];
            worst = worst.max(displacement.abs()).max(velocity.abs());
            compared += 2;
        }
    }
    (worst, compared)
}

#[test]
fn finer_samples_change_nothing() {
    let (mut worst, mut compared, mut events) = (0.0_f64, 0, 0);
    for (text, points) in SCENES {
        let system = system(text);
        for (r, beta) in points {
            let at = |samples, skip, cycles| {
                let request = HistoryRequest {
                    samples,
                    skip,
                    cycles,
                    ..HistoryRequest::new(&all(&system))
                };
                system.history(*r, *beta, &request).unwrap()
            };
            let fine = at(600, 0, 30);
            for (samples, skip, cycles) in [(2, 0, 30), (6, 0, 30), (200, 0, 30), (24, 17, 13)] {
                let coarse = at(samples, skip, cycles);
                let offset = skip as usize * samples as usize;
                let (difference, count) = apart(&coarse, &fine, offset);
                worst = worst.max(difference);
                compared += count;
                let later = |tau: f64| tau > coarse.tau(0) - 1e-9;
                let expected = fine.events.iter().filter(|event| later(event.tau));
                assert_eq!(expected.clone().count(), coarse.events.len());
                for (event, expected) in coarse.events.iter().zip(expected) {
                    assert_eq!(
                        (event.event, event.contact),
                        (expected.event, expected.contact)
                    );
                    worst = worst.max((event.tau - expected.tau).abs());
                    events += 1;
                }
            }
        }
    }
    println!("{compared} values and {events} events, to {worst:.1e}");
    assert!(compared > 100_000 && events > 3000);
    assert!(worst < 1e-11);
}

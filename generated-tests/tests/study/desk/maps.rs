//! Tests the points of maps, their boundaries, and the content of a cancelled map.

use crate::desk::{SCENES, system};
use frictiongen::study::map::{MapRequest, Pattern};
use frictiongen::{Given, Of, OutOfDomain, Regime, Unsupported};
use std::sync::atomic::{AtomicUsize, Ordering};

fn request() -> MapRequest {
    MapRequest {
        r: (1..=30).map(|i| 0.0731 * f64::from(i)).collect(),
        beta: (0..=24).map(|i| 0.047 * f64::from(i)).collect(),
        of: vec![Of::Contact, Of::Mass(0)],
    }
}

/// Checks that points computed in parallel equal points computed one by one, in the same order.
#[test]
fn points_are_responses() {
    for (name, text) in SCENES {
        let system = system(text);
        let map = system.map(&request(), |_| true).unwrap();
        assert_eq!(map.points().count(), 30 * 25);
        for (r, beta, point) in map.points().step_by(17) {
            let response = system.at(r).unwrap().response(beta);
            match (point, response) {
                (Ok(point), Ok(response)) => {
                    assert_eq!(
                        point.pattern,
                        Pattern::of(&response),
                        "{name}, r = {r}, β = {beta}"
                    );
                    let amplitude = response.swing(Of::Mass(0)).unwrap().amplitude;
                    assert_eq!(
                        point.amplitudes[1], amplitude,
                        "{name}, r = {r}, β = {beta}"
                    );
                    assert_eq!(
                        (point.offset, point.pattern.period == 0),
                        (response.offset(), !response.is_settled()),
                        "{name}, r = {r}, β = {beta}"
                    );
                }
                (Err(one), Err(other)) => assert_eq!(*one, other),
                (one, other) => panic!("{name}, r = {r}, β = {beta}: {one:?}, {other:?}"),
            }
        }
    }
}

/// Checks that the map gives no period to a motion that does not settle.
#[test]
fn what_does_not_settle() {
    let system = system(
        "struct S { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - base, excitation: base, stiction: 3 }",
    );
    let request = MapRequest {
        r: vec![1.0 / 3.0],
        beta: vec![0.01395],
        of: vec![Of::Mass(0)],
    };
    let map = system.map(&request, |_| true).unwrap();
    let point = map.columns[0].points[0].as_ref().unwrap();
    let pattern = point.pattern;
    assert_eq!(pattern.regime, Regime::StickSlip);
    assert_eq!(
        (pattern.stops, pattern.reversals, pattern.period),
        (0, 0, 0)
    );
}

/// Checks that on each side of a boundary the contact moves as the boundary states. The limits of the regimes are
/// exact.
#[test]
#[ignore = "a sweep, ten seconds or more: .ci/nightly"]
fn boundaries_have_their_two_sides() {
    let (mut inner, mut exact) = (0, 0);
    for (name, text) in SCENES {
        let system = system(text);
        let map = system.map(&request(), |_| true).unwrap();
        for boundary in system.boundaries(&map, 5) {
            let at = system.at(boundary.r).unwrap();
            let what = format!("{name}, r = {}, β = {}", boundary.r, boundary.beta);
            if boundary.width == 0.0 {
                let limits = at.limits();
                assert!(
                    [limits.continuous, limits.sliding].contains(&boundary.beta),
                    "{what}"
                );
                exact += 1;
                continue;
            }
            assert!(
                boundary.width <= 1e-5 * boundary.beta * 1.001,
                "{what}: {}",
                boundary.width
            );
            // A motion that repeats only after many cycles is sensitive to rounding. A change of β by a rounding unit
            // may change the pattern of its events.
            let scatters = |pattern: &Result<Pattern, _>| {
                pattern.as_ref().is_ok_and(|pattern| pattern.period != 1)
            };
            if scatters(&boundary.below) || scatters(&boundary.above) {
                continue;
            }
            let pattern = |beta: f64| at.response(beta).map(|response| Pattern::of(&response));
            assert_eq!(
                pattern(boundary.beta - 0.5 * boundary.width),
                boundary.below,
                "{what}"
            );
            assert_eq!(
                pattern(boundary.beta + 0.5 * boundary.width),
                boundary.above,
                "{what}"
            );
            inner += 1;
        }
    }
    println!("{exact} limits, {inner} traced");
    assert!(exact > 100 && inner > 30, "{exact} limits, {inner} traced");
}

/// Checks that a map finds several boundaries between two of its friction ratios, in order. The reference is a map with
/// sixteen times as many friction ratios. The search may miss regions narrower than a quarter of a step.
#[test]
fn several_boundaries_between_two_frictions() {
    const FINER: usize = 16;
    let system = system(SCENES[0].1);
    let r: Vec<f64> = (1..=30).map(|i| 0.021 * f64::from(i)).collect();
    let grid = |steps: usize| -> Vec<f64> {
        let step = 0.96 / steps as f64;
        (0..=steps).map(|i| 0.04 + step * i as f64).collect()
    };
    let coarse = MapRequest {
        r,
        beta: grid(6),
        of: Vec::new(),
    };
    let fine = MapRequest {
        beta: grid(6 * FINER),
        ..coarse.clone()
    };
    let map = system.map(&coarse, |_| true).unwrap();
    let found = system.boundaries(&map, 4);
    let fine = system.map(&fine, |_| true).unwrap();
    let (mut several, mut alike, mut compared) = (0, 0, 0);
    for column in &fine.columns {
        let kind = |place: usize| {
            column.points[place]
                .as_ref()
                .map(|point| point.pattern)
                .map_err(|error| *error)
        };
        for step in 0..6 {
            let ends = [step, step + 1].map(|place| map.beta[place]);
            let here: Vec<_> = found
                .iter()
                .filter(|one| one.r == column.r && ends[0] < one.beta && one.beta <= ends[1])
                .collect();
            // From one friction ratio of the map to the next, each boundary must lead to the kind of motion from
            // which the next boundary starts.
            let outer = [step * FINER, (step + 1) * FINER].map(kind);
            let mut last = outer[0];
            for one in &here {
                assert!(
                    one.below == last && one.below != one.above,
                    "r = {}: {one:?}",
                    column.r
                );
                last = one.above;
            }
            assert_eq!(last, outer[1], "r = {}, {ends:?}", column.r);
            // The search must not miss a region whose width is at least a quarter of the step between two friction
            // ratios.
            let inner = step * FINER..(step + 1) * FINER;
            let mut start = inner.start;
            for place in inner {
                if kind(place) != kind(place + 1) || place + 1 == (step + 1) * FINER {
                    if place - start >= FINER / 4 {
                        let known = |one: &&&frictiongen::study::map::Boundary| {
                            one.below == kind(start) || one.above == kind(start)
                        };
                        let whole = outer[0] == kind(start);
                        assert!(
                            whole || here.iter().any(|one| known(&one)),
                            "r = {}: {start}",
                            column.r
                        );
                        compared += 1;
                    }
                    start = place + 1;
                }
            }
            several += usize::from(here.len() > 1);
            alike += usize::from(!here.is_empty() && outer[0] == outer[1]);
        }
    }
    println!(
        "{compared} regions, {several} steps with several boundaries, {alike} between points that are alike"
    );
    assert!(compared > 60 && several > 10 && alike > 0);
}

/// Checks that a cancelled map keeps whole columns, in their order.
#[test]
fn a_cancelled_map_keeps_whole_columns() {
    let system = system(SCENES[0].1);
    let told = AtomicUsize::new(0);
    let map = system
        .map(&request(), |done| {
            told.fetch_max(done, Ordering::Relaxed);
            done < 5
        })
        .unwrap();
    let done = map.columns.len();
    // Unfinished columns of other threads are dropped, and finished ones are kept.
    assert!(
        (5..30).contains(&done) && told.load(Ordering::Relaxed) >= 5,
        "{done}"
    );
    assert!(map.columns.iter().all(|column| column.points.len() == 25));
    assert!(map.columns.is_sorted_by(|a, b| a.r < b.r));
    assert!(
        system
            .map(&request(), |_| false)
            .unwrap()
            .columns
            .is_empty()
    );
}

#[test]
fn bad_requests() {
    let system = system(SCENES[0].1);
    for (change, error) in [
        (
            MapRequest {
                r: vec![-1.0],
                ..request()
            },
            OutOfDomain::FrequencyRatio(Given::Negative),
        ),
        (
            MapRequest {
                r: vec![f64::NAN],
                ..request()
            },
            OutOfDomain::FrequencyRatio(Given::NotANumber),
        ),
        (
            MapRequest {
                r: vec![f64::INFINITY],
                ..request()
            },
            OutOfDomain::FrequencyRatio(Given::Infinite),
        ),
        (
            MapRequest {
                beta: vec![f64::INFINITY],
                ..request()
            },
            OutOfDomain::FrictionRatio(Given::Infinite),
        ),
        (
            MapRequest {
                of: vec![Of::Mass(1)],
                ..request()
            },
            OutOfDomain::Mass,
        ),
    ] {
        assert_eq!(system.map(&change, |_| true).unwrap_err(), error);
    }
}

/// Checks that the polylines of limits are close to the limits between their points. They reach 0 at the odd
/// subharmonics (3.17).
#[test]
fn limit_lines_pass_the_limits() {
    let share = |beta: f64| 1.0 - 1.0 / (1.0 + beta);
    for (name, text) in SCENES {
        let system = system(text);
        let lines = system.limit_lines(0.05, 2.5, 1e-4).unwrap();
        for pair in lines.points.windows(2) {
            let r = 0.6 * pair[0].0 + 0.4 * pair[1].0;
            let exact = system.at(r).unwrap().limits();
            let line = |read: fn(&frictiongen::Limits<f64>) -> f64| {
                (0.6 * share(read(&pair[0].1)) + 0.4 * share(read(&pair[1].1))
                    - share(read(&exact)))
                .abs()
            };
            assert!(line(|limits| limits.continuous) < 1e-3, "{name}, r = {r}");
            assert!(line(|limits| limits.sliding) < 1e-3, "{name}, r = {r}");
        }
    }
    let block = system(SCENES[0].1);
    let lines = block.limit_lines(0.1, 1.5, 1e-4).unwrap();
    let third = lines
        .points
        .iter()
        .find(|point| point.0 == 1.0 / 3.0)
        .unwrap();
    assert!(third.1.continuous < 1e-12 && third.1.regime(0.3) == Ok(Regime::StickSlip));
    assert!(
        block.limit_lines(1.0, 1.0, 1e-4).is_err() && block.limit_lines(-1.0, 1.0, 1e-4).is_err()
    );
}

/// Checks that the map returns an error, instead of no columns, if the kinetic friction depends on the speed.
#[test]
fn a_law_that_falls_with_speed_is_refused() {
    let system = system(
        "struct S { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a,
         friction: stribeck(0.1: 0.8, 0.3: 0.6), provide: [simulation] }",
    );
    let error = system.map(&request(), |_| true).unwrap_err();
    assert_eq!(error, OutOfDomain::Unsupported(Unsupported::FrictionLaw));
}

/// Checks that a mass index that does not exist is reported as a missing mass, not as an invalid number.
#[test]
fn a_mass_that_is_not_there() {
    let request = MapRequest {
        of: vec![Of::Mass(1)],
        ..request()
    };
    let error = system(SCENES[0].1).map(&request, |_| true).unwrap_err();
    assert_eq!(error, OutOfDomain::Mass);
    let told = error.to_string();
    assert!(
        told.contains("no mass with this index") && !told.contains("finite"),
        "{told}"
    );
}

/// Checks that every requested frequency has its column, including the smallest and the largest numbers.
#[test]
fn no_column_is_lost() {
    for (name, text) in SCENES {
        let request = MapRequest {
            r: vec![0.0, 5e-324, 1e-300, 0.4, 1.0, 1e150, f64::MAX],
            beta: vec![0.0, 0.3, 1e300],
            of: vec![Of::Mass(0)],
        };
        let map = system(text).map(&request, |_| true).unwrap();
        let r: Vec<f64> = map.columns.iter().map(|column| column.r).collect();
        assert_eq!(r, request.r, "{name}");
        assert!(map.columns.iter().all(|column| column.points.len() == 3));
    }
}

/// Checks a map under a load whose amplitude falls with 1/r². Each point is the response to the friction ratio at its
/// frequency. In the unit of force of the load at r = 1, friction and limits compare as β and the limits do.
#[test]
fn a_load_over_frequency() {
    for (name, text) in &SCENES[..2] {
        let system = system(text);
        let map = system.map_under(&request(), 2, |_| true).unwrap();
        let boundaries = system.boundaries(&map, 4);
        let reference = map.at_reference();
        let columns = map.columns.iter().zip(&reference.columns);
        for (column, scaled) in columns.step_by(7) {
            // The amplitude of the load at r, divided by that at r = 1.
            let load = 1.0 / (column.r * column.r);
            let at = system.at(column.r).unwrap();
            for (place, (point, own)) in column.points.iter().zip(&scaled.points).enumerate() {
                let friction = map.beta[place];
                let (Ok(point), Ok(response)) = (point, at.response(friction / load)) else {
                    continue;
                };
                let amplitude = response.swing(Of::Mass(0)).unwrap().amplitude;
                let what = format!("{name}, r = {}, F = {friction}", column.r);
                assert_eq!(point.pattern, Pattern::of(&response), "{what}");
                let own = own.as_ref().unwrap();
                let off = |found: f64, expected: f64| (found - expected).abs() <= 1e-9 * expected;
                assert!(off(point.amplitudes[1], amplitude), "{what}");
                assert!(off(own.amplitudes[1], amplitude * load), "{what}");
                let stuck = scaled.limits.sliding <= friction;
                assert_eq!(stuck, at.limits().sliding <= friction / load, "{what}");
            }
            let limits = [at.limits().continuous, at.limits().sliding];
            for boundary in boundaries.iter().filter(|of| of.r == column.r) {
                let exact = boundary.width == 0.0;
                assert!(!exact || limits.contains(&boundary.beta), "{boundary:?}");
                let off = boundary.at_reference(2).beta / (boundary.beta * load) - 1.0;
                assert!(off.abs() < 1e-14);
            }
        }
        let lines = system.limit_lines(0.5, 1.5, 1e-3).unwrap().at_reference(2);
        for &(r, limits) in lines.points.iter().step_by(50) {
            let expected = system.at(r).unwrap().limits().sliding / (r * r);
            let off = limits.sliding / expected - 1.0;
            assert!(off.abs() < 1e-14, "{name}, r = {r}");
        }
    }
}

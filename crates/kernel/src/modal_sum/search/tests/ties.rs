//! Tests of sums with equal maxima, of a minimum at the start, and of a search that reaches its bound.

use super::whole::scanned;
use super::*;

/// Returns a sum of sinusoids at multiples k of the excitation frequency: Σ b·sin kτ over `sines` plus Σ c·cos kτ over
/// `cosines`.
fn harmonics(sines: &[(f64, f64)], cosines: &[(f64, f64)]) -> (Vec<TestWave>, f64, f64) {
    let (mut waves, mut cosine, mut sine) = (Vec::new(), 0.0, 0.0);
    for &(k, b) in sines {
        if k == 1.0 {
            sine += b;
        } else {
            waves.push(Wave {
                free: k * b,
                ..at_rest(k, 0.0)
            });
        }
    }
    for &(k, c) in cosines {
        cosine += c;
        if k != 1.0 {
            waves.push(Wave {
                forced_slope: -c,
                ..at_rest(k, 0.0)
            });
        }
    }
    waves.sort_by(|a, b| a.x.total_cmp(&b.x));
    (waves, cosine, sine)
}

fn motion_problem() -> SearchSettings<f64> {
    SearchSettings {
        tolerance: 4.0 * f64::EPSILON,
        ..asked(Weight::One, true, 0.0)
    }
}

/// Returns the positions of the maxima in ascending order, each with a flag for a maximum of the negative of the sum.
fn places(peak: &Peak<f64>) -> Vec<(f64, bool)> {
    let mut places: Vec<_> = peak
        .places
        .iter()
        .flatten()
        .map(|place| (place.tau, place.negative))
        .collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    places
}

/// Checks sums that are even or odd about the middle of the half period. Their maxima come in pairs, with distances
/// down to a seventh of a radian.
#[test]
fn equal_maxima_are_all_found() {
    let mut compared = 0;
    for (k, b) in [
        (3.0, 0.5),
        (3.0, 0.3),
        (5.0, -0.4),
        (7.0, 0.2),
        (11.0, 0.3),
        (15.0, 0.2),
        (19.0, 0.1),
        (31.0, 0.5),
        (43.0, 0.1),
    ] {
        for odd in [false, true] {
            let (waves, cosine, sine) = if odd {
                harmonics(&[], &[(1.0, 1.0), (k, -f64::abs(b))])
            } else {
                harmonics(&[(1.0, 1.0), (k, b)], &[])
            };
            let sum = Sum {
                waves: &waves,
                cosine,
                sine,
            };
            let want = scanned(&search(sum, motion_problem(), 0.0));
            {
                let peak = largest(sum, motion_problem());
                assert!((peak.value / want - 1.0).abs() < 1e-13, "{k}, {b}, {odd}");
                let places = places(&peak);
                // For these coefficients b, the middle of the half period is never a maximum of a sum that is even
                // about the middle.
                let [(first, sign), (second, other)] = places[..] else {
                    panic!("{k}, {b}, odd {odd}: {places:?}");
                };
                assert!(
                    (first + second - PI).abs() < 1e-7,
                    "{k}, {b}, odd {odd}: {places:?}"
                );
                assert_eq!(sign != other, odd, "{k}, {b}: {places:?}");
                compared += 1;
            }
        }
    }
    println!("{compared} searches for pairs");
    assert_eq!(compared, 18);
}

/// Checks that the result of a search contains four positions if seven maxima are equal. Maxima at the two bounds of
/// the half period count as one maximum.
#[test]
fn a_peak_keeps_four_places() {
    let (waves, cosine, sine) = harmonics(&[(7.0, 1.0)], &[]);
    let peak = largest(
        Sum {
            waves: &waves,
            cosine,
            sine,
        },
        motion_problem(),
    );
    let found = places(&peak);
    assert_eq!(found.len(), 4);
    for (tau, negative) in found {
        let turns = tau * 7.0 / PI - 0.5;
        assert!((turns - turns.round()).abs() < 1e-7, "{tau}");
        assert_eq!(negative, turns.round() as u32 % 2 == 1, "{tau}");
    }
    let (waves, cosine, sine) = harmonics(&[], &[(1.0, 1.0), (3.0, 0.4)]);
    let sum = Sum {
        waves: &waves,
        cosine,
        sine,
    };
    assert_eq!(places(&largest(sum, motion_problem())).len(), 1);
}

/// Checks a mode that is so fast that the search would have to evaluate each of its 5·10⁴ turns. The search must stop
/// at its bound and return the largest value found.
#[test]
fn a_search_that_takes_too_long_ends_with_the_best_so_far() {
    let waves = [Wave {
        free: 1e5,
        ..at_rest(1e5 + 0.3, 0.0)
    }];
    let sum = Sum {
        waves: &waves,
        cosine: 0.0,
        sine: 0.0,
    };
    let peak = largest(sum, motion_problem());
    let most = most_evaluations(Weight::One, 1e5 + 0.3);
    println!("{} evaluations of {most}", peak.evaluations);
    assert!(most < MAX_EVALUATIONS);
    // The search stops if one more grid and its local maxima might exceed the bound.
    assert!(peak.evaluations <= most && peak.evaluations > most - 32);
    assert!(peak.exceeded && peak.effort() == Effort::Exceeded);
    assert!((peak.value * (1e5 + 0.3) / 1e5 - 1.0).abs() < 1e-9);
    assert!(peak.places[0].is_some());
}

/// Checks a sum whose slope is exactly 0 at its minimum. The search must not take the minimum for a maximum.
#[test]
fn a_minimum_at_the_start_is_left() {
    for (k, b) in [(3.0, 0.3), (5.0, 0.1), (9.0, 0.02)] {
        let (waves, cosine, sine) = harmonics(&[], &[(1.0, 1.0), (k, -b)]);
        let sum = Sum {
            waves: &waves,
            cosine,
            sine,
        };
        assert!(sum.slope(&Instant::new(0.0)) == 0.0);
        let want = scanned(&search(sum, motion_problem(), 0.0));
        let peak = largest(sum, motion_problem());
        assert!(
            (peak.value / want - 1.0).abs() < 1e-13,
            "{k}: {peak:?}, not {want}"
        );
        assert!(peak.evaluations < 500, "{k}: {peak:?}");
    }
}

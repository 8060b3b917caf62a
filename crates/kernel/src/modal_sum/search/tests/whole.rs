//! Tests of whole searches. The tests compare the largest value with that of a dense scan, and limit the number of
//! evaluations.

use super::*;

/// Returns the largest quotient from a scan with 24 points per turn of the fastest mode, refined by golden sections.
pub fn scanned(search: &TestSearch<'_>) -> f64 {
    let end = search.problem.end;
    let rate = search
        .sum
        .waves
        .iter()
        .map(|wave| wave.x)
        .fold(2.0, f64::max);
    let points = (24.0 * rate) as usize;
    let quotient = |tau: f64| {
        let value = sum_derivative(&search.sum, tau, 0);
        let one = |value: f64, negative: bool| match search.problem.weight {
            Weight::One => value,
            Weight::Sine => value / tau.sin() - search.signed(0.0, negative),
        };
        let plus = one(value, false);
        if search.problem.both_signs {
            plus.max(one(-value, true))
        } else {
            plus
        }
    };
    // The scan stops 10⁻⁵ before its end, because towards π the rounding error of the sum is divided by a sine close
    // to 0.
    let at = |i: usize| (end * (i as f64 + 0.01) / points as f64).min(end - 1e-5);
    let values: Vec<f64> = (0..=points).map(|i| quotient(at(i))).collect();
    let most = values.iter().copied().fold(f64::MIN, f64::max);
    let mut best = most;
    for i in 0..=points {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(points));
        if values[i] < values[before].max(values[after]) || values[i] < most - 0.1 * most.abs() {
            continue;
        }
        let (mut low, mut high) = (at(before), at(after));
        for _ in 0..40 {
            let width = 0.618_033_988_749_894_8 * (high - low);
            if quotient(high - width) < quotient(low + width) {
                low = high - width;
            } else {
                high = low + width;
            }
        }
        best = best.max(quotient(0.5 * (low + high)));
    }
    best
}

#[test]
fn no_maximum_of_a_random_sum_is_missed() {
    let mut random = Lcg(47);
    let mut counts = [Vec::new(), Vec::new()];
    let mut floors = 0;
    for case in 0..700 {
        let sine = case % 2 == 0;
        let undamped = case % 3 == 0;
        let drawn = Drawn::new(&mut random, (0.05, 60.0), undamped, sine);
        let (sum, problem) = (drawn.sum(), drawn.problem);
        let want = scanned(&search(sum, problem, 0.0));
        let problem = SearchSettings {
            tolerance: 4.0 * f64::EPSILON,
            ..problem
        };
        let found = largest(sum, problem);
        let most = most_evaluations(problem.weight, sum.fastest());
        assert!(!found.exceeded && found.evaluations <= most, "case {case}");
        if found.places[0].is_none() {
            // The search returns the floor, the smallest value that it looks for. A quotient of the scan may be
            // slightly larger, because sum and sin τ both vanish at τ = 0.
            assert!(want < 1e-6, "case {case}: {want} above the floor");
            floors += 1;
            continue;
        }
        let scale = want.abs() + problem.start;
        // Bound on the rounding error of sum/sin τ, in a scan that stops 10⁻⁵ before π.
        let bar = 1e-9 * scale;
        let value = found.value;
        assert!(value >= want - bar, "case {case}: {value} below {want}");
        assert!(
            sine || value <= want + bar,
            "case {case}: {value} above {want}"
        );
        counts[usize::from(sine)].push(found.evaluations);
    }
    // Bounds on the median, the 90th percentile and the largest number of evaluations. Each bound is a quarter above
    // the measured number.
    let most = [(213, 531, 1225), (91, 134, 980)];
    for ((name, counts), most) in ["plain", "over sin τ"].iter().zip(&mut counts).zip(most) {
        counts.sort_unstable();
        let n = counts.len();
        let (median, nine_tenths, worst) = (counts[n / 2], counts[n * 9 / 10], counts[n - 1]);
        println!("{name}: {n} searches, median {median}, 90 % {nine_tenths}, worst {worst}");
        assert!(
            median <= most.0 && nine_tenths <= most.1 && worst <= most.2,
            "{name}"
        );
    }
    println!("{floors} at the floor");
    assert_eq!(counts[0].len() + counts[1].len() + floors, 700);
}

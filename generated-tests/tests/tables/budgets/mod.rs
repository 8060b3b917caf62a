//! Measures the largest error of every numeric function of the kernel, and compares it with an allowed error, the
//! budget.
//!
//! `docs/data/accuracy.csv` has the budgets, and the largest errors with their arguments. `f64` measures `f32`,
//! double-double measures `f64`, and big numbers ([`big`]) measure double-double. Big numbers share nothing with the
//! kernel and evaluate the formulas as they are printed.
//!
//! With ε = 2⁻²³ for `f32`, 2⁻⁵² for `f64` and 2⁻¹⁰⁴ for double-double, the units of an error of the result f are:
//!
//! * `ulp`: ε times the largest power of two that is not above |f|.
//! * `norm`: ε times the length of f, where all results of the function together are a vector.
//! * `mixed`: ε·(|f| + Σ|a·∂f/∂a|), with the sum over the arguments a. An error of at most 1 is that of a relative
//!   change of ε in each argument and in the result.
//! * `size`: ε·(|f| + Σ|a·∂f/∂a| + A). A is the size of a larger number to which the code adds f ([`modes`]).
//!
//! A damping function or a reversal's term is multiplied by |x² − 1| + 2ζx, with x = √λ/r of the mode. This factor
//! removes the common pole.
//!
//! The long form evaluates every `f32` of each domain and draws ten million `f64`:
//!
//! ```sh
//! cargo test --release -p generated-tests --test tables budgets:: -- --ignored --nocapture
//! UPDATE_ACCURACY=1 cargo test --release -p generated-tests --test tables budgets:: -- --ignored   # writes accuracy.csv
//! BUDGETS_ONLY='basis+(Dd)' …                                              # only these functions
//! ```

mod big;
mod blocks;
mod cases;
mod draw;
mod elementary;
mod measure;
mod modes;
mod table;

use cases::Case;
use draw::Source;
use fuzzing::Random;
use measure::Arguments;
use std::sync::Mutex;
use table::Row;

/// Largest error of the reference, in units of the measured scalar type. For example, ten units of `f64` are at most
/// 1e-7 units of `f32`.
const REFERENCE: f64 = 1e-7;

fn asked_to_write() -> bool {
    std::env::var_os("UPDATE_ACCURACY").is_some()
}

/// Returns the largest error of each result of a case, with the arguments of that error.
fn measured(case: &Case, points: impl Iterator<Item = Arguments>) -> Vec<(f64, Arguments)> {
    let mut worst = vec![(-1.0, Arguments::default()); case.fields.len()];
    for point in points {
        for (worst, error) in worst.iter_mut().zip((case.error)(&point)) {
            if error > worst.0 {
                *worst = (error, point);
            }
        }
    }
    worst
}

fn random(case: &Case, seed: u64, count: usize) -> impl Iterator<Item = Arguments> {
    let mut source = Source(Random(seed));
    (0..count).map(move |_| (case.draw)(&case.domain, &mut source))
}

fn name(case: &Case, field: &str) -> String {
    format!("{} {field} ({})", case.function, case.scalar)
}

#[test]
fn every_function_stays_within_its_budget() {
    let table = table::read();
    for case in cases::all() {
        let rows = table::rows_of(&table, &case)
            .unwrap_or_else(|| panic!("{}: no row of this unit and domain", name(&case, "")));
        let count = if case.scalar == "Dd" { 20 } else { 2000 };
        let worst = measured(&case, random(&case, 1, count));
        for (i, (row, (error, place))) in rows.iter().zip(worst).enumerate() {
            let what = name(&case, case.fields[i]);
            assert!(
                error <= row.budget + REFERENCE,
                "{what}: {error} exceeds {} at {place:?}",
                row.budget
            );
            // With the arguments in the table, the present code must not exceed the budget either.
            let again = (case.error)(&row.place)[i];
            assert!(
                again <= row.budget + REFERENCE,
                "{what}: {again} exceeds {}",
                row.budget
            );
            assert!(
                (again - row.worst).abs() <= 1e-3 * row.worst + REFERENCE,
                "{what}: {again} at its worst place instead of {}",
                row.worst
            );
        }
    }
}

#[test]
fn every_row_is_measured() {
    let cases = cases::all();
    for row in table::read() {
        assert!(
            cases.iter().any(|case| {
                case.function == row.function
                    && case.scalar == row.scalar
                    && case.fields.contains(&row.result.as_str())
            }),
            "nothing measures {row:?}"
        );
    }
}

/// Tests values for which units in the last place mean nothing: signs of zeros, infinities, NaN, and the bounds of
/// the range of a scalar type.
fn ends_of_the_range<T: measure::Real>(least: f64, largest: f64) {
    use frictiongen_kernel::number::special::{exp_m1_minus, versine_pi};
    let c = T::constant;
    let of = |f: fn(T) -> T, x: f64| f(c(x)).to_f64();
    let infinity = f64::INFINITY;
    for zero in [0.0, -0.0] {
        let functions: [fn(T) -> T; 7] = [
            T::sin_pi,
            T::sqrt,
            T::exp_m1,
            T::one_minus_sinc_pi,
            T::scaled_sinh_defect,
            versine_pi,
            exp_m1_minus,
        ];
        assert!(functions.iter().all(|f| of(*f, zero) == 0.0));
        assert_eq!([of(T::exp, zero), of(T::cos_pi, zero)], [1.0, 1.0]);
        // For an angle of π or −π, the sign of a zero must not decide which of the two is returned.
        assert!(c(zero).atan2(c(-1.0)).to_f64() > 3.0);
    }
    let functions: [fn(T) -> T; 8] = [
        T::sin_pi,
        T::cos_pi,
        T::exp,
        T::exp_m1,
        T::one_minus_sinc_pi,
        T::scaled_sinh_defect,
        versine_pi,
        exp_m1_minus,
    ];
    assert!(functions.iter().all(|f| of(*f, f64::NAN).is_nan()));
    assert!(of(T::sin_pi, infinity).is_nan() && of(versine_pi, -infinity).is_nan());
    assert_eq!(
        [of(T::exp, -infinity), of(T::exp, infinity)],
        [0.0, infinity]
    );
    assert_eq!(
        [of(T::exp_m1, -infinity), of(T::exp_m1, infinity)],
        [-1.0, infinity]
    );
    assert_eq!(
        [of(exp_m1_minus, -infinity), of(exp_m1_minus, infinity)],
        [infinity, infinity]
    );
    assert_eq!(
        [of(T::scaled_sinh_defect, infinity), of(T::sqrt, infinity)],
        [1.0, infinity]
    );
    assert_eq!([of(T::sin_pi, largest), of(T::cos_pi, largest)], [0.0, 1.0]);
    assert_eq!(
        [
            of(T::one_minus_sinc_pi, largest),
            of(T::scaled_sinh_defect, largest)
        ],
        [1.0, 1.0]
    );
    // π times the smallest number is rounded, and the square and the cube of this number are 0.
    assert_eq!(
        [of(T::sin_pi, least), of(T::exp_m1, least)],
        [3.0 * least, least]
    );
    assert_eq!(
        [of(T::one_minus_sinc_pi, least), of(exp_m1_minus, -least)],
        [0.0, 0.0]
    );
}

#[test]
fn ends_of_every_range() {
    ends_of_the_range::<f32>(f32::from_bits(1).into(), f32::MAX.into());
    ends_of_the_range::<f64>(f64::from_bits(1), f64::MAX);
}

#[test]
fn the_measure_sees_an_error() {
    use frictiongen_kernel::number::dd::Dd;
    use measure::{Formula, Real, Results, against, against_big};
    /// The function 1 + x with a deliberate error of two units in `f64`, which the measurement must detect.
    struct Wrong;
    impl Formula for Wrong {
        fn at<T: Real>([x, ..]: [T; 3]) -> Results<T> {
            let c = T::constant;
            let off = if T::NAME == "f64" {
                2.0 * f64::EPSILON
            } else {
                0.0
            };
            [c(1.0) + x + c(off), c(0.0), c(0.0), c(0.0), c(0.0)]
        }
        fn printed([x, ..]: [big::Big; 3]) -> Option<Vec<big::Big>> {
            Some(vec![big::Big::integer(2) + x])
        }
    }
    let quarter = [Dd::from(0.25), Dd::ZERO, Dd::ZERO];
    assert_eq!(against::<Wrong, f64, Dd>(&quarter)[0], 2.0);
    assert_eq!(against::<Wrong, f32, Dd>(&quarter)[0], 0.0);
    assert!(against_big::<Wrong>(&quarter)[0] > 1e30);
}

/// Returns the number of random points in the long form. The functions of a mode have separate points for each kind
/// of mode, ten million in total.
fn points(case: &Case) -> usize {
    match case.scalar {
        "Dd" => 10_000,
        _ if case.function.contains(',') => 2_000_000,
        _ => 10_000_000,
    }
}

#[test]
#[ignore = "minutes; cargo test --release -p generated-tests --test tables budgets:: -- --ignored --nocapture"]
fn long_form() {
    let only = std::env::var("BUDGETS_ONLY").unwrap_or_default();
    let old = table::read();
    let cases: Vec<Case> = cases::all();
    let next = Mutex::new(cases.iter().enumerate());
    let found: Mutex<Vec<(usize, Vec<Row>)>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let Some((i, case)) = next.lock().expect("a case").next() else {
                        break;
                    };
                    let rows = if only.split('+').any(|part| name(case, "").contains(part)) {
                        long_rows(case, &old)
                    } else {
                        table::rows_of(&old, case).unwrap_or_default()
                    };
                    found.lock().expect("rows").push((i, rows));
                }
            });
        }
    });
    let mut found = found.into_inner().expect("rows");
    found.sort_by_key(|(i, _)| *i);
    let rows: Vec<Row> = found.into_iter().flat_map(|(_, rows)| rows).collect();
    if asked_to_write() {
        table::write(&rows);
    }
    for row in &rows {
        let Row {
            function,
            result,
            scalar,
            budget,
            worst,
            ..
        } = row;
        assert!(
            *worst <= budget + REFERENCE,
            "{function} {result} ({scalar}): {worst} exceeds {budget}"
        );
    }
}

fn long_rows(case: &Case, old: &[Row]) -> Vec<Row> {
    let known = table::rows_of(old, case);
    let stored = known.iter().flatten().map(|row| row.place);
    let every = random(case, 2, points(case))
        .chain(case.counted())
        .chain(stored);
    let worst = measured(case, every);
    let rows = case
        .fields
        .iter()
        .zip(worst)
        .enumerate()
        .map(|(i, (field, (worst, place)))| {
            let budget = known
                .as_ref()
                .map_or(table::first_budget(worst), |rows| rows[i].budget);
            let [x, y, z] = place.map(|a| a.hi);
            println!(
                "{:50} {worst:9.3} of {budget:5} {:5} at {x:e} {y:e} {z:e}",
                name(case, field),
                case.unit.name()
            );
            Row {
                function: case.function.into(),
                result: (*field).into(),
                scalar: case.scalar.into(),
                unit: case.unit.name().into(),
                budget,
                worst,
                place,
                domain: case.domain.text.into(),
            }
        });
    rows.collect()
}

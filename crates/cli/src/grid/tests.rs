//! Tests the parser of grids.

use super::{GridQuantity, MOST_POINTS, parse};

fn ratios(text: &str) -> Vec<f64> {
    parse(text, GridQuantity::FrequencyRatio).expect("a grid")
}

fn error(text: &str, quantity: GridQuantity) -> String {
    parse(text, quantity).expect_err("no grid").to_string()
}

#[test]
fn numbers_and_lists() {
    assert_eq!(ratios("0.9"), [0.9]);
    assert_eq!(ratios(" 1e-1 , 2.,+3 "), [0.1, 2.0, 3.0]);
    assert_eq!(
        ratios("0,inf,Infinity"),
        [0.0, f64::INFINITY, f64::INFINITY]
    );
    assert_eq!(ratios("2,0:0.5:1,3"), [2.0, 0.0, 0.5, 1.0, 3.0]);
    assert!(ratios("-0").iter().all(|value| value.is_sign_positive()));
    assert_eq!(ratios("1e-400"), [0.0]);
}

#[test]
fn ranges_include_their_end_and_are_not_accumulated() {
    assert_eq!(ratios("0:0.1:0.3"), [0.0, 0.1, 0.2, 0.3]);
    assert_eq!(ratios("1:-0.25:0.5"), [1.0, 0.75, 0.5]);
    assert_eq!(ratios("0:0.4:1"), [0.0, 0.4, 0.8]);
    assert_eq!(ratios("1:5:1"), [1.0]);
    assert_eq!(ratios("1:-5:1"), [1.0]);
    assert_eq!(ratios("1:5:2"), [1.0]);
    let grid = ratios("0.2:0.01:2.5");
    assert_eq!(grid.len(), 231);
    assert_eq!(grid.last(), Some(&2.5));
    for (index, value) in (20_u32..).zip(&grid) {
        assert_eq!(*value, f64::from(index) / 100.0);
    }
}

/// Checks that the points of a decimal grid equal the decimal numbers, for grids of any length and any exponents.
#[test]
fn decimal_points() {
    let (mut compared, mut differ) = (0, 0);
    for (text, first, step, places) in [
        ("0.1:0.1:100", 1_i64, 1_i64, 1),
        ("0.05:0.05:1.0", 5, 5, 2),
        ("2.5:-0.001:0.0004", 25_000, -10, 4),
        ("1e-3:3e-5:.25E0", 100, 3, 5),
        ("+0.70:0.07:7e1", 70, 7, 2),
    ] {
        let scale = 10_i64.pow(places);
        for (index, value) in (0..).zip(ratios(text)) {
            let number = first + index * step;
            let width = places as usize;
            let written = format!("{}.{:0width$}", number / scale, number % scale);
            assert_eq!(value, written.parse::<f64>().unwrap(), "{text}: {written}");
            let binary =
                (first as f64 + 0.0) / scale as f64 + index as f64 * (step as f64 / scale as f64);
            differ += usize::from(value != binary);
            compared += 1;
        }
    }
    // The test is meaningful only if steps in binary floating point would give wrong points in many of these grids.
    assert!(
        compared == 1000 + 20 + 2500 + 8301 + 991 && differ > 1000,
        "{compared} {differ}"
    );
}

#[test]
fn numbers_too_long_to_be_held_are_read_all_the_same() {
    let third = "0.3333333333333333333333333333333333333333";
    assert_eq!(ratios(&format!("0:{third}:1")).len(), 4);
    assert_eq!(ratios("1e-300:1e-2:0.02").len(), 3);
    assert_eq!(ratios("0:1e100:3e100"), [0.0, 1e100, 2e100, 3e100]);
}

#[test]
fn every_decimal_range_has_its_end() {
    for tenths in 1_u32..200 {
        for steps in 1_u32..60 {
            let step = f64::from(tenths) / 1000.0;
            let last = f64::from(tenths * steps + 7) / 1000.0;
            let text = format!("0.007:{step}:{last}");
            let grid = ratios(&text);
            assert_eq!(grid.len() as u32, steps + 1, "{text}");
            assert_eq!(grid.last(), Some(&last), "{text}");
            assert!(grid.is_sorted(), "{text}");
        }
    }
}

#[test]
fn ranges_do_not_go_beyond_their_end() {
    for text in ["0:0.3:1", "0:0.7:0.69999999", "0.1:0.1:0.99999999"] {
        let last: f64 = text.rsplit(':').next().unwrap().parse().unwrap();
        assert!(ratios(text).iter().all(|value| *value <= last), "{text}");
    }
}

#[test]
fn as_many_points_as_there_may_be() {
    assert_eq!(ratios("1:1:10000000").len(), MOST_POINTS);
    let most = "more than 10000000 points, the largest possible number";
    for text in [
        "0:1:10000000",
        "0:1e-300:1e300",
        "0:1e-320:1",
        "0:5e-324:1e308",
    ] {
        assert_eq!(
            error(text, GridQuantity::FrequencyRatio),
            format!("--r `{text}`: {most}")
        );
    }
    assert_eq!(
        error("1:1:10000000,4", GridQuantity::FrequencyRatio),
        format!("--r `4`: {most}")
    );
}

#[test]
fn bad_grids() {
    let cases = [
        ("", "--r ``: a number is missing"),
        ("1,", "--r ``: a number is missing"),
        ("1,,2", "--r ``: a number is missing"),
        (
            "1:2:3:4",
            "--r `1:2:3:4`: a grid is a number, or a range a:step:b",
        ),
        ("1::3", "--r `1::3`: a number is missing"),
        ("x", "--r `x`: `x` is not a number"),
        ("1:x:3", "--r `1:x:3`: `x` is not a number"),
        ("nan", "--r `nan`: a number is needed, not NaN"),
        ("0:nan:1", "--r `0:nan:1`: a number is needed, not NaN"),
        (
            "1e999",
            "--r `1e999`: `1e999` is too large; write inf for infinity",
        ),
        ("0:1:inf", "--r `0:1:inf`: a range needs finite numbers"),
        ("0:inf:1", "--r `0:inf:1`: a range needs finite numbers"),
        ("0:0:1", "--r `0:0:1`: the step must not be 0"),
        ("1:-0:1", "--r `1:-0:1`: the step must not be 0"),
        (
            "0:-0.1:1",
            "--r `0:-0.1:1`: from 0.0 to 1.0 the step must be positive",
        ),
        (
            "1:0.1:0",
            "--r `1:0.1:0`: from 1.0 to 0.0 the step must be negative",
        ),
        ("-1", "--r `-1`: a frequency ratio must not be negative"),
        ("-inf", "--r `-inf`: a frequency ratio must not be negative"),
        (
            "-1:1:1",
            "--r `-1:1:1`: a frequency ratio must not be negative",
        ),
    ];
    for (text, message) in cases {
        assert_eq!(error(text, GridQuantity::FrequencyRatio), message);
    }
}

#[test]
fn friction_ratios_are_finite() {
    assert_eq!(
        error("0,inf", GridQuantity::FrictionRatio),
        "--beta `inf`: a friction ratio must be finite"
    );
    assert_eq!(
        error("-0.1", GridQuantity::FrictionRatio),
        "--beta `-0.1`: a friction ratio must not be negative"
    );
}

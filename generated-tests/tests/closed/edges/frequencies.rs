//! Tests natural frequencies that are far apart, against references with 40 digits.

use frictiongen::study::System;
use frictiongen_kernel::Float;
use generated_tests::reference::{description, extremes, list_of, number};

/// Tolerance relative to each frequency, including frequencies many decades below the largest one.
const TOLERANCE: f64 = 1e-14;

fn worst<S: Float>() -> (f64, String) {
    let mut worst = (0.0, String::new());
    let mut compared = 0;
    for scene in extremes() {
        let system: System<S> = description(&scene).parse().expect("a valid scene");
        let got = system.resonances();
        let wanted = list_of(&scene["natural_frequency_ratios"], got.len(), "frequencies");
        for (got, want) in got.iter().zip(wanted) {
            let error = (got.to_f64() / number(want) - 1.0).abs();
            compared += 1;
            if !(error <= worst.0) {
                worst = (error, format!("{}: {got:?} for {want}", scene["name"]));
            }
        }
    }
    println!("{compared} compared, none skipped");
    assert_eq!(compared, 63);
    worst
}

#[test]
fn of_twelve_decades() {
    let (error, place) = worst::<f64>();
    println!("natural frequencies, f64: {error:.2e} {place}");
    assert!(error <= TOLERANCE, "{error:e} at {place}");
    // The constant is rounded once, so its error is at most half a unit of the last place.
    let (error, place) = worst::<f32>();
    println!("natural frequencies, f32: {error:.2e} {place}");
    assert!(
        error <= 0.5 * f64::from(f32::EPSILON) * 1.0001,
        "{error:e} at {place}"
    );
}

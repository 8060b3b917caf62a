//! Tests antiresonances and invariant points. The search must miss no zero, and must return no wrong one.

use super::count::{Count, sign_changes};
use super::sums::Modes;
use super::{DENSE, dense};
use crate::features::scenes::{random, shown};
use frictiongen::study::features::InvariantQuantity;
use frictiongen::{LimitsAt, Of};
use fuzzing::Random;

#[test]
fn undamped_functions() {
    let mut random_numbers = Random(22);
    let mut count = Count::default();
    for scene in 0..30 {
        let system = random(&mut random_numbers, 10, false);
        let largest = *system.resonances().last().unwrap();
        let range = [0.12 * largest, 1.5 * largest];
        let places = dense(range, DENSE);
        let step = (1.0 / range[0] - 1.0 / range[1]) / DENSE as f64;
        let mass = scene % system.scene().masses.len();
        let modes = Modes::new(&system, mass);
        let what = shown(&system);
        let features = system.features(None).unwrap();
        let at = |r: f64| modes.at(r);
        let free: Vec<f64> = features
            .antiresonances(Of::Contact, range)
            .unwrap()
            .iter()
            .map(|zero| zero.r)
            .collect();
        let of_v = |r: f64| at(r).v;
        count.add(
            &free,
            &sign_changes(&places, of_v),
            step,
            &modes.resonances,
            &[Box::new(of_v)],
            &format!("V, {what}"),
        );
        if modes
            .contacts
            .iter()
            .zip(&modes.shapes)
            .all(|(w, shape)| w * shape == 0.0)
        {
            continue;
        }
        let of = Of::Mass(mass);
        let as_contact = system.modal().rubbing() == Some(mass) && modes.of_base == 0.0;
        for measured in [InvariantQuantity::Amplitude, InvariantQuantity::Fundamental] {
            let points = features.invariant_points(of, measured, range).unwrap();
            let mut wanted = Vec::new();
            let functions: Vec<Box<dyn Fn(f64) -> f64>> = match (measured, as_contact) {
                (InvariantQuantity::Amplitude, true) => vec![Box::new(|r| at(r).u)],
                (InvariantQuantity::Amplitude, false) => vec![
                    Box::new(|r| at(r).own_u),
                    Box::new(|r| {
                        let sums = at(r);
                        if system.modal().rubbing() == Some(mass) {
                            // Here U_k = U, so the condition U_k = 0 already covers this factor.
                            sums.v - 2.0 * sums.own_v
                        } else {
                            sums.v * sums.own_u - 2.0 * sums.own_v * sums.u
                        }
                    }),
                ],
                (InvariantQuantity::Fundamental, _) => vec![
                    Box::new(|r| at(r).own_h),
                    Box::new(|r| {
                        let sums = at(r);
                        let share = std::f64::consts::FRAC_2_PI;
                        if as_contact {
                            sums.u + share * sums.h
                        } else {
                            sums.own_v * sums.u + share * sums.own_h * sums.v
                        }
                    }),
                ],
            };
            for function in &functions {
                wanted.extend(sign_changes(&places, function));
            }
            // Where the contact does not move without friction, there is no motion that could be invariant.
            wanted.retain(|r| system.at(*r).unwrap().continuous_limit() > 1e-10);
            let found: Vec<f64> = points.iter().map(|point| point.r).collect();
            count.add(
                &found,
                &wanted,
                step,
                &modes.resonances,
                &functions,
                &format!("{measured:?} of {mass}, {what}"),
            );
        }
    }
    println!(
        "{} zeros, {} more than the samples show",
        count.compared, count.more
    );
    assert!(count.compared > 600, "{}", count.compared);
}

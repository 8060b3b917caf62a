//! `reference/extremes.json`: beside poles and sub-harmonics, at vanishing, critical and over-critical
//! damping, for spreads of twelve decades, at nearly equal modes, at r = 0 and r = ∞.

use crate::asked::{Asked, Place, answer};
use crate::measure::{Error, Judge, Scene};
use frictiongen::study::System;
use frictiongen_codegen::{Limits, parse_text};
use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::{Complex, Float};
use frictiongen_model::modal::Modal;
use generated_tests::data::Data;
use serde_json::Value;
use std::collections::BTreeMap;

/// In roundings, 2^-52 of each input.
const BAR: f64 = 64.0;

fn scenes() -> Vec<Value> {
    serde_json::from_str(include_str!("../../reference/extremes.json")).expect("JSON")
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// A decimal number to 30 digits.
fn exact(value: &Value) -> Dd {
    let text = value
        .as_str()
        .map_or_else(|| value.to_string(), str::to_owned);
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let (negative, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let ten = Dd::from(10.0);
    let mut sum = Dd::from(0.0);
    for digit in whole.chars().chain(fraction.chars()) {
        sum = sum * ten + Dd::from(f64::from(digit.to_digit(10).expect("a digit")));
    }
    let places = exponent - i32::try_from(fraction.len()).expect("few digits");
    for _ in 0..places.abs() {
        sum = if places < 0 { sum / ten } else { sum * ten };
    }
    if negative { -sum } else { sum }
}

/// A number that the reference gives as an exact double.
fn double(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number"),
        value => value.as_f64().expect("a number"),
    }
}

struct Case {
    name: String,
    place: Place<f64>,
    asked: Asked,
    want: Dd,
}

fn cases(scene: &Value) -> Vec<Case> {
    let mut cases = Vec::new();
    for point in list(&scene["points"]) {
        let r = double(&point["r"]);
        let mut add = |beta: f64, asked: Asked, value: &Value| {
            if !value.is_null() {
                cases.push(Case {
                    name: format!("{}, r = {r}, beta = {beta}", scene["name"]),
                    place: Place { r, beta, tau: 1.0 },
                    asked,
                    want: if value == "inf" {
                        Dd::from(f64::INFINITY)
                    } else {
                        exact(value)
                    },
                });
            }
        };
        add(0.0, Asked::ContinuousLimit, &point["continuous_limit"]);
        add(
            0.0,
            Asked::WithoutSearch,
            &point["continuous_limit_without_search"],
        );
        add(0.0, Asked::SlidingLimit, &point["sliding_limit"]);
        for motion in list(&point["motions"]) {
            let beta = double(&motion["beta"]);
            add(beta, Asked::ContactAmplitude, &motion["contact_amplitude"]);
            add(beta, Asked::ContactPhase, &motion["contact_phase"]);
            for (mass, value) in list(&motion["displacement_at_1"]).iter().enumerate() {
                add(beta, Asked::Displacement(mass), value);
            }
        }
    }
    cases
}

fn description(scene: &Value) -> &str {
    scene["description"].as_str().expect("a description")
}

fn modal(scene: &Value) -> Modal {
    let parsed = parse_text(description(scene), &Limits::RUN_TIME).expect("a valid scene");
    Modal::of(&parsed.scene)
}

fn data<S: Float>(modal: &Modal, to: impl Fn(Dd) -> S) -> Data<S> {
    Data {
        reduced: modal.reduced(to),
        contact: modal.contact,
    }
}

/// What a system answers through its public face.
fn ask<S: Float>(system: &System<S>, case: &Case) -> S {
    let constant = |value: f64| S::constant(value);
    let at = system.at(constant(case.place.r)).expect("in the domain");
    let motion = || {
        at.motion(constant(case.place.beta))
            .unwrap_or_else(|error| panic!("{}: {error}", case.name))
    };
    match case.asked {
        Asked::ContinuousLimit => at.continuous_limit(),
        Asked::WithoutSearch => at.continuous_limit_without_search(),
        Asked::SlidingLimit => at.sliding_limit(),
        Asked::ContactAmplitude => motion().contact().amplitude(),
        Asked::ContactPhase => motion().contact().phase(),
        Asked::Displacement(mass) => motion()
            .mass_at(mass)
            .expect("a mass")
            .displacement(constant(1.0)),
        other => panic!("the reference has no {other:?}"),
    }
}

fn real(value: Dd) -> Complex<Dd> {
    Complex::new(value, Dd::from(0.0))
}

/// The double-double reading, which serves as a reference elsewhere, against the reference: to the
/// 20 digits that it has, wherever the formulas have a condition below 1e10.
#[test]
fn double_double_is_a_reference() {
    let mut worst = (0.0, String::new());
    for scene in scenes() {
        let exact = Scene::new(data(&modal(&scene), |value| value));
        for case in cases(&scene) {
            if case.place.r == 0.0 || !case.place.r.is_finite() {
                continue;
            }
            let place = case.place.read(Dd::from);
            // In roundings of 2^-64, which is the reference's last digit.
            let judge = Judge::new(&exact, place, 2f64.powi(-64), 64.0);
            let got = answer(&judge.at, &place, case.asked);
            let error = judge.known(case.asked, got, case.want);
            if error.backward > worst.0 {
                worst = (
                    error.backward,
                    format!(
                        "{} {:?}: {:?} for {:?}",
                        case.name, case.asked, got.re, case.want
                    ),
                );
            }
        }
    }
    println!("double-double: {:.2} x 2^-64 at {}", worst.0, worst.1);
    assert!(worst.0 <= 1.0, "{} at {}", worst.0, worst.1);
}

/// Every value through the run-time system, in roundings of its inputs.
#[test]
fn every_value() {
    let mut worst: BTreeMap<&str, (Error, String)> = BTreeMap::new();
    let mut failures = Vec::new();
    for scene in scenes() {
        let system: System = description(&scene).parse().expect("a valid scene");
        let rounded = Scene::new(data(&modal(&scene), Dd::to_f64).read(Dd::from));
        for case in cases(&scene) {
            let got = ask(&system, &case);
            assert!(!got.is_nan(), "{}: {:?} is NaN", case.name, case.asked);
            if case.place.r == 0.0 || !case.place.r.is_finite() {
                let want = case.want.to_f64();
                assert!(
                    got == want || (got - want).abs() <= 4.0 * f64::EPSILON * want.abs(),
                    "{}: {got:e}, reference {want:e}",
                    case.name
                );
                continue;
            }
            let judge = Judge::new(&rounded, case.place.read(Dd::from), f64::EPSILON, BAR);
            let error = judge.known(case.asked, real(Dd::from(got)), case.want);
            let line = format!("{}: {got:e} for {:e}", case.name, case.want.to_f64());
            if !(error.backward <= BAR) {
                failures.push(format!("{:?} {line}: {error:?}", case.asked));
            }
            let entry = worst
                .entry(case.asked.kind())
                .or_insert_with(|| (error, line.clone()));
            if entry.0.backward < error.backward {
                *entry = (error, line);
            }
        }
    }
    for (kind, (error, line)) in &worst {
        println!(
            "{kind:>18}: backward {:.2}, forward {:.2e} at {line}",
            error.backward, error.forward
        );
    }
    assert!(
        failures.is_empty(),
        "{} failures:\n{}",
        failures.len(),
        failures.join("\n")
    );
}

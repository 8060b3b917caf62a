//! Questions as the page asks them, with answers from the library.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::answer;
use frictiongen::{Of, System};
use serde_json::{Value, json};

const FRAME: &str = include_str!("../scenes/01-shear-frame.friction");
const STOREYS: &str = include_str!("../scenes/09-frame-with-three-braces.friction");

/// Every scene of the page.
const SCENES: [&str; 10] = [
    FRAME,
    include_str!("../scenes/02-block-on-the-floor.friction"),
    include_str!("../scenes/03-block-on-its-base.friction"),
    include_str!("../scenes/04-stiction.friction"),
    include_str!("../scenes/05-two-masses-with-contact-between.friction"),
    include_str!("../scenes/06-chain-of-three.friction"),
    include_str!("../scenes/07-five-masses.friction"),
    include_str!("../scenes/08-braced-frame.friction"),
    STOREYS,
    include_str!("../scenes/10-bowed-board.friction"),
];

fn ask(question: Value) -> Value {
    serde_json::from_str(&answer(&question.to_string())).unwrap()
}

fn about(text: &str, ask_: &str, more: Value) -> Value {
    let mut question = json!({
        "ask": ask_, "text": text, "r": 0.9, "beta": 0.7, "from": 0.3, "to": 2.0, "of": 0, "work": 2000,
    });
    for (name, value) in more.as_object().unwrap() {
        question[name] = value.clone();
    }
    ask(question)
}

#[test]
fn every_scene_is_read_and_has_a_steady_state() {
    for text in SCENES {
        let scene = about(text, "scene", json!({}));
        assert!(scene["faults"].is_null(), "{text}: {scene}");
        assert!(scene["sketch"].as_str().unwrap().starts_with("<svg"));
        let orbit = about(text, "orbit", json!({}));
        assert!(orbit["error"].is_null(), "{text}: {orbit}");
        let masses = scene["masses"].as_array().unwrap().len();
        assert_eq!(orbit["motion"]["masses"].as_array().unwrap().len(), masses);
        assert!(orbit["loop"]["svg"].as_str().unwrap().starts_with("<svg"));
    }
}

#[test]
fn a_fault_has_its_line_and_column() {
    let text = FRAME.replace("lower - upper", "lower - uper");
    let told = about(&text, "scene", json!({}));
    let fault = &told["faults"][0];
    let column = text.lines().nth(3).unwrap().find("uper").unwrap() + 1;
    assert_eq!(
        (&fault["line"], &fault["column"]),
        (&json!(4), &json!(column))
    );
    assert!(fault["message"].as_str().unwrap().contains("uper"));
    for text in [
        "",
        "nonsense",
        "struct A {",
        "\u{0}",
        "struct É { masses: { a: 1e999 } }",
    ] {
        let told = about(text, "scene", json!({}));
        assert!(!told["faults"].as_array().unwrap().is_empty(), "{text}");
    }
}

#[test]
fn a_long_chain_and_a_long_text_get_a_message() {
    let masses: Vec<String> = (0..64).map(|i| format!("m{i}: 1")).collect();
    let springs: Vec<String> = (0..64)
        .map(|i| match i {
            0 => "base - m0: 1".to_owned(),
            _ => format!("m{} - m{i}: 1", i - 1),
        })
        .collect();
    let text = format!(
        "struct Long {{ masses: {{ {} }}, springs: {{ {} }}, contact: m9 - wall, excitation: base }}",
        masses.join(", "),
        springs.join(", ")
    );
    let told = about(&text, "scene", json!({}));
    assert!(
        told["faults"][0]["message"]
            .as_str()
            .unwrap()
            .contains("12 masses")
    );
    let told = about(&" ".repeat(30_000), "scene", json!({}));
    assert!(
        told["faults"][0]["message"]
            .as_str()
            .unwrap()
            .contains("30000")
    );
}

/// A slider rewrites the text between two positions, and the library then reads the new number.
#[test]
fn numbers_are_where_the_text_has_them() {
    for text in SCENES {
        // A comment with a wide character moves the positions of the bytes, but not those of the browser.
        let text = &format!(
            "// 𝄞: a: {{ 1 }}, /* \n{}",
            text.replace("masses:", "/* { /* , */ } */ masses:")
        );
        let units: Vec<u16> = text.encode_utf16().collect();
        let told = about(text, "scene", json!({}));
        let numbers = told["numbers"].as_array().unwrap();
        assert!(
            2 < numbers.len() + usize::from(text.contains("Block") || text.contains("Carried"))
        );
        for (index, number) in numbers.iter().enumerate() {
            let ends = [&number["start"], &number["end"]]
                .map(|end| usize::try_from(end.as_u64().unwrap()).unwrap());
            let written = String::from_utf16(&units[ends[0]..ends[1]]).unwrap();
            assert_eq!(
                written.parse::<f64>().unwrap(),
                number["value"],
                "{written}"
            );
            let new = 1.25 * number["value"].as_f64().unwrap();
            let changed = [
                String::from_utf16(&units[..ends[0]]).unwrap(),
                new.to_string(),
                String::from_utf16(&units[ends[1]..]).unwrap(),
            ]
            .concat();
            let told = about(&changed, "scene", json!({}));
            assert_eq!(told["numbers"][index]["value"], json!(new), "{changed}");
        }
    }
}

#[test]
fn the_orbit_is_that_of_the_library() {
    let system: System = FRAME.parse().unwrap();
    for (r, beta) in [(0.9, 0.3), (0.9, 0.7), (0.9, 1.0), (0.3, 0.4)] {
        let at = system.at(r).unwrap();
        let response = at.response(beta).unwrap();
        let told = about(FRAME, "orbit", json!({ "r": r, "beta": beta }));
        for mass in 0..2 {
            let swing = response.swing(Of::Mass(mass)).unwrap();
            assert_eq!(told["masses"][mass]["amplitude"], json!(swing.amplitude));
            let motion = told["motion"]["masses"][mass].as_array().unwrap();
            let largest = motion
                .iter()
                .map(|x| x.as_f64().unwrap().abs())
                .fold(0.0, f64::max);
            // 480 samples of a motion miss its maximum by less than (π/480)²/2 of the harmonics' amplitudes.
            assert!((largest - swing.amplitude).abs() < 1e-3 * swing.amplitude.max(0.1));
        }
    }
}

#[test]
fn quick_points_are_those_of_the_curve() {
    let curve = about(FRAME, "curve", json!({ "starts": ["rest"], "bare": true }));
    let points = curve["curves"][0].as_array().unwrap();
    assert!(100 < points.len());
    let mut compared = 0;
    for point in points.iter().step_by(7) {
        let told = about(FRAME, "points", json!({ "rs": [point[0]] }));
        // At a boundary of regimes the curve takes the limits from both sides.
        let (one, other) = (
            told["points"][0][1].as_f64().unwrap(),
            point[1].as_f64().unwrap(),
        );
        assert!(
            (one - other).abs() < 1e-3 * other.max(0.1),
            "{point}: {one}"
        );
        compared += 1;
    }
    assert!(15 < compared);
}

#[test]
fn the_limits_of_the_map_are_those_of_the_orbit() {
    let map = about(FRAME, "map", json!({}));
    assert!(map["top"].as_f64().unwrap() > 0.5);
    assert_eq!(map["frame"]["x"], json!([0.3, 2.0]));
    let orbit = about(FRAME, "orbit", json!({ "bare": true }));
    let limits = FRAME.parse::<System>().unwrap().at(0.9).unwrap().limits();
    assert_eq!(orbit["limits"]["continuous"], json!(limits.continuous));
}

#[test]
fn the_best_friction_is_that_of_the_library() {
    let told = about(
        SCENES[2],
        "best",
        json!({ "work": 60_000, "from": 0.5, "to": 2.0 }),
    );
    let (beta, amplitude) = (
        told["beta"].as_f64().unwrap(),
        told["amplitude"].as_f64().unwrap(),
    );
    // No neighbouring friction has a smaller peak on a dense grid.
    let peak = |beta: f64| {
        let size = |i: u32| {
            let r = 0.5 + 0.005 * f64::from(i);
            let more = json!({ "r": r, "beta": beta, "bare": true });
            let told = about(SCENES[2], "orbit", more);
            told["masses"][0]["amplitude"].as_f64().unwrap()
        };
        (0..=300).map(size).fold(0.0, f64::max)
    };
    assert!((peak(beta) - amplitude).abs() < 0.01 * amplitude);
    assert!(peak(1.05 * beta) > peak(beta) && peak(0.95 * beta) > peak(beta));
}

#[test]
fn several_contacts_are_answered_point_by_point() {
    let system: System = STOREYS.parse().unwrap();
    let joined = system.joined().unwrap();
    let orbit = joined.at(0.5).unwrap().orbit(0.6).unwrap();
    let told = about(
        STOREYS,
        "points",
        json!({ "rs": [0.5], "beta": 0.6, "of": 4 }),
    );
    assert_eq!(
        told["points"][0][1],
        json!(orbit.largest_displacements()[4])
    );
    let drawn = about(
        STOREYS,
        "line",
        json!({ "points": [[0.3, 1.0, 1], [0.5, 2.0, 1], [0.7, null, null]] }),
    );
    assert!(drawn["svg"].as_str().unwrap().contains("stick-slip"));
    let cells = about(STOREYS, "cells", json!({ "r": 0.5, "betas": [0.6, 1e6] }));
    assert_eq!(cells["cells"], json!([1, 2]));
    let raster = about(
        STOREYS,
        "raster",
        json!({ "rs": [0.5], "cells": [1, 2], "top": 2.0 }),
    );
    assert!(raster["svg"].as_str().unwrap().starts_with("<svg"));
}

#[test]
fn a_faulty_question_gets_a_message() {
    for question in [
        "",
        "{",
        "{\"ask\": 1}",
        "{\"ask\": \"other\"}",
        "{\"unknown\": 1}",
    ] {
        assert!(answer(question).contains("error"), "{question}");
    }
    for (name, value) in [("r", -1.0), ("beta", -1.0), ("from", -1.0)] {
        let kind = if name == "from" { "map" } else { "orbit" };
        let told = about(FRAME, kind, json!({ name: value }));
        assert!(told["error"].is_string(), "{name}: {told}");
    }
}

#[test]
fn the_emitted_code_is_that_of_the_macro() {
    let told = about(FRAME, "code", json!({}));
    let code = told["code"].as_str().unwrap();
    assert!(code.contains("pub struct Frame") && code.contains("fn continuous_limit"));
    // The constant is m₁ of the description.
    assert!(code.contains("3.27"));
    for text in [
        STOREYS,
        &FRAME.replace("damping:", "accuracy: 1e-4, range: { r: 0.2..2 }, damping:"),
    ] {
        let told = about(text, "code", json!({}));
        assert!(told["error"].is_string(), "{told}");
    }
}

/// `frictiongen play` replaces this element of the page.
#[test]
fn the_page_has_room_for_a_description() {
    let page = include_str!("../page/page.html");
    let room = r#"<script id="given" type="application/json">null</script>"#;
    assert_eq!(page.matches(room).count(), 1);
    let command = include_str!("../../../crates/cli/src/play.rs");
    assert_eq!(command.matches(room).count(), 1);
}

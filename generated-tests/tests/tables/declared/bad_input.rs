//! Tests that the compiler reports an unsatisfiable request at its token. `tests/messages` has all other messages.

use super::scenes::scene;
use frictiongen_codegen::{SizeLimits, parse_text};

fn told(field: &str, text: &str) -> String {
    let text = text.replace("stiction", &format!("{field}, stiction"));
    parse_text(&text, &SizeLimits::MACRO)
        .expect_err("no table")
        .to_string()
}

#[test]
fn an_accuracy_beyond_the_condition() {
    let message = told(
        "accuracy: 1e-12, range: { r: 0.2..2.5 }",
        &scene("Wall", 10, "none", "1", "f64"),
    );
    assert!(
        message.contains("no table meets the accuracy 1e-12 at r = 1.97"),
        "{message}"
    );
    assert!(
        message.contains(
            "1e-11 can be met; declare a coarser accuracy, or leave this r out of the range"
        ),
        "{message}"
    );
    let column = message.split(':').nth(1).unwrap().parse::<usize>().unwrap();
    assert!(column > 200, "on the number: {message}");
}

#[test]
fn single_precision_has_fewer_digits() {
    let message = told(
        "accuracy: 1e-7, range: { r: 0.2..2.5 }",
        &scene("Wall", 1, "none", "1", "f32"),
    );
    assert!(
        message.contains("an accuracy is a relative error from 2e-6 to 0.1, not 1e-7"),
        "{message}"
    );
}

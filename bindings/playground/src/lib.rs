//! The playground: answers about a scene for a page in a browser.
//!
//! The page sends a question as JSON and receives the answer as JSON.  [`answer`] is the whole interface.
//! `boundary.rs` passes both texts between the browser and this crate.

mod best;
mod boundary;
mod code;
mod curve;
mod joined;
mod map;
mod numbers;
mod orbit;
mod question;
mod scene;

use question::Question;
use serde_json::{Value, json};

/// Answers a question. Question and answer are JSON. If the question is faulty, the answer has the field `error` with
/// a message.
///
/// ```
/// let question = r#"{"ask": "scene", "text": "struct Block { masses: { block: 1 } }"}"#;
/// let answer = playground::answer(question);
/// assert!(answer.contains(r#""line":1"#));
/// ```
#[must_use]
pub fn answer(question: &str) -> String {
    let found = match serde_json::from_str::<Question>(question) {
        Ok(question) => answered(&question),
        Err(error) => Err(format!("the question is not valid: {error}")),
    };
    found
        .unwrap_or_else(|error| json!({ "error": error }))
        .to_string()
}

fn answered(question: &Question) -> Result<Value, String> {
    match question.ask.as_str() {
        "scene" => Ok(scene::answer(question)),
        "curve" => curve::answer(question),
        "map" => map::answer(question),
        "orbit" => orbit::answer(question),
        "best" => best::answer(question),
        "code" => code::answer(question),
        "points" => joined::points(question),
        "line" => joined::line(question),
        "cells" => joined::cells(question),
        "raster" => joined::raster(question),
        other => Err(format!("there is no question `{other}`")),
    }
}

#[cfg(test)]
mod tests;

//! The differences of two scenes as JSON.

use super::Differences;
use super::parameters::DescriptionField;
use super::steppers::Steppers;
use crate::json::object;
use crate::number::{Cell, Lossless as _};
use serde_json::{Value as Json, json};

impl Differences {
    /// Returns all differences as one JSON object.
    pub(super) fn json(&self) -> Json {
        let [old, new] = &self.names;
        let number = |value: f64| Cell::from(value).json();
        let field = |field: &Option<DescriptionField>| match field {
            None => Json::Null,
            Some(DescriptionField {
                number: Some(value),
                ..
            }) => number(*value),
            Some(field) => field.text.as_str().into(),
        };
        let changes = self.changes.iter().map(|change| {
            json!({
                "name": change.name,
                "old": field(&change.old),
                "new": field(&change.new),
                "relative": change.relative().map(number),
            })
        });
        let modes = self.answers.modes.iter();
        let modes =
            modes.map(|(old, new)| json!({ "old": old.map(number), "new": new.map(number) }));
        let answers = self.answers.differences.iter().map(|found| {
            json!({
                "name": found.name,
                "unit": found.unit,
                "frequency_Hz": number(found.hertz),
                "old": number(found.values.0),
                "new": number(found.values.1),
                "relative": number(found.relative),
                "median": number(found.median),
                "compared": found.compared,
                "left_out": !found.left_out_by.is_empty(),
            })
        });
        let mut left_out: Vec<Json> = self
            .answers
            .left_out
            .iter()
            .map(|reason| reason.as_str().into())
            .collect();
        let code = match &self.code {
            Err(reason) => {
                left_out.push(reason.as_str().into());
                Json::Null
            }
            Ok(code) => json!({
                "lines": { "old": code.lines.0, "new": code.lines.1, "removed": code.differing.0, "added": code.differing.1 },
                "source_bytes": { "old": code.bytes.0, "new": code.bytes.1 },
                "table_bytes": { "old": code.tables.0, "new": code.tables.1 },
                "functions": code.functions.iter().map(|(name, old, new)| json!({ "name": name, "old": old, "new": new })).collect::<Json>(),
            }),
        };
        Json::Object(object([
            ("version", 1.into()),
            ("old", old.as_str().into()),
            ("new", new.as_str().into()),
            ("parameters", changes.collect()),
            ("natural_frequencies_Hz", modes.collect()),
            (
                "emitted_answers",
                self.notes.iter().map(String::as_str).collect(),
            ),
            ("answers", answers.collect()),
            (
                "stepper",
                self.steppers.as_ref().map_or(Json::Null, Steppers::json),
            ),
            (
                "without_effect",
                self.without_effect().into_iter().collect(),
            ),
            ("code", code),
            ("not_compared", Json::Array(left_out)),
        ]))
    }
}

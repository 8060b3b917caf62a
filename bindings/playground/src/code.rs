//! The Rust code that the macro emits.

use crate::question::Question;
use frictiongen_codegen::{SizeLimits, parse_text, pretty};
use serde_json::{Value, json};

/// Returns the Rust code that the macro emits for the description of the question.
pub fn answer(question: &Question) -> Result<Value, String> {
    // The page refuses long chains and long texts, as it does for every question.
    question.system()?;
    let description = parse_text(&question.text, &SizeLimits::MACRO).map_err(|faults| {
        let lines = faults.list.into_iter();
        let lines: Vec<String> = lines.map(|fault| fault.to_string()).collect();
        lines.join("\n")
    })?;
    if description.scene.declared.is_tabled() {
        return Err(
            "the tables of this scene take too long for a page; `frictiongen expand` prints them"
                .to_owned(),
        );
    }
    let code = pretty(&description).map_err(|error| error.to_string())?;
    Ok(json!({ "code": code }))
}

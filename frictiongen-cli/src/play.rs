//! `frictiongen play`: writes the playground with a description in it.

use crate::args::PlayArguments;
use crate::failure::{Failure, reason};
use crate::file;
use frictiongen_codegen::{Limits, parse_text};
use serde_json::json;
use std::io::Write;
use std::path::PathBuf;

/// The element of the page for the description, as `scripts/playground` writes it. The command replaces `null` by the
/// description.
const GIVEN: &str = r#"<script id="given" type="application/json">null</script>"#;
/// File name of the page, which is in the folder of the program.
const PAGE: &str = "playground.html";

/// Runs `frictiongen play`.
pub fn run(arguments: &PlayArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let description = arguments.file.path();
    if let Some(path) = arguments.output.as_deref() {
        file::check_page(path, "the playground")?;
        file::check(path, description)?;
    }
    let name = arguments.file.name();
    let text = arguments.file.text()?;
    parse_text(&text, &Limits::RUN_TIME).map_err(|diagnostics| {
        let lines = diagnostics.list.into_iter();
        Failure::Lines(lines.map(|line| format!("{name}:{line}")).collect())
    })?;
    let page = page(arguments)?;
    let given = json!({ "text": text }).to_string();
    // "</script>" in a comment of the description would end the element.
    let given = given.replace('<', "\\u003c");
    let element = GIVEN.replace("null", &given);
    let html = page.replacen(GIVEN, &element, 1);
    match arguments.output.as_deref() {
        Some(path) => file::write_file(path, description, &html),
        None => {
            out.write_all(html.as_bytes())?;
            Ok(out.flush()?)
        }
    }
}

/// Reads the page of the playground, without a description.
fn page(arguments: &PlayArguments) -> Result<String, Failure> {
    let beside = || Some(std::env::current_exe().ok()?.parent()?.join(PAGE));
    let path: PathBuf = match &arguments.page {
        Some(path) => path.clone(),
        None => beside().unwrap_or_else(|| PAGE.into()),
    };
    let page = std::fs::read_to_string(&path).map_err(|error| {
        Failure::new(format_args!(
            "cannot read the page {}: {}; `scripts/playground` makes it, and `--page` says where it is",
            path.display(),
            reason(&error)
        ))
    })?;
    if page.matches(GIVEN).count() == 1 {
        return Ok(page);
    }
    Err(Failure::new(format_args!(
        "--page `{}`: this file is not a playground without a description; `scripts/playground` makes one",
        path.display()
    )))
}

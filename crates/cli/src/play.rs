//! `frictiongen play`: writes the page of the playground, with a scene description in it.

use crate::args::PlayArguments;
use crate::failure::{Failure, reason};
use crate::file;
use frictiongen_codegen::{SizeLimits, parse_text};
use serde_json::{Value as Json, json};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The element of the playground's page that contains the scene description. `scripts/playground` writes the element
/// with `null`. The command replaces `null` by the description.
const GIVEN: &str = r#"<script id="given" type="application/json">null</script>"#;
/// File name of the playground's page. The file is in the folder of the program.
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
    parse_text(&text, &SizeLimits::RUN_TIME).map_err(|diagnostics| {
        let lines = diagnostics.list.into_iter();
        Failure::Lines(lines.map(|line| format!("{name}:{line}")).collect())
    })?;
    let html = with(&page(arguments.page.as_deref())?, &json!({ "text": text }));
    file::write_page((arguments.output.as_deref(), description), &html, out)
}

/// Returns the page of the playground with the given start. The start is an object with the key `text` for the scene
/// description. It may also have the keys `r` and `beta` for a point, and `from` and `to` for the range of frequency
/// ratios.
pub fn with(page: &str, start: &Json) -> String {
    // The text "</script>" in a comment of the scene description would end the element.
    let start = start.to_string().replace('<', "\\u003c");
    page.replacen(GIVEN, &GIVEN.replace("null", &start), 1)
}

/// Reads the page of the playground, without a scene description. Without a path, the page is the file [`PAGE`] in the
/// folder of the program.
pub fn page(path: Option<&Path>) -> Result<String, Failure> {
    let beside = || Some(std::env::current_exe().ok()?.parent()?.join(PAGE));
    let path: PathBuf = match path {
        Some(path) => path.to_owned(),
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

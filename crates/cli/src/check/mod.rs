//! `frictiongen check`: prints the errors and warnings of a scene description in the style of a compiler. For a valid
//! description, prints numbers that reveal a wrong unit.

mod joints;
mod numbers;

use crate::args::CheckArguments;
use crate::failure::Failure;
use crate::number::computed;
use crate::progress;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use frictiongen_codegen::{Diagnostic, SizeLimits, parse_text, smooth_law, warnings};
use serde_json::{Value as Json, json};
use std::io::Write;
use std::ops::Range;

/// Runs `frictiongen check`.
pub fn run(arguments: &CheckArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let name = arguments.file.name();
    let text = arguments.file.text()?;
    // A description that restricts only the emitted code is valid. The command prints the restrictions.
    let limits = SizeLimits {
        emitted: false,
        ..SizeLimits::CHECK
    };
    let description = parse_text(&text, &limits).map_err(|diagnostics| {
        if arguments.json {
            let answer =
                json!({ "file": name, "errors": listed(&diagnostics.list), "warnings": [] });
            // The command also writes the errors to standard error, so that the user sees them even if this write
            // fails.
            let _ = writeln!(out, "{answer:#}");
            let _ = out.flush();
        }
        let list = diagnostics.list.iter();
        Failure::Lines(
            list.map(|error| shown(&name, &text, error, Level::ERROR))
                .collect(),
        )
    })?;
    let warned = warnings(&text);
    let not_emitted = refused_by_macro(&text);
    if arguments.json {
        let warned: Vec<Diagnostic> = warned.into_iter().flat_map(|found| found.list).collect();
        let mut answer = json!({
            "file": name,
            "errors": [],
            "warnings": listed(&warned),
            "not_emitted": listed(&not_emitted),
        });
        if let (Some(fields), Some(numbers)) =
            (answer.as_object_mut(), numbers::json(&description.scene))
        {
            fields.extend(numbers);
            fields.extend(joints::json(&description.scene));
        }
        if let (Some(fields), Some(law)) = (answer.as_object_mut(), smooth_law(&text)) {
            let lines = json!({ "lines": law.points.len(), "largest_error": law.error });
            fields.insert("stribeck".to_owned(), lines);
        }
        writeln!(out, "{answer:#}")?;
        return Ok(out.flush()?);
    }
    for warning in warned.iter().flat_map(|found| &found.list) {
        progress::say(&format!(
            "{}\n",
            shown(&name, &text, warning, Level::WARNING)
        ));
    }
    let scene = &description.scene;
    let count = |count: usize, one: &str, more: &str| match count {
        1 => format!("1 {one}"),
        count => format!("{count} {more}"),
    };
    let masses = count(scene.masses.len(), "mass", "masses");
    let springs = count(scene.springs.len(), "spring", "springs");
    let joints = &scene.joints;
    let joined = if scene.is_joined() {
        let contacts = count(scene.named_contacts().len(), "contact", "contacts");
        let dampers = count(joints.dampers.len(), "dashpot", "dashpots");
        format!(", {contacts}, {dampers}")
    } else {
        String::new()
    };
    writeln!(out, "{name}: no errors; {masses}, {springs}{joined}")?;
    if let Some(acts_on) = scene.damping_acts_on() {
        writeln!(out, "{acts_on}")?;
    }
    numbers::write(scene, out)?;
    for [what, name, numbers] in joints::lines(scene) {
        writeln!(out, "{what:<25}  {name}: {numbers}")?;
    }
    if let Some(law) = smooth_law(&text) {
        writeln!(
            out,
            "stribeck: {} straight lines from {:?} F to F, with errors of at most {} F",
            law.points.len(),
            law.rest,
            computed(law.error)
        )?;
    }
    for reason in not_emitted {
        writeln!(out, "the macro emits no code for this scene: {reason}")?;
    }
    Ok(out.flush()?)
}

/// Returns the reasons why the macro emits no code for a valid description.
fn refused_by_macro(text: &str) -> Vec<Diagnostic> {
    // The tables have passed the check already.
    let limits = SizeLimits {
        tables: false,
        ..SizeLimits::CHECK
    };
    let refused = parse_text(text, &limits).err();
    refused.into_iter().flat_map(|found| found.list).collect()
}

/// Returns errors or warnings of a scene description as JSON, each with its line and column, counted from 1.
fn listed(list: &[Diagnostic]) -> Json {
    let one =
        |of: &Diagnostic| json!({ "line": of.line, "column": of.column, "message": of.message });
    list.iter().map(one).collect()
}

/// Returns an error or a warning as text, with the affected line of the scene description.
fn shown(name: &str, text: &str, error: &Diagnostic, level: Level<'_>) -> String {
    let snippet = Snippet::source(text)
        .path(name)
        .annotation(AnnotationKind::Primary.span(token(text, error.line, error.column)));
    let report = level.primary_title(error.message.as_str()).element(snippet);
    Renderer::plain().render(&[report])
}

/// Returns the range of bytes of the token at a line and a column of the scene description, both counted from 1. The
/// range is empty if the position is after the end of the text.
fn token(text: &str, line: usize, column: usize) -> Range<usize> {
    let before: usize = text
        .split_inclusive('\n')
        .take(line - 1)
        .map(str::len)
        .sum();
    let rest = text.get(before..).unwrap_or_default();
    let within = rest.char_indices().nth(column - 1);
    let start = before + within.map_or(rest.len(), |(place, _)| place);
    let token = text.get(start..).unwrap_or_default();
    let word = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '.';
    // A number may begin with a sign. Any other token that is not a word is a single character.
    let first = token.chars().next().map_or(0, char::len_utf8);
    let sign = if token.starts_with('-') { first } else { 0 };
    let after = token.get(sign..).unwrap_or_default();
    let length = sign + after.find(|letter| !word(letter)).unwrap_or(after.len());
    let length = length.max(first);
    start..start + length
}

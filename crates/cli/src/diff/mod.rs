//! `frictiongen diff`: compares two scene descriptions, their results and their emitted code.

mod answers;
mod code;
mod json;
mod parameters;
mod steppers;
mod text;

use crate::args::{DiffArguments, FileArgument};
use crate::failure::Failure;
use answers::Answers;
use code::Code;
use frictiongen::System;
use frictiongen::study::scene::{Accuracy, Precision, Scene};
use frictiongen_codegen::{SizeLimits, parse_text};
use parameters::FieldChange;
use similar::TextDiff;
use std::io::Write;
use steppers::Steppers;

/// All differences between two scene descriptions.
struct Differences {
    names: [String; 2],
    changes: Vec<FieldChange>,
    /// Sentences (without full stops) on scenes whose emitted code does not use the exact double-precision formulas.
    notes: Vec<String>,
    answers: Answers,
    /// Comparison of the steppers, unless no scene provides one.
    steppers: Option<Steppers>,
    code: Result<Code, String>,
}

impl Differences {
    /// Returns the names of the changed fields that describe the physics of the scene, if no answer differs. None of the
    /// compared answers then depends on these fields.
    fn without_effect(&self) -> Vec<&str> {
        let Answers {
            modes, differences, ..
        } = &self.answers;
        let moved = modes.iter().any(|(old, new)| match (old, new) {
            (Some(old), Some(new)) => relative(*old, *new) > ROUNDINGS,
            _ => true,
        });
        let steps = self.steppers.iter().flat_map(|found| &found.answers);
        let mut steps = steps.flat_map(|answers| &answers.differences);
        let differs = moved
            || differences.iter().any(|found| found.relative > ROUNDINGS)
            || steps.any(|found| found.relative() > ROUNDINGS);
        let fields = self.changes.iter().filter(|_| !differs);
        fields
            .filter(|change| change.is_physical())
            .map(|change| change.name.as_str())
            .collect()
    }
}

/// Runs `frictiongen diff`.
pub fn run(arguments: &DiffArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let files = [&arguments.old, &arguments.new].map(|path| FileArgument {
        file: Some(path.clone()),
    });
    if files.iter().all(|file| file.path().is_none()) {
        return Err(Failure::new(
            "diff: only one of both descriptions can come from standard input",
        ));
    }
    let [old, new] = &files;
    let texts = [old.text()?, new.text()?];
    let found = compare([old.name(), new.name()], &texts);
    let found = match found {
        Ok(found) => found,
        Err(failure) => {
            // If a scene description cannot be parsed, the command compares the texts line by line.
            unified(&files, &texts, out)?;
            return Err(failure);
        }
    };
    if arguments.json {
        writeln!(out, "{:#}", found.json())?;
    } else {
        found.write(out)?;
    }
    Ok(out.flush()?)
}

/// Compares two scene descriptions. If a description has errors, the failure contains them.
fn compare(names: [String; 2], texts: &[String; 2]) -> Result<Differences, Failure> {
    let mut errors = Vec::new();
    let mut systems = Vec::new();
    for (name, text) in names.iter().zip(texts) {
        match parse_text(text, &SizeLimits::RUN_TIME) {
            Err(diagnostics) => {
                let list = diagnostics.list.iter();
                errors.extend(list.map(|error| format!("{name}:{error}")));
            }
            Ok(description) => match System::<f64>::try_from(description.scene) {
                Ok(system) => systems.push(system),
                Err(error) => errors.push(format!("{name}: {error}")),
            },
        }
    }
    let ([old, new], [old_text, new_text]) = (systems.as_slice(), texts) else {
        return Err(Failure::Lines(errors));
    };
    let (scene, mut changes) = parameters::renamed(old.scene(), new.scene());
    changes.extend(parameters::changes(&scene, new.scene()));
    let notes = [("old", old), ("new", new)].map(|(which, system)| note(which, system.scene()));
    let old = System::<f64>::try_from(scene).map_err(Failure::new)?;
    let answers = answers::compare(&old, new);
    let alone = answers.differences.is_empty();
    Ok(Differences {
        names,
        changes,
        notes: notes.into_iter().flatten().collect(),
        answers,
        steppers: steppers::compare([&old, new], texts, alone),
        code: code::compare(old_text, new_text),
    })
}

/// Returns a sentence about a scene whose emitted code does not use the exact formulas in double precision. The
/// comparison uses these formulas for every scene.
fn note(which: &str, scene: &Scene) -> Option<String> {
    let tables = match (scene.declared.accuracy, scene.declared.budget) {
        (Accuracy::Relative(accuracy), _) => {
            Some(format!("uses tables of relative accuracy {accuracy:e}"))
        }
        (Accuracy::Exact, Some(bytes)) => Some(format!("uses tables of at most {bytes} bytes")),
        (Accuracy::Exact, None) => None,
    };
    let single = (scene.precision == Precision::F32).then(|| "computes in f32".to_owned());
    let said: Vec<String> = single.into_iter().chain(tables).collect();
    (!said.is_empty()).then(|| format!("The {which} emitted code {}", said.join(" and ")))
}

/// Writes the differing lines of two texts.
fn unified(
    files: &[FileArgument; 2],
    texts: &[String; 2],
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let [old, new] = texts;
    let name = |index: usize| files.get(index).map(FileArgument::name).unwrap_or_default();
    let difference = TextDiff::from_lines(old, new);
    let mut text = difference
        .unified_diff()
        .header(&name(0), &name(1))
        .to_string();
    // The line break lets the errors on standard error begin on a new line of the terminal.
    if !text.is_empty() && !text.ends_with('\n') {
        text.push('\n');
    }
    out.write_all(text.as_bytes())?;
    Ok(out.flush()?)
}

/// Largest relative difference at which the command treats two results as equal. Rounding in the two scenes can cause
/// differences of this size.
const ROUNDINGS: f64 = 1e-12;

/// Returns the absolute difference of two numbers, divided by the larger absolute value. Returns 0 if both numbers are
/// 0.
fn relative(old: f64, new: f64) -> f64 {
    let size = old.abs().max(new.abs());
    if size == 0.0 {
        return 0.0;
    }
    (new - old).abs() / size
}

/// Formats a relative change in per cent, with its sign.
fn per_cent(relative: f64) -> String {
    let value = 100.0 * relative;
    match value.abs() {
        0.0 => "0 %".to_owned(),
        size if !(5e-4..1e4).contains(&size) => format!("{value:+.1e} %"),
        size if size < 1.0 => format!("{value:+.3} %"),
        _ => format!("{value:+.2} %"),
    }
}

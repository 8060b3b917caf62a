//! `frictiongen diff`: compares two scene descriptions, their results and their emitted code.

mod answers;
mod code;
mod parameters;
mod steppers;

use crate::args::{DiffArguments, FileArgument};
use crate::failure::Failure;
use crate::json::object;
use crate::number::{Cell, Lossless as _, computed};
use answers::{Answers, BAND, Difference, FREQUENCIES, FRICTION};
use code::Code;
use frictiongen::System;
use frictiongen::study::scene::{Accuracy, Precision, Scene};
use frictiongen_codegen::{SizeLimits, parse_text};
use parameters::{DescriptionField, FieldChange};
use serde_json::{Value as Json, json};
use similar::TextDiff;
use std::io::Write;
use steppers::Steppers;

/// All differences between two scene descriptions.
struct Differences {
    names: [String; 2],
    changes: Vec<FieldChange>,
    /// Sentences about emitted code that does not use the exact formulas in double precision, without full stops.
    notes: Vec<String>,
    answers: Answers,
    /// Comparison of the steppers, unless no scene provides one.
    steppers: Option<Steppers>,
    code: Result<Code, String>,
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
    Ok(Differences {
        names,
        changes,
        notes: notes.into_iter().flatten().collect(),
        answers: answers::compare(&old, new),
        steppers: steppers::compare([&old, new], texts),
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

/// Largest number of ranges of frequencies that a line of the comparison lists.
const SHOWN_RANGES: usize = 6;

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

/// Formats the first ranges of a list.
fn ranges(all: &[(f64, f64)]) -> String {
    let shown = all.iter().take(SHOWN_RANGES).map(|(from, to)| {
        if from == to {
            return computed(*from);
        }
        format!("{} to {}", computed(*from), computed(*to))
    });
    let mut text = shown.collect::<Vec<_>>().join(", ");
    if all.len() > SHOWN_RANGES {
        text += &format!(", and {} more", all.len() - SHOWN_RANGES);
    }
    text
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

impl Differences {
    fn write(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let [old, new] = &self.names;
        writeln!(out, "{old} -> {new}")?;
        if self.changes.is_empty() {
            writeln!(out, "\nThe descriptions describe the same scene.")?;
            return Ok(());
        }
        writeln!(out, "\nparameters")?;
        let width = self
            .changes
            .iter()
            .map(|change| change.name.chars().count());
        let width = width.max().unwrap_or(0);
        for change in &self.changes {
            let name = &change.name;
            let relative = change
                .relative()
                .map(|relative| format!(" ({})", per_cent(relative)));
            match (&change.old, &change.new) {
                (Some(old), Some(new)) => writeln!(
                    out,
                    "  {name:<width$}  {} -> {}{}",
                    old.text,
                    new.text,
                    relative.unwrap_or_default()
                )?,
                (Some(old), None) => writeln!(out, "  {name:<width$}  removed, was {}", old.text)?,
                (None, Some(new)) => writeln!(out, "  {name:<width$}  added, {}", new.text)?,
                (None, None) => {}
            }
        }
        self.write_answers(out)?;
        if let Some(steppers) = &self.steppers {
            steppers.write(out)?;
        }
        self.write_code(out)
    }

    fn write_answers(&self, out: &mut dyn Write) -> Result<(), Failure> {
        writeln!(out, "\nnatural frequencies (Hz)")?;
        for (mode, pair) in self.answers.modes.iter().enumerate() {
            let mode = mode + 1;
            match *pair {
                (Some(old), Some(new)) if (new - old).abs() <= ROUNDINGS * old => {
                    writeln!(out, "  mode {mode}  {}, unchanged", computed(old))?;
                }
                (Some(old), Some(new)) => {
                    let change = per_cent((new - old) / old);
                    writeln!(
                        out,
                        "  mode {mode}  {} -> {} ({change})",
                        computed(old),
                        computed(new)
                    )?;
                }
                (Some(old), None) => {
                    writeln!(out, "  mode {mode}  removed, was {}", computed(old))?;
                }
                (None, Some(new)) => writeln!(out, "  mode {mode}  added, {}", computed(new))?,
                (None, None) => {}
            }
        }
        if let Some((from, to)) = self.answers.band {
            writeln!(
                out,
                "\nanswers at {FREQUENCIES} frequencies, logarithmically spaced from {} to {} Hz",
                computed(from),
                computed(to)
            )?;
            self.write_conditions(out)?;
        }
        for found in &self.answers.differences {
            let Difference {
                name,
                unit,
                hertz,
                values,
                relative,
                median,
                smallest,
                gaps,
                compared,
                left_out_by,
                where_both,
            } = found;
            let unit = if unit.is_empty() {
                String::new()
            } else {
                format!(" {unit}")
            };
            if left_out_by.is_empty() {
                writeln!(out, "  {name}")?;
            } else {
                writeln!(out, "  {name} ({left_out_by})")?;
            }
            if u32::try_from(*compared) != Ok(FREQUENCIES) {
                writeln!(
                    out,
                    "    compared at {compared} of {FREQUENCIES} frequencies, {where_both}: not at {} Hz",
                    ranges(gaps)
                )?;
            }
            if *relative <= ROUNDINGS {
                writeln!(out, "    unchanged, to rounding")?;
                continue;
            }
            if relative - smallest <= ROUNDINGS {
                writeln!(
                    out,
                    "    differs by {} at every compared frequency",
                    per_cent(*relative).trim_start_matches('+')
                )?;
                continue;
            }
            writeln!(
                out,
                "    largest difference {}, at {} Hz: {} -> {}{unit}; median {}",
                per_cent(*relative).trim_start_matches('+'),
                computed(*hertz),
                computed(values.0),
                computed(values.1),
                per_cent(*median).trim_start_matches('+')
            )?;
        }
        for reason in &self.answers.left_out {
            writeln!(out, "  not compared: {reason}")?;
        }
        Ok(())
    }

    /// Writes the compared range of frequencies, the formulas and the friction force of the compared answers.
    fn write_conditions(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let range = |(from, to): (f64, f64)| format!("{} to {}", computed(from), computed(to));
        let [old, new] = self.answers.ratios.map(range);
        if old == new {
            writeln!(out, "  Frequency ratio r: {old} in both scenes.")?;
        } else {
            writeln!(
                out,
                "  Frequency ratio r: {old} (old scene), {new} (new scene)."
            )?;
        }
        let (low, high) = BAND;
        writeln!(
            out,
            "  Default range: {low} times the lowest to \
             {high} times the highest natural frequency of both scenes."
        )?;
        if self.answers.within_range {
            writeln!(
                out,
                "  The declared `range` narrows it. \
                 Code with tables returns an error outside its `range`."
            )?;
        }
        writeln!(
            out,
            "  The answers of both scenes come from the exact formulas in f64, not from tables."
        )?;
        for note in &self.notes {
            writeln!(out, "  {note}.")?;
        }
        writeln!(
            out,
            "  A difference is relative to the larger of both values, a change in brackets to the old value."
        )?;
        writeln!(
            out,
            "  Friction force for amplitudes, in both scenes: \
             {FRICTION} min(F_lim, F*_lim) of the old scene at each frequency."
        )?;
        writeln!(
            out,
            "  Phases, stuck responses and stick-slip motions are not compared."
        )?;
        Ok(())
    }

    fn write_code(&self, out: &mut dyn Write) -> Result<(), Failure> {
        writeln!(out, "\nemitted code in Rust")?;
        let code = match &self.code {
            Err(reason) => {
                writeln!(out, "  not compared: {reason}")?;
                return Ok(());
            }
            Ok(code) => code,
        };
        writeln!(
            out,
            "  Lines and bytes include documentation comments, \
             but not the header comment of `expand`."
        )?;
        // `compile` refuses several contacts, dashpots and `stribeck`, for which there is no band.
        if self.answers.band.is_some() {
            writeln!(
                out,
                "  C is not compared. \
                 `compile --format c -o NAME.c` writes its numbers to NAME_tables.h."
            )?;
        }
        let (removed, added) = code.differing;
        writeln!(
            out,
            "  lines            {} -> {}; {removed} removed, {added} added",
            code.lines.0, code.lines.1
        )?;
        writeln!(
            out,
            "  bytes of source  {} -> {}",
            code.bytes.0, code.bytes.1
        )?;
        if code.tables != (0, 0) {
            writeln!(
                out,
                "  bytes of tables  {} -> {}, without those of a step",
                code.tables.0, code.tables.1
            )?;
        }
        if code.functions.is_empty() {
            writeln!(out, "  operations       unchanged in every function")?;
        }
        for (name, old, new) in &code.functions {
            writeln!(out, "  operations of `{name}`")?;
            match (old, new) {
                (Some(old), Some(new)) => writeln!(out, "    {old}\n    -> {new}")?,
                (Some(old), None) => writeln!(out, "    function removed, had {old}")?,
                (None, Some(new)) => writeln!(out, "    function added, has {new}")?,
                (None, None) => {}
            }
        }
        Ok(())
    }

    fn json(&self) -> Json {
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
            ("code", code),
            ("not_compared", Json::Array(left_out)),
        ]))
    }
}

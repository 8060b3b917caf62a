//! Differences of the code that the macro emits for two scene descriptions.

use crate::emitted::functions;
use frictiongen_codegen::{Description, SceneTables, SizeLimits, parse_text, pretty};
use similar::{ChangeTag, TextDiff};

/// Sizes of the emitted code of two scene descriptions (old, new), and differences between the two codes.
#[derive(Clone, Debug, PartialEq)]
pub struct Code {
    /// Number of lines of the emitted code, for the old and the new scene description.
    pub lines: (usize, usize),
    /// Number of lines in which the two sources differ: lines that only the old source contains, and lines that only
    /// the new source contains.
    pub differing: (usize, usize),
    /// Number of bytes of the emitted code, for the old and the new scene description.
    pub bytes: (usize, usize),
    /// Number of bytes of the tables of a declared accuracy, for the old and the new scene description.
    pub tables: (usize, usize),
    /// Functions whose numbers of operations differ: name, old number and new number. A number is `None` if the source
    /// does not contain the function.
    pub functions: Vec<(String, Option<String>, Option<String>)>,
}

/// Compares the emitted code of two scene descriptions.
///
/// # Errors
/// Returns the reason if one of the scene descriptions gives no code.
pub fn compare(old: &str, new: &str) -> Result<Code, String> {
    let (old, new) = (emitted(old, "old")?, emitted(new, "new")?);
    let difference = TextDiff::from_lines(&old.0, &new.0);
    let count = |tag| {
        difference
            .iter_all_changes()
            .filter(|change| change.tag() == tag)
            .count()
    };
    let operations = |source: &str| -> Vec<(String, String)> {
        let all = functions(source).into_iter();
        all.map(|function| (function.name, function.operations))
            .collect()
    };
    let (before, after) = (operations(&old.0), operations(&new.0));
    let mut names: Vec<&String> = before.iter().map(|(name, _)| name).collect();
    let added = after.iter().map(|(name, _)| name);
    names.extend(added.filter(|name| !before.iter().any(|(other, _)| other == *name)));
    names.dedup();
    let of = |all: &[(String, String)], name: &str| {
        let mut all = all.iter().filter(|(other, _)| other == name);
        all.next().map(|(_, operations)| operations.clone())
    };
    let functions = names.into_iter().filter_map(|name| {
        let (one, other) = (of(&before, name), of(&after, name));
        (one != other).then(|| (name.clone(), one, other))
    });
    Ok(Code {
        lines: (old.0.lines().count(), new.0.lines().count()),
        differing: (count(ChangeTag::Delete), count(ChangeTag::Insert)),
        bytes: (old.0.len(), new.0.len()),
        tables: (old.1, new.1),
        functions: functions.collect(),
    })
}

/// Returns the emitted source and the size of its tables in bytes.
fn emitted(text: &str, which: &str) -> Result<(String, usize), String> {
    let description = parse_text(text, &SizeLimits::MACRO).map_err(|diagnostics| {
        let first = diagnostics.list.first();
        let first = first.map_or_else(String::new, |error| format!(": {}", error.message));
        format!("the macro refuses the {which} description{first}")
    })?;
    let source = pretty(&description)?;
    Ok((source, table_bytes(&description)))
}

fn table_bytes(description: &Description) -> usize {
    match &description.tables {
        None => 0,
        Some(SceneTables::Double(tables)) => tables.report.bytes,
        Some(SceneTables::Single(tables)) => tables.report.bytes,
    }
}

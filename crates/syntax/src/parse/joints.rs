//! Parses the fields `contacts` (several contacts) and `dampers` (dashpots) of a description.

use super::chain::{braces, ends, link};
use super::number::{Number, number};
use super::reader::{Read, TokenReader};
use super::suggest;
use super::syntax::{JointEntry, Placed, SpringEntry};
use super::token::Delimiter;
use crate::diagnostics::{Problems, Reported};

/// Names of the properties that a contact of the field `contacts` may have.
const PROPERTIES: [&str; 3] = ["stiffness", "stiction", "share"];

/// Parses the field `contacts`: `{ name: node - node { stiffness: number, stiction: number, share: number }, … }`.
pub(crate) fn contacts(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<JointEntry>> {
    let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
    let read = braces(
        reader,
        problems,
        "the contacts must be in braces",
        "{ pads: m1 - wall }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                contact(reader, problems).unwrap_or_else(|Reported| Read::lost())
            })
        },
    );
    filled(
        read,
        problems,
        "`contacts` lists no contact; write, for example, `pads: m1 - wall`",
    )
}

/// Parses the field `dampers`: `{ node - node: number, … }`.
pub(crate) fn dampers(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<SpringEntry>> {
    let begins = |reader: &TokenReader<'_>| {
        reader.is_word(0) && reader.is_punct(1, '-') && reader.is_word(2) && reader.is_punct(3, ':')
    };
    let read = braces(
        reader,
        problems,
        "the dashpots must be in braces",
        "{ base - m1: 1.0 }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                let parts = "the ends of a dashpot and its coefficient";
                link(reader, problems, "a dashpot", parts).unwrap_or_else(|Reported| Read::lost())
            })
        },
    );
    filled(
        read,
        problems,
        "`dampers` lists no dashpot; write, for example, `base - m1: 1.0`, or leave the field out",
    )
}

/// Returns the list, and reports the error `message` if the list is empty.
fn filled<T>(read: Read<Placed<T>>, problems: &mut Problems, message: &str) -> Read<Placed<T>> {
    match &read.value {
        Some(placed) if placed.list.entries.is_empty() && placed.list.complete => {
            problems.report(placed.place, message);
            Read {
                value: None,
                clean: true,
            }
        }
        _ => read,
    }
}

fn contact(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<Read<JointEntry>, Reported> {
    let place = reader.place();
    let Some(name) = reader.take_word() else {
        let message = format!(
            "the name of a contact belongs here, not {}; write, for example, `pads: m1 - wall`",
            reader.found()
        );
        return Err(problems.report(place, message));
    };
    if reader.is_punct(0, '-') {
        let message = format!(
            "each of several contacts needs a name before its sides; write, for example, `pads: {} - wall`",
            name.text
        );
        return Err(problems.report(place, message));
    }
    reader.take_colon(problems, "the name of a contact and its sides")?;
    let (from, to) = ends(reader, problems, "the contact", "m1 - wall")?;
    let mut entry = JointEntry {
        name,
        from,
        to,
        stiffness: None,
        stiction: None,
        share: None,
        complete: true,
    };
    if let Some(mut inside) = reader.take_group(Delimiter::Brace) {
        let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
        let list = inside
            .reader
            .list(problems, begins, begins, |reader, problems| {
                property(reader, problems, &mut entry).unwrap_or_else(|Reported| Read::lost())
            });
        entry.complete = list.complete;
    }
    Ok(Read::clean(entry))
}

/// Parses one property of a contact: `stiffness: number`, `stiction: number` or `share: number`.
fn property(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    entry: &mut JointEntry,
) -> Result<Read<()>, Reported> {
    let place = reader.place();
    let Some(word) = reader.take_word() else {
        let message = format!(
            "a property of a contact belongs here, not {}; write, for example, `share: 0.5`",
            reader.found()
        );
        return Err(problems.report(place, message));
    };
    let slot = match word.text.as_str() {
        "stiffness" => &mut entry.stiffness,
        "stiction" => &mut entry.stiction,
        "share" => &mut entry.share,
        text => {
            let hint = suggest::hint(text, PROPERTIES, || {
                "write `stiffness`, `stiction` or `share`".to_owned()
            });
            return Err(problems.report(place, format!("a contact has no `{text}`{hint}")));
        }
    };
    if slot.is_some() {
        let message = format!("`{}` is given twice; keep one of the two", word.text);
        return Err(problems.report(place, message));
    }
    reader.take_colon(problems, "a property of a contact and its value")?;
    let value: Read<Number> = number(reader, problems);
    *slot = value.value;
    Ok(Read {
        value: value.value.map(|_| ()),
        clean: value.clean,
    })
}

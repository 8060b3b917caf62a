//! Parses the fields `contacts` (several contacts), `dampers` (dashpots), `stops` and `constant` (constant forces) of a
//! description.

use super::chain::{braces, ends, link, mass};
use super::number::{Number, number};
use super::reader::{Name, Read, TokenReader};
use super::suggest;
use super::syntax::{JointEntry, MassEntry, Placed, SpringEntry, StopEntry};
use super::token::Delimiter;
use crate::diagnostics::{Problems, Reported};

/// Names of the properties that a contact of the field `contacts` may have.
const PROPERTIES: [&str; 4] = ["stiffness", "stiction", "share", "speed"];
/// Names of the properties that a stop may have.
const STOP_PROPERTIES: [&str; 4] = ["gap", "stiffness", "damping", "restitution"];

/// Parses the field `contacts`: `{ name: node - node { stiffness: number, share: number, … }, … }`.
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
    let (name, (from, to)) = named(reader, problems, "contact", "pads")?;
    let (values, complete) = properties(reader, problems, "contact", PROPERTIES);
    let [stiffness, stiction, share, speed] = values;
    Ok(Read::clean(JointEntry {
        name,
        from,
        to,
        stiffness,
        stiction,
        share,
        speed,
        complete,
    }))
}

/// Parses the field `stops`: `{ name: node - node { gap: number, stiffness: number, … }, … }`.
pub(crate) fn stops(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<StopEntry>> {
    let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
    let read = braces(
        reader,
        problems,
        "the stops must be in braces",
        "{ bumper: m1 - wall { gap: 0.01, stiffness: 1e6 } }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                stop(reader, problems).unwrap_or_else(|Reported| Read::lost())
            })
        },
    );
    filled(
        read,
        problems,
        "`stops` lists no stop; write, for example, `bumper: m1 - wall { gap: 0.01, stiffness: 1e6 }`, or leave the field out",
    )
}

fn stop(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<Read<StopEntry>, Reported> {
    let (name, (from, to)) = named(reader, problems, "stop", "bumper")?;
    let (values, complete) = properties(reader, problems, "stop", STOP_PROPERTIES);
    let [gap, stiffness, damping, restitution] = values;
    Ok(Read::clean(StopEntry {
        name,
        from,
        to,
        gap,
        stiffness,
        damping,
        restitution,
        complete,
    }))
}

/// Parses the field `constant`: `{ mass: number, … }`.
pub(crate) fn constant(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<MassEntry>> {
    let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
    let read = braces(
        reader,
        problems,
        "the constant forces must be in braces",
        "{ m1: 9.81 }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                mass(reader, problems).unwrap_or_else(|Reported| Read::lost())
            })
        },
    );
    filled(
        read,
        problems,
        "`constant` lists no force; write, for example, `m1: 9.81`, or leave the field out",
    )
}

/// Parses the name and the two sides of a contact or a stop: `name: node - node`. `what` is "contact" or "stop".
fn named(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    what: &str,
    example: &str,
) -> Result<(Name, (Name, Name)), Reported> {
    let place = reader.place();
    let Some(name) = reader.take_word() else {
        let message = format!(
            "the name of a {what} belongs here, not {}; write, for example, `{example}: m1 - wall`",
            reader.found()
        );
        return Err(problems.report(place, message));
    };
    if reader.is_punct(0, '-') {
        let each = if what == "contact" {
            "each of several contacts"
        } else {
            "each stop"
        };
        let message = format!(
            "{each} needs a name before its sides; write, for example, `{example}: {} - wall`",
            name.text
        );
        return Err(problems.report(place, message));
    }
    reader.take_colon(problems, &format!("the name of a {what} and its sides"))?;
    let sides = ends(reader, problems, &format!("the {what}"), "m1 - wall")?;
    Ok((name, sides))
}

/// Parses the properties in the braces after the sides of a contact or a stop: `{ name: number, … }`. Returns the number
/// of each property in `names`, and true if the parser could read all of them.
fn properties<const N: usize>(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    what: &str,
    names: [&'static str; N],
) -> ([Option<Number>; N], bool) {
    let mut values = [None; N];
    let Some(mut inside) = reader.take_group(Delimiter::Brace) else {
        return (values, true);
    };
    let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
    let list = inside
        .reader
        .list(problems, begins, begins, |reader, problems| {
            property(reader, problems, (what, names), &mut values)
                .unwrap_or_else(|Reported| Read::lost())
        });
    (values, list.complete)
}

/// Parses one property of a contact or a stop: `name: number`.
fn property<const N: usize>(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    (what, names): (&str, [&'static str; N]),
    values: &mut [Option<Number>; N],
) -> Result<Read<()>, Reported> {
    let place = reader.place();
    let Some(word) = reader.take_word() else {
        let example = if what == "contact" {
            "share: 0.5"
        } else {
            "gap: 0.01"
        };
        let message = format!(
            "a property of a {what} belongs here, not {}; write, for example, `{example}`",
            reader.found()
        );
        return Err(problems.report(place, message));
    };
    let mut slots = names.into_iter().zip(values);
    let Some((_, slot)) = slots.find(|(name, _)| *name == word.text) else {
        let hint = suggest::hint(&word.text, names, || {
            let quoted: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
            let (last, others) = quoted
                .split_last()
                .map_or(("", &[][..]), |(last, others)| (last, others));
            format!("write {} or {last}", others.join(", "))
        });
        return Err(problems.report(place, format!("a {what} has no `{}`{hint}", word.text)));
    };
    if slot.is_some() {
        let message = format!("`{}` is given twice; keep one of the two", word.text);
        return Err(problems.report(place, message));
    }
    reader.take_colon(problems, &format!("a property of a {what} and its value"))?;
    let value: Read<Number> = number(reader, problems);
    *slot = value.value;
    Ok(Read {
        value: value.value.map(|_| ()),
        clean: value.clean,
    })
}

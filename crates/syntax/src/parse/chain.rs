//! Parses the fields of a description that define the chain: masses, springs, contact, excitation.

use super::joints;
use super::number::number;
use super::reader::{List, Name, Read, TokenReader};
use super::syntax::{ContactEntry, MassEntry, Placed, SpringEntry};
use super::token::{Delimiter, Token, TokenKind};
use crate::diagnostics::{Problems, Reported};

/// Parses the masses: `{ name: number, … }`.
pub(crate) fn masses(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<MassEntry>> {
    let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
    braces(
        reader,
        problems,
        "the masses must be in braces",
        "{ m1: 1.0, m2: 2.0 }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                mass(reader, problems).unwrap_or_else(|Reported| Read::lost())
            })
        },
    )
}

fn mass(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<Read<MassEntry>, Reported> {
    let place = reader.place();
    let Some(name) = reader.take_word() else {
        let message = match reader.peek(0) {
            Some(Token {
                kind: TokenKind::Number(text),
                ..
            }) => format!(
                "a mass needs a name before its value, for example `m1: {text}`{}",
                reader.comma_hint()
            ),
            _ => format!(
                "the name of a mass belongs here, not {}; write, for example, `m1: 1.0`",
                reader.found()
            ),
        };
        return Err(problems.report(place, message));
    };
    reader.take_colon(problems, "the name of a mass and its value")?;
    let value = number(reader, problems);
    Ok(Read {
        value: value.value.map(|value| MassEntry { name, value }),
        clean: value.clean,
    })
}

/// Parses the springs: `{ node - node: number, … }`.
pub(crate) fn springs(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<SpringEntry>> {
    let begins = |reader: &TokenReader<'_>| {
        reader.is_word(0) && reader.is_punct(1, '-') && reader.is_word(2) && reader.is_punct(3, ':')
    };
    braces(
        reader,
        problems,
        "the springs must be in braces",
        "{ base - m1: 1.0 }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                spring(reader, problems).unwrap_or_else(|Reported| Read::lost())
            })
        },
    )
}

fn spring(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<Read<SpringEntry>, Reported> {
    link(
        reader,
        problems,
        "a spring",
        "the ends of a spring and its stiffness",
    )
}

/// Parses `node - node: number`. For error messages, `what` names the entry, such as "a spring". `parts` names what
/// the colon separates, such as "the ends of a spring and its stiffness".
pub(crate) fn link(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    what: &str,
    parts: &str,
) -> Result<Read<SpringEntry>, Reported> {
    let (from, to) = ends(reader, problems, what, "base - m1: 1.0")?;
    reader.take_colon(problems, parts)?;
    let stiffness = number(reader, problems);
    let value = stiffness.value.map(|stiffness| SpringEntry {
        from,
        to,
        stiffness,
    });
    Ok(Read {
        value,
        clean: stiffness.clean,
    })
}

/// Parses the contact: `mass - wall`, `mass - mass` or `mass - base`, in either order. Its properties may follow in
/// braces.
pub(crate) fn contact(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<ContactEntry> {
    if let Some(Token {
        kind: TokenKind::Group { .. },
        place,
    }) = reader.peek(0)
    {
        let message = "`contact` takes one contact without brackets; write, for example, `m1 - wall`, or several as `contacts: { pads: m1 - wall, brace: base - m1 }`";
        return Err(problems.report(*place, message)).into();
    }
    let sides = match ends(reader, problems, "the contact", "m1 - wall") {
        Ok(sides) => sides,
        Err(reported) => return Err(reported).into(),
    };
    let has_properties = matches!(
        reader.peek(0),
        Some(Token {
            kind: TokenKind::Group {
                bracket: Delimiter::Brace,
                ..
            },
            ..
        })
    );
    let named = has_properties.then(|| {
        let name = Name {
            text: "contact".to_owned(),
            place: sides.0.place,
        };
        joints::with_properties(reader, problems, name, sides.clone())
    });
    let (from, to) = sides;
    Read::clean(ContactEntry { from, to, named })
}

/// Parses the two nodes of a spring, dashpot or contact: `node - node`.
pub(crate) fn ends(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    what: &str,
    example: &str,
) -> Result<(Name, Name), Reported> {
    let from = node(reader, problems, what, example)?;
    let place = reader.place();
    if !reader.take_punct('-') {
        let message = format!(
            "a hyphen joins the two sides of {what}, but here is {}; write, for example, `{example}`",
            reader.found()
        );
        return Err(problems.report(place, message));
    }
    let arrow = reader.place();
    if reader.take_punct('>') {
        problems.report(
            arrow,
            format!("a plain hyphen joins the two sides of {what}; delete `>`"),
        );
    }
    let to = node(reader, problems, what, example)?;
    Ok((from, to))
}

fn node(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    what: &str,
    example: &str,
) -> Result<Name, Reported> {
    let place = reader.place();
    reader.take_word().ok_or_else(|| {
        let message = format!(
            "one side of {what} belongs here (a mass, `base` or `wall`), not {}; write, for example, `{example}`{}",
            reader.found(),
            reader.comma_hint()
        );
        problems.report(place, message)
    })
}

/// Parses the excitation: the name of a mass, or `base`.
pub(crate) fn excitation(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<Name> {
    let place = reader.place();
    reader
        .take_word()
        .ok_or_else(|| {
            let message = format!(
                "the excitation must be a mass (a force acts on it) or `base` (the base moves), not {}; write, for example, `base`",
                reader.found()
            );
            problems.report(place, message)
        })
        .into()
}

/// Parses a list in braces, `{ …, … }`. The function `read` parses each entry.
pub(crate) fn braces<T>(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    what: &str,
    example: &str,
    read: impl FnOnce(&mut TokenReader<'_>, &mut Problems) -> List<T>,
) -> Read<Placed<T>> {
    let place = reader.place();
    match reader.take_group(Delimiter::Brace) {
        Some(mut inside) => {
            let list = read(&mut inside.reader, problems);
            Read::clean(Placed {
                list,
                place: inside.place,
            })
        }
        None => {
            let message = format!(
                "{what}, but here is {}; write, for example, `{example}`",
                reader.found()
            );
            problems.report(place, message);
            Read::lost()
        }
    }
}

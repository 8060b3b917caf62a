//! Parses the fields `contacts` (several contacts) and `dampers` (dashpots) of a description, and the properties of an
//! entry in braces.

use super::chain::{braces, ends, link};
use super::number::{Number, number};
use super::reader::{Name, Read, TokenReader};
use super::suggest;
use super::syntax::{JointEntry, Placed, SpringEntry};
use super::token::Delimiter;
use crate::diagnostics::{Problems, Reported, TokenPosition};

/// The properties that a contact of the field `contacts` may have.
const PROPERTIES: Properties<4> = Properties {
    owner: "contact",
    names: ["stiffness", "stiction", "share", "speed"],
    example: "share: 0.5",
};

/// Parses the field `contacts`: `{ name: node - node { stiffness: number, stiction: number, share: number, speed:
/// number }, … }`.
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
pub(crate) fn filled<T>(
    read: Read<Placed<T>>,
    problems: &mut Problems,
    message: &str,
) -> Read<Placed<T>> {
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
    let sides = ends(reader, problems, "the contact", "m1 - wall")?;
    Ok(Read::clean(with_properties(reader, problems, name, sides)))
}

/// Parses the properties of a contact in braces, if an opening brace follows its sides.
pub(crate) fn with_properties(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    name: Name,
    (from, to): (Name, Name),
) -> JointEntry {
    let (values, complete) = PROPERTIES.read(reader, problems);
    let [stiffness, stiction, share, speed] =
        values.map(|value| value.map(|Property { number, .. }| number));
    JointEntry {
        name,
        from,
        to,
        stiffness,
        stiction,
        share,
        speed,
        complete,
    }
}

/// The properties that an entry of a list may have in braces: their names, and words for messages.
pub(crate) struct Properties<const N: usize> {
    /// Word for the entry.
    pub(crate) owner: &'static str,
    pub(crate) names: [&'static str; N],
    /// A valid property.
    pub(crate) example: &'static str,
}

/// A property of an entry, with the position of its name.
#[derive(Clone, Copy)]
pub(crate) struct Property {
    pub(crate) place: TokenPosition,
    pub(crate) number: Number,
}

impl<const N: usize> Properties<N> {
    /// Parses the properties in braces, `{ name: number, … }`, if an opening brace follows. Returns them in the order of
    /// `names`, and true if the parser could read all of them.
    pub(crate) fn read(
        &self,
        reader: &mut TokenReader<'_>,
        problems: &mut Problems,
    ) -> ([Option<Property>; N], bool) {
        let mut values = [None; N];
        let Some(mut inside) = reader.take_group(Delimiter::Brace) else {
            return (values, true);
        };
        let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
        let list = inside
            .reader
            .list(problems, begins, begins, |reader, problems| {
                self.one(reader, problems, &mut values)
                    .unwrap_or_else(|Reported| Read::lost())
            });
        (values, list.complete)
    }

    /// Parses one property: `name: number`.
    fn one(
        &self,
        reader: &mut TokenReader<'_>,
        problems: &mut Problems,
        values: &mut [Option<Property>; N],
    ) -> Result<Read<()>, Reported> {
        let (owner, place) = (self.owner, reader.place());
        let Some(word) = reader.take_word() else {
            let message = format!(
                "a property of a {owner} belongs here, not {}; write, for example, `{}`",
                reader.found(),
                self.example
            );
            return Err(problems.report(place, message));
        };
        let mut slots = self.names.iter().zip(values);
        let Some((_, slot)) = slots.find(|(name, _)| **name == word.text) else {
            let text = word.text.as_str();
            let hint = suggest::hint(text, self.names, || format!("write {}", self.all()));
            return Err(problems.report(place, format!("a {owner} has no `{text}`{hint}")));
        };
        if slot.is_some() {
            let message = format!("`{}` is given twice; keep one of the two", word.text);
            return Err(problems.report(place, message));
        }
        reader.take_colon(problems, &format!("a property of a {owner} and its value"))?;
        let value: Read<Number> = number(reader, problems);
        *slot = value.value.map(|number| Property { place, number });
        Ok(Read {
            value: value.value.map(|_| ()),
            clean: value.clean,
        })
    }

    /// Returns the names of all properties, joined by commas and a final "or".
    fn all(&self) -> String {
        let names = self.names.map(|name| format!("`{name}`"));
        match names.split_last() {
            Some((last, [])) => last.clone(),
            Some((last, others)) => format!("{} or {last}", others.join(", ")),
            None => String::new(),
        }
    }
}

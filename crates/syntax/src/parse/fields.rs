//! Parses the fields between the braces of a description, in any order.

use frictiongen_model::scene::Precision;
use frictiongen_model::validate::is_keyword;

use super::chain;
use super::declared;
use super::forms;
use super::joints;
use super::reader::{Name, Read, TokenReader};
use super::stepping;
use super::stops;
use super::suggest;
use super::syntax::{Fields, RustPath, Slot};
use super::token::{Token, TokenKind};
use crate::diagnostics::{Problems, Reported, TokenPosition};

/// The fields that a description may have.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Field {
    Masses,
    Springs,
    Contact,
    Contacts,
    Dampers,
    Stops,
    Constant,
    Excitation,
    Damping,
    DampingFrom,
    Stiction,
    Stiffness,
    Scalar,
    Provide,
    Accuracy,
    Range,
    Side,
    Budget,
    Beyond,
    Proof,
    Friction,
    Stribeck,
    Step,
    Input,
    Force,
    Crate,
}

const FIELDS: [(&str, Field); 26] = [
    ("masses", Field::Masses),
    ("springs", Field::Springs),
    ("contact", Field::Contact),
    ("contacts", Field::Contacts),
    ("excitation", Field::Excitation),
    ("damping", Field::Damping),
    ("damping_from", Field::DampingFrom),
    ("dampers", Field::Dampers),
    ("stops", Field::Stops),
    ("constant", Field::Constant),
    ("stiction", Field::Stiction),
    ("stiffness", Field::Stiffness),
    ("scalar", Field::Scalar),
    ("provide", Field::Provide),
    ("accuracy", Field::Accuracy),
    ("range", Field::Range),
    ("side", Field::Side),
    ("budget", Field::Budget),
    ("beyond", Field::Beyond),
    ("proof", Field::Proof),
    ("friction", Field::Friction),
    ("stribeck", Field::Stribeck),
    ("step", Field::Step),
    ("input", Field::Input),
    ("force", Field::Force),
    ("crate", Field::Crate),
];

fn known(word: &str) -> Option<Field> {
    FIELDS
        .iter()
        .find(|(name, _)| *name == word)
        .map(|&(_, field)| field)
}

/// Returns the names of all fields that a description may have.
fn names() -> impl Iterator<Item = &'static str> {
    FIELDS.iter().map(|&(name, _)| name)
}

/// Returns true if a known field begins at the next token. `crate: …` begins a field, even with a path as in `crate:
/// ::path`. `crate::path` does not begin a field.
pub(crate) fn begins(reader: &TokenReader<'_>) -> bool {
    matches!(reader.peek(0), Some(Token { kind: TokenKind::Word(text), .. }) if known(text).is_some())
        && reader.is_punct(1, ':')
        && (!reader.is_punct(2, ':') || reader.is_punct(3, ':'))
}

/// Parses all fields of a description.
pub(crate) fn fields(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Fields {
    let mut fields = Fields::default();
    reader.list(
        problems,
        |reader| reader.is_word(0) && reader.is_punct(1, ':'),
        begins,
        |reader, problems| match field(reader, problems, &mut fields) {
            Ok(()) => Read::clean(()),
            Err(Reported) => Read::lost(),
        },
    );
    fields.list_contact();
    fields
}

fn field(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    fields: &mut Fields,
) -> Result<(), Reported> {
    let place = reader.place();
    let Some(word) = reader.take_word() else {
        let message = format!(
            "the name of a field belongs here, not {}; write, for example, `stiction: 1.2`{}",
            reader.found(),
            reader.comma_hint()
        );
        return Err(problems.report(place, message));
    };
    if fields.contact.given().is_some() && reader.is_punct(0, '-') && known(&word.text).is_none() {
        let message = "`contact` takes one contact; write both as `contacts: { pads: m1 - wall, brace: base - m1 }`, or delete this one";
        return Err(problems.report(place, message));
    }
    // If the name of a field is unknown and the colon is missing, the parser reports only the unknown name.
    let field = recognise(&word, problems).ok_or(Reported)?;
    reader.take_colon(problems, "the name of a field and its value")?;
    match field {
        Field::Masses => store(&mut fields.masses, &word, reader, problems, chain::masses),
        Field::Springs => store(&mut fields.springs, &word, reader, problems, chain::springs),
        Field::Contact => store(&mut fields.contact, &word, reader, problems, chain::contact),
        Field::Contacts => store(
            &mut fields.contacts,
            &word,
            reader,
            problems,
            joints::contacts,
        ),
        Field::Dampers => store(
            &mut fields.dampers,
            &word,
            reader,
            problems,
            joints::dampers,
        ),
        Field::Stops => store(&mut fields.stops, &word, reader, problems, stops::stops),
        Field::Constant => store(
            &mut fields.constant,
            &word,
            reader,
            problems,
            stops::constant,
        ),
        Field::Excitation => store(
            &mut fields.excitation,
            &word,
            reader,
            problems,
            chain::excitation,
        ),
        Field::Damping => store(&mut fields.damping, &word, reader, problems, forms::damping),
        Field::DampingFrom => store(
            &mut fields.damping_from,
            &word,
            reader,
            problems,
            forms::damping_from,
        ),
        Field::Stiction => store(
            &mut fields.stiction,
            &word,
            reader,
            problems,
            super::number::number,
        ),
        Field::Stiffness => store(
            &mut fields.stiffness,
            &word,
            reader,
            problems,
            super::number::number,
        ),
        Field::Scalar => store(&mut fields.scalar, &word, reader, problems, scalar),
        Field::Provide => store(&mut fields.provide, &word, reader, problems, forms::provide),
        Field::Accuracy => store(
            &mut fields.accuracy,
            &word,
            reader,
            problems,
            declared::accuracy,
        ),
        Field::Range => store(&mut fields.range, &word, reader, problems, declared::range),
        Field::Side => store(&mut fields.side, &word, reader, problems, declared::side),
        Field::Budget => store(
            &mut fields.budget,
            &word,
            reader,
            problems,
            super::number::number,
        ),
        Field::Beyond => store(
            &mut fields.beyond,
            &word,
            reader,
            problems,
            declared::beyond,
        ),
        Field::Proof => store(&mut fields.proof, &word, reader, problems, declared::proof),
        Field::Friction => store(
            &mut fields.friction,
            &word,
            reader,
            problems,
            stepping::friction,
        ),
        Field::Stribeck => store(
            &mut fields.friction,
            &word,
            reader,
            problems,
            stepping::stribeck,
        ),
        Field::Step => store(
            &mut fields.step,
            &word,
            reader,
            problems,
            super::number::number,
        ),
        Field::Input => store(&mut fields.input, &word, reader, problems, stepping::input),
        Field::Force => store(&mut fields.force, &word, reader, problems, stepping::force),
        Field::Crate => store(&mut fields.facade, &word, reader, problems, facade),
    }
}

/// Wrong names of fields for the friction force or the friction ratio. A description must not contain the friction,
/// because the user gives it with each computation.
const AMOUNTS: [&str; 4] = ["friction_force", "friction_ratio", "beta", "coulomb"];

/// Words that users write by mistake instead of the name of a field, in groups with a common message.
const ASKED: [(&[&str], &str); 2] = [
    (
        &["frequency", "frequency_ratio", "omega", "r"],
        "delete it here, and give the frequency ratio r = ω√(m₁/k₁) with each request, as in `Frame::at(0.9)` or `--r 0.9`",
    ),
    (&["mu", "static_friction"], "did you mean `stiction`?"),
];

/// Returns the field that a word names. For a misspelt word, the function reports the error and returns the intended
/// field. The parser then does not also report this field as missing.
fn recognise(word: &Name, problems: &mut Problems) -> Option<Field> {
    let text = word.text.as_str();
    if AMOUNTS.contains(&text) {
        let message = format!("a scene has no field `{text}`; {}", stepping::HOW_MUCH);
        problems.report(word.place, message);
        return None;
    }
    if let Some((_, message)) = ASKED.iter().find(|(words, _)| words.contains(&text)) {
        problems.report(
            word.place,
            format!("a scene has no field `{text}`; {message}"),
        );
        return None;
    }
    known(text).or_else(|| {
        let hint = suggest::hint(text, names(), || {
            format!("the fields are {}", names().collect::<Vec<_>>().join(", "))
        });
        problems.report(word.place, format!("a scene has no field `{text}`{hint}"));
        suggest::closest(text, names()).and_then(known)
    })
}

/// Parses the value of a field and stores it. If the description has the field twice, the function keeps the first
/// value.
fn store<'t, T>(
    slot: &mut Slot<T>,
    word: &Name,
    reader: &mut TokenReader<'t>,
    problems: &mut Problems,
    read: impl FnOnce(&mut TokenReader<'t>, &mut Problems) -> Read<T>,
) -> Result<(), Reported> {
    let first = slot.is_missing();
    if !first {
        let message = format!("`{}` is given twice; keep one of the two", word.text);
        problems.report(word.place, message);
    }
    let value = if reader.is_empty() || reader.is_punct(0, ',') || begins(reader) {
        let message = format!(
            "the field `{}` has no value; write it after the colon",
            word.text
        );
        problems.report(word.place, message);
        Read::lost()
    } else {
        read(reader, problems)
    };
    if first {
        *slot = value.value.map_or(Slot::Broken, Slot::Given);
    }
    if value.clean { Ok(()) } else { Err(Reported) }
}

fn scalar(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<Precision> {
    let place = reader.place();
    let found = reader.found();
    match reader.take_word().map(|word| word.text).as_deref() {
        Some("f64") => Read::clean(Precision::F64),
        Some("f32") => Read::clean(Precision::F32),
        _ => {
            problems.report(
                place,
                format!("the scalar is `f64` or `f32`, not {found}; write one of the two"),
            );
            Read::lost()
        }
    }
}

/// Parses the path by which the user's crate refers to the crate `frictiongen`.
fn facade(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<RustPath> {
    let place = reader.place();
    path(reader).map_or_else(
        || {
            let message = format!(
                "`crate` is the path of the library, not {}; write, for example, `::frictiongen`",
                TokenReader::found(reader)
            );
            problems.report(place, message);
            Read::lost()
        },
        Read::clean,
    )
}

/// Parses words joined by `::`. Returns `None` if the words are not a path that Rust accepts.
pub(crate) fn path(reader: &mut TokenReader<'_>) -> Option<RustPath> {
    let mut path = RustPath {
        segments: Vec::new(),
    };
    let mut before = colons(reader);
    loop {
        if reader.peek(0).is_some_and(in_no_path) {
            return None;
        }
        path.segments.push((before, reader.take_word()?));
        before = colons(reader);
        if before.is_none() {
            return Some(path);
        }
    }
}

/// Returns true if the token is a keyword that a path of Rust may not contain.
fn in_no_path(token: &Token) -> bool {
    let TokenKind::Word(text) = &token.kind else {
        return false;
    };
    is_keyword(text) && !["crate", "self", "super"].contains(&text.as_str())
}

/// Reads `::` and returns its position.
fn colons(reader: &mut TokenReader<'_>) -> Option<TokenPosition> {
    let place = reader.place();
    if reader.is_punct(0, ':') && reader.is_punct(1, ':') {
        reader.next();
        reader.next();
        Some(place)
    } else {
        None
    }
}

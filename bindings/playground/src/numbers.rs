//! Finds the numbers of a description with their positions in the text. A slider of the page uses them to rewrite a
//! number.

use frictiongen::study::scene::{Damping, Scene};
use serde_json::{Value, json};

/// A token of a description: its bytes, and the depth of brackets around it.
#[derive(Clone, Copy, Debug)]
struct Token<'a> {
    text: &'a str,
    start: usize,
}

impl Token<'_> {
    fn end(&self) -> usize {
        self.start + self.text.len()
    }

    fn is_name(&self) -> bool {
        let first = self.text.chars().next();
        first.is_some_and(|first| first.is_alphabetic() || first == '_')
    }
}

/// Returns the numbers of a valid description, each with its kind, name, value, and range in the text. The range
/// counts the units of UTF-16, as the browser does.
pub fn numbers(text: &str, scene: &Scene) -> Vec<Value> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    let start = tokens.iter().position(|token| token.text == "{");
    let mut rest = tokens
        .get(start.map_or(0, |start| start + 1)..)
        .unwrap_or(&[]);
    while let [name, colon, ..] = rest {
        if colon.text != ":" || !name.is_name() {
            rest = rest.get(1..).unwrap_or(&[]);
            continue;
        }
        let body = rest.get(2..).unwrap_or(&[]);
        let length = length_of_value(body);
        let (value, after) = body.split_at(length);
        field(name.text, value, &mut found);
        rest = after.get(1..).unwrap_or(&[]);
    }
    let position = |byte: usize| {
        text.get(..byte)
            .map_or(0, |text| text.encode_utf16().count())
    };
    let values = found.into_iter().filter_map(|number: Number| {
        let value = value_of(&number, scene)?;
        Some(json!({
            "kind": number.kind, "name": number.name, "value": value,
            "start": position(number.range.0), "end": position(number.range.1),
        }))
    });
    values.collect()
}

/// A number in the text of a description.
struct Number {
    /// The field of the description that has the number, or the field of a contact if there are several contacts.
    kind: &'static str,
    /// The name of the mass, spring, dashpot or contact.
    name: String,
    /// Index of the number among those of its kind, or the index of its contact.
    index: usize,
    /// Range of the number in the text: its first byte, and the byte after its last.
    range: (usize, usize),
}

/// Finds the numbers of one field of the description, and adds them to `found`.
fn field(name: &str, value: &[Token<'_>], found: &mut Vec<Number>) {
    let single = |kind| Number {
        kind,
        name: String::new(),
        index: 0,
        range: range(value),
    };
    match name {
        "masses" => entries("mass", inside(value), found),
        "springs" => entries("spring", inside(value), found),
        "dampers" => entries("damper", inside(value), found),
        "contacts" => contacts(inside(value), found),
        "stiction" => found.push(single("stiction")),
        "stiffness" => found.push(single("stiffness")),
        "damping" => {
            let list = value.get(2..value.len().max(3) - 1).unwrap_or(&[]);
            let numbers = parts(list).into_iter().enumerate();
            found.extend(numbers.map(|(index, part)| Number {
                kind: "damping",
                name: (index + 1).to_string(),
                index,
                range: range(part),
            }));
        }
        _ => {}
    }
}

/// Finds the numbers of a list whose entries have a name and a number, such as the masses. Adds them to `found`.
fn entries(kind: &'static str, list: &[Token<'_>], found: &mut Vec<Number>) {
    for (index, part) in parts(list).into_iter().enumerate() {
        if let Some(colon) = part.iter().position(|token| token.text == ":") {
            let (name, value) = part.split_at(colon);
            found.push(Number {
                kind,
                name: joined(name),
                index,
                range: range(value.get(1..).unwrap_or(&[])),
            });
        }
    }
}

/// Finds the numbers of the field `contacts`, and adds them to `found`.
fn contacts(list: &[Token<'_>], found: &mut Vec<Number>) {
    for (index, part) in parts(list).into_iter().enumerate() {
        let Some(open) = part.iter().position(|token| token.text == "{") else {
            continue;
        };
        let name = part.first().map_or("", |token| token.text);
        for number in parts(inside(part.get(open..).unwrap_or(&[]))) {
            let kind = match number.first().map(|token| token.text) {
                Some("stiffness") => "stiffness",
                Some("stiction") => "stiction",
                Some("share") => "share",
                _ => continue,
            };
            found.push(Number {
                kind,
                name: name.to_owned(),
                index,
                range: range(number.get(2..).unwrap_or(&[])),
            });
        }
    }
}

fn value_of(number: &Number, scene: &Scene) -> Option<f64> {
    let index = number.index;
    let law = (!number.name.is_empty()).then(|| Some(scene.joints.contacts.get(index)?.law));
    match number.kind {
        "mass" => Some(scene.masses.get(index)?.value),
        "spring" => Some(scene.springs.get(index)?.stiffness),
        "damper" => Some(scene.joints.dampers.get(index)?.coefficient),
        "share" => Some(law??.share),
        "stiction" => Some(law.map_or(Some(scene.stiction), |law| Some(law?.stiction))?),
        "stiffness" => law.map_or(scene.stiffness, |law| law?.stiffness),
        "damping" => match &scene.damping {
            Damping::None => None,
            Damping::Uniform(ratio) => (index == 0).then_some(*ratio),
            Damping::Modal(ratios) => ratios.get(index).copied(),
            Damping::Rayleigh { mass, stiffness } => [*mass, *stiffness].get(index).copied(),
        },
        _ => None,
    }
}

fn joined(tokens: &[Token<'_>]) -> String {
    let texts: Vec<&str> = tokens.iter().map(|token| token.text).collect();
    texts.join(" ")
}

fn range(tokens: &[Token<'_>]) -> (usize, usize) {
    match (tokens.first(), tokens.last()) {
        (Some(first), Some(last)) => (first.start, last.end()),
        _ => (0, 0),
    }
}

/// Returns the tokens between the outer brackets of a value.
fn inside<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    tokens.get(1..tokens.len().max(2) - 1).unwrap_or(&[])
}

/// Returns the number of tokens of a value. The value ends at a comma outside of brackets, or at the bracket that
/// closes the list.
fn length_of_value(tokens: &[Token<'_>]) -> usize {
    let mut depth = 0_i32;
    for (index, token) in tokens.iter().enumerate() {
        match token.text {
            "{" | "[" | "(" => depth += 1,
            "}" | "]" | ")" if depth == 0 => return index,
            "}" | "]" | ")" => depth -= 1,
            "," if depth == 0 => return index,
            _ => {}
        }
    }
    tokens.len()
}

/// Splits the tokens of a list at its commas.
fn parts<'t, 'a>(mut list: &'t [Token<'a>]) -> Vec<&'t [Token<'a>]> {
    let mut parts = Vec::new();
    while !list.is_empty() {
        let (part, after) = list.split_at(length_of_value(list));
        if !part.is_empty() {
            parts.push(part);
        }
        list = after.get(1..).unwrap_or(&[]);
    }
    parts
}

/// Splits a description into names, numbers and signs, and leaves out comments.
fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut start = 0;
    while let Some(rest) = text.get(start..).filter(|rest| !rest.is_empty()) {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            comment(rest)
        } else {
            let length = word(rest);
            if let Some(text) = rest.get(..length).filter(|text| !text.trim().is_empty()) {
                tokens.push(Token { text, start });
            }
            length
        };
        start += length.max(1);
    }
    tokens
}

/// Returns the length in bytes of the comment at the start of the text. A comment may contain other comments.
fn comment(rest: &str) -> usize {
    let (mut depth, mut place) = (0, 0);
    while let Some(tail) = rest.get(place..).filter(|tail| !tail.is_empty()) {
        if tail.starts_with("/*") {
            (depth, place) = (depth + 1, place + 2);
        } else if tail.starts_with("*/") {
            (depth, place) = (depth - 1, place + 2);
            if depth == 0 {
                return place;
            }
        } else {
            place += tail.chars().next().map_or(1, char::len_utf8);
        }
    }
    rest.len()
}

/// Returns the length in bytes of the name, number or sign at the start of the text.
fn word(rest: &str) -> usize {
    let is_word = |char: char| char.is_alphanumeric() || char == '_' || char == '.';
    let mut before = ' ';
    let number = rest.starts_with(|first: char| first.is_ascii_digit() || first == '.');
    for (place, char) in rest.char_indices() {
        let exponent = number && matches!(before, 'e' | 'E') && matches!(char, '+' | '-');
        if !is_word(char) && !exponent {
            return if place == 0 { char.len_utf8() } else { place };
        }
        before = char;
    }
    rest.len()
}

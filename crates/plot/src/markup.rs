//! Parses the markup of labels.

use crate::face::{Face, Level};
use crate::label::Label;

impl Label {
    /// Creates a label from text with markup: stars for italic and bold, `_` and `^` for subscripts and superscripts.
    #[must_use]
    pub fn new(markup: &str) -> Self {
        let mut label = Self::default();
        let characters: Vec<char> = markup.chars().collect();
        read(&mut label, &characters, Face::Regular, Level::Base);
        label
    }
}

/// Parses markup and appends the pieces of text to a label.
fn read(label: &mut Label, markup: &[char], face: Face, level: Level) {
    let mut rest = markup;
    while let [first, after @ ..] = rest {
        rest = match (*first, level) {
            ('\\', _) => match after {
                [escaped, after @ ..] => {
                    letter(label, *escaped, face, level);
                    after
                }
                [] => after,
            },
            ('*', _) => starred(label, after, face, level),
            ('_', Level::Base) => shifted(label, after, face, Level::Sub),
            ('^', Level::Base) => shifted(label, after, face, Level::Sup),
            (character, _) => {
                letter(label, character, face, level);
                after
            }
        };
    }
}

/// Parses the text after a star. The text is emphasised up to the closing star. Without a closing star, the text is
/// plain.
fn starred<'a>(label: &mut Label, after: &'a [char], face: Face, level: Level) -> &'a [char] {
    let (marks, inner) = match after {
        ['*', inner @ ..] => (2, inner),
        _ => (1, after),
    };
    // A star before a space is a multiplication sign.
    if inner.first() != Some(&' ')
        && let Some((inner, rest)) = closed(inner, marks)
    {
        let emphasis = match (face, marks) {
            (Face::Italic, 1) | (Face::Bold, 2) => Face::Regular,
            (_, 1) => Face::Italic,
            _ => Face::Bold,
        };
        read(label, inner, emphasis, level);
        rest
    } else {
        letter(label, '*', face, level);
        after
    }
}

/// Parses the subscript after `_` or the superscript after `^`.
fn shifted<'a>(label: &mut Label, after: &'a [char], face: Face, level: Level) -> &'a [char] {
    if let ['{', inner @ ..] = after
        && let Some(end) = inner.iter().position(|c| *c == '}')
        && let (inner, [_, rest @ ..]) = inner.split_at(end)
    {
        read(label, inner, face, level);
        return rest;
    }
    let alike = |kind: fn(&char) -> bool| after.iter().take_while(|c| kind(c)).count();
    let digits = alike(|c| c.is_ascii_digit());
    let letters = alike(|c| c.is_alphabetic());
    let (inner, rest) = after.split_at(digits.max(letters).max(1).min(after.len()));
    for character in inner {
        letter(label, *character, face, level);
    }
    rest
}

/// Single characters for a letter with a bar, each followed by the same letter without a bar.
const BARRED: [(char, char); 12] = [
    ('Ā', 'A'),
    ('ā', 'a'),
    ('Ē', 'E'),
    ('ē', 'e'),
    ('Ī', 'I'),
    ('ī', 'i'),
    ('Ō', 'O'),
    ('ō', 'o'),
    ('Ū', 'U'),
    ('ū', 'u'),
    ('Ȳ', 'Y'),
    ('ȳ', 'y'),
];

/// Appends one character to a label. Unicode subscript digits, which few fonts have, become real subscripts.
fn letter(label: &mut Label, character: char, face: Face, level: Level) {
    let code = character as u32;
    let digit = (0x2080..=0x2089)
        .contains(&code)
        .then(|| char::from_digit(code - 0x2080, 10))
        .flatten();
    let (character, level) = digit.map_or((character, level), |digit| (digit, Level::Sub));
    // Every bar becomes a combining macron. Unicode has two other forms of a bar: the combining overline, and single
    // characters for a letter with a bar.
    let (character, bar) = match character {
        '\u{305}' => ('\u{304}', false),
        _ => BARRED
            .iter()
            .find(|(barred, _)| *barred == character)
            .map_or((character, false), |(_, bare)| (*bare, true)),
    };
    label.push(character.encode_utf8(&mut [0; 4]), face, level);
    if bar {
        label.push("\u{304}", face, level);
    }
}

/// Returns the text before the closing stars, and the text after the closing stars.
fn closed(markup: &[char], marks: usize) -> Option<(&[char], &[char])> {
    let mut at = 0;
    while let Some(rest) = markup.get(at..) {
        match rest {
            ['\\' | '^', _, ..] => at += 2,
            ['*', '*', ..] if marks == 2 && at != 0 => {
                return Some((markup.get(..at)?, markup.get(at + 2..)?));
            }
            ['*', ..] if marks == 1 && at != 0 => {
                return Some((markup.get(..at)?, markup.get(at + 1..)?));
            }
            [_, ..] => at += 1,
            [] => return None,
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use crate::face::{Face, Level};
    use crate::label::{Label, Span};

    /// Writes the pieces of a label in short form as `face level text`.
    fn read(markup: &str) -> Vec<String> {
        let name = |span: &Span| {
            let face = match span.face {
                Face::Regular => "",
                Face::Italic => "i",
                Face::Bold => "b",
            };
            let level = match span.level {
                Level::Base => "",
                Level::Sub => "_",
                Level::Sup => "^",
            };
            format!("{face}{level}:{}", span.text)
        };
        Label::new(markup).spans().iter().map(name).collect()
    }

    #[test]
    fn reads_markup() {
        assert_eq!(read("β_lim"), [":β", "_:lim"]);
        assert_eq!(read("*β*^*_lim"), ["i:β", "^:*", "_:lim"]);
        assert_eq!(
            read("*F*/(*k*_1*Y*)"),
            ["i:F", ":/(", "i:k", "_:1", "i:Y", ":)"]
        );
        assert_eq!(read("*X̄*_{1, fft} = 2"), ["i:X̄", "_:1, fft", ": = 2"]);
        assert_eq!(read("10^{−3}"), [":10", "^:−3"]);
        assert_eq!(
            read("**Figure 6.6** *m*₁"),
            ["b:Figure 6.6", ": ", "i:m", "_:1"]
        );
        assert_eq!(read("*β_lim*"), ["i:β", "i_:lim"]);
        assert_eq!(read("_{*n*}"), ["i_:n"]);
    }

    #[test]
    fn a_bar_is_one_of_its_own() {
        assert_eq!(read("*\u{233}*"), ["i:y\u{304}"]);
        assert_eq!(read("*y\u{305}*"), ["i:y\u{304}"]);
    }

    #[test]
    fn keeps_what_is_no_markup() {
        assert_eq!(read("a * b * c"), [":a * b * c"]);
        assert_eq!(read("**"), [":**"]);
        assert_eq!(read(r"a\_b\*c\\"), [r":a_b*c\"]);
        assert_eq!(read("x_"), [":x"]);
        assert_eq!(read("x_{1"), [":x", "_:{", ":1"]);
        assert_eq!(read("\\"), Vec::<String>::new());
        assert_eq!(read(""), Vec::<String>::new());
        assert_eq!(Label::verbatim("a_b").plain(), "a_b");
    }
}

//! Labels: text with real subscripts, superscripts and italic symbols.

use crate::face::{Face, Level};
use crate::metrics::advance;

/// A piece of text with one typeface and one vertical level.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// The characters of the piece.
    pub text: String,
    /// Typeface of the letters: regular, italic or bold.
    pub face: Face,
    /// Vertical level of the letters: normal, subscript or superscript.
    pub level: Level,
}

/// A line of text with subscripts, superscripts and italic symbols, read from simple markup.
///
/// | markup | means |
/// |---|---|
/// | `*r*` | italic |
/// | `**(a)**` | bold |
/// | `_1`, `_lim`, `_{fft}` | subscript: the digits or the letters that follow, or the text in the braces |
/// | `^2`, `^*`, `^{−3}` | superscript, with the same rule |
/// | `X̄` | a bar: the combining macron, U+0304, after its letter |
/// | `\_`, `\^`, `\*`, `\\` | the character itself |
///
/// A star without a closing star is printed as a star.
///
/// ```
/// use frictiongen_plot::Label;
/// assert_eq!(Label::new("*X̄*_1 at *β*_lim").plain(), "X̄1 at βlim");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Label {
    spans: Vec<Span>,
}

impl Label {
    /// Creates a label from plain text, in which markup characters have no special meaning.
    #[must_use]
    pub fn verbatim(text: &str) -> Self {
        let mut label = Self::default();
        label.push(text, Face::Regular, Level::Base);
        label
    }

    /// Returns the pieces of text of the label, from left to right.
    #[must_use]
    pub fn spans(&self) -> &[Span] {
        &self.spans
    }

    /// Returns true if the label has no text.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }

    /// Returns the text of the label without markup.
    #[must_use]
    pub fn plain(&self) -> String {
        self.spans.iter().map(|span| span.text.as_str()).collect()
    }

    /// Returns a label with the text of this label, followed by the text of another.
    #[must_use]
    pub fn then(mut self, other: &Self) -> Self {
        for span in &other.spans {
            self.push(&span.text, span.face, span.level);
        }
        self
    }

    /// Returns the width of the label in pixels, if it is set at the text size `size` in the embedded fonts.
    pub(crate) fn width(&self, size: f64) -> f64 {
        self.spans
            .iter()
            .map(|span| {
                let advances = span.text.chars().map(|c| u32::from(advance(span.face, c)));
                f64::from(advances.sum::<u32>()) * 1e-3 * span.level.size() * size
            })
            .sum()
    }

    /// Splits the label, set at the text size `size`, into lines that are at most `width` pixels wide. A line with a
    /// single word may be wider.
    pub(crate) fn wrapped(&self, size: f64, width: f64) -> Vec<Self> {
        let mut lines = Vec::new();
        let mut line = Self::default();
        for word in self.words() {
            let longer = line.clone().then(&word);
            if line.is_empty() || longer.trimmed().width(size) <= width {
                line = longer;
            } else {
                lines.push(line.trimmed());
                line = word;
            }
        }
        lines.push(line.trimmed());
        lines.retain(|line| !line.is_empty());
        lines
    }

    /// Splits the label into words, each with the space after it. An equals sign with its two sides, such as "*r* =
    /// 1", counts as one word.
    fn words(&self) -> Vec<Self> {
        let mut words = Vec::new();
        let mut word = Self::default();
        for span in &self.spans {
            for part in span.text.split_inclusive(' ') {
                word.push(part, span.face, span.level);
                if part.ends_with(' ') && span.level == Level::Base {
                    words.push(std::mem::take(&mut word));
                }
            }
        }
        words.push(word);
        // The code joins an equals sign to the words on both of its sides, so that no line break separates them.
        let mut joined: Vec<Self> = Vec::new();
        for word in words {
            let equals = |word: &Self| word.plain().trim_end() == "=";
            match joined.last_mut() {
                Some(last) if equals(&word) || last.plain().ends_with("= ") => {
                    *last = std::mem::take(last).then(&word);
                }
                _ => joined.push(word),
            }
        }
        joined
    }

    fn trimmed(&self) -> Self {
        let mut label = self.clone();
        if let Some(last) = label.spans.last_mut() {
            last.text.truncate(last.text.trim_end().len());
        }
        label.spans.retain(|span| !span.text.is_empty());
        label
    }

    pub(crate) fn push(&mut self, text: &str, face: Face, level: Level) {
        if text.is_empty() {
            return;
        }
        match self.spans.last_mut() {
            Some(last) if last.face == face && last.level == level => last.text.push_str(text),
            _ => self.spans.push(Span {
                text: text.to_owned(),
                face,
                level,
            }),
        }
    }
}

impl From<&str> for Label {
    fn from(markup: &str) -> Self {
        Self::new(markup)
    }
}

impl From<String> for Label {
    fn from(markup: String) -> Self {
        Self::new(&markup)
    }
}

impl From<&Self> for Label {
    fn from(label: &Self) -> Self {
        label.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::Label;

    #[test]
    fn a_bar_takes_no_room() {
        let bare = Label::new("*X*_1").width(10.0);
        assert!(5.0 < bare && bare < 20.0);
        assert_eq!(Label::new("*X̄*_1").width(10.0), bare);
        assert_eq!(Label::new("*X\u{305}*_1"), Label::new("*X\u{304}*_1"));
    }

    #[test]
    fn wraps_between_words() {
        let label = Label::new("one *two* three_4 five");
        let lines: Vec<String> = label.wrapped(10.0, 42.0).iter().map(Label::plain).collect();
        assert_eq!(lines, ["one two", "three4", "five"]);
        assert!(
            label
                .wrapped(10.0, 42.0)
                .iter()
                .all(|line| line.width(10.0) <= 42.0)
        );
        assert_eq!(label.wrapped(10.0, 0.0).len(), 4);
        assert!(Label::default().wrapped(10.0, 42.0).is_empty());
    }
}

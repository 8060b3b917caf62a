//! Labels: text with real subscripts, superscripts and italic symbols.

use crate::face::{Face, Level};
use crate::metrics::advance;

/// A run of text with one style and one level.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// The text.
    pub text: String,
    /// Style of the letters.
    pub face: Face,
    /// Vertical level.
    pub level: Level,
}

/// A line of text, read from simple markup.
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
    /// Makes a label from plain text without markup.
    #[must_use]
    pub fn verbatim(text: &str) -> Self {
        let mut label = Self::default();
        label.push(text, Face::Regular, Level::Base);
        label
    }

    /// Returns the runs of the label.
    #[must_use]
    pub fn spans(&self) -> &[Span] {
        &self.spans
    }

    /// Returns whether the label is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }

    /// Returns the text without markup.
    #[must_use]
    pub fn plain(&self) -> String {
        self.spans.iter().map(|span| span.text.as_str()).collect()
    }

    /// Returns this label followed by another.
    #[must_use]
    pub fn then(mut self, other: &Self) -> Self {
        for span in &other.spans {
            self.push(&span.text, span.face, span.level);
        }
        self
    }

    /// Returns the width at a size, in the embedded fonts.
    pub(crate) fn width(&self, size: f64) -> f64 {
        self.spans
            .iter()
            .map(|span| {
                let advances = span.text.chars().map(|c| u32::from(advance(span.face, c)));
                f64::from(advances.sum::<u32>()) * 1e-3 * span.level.size() * size
            })
            .sum()
    }

    /// Returns lines that are no wider than `width`, unless a single word is.
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

    /// Returns the words, each with the space after it. "*r* = 1" counts as one word.
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
        // An equals sign stays with both of its sides.
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

//! The pages of the gallery: each chapter's figures with their captions.

use frictiongen_plot::{Face, Label, Level};
use std::fmt::Write as _;

/// A figure in the gallery.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its number.
    pub number: String,
    /// What it shows.
    pub title: Label,
    /// What is seen, and the parameters.
    pub caption: Label,
}

/// The page of a chapter.
#[must_use]
pub fn page(number: u32, title: &str, entries: &[Entry]) -> String {
    let mut page = format!("## Chapter {number}: {title}\n");
    for entry in entries {
        let Entry {
            number,
            title,
            caption,
        } = entry;
        let alt = format!("{}. {}", title.plain(), caption.plain()).replace(['[', ']'], "");
        // Writing to a string cannot fail.
        let _ = write!(
            page,
            "\n### Figure {number}: {}\n\n{}\n\n![{alt}](figures/figure-{number}.svg)\n\n[data](figures/figure-{number}.csv)\n",
            markdown(title),
            markdown(caption),
        );
    }
    page
}

/// A label as Markdown.
#[must_use]
pub fn markdown(label: &Label) -> String {
    let mut text = String::new();
    for span in label.spans() {
        let plain = span.text.replace('*', "\\*").replace('_', "\\_");
        let cut = match span.face {
            Face::Regular => plain,
            Face::Italic => format!("<i>{plain}</i>"),
            Face::Bold => format!("<b>{plain}</b>"),
        };
        text.push_str(&match span.level {
            Level::Base => cut,
            Level::Sub => format!("<sub>{cut}</sub>"),
            Level::Sup => format!("<sup>{cut}</sup>"),
        });
    }
    text
}

#[cfg(test)]
mod tests {
    use super::markdown;

    #[test]
    fn labels_become_markdown() {
        let label = "*β*_lim^* = 2".into();
        let expected = "<i>β</i><sub>lim</sub><sup>\\*</sup> = 2";
        assert_eq!(markdown(&label), expected);
    }
}

//! Pages of the gallery, which show the figures of each chapter with their captions.

use frictiongen_plot::{Face, Label, Level};
use std::fmt::Write as _;

/// A figure in the gallery, with its number, title and caption.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Number of the figure.
    pub number: String,
    /// Title of the figure.
    pub title: Label,
    /// Caption of the figure, with its parameters.
    pub caption: Label,
}

/// Writes the page of a chapter: a list of the figures, then each figure. The captions are part of the pictures. The
/// page repeats them as text for readers who do not see the pictures.
#[must_use]
pub fn page(number: u32, title: &str, entries: &[Entry]) -> String {
    let mut page = format!(
        "# Chapter {number}: {title}\n\n[Gallery](../GALLERY.md)\n\n`scripts/chapters` also writes the numbers of each figure, as CSV next to the picture.\n\n"
    );
    // Writing to a string cannot fail.
    for Entry { number, title, .. } in entries {
        let anchor = number.replace('.', "");
        let title = markdown(title);
        let _ = writeln!(page, "- [{number}](#figure-{anchor}): {title}");
    }
    for entry in entries {
        let number = &entry.number;
        let alt = format!("{}. {}", entry.title.plain(), entry.caption.plain());
        let alt = escaped(&alt);
        let _ = write!(
            page,
            "\n## Figure {number}\n\n\
             <img src=\"figure-{number}.svg\" alt=\"{alt}\">\n"
        );
    }
    page
}

/// Escapes a text for an HTML attribute.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('"', "&quot;")
}

/// Converts a label of a figure to Markdown text.
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
    use super::{Entry, markdown, page};

    #[test]
    fn a_page_names_every_figure_twice() {
        let entry = Entry {
            number: "2.4".to_owned(),
            title: "*X̄* [mm]".into(),
            caption: "*β* < \"1\"".into(),
        };
        let page = page(2, "Walls", &[entry]);
        assert!(page.contains("- [2.4](#figure-24): <i>X̄</i> [mm]\n"));
        let image = "<img src=\"figure-2.4.svg\" alt=\"X̄ [mm]. β &lt; &quot;1&quot;\">\n";
        assert!(page.ends_with(image), "{page}");
    }

    #[test]
    fn labels_become_markdown() {
        let label = "*β*_lim^* = 2".into();
        let expected = "<i>β</i><sub>lim</sub><sup>\\*</sup> = 2";
        assert_eq!(markdown(&label), expected);
    }
}

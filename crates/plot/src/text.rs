//! Writes texts as SVG elements. SVG has no elements for subscripts, superscripts and bars. The module shifts the
//! letters of a subscript or superscript, and draws a bar as an extra character.

use crate::face::Face;
use crate::geometry::Point;
use crate::label::{Label, Span};
use crate::layer::Anchor;
use crate::metrics::advance;
use crate::palette::{INK, PAPER, Rgb};
use crate::svg::Canvas;
use crate::xml::{escaped, number};
use std::fmt::Write as _;

/// Size, colour, alignment and direction of a text in a figure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TextStyle {
    pub size: f64,
    pub anchor: Anchor,
    pub colour: Rgb,
    /// True if the text reads from bottom to top.
    pub upright: bool,
    /// True if a light edge keeps the text legible over lines.
    pub halo: bool,
}

impl TextStyle {
    pub(crate) const fn new(size: f64, anchor: Anchor) -> Self {
        Self {
            size,
            anchor,
            colour: INK,
            upright: false,
            halo: false,
        }
    }

    pub(crate) const fn coloured(mut self, colour: Rgb) -> Self {
        self.colour = colour;
        self
    }
}

/// Size of the dash that serves as a bar over a letter, relative to the letter. The code draws the bar as an en dash,
/// because few browser fonts place a combining macron well. In every font the en dash is half an em long, at a fourth
/// of an em above the base line.
const BAR: f64 = 0.8;
/// Width of the en dash that serves as a bar over a letter, as a multiple of the letter size.
const DASH: f64 = 0.5 * BAR;

/// A piece of text with its style. Its position is relative to the end of the previous piece.
struct TextPiece<'a> {
    text: &'a str,
    face: Face,
    size: f64,
    /// Offset of the piece to the right, in pixels, from the end of the previous piece.
    shift: f64,
    /// Offset of the piece below the base line, in pixels.
    drop: f64,
}

/// Splits a label of the text size `size`, in pixels, into pieces of text. A bar over a letter is a separate piece.
fn pieces(label: &Label, size: f64) -> Vec<TextPiece<'_>> {
    let mut pieces = Vec::new();
    for Span { text, face, level } in label.spans() {
        let (size, drop) = (level.size() * size, level.drop() * size);
        let mut shift = 0.0;
        let mut rest = text.as_str();
        while let Some((before, after)) = rest.split_once('\u{304}') {
            pieces.push(TextPiece {
                text: before,
                face: *face,
                size,
                shift,
                drop,
            });
            let (back, forth, rise) = bar(before.chars().next_back().unwrap_or(' '), *face);
            pieces.push(TextPiece {
                text: "–",
                face: Face::Regular,
                size: BAR * size,
                shift: back * size,
                drop: drop - rise * size,
            });
            (shift, rest) = (forth * size, after);
        }
        pieces.push(TextPiece {
            text: rest,
            face: *face,
            size,
            shift,
            drop,
        });
    }
    // If a label piece ends with a bar, the next piece takes over the offset that follows the bar.
    let mut carried = 0.0;
    for piece in &mut pieces {
        piece.shift += carried;
        carried = if piece.text.is_empty() {
            piece.shift
        } else {
            0.0
        };
    }
    pieces.retain(|piece| !piece.text.is_empty());
    pieces
}

/// Returns three offsets for the bar over a letter, in ems: back to the letter, forward after the bar, and upwards.
fn bar(letter: char, face: Face) -> (f64, f64, f64) {
    let tall = letter.is_uppercase() || "bdfhklt".contains(letter);
    // The top of an italic letter is to the right of the letter's middle.
    let slant = match (face, tall) {
        (Face::Italic, true) => 0.1,
        (Face::Italic, false) => 0.04,
        _ => 0.0,
    };
    let middle = 0.5e-3 * f64::from(advance(face, letter)) - slant;
    let rise = if tall { 0.58 } else { 0.4 };
    (-middle - 0.5 * DASH, middle - 0.5 * DASH, rise)
}

impl Canvas {
    /// Draws a label as a line of text at a position.
    pub(crate) fn text(&mut self, label: &Label, (x, y): Point, style: TextStyle) {
        if label.is_empty() || !x.is_finite() || !y.is_finite() {
            return;
        }
        let anchor = match style.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let (x, y) = (number(x), number(y));
        let place = if style.upright {
            format!("transform=\"translate({x} {y}) rotate(-90)\"")
        } else {
            format!("x=\"{x}\" y=\"{y}\"")
        };
        let halo = if style.halo {
            format!(
                " stroke=\"{PAPER}\" stroke-width=\"3\" stroke-opacity=\"0.8\" paint-order=\"stroke\""
            )
        } else {
            String::new()
        };
        // The document already sets this colour for all texts, so the text element does not repeat it.
        let fill = if style.colour == INK {
            String::new()
        } else {
            format!(" fill=\"{}\"", style.colour)
        };
        // A write to a string cannot fail.
        let _ = write!(
            self.body,
            "<text {place} font-size=\"{}\"{fill}{anchor}{halo}>",
            number(style.size)
        );
        let mut drop = 0.0;
        for piece in pieces(label, style.size) {
            let mut attributes = String::new();
            let mut attribute = |name: &str, value: f64| {
                let _ = write!(attributes, " {name}=\"{}\"", number(value));
            };
            if piece.size != style.size {
                attribute("font-size", piece.size);
            }
            if piece.shift != 0.0 {
                attribute("dx", piece.shift);
            }
            if piece.drop != drop {
                attribute("dy", piece.drop - drop);
                drop = piece.drop;
            }
            attributes.push_str(match piece.face {
                Face::Regular => "",
                Face::Italic => " font-style=\"italic\"",
                Face::Bold => " font-weight=\"bold\"",
            });
            let text = escaped(piece.text);
            let _ = if attributes.is_empty() {
                write!(self.body, "{text}")
            } else {
                write!(self.body, "<tspan{attributes}>{text}</tspan>")
            };
        }
        self.body.push_str("</text>\n");
    }
}

#[cfg(test)]
mod tests {
    use super::{TextStyle, pieces};
    use crate::label::Label;
    use crate::layer::Anchor;
    use crate::svg::Canvas;

    #[test]
    fn text_has_real_subscripts_and_is_escaped() {
        let mut canvas = Canvas::default();
        canvas.text(
            &Label::new("*β*_lim < 1"),
            (1.0, 2.0),
            TextStyle::new(10.0, Anchor::Middle),
        );
        assert_eq!(
            canvas.body,
            "<text x=\"1\" y=\"2\" font-size=\"10\" text-anchor=\"middle\">\
             <tspan font-style=\"italic\">β</tspan><tspan font-size=\"7.4\" dy=\"2.2\">lim</tspan>\
             <tspan dy=\"-2.2\"> &lt; 1</tspan></text>\n"
        );
    }

    #[test]
    fn a_bar_stands_over_its_letter_and_moves_nothing_else() {
        let label = Label::new("*X̄*_1 and *x̄*");
        let found = pieces(&label, 10.0);
        let texts: Vec<&str> = found.iter().map(|piece| piece.text).collect();
        assert_eq!(texts, ["X", "–", "1", " and ", "x", "–"]);
        // The two offsets (back to the letter, and forward after the bar) cancel the width of the dash, which is 4
        // pixels here.
        assert!((found[1].shift + found[2].shift + 4.0).abs() < 1e-9);
        assert!(found[1].shift < 0.0 && found[1].drop < found[5].drop && found[5].drop < 0.0);
        assert_eq!((found[3].shift, found[3].drop), (0.0, 0.0));
    }
}

//! The writer of SVG: a few elements, numbers of two decimals, text as text.

use crate::geometry::{Point, Rect};
use crate::label::{Face, Label, Level};
use crate::layer::{Anchor, Marker, Stroke};
use crate::palette::{INK, PAPER, Rgb};
use std::fmt::Write as _;

/// Families that look alike and are about as wide; PNG has the first one embedded, under another name.
const FAMILY: &str =
    "'STIX Two Text','Times New Roman',Times,'Liberation Serif','Noto Serif',serif";

/// How text is set.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    pub size: f64,
    pub anchor: Anchor,
    pub colour: Rgb,
    /// Read from the bottom to the top.
    pub upright: bool,
    /// With a light edge that keeps it legible over lines.
    pub halo: bool,
}

impl Style {
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

/// An SVG in the making.
#[derive(Debug, Default)]
pub(crate) struct Canvas {
    body: String,
}

impl Canvas {
    /// The whole document.
    pub(crate) fn document(self, (width, height): Point, title: &str, description: &str) -> String {
        let (width, height) = (number(width.ceil()), number(height.ceil()));
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FAMILY}\">\n"
        );
        for (name, content) in [("title", title), ("desc", description)] {
            if !content.is_empty() {
                // Writing to a string cannot fail, here and below.
                let _ = writeln!(text, "<{name}>{}</{name}>", escaped(content));
            }
        }
        let _ = writeln!(
            text,
            "<rect width=\"{width}\" height=\"{height}\" fill=\"{PAPER}\"/>"
        );
        text.push_str(&self.body);
        text.push_str("</svg>\n");
        text
    }

    /// Lines of one look.
    pub(crate) fn lines(&mut self, lines: &[Vec<Point>], colour: Rgb, stroke: Stroke) {
        let (width, dashes) = look(stroke);
        self.path(lines, colour, width, dashes);
    }

    /// Lines of any width.
    pub(crate) fn path(&mut self, lines: &[Vec<Point>], colour: Rgb, width: f64, dashes: &str) {
        let data = data(lines, "");
        if data.is_empty() {
            return;
        }
        let dashes = if dashes.is_empty() {
            String::new()
        } else {
            format!(" stroke-dasharray=\"{dashes}\"")
        };
        let _ = writeln!(
            self.body,
            "<path d=\"{data}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dashes}/>",
            number(width)
        );
    }

    /// Areas; where two overlap there is a hole.
    pub(crate) fn areas(&mut self, outlines: &[Vec<Point>], fill: Rgb) {
        let data = data(outlines, "Z");
        if !data.is_empty() {
            let _ = writeln!(
                self.body,
                "<path d=\"{data}\" fill=\"{fill}\" fill-rule=\"evenodd\"/>"
            );
        }
    }

    /// Rectangles of one colour, which meet without a seam.
    pub(crate) fn cells(&mut self, cells: &[Rect], fill: Rgb) {
        let mut data = String::new();
        for cell in cells {
            let (x, y) = (number(cell.left), number(cell.top));
            let (right, bottom) = (number(cell.right()), number(cell.bottom()));
            let _ = write!(data, "M{x} {y}H{right}V{bottom}H{x}Z");
        }
        if !data.is_empty() {
            let _ = writeln!(
                self.body,
                "<path d=\"{data}\" fill=\"{fill}\" shape-rendering=\"crispEdges\"/>"
            );
        }
    }

    /// A rectangle; `fill` and `edge` are left out where there is none.
    pub(crate) fn rect(&mut self, rect: Rect, fill: Option<Rgb>, edge: Option<(Rgb, f64)>) {
        let Rect {
            left,
            top,
            width,
            height,
        } = rect;
        let fill = fill.map_or_else(|| "none".to_owned(), |fill| fill.to_string());
        let edge = edge.map_or_else(String::new, |(colour, width)| {
            format!(" stroke=\"{colour}\" stroke-width=\"{}\"", number(width))
        });
        let [left, top, width, height] = [left, top, width, height].map(number);
        let _ = writeln!(
            self.body,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"{edge}/>"
        );
    }

    /// Markers of one look.
    pub(crate) fn markers(&mut self, points: &[Point], colour: Rgb, marker: Marker) {
        let mut data = String::new();
        for (x, y) in points {
            if !x.is_finite() || !y.is_finite() {
                continue;
            }
            let _ = match marker {
                Marker::Circle => write!(
                    data,
                    "M{} {}a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0Z",
                    number(x - 3.2),
                    number(*y)
                ),
                Marker::Dot => write!(
                    data,
                    "M{} {}a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0 -4.8 0Z",
                    number(x - 2.4),
                    number(*y)
                ),
                Marker::Square => write!(
                    data,
                    "M{} {}h5.6v5.6h-5.6Z",
                    number(x - 2.8),
                    number(y - 2.8)
                ),
                Marker::Triangle => {
                    write!(data, "M{} {}l3.6 6.2h-7.2Z", number(*x), number(y - 4.0))
                }
                Marker::Cross => write!(
                    data,
                    "M{} {}l5.6 5.6m0 -5.6l-5.6 5.6",
                    number(x - 2.8),
                    number(y - 2.8)
                ),
            };
        }
        if data.is_empty() {
            return;
        }
        let look = match marker {
            Marker::Dot => format!("fill=\"{colour}\""),
            Marker::Cross => format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.2\""),
            Marker::Circle | Marker::Square | Marker::Triangle => {
                format!("fill=\"{PAPER}\" stroke=\"{colour}\" stroke-width=\"1.2\"")
            }
        };
        let _ = writeln!(self.body, "<path d=\"{data}\" {look}/>");
    }

    /// A line of text.
    pub(crate) fn text(&mut self, label: &Label, (x, y): Point, style: Style) {
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
                " stroke=\"{PAPER}\" stroke-width=\"3\" stroke-opacity=\"0.8\" stroke-linejoin=\"round\" paint-order=\"stroke\""
            )
        } else {
            String::new()
        };
        let _ = write!(
            self.body,
            "<text {place} font-size=\"{}\" fill=\"{}\"{anchor}{halo}>",
            number(style.size),
            style.colour
        );
        let mut drop = 0.0;
        for span in label.spans() {
            let text = escaped(&span.text);
            let wanted = span.level.drop() * style.size;
            let mut attributes = String::new();
            if span.level != Level::Base {
                let _ = write!(
                    attributes,
                    " font-size=\"{}\"",
                    number(span.level.size() * style.size)
                );
            }
            if wanted != drop {
                let _ = write!(attributes, " dy=\"{}\"", number(wanted - drop));
                drop = wanted;
            }
            attributes.push_str(match span.face {
                Face::Regular => "",
                Face::Italic => " font-style=\"italic\"",
                Face::Bold => " font-weight=\"bold\"",
            });
            let _ = if attributes.is_empty() {
                write!(self.body, "{text}")
            } else {
                write!(self.body, "<tspan{attributes}>{text}</tspan>")
            };
        }
        self.body.push_str("</text>\n");
    }
}

/// The width and the dashes of a stroke.
fn look(stroke: Stroke) -> (f64, &'static str) {
    match stroke {
        Stroke::Solid => (1.6, ""),
        Stroke::DashDot => (1.6, "8 3 1.8 3"),
        Stroke::Dotted => (1.8, "1.8 2.8"),
        Stroke::Dashed => (1.4, "5.5 3.2"),
        Stroke::Thin => (0.9, ""),
    }
}

/// The data of a path.
fn data(lines: &[Vec<Point>], end: &str) -> String {
    let mut data = String::new();
    for line in lines.iter().filter(|line| 1 < line.len()) {
        let mut last = None;
        for (x, y) in line.iter().filter(|(x, y)| x.is_finite() && y.is_finite()) {
            let (x, y) = (number(*x), number(*y));
            if last.as_ref() == Some(&(x.clone(), y.clone())) {
                continue;
            }
            // Pairs after the first are lines.
            let _ = write!(data, "{}{x} {y}", if last.is_none() { "M" } else { " " });
            last = Some((x, y));
        }
        data.push_str(end);
    }
    data
}

/// A finite number with two decimals, none of them needless.
pub(crate) fn number(value: f64) -> String {
    let value = if value.is_finite() { value } else { 0.0 };
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// Text that XML takes for text; control characters, which it forbids, become spaces.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            _ if character.is_control() || matches!(character, '\u{fffe}' | '\u{ffff}') => {
                safe.push(' ')
            }
            _ => safe.push(character),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::{Canvas, Style, number};
    use crate::label::Label;
    use crate::layer::Anchor;
    use crate::palette::INK;

    #[test]
    fn numbers_are_short_and_finite() {
        let said = [1.0, -0.001, 0.125, 1e7, 10.5, f64::NAN, f64::INFINITY].map(number);
        assert_eq!(said, ["1", "0", "0.12", "10000000", "10.5", "0", "0"]);
    }

    #[test]
    fn text_has_real_subscripts_and_is_escaped() {
        let mut canvas = Canvas::default();
        canvas.text(
            &Label::new("*β*_lim < 1"),
            (1.0, 2.0),
            Style::new(10.0, Anchor::Middle),
        );
        assert_eq!(
            canvas.body,
            "<text x=\"1\" y=\"2\" font-size=\"10\" fill=\"#222222\" text-anchor=\"middle\">\
             <tspan font-style=\"italic\">β</tspan><tspan font-size=\"7.4\" dy=\"2.2\">lim</tspan>\
             <tspan dy=\"-2.2\"> &lt; 1</tspan></text>\n"
        );
    }

    #[test]
    fn what_is_not_finite_is_left_out() {
        let mut canvas = Canvas::default();
        canvas.path(
            &[vec![(0.0, 0.0), (f64::NAN, 1.0), (2.0, 2.001), (2.0, 2.0)]],
            INK,
            1.0,
            "",
        );
        assert!(canvas.body.contains("d=\"M0 0 2 2\""), "{}", canvas.body);
        canvas.text(
            &Label::new("x"),
            (f64::NAN, 1.0),
            Style::new(10.0, Anchor::Start),
        );
        assert!(!canvas.body.contains("NaN") && !canvas.body.contains("text"));
    }
}

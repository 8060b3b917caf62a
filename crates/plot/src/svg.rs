//! Writes SVG documents. The documents contain few types of elements, numbers with two decimals, and texts as text
//! elements instead of outlines.

use crate::geometry::{Point, Rect};
use crate::palette::{INK, PAPER, Rgb};
use crate::stroke::{Marker, Stroke};
use crate::xml::{data, escaped, number};
use std::fmt::Write as _;

/// Font families of similar shapes and widths. For a PNG picture, the renderer replaces the first family by the
/// embedded font.
const FAMILY: &str =
    "'STIX Two Text','Times New Roman',Times,'Liberation Serif','Noto Serif',serif";

/// SVG attribute that gives rectangles and markers sharp corners. All other line corners in the document are round.
const SHARP: &str = " stroke-linejoin=\"miter\"";

/// A grid of cells on the page.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CellGrid {
    /// Position on the page of the corner at which the first cell of the first row begins.
    pub(crate) origin: Point,
    /// Width and height of a cell. The height is negative if the rows ascend on the page.
    pub(crate) cell: Point,
}

impl CellGrid {
    /// A grid whose cells are single pixels, so that coordinates are in pixels.
    pub(crate) const PIXELS: Self = Self {
        origin: (0.0, 0.0),
        cell: (1.0, 1.0),
    };
}

/// An SVG document under construction.
#[derive(Debug, Default)]
pub(crate) struct Canvas {
    pub(crate) body: String,
}

impl Canvas {
    /// Returns the complete SVG document of the given size in pixels, with a title and a description in words.
    pub(crate) fn document(self, (width, height): Point, title: &str, description: &str) -> String {
        let (width, height) = (number(width.ceil()), number(height.ceil()));
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" xml:space=\"preserve\" font-family=\"{FAMILY}\" \
             fill=\"{INK}\" stroke-linejoin=\"round\">\n"
        );
        for (name, content) in [("title", title), ("desc", description)] {
            if !content.is_empty() {
                // A write to a string cannot fail, so the code ignores the result.
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

    /// Draws lines of one colour and one stroke.
    pub(crate) fn lines(&mut self, lines: &[Vec<Point>], colour: Rgb, stroke: Stroke) {
        let (width, dashes) = stroke.look();
        self.path(lines, colour, width, dashes);
    }

    /// Draws lines of one colour, with a width in pixels and a dash pattern in the notation of SVG.
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
            "<path d=\"{data}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\"{dashes}/>",
            number(width)
        );
    }

    /// Draws areas of one colour. The overlap of two outlines is a hole.
    pub(crate) fn areas(&mut self, outlines: &[Vec<Point>], fill: Rgb) {
        let data = data(outlines, "Z");
        if !data.is_empty() {
            let _ = writeln!(
                self.body,
                "<path d=\"{data}\" fill=\"{fill}\" fill-rule=\"evenodd\"/>"
            );
        }
    }

    /// Draws rectangles of one colour, which meet without a seam. The coordinates count cells of the grid. Most
    /// coordinates are therefore small integers, which make the file two thirds shorter.
    pub(crate) fn cells(&mut self, cells: &[Rect], grid: CellGrid, fill: Rgb) {
        let mut data = String::new();
        let mut pen = (0.0, 0.0);
        for cell in cells {
            let Rect {
                left,
                top,
                width,
                height,
            } = *cell;
            let step = (number(left - pen.0), number(top - pen.1));
            let (wide, high) = (number(width), number(height));
            let _ = write!(data, "m{} {}h{wide}v{high}h-{wide}z", step.0, step.1);
            pen = (left, top);
        }
        if !data.is_empty() {
            let CellGrid { origin, cell } = grid;
            let _ = writeln!(
                self.body,
                "<path d=\"{data}\" transform=\"matrix({:.4} 0 0 {:.4} {:.2} {:.2})\" fill=\"{fill}\" shape-rendering=\"crispEdges\"/>",
                cell.0, cell.1, origin.0, origin.1
            );
        }
    }

    /// Draws a rectangle. `fill` is its colour, and `edge` the colour and width of its edge. `None` leaves out the
    /// fill or the edge.
    pub(crate) fn rect(&mut self, rect: Rect, fill: Option<Rgb>, edge: Option<(Rgb, f64)>) {
        let Rect {
            left,
            top,
            width,
            height,
        } = rect;
        let fill = fill.map_or_else(|| "none".to_owned(), |fill| fill.to_string());
        let edge = edge.map_or_else(String::new, |(colour, width)| {
            format!(
                " stroke=\"{colour}\" stroke-width=\"{}\"{SHARP}",
                number(width)
            )
        });
        let [left, top, width, height] = [left, top, width, height].map(number);
        let _ = writeln!(
            self.body,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"{edge}/>"
        );
    }

    /// Draws markers of one shape and colour.
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
            Marker::Cross => {
                format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.2\"{SHARP}")
            }
            Marker::Circle | Marker::Square | Marker::Triangle => {
                format!("fill=\"{PAPER}\" stroke=\"{colour}\" stroke-width=\"1.2\"{SHARP}")
            }
        };
        let _ = writeln!(self.body, "<path d=\"{data}\" {look}/>");
    }
}

#[cfg(test)]
mod tests {
    use super::Canvas;
    use crate::label::Label;
    use crate::layer::Anchor;
    use crate::palette::INK;
    use crate::text::TextStyle;

    #[test]
    fn what_is_not_finite_is_left_out() {
        let mut canvas = Canvas::default();
        canvas.path(
            &[vec![(0.0, 0.0), (f64::NAN, 1.0), (2.0, 2.001), (2.0, 2.0)]],
            INK,
            1.0,
            "",
        );
        assert!(canvas.body.contains("d=\"M0 0l2 2\""), "{}", canvas.body);
        canvas.text(
            &Label::new("x"),
            (f64::NAN, 1.0),
            TextStyle::new(10.0, Anchor::Start),
        );
        assert!(!canvas.body.contains("NaN") && !canvas.body.contains("text"));
    }
}

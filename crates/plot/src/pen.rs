//! Draws the strokes of a sketch: lines, springs, hatching, arrows.

use crate::geometry::{Point, Rect};
use crate::label::Label;
use crate::layer::Anchor;
use crate::palette::{INK, Rgb, SOFT};
use crate::svg::Canvas;
use crate::text::TextStyle;

/// Text size in a sketch, in pixels.
pub(crate) const TEXT: f64 = 14.0;

/// A pen that draws the elements of a sketch, with coordinates relative to the sketch's corner.
#[derive(Debug)]
pub(crate) struct Pen<'c> {
    canvas: &'c mut Canvas,
    left: f64,
    top: f64,
}

impl<'c> Pen<'c> {
    pub(crate) fn new(canvas: &'c mut Canvas, (left, top): Point) -> Self {
        Self { canvas, left, top }
    }

    pub(crate) fn line(&mut self, points: &[Point], colour: Rgb, width: f64) {
        let moved = points
            .iter()
            .map(|(x, y)| (x + self.left, y + self.top))
            .collect();
        self.canvas.path(&[moved], colour, width, "");
    }

    pub(crate) fn rect(
        &mut self,
        (left, top, width, height): (f64, f64, f64, f64),
        fill: Rgb,
        edge: Option<Rgb>,
    ) {
        let rect = Rect {
            left: left + self.left,
            top: top + self.top,
            width,
            height,
        };
        self.canvas
            .rect(rect, Some(fill), edge.map(|edge| (edge, 1.2)));
    }

    pub(crate) fn text(&mut self, label: &Label, (x, y): Point, anchor: Anchor, colour: Rgb) {
        let style = TextStyle::new(TEXT, anchor).coloured(colour);
        self.canvas
            .text(label, (x + self.left, y + self.top), style);
    }

    /// Draws a horizontal spring of a sketch between two positions: a zigzag with straight ends.
    pub(crate) fn spring(&mut self, from: f64, to: f64, y: f64) {
        let turns = 8;
        let lead = f64::min(9.0, 0.15 * (to - from));
        let step = (to - from - 2.0 * lead) / f64::from(turns);
        let mut points = vec![(from, y), (from + lead, y)];
        for turn in 0..turns {
            let side = if turn % 2 == 0 { -5.5 } else { 5.5 };
            points.push((from + lead + step * (f64::from(turn) + 0.5), y + side));
        }
        points.extend([(to - lead, y), (to, y)]);
        self.line(&points, INK, 1.2);
    }

    /// Draws a horizontal dashpot of a sketch between two positions: a piston in a cylinder that is open to the
    /// right.
    pub(crate) fn dashpot(&mut self, from: f64, to: f64, y: f64) {
        let middle = 0.5 * (from + to);
        let (left, right) = (middle - 9.0, middle + 8.0);
        self.line(&[(from, y), (left, y)], INK, 1.2);
        let cylinder = [
            (right, y - 7.0),
            (left, y - 7.0),
            (left, y + 7.0),
            (right, y + 7.0),
        ];
        self.line(&cylinder, INK, 1.2);
        self.line(&[(middle, y - 5.0), (middle, y + 5.0)], INK, 2.4);
        self.line(&[(middle, y), (to, y)], INK, 1.2);
    }

    /// Draws a friction contact: a pad between two plates that are open to the left.
    pub(crate) fn slider(&mut self, from: f64, to: f64, y: f64, colour: Rgb) {
        let middle = 0.5 * (from + to);
        let (left, right) = (middle - 8.0, middle + 8.0);
        self.line(&[(from, y), (left, y)], INK, 1.2);
        self.rect((left, y - 5.0, 11.0, 10.0), colour, None);
        let plates = [
            (left - 2.0, y - 6.0),
            (right, y - 6.0),
            (right, y + 6.0),
            (left - 2.0, y + 6.0),
        ];
        self.line(&plates, INK, 1.2);
        self.line(&[(right, y), (to, y)], INK, 1.2);
    }

    /// Draws a stop with a gap between two positions: a rod with a plate in front of a hatched face.
    pub(crate) fn stop(&mut self, from: f64, to: f64, y: f64) {
        let middle = 0.5 * (from + to);
        let (plate, face) = (middle - 5.0, middle + 4.0);
        self.line(&[(from, y), (plate, y)], INK, 1.2);
        self.line(&[(plate, y - 6.0), (plate, y + 6.0)], INK, 2.4);
        self.hatched((face, y - 8.0), (face, y + 8.0), (1.0, 0.0));
        self.line(&[(face, y), (to, y)], INK, 1.2);
    }

    /// Draws a stop with a gap that acts under a pull: the plate of a rod behind the face of a bracket.
    pub(crate) fn pulling_stop(&mut self, from: f64, to: f64, y: f64) {
        let middle = 0.5 * (from + to);
        let (face, plate, back) = (middle - 5.0, middle + 4.0, middle + 11.0);
        self.line(&[(from, y), (plate, y)], INK, 1.2);
        self.line(&[(plate, y - 5.0), (plate, y + 5.0)], INK, 2.4);
        for side in [-1.0, 1.0] {
            let outer = y + 8.0 * side;
            let bracket = [
                (face, y + 2.5 * side),
                (face, outer),
                (back, outer),
                (back, y),
            ];
            self.line(&bracket, INK, 1.2);
        }
        self.line(&[(back, y), (to, y)], INK, 1.2);
    }

    /// Draws a line with short oblique strokes on one side, as for a wall. `side` is the direction towards the
    /// strokes.
    pub(crate) fn hatched(&mut self, from: Point, to: Point, side: Point) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = dx.abs().max(dy.abs());
        let count = (length / 6.0).floor().max(1.0);
        for index in 0..count as usize {
            let share = (index as f64 + 1.0) / count;
            let at = (from.0 + share * dx, from.1 + share * dy);
            let back = 5.0 / length;
            let end = (
                at.0 - back * dx + 6.0 * side.0,
                at.1 - back * dy + 6.0 * side.1,
            );
            self.line(&[at, end], SOFT, 0.8);
        }
        self.line(&[from, to], INK, 1.6);
    }

    pub(crate) fn arrow(&mut self, from: Point, to: Point, colour: Rgb) {
        let sign = if from.0 < to.0 { 1.0 } else { -1.0 };
        self.line(&[from, (to.0 - 5.0 * sign, to.1)], colour, 1.6);
        let (x, y) = (to.0 + self.left, to.1 + self.top);
        let head = vec![(x, y), (x - 8.0 * sign, y - 3.6), (x - 8.0 * sign, y + 3.6)];
        self.canvas.areas(&[head], colour);
    }
}

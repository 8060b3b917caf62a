//! Draws the elements of a sketch.

use crate::geometry::Point;
use crate::label::Label;
use crate::layer::Anchor;
use crate::palette::{INK, Rgb};
use crate::pen::{Pen, TEXT};
use crate::plan::{Above, Element, HATCH, HEIGHT, PAD, Plan, WIDTH};
use crate::sketch::{End, Excitation, Sketch, SketchContact, SliderType};
use crate::svg::Canvas;

/// Horizontal distance in a sketch between the middle of a mass and the vertical end of a spring above the row, in
/// pixels.
const RISER: f64 = 11.0;
/// Colour of the masses of a sketch.
const MASS: Rgb = Rgb(0xe9, 0xee, 0xf4);
/// Colour of the friction contact in a sketch.
const FRICTION: Rgb = Rgb(0xb3, 0x3a, 0x1e);
/// Colour of the excitation in a sketch.
const FORCE: Rgb = Rgb(0x00, 0x5f, 0xad);

/// Half the length of the arrow of a moving surface, and its distance below its contact, in pixels.
const BELT: f64 = 10.0;
/// Half the length of the arrow of a constant force, in pixels.
const ARROW: f64 = 15.0;
/// Margin in pixels around a sketch that is a separate SVG document.
const MARGIN: f64 = 8.0;
/// Width in pixels that is available to a sketch in a separate SVG document.
pub(crate) const ALONE: f64 = 1000.0;

impl Sketch {
    /// Returns the sketch as a separate SVG document. Returns `None` if the sketch has no masses or too many.
    #[must_use]
    pub fn svg(&self) -> Option<String> {
        let (width, height) = self.size(ALONE)?;
        let mut canvas = Canvas::default();
        self.draw(&mut canvas, (MARGIN, MARGIN), ALONE);
        let masses: Vec<String> = self.masses.iter().map(Label::plain).collect();
        let title = format!("Sketch of a chain of masses: {}", masses.join(", "));
        Some(canvas.document((width + 2.0 * MARGIN, height + 2.0 * MARGIN), &title, ""))
    }

    /// Returns the width and the height of the sketch in pixels, within the width `room`. Returns `None` if the
    /// sketch cannot be drawn.
    pub(crate) fn size(&self, room: f64) -> Option<(f64, f64)> {
        Plan::new(self, room).map(|plan| plan.size())
    }

    /// Draws the sketch on a canvas, with its upper left corner at `corner` and within the width `room`.
    pub(crate) fn draw(&self, canvas: &mut Canvas, corner: (f64, f64), room: f64) {
        if let Some(plan) = Plan::new(self, room) {
            plan.draw(canvas, corner);
        }
    }
}

impl Plan<'_> {
    pub(crate) fn draw(&self, canvas: &mut Canvas, (left, top): Point) {
        let mut pen = Pen::new(canvas, (left, top));
        let row = self.top();
        self.ground(&mut pen, row);
        for (gap, spring) in &self.direct {
            let (from, to) = (self.sides(*gap).1, self.sides(gap + 1).0);
            let middle = row + 0.5 * HEIGHT;
            pen.spring(from, to, middle);
            pen.text(
                &spring.label,
                (0.5 * (from + to), middle + 21.0),
                Anchor::Middle,
                INK,
            );
        }
        for above in &self.above {
            self.far(&mut pen, above);
        }
        if let Some(contact) = self.contact {
            self.friction(&mut pen, contact, row);
        }
        for (index, mass) in self.sketch.masses.iter().enumerate() {
            let (left, _) = self.sides(index + 1);
            pen.rect((left, row, self.pitch.0, HEIGHT), MASS, Some(INK));
            let (x, middle) = (left + 0.5 * self.pitch.0, row + 0.5 * HEIGHT + 5.0);
            match self.sketch.values.get(index) {
                Some(value) => {
                    pen.text(mass, (x, middle - 9.0), Anchor::Middle, INK);
                    pen.text(value, (x, middle + 9.0), Anchor::Middle, INK);
                }
                None => pen.text(mass, (x, middle), Anchor::Middle, INK),
            }
        }
        self.constant_arrows(&mut pen, row);
        self.excitation(&mut pen, row);
    }

    /// Draws the base and the wall of a sketch, with hatching.
    fn ground(&self, pen: &mut Pen<'_>, row: f64) {
        let lowest = row + HEIGHT + PAD;
        let highest = |station: usize| {
            let lanes = self
                .above
                .iter()
                .filter(|above| above.low == station || above.high == station);
            lanes
                .map(|above| self.lane(above.lane) - 8.0)
                .fold(row - 4.0, f64::min)
        };
        if self.base {
            pen.hatched((HATCH, highest(0)), (HATCH, lowest), (-1.0, 0.0));
        }
        if self.wall {
            let station = self.count() + 1;
            let x = self.sides(station).0;
            pen.hatched((x, highest(station)), (x, lowest), (1.0, 0.0));
        }
    }

    fn far(&self, pen: &mut Pen<'_>, above: &Above<'_>) {
        let (low, high, lane) = (above.low, above.high, above.lane);
        let (row, y) = (self.top(), self.lane(lane));
        // Springs that end at the same mass have their vertical ends at different horizontal positions, so that they do
        // not overlap.
        let shift = (RISER - 4.0 * (lane % 4) as f64) * self.pitch.0 / WIDTH;
        let end = |station: usize, sign: f64| {
            let (left, right) = self.sides(station);
            if left == right {
                left
            } else {
                0.5 * (left + right) + sign * shift
            }
        };
        let (from, to) = (end(low, 1.0), end(high, -1.0));
        for (station, x) in [(low, from), (high, to)] {
            let (left, right) = self.sides(station);
            if left != right {
                pen.line(&[(x, row), (x, y)], INK, 1.2);
            }
        }
        // The spring's zigzag lies above a gap between two masses, because vertical spring ends rise only above masses.
        let (low, high) = (low as f64, high as f64);
        let gap = (0.5 * (low + high) - 0.5).floor().max(low) as usize;
        let middle = 0.5 * (self.sides(gap).1 + self.sides(gap + 1).0);
        let half = 0.5 * self.pitch.1;
        pen.line(&[(from, y), (middle - half, y)], INK, 1.2);
        pen.line(&[(middle + half, y), (to, y)], INK, 1.2);
        let (from, to) = (middle - half, middle + half);
        match above.element {
            Element::Spring => pen.spring(from, to, y),
            Element::Dashpot => pen.dashpot(from, to, y),
            Element::Slider(SliderType::Stop, _) => pen.stop(from, to, y),
            Element::Slider(SliderType::PullingStop, _) => pen.pulling_stop(from, to, y),
            Element::Slider(SliderType::Rigid, _) => pen.slider(from, to, y, FRICTION),
            Element::Slider(SliderType::Elastic, _) => {
                pen.spring(from, middle, y);
                pen.slider(middle, to, y, FRICTION);
            }
        }
        if let Element::Slider(_, direction @ (1 | -1)) = above.element {
            let (at, half) = (to - BELT, f64::from(direction) * BELT);
            pen.arrow((at - half, y + BELT), (at + half, y + BELT), FORCE);
        }
        let colour = match above.element {
            Element::Slider(SliderType::Rigid | SliderType::Elastic, _) => FRICTION,
            _ => INK,
        };
        pen.text(above.label, (middle, y - 11.0), Anchor::Middle, colour);
    }

    fn friction(&self, pen: &mut Pen<'_>, contact: &SketchContact, row: f64) {
        let masses: Vec<usize> = [contact.between.0, contact.between.1]
            .into_iter()
            .filter_map(|end| match end {
                End::Mass(index) => Some(index + 1),
                End::Base | End::Wall => None,
            })
            .collect();
        let bottom = row + HEIGHT;
        let (Some(first), Some(last)) = (masses.iter().min(), masses.iter().max()) else {
            return;
        };
        let (left, right) = self.sides(*first);
        let middle = 0.5 * (left + right);
        let floor = bottom + PAD;
        let pad = f64::min(26.0, 0.7 * self.pitch.0);
        pen.rect((middle - 0.5 * pad, bottom, pad, PAD), FRICTION, None);
        if first != last {
            // The sketch shows the contact of two masses as an arm. The arm of the right mass reaches under the left
            // mass.
            let (_, end) = self.sides(*last);
            let arm = end - 0.5 * self.pitch.0;
            pen.rect(
                (middle - 18.0, floor, arm - middle + 18.0, 4.0),
                MASS,
                Some(INK),
            );
            pen.rect((arm - 4.0, bottom, 4.0, PAD + 4.0), MASS, Some(INK));
        } else if [contact.between.0, contact.between.1].contains(&End::Base) {
            pen.hatched((right, floor), (HATCH, floor), (0.0, 1.0));
        } else {
            pen.hatched((right + 4.0, floor), (left - 4.0, floor), (0.0, 1.0));
        }
        pen.text(
            &contact.label,
            (middle, floor + HATCH + TEXT),
            Anchor::Middle,
            FRICTION,
        );
    }

    /// Draws the arrows of constant forces below their masses.
    fn constant_arrows(&self, pen: &mut Pen<'_>, row: f64) {
        let y = row + HEIGHT + PAD + 2.0;
        for own in self.constant() {
            let (left, right) = self.sides(own.mass + 1);
            let middle = 0.5 * (left + right);
            let half = if own.is_negative { -ARROW } else { ARROW };
            pen.arrow((middle - half, y), (middle + half, y), FORCE);
            let label = (middle, y + TEXT + 3.0);
            pen.text(&own.label, label, Anchor::Middle, FORCE);
        }
    }

    fn excitation(&self, pen: &mut Pen<'_>, row: f64) {
        if let Some((mass, label)) = self.force() {
            let x = self.sides(mass + 1).1;
            if self.is_free(mass) {
                let y = row + 0.5 * HEIGHT;
                pen.arrow((x, y), (x + 38.0, y), FORCE);
                pen.text(label, (x + 43.0, y + 5.0), Anchor::Start, FORCE);
            } else {
                let y = row + 8.0;
                pen.arrow((x, y), (x + f64::min(36.0, 0.9 * self.pitch.1), y), FORCE);
                pen.text(label, (x + 3.0, row - 4.0), Anchor::Start, FORCE);
            }
        }
        if let Excitation::Base { label } = &self.sketch.excitation {
            let y = row + HEIGHT + PAD + HATCH + 5.0;
            let middle = HATCH + 18.0;
            pen.arrow((middle, y), (middle + 18.0, y), FORCE);
            pen.arrow((middle, y), (middle - 18.0, y), FORCE);
            pen.text(label, (HATCH, y + TEXT), Anchor::Start, FORCE);
        }
    }
}

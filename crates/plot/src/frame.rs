//! The frame of a panel: axes with ticks and grid, and the space that they need.

use crate::axis::{Axis, Mapping};
use crate::figure::Panel;
use crate::geometry::Rect;
use crate::layer::{Anchor, Cells, Layer};
use crate::palette::{FRAME, Fill, GRID, INK};
use crate::svg::{Canvas, CellGrid};
use crate::text::TextStyle;
use crate::ticks::{Tick, ticks};

/// Text size of the title of a panel, in pixels.
const TITLE: f64 = 14.5;
/// Text size of the axis labels, in pixels.
const LABEL: f64 = 15.0;
/// Text size of the tick labels, in pixels.
const TICK: f64 = 13.0;
/// Text size of the tick labels of an inset, a small panel inside a panel, in pixels.
const SMALL: f64 = 12.0;
/// Distance from the frame of a panel to its tick labels, in pixels.
const OFF: f64 = 6.0;
/// Width of the colour bar of a map, in pixels.
const BAR: f64 = 13.0;

/// The frame of a panel at its position on the page.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub rect: Rect,
    pub x: Mapping,
    pub y: Mapping,
    x_ticks: Vec<Tick>,
    y_ticks: Vec<Tick>,
    /// Text sizes of the tick labels and of the axis labels, in pixels.
    sizes: (f64, f64),
    /// True if the text has a light outline, which keeps it legible over lines.
    halo: bool,
}

impl Frame {
    pub(crate) fn new(panel: &Panel, rect: Rect, inset: bool) -> Self {
        let sizes = if inset {
            (SMALL, SMALL + 1.0)
        } else {
            (TICK, LABEL)
        };
        Self {
            rect,
            x: Mapping::new(&panel.x, rect.left, rect.right()),
            y: Mapping::new(&panel.y, rect.bottom(), rect.top),
            x_ticks: level_ticks(&panel.x, rect.width, sizes.0),
            y_ticks: upright_ticks(&panel.y, rect.height, sizes.0),
            sizes,
            halo: inset,
        }
    }

    /// Returns the widths, in pixels, that tick labels, axis label and colour bar need to the left and to the right
    /// of a panel's frame.
    pub(crate) fn sides(panel: &Panel) -> (f64, f64) {
        let ticks = upright_ticks(&panel.y, panel.height.unwrap_or(260.0), TICK);
        let label = if panel.y.label.is_empty() {
            0.0
        } else {
            LABEL + 8.0
        };
        let left = widest(&ticks, TICK) + OFF + label;
        let right = bar_of(panel).map_or(10.0, |bar| {
            let label = if bar.label.is_empty() {
                0.0
            } else {
                LABEL + 8.0
            };
            12.0 + BAR
                + OFF
                + widest(
                    &upright_ticks(bar, panel.height.unwrap_or(260.0), TICK),
                    TICK,
                )
                + label
        });
        (left, right)
    }

    /// Returns the height that a panel needs above its frame, for its title, in pixels.
    pub(crate) fn above(panel: &Panel) -> f64 {
        if panel.title.is_empty() {
            10.0
        } else {
            TITLE + 14.0
        }
    }

    /// Returns the height that a panel needs below its frame, for tick labels and axis label, in pixels.
    pub(crate) fn under(panel: &Panel) -> f64 {
        let label = if panel.x.label.is_empty() {
            0.0
        } else {
            LABEL + 7.0
        };
        TICK + OFF + 4.0 + label
    }

    /// Returns the rectangle that contains the frame of a panel, its tick labels and its axis labels.
    pub(crate) fn whole(&self, panel: &Panel) -> Rect {
        let label = |axis: &Axis| {
            if axis.label.is_empty() {
                0.0
            } else {
                self.sizes.1 + 4.0
            }
        };
        let left = widest(&self.y_ticks, self.sizes.0) + OFF + 3.0 + label(&panel.y);
        let under = self.sizes.0 + OFF + 2.0 + label(&panel.x);
        let right = 0.5 * widest(&self.x_ticks, self.sizes.0) + 2.0;
        let above = if panel.title.is_empty() {
            0.5 * self.sizes.0
        } else {
            TITLE + 4.0
        };
        Rect {
            left: self.rect.left - left,
            top: self.rect.top - above,
            width: self.rect.width + left + right,
            height: self.rect.height + above + under,
        }
    }

    /// Draws the grid lines of a panel. `over_areas` is true if the panel has shaded areas or a map under the grid.
    pub(crate) fn grid(&self, canvas: &mut Canvas, over_areas: bool) {
        let Rect { left, top, .. } = self.rect;
        let (right, bottom) = (self.rect.right(), self.rect.bottom());
        let named = |ticks: &[Tick], mapping: Mapping| -> Vec<f64> {
            let labelled = ticks.iter().filter(|tick| !tick.label.is_empty());
            labelled.filter_map(|tick| mapping.at(tick.value)).collect()
        };
        let mut lines: Vec<_> = named(&self.x_ticks, self.x)
            .into_iter()
            .map(|x| vec![(x, top), (x, bottom)])
            .collect();
        lines.extend(
            named(&self.y_ticks, self.y)
                .into_iter()
                .map(|y| vec![(left, y), (right, y)]),
        );
        // Over a shaded area, the grid lines are lighter than the area. On white paper, the grid lines are darker than
        // the paper.
        let colour = if over_areas {
            crate::palette::PAPER
        } else {
            GRID
        };
        canvas.path(&lines, colour, 0.7, "");
    }

    /// Draws the lines of a panel's frame, and the ticks and labels of its axes.
    pub(crate) fn axes(&self, canvas: &mut Canvas, panel: &Panel) {
        let rect = self.rect;
        let (tick_size, label_size) = self.sizes;
        let mut marks = Vec::new();
        for tick in &self.x_ticks {
            let Some(x) = self.x.at(tick.value) else {
                continue;
            };
            let length = if tick.label.is_empty() { 2.5 } else { 4.5 };
            marks.push(vec![(x, rect.bottom()), (x, rect.bottom() - length)]);
            let place = (x, rect.bottom() + OFF + 0.78 * tick_size);
            canvas.text(
                &tick.label,
                place,
                TextStyle {
                    halo: self.halo,
                    ..TextStyle::new(tick_size, Anchor::Middle)
                },
            );
        }
        for tick in &self.y_ticks {
            let Some(y) = self.y.at(tick.value) else {
                continue;
            };
            let length = if tick.label.is_empty() { 2.5 } else { 4.5 };
            marks.push(vec![(rect.left, y), (rect.left + length, y)]);
            canvas.text(
                &tick.label,
                (rect.left - OFF, y + 0.32 * tick_size),
                TextStyle {
                    halo: self.halo,
                    ..TextStyle::new(tick_size, Anchor::End)
                },
            );
        }
        canvas.path(&marks, FRAME, 0.9, "");
        canvas.rect(rect, None, Some((FRAME, 0.9)));
        let under = rect.bottom() + OFF + tick_size + label_size + 2.0;
        let middle = (rect.left + 0.5 * rect.width, rect.top + 0.5 * rect.height);
        canvas.text(
            &panel.x.label,
            (middle.0, under),
            TextStyle::new(label_size, Anchor::Middle),
        );
        let beside = rect.left - OFF - widest(&self.y_ticks, tick_size) - 0.55 * label_size;
        let upright = TextStyle {
            upright: true,
            ..TextStyle::new(label_size, Anchor::Middle)
        };
        canvas.text(&panel.y.label, (beside, middle.1), upright);
        canvas.text(
            &panel.title,
            (rect.left, rect.top - 8.0),
            TextStyle::new(TITLE, Anchor::Start),
        );
        if let Some(bar) = bar_of(panel) {
            self.bar(canvas, bar);
        }
    }

    /// Draws the colour bar of a map to the right of the frame.
    fn bar(&self, canvas: &mut Canvas, axis: &Axis) {
        let rect = Rect {
            left: self.rect.right() + 12.0,
            width: BAR,
            ..self.rect
        };
        let steps = 64;
        for step in 0..steps {
            let share = |step: i32| f64::from(step) / f64::from(steps);
            let cell = Rect {
                top: rect.bottom() - share(step + 1) * rect.height,
                height: rect.height / f64::from(steps),
                ..rect
            };
            canvas.cells(
                &[cell],
                CellGrid::PIXELS,
                Fill::Map((f64::from(step) + 0.5) / f64::from(steps)).rgb(),
            );
        }
        canvas.rect(rect, None, Some((FRAME, 0.9)));
        let mapping = Mapping::new(axis, rect.bottom(), rect.top);
        let ticks = upright_ticks(axis, rect.height, TICK);
        let mut marks = Vec::new();
        for tick in &ticks {
            let Some(y) = mapping.at(tick.value) else {
                continue;
            };
            marks.push(vec![(rect.right(), y), (rect.right() + 3.5, y)]);
            canvas.text(
                &tick.label,
                (rect.right() + OFF, y + 0.32 * TICK),
                TextStyle::new(TICK, Anchor::Start),
            );
        }
        canvas.path(&marks, INK, 0.9, "");
        let beside = rect.right() + OFF + widest(&ticks, TICK) + LABEL + 2.0;
        let upright = TextStyle {
            upright: true,
            ..TextStyle::new(LABEL, Anchor::Middle)
        };
        canvas.text(&axis.label, (beside, rect.top + 0.5 * rect.height), upright);
    }
}

/// Returns the axis of a panel's colour bar. Returns `None` unless the panel has a map of values.
fn bar_of(panel: &Panel) -> Option<&Axis> {
    panel.layers.iter().find_map(|layer| match layer {
        Layer::Raster(raster) => match &raster.cells {
            Cells::Values { bar, .. } => Some(bar),
            Cells::Classes { .. } => None,
        },
        _ => None,
    })
}

fn widest(ticks: &[Tick], size: f64) -> f64 {
    ticks
        .iter()
        .map(|tick| tick.label.width(size))
        .fold(0.0, f64::max)
}

/// Returns the ticks of a horizontal axis that is `width` pixels wide. The space for labels of the text size `size`
/// limits the number of ticks.
fn level_ticks(axis: &Axis, width: f64, size: f64) -> Vec<Tick> {
    let most = ((width / (3.6 * size)) as usize).clamp(3, 8);
    for count in (3..=most).rev() {
        let found = ticks(axis, count);
        let named = found.iter().filter(|tick| !tick.label.is_empty()).count();
        if (widest(&found, size) + 10.0) * named as f64 <= width {
            return found;
        }
    }
    ticks(axis, 2)
}

fn upright_ticks(axis: &Axis, height: f64, size: f64) -> Vec<Tick> {
    ticks(axis, ((height / (2.7 * size)) as usize).clamp(3, 8))
}

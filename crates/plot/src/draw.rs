//! Layout of a page: title, panels in rows, sketch and legend, caption.

use crate::figure::{Figure, Page, Panel, PanelFrame};
use crate::frame::Frame;
use crate::geometry::Rect;
use crate::label::Label;
use crate::layer::Anchor;
use crate::legend::Legend;
use crate::palette::SOFT;
use crate::panel::draw_panel;
use crate::svg::Canvas;
use crate::text::TextStyle;

/// Margin around the page of a figure, in pixels.
const MARGIN: f64 = 14.0;
/// Distance between neighbouring panels of a figure, in pixels.
const GAP: f64 = 22.0;
/// Text size of the title of a figure, in pixels.
const TITLE: f64 = 16.0;
/// Text size of the caption of a figure, in pixels.
const CAPTION: f64 = 13.0;
/// Distance between the base lines of wrapped text, as a multiple of the text size.
const LEADING: f64 = 1.3;

impl Figure {
    /// Returns the figure as an SVG document. A figure gives the same bytes on every machine.
    #[must_use]
    pub fn svg(&self) -> String {
        figure(self).0
    }

    /// Returns the figure as an SVG document, with the position of each panel's frame. A web page uses the positions
    /// to show the values under the pointer.
    ///
    /// ```
    /// use frictiongen_plot::{Axis, Figure, Panel};
    /// let panel = Panel::new("", Axis::new("*r*", 0.0, 2.0), Axis::new("*X̄*", 0.0, 5.0));
    /// let (svg, frames) = Figure::new("", "", 1, vec![panel]).svg_with_frames();
    /// assert!(svg.starts_with("<svg") && frames.len() == 1);
    /// assert_eq!(frames[0].x, (0.0, 2.0));
    /// ```
    #[must_use]
    pub fn svg_with_frames(&self) -> (String, Vec<PanelFrame>) {
        let (svg, rects) = figure(self);
        let frames = self.panels.iter().zip(rects);
        let frames = frames.map(|(panel, rect)| PanelFrame {
            left: rect.left,
            top: rect.top,
            width: rect.width,
            height: rect.height,
            x: panel.x.range(),
            y: panel.y.range(),
        });
        (svg, frames.collect())
    }

    /// Returns the figure as a PNG picture, with `scale` pixels for each pixel of the SVG. A figure gives the same
    /// bytes on every machine.
    ///
    /// # Errors
    /// Fails if the scale is not positive, or if the picture would be larger than 16384 pixels.
    #[cfg(feature = "png")]
    pub fn png(&self, scale: f32) -> Result<Vec<u8>, crate::PlotError> {
        crate::png::render(&self.svg(), scale)
    }
}

/// Returns the whole figure as an SVG document, with the rectangle of each panel's frame on the page.
fn figure(figure: &Figure) -> (String, Vec<Rect>) {
    let most = if figure.page == Page::Narrow { 1 } else { 2 };
    let columns = figure
        .columns
        .clamp(1, most)
        .min(figure.panels.len().max(1));
    let width = match (figure.page, columns) {
        (Page::Narrow, _) => 400.0,
        (Page::Wide, 1) => 640.0,
        (Page::Wide, _) => 900.0,
    };
    // If a sketch is wider than the page even after shrinking, the page becomes wider.
    let room = width - 2.0 * MARGIN;
    let chain = figure.sketch.as_ref().and_then(|sketch| sketch.size(room));
    let width = f64::max(width, chain.map_or(0.0, |size| size.0 + 2.0 * MARGIN));
    let room = width - 2.0 * MARGIN;
    let mut canvas = Canvas::default();
    let heading = heading(figure);
    let mut y = MARGIN
        + text(
            &mut canvas,
            &heading,
            MARGIN,
            room,
            TextStyle::new(TITLE, Anchor::Start),
        );
    let mut legend = Legend::default();
    let frames = rows(figure, columns, room, &mut y);
    for (panel, rect) in figure.panels.iter().zip(&frames) {
        draw_panel(
            &mut canvas,
            panel,
            &Frame::new(panel, *rect, false),
            &mut legend,
        );
    }
    for key in &figure.keys {
        legend.add(&key.name, key.sample);
    }
    y = below(&mut canvas, figure, &legend, room, y);
    if !figure.caption.is_empty() {
        let style = TextStyle::new(CAPTION, Anchor::Start).coloured(SOFT);
        y += 6.0 + text(&mut canvas, &figure.caption, y + 6.0, room, style);
    }
    let document = canvas.document(
        (width, y + 0.6 * MARGIN),
        &heading.plain(),
        &description(figure, &legend),
    );
    (document, frames)
}

/// Arranges the panels of a figure in rows, and returns the rectangle of each panel's frame. `y` moves to the
/// position under the last row.
fn rows(figure: &Figure, columns: usize, room: f64, y: &mut f64) -> Vec<Rect> {
    let cell = (room - GAP * (columns - 1) as f64) / columns as f64;
    // The frames of a column of panels are aligned. Every frame therefore has the largest margins that a panel of its
    // column needs.
    let margins: Vec<(f64, f64)> = (0..columns)
        .map(|column| {
            let panels = figure.panels.iter().skip(column).step_by(columns);
            panels.map(Frame::sides).fold((0.0, 0.0), |most, sides| {
                (f64::max(most.0, sides.0), f64::max(most.1, sides.1))
            })
        })
        .collect();
    let mut frames = Vec::new();
    for row in figure.panels.chunks(columns) {
        let above = row.iter().map(Frame::above).fold(0.0, f64::max);
        let under = row.iter().map(Frame::under).fold(0.0, f64::max);
        // On a narrow page a colour bar makes only its own panel narrower.
        let narrow = figure.page == Page::Narrow;
        let own = |panel: &Panel, right: f64| if narrow { Frame::sides(panel).1 } else { right };
        let widths: Vec<f64> = row
            .iter()
            .zip(&margins)
            .map(|(panel, (left, right))| cell - left - own(panel, *right))
            .collect();
        let least = widths.iter().copied().fold(f64::INFINITY, f64::min);
        let usual = (0.7 * least).clamp(200.0, 340.0);
        let asked = row
            .iter()
            .filter_map(|panel| panel.height)
            .filter(|height| height.is_finite())
            .fold(0.0, f64::max);
        let height = if 0.0 < asked {
            asked.clamp(60.0, 4000.0)
        } else {
            usual
        };
        for (column, ((left, _), width)) in margins.iter().zip(widths).enumerate() {
            frames.push(Rect {
                left: MARGIN + column as f64 * (cell + GAP) + left,
                top: *y + above,
                width,
                height,
            });
        }
        *y += above + height + under + 10.0;
    }
    frames
}

/// Draws the sketch and the legend of a figure, side by side if `room` is wide enough. Returns the vertical position
/// under the sketch and the legend.
fn below(canvas: &mut Canvas, figure: &Figure, legend: &Legend, room: f64, top: f64) -> f64 {
    let sketch = figure.sketch.as_ref();
    let size = sketch.and_then(|sketch| Some((sketch, sketch.size(room)?)));
    let Some((sketch, (wide, high))) = size else {
        let height = legend.draw(Some(canvas), (MARGIN, top), room);
        return top + height;
    };
    let beside = room - wide - 36.0;
    if legend.is_empty() || beside < legend.least() {
        sketch.draw(canvas, (MARGIN + 0.5 * (room - wide).max(0.0), top), room);
        let under = top + high + 8.0;
        return under + legend.draw(Some(canvas), (MARGIN, under), room);
    }
    let tall = legend.draw(None, (0.0, 0.0), beside);
    let both = high.max(tall);
    sketch.draw(canvas, (MARGIN, top + 0.5 * (both - high)), room);
    legend.draw(
        Some(canvas),
        (MARGIN + wide + 36.0, top + 0.5 * (both - tall)),
        beside,
    );
    top + both
}

fn heading(figure: &Figure) -> Label {
    if figure.number.is_empty() {
        figure.title.clone()
    } else {
        let number = figure.number.replace(['\\', '*', '_', '^'], " ");
        Label::new(&format!("**Figure {number}.** ")).then(&figure.title)
    }
}

/// Draws a label in lines that fit into the width `room`. Returns the height of the lines.
fn text(canvas: &mut Canvas, label: &Label, top: f64, room: f64, style: TextStyle) -> f64 {
    let lines = label.wrapped(style.size, room / 1.03);
    for (index, line) in lines.iter().enumerate() {
        let baseline = top + style.size + LEADING * style.size * index as f64;
        canvas.text(line, (MARGIN, baseline), style);
    }
    LEADING * style.size * lines.len() as f64
}

/// Returns a description of the figure in words, for readers who cannot see the figure.
fn description(figure: &Figure, legend: &Legend) -> String {
    let mut sentences: Vec<String> = figure
        .panels
        .iter()
        .map(|panel| {
            let (x, y) = (panel.x.label.plain(), panel.y.label.plain());
            let over = format!("{y} over {x}.");
            if panel.title.is_empty() {
                over
            } else {
                format!("{}: {over}", panel.title.plain())
            }
        })
        .collect();
    if !legend.is_empty() {
        sentences.push(format!("Drawn are: {}.", legend.names().join("; ")));
    }
    if !figure.caption.is_empty() {
        sentences.push(figure.caption.plain());
    }
    sentences.join(" ")
}

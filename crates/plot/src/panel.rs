//! Draws the layers of a panel within its frame.

use crate::figure::{Inset, LegendSample, Panel};
use crate::frame::Frame;
use crate::geometry::{Point, Rect, thin};
use crate::layer::{Across, Anchor, Guide, Layer, Line, Markers, Note, Region};
use crate::legend::Legend;
use crate::palette::{FRAME, PAPER};
use crate::raster;
use crate::svg::Canvas;
use crate::text::TextStyle;

/// Largest distance on paper between a curve and the simplified line that replaces it, in pixels.
const TOLERANCE: f64 = 0.05;
/// Size of a text inside the panel, in pixels.
const NOTE: f64 = 13.5;

/// Draws a panel with its layers and insets, and adds the names of its visible layers to the legend.
pub(crate) fn draw_panel(canvas: &mut Canvas, panel: &Panel, frame: &Frame, legend: &mut Legend) {
    let mut areas = false;
    for layer in &panel.layers {
        match layer {
            Layer::Region(layer) => areas |= region(canvas, layer, frame, legend),
            Layer::Raster(layer) => areas |= raster::draw(canvas, layer, frame, legend),
            Layer::Line(_) | Layer::Markers(_) | Layer::Note(_) | Layer::Guide(_) => {}
        }
    }
    frame.grid(canvas, areas);
    for layer in &panel.layers {
        match layer {
            Layer::Line(layer) => line(canvas, layer, frame, legend),
            Layer::Markers(layer) => markers(canvas, layer, frame, legend),
            Layer::Guide(layer) => guide(canvas, layer, frame, legend),
            Layer::Region(_) | Layer::Raster(_) | Layer::Note(_) => {}
        }
    }
    frame.axes(canvas, panel);
    for layer in &panel.layers {
        match layer {
            Layer::Note(layer) => note(canvas, layer, frame, true),
            Layer::Region(Region {
                name, at: Some(at), ..
            }) => {
                note(canvas, &Note::new(name, *at, Anchor::Middle), frame, false);
            }
            _ => {}
        }
    }
    for layer in &panel.insets {
        inset(canvas, layer, frame, legend);
    }
}

/// Converts the points of a line to positions on paper. The function splits the line at points that the axes cannot
/// show.
fn placed(points: &[Point], frame: &Frame) -> Vec<Vec<Point>> {
    let mut runs: Vec<Vec<Point>> = vec![Vec::new()];
    for (x, y) in points {
        match (frame.x.at(*x), frame.y.at(*y)) {
            (Some(x), Some(y)) => {
                if let Some(run) = runs.last_mut() {
                    run.push((x, y));
                }
            }
            _ => runs.push(Vec::new()),
        }
    }
    runs
}

fn line(canvas: &mut Canvas, layer: &Line, frame: &Frame, legend: &mut Legend) {
    let drawn: Vec<Vec<Point>> = layer
        .pieces
        .iter()
        .flat_map(|piece| placed(piece, frame))
        .flat_map(|run| frame.rect.clip(&run))
        .map(|part| thin(&part, TOLERANCE))
        .collect();
    if drawn.is_empty() {
        return;
    }
    canvas.lines(&drawn, layer.colour.rgb(), layer.stroke);
    if let Some(name) = &layer.name {
        legend.add(name, LegendSample::Line(layer.colour, layer.stroke));
    }
}

fn markers(canvas: &mut Canvas, layer: &Markers, frame: &Frame, legend: &mut Legend) {
    let mut points = placed(&layer.points, frame).concat();
    points.retain(|point| frame.rect.contains(*point));
    if points.is_empty() {
        return;
    }
    canvas.markers(&points, layer.colour.rgb(), layer.marker);
    if let Some(name) = &layer.name {
        legend.add(name, LegendSample::Marker(layer.colour, layer.marker));
    }
}

fn guide(canvas: &mut Canvas, layer: &Guide, frame: &Frame, legend: &mut Legend) {
    let rect = frame.rect;
    let ends = match layer.across {
        Across::X(x) => frame
            .x
            .at(x)
            .map(|x| vec![(x, rect.top), (x, rect.bottom())]),
        Across::Y(y) => frame
            .y
            .at(y)
            .map(|y| vec![(rect.left, y), (rect.right(), y)]),
    };
    let Some(ends) = ends.filter(|ends| ends.iter().all(|end| rect.contains(*end))) else {
        return;
    };
    canvas.lines(&[ends], layer.colour.rgb(), layer.stroke);
    if let Some(name) = &layer.name {
        legend.add(name, LegendSample::Line(layer.colour, layer.stroke));
    }
}

fn region(canvas: &mut Canvas, layer: &Region, frame: &Frame, legend: &mut Legend) -> bool {
    let outlines: Vec<Vec<Point>> = layer
        .outlines
        .iter()
        .map(|outline| frame.rect.clip_area(&placed(outline, frame).concat()))
        .map(|mut outline| {
            // The code repeats the first point before it thins the outline, because `thin` expects an open line.
            outline.extend(outline.first().copied());
            thin(&outline, TOLERANCE)
        })
        .filter(|outline| 3 < outline.len())
        .collect();
    if outlines.is_empty() {
        return false;
    }
    canvas.areas(&outlines, layer.fill.rgb());
    if layer.at.is_none() {
        legend.add(&layer.name, LegendSample::Fill(layer.fill));
    }
    true
}

fn note(canvas: &mut Canvas, layer: &Note, frame: &Frame, halo: bool) {
    let (Some(x), Some(y)) = (frame.x.at(layer.at.0), frame.y.at(layer.at.1)) else {
        return;
    };
    if !frame.rect.contains((x, y)) {
        return;
    }
    let width = layer.text.width(NOTE);
    let before = match layer.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5 * width,
        Anchor::End => width,
    };
    // The code moves a text that crosses the frame to the inside, if the frame is wide enough.
    let (least, most) = (frame.rect.left + 4.0, frame.rect.right() - 4.0 - width);
    let left = if least < most {
        (x - before).clamp(least, most)
    } else {
        least
    };
    let (highest, lowest) = (frame.rect.top + NOTE, frame.rect.bottom() - 5.0);
    let baseline = (y + 0.32 * NOTE).max(highest).min(lowest);
    let style = TextStyle {
        halo,
        ..TextStyle::new(NOTE, layer.anchor).coloured(layer.colour.rgb())
    };
    canvas.text(&layer.text, (left + before, baseline), style);
}

fn inset(canvas: &mut Canvas, layer: &Inset, outer: &Frame, legend: &mut Legend) {
    let (left, top, width, height) = layer.place;
    if ![left, top, width, height]
        .iter()
        .all(|share| share.is_finite())
        || width <= 0.0
        || height <= 0.0
    {
        return;
    }
    let rect = Rect {
        left: outer.rect.left + left * outer.rect.width,
        top: outer.rect.top + top * outer.rect.height,
        width: width * outer.rect.width,
        height: height * outer.rect.height,
    };
    let frame = Frame::new(&layer.panel, rect, true);
    canvas.rect(frame.whole(&layer.panel), Some(PAPER), None);
    if layer.marked {
        mark(canvas, &layer.panel, outer, frame.rect);
    }
    draw_panel(canvas, &layer.panel, &frame, legend);
}

/// Draws a rectangle around the area of the outer panel that an inset shows. Two lines connect this rectangle with
/// the inset.
fn mark(canvas: &mut Canvas, inner: &Panel, outer: &Frame, frame: Rect) {
    let (x, y) = (inner.x.range(), inner.y.range());
    let corners = [(x.0, y.1), (x.1, y.1), (x.1, y.0), (x.0, y.0)];
    let outline = outer.rect.clip_area(&placed(&corners, outer).concat());
    let ends = |of: fn(&Point) -> f64| {
        let values = outline.iter().map(of);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |ends, value| {
            (ends.0.min(value), ends.1.max(value))
        })
    };
    let ((left, right), (top, bottom)) = (ends(|p| p.0), ends(|p| p.1));
    if !(left < right && top < bottom) {
        return;
    }
    let area = Rect {
        left,
        top,
        width: right - left,
        height: bottom - top,
    };
    canvas.rect(area, None, Some((FRAME, 0.8)));
    // Lines connect the side of the area and the side of the inset that face each other.
    let gaps = [
        frame.left - right,
        left - frame.right(),
        frame.top - bottom,
        top - frame.bottom(),
    ];
    let widest = gaps.iter().copied().fold(0.0, f64::max);
    let facing = gaps.iter().position(|gap| 0.0 < *gap && *gap == widest);
    let between = match facing {
        Some(0) => [
            (right, top, frame.left, frame.top),
            (right, bottom, frame.left, frame.bottom()),
        ],
        Some(1) => [
            (left, top, frame.right(), frame.top),
            (left, bottom, frame.right(), frame.bottom()),
        ],
        Some(2) => [
            (left, bottom, frame.left, frame.top),
            (right, bottom, frame.right(), frame.top),
        ],
        Some(_) => [
            (left, top, frame.left, frame.bottom()),
            (right, top, frame.right(), frame.bottom()),
        ],
        None => return,
    };
    let lines = between.map(|(x, y, to_x, to_y)| vec![(x, y), (to_x, to_y)]);
    canvas.path(&lines, FRAME, 0.6, "");
}

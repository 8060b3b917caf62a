//! Draws pictures and writes their files.

use crate::asked::MovingPart;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::measure::{self, Measure};
use frictiongen::System;
use frictiongen_plot::desk::{Scales, sketch, sketch_without_load};
use frictiongen_plot::{Axis, Colour, Figure, Label, Line, Panel, Sketch, Stroke};
use std::io::Write;

/// Number of PNG pixels along the side of an SVG pixel.
#[cfg(feature = "png")]
const SCALE: f32 = 2.0;

/// Upper end of an axis, as a multiple of the largest value that the axis shows.
pub const ROOM: f64 = 1.15;

/// Returns the panels of a picture over time in s. The panels show displacements in m, spring forces in N and the
/// friction force in N. `motions` has the values of each displacement or spring force at the times.
pub fn over_time(times: &[f64], motions: &[(&MovingPart, &[f64])], force: &[f64]) -> Vec<Panel> {
    let ends = [times.first(), times.last()].map(|end| end.copied().unwrap_or(0.0));
    let [first, last] = ends;
    let time = || {
        Axis::new(
            "time (s)",
            first,
            if first < last { last } else { first + 1.0 },
        )
    };
    let track = |values: &[f64]| -> Vec<(f64, f64)> {
        times.iter().copied().zip(values.iter().copied()).collect()
    };
    let edge = |values: &mut dyn Iterator<Item = f64>| {
        let most = values.map(f64::abs).fold(0.0, f64::max);
        if 0.0 < most { most * ROOM } else { 1.0 }
    };
    let mut panels = Vec::new();
    for (forces, label) in [(false, "displacement (m)"), (true, "force (N)")] {
        let shown = motions.iter().enumerate();
        let shown: Vec<_> = shown
            .filter(|(_, (part, _))| part.of.is_force() == forces)
            .collect();
        if shown.is_empty() {
            continue;
        }
        let high = edge(
            &mut shown
                .iter()
                .flat_map(|(_, (_, values))| values.iter().copied()),
        );
        let mut panel = Panel::new("", time(), Axis::new(label, -high, high));
        for (place, (part, values)) in shown {
            panel = panel.with(Line::new(
                part_name(part),
                Colour::Series(place),
                Stroke::Solid,
                vec![track(values)],
            ));
        }
        panels.push(panel);
    }
    let high = edge(&mut force.iter().copied());
    let force = Line::new(
        "friction force",
        Colour::Black,
        Stroke::Solid,
        vec![track(force)],
    );
    let axis = Axis::new("friction force (N)", -high, high);
    panels.push(Panel::new("", time(), axis).with(force));
    panels
}

/// Returns the units of the axes of a picture.
pub fn scales(system: &System, in_hertz: bool, measure: &Measure) -> Scales {
    let mut scales = Scales::groups(system);
    if in_hertz {
        scales = scales.in_hertz(system);
    }
    match measure.scale() {
        Some(load) => scales.under(load).falling(measure.fall()),
        None => scales,
    }
}

/// Adds the amplitude of the load to the caption of a figure if the figure is in N and m. If the figure is in
/// non-dimensional groups, the caption is only `more`.
pub fn under_load(figure: Figure, measure: &Measure, more: &str) -> Figure {
    let caption = match measure::description(measure, short) {
        Some(load) if more.is_empty() => load,
        Some(load) => format!("{load}; {more}"),
        None => more.to_owned(),
    };
    match caption.as_str() {
        "" => figure,
        caption => figure.with_caption(Label::verbatim(caption)),
    }
}

/// Formats a number with four significant digits for a caption.
pub fn short(value: f64) -> String {
    let rounded = format!("{value:.3e}").parse().unwrap_or(value);
    format!("{rounded}")
}

/// Returns the title of the panel that shows the motion of `part`.
pub fn part_name(part: &MovingPart) -> Label {
    Label::verbatim(&part.name)
}

/// Writes a figure of a motion over time, with a sketch of the system under a harmonic load or without a load.
pub fn write_motion(
    figure: Figure,
    system: &System,
    measure: &Measure,
    (form, out): (OutputFormat, &mut dyn Write),
) -> Result<(), Failure> {
    let sketch = match measure.is_free() {
        true => sketch_without_load(system.scene()),
        false => sketch(system.scene(), true),
    };
    write_with(figure, sketch, form, out)
}

/// Writes a figure of a system under a harmonic load, with a sketch of the system.
pub fn write(
    figure: Figure,
    system: &System,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    write_with(figure, sketch(system.scene(), true), form, out)
}

/// Writes a figure with a given sketch.
pub fn write_with(
    figure: Figure,
    sketch: Sketch,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    write_alone(&figure.with_sketch(sketch), form, out)
}

/// Writes a figure without a sketch.
pub fn write_alone(
    figure: &Figure,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let bytes = match form {
        #[cfg(feature = "png")]
        OutputFormat::Png => figure.png(SCALE).map_err(Failure::new)?,
        _ => figure.svg().into_bytes(),
    };
    out.write_all(&bytes)?;
    Ok(out.flush()?)
}

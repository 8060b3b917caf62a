//! Draws pictures and writes their files.

use crate::asked::Part;
use crate::destination::Form;
use crate::failure::Failure;
use crate::measure::{self, Measure};
use frictiongen::System;
use frictiongen_plot::desk::{Scales, sketch};
use frictiongen_plot::{Figure, Label, Sketch};
use std::io::Write;

/// Number of PNG pixels along a side of an SVG pixel.
#[cfg(feature = "png")]
const SCALE: f32 = 2.0;

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

/// Adds the amplitude of the load to the caption of a figure, if the figure is in N and m. For a figure in
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

/// Formats a number for a caption, with four digits.
fn short(value: f64) -> String {
    let rounded = format!("{value:.3e}").parse().unwrap_or(value);
    format!("{rounded}")
}

/// Returns the title of the panel of a motion.
pub fn part_name(part: &Part) -> Label {
    Label::verbatim(&part.name)
}

/// Writes a figure of a system under a harmonic load, with a sketch of the system.
pub fn write(
    figure: Figure,
    system: &System,
    form: Form,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    write_with(figure, sketch(system.scene(), true), form, out)
}

/// Writes a figure with a given sketch.
pub fn write_with(
    figure: Figure,
    sketch: Sketch,
    form: Form,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let figure = figure.with_sketch(sketch);
    let bytes = match form {
        #[cfg(feature = "png")]
        Form::Png => figure.png(SCALE).map_err(Failure::new)?,
        _ => figure.svg().into_bytes(),
    };
    out.write_all(&bytes)?;
    Ok(out.flush()?)
}

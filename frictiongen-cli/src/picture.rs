//! Draws pictures and writes their files.

use crate::asked::Part;
use crate::destination::Form;
use crate::failure::Failure;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen_plot::desk::{Scales, sketch};
use frictiongen_plot::{Figure, Label, Sketch};
use std::io::Write;

/// Number of PNG pixels for each SVG pixel, along a side.
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

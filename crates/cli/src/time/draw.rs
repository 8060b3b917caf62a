//! Draws motions over time and spectra.

use super::motion::RunMotion;
use super::spectrum::spectra;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::picture;
use frictiongen::System;
use frictiongen_plot::Label;
use frictiongen_plot::desk::{history_figure, spectrum_figure};
use std::io::Write;

/// Draws a motion over time, or its spectrum.
pub fn draw(
    system: &System,
    motion: &RunMotion<'_>,
    spectrum: bool,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let course = &motion.course;
    let mut scales = picture::scales(system, false, &course.measure);
    if course.in_seconds {
        scales = scales.at(course.frequency.omega);
    }
    let parts: Vec<Label> = course.parts.iter().map(picture::part_name).collect();
    let title = Label::verbatim(&system.scene().name);
    let figure = if spectrum {
        spectrum_figure(title, &spectra(motion), &parts, &scales)
    } else {
        let turned = course.measure.turns_contact();
        history_figure(title, &motion.history, &parts, turned, &scales)
    };
    let point = motion.preamble().into_iter().map(|(_, what)| what);
    let caption = point.collect::<Vec<_>>().join("; ");
    let figure = picture::under_load(figure, &course.measure, &caption);
    picture::write_motion(figure, system, &course.measure, (form, out))
}

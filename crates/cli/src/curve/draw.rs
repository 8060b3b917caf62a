//! Draws the curves of `frictiongen curve`.

use super::report::CurveReport;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::picture;
use frictiongen::Of;
use frictiongen::study::curve::CurveStart;
use frictiongen::study::response::MotionQuantity;
use frictiongen_plot::desk::{Drawn, curve_figure};
use frictiongen_plot::{Colour, Label};
use std::io::Write;

/// Draws amplitude and phase of each motion over frequency.
pub fn draw(report: &CurveReport, form: OutputFormat, out: &mut dyn Write) -> Result<(), Failure> {
    let scales = picture::scales(&report.system, report.band.is_physical(), &report.measure);
    let scales = scales.with_log(report.log.frequency(), report.log.amplitude());
    let curves = report.curves.iter().enumerate();
    let drawn: Vec<Drawn<'_>> = curves
        .map(|(index, (friction, curve))| Drawn {
            curve,
            name: match report.swept {
                true => scales.swept_name(friction.beta, way(curve.start)),
                false => scales.friction_name(friction.beta),
            },
            colour: Colour::Series(index),
        })
        .collect();
    let parts = report.parts.iter();
    let parts: Vec<(Of, MotionQuantity, Label)> = parts
        .map(|part| (part.of, part.size, picture::part_name(part)))
        .collect();
    let title = Label::verbatim(&report.system.scene().name);
    let figure = curve_figure(title, &drawn, &parts, &scales);
    let figure = picture::under_load(figure, &report.measure, "");
    picture::write(figure, &report.system, form, out)
}

/// Returns the words of the legend that describe the initial state of a curve.
fn way(start: CurveStart) -> &'static str {
    match start {
        CurveStart::Rest => ", from rest",
        CurveStart::Up => ", swept up",
        CurveStart::Down => ", swept down",
    }
}

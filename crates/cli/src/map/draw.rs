//! Draws the map of `frictiongen map`.

use super::points::MapReport;
use crate::args::ShadeArgument;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::picture;
use frictiongen::study::map::Boundary;
use frictiongen_plot::Label;
use frictiongen_plot::desk::{self, map_figure};
use std::io::Write;

/// Largest distance between a limit and its line in the picture, measured in β/(1 + β).
const LINES: f64 = 2e-4;

/// Draws a map over frequency and friction. Lines over the map show β_lim and β*_lim.
pub fn draw(
    report: &MapReport<'_>,
    boundaries: &[Boundary],
    shade: ShadeArgument,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    // The unit of force and the unit of length of the whole picture are those that belong to the load at r = 1.
    let (map, grids) = (&report.map.at_reference(), &report.grids);
    let fall = grids.measure.fall();
    let ends = map
        .columns
        .iter()
        .fold((f64::INFINITY, 0.0_f64), |(low, high), column| {
            (low.min(column.r), high.max(column.r))
        });
    if !(ends.0 < ends.1) || map.beta.len() < 2 {
        return Err(Failure::new(
            "a picture of a map needs two frequencies and two frictions",
        ));
    }
    let lines = grids
        .system
        .limit_lines(ends.0, ends.1, LINES)
        .map_err(Failure::new)?
        .at_reference(fall);
    let boundaries = boundaries.iter();
    let boundaries: Vec<Boundary> = boundaries.map(|each| each.at_reference(fall)).collect();
    let shade = match shade {
        ShadeArgument::Regime => desk::Shade::Regime,
        ShadeArgument::Stuck => desk::Shade::Stuck,
        ShadeArgument::Amplitude => desk::Shade::Amplitude(0),
    };
    let scales = picture::scales(
        &grids.system,
        grids.frequencies.are_physical(),
        &grids.measure,
    );
    let name = &grids.system.scene().name;
    let title = match (shade, grids.parts.first()) {
        (desk::Shade::Amplitude(_), Some(part)) => format!("{name}: {}", part.name),
        _ => name.clone(),
    };
    let scales = match grids.parts.first() {
        Some(part) => scales.showing(part.of),
        None => scales,
    };
    let figure = map_figure(
        Label::verbatim(&title),
        map,
        &lines,
        &boundaries,
        shade,
        &scales,
    );
    let figure = picture::under_load(figure, &grids.measure, "");
    picture::write(figure, &grids.system, form, out)
}

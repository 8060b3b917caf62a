//! Draws the motion over one period of a steady state, and the hysteresis loop of the contact.

use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::number::computed;
use crate::picture;
use frictiongen::Of;
use frictiongen::study::columns::{Measure, PeriodicRow, PeriodicTable};
use frictiongen_plot::desk::sketch_under_record;
use frictiongen_plot::{Axis, Colour, Figure, Label, Line, Panel, Stroke};
use std::io::Write;

/// Draws the motion over one period of a steady state. If the contact is among the motions, the picture also shows the
/// friction force against the slip.
pub fn motion(
    table: &PeriodicTable<'_>,
    row: &PeriodicRow,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let (system, state) = (table.system, &row.state);
    let measure = Measure::si(system);
    let sign = if measure.turns_contact() { -1.0 } else { 1.0 };
    let force: Vec<f64> = state.forces().iter().map(|force| sign * force).collect();
    let parts = table.parts.iter().enumerate();
    let values: Vec<Vec<f64>> = parts
        .map(|(place, part)| row.values(place, measure.turns(part.of)))
        .collect();
    let motions = table.parts.iter().zip(&values);
    let motions: Vec<_> = motions
        .map(|(part, values)| (part, values.as_slice()))
        .collect();
    let mut panels = picture::over_time(&row.times(), &motions, &force);
    let slip = motions.iter().find(|(part, _)| part.of == Of::Contact);
    if let Some((_, slip)) = slip {
        let path: Vec<(f64, f64)> = slip.iter().copied().zip(force.iter().copied()).collect();
        let across = Axis::fitted("slip of the contact (m)", path.iter().map(|point| point.0));
        let up = Axis::fitted("friction force (N)", path.iter().map(|point| point.1));
        let title = "hysteresis loop of the contact, area = energy";
        let line = Line::unnamed(Colour::Black, Stroke::Solid, vec![path]);
        panels.push(Panel::new(title, across, up).with(line));
    }
    let caption = format!(
        "friction force {} N; {}; the motion repeats after {} of the load",
        computed(row.friction),
        if state.is_stable() {
            "stable"
        } else {
            "marginal"
        },
        match state.period() {
            1 => "one period".to_owned(),
            periods => format!("{periods} periods"),
        }
    );
    let title = Label::verbatim(&system.scene().name);
    let figure = Figure::new("", title, 2, panels).with_caption(Label::verbatim(&caption));
    picture::write_with(figure, sketch_under_record(system.scene()), form, out)
}

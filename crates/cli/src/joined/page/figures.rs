//! Draws the figures that only the report page of a scene with several contacts contains.

use crate::failure::Failure;
use crate::joined::{Question, draw};
use crate::picture;
use frictiongen::study::columns::Frequency;
use frictiongen::study::joined::JoinedOrbit;
use frictiongen_plot::{Axis, Colour, Figure, Label, Line, Panel, Stroke};

/// Draws amplitudes over frequency in two cases with a closed form: without friction, and with all contacts stuck.
pub(super) fn closed(question: &Question<'_>) -> Result<Figure, Failure> {
    let physical = question.frequencies.are_physical();
    let scales = picture::scales(question.system, physical, &question.measure);
    let parts = &question.parts;
    let mut lines = vec![[Vec::new(), Vec::new()]; parts.len()];
    for frequency in question.frequencies.all(question.system) {
        let at = question.table().at(frequency).map_err(Failure::new)?;
        let (free, stuck) = (at.linear().ok(), at.stuck().ok());
        for (part, [without, locked]) in parts.iter().zip(&mut lines) {
            let sizes = [
                free.as_ref()
                    .and_then(|free| free.amplitude(part.of, part.size)),
                stuck
                    .as_ref()
                    .and_then(|stuck| stuck.amplitude(part.of, part.size)),
            ];
            for (size, line) in sizes.into_iter().zip([without, locked]) {
                let size = size.unwrap_or(f64::NAN);
                let size = draw::in_unit(size, part, (frequency.r, &scales));
                line.push((scales.frequency(frequency.r), size));
            }
        }
    }
    let range = question.frequencies.all(question.system).map(|at| at.r);
    let (low, high) = range.fold((f64::INFINITY, 0.0_f64), |(low, high), r| {
        (low.min(scales.frequency(r)), high.max(scales.frequency(r)))
    });
    let panels = parts.iter().zip(lines).map(|(part, [without, locked])| {
        let sizes = without.iter().chain(&locked).map(|point| point.1);
        let sizes: Vec<f64> = sizes
            .filter(|size| 0.0 < *size && size.is_finite())
            .collect();
        let label = scales.showing(part.of).size_label(part.size);
        let axis = Axis::fitted_log(label, sizes);
        Panel::new(
            Label::verbatim(&part.name),
            scales.frequency_axis(low, high),
            axis,
        )
        .with(Line::new(
            "without friction",
            Colour::Series(0),
            Stroke::Solid,
            vec![without],
        ))
        .with(Line::new(
            "all contacts stuck",
            Colour::Series(1),
            Stroke::Dotted,
            vec![locked],
        ))
    });
    let title = Label::verbatim(&question.system.scene().name);
    let figure = Figure::new("", title, 2, panels.collect());
    Ok(picture::under_load(figure, &question.measure, ""))
}

/// Draws one period of a steady state, with the hysteresis loops of all contacts.
pub(super) fn loops_figure(
    question: &Question<'_>,
    (frequency, orbit): (Frequency, &JoinedOrbit<'_>),
) -> Result<Figure, Failure> {
    let cycles = u32::try_from(orbit.period()).unwrap_or(u32::MAX);
    let mut run = orbit.simulation().map_err(Failure::new)?;
    let path = run.path(0, cycles, 200).map_err(Failure::new)?;
    Ok(draw::motion_figure(question, (&path, frequency), ""))
}

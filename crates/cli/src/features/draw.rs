//! Draws the amplitudes over frequency, and marks the features on them.

use super::report::FeaturesReport;
use crate::asked::MovingPart;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::picture;
use frictiongen::study::columns::FeatureLine;
use frictiongen::study::curve::CurveRequest;
use frictiongen_plot::desk::{Drawn, Reading, Scales, keys_of, panel};
use frictiongen_plot::{Colour, Figure, Label, Marker, Markers};
use std::io::Write;

/// Kinds of features that a picture marks. Each has a name, a marker and a legend entry.
const MARKS: [(&str, Marker, &str); 3] = [
    ("invariant point", Marker::Circle, "invariant point"),
    ("same amplitude", Marker::Square, "same amplitude"),
    ("peak", Marker::Triangle, "peak"),
];

/// Returns the marks of the features on the amplitude curve of a motion.
pub fn marks(
    lines: &[FeatureLine],
    part: &MovingPart,
    measure: &Measure,
    scales: &Scales,
) -> Vec<Markers> {
    let mut marks = Vec::new();
    for (feature, marker, name) in MARKS {
        // The curves of the picture show amplitudes. A feature of the fundamental component is not on these curves, so
        // the picture does not mark it.
        let marked = lines.iter().filter(|line| {
            line.feature == feature
                && line.of == part.name
                && !line.detail.starts_with("fundamental")
        });
        // Under a load, the amplitude of a feature is in m, but the axis of the picture is in mm.
        let points: Vec<_> = marked
            .filter_map(|line| {
                let height = measure.length_ratio(line.amplitude?);
                Some((scales.frequency(line.r?), scales.length(height)))
            })
            .filter(|(_, height)| height.is_finite())
            .collect();
        if !points.is_empty() {
            marks.push(Markers::new(name, Colour::Black, marker, points));
        }
    }
    marks
}

/// Draws each motion in its own panel, at the given friction. If the user gives no friction, the panels show the
/// motions without friction.
pub fn draw(
    report: &FeaturesReport<'_>,
    parts: &[MovingPart],
    frictions: &[f64],
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let scales = picture::scales(report.system, report.band.is_physical(), &report.measure);
    let of: Vec<_> = parts.iter().map(|part| part.of).collect();
    let request = CurveRequest::new(report.band.from, report.band.to, &of);
    let frictions = if frictions.is_empty() {
        &[0.0]
    } else {
        frictions
    };
    let curves = frictions
        .iter()
        .map(|beta| report.system.curve(&request, *beta).map_err(Failure::new))
        .collect::<Result<Vec<_>, Failure>>()?;
    let drawn: Vec<Drawn<'_>> = curves
        .iter()
        .zip(frictions)
        .enumerate()
        .map(|(index, (curve, beta))| Drawn {
            curve,
            name: scales.friction_name(*beta),
            colour: Colour::Series(index),
        })
        .collect();
    let mut panels = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        let title = picture::part_name(part);
        let mut own = panel(title, &drawn, index, Reading::Amplitude, &scales);
        for markers in marks(&report.lines, part, &report.measure, &scales) {
            own = own.with(markers);
        }
        panels.push(own);
    }
    let title = Label::verbatim(&report.system.scene().name);
    let columns = parts.len().min(2);
    let figure = Figure::new("", title, columns, panels).with_keys(keys_of(&curves));
    let figure = picture::under_load(figure, &report.measure, "");
    picture::write(figure, report.system, form, out)
}

//! Draws the residuals of an identification.

use crate::destination::Form;
use crate::failure::Failure;
use crate::picture;
use frictiongen::System;
use frictiongen::measure::{Identified, Observation};
use frictiongen_plot::{Across, Axis, Colour, Figure, Guide, Label, Marker, Markers, Panel};
use std::io::Write;

/// How much wider the frame is than the points.
const ROOM: f64 = 1.15;

/// Residuals over their deviations, over frequency: real parts and imaginary parts, and the lines at ±2.
pub fn residuals(
    system: &System,
    observations: &[Observation],
    found: &Identified,
    form: Form,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let (mut real, mut imaginary) = (Vec::new(), Vec::new());
    for (index, seen) in observations.iter().enumerate() {
        let residuals = found.residuals(observations, index);
        for (datum, residual) in seen.motions.iter().zip(residuals) {
            real.push((seen.hertz, residual.re / datum.deviation));
            imaginary.push((seen.hertz, residual.im / datum.deviation));
        }
    }
    let all = || real.iter().chain(&imaginary);
    let high = all().map(|(_, value)| value.abs()).fold(2.5, f64::max) * ROOM;
    let right = all().map(|(hertz, _)| *hertz).fold(0.0, f64::max) * ROOM;
    let mut panel = Panel::new(
        "",
        Axis::new("frequency (Hz)", 0.0, right),
        Axis::new("residual over deviation", -high, high),
    );
    for level in [-2.0, 0.0, 2.0] {
        panel = panel.with(Guide::new(Across::Y(level)));
    }
    let panel = panel
        .with(Markers::new("real part", Colour::Black, Marker::Dot, real))
        .with(Markers::new(
            "imaginary part",
            Colour::Black,
            Marker::Circle,
            imaginary,
        ));
    let caption = format!(
        "F = {:.6} N, 95 %: {:.6} to {:.6} N; {}",
        found.friction.value, found.friction.from, found.friction.to, found.verdict
    );
    let figure = Figure::new("", "Measured less computed", 1, vec![panel])
        .with_caption(Label::verbatim(&caption));
    picture::write(figure, system, form, out)
}

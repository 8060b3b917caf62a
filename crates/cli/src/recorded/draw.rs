//! Draws the residuals of an identification, and the motion under a recorded input.

use super::driven::DrivenReport;
use super::spectrum::ResponseSpectrumReport;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::output::ResultTable as _;
use crate::picture;
use frictiongen::measure::columns::{DrivenSample, SpectrumRow};
use frictiongen::measure::{Identified, Observation, PeakResponse};
use frictiongen::{Of, System};
use frictiongen_plot::desk::{
    ContactTrack, JoinedMotion, joined_motion_figure, sketch_under_record,
};
use frictiongen_plot::{
    Across, Axis, Colour, Figure, Guide, Label, Line, Marker, Markers, Panel, Stroke,
};
use std::io::Write;

/// Upper end of an axis, as a multiple of the largest value that the axis shows.
const ROOM: f64 = 1.15;

/// Draws the residuals of an identification over frequency, as multiples of their standard deviations. The picture
/// shows real parts, imaginary parts, and lines at ±2 standard deviations.
pub fn residuals(
    system: &System,
    observations: &[Observation],
    found: &Identified,
    form: OutputFormat,
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

/// Draws displacements and forces under a recorded input over time, and a hysteresis loop of each contact.
pub fn driven(
    driven: &DrivenReport<'_>,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let (table, samples) = (&driven.table, &driven.motion.samples);
    let track = |read: &dyn Fn(&DrivenSample) -> Option<f64>| -> Vec<f64> {
        samples.iter().filter_map(read).collect()
    };
    let parts = table.parts.iter().enumerate();
    let parts = parts.filter(|(_, part)| part.of != Of::Contact);
    let named = parts.map(|(place, part)| {
        let values = track(&|sample| sample.motions.get(place).map(|[value, _]| *value));
        (part.of.is_force(), (part.name.clone(), values))
    });
    let (springs, masses): (Vec<_>, Vec<_>) = named.partition(|(is_force, _)| *is_force);
    let tracks = |all: Vec<(bool, (String, Vec<f64>))>| {
        let tracks = all.into_iter().map(|(_, track)| track);
        tracks.collect()
    };
    let contacts = table.names.iter().enumerate().map(|(index, name)| {
        let states = || samples.iter().filter_map(|all| all.contacts.get(index));
        ContactTrack {
            name: name.clone(),
            displacement: states().map(|now| now.displacement).collect(),
            force: states().map(|now| now.force).collect(),
            sticks: states().map(|now| now.is_sticking).collect(),
        }
    });
    let motion = JoinedMotion {
        times: track(&|sample| Some(sample.time)),
        time_label: "time (s)".into(),
        displacement_label: "displacement (m)".into(),
        force_label: "force (N)".into(),
        masses: tracks(masses),
        springs: tracks(springs),
        contacts: contacts.collect(),
    };
    let scene = table.system.scene();
    let said = driven.preamble().into_iter();
    let said: Vec<String> = said
        .map(|(title, text)| format!("{title}: {text}"))
        .collect();
    let figure = joined_motion_figure(Label::verbatim(&scene.name), &motion)
        .with_caption(Label::verbatim(&said.join("; ")));
    picture::write_with(figure, sketch_under_record(scene), form, out)
}

/// Draws pseudo-acceleration and displacement of a response spectrum against the period. The picture also shows the
/// natural periods of the scene.
pub fn spectrum(
    system: &System,
    spectrum: &ResponseSpectrumReport<'_>,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let acceleration = |peak: &PeakResponse| peak.displacement * peak.omega() * peak.omega();
    let displacement = |peak: &PeakResponse| peak.displacement;
    let panel = |title: &str, read: &dyn Fn(&PeakResponse) -> f64| {
        let of = |row: &SpectrumRow| (row.peak.period, read(&row.peak));
        let (modes, others): (Vec<&SpectrumRow>, Vec<&SpectrumRow>) =
            spectrum.rows.iter().partition(|row| row.mode.is_some());
        let mut curve: Vec<(f64, f64)> = spectrum.rows.iter().map(of).collect();
        curve.sort_by(|a, b| a.0.total_cmp(&b.0));
        let modes: Vec<(f64, f64)> = modes.into_iter().map(of).collect();
        let grid = others.iter().map(|row| row.peak.period);
        let x = Axis::fitted_log("period (s)", grid.chain(modes.iter().map(|mode| mode.0)));
        let high = curve.iter().map(|point| point.1).fold(0.0, f64::max);
        let high = if 0.0 < high { high * ROOM } else { 1.0 };
        let mut panel = Panel::new("", x, Axis::new(title, 0.0, high));
        for (period, _) in &modes {
            panel = panel.with(Guide::new(Across::X(*period)));
        }
        panel
            .with(Line::unnamed(Colour::Series(0), Stroke::Solid, vec![curve]))
            .with(Markers::new(
                "natural periods of the scene",
                Colour::Black,
                Marker::Dot,
                modes,
            ))
    };
    let panels = vec![
        panel("pseudo-acceleration (m/s²)", &acceleration),
        panel("displacement (m)", &displacement),
    ];
    let title = Label::verbatim(&system.scene().name);
    let figure =
        Figure::new("", title, 1, panels).with_caption(Label::verbatim(&spectrum.description()));
    picture::write_with(figure, sketch_under_record(system.scene()), form, out)
}

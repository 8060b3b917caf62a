//! Figures of motions over time, phase portraits and spectra.

use super::scales::Scales;
use crate::{Across, Axis, Colour, Figure, Guide, Label, Line, Panel, Point, Stroke};
use frictiongen::study::history::{History, Spectrum, Track};
use std::f64::consts::PI;

/// Smallest amplitude of a spectral line that a figure shows, as a fraction of the amplitude of the largest line.
const FLOOR: f64 = 1e-5;

/// Returns a figure of a motion: displacements and friction force against time, and phase portraits. If the contact is
/// among the motions, the figure also shows the hysteresis loop, which is the friction force against the slip. The area
/// of the loop of one period is the energy that the contact dissipates in that period. If `turned` is true, the figure
/// reverses the signs of the contact's displacement and force.
#[must_use]
pub fn history_figure(
    title: impl Into<Label>,
    history: &History,
    parts: &[Label],
    turned: bool,
    scales: &Scales,
) -> Figure {
    let sign = |track: &Track| {
        if turned && track.of == frictiongen::Of::Contact {
            -1.0
        } else {
            1.0
        }
    };
    let times: Vec<f64> = (0..history.len())
        .map(|index| scales.time(history.tau(index)))
        .collect();
    let ends = (
        times.first().copied().unwrap_or(0.0),
        times.last().copied().unwrap_or(1.0),
    );
    let axis = || {
        let axis = Axis::new(scales.time_label(), ends.0, ends.1);
        if scales.in_seconds() || 40.0 * PI < ends.1 - ends.0 {
            axis
        } else {
            axis.in_pi()
        }
    };
    let convert = |track: &Track, values: &[f64]| -> Vec<f64> {
        values
            .iter()
            .map(|value| sign(track) * scales.showing(track.of).length(*value))
            .collect()
    };
    let over = |values: &[f64]| -> Vec<Point> {
        times.iter().copied().zip(values.iter().copied()).collect()
    };
    let mut drawn = Vec::new();
    let mut portraits = Vec::new();
    let mut forces = Vec::new();
    let mut slip = None;
    for (index, (track, name)) in history.tracks.iter().zip(parts).enumerate() {
        let colour = Colour::Series(index);
        let x = convert(track, &track.displacement);
        if track.of.is_force() {
            let line = Line::new(name.clone(), colour, Stroke::Solid, vec![over(&x)]);
            forces.push(line);
            continue;
        }
        if track.of == frictiongen::Of::Contact {
            slip = Some(x.clone());
        }
        let v = convert(track, &track.velocity).into_iter();
        let v: Vec<f64> = v.map(|value| scales.rate(value)).collect();
        drawn.push(Line::new(
            name.clone(),
            colour,
            Stroke::Solid,
            vec![over(&x)],
        ));
        let path = x.iter().copied().zip(v).collect();
        portraits.push(Line::new(name.clone(), colour, Stroke::Solid, vec![path]));
    }
    let all = |lines: &[Line], read: fn(&Point) -> f64| -> Vec<f64> {
        lines
            .iter()
            .flat_map(|line| &line.pieces)
            .flatten()
            .map(read)
            .collect()
    };
    let sign = if turned { -1.0 } else { 1.0 };
    let force: Vec<f64> = history
        .friction
        .iter()
        .map(|force| sign * scales.friction(*force))
        .collect();
    let range = Axis::fitted(scales.friction_label(), force.iter().copied());
    let pulls = Panel::new("friction force in the contact", axis(), range)
        .with(Guide::new(Across::Y(0.0)))
        .with(Line::unnamed(
            Colour::Black,
            Stroke::Solid,
            vec![over(&force)],
        ));
    let mut panels = Vec::new();
    if !drawn.is_empty() {
        let range = Axis::fitted(scales.displacement_label(), all(&drawn, |point| point.1));
        panels.push(with_lines(Panel::new("displacement", axis(), range), drawn));
    }
    panels.push(pulls);
    if !forces.is_empty() {
        let range = Axis::fitted(scales.force_label(), all(&forces, |point| point.1));
        panels.push(with_lines(Panel::new("force", axis(), range), forces));
    }
    if !portraits.is_empty() {
        let across = Axis::fitted(
            scales.displacement_label(),
            all(&portraits, |point| point.0),
        );
        let up = Axis::fitted(scales.rate_label(), all(&portraits, |point| point.1));
        panels.push(with_lines(
            Panel::new("phase portrait", across, up),
            portraits,
        ));
    }
    if let Some(slip) = slip {
        panels.push(loop_panel(&slip, &force, scales));
    }
    Figure::new("", title, 2, panels)
}

/// Returns the panel with the hysteresis loop: the friction force against the slip of the contact.
fn loop_panel(slip: &[f64], force: &[f64], scales: &Scales) -> Panel {
    let across = Axis::fitted(scales.displacement_label(), slip.iter().copied());
    let up = Axis::fitted(scales.friction_label(), force.iter().copied());
    let path = slip.iter().copied().zip(force.iter().copied()).collect();
    let title = "hysteresis loop of the contact, area = energy";
    Panel::new(title, across, up).with(Line::unnamed(Colour::Black, Stroke::Solid, vec![path]))
}

/// Returns `panel` with `lines` added on top of its other layers.
fn with_lines(panel: Panel, lines: Vec<Line>) -> Panel {
    lines
        .into_iter()
        .fold(panel, |panel, line| panel.with(line))
}

/// Returns a figure of spectra as vertical lines, one panel for each motion. All panels have the same frequency axis.
#[must_use]
pub fn spectrum_figure(
    title: impl Into<Label>,
    spectra: &[Spectrum],
    parts: &[Label],
    scales: &Scales,
) -> Figure {
    let drawn: Vec<(f64, Vec<Vec<Point>>)> = spectra
        .iter()
        .map(|spectrum| stems(spectrum, &scales.showing(spectrum.of)))
        .collect();
    let points = drawn.iter().flat_map(|(_, stems)| stems).flatten();
    let last = points
        .map(|point| point.0)
        .fold(scales.order(1.0), f64::max);
    let panels = spectra.iter().zip(drawn).zip(parts).enumerate();
    let panels = panels.map(|(index, ((spectrum, (most, stems)), part))| {
        let label = scales.showing(spectrum.of).length_label();
        let x = Axis::new(scales.order_label(), 0.0, last * 1.04);
        let y = if most > 0.0 {
            Axis::log(label, FLOOR * most, 2.0 * most)
        } else {
            Axis::new(label, 0.0, 1.0)
        };
        Panel::new(part.clone(), x, y).with(Line::unnamed(
            Colour::Series(index),
            Stroke::Solid,
            stems,
        ))
    });
    Figure::new("", title, 2, panels.collect())
}

/// Returns the amplitude of the largest line of a spectrum, and a vertical line for each spectral line of at least
/// [`FLOOR`] of this amplitude.
fn stems(spectrum: &Spectrum, scales: &Scales) -> (f64, Vec<Vec<Point>>) {
    let lines = spectrum.lines.iter();
    let lines: Vec<Point> = lines
        .map(|line| (scales.order(line.order), scales.length(line.amplitude())))
        .collect();
    let most = lines.iter().map(|line| line.1).fold(0.0, f64::max);
    let floor = FLOOR * most;
    let stems = lines
        .into_iter()
        .filter(|line| floor < line.1)
        .map(|(order, size)| vec![(order, floor), (order, size)]);
    (most, stems.collect())
}

//! Draws panels of motions over time.

use super::simulated::from_rest;
use frictiongen::study::response::SystemResponse;
use frictiongen::{Of, System};
use frictiongen_plot::{
    Axis, Colour, Fill, Key, Label, Line, Marker, Markers, Panel, Region, Stroke,
};
use std::f64::consts::TAU;

/// Number of points in a cycle of a line over time.
const POINTS: f64 = 240.0;

/// Settings of a panel over time.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// Range of the phase τ on the horizontal axis.
    pub span: (f64, f64),
    /// Distance in τ between the circles of the simulation. With 0 there are no circles.
    pub circles: f64,
    /// True if the panel also shows the excitation.
    pub excitation: bool,
}

/// Returns the legend entry for the circles of the simulation.
#[must_use]
pub fn keys() -> [Key; 1] {
    [Key::marker("simulation from rest", Marker::Circle)]
}

/// Returns a panel of motions over time, which begins at a maximum of the contact's relative motion. Lines show the
/// exact motions, circles the simulation, and shading the times at which the contact is stuck.
#[must_use]
pub fn cycle(
    title: &str,
    system: &System,
    (r, beta): (f64, f64),
    parts: &[(&str, Of, Colour)],
    times: Times,
) -> Option<Panel> {
    let response = system.at(r).ok()?.response(beta).ok()?;
    let (origin, sticking) = match &response {
        SystemResponse::Continuous(motion) => (motion.contact().phase(), Vec::new()),
        SystemResponse::StickSlip(orbit) => (orbit.origin(), orbit.sticking_intervals().collect()),
        SystemResponse::Stuck(_) => return None,
    };
    let (from, to) = times.span;
    let count = (POINTS * (to - from) / TAU).ceil() as usize;
    let taus: Vec<f64> = (0..=count)
        .map(|i| from + (to - from) * i as f64 / count as f64)
        .collect();
    let mut lines = Vec::new();
    let mut reach = if times.excitation { 1.0_f64 } else { 0.0 };
    for (name, of, colour) in parts {
        let place = |tau: &f64| Some((*tau, displacement(&response, *of, *tau)?));
        let points: Vec<(f64, f64)> = taus.iter().filter_map(place).collect();
        reach = points
            .iter()
            .fold(reach, |reach, point| reach.max(point.1.abs()));
        lines.push(Line::new(*name, *colour, Stroke::Solid, vec![points]));
    }
    let reach = 1.08 * reach;
    let x = Axis::new("*τ*", from, to).in_pi();
    let mut panel = Panel::new(title, x, Axis::new("displacement", -reach, reach));
    let stuck = stuck(&sticking, origin, times.span, reach);
    if !stuck.is_empty() {
        panel = panel.with(Region::new("stuck", Fill::Class(2), stuck));
    }
    if times.excitation {
        let points = taus.iter().map(|tau| (*tau, (tau + origin).cos()));
        let name: Label = "excitation cos(*τ* + *φ*)".into();
        panel = panel.with(Line::new(
            name,
            Colour::Black,
            Stroke::Dashed,
            vec![points.collect()],
        ));
    }
    for line in lines {
        panel = panel.with(line);
    }
    if 0.0 < times.circles {
        let of: Vec<Of> = parts.iter().map(|part| part.1).collect();
        let count = ((to - from) / times.circles).round() as usize;
        let taus: Vec<f64> = (0..=count)
            .map(|i| from + times.circles * i as f64)
            .collect();
        let first = (from + origin).rem_euclid(TAU) - from;
        let angles: Vec<f64> = taus.iter().map(|tau| tau + first).collect();
        let motions = from_rest(system, (r, beta), &of, &angles)?;
        for ((_, _, colour), motion) in parts.iter().zip(motions) {
            let points = taus.iter().copied().zip(motion).collect();
            panel = panel.with(Markers::unnamed(*colour, Marker::Circle, points));
        }
    }
    Some(panel)
}

fn displacement(response: &SystemResponse<'_>, of: Of, tau: f64) -> Option<f64> {
    match response {
        SystemResponse::Continuous(motion) => Some(motion.motion_of(of)?.displacement(tau)),
        SystemResponse::StickSlip(orbit) => orbit.ask_of(of, |motion| motion.displacement(tau)),
        SystemResponse::Stuck(_) => None,
    }
}

/// Returns the shaded areas of a panel over time, in which the contact sticks, for all cycles of its range.
fn stuck(
    sticking: &[(f64, f64)],
    origin: f64,
    (from, to): (f64, f64),
    reach: f64,
) -> Vec<Vec<(f64, f64)>> {
    let mut areas = Vec::new();
    for (start, length) in sticking {
        let first = ((start - origin - from) / TAU).floor() as i64;
        for turn in -1..=((to - from) / TAU).ceil() as i64 {
            let low = start - origin + TAU * (turn - first) as f64;
            let (low, high) = (low.max(from), (low + length).min(to));
            if low < high {
                areas.push(vec![
                    (low, -reach),
                    (high, -reach),
                    (high, reach),
                    (low, reach),
                ]);
            }
        }
    }
    areas
}

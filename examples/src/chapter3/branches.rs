//! Draws figure 3.15: coexisting steady states over the frequency ratio.

use crate::{MASS, drawn, joined};
use frictiongen::study::{SystemAt, orbit::SystemOrbit};
use frictiongen::{Of, Regime, System};
use frictiongen_examples::draw::{Responses, only_regimes, variant_colour};
use frictiongen_plot::desk::{self, Drawn, Reading, Scales};
use frictiongen_plot::{Axis, Colour, Figure, Layer, Line, Marker, Markers, Panel, Point, Stroke};
use std::error::Error;

const RANGE: (f64, f64) = (0.1, 2.5);
/// Friction ratio β of figure 3.15.
const BETA: f64 = 1.0;
/// Range of frequency ratios r in which the figure shows states that motion from rest does not reach.
const SHOWN: (f64, f64) = (0.8, 1.8);
/// Number of steps over [`SHOWN`] in the search for steady states that motion from rest does not reach.
const PLACES: u32 = 200;
/// Two amplitudes that differ by less than this value belong to the same steady state.
const ALIKE: f64 = 1e-5;
/// Largest change of the amplitude along a branch, from one frequency ratio of the search to the next.
const JOINED: f64 = 0.05;

/// Properties that distinguish branches of steady states: number of stops and of reversals in a period, period in
/// cycles, and symmetry.
type Kind = (usize, usize, u32, bool);

fn kind(orbit: &SystemOrbit<'_>) -> Kind {
    (
        orbit.stops(),
        orbit.reversals(),
        orbit.period(),
        orbit.is_symmetric(),
    )
}

/// Finds the stable sliding states at one frequency that motion from rest does not reach. Returns each with the
/// amplitude of the mass if `part` is 0, and otherwise of the contact.
fn beside_rest(at: &SystemAt<'_>, part: usize) -> Vec<(Kind, f64)> {
    let of = if part == 0 { MASS } else { Of::Contact };
    let rest = at.response(BETA).ok().and_then(|rest| rest.swing(of));
    let found = at.states(BETA).into_iter().flatten();
    let sliding = found.filter(|orbit| orbit.is_stable() && !orbit.never_slides());
    let sized = sliding.filter_map(|orbit| {
        let size = orbit.ask_of(of, |motion| motion.amplitude())?;
        Some((kind(&orbit), size))
    });
    let other =
        |(_, size): &(Kind, f64)| rest.is_none_or(|rest| ALIKE < (size - rest.amplitude).abs());
    sized.filter(other).collect()
}

/// Draws the branches of steady states that motion from rest does not reach. `part` is 0 for the mass, and 1 for the
/// contact.
fn others(system: &System, part: usize, colour: Colour) -> Vec<Layer> {
    let step = (SHOWN.1 - SHOWN.0) / f64::from(PLACES);
    let mut branches: Vec<(Kind, Vec<Point>)> = Vec::new();
    for i in 0..=PLACES {
        let r = SHOWN.0 + step * f64::from(i);
        let found = system.at(r).map(|at| beside_rest(&at, part));
        for (kind, size) in found.unwrap_or_default() {
            let goes_on = |(of, points): &&mut (Kind, Vec<Point>)| {
                *of == kind
                    && points.last().is_some_and(|last| {
                        r - last.0 < 1.5 * step && (size - last.1).abs() < JOINED
                    })
            };
            match branches.iter_mut().find(goes_on) {
                Some((_, points)) => points.push((r, size)),
                None => branches.push((kind, vec![(r, size)])),
            }
        }
    }
    let line = |((stops, ..), points): (Kind, Vec<Point>)| {
        let stroke = if stops == 0 {
            Stroke::Solid
        } else {
            Stroke::DashDot
        };
        Line::unnamed(colour, stroke, vec![points]).into()
    };
    branches
        .into_iter()
        .filter(|branch| 1 < branch.1.len())
        .map(line)
        .collect()
}

/// Figure 3.15: influence of static friction on the coexisting steady states.
pub fn stiction() -> Result<Figure, Box<dyn Error>> {
    let of = [MASS, Of::Contact];
    let systems = [1.0, 1.2, 1.5, 2.0].map(|stiction| (stiction, joined(stiction)));
    let mut curves = Vec::new();
    for (stiction, system) in &systems {
        curves.push((stiction, Responses::new(system, RANGE, &[BETA], &of)?));
    }
    let scales = Scales::groups(&systems[0].1);
    let panel = |title: &str, part: usize, label: &str, ends: (f64, f64)| {
        let x = Axis::new("frequency ratio *r*", SHOWN.0, SHOWN.1);
        let mut panel = Panel::new(title, x, Axis::new(label, ends.0, ends.1));
        for (index, (stiction, responses)) in curves.iter().enumerate() {
            for curve in responses.curves() {
                let curve = only_regimes(curve, false);
                let drawn = Drawn {
                    curve: &curve,
                    name: format!("*μ* = {stiction}").into(),
                    colour: variant_colour(index),
                };
                let lines = desk::lines(&drawn, part, Reading::Amplitude, &scales);
                panel.layers.extend(lines);
            }
        }
        // The stuck response is the same for every μ. Only the frequency at which it ends differs.
        if let Some(curve) = curves.first().and_then(|(_, first)| first.curves().first()) {
            let curve = only_regimes(curve, true);
            let drawn = Drawn {
                curve: &curve,
                name: "stuck".into(),
                colour: Colour::Black,
            };
            panel
                .layers
                .extend(desk::lines(&drawn, part, Reading::Amplitude, &scales));
        }
        // The longest line is drawn first. The end of each line remains visible. It is at β*_lim = r²/μ.
        let height = if part == 0 { 1.0 } else { 0.0 };
        for (index, (stiction, _)) in systems.iter().enumerate().skip(1).rev() {
            let points = vec![(1.0, height), ((BETA * stiction).sqrt(), height)];
            let colour = variant_colour(index);
            panel = panel.with(Line::unnamed(colour, Stroke::Dotted, vec![points]));
        }
        for (index, (_, system)) in systems.iter().enumerate().skip(1) {
            panel
                .layers
                .extend(others(system, part, variant_colour(index)));
        }
        // A mark shows the frequency from which motion from rest slides and is never stuck.
        for (index, (_, responses)) in curves.iter().enumerate().skip(1) {
            let sliding = responses.curves().iter().flat_map(|curve| &curve.pieces);
            let first = sliding.filter(|piece| piece.regime != Regime::Stuck);
            let first = first.flat_map(|piece| &piece.points).next();
            let place =
                first.and_then(|point| Some((point.r, point.movements.get(part)?.swing.amplitude)));
            let points = place.into_iter().collect();
            panel = panel.with(Markers::unnamed(variant_colour(index), Marker::Dot, points));
        }
        panel
    };
    let panels = vec![
        panel("(a) mass", 0, "*X̄*", (0.55, 1.15)),
        panel("(b) relative motion", 1, "*Z̄*", (0.0, 1.6)),
    ];
    Ok(Figure::new("3.15", "Static friction at *β* = 1", 2, panels)
        .with_sketch(drawn(&systems[0].1))
        .with_keys(desk::keys())
        .with_caption(
            "*μ* is static over kinetic friction. A stuck state exists up to *r* = √*μ*; motion from rest begins to slide at the \
             dots. Where a sliding motion and the stuck state exist at one *r*, the start decides. Motions without stops do not \
             depend on *μ*.",
        ))
}

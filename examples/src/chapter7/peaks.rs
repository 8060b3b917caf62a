//! Figures of the resonant amplitude of one mass.

use super::responses::{one_mass, with_dashpot};
use frictiongen::System;
use frictiongen_examples::draw::{beta_colour, part_colour};
use frictiongen_plot::{
    Across, Anchor, Axis, Colour, Figure, Guide, Line, Note, Panel, Point, Stroke,
};
use std::error::Error;
use std::f64::consts::{FRAC_PI_4, PI};

type Drawn = Result<Figure, Box<dyn Error>>;

/// Number of intervals of a line between its points.
const STEPS: u32 = 400;

/// Returns the amplitude of the mass at the frequency ratio r of the undamped resonance, or `None` if the contact stops
/// at this r.
fn at_resonance(system: &System, r: f64, beta: f64) -> Option<f64> {
    Some(system.at(r).ok()?.motion(beta).ok()?.contact().amplitude())
}

/// Returns the limit of continuous motion β_lim at the frequency ratio 1, the undamped resonance.
fn limit(system: &System) -> Option<f64> {
    Some(system.at(1.0).ok()?.limits().continuous)
}

/// Returns the largest amplitude of continuous motion near the resonance. The frequency ratio of this peak is
/// slightly below 1.
fn peak(system: &System, beta: f64) -> Option<f64> {
    // In this range the amplitude has a single maximum, which golden section search finds.
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (0.95, 1.005);
    let read = |r: f64| at_resonance(system, r, beta).unwrap_or(0.0);
    for _ in 0..60 {
        let (one, other) = (high - ratio * (high - low), low + ratio * (high - low));
        if read(one) < read(other) {
            low = one;
        } else {
            high = other;
        }
    }
    at_resonance(system, 0.5 * (low + high), beta)
}

/// Returns numbers from `low` to `high` that are evenly spaced on a logarithmic axis.
fn spread(low: f64, high: f64) -> impl Iterator<Item = f64> {
    (0..=STEPS).map(move |i| low * (high / low).powf(f64::from(i) / f64::from(STEPS)))
}

fn line(name: &str, colour: Colour, stroke: Stroke, points: Vec<Point>) -> Line {
    Line::new(name, colour, stroke, vec![points])
}

/// Figure 7.8: amplitude and limit over the modal damping ratio.
pub fn over_damping() -> Drawn {
    let (low, high) = (1e-4, 0.1);
    let zeta = || Axis::log("modal damping ratio *ζ*", low, high);
    let mut panel = Panel::new(
        "(a) amplitude at *r* = 1",
        zeta(),
        Axis::log("*X̄*", 0.5, 5000.0),
    );
    for beta in [0.0, 0.2, 0.4, 0.6, 0.7] {
        let place = |zeta: f64| Some((zeta, at_resonance(&one_mass(zeta), 1.0, beta)?));
        let points = spread(low, high).filter_map(place).collect();
        panel = panel.with(line(
            &format!("*β* = {beta}"),
            beta_colour(beta),
            Stroke::Solid,
            points,
        ));
    }
    let least = |zeta: f64| {
        let system = one_mass(zeta);
        // The friction is just below β_lim, because at β_lim itself the motion is no longer continuous.
        Some((
            zeta,
            at_resonance(&system, 1.0, limit(&system)? * (1.0 - 1e-13))?,
        ))
    };
    let points = spread(low, high).filter_map(least).collect();
    panel = panel.with(line("at *β*_lim", Colour::Black, Stroke::Dashed, points));
    let exact = spread(low, high).filter_map(|zeta| Some((zeta, limit(&one_mass(zeta))?)));
    // `printed` is the limit (7.62) as printed, with (cosh x − 1)/sinh x = tanh(x/2).
    let printed = |zeta: f64| (zeta, (0.5 * PI * zeta).tanh() / (2.0 * zeta));
    let limits = Panel::new(
        "(b) *β*_lim at *r* = 1",
        zeta(),
        Axis::new("*β*_lim", 0.66, 0.8),
    )
    .with(Guide::new(Across::Y(FRAC_PI_4)))
    .with(Note::new("π/4", (1.2e-4, FRAC_PI_4 + 0.004), Anchor::Start))
    .with(line(
        "exact",
        part_colour(0),
        Stroke::Solid,
        exact.collect(),
    ))
    .with(line(
        "estimate (7.62)",
        part_colour(1),
        Stroke::Dashed,
        spread(low, high).map(printed).collect(),
    ));
    Ok(Figure::new("7.8", "Resonance of one damped mass over its damping", 2, vec![panel, limits])
        .with_sketch(with_dashpot())
        .with_caption(
            "*μ* = 1. Each curve of (a) has as much friction as its *β* says and ends where the contact begins to stop. (b) That limit stays near π/4 up \
             to about *ζ* = 0.01; the estimate, which leaves out the force of breaking away, is too high beyond.",
        ))
}

/// Figure 7.9: amplitudes at resonance over the friction ratio.
pub fn over_friction() -> Drawn {
    let beta = || Axis::new("friction ratio *β*", 0.0, 0.8);
    let light = one_mass(0.01);
    let most = limit(&light).ok_or("no limit")?;
    let places =
        |most: f64| (0..=STEPS).map(move |i| most * (1.0 - 1e-9) * f64::from(i) / f64::from(STEPS));
    let estimate = |system: &System, beta| system.resonant_peak_estimate(0, 0, beta);
    let beyond = |read: &dyn Fn(f64) -> Option<f64>| -> Vec<Point> {
        let place = |beta: f64| Some((beta, read(beta)? - estimate(&light, beta)?));
        places(most).filter_map(place).collect()
    };
    let same = beyond(&|beta| at_resonance(&light, 1.0, beta));
    let largest = beyond(&|beta| peak(&light, beta));
    let compared = Panel::new(
        "(a) beyond the estimate, *ζ* = 0.01",
        beta(),
        Axis::log("exact *X̄* − estimate", 1e-4, 1.0),
    )
    .with(line("at *r* = 1", part_colour(0), Stroke::Solid, same))
    .with(line(
        "largest near *r* = 1",
        part_colour(1),
        Stroke::DashDot,
        largest,
    ));
    let mut varying = Panel::new("(b) estimate (7.61)", beta(), Axis::new("*X̄*", 0.0, 55.0));
    for (index, zeta) in [0.01, 0.02, 0.05, 0.1].into_iter().enumerate() {
        let system = one_mass(zeta);
        let most = limit(&system).ok_or("no limit")?;
        let points = places(most).filter_map(|beta| Some((beta, estimate(&system, beta)?)));
        let colour = Colour::Series(index);
        varying = varying.with(line(
            &format!("*ζ* = {zeta}"),
            colour,
            Stroke::Solid,
            points.collect(),
        ));
    }
    Ok(Figure::new("7.9", "Resonance of one damped mass over friction", 2, vec![compared, varying])
        .with_sketch(with_dashpot())
        .with_caption(
            "*μ* = 1. (b) The estimated amplitude falls evenly with *β*, to where the contact begins to stop. (a) The exact one differs so little that \
             only the difference shows: a few thousandths at *r* = 1, and up to 0.8 for the largest near the limit, where *X̄* itself is below 2.",
        ))
}

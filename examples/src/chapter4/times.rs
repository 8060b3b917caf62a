//! Motions at β = 0.2 in time and by their harmonics.

use crate::{PLATE, drawn, fixed};
use frictiongen_examples::draw::{Times, cycle, from_rest, keys, part_colour};
use frictiongen_plot::{Across, Axis, Figure, Guide, Line, Marker, Markers, Panel, Stroke};
use std::error::Error;
use std::f64::consts::TAU;

const BETA: f64 = 0.2;
/// Title, r, μ.
const CASES: [(&str, f64, f64); 4] = [
    ("(a) *r* = 0.12", 0.12, 1.0),
    ("(b) *r* = 0.5", 0.5, 1.0),
    ("(c) *r* = 0.8", 0.8, 1.0),
    ("(d) *r* = 1.25", 1.25, 1.0),
];
/// The static friction with which one stop a cycle is seen in (b).
const STICTION: f64 = 1.2;
const HARMONICS: u32 = 12;

/// 4.12: time responses.
pub fn motions() -> Result<Figure, Box<dyn Error>> {
    let times = Times {
        span: (0.0, 2.0 * TAU),
        circles: TAU / 24.0,
        excitation: true,
    };
    let parts = [("plate *x̄*", PLATE, part_colour(0))];
    let mut panels = Vec::new();
    for (title, r, stiction) in CASES {
        let system = fixed(stiction);
        let mut panel = cycle(title, &system, (r, BETA), &parts, times).ok_or("no motion")?;
        if r == 0.5 {
            panel = panel.with(one_stop()?);
            (panel.y.low, panel.y.high) = (-1.65, 1.65);
        }
        panels.push(panel);
    }
    Ok(Figure::new("4.12", "Steady motions at *β* = 0.2", 2, panels)
        .with_sketch(drawn(&fixed(1.0)))
        .with_keys(keys())
        .with_caption(
            "Fixed wall, *μ* = 1, two cycles; the thesis shows four such motions beside measured ones without stating all *r*. \
             In (b) the symmetric motion (line) is one of a continuum, and from rest another is reached (circles); with \
             *μ* = 1.2 the plate stops once a cycle (green), as the measured one does.",
        ))
}

/// The steady state from rest at r = 1/2 with more static friction, its time counted as in the symmetric motion.
fn one_stop() -> Result<Line, Box<dyn Error>> {
    let symmetric = fixed(1.0);
    let origin = symmetric.at(0.5)?.motion(BETA)?.contact().phase();
    let count = 480;
    let taus = (0..=count).map(|i| 2.0 * TAU * f64::from(i) / f64::from(count));
    let taus: Vec<f64> = taus.collect();
    let angles: Vec<f64> = taus
        .iter()
        .map(|tau| tau + origin.rem_euclid(TAU))
        .collect();
    let system = fixed(STICTION);
    let motion = from_rest(&system, (0.5, BETA), &[PLATE], &angles).ok_or("no run")?;
    let points = taus.into_iter().zip(motion.into_iter().flatten()).collect();
    Ok(Line::new(
        "*r* = 0.5, *μ* = 1.2",
        part_colour(2),
        Stroke::Solid,
        vec![points],
    ))
}

/// 4.13: their harmonics.
pub fn spectra() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for (title, r, stiction) in CASES {
        let x = Axis::new("harmonic *n*", 0.0, f64::from(HARMONICS));
        let y = Axis::new("|*X̄*_n| (dB)", -80.0, 10.0);
        let mut panel = Panel::new(title, x, y).with(Guide::new(Across::Y(0.0)));
        let levels = levels(r, stiction)?;
        let stems = levels
            .iter()
            .map(|(n, level)| vec![(*n, -80.0), (*n, *level)]);
        panel = panel.with(Line::unnamed(
            part_colour(0),
            Stroke::Solid,
            stems.collect(),
        ));
        panel = panel.with(Markers::new("*μ* = 1", part_colour(0), Marker::Dot, levels));
        if r == 0.5 {
            let levels = self::levels(r, STICTION)?;
            panel = panel.with(Markers::new(
                "*r* = 0.5, *μ* = 1.2",
                part_colour(2),
                Marker::Square,
                levels,
            ));
        }
        panels.push(panel);
    }
    Ok(Figure::new("4.13", "Harmonics of the steady motions at *β* = 0.2", 2, panels)
        .with_sketch(drawn(&fixed(1.0)))
        .with_caption(
            "The motions of figure 4.12 as reached from rest; 0 dB is the motion *Y* of the base, and levels below −78 dB are \
             left out. Friction puts in odd harmonics; even ones show that a motion is not symmetric.",
        ))
}

/// The levels in dB of the harmonics of a run from rest, from the mean on.
fn levels(r: f64, stiction: f64) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let count = 4096;
    let angles: Vec<f64> = (0..count)
        .map(|i| TAU * f64::from(i) / f64::from(count))
        .collect();
    let system = fixed(stiction);
    let motions = from_rest(&system, (r, BETA), &[PLATE], &angles).ok_or("no run")?;
    let motion = motions.first().ok_or("no motion")?;
    let level = |n: u32| {
        let angle = |i: usize| f64::from(n) * angles[i];
        let sum = |of: fn(f64) -> f64| -> f64 {
            let terms = motion.iter().enumerate().map(|(i, x)| x * of(angle(i)));
            terms.sum()
        };
        let share = if n == 0 { 1.0 } else { 2.0 } / f64::from(count);
        let size = share * sum(f64::cos).hypot(sum(f64::sin));
        (f64::from(n), 20.0 * size.log10())
    };
    Ok((0..=HARMONICS)
        .map(level)
        .filter(|(_, level)| -78.0 < *level)
        .collect())
}

//! Figures of five equal masses. The lowest mass is loaded, and one mass rubs on a fixed wall.

use super::systems::{FIVE, five, motions};
use frictiongen::System;
use frictiongen_examples::draw::{
    Responses, Row, Times, cycle, drawn, keys, map, over_r1, part_colour, places, strokes, tidy,
    without_specks,
};
use frictiongen_plot::desk::{Drawn as Curve, Reading, Scales, lines};
use frictiongen_plot::{Axis, Figure, Fill, Layer, Marker, Markers, Panel, Region};
use std::error::Error;
use std::f64::consts::PI;

type Drawn = Result<Figure, Box<dyn Error>>;

const LOW: [f64; 5] = [0.0, 0.2, 0.4, 0.6, 0.8];
const MIDDLE: [f64; 6] = [0.0, 0.2, 0.4, 0.6, 1.0, 2.0];
const NAMES: [&str; 5] = ["*x̄*_1", "*x̄*_2", "*x̄*_3", "*x̄*_4", "*x̄*_5"];

/// Returns panels with the amplitudes or the phases of all five masses over the frequency ratio.
fn all(
    system: &System,
    (betas, stuck): (&[f64], bool),
    phases: bool,
    sizes: (f64, f64),
) -> Result<Vec<Panel>, Box<dyn Error>> {
    let mut responses = Responses::up_to(1e4, 1e-3, system, (0.2, 2.5), betas, &FIVE)?;
    if phases {
        // In a motion with stops the largest displacement lasts for a while. The lag of this maximum is then not
        // informative.
        responses = responses.sliding_or_stuck();
    }
    let panels = (0..FIVE.len()).map(|part| {
        let name = format!("*m*_{}", part + 1);
        let labels = [
            format!("*X̄*_{}", part + 1),
            format!("*φ*_{} (degrees)", part + 1),
        ];
        let row = Row {
            part,
            titles: [&name, &name],
            labels: [&labels[0], &labels[1]],
            sizes,
            stuck,
            limit_from: if phases { 0.6 } else { 0.3 },
            circles: 0.0,
            harmonic: false,
        };
        if phases {
            row.phase(&responses)
        } else {
            row.amplitude(&responses)
        }
    });
    Ok(panels.collect())
}

/// Figure 6.8a: amplitudes with load and contact on m₁.
pub fn low_amplitudes() -> Drawn {
    let system = five(1);
    let panels = all(&system, (&LOW, false), false, (0.01, 200.0))?;
    Ok(Figure::new("6.8a", "Five masses, load and contact on the lowest: amplitudes", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(false, false))
        .with_caption(
            "Equal masses and springs, *μ* = 1. The five resonances are finite for *β* = 0.8 only, and nearly everywhere more \
             friction means less motion.",
        ))
}

/// Figure 6.8b: phases with load and contact on m₁.
pub fn low_phases() -> Drawn {
    let system = five(1);
    let panels = all(&system, (&LOW, false), true, (0.0, 1.0))?;
    Ok(Figure::new("6.8b", "Five masses, load and contact on the lowest: phases", 2, panels)
        .with_sketch(drawn(&system))
        .with_caption(
            "Motions without stops, equal masses and springs, *μ* = 1. Each mass moves nearly in step with *m*_1 or against it; at a resonance the phase \
             jumps, and the more friction, the less.",
        ))
}

/// Figure 6.15a: amplitudes with the contact on m₃.
pub fn middle_amplitudes() -> Drawn {
    let system = five(3);
    let panels = all(&system, (&MIDDLE, true), false, (0.0, 5.0))?;
    Ok(Figure::new("6.15a", "Five masses, load on the lowest, contact on the middle one: amplitudes", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, false))
        .with_caption(
            "Equal masses and springs, *μ* = 1. Friction lowers the resonances of *m*_3 to *m*_5, and raises *m*_1 and *m*_2 \
             between them to the two resonances of the stuck system, at *r*_1 = 1 and √3.",
        ))
}

/// Figure 6.15b: phases with the contact on m₃.
pub fn middle_phases() -> Drawn {
    let system = five(3);
    let panels = all(&system, (&MIDDLE, true), true, (0.0, 1.0))?;
    Ok(Figure::new("6.15b", "Five masses, load on the lowest, contact on the middle one: phases", 2, panels)
        .with_sketch(drawn(&system))
        .with_caption(
            "Motions without stops, and stuck, equal masses and springs, *μ* = 1. *m*_4 and *m*_5 move in step with *m*_3 or against it; *m*_1 and *m*_2, between \
             load and contact, have phases of their own.",
        ))
}

/// Returns two panels: the motion of all masses over half a cycle, and their phases at β = 0.4 over shaded regimes.
fn motion(system: &System, at: (f64, f64)) -> Result<Vec<Panel>, Box<dyn Error>> {
    let times = Times {
        span: (0.0, PI),
        circles: PI / 20.0,
        excitation: true,
    };
    let title = format!("(a) *r*_1 = {}, *β* = {}", at.0, at.1);
    let cycle = cycle(&title, system, at, &motions(&NAMES), times);
    let mut phases = phases(system)?;
    phases.height = Some(360.0);
    Ok(vec![cycle.ok_or("no motion")?, phases])
}

/// Returns a panel with the phases of all masses over the frequency ratio, at β = 0.4.
fn phases(system: &System) -> Result<Panel, Box<dyn Error>> {
    let (low, high) = (-190.0, 190.0);
    let beta = 0.4;
    let responses = Responses::up_to(1e4, 1e-3, system, (0.2, 2.5), &[beta], &FIVE)?.continuous();
    let x = Axis::new("", 0.0, 2.5);
    let y = Axis::new("*φ_i* (degrees)", low, high).degrees();
    let mut panel = over_r1(Panel::new("(b) *β* = 0.4", x, y));
    let limits = places(system, (1e-3, 2.5));
    let slips =
        |limits: &frictiongen::Limits<f64>| limits.continuous <= beta && beta < limits.sliding;
    let sticks = |limits: &frictiongen::Limits<f64>| limits.sliding <= beta;
    for (name, fill, holds) in [
        (
            "stick-slip",
            1,
            &slips as &dyn Fn(&frictiongen::Limits<f64>) -> bool,
        ),
        ("stuck", 2, &sticks),
    ] {
        let mut areas: Vec<Vec<(f64, f64)>> = Vec::new();
        let mut start: Option<f64> = None;
        let mut last = limits.first().map_or(0.0, |place| place.0);
        for (r, limits) in &limits {
            match (start, holds(limits)) {
                (None, true) => start = Some(0.5 * (last + r)),
                (Some(from), false) => {
                    areas.push(band(from, 0.5 * (last + r), (low, high)));
                    start = None;
                }
                _ => {}
            }
            last = *r;
        }
        if let Some(from) = start {
            areas.push(band(from, 2.5, (low, high)));
        }
        if !areas.is_empty() {
            panel = panel.with(Region::new(name, Fill::Class(fill), areas));
        }
    }
    for (part, _) in FIVE.iter().enumerate() {
        for curve in responses.curves() {
            let drawn = Curve {
                curve,
                name: NAMES[part].into(),
                colour: part_colour(part),
            };
            let scales = Scales::groups(system);
            panel
                .layers
                .extend(lines(&drawn, part, Reading::Phase, &scales));
        }
    }
    let mut panel = without_specks(panel);
    for (part, _) in FIVE.iter().enumerate() {
        for layer in responses.simulation(0.1, part, Reading::Phase) {
            if let Layer::Markers(Markers { points, .. }) = layer {
                panel = panel.with(Markers::unnamed(part_colour(part), Marker::Circle, points));
            }
        }
    }
    Ok(tidy(panel))
}

fn band(from: f64, to: f64, (low, high): (f64, f64)) -> Vec<(f64, f64)> {
    vec![(from, low), (to, low), (to, high), (from, high)]
}

/// Figure 6.9: motion and phases with load and contact on m₁.
pub fn low_motion() -> Drawn {
    let system = five(1);
    let panels = motion(&system, (1.6, 0.6))?;
    Ok(Figure::new("6.9", "Five masses, load and contact on the lowest: motion and phases", 1, panels)
        .with_sketch(drawn(&system))
        .with_keys(keys())
        .with_caption(
            "Equal masses and springs, *μ* = 1. (a) From a maximum of *m*_1: all masses turn at nearly the same time. (b) Phases of motions \
             without stops; in the shaded ranges of *r*_1 the contact stops or is stuck.",
        ))
}

/// Figure 6.16: motion and phases with the contact on m₃.
pub fn middle_motion() -> Drawn {
    let system = five(3);
    let panels = motion(&system, (0.95, 0.4))?;
    Ok(Figure::new("6.16", "Five masses, load on the lowest, contact on the middle one: motion and phases", 1, panels)
        .with_sketch(drawn(&system))
        .with_keys(keys())
        .with_caption(
            "Equal masses and springs, *μ* = 1. (a) From a maximum of *m*_3, at *r*_1 and *β* that are chosen, as the text of the thesis \
             does not give them: the other masses turn earlier or later. (b) Phases of motions \
             without stops; in the shaded ranges of *r*_1 the contact stops or is stuck.",
        ))
}

/// Figure 6.10: regimes with load and contact on m₁.
pub fn low_regimes() -> Drawn {
    let system = five(1);
    Ok(Figure::new("6.10", "Motion regimes of five masses, load and contact on the lowest", 1, vec![map("", &system, 1.2)?])
        .with_sketch(drawn(&system))
        .with_caption(
            "Equal masses and springs, *μ* = 1. *β*_lim has a maximum of 0.82 to 0.87 beside each of the five resonances, and is zero \
             at the four antiresonances of *m*_1 between them.",
        ))
}

/// Figure 6.17: regimes with the contact on m₃.
pub fn middle_regimes() -> Drawn {
    let system = five(3);
    Ok(Figure::new("6.17", "Motion regimes of five masses, load on the lowest, contact on the middle one", 1, vec![map("", &system, 3.0)?])
        .with_sketch(drawn(&system))
        .with_caption(
            "Equal masses and springs, *μ* = 1. Beside *r*_1 = 1 and √3, the resonances of the stuck system, no friction keeps the \
             contact at rest; both limits go to zero at high frequency.",
        ))
}

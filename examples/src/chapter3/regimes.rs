//! Figures of the regimes over frequency ratio and friction ratio.

use crate::{drawn, joined};
use frictiongen::System;
use frictiongen::study::map::MapRequest;
use frictiongen_examples::draw::{part_colour, tidy};
use frictiongen_plot::desk::{self, Scales, Shade, map_panel};
use frictiongen_plot::{
    Across, Axis, Colour, Figure, Guide, Inset, Layer, Line, Panel, Point, Stroke,
};
use std::error::Error;
use std::f64::consts::PI;

const TO: f64 = 2.5;
const TOP: f64 = 4.0;
/// Number of poles of the velocity constraint S that the figure contains. The last one is at r = 1/31.
const POLES: u32 = 15;
/// Number of poles of S that the figure marks with a grey line.
const GUIDES: u32 = 6;

/// Figure 3.3: the velocity constraint S (2.27), computed from Z̄ = βS/r² (3.16) on the limit of continuous motion.
pub fn constraint() -> Result<Figure, Box<dyn Error>> {
    let system = joined(1.0);
    let value = |r: f64| -> Option<f64> {
        let at = system.at(r).ok()?;
        let limit = at.continuous_limit();
        let amplitude = (*at).clone().closed_form(limit).contact().amplitude();
        Some(r * r * amplitude / limit).filter(|value| value.is_finite())
    };
    // The response U to a square wave of friction has its poles at the odd fractions of the resonance, r = 1/(2i + 1).
    // S is drawn in one piece between two poles.
    let pole = |i: u32| 1.0 / f64::from(2 * i + 1);
    let mut ends: Vec<f64> = (1..=POLES).rev().map(pole).collect();
    ends.push(TO);
    let count = 400;
    let pieces = ends.windows(2).map(|pair| {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let place = |i: i32| middle - half * (PI * f64::from(i) / f64::from(count)).cos();
        let last = if pair[1] == TO { count } else { count - 1 };
        let points = (1..=last).map(place).filter_map(|r| Some((r, value(r)?)));
        points.collect::<Vec<Point>>()
    });
    let line = Line::new("*S*", part_colour(0), Stroke::Solid, pieces.collect());
    let x = Axis::new("frequency ratio *r*", 0.0, 1.0);
    let panel = Panel::new("", x, Axis::new("*S*", 0.0, 6.0));
    let guides = (1..=GUIDES).map(|i| Guide::new(Across::X(pole(i))));
    let panel = tidy(guides.fold(panel, Panel::with).with(line));
    Ok(Figure::new("3.3", "The function *S*", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_caption(
            "A motion is continuous only if its amplitude is above *βS*/*r*^2. *S* is 1 from *r* = 1/2 on, and nowhere \
             less; it has poles at *r* = 1/3, 1/5, 1/7, … (grey down to 1/13), where any friction ends the continuous motion. \
             It is drawn from *r* = 1/31 on: below, its poles crowd.",
        ))
}

fn panel(title: &str, system: &System) -> Result<Panel, Box<dyn Error>> {
    let lines = system.limit_lines(0.0, TO, 1e-4)?;
    Ok(desk::regimes(title, &lines, TOP, &Scales::groups(system)))
}

/// Figure 3.4: regimes over frequency ratio and friction ratio.
pub fn map() -> Result<Figure, Box<dyn Error>> {
    let system = joined(1.0);
    let lines = system.limit_lines(0.0, 1.0, 1e-4)?;
    let mut inner = desk::regimes("", &lines, 1.0, &Scales::groups(&system));
    (inner.x.label, inner.y.label) = ("".into(), "".into());
    for layer in &mut inner.layers {
        // The inset covers the name of one regime, but has room for this name. The outer panel has the names of the
        // remaining regimes.
        if let Layer::Region(region) = layer
            && region.name.plain() != "stuck"
        {
            region.name = "".into();
        }
    }
    let inset = Inset {
        place: (0.09, 0.08, 0.38, 0.46),
        marked: true,
        panel: inner,
    };
    let panel = panel("", &system)?.with_inset(inset);
    Ok(Figure::new("3.4", "Motion regimes, the wall on the base", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_caption(
            "*β* = *F*/(*kY*), *μ* = 1. The mass is stuck above *β* = *r*². Both limits grow with *r*, and the region of \
             motions with stops between them is narrow; it is widest at *r* = 0.56 below the resonance.",
        ))
}

/// Figure 3.5: regimes for several ratios μ of static to kinetic friction.
pub fn stiction() -> Result<Figure, Box<dyn Error>> {
    let titles = [
        (1.0, "(a) *μ* = 1"),
        (1.2, "(b) *μ* = 1.2"),
        (1.5, "(c) *μ* = 1.5"),
        (2.0, "(d) *μ* = 2"),
    ];
    let panels = titles.map(|(stiction, title)| panel(title, &joined(stiction)));
    let panels = panels.into_iter().collect::<Result<_, _>>()?;
    Ok(Figure::new("3.5", "Motion regimes for static over kinetic friction *μ*", 2, panels)
        .with_sketch(drawn(&joined(1.0)))
        .with_caption(
            "*β* = *F*/(*kY*). With more static friction both limits fall, the limit of permanent sticking, *r*²/*μ*, faster: \
             from about *μ* = 1.2 on they cross. Where *r*²/*μ* is the lower one, the mass may slide all the time or be stuck, \
             as it starts; the thesis draws that wedge as stuck.",
        ))
}

/// Returns a panel with the number of stops in a cycle over a grid of r and β. Lines show β_lim and β*_lim.
fn counted(
    title: &str,
    stiction: f64,
    r: (f64, f64, u32),
    beta: (f64, u32),
) -> Result<Panel, Box<dyn Error>> {
    let system = joined(stiction);
    let step = (r.1 - r.0) / f64::from(r.2);
    let request = MapRequest {
        r: (0..r.2)
            .map(|i| r.0 + step * (f64::from(i) + 0.5))
            .collect(),
        beta: (0..beta.1)
            .map(|i| beta.0 * (f64::from(i) + 0.5) / f64::from(beta.1))
            .collect(),
        of: Vec::new(),
    };
    let map = system.map(&request, |_| true)?;
    let lines = system.limit_lines(r.0, r.1, 1e-4)?;
    let scales = Scales::groups(&system);
    let mut panel = map_panel(title, &map, &lines, &[], Shade::Stops, &scales);
    (panel.x.low, panel.x.high) = (r.0, r.1);
    (panel.y.low, panel.y.high) = (0.0, beta.0);
    Ok(panel)
}

/// Figure 3.12: number of stops in a cycle over r and β.
pub fn stops() -> Result<Figure, Box<dyn Error>> {
    let of = |title, stiction| counted(title, stiction, (0.0, TO, 125), (TOP, 200));
    let panels = vec![of("(a) *μ* = 1", 1.0)?, of("(b) *μ* = 1.5", 1.5)?];
    Ok(Figure::new("3.12", "How often the mass stops in a cycle", 2, panels)
        .with_sketch(drawn(&joined(1.0)))
        .with_caption(
            "The steady state that is reached from rest, at each of 125 by 200 places; the lines are the exact limits. \
             Between them two stops are the rule. With *μ* = 1.5 the limits cross; between the crossings a motion without stops \
             and a stuck state exist side by side, and the cells show in which of them motion from rest ends.",
        ))
}

/// Figure 3.13: number of stops in a cycle over r and β, for small r and β.
pub fn few_stops() -> Result<Figure, Box<dyn Error>> {
    let of = |title, stiction| counted(title, stiction, (0.1, 0.7, 120), (0.3, 120));
    let panels = vec![
        of("(a) *μ* = 1", 1.0)?,
        of("(b) *μ* = 1.2", 1.2)?,
        of("(c) *μ* = 1.5", 1.5)?,
        of("(d) *μ* = 2", 2.0)?,
    ];
    let panels = panels.into_iter().map(|panel| panel.with(half())).collect();
    Ok(Figure::new("3.13", "How often the mass stops in a cycle, at low frequency", 2, panels)
        .with_sketch(drawn(&joined(1.0)))
        .with_caption(
            "Detail of figure 3.12. With *μ* above 1 motions with one stop, which are not symmetric, spread from *r* = 1/2 \
             (dashed grey); the more static friction, the farther. \
             Light green are motions that repeat after several cycles only, or not at all.",
        ))
}

fn half() -> Guide {
    Guide {
        stroke: Stroke::Dashed,
        colour: Colour::Grey,
        ..Guide::new(Across::X(0.5))
    }
}

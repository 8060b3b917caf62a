//! The rig of 6.4 and 6.5.3: two storeys on a base that moves.

use super::systems::{M1, M2, rig};
use frictiongen::{Of, System};
use frictiongen_examples::draw::{Responses, Row, drawn, part_colour, strokes, tidy};
use frictiongen_plot::{Across, Anchor, Axis, Figure, Guide, Line, Note, Panel, Sketch, Stroke};
use std::error::Error;

type Drawn = Result<Figure, Box<dyn Error>>;

/// r₁ for each Hz.
const SECONDS: f64 = 0.3419;
const GAMMA: f64 = 0.9772;
const KAPPA: f64 = 1.1119;

/// 6.19: what the parameters were found from.
pub fn without_friction() -> Drawn {
    let system = rig("m1 - base");
    let parts = [
        ("*X̄*_1, lower mass", M1),
        ("*Z̄*, lower mass and base", Of::Contact),
    ];
    let mut panel = Panel::new(
        "",
        Axis::new("frequency (Hz)", 0.0, 8.0),
        Axis::log("amplitude over *Y*", 1e-3, 1e3),
    );
    let antiresonance = (KAPPA / GAMMA).sqrt();
    let relative = (KAPPA * (1.0 + GAMMA) / GAMMA).sqrt();
    let resonances = system.resonances();
    let [first, second] = [0, 1].map(|i| resonances.get(i).copied().unwrap_or(f64::NAN));
    let guides = [
        ("*f*_1", first),
        ("*f*_0", antiresonance),
        ("*f*_{*z*0}", relative),
        ("*f*_2", second),
    ];
    for (name, r) in guides {
        let hertz = r / SECONDS;
        panel = panel.with(Guide::new(Across::X(hertz))).with(Note::new(
            name,
            (hertz + 0.06, 350.0),
            Anchor::Start,
        ));
    }
    for (index, (name, of)) in parts.into_iter().enumerate() {
        let stroke = if index == 0 {
            Stroke::Solid
        } else {
            Stroke::Dashed
        };
        let pieces = undamped(&system, of, &guides.map(|guide| guide.1));
        panel = panel.with(Line::new(name, part_colour(index), stroke, pieces));
    }
    let said = guides.map(|(name, r)| format!("{name} = {:.2} Hz", r / SECONDS));
    let sketch = Sketch {
        contact: None,
        ..drawn(&system)
    };
    Ok(Figure::new("6.19", "The rig without friction", 1, vec![tidy(panel)])
        .with_sketch(sketch)
        .with_caption(format!(
            "Theory for *γ* = 0.9772, *κ* = 1.1119, *r*_1 = 0.3419 s × frequency in Hz. Two resonances and two antiresonances, of \
             the lower mass and of its motion relative to the base, give all three parameters: {}. The measured points are not in the text \
             of the thesis.",
             said.join(", "),
        )))
}

/// An amplitude without friction, between the places where it has none or no end.
fn undamped(system: &System, of: Of, marks: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let steps = 800;
    let width = 8.0 * SECONDS;
    let mut ends: Vec<f64> = marks.iter().copied().chain([0.0, width]).collect();
    ends.sort_by(f64::total_cmp);
    let mut pieces = Vec::new();
    for pair in ends.windows(2) {
        let &[from, to] = pair else { continue };
        // Closer and closer to both ends.
        let place = |i: u32| {
            let share = f64::from(i) / f64::from(steps);
            from + (to - from) * 0.5 * (1.0 + (6.0 * (2.0 * share - 1.0)).tanh() / 6.0_f64.tanh())
        };
        let read = |r: f64| {
            let swing = system.at(r).ok()?.response(0.0).ok()?.swing(of)?;
            (0.0 < swing.amplitude).then_some((r / SECONDS, swing.amplitude))
        };
        pieces.push((1..steps).filter_map(|i| read(place(i))).collect());
    }
    pieces
}

/// A row of the first harmonic.
fn row<'a>(part: usize, titles: [&'a str; 2], labels: [&'a str; 2], ends: (f64, f64)) -> Row<'a> {
    Row {
        part,
        titles,
        labels,
        sizes: (0.0, 5.0),
        ends,
        stuck: true,
        limit_from: 0.2,
        circles: 0.0,
        harmonic: true,
    }
}

/// Amplitudes and phases of both masses.
fn rows(responses: &Responses<'_>, ends: [(f64, f64); 2]) -> Vec<Panel> {
    let lower = row(
        0,
        ["(a) *m*_1, amplitude", "(a) *m*_1, phase"],
        ["*X̄*_{1,fft}", "*φ*_{1,fft} (degrees)"],
        ends[0],
    );
    let upper = row(
        1,
        ["(b) *m*_2, amplitude", "(b) *m*_2, phase"],
        ["*X̄*_{2,fft}", "*φ*_{2,fft} (degrees)"],
        ends[1],
    );
    let [lower, upper] = [lower.panels(responses), upper.panels(responses)];
    lower.into_iter().chain(upper).collect()
}

/// 6.20: contact of the lower mass with a fixed wall.
pub fn lower() -> Drawn {
    let system = rig("m1 - wall");
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &[0.2, 0.4, 0.6], &[M1, M2])?;
    let panels = rows(&responses, [(-45.0, 190.0), (-45.0, 370.0)]);
    Ok(Figure::new("6.20", "The rig, contact of the lower mass with a fixed wall", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(false, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. The phase of *m*_1 hardly depends on frequency between \
             its jumps, so that *β* can be read off it; *m*_2 moves with *m*_1, then against it.",
        ))
}

/// 6.21: contact of the upper mass with a fixed wall.
pub fn upper() -> Drawn {
    let system = rig("m2 - wall");
    let betas = [0.2, 0.5, 1.0, 1.5, 2.0];
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &betas, &[M1, M2])?;
    let panels = rows(&responses, [(-45.0, 190.0), (-45.0, 370.0)]);
    Ok(Figure::new("6.21", "The rig, contact of the upper mass with a fixed wall", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. Near *r*_1 = 1.45 the motion of *m*_2 does not depend on \
             friction, and *m*_1 moves the more the firmer *m*_2 is held.",
        ))
}

const BETAS: [f64; 4] = [0.5, 0.75, 1.0, 2.0];

/// 6.28: contact of the lower mass with the base.
pub fn joined() -> Drawn {
    let system = rig("m1 - base");
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &BETAS, &[M1, M2])?;
    let panels = rows(&responses, [(-90.0, 190.0), (-45.0, 370.0)]);
    Ok(Figure::new("6.28", "The rig, contact of the lower mass with the base", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. At low frequency *m*_1 is stuck to the base and moves with \
             it; from *β* = π/4 on the resonances are finite.",
        ))
}

/// 6.29: the relative motion in that contact.
pub fn relative() -> Drawn {
    let system = rig("m1 - base");
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &BETAS, &[Of::Contact])?;
    let row = row(
        0,
        ["(a) amplitude", "(b) phase"],
        ["*Z̄*_{fft}", "*φ*_{*z*,fft} (degrees)"],
        (-45.0, 370.0),
    );
    Ok(Figure::new("6.29", "The rig, motion of the lower mass relative to the base", 2, row.panels(&responses).into())
        .with_sketch(drawn(&system))
        .with_keys(strokes(false, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. Where the contact is stuck there is no relative motion, \
             and no phase.",
        ))
}

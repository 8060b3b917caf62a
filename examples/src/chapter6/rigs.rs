//! Figures of the rig of sections 6.4 and 6.5.3 with friction: two storeys on a moving base.

use super::systems::{M1, M2, rig};
use frictiongen::Of;
use frictiongen_examples::draw::{Responses, Row, drawn, strokes};
use frictiongen_plot::{Figure, Panel};
use std::error::Error;

type Drawn = Result<Figure, Box<dyn Error>>;

/// Returns the settings of a row of two panels: amplitude and phase of the first harmonic of a motion.
fn row<'a>(part: usize, titles: [&'a str; 2], labels: [&'a str; 2]) -> Row<'a> {
    Row {
        part,
        titles,
        labels,
        sizes: (0.0, 5.0),
        stuck: true,
        limit_from: 0.2,
        circles: 0.0,
        harmonic: true,
    }
}

/// Returns panels with the amplitudes and the phases of both masses over the frequency ratio.
fn rows(responses: &Responses<'_>) -> Vec<Panel> {
    let lower = row(
        0,
        ["(a) *m*_1, amplitude", "(a) *m*_1, phase"],
        ["*X̄*_{1,fft}", "*φ*_{1,fft} (degrees)"],
    );
    let upper = row(
        1,
        ["(b) *m*_2, amplitude", "(b) *m*_2, phase"],
        ["*X̄*_{2,fft}", "*φ*_{2,fft} (degrees)"],
    );
    let [lower, upper] = [lower.panels(responses), upper.panels(responses)];
    lower.into_iter().chain(upper).collect()
}

/// Figure 6.20: contact of the lower mass with a fixed wall.
pub fn lower() -> Drawn {
    let system = rig("m1 - wall");
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &[0.2, 0.4, 0.6], &[M1, M2])?;
    let panels = rows(&responses);
    Ok(Figure::new("6.20", "The rig, contact of the lower mass with a fixed wall", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(false, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. The phase of *m*_1 hardly depends on frequency between \
             its jumps, so that *β* can be read off it; *m*_2 moves with *m*_1, then against it.",
        ))
}

/// Figure 6.21: contact of the upper mass with a fixed wall.
pub fn upper() -> Drawn {
    let system = rig("m2 - wall");
    let betas = [0.2, 0.5, 1.0, 1.5, 2.0];
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &betas, &[M1, M2])?;
    let panels = rows(&responses);
    Ok(Figure::new("6.21", "The rig, contact of the upper mass with a fixed wall", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. Near *r*_1 = 1.45 the motion of *m*_2 does not depend on \
             friction, and *m*_1 moves the more the firmer *m*_2 is held.",
        ))
}

const BETAS: [f64; 4] = [0.5, 0.75, 1.0, 2.0];

/// Figure 6.28: contact of the lower mass with the base.
pub fn joined() -> Drawn {
    let system = rig("m1 - base");
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &BETAS, &[M1, M2])?;
    let panels = rows(&responses);
    Ok(Figure::new("6.28", "The rig, contact of the lower mass with the base", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. At low frequency *m*_1 is stuck to the base and moves with \
             it; from *β* = π/4 on the resonances are finite.",
        ))
}

/// Figure 6.29: relative motion in the contact of the lower mass with the base.
pub fn relative() -> Drawn {
    let system = rig("m1 - base");
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &BETAS, &[Of::Contact])?;
    let row = row(
        0,
        ["(a) amplitude", "(b) phase"],
        ["*Z̄*_{fft}", "*φ*_{*z*,fft} (degrees)"],
    );
    Ok(Figure::new("6.29", "The rig, motion of the lower mass relative to the base", 2, row.panels(&responses).into())
        .with_sketch(drawn(&system))
        .with_keys(strokes(false, false))
        .with_caption(
            "First harmonic under base motion, *γ* = 0.9772, *κ* = 1.1119, *μ* = 1. Where the contact is stuck there is no relative motion, \
             and no phase.",
        ))
}

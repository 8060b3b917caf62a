//! Figures of contacts between two bodies that both move.

use super::systems::{M1, M2, between, joined};
use frictiongen::{Of, System};
use frictiongen_examples::draw::{Responses, Row, drawn, map, strokes};
use frictiongen_plot::{Figure, Panel};
use std::error::Error;

type Drawn = Result<Figure, Box<dyn Error>>;

/// Figure 6.22a: sketch of two masses that rub on each other.
pub fn system_between() -> Drawn {
    Ok(Figure::new("6.22a", "Contact between two masses", 1, Vec::new())
        .with_sketch(drawn(&between()))
        .with_caption("The system of figures 6.23 and 6.24. A base that moves by *Y* = *P*/*k*_1 does the same as the load."))
}

/// Figure 6.22b: sketch of two masses, the lower one of which rubs on the moving base.
pub fn system_joined() -> Drawn {
    Ok(Figure::new(
        "6.22b",
        "Contact between a mass and the moving base",
        1,
        Vec::new(),
    )
    .with_sketch(drawn(&joined()))
    .with_caption("The system of figures 6.25, 6.26, 6.28 and 6.29: the wall moves with the base."))
}

/// Returns panels with the amplitudes of both masses, and with amplitude and phase of the relative motion.
fn panels(system: &System, betas: &[f64]) -> Result<Vec<Panel>, Box<dyn Error>> {
    let responses = Responses::up_to(1e4, 5e-4, system, (0.1, 2.5), betas, &[M1, M2, Of::Contact])?;
    let row = |part, titles, labels| Row {
        part,
        titles,
        labels,
        sizes: (0.0, 5.0),
        stuck: part < 2,
        limit_from: 0.2,
        circles: 0.1,
        harmonic: false,
    };
    let phase = "*φ_z* (degrees)";
    let relative = [
        "(b) relative motion, amplitude",
        "(b) relative motion, phase",
    ];
    Ok(vec![
        row(0, ["(a) *m*_1, amplitude", ""], ["*X̄*_1", ""]).amplitude(&responses),
        row(1, ["(a) *m*_2, amplitude", ""], ["*X̄*_2", ""]).amplitude(&responses),
        row(2, relative, ["*Z̄*", phase]).amplitude(&responses),
        row(2, relative, ["*Z̄*", phase]).phase(&responses),
    ])
}

/// Figure 6.23: responses with friction between the masses.
pub fn between_responses() -> Drawn {
    let system = between();
    let betas = [0.0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8];
    let panels = panels(&system, &betas)?;
    Ok(Figure::new("6.23", "Responses with friction between two masses", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, true))
        .with_caption(
            "*γ* = *κ* = 0.5, *μ* = 1. Between about *r*_1 = 0.77 and 1.23 more friction means more motion of the masses, up to the resonance \
             of both stuck together at √(2/3); the relative motion becomes smaller everywhere. Phases are of the largest displacement; where the contact stops there, of \
             the beginning of the stop.",
        ))
}

/// Figure 6.24: regimes with friction between the masses.
pub fn between_regimes() -> Drawn {
    let system = between();
    Ok(Figure::new("6.24", "Motion regimes with friction between two masses", 1, vec![map("", &system, 1.2)?])
        .with_sketch(drawn(&system))
        .with_caption(
            "*γ* = *κ* = 0.5, *μ* = 1. At low frequency the masses stick together; at high frequency *β*_lim tends to 0.179 and *β*_lim^* to \
             0.333.",
        ))
}

/// Figure 6.25: responses with the wall joined to the base.
pub fn joined_responses() -> Drawn {
    let system = joined();
    let betas = [0.2, 0.5, 0.8, 1.0, 1.5, 2.0];
    let panels = panels(&system, &betas)?;
    Ok(Figure::new("6.25", "Responses with a wall that moves with the base", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, true))
        .with_caption(
            "Equal masses and springs, *μ* = 1. At low frequency *m*_1 moves with the base and nothing slides; from *β* = π/4 on both resonances \
             are finite, and *m*_2 has that of the stuck system at *r*_1 = 1. Phases are of the largest displacement; where the contact \
             stops there, of the beginning of the stop.",
        ))
}

/// Figure 6.26: regimes with the wall joined to the base.
pub fn joined_regimes() -> Drawn {
    let system = joined();
    Ok(Figure::new("6.26", "Motion regimes with a wall that moves with the base", 1, vec![map("", &system, 4.0)?])
        .with_sketch(drawn(&system))
        .with_caption(
            "Equal masses and springs, *μ* = 1. Both limits grow as *r*_1^2 at high frequency; at *r*_1 = 1, the resonance of *m*_2 on a stuck \
             *m*_1, no friction keeps the contact at rest.",
        ))
}

//! Figures of amplitudes and phases over the frequency ratio.

use crate::{MASS, drawn, joined};
use frictiongen::Of;
use frictiongen_examples::draw::Responses;
use frictiongen_plot::desk::{self, Reading};
use frictiongen_plot::{Axis, Figure, Inset, Key, Marker, Panel};
use std::error::Error;

const CONTINUOUS: [f64; 7] = [0.0, 0.2, 0.5, 0.8, 1.0, 1.25, 1.5];
const ALL: [f64; 7] = [0.2, 0.5, 0.8, 1.0, 1.25, 1.5, 2.0];
const RANGE: (f64, f64) = (0.1, 2.5);

/// Figure 3.2: amplitude of the relative motion in the contact, over the frequency ratio.
pub fn relative() -> Result<Figure, Box<dyn Error>> {
    let system = joined(1.0);
    let responses = Responses::new(&system, RANGE, &CONTINUOUS, &[Of::Contact])?.continuous();
    let panels = vec![
        responses
            .amplitude("(a) amplitude", 0, "*Z̄*", 5.0)
            .with(responses.limit(0, Reading::Amplitude)),
        responses
            .phase("(b) phase", 0, "*φ*_z (degrees)", (-45.0, 190.0))
            .with(responses.limit(0, Reading::Phase)),
    ];
    Ok(Figure::new("3.2", "Relative motion in the contact, without stops", 2, panels)
        .with_sketch(drawn(&system))
        .with_caption(
            "*β* = *F*/(*kY*), *μ* = 1. From *β* = π/4 on the peak is finite and moves to higher *r*; for large *r* the mass \
             stands still and the relative motion is that of the base. The dashed line is drawn from *r* = 0.2 on.",
        ))
}

/// Figure 3.7: displacement transmissibility over the frequency ratio.
pub fn transmissibility() -> Result<Figure, Box<dyn Error>> {
    let system = joined(1.0);
    let responses = Responses::new(&system, RANGE, &CONTINUOUS, &[MASS])?.continuous();
    let near = Responses::new(&system, (1.35, 1.6), &CONTINUOUS, &[MASS])?.continuous();
    let panels = vec![
        responses
            .amplitude("(a)", 0, "*X̄*", 5.0)
            .with(responses.limit(0, Reading::Amplitude)),
        near.panel(
            "(b) where the curves change their order",
            0,
            Reading::Amplitude,
            ("*X̄*", Some((0.6, 1.25))),
        )
        .with(near.limit(0, Reading::Amplitude)),
    ];
    Ok(Figure::new("3.7", "Displacement transmissibility, without stops", 2, panels)
        .with_sketch(drawn(&system))
        .with_caption(
            "*X̄* is the amplitude of the mass over that of the base, *β* = *F*/(*kY*), *μ* = 1. Between *r* = 1.4 and 1.55 \
             the curves cross, not all in one point; beyond, friction makes the mass move more.",
        ))
}

/// Figure 3.8: phase of the mass over the frequency ratio.
pub fn phase() -> Result<Figure, Box<dyn Error>> {
    let system = joined(1.0);
    let responses = Responses::new(&system, RANGE, &CONTINUOUS, &[MASS])?.continuous();
    let panel = responses
        .phase("", 0, "*φ* (degrees)", (-15.0, 190.0))
        .with(responses.limit(0, Reading::Phase));
    Ok(Figure::new("3.8", "Lag of the mass behind the base, without stops", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_caption(
            "The lag between the maxima of base and mass, *μ* = 1. Without friction it jumps from 0 to 180° at the resonance; \
             beyond, the more friction the less the mass lags.",
        ))
}

/// Figure 3.14: responses in all regimes, compared with the event-driven simulation.
pub fn all_regimes() -> Result<Figure, Box<dyn Error>> {
    let system = joined(1.0);
    let of = [MASS, Of::Contact];
    let responses = Responses::new(&system, RANGE, &ALL, &of)?;
    let mut panels = Vec::new();
    for (part, title, label) in [(0, "(a) mass", "*X̄*"), (1, "(b) relative motion", "*Z̄*")] {
        let mut panel = responses.amplitude(title, part, label, 5.0);
        let lines = panel.layers.clone();
        panel
            .layers
            .extend(responses.simulation(0.1, part, Reading::Amplitude));
        if part == 0 {
            let mut inner = Panel::new("", Axis::new("", 0.9, 1.6), Axis::new("", 0.5, 1.75));
            inner.layers = lines;
            panel = panel.with_inset(Inset {
                place: (0.6, 0.06, 0.36, 0.45),
                marked: true,
                panel: inner,
            });
        }
        panels.push(panel);
    }
    Ok(Figure::new("3.14", "Amplitudes in all regimes", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(desk::keys())
        .with_keys([Key::marker("simulation from rest", Marker::Circle)])
        .with_caption(
            "*β* = *F*/(*kY*), *μ* = 1. Up to *r* = √*β* the mass is stuck and moves with its base; where it begins to slide \
             the transmissibility falls below 1. From *β* = 1.06 on no sliding motion exceeds that of the base.",
        ))
}

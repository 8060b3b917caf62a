//! Draws figures of curves with markers, an inset and degrees.

use crate::systems::two_masses;
use crate::{curve, damped};
use frictiongen_plot::{
    Across, Anchor, Axis, Colour, Figure, Guide, Inset, Key, Line, Marker, Markers, Note, Panel,
    Stroke,
};

fn regimes() -> [Key; 4] {
    [
        Key::stroke("continuous", Stroke::Solid),
        Key::stroke("stick-slip", Stroke::DashDot),
        Key::stroke("stuck", Stroke::Dotted),
        Key::marker("simulation", Marker::Circle),
    ]
}

/// Returns the figure of curves with markers, an inset and degrees.
pub fn responses() -> Figure {
    let x = || Axis::new("frequency ratio *r*_1", 0.0, 2.5);
    let mut amplitude = Panel::new(
        "**(a)** amplitude of *m*_1",
        x(),
        Axis::new("*X̄*_1", 0.0, 5.0),
    );
    let mut lag = Panel::new(
        "**(b)** lag of *m*_1",
        x(),
        Axis::new("*φ*_1, degrees", 0.0, 180.0).degrees(),
    );
    let mut detail = Panel::new("", Axis::new("", 0.9, 1.1), Axis::new("", 2.0, 6.0));
    for (index, zeta) in [0.02, 0.1, 0.2, 0.4].into_iter().enumerate() {
        let colour = Colour::Series(index);
        let name = format!("*β* = {zeta}");
        let pieces = |read: &dyn Fn(f64) -> f64, stroke| match stroke {
            Stroke::DashDot => vec![curve(0.02, 0.4, 400, read)],
            Stroke::Dotted => vec![curve(1.9, 2.5, 400, read)],
            _ => vec![curve(0.4, 1.9, 4000, read)],
        };
        for stroke in [Stroke::Solid, Stroke::DashDot, Stroke::Dotted] {
            let high = |r: f64| damped(r, zeta).0;
            let late = |r: f64| damped(r, zeta).1;
            amplitude = amplitude.with(Line::new(
                name.clone(),
                colour,
                stroke,
                pieces(&high, stroke),
            ));
            lag = lag.with(Line::new(
                name.clone(),
                colour,
                stroke,
                pieces(&late, stroke),
            ));
            detail = detail.with(Line::new(
                name.clone(),
                colour,
                stroke,
                pieces(&high, stroke),
            ));
        }
        let places = curve(0.15, 2.4, 15, |r| r);
        let marks = places
            .iter()
            .map(|(r, _)| (*r, damped(*r, zeta).0))
            .collect();
        amplitude = amplitude.with(Markers::unnamed(colour, Marker::Circle, marks));
        let marks = places
            .iter()
            .map(|(r, _)| (*r, damped(*r, zeta).1))
            .collect();
        lag = lag.with(Markers::unnamed(colour, Marker::Circle, marks));
    }
    let limit = curve(0.0, 2.5, 500, |r| 2.2 / (1.0 + r * r));
    amplitude = amplitude
        .with(Line::new(
            "at *β*_lim",
            Colour::Black,
            Stroke::Dashed,
            vec![limit],
        ))
        .with(Note::new("*P*_1", (0.99, 2.75), Anchor::Middle))
        .with_inset(Inset {
            place: (0.62, 0.08, 0.34, 0.42),
            marked: true,
            panel: detail,
        });
    lag = lag
        .with(Guide::new(Across::Y(90.0)))
        .with(Guide::new(Across::X(1.0)));
    Figure::new("6.6", "two masses, contact and load on *m*_1", 2, vec![amplitude, lag])
        .with_sketch(two_masses())
        .with_keys(regimes())
        .with_caption(
            "*γ* = *m*_2/*m*_1 = 1, *κ* = *k*_2/*k*_1 = 1, *β* = *F*/*P*. The inset shows the resonance; where \
             *X̄*_1 ≈ 0 the lag is left out.",
        )
}

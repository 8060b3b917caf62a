//! Draws figure 3.9: viscous damping in place of friction.

use frictiongen::Of;
use frictiongen_examples::draw::{block, variant_colour};
use frictiongen_plot::desk::sketch;
use frictiongen_plot::{
    Anchor, Axis, Colour, End, Figure, Line, Marker, Markers, Note, Panel, Point, Spring, Stroke,
};
use std::error::Error;
use std::f64::consts::SQRT_2;

/// Figure 3.9: displacement transmissibility with dashpots only.
pub fn dashpots() -> Result<Figure, Box<dyn Error>> {
    let x = Axis::new("frequency ratio *r*", 0.0, 2.5);
    let mut panel = Panel::new("", x, Axis::new("*X̄*", 0.0, 5.5));
    for (index, zeta) in [0.0, 0.1, 0.2, 0.5, 1.0].into_iter().enumerate() {
        let loaded = block("wall", "block", &format!("damping: modal({zeta:?}),"));
        // If the dashpot joins the block to the moving base, the relative motion is r² times the motion of a loaded
        // block.
        let value = |r: f64| -> Option<f64> {
            let x = loaded
                .at(r)
                .ok()?
                .response(0.0)
                .ok()?
                .harmonic(Of::Mass(0), 1)?;
            Some((1.0 + r * r * x.re).hypot(r * r * x.im))
        };
        let points = (1..=1000).map(|i| f64::from(i) * 0.0025);
        let points = points.map(|r| (r, value(r).unwrap_or(f64::NAN)));
        let mut pieces: Vec<Vec<Point>> = vec![Vec::new()];
        for (r, value) in points {
            // The line is interrupted at the resonance, and where the response lies far above the figure.
            if value < 50.0 {
                pieces.last_mut().expect("a piece").push((r, value));
            } else {
                pieces.push(Vec::new());
            }
        }
        pieces.retain(|piece| 1 < piece.len());
        let colour = match index {
            0 => Colour::Rgb(0x60, 0x60, 0x60),
            _ => variant_colour(index - 1),
        };
        let name = format!("*ζ* = {zeta}");
        panel = panel.with(Line::new(name, colour, Stroke::Solid, pieces));
    }
    let panel = panel
        .with(Markers::unnamed(
            Colour::Black,
            Marker::Dot,
            vec![(SQRT_2, 1.0)],
        ))
        .with(Note::new("*r* = √2, *X̄* = 1", (1.46, 1.17), Anchor::Start));
    let mut drawn = sketch(block("base", "base", "").scene(), false);
    drawn.contact = None;
    drawn.dashpots.push(Spring {
        between: (End::Base, End::Mass(0)),
        label: "*c*".into(),
    });
    Ok(Figure::new("3.9", "A dashpot in place of friction", 1, vec![panel])
        .with_sketch(drawn)
        .with_caption(
            "Displacement transmissibility with viscous damping *ζ* only. All curves cross in one point, with *X̄* = 1; with \
             friction (figure 3.7) they cross later, below 1, and not in one point.",
        ))
}

//! Draws figures of motions over time.

use crate::curve;
use crate::systems::base_driven;
use frictiongen_plot::{Axis, Colour, Figure, Fill, Key, Line, Panel, Stroke};
use std::f64::consts::PI;

/// Returns the figure with multiples of π, jumps, and values that are not finite.
pub fn times() -> Figure {
    let stuck = |tau: f64| (1.4 * tau.cos()).clamp(-1.0, 1.0);
    // A value that is not finite interrupts a line, so no line is drawn across a pole.
    let mut wild = curve(0.0, 0.5 * PI, 600, |tau| 0.4 * tau.tan());
    wild.push((0.5 * PI, f64::NAN));
    wild.extend(curve(0.501 * PI, 1.499 * PI, 600, |tau| 0.4 * tau.tan()));
    let last = curve(1.501 * PI, 2.0 * PI, 600, |tau| 0.4 * tau.tan());
    let panel = Panel::new(
        "",
        Axis::new("*τ*", 0.0, 2.0 * PI).in_pi(),
        Axis::fitted("*x̄*, *ȳ*", [-1.5, 1.5]),
    )
    .with(Line::new(
        "*x̄*_1(*τ*)",
        Colour::Series(0),
        Stroke::Solid,
        vec![curve(0.0, 2.0 * PI, 600, stuck)],
    ))
    .with(Line::new(
        "*ȳ*(*τ*)",
        Colour::Black,
        Stroke::Dashed,
        vec![curve(0.0, 2.0 * PI, 600, f64::cos)],
    ))
    .with(Line::new(
        "0.4 tan *τ*",
        Colour::Grey,
        Stroke::Thin,
        vec![wild, last],
    ));
    Figure::new(
        "4.12",
        "time response at *β* = 0.2, *r* = 0.6",
        1,
        vec![panel],
    )
    .with_keys([Key::fill("stuck", Fill::Class(2))])
    .with_sketch(base_driven())
}

//! Computes the response of the masses while the contact is stuck.

use frictiongen::study::units::polar;
use frictiongen::{Of, System};
use frictiongen_plot::desk::Reading;
use frictiongen_plot::{Colour, Line, Point, Stroke};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Number of intervals of a line between its points. A picture cannot show more.
const STEPS: u32 = 10_000;
/// Smallest amplitude that is drawn. A mass with a smaller amplitude counts as at rest.
const REST: f64 = 1e-9;
/// Largest difference of lag between neighbouring points that a line joins, in rad.
const TURN: f64 = 0.6;

/// Returns the response of a motion with the contact stuck, over a range of frequency ratios. It does not depend on
/// friction. If the mass is at rest while the contact is stuck, there is no line.
#[must_use]
pub fn stuck(system: &System, (from, to): (f64, f64), of: Of, reading: Reading) -> Line {
    let mut pieces: Vec<Vec<Point>> = vec![Vec::new()];
    let mut last: Option<f64> = None;
    for i in 0..=STEPS {
        let r = from + (to - from) * f64::from(i) / f64::from(STEPS);
        let Some((amplitude, lag)) = read(system, r, of) else {
            pieces.push(Vec::new());
            continue;
        };
        let near = lag - ((lag - last.unwrap_or(FRAC_PI_2)) / TAU).round() * TAU;
        let jumps = last.is_some_and(|last| TURN < (near - last).abs());
        // Without damping the lag jumps where the amplitude has a pole or a zero.
        if jumps {
            pieces.push(Vec::new());
        }
        last = Some(near);
        let value = match reading {
            reading if !reading.is_phase() => amplitude,
            _ => near.to_degrees(),
        };
        if let Some(piece) = pieces.last_mut() {
            piece.push((r, value));
        }
    }
    pieces.retain(|piece| 1 < piece.len());
    Line::new("stuck", Colour::Black, Stroke::Dotted, pieces)
}

fn read(system: &System, r: f64, of: Of) -> Option<(f64, f64)> {
    let Of::Mass(index) = of else {
        return None;
    };
    let x = system.at(r).ok()?.stuck().ok()?.mass_at(index)?;
    Some(polar(x)).filter(|(amplitude, _)| REST < *amplitude)
}

//! Computes the response at the limit of continuous motion.

use frictiongen::study::units::polar;
use frictiongen::{Of, System};
use frictiongen_plot::desk::Reading;
use frictiongen_plot::{Colour, Line, Point, Stroke};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Largest difference of lag between neighbouring points that a line joins, in rad.
const TURN: f64 = 0.6;
/// Points at which β_lim is below this value are left out. At single frequencies β_lim vanishes. The response there
/// is not that of neighbouring frequencies.
const VANISHING: f64 = 1e-6;

/// Returns frequency ratios in a range, each with its limits β_lim and β*_lim. They are densest where the curve of a
/// limit bends most.
#[must_use]
pub fn places(system: &System, (from, to): (f64, f64)) -> Vec<(f64, frictiongen::Limits<f64>)> {
    system
        .limit_lines(from, to, 5e-5)
        .map(|lines| lines.points)
        .unwrap_or_default()
}

/// Returns the response with friction at the limit, β = β_lim, over the frequency ratio. Only frequencies at which
/// β_lim is below β*_lim count, so that no stuck state exists.
#[must_use]
pub fn at_limit(system: &System, range: (f64, f64), of: Of, reading: Reading) -> Line {
    let mut pieces: Vec<Vec<Point>> = vec![Vec::new()];
    let mut last: Option<f64> = None;
    for (r, limits) in places(system, range) {
        if limits.continuous < VANISHING {
            continue;
        }
        let polar = (limits.continuous < limits.sliding)
            .then(|| read(system, r, limits.continuous, of, reading))
            .flatten();
        let Some((amplitude, lag)) = polar else {
            pieces.push(Vec::new());
            last = None;
            continue;
        };
        let value = match reading {
            reading if !reading.is_phase() => amplitude,
            _ => {
                let near = lag - ((lag - last.unwrap_or(FRAC_PI_2)) / TAU).round() * TAU;
                if last.is_some_and(|last| TURN < (near - last).abs()) {
                    pieces.push(Vec::new());
                }
                last = Some(near);
                near.to_degrees()
            }
        };
        if let Some(piece) = pieces.last_mut() {
            piece.push((r, value));
        }
    }
    pieces.retain(|piece| 1 < piece.len());
    Line::new("at *β*_lim", Colour::Black, Stroke::Dashed, pieces)
}

fn read(system: &System, r: f64, limit: f64, of: Of, reading: Reading) -> Option<(f64, f64)> {
    // The friction is just below β_lim. At β_lim itself the motion is no longer continuous.
    let response = system.at(r).ok()?.response(limit * (1.0 - 1e-13)).ok()?;
    match reading {
        Reading::Amplitude | Reading::Phase | Reading::Rate(_) => {
            let swing = response.swing(of)?;
            Some((swing.amplitude, swing.phase?))
        }
        Reading::Harmonic(_) | Reading::HarmonicPhase(_) => Some(polar(response.harmonic(of, 1)?)),
    }
}

//! Curve of a response over frequency.

use super::point::CurvePoint;
use super::request::CurveStart;
use crate::{Error, Regime};

/// A response over frequency at one friction ratio.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Friction ratio β = F/P (F/(k₁Y) for base motion).
    pub beta: f64,
    /// The initial state of the motion at each point.
    pub start: CurveStart,
    /// The pieces of the curve, in ascending order of r. Straight lines may join the points of one piece.
    pub pieces: Vec<CurvePiece>,
    /// The ranges without a response.
    pub gaps: Vec<Gap>,
    /// True if straight lines between the points have the requested accuracy. False if the curve reached its bound on
    /// work before.
    pub refined: bool,
}

/// An interval of a curve in one regime. Straight lines may join its points.
#[derive(Clone, Debug)]
pub struct CurvePiece {
    /// Regime at all points of the piece.
    pub regime: Regime,
    /// The points, in ascending order of r.
    pub points: Vec<CurvePoint>,
    /// The reason why the piece starts at its first point.
    pub start: PieceEnd,
    /// The reason why the piece ends at its last point.
    pub end: PieceEnd,
}

/// The reason why a piece of a curve ends at one of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PieceEnd {
    /// The requested range ends.
    Range,
    /// The regime changes.
    Boundary,
    /// The amplitude grows without bound.
    Pole,
    /// The amplitude jumps, because another steady state begins.
    Jump,
    /// No response exists beyond this point.
    NoAnswer,
}

/// A range of a curve without a response.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The lowest r without a response.
    pub from: f64,
    /// The highest r without a response.
    pub to: f64,
    /// The reason why there is no response at the lowest r.
    pub reason: Error,
}

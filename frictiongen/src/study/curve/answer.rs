//! The result of a computation of a curve: the curve over frequency, its pieces and its gaps.

use super::point::CurvePoint;
use super::request::CurveStart;
use crate::{Error, Regime};

/// A curve: the response over frequency at one friction ratio.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Friction ratio β = F/P (F/(k₁Y) for base motion). If `CurveRequest::rise` is not 0, `beta` is the friction
    /// ratio at r = 1.
    pub beta: f64,
    /// The initial state of the motion at each point of the curve.
    pub start: CurveStart,
    /// The pieces of the curve, in ascending order of the frequency ratio r. Straight lines may join the points of one
    /// piece.
    pub pieces: Vec<CurvePiece>,
    /// The ranges of the frequency ratio r in which the curve has no response.
    pub gaps: Vec<Gap>,
    /// True if straight lines between the points have the requested accuracy. False if the refinement has ended early,
    /// because the curve reached its bound on work.
    pub refined: bool,
}

/// A range of a curve without a change of regime, a pole, a jump or a gap. Straight lines may join its points.
#[derive(Clone, Debug)]
pub struct CurvePiece {
    /// Regime at all points of the piece.
    pub regime: Regime,
    /// The points of the piece, in ascending order of the frequency ratio r.
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
    /// The requested range of frequencies ends at this point.
    Range,
    /// The regime of the contact changes at this point.
    Boundary,
    /// Beyond this point the amplitude grows without bound towards a resonance.
    Pole,
    /// The amplitude jumps at this point, because another steady state begins.
    Jump,
    /// No response exists on the other side of this point.
    NoAnswer,
}

/// A range of frequencies in which a curve has no response.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Lowest frequency ratio r of the range without a response.
    pub from: f64,
    /// Highest frequency ratio r of the range without a response.
    pub to: f64,
    /// Reason why there is no response at the lowest frequency ratio of the range.
    pub reason: Error,
}

//! A curve of the response.

use super::point::CurvePoint;
use super::request::CurveStart;
use crate::{Error, Regime};

/// A response along frequency at one friction ratio.
#[derive(Clone, Debug)]
pub struct Curve {
    /// β.
    pub beta: f64,
    /// Where the motion of each point starts.
    pub start: CurveStart,
    /// What is joined, with ascending r.
    pub pieces: Vec<Piece>,
    /// Where there is no answer.
    pub gaps: Vec<Gap>,
    /// Whether straight lines stray no farther than was asked; otherwise the work that one curve may take was done before.
    pub refined: bool,
}

/// A part of a curve in one regime, whose points may be joined.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The regime.
    pub regime: Regime,
    /// Its points, with ascending r.
    pub points: Vec<CurvePoint>,
    /// Why it starts where it does.
    pub start: End,
    /// Why it ends where it does.
    pub end: End,
}

/// Why a piece of a curve ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum End {
    /// The range ends.
    Range,
    /// The regime changes.
    Boundary,
    /// The amplitude grows without bound.
    Pole,
    /// The amplitude changes at once: another motion begins.
    Jump,
    /// There is no answer beyond.
    NoAnswer,
}

/// Where a curve has no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The lowest r without an answer.
    pub from: f64,
    /// The highest.
    pub to: f64,
    /// Why the first has none.
    pub reason: Error,
}

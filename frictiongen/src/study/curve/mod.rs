//! Responses along frequency, in every regime, as finely as they bend.
//!
//! A curve is cut where the regime changes, at poles, at jumps and where there is no answer, and is refined between. Cuts are
//! found to rounding, so that no picture joins what is not joined.

mod places;
mod point;
mod refine;

pub use point::{CurvePoint, Movement};

use super::system::System;
use crate::{Error, Of, Regime};
use rayon::prelude::*;
use refine::{Node, Refine};

/// What is asked of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveRequest {
    /// The lowest frequency ratio r, above 0.
    pub from: f64,
    /// The highest, finite.
    pub to: f64,
    /// Whose motions.
    pub of: Vec<Of>,
    /// How far a straight line between two neighbours may stray from the curve, relative to it.
    pub accuracy: f64,
    /// How far apart neighbours are at most, in r.
    pub widest: Option<f64>,
    /// Which harmonics each point has.
    pub harmonics: Vec<u32>,
    /// Whether each point has velocities and accelerations.
    pub rates: bool,
    /// Whether the contact's motion is wanted with the opposite sign, as [`System::contact_is_reversed`] asks for.
    pub turned: bool,
}

impl CurveRequest {
    /// The amplitudes and phases of some motions over a range of r, to a two-thousandth.
    #[must_use]
    pub fn new(from: f64, to: f64, of: &[Of]) -> Self {
        Self {
            from,
            to,
            of: of.to_vec(),
            accuracy: 5e-4,
            widest: None,
            harmonics: Vec::new(),
            rates: false,
            turned: false,
        }
    }

    fn check(&self, masses: usize) -> Result<(), CurveError> {
        // Of normal numbers only, between which there are others.
        if !(f64::MIN_POSITIVE <= self.from && self.to.is_finite() && self.from < self.to) {
            return Err(CurveError::Range);
        }
        if !(1e-9..1.0).contains(&self.accuracy) {
            return Err(CurveError::Accuracy);
        }
        if self.widest.is_some_and(|widest| !(0.0 < widest)) {
            return Err(CurveError::Widest);
        }
        let unknown = |of: &&Of| matches!(of, Of::Mass(index) if masses <= *index);
        match self.of.iter().find(unknown) {
            Some(Of::Mass(index)) => Err(CurveError::NoSuchMass(*index)),
            _ => Ok(()),
        }
    }
}

/// Why there is no curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CurveError {
    /// The range of r has no width, or does not lie between 0 and ∞.
    Range,
    /// The accuracy is not between 10⁻⁹ and 1.
    Accuracy,
    /// The largest distance of neighbours is not above 0.
    Widest,
    /// The friction ratio is not a finite number from 0 on.
    Friction,
    /// The scene has no mass at this place.
    NoSuchMass(usize),
}

impl std::fmt::Display for CurveError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Range => {
                write!(
                    f,
                    "a curve needs a range of frequencies above 0, its end above its start"
                )
            }
            Self::Accuracy => write!(f, "the accuracy of a curve is between 1e-9 and 1"),
            Self::Widest => write!(f, "the largest distance of two points is above 0"),
            Self::Friction => write!(f, "a friction ratio is a finite number, 0 or above"),
            Self::NoSuchMass(index) => write!(f, "the scene has no mass at place {index}"),
        }
    }
}

impl std::error::Error for CurveError {}

/// A response along frequency at one friction ratio.
#[derive(Clone, Debug)]
pub struct Curve {
    /// β.
    pub beta: f64,
    /// What is joined, with ascending r.
    pub pieces: Vec<Piece>,
    /// Where there is no answer.
    pub gaps: Vec<Gap>,
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

impl System {
    /// The response along frequency at one friction ratio: closed form where the contact slides all the time, steady
    /// states with stops, the stuck response.
    ///
    /// ```
    /// use frictiongen::study::CurveRequest;
    /// use frictiongen::{Of, Regime, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - base,
    ///     excitation: base,
    /// }"
    /// .parse()?;
    /// let curve = block.curve(&CurveRequest::new(0.1, 2.5, &[Of::Mass(0)]), 1.25)?;
    /// let regimes: Vec<Regime> = curve.pieces.iter().map(|piece| piece.regime).collect();
    /// // It moves with its base up to r = √β, then it slips.
    /// assert_eq!(regimes[..2], [Regime::Stuck, Regime::StickSlip]);
    /// let departure = curve.pieces[1].points[0].r;
    /// assert!((departure - 1.25_f64.sqrt()).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`CurveError`] for what cannot be asked. Where there is no answer, a [`Gap`] says why.
    pub fn curve(&self, request: &CurveRequest, beta: f64) -> Result<Curve, CurveError> {
        request.check(self.scene().masses.len())?;
        if !(0.0 <= beta && beta.is_finite()) {
            return Err(CurveError::Friction);
        }
        let places = places::places(self, request, beta);
        let refine = Refine::new(self, request, beta);
        let ends: Vec<Node> = places.par_iter().map(|place| refine.node(place)).collect();
        let refine = refine.scaled(&ends);
        let parts: Vec<Vec<Node>> = ends.par_windows(2).map(|pair| refine.part(pair)).collect();
        let last = ends.into_iter().next_back();
        Ok(refine.curve(parts.into_iter().flatten().chain(last)))
    }
}

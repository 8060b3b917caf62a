//! Responses along frequency, in every regime, as finely as they bend.
//!
//! A curve is cut where the regime changes, at poles, at jumps and where there is no answer, and is refined between. Cuts are
//! found to rounding, so that no picture joins what is not joined.

mod answer;
mod pieces;
mod places;
mod point;
mod refine;
mod request;
mod straight;
mod sweep;

pub use answer::{Curve, End, Gap, Piece};
pub use point::{CurvePoint, Movement};
pub use request::{CurveError, CurveRequest, CurveStart};

use super::system::System;
use rayon::prelude::*;
use refine::Refine;

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
    /// With [`CurveStart::Up`] and [`CurveStart::Down`] each point starts where the last one ended, as a sweep in a
    /// laboratory does.  Displacements and velocities of the masses go over unchanged when the frequency changes.  A curve
    /// is cut with [`End::Jump`] where its state ends and the motion settles to another one.
    ///
    /// ```
    /// use frictiongen::study::{CurveRequest, CurveStart};
    /// use frictiongen::{Of, Regime, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - base,
    ///     excitation: base,
    ///     stiction: 2,
    /// }"
    /// .parse()?;
    /// let mut request = CurveRequest::new(0.9, 1.3, &[Of::Mass(0)]);
    /// request.start = CurveStart::Up;
    /// let up = block.curve(&request, 0.65)?;
    /// // The block moves with its base up to r² = μβ, less what holds it off its centre; then it slides.
    /// let held = up.pieces[0].points.last().ok_or("a point")?;
    /// assert_eq!(held.regime, Regime::Stuck);
    /// assert!((held.r * held.r + held.offset.abs() - 1.3).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`CurveError`] for what cannot be asked. Where there is no answer, a [`Gap`] says why.
    pub fn curve(&self, request: &CurveRequest, beta: f64) -> Result<Curve, CurveError> {
        self.curve_from(request, beta, request.start)
    }

    /// Several curves side by side, each at its own friction ratio and start in place of the request's.
    ///
    /// # Errors
    /// Same errors as [`curve`](Self::curve).
    pub fn curves(
        &self,
        request: &CurveRequest,
        asked: &[(f64, CurveStart)],
    ) -> Result<Vec<Curve>, CurveError> {
        let curves = asked.par_iter();
        curves
            .map(|(beta, start)| self.curve_from(request, *beta, *start))
            .collect()
    }

    fn curve_from(
        &self,
        request: &CurveRequest,
        beta: f64,
        start: CurveStart,
    ) -> Result<Curve, CurveError> {
        let request = &CurveRequest {
            start,
            ..request.clone()
        };
        request.check(self.scene().masses.len())?;
        if !(0.0 <= beta && beta.is_finite()) {
            return Err(CurveError::Friction);
        }
        let places = places::places(self, request, beta);
        let refine = Refine::new(self, request, beta);
        if request.start != CurveStart::Rest {
            return Ok(refine.swept(&places));
        }
        Ok(refine.refined(&places))
    }
}

//! Responses over frequency in every regime, as curves. The points are close together where a curve bends.
//!
//! A curve consists of pieces. The code cuts the curve where the regime changes, at poles, at jumps, and at the bounds
//! of a range without response. Cuts at which β equals β_lim or β*_lim are exact to rounding. The other cuts are exact
//! to a small tolerance. Between two cuts the code adds points until straight lines are accurate enough. A picture
//! draws each piece as one line, and therefore never joins points on two sides of a cut.

mod answer;
mod pieces;
mod places;
mod point;
mod refine;
mod request;
mod straight;
mod sweep;

pub use answer::{Curve, CurvePiece, Gap, PieceEnd};
pub use point::{CurvePoint, Movement};
pub use request::{CurveError, CurveRequest, CurveStart};

use super::system::System;
use rayon::prelude::*;
use refine::Refine;
use std::sync::atomic::{AtomicUsize, Ordering};

impl System {
    /// Returns the response over frequency at one friction ratio. At frequencies where the contact slides all the
    /// time, the points come from the closed form. All other points come from stick-slip motions, or from the stuck
    /// response.
    ///
    /// ```
    /// use frictiongen::study::curve::CurveRequest;
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
    /// // The block moves with its base up to r = √β, then it slips.
    /// assert_eq!(regimes[..2], [Regime::Stuck, Regime::StickSlip]);
    /// let departure = curve.pieces[1].points[0].r;
    /// assert!((departure - 1.25_f64.sqrt()).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// With [`CurveStart::Up`] and [`CurveStart::Down`] the motion at each point starts from the steady state of the
    /// previous point, as in a laboratory sweep. When the frequency changes, displacements and velocities of the masses
    /// stay unchanged. A stuck contact stays where the motion has left it. If the steady state ceases to exist and the motion settles in another state, the curve has a cut
    /// with [`PieceEnd::Jump`].
    ///
    /// ```
    /// use frictiongen::study::curve::{CurveRequest, CurveStart};
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
    /// // The block moves with its base up to r² = μβ − |offset|. Then it slides.
    /// let held = up.pieces[0].points.last().ok_or("a point")?;
    /// assert_eq!(held.regime, Regime::Stuck);
    /// assert!((held.r * held.r + held.offset.abs() - 1.3).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`CurveError`] for an invalid request. Where no response exists, a [`Gap`] gives the reason.
    pub fn curve(&self, request: &CurveRequest, beta: f64) -> Result<Curve, CurveError> {
        self.curve_from(request, beta, request.start)
    }

    /// Returns several curves, which the call computes in parallel. The list `asked` gives the friction ratio β and
    /// the initial state of each curve. This initial state replaces that of the request.
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

    /// Returns several curves as [`curves`](Self::curves) does. Before each curve and after each curve, the function
    /// calls `go_on` with the number of finished curves. If `go_on` returns false, the function computes no further
    /// curves, and their entries are `None`.
    pub fn curves_while(
        &self,
        request: &CurveRequest,
        asked: &[(f64, CurveStart)],
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<Vec<Option<Curve>>, CurveError> {
        let done = AtomicUsize::new(0);
        let curves = asked.par_iter().map(|(beta, start)| {
            if !go_on(done.load(Ordering::Relaxed)) {
                return Ok(None);
            }
            let curve = self.curve_from(request, *beta, *start)?;
            go_on(done.fetch_add(1, Ordering::Relaxed) + 1);
            Ok(Some(curve))
        });
        curves.collect()
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
        request.check(self)?;
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

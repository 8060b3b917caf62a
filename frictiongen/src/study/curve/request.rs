//! The request for a curve over frequency.

use crate::Of;
use crate::study::error::no_such_motion;
use crate::study::system::System;

/// Default bound on the work of a curve, in units of about 10 µs. The default corresponds to two seconds.
const WORK: usize = 200_000;

/// The initial state of the motion at each point of a curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CurveStart {
    /// Each point starts from rest, or from the initial state of the system
    /// ([`InitialState`](crate::study::InitialState)).
    #[default]
    Rest,
    /// Each point starts from the steady state of the previous point, while the frequency increases. The first point
    /// starts from rest, or from the initial state of the system.
    Up,
    /// Each point starts from the steady state of the previous point, while the frequency decreases. The first point
    /// starts from rest, or from the initial state of the system.
    Down,
}

/// The range, motions, accuracy and work of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveRequest {
    /// Lowest frequency ratio r of the curve. It must be above 0.
    pub from: f64,
    /// Highest frequency ratio r of the curve. It must be finite.
    pub to: f64,
    /// The motions that each point contains.
    pub of: Vec<Of>,
    /// Tolerance: the largest permitted distance between the curve and the straight line that joins two neighbouring
    /// points, divided by the value of the curve.
    pub accuracy: f64,
    /// The largest distance between neighbouring points, in the frequency ratio r. `None` sets no bound.
    pub widest: Option<f64>,
    /// The orders of the harmonics that each point contains.
    pub harmonics: Vec<u32>,
    /// True if each point contains velocities, accelerations and the equivalent viscous damping ratio.
    pub rates: bool,
    /// True if the curve contains the contact's motion with the opposite sign. The sign then agrees with the
    /// description if [`System::contact_is_reversed`](crate::study::System::contact_is_reversed) returns true.
    pub turned: bool,
    /// Bound on the work of the curve, in units of about 10 µs. The code counts work instead of time, so that the same
    /// request gives the same curve on every machine. The code always computes the points at cuts and on an even grid,
    /// even if they exceed the bound.
    pub work: usize,
    /// The initial state of the motion at each point.
    pub start: CurveStart,
    /// Exponent n of the friction ratio along the curve: the friction ratio at r is β·rⁿ. For a load of constant
    /// amplitude n is 0. For a constant friction force, n is 2 under a base motion of constant acceleration, and −2
    /// under an unbalance.
    pub rise: i32,
    /// Exponent n of the load along the curve: the amplitude of the load is proportional to r⁻ⁿ. The refinement of the
    /// curve expresses all displacements in the unit P/k₁ (Y for base motion) at r = 1.
    pub fall: i32,
}

impl CurveRequest {
    /// Requests amplitudes and phases of the motions `of` over a range of the frequency ratio r, with a tolerance of
    /// 5e-4.
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
            work: WORK,
            start: CurveStart::Rest,
            rise: 0,
            fall: 0,
        }
    }

    /// Returns the friction ratio at the frequency ratio r, which is β·rⁿ with n = `rise`.
    pub(super) fn beta_at(&self, beta: f64, r: f64) -> f64 {
        beta * r.powi(self.rise)
    }

    pub(super) fn check(&self, system: &System) -> Result<(), CurveError> {
        if system.single().is_err() {
            return Err(CurveError::SeveralContacts);
        }
        // The check refuses subnormal bounds, because too few floating-point numbers lie between two subnormal bounds.
        if !(f64::MIN_POSITIVE <= self.from && self.to.is_finite() && self.from < self.to) {
            return Err(CurveError::Range);
        }
        if !(1e-9..1.0).contains(&self.accuracy) {
            return Err(CurveError::Accuracy);
        }
        if self.widest.is_some_and(|widest| !(0.0 < widest)) {
            return Err(CurveError::Widest);
        }
        match self.of.iter().find(|of| !system.has_motion(**of)) {
            Some(of) => Err(CurveError::NoSuchMotion(*of)),
            None => Ok(()),
        }
    }
}

/// The reason why a request gives no curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CurveError {
    /// The requested range of frequency ratios r has no width, or its bounds are not positive and finite.
    Range,
    /// The tolerance of the curve is not between 10⁻⁹ and 1.
    Accuracy,
    /// The largest distance of neighbouring points of the curve is not above 0.
    Widest,
    /// The friction ratio β is negative or not finite.
    Friction,
    /// The scene does not have the mass or the spring of the requested motion.
    NoSuchMotion(Of),
    /// The scene has several contacts or dashpots, for which no curve exists.
    SeveralContacts,
}

impl std::fmt::Display for CurveError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Range => {
                write!(
                    f,
                    "a range of frequencies must begin above 0 and end above its start"
                )
            }
            Self::Accuracy => write!(f, "the accuracy of a curve must be between 1e-9 and 1"),
            Self::Widest => write!(f, "the largest distance between two points must be above 0"),
            Self::Friction => write!(f, "a friction ratio must be a finite number, 0 or above"),
            Self::NoSuchMotion(of) => no_such_motion(f, *of),
            Self::SeveralContacts => crate::Unsupported::SeveralContacts.fmt(f),
        }
    }
}

impl std::error::Error for CurveError {}

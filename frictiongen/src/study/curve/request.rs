//! What is asked of a curve.

use crate::Of;

/// The work of a curve: some seconds.
const WORK: usize = 200_000;

/// Where the motion of each point of a curve starts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CurveStart {
    /// From rest, point by point: every mass at x = 0 without velocity where the excitation is at its maximum.
    #[default]
    Rest,
    /// From the steady state of the point before, with ascending frequency; the first point starts from rest.
    Up,
    /// From the steady state of the point before, with descending frequency; the first point starts from rest.
    Down,
}

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
    /// Whether the contact's motion is wanted with the opposite sign, as
    /// [`System::contact_is_reversed`](crate::study::System::contact_is_reversed) asks for.
    pub turned: bool,
    /// How much work the curve may take, in units of some 10 µs.  It is counted, so that a curve is the same on every machine.
    /// The places where the curve is cut and those of an even grid are answered whatever they take.
    pub work: usize,
    /// Where the motion of each point starts.
    pub start: CurveStart,
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
            work: WORK,
            start: CurveStart::Rest,
        }
    }

    pub(super) fn check(&self, masses: usize) -> Result<(), CurveError> {
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

//! The course of one quantity over the period of a steady state: largest value and phase, harmonics, values at any
//! phase.

use super::combination::Combination;
use super::scene::Joined;
use super::units::AnswerUnits;
use crate::Of;
use crate::study::joints::Series;
use crate::study::response::MotionQuantity;
use frictiongen_kernel::joints::Piece;

/// The course of a displacement or a force over the period of a steady state.
///
/// The phase τ = ωt of the load is 0 at a maximum of the load, where the period begins. Displacements, forces and
/// velocities (derivatives with respect to τ) are in the units of [`JoinedAt::units`](super::JoinedAt::units).
pub type Waveform = frictiongen_kernel::joints::Waveform<f64, Vec<Piece<f64>>>;

/// A quantity whose course over a period the code follows.
#[derive(Clone, Debug)]
pub(in crate::study) enum Course {
    /// A displacement of masses, its derivative, or a force of springs.
    Combination(Combination),
    /// The relative displacement in a contact or a stop, from the second node to the first, times 1 or −1.
    Contact((usize, usize), f64),
}

impl Course {
    /// Returns the course of a motion or of a force of springs. Returns `None` for a quantity that only a contact has.
    pub fn of(joined: &Joined<'_>, of: Of, size: MotionQuantity) -> Option<Self> {
        Combination::of(joined.scene(), of, size).map(Self::Combination)
    }

    /// Returns the course of the relative displacement in the contact or stop with this index.
    pub fn of_contact(joined: &Joined<'_>, index: usize) -> Option<Self> {
        Some(Self::Contact(joined.nodes(index)?, joined.sign(index)))
    }

    /// Returns the quantity from the start of a stretch (time interval of a power series) to its fraction `end`.
    pub fn piece(&self, series: &Series, end: f64, setting: (f64, AnswerUnits)) -> Piece<f64> {
        let (_, units) = setting;
        let (terms, factor) = match self {
            Self::Combination(combination) => {
                let factor = combination.in_units(1.0, setting);
                (combination.terms_of(series), factor)
            }
            Self::Contact((plus, minus), sign) => {
                (series.place_terms(*plus, *minus), sign / units.length)
            }
        };
        Piece {
            start: series.start,
            length: series.length,
            end,
            terms: terms.map(|term| factor * term),
        }
    }
}

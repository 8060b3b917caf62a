//! Largest values of a motion in time, exact between its samples.

use super::combination::{Combination, extreme_between};
use super::error::JoinedError;
use super::scene::Joined;
use super::slides::Slide;
use crate::Of;
use crate::study::joints::{Series, State};
use crate::study::response::MotionQuantity;
use frictiongen_kernel::joints::{Poly, STUCK, value as value_of};

/// A later value must exceed an earlier one by this relative distance to replace it, so that rounding moves no instant.
const ROUNDING: f64 = 1e-12;

/// Largest absolute value of a quantity in a motion, in the units of the scene description.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// Value with the largest absolute value.
    pub value: f64,
    /// First instant of this value, in s since the start.
    pub time: f64,
    /// Value at the end of the motion.
    pub last: f64,
}

/// A quantity whose largest value the stepper follows.
#[derive(Clone, Debug)]
enum Tracked {
    Combination(Combination),
    /// Index of the contact or stop, its quantity, and the factor 1 or −1 of [`Joined::sign`].
    Contact(usize, MotionQuantity, f64),
}

/// The largest values of quantities since the start of a motion.
#[derive(Clone, Debug, Default)]
pub(super) struct Peaks {
    /// Time at the start of the present step, in s.
    pub start: f64,
    all: Vec<(Tracked, Peak)>,
}

impl Peaks {
    /// Starts to follow quantities. A contact or a stop has its index.
    pub fn of(
        joined: &Joined<'_>,
        quantities: &[(Of, MotionQuantity, usize)],
    ) -> Result<Self, JoinedError> {
        use MotionQuantity::{Displacement, Energy, Force};
        let tracked = quantities.iter();
        let tracked = tracked.map(|&(of, size, contact)| match (of, size) {
            (Of::Contact | Of::ContactAt(_), Displacement | Force | Energy) => {
                let contact = if let Of::ContactAt(own) = of {
                    own
                } else {
                    contact
                };
                Some(Tracked::Contact(contact, size, joined.sign(contact)))
            }
            _ => Combination::of(joined.scene(), of, size).map(Tracked::Combination),
        });
        let all = tracked.map(|tracked| Some((tracked?, Peak::default())));
        let all = all.collect::<Option<_>>().ok_or(JoinedError::Quantity)?;
        Ok(Self { start: 0.0, all })
    }

    /// Returns the peak of each quantity.
    pub fn found(&self) -> Vec<Peak> {
        self.all.iter().map(|(_, peak)| *peak).collect()
    }

    /// Compares the peaks with the motion from the start of a stretch (time interval of a power series) to its fraction
    /// `end`. `contacts` has the energies at the end.
    pub fn stretch(&mut self, (series, end): (&Series, f64), state: &State, contacts: &[Slide]) {
        let extreme = |terms: &Poly<f64>| {
            let (at, value) = extreme_between(terms, end);
            (at, value, value_of(terms, end))
        };
        for (tracked, peak) in &mut self.all {
            let (at, value, last) = match tracked {
                Tracked::Combination(combination) => extreme(&combination.terms_of(series)),
                Tracked::Contact(index, size, sign) => {
                    let Some(own) = contacts.get(*index) else {
                        continue;
                    };
                    let is_shut = state.phase(*index) == STUCK;
                    match own.terms(series, (*index, is_shut), *size) {
                        Some(terms) => extreme(&terms.map(|term| *sign * term)),
                        None => (end, own.energy, own.energy),
                    }
                }
            };
            if peak.value.abs() * (1.0 + ROUNDING) < value.abs() {
                peak.value = value;
                peak.time = self.start + series.start + at * series.length;
            }
            peak.last = last;
        }
    }
}

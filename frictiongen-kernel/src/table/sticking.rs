//! The response of a scene with tables while its contact is stuck.

use super::compiled::{Compiled, Tabled};
use crate::errors::StuckResonance;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::response::{ProvidesStuck, Stuck};

/// A scene with products over zeros and poles for its response while the contact is stuck.
///
/// Without a body of its own for any of these methods the exact formulas answer.
pub trait TabledStuck: Tabled + ProvidesStuck {
    /// The response, with a method for each mass.
    type Sticking: From<Sticking<Self>>;

    /// Whether the products answer; else only the exact formulas keep the accuracy.
    #[inline]
    fn holds_stuck(&self) -> bool {
        false
    }

    /// The numbers within the domain on which an undamped resonance of the held chain lies to the last digit.
    #[inline]
    fn stuck_resonances(&self) -> &[Self::Scalar] {
        &[]
    }

    /// x̄* = V_k − H_kV/H of a mass within the domain; none if there is no such mass.
    #[inline]
    fn tabled_stuck(&self, _mass: usize, _r: Self::Scalar) -> Option<Complex<Self::Scalar>> {
        None
    }

    /// V/H within the domain.
    #[inline]
    fn tabled_holding_force(&self, _r: Self::Scalar) -> Option<Complex<Self::Scalar>> {
        None
    }
}

impl<T: TabledStuck> Compiled<T> {
    /// The response while the contact is stuck, β ≥ β*_lim, to the declared accuracy.
    ///
    /// # Errors
    /// [`StuckResonance`] on an undamped resonance of the chain with its contact stuck.
    #[inline]
    pub fn stuck(&self) -> Result<T::Sticking, StuckResonance> {
        let at = self.clone();
        if !self.holds_stuck() {
            // The exact formulas have their own admission.
            self.exact().stuck()?;
            return Ok(Sticking { at }.into());
        }
        let resonances = self.scene().stuck_resonances();
        if resonances.contains(&self.frequency_ratio()) {
            return Err(StuckResonance);
        }
        Ok(Sticking { at }.into())
    }

    /// Whether the products answer at this r.
    #[inline]
    fn holds_stuck(&self) -> bool {
        // Where nothing answers beyond the range, it need not be asked.
        let within = !self.scene().domain().exact_beyond || self.is_within();
        within && self.scene().holds_stuck()
    }
}

/// The response at one frequency ratio while the contact is stuck, of a scene with tables.
#[derive(Clone, Copy, Debug)]
pub struct Sticking<T: TabledStuck> {
    at: Compiled<T>,
}

impl<T: TabledStuck> Sticking<T> {
    /// The scene at this frequency.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &Compiled<T> {
        &self.at
    }

    /// The same response by the exact formulas.
    #[must_use]
    pub fn exact(&self) -> Stuck<T> {
        self.at.exact().stuck_unchecked()
    }

    /// A of the force Re(A e^{iτ}) over P that holds the contact, V/H (6.11, 6.27, 6.33); positive against positive
    /// sliding.  Its modulus is μβ*_lim.
    #[inline]
    #[must_use]
    pub fn contact_force(&self) -> Complex<T::Scalar> {
        let tabled = if self.at.holds_stuck() {
            let r = self.at.frequency_ratio();
            self.at.scene().tabled_holding_force(r)
        } else {
            None
        };
        match tabled {
            Some(force) => force,
            None => self.exact().contact_force(),
        }
    }

    /// The same as [`mass_at`](Self::mass_at); rest if there is no such mass.
    #[inline]
    #[must_use]
    pub fn mass(&self, mass: usize) -> Complex<T::Scalar> {
        let at_rest = complex::real(T::Scalar::constant(0.0));
        self.mass_at(mass).unwrap_or(at_rest)
    }

    /// x̄* = V_k − H_kV/H, the complex amplitude of a mass (6.11, 6.27, 6.33), by its place in the description; none
    /// if there is no such mass.
    #[inline]
    #[must_use]
    pub fn mass_at(&self, mass: usize) -> Option<Complex<T::Scalar>> {
        if self.at.holds_stuck() {
            let r = self.at.frequency_ratio();
            self.at.scene().tabled_stuck(mass, r)
        } else {
            self.exact().mass_at(mass)
        }
    }
}

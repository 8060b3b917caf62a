//! Response of a scene with tables while the contact is stuck.

use super::compiled::{Compiled, Tabled};
use crate::errors::StuckResonance;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::response::{ProvidesStuck, Stuck};

/// A scene that stores its response with the contact stuck as products over zeros and poles.
///
/// The default methods of this trait use the exact formulas. For a scene that stores such products, the code generator
/// replaces these methods.
pub trait TabledStuck: Tabled + ProvidesStuck {
    /// Type that `stuck` returns. In emitted code this type has one method for each mass.
    type Sticking: From<Sticking<Self>>;

    /// Returns true if the response with the contact stuck comes from products over zeros and poles. If false, only the
    /// exact formulas have the declared accuracy.
    #[inline]
    fn holds_stuck(&self) -> bool {
        false
    }

    /// Returns the undamped resonances of the chain with its contact stuck, as frequency ratios within the domain of
    /// the tables. The list contains only resonances that the number type represents exactly.
    #[inline]
    fn stuck_resonances(&self) -> &[Self::Scalar] {
        &[]
    }

    /// Returns x̄*, the complex amplitude of a mass while the contact is stuck. The frequency ratio r must be within
    /// the domain of the tables. Returns `None` if the scene has no mass with this index.
    #[inline]
    fn tabled_stuck(&self, _mass: usize, _r: Self::Scalar) -> Option<Complex<Self::Scalar>> {
        None
    }

    /// Returns V/H, the complex amplitude of the force that keeps the contact stuck. The frequency ratio r must be
    /// within the domain of the tables.
    #[inline]
    fn tabled_holding_force(&self, _r: Self::Scalar) -> Option<Complex<Self::Scalar>> {
        None
    }
}

impl<T: TabledStuck> Compiled<T> {
    /// Returns the response while the contact is stuck, with the declared accuracy. This response exists for β ≥
    /// β*_lim, the limit of sliding.
    ///
    /// # Errors
    /// [`StuckResonance`] if r is an undamped resonance of the chain with its contact stuck.
    #[inline]
    pub fn stuck(&self) -> Result<T::Sticking, StuckResonance> {
        let at = self.clone();
        if !self.holds_stuck() {
            // The exact formulas contain their own check for a resonance.
            self.exact().stuck()?;
            return Ok(Sticking { at }.into());
        }
        let resonances = self.scene().stuck_resonances();
        if resonances.contains(&self.frequency_ratio()) {
            return Err(StuckResonance);
        }
        Ok(Sticking { at }.into())
    }

    /// Returns true if the response at this frequency ratio comes from products over zeros and poles.
    #[inline]
    fn holds_stuck(&self) -> bool {
        // If `exact_beyond` is false, `Compiled::new` has rejected every r outside the range of the tables.
        let within = !self.scene().domain().exact_beyond || self.is_within();
        within && self.scene().holds_stuck()
    }
}

/// Response of a [`TabledStuck`] scene at one frequency ratio while the contact is stuck.
#[derive(Clone, Copy, Debug)]
pub struct Sticking<T: TabledStuck> {
    at: Compiled<T>,
}

impl<T: TabledStuck> Sticking<T> {
    /// Returns the scene at the frequency ratio of this response.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &Compiled<T> {
        &self.at
    }

    /// Returns the response with the contact stuck from the exact formulas, at the same frequency ratio.
    #[must_use]
    pub fn exact(&self) -> Stuck<T> {
        self.at.exact().stuck_unchecked()
    }

    /// Returns V/H, the complex amplitude of the contact force that keeps the contact stuck, divided by P (6.11, 6.27,
    /// 6.33). A positive force opposes positive sliding. The absolute value is μβ*_lim, where β*_lim is the limit of
    /// sliding.
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

    /// Returns the complex amplitude of a mass while the contact is stuck. The result is 0 if the scene has no mass
    /// with this index. [`mass_at`](Self::mass_at) returns `None` instead of 0.
    #[inline]
    #[must_use]
    pub fn mass(&self, mass: usize) -> Complex<T::Scalar> {
        let at_rest = complex::real(T::Scalar::constant(0.0));
        self.mass_at(mass).unwrap_or(at_rest)
    }

    /// Returns x̄*, the complex amplitude of a mass while the contact is stuck (6.11, 6.27, 6.33). `mass` is the index
    /// of the mass in the scene description. Returns `None` if the scene has no mass with this index.
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

//! The response while the contact is stuck.

use super::at::At;
use super::scene::Scene;
use crate::errors::StuckResonance;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;

/// A scene that provides `stuck`.
pub trait ProvidesStuck: Scene {
    /// The response, with a method for each mass.
    type Stuck: From<Stuck<Self>>;

    /// x̄* = V_k − H_kV/H of a mass that the stuck contact does not tie (6.11, 6.27, 6.33); a generator may write its own.
    #[inline]
    fn stuck_mass(at: &At<Self>, mass: usize) -> Option<Complex<Self::Scalar>> {
        let numbers = at.scene.numbers();
        let (shape, chain) = (at.scene.shape(mass)?, numbers.chain);
        let (contact, modes) = (&at.contact, at.modes.as_ref());
        Some(chain.stuck(shape, numbers.modes, modes, contact, at.inverse_r))
    }
}

impl<T: ProvidesStuck> At<T> {
    /// The response while the contact is stuck, β ≥ β*_lim.
    ///
    /// # Errors
    /// [`StuckResonance`] on an undamped resonance of the chain with its contact stuck.
    #[inline]
    pub fn stuck(&self) -> Result<T::Stuck, StuckResonance> {
        let numbers = self.scene.numbers();
        numbers
            .chain
            .stuck_admitted(self.r, &self.contact, numbers.invisible)?;
        Ok(self.kept().stuck_unchecked().into())
    }

    /// The response with the contact stuck, without a look at resonances: there it is infinite.
    #[inline]
    #[must_use]
    pub fn stuck_unchecked(self) -> Stuck<T> {
        Stuck { at: self }
    }

    /// The amplitude of a mass while the contact is stuck, from the holding force where masses beyond it absorb.
    #[inline]
    fn absorbed_mass(&self, mass: usize) -> Option<Complex<T::Scalar>> {
        let force = self.absorbed_force()?;
        let numbers = self.scene.numbers();
        let (shape, chain) = (self.scene.shape(mass)?, numbers.chain);
        let (contact, modes) = (&self.contact, self.modes.as_ref());
        let amplitude =
            chain.stuck_under(force, shape, numbers.modes, modes, contact, self.inverse_r);
        Some(complex::real(amplitude))
    }
}

/// The response at one frequency ratio while the contact is stuck.
#[derive(Clone, Debug)]
pub struct Stuck<T: Scene> {
    at: At<T>,
}

impl<T: Scene + Copy> Copy for Stuck<T> where T::Modes: Copy {}

impl<T: ProvidesStuck> Stuck<T> {
    /// The scene at this frequency.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &At<T> {
        &self.at
    }

    /// A of the force Re(A e^{iτ}) over P that holds the contact, V/H (6.11, 6.27, 6.33); positive against positive
    /// sliding.  Its modulus is μβ*_lim.
    #[must_use]
    pub fn contact_force(&self) -> Complex<T::Scalar> {
        if let Some(force) = self.at.absorbed_force() {
            return complex::real(force);
        }
        let sums = &self.at.contact;
        complex::mul(sums.v, complex::reciprocal(sums.h, true), true)
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
        if let Some(amplitude) = self.at.scene().numbers().tied(mass) {
            return Some(complex::real(amplitude));
        }
        // Masses beyond the contact absorb: V and H have zeros in common.
        if let Some(amplitude) = self.at.absorbed_mass(mass) {
            return Some(amplitude);
        }
        T::stuck_mass(&self.at, mass)
    }
}

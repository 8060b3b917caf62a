//! The response while the contact is stuck.

use super::at::At;
use super::scene::Scene;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;

/// A scene that provides `stuck`.
pub trait ProvidesStuck: Scene {
    /// The response, with a method for each mass.
    type Stuck: From<Stuck<Self>>;
}

/// The response at one frequency ratio while the contact is stuck.
#[derive(Clone, Debug)]
pub struct Stuck<T: Scene> {
    at: At<T>,
}

impl<T: Scene + Copy> Copy for Stuck<T> where T::Modes: Copy {}

impl<T: Scene> Stuck<T> {
    /// The response, which [`At::stuck`] has admitted.
    #[inline]
    pub(super) fn new(at: At<T>) -> Self {
        Self { at }
    }

    /// The scene at this frequency.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &At<T> {
        &self.at
    }

    /// The same as [`mass_at`](Self::mass_at); rest if there is no such mass.
    #[inline]
    #[must_use]
    pub fn mass(&self, mass: usize) -> Complex<T::Scalar> {
        let rest = complex::real(T::Scalar::constant(0.0));
        self.mass_at(mass).unwrap_or(rest)
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

//! Response of the chain at one frequency ratio while the contact is stuck.

use super::at::At;
use super::scene::Scene;
use crate::errors::StuckResonance;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;

/// Trait of scenes that provide the response with the contact stuck through the method `stuck`.
pub trait ProvidesStuck: Scene {
    /// Type that `stuck` returns. In emitted code this type has one method for each mass.
    type Stuck: From<Stuck<Self>>;

    /// Returns x̄* = V_k − H_kV/H, the complex amplitude of mass k while the contact is stuck (6.11, 6.27, 6.33). V_k
    /// is the response of mass k to the load, and H_k its response to a unit force in the contact. V/H is the contact
    /// force in the stuck state.
    ///
    /// The mass must not be fixed to its support by the stuck contact. The default method is valid for every chain. The
    /// code generator replaces it by a faster method if the constants of a scene permit.
    #[inline]
    fn stuck_mass(at: &At<Self>, mass: usize) -> Option<Complex<Self::Scalar>> {
        let numbers = at.scene.numbers();
        let (shape, chain) = (at.scene.shape(mass)?, numbers.chain);
        let (contact, modes) = (&at.contact, at.modes.as_ref());
        let quadratures = at.scene.quadratures();
        if let Some(compliance) = at.scene.compliance() {
            let loaded = (numbers.modes, quadratures);
            return Some(chain.stuck_elastic(
                shape,
                loaded,
                modes,
                (contact, compliance),
                at.inverse_r,
            ));
        }
        // A scene without loads in quadrature uses the shorter formula.
        Some(if quadratures.is_empty() {
            chain.stuck(shape, numbers.modes, modes, contact, at.inverse_r)
        } else {
            let loaded = (numbers.modes, quadratures);
            chain.stuck_loaded(shape, loaded, modes, contact, at.inverse_r)
        })
    }
}

impl<T: ProvidesStuck> At<T> {
    /// Returns the response at this frequency ratio while the contact is stuck. This response exists for β ≥ β*_lim,
    /// the limit of sliding.
    ///
    /// # Errors
    /// [`StuckResonance`] if r is an undamped resonance of the chain with its contact stuck.
    #[inline]
    pub fn stuck(&self) -> Result<T::Stuck, StuckResonance> {
        let numbers = self.scene.numbers();
        numbers
            .chain
            .stuck_admitted(self.r, &self.contact, numbers.invisible)?;
        Ok(self.kept().stuck_unchecked().into())
    }

    /// Returns the response at this frequency ratio while the contact is stuck, without a check for resonances. At an
    /// undamped resonance the response is infinite.
    #[inline]
    #[must_use]
    pub fn stuck_unchecked(self) -> Stuck<T> {
        Stuck { at: self }
    }

    /// Returns the amplitude of a mass while the contact is stuck, if masses beyond the contact (seen from the load)
    /// act as an absorber. The code computes the amplitude from the force in the contact. Returns `None` if no mass
    /// acts as an absorber.
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

/// Response at one frequency ratio while the contact is stuck.
#[derive(Clone, Debug)]
pub struct Stuck<T: Scene> {
    at: At<T>,
}

impl<T: Scene + Copy> Copy for Stuck<T> where T::Modes: Copy {}

impl<T: ProvidesStuck> Stuck<T> {
    /// Returns the scene at the frequency ratio of this response.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &At<T> {
        &self.at
    }

    /// Returns V/H, the complex amplitude of the contact force that keeps the contact stuck, divided by P (6.11, 6.27,
    /// 6.33). A positive force opposes positive sliding. The absolute value is μβ*_lim, where β*_lim is the stuck
    /// limit.
    #[must_use]
    pub fn contact_force(&self) -> Complex<T::Scalar> {
        if let Some(force) = self.at.absorbed_force() {
            return complex::real(force);
        }
        let sums = &self.at.contact;
        complex::mul(sums.v, complex::reciprocal(sums.h, true), true)
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
        if !self.at.is_elastic()
            && let Some(amplitude) = self.at.scene().numbers().tied(mass)
        {
            return Some(complex::real(amplitude));
        }
        // If masses beyond the contact act as an absorber, V and H vanish at the same frequency. The general formula
        // would then contain 0/0.
        if let Some(amplitude) = self.at.absorbed_mass(mass) {
            return Some(amplitude);
        }
        T::stuck_mass(&self.at, mass)
    }
}

//! Smallest and largest displacement of a steady motion, its offset, and its amplitude about the middle.

use super::motion::OrbitMotion;
use super::types::Orbit;
use crate::motion::{ContactChain, Part};
use crate::number::complex::Complex;
use crate::number::scalar::Float;

impl<S, P, V, C, K> Orbit<'_, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    /// Returns the offset of the contact, in units of P/k₁ (of the base amplitude Y for base motion). The offset is the
    /// [`middle`](Self::middle) of the contact's relative motion. If the contact never slides and the motion started
    /// from rest, the steady state itself has its middle at 0. The offset is then the place at which the motion from
    /// rest leaves the contact.
    pub fn offset(&self) -> S {
        self.left_at.unwrap_or_else(|| self.middle())
    }

    /// Returns the middle of the contact's relative motion, (max z̄ + min z̄)/2, in units of P/k₁ (of the base amplitude
    /// Y for base motion). It is 0 for a symmetric motion.
    pub fn middle(&self) -> S {
        if self.symmetric {
            return S::constant(0.0);
        }
        let (least, most) = self.contact().extremes();
        (least + most) * S::constant(0.5)
    }
}

impl<S, P, V, C, K> OrbitMotion<'_, '_, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    /// Returns the smallest and the largest displacement x̄ in a period, in units of P/k₁ (of the base amplitude Y for
    /// base motion).
    pub fn extremes(&self) -> (S, S) {
        let largest = self.amplitude();
        if self.is_symmetric() {
            return (-largest, largest);
        }
        if self.turns_at_events() {
            return self.extremes_at_events();
        }
        // The sum of the motion and its own amplitude never changes its sign. The maximum of |x̄ + amplitude| therefore
        // gives the maximum of x̄.
        let shifted = |shift: S| {
            let mut most = S::constant(0.0);
            self.each(|_, sum| {
                let mut sum = *sum;
                sum.constant = sum.constant + shift;
                sum.peaks(most, |_, value| {
                    most = most.max(value.abs());
                    most
                });
            });
            most - largest
        };
        (-shifted(-largest), shifted(largest))
    }

    /// Returns half the distance between the smallest and the largest displacement x̄ in a period, in units of P/k₁ (of
    /// the base amplitude Y for base motion). The result is the amplitude about the middle of the motion.
    pub fn centred_amplitude(&self) -> S {
        let (least, most) = self.extremes();
        (most - least) * S::constant(0.5)
    }
}

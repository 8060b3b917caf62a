//! Special values in closed form (section 6 of `docs/derivation.md`): friction thresholds at resonances, amplitudes for
//! r → 0, and estimates of resonant peaks.

use crate::modal::Modal;
use frictiongen_kernel::Float;

impl<T: Float> Modal<T> {
    /// Returns the friction threshold β_n,i of each mode i (6.2, 6.26). If β is smaller than the threshold, the motion
    /// at the undamped resonance of the mode is unbounded. The entry is `None` for a mode that the contact does not
    /// drive.
    #[must_use]
    pub fn resonance_thresholds(&self) -> Vec<Option<T>> {
        self.loads
            .iter()
            .zip(&self.contacts)
            .map(|(load, contact)| {
                (!contact.vanishes())
                    .then(|| T::pi() * T::constant(0.25) * (*load / *contact).abs())
            })
            .collect()
    }

    /// Returns the displacement x̄ of every mass for r → 0 at the friction ratio β (6.5). The result is the static
    /// displacement under the load and an opposing friction force. Returns `None` if the contact is stuck at r = 0.
    #[must_use]
    pub fn quasi_static_start(&self, beta: T) -> Option<Vec<T>> {
        if self.ends().sliding_at_rest <= beta {
            return None;
        }
        let sign = if self.static_motion < T::constant(0.0) {
            T::constant(-1.0)
        } else {
            T::constant(1.0)
        };
        let zero = T::constant(0.0);
        let masses = self.shapes.first().map_or(0, Vec::len);
        let start = |mass: usize| {
            let mut sum = zero;
            for (mode, shape) in self.shapes.iter().enumerate() {
                let of = |list: &[T]| list.get(mode).copied().unwrap_or(zero);
                let lambda = of(&self.resonances) * of(&self.resonances);
                let force = of(&self.loads) - beta * sign * of(&self.contacts);
                sum = sum + shape.get(mass).copied().unwrap_or(zero) * force / lambda;
            }
            sum
        };
        Some((0..masses).map(start).collect())
    }

    /// Returns an estimate of the peak amplitude of a mass at a damped resonance, for small ζ (7.60). `beta` is the
    /// friction ratio β. The estimate contains sinh x/(cosh x − 1) with x = πζ, which the code evaluates as coth(x/2).
    /// Returns `None` for a mode without damping.
    #[must_use]
    pub fn resonant_peak_estimate(&self, mode: usize, mass: usize, beta: T) -> Option<T> {
        let zeta = *self.damping_ratios.get(mode)?;
        if !(T::constant(0.0) < zeta) {
            return None;
        }
        let resonance = *self.resonances.get(mode)?;
        let component = *self.shapes.get(mode)?.get(mass)? / (resonance * resonance);
        let load = *self.loads.get(mode)?;
        let size = match self.participations.get(mode) {
            None => load.abs(),
            Some(_) => {
                let [quadrature, _] = self.quadrature(mode, &|value| value);
                (load * load + quadrature * quadrature).sqrt()
            }
        };
        let driven = component.abs() * size / (zeta + zeta);
        let rubbed = (component * *self.contacts.get(mode)?).abs();
        // coth(x/2) = (2 + m)/m with m = e^x − 1. `exp_m1` computes m without cancellation for small x.
        let m = (T::pi() * zeta).exp_m1();
        Some(driven - rubbed * (m + T::constant(2.0)) / m * beta)
    }
}

//! Steady states of a run-time system in any regime: the kernel's, with masses by their names.

use super::error::UnknownMass;
use super::system::System;
use super::units::reversed_phase;
use crate::Complex;
use frictiongen_kernel::Float;
use frictiongen_kernel::orbit::{Orbit, OrbitMotion};
use frictiongen_kernel::simulation::Part;
use std::ops::Deref;

/// Lags that differ by so much are equal,
const SAME_LAG: f64 = 1e-9;
/// and in `f32` by so many roundings.
const ROUNDINGS: f64 = 64.0;

/// A steady state of a system, as the kernel holds it.
pub type SystemOrbitState<'a, S = f64> = Orbit<'a, S, Vec<Part<S>>, Vec<S>, Vec<Complex<S>>>;

/// The steady motion of the contact or of a mass.
pub type SystemOrbitMotion<'o, 'a, S = f64> =
    OrbitMotion<'o, 'a, S, Vec<Part<S>>, Vec<S>, Vec<Complex<S>>>;

/// The steady state of a system at one frequency ratio and one friction ratio, in any regime.
///
/// ```
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let system: frictiongen::System = "struct Block {
///     masses: { block: 1 },
///     springs: { base - block: 1 },
///     contact: block - wall,
///     excitation: block,
/// }"
/// .parse()?;
/// let orbit = system.at(0.3)?.orbit(0.4)?;
/// assert_eq!((orbit.stops(), orbit.reversals()), (2, 0));
/// assert!((orbit.mass("block")?.amplitude() - 0.8567297780578).abs() < 1e-12);
/// assert!(orbit.is_symmetric() && orbit.is_stable() && !orbit.is_marginal());
/// # Ok(())
/// # }
/// ```
///
/// Where the motion from rest does not settle, `orbit_or_last_cycles` gives its last 64 cycles:
///
/// ```
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let system: frictiongen::System = "struct Block {
///     masses: { block: 1 },
///     springs: { base - block: 1 },
///     contact: block - base,
///     excitation: base,
///     stiction: 3,
/// }"
/// .parse()?;
/// let at = system.at(1.0 / 3.0)?;
/// assert!(at.orbit(0.01395).is_err());
/// let seen = at.orbit_or_last_cycles(0.01395)?;
/// assert!(!seen.is_settled() && !seen.is_stable() && seen.multipliers().is_empty());
/// assert!(seen.mass("block")?.amplitude() > 1.0);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct SystemOrbit<'a, S = f64> {
    pub(super) system: &'a System<S>,
    pub(super) orbit: SystemOrbitState<'a, S>,
}

impl<'a, S: Float> SystemOrbit<'a, S> {
    /// The motion of a mass.
    ///
    /// # Errors
    /// [`UnknownMass`] if there is none of this name.
    pub fn mass(&self, name: &str) -> Result<SystemOrbitMotion<'_, 'a, S>, UnknownMass> {
        Ok(self.orbit.mass(self.system.mass_index(name)?))
    }

    /// The phase of the contact's motion with the opposite sign, in (−π, π]: what
    /// [`contact_is_reversed`](System::contact_is_reversed) asks for. As for `phase`, of several lags at which that
    /// motion is farthest the smallest counts, and then the positive one.
    #[must_use]
    pub fn reversed_contact_phase(&self) -> S {
        let contact = self.orbit.contact();
        let (amplitude, phase) = contact.largest();
        let (zero, turn) = (S::constant(0.0), S::constant(2.0) * S::pi());
        // Within rounding of the farthest, and of equal lags.
        let same = S::constant(SAME_LAG.max(ROUNDINGS * S::EPSILON));
        let mut best = reversed_phase(phase);
        let mut note = |lag: S| {
            let lag = if S::pi() < lag { lag - turn } else { lag };
            let shorter = best.abs() - lag.abs();
            if same < shorter || (shorter.abs() <= same && best < lag) {
                best = lag;
            }
        };
        for (start, length) in self.orbit.sticking_intervals() {
            let middle = start + length * S::constant(0.5) - self.orbit.origin();
            let relative = contact.displacement(middle);
            if relative.abs() < amplitude - amplitude * same {
                continue;
            }
            // Where the motion is negative the opposite one has its maximum; else half a turn away.
            let from = if zero < relative {
                start + S::pi()
            } else {
                start
            };
            let from = from - (from / turn).floor() * turn;
            let to = from + length;
            if turn <= to {
                note(zero);
            } else {
                note(from);
                note(to);
            }
        }
        best
    }
}

impl<'a, S> Deref for SystemOrbit<'a, S> {
    type Target = SystemOrbitState<'a, S>;

    fn deref(&self) -> &Self::Target {
        &self.orbit
    }
}

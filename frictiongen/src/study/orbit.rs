//! Steady states of a run-time system in any regime. A caller can request the motion of a mass by the name of the mass.

use super::error::UnknownMass;
use super::joined::UnknownContact;
use super::system::System;
use super::units::reversed_phase;
use crate::Complex;
use frictiongen_kernel::Float;
use frictiongen_kernel::motion::{AnyContact, Part};
use frictiongen_kernel::orbit::{Orbit, OrbitMotion};
use std::ops::Deref;

/// The kernel's steady state, with its data in vectors. A [`SystemOrbit`] dereferences to this type.
pub type SystemOrbitState<'a, S = f64> =
    Orbit<'a, S, Vec<Part<S>>, Vec<S>, Vec<Complex<S>>, AnyContact<S>>;

/// The steady motion of the contact or of a mass, in any regime.
pub type SystemOrbitMotion<'o, 'a, S = f64> =
    OrbitMotion<'o, 'a, S, Vec<Part<S>>, Vec<S>, Vec<Complex<S>>, AnyContact<S>>;

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
/// If the motion from rest does not settle, `orbit_or_last_cycles` returns the last 64 cycles of that motion:
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
    pub(super) from_rest: bool,
    /// Number of cycles after which the motion from the initial state has not settled.
    pub(super) unsettled: Option<u32>,
    /// True if the contact slides all the time in this state, although this state is not the closed form. The state and
    /// the closed form then belong to one continuum of steady states, and the regime of the state is continuous.
    pub(super) slides: bool,
}

impl<'a, S: Float> SystemOrbit<'a, S> {
    /// Returns the steady motion of the mass called `name`.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<SystemOrbitMotion<'_, 'a, S>, UnknownMass> {
        Ok(self.orbit.mass(self.system.mass_index(name)?))
    }

    /// Returns the relative motion in the contact called `name`.
    ///
    /// # Errors
    /// [`UnknownContact`] if the contact has another name.
    #[doc(hidden)]
    pub fn contact_named(
        &self,
        name: &str,
    ) -> Result<SystemOrbitMotion<'_, 'a, S>, UnknownContact> {
        let known = &self.system.scene().contact_name;
        if known == name {
            return Ok(self.orbit.contact());
        }
        Err(UnknownContact {
            name: name.to_owned(),
            known: vec![known.clone()],
        })
    }

    /// Returns the phase of the contact's relative motion with the opposite sign, in rad, in (−π, π]. If
    /// [`contact_is_reversed`](System::contact_is_reversed) is true, this phase follows the sign convention of the
    /// scene description.
    #[must_use]
    pub fn reversed_contact_phase(&self) -> S {
        let phase = self.orbit.contact().phase();
        // A rigid contact that never slides has no instant of its largest displacement, and so no reversed phase. An
        // elastic contact has this instant also while it sticks, because its spring deforms.
        let is_rigid = self.system.scene().stiffness.is_none();
        if is_rigid && self.orbit.never_slides() {
            phase
        } else {
            reversed_phase(phase)
        }
    }
}

impl<S> SystemOrbit<'_, S> {
    /// Returns true if the motion from the requested initial state ends in this state. If the result is false, the
    /// motion from that initial state did not settle, and this state is another steady state.
    #[must_use]
    pub fn is_from_rest(&self) -> bool {
        self.from_rest
    }

    /// Returns the number of cycles over which the search followed the motion from the initial state without seeing it
    /// settle. Returns `None` if the motion settles.
    ///
    /// If the result is a number and [`is_settled`](Orbit::is_settled) is true, this state is a stable steady state
    /// that Newton's method found from the states that the motion visited, or the stuck state.
    /// [`is_from_rest`](Self::is_from_rest) is then false. If `is_settled` is false, this state contains the last 64 cycles of the motion.
    #[must_use]
    pub fn cycles_followed(&self) -> Option<u32> {
        self.unsettled
    }

    pub(super) fn sliding(mut self) -> Self {
        self.slides = true;
        self
    }

    pub(super) fn not_from_rest(mut self) -> Self {
        self.from_rest = false;
        self
    }
}

impl<'a, S> Deref for SystemOrbit<'a, S> {
    type Target = SystemOrbitState<'a, S>;

    fn deref(&self) -> &Self::Target {
        &self.orbit
    }
}

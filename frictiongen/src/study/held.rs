//! The response while the contact is stuck, in the middle of its interval or where an initial state leaves it.

use super::motion::SystemStuck;
use super::system::System;
use frictiongen_kernel::Float;
use frictiongen_kernel::response::Scene as _;
use std::ops::Deref;

/// The response while the contact is stuck. Without an [initial state](super::InitialState) of the system, the contact
/// is in the middle z̄ = 0 of the interval in which it may rest.
#[derive(Clone, Debug)]
pub struct SystemHeld<'a> {
    pub(super) stuck: SystemStuck<'a>,
    pub(super) middle: f64,
    pub(super) offset: f64,
    pub(super) offset_range: f64,
    pub(super) from_rest: bool,
}

impl<'a> SystemHeld<'a> {
    /// Returns the middle of the contact's relative displacement z̄ = z/(P/k₁) (z/Y for base motion) in this response.
    #[must_use]
    pub fn middle(&self) -> f64 {
        self.middle
    }

    /// Returns the offset of the contact: the mean z̄ at which the motion from rest, or from the initial state of the
    /// system, leaves the contact.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// Returns the largest offset |z̄| at which friction keeps the contact stuck.
    #[must_use]
    pub fn offset_range(&self) -> f64 {
        self.offset_range
    }

    /// Returns the constant part of the friction force, divided by P (by k₁Y for base motion). The springs of the
    /// chain pull the contact back to z̄ = 0. This constant force balances them. A positive force opposes positive
    /// sliding.
    #[must_use]
    pub fn constant_force(&self) -> f64 {
        -(self.middle / receptance(self.stuck.at().scene()))
    }

    /// Returns the constant displacement x̄ of a mass, which the middle of the contact's motion causes. Returns `None` if the
    /// scene has no mass with this index.
    #[must_use]
    pub fn mass_offset(&self, index: usize) -> Option<f64> {
        let system = *self.stuck.at().scene();
        Some(self.middle * static_share(system, index)?)
    }
}

impl<'a> Deref for SystemHeld<'a> {
    type Target = SystemStuck<'a>;

    fn deref(&self) -> &Self::Target {
        &self.stuck
    }
}

/// Returns the displacement of a mass for a constant unit displacement of the contact. The result is the sum of
/// φ_k(φᵀw)/λ over all modes, divided by the sum of (φᵀw)²/λ over all modes. φ is a mode shape and φ_k its component at
/// the mass. λ is the square of the mode's frequency ratio, and w the direction vector of the contact.
pub(super) fn static_share<S: Float>(system: &System<S>, mass: usize) -> Option<S> {
    let zero = S::constant(0.0);
    let shape = system.shape(mass)?;
    let modes = system.numbers().modes.iter().zip(shape);
    let moved = modes.fold(zero, |moved, (mode, component)| {
        moved + *component * mode.contact / (mode.resonance * mode.resonance)
    });
    Some(moved / receptance(system))
}

/// Returns wᵀK̄⁻¹w, the displacement of the contact for a constant unit force in the contact. w is the contact's
/// direction vector. K̄ is the stiffness matrix divided by k₁.
fn receptance<S: Float>(system: &System<S>) -> S {
    let modes = system.numbers().modes.iter();
    modes.fold(S::constant(0.0), |sum, mode| {
        sum + mode.contact * mode.contact / (mode.resonance * mode.resonance)
    })
}

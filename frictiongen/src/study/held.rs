//! The response while the contact is stuck, at its centre z̄ = 0 or at an offset from its centre.

use super::motion::SystemStuck;
use super::system::System;
use frictiongen_kernel::Float;
use frictiongen_kernel::response::Scene as _;
use std::ops::Deref;

/// The response while the contact is stuck. The contact may have stopped at an offset from its centre z̄ = 0.
#[derive(Clone, Debug)]
pub struct SystemHeld<'a> {
    pub(super) stuck: SystemStuck<'a>,
    pub(super) offset: f64,
    pub(super) offset_range: f64,
    pub(super) from_rest: bool,
}

impl<'a> SystemHeld<'a> {
    /// Returns the offset of the contact: the mean of its relative displacement z̄ = z/(P/k₁) (z/Y for base motion).
    /// The offset is 0 if the contact sticks at its centre.
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
    /// chain pull the contact back from its offset. This constant force balances them. A positive force opposes
    /// positive sliding.
    #[must_use]
    pub fn constant_force(&self) -> f64 {
        -(self.offset / receptance(self.stuck.at().scene()))
    }

    /// Returns the constant displacement x̄ of a mass, which the offset of the contact causes. Returns `None` if the
    /// scene has no mass with this index.
    #[must_use]
    pub fn mass_offset(&self, index: usize) -> Option<f64> {
        let system = *self.stuck.at().scene();
        Some(self.offset * static_share(system, index)?)
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

/// Returns the constant part of z̄, the relative displacement of the contact, in a motion from rest in which the
/// contact never slides. The result is 0, unless the contact is on a moving base.
///
/// At the start of the motion, a moving base is at its largest displacement Y. Every mass is at 0, so that z̄ is −1. A
/// rigid contact keeps this displacement, and the function returns −1.
///
/// In an elastic contact, the spring has no force at z̄ = −1, but the springs of the chain pull the contact towards z̄
/// = 0. The two constant forces are in equilibrium at z̄ = −h/(h + ρ), which the function returns. h is wᵀK̄⁻¹w (see
/// [`receptance`]), and ρ is the compliance of the contact.
pub(super) fn offset_from_rest<S: Float>(system: &System<S>) -> S {
    if system.numbers().chain.on_moving_base.is_none() {
        return S::constant(0.0);
    }
    let share = -S::constant(1.0);
    match system.compliance() {
        None => share,
        Some(compliance) => {
            let receptance = receptance(system);
            share * (receptance / (receptance + compliance))
        }
    }
}

/// Returns wᵀK̄⁻¹w, the displacement of the contact for a constant unit force in the contact. w is the contact's
/// direction vector. K̄ is the stiffness matrix divided by k₁.
fn receptance<S: Float>(system: &System<S>) -> S {
    let modes = system.numbers().modes.iter();
    modes.fold(S::constant(0.0), |sum, mode| {
        sum + mode.contact * mode.contact / (mode.resonance * mode.resonance)
    })
}

//! The response while the contact is stuck, at its centre or off it.

use super::motion::SystemStuck;
use super::system::System;
use frictiongen_kernel::Float;
use frictiongen_kernel::response::Scene as _;
use std::ops::Deref;

/// The response while the contact is stuck, at the offset where it came to rest.
#[derive(Clone, Debug)]
pub struct SystemHeld<'a> {
    pub(super) stuck: SystemStuck<'a>,
    pub(super) offset: f64,
    pub(super) offset_range: f64,
    pub(super) from_rest: bool,
}

impl<'a> SystemHeld<'a> {
    /// z̄ of the contact: 0 if it sticks at its centre.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// The largest |z̄| at which friction can hold the contact.
    #[must_use]
    pub fn offset_range(&self) -> f64 {
        self.offset_range
    }

    /// The constant friction force that holds the contact off its centre, over P, for base motion over k₁Y; positive
    /// against positive sliding.
    #[must_use]
    pub fn constant_force(&self) -> f64 {
        -(self.offset / receptance(self.stuck.at().scene()))
    }

    /// The constant displacement of a mass that the offset brings about; none if there is no such mass.
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

/// By how much a constant displacement of the contact moves a mass, Σφ_k(φᵀw)/λ over Σ(φᵀw)²/λ.
pub(super) fn static_share<S: Float>(system: &System<S>, mass: usize) -> Option<S> {
    let zero = S::constant(0.0);
    let shape = system.shape(mass)?;
    let modes = system.numbers().modes.iter().zip(shape);
    let moved = modes.fold(zero, |moved, (mode, component)| {
        moved + *component * mode.contact / (mode.resonance * mode.resonance)
    });
    Some(moved / receptance(system))
}

/// s: 1 for a contact with the moving base.
pub(super) fn share_of_base(system: &System) -> f64 {
    let on_base = (&system).numbers().chain.on_moving_base.is_some();
    f64::from(u8::from(on_base))
}

/// wᵀK̄⁻¹w, by how much a unit of constant force moves the contact.
fn receptance<S: Float>(system: &System<S>) -> S {
    let modes = system.numbers().modes.iter();
    modes.fold(S::constant(0.0), |sum, mode| {
        sum + mode.contact * mode.contact / (mode.resonance * mode.resonance)
    })
}

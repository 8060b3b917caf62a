//! Sums over the modes: projections, static displacements, and the acceleration of the contact that damping relative
//! to a moving base causes. A sum that is only rounding noise becomes zero.

use crate::jacobi::dot;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;

/// Returns the scalar product of the unit vector `vector` and the vector `on`. A product of at most `noise` times the
/// length of `on` is only rounding noise, and becomes exactly zero.
pub(crate) fn projected(vector: &[Dd], on: &[Dd], noise: f64) -> Dd {
    cleaned(dot(vector, on), dot(on, on).sqrt(), noise)
}

/// Returns the static relative displacements of the contact: wᵀK̄⁻¹p − s under a unit load, and wᵀK̄⁻¹w under a unit
/// force in the contact. w is the contact direction, K̄ the stiffness matrix and p the load vector. s (`carried`) is 1
/// if the contact slides on the moving base, otherwise 0.
pub(crate) fn static_sums<T: Float>(
    carried: T,
    resonances: &[T],
    loads: &[T],
    contacts: &[T],
    noise: f64,
) -> (T, T) {
    let (mut motion, mut size) = (-carried, carried);
    let mut receptance = T::constant(0.0);
    for ((resonance, load), contact) in resonances.iter().zip(loads).zip(contacts) {
        let lambda = *resonance * *resonance;
        let term = *contact * *load / lambda;
        motion = motion + term;
        size = size + term.abs();
        receptance = receptance + *contact * *contact / lambda;
    }
    (cleaned(motion, size, noise), receptance)
}

/// Returns Σ φᵀw·2ζ√λ·g over the modes, where g is the participation factor of a mode for base motion. This sum is
/// wᵀΓ⁻¹C̄1/r, the relative acceleration of the contact that damping causes if the base moves at unit velocity. Without
/// participation factors the sum is 0.
pub(crate) fn inertial_drag<T: Float>(
    (resonances, damping_ratios): (&[T], &[T]),
    (contacts, participations): (&[T], &[T]),
    noise: f64,
) -> T {
    let (mut drag, mut size) = (T::constant(0.0), T::constant(0.0));
    let modes = resonances.iter().zip(damping_ratios);
    for ((resonance, zeta), (contact, participation)) in
        modes.zip(contacts.iter().zip(participations))
    {
        let term = *contact * (*zeta + *zeta) * *resonance * *participation;
        drag = drag + term;
        size = size + term.abs();
    }
    cleaned(drag, size, noise)
}

pub(crate) fn cleaned<T: Float>(value: T, size: T, noise: f64) -> T {
    if value.abs() <= size * T::constant(noise) {
        value.replaced(0.0)
    } else {
        value
    }
}

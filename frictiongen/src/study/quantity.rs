//! Quantities of a motion.

/// Selects a quantity: the displacement, velocity or acceleration of a motion, or a quantity of the contact. The
/// largest displacement, velocity or acceleration is divided by P/k₁ (by Y for base motion).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MotionQuantity {
    /// The quantity is the largest displacement |x̄|.
    Displacement,
    /// The quantity is the largest velocity |dx̄/dτ|. Multiplied by ω, it is |dx̄/dt|.
    Velocity,
    /// The quantity is the largest acceleration |d²x̄/dτ²|. Multiplied by ω², it is |d²x̄/dt²|.
    Acceleration,
    /// The quantity is the largest force in the contact, divided by P (by k₁Y for base motion). Only the contact has
    /// this quantity.
    Force,
    /// The quantity is the energy that the contact dissipates in a cycle of the excitation, divided by P²/k₁ (by k₁Y²
    /// for base motion). Only the contact has this quantity.
    Energy,
    /// The quantity is the equivalent viscous damping ratio ζ_eq = E_d/(4πE_s) of the contact. E_d is the energy that
    /// friction dissipates in a cycle. E_s is the sum of ½kX² of all springs, or ½kX² of one spring, where X is the
    /// centred amplitude of the elongation. [`Of::Contact`](crate::Of::Contact) selects all springs, and
    /// [`Of::Spring`](crate::Of::Spring) selects one spring.
    Damping,
}

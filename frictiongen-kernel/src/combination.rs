//! Linear combinations of the displacements of masses and of the base, such as a drift between two storeys.

/// The combination Σ c_k x̄_k + b ȳ of the displacements of the masses and of the base.
///
/// ȳ = cos τ_e is the motion of the base, with τ_e counted from a maximum of the excitation. A mass relative to the
/// moving base has b = −1.
#[derive(Clone, Copy, Debug)]
pub struct Combination<'s, S> {
    /// Σ c_k φ_k, the component of the combination in each mode shape.
    pub shape: &'s [S],
    /// Coefficient b of the base's motion. It is 0 if no base moves.
    pub base: S,
}

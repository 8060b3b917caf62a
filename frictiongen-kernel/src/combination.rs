//! Linear combinations of the displacements of masses and of the base, such as a drift between two storeys.

/// The linear combination Σ c_k x̄_k + b ȳ of the displacements of masses and base. x̄_k is the displacement of mass k,
/// and ȳ is that of the base.
///
/// The motion of the base is ȳ = cos τ_e. The phase τ_e is 0 at a maximum of the excitation. The displacement of a mass
/// relative to the moving base has b = −1.
#[derive(Clone, Copy, Debug)]
pub struct Combination<'s, S> {
    /// Σ c_k φ_k, the component of the combination in each mode. φ_k is the component of mass k in the mode shape.
    pub shape: &'s [S],
    /// Coefficient b of the base's motion. It is 0 if no base moves.
    pub base: S,
}

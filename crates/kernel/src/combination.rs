//! Linear combinations of the displacements of masses and of the base, such as a drift between two storeys.

/// The linear combination Σ c_k x̄_k + b ȳ of displacements, with the coefficients c_k and b. x̄_k is the displacement
/// of mass k, and ȳ is the displacement of the base.
///
/// The motion of the base is ȳ = cos τ_e. The phase τ_e is 0 at a maximum of the excitation. The displacement of a mass
/// relative to the moving base has b = −1.
#[derive(Clone, Copy, Debug)]
pub struct Combination<'s, S> {
    /// Component Σ c_k φ_k of the combination in each mode. c_k is the coefficient of mass k in the combination, and
    /// φ_k the component of mass k in the mode shape.
    pub shape: &'s [S],
    /// Coefficient b of the displacement of the base. The coefficient is 0 if the base does not move.
    pub base: S,
}

//! Loads in quadrature (90° out of phase) with the motion of the base.
//!
//! If damping acts on velocities relative to the moving base, the velocity ẏ of the base causes an additional load
//! C·1·ẏ. C is the damping matrix and 1 the vector of ones. The springs on the base cause the load K_b·y in phase with
//! the displacement y of the base (section 1 of `docs/derivation.md`). Divided by the displacement of the base, the
//! total load on mode i is p_i + 2iζ_iλ_iΓ_i/x_i. Here Γ_i = φᵀΓ1 is the participation factor, and x_i = √λ_i/r. If
//! damping acts on absolute velocities, the scene has no load in quadrature. The scene then uses the type [`InPhase`],
//! so that its formulas have no additional cost.

/// Load of one mode in quadrature (90° out of phase) with the motion of the base.
#[derive(Clone, Copy, Debug)]
pub struct Quadrature<S> {
    /// 2ζλΓ: the imaginary part of the load on the mode, multiplied by x = √λ/r. ζ is the damping ratio, λ the squared
    /// frequency ratio, and Γ = φᵀΓ1 the participation factor of the mode.
    pub load: S,
    /// Static residue of the mode, minus (φᵀw)Γ with the participation factor Γ of the mode. `wall` is 0 if only the
    /// base supports the chain, because each static displacement then equals the displacement of the base.
    pub wall: S,
}

/// Loads of all modes in quadrature (90° out of phase) with the motion of the base.
pub trait Quadratures<S>: Copy {
    /// Returns the load of a mode in quadrature with the base, or `None` if the mode has no load in quadrature.
    fn of(self, mode: usize) -> Option<Quadrature<S>>;
}

/// Type for a scene in which no mode has a load in quadrature.
#[derive(Clone, Copy, Debug)]
pub struct InPhase;

impl<S> Quadratures<S> for InPhase {
    #[inline(always)]
    fn of(self, _: usize) -> Option<Quadrature<S>> {
        None
    }
}

/// List of [`Quadrature`] values, one for each mode. Each list entry contains `load` and `wall`, in this order. An
/// empty list means that no mode has a load in quadrature.
impl<S: Copy> Quadratures<S> for &[[S; 2]] {
    #[inline]
    fn of(self, mode: usize) -> Option<Quadrature<S>> {
        self.get(mode)
            .map(|&[load, wall]| Quadrature { load, wall })
    }
}

//! Loads in quadrature (90° out of phase) with the motion of the base.
//!
//! Damping on velocities relative to the moving base adds the load C·1·ẏ to the load K_b·y of the springs (section 1 of
//! `docs/derivation.md`). Divided by the displacement of the base, the total load on mode i is p_i + 2iζ_iλ_iΓ_i/x_i.
//! Here Γ_i = φᵀΓ1 is the participation factor, and x_i = √λ_i/r. If damping acts on absolute velocities, the scene has
//! no load in quadrature. The scene then uses the type [`InPhase`], so that its formulas have no additional cost.

use crate::contact::sums::{Chain, ModeAt};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

/// Load of one mode in quadrature (90° out of phase) with the motion of the base.
#[derive(Clone, Copy, Debug)]
pub struct Quadrature<S> {
    /// 2ζλΓ: the imaginary part of the load on the mode, multiplied by x = √λ/r. ζ is the damping ratio, λ the squared
    /// frequency ratio, and Γ = φᵀΓ1 the participation factor of the mode.
    pub load: S,
    /// Static residue of the mode, minus (φᵀw)Γ with the participation factor Γ of the mode. If only the base supports
    /// the chain, each static displacement equals the displacement of the base. This difference is then 0.
    pub wall: S,
}

/// Loads of all modes in quadrature (90° out of phase) with the motion of the base.
pub trait Quadratures<S>: Copy {
    /// Returns the load of a mode in quadrature, or `None` if it has none.
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

/// List of [`Quadrature`] values, one for each mode. Each entry contains `load` and `wall`, in this order. An empty
/// list means that no mode has a load in quadrature.
impl<S: Copy> Quadratures<S> for &[[S; 2]] {
    #[inline]
    fn of(self, mode: usize) -> Option<Quadrature<S>> {
        self.get(mode)
            .map(|&[load, wall]| Quadrature { load, wall })
    }
}

impl<S: Scalar> Mode<S> {
    /// Returns the response of the mode to its load, multiplied by `factor`. The load has a component in phase with the
    /// excitation, and possibly a component in quadrature (90° out of phase).
    #[inline]
    pub(crate) fn driven(
        &self,
        at: &ModeAt<S>,
        factor: S,
        quadrature: Option<Quadrature<S>>,
        index: usize,
    ) -> Complex<S> {
        match quadrature {
            None => {
                let by_load = factor * self.load;
                let about = "φ_k(φᵀp), from the load to mass k";
                complex::scale(at.response, by_load.named("by_load", about, Some(index)))
            }
            Some(Quadrature { load, .. }) => {
                let load = Complex::new(factor * self.load, factor * (load / at.x));
                complex::mul(at.response, load, true)
            }
        }
    }
}

impl<S: Scalar> Chain<S> {
    /// Returns the term of a mode in V, the response of the contact to the load. On a moving base V is relative to the
    /// base. The function then uses v − 1 = (1 − 2iζx)/(x² − 1 + 2iζx) in place of the response v of the mode. This
    /// avoids a difference of nearly equal numbers. If damping acts relative to the base, the motion of the base alone
    /// causes no damping force. In this case `wall` replaces the static residue in the imaginary part.
    #[inline]
    pub(crate) fn load_term(
        &self,
        mode: &Mode<S>,
        at: &ModeAt<S>,
        quadrature: Option<Quadrature<S>>,
    ) -> Complex<S> {
        let two = S::constant(2.0);
        match (self.on_moving_base, quadrature) {
            (None, None) => complex::scale(at.response, mode.residue),
            (None, Some(Quadrature { load, .. })) => {
                let load = Complex::new(mode.residue, mode.contact * (load / at.x));
                complex::mul(at.response, load, true)
            }
            (Some(_), None) => {
                let lag = Complex::new(S::constant(1.0), -(two * mode.zeta * at.x));
                complex::scale(
                    complex::mul(at.response, lag, self.damped),
                    mode.static_residue,
                )
            }
            (Some(_), Some(Quadrature { wall, .. })) => {
                let lag = Complex::new(mode.static_residue, -(two * mode.zeta * at.x * wall));
                complex::mul(at.response, lag, true)
            }
        }
    }
}

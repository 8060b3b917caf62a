//! Loads in quadrature with the motion of the base.
//!
//! Damping that acts on velocities relative to the moving base adds the load C·1·ẏ to K_b·y (section 1 of
//! `docs/derivation.md`). On mode i the load of both is p_i + 2iζ_iλ_iΓ_i/x_i over the displacement of the base, with
//! the participation factor Γ_i = φᵀΓ1 and x_i = √λ_i/r. A scene whose damping acts on absolute velocities has no load
//! in quadrature. The type [`InPhase`] stands for that, so that its formulas cost nothing there.

use crate::contact::sums::{Chain, ModeAt};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

/// Load of one mode in quadrature with the motion of the base.
#[derive(Clone, Copy, Debug)]
pub struct Quadrature<S> {
    /// 2ζλΓ, with the participation factor Γ = φᵀΓ1: x times the load in quadrature.
    pub load: S,
    /// Static residue less (φᵀw)Γ. It is 0 in a chain that only the base holds, because the static displacement is
    /// then that of the base.
    pub wall: S,
}

/// Loads of all modes in quadrature with the motion of the base.
pub trait Quadratures<S>: Copy {
    /// Returns the load of a mode in quadrature, or `None` if it has none.
    fn of(self, mode: usize) -> Option<Quadrature<S>>;
}

/// No mode has a load in quadrature.
#[derive(Clone, Copy, Debug)]
pub struct InPhase;

impl<S> Quadratures<S> for InPhase {
    #[inline(always)]
    fn of(self, _: usize) -> Option<Quadrature<S>> {
        None
    }
}

/// The fields of [`Quadrature`] for each mode in turn. An empty list stands for no load in quadrature.
impl<S: Copy> Quadratures<S> for &[[S; 2]] {
    #[inline]
    fn of(self, mode: usize) -> Option<Quadrature<S>> {
        self.get(mode)
            .map(|&[load, wall]| Quadrature { load, wall })
    }
}

impl<S: Scalar> Mode<S> {
    /// Returns the response of the mode to the load, times `factor`: the load in phase with the excitation, and the load
    /// in quadrature if there is one.
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
    /// base, so that v − 1 = (1 − 2iζx)/(x² − 1 + 2iζx) replaces v. The base motion is then never subtracted. Where
    /// damping acts relative to the base, the loss of the base's own motion is missing from that numerator.
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

//! Response of one mode to the load, and response of the contact to the load.

use crate::contact::quadrature::Quadrature;
use crate::contact::sums::{Chain, ModeAt};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

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
    /// Returns the term of a mode in V, the response of the contact to the load.
    ///
    /// On a moving base V is relative to the base. The function then replaces the response v of the mode by v − 1 = (1
    /// − 2iζx)/(x² − 1 + 2iζx). This formula avoids a difference of nearly equal numbers. If damping acts relative to
    /// the base, a chain that moves with the base has no damping force. In this case `wall` replaces the static
    /// residue in the imaginary part.
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

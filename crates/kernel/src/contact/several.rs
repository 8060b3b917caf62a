//! Limits β_lim and β*_lim, computed for several frequencies at the same time, without the search for the velocity
//! constraint S.
//!
//! The processor evaluates several frequencies at the same time with packed (SIMD) instructions. The operations and
//! their order are the same as for one frequency. The results are therefore equal to the last bit.

use crate::contact::pairs::{Light, UndampedPairs, Uniform};
use crate::contact::sums::{Chain, ContactAt};
use crate::number::lanes::Lanes;
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::mode::{Kind, Mode};

/// Number of frequencies that the code computes at the same time. Four numbers fill two packed registers of two numbers
/// each. Eight numbers fill one register, if the processor has registers of that size.
pub(crate) const SIDE_BY_SIDE: usize = if cfg!(target_feature = "avx512f") {
    8
} else {
    4
};

/// Limits β_lim and β*_lim at several frequencies, from formulas without a search. The formula of β_lim uses the
/// break-away term instead of the velocity constraint S. β*_lim contains no correction for masses that act as an
/// absorber.
#[derive(Debug)]
pub(crate) struct Several<S> {
    pub continuous: [S; SIDE_BY_SIDE],
    pub sliding: [S; SIDE_BY_SIDE],
    /// Real part of the receptance H of the contact, multiplied by r² and by the scale E of [`ContactAt`]. If `h` is
    /// small, masses may act as an absorber.
    pub h: [S; SIDE_BY_SIDE],
}

impl<S: Float> Several<S> {
    pub(crate) fn new() -> Self {
        let none = [S::constant(0.0); SIDE_BY_SIDE];
        Self {
            continuous: none,
            sliding: none,
            h: none,
        }
    }
}

impl<S: Float> Chain<S> {
    /// Returns the kind of damping that all modes share, if all are undamped or all are lightly damped. Returns `None`
    /// for other chains, and if the contact drives no mode. Also returns `None` for a scalar type of which no
    /// processor computes two numbers at the same time.
    pub(crate) fn kind_of_several(&self, modes: &[Mode<S>]) -> Option<Kind> {
        let touched = modes.iter().any(|mode| mode.in_contact);
        self.common_kind(modes).filter(|_| touched)
    }

    /// Computes the limits β_lim and β*_lim at several 1/r, without the search for the velocity constraint S. `kind` is
    /// the result of [`kind_of_several`](Self::kind_of_several).
    pub(crate) fn several_limits(
        &self,
        modes: &[Mode<S>],
        kind: Kind,
        inverse_r: &[S; SIDE_BY_SIDE],
        found: &mut Several<S>,
    ) {
        match kind {
            Kind::Undamped => self.side_by_side::<UndampedPairs>(modes, inverse_r, found),
            _ => self.side_by_side::<Light>(modes, inverse_r, found),
        }
    }

    /// Computes the limits β_lim and β*_lim at several frequencies for the kind of damping `U`. Because the compiler
    /// does not inline the function, its results are stored in arrays. The compiler then uses packed instructions.
    #[inline(never)]
    fn side_by_side<U: Uniform>(
        &self,
        modes: &[Mode<S>],
        inverse_r: &[S; SIDE_BY_SIDE],
        found: &mut Several<S>,
    ) {
        let chain = Chain {
            damped: U::DAMPED,
            ..self.in_lanes()
        };
        let inverse_r = Lanes(*inverse_r);
        let single = modes.len() == 1;
        let touched = || {
            let touched = modes.iter().filter(|mode| mode.in_contact);
            touched.map(|mode| Mode::beside(U::KIND, &[*mode; SIDE_BY_SIDE]))
        };
        let least = touched().fold(Lanes::constant(f64::INFINITY), |least, mode| {
            least.min(mode.size_but_zero(U::KIND, inverse_r))
        });
        // The scale E, the smallest |x² − 1| among the modes, must not be 0. If x² − 1 of a mode is exactly zero, the
        // code therefore replaces it by a small number. It makes this replacement only in the smallest |x² − 1|, as
        // the sums over pairs of modes do.
        let scale = if U::DAMPED {
            least
        } else {
            least.detuning_off_pole()
        };
        let mut sum = ContactAt::zero(scale);
        for mode in touched() {
            let response = mode.functions_of(U::KIND, inverse_r, false, 0);
            let at = chain.scaled(&response, scale, single, 0);
            sum = chain.joined_by(&sum, &mode, &response, &at, single, false);
        }
        let contact = chain.completed(&sum, inverse_r);
        found.continuous = chain
            .continuous_limit(&contact, chain.break_away(&contact))
            .0;
        found.sliding = chain.sliding_limit(&contact).0;
        found.h = contact.h.re.0;
    }
}

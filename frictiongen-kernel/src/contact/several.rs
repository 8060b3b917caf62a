//! Both limits without search at several frequencies side by side, which a processor takes at once.
//!
//! The formulas are those of one frequency, in the same order: the bits are the same.

use crate::contact::pairs::{Light, Undamped, Uniform};
use crate::contact::sums::{Chain, ContactAt};
use crate::number::lanes::Lanes;
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::mode::{Kind, Mode};

/// So many frequencies: two registers of two numbers, or one of eight where the target has such.
pub(crate) const SIDE_BY_SIDE: usize = if cfg!(target_feature = "avx512f") {
    8
} else {
    4
};

/// What limits without search are at several frequencies, as if nothing absorbed.
#[derive(Debug)]
pub(crate) struct Several<S> {
    pub continuous: [S; SIDE_BY_SIDE],
    pub sliding: [S; SIDE_BY_SIDE],
    /// The real part of H times r²E, which tells whether something may absorb.
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
    /// The kind of all modes, if frequencies may go side by side: where no mode is in contact there is no scale.
    pub(crate) fn kind_of_several(&self, modes: &[Mode<S>]) -> Option<Kind> {
        let touched = modes.iter().any(|mode| mode.in_contact);
        self.common_kind(modes).filter(|_| touched)
    }

    /// Both limits without search at several 1/r, for modes [of a kind](Self::kind_of_several).
    pub(crate) fn several_limits(
        &self,
        modes: &[Mode<S>],
        kind: Kind,
        inverse_r: &[S; SIDE_BY_SIDE],
        found: &mut Several<S>,
    ) {
        match kind {
            Kind::Undamped => self.side_by_side::<Undamped>(modes, inverse_r, found),
            _ => self.side_by_side::<Light>(modes, inverse_r, found),
        }
    }

    /// Not inlined: the compiler packs what is stored side by side.
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
        // As in the sums over pairs of modes: an exact zero is replaced once, in the smallest.
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

//! Both limits without search at several frequencies side by side, which a processor takes at once.
//!
//! The formulas are those of one frequency, in the same order: the bits are the same.

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

type Side<S> = Lanes<S, SIDE_BY_SIDE>;

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
    /// The kind of all modes, if they are undamped or all lightly damped and some are in contact: only then they go side
    /// by side.
    pub(crate) fn common_kind(&self, modes: &[Mode<S>]) -> Option<Kind> {
        let kind = if self.damped {
            Kind::Light
        } else {
            Kind::Undamped
        };
        let common = modes.iter().all(|mode| mode.kind == kind);
        let touched = modes.iter().any(|mode| mode.in_contact);
        (S::PAIRS && common && touched).then_some(kind)
    }

    /// Whether V = H and μ = 1, so that β*_lim is 1.
    pub(crate) fn pushed_where_it_rubs(&self, modes: &[Mode<S>]) -> bool {
        self.on_moving_base.is_none()
            && self.stiction == S::constant(1.0)
            && modes.iter().all(|mode| mode.residue == mode.inverse_mass)
    }

    /// Both limits without search at several 1/r, for modes of [a common kind](Self::common_kind).
    pub(crate) fn several_limits(
        &self,
        modes: &[Mode<S>],
        kind: Kind,
        inverse_r: &[S; SIDE_BY_SIDE],
        found: &mut Several<S>,
    ) {
        match kind {
            Kind::Undamped => self.side_by_side::<false>(modes, inverse_r, found),
            _ => self.side_by_side::<true>(modes, inverse_r, found),
        }
    }

    /// Not inlined: the compiler packs what is stored side by side.
    #[inline(never)]
    fn side_by_side<const DAMPED: bool>(
        &self,
        modes: &[Mode<S>],
        inverse_r: &[S; SIDE_BY_SIDE],
        found: &mut Several<S>,
    ) {
        let kind = if DAMPED { Kind::Light } else { Kind::Undamped };
        let chain = Chain {
            damped: DAMPED,
            on_moving_base: self.on_moving_base.map(Side::all),
            inverse_mass: Side::all(self.inverse_mass),
            stiction: Side::all(self.stiction),
        };
        let inverse_r = Lanes(*inverse_r);
        let single = modes.len() == 1;
        let touched = || modes.iter().filter(|mode| mode.in_contact).map(wide);
        let least = touched().fold(Side::constant(f64::INFINITY), |least, mode| {
            least.min(mode.size_but_zero(kind, inverse_r))
        });
        // As in the sums over pairs of modes: an exact zero is replaced once, in the smallest.
        let scale = if DAMPED {
            least
        } else {
            least.detuning_off_pole()
        };
        let mut sum = ContactAt::zero(scale);
        for mode in touched() {
            let response = mode.functions_of(kind, inverse_r, false, 0);
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

/// A mode at every frequency.
#[inline(always)]
fn wide<S: Float>(mode: &Mode<S>) -> Mode<Side<S>> {
    Mode {
        kind: mode.kind,
        in_contact: mode.in_contact,
        resonance: Lanes::all(mode.resonance),
        zeta: Lanes::all(mode.zeta),
        q: Lanes::all(mode.q),
        q_defect: Lanes::all(mode.q_defect),
        load: Lanes::all(mode.load),
        contact: Lanes::all(mode.contact),
        residue: Lanes::all(mode.residue),
        inverse_mass: Lanes::all(mode.inverse_mass),
        static_residue: Lanes::all(mode.static_residue),
    }
}

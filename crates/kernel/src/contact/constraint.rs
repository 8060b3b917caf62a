//! Searches for the velocity constraint S, the maximum of F/sin τ in the half period, where F is a sum over the modes.
//! Each search proves that no larger value exists. The module also decides whether a continuous motion exists.

use crate::contact::regime::check_beta;
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::errors::{NotContinuous, StuckResonance};
use crate::modal_sum::search::{self, Peak, SearchSettings, Weight};
use crate::modal_sum::wave::{Sum, Wave};
use crate::number::complex;
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;
use crate::oscillator::mode::Mode;

/// Safety margin for the comparison of β with the computed β_lim, in rounding units. If β is less than the computed
/// β_lim by more than this margin, β is also less than the exact β_lim. The search for β_lim contributes an error of
/// up to four units. The formula of β_lim contributes the remaining error.
const CLEAR: f64 = 32.0;
/// Upper bound on the phase error of a mode that the rounding of r causes, as a fraction of a half turn. If the error
/// of a fast mode is larger, two searches at the same r may differ. The code then skips the cheaper search, which only
/// compares S with the largest value that β permits.
const UNTURNED: f64 = 1e-4;

/// Upper bound on the relative tolerance of a search for the velocity constraint S. If β_lim hardly depends on S, a
/// larger tolerance would suffice for β_lim itself. But a larger tolerance would make the amplitude of the motion at
/// β_lim inaccurate.
const MOST_TOLERANCE: f64 = 1.0 / 4096.0;

impl<S: Float> Chain<S> {
    /// Finds max(S, H_c + μm*/r²), on which β_lim depends, multiplied by r² and by the scale E of [`ContactAt`]. The
    /// velocity constraint S (5.54, 7.36) is the maximum of F/sin τ in the half period, where F is a sum over the
    /// modes. A search finds S and proves that no larger value exists. The search starts from the break-away term
    /// H_c + μm*/r². `waves` is working space with one element for each mode.
    pub fn velocity_constraint<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        waves: &mut [Wave<S, D>],
    ) -> Peak<S> {
        fill(contact, modes, at, waves);
        self.constraint_of(contact, at, waves)
    }

    /// Finds max(S, H_c + μm*/r²) as [`velocity_constraint`](Self::velocity_constraint) does. The caller has already
    /// written the terms of all modes to `waves`.
    fn constraint_of<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        at: &[ModeAt<S>],
        waves: &[Wave<S, D>],
    ) -> Peak<S> {
        let start = self.start_constraint(contact);
        // The code computes `above` = (μ − 1)m*E directly. A difference of two sums would lose digits, because the
        // damping term H_c outweighs all other terms of the sums close to a resonance.
        let above = (self.stiction - S::constant(1.0)) * self.inverse_mass * contact.scale;
        let mut peak = self.constraint_above(contact, at, waves, start, above);
        peak.value = if peak.places[0].is_some() {
            start + peak.value
        } else {
            self.break_away(contact)
        };
        peak
    }

    /// Returns true if F/sin τ, whose maximum is the velocity constraint S, is known to be largest for τ → 0. No
    /// search for S is then needed. F is a sum over the modes. In an undamped chain the result is true if R ≥ 1/2 for
    /// every mode. R is the excitation frequency divided by the natural frequency of the mode. `ratios` contains x =
    /// 1/R of the modes.
    pub(crate) fn start_decides(&self, mut ratios: impl Iterator<Item = S>) -> bool {
        !self.damped && ratios.all(|x| x <= S::constant(2.0))
    }

    /// Returns r²E·S − `start`, or `above` if this difference is less than `above`. The velocity constraint S is the
    /// maximum of F/sin τ, where F is a sum over the modes. E is the scale of [`ContactAt`], and `start` the limit of
    /// r²E·F/sin τ for τ → 0.
    fn constraint_above<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        at: &[ModeAt<S>],
        waves: &[Wave<S, D>],
        start: S,
        above: S,
    ) -> Peak<S> {
        let decided = self.start_decides(at.iter().map(|at| at.x));
        // If rounding makes the phase of every mode meaningless, a search cannot improve the result.
        if decided || waves.iter().all(Wave::turns_unknown) {
            return Peak {
                value: above,
                places: [None; 4],
                evaluations: 0,
                exceeded: false,
            };
        }
        let zero = S::constant(0.0);
        let at_start = |sum: S, wave: &Wave<S, D>| {
            let two_zeta = wave.decay.zeta() + wave.decay.zeta();
            sum - two_zeta * wave.x * wave.forced_slope
        };
        let sum = Sum {
            waves,
            cosine: zero,
            sine: waves.iter().fold(zero, at_start),
        };
        // β_lim depends on U² + S², with the damping function U of the contact. If U is larger than S, fewer digits of
        // S suffice.
        let ratio = contact.u / (start + above);
        let tolerance = S::constant(4.0 * S::RESOLUTION) * (S::constant(1.0) + ratio * ratio);
        search::largest(
            sum,
            SearchSettings {
                weight: Weight::Sine,
                both_signs: !self.damped,
                end: if self.damped {
                    S::pi()
                } else {
                    S::pi() * S::constant(0.5)
                },
                floor: above,
                start,
                tolerance: tolerance.min(S::constant(MOST_TOLERANCE)),
            },
        )
    }

    /// Returns max(S, H_c + μm*/r²) with the thesis's approximation of the velocity constraint S (5.55, 7.37),
    /// multiplied by r² and by the scale E of [`ContactAt`]. The thesis adds the maxima of the single modes. The
    /// result is an upper bound, because the exact S is the maximum of the sum over the modes.
    pub fn constraint_per_mode<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
    ) -> S {
        let mut sum = S::constant(0.0);
        for (mode, at) in modes.iter().zip(at) {
            if mode.in_contact {
                let wave: Wave<S, D> = constraint_wave(mode, at, contact, S::constant(1.0));
                let two_zeta = mode.zeta + mode.zeta;
                // For τ → 0, the constraint of a single mode has the limit 1 + g + 2ζRu. u and g are the mode's damping
                // functions, and R = 1/x.
                let start = contact.scale + at.g + two_zeta * at.u * at.x;
                let at = core::slice::from_ref(at);
                let above = S::constant(0.0);
                let peak = self.constraint_above(contact, at, &[wave], start, above);
                sum = sum + mode.contact_squared * (start + peak.value);
            }
        }
        sum.max(self.break_away(contact))
    }

    /// Returns true if β is less than the exact limit of continuous motion β_lim. For most β the function does not
    /// compute β_lim. Instead, a cheaper search only decides whether the velocity constraint S exceeds the largest
    /// value that β permits.
    pub fn is_continuous<D: Decay<S>>(
        &self,
        beta: S,
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        waves: &mut [Wave<S, D>],
    ) -> bool {
        if !(beta < self.continuous_limit(contact, self.break_away(contact))) {
            return false;
        }
        fill(contact, modes, at, waves);
        let break_away = self.break_away(contact);
        let excitation = complex::modulus(contact.v, self.damped);
        let quadrature = beta * contact.u;
        // The product (|V| − βU)(|V| + βU) may underflow. The product of the two square roots does not.
        let root = (excitation - quadrature).sqrt() * (excitation + quadrature).sqrt();
        let allowed = S::constant(1.0 - 1e-3) * root / beta;
        // If the damping function U is much larger than S, `allowed` is mainly rounding error. The cheaper search then
        // proves nothing.
        let beyond = beta * S::constant(1.0 + CLEAR * S::RESOLUTION);
        let clear = beyond < self.continuous_limit(contact, allowed);
        // For a very small r, the rounding of r shifts the phase of a mode noticeably, so that two searches would
        // differ.
        let fastest = S::constant(UNTURNED / S::RESOLUTION);
        let clear = clear && at.iter().all(|at| at.x < fastest);
        if break_away < allowed && allowed.is_finite() && clear {
            let start = self.start_constraint(contact);
            let above = allowed - start;
            let peak = self.constraint_above(contact, at, waves, start, above);
            // A search that stopped at its largest number of evaluations has not proven that `above` is an upper bound.
            if peak.value <= above && !peak.exceeded {
                return true;
            }
        }
        let constraint = self.constraint_of(contact, at, waves).value;
        beta < self.continuous_limit(contact, constraint)
    }
}

impl<S: Float> Chain<S> {
    /// Checks that a bounded continuous motion exists, which requires β < β_lim. Returns β, or 0 at r = ∞ if friction
    /// has no effect there. β*_lim is not part of the condition, because for μ > 1 a stuck state may coexist with the
    /// continuous motion. `unbounded` contains the undamped resonances that the load drives. `at_infinity` is β_lim
    /// for r → ∞.
    ///
    /// # Errors
    /// Any variant of [`NotContinuous`].
    #[allow(clippy::too_many_arguments, reason = "one question on one frequency")]
    pub fn admitted<D: Decay<S>>(
        &self,
        r: S,
        beta: S,
        sliding: S,
        at_infinity: S,
        unbounded: &[S],
        contact: &ContactAt<S>,
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        waves: &mut [Wave<S, D>],
    ) -> Result<S, NotContinuous> {
        let beta = check_beta(beta).map_err(|_| NotContinuous::OutOfDomain)?;
        let refused = || {
            if beta < sliding {
                NotContinuous::StickSlip
            } else {
                NotContinuous::Stuck
            }
        };
        if !r.is_finite() {
            // At r = ∞ the code compares β with the known limit of β_lim, because sums at a large r would round β_lim
            // differently. If the contact is on a moving base, or if damping acts relative to the base, this limit may
            // be infinite. Friction then has no effect, and the formulas use β = 0.
            if !(beta < at_infinity) {
                return Err(refused());
            }
            let felt = at_infinity.is_finite();
            return Ok(if felt { beta } else { S::constant(0.0) });
        }
        if !(S::constant(0.0) < r && self.is_continuous(beta, contact, modes, at, waves)) {
            return Err(refused());
        }
        if unbounded.contains(&r) {
            return Err(NotContinuous::Unbounded);
        }
        Ok(beta)
    }

    /// Returns an error if r is an undamped resonance of the chain with its contact stuck. `invisible` contains the
    /// undamped resonances that the load drives and on which the contact does not act.
    ///
    /// # Errors
    /// [`StuckResonance`].
    pub fn stuck_admitted(
        &self,
        r: S,
        contact: &ContactAt<S>,
        invisible: &[S],
    ) -> Result<(), StuckResonance> {
        let zero = S::constant(0.0);
        if (contact.h.re == zero && contact.h.im == zero) || invisible.contains(&r) {
            return Err(StuckResonance);
        }
        Ok(())
    }
}

/// Writes the term of each mode in the velocity constraint to the working space `waves`.
fn fill<S: Float, D: Decay<S>>(
    contact: &ContactAt<S>,
    modes: &[Mode<S>],
    at: &[ModeAt<S>],
    waves: &mut [Wave<S, D>],
) {
    debug_assert_eq!(modes.len(), at.len(), "every mode at this r");
    debug_assert_eq!(modes.len(), waves.len(), "a wave for each mode");
    for ((mode, at), wave) in modes.iter().zip(at).zip(waves) {
        *wave = constraint_wave(mode, at, contact, mode.contact_squared);
    }
}

/// Returns the term of a mode in F − `start`·sin τ. F is the sum over the modes whose quotient F/sin τ has the
/// velocity constraint S as its maximum. `start` is the limit of F/sin τ for τ → 0.
///
/// The term is −m·(1 + g)·(sin τ − p) + m·u·((cos τ − p′) − 2ζx·sin τ), with m = (φᵀw)². p is the free displacement of
/// the mode, and u and g are its damping functions. The function leaves out −2ζx·m·u·sin τ, which the caller adds for
/// all modes together.
///
/// Close to a resonance, F is nearly proportional to sin τ. A subtraction of `start`·sin τ from F would leave mainly
/// rounding error. The formula of the term contains no subtraction of nearly equal numbers.
fn constraint_wave<S: Float, D: Decay<S>>(
    mode: &Mode<S>,
    at: &ModeAt<S>,
    contact: &ContactAt<S>,
    inverse_mass: S,
) -> Wave<S, D> {
    let mut wave = Wave::at_rest(at.x, D::of(mode));
    if mode.in_contact {
        wave.forced = -(inverse_mass * (contact.scale + at.g));
        wave.forced_slope = inverse_mass * at.u;
    }
    wave
}

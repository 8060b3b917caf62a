//! The velocity constraint by a guaranteed search, and whether a motion is admitted.

use crate::contact::regime::check_beta;
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::errors::{NotContinuous, StuckResonance};
use crate::modal_sum::search::{self, Peak, Problem, Weight};
use crate::modal_sum::wave::{Sum, Wave};
use crate::number::complex;
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;
use crate::oscillator::mode::Mode;

/// By how many roundings β must be below a limit that is not the exact one to be below that as well:
/// four that a search may miss, and those of a limit, with room.
const CLEAR: f64 = 32.0;
/// By less than this fraction of a half turn must the rounding of r turn every mode for two searches to agree.
const UNTURNED: f64 = 1e-4;

/// However little U leaves of S in a limit, of the amplitude there S decides.
const MOST_TOLERANCE: f64 = 1.0 / 4096.0;

impl<S: Float> Chain<S> {
    /// r²E·max(S, H_c + μm*/r²): the velocity constraint by a guaranteed search over the half
    /// period (5.54, 7.36, with the maximum of the sum), started at the break-away term.
    /// `waves` is working space, one for each mode.
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

    /// The same from the modes' waves.
    fn constraint_of<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        at: &[ModeAt<S>],
        waves: &[Wave<S, D>],
    ) -> Peak<S> {
        let start = self.start_constraint(contact);
        // Not as the difference of two sums: beside a resonance the damping's part outweighs the rest.
        let above = (self.stiction - S::constant(1.0)) * self.inverse_mass * contact.scale;
        let mut peak = self.constraint_above(contact, at, waves, start, above);
        peak.value = if peak.places[0].is_some() {
            start + peak.value
        } else {
            self.break_away(contact)
        };
        peak
    }

    /// Whether the start of the half period decides and nothing is searched: undamped, with every R ≥ 1/2.
    pub(crate) fn start_decides(&self, mut ratios: impl Iterator<Item = S>) -> bool {
        !self.damped && ratios.all(|x| x <= S::constant(2.0))
    }

    /// By how much the constraint exceeds `start`, what it is for τ → 0; at least by `above`.
    fn constraint_above<D: Decay<S>>(
        &self,
        contact: &ContactAt<S>,
        at: &[ModeAt<S>],
        waves: &[Wave<S, D>],
        start: S,
        above: S,
    ) -> Peak<S> {
        let decided = self.start_decides(at.iter().map(|at| at.x));
        // Where no angle is known, nothing decides.
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
        // β_lim knows S by U² + S²: where U is the larger, S is needed to fewer digits.
        let ratio = contact.u / (start + above);
        let tolerance = S::constant(4.0 * S::RESOLUTION) * (S::constant(1.0) + ratio * ratio);
        search::largest(
            sum,
            Problem {
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

    /// The same with the sum of each mode's own maximum in place of S (5.55, 7.37): an upper
    /// bound on S, as the thesis prints it.
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
                // The mode's own 1 + g + 2ζRu, its quotient for τ → 0.
                let start = contact.scale + at.g + two_zeta * at.u * at.x;
                let at = core::slice::from_ref(at);
                let above = S::constant(0.0);
                let peak = self.constraint_above(contact, at, &[wave], start, above);
                sum = sum + mode.inverse_mass * (start + peak.value);
            }
        }
        sum.max(self.break_away(contact))
    }

    /// Whether β is below the exact continuous limit.  Most β are settled by a search that only
    /// asks whether the constraint exceeds what β allows.
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
        // Their product may vanish where neither does.
        let root = (excitation - quadrature).sqrt() * (excitation + quadrature).sqrt();
        let allowed = S::constant(1.0 - 1e-3) * root / beta;
        // Where U is so much larger than S that rounding decides on what β allows, this says nothing.
        let beyond = beta * S::constant(1.0 + CLEAR * S::RESOLUTION);
        let clear = beyond < self.continuous_limit(contact, allowed);
        // In so slow a sweep rounding turns a mode by an angle that counts, and two searches differ.
        let fastest = S::constant(UNTURNED / S::RESOLUTION);
        let clear = clear && at.iter().all(|at| at.x < fastest);
        if break_away < allowed && allowed.is_finite() && clear {
            let start = self.start_constraint(contact);
            let above = allowed - start;
            let peak = self.constraint_above(contact, at, waves, start, above);
            // A search that gave up has found nothing, but knows nothing either.
            if peak.value <= above && !peak.exceeded {
                return true;
            }
        }
        let constraint = self.constraint_of(contact, at, waves).value;
        beta < self.continuous_limit(contact, constraint)
    }
}

impl<S: Float> Chain<S> {
    /// β, if a bounded motion exists at it that slides all the time, β < β_lim; else which regime it is instead.
    /// β*_lim does not decide: with μ > 1 a stuck state may exist beside the motion.
    /// `unbounded` are the undamped resonances that the load drives, `at_infinity` is β_lim for r → ∞.
    ///
    /// # Errors
    /// Every [`NotContinuous`].
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
        let beta = check_beta(beta)?;
        let refused = || {
            if beta < sliding {
                NotContinuous::StickSlip
            } else {
                NotContinuous::Stuck
            }
        };
        if !r.is_finite() {
            // The limit itself decides, not the sums at a large r, which round it otherwise.  On a moving
            // base it is infinite: no friction is felt there, and the formulas must not feel it either.
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

    /// Nothing, unless the chain with its contact stuck resonates at r.  `invisible` are the
    /// undamped resonances that the load drives and the contact does not touch.
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

/// Every mode's part, in working space.
fn fill<S: Float, D: Decay<S>>(
    contact: &ContactAt<S>,
    modes: &[Mode<S>],
    at: &[ModeAt<S>],
    waves: &mut [Wave<S, D>],
) {
    debug_assert_eq!(modes.len(), at.len(), "every mode at this r");
    debug_assert_eq!(modes.len(), waves.len(), "a wave for each mode");
    for ((mode, at), wave) in modes.iter().zip(at).zip(waves) {
        *wave = constraint_wave(mode, at, contact, mode.inverse_mass);
    }
}

/// A mode's part in what the constraint's sum exceeds `start`·sin τ by: −m(1 + g)(sin τ − p) +
/// mu((cos τ − p′) − 2ζx·sin τ), of which the last comes once.  Beside a resonance sum and sine are nearly in
/// proportion, and their difference would be what rounding leaves of them.
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

//! Adds derivatives with respect to one variable to a known steady state (`Orbit::carrying`).
//!
//! A steady state is a fixed point x = P(x), where x is the state at a fixed phase and P is the period map. The code
//! uses dual numbers, which contain a value and its derivative. With dual numbers, one period of motion from x gives
//! P(x) and the derivative b of P at fixed x. A Newton step then adds (1 − DP)⁻¹b to the derivative of x, where DP is
//! the derivative of P with respect to x. A second pass follows the segments from the new x, and adds the derivatives
//! to every result.

use super::build::{record_period, stuck};
use super::closed;
use super::cycle_map::{CycleMap, MOST_EVENTS};
use super::newton::{PeriodMap, Workspace, newton};
use super::record::{OrbitRecord, RecordedPeriod};
use super::types::{MAX_SEGMENTS, MAX_STEPS, Orbit, SegmentStart};
use crate::errors::{NoOrbit, OutOfDomain, Ratio, Slice};
use crate::motion::{
    Contact, ContactChain, ContactState, Dynamics, Law, MotionSetting, Part, SUM_ROUNDINGS,
};
use crate::number::complex::Complex;
use crate::number::pairs::pairs;
use crate::number::scalar::Float;
use core::fmt;

/// Largest relative distance from a graze at which the derivative of an event's instant is unreliable. A graze is a
/// motion at which an event of the contact appears or vanishes.
const GRAZE: f64 = 1e-9;
/// Largest relative difference of the derivatives of two successive Newton steps at which the code treats the
/// derivatives as equal.
const ALIKE: f64 = 1e-6;

/// Permitted rounding error of the state's derivative in `f64`, divided by the size of the state.
const ROUNDING: f64 = 1e-14;
/// Largest relative difference at which the given r and β are treated as equal to the r and β of the steady state.
const SAME: f64 = 1e-12;

/// Reason why a steady state has no derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum NoDerivative {
    /// The search finds no steady state. The field gives the reason.
    NoOrbit(NoOrbit),
    /// The motion does not repeat, and only its last cycles are known.
    Unsettled,
    /// The steady state belongs to a continuum of steady states, or lies at the end of one. The initial state decides
    /// which state of the continuum the motion reaches.
    Marginal,
    /// At this motion an event of the contact appears or vanishes. The results have a kink at this motion, and no
    /// derivative.
    Graze,
    /// The modes of the scene themselves have no derivative. One possible reason is that two modes have the same
    /// constants. The two modes may be modes of the chain, or modes of the chain with its contact stuck. Another
    /// possible reason is a mode that the contact does not drive, but would drive after any small change of the scene.
    Degenerate,
}

impl fmt::Display for NoDerivative {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NoOrbit(error) => return error.fmt(f),
            Self::Unsettled => "no derivative: the motion does not repeat",
            Self::Marginal => "no derivative: the steady state is one of a continuum",
            Self::Graze => "no derivative: an event is about to appear or to vanish",
            Self::Degenerate => {
                "no derivative: two modes coincide, or the contact starts to drive a mode"
            }
        })
    }
}

impl core::error::Error for NoDerivative {}

impl From<NoOrbit> for NoDerivative {
    fn from(error: NoOrbit) -> Self {
        Self::NoOrbit(error)
    }
}

impl From<OutOfDomain> for NoDerivative {
    fn from(error: OutOfDomain) -> Self {
        Self::NoOrbit(error.into())
    }
}

/// Memory for a steady state whose numbers have derivatives.
#[derive(Debug)]
pub struct CarryingStorage<'m, S, P, V, C> {
    /// Oscillators that the caller initialises with [`Part::empty`]: one for each mode of the chain, and one for each
    /// mode of the chain with its contact stuck.
    pub parts: P,
    /// Room for the scalars of any orbit (steady state) of the scene ([`numbers_of`](super::numbers_of)).
    pub numbers: V,
    /// Working memory for two scalars of each mass.
    pub masses: &'m mut [S],
    /// Empty storage, because the multipliers have no derivative.
    pub multipliers: C,
}

impl<'a, S, P, V, C, K> Orbit<'a, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    /// Computes the steady state `plain` with a number type that has derivatives. `dynamics`, r and β describe the
    /// scene, the frequency ratio and the friction ratio of `plain`, with derivatives.
    ///
    /// # Errors
    /// [`NoDerivative`] gives the reason why no derivatives exist. Slices of a wrong length return the error
    /// `OutOfDomain`.
    pub fn carrying<T, Q, W, D, J>(
        plain: &Orbit<'_, T, Q, W, D, J>,
        dynamics: Dynamics<'a, S, K>,
        (r, beta): (S, S),
        storage: CarryingStorage<'_, S, P, V, C>,
    ) -> Result<Self, NoDerivative>
    where
        T: Float,
        Q: AsRef<[Part<T>]> + Clone + AsMut<[Part<T>]>,
        W: AsRef<[T]> + AsMut<[T]>,
        D: AsRef<[Complex<T>]> + AsMut<[Complex<T>]>,
        J: ContactChain<T>,
    {
        let CarryingStorage {
            mut parts,
            mut numbers,
            masses,
            multipliers,
        } = storage;
        if !plain.settled {
            return Err(NoDerivative::Unsettled);
        }
        check_same(r, plain.setting.r, Ratio::Frequency)?;
        check_same(beta, plain.setting.beta, Ratio::Friction)?;
        let (modes, size) = (dynamics.modes.len(), dynamics.state_size());
        let setting = MotionSetting::new(dynamics, r, beta, parts.as_mut())?;
        let room = numbers.as_ref().len();
        if room != super::numbers_of(modes, size) || masses.len() != 2 * modes {
            return Err(OutOfDomain::Length(Slice::Storage).into());
        }
        let clean = parts.clone();
        let oscillators = setting.split(parts.as_mut());
        let contact_state = SegmentStart::empty().contact_state;
        let mut cycle_map = CycleMap::new(&setting, oscillators, contact_state);
        let (states, mut workspace) = Workspace::divided(numbers.as_mut(), &mut [], (modes, size));
        let mut marks = [SegmentStart::empty(); MAX_SEGMENTS];
        // The search for the steady state `plain` has already checked the number of segments.
        let most = MOST_EVENTS as usize;
        let mut record = OrbitRecord::new(&mut marks, states, 2 * modes, most);
        if plain.never_slides() {
            // Away from the middle, the place of a stuck contact depends on every earlier slip.
            if !plain.middle().is_zero() {
                return Err(NoDerivative::Marginal);
            }
            let offset = S::constant(0.0);
            stuck(&mut cycle_map, &mut workspace, offset)?;
            record.stuck(&cycle_map, offset);
        } else {
            plain.close(&mut cycle_map, &mut workspace, (beta, masses))?;
            cycle_map.step_budget = MAX_STEPS;
            record_period(&mut cycle_map, &mut record, plain.period)?;
        }
        let RecordedPeriod {
            count,
            stops,
            reversals,
            origin,
        } = record.done();
        if (stops, reversals) != (plain.stops, plain.reversals) {
            return Err(NoDerivative::Graze);
        }
        let orbit = Self {
            setting,
            parts: clean,
            numbers,
            multipliers,
            marks,
            count,
            period: plain.period,
            stops,
            reversals,
            symmetric: plain.symmetric,
            marginal: plain.marginal,
            settled: true,
            left_at: plain.left_at.map(|offset| S::constant(offset.to_f64())),
            offset_range: None,
            origin: origin.0,
            origin_cycle: origin.1,
        };
        if orbit.grazes() {
            return Err(NoDerivative::Graze);
        }
        Ok(orbit)
    }

    /// Sets a cycle map to a state of this steady motion, and corrects the state and its derivatives until they repeat
    /// after the period. The number type of the cycle map has derivatives.
    fn close<U: Float, J: ContactChain<U>>(
        &self,
        cycle_map: &mut CycleMap<'_, '_, U, J>,
        workspace: &mut Workspace<'_, U>,
        (beta, masses): (U, &mut [U]),
    ) -> Result<(), NoDerivative> {
        if self.is_closed() {
            closed::set(cycle_map, beta);
            return Ok(());
        }
        if self.marginal {
            return Err(NoDerivative::Marginal);
        }
        let map = PeriodMap {
            period: self.period,
            symmetric: self.symmetric,
        };
        self.set_state(cycle_map, masses)?;
        closed_in(cycle_map, workspace, map)
    }

    /// Returns true if the contact never slides in this steady state.
    pub fn never_slides(&self) -> bool {
        let mut marks = self.marks().iter();
        self.stops == 0 && marks.all(|mark| mark.contact_state.contact == Contact::Stuck)
    }

    /// Returns true if the closed form describes this steady motion. In the closed form the contact slides all the
    /// time, with one reversal in half a cycle.
    fn is_closed(&self) -> bool {
        let (zero, own) = (self.setting.beta.is_zero(), self.period == 1);
        own && self.stops == 0 && self.reversals == 2 && self.symmetric && (zero || !self.marginal)
    }

    /// Sets a cycle map to this steady state, at the middle of the longest sliding segment. The cycle map may have
    /// another number type than the steady state. `masses` is working memory for displacements and velocities.
    fn set_state<U: Float, J: ContactChain<U>>(
        &self,
        cycle_map: &mut CycleMap<'_, '_, U, J>,
        masses: &mut [U],
    ) -> Result<(), NoDerivative> {
        let (half, two) = (S::constant(0.5), S::constant(2.0));
        let slides = |mark: &SegmentStart<S>| mark.contact_state.contact != Contact::Stuck;
        let longest = self.segments().filter(slides).reduce(|longest, mark| {
            if longest.length < mark.length {
                mark
            } else {
                longest
            }
        });
        let longest = longest.ok_or(NoDerivative::Graze)?;
        let from = longest.contact_state.t + two * (longest.cycle - self.origin_cycle);
        let tau = (from - self.origin) * S::pi() + longest.length * half;
        let t = longest.contact_state.t + longest.length * half * S::inverse_pi();
        let t = t - (t * half).floor() * two;
        let count = masses.len() / 2;
        let (displacements, velocities) = masses.split_at_mut(count);
        for (index, (x, v)) in displacements.iter_mut().zip(&mut *velocities).enumerate() {
            let mass = self.mass(index);
            *x = U::constant(mass.displacement(tau).to_f64());
            *v = U::constant(mass.velocity(tau).to_f64());
        }
        let setting = cycle_map.setting;
        setting.load_state(displacements, velocities, cycle_map.modes);
        // For the states of the modes alone, the law of an elastic contact would return a stuck contact. The code
        // therefore passes the direction of sliding.
        let sliding = ContactState {
            contact: longest.contact_state.contact,
            ..ContactState::stuck(U::constant(t.to_f64()))
        };
        cycle_map.contact_state = J::sliding_state(setting, cycle_map.modes, &sliding);
        Ok(())
    }

    /// Returns true if an event of the contact appears or vanishes after any small change of this motion.
    fn grazes(&self) -> bool {
        let graze = S::constant(GRAZE);
        let setting = &self.setting;
        let mut before = Contact::Stuck;
        let mut segments = self.segments();
        let mut first = true;
        while let Some(mark) = segments.next() {
            if mark.length < S::constant(0.0) {
                return true;
            }
            let parts = segments.parts();
            let (modes, stuck_modes) = setting.split(parts);
            // The force of a rigid contact that has just stopped must differ clearly from μβ. The force of an elastic
            // contact is μβ at that instant, and then falls.
            if !first && before != Contact::Stuck && setting.dynamics.chain.remembered() == 0 {
                let force = setting.holding(modes, mark.contact_state.t.sin_cos_pi());
                if setting.law().is_marginal(force, graze) {
                    return true;
                }
            }
            (first, before) = (false, mark.contact_state.contact);
            if self.never_slides() {
                return false;
            }
            // The sum is a function of time that reaches zero at the end of the segment. Its slope must differ clearly
            // from zero.
            let sum = if before == Contact::Stuck {
                setting
                    .start_sticking(modes, stuck_modes, &mark.contact_state, mark.length)
                    .0
            } else {
                setting.start_sliding(modes, &mark.contact_state, mark.length)
            };
            let slope = sum.local(mark.length).slope;
            let size = sum.noise / S::constant(SUM_ROUNDINGS * S::EPSILON);
            if !(size * graze < slope.abs()) {
                return true;
            }
        }
        false
    }
}

/// Returns an error if the given r or β differs from that of the known steady state by more than rounding.
fn check_same<S: Float>(given: S, known: impl Float, ratio: Ratio) -> Result<(), OutOfDomain> {
    let known = S::constant(known.to_f64());
    if (given - known).abs() <= known * S::constant(SAME) {
        Ok(())
    } else {
        Err(OutOfDomain::OtherPoint(ratio))
    }
}

/// Applies Newton steps until the motion of the cycle map repeats, in a number type that has derivatives. After the
/// first step the derivative has the precision of the value. After the second step the derivative has the precision of
/// the number type.
fn closed_in<S: Float, K: ContactChain<S>>(
    cycle_map: &mut CycleMap<'_, '_, S, K>,
    workspace: &mut Workspace<'_, S>,
    map: PeriodMap,
) -> Result<(), NoDerivative> {
    let alike = S::constant(ALIKE);
    for last in [false, true] {
        cycle_map.save(workspace.state);
        if newton(cycle_map, workspace, map)?.is_none() {
            return Err(NoDerivative::Graze);
        }
        if !last {
            continue;
        }
        let (mut change, mut size) = (S::constant(0.0), S::constant(0.0));
        for (part, state) in cycle_map.modes.iter().zip(pairs(workspace.state)) {
            if let [y, u] = state {
                for (now, then) in [(part.y, *y), (part.u, *u)] {
                    let (now, then) = (now.carried(), then.carried());
                    change = change.max((now - then).abs());
                    size = size.max(now.abs());
                }
            }
        }
        // A derivative of 0 has no size. The code therefore compares the rounding error of the first step with the size
        // of the state.
        let rounding = cycle_map.scale() * S::constant(ROUNDING);
        if !(change <= alike * size + rounding) {
            return Err(NoDerivative::Graze);
        }
    }
    Ok(())
}

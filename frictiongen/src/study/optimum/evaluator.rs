//! Computes the quantities of a search for the best friction at one frequency and one friction. The search itself does
//! not depend on the number of contacts.

use super::objective::Objective;
use crate::study::joined::{Combination, Joined, JoinedError};
use crate::study::joints::JointError;
use crate::study::response::{MotionQuantity, SystemResponse};
use crate::study::system::System;
use crate::study::units::LoadScale;
use crate::study::work::{of_contacts, work};
use crate::{Error, NoOrbit, NotContinuous, Of, Regime};

/// Smallest relative distance from a pole at which the code evaluates a function to detect the pole. At a pole, the
/// value at this distance is ten times the value at ten times the distance.
const BESIDE: f64 = 1e-9;
/// Value up to which the code assumes that a function has no pole. The code evaluates the function at the relative
/// distance `BESIDE` from the possible pole. A value of this size is only a rounding error.
const DRIVEN: f64 = 1e-3;

/// Friction ratio β at which contacts stick from their initial state on, except very close to a resonance of the chain with
/// its contacts stuck.
const LOCKED: f64 = 1e12;
/// Factor on the work of a motion from rest that does not settle.
const UNSETTLED: usize = 2;
/// Friction from which a contact with μ > 1 sticks from rest, divided by β*_lim. In the transient motion, the force of the
/// contact may be larger than in the stuck state.
const SETTLES: f64 = 2.5;

/// Amount of friction: a given friction, or a friction so large that no contact ever slides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study) enum FrictionAmount {
    /// The (common) friction force divided by the amplitude P that the load has at r = 1 (by k₁Y for base motion). For
    /// a load of constant amplitude it is the friction ratio β.
    Ratio(f64),
    /// The friction is so large that no contact ever slides.
    Locked,
}

/// A quantity with a positive number: the divisor of a minimised quantity, or the upper bound of a bounded quantity.
pub(super) type Quotient = (Objective, f64);

/// The quantities of a search: those whose largest quotient is minimised, and those whose quotients must not exceed 1.
#[derive(Clone, Debug, Default)]
pub(super) struct Goal {
    pub minimised: Vec<Quotient>,
    pub bounded: Vec<Quotient>,
}

/// The quantities of a steady state at one frequency and one friction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    /// The largest quotient of the minimised quantities, which the search calls the amplitude. It is NaN if the solvers
    /// find no motion, and infinite on a resonance that nothing bounds.
    pub value: f64,
    /// The largest quotient of the bounded quantities, or 0 without bounds.
    pub bound: f64,
    pub regime: Regime,
    /// False if the motion does not settle. The quantities are then those of its last cycles.
    pub is_settled: bool,
    /// Work of the evaluation, in units of about 10 µs of computing time.
    pub work: usize,
}

/// Computes steady states of a scene for the search.
pub(super) trait Evaluator {
    /// Returns the quantities of the steady state at the frequency ratio r. If `follows` is false, the closed form of a
    /// sliding contact counts where it exists. With μ > 1 the motion from rest may end in another state.
    fn answer(&self, r: f64, friction: FrictionAmount, follows: bool) -> Answer;

    /// Returns β_lim and β*_lim at the frequency ratio r, as frictions. β_lim is NaN for several contacts.
    fn limits(&self, r: f64) -> [f64; 2];

    /// Returns β*_lim at the frequency ratio r, as a friction. It is infinite if no friction keeps all contacts stuck.
    fn sliding_limit(&self, r: f64) -> f64;

    /// Returns true if every friction from β*_lim on leaves the contacts stuck at the same place. With μ > 1 the motion
    /// from rest may still slide. An initial state leaves a contact at a place that depends on friction.
    fn locks(&self) -> bool;

    /// Returns the relative accuracy of a tolerance of the friction. It is low where every digit takes many motions.
    fn accuracy(&self) -> f64;

    /// Returns true if the search has bounded quantities.
    fn has_bounds(&self) -> bool;

    /// Returns frequency ratios near which the amplitude may have a maximum, the resonances of the chain with
    /// each set of stuck contacts, each with its damping ratio. The ratio is NaN for a set of some contacts.
    fn resonances(&self) -> Vec<[f64; 2]>;
}

impl Goal {
    pub fn one(objective: Objective) -> Self {
        Self {
            minimised: vec![(objective, 1.0)],
            bounded: Vec::new(),
        }
    }

    /// Returns the answer with the quotients at r. `value` returns a quantity in the units of the load at r.
    fn answer(
        &self,
        r: f64,
        value: impl Fn(&Objective) -> Option<f64>,
        (regime, is_settled): (Regime, bool),
    ) -> Answer {
        let largest = |all: &[Quotient]| {
            let quotients = all.iter().map(|(objective, over)| {
                value(objective).map_or(f64::NAN, |value| value * objective.factor(r) / over)
            });
            quotients.fold(
                0.0_f64,
                |most, value| if value <= most { most } else { value },
            )
        };
        Answer {
            value: largest(&self.minimised),
            bound: largest(&self.bounded),
            regime,
            is_settled,
            work: 1,
        }
    }

    /// Returns the answer of a frequency without a steady state: NaN, or an infinite amplitude.
    fn without_motion(&self, value: f64) -> Answer {
        let bound = if self.bounded.is_empty() || value.is_nan() {
            0.0
        } else {
            value
        };
        Answer {
            value,
            bound,
            regime: Regime::Stuck,
            is_settled: false,
            work: 1,
        }
    }

    /// Returns the exponent n of the load, whose amplitude is proportional to r⁻ⁿ.
    pub fn fall(&self) -> i32 {
        self.minimised
            .first()
            .map_or(0, |(objective, _)| objective.fall)
    }
}

/// Returns the value that a function approaches towards a resonance at which the function is undefined. The result is
/// infinite if the function grows towards the resonance.
fn beside(r: f64, function: impl Fn(f64) -> f64) -> f64 {
    let at = |distance: f64| function(r * (1.0 + distance));
    let (far, near) = (at(10.0 * BESIDE), at(BESIDE));
    if DRIVEN < near && 5.0 * far < near {
        f64::INFINITY
    } else {
        near
    }
}

/// Evaluates a scene with one contact.
pub(super) struct OneContact<'s> {
    system: &'s System,
    goal: Goal,
    /// Each undamped resonance that the contact drives, with its threshold β_n (6.2, 6.26). At a friction ratio below
    /// the threshold, the amplitude at this resonance is unbounded.
    thresholds: Vec<[f64; 2]>,
}

impl<'s> OneContact<'s> {
    pub fn new(system: &'s System, goal: Goal) -> Self {
        let resonances = system.resonances().iter();
        let all = resonances.zip(system.resonance_thresholds());
        let all = all.zip(&system.modal().damping_ratios);
        let undamped = all.filter(|(_, zeta)| zeta.to_f64() == 0.0);
        let thresholds = undamped
            .filter_map(|((resonance, threshold), _)| Some([*resonance, threshold?]))
            .collect();
        Self {
            system,
            goal,
            thresholds,
        }
    }

    /// Returns the response, and true if the code has followed a motion from rest.
    fn response(
        &self,
        r: f64,
        friction: FrictionAmount,
        follows: bool,
    ) -> Result<(SystemResponse<'s>, bool), Error> {
        let at = self.system.at(r)?;
        let FrictionAmount::Ratio(friction) = friction else {
            return Ok((at.locked()?, false));
        };
        let beta = friction * r.powi(self.goal.fall());
        if self.system.start.is_none() {
            let held = if self.locks() { 1.0 } else { SETTLES };
            if !(beta < held * at.sliding_limit()) {
                return Ok((at.locked()?, false));
            }
            if !follows
                && beta < at.sliding_limit()
                && let Ok(motion) = at.motion(beta)
            {
                return Ok((SystemResponse::Continuous(motion), false));
            }
        }
        match at.response(beta) {
            // The solvers find no motion from rest, but the contact can stick.
            Err(Error::NoOrbit(error))
                if error != NoOrbit::Unbounded
                    && self.system.start.is_none()
                    && !(beta < at.sliding_limit()) =>
            {
                Ok((at.locked()?, true))
            }
            response => Ok((response?, true)),
        }
    }

    fn of_response(&self, r: f64, response: &SystemResponse<'_>) -> Answer {
        let state = (response.regime(), response.is_settled());
        self.goal
            .answer(r, |objective| objective.of_response(response), state)
    }

    /// Returns true if r is an undamped resonance at which the load supplies more energy than this amount of friction
    /// dissipates.
    fn is_unbounded(&self, r: f64, friction: FrictionAmount) -> bool {
        let FrictionAmount::Ratio(friction) = friction else {
            return false;
        };
        let beta = friction * r.powi(self.goal.fall());
        let mut thresholds = self.thresholds.iter();
        thresholds.any(|[resonance, threshold]| *resonance == r && beta < *threshold)
    }
}

impl Evaluator for OneContact<'_> {
    fn accuracy(&self) -> f64 {
        1e-7
    }

    fn has_bounds(&self) -> bool {
        !self.goal.bounded.is_empty()
    }

    fn answer(&self, r: f64, friction: FrictionAmount, follows: bool) -> Answer {
        let found = self.response(r, friction, follows);
        let work = match &found {
            Ok((_, false)) => 1,
            // A search over all states may follow an unsettled motion.
            Ok((response, true)) => {
                let settled = response.is_settled() && response.is_from_rest();
                work(self.system, r, Ok(response)) * if settled { 1 } else { UNSETTLED }
            }
            Err(error) => work(self.system, r, Err(*error)),
        };
        let answer = match found {
            Ok((response, _)) => self.of_response(r, &response),
            Err(Error::NotContinuous(NotContinuous::Unbounded)) => {
                self.goal.without_motion(f64::INFINITY)
            }
            Err(Error::NoOrbit(NoOrbit::Unbounded)) if self.is_unbounded(r, friction) => {
                self.goal.without_motion(f64::INFINITY)
            }
            // The contact is stuck, and r is an undamped resonance of the chain with its contact stuck. The amplitude
            // is finite if the load does not drive the mode of this resonance.
            Err(Error::NoOrbit(NoOrbit::Unbounded) | Error::StuckResonance(_)) => {
                let near = |r: f64| {
                    let response = self.response(r, friction, follows);
                    response.map(|(response, _)| self.of_response(r, &response))
                };
                let value =
                    |of: &dyn Fn(Answer) -> f64| beside(r, |r| near(r).map_or(f64::INFINITY, of));
                Answer {
                    value: value(&|answer| answer.value),
                    bound: value(&|answer| answer.bound),
                    is_settled: true,
                    ..self.goal.without_motion(f64::INFINITY)
                }
            }
            Err(_) => self.goal.without_motion(f64::NAN),
        };
        Answer { work, ..answer }
    }

    fn limits(&self, r: f64) -> [f64; 2] {
        let continuous = self.system.at(r).map(|at| at.limits().continuous);
        let continuous = continuous.unwrap_or(f64::NAN) / r.powi(self.goal.fall());
        [continuous, self.sliding_limit(r)]
    }

    fn sliding_limit(&self, r: f64) -> f64 {
        let limit = |r: f64| self.system.at(r).map_or(f64::NAN, |at| at.sliding_limit());
        let mut sliding = limit(r);
        if sliding == f64::INFINITY {
            // r is a resonance of the chain with its contact stuck. The limit is finite if the load does not drive
            // this resonance.
            sliding = beside(r, limit);
        }
        sliding / r.powi(self.goal.fall())
    }

    fn locks(&self) -> bool {
        self.system.scene().stiction <= 1.0 && self.system.start.is_none()
    }

    fn resonances(&self) -> Vec<[f64; 2]> {
        let zetas = self.system.modal().damping_ratios.iter();
        // The resonances of the system agree to the last bit with those of its closed forms.
        let free = self.system.resonances().iter().zip(zetas);
        let free = free.map(|(resonance, zeta)| [*resonance, zeta.to_f64()]);
        let held = self.system.dynamics().held.iter();
        free.chain(held.map(|mode| [mode.frequency, mode.zeta]))
            .collect()
    }
}

/// Evaluates a scene with several contacts or dashpots.
pub(in crate::study) struct SeveralContacts<'s> {
    system: &'s System,
    joined: Joined<'s>,
    goal: Goal,
    scale: Option<LoadScale>,
}

impl<'s> SeveralContacts<'s> {
    pub fn new(
        (system, joined): (&'s System, Joined<'s>),
        goal: Goal,
        scale: Option<LoadScale>,
    ) -> Self {
        Self {
            system,
            joined,
            goal,
            scale,
        }
    }

    fn answer_of(&self, r: f64, friction: FrictionAmount) -> Result<Answer, JoinedError> {
        let joined = match &self.scale {
            Some(scale) => &self
                .joined
                .with_length(scale.length() * r.powi(-self.goal.fall())),
            None => &self.joined,
        };
        let at = joined.at_any(r)?;
        let (scene, units) = (self.system.scene(), at.units());
        let (is_linear, is_free) = (scene.has_linear_states(), self.system.start.is_none());
        let beta = match friction {
            FrictionAmount::Ratio(0.0) if is_linear => {
                let state = at.linear()?;
                let value = |of: &Objective| state.amplitude(of.of, of.size);
                return Ok(self.goal.answer(r, value, (Regime::Continuous, true)));
            }
            FrictionAmount::Ratio(friction) => friction * r.powi(self.goal.fall()),
            FrictionAmount::Locked if self.system.start.is_some() || !is_linear => LOCKED,
            FrictionAmount::Locked => f64::INFINITY,
        };
        // The answer of contacts that never slide is the state without constant forces in the contacts.
        let stuck = |state: &crate::study::joined::StuckState<'_>| {
            let value = |of: &Objective| state.amplitude(of.of, of.size);
            self.goal.answer(r, value, (Regime::Stuck, true))
        };
        if beta.is_infinite() {
            return Ok(stuck(&at.stuck()?));
        }
        let held = if self.locks() { 1.0 } else { SETTLES };
        if joined.chain().law.is_empty()
            && self.system.start.is_none()
            && let Ok(state) = at.stuck()
            && held * state.limit() <= beta
        {
            return Ok(stuck(&state));
        }
        match at.orbit_soon(beta)? {
            Ok(orbit) if orbit.regime() == Regime::Stuck && is_free && is_linear => {
                Ok(stuck(&at.stuck()?))
            }
            Ok(orbit) => {
                let multiplier = orbit.multipliers().first();
                let multiplier = multiplier.map_or(0.0, |value| value.norm());
                let value = |of: &Objective| orbit.largest(of.of, of.size).ok();
                let answer = self.goal.answer(r, value, (orbit.regime(), true));
                let work = of_contacts(scene.masses.len(), Some(multiplier));
                Ok(Answer { work, ..answer })
            }
            // The common friction may be just below the limit of the stuck state. The contacts then move less and less
            // in each cycle, but never come to rest.
            Err(largest) => {
                let value = |of: &Objective| {
                    let moved = |size| Combination::of(scene, of.of, size);
                    let moved = |size| Some(moved(size)?.at_most(&largest, units));
                    let force = || Some(beta * most_force(joined, of.of)?);
                    match of.size {
                        MotionQuantity::Force => force(),
                        // A contact slides over at most four amplitudes in a cycle that it does not leave twice.
                        MotionQuantity::Energy => {
                            Some(4.0 * force()? * moved(MotionQuantity::Displacement)?)
                        }
                        size => moved(size),
                    }
                };
                let answer = self.goal.answer(r, value, (Regime::StickSlip, false));
                let work = of_contacts(scene.masses.len(), None);
                Ok(Answer { work, ..answer })
            }
        }
    }
}

/// Returns the largest force of a contact, divided by the common friction. A stop has no such bound.
fn most_force(joined: &Joined<'_>, of: Of) -> Option<f64> {
    let Of::ContactAt(index) = of else {
        return None;
    };
    let contact = joined.chain().contacts.get(index)?;
    Some(contact.level.constant * contact.stiction)
}

impl Evaluator for SeveralContacts<'_> {
    fn accuracy(&self) -> f64 {
        1e-4
    }

    fn has_bounds(&self) -> bool {
        !self.goal.bounded.is_empty()
    }

    fn answer(&self, r: f64, friction: FrictionAmount, _: bool) -> Answer {
        self.answer_of(r, friction)
            .unwrap_or_else(|error| match error {
                JoinedError::Resonance | JoinedError::Engine(JointError::NotFinite) => {
                    self.goal.without_motion(f64::INFINITY)
                }
                _ => self.goal.without_motion(f64::NAN),
            })
    }

    fn limits(&self, r: f64) -> [f64; 2] {
        [f64::NAN, self.sliding_limit(r)]
    }

    fn sliding_limit(&self, r: f64) -> f64 {
        let stuck = self.joined.at_any(r).and_then(|at| at.stuck());
        // On an undamped resonance of the chain with its contacts stuck, no friction keeps all contacts stuck.
        let limit = stuck.map_or(f64::INFINITY, |stuck| stuck.limit());
        limit / r.powi(self.goal.fall())
    }

    fn locks(&self) -> bool {
        let chain = self.joined.chain();
        let mut contacts = chain.contacts.iter();
        contacts.all(|contact| contact.stiction <= 1.0)
            && chain.law.is_empty()
            && self.system.start.is_none()
    }

    fn resonances(&self) -> Vec<[f64; 2]> {
        self.joined.resonances()
    }
}

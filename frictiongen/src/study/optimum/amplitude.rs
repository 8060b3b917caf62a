//! Computes the quantity that the search for an optimum minimises, at one frequency ratio and one friction ratio.

use super::objective::Objective;
use super::resonance::beside;
use crate::study::physical::swing;
use crate::study::sensitivity::Varied;
use crate::study::system::System;
use crate::study::work::work;
use crate::study::{response::SystemResponse, sensitivity::Sensitive};
use crate::{Error, NoOrbit, NotContinuous, Regime};
use std::cell::Cell;

/// Relative step of the central differences. It is the step in r divided by r, and the step in friction divided by the
/// friction.
const DIFFERENCE: f64 = 1e-6;

/// Amount of friction: a given friction ratio, or a friction so large that the contact never slides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study) enum FrictionAmount {
    /// A given friction: the friction force divided by the amplitude P that the load has at r = 1 (by k₁Y for base
    /// motion). For a load of constant amplitude it is the friction ratio β.
    Ratio(f64),
    /// The friction is so large that the contact never slides.
    Locked,
}

/// A function that a search calls after each evaluation. It returns false to stop the search.
pub(in crate::study) type KeepGoing<'s> = &'s (dyn Fn() -> bool + Sync);

/// The quantity that the search minimises, as a function of frequency and friction. The code calls the quantity the
/// amplitude. The struct counts the evaluations and their work.
pub(in crate::study) struct Amplitude<'s> {
    pub system: &'s System,
    pub objective: Objective,
    unvaried: Varied,
    /// Each undamped resonance that the contact drives, with its threshold. At a friction ratio below the threshold,
    /// the amplitude at this resonance is unbounded.
    thresholds: Vec<[f64; 2]>,
    /// Number of evaluations of the amplitude so far.
    pub asked: Cell<usize>,
    /// Work of all evaluations so far, in units of about 10 µs of computing time.
    work: Cell<usize>,
    /// Bound on the work of all evaluations, in units of about 10 µs of computing time.
    most: Cell<usize>,
    /// The caller's function that can stop the search.
    watch: Cell<Option<KeepGoing<'s>>>,
    /// True if the caller has stopped the search.
    stopped: Cell<bool>,
    /// Number of evaluations without a result, because the solvers found no amplitude.
    pub silent: Cell<usize>,
    /// True if evaluations use the motion from rest even if the closed form exists.
    follows: Cell<bool>,
}

/// Returns the undamped resonances, each with its threshold β_n (6.2, 6.26). Below this friction ratio, the amplitude
/// at the resonance is unbounded.
fn thresholds(system: &System) -> Vec<[f64; 2]> {
    let resonances = system.resonances().iter();
    let all = resonances.zip(system.resonance_thresholds());
    let all = all.zip(&system.modal().damping_ratios);
    let undamped = all.filter(|(_, zeta)| zeta.to_f64() == 0.0);
    undamped
        .filter_map(|((resonance, threshold), _)| Some([*resonance, threshold?]))
        .collect()
}

impl<'s> Amplitude<'s> {
    pub(super) fn new(system: &'s System, objective: Objective) -> Self {
        Self {
            system,
            objective,
            unvaried: system.unvaried(),
            thresholds: thresholds(system),
            asked: Cell::new(0),
            work: Cell::new(0),
            most: Cell::new(usize::MAX),
            watch: Cell::new(None),
            stopped: Cell::new(false),
            silent: Cell::new(0),
            follows: Cell::new(false),
        }
    }

    /// Makes all later evaluations compute the motion from rest, even if the closed form exists. The evaluations do so
    /// until they reach the bound on work. With μ > 1 the motion from rest may end in another steady state than the
    /// closed form. The amplitude of this steady state may be the largest over the band, although the amplitude of the
    /// closed form is not.
    pub(super) fn follow_from_rest(&self) {
        self.follows.set(true);
    }

    fn response(&self, r: f64, friction: FrictionAmount) -> Result<SystemResponse<'s>, Error> {
        let at = self.system.at(r)?;
        match friction {
            FrictionAmount::Ratio(friction) => {
                let beta = self.objective.beta(friction, r);
                if self.locks() && !(beta < at.sliding_limit()) {
                    return at.locked();
                }
                at.response(beta)
            }
            FrictionAmount::Locked => at.locked(),
        }
    }

    /// Returns true if the contact is locked, at the same place, with every friction from β*_lim on. With μ > 1 the
    /// motion from rest may still slide. An initial state leaves the contact at a place that depends on friction.
    pub(super) fn locks(&self) -> bool {
        self.system.scene().stiction <= 1.0 && self.system.start.is_none()
    }

    /// Sets the caller's function that can stop the search.
    pub(super) fn watched_by(&self, watch: Option<KeepGoing<'s>>) {
        self.watch.set(watch);
    }

    /// Removes the caller's function that can stop the search, so that the function does not stop the code that
    /// completes the result. Returns true if the caller has stopped the search.
    pub(super) fn end_watch(&self) -> bool {
        self.watch.set(None);
        self.stopped.replace(false)
    }

    /// Returns true if the caller has stopped the search.
    pub(super) fn is_stopped(&self) -> bool {
        self.stopped.get()
    }

    /// Returns true if the evaluations have reached their bound on work, or if the caller has stopped the search.
    pub(super) fn is_spent(&self) -> bool {
        self.most.get() <= self.work.get() || self.stopped.get()
    }

    /// Sets the bound on work to the work done so far plus `work`.
    pub(super) fn allow(&self, work: usize) {
        self.most.set(self.work.get().saturating_add(work));
    }

    /// Returns the work of all evaluations so far, in units of about 10 µs of computing time.
    pub(super) fn spent(&self) -> usize {
        self.work.get()
    }

    fn spend(&self, r: f64, found: Result<&SystemResponse<'_>, Error>) {
        self.spend_work(work(self.system, r, found));
    }

    fn spend_work(&self, work: usize) {
        self.work.set(self.work.get().saturating_add(work));
        if let Some(watch) = self.watch.get()
            && !watch()
        {
            self.stopped.set(true);
        }
    }

    /// Returns the amplitude at a frequency ratio r, divided by P/k₁ (by Y for base motion). The result is infinite on
    /// a resonance at which neither friction nor damping bounds the amplitude. It is NaN if no response exists.
    ///
    /// If β is less than β_lim and β*_lim, the result is the amplitude of the closed form. With μ > 1, the motion from
    /// rest may end in another state. [`followed`](Self::followed) returns the amplitude of that state.
    pub(super) fn at(&self, r: f64, friction: FrictionAmount) -> f64 {
        if let FrictionAmount::Ratio(force) = friction
            && (!self.follows.get() || self.is_spent())
            && let Ok(at) = self.system.at(r)
            && let beta = self.objective.beta(force, r)
            && let Ok(motion) = at.motion(beta)
            && beta < at.sliding_limit()
        {
            self.asked.set(self.asked.get() + 1);
            self.spend_work(1);
            return self.value(r, &SystemResponse::Continuous(motion));
        }
        self.followed(r, friction)
    }

    /// Returns the amplitude of the steady state in which the motion from rest ends, in any regime.
    pub(super) fn followed(&self, r: f64, friction: FrictionAmount) -> f64 {
        self.asked.set(self.asked.get() + 1);
        let found = self.response(r, friction);
        self.spend(r, found.as_ref().map_err(|error| *error));
        match found {
            Ok(response) => self.value(r, &response),
            Err(Error::NotContinuous(NotContinuous::Unbounded)) => f64::INFINITY,
            Err(Error::NoOrbit(NoOrbit::Unbounded)) if self.is_unbounded(r, friction) => {
                f64::INFINITY
            }
            // These errors mean that the contact is stuck, and that r is a resonance of the chain with its contact
            // stuck.
            Err(Error::NoOrbit(NoOrbit::Unbounded) | Error::StuckResonance(_)) => {
                self.beside_resonance(r, friction)
            }
            Err(_) => {
                self.silent.set(self.silent.get() + 1);
                f64::NAN
            }
        }
    }

    fn value(&self, r: f64, response: &SystemResponse<'_>) -> f64 {
        let value = self.objective.of_response(response);
        value.map_or(f64::NAN, |value| value * self.objective.factor(r))
    }

    /// Returns true if r is an undamped resonance at which the load supplies more energy than this amount of friction
    /// dissipates. At frequencies near this resonance, the motion from rest needs so many cycles that its computation
    /// ends in another state. The amplitude of that state says nothing about the resonance.
    pub(super) fn is_unbounded(&self, r: f64, friction: FrictionAmount) -> bool {
        let FrictionAmount::Ratio(friction) = friction else {
            return false;
        };
        let beta = self.objective.beta(friction, r);
        let mut thresholds = self.thresholds.iter();
        thresholds.any(|[resonance, threshold]| *resonance == r && beta < *threshold)
    }

    /// Returns the amplitude on an undamped resonance of the chain with its contact stuck. The amplitude is finite if
    /// the load does not drive the mode of this resonance.
    fn beside_resonance(&self, r: f64, friction: FrictionAmount) -> f64 {
        beside(r, |r| {
            let response = self.response(r, friction);
            response.map_or(f64::INFINITY, |response| self.value(r, &response))
        })
    }

    /// Returns the regime of the response. If there is no response, returns `Regime::Stuck`.
    pub(super) fn regime(&self, r: f64, friction: FrictionAmount) -> Regime {
        self.response(r, friction)
            .map_or(Regime::Stuck, |response| response.regime())
    }

    /// Returns the derivatives of the amplitude with respect to r and β. They are exact for a displacement under a load
    /// of constant amplitude, and otherwise central differences. Returns `None` if a derivative does not exist.
    pub(super) fn slopes(&self, r: f64, beta: f64) -> Option<[f64; 2]> {
        if !self.objective.has_derivatives() {
            return self.differences(r, beta);
        }
        let response = self.response(r, FrictionAmount::Ratio(beta)).ok()?;
        let (fixed_r, fixed_beta) = (Sensitive::fixed(r.into()), Sensitive::fixed(beta.into()));
        let slope = |r: Sensitive, beta: Sensitive| {
            let known = swing(
                &self.unvaried,
                &response,
                (r, beta),
                self.objective.of,
                false,
            );
            let slope = known.ok()?.0.slope.to_f64();
            slope.is_finite().then_some(slope)
        };
        Some([
            slope(Sensitive::variable(r.into()), fixed_beta)?,
            slope(fixed_r, Sensitive::variable(beta.into()))?,
        ])
    }

    /// Returns central differences instead of derivatives, for a quantity without exact derivatives. Returns `None` if
    /// the regime changes within a difference, because the quantity may then jump.
    fn differences(&self, r: f64, beta: f64) -> Option<[f64; 2]> {
        let [along_r, along_beta] = [DIFFERENCE * r, DIFFERENCE * beta];
        let at = |r: f64, beta: f64| {
            let friction = FrictionAmount::Ratio(beta);
            (self.at(r, friction), self.regime(r, friction))
        };
        let slope = |[below, above]: [(f64, Regime); 2], step: f64| {
            let slope = (above.0 - below.0) / (step + step);
            (below.1 == above.1 && slope.is_finite()).then_some(slope)
        };
        Some([
            slope([at(r - along_r, beta), at(r + along_r, beta)], along_r)?,
            slope(
                [at(r, beta - along_beta), at(r, beta + along_beta)],
                along_beta,
            )?,
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::{Amplitude, FrictionAmount, Objective};
    use crate::Of;
    use crate::study::System;

    /// Checks that the search counts evaluations without a result. In this chain neither the contact nor damping acts
    /// on the second mode. A steady state with stops therefore does not exist.
    #[test]
    fn what_has_no_answer_is_counted() {
        let text = "struct Chain { masses: { a: 1, b: 1, c: 1 }, contact: b - wall, excitation: a,
            springs: { base - a: 1, a - b: 1, b - c: 1, c - wall: 1 } }";
        let system: System = text.parse().unwrap();
        let limits = system.at(0.5).unwrap().limits();
        let amplitude = Amplitude::new(&system, Objective::displacement(Of::Mass(0)));
        let slides = FrictionAmount::Ratio(0.5 * limits.continuous);
        assert!(amplitude.at(0.5, slides).is_finite());
        assert_eq!((amplitude.asked.get(), amplitude.silent.get()), (1, 0));
        let stops = FrictionAmount::Ratio(0.5 * (limits.continuous + limits.sliding));
        for asked in [1, 2] {
            assert!(amplitude.at(0.5, stops).is_nan());
            assert_eq!(
                (amplitude.asked.get(), amplitude.silent.get()),
                (1 + asked, asked)
            );
        }
    }
}

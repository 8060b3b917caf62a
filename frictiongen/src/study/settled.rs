//! Selects the steady state in which the motion from rest, or from another state, ends.

use super::at::SystemAt;
use super::held::SystemHeld;
use super::motion::SystemMotion;
use super::orbit::SystemOrbit;
use super::response::SystemResponse;
#[cfg(feature = "desk")]
use super::start::InitialState;
use crate::{Error, Given, NoOrbit, NotContinuous, OutOfDomain, Regime, StuckResonance};
use frictiongen_kernel::orbit::Start;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_kernel::response::Scene as _;

/// Relative tolerance, in machine epsilons, within which √λ_i/r is treated as an even integer. √λ_i is the frequency
/// ratio of mode i. If √λ_i/r is an even integer, an undamped mode has a Floquet multiplier on the unit circle.
const ON_CIRCLE: f64 = 4096.0;
/// Friction ratio β at which a contact sticks from its initial state on, except very close to a resonance of the stuck
/// chain.
const LOCKED: f64 = 1e12;

/// Largest number of masses with which the search for unstable states takes seconds and not minutes.
const MOST_MASSES: usize = 64;
/// Largest difference of two harmonics that are treated as the same, divided by the amplitude.
const SAME: f64 = 1e-6;

impl<'a> SystemAt<'a> {
    /// Returns the steady response at the friction ratio β = F/P, in any regime: the state in which the motion from
    /// rest ends, or from the initial state of the system ([`InitialState`](super::InitialState)).
    ///
    /// With μ = 1 this state is the closed form for every β < β_lim. The exception is a chain without damping at r =
    /// √λ_i/(2n) with an integer n, where √λ_i is the frequency ratio of a mode that the contact drives. At these r the
    /// closed form belongs to a continuum of steady states. With μ > 1, other states may exist in addition to the
    /// closed form and to the stuck state. The call then computes the motion from event to event.
    ///
    /// If the motion from rest does not settle, the call searches for another stable steady state. The search starts
    /// from the states that the motion visits, then from the closed form, from neighbouring friction ratios and from
    /// the stuck state. If the search finds a state, the call returns it, and [`SystemOrbit::is_from_rest`] is false.
    /// If the search finds no state, the call returns the last 64 cycles of the motion from rest.
    ///
    /// # Errors
    /// [`NotContinuous::Unbounded`] and [`StuckResonance`](crate::StuckResonance) on an undamped resonance.
    /// [`NoOrbit`](crate::NoOrbit) if no steady state exists. [`OutOfDomain`] for NaN, negative and infinite β. For a
    /// system with an initial state, [`OutOfDomain`] also at r = 0 and r = ∞, where the excitation has no cycle.
    pub fn response(&self, beta: f64) -> Result<SystemResponse<'a>, Error> {
        self.response_after(beta, || self.orbit_or_last_cycles(beta))
    }

    /// Returns the [`response`](Self::response). `from_rest` returns the steady state of the motion from rest, or the
    /// last cycles of this motion.
    pub(in crate::study) fn response_after(
        &self,
        beta: f64,
        from_rest: impl FnOnce() -> Result<SystemOrbit<'a>, NoOrbit>,
    ) -> Result<SystemResponse<'a>, Error> {
        if self.scene().start.is_some() && !self.has_cycles() {
            let r = Given::of(self.frequency_ratio());
            return Err(OutOfDomain::FrequencyRatioInTime(r).into());
        }
        let motion = self.motion(beta);
        match motion {
            Ok(motion) if beta == 0.0 || self.is_unique() => Ok(SystemResponse::Continuous(motion)),
            Err(NotContinuous::OutOfDomain) => {
                Err(OutOfDomain::FrictionRatio(Given::of(beta)).into())
            }
            Err(NotContinuous::Unbounded) if beta < self.sliding_limit() => {
                Err(NotContinuous::Unbounded.into())
            }
            // At r = 0 and r = ∞ the excitation has no cycle that a search could follow.
            Ok(motion) if !self.has_cycles() => Ok(SystemResponse::Continuous(motion)),
            Err(NotContinuous::Stuck) if !self.has_cycles() => self.centred(),
            motion => {
                let orbit = self.settled_or_other(beta, from_rest()?)?;
                self.told(orbit, motion.ok())
            }
        }
    }

    /// Returns the response in which the motion from the state `start` ends, and the state of this response. The next
    /// call can use the returned state as its initial state. The amplitude of the load is proportional to r⁻ⁿ with n =
    /// `fall`.
    #[cfg(feature = "desk")]
    pub(super) fn response_from(
        &self,
        beta: f64,
        start: &InitialState,
        fall: i32,
    ) -> Result<(SystemResponse<'a>, InitialState), Error> {
        let motion = match self.motion(beta) {
            Err(NotContinuous::OutOfDomain) => {
                return Err(OutOfDomain::FrictionRatio(Given::of(beta)).into());
            }
            motion => motion.ok(),
        };
        let r = self.frequency_ratio();
        let (displacements, velocities) = start.at(r);
        let orbit = self.orbit_or_last_cycles_from(beta, (&displacements, &velocities))?;
        let tau = -orbit.origin();
        let masses = 0..orbit.system.scene().masses.len();
        let state = masses
            .filter_map(|mass| orbit.mass_at(mass))
            .map(|motion| (motion.displacement(tau), motion.velocity(tau)))
            .unzip();
        let carried = InitialState::at_ratio(state, r, fall);
        Ok((self.told(orbit, motion)?, carried))
    }

    /// Returns every steady state that the search finds at the friction ratio β, stable or not: those of
    /// [`states`](frictiongen_kernel::response::At::states), and with μ > 1 also unstable ones and mirror images. The
    /// search is that of [`JoinedAt::states`](super::joined::JoinedAt::states), for up to 64 masses.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: frictiongen::System = "struct Block {
    ///     masses: { m: 1 }, springs: { base - m: 1 }, contact: m - base, excitation: base, stiction: 1.5,
    /// }".parse()?;
    /// let states = block.at(0.55)?.every_state(0.1)?;
    /// let unstable = states.iter().find(|orbit| !orbit.is_stable()).ok_or("none")?;
    /// assert!((unstable.contact().amplitude() - 0.436472360457).abs() < 1e-11);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn every_state(&self, beta: f64) -> Result<Vec<SystemOrbit<'a>>, OutOfDomain> {
        let mut all: Vec<SystemOrbit<'a>> = self.states(beta)?.collect();
        let (system, r) = (*self.scene(), self.frequency_ratio());
        let is_large = system.scene().masses.len() > MOST_MASSES;
        if self.is_unique() || !self.has_cycles() || is_large {
            return Ok(all);
        }
        let found = system
            .joined()
            .and_then(|joined| joined.at(r)?.states(beta));
        // Where no motion settles, the first search has told the reason.
        for state in found.unwrap_or_default() {
            if state.is_marginal() {
                continue;
            }
            let (x, v) = state.state();
            let period = u32::try_from(state.period()).unwrap_or(u32::MAX);
            let start = Start::Cycle(&x, &v, period);
            let orbit = system.settled_from(r, beta, start, (self.sliding_limit(), false));
            let Ok(orbit) = orbit else { continue };
            let largest = orbit.contact().amplitude();
            let mut contacts = state.contacts();
            let is_found =
                contacts.all(|contact| (contact.displacement() - largest).abs() <= SAME * largest);
            if is_found && !all.iter().any(|known| are_alike(known, &orbit)) {
                all.push(orbit);
            }
        }
        Ok(all)
    }

    /// Returns the regime of the steady state `orbit` at this frequency ratio. Other steady states at the same β have
    /// no influence. If the motion does not settle, the result is stick-slip.
    #[must_use]
    pub fn regime_of(&self, orbit: &SystemOrbit<'_>) -> Regime {
        // Just below β*_lim, rounding can hide a small motion of the contact. The code therefore also compares β with
        // β*_lim.
        let holds = !(orbit.beta() < self.sliding_limit());
        let frictionless = orbit.beta() == 0.0;
        if holds && orbit.is_settled() && orbit.never_slides() {
            Regime::Stuck
        } else if (slides_twice(orbit) || frictionless) && self.motion(orbit.beta()).is_ok() {
            Regime::Continuous
        } else {
            Regime::StickSlip
        }
    }

    /// Returns the largest force in the contact, and the energy that the contact dissipates in a cycle, for a steady
    /// state at this frequency ratio. Force and energy are divided by P and P²/k₁ (by k₁Y and k₁Y² for base motion).
    /// Returns `None` if the contact never slides and no stuck response exists.
    pub(super) fn contact_of(&self, orbit: &SystemOrbit<'_>) -> Option<(f64, f64)> {
        let energy = orbit.beta() * orbit.sliding_distance() / f64::from(orbit.period());
        let force = if orbit.is_settled() && orbit.never_slides() {
            SystemResponse::Stuck(self.held(orbit).ok()?).contact_force()
        } else if orbit.stops() == 0 {
            orbit.beta()
        } else {
            orbit.beta() * self.scene().scene().stiction
        };
        Some((force, energy))
    }

    /// Returns the steady state as the response of its regime: continuous, stick-slip or stuck.
    fn told(
        &self,
        orbit: SystemOrbit<'a>,
        motion: Option<SystemMotion<'a>>,
    ) -> Result<SystemResponse<'a>, Error> {
        let slides = slides_twice(&orbit);
        match motion {
            _ if self.regime_of(&orbit) == Regime::Stuck => {
                Ok(SystemResponse::Stuck(self.held(&orbit)?))
            }
            Some(motion) if slides && orbit.is_symmetric() => {
                let motion = motion.with_start(orbit.is_from_rest());
                Ok(SystemResponse::Continuous(motion))
            }
            // This steady state is not symmetric, and belongs to the same continuum as the closed form.
            Some(_) if slides => Ok(SystemResponse::StickSlip(Box::new(orbit.sliding()))),
            _ => Ok(SystemResponse::StickSlip(Box::new(orbit))),
        }
    }

    /// Returns the response under a friction with which the contact never leaves its initial place.
    pub(super) fn locked(&self) -> Result<SystemResponse<'a>, Error> {
        match self.scene().start {
            None => self.centred(),
            Some(_) => self.response(LOCKED),
        }
    }

    /// Returns the response while the contact is stuck at z̄ = 0.
    fn centred(&self) -> Result<SystemResponse<'a>, Error> {
        Ok(SystemResponse::Stuck(SystemHeld {
            stuck: self.stuck()?,
            middle: 0.0,
            offset: 0.0,
            offset_range: 0.0,
            from_rest: true,
        }))
    }

    /// Returns the response of a steady state in which the contact never slides.
    fn held(&self, orbit: &SystemOrbit<'_>) -> Result<SystemHeld<'a>, StuckResonance> {
        Ok(SystemHeld {
            stuck: self.stuck()?,
            middle: orbit.middle(),
            offset: orbit.offset(),
            offset_range: orbit.offset_range().unwrap_or(0.0),
            from_rest: orbit.is_from_rest(),
        })
    }

    /// Returns `last`, the result of the motion from rest, if this motion settles. Otherwise returns another stable
    /// state, or `last` if the search finds none.
    fn settled_or_other(
        &self,
        beta: f64,
        last: SystemOrbit<'a>,
    ) -> Result<SystemOrbit<'a>, NoOrbit> {
        if last.is_settled() {
            return Ok(last);
        }
        let mut others = self.states(beta)?.without_rest();
        let other = others.find(|orbit| orbit.is_stable());
        Ok(other.map_or(last, SystemOrbit::not_from_rest))
    }

    /// Returns true if no steady state other than the closed form can exist. For μ > 1 the result is false. If μ is 1,
    /// the result is false only if √λ_i/r is an even integer for an undamped mode that the contact drives. √λ_i is the
    /// frequency ratio of this mode.
    fn is_unique(&self) -> bool {
        let numbers = self.scene().numbers();
        let even = |x: f64| {
            let half = x * 0.5;
            half > 0.5 && (half - half.round()).abs() <= ON_CIRCLE * f64::EPSILON * half
        };
        let inverse = self.inverse_ratio();
        let marginal = |mode: &Mode<f64>| {
            mode.kind == Kind::Undamped && mode.in_contact && even(mode.resonance * inverse)
        };
        numbers.chain.stiction <= 1.0 && !numbers.modes.iter().any(marginal)
    }

    /// Returns true if the frequency ratio r is neither 0 nor infinite.
    fn has_cycles(&self) -> bool {
        let r = self.frequency_ratio();
        0.0 < r && r.is_finite()
    }
}

/// Returns true if the contact slides all the time and reverses exactly twice in a cycle, as in the closed form.
fn slides_twice(orbit: &SystemOrbit<'_>) -> bool {
    orbit.is_settled() && (orbit.stops(), orbit.reversals(), orbit.period()) == (0, 2, 1)
}

#[cfg(all(test, feature = "desk"))]
#[allow(clippy::expect_used, reason = "a test may fail")]
mod tests {
    use crate::study::{InitialState, System};

    /// Checks that the state of a sweep keeps its displacements in m and its velocities in m/s at another frequency, so
    /// that dx̄/dτ = (dx̄/dt)/ω changes.
    #[test]
    fn a_state_goes_over_to_another_frequency() {
        let text = "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall,
            excitation: block }";
        let system: System = text.parse().expect("a scene");
        let from = system.at(1.2).expect("in the domain");
        let found = from.response_from(0.4, &InitialState::rest(1), 2);
        let (x, v) = found.expect("a response").1.at::<f64>(1.2);
        assert!(0.1 < v[0].abs());
        let (same, doubled) = (InitialState::at_ratio((x.clone(), v.clone()), 1.2, 0), 0.6);
        assert_eq!(same.at(doubled), (x.clone(), vec![2.0 * v[0]]));
        // Under a base motion of constant acceleration, half the frequency makes the unit of displacement four times as
        // large.
        let quarter = InitialState::at_ratio((x.clone(), v.clone()), 1.2, 2).at(doubled);
        assert_eq!(quarter, (vec![0.25 * x[0]], vec![0.5 * v[0]]));
    }
}

/// Returns true if the contact has the same mean and the same fundamental in two steady states of one period.
fn are_alike(one: &SystemOrbit<'_>, other: &SystemOrbit<'_>) -> bool {
    let (a, b) = (one.contact(), other.contact());
    let size = a.amplitude().max(b.amplitude());
    let near = |n: u32| (a.harmonic(n) - b.harmonic(n)).norm() <= SAME * size;
    one.period() == other.period() && near(0) && near(1)
}

//! Selects the steady state in which the motion from rest, or from another state, ends.

use super::at::SystemAt;
use super::held::{SystemHeld, offset_from_rest};
use super::motion::SystemMotion;
use super::orbit::SystemOrbit;
use super::response::SystemResponse;
use crate::{Error, Given, NoOrbit, NotContinuous, OutOfDomain, Regime, StuckResonance};
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_kernel::response::Scene as _;

/// Relative tolerance, in machine epsilons, within which √λ_i/r is treated as an even integer. √λ_i is the frequency
/// ratio of mode i. If √λ_i/r is an even integer, an undamped mode has a Floquet multiplier on the unit circle.
const ON_CIRCLE: f64 = 4096.0;

/// The state of a steady motion at a maximum of the excitation. It consists of displacement and velocity of every mass,
/// as non-dimensional groups.
#[cfg(feature = "desk")]
#[derive(Clone, Debug)]
pub(super) struct Carried {
    r: f64,
    displacements: Vec<f64>,
    velocities: Vec<f64>,
}

#[cfg(feature = "desk")]
impl Carried {
    /// Divides displacements and velocities by the unit of displacement at another frequency ratio r. The unit changes
    /// with r, because the amplitude of the load is proportional to r⁻ⁿ. n is `fall`.
    pub(super) fn under(&self, fall: i32, r: f64) -> Self {
        let factor = (r / self.r).powi(fall);
        let scaled = |values: &[f64]| values.iter().map(|value| value * factor).collect();
        Self {
            r: self.r,
            displacements: scaled(&self.displacements),
            velocities: scaled(&self.velocities),
        }
    }

    fn of(orbit: &SystemOrbit<'_>, r: f64) -> Self {
        let tau = -orbit.origin();
        let masses = 0..orbit.system.scene().masses.len();
        let (displacements, velocities) = masses
            .filter_map(|mass| orbit.mass_at(mass))
            .map(|motion| (motion.displacement(tau), motion.velocity(tau)))
            .unzip();
        Self {
            r,
            displacements,
            velocities,
        }
    }
}

impl<'a> SystemAt<'a> {
    /// Returns the steady response at the friction ratio β = F/P, in any regime: the state in which the motion from
    /// rest ends.
    ///
    /// With μ = 1 this state is the closed form for every β < β_lim. The exception is a chain without damping at r =
    /// √λ_i/(2n) with an integer n, where √λ_i is the frequency ratio of a mode that the contact drives. At these r the
    /// closed form belongs to a continuum of steady states. With μ > 1, other states may exist in addition to the
    /// closed form and to the stuck state. The call then computes the motion from event to event.
    ///
    /// If the motion from rest does not settle, the call searches for another stable steady state. The search starts
    /// from the closed form, from a neighbouring friction ratio or from the stuck state. If the search finds a state,
    /// the call returns it, and [`SystemOrbit::is_from_rest`] is false. If the search finds no state, the call returns
    /// the last 64 cycles of the motion from rest.
    ///
    /// # Errors
    /// [`NotContinuous::Unbounded`] and [`StuckResonance`](crate::StuckResonance) on an undamped resonance.
    /// [`NoOrbit`](crate::NoOrbit) if no steady state exists. [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn response(&self, beta: f64) -> Result<SystemResponse<'a>, Error> {
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
            Err(NotContinuous::Stuck) if !self.has_cycles() => {
                Ok(SystemResponse::Stuck(self.held(0.0, 0.0)?))
            }
            motion => {
                let orbit = self.settled_orbit(beta)?;
                self.told(orbit, motion.ok())
            }
        }
    }

    /// Returns the response in which the motion from the state `start` ends, and the state of this response. Without
    /// `start` the motion starts from rest. The next call can use the returned state as its initial state.
    #[cfg(feature = "desk")]
    pub(super) fn response_from(
        &self,
        beta: f64,
        start: Option<&Carried>,
    ) -> Result<(SystemResponse<'a>, Carried), Error> {
        let motion = match self.motion(beta) {
            Err(NotContinuous::OutOfDomain) => {
                return Err(OutOfDomain::FrictionRatio(Given::of(beta)).into());
            }
            motion => motion.ok(),
        };
        let r = self.frequency_ratio();
        let orbit = match start {
            None => self.orbit_or_last_cycles(beta)?,
            Some(carried) => {
                // The velocity dx/dt stays the same when the frequency changes. It is proportional to r·dx̄/dτ.
                let factor = carried.r / r;
                let velocities: Vec<f64> = carried.velocities.iter().map(|v| v * factor).collect();
                self.orbit_or_last_cycles_from(beta, (&carried.displacements, &velocities))?
            }
        };
        let carried = Carried::of(&orbit, r);
        Ok((self.told(orbit, motion)?, carried))
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
            let held = self.held(orbit.offset(), 0.0).ok()?;
            SystemResponse::Stuck(held).contact_force()
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
                let range = orbit.offset_range().unwrap_or(0.0);
                let mut held = self.held(orbit.offset(), range)?;
                held.from_rest = orbit.is_from_rest();
                Ok(SystemResponse::Stuck(held))
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

    /// Returns the response under a friction with which the contact never leaves its initial position. The offset of
    /// the contact is that of [`offset_from_rest`]: on a moving base it is −Y for a rigid contact, and smaller for an
    /// elastic contact. Without a moving base in the contact, the offset is 0.
    pub(super) fn locked(&self) -> Result<SystemResponse<'a>, Error> {
        let offset = offset_from_rest(self.scene());
        Ok(SystemResponse::Stuck(self.held(offset, f64::INFINITY)?))
    }

    /// Returns the response while the contact is stuck at an offset.
    fn held(&self, offset: f64, offset_range: f64) -> Result<SystemHeld<'a>, StuckResonance> {
        Ok(SystemHeld {
            stuck: self.stuck()?,
            offset,
            offset_range,
            from_rest: true,
        })
    }

    /// Returns the steady state in which the motion from rest ends. If the motion from rest does not settle, returns
    /// another stable state.
    fn settled_orbit(&self, beta: f64) -> Result<SystemOrbit<'a>, NoOrbit> {
        let last = self.orbit_or_last_cycles(beta)?;
        if last.is_settled() {
            return Ok(last);
        }
        let mut others = self.states(beta)?;
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
    use super::Carried;
    use crate::study::System;

    /// Checks a motion that starts from a state at another frequency. The displacements and the velocities dx̄/dt must
    /// stay unchanged, so that dx̄/dτ = (dx̄/dt)/ω changes. A contact that sticks at once keeps its offset, which
    /// depends on the initial position and velocity.
    #[test]
    fn a_state_goes_over_to_another_frequency() {
        let text = "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall,
            excitation: block }";
        let system: System = text.parse().expect("a scene");
        let from = system.at(1.2).expect("in the domain");
        let (_, carried) = from.response_from(0.4, None).expect("a response");
        assert!(
            carried
                .velocities
                .iter()
                .all(|velocity| 0.1 < velocity.abs())
        );
        let to = system.at(0.6).expect("in the domain");
        let (stuck, _) = to.response_from(1.5, Some(&carried)).expect("a response");
        // The test halves the angular frequency ω, so that dx̄/dτ doubles.
        let twice: Vec<f64> = carried
            .velocities
            .iter()
            .map(|velocity| 2.0 * velocity)
            .collect();
        let state = (carried.displacements.as_slice(), twice.as_slice());
        let expected = to.orbit_from(1.5, state).expect("a state").offset();
        assert!(0.1 < expected.abs(), "{expected}");
        assert!((stuck.offset() - expected).abs() < 1e-12);
        let other = Carried { r: 0.6, ..carried };
        let (other, _) = to.response_from(1.5, Some(&other)).expect("a response");
        assert!(1e-3 < (other.offset() - expected).abs());
    }
}

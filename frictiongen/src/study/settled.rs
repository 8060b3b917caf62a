//! Which steady state answers: the one that motion from rest, or from another state, ends in.

use super::at::SystemAt;
use super::held::{SystemHeld, share_of_base};
use super::motion::SystemMotion;
use super::orbit::SystemOrbit;
use super::response::SystemResponse;
use crate::{Error, NoOrbit, NotContinuous, OutOfDomain, Regime, StuckResonance};
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_kernel::response::Scene as _;

/// A multiplier counts as on the unit circle within so many roundings, as it does for a steady state.
const ON_CIRCLE: f64 = 4096.0;

/// The state of a steady motion where the excitation is at its maximum.
#[cfg(feature = "desk")]
#[derive(Clone, Debug)]
pub(super) struct Carried {
    r: f64,
    displacements: Vec<f64>,
    velocities: Vec<f64>,
}

#[cfg(feature = "desk")]
impl Carried {
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
    /// The steady response at β = F/P, in whatever regime: the state that motion from rest ends in.
    ///
    /// With μ = 1 that is the closed form for every β < β_lim, except for a chain without damping at r = 1/2n, where it is
    /// one of a continuum.  With μ > 1 other states may exist beside the closed form and beside the stuck state, and the
    /// motion is followed.
    ///
    /// Where motion from rest does not settle, the answer is another stable steady state, found from the closed form, a
    /// neighbouring friction ratio or the stuck state; [`SystemOrbit::is_from_rest`] is false then.  Where none is found
    /// either, the answer is the last 64 cycles of the motion from rest.
    ///
    /// # Errors
    /// [`NotContinuous::Unbounded`] and [`StuckResonance`](crate::StuckResonance) on an undamped resonance,
    /// [`NoOrbit`](crate::NoOrbit) where there is no steady state to follow, [`OutOfDomain`] for NaN, negative and
    /// infinite β.
    pub fn response(&self, beta: f64) -> Result<SystemResponse<'a>, Error> {
        let motion = self.motion(beta);
        match motion {
            Ok(motion) if beta == 0.0 || self.is_unique() => Ok(SystemResponse::Continuous(motion)),
            Err(NotContinuous::OutOfDomain) => Err(OutOfDomain { argument: "beta" }.into()),
            Err(NotContinuous::Unbounded) if beta < self.sliding_limit() => {
                Err(NotContinuous::Unbounded.into())
            }
            // Neither 0 nor ∞ has a cycle to follow.
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

    /// The response that motion from another state ends in, with the state to carry on from.
    #[cfg(feature = "desk")]
    pub(super) fn response_from(
        &self,
        beta: f64,
        start: Option<&Carried>,
    ) -> Result<(SystemResponse<'a>, Carried), Error> {
        let motion = match self.motion(beta) {
            Err(NotContinuous::OutOfDomain) => {
                return Err(OutOfDomain { argument: "beta" }.into());
            }
            motion => motion.ok(),
        };
        let r = self.frequency_ratio();
        let orbit = match start {
            None => self.orbit_or_last_cycles(beta)?,
            Some(carried) => {
                // A velocity in time is r times dx̄/dτ.
                let factor = carried.r / r;
                let velocities: Vec<f64> = carried.velocities.iter().map(|v| v * factor).collect();
                self.orbit_or_last_cycles_from(beta, (&carried.displacements, &velocities))?
            }
        };
        let carried = Carried::of(&orbit, r);
        Ok((self.told(orbit, motion)?, carried))
    }

    /// The regime of a steady state at this frequency ratio: the state's own, whatever others exist beside it.  Of a motion
    /// that does not settle it is stick-slip.
    #[must_use]
    pub fn regime_of(&self, orbit: &SystemOrbit<'_>) -> Regime {
        // Within rounding below β*_lim a motion may be too small to be seen.
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

    /// The response that an orbit is.
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
            // Another of the closed form's continuum.
            Some(_) if slides => Ok(SystemResponse::StickSlip(Box::new(orbit.sliding()))),
            _ => Ok(SystemResponse::StickSlip(Box::new(orbit))),
        }
    }

    /// The response with so much friction that the contact stays where it is at rest: at its centre, or for a contact with
    /// the moving base where the base has gone by then.
    pub(super) fn locked(&self) -> Result<SystemResponse<'a>, Error> {
        let offset = -share_of_base(self.scene());
        Ok(SystemResponse::Stuck(self.held(offset, f64::INFINITY)?))
    }

    /// The response while the contact is stuck at an offset.
    fn held(&self, offset: f64, offset_range: f64) -> Result<SystemHeld<'a>, StuckResonance> {
        Ok(SystemHeld {
            stuck: self.stuck()?,
            offset,
            offset_range,
            from_rest: true,
        })
    }

    /// The steady state that motion from rest ends in; where it does not settle, another that is stable.
    fn settled_orbit(&self, beta: f64) -> Result<SystemOrbit<'a>, NoOrbit> {
        let last = self.orbit_or_last_cycles(beta)?;
        if last.is_settled() {
            return Ok(last);
        }
        let mut others = self.states(beta)?;
        let other = others.find(|orbit| orbit.is_stable());
        Ok(other.map_or(last, SystemOrbit::not_from_rest))
    }

    /// Whether no other steady state can exist beside the closed form: with μ = 1, unless an undamped mode turns an even
    /// number of times in half a period.
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

    /// Whether r is neither 0 nor infinite.
    fn has_cycles(&self) -> bool {
        let r = self.frequency_ratio();
        0.0 < r && r.is_finite()
    }
}

/// Whether it slides all the time and turns twice in a cycle, as the closed form does.
fn slides_twice(orbit: &SystemOrbit<'_>) -> bool {
    orbit.is_settled() && (orbit.stops(), orbit.reversals(), orbit.period()) == (0, 2, 1)
}

#[cfg(test)]
#[allow(clippy::expect_used, reason = "a test may fail")]
mod tests {
    use super::Carried;
    use crate::study::System;

    /// Displacements and velocities in time go over unchanged from one frequency to another, and dx̄/dτ = (dx̄/dt)/ω.  A
    /// contact that sticks at once keeps its place, which depends on where it was and how fast.
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
        // ω halves, so dx̄/dτ doubles.
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

//! Derivatives of a response with respect to every number of a description and of an operating point, in any regime.
//!
//! At an operating point in physical units, a derivative with respect to a mass or a stiffness keeps the frequency in
//! Hz, the friction force and the load constant. The non-dimensional groups refer to the first mass m₁ and the first
//! spring k₁. A change of m₁ or k₁ therefore also changes r, β or the unit of displacement.

use super::error::StudyError;
use super::parameter::{OperatingPoint, Parameter, Slope, parameters_of};
use super::response::{SystemHeld, SystemResponse};
use super::system::System;
use super::units::{Load, angular_frequency, reversed_phase};
use super::varied::{Sensitive, Varied};
use crate::{Given, Of, OutOfDomain, Regime};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::orbit::NoDerivative;
use frictiongen_kernel::{Float, Scalar};
use frictiongen_model::sensitivity::Quantity;

/// The derivatives of a response with respect to one parameter p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterSensitivity {
    /// The parameter p of the derivatives.
    pub parameter: Parameter,
    /// The value of the parameter p, in its own unit.
    pub value: f64,
    /// Largest displacement and its derivative with respect to p, in m. At a non-dimensional operating point the
    /// displacement is divided by P/k₁ (by Y for base motion).
    pub amplitude: Slope,
    /// Lag of the largest displacement and its derivative with respect to p, in rad. `None` if the contact or mass does
    /// not move.
    pub phase: Option<Slope>,
    /// The limit of continuous motion β_lim and its derivative with respect to p. Under a load the limit is a force in
    /// N. At a non-dimensional operating point it is a friction ratio. `None` if the limit or its derivative is not
    /// finite.
    pub continuous_limit: Option<Slope>,
    /// The limit of sliding β*_lim and its derivative with respect to p, in the units of `continuous_limit`. `None` if
    /// the limit or its derivative is not finite.
    pub sliding_limit: Option<Slope>,
}

/// The derivatives of a response at one operating point, with respect to every parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseSensitivities {
    /// The regime of the response at the operating point.
    pub regime: Regime,
    /// Derivatives with respect to each parameter, in the order masses, springs, damping, contact stiffness, stiction,
    /// friction, load, frequency.
    pub parameters: Vec<ParameterSensitivity>,
}

/// Amplitude, phase, β_lim and β*_lim at one operating point, each with its derivative with respect to one parameter.
struct PointAnswers {
    amplitude: Sensitive,
    phase: Option<Sensitive>,
    continuous_limit: Sensitive,
    sliding_limit: Sensitive,
}

/// Frequency ratio r and friction ratio β of an operating point, and the units of length and force of the
/// non-dimensional amplitudes and limits. Each of these four numbers has derivatives.
struct PhysicalGroups {
    r: Sensitive,
    beta: Sensitive,
    length: Sensitive,
    force: Sensitive,
}

impl System {
    /// Returns the exact derivatives of amplitude and phase of a motion, and of the limits β_lim and β*_lim, with
    /// respect to every parameter. The response may be in any regime.
    ///
    /// The source of the derivatives depends on the regime. If the contact slides all the time, it is the closed form.
    /// If the contact stops and slides, it is the steady state in which the motion from rest ends. If the contact never
    /// slides, it is the stuck response.
    ///
    /// At a physical operating point, a change of m₁ or k₁ also changes the non-dimensional groups. No derivative then
    /// depends on the order of masses and springs. The phase of the contact then has the sign of the contact in the
    /// scene description ([`contact_is_reversed`](Self::contact_is_reversed)).
    ///
    /// ```
    /// use frictiongen::study::{System, units::Load, sensitivity::{OperatingPoint, Parameter, Quantity}};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 2.0 },            // kg
    ///     springs: { base - block: 50.0 },   // N/m
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let load = Load::Force(10.0); // N
    /// let point = OperatingPoint::Physical { hertz: 0.3, friction: 4.0, load };
    /// let all = block.response_sensitivities(point, block.motion_named("block")?)?;
    /// let of = |parameter| all.parameters.iter().find(|found| found.parameter == parameter);
    /// // With two stops a cycle, one more newton of friction reduces the amplitude by 4.9 mm.
    /// let friction = of(Parameter::Friction).ok_or("no friction")?;
    /// assert!((friction.amplitude.derivative + 0.004916).abs() < 1e-6);
    /// // If P, F, m and k all double, the motion stays the same.
    /// let sum: f64 = [
    ///     Parameter::Friction,
    ///     Parameter::Load,
    ///     Parameter::Quantity(Quantity::Mass(0)),
    ///     Parameter::Quantity(Quantity::Stiffness(0)),
    /// ]
    /// .iter()
    /// .filter_map(|parameter| of(*parameter)?.amplitude.relative(of(*parameter)?.value))
    /// .sum();
    /// assert!(sum.abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`StudyError`] for an operating point outside the domain, and for a load that does not fit the scene.
    /// [`StudyError`] also for a motion that the scene does not have, for a spring force or the base shear, and if no
    /// steady motion exists. [`NoDerivative`] if the response has no derivative.
    pub fn response_sensitivities(
        &self,
        point: OperatingPoint,
        of: Of,
    ) -> Result<ResponseSensitivities, StudyError> {
        if !self.has_motion(of) {
            return Err(StudyError::NoSuchMotion(of));
        }
        if matches!(of, Of::Spring(_) | Of::Shear) {
            return Err(StudyError::ForceHasNoDerivative);
        }
        let (r, beta) = self.groups_at(point)?;
        let at = self.at(r)?;
        let response = at.response(beta)?;
        let regime = response.regime();
        let mut parameters = Vec::new();
        let unvaried = self.unvaried();
        for (parameter, value) in parameters_of(&self.scene, point, self) {
            let own = match parameter {
                Parameter::Quantity(quantity) => self.along(quantity),
                _ => None,
            };
            let varied = own.as_ref().unwrap_or(&unvaried);
            let groups = groups(self, varied, point, parameter);
            let answers = self.answers(varied, &groups, &response, (point, of))?;
            let slope = |answer| slope(answer, value);
            let amplitude = slope(answers.amplitude * groups.length).ok_or(NoDerivative::Graze)?;
            parameters.push(ParameterSensitivity {
                parameter,
                value,
                amplitude,
                phase: answers.phase.and_then(slope),
                continuous_limit: slope(answers.continuous_limit * groups.force),
                sliding_limit: slope(answers.sliding_limit * groups.force),
            });
        }
        Ok(ResponseSensitivities { regime, parameters })
    }

    /// Returns the frequency ratio r and the friction ratio β of an operating point. Fails if the load does not fit
    /// the scene, or if β is negative, infinite or NaN.
    fn groups_at(&self, point: OperatingPoint) -> Result<(f64, f64), StudyError> {
        let (r, beta) = match point {
            OperatingPoint::Groups { r, beta } => (r, beta),
            OperatingPoint::Physical {
                hertz,
                friction,
                load,
            } => {
                let r = self.frequency_ratio_at_hertz(hertz);
                let scale = self.load_scale_at(load, r)?;
                (r, scale.friction_ratio(friction))
            }
        };
        if beta.is_finite() && 0.0 <= beta {
            Ok((r, beta))
        } else {
            Err(OutOfDomain::FrictionRatio(Given::of(beta)).into())
        }
    }

    fn answers(
        &self,
        varied: &Varied,
        groups: &PhysicalGroups,
        response: &SystemResponse<'_>,
        (point, of): (OperatingPoint, Of),
    ) -> Result<PointAnswers, StudyError> {
        let PhysicalGroups { r, beta, .. } = *groups;
        let at = varied.at(r)?;
        let physical = matches!(point, OperatingPoint::Physical { .. });
        let turned = physical && of == Of::Contact && self.contact_is_reversed();
        let (amplitude, phase) = swing(varied, response, (r, beta), of, turned)?;
        Ok(PointAnswers {
            amplitude,
            phase,
            continuous_limit: at.continuous_limit(),
            sliding_limit: at.sliding_limit(),
        })
    }
}

/// Returns amplitude and phase of the motion `of` in a known response, with their derivatives. The phase is `None` if
/// the contact or mass does not move. If `turned` is true, the result is that of the contact's relative motion with
/// the opposite sign.
pub(super) fn swing(
    varied: &Varied,
    response: &SystemResponse<'_>,
    (r, beta): (Sensitive, Sensitive),
    of: Of,
    turned: bool,
) -> Result<(Sensitive, Option<Sensitive>), StudyError> {
    let (amplitude, phase) = match response {
        SystemResponse::StickSlip(orbit) => {
            let orbit = varied.orbit_along(orbit, r, beta)?;
            let largest = orbit.ask_of(of, |motion| motion.largest());
            let (amplitude, phase) = largest.ok_or(NoDerivative::Graze)?;
            if turned {
                return Ok((amplitude, Some(orbit.reversed_contact_phase())));
            }
            (amplitude, phase)
        }
        SystemResponse::Stuck(held) => return stuck_swing(varied, held, r, of),

        SystemResponse::Continuous(_) => {
            let motion = varied.at(r)?.motion(beta)?;
            let motion = motion.motion_of(of).ok_or(NoDerivative::Graze)?;
            (motion.amplitude(), motion.phase())
        }
    };
    let phase = if turned { reversed_phase(phase) } else { phase };
    Ok((amplitude, Some(phase)))
}

/// Returns amplitude and phase of a motion with their derivatives, for a response in which the contact never slides.
/// Fails if an initial state has left the contact away from its middle, because the function cannot differentiate this
/// place.
fn stuck_swing(
    varied: &Varied,
    held: &SystemHeld<'_>,
    r: Sensitive,
    of: Of,
) -> Result<(Sensitive, Option<Sensitive>), StudyError> {
    if held.middle() != 0.0 {
        return Err(NoDerivative::Marginal.into());
    }
    let motion = varied
        .at(r)?
        .stuck()?
        .motion_at(of, Sensitive::constant(0.0));
    let (motion, _) = motion.ok_or(NoDerivative::Graze)?;
    if motion.re.vanishes() && motion.im.vanishes() {
        return Ok((Sensitive::constant(0.0), None));
    }
    let phase = -(motion.im.atan2(motion.re));
    Ok((motion.re.hypot(motion.im), Some(phase)))
}

/// Returns r, β, and the units of length and force of an operating point. All four have derivatives with respect to
/// `parameter`.
fn groups(
    system: &System,
    varied: &Varied,
    point: OperatingPoint,
    parameter: Parameter,
) -> PhysicalGroups {
    let number = |value: f64, own: bool| {
        let value = Dd::from(value);
        if own {
            Dual::variable(value)
        } else {
            Dual::fixed(value)
        }
    };
    match point {
        OperatingPoint::Groups { r, beta } => PhysicalGroups {
            r: number(r, parameter == Parameter::Frequency),
            beta: number(beta, parameter == Parameter::Friction),
            length: number(1.0, false),
            force: number(1.0, false),
        },
        OperatingPoint::Physical {
            hertz,
            friction,
            load,
        } => {
            let hertz = number(hertz, parameter == Parameter::Frequency);
            let friction = number(friction, parameter == Parameter::Friction);
            let first = system.scene.first_stiffness();
            let stiffness = number(
                first,
                parameter == Parameter::Quantity(Quantity::Stiffness(0)),
            );
            let own = parameter == Parameter::Load;
            let amplitude = number(load.amplitude(), own);
            let omega = angular_frequency(hertz);
            let (length, force) = match load {
                Load::Force(_) => (amplitude / stiffness, amplitude),
                Load::Base(_) => (amplitude, stiffness * amplitude),
                Load::BaseVelocity(_) => (amplitude / omega, stiffness * amplitude / omega),
                Load::BaseAcceleration(_) => {
                    let length = amplitude / (omega * omega);
                    (length, stiffness * length)
                }
                Load::Unbalance(_) => {
                    let force = amplitude * omega * omega;
                    (force / stiffness, force)
                }
            };
            PhysicalGroups {
                r: varied.frequency_ratio(omega),
                beta: friction / force,
                length,
                force,
            }
        }
    }
}

/// Largest relative derivative |p·(dX/dp)/X| that is treated as 0. If |X| exceeds 1, the code uses |p·dX/dp| instead.
/// Rounding of numbers with 30 digits causes values of this size.
const NOTHING: f64 = 1e-24;

/// Returns a number and its derivative with respect to one parameter. `parameter` is the value of that parameter.
/// Returns `None` unless both results are finite.
fn slope(answer: Sensitive, parameter: f64) -> Option<Slope> {
    let mut slope = Slope {
        value: answer.value.to_f64(),
        derivative: answer.slope.to_f64(),
    };
    if (slope.derivative * parameter).abs() < NOTHING * slope.value.abs().min(1.0) {
        slope.derivative = 0.0;
    }
    (slope.value.is_finite() && slope.derivative.is_finite()).then_some(slope)
}

//! Computes exact derivatives of steady states with several contacts. The parameters are the numbers of a scene
//! description and of an operating point.
//!
//! The search finds the steady state without derivatives. The engine then follows the motion over a few periods with dual
//! numbers, whose derivatives pass through all events ([`frictiongen_kernel::joints::vary`]).

use super::at::JoinedAt;
use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::parameter::{JoinedParameter, JoinedPoint};
use super::scene::Joined;
use super::units::AnswerUnits;
use super::varied::Number;
use crate::study::joints::{Chain, Heap};
use crate::study::parameter::Slope;
use crate::study::sensitivity::{NoDerivative, OperatingPoint};
use crate::study::system::System;
use crate::study::units::angular_frequency;
use crate::{OutOfDomain, Regime};
use frictiongen_kernel::joints::{self, Observe, Piece, Waveform};
use frictiongen_model::scene::Scene;

/// Derivatives of a steady state with respect to one parameter p.
#[derive(Clone, Debug, PartialEq)]
pub struct JoinedSensitivity {
    /// Parameter p with respect to which the derivatives are taken.
    pub parameter: JoinedParameter,
    /// The value of the parameter p, in its own unit.
    pub value: f64,
    /// Amplitude of each mass and its derivative with respect to p.
    pub amplitudes: Vec<Slope>,
    /// Lag of the largest displacement of each mass and its derivative with respect to p, in rad. `None` for a mass that
    /// does not move.
    pub phases: Vec<Option<Slope>>,
    /// Numbers of each contact and stop, with their derivatives with respect to p.
    pub contacts: Vec<ContactSensitivity>,
}

/// Numbers of a contact over a period, each with its derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSensitivity {
    /// Energy that the contact dissipates in a period.
    pub energy: Slope,
    /// Largest absolute force of the contact.
    pub force: Slope,
    /// Distance that the contact slides in a period, added over both directions.
    pub slip: Slope,
    /// Largest absolute relative displacement of the contact.
    pub displacement: Slope,
    /// Fraction of the period during which the contact sticks.
    pub stuck_fraction: Slope,
}

/// Derivatives of a steady state with respect to every parameter.
///
/// Under a load, amplitudes are in m, forces in N and energies in J. At a non-dimensional operating point, amplitudes are
/// divided by P/k₁, forces by P and energies by P²/k₁ (by Y, k₁Y and k₁Y² for base motion).
#[derive(Clone, Debug, PartialEq)]
pub struct JoinedSensitivities {
    /// The regime of the steady state.
    pub regime: Regime,
    /// Derivatives with respect to each parameter, in the order masses, springs, damping, dashpots, contacts, friction,
    /// load, frequency. The list leaves out shares and frictions that are 0.
    pub parameters: Vec<JoinedSensitivity>,
}

/// Data of a scene at an operating point that the search for a steady state needs.
pub(super) struct Prepared {
    pub(super) chain: Chain,
    pub(super) omega: f64,
    pub(super) units: AnswerUnits,
}

impl Joined<'_> {
    /// Returns exact derivatives of the steady state that the motion from rest, or from the initial state of the system,
    /// reaches: of the amplitude and the phase of each mass, and of the numbers of each contact. A contact that never slides
    /// stays in the middle of the interval in which it can stick.
    ///
    /// The steady state may have a period of several cycles. The derivative with respect to a μ of 1 is that towards larger
    /// μ.
    ///
    /// ```
    /// use frictiongen::study::{System, joined::JoinedParameter, sensitivity::OperatingPoint};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: System = "struct Frame {
    ///     masses: { lower: 2.0, upper: 1.5 },
    ///     springs: { base - lower: 1500.0, lower - upper: 1200.0 },
    ///     contacts: { brace: base - lower { stiffness: 4.0e3 }, pads: lower - upper { share: 0.6 } },
    ///     damping: modal(0.01),
    ///     excitation: base,
    /// }"
    /// .parse()?;
    /// let all = frame.joined()?.sensitivities(OperatingPoint::Groups { r: 0.6, beta: 0.3 })?;
    /// let of = |parameter| all.parameters.iter().find(|found| found.parameter == parameter);
    /// let shares = [0, 1].map(|contact| of(JoinedParameter::Share(contact)));
    /// // A change of all shares by one factor has the effect of a change of the friction.
    /// if let (Some(friction), [Some(brace), Some(pads)]) = (of(JoinedParameter::Friction), shares) {
    ///     let of_shares = brace.amplitudes[1].derivative + 0.6 * pads.amplitudes[1].derivative;
    ///     assert!((0.3 * friction.amplitudes[1].derivative - of_shares).abs() < 1e-12);
    /// }
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`NoDerivative::Marginal`] if the steady state depends on the initial state, because a contact never slides or a part
    /// of the chain has no path of springs to a support. A state that has the opposite sign half a cycle later depends on
    /// neither. [`NoDerivative::Graze`] if an event is about to appear or to vanish. [`JoinedError::Engine`] if the motion
    /// does not settle. Other [`JoinedError`]s for an operating point outside the domain.
    pub fn sensitivities(&self, point: OperatingPoint) -> Result<JoinedSensitivities, JoinedError> {
        let setting = JoinedPoint::new(self.scene(), point);
        let system = system(&setting.scene)?;
        let mut joined = system.joined()?;
        joined.set_start(self.start().cloned());
        let (at, friction) = operating(&system, &joined, point)?;
        let known = KnownState {
            orbit: at.orbit(friction)?,
            chain: at.chain(friction)?,
            system: &system,
            setting: &setting,
        };
        let mut parameters = Vec::new();
        for parameter in setting.parameters() {
            let value = setting.value(parameter).unwrap_or_default();
            // Without friction or share, a contact has no events, and its phase has no derivative.
            let is_damping = matches!(parameter, JoinedParameter::Quantity(_));
            if is_damping || value != 0.0 {
                parameters.push(known.sensitivity(parameter, value)?);
            }
        }
        Ok(JoinedSensitivities {
            regime: known.orbit.regime(),
            parameters,
        })
    }
}

/// The steady state of which the code computes derivatives.
struct KnownState<'s> {
    orbit: JoinedOrbit<'s>,
    chain: Chain,
    system: &'s System,
    setting: &'s JoinedPoint,
}

impl KnownState<'_> {
    /// Returns the derivatives with respect to one parameter.
    fn sensitivity(
        &self,
        parameter: JoinedParameter,
        value: f64,
    ) -> Result<JoinedSensitivity, JoinedError> {
        let varied = self
            .setting
            .varied(self.system, &self.chain.model()?, parameter);
        let steady = self.orbit.steady();
        let mut pieces = Pieces(vec![Vec::new(); self.chain.masses.len()]);
        let (omega, force) = (varied.omega, varied.force);
        let size = if value == 0.0 { 1.0 } else { value.abs() };
        let cycle = steady.vary(varied.model, (omega, size), &mut pieces)?;
        let slope = |number, unit| slope(number, (size, unit));
        let amplitudes = match steady.neutral {
            0 => &cycle.amplitudes,
            _ => &cycle.centred,
        };
        let amplitudes = amplitudes.iter().map(|own| slope(*own, 0.0));
        let amplitudes: Result<Vec<Slope>, _> = amplitudes.collect();
        let phases = pieces.0.into_iter().map(|pieces| {
            let course = Waveform::new(pieces, omega, steady.period);
            let moves = course.amplitude().value != 0.0;
            moves.then(|| slope(course.phase(), 1.0)).transpose()
        });
        let contacts = cycle.contacts.iter().map(|own| {
            Ok(ContactSensitivity {
                energy: slope(own.energy / force, 0.0)?,
                force: slope(own.force / force, 0.0)?,
                slip: slope(own.slip, 0.0)?,
                displacement: slope(own.displacement, 0.0)?,
                stuck_fraction: slope(own.stuck_fraction, 1.0)?,
            })
        });
        Ok(JoinedSensitivity {
            parameter,
            value,
            amplitudes: amplitudes?,
            phases: phases.collect::<Result<_, NoDerivative>>()?,
            contacts: contacts.collect::<Result<_, NoDerivative>>()?,
        })
    }
}

/// Largest |p dX/dp| that counts as 0, because rounding causes it, divided by |X| or by the unit of X.
const NOTHING: f64 = 1e-14;

/// Converts a number X with its derivative with respect to a parameter of the size `parameter`. `unit` is 1 for an angle or a
/// fraction, whose rounding does not depend on its value, and otherwise 0. Fails if one of the two is not finite.
fn slope(number: Number, (parameter, unit): (f64, f64)) -> Result<Slope, NoDerivative> {
    let change = number.slope.abs() * parameter;
    let is_nothing = change < NOTHING * number.value.abs().max(unit);
    let found = Slope {
        value: number.value,
        derivative: if is_nothing { 0.0 } else { number.slope },
    };
    let is_finite = found.value.is_finite() && found.derivative.is_finite();
    is_finite.then_some(found).ok_or(NoDerivative::Graze)
}

/// Observer of a period that collects the course of each mass.
struct Pieces(Vec<Vec<Piece<Number>>>);

impl Observe<Number, Heap> for Pieces {
    fn stretch(
        &mut self,
        series: &joints::Series<Number, Heap>,
        end: Number,
        _: &joints::State<Number, Heap>,
    ) {
        for (mass, pieces) in self.0.iter_mut().enumerate() {
            pieces.push(Piece {
                start: series.start,
                length: series.length,
                end,
                terms: series.displacement_terms(mass),
            });
        }
    }
}

/// Returns the chain of a scene at an operating point, with its load and with the friction force of each contact.
pub(super) fn prepare(setting: &JoinedPoint) -> Result<Prepared, JoinedError> {
    prepare_on(&system(&setting.scene)?, setting.point)
}

/// Returns the chain of a system at an operating point, as [`prepare`] does.
pub(super) fn prepare_on(system: &System, point: OperatingPoint) -> Result<Prepared, JoinedError> {
    let (at, friction) = operating(system, &system.joined()?, point)?;
    Ok(Prepared {
        chain: at.chain(friction)?,
        omega: at.omega(),
        units: at.units(),
    })
}

/// Evaluates a scene at an operating point, and returns the common friction there.
pub(super) fn operating<'a>(
    system: &System,
    joined: &Joined<'a>,
    point: OperatingPoint,
) -> Result<(JoinedAt<'a>, f64), JoinedError> {
    Ok(match point {
        OperatingPoint::Groups { r, beta } => (joined.at(r)?, beta),
        OperatingPoint::Physical {
            hertz,
            friction,
            load,
        } => {
            let omega = angular_frequency(hertz);
            system.fits(load).map_err(JoinedError::Load)?;
            (joined.under(omega, load.at(omega).amplitude())?, friction)
        }
    })
}

/// Returns the system of a scene whose numbers differ slightly from those of a valid scene.
pub(super) fn system(scene: &Scene) -> Result<System, JoinedError> {
    let system = System::try_from(scene.clone());
    system.map_err(|_| JoinedError::OutOfDomain(OutOfDomain::State))
}

//! Computes derivatives of steady states with several contacts. The parameters are the numbers of a scene description
//! and of an operating point.
//!
//! The module finds the steady state of a slightly changed scene by Newton's method, from the known state, with a
//! residual below 1e-11. The derivatives are central differences of such states, with Richardson's extrapolation from
//! two steps. A step is valid only if each contact stops and reverses as often in both changed states as in the known
//! state.

use super::at::JoinedAt;
use super::error::JoinedError;
use super::parameter::{JoinedParameter, JoinedPoint};
use super::scene::Joined;
use super::units::AnswerUnits;
use crate::study::joints::{
    Chain, JointError, Motion, Place, Steady, steady_state, steady_state_near,
};
use crate::study::parameter::Slope;
use crate::study::sensitivity::{NoDerivative, OperatingPoint};
use crate::study::system::System;
use crate::study::units::angular_frequency;
use crate::{OutOfDomain, Regime};
use frictiongen_model::scene::Scene;

/// First step of the parameter in a central difference, divided by the value of the parameter.
const STEP: f64 = 1e-3;
/// Largest number of steps of the parameter that the code tries. Each step is a quarter of the previous step.
const STEPS: usize = 5;
/// Largest change of p·dX/dp by Richardson's extrapolation, divided by X + |p·dX/dp|. p is the parameter. X is the
/// largest amplitude, or the sum of all energies. The relative error of the extrapolated derivative is about the
/// square of this number.
const AGREES: f64 = 3e-5;

/// Derivatives of a steady state with respect to one parameter p.
#[derive(Clone, Debug, PartialEq)]
pub struct JoinedSensitivity {
    /// Parameter p with respect to which the derivatives are taken.
    pub parameter: JoinedParameter,
    /// The value of the parameter p, in its own unit.
    pub value: f64,
    /// Amplitude of each mass and its derivative with respect to p.
    pub amplitudes: Vec<Slope>,
    /// Energy that each contact dissipates in a period, and its derivative with respect to p.
    pub energies: Vec<Slope>,
}

/// Derivatives of a steady state with respect to every parameter.
///
/// Under a load, amplitudes are in m and energies in J. At a non-dimensional operating point, amplitudes are divided by
/// P/k₁ and energies by P²/k₁ (by Y and k₁Y² for base motion).
#[derive(Clone, Debug, PartialEq)]
pub struct JoinedSensitivities {
    /// The regime of the steady state.
    pub regime: Regime,
    /// Derivatives with respect to each parameter, in the order masses, springs, damping, dashpots, contacts, friction,
    /// load, frequency. The list leaves out parameters that are 0, and a μ of 1.
    pub parameters: Vec<JoinedSensitivity>,
}

/// Data of a scene at an operating point that the search for a steady state needs.
pub(super) struct Prepared {
    pub(super) chain: Chain,
    pub(super) omega: f64,
    pub(super) units: AnswerUnits,
}

/// Amplitudes of the masses and energies of the contacts in a steady state, and the numbers of stops and reversals of
/// each contact.
struct SteadyAmplitudes {
    numbers: Vec<f64>,
    events: Vec<(usize, usize)>,
}

impl Joined<'_> {
    /// Returns derivatives of the steady state that the motion from rest reaches: of the amplitude of each mass, and
    /// of the energy that each contact dissipates.
    ///
    /// The method computes each derivative as a difference of steady states. The error of a derivative is about 1e-8
    /// of the amplitude, or of the sum of all energies. The steady state may have a period of several cycles.
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
    ///     assert!((0.3 * friction.amplitudes[1].derivative - of_shares).abs() < 1e-7);
    /// }
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`NoDerivative::Marginal`] if the steady state depends on the initial state. This is the case if a contact
    /// never slides, or if a part of the chain has no path of springs to a support. [`NoDerivative::Graze`] if an
    /// event is about to appear or to vanish. [`JoinedError::Engine`] if the motion does not settle. Other
    /// [`JoinedError`]s for an operating point outside the domain.
    pub fn sensitivities(&self, point: OperatingPoint) -> Result<JoinedSensitivities, JoinedError> {
        let setting = JoinedPoint::new(self.scene(), point);
        let prepared = prepare(&setting)?;
        let motion = Motion::from_rest(&prepared.chain)?;
        let steady = steady_state(motion, prepared.omega, (Place::Centred, None))?.settled()?;
        if !steady.marginal.is_empty() || steady.neutral > 0 {
            return Err(NoDerivative::Marginal.into());
        }
        let search = NeighbourSearch {
            found: SteadyAmplitudes::of(&steady, prepared.units),
            masses: prepared.chain.masses.len(),
            setting,
            steady,
        };
        let mut parameters = Vec::new();
        for parameter in search.setting.parameters() {
            if let Some(found) = search.sensitivity(parameter)? {
                parameters.push(found);
            }
        }
        Ok(JoinedSensitivities {
            regime: search.steady.cycle.regime(),
            parameters,
        })
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

impl SteadyAmplitudes {
    fn of(steady: &Steady, units: AnswerUnits) -> Self {
        let cycle = &steady.cycle;
        let amplitudes = cycle.amplitudes.iter().map(|x| x / units.length);
        let energies = cycle.contacts.iter().map(|c| c.energy / units.energy());
        let events = cycle.contacts.iter().map(|c| (c.stops, c.reversals));
        Self {
            numbers: amplitudes.chain(energies).collect(),
            events: events.collect(),
        }
    }
}

/// The known steady state of a scene. The search for the steady states of slightly changed scenes starts from this
/// state.
struct NeighbourSearch {
    setting: JoinedPoint,
    steady: Steady,
    found: SteadyAmplitudes,
    /// Number of masses in the scene.
    masses: usize,
}

impl NeighbourSearch {
    /// Returns the derivatives with respect to one parameter. No central difference exists if the parameter is 0, or if
    /// it is a ratio μ that the first step would reduce below 1. The method then returns `None`.
    fn sensitivity(
        &self,
        parameter: JoinedParameter,
    ) -> Result<Option<JoinedSensitivity>, JoinedError> {
        let value = self.setting.value(parameter);
        let Some(value) = value.filter(|value| *value != 0.0) else {
            return Ok(None);
        };
        let is_stiction = matches!(parameter, JoinedParameter::Stiction(_));
        if is_stiction && value * (1.0 - STEP) < 1.0 {
            return Ok(None);
        }
        let derivatives = self.derivatives(parameter, value)?;
        let pairs = self.found.numbers.iter().zip(derivatives);
        let slopes = pairs.map(|(value, derivative)| Slope {
            value: *value,
            derivative,
        });
        let mut amplitudes: Vec<Slope> = slopes.collect();
        let energies = amplitudes.split_off(self.masses);
        Ok(Some(JoinedSensitivity {
            parameter,
            value,
            amplitudes,
            energies,
        }))
    }

    /// Returns the derivatives of all amplitudes and energies with respect to a parameter.
    fn derivatives(&self, parameter: JoinedParameter, value: f64) -> Result<Vec<f64>, JoinedError> {
        let mut coarse: Option<Vec<f64>> = None;
        let mut step = STEP;
        for _ in 0..STEPS {
            let Some(fine) = self.difference(parameter, value, step)? else {
                (coarse, step) = (None, step / 4.0);
                continue;
            };
            if let Some(coarse) = &coarse {
                let pairs = fine.iter().zip(coarse);
                // The error of a central difference is proportional to the square of the step.
                let better: Vec<f64> = pairs
                    .map(|(fine, coarse)| fine + (fine - coarse) / 15.0)
                    .collect();
                if self.agree(&fine, &better, value) {
                    return Ok(better);
                }
            }
            (coarse, step) = (Some(fine), step / 4.0);
        }
        Err(NoDerivative::Graze.into())
    }

    /// Returns the central difference over a step of the parameter. `step` is the step divided by `value`. Returns
    /// `None` if one of the two changed steady states does not exist, or stops or reverses more or less often than the
    /// known state.
    fn difference(
        &self,
        parameter: JoinedParameter,
        value: f64,
        step: f64,
    ) -> Result<Option<Vec<f64>>, JoinedError> {
        let ends = [value * (1.0 + step), value * (1.0 - step)];
        let [Some(above), Some(below)] = [
            self.moved(parameter, ends[0])?,
            self.moved(parameter, ends[1])?,
        ] else {
            return Ok(None);
        };
        let pairs = above.numbers.iter().zip(&below.numbers);
        let width = ends[0] - ends[1];
        Ok(Some(
            pairs
                .map(|(above, below)| (above - below) / width)
                .collect(),
        ))
    }

    /// Returns the steady state for another value of a parameter. Returns `None` if Newton's method finds no steady
    /// state. Also returns `None` if a contact stops or reverses more or less often than in the known state.
    fn moved(
        &self,
        parameter: JoinedParameter,
        value: f64,
    ) -> Result<Option<SteadyAmplitudes>, JoinedError> {
        let Prepared {
            chain,
            omega,
            units,
        } = prepare(&self.setting.with(parameter, value))?;
        let found = match steady_state_near(&chain, omega, &self.steady) {
            Ok(steady) => SteadyAmplitudes::of(&steady, units),
            Err(JointError::NotSteady) => return Ok(None),
            Err(error) => return Err(error.into()),
        };
        Ok((found.events == self.found.events).then_some(found))
    }

    /// Returns true if the extrapolation changes no derivative by more than the tolerance `AGREES`. `fine` contains
    /// the derivatives before the extrapolation, and `better` contains those after it.
    fn agree(&self, fine: &[f64], better: &[f64], value: f64) -> bool {
        let (amplitudes, energies) = self.found.numbers.split_at(self.masses);
        let largest = amplitudes.iter().copied().fold(0.0, f64::max);
        let energy: f64 = energies.iter().sum();
        let mut pairs = fine.iter().zip(better).enumerate();
        pairs.all(|(index, (fine, better))| {
            let size = if index < self.masses { largest } else { energy };
            let change = ((better - fine) * value).abs();
            change <= AGREES * (size + (better * value).abs())
        })
    }
}

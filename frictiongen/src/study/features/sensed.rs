//! Derivatives of a feature with respect to every parameter. If a zero of a function defines the feature, implicit
//! differentiation gives the derivatives. Otherwise closed forms give the derivatives.

use super::isolate::{FunctionZero, MotionFunction};
use crate::study::parameter::{OperatingPoint, Parameter, parameters_of};
use crate::study::sensitivity::{Sensitive, Varied};
use crate::study::system::System;
use crate::study::units::{Load, LoadError, LoadScale};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::modal::Modal;
use frictiongen_model::sensitivity::Quantity;

/// The derivative of a number X with respect to one parameter p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterSlope {
    /// Parameter p with respect to which the derivative is taken.
    pub parameter: Parameter,
    /// The value of the parameter p, in the parameter's own unit.
    pub value: f64,
    /// The derivative dX/dp of the number X.
    pub derivative: f64,
}

/// A number X with its derivatives dX/dp. There is one derivative for each parameter p on which X depends smoothly.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensed {
    /// The number X itself.
    pub value: f64,
    /// The derivatives dX/dp of X, one for each parameter p.
    pub slopes: Vec<ParameterSlope>,
}

impl Sensed {
    /// Returns the relative derivative (p/X)·dX/dp: the change of X in per cent for one per cent of p. Returns `None`
    /// if X is 0, or if X has no derivative with respect to this parameter.
    #[must_use]
    pub fn relative(&self, parameter: Parameter) -> Option<f64> {
        let mut slopes = self.slopes.iter();
        let slope = slopes.find(|slope| slope.parameter == parameter)?;
        let relative = slope.value / self.value * slope.derivative;
        relative.is_finite().then_some(relative)
    }

    /// Returns the parameter with the largest absolute relative derivative, and this relative derivative.
    #[must_use]
    pub fn strongest(&self) -> Option<(Parameter, f64)> {
        let relative = self
            .slopes
            .iter()
            .filter_map(|slope| Some((slope.parameter, self.relative(slope.parameter)?)));
        relative.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))
    }
}

/// Largest change p·dX/dp that is treated as 0, divided by X. In numbers of 30 digits, rounding causes changes of this
/// size.
const NOTHING: f64 = 1e-18;

/// The scene and its units, each with its derivative with respect to one parameter.
pub(super) struct Variation {
    pub parameter: Parameter,
    pub value: f64,
    pub varied: Varied,
    /// Unit of force: P (k₁Y for base motion) if the load is given, otherwise 1.
    pub force: Sensitive,
    /// Unit of length: P/k₁ (Y for base motion) if the load is given, otherwise 1.
    pub length: Sensitive,
    /// Frequency in Hz at the frequency ratio r = 1 if the load is given, otherwise 1.
    pub frequency: Sensitive,
}

/// The scene with its derivatives with respect to each parameter. Under a load the numbers are in physical units.
/// Otherwise the numbers are non-dimensional groups.
pub(super) struct Variations {
    pub scale: Option<LoadScale>,
    pub all: Vec<Variation>,
    /// The scene without a varied parameter, for derivatives with respect to the frequency ratio r.
    pub unvaried: Varied,
}

impl Variations {
    pub fn new(system: &System, load: Option<Load>) -> Result<Self, LoadError> {
        let scale = load.map(|load| system.constant_scale(load)).transpose()?;
        let point = match load {
            Some(load) => OperatingPoint::Physical {
                hertz: 1.0,
                friction: 1.0,
                load,
            },
            None => OperatingPoint::Groups { r: 1.0, beta: 1.0 },
        };
        let known = parameters_of(system.scene(), point, system);
        let mut all = Vec::new();
        for (parameter, value) in known {
            let varied = match parameter {
                Parameter::Quantity(quantity) => system.along(quantity),
                Parameter::Frequency => None,
                Parameter::Friction | Parameter::Load => Some(system.unvaried()),
            };
            let Some(varied) = varied else { continue };
            let [force, length] = units(system, load, parameter);
            let two_pi = Sensitive::constant(2.0) * Sensitive::pi();
            let frequency = match load {
                Some(_) => varied.modal().reference / two_pi,
                None => Sensitive::constant(1.0),
            };
            all.push(Variation {
                parameter,
                value,
                varied,
                force,
                length,
                frequency,
            });
        }
        Ok(Self {
            scale,
            all,
            unvaried: system.unvaried(),
        })
    }

    /// Returns the number `value` with its derivative with respect to each parameter. `of` computes the derivative from
    /// the scene in which this parameter varies. The result leaves out parameters without a finite derivative.
    pub fn sensed(
        &self,
        value: f64,
        beta: Option<f64>,
        of: impl Fn(&Variation) -> Option<Sensitive>,
    ) -> Sensed {
        let mut slopes = Vec::new();
        for variation in &self.all {
            if beta.is_none() && variation.parameter == Parameter::Friction {
                continue;
            }
            let answer = of(variation).map(|answer| answer.slope.to_f64());
            let Some(derivative) = answer.filter(|slope| slope.is_finite()) else {
                continue;
            };
            let parameter = match variation.parameter {
                Parameter::Friction => self.friction(beta.unwrap_or(0.0)),
                _ => variation.value,
            };
            let nothing = (derivative * parameter).abs() < NOTHING * value.abs();
            slopes.push(ParameterSlope {
                parameter: variation.parameter,
                value: parameter,
                derivative: if nothing { 0.0 } else { derivative },
            });
        }
        Sensed { value, slopes }
    }

    /// Converts a friction ratio β to a friction force in N under a load. Without a load, returns β.
    pub fn friction(&self, beta: f64) -> f64 {
        self.scale.map_or(beta, |scale| scale.friction(beta))
    }

    /// Converts a displacement x̄ to m under a load. Without a load, returns x̄.
    pub fn length(&self, amplitude: f64) -> f64 {
        self.scale
            .map_or(amplitude, |scale| scale.displacement(amplitude))
    }

    /// Returns a friction ratio with its derivatives, as a force in N under a load.
    pub fn of_friction(
        &self,
        value: f64,
        of: impl Fn(&Modal<Sensitive>) -> Option<Sensitive>,
    ) -> Sensed {
        let of = |variation: &Variation| Some(of(variation.varied.modal())? * variation.force);
        self.sensed(self.friction(value), None, of)
    }

    /// Returns the frequency at the frequency ratio r with its derivatives, in Hz under a load. `of` returns the
    /// derivative of r with respect to one parameter.
    pub fn of_frequency(
        &self,
        r: f64,
        beta: Option<f64>,
        of: impl Fn(&Variation) -> Option<Dd>,
    ) -> Sensed {
        let value = match self.scale {
            Some(_) => {
                let reference = self.unvaried.modal().reference.value.to_f64();
                r * reference / std::f64::consts::TAU
            }
            None => r,
        };
        self.sensed(value, beta, |variation| {
            let moved = Dual {
                value: Dd::from(r),
                slope: of(variation)?,
            };
            Some(moved * variation.frequency)
        })
    }

    /// Returns the frequency at a zero of a function f, with its derivatives: dr/dp = r² (∂f/∂p)/(∂f/∂y), where y =
    /// 1/r and p is a parameter.
    pub fn of_zero(
        &self,
        function: &MotionFunction<'_>,
        zero: &FunctionZero,
        beta: Option<f64>,
    ) -> Sensed {
        self.of_frequency(zero.r(), beta, |variation| {
            if !zero.crosses {
                return None;
            }
            let friction = variation.beta(beta.unwrap_or(0.0), self.scale);
            let moved = function.moved(zero, variation.varied.modal(), friction);
            Some(moved / zero.slope / (zero.y * zero.y))
        })
    }

    /// Returns the frequency at r with its derivatives. At this r and β the function f is zero. The derivatives of the
    /// frequency follow from the derivatives of f, by implicit differentiation.
    pub fn of_place(
        &self,
        r: f64,
        beta: f64,
        f: impl Fn(&Varied, Sensitive, Sensitive) -> Option<Sensitive>,
    ) -> Sensed {
        let place = Dd::from(r);
        let along = f(
            &self.unvaried,
            Dual::variable(place),
            Dual::fixed(Dd::from(beta)),
        );
        self.of_frequency(r, Some(beta), |variation| {
            let friction = variation.beta(beta, self.scale);
            let moved = f(&variation.varied, Dual::fixed(place), friction)?;
            Some(-(moved.slope / along?.slope))
        })
    }
}

impl Variation {
    /// Returns the friction ratio β with its derivative with respect to the varied parameter. Under a load the friction
    /// force is constant, and β may vary with the unit of force.
    pub fn beta(&self, beta: f64, scale: Option<LoadScale>) -> Sensitive {
        let own = self.parameter == Parameter::Friction;
        let number = |value: Dd| {
            if own {
                Dual::variable(value)
            } else {
                Dual::fixed(value)
            }
        };
        match scale {
            None => number(Dd::from(beta)),
            Some(_) => number(Dd::from(beta) * self.force.value) / self.force,
        }
    }
}

/// Returns the units of force (P or k₁Y) and of length (P/k₁ or Y) with their derivatives. Without a load both units
/// are 1.
fn units(system: &System, load: Option<Load>, parameter: Parameter) -> [Sensitive; 2] {
    let number = |value: f64, own: bool| {
        if own {
            Dual::variable(Dd::from(value))
        } else {
            Dual::fixed(Dd::from(value))
        }
    };
    let stiffness = number(
        system.scene().first_stiffness(),
        parameter == Parameter::Quantity(Quantity::Stiffness(0)),
    );
    let own = parameter == Parameter::Load;
    match load {
        None => [Sensitive::constant(1.0); 2],
        Some(load) if load.is_base_motion() => {
            let length = number(load.amplitude(), own);
            [stiffness * length, length]
        }
        Some(load) => {
            let force = number(load.amplitude(), own);
            [force, force / stiffness]
        }
    }
}

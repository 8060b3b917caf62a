//! Parameters of a response, with their symbols and units: the numbers of a description and of an operating point.

use super::system::System;
use super::units::Load;
use frictiongen_model::scene::{Damping, Scene};
use frictiongen_model::sensitivity::Quantity;

/// Operating point of a response: the frequency, the friction and the load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OperatingPoint {
    /// The operating point is given by the non-dimensional groups r and β.
    Groups {
        /// Frequency ratio r = ω√(m₁/k₁) of the excitation.
        r: f64,
        /// Friction ratio β = F/P (F/(k₁Y) for base motion).
        beta: f64,
    },
    /// The operating point is given in physical units: Hz, N, and the unit of the load.
    Physical {
        /// Frequency of the excitation, in Hz.
        hertz: f64,
        /// Kinetic friction force F, in N.
        friction: f64,
        /// The load in its own unit, for example a force P in N or a base motion Y in m.
        load: Load,
    },
}

/// A number on which a response depends. It is a number of the scene description or of the operating point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Parameter {
    /// A number of the scene description, in its own unit: a mass, a stiffness, a damping number, or the ratio μ.
    Quantity(Quantity),
    /// The friction. It is the force F in N at a physical operating point, and β at a non-dimensional operating point.
    Friction,
    /// The amplitude of the load in its own unit, for example P in N or Y in m. A non-dimensional operating point does
    /// not have this parameter.
    Load,
    /// The frequency. It is in Hz at a physical operating point, and is the ratio r at a non-dimensional operating
    /// point.
    Frequency,
}

/// A number X and its derivative with respect to one parameter p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// The number X itself.
    pub value: f64,
    /// The derivative dX/dp of X with respect to the parameter p.
    pub derivative: f64,
}

impl Slope {
    /// Returns the relative derivative (p/X)·dX/dp, where `parameter` is the value of p. Returns `None` if X is 0.
    #[must_use]
    pub fn relative(&self, parameter: f64) -> Option<f64> {
        let relative = parameter / self.value * self.derivative;
        relative.is_finite().then_some(relative)
    }
}

impl Parameter {
    /// Returns the symbol of the parameter, which contains names from the description. Examples are `m upper`,
    /// `k base - lower`, `zeta 1` and `F`.
    #[must_use]
    pub fn symbol(&self, scene: &Scene, point: &OperatingPoint) -> String {
        let physical = matches!(point, OperatingPoint::Physical { .. });
        let short = match self {
            Self::Quantity(quantity) => return symbol(*quantity, scene),
            Self::Friction if physical => "F",
            Self::Friction => "beta",
            Self::Load => match point {
                OperatingPoint::Physical { load, .. } => match load {
                    Load::Base(_) => "Y",
                    Load::BaseVelocity(_) => "v",
                    Load::BaseAcceleration(_) => "a",
                    Load::Unbalance(_) => "m e",
                    Load::Force(_) => "P",
                },
                OperatingPoint::Groups { .. } => "P",
            },
            Self::Frequency if physical => "f",
            Self::Frequency => "r",
        };
        short.to_owned()
    }

    /// Returns the key of the parameter, an identifier for programs. Examples are `m.upper`, `k.base-lower`, `zeta.1`
    /// and `F`.
    #[must_use]
    pub fn key(&self, scene: &Scene, point: &OperatingPoint) -> String {
        let symbol = self.symbol(scene, point);
        symbol.replace(" - ", "-").replace(' ', ".")
    }

    /// Returns the parameter in words, for a reader. Examples are ``m of `upper` ``, ``k of `base - lower` ``, `zeta of
    /// mode 1` and `F`.
    #[must_use]
    pub fn label(&self, scene: &Scene, point: &OperatingPoint) -> String {
        let symbol = self.symbol(scene, point);
        match (self, symbol.split_once(' ')) {
            (Self::Quantity(Quantity::DampingRatio(_)), Some((zeta, mode))) => {
                format!("{zeta} of mode {mode}")
            }
            (_, Some((short, name))) => format!("{short} of `{name}`"),
            (_, None) => symbol,
        }
    }

    /// Returns the SI unit of the parameter. The text is empty if the parameter is a ratio.
    #[must_use]
    pub fn unit(&self, point: &OperatingPoint) -> &'static str {
        let physical = matches!(point, OperatingPoint::Physical { .. });
        match self {
            Self::Quantity(Quantity::Mass(_)) => "kg",
            Self::Quantity(Quantity::Stiffness(_) | Quantity::ContactStiffness) => "N/m",
            Self::Quantity(Quantity::MassDamping) => "1/s",
            Self::Quantity(Quantity::StiffnessDamping) => "s",
            Self::Load => match point {
                OperatingPoint::Physical { load, .. } => match load {
                    Load::Base(_) => "m",
                    Load::BaseVelocity(_) => "m/s",
                    Load::BaseAcceleration(_) => "m/s2",
                    Load::Unbalance(_) => "kg m",
                    Load::Force(_) => "N",
                },
                OperatingPoint::Groups { .. } => "N",
            },
            Self::Friction if physical => "N",
            Self::Frequency if physical => "Hz",
            _ => "",
        }
    }
}

pub(super) fn symbol(quantity: Quantity, scene: &Scene) -> String {
    let mass = |place: usize| scene.masses.get(place).map_or("?", |mass| &mass.name);
    match quantity {
        Quantity::Mass(place) => format!("m {}", mass(place)),
        Quantity::Stiffness(place) => match scene.springs.get(place) {
            Some(spring) => format!(
                "k {} - {}",
                scene.node_name(spring.from),
                scene.node_name(spring.to)
            ),
            None => "k ?".to_owned(),
        },
        Quantity::MassDamping => "a".to_owned(),
        Quantity::StiffnessDamping => "b".to_owned(),
        Quantity::DampingRatio(mode) => format!("zeta {}", mode + 1),
        Quantity::ContactStiffness => "stiffness".to_owned(),
        Quantity::Stiction => "mu".to_owned(),
        other => format!("{other:?}"),
    }
}

/// Returns all parameters of a response, each with its value at the operating point.
pub(super) fn parameters_of(
    scene: &Scene,
    point: OperatingPoint,
    system: &System,
) -> Vec<(Parameter, f64)> {
    let value = |quantity: Quantity| match (quantity, &scene.damping) {
        (Quantity::Mass(place), _) => scene.masses.get(place).map(|mass| mass.value),
        (Quantity::Stiffness(place), _) => scene.springs.get(place).map(|spring| spring.stiffness),
        (Quantity::MassDamping, Damping::Rayleigh { mass, .. }) => Some(*mass),
        (Quantity::StiffnessDamping, Damping::Rayleigh { stiffness, .. }) => Some(*stiffness),
        (Quantity::DampingRatio(mode), _) => {
            let ratios = &system.modal().damping_ratios;
            ratios.get(mode).map(|ratio| ratio.to_f64())
        }
        (Quantity::ContactStiffness, _) => scene.stiffness,
        (Quantity::Stiction, _) => Some(scene.stiction),
        _ => None,
    };
    let quantities = quantities(scene).into_iter();
    let mut all: Vec<(Parameter, f64)> = quantities
        .filter_map(|quantity| Some((Parameter::Quantity(quantity), value(quantity)?)))
        .collect();
    match point {
        OperatingPoint::Groups { r, beta } => {
            all.extend([(Parameter::Friction, beta), (Parameter::Frequency, r)]);
        }
        OperatingPoint::Physical {
            hertz,
            friction,
            load,
        } => {
            all.extend([
                (Parameter::Friction, friction),
                (Parameter::Load, load.amplitude()),
                (Parameter::Frequency, hertz),
            ]);
        }
    }
    all
}

/// Returns every quantity of a description for which derivatives exist: masses, springs, damping, the stiffness of the
/// contact and stiction.
pub(super) fn quantities(scene: &Scene) -> Vec<Quantity> {
    let masses = (0..scene.masses.len()).map(Quantity::Mass);
    let springs = (0..scene.springs.len()).map(Quantity::Stiffness);
    let mut all: Vec<Quantity> = masses.chain(springs).collect();
    match scene.damping {
        Damping::None => {}
        Damping::Uniform(_) | Damping::Modal(_) => {
            all.extend((0..scene.masses.len()).map(Quantity::DampingRatio));
        }
        Damping::Rayleigh { .. } => {
            all.extend([Quantity::MassDamping, Quantity::StiffnessDamping]);
        }
    }
    all.extend(scene.stiffness.map(|_| Quantity::ContactStiffness));
    all.push(Quantity::Stiction);
    all
}

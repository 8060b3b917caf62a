//! Parameters of a steady state with several contacts: the numbers of a scene description and of an operating point.

use crate::study::parameter::{Parameter, symbol};
use crate::study::sensitivity::{OperatingPoint, Quantity};
use frictiongen_model::scene::{Damping, Scene};

/// A number on which a steady state with several contacts depends. Every index counts from 0 in the order of the scene
/// description.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JoinedParameter {
    /// A mass, the stiffness of a spring, or a damping number of the scene description.
    Quantity(Quantity),
    /// The damping coefficient of a dashpot. The number is the index of the dashpot.
    Dashpot(usize),
    /// The share of a contact: its friction force divided by the common friction. The number is the index of the
    /// contact.
    Share(usize),
    /// The stiffness of an elastic contact. The number is the index of the contact.
    ContactStiffness(usize),
    /// Ratio μ of the static to the kinetic friction force of a contact. The number is the index of the contact.
    Stiction(usize),
    /// The velocity of the surface of a contact's second side. The number is the index of the contact.
    Speed(usize),
    /// The common friction of all contacts. It is the force F at a physical operating point, and β at a non-dimensional
    /// operating point.
    Friction,
    /// The amplitude of the load, at a physical operating point.
    Load,
    /// The frequency. It is in Hz at a physical operating point, and is the ratio r at a non-dimensional operating
    /// point.
    Frequency,
}

/// A scene and its operating point. The search for derivatives changes their numbers one at a time.
#[derive(Clone, Debug)]
pub(super) struct JoinedPoint {
    pub(super) scene: Scene,
    pub(super) point: OperatingPoint,
}

impl JoinedPoint {
    /// Combines a scene with an operating point. Each mode gets its own damping ratio, so that each ratio can vary
    /// alone.
    pub(super) fn new(scene: &Scene, point: OperatingPoint) -> Self {
        let mut scene = scene.clone();
        if let Damping::Uniform(ratio) = scene.damping {
            scene.damping = Damping::Modal(vec![ratio; scene.masses.len()]);
        }
        Self { scene, point }
    }

    /// Returns every parameter with respect to which derivatives exist.
    pub(super) fn parameters(&self) -> Vec<JoinedParameter> {
        let mut all = JoinedParameter::of_scene(&self.scene);
        let point = [
            JoinedParameter::Friction,
            JoinedParameter::Load,
            JoinedParameter::Frequency,
        ];
        all.extend(point.into_iter().filter(|of| self.value(*of).is_some()));
        all
    }

    /// Returns the parameter with this name: its symbol, also with dots, such as `m.upper` and `k.base-lower`. The names
    /// `hz`, `friction` and `load` work too, and `mu`, `stiffness`, `share` and `speed` alone if there is one contact.
    pub(super) fn named(&self, name: &str) -> Option<JoinedParameter> {
        let plain = |text: &str| text.replace(" - ", "-").replace('.', " ");
        let wanted = plain(name);
        let is_single = self.scene.named_contacts().len() == 1;
        self.parameters().into_iter().find(|parameter| {
            let symbol = plain(&parameter.symbol(&self.scene, &self.point));
            let short = symbol.split(' ').next().unwrap_or_default();
            let other = match parameter {
                JoinedParameter::Friction => "friction",
                JoinedParameter::Load => "load",
                JoinedParameter::Frequency if symbol != "r" => "hz",
                parameter if is_single && parameter.is_of_contact() => short,
                _ => "",
            };
            wanted == symbol || (wanted == other && !wanted.is_empty())
        })
    }

    /// Returns this operating point with another value of a parameter.
    pub(super) fn with(&self, parameter: JoinedParameter, value: f64) -> Self {
        let mut changed = self.clone();
        if let Some(number) = changed.number(parameter) {
            *number = value;
        }
        changed
    }

    /// Returns the value of a parameter at this operating point, or `None` if the scene does not have the parameter.
    pub(super) fn value(&self, parameter: JoinedParameter) -> Option<f64> {
        self.clone().number(parameter).copied()
    }

    /// Returns a reference to the number of a parameter, so that the caller can change the number. Returns `None` if
    /// the operating point does not have the parameter.
    pub(super) fn number(&mut self, parameter: JoinedParameter) -> Option<&mut f64> {
        let Self { scene, point } = self;
        match (parameter, point) {
            (JoinedParameter::Friction, OperatingPoint::Groups { beta, .. }) => Some(beta),
            (JoinedParameter::Friction, OperatingPoint::Physical { friction, .. }) => {
                Some(friction)
            }
            (JoinedParameter::Load, OperatingPoint::Groups { .. }) => None,
            (JoinedParameter::Load, OperatingPoint::Physical { load, .. }) => {
                Some(load.amplitude_mut())
            }
            (JoinedParameter::Frequency, OperatingPoint::Groups { r, .. }) => Some(r),
            (JoinedParameter::Frequency, OperatingPoint::Physical { hertz, .. }) => Some(hertz),
            (of_scene, _) => of_scene.number(scene),
        }
    }
}

impl JoinedParameter {
    /// Returns every number of a scene with respect to which derivatives exist.
    pub(in crate::study) fn of_scene(scene: &Scene) -> Vec<Self> {
        let masses = (0..scene.masses.len()).map(Quantity::Mass);
        let springs = (0..scene.springs.len()).map(Quantity::Stiffness);
        let ratios = (0..scene.masses.len()).map(Quantity::DampingRatio);
        let quantities = masses.chain(springs).chain(ratios);
        let quantities = quantities.chain([Quantity::MassDamping, Quantity::StiffnessDamping]);
        let dashpots = (0..scene.joints.dampers.len()).map(Self::Dashpot);
        let contacts = (0..scene.named_contacts().len()).flat_map(|contact| {
            [
                Self::Share(contact),
                Self::ContactStiffness(contact),
                Self::Stiction(contact),
                Self::Speed(contact),
            ]
        });
        let all = quantities.map(Self::Quantity).chain(dashpots);
        let mut scene = scene.clone();
        all.chain(contacts)
            .filter(|of| of.number(&mut scene).is_some())
            .collect()
    }

    /// Returns a reference to this number of a scene. Returns `None` if the scene does not have the number.
    pub(in crate::study) fn number(self, scene: &mut Scene) -> Option<&mut f64> {
        let contacts = &mut scene.joints.contacts;
        let is_single = contacts.is_empty();
        match self {
            Self::Quantity(quantity) => match (quantity, &mut scene.damping) {
                (Quantity::Mass(index), _) => Some(&mut scene.masses.get_mut(index)?.value),
                (Quantity::Stiffness(index), _) => {
                    Some(&mut scene.springs.get_mut(index)?.stiffness)
                }
                (Quantity::DampingRatio(index), Damping::Modal(ratios)) => ratios.get_mut(index),
                (Quantity::MassDamping, Damping::Rayleigh { mass, .. }) => Some(mass),
                (Quantity::StiffnessDamping, Damping::Rayleigh { stiffness, .. }) => {
                    Some(stiffness)
                }
                _ => None,
            },
            Self::Dashpot(index) => Some(&mut scene.joints.dampers.get_mut(index)?.coefficient),
            Self::Share(index) => Some(&mut contacts.get_mut(index)?.law.share),
            Self::ContactStiffness(_) if is_single => scene.stiffness.as_mut(),
            Self::ContactStiffness(index) => contacts.get_mut(index)?.law.stiffness.as_mut(),
            Self::Stiction(_) if is_single => Some(&mut scene.stiction),
            Self::Stiction(index) => Some(&mut contacts.get_mut(index)?.law.stiction),
            Self::Speed(index) => {
                let speed = &mut contacts.get_mut(index)?.law.speed;
                (*speed != 0.0).then_some(speed)
            }
            Self::Friction | Self::Load | Self::Frequency => None,
        }
    }

    /// Returns true for a number of one contact.
    fn is_of_contact(self) -> bool {
        matches!(
            self,
            Self::Share(_) | Self::ContactStiffness(_) | Self::Stiction(_) | Self::Speed(_)
        )
    }

    /// Returns the corresponding parameter of a scene with a single contact, if there is one.
    fn single(self) -> Option<Parameter> {
        match self {
            Self::Quantity(quantity) => Some(Parameter::Quantity(quantity)),
            Self::Friction => Some(Parameter::Friction),
            Self::Load => Some(Parameter::Load),
            Self::Frequency => Some(Parameter::Frequency),
            _ => None,
        }
    }

    /// Returns the symbol of the parameter. The symbol of a number of a mass, spring, dashpot or contact contains the
    /// names from the description. Examples are `m upper`, `share brace` and `F`.
    #[must_use]
    pub fn symbol(self, scene: &Scene, point: &OperatingPoint) -> String {
        let contact = |short: &str, index: usize| {
            let contacts = scene.named_contacts();
            let name = contacts.get(index).map_or("", |contact| &contact.name);
            format!("{short} {name}")
        };
        match (self, self.single()) {
            (Self::Quantity(quantity), _) => symbol(quantity, scene),
            (_, Some(single)) => single.symbol(scene, point),
            (Self::Dashpot(index), _) => {
                let damper = scene.joints.dampers.get(index);
                let ends = damper.map(|damper| {
                    let (from, to) = (scene.node_name(damper.from), scene.node_name(damper.to));
                    format!("c {from} - {to}")
                });
                ends.unwrap_or_default()
            }
            (Self::Share(index), _) => contact("share", index),
            (Self::ContactStiffness(index), _) => contact("stiffness", index),
            (Self::Stiction(index), _) => contact("mu", index),
            (Self::Speed(index), _) => contact("speed", index),
            (Self::Friction | Self::Load | Self::Frequency, None) => String::new(),
        }
    }

    /// Returns the SI unit of the parameter. The text is empty if the parameter is a ratio.
    #[must_use]
    pub fn unit(self, point: &OperatingPoint) -> &'static str {
        match (self, self.single()) {
            (_, Some(single)) => single.unit(point),
            (Self::Dashpot(_), _) => "N s/m",
            (Self::ContactStiffness(_), _) => "N/m",
            (Self::Speed(_), _) => "m/s",
            _ => "",
        }
    }
}

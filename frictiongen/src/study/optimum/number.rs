//! The numbers of a scene description that a search for the best friction can vary together with the friction.

use crate::study::error::InvalidScene;
use crate::study::joined::JoinedParameter;
use crate::study::parameter::{OperatingPoint, Parameter, quantities, symbol};
use crate::study::system::System;
use frictiongen_model::scene::{Damping, Node, Scene};
use frictiongen_model::sensitivity::Quantity;

/// Operating point from which the numbers of a contact or a dashpot take their names and units.
const POINT: OperatingPoint = OperatingPoint::Groups { r: 1.0, beta: 1.0 };

/// A number of a scene description that a search for the best friction can vary together with the friction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tunable {
    /// A mass, the stiffness of a spring or of the contact, μ, the damping ratio of one mode, or a factor of C = aM +
    /// bK.
    Quantity(Quantity),
    /// The number is the common damping ratio of all modes.
    DampingRatios,
    /// A number of a dashpot, or of one of several contacts: a coefficient, a share, a stiffness, μ or a speed.
    Joined(JoinedParameter),
}

/// Error for a name that denotes no number of the scene description that can vary.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownTunable {
    /// The requested name.
    pub name: String,
    /// The names of all numbers that can vary.
    pub known: Vec<String>,
}

impl std::fmt::Display for UnknownTunable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "there is no number `{}` in the description; the numbers are {}",
            self.name,
            self.known.join(", ")
        )
    }
}

impl std::error::Error for UnknownTunable {}

impl Tunable {
    /// Returns the symbol of the number, for example `m upper`, `k base - lower`, `zeta 1`, `a`, `mu` or `share pads`.
    /// Lists of derivatives use the same symbols. The symbol of the damping ratio that all modes have in common is
    /// `zeta`.
    #[must_use]
    pub fn symbol(&self, scene: &Scene) -> String {
        match self {
            Self::Quantity(quantity) => symbol(*quantity, scene),
            Self::DampingRatios => "zeta".to_owned(),
            Self::Joined(parameter) => parameter.symbol(scene, &POINT),
        }
    }

    /// Returns the SI unit of the number. The text is empty for a ratio.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Quantity(quantity) => Parameter::Quantity(*quantity).unit(&POINT),
            Self::DampingRatios => "",
            Self::Joined(parameter) => parameter.unit(&POINT),
        }
    }

    /// Returns the index of the contact whose share of the common friction this number is.
    pub(in crate::study) fn share(&self) -> Option<usize> {
        match self {
            Self::Joined(JoinedParameter::Share(contact)) => Some(*contact),
            _ => None,
        }
    }

    /// Returns all quantities of the scene description that change together with this number.
    #[cfg(feature = "measure")]
    pub(crate) fn quantities(self, scene: &Scene) -> Vec<Quantity> {
        match self {
            Self::Quantity(quantity) => vec![quantity],
            Self::DampingRatios => (0..scene.masses.len())
                .map(Quantity::DampingRatio)
                .collect(),
            Self::Joined(_) => Vec::new(),
        }
    }

    /// Returns the scene with another value of this number. Returns `None` if the scene description does not have this
    /// number.
    fn applied(self, scene: &Scene, value: f64) -> Option<Scene> {
        let mut scene = scene.clone();
        match self {
            Self::Quantity(Quantity::ContactStiffness) => *scene.stiffness.as_mut()? = value,
            Self::Quantity(Quantity::Stiction) => scene.stiction = value,
            Self::Quantity(Quantity::MassDamping | Quantity::StiffnessDamping) => {
                let [mass, stiffness] = factors(&scene)?;
                scene.damping = match self {
                    Self::Quantity(Quantity::MassDamping) => Damping::Rayleigh {
                        mass: value,
                        stiffness,
                    },
                    _ => Damping::Rayleigh {
                        mass,
                        stiffness: value,
                    },
                };
            }
            Self::Quantity(Quantity::DampingRatio(mode)) => {
                let mut all = ratios(&scene)?;
                *all.get_mut(mode)? = value;
                scene.damping = Damping::Modal(all);
            }
            Self::DampingRatios => {
                ratios(&scene)?;
                scene.damping = Damping::Uniform(value);
            }
            Self::Quantity(quantity) => {
                *JoinedParameter::Quantity(quantity).number(&mut scene)? = value;
            }
            Self::Joined(parameter) => *parameter.number(&mut scene)? = value,
        }
        Some(scene)
    }
}

/// Returns the factors a and b of the damping C = aM + bK. Returns `None` for a scene with damping ratios.
fn factors(scene: &Scene) -> Option<[f64; 2]> {
    match scene.damping {
        Damping::None => Some([0.0; 2]),
        Damping::Rayleigh { mass, stiffness } => Some([mass, stiffness]),
        _ => None,
    }
}

/// Returns the damping ratio of each mode. Returns `None` for a scene with the damping C = aM + bK.
fn ratios(scene: &Scene) -> Option<Vec<f64>> {
    let masses = scene.masses.len();
    match &scene.damping {
        Damping::None => Some(vec![0.0; masses]),
        Damping::Uniform(ratio) => Some(vec![*ratio; masses]),
        Damping::Modal(ratios) => Some(ratios.clone()),
        Damping::Rayleigh { .. } => None,
    }
}

impl System {
    /// Returns all numbers of the scene description that a search can vary: masses, springs, dashpots, the numbers of
    /// the contacts, and damping. If the description has no damping, the numbers include damping ratios and the factors
    /// of C = aM + bK. Otherwise the numbers include only those of the damping in the description.
    #[must_use]
    pub fn tunables(&self) -> Vec<Tunable> {
        let scene = self.scene();
        let tunable = |of: JoinedParameter| match of {
            JoinedParameter::Quantity(quantity) => Tunable::Quantity(quantity),
            other => Tunable::Joined(other),
        };
        let mut all: Vec<Tunable> = match scene.is_joined() {
            true => JoinedParameter::of_scene(scene)
                .into_iter()
                .map(tunable)
                .collect(),
            false => quantities(scene)
                .into_iter()
                .map(Tunable::Quantity)
                .collect(),
        };
        all.retain(|of| !matches!(of, Tunable::Quantity(Quantity::DampingRatio(_))));
        if ratios(scene).is_some() {
            let modes = (0..scene.masses.len()).map(Quantity::DampingRatio);
            all.push(Tunable::DampingRatios);
            all.extend(modes.map(Tunable::Quantity));
        }
        if scene.damping == Damping::None {
            let factors = [Quantity::MassDamping, Quantity::StiffnessDamping];
            all.extend(factors.map(Tunable::Quantity));
        }
        all
    }

    /// Returns the number with the symbol `name`. Symbols are `m upper`, `k base - lower`, `zeta` for all modes, `zeta
    /// 1`, `a`, `b`, `stiffness` for an elastic contact, and `mu`. With several contacts or dashpots they are also `c
    /// base - lower`, `share pads`, `stiffness pads` and `mu pads`; a single contact needs no name. The two nodes of a
    /// spring or a dashpot may be in either order. `k2` means the second spring of the scene description, and `m1` its first mass.
    ///
    /// # Errors
    /// [`UnknownTunable`] if no number has this symbol.
    pub fn tunable_named(&self, name: &str) -> Result<Tunable, UnknownTunable> {
        let scene = self.scene();
        let all = self.tunables();
        let asked = spaced(name);
        let is_single = scene.joints.contacts.len() < 2;
        let of_this_name = |tunable: &&Tunable| {
            let reversed = |short: &str, [from, to]: [Node; 2]| {
                format!(
                    "{short} {} - {}",
                    scene.node_name(to),
                    scene.node_name(from)
                )
            };
            let other = match tunable {
                Tunable::Quantity(Quantity::Stiffness(index)) => {
                    let spring = scene.springs.get(*index);
                    spring.map(|spring| reversed("k", [spring.from, spring.to]))
                }
                Tunable::Joined(JoinedParameter::Dashpot(index)) => {
                    let damper = scene.joints.dampers.get(*index);
                    damper.map(|damper| reversed("c", [damper.from, damper.to]))
                }
                Tunable::Joined(parameter) if is_single => {
                    let symbol = parameter.symbol(scene, &POINT);
                    symbol.split(' ').next().map(str::to_owned)
                }
                _ => None,
            };
            let by_index = match tunable {
                Tunable::Quantity(Quantity::Mass(index)) => Some(format!("m{}", index + 1)),
                Tunable::Quantity(Quantity::Stiffness(index)) => Some(format!("k{}", index + 1)),
                Tunable::Quantity(Quantity::DampingRatio(mode)) => {
                    Some(format!("zeta{}", mode + 1))
                }
                _ => None,
            };
            tunable.symbol(scene) == asked || [other, by_index].contains(&Some(asked.clone()))
        };
        let found = all.iter().find(of_this_name).copied();
        found.ok_or_else(|| UnknownTunable {
            name: name.to_owned(),
            known: all.iter().map(|tunable| tunable.symbol(scene)).collect(),
        })
    }

    /// Returns the numbers that a name denotes. `share` alone denotes the shares of all contacts but the first, because
    /// a common factor on all shares has the effect of the common friction. Any other name denotes the number of
    /// [`tunable_named`](Self::tunable_named).
    ///
    /// # Errors
    /// Same error as [`tunable_named`](Self::tunable_named).
    #[doc(hidden)]
    pub fn tunables_named(&self, name: &str) -> Result<Vec<Tunable>, UnknownTunable> {
        let contacts = self.scene().joints.contacts.len();
        if spaced(name) == "share" && 1 < contacts {
            let shares = (1..contacts).map(JoinedParameter::Share);
            return Ok(shares.map(Tunable::Joined).collect());
        }
        Ok(vec![self.tunable_named(name)?])
    }

    /// Returns this scene with another value of one number. Damping ratios belong to the modes in ascending order
    /// of natural frequency, in the original scene and in the changed one.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: frictiongen::System = "struct Block {
    ///     masses: { block: 2.0 },
    ///     springs: { base - block: 50.0 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let softer = block.with_value(block.tunable_named("k base - block")?, 20.0)?;
    /// assert_eq!(softer.scene().springs[0].stiffness, 20.0);
    /// assert!(block.with_value(block.tunable_named("k1")?, -20.0).is_err());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`InvalidScene`] if the value makes no physical sense, and for a number that the scene description does not
    /// have.
    pub fn with_value(&self, tunable: Tunable, value: f64) -> Result<Self, InvalidScene> {
        let scene = self.scene();
        let varied = tunable.applied(scene, value).ok_or_else(|| InvalidScene {
            unknown: vec![format!(
                "the description does not contain the number `{}`",
                tunable.symbol(scene)
            )],
            errors: Vec::new(),
        })?;
        Self::try_from(varied)
    }
}

/// Returns a name with one space between words and one space on either side of a hyphen.
fn spaced(name: &str) -> String {
    let name = name.replace('-', " - ");
    name.split_whitespace().collect::<Vec<_>>().join(" ")
}

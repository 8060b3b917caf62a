//! Types of a scene, with the values of its description and in the units of the description.

mod joints;

pub use joints::{
    CONTACT, ConstantForce, Damper, Impact, JointLaw, Joints, NamedContact, NamedStop, StopLaw,
};

/// One end of a spring, or one side of a contact: a mass, the base or the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Node {
    /// A mass, given by its zero-based index in [`Scene::masses`].
    Mass(usize),
    /// The base, a support that moves if the excitation is a base motion.
    Base,
    /// The wall, a support that never moves.
    Wall,
}

/// A point mass of the chain, with its name and value.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mass {
    /// The name of the mass, a Rust identifier.
    pub name: String,
    /// The value of the mass, in the scene's own units (kg in SI). The first mass is m₁, the reference of all mass
    /// ratios.
    pub value: f64,
}

/// A linear spring between two nodes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring {
    /// The end of the spring that the description writes first.
    pub from: Node,
    /// The end of the spring that the description writes second.
    pub to: Node,
    /// The stiffness of the spring, in the scene's own units (N/m in SI). The first spring is k₁, the reference of all
    /// stiffness ratios.
    pub stiffness: f64,
}

/// The two sides of the single Coulomb contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactSides {
    /// The side of the contact that the description writes first.
    pub from: Node,
    /// The side of the contact that the description writes second.
    pub to: Node,
}

impl ContactSides {
    /// Returns true if the description writes the later one of two masses first.
    #[must_use]
    pub fn is_reversed(&self) -> bool {
        matches!((self.from, self.to), (Node::Mass(from), Node::Mass(to)) if from > to)
    }
}

/// The harmonic excitation: a force on a mass, or a motion of the base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Excitation {
    /// A force P cos ωt on the mass with this index.
    Force(usize),
    /// A motion Y cos ωt of the base, with the amplitude Y.
    Base,
}

/// The viscous damping of a scene, in addition to the friction.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Damping {
    /// No viscous damping.
    #[default]
    None,
    /// One modal damping ratio ζ for all modes.
    Uniform(f64),
    /// One modal damping ratio ζ for each mode, in ascending order of natural frequency.
    Modal(Vec<f64>),
    /// Rayleigh damping C = aM + bK, with a and b in the scene's own units.
    Rayleigh {
        /// The factor a of the mass matrix M.
        mass: f64,
        /// The factor b of the stiffness matrix K.
        stiffness: f64,
    },
}

/// Velocities on which modal and Rayleigh damping act if the base moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum DampingFrom {
    /// Absolute velocities, as in the thesis. The motion of the base then causes no damping load.
    #[default]
    Rest,
    /// Velocities relative to the moving base, as is usual for structures.
    Base,
}

/// The floating-point type that the emitted code computes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Precision {
    /// `f64`, double precision.
    #[default]
    F64,
    /// `f32`. The emitted code contains no `f64` operation.
    F32,
}

/// A group of methods that the generator emits for a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Provide {
    /// The limits β_lim and β*_lim and the regime at any frequency ratio.
    Limits,
    /// The exact continuous motion of the contact and of masses. `None` selects every mass, a list selects the masses
    /// with these indices.
    Motion(Option<Vec<usize>>),
    /// The responses of all masses while the contact is stuck.
    Stuck,
    /// The steady state in any regime: continuous, stick-slip or stuck.
    Orbit,
    /// The exact motion in time, from a given state.
    Simulation,
    /// The stepper, which advances the motion by a fixed step in physical time, under any force.
    Stepper,
    /// The self-check. It compares checksums of the constants, and results of the other groups of methods, with known
    /// values.
    SelfCheck,
}

/// The accuracy that the description demands of the emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Accuracy {
    /// The limits, motions and responses come from exact formulas, without tables.
    #[default]
    Exact,
    /// Tables whose relative error is at most this number in the scene's `range`.
    Relative(f64),
}

/// Side of the exact limits on which the limits from tables may lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// The limits from tables may lie on either side of the exact limits.
    #[default]
    Near,
    /// The limits from tables have errors only to the safe side. β_lim is never above its exact value, and β*_lim is
    /// never below its exact value.
    Safe,
}

/// Behaviour of the emitted code outside the range of a declared accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Beyond {
    /// The emitted code returns an error outside the range.
    #[default]
    Error,
    /// The emitted code uses the exact formulas outside the range.
    Exact,
}

/// Time that the macro may spend on a proof that the tables have the declared accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Proving {
    /// About a second. Tables whose proof needs longer are checked but not proven.
    #[default]
    Quick,
    /// The time of a whole proof, as on the command line: a few seconds in code without optimisation.
    Whole,
}

/// The range of r and β in which a declared accuracy is valid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Range {
    /// Smallest and largest frequency ratio r of the range.
    pub r: (f64, f64),
    /// Smallest and largest friction ratio β of the range.
    pub beta: (f64, f64),
}

/// The accuracy that the description declares for the emitted code, and the range of r and β in which the emitted code
/// has this accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct Declared {
    /// The accuracy of the emitted limits, motions and responses.
    pub accuracy: Accuracy,
    /// The range of r and β in which the accuracy is valid. `None` if the scene uses the exact formulas.
    pub range: Option<Range>,
    /// The side of the exact limits on which limits from tables may lie.
    pub side: Side,
    /// Largest size of the tables in bytes, which a scene may declare in place of an accuracy. The generator then
    /// chooses the best accuracy that fits.
    pub budget: Option<f64>,
    /// Behaviour of the emitted code outside the range.
    pub beyond: Beyond,
    /// Time that the macro may spend on a proof that the tables have the declared accuracy.
    #[cfg_attr(feature = "serde", serde(default))]
    pub proof: Proving,
}

impl Declared {
    /// Returns true if the scene declares an accuracy or a size for tables. The tables then replace the exact formulas.
    #[must_use]
    pub fn is_tabled(&self) -> bool {
        self.accuracy != Accuracy::Exact || self.budget.is_some()
    }
}

/// Dependence of the kinetic friction force on the sliding speed.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FrictionLaw {
    /// Coulomb's law: a static friction force, and a kinetic friction force that does not depend on the speed.
    #[default]
    Coulomb,
    /// Kinetic friction that is piecewise linear in the sliding speed. Each point has a speed, in the scene's own
    /// units, and a level, which is the friction force divided by F. The level at rest is 1. Beyond the last point the
    /// level is constant.
    Stribeck(Vec<[f64; 2]>),
}

impl FrictionLaw {
    /// Returns the points (speed, level) of the friction law. The level is the kinetic friction force divided by F. The
    /// list is empty for Coulomb's law.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        match self {
            Self::Coulomb => &[],
            Self::Stribeck(points) => points,
        }
    }
}

/// Course of the stepper's input between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum StepInput {
    /// The input keeps the value of the sample during the whole step.
    Hold,
    /// The input changes linearly during the step, and reaches the sample at the end of the step.
    #[default]
    Linear,
}

/// Settings of the stepper: the step, the input and the loads.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StepperOptions {
    /// The fixed step in the scene's unit of time (s in SI), or `None` if the step is known only at run time. If the
    /// step is known, the tables for it are constants of the emitted code.
    pub step: Option<f64>,
    /// Course of the stepper's input between two samples.
    pub input: StepInput,
    /// Indices of masses on which a force may act in addition to the excitation.
    pub forces: Vec<usize>,
}

/// A whole scene: chain, contact, excitation, damping, and the groups of methods that the generator emits.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scene {
    /// The name of the emitted type.
    pub name: String,
    /// The masses of the chain. The first mass is m₁, the reference of all mass ratios.
    pub masses: Vec<Mass>,
    /// The springs of the chain. The first spring is k₁, the reference of all stiffness ratios.
    pub springs: Vec<Spring>,
    /// The single Coulomb contact of the scene. In a scene with several contacts, this field has the two sides of the
    /// first contact.
    pub contact: ContactSides,
    /// The name of the single contact. It is `contact`, unless the description has one contact with another name in the
    /// field `contacts`.
    #[cfg_attr(feature = "serde", serde(default = "joints::contact_name"))]
    pub contact_name: String,
    /// The harmonic excitation of the scene.
    pub excitation: Excitation,
    /// The viscous damping of the scene.
    pub damping: Damping,
    /// The velocities on which the damping acts if the base moves.
    #[cfg_attr(feature = "serde", serde(default))]
    pub damping_from: DampingFrom,
    /// μ, the ratio of static to kinetic friction force, at least 1.
    pub stiction: f64,
    /// Stiffness of an elastic contact (Jenkins element), a spring in series with the slider, in the scene's own units
    /// (N/m in SI). `None` for a rigid contact.
    #[cfg_attr(feature = "serde", serde(default))]
    pub stiffness: Option<f64>,
    /// The floating-point type that the emitted code computes with.
    pub precision: Precision,
    /// The groups of methods that the generator emits.
    pub provide: Vec<Provide>,
    /// The declared accuracy, with the range in which it is valid.
    pub declared: Declared,
    /// Dependence of the kinetic friction force on the sliding speed.
    #[cfg_attr(feature = "serde", serde(default))]
    pub friction: FrictionLaw,
    /// The settings of the stepper.
    #[cfg_attr(feature = "serde", serde(default))]
    pub stepping: StepperOptions,
    /// Several contacts, the dashpots, the stops and the constant forces.
    #[cfg_attr(feature = "serde", serde(default))]
    #[doc(hidden)]
    pub joints: Joints,
}

impl Scene {
    /// Returns true if the generator emits this group of methods for the scene. Two `Motion` groups count as equal,
    /// even if they name different masses.
    #[must_use]
    pub fn provides(&self, item: &Provide) -> bool {
        let kind = core::mem::discriminant(item);
        let mut items = self.provide.iter();
        items.any(|item| core::mem::discriminant(item) == kind)
    }

    /// Returns the groups of methods of a scene without the field `provide`: limits and motion if the scene has closed
    /// forms, motions in time if it has stops, moving surfaces or constant forces, and otherwise steady states.
    #[must_use]
    pub fn default_provide(&self) -> Vec<Provide> {
        let rigid = self.stiffness.is_none() && self.joints.is_empty();
        if rigid && self.friction == FrictionLaw::Coulomb {
            vec![Provide::Limits, Provide::Motion(None)]
        } else if !self.has_linear_states() {
            vec![Provide::Simulation]
        } else {
            vec![Provide::Orbit]
        }
    }

    /// Returns true if the emitted code has a method that depends on the frequency of excitation. The stepper does not
    /// depend on this frequency. If the kinetic friction depends on the speed, the simulation does not depend on this
    /// frequency either.
    #[must_use]
    pub fn needs_frequency(&self) -> bool {
        let constant = self.friction == FrictionLaw::Coulomb;
        let mut items = self.provide.iter();
        items.any(|item| match item {
            Provide::Stepper | Provide::SelfCheck => false,
            Provide::Simulation => constant,
            _ => true,
        })
    }

    /// Returns true if the base moves and damping acts on velocities relative to the base.
    #[must_use]
    pub fn is_damped_from_base(&self) -> bool {
        self.damping_from == DampingFrom::Base
            && self.excitation == Excitation::Base
            && self.damping != Damping::None
    }

    /// Returns the velocities on which the damping acts, for a report. Returns `None` if the base does not move or the
    /// scene has no damping, because the choice then has no effect.
    #[must_use]
    pub fn damping_acts_on(&self) -> Option<&'static str> {
        let differs = self.excitation == Excitation::Base && self.damping != Damping::None;
        differs.then_some(match self.damping_from {
            DampingFrom::Rest => {
                "damping acts on absolute velocities (damping_from: rest, the default)"
            }
            DampingFrom::Base => {
                "damping acts on velocities relative to the base (damping_from: base)"
            }
        })
    }

    /// Returns true if the emitted code has a method that computes a motion in time.
    #[must_use]
    pub fn moves_in_time(&self) -> bool {
        let in_time = [Provide::Simulation, Provide::Orbit, Provide::Stepper];
        self.provide.iter().any(|item| in_time.contains(item))
    }

    /// Returns k₁, the stiffness of the first spring, to which all stiffness ratios refer. Without a spring the result
    /// is 1.
    #[must_use]
    pub fn first_stiffness(&self) -> f64 {
        self.springs.first().map_or(1.0, |spring| spring.stiffness)
    }

    /// Returns the name of a node in the description. Returns `?` for a mass that does not exist.
    #[must_use]
    pub fn node_name(&self, node: Node) -> &str {
        match node {
            Node::Mass(index) => self
                .masses
                .get(index)
                .map_or("?", |mass| mass.name.as_str()),
            Node::Base => "base",
            Node::Wall => "wall",
        }
    }
}

impl Scene {
    /// Returns true if masses beyond the contact can act as an absorber. The load reaches these masses only through a
    /// mass of the contact. While the contact is stuck, these masses can resonate on their own.
    #[must_use]
    pub fn has_absorber(&self) -> bool {
        let sides = [self.contact.from, self.contact.to];
        let held = |node: Node| !matches!(node, Node::Mass(_)) || sides.contains(&node);
        let loaded = |mass: usize| match self.excitation {
            Excitation::Force(at) => at == mass,
            Excitation::Base => self.springs.iter().any(|spring| {
                let ends = [spring.from, spring.to];
                ends.contains(&Node::Base) && ends.contains(&Node::Mass(mass))
            }),
        };
        // Marks the masses that the load reaches by a path that avoids the masses of the contact.
        let mut reached: Vec<bool> = (0..self.masses.len())
            .map(|mass| !held(Node::Mass(mass)) && loaded(mass))
            .collect();
        for _ in 0..self.masses.len() {
            for spring in &self.springs {
                if let (Node::Mass(a), Node::Mass(b)) = (spring.from, spring.to)
                    && !held(spring.from)
                    && !held(spring.to)
                    && let (Some(&at_a), Some(&at_b)) = (reached.get(a), reached.get(b))
                    && at_a != at_b
                {
                    for end in [a, b] {
                        if let Some(reached) = reached.get_mut(end) {
                            *reached = true;
                        }
                    }
                }
            }
        }
        let mut masses = reached.iter().enumerate();
        masses.any(|(mass, reached)| !held(Node::Mass(mass)) && !reached)
    }
}

//! A scene as described, in its own units, before any computation.

/// An end of a spring, or a side of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Node {
    /// A mass, by its zero-based index in [`Scene::masses`].
    Mass(usize),
    /// The support that moves if the excitation is a base motion.
    Base,
    /// A support that never moves.
    Wall,
}

/// A point mass.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mass {
    /// The name of the mass, a Rust identifier.
    pub name: String,
    /// The value of the mass, in the scene's own units (kg in SI). The first mass is the reference m₁.
    pub value: f64,
}

/// A linear spring between two nodes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring {
    /// The node of the spring that is written first.
    pub from: Node,
    /// The node of the spring that is written second.
    pub to: Node,
    /// The stiffness of the spring, in the scene's own units (N/m in SI). The first spring is the reference k₁.
    pub stiffness: f64,
}

/// The single Coulomb contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Contact {
    /// The side of the contact that is written first.
    pub from: Node,
    /// The side of the contact that is written second.
    pub to: Node,
}

/// The harmonic excitation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Excitation {
    /// A force P cos ωt on a mass.
    Force(usize),
    /// A motion Y cos ωt of the base.
    Base,
}

/// The viscous damping of a scene.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Damping {
    /// No damping.
    #[default]
    None,
    /// One modal damping ratio for all modes.
    Uniform(f64),
    /// A modal damping ratio for each mode, in ascending order of natural frequency.
    Modal(Vec<f64>),
    /// Rayleigh damping C = aM + bK, in the scene's own units.
    Rayleigh {
        /// The factor a of the mass matrix.
        mass: f64,
        /// The factor b of the stiffness matrix.
        stiffness: f64,
    },
}

/// The floating-point type of the emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Precision {
    /// `f64`, double precision.
    #[default]
    F64,
    /// `f32`, without any `f64` operation.
    F32,
}

/// An item to emit.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Provide {
    /// Both limits and the regime at a frequency ratio.
    Limits,
    /// The continuous motion of the contact, and of every mass (`None`) or of the named masses.
    Motion(Option<Vec<usize>>),
    /// The response while the contact is stuck.
    Stuck,
    /// The steady state in any regime.
    Orbit,
    /// The exact motion in time.
    Simulation,
    /// The stepper: a fixed step in physical time, under any force.
    Stepper,
}

/// The accuracy of the emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Accuracy {
    /// Exact formulas, without tables.
    #[default]
    Exact,
    /// The largest relative error, over the scene's `range`.
    Relative(f64),
}

/// The side of the exact limits on which approximate limits may lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// Either side of the exact limits.
    #[default]
    Near,
    /// β_lim is never above the exact one, and β*_lim is never below the exact one.
    Safe,
}

/// The behaviour outside the range of a declared accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Beyond {
    /// The emitted code returns an error.
    #[default]
    Error,
    /// The exact formulas are used.
    Exact,
}

/// Time that the macro may spend on a proof of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Proving {
    /// About a second. Tables that need longer are checked but not proven.
    #[default]
    Quick,
    /// The time that the command line takes for a proof: some seconds in code without optimisation.
    Whole,
}

/// The range of r and β for a declared accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Range {
    /// Smallest and largest frequency ratio r.
    pub r: (f64, f64),
    /// Smallest and largest friction ratio β.
    pub beta: (f64, f64),
}

/// The declared accuracy of the emitted code, and its range.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Declared {
    /// The accuracy of the emitted limits, motions and responses.
    pub accuracy: Accuracy,
    /// The range of r and β for the accuracy; `None` if the scene is exact.
    pub range: Option<Range>,
    /// The side of the exact limits on which the emitted limits may lie.
    pub side: Side,
    /// Number of bytes for the tables, in place of an accuracy. The best accuracy that fits is chosen.
    pub budget: Option<f64>,
    /// The behaviour outside the range.
    pub beyond: Beyond,
    /// Time that the macro may spend on a proof.
    #[cfg_attr(feature = "serde", serde(default))]
    pub proof: Proving,
}

impl Declared {
    /// Returns whether the scene declares tables.
    #[must_use]
    pub fn is_tabled(&self) -> bool {
        self.accuracy != Accuracy::Exact || self.budget.is_some()
    }
}

/// Dependence of the kinetic friction force on the sliding speed.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FrictionLaw {
    /// Coulomb's law: a static level, and a kinetic level that does not depend on the speed.
    #[default]
    Coulomb,
    /// Piecewise linear kinetic level. Each point has a speed, in the scene's own units, and a level over F. The level
    /// is 1 at rest, and constant beyond the last point.
    Stribeck(Vec<[f64; 2]>),
}

impl FrictionLaw {
    /// Returns the points (speed, level). Coulomb's law has none.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        match self {
            Self::Coulomb => &[],
            Self::Stribeck(points) => points,
        }
    }
}

/// The stepper's input between samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum StepInput {
    /// The input keeps the value of the sample over the step.
    Hold,
    /// The input changes linearly, and reaches the sample at the end of the step.
    #[default]
    Linear,
}

/// The stepper settings of a scene.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stepping {
    /// The step, if it is known, in the scene's unit of time (s in SI). Its tables are then constants.
    pub step: Option<f64>,
    /// The behaviour of the input between samples.
    pub input: StepInput,
    /// The masses that may be loaded in addition to the excitation.
    pub forces: Vec<usize>,
}

/// A whole scene.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scene {
    /// The name of the emitted type.
    pub name: String,
    /// The masses. The first is the reference.
    pub masses: Vec<Mass>,
    /// The springs. The first is the reference.
    pub springs: Vec<Spring>,
    /// The contact of the scene.
    pub contact: Contact,
    /// The excitation of the scene.
    pub excitation: Excitation,
    /// The damping of the scene.
    pub damping: Damping,
    /// μ, static over kinetic friction force, at least 1.
    pub stiction: f64,
    /// The floating-point type of the emitted code.
    pub precision: Precision,
    /// The items to emit.
    pub provide: Vec<Provide>,
    /// The declared accuracy, with its range.
    pub declared: Declared,
    /// The law of the kinetic friction force.
    #[cfg_attr(feature = "serde", serde(default))]
    pub friction: FrictionLaw,
    /// The stepper's step, input and loads.
    #[cfg_attr(feature = "serde", serde(default))]
    pub stepping: Stepping,
}

impl Scene {
    /// Returns whether the scene provides an item, for any masses that the item names.
    #[must_use]
    pub fn provides(&self, item: &Provide) -> bool {
        let kind = core::mem::discriminant(item);
        let mut items = self.provide.iter();
        items.any(|item| core::mem::discriminant(item) == kind)
    }

    /// Returns whether any provided item is evaluated at a frequency. The stepper is not, nor is the simulation if the
    /// kinetic level depends on the speed.
    #[must_use]
    pub fn needs_frequency(&self) -> bool {
        let constant = self.friction == FrictionLaw::Coulomb;
        let mut items = self.provide.iter();
        items.any(|item| match item {
            Provide::Stepper => false,
            Provide::Simulation => constant,
            _ => true,
        })
    }

    /// Returns whether any provided item follows the motion in time.
    #[must_use]
    pub fn moves_in_time(&self) -> bool {
        let in_time = [Provide::Simulation, Provide::Orbit, Provide::Stepper];
        self.provide.iter().any(|item| in_time.contains(item))
    }

    /// Returns the name of a node in the description, or `?` for a mass that does not exist.
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
    /// Returns whether masses beyond the contact can act as an absorber. While the contact is stuck, only the contact
    /// joins such masses to the load, so that they resonate by themselves.
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
        // Marks the masses that the load reaches through free masses.
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

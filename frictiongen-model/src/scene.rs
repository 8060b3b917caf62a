//! A scene: what a description says, in its own units, before anything is computed from it.

/// One end of a spring, or the far side of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Node {
    /// A mass, by its zero-based place in [`Scene::masses`].
    Mass(usize),
    /// The support that moves when the excitation is base motion.
    Base,
    /// A support that never moves.
    Wall,
}

/// A point mass.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mass {
    /// Its name, a Rust identifier.
    pub name: String,
    /// Its mass, in the scene's own units (kg in SI); the first mass is the reference m₁.
    pub value: f64,
}

/// A linear spring between two nodes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring {
    /// Where it starts, as written.
    pub from: Node,
    /// Where it ends, as written.
    pub to: Node,
    /// Its stiffness, in the scene's own units (N/m in SI); the first spring is the reference k₁.
    pub stiffness: f64,
}

/// The one Coulomb contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Contact {
    /// The side written first.
    pub from: Node,
    /// The side written second.
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

/// Viscous damping.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Damping {
    /// None.
    #[default]
    None,
    /// The same modal damping ratio in every mode.
    Uniform(f64),
    /// A modal damping ratio for each mode, in ascending order of natural frequency.
    Modal(Vec<f64>),
    /// C = aM + bK, in the scene's own units.
    Rayleigh {
        /// The factor of the mass matrix.
        mass: f64,
        /// The factor of the stiffness matrix.
        stiffness: f64,
    },
}

/// The precision of the emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Precision {
    /// `f64`.
    #[default]
    F64,
    /// `f32`, without a single `f64`.
    F32,
}

/// What is to be emitted.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Provide {
    /// Both limits and the regime.
    Limits,
    /// The motion in the continuous regime of every mass, or of those named; the contact's always.
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

/// How exact the emitted code has to be.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Accuracy {
    /// Every formula exact.
    #[default]
    Exact,
    /// Within this relative error, over the scene's `range`.
    Relative(f64),
}

/// On which side of the exact limits approximate ones may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// On either.
    #[default]
    Near,
    /// β_lim never above and β*_lim never below the exact one.
    Safe,
}

/// What happens outside the range for which an accuracy is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Beyond {
    /// Nothing is answered.
    #[default]
    Error,
    /// The exact formulas answer.
    Exact,
}

/// How long the macro may look for a proof of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Proving {
    /// A second or so: what needs longer is checked.
    #[default]
    Quick,
    /// As long as a command would: some seconds, where nothing is optimised.
    Whole,
}

/// The values of r and β for which an accuracy is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Range {
    /// Smallest and largest frequency ratio.
    pub r: (f64, f64),
    /// Smallest and largest friction ratio.
    pub beta: (f64, f64),
}

/// How exact the emitted code has to be, and where.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Declared {
    /// The accuracy.
    pub accuracy: Accuracy,
    /// Where it holds, if it is not exact.
    pub range: Option<Range>,
    /// On which side of the exact limits the emitted ones may be.
    pub side: Side,
    /// In place of an accuracy, so many bytes: the best accuracy that fits is taken.
    pub budget: Option<f64>,
    /// What happens outside the range.
    pub beyond: Beyond,
    /// How long the macro may look for a proof.
    #[cfg_attr(feature = "serde", serde(default))]
    pub proof: Proving,
}

impl Declared {
    /// Whether tables are asked for.
    #[must_use]
    pub fn is_tabled(&self) -> bool {
        self.accuracy != Accuracy::Exact || self.budget.is_some()
    }
}

/// How the kinetic friction force depends on the sliding speed.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FrictionLaw {
    /// It does not: Coulomb's law with a static and a kinetic level.
    #[default]
    Coulomb,
    /// Piecewise linear: at each speed, in the scene's own units, the level over F.  From 1 at rest to the first point,
    /// constant beyond the last.
    Stribeck(Vec<[f64; 2]>),
}

impl FrictionLaw {
    /// The points (speed, level); none of Coulomb's law.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        match self {
            Self::Coulomb => &[],
            Self::Stribeck(points) => points,
        }
    }
}

/// What the stepper's input does between samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum StepInput {
    /// It keeps the value of the sample over the step.
    Hold,
    /// It goes on a straight line to the sample, which it reaches at the end of the step.
    #[default]
    Linear,
}

/// What a scene says of its stepper.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stepping {
    /// The step, if it is known: its tables are then constants.  In the unit of time that goes with the scene's, s in SI.
    pub step: Option<f64>,
    /// The input between samples.
    pub input: StepInput,
    /// The masses that may be loaded besides the excitation.
    pub forces: Vec<usize>,
}

/// A whole description.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scene {
    /// The name of the type.
    pub name: String,
    /// The masses; the first is the reference.
    pub masses: Vec<Mass>,
    /// The springs; the first is the reference.
    pub springs: Vec<Spring>,
    /// The contact.
    pub contact: Contact,
    /// The excitation.
    pub excitation: Excitation,
    /// The damping.
    pub damping: Damping,
    /// μ = static over kinetic friction force, at least 1.
    pub stiction: f64,
    /// The scalar of the emitted code.
    pub precision: Precision,
    /// What to emit.
    pub provide: Vec<Provide>,
    /// How exact.
    pub declared: Declared,
    /// The friction law.
    #[cfg_attr(feature = "serde", serde(default))]
    pub friction: FrictionLaw,
    /// The stepper's step, input and loads.
    #[cfg_attr(feature = "serde", serde(default))]
    pub stepping: Stepping,
}

impl Scene {
    /// Whether an item is provided, whatever masses it names.
    #[must_use]
    pub fn provides(&self, item: &Provide) -> bool {
        let kind = core::mem::discriminant(item);
        let mut items = self.provide.iter();
        items.any(|item| core::mem::discriminant(item) == kind)
    }

    /// Whether anything is provided that answers at a frequency: all but the stepper does, and but the simulation
    /// where the kinetic level changes with the speed.
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

    /// Whether anything is provided that follows the motion in time.
    #[must_use]
    pub fn moves_in_time(&self) -> bool {
        let in_time = [Provide::Simulation, Provide::Orbit, Provide::Stepper];
        self.provide.iter().any(|item| in_time.contains(item))
    }

    /// What a node is called in the description; `?` for a mass that does not exist.
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
    /// Whether masses beyond the contact can absorb: held contact, they are joined to the load by
    /// nothing else, so that they resonate by themselves.
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
        // What the load reaches through free masses.
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

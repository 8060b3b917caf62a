//! Creates a scene in code instead of from text.

use super::error::InvalidScene;
use super::system::System;
use frictiongen_kernel::Float;
use frictiongen_model::scene::{
    CONTACT, ConstantForce, ContactSides, Damper, Damping, DampingFrom, Declared, Excitation,
    FrictionLaw, JointLaw, Joints, Mass, NamedContact, NamedStop, Node, Precision, Provide, Scene,
    Spring, StepInput, StepperOptions, StopLaw,
};
use frictiongen_model::validate::{Checks, validate_known};

/// Builder of a scene in code. Nodes have the same names as in a description: the name of a mass, `base` or `wall`.
///
/// ```
/// use frictiongen::study::{System, scene::Damping};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let frame: System = System::builder()
///     .mass("lower", 3.27)
///     .mass("upper", 3.25)
///     .spring("base", "lower", 1190.0)
///     .spring("lower", "upper", 1323.0)
///     .contact("upper", "wall")
///     .excitation("base")
///     .damping(Damping::Modal(vec![0.010, 0.012]))
///     .stiction(1.2)
///     .build()?;
/// assert!((frame.at(0.9)?.continuous_limit() - 0.464135).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
#[must_use = "a builder makes a system by `build`"]
pub struct Builder {
    name: String,
    masses: Vec<Mass>,
    springs: Vec<(String, String, f64)>,
    contact: Option<(String, String)>,
    excitation: Option<String>,
    damping: Damping,
    damping_from: DampingFrom,
    stiction: f64,
    stiffness: Option<f64>,
    contacts: Vec<(String, (String, String), JointLaw)>,
    dampers: Vec<(String, String, f64)>,
    stops: Vec<(String, (String, String), StopLaw)>,
    constant: Vec<(String, f64)>,
    friction: FrictionLaw,
    step: Option<f64>,
    input: StepInput,
    forces: Vec<String>,
}

impl System {
    /// Returns an empty builder of a scene.
    pub fn builder() -> Builder {
        Builder {
            name: "Scene".to_owned(),
            masses: Vec::new(),
            springs: Vec::new(),
            contact: None,
            excitation: None,
            damping: Damping::None,
            damping_from: DampingFrom::Rest,
            stiction: 1.0,
            stiffness: None,
            contacts: Vec::new(),
            dampers: Vec::new(),
            stops: Vec::new(),
            constant: Vec::new(),
            friction: FrictionLaw::Coulomb,
            step: None,
            input: StepInput::Linear,
            forces: Vec::new(),
        }
    }
}

impl Builder {
    /// Sets the name of the scene. The default name is `Scene`.
    pub fn name(mut self, name: &str) -> Self {
        name.clone_into(&mut self.name);
        self
    }

    /// Adds a mass. The first mass is m₁, the reference of all mass ratios.
    pub fn mass(mut self, name: &str, value: f64) -> Self {
        self.masses.push(Mass {
            name: name.to_owned(),
            value,
        });
        self
    }

    /// Adds a spring of the given stiffness between two nodes. The first spring is k₁, the reference of all stiffness
    /// ratios.
    pub fn spring(mut self, from: &str, to: &str, stiffness: f64) -> Self {
        self.springs
            .push((from.to_owned(), to.to_owned(), stiffness));
        self
    }

    /// Sets the two nodes between which the friction contact acts.
    pub fn contact(mut self, from: &str, to: &str) -> Self {
        self.contact = Some((from.to_owned(), to.to_owned()));
        self
    }

    /// Adds one of several contacts. The contact has a name, two nodes and a law: its stiffness, its μ, its friction
    /// force divided by F, and the speed of the surface of its second side. If the scene has several contacts, use this method instead of `contact`.
    /// `System::joined` then solves the scene. If it is the only contact, the scene is that of `contact` with a name.
    #[doc(hidden)]
    pub fn contact_named(mut self, name: &str, from: &str, to: &str, law: JointLaw) -> Self {
        let sides = (from.to_owned(), to.to_owned());
        self.contacts.push((name.to_owned(), sides, law));
        self
    }

    /// Adds a dashpot between two nodes. Its coefficient is the force divided by the relative velocity, in N·s/m.
    pub fn damper(mut self, from: &str, to: &str, coefficient: f64) -> Self {
        self.dampers
            .push((from.to_owned(), to.to_owned(), coefficient));
        self
    }

    /// Adds a stop with a name. It acts while the displacement of `from` minus that of `to` exceeds the gap of the law.
    /// Behind the gap the stop has a stiffness and a damping, or a coefficient of restitution.
    ///
    /// ```
    /// use frictiongen::study::System;
    /// use frictiongen::study::scene::{Impact, StopLaw};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let law = StopLaw { gap: 0.002, impact: Impact::Spring { stiffness: 1e6, damping: 50.0 } };
    /// let block: System = System::builder()
    ///     .mass("block", 2.0)
    ///     .spring("base", "block", 800.0)
    ///     .contact("block", "wall")
    ///     .stop("bumper", "block", "wall", law)
    ///     .constant("block", 9.81)
    ///     .excitation("base")
    ///     .build()?;
    /// assert!(block.scene().has_length());
    /// # Ok(())
    /// # }
    /// ```
    pub fn stop(mut self, name: &str, from: &str, to: &str, law: StopLaw) -> Self {
        let sides = (from.to_owned(), to.to_owned());
        self.stops.push((name.to_owned(), sides, law));
        self
    }

    /// Adds a constant force on a mass, in N.
    pub fn constant(mut self, mass: &str, force: f64) -> Self {
        self.constant.push((mass.to_owned(), force));
        self
    }

    /// Sets the excited node. If the node is a mass, a harmonic force acts on the mass. If it is `base`, the base
    /// moves.
    pub fn excitation(mut self, node: &str) -> Self {
        self.excitation = Some(node.to_owned());
        self
    }

    /// Sets the modal or Rayleigh damping of the chain. The default is no damping.
    pub fn damping(mut self, damping: Damping) -> Self {
        self.damping = damping;
        self
    }

    /// Selects the velocities on which the damping acts if the base moves: absolute velocities (the default), or
    /// velocities relative to the base.
    pub fn damping_from(mut self, damping_from: DampingFrom) -> Self {
        self.damping_from = damping_from;
        self
    }

    /// Sets μ, the ratio of static to kinetic friction. The default is 1.
    pub fn stiction(mut self, stiction: f64) -> Self {
        self.stiction = stiction;
        self
    }

    /// Sets the stiffness of an elastic contact (Jenkins element) in N/m: the stiffness of the spring in series with
    /// the slider. Without this call the contact is rigid. An elastic contact sticks after each reversal. Continuous
    /// motion is therefore impossible, and its limit β_lim is 0.
    pub fn stiffness(mut self, stiffness: f64) -> Self {
        self.stiffness = Some(stiffness);
        self
    }

    /// Sets the friction law. The default is Coulomb's law. With any other law, only the stepper and `simulation_under`
    /// compute motions, and `at` returns an error.
    ///
    /// ```
    /// use frictiongen::study::System;
    /// use frictiongen::study::scene::FrictionLaw;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let string: System = System::builder()
    ///     .mass("string", 0.01)
    ///     .spring("base", "string", 1e5)
    ///     .contact("string", "base")
    ///     .excitation("base")
    ///     .friction(FrictionLaw::Stribeck(vec![[0.02, 0.5], [0.2, 0.3]]))
    ///     .build()?;
    /// let told = string.at(0.9).map(|_| ()).map_err(|error| error.to_string());
    /// assert!(told.is_err_and(|told| told.contains("needs a constant kinetic level")));
    /// # Ok(())
    /// # }
    /// ```
    pub fn friction(mut self, law: FrictionLaw) -> Self {
        self.friction = law;
        self
    }

    /// Sets the length of the stepper's time step, in s. Only emitted code uses this length.
    pub fn step(mut self, step: f64) -> Self {
        self.step = Some(step);
        self
    }

    /// Sets the interpolation of the stepper's input between samples. The default is linear.
    pub fn input(mut self, input: StepInput) -> Self {
        self.input = input;
        self
    }

    /// Adds a mass on which an emitted stepper accepts a force, in addition to the excited mass. A run-time stepper
    /// accepts forces on every mass.
    pub fn force(mut self, mass: &str) -> Self {
        self.forces.push(mass.to_owned());
        self
    }

    /// Builds the system, in double precision.
    ///
    /// # Errors
    /// [`InvalidScene`] lists every fault: names that are not defined, and values that make no physical sense.
    pub fn build(self) -> Result<System, InvalidScene> {
        self.build_in()
    }

    /// Builds the system in another scalar type, as in `build_in::<f32>()`.
    ///
    /// # Errors
    /// Same errors as [`build`](Self::build).
    pub fn build_in<S: Float>(self) -> Result<System<S>, InvalidScene> {
        let mut unknown = Vec::new();
        let mut checks = Checks::default();
        let mut node = |name: &str, place: &dyn Fn() -> String| {
            let mass = self.masses.iter().position(|mass| mass.name == name);
            match (name, mass) {
                ("base", _) => Some(Node::Base),
                ("wall", _) => Some(Node::Wall),
                (_, Some(mass)) => Some(Node::Mass(mass)),
                (_, None) => {
                    let place = place();
                    unknown.push(format!(
                        "{place} names `{name}`, which is neither a mass nor `base` nor `wall`"
                    ));
                    None
                }
            }
        };
        // A spring with an unknown node is reported, and does not enter `springs`. The later checks can then still find
        // the other faults of the scene.
        let mut springs = Vec::with_capacity(self.springs.len());
        for (from, to, stiffness) in &self.springs {
            let place = || format!("the spring `{from} - {to}`");
            let ends = (node(from, &place), node(to, &place));
            if let (Some(from), Some(to)) = ends {
                springs.push(Spring {
                    from,
                    to,
                    stiffness: *stiffness,
                });
            } else {
                checks.springs = false;
            }
        }
        let mut joints = Joints::default();
        for (name, (from, to), law) in &self.contacts {
            let place = || format!("the contact `{from} - {to}`");
            if let (Some(from), Some(to)) = (node(from, &place), node(to, &place)) {
                joints.contacts.push(NamedContact {
                    name: name.clone(),
                    sides: ContactSides { from, to },
                    law: *law,
                });
            } else {
                checks.joints = false;
            }
        }
        for (from, to, coefficient) in &self.dampers {
            let place = || format!("the dashpot `{from} - {to}`");
            if let (Some(from), Some(to)) = (node(from, &place), node(to, &place)) {
                joints.dampers.push(Damper {
                    from,
                    to,
                    coefficient: *coefficient,
                });
            } else {
                checks.joints = false;
            }
        }
        for (name, (from, to), law) in &self.stops {
            let place = || format!("the stop `{name}`");
            if let (Some(from), Some(to)) = (node(from, &place), node(to, &place)) {
                joints.stops.push(NamedStop {
                    name: name.clone(),
                    sides: ContactSides { from, to },
                    law: *law,
                });
            } else {
                checks.joints = false;
            }
        }
        let sides = self.contact.as_ref().map(|(from, to)| {
            let place = || format!("the contact `{from} - {to}`");
            (node(from, &place), node(to, &place))
        });
        let excited = self
            .excitation
            .as_ref()
            .map(|name| node(name, &|| "the excitation".to_owned()));
        if self.contact.is_some() && !self.contacts.is_empty() {
            unknown.push(
                "`contact` and `contact_named` exclude each other; keep one of the two".to_owned(),
            );
        }
        if self.contact.is_none() && self.contacts.is_empty() {
            unknown.push("there is no contact; add one by `contact`".to_owned());
        }
        let contact = if let Some((Some(from), Some(to))) = sides {
            ContactSides { from, to }
        } else if let Some(first) = joints.contacts.first() {
            first.sides
        } else {
            checks.contact = false;
            ContactSides {
                from: Node::Base,
                to: Node::Wall,
            }
        };
        let excitation = match excited {
            Some(Some(Node::Mass(mass))) => Excitation::Force(mass),
            Some(Some(Node::Base)) => Excitation::Base,
            other => {
                checks.excitation = false;
                match other {
                    Some(Some(_)) => {
                        unknown.push("the excitation names `wall`, which never moves".to_owned());
                    }
                    Some(None) => {}
                    None => {
                        unknown.push("there is no excitation; add one by `excitation`".to_owned())
                    }
                }
                Excitation::Base
            }
        };
        let mut forces = Vec::with_capacity(self.forces.len());
        for name in &self.forces {
            let known = self.masses.iter().position(|mass| mass.name == *name);
            match known {
                Some(mass) => forces.push(mass),
                None => unknown.push(format!("`force` names `{name}`, which is no mass")),
            }
        }
        for (name, force) in &self.constant {
            let known = self.masses.iter().position(|mass| mass.name == *name);
            if let Some(mass) = known {
                let force = *force;
                joints.constant.push(ConstantForce { mass, force });
            } else {
                unknown.push(format!("`constant` names `{name}`, which is no mass"));
                checks.joints = false;
            }
        }
        let stepping = StepperOptions {
            step: self.step,
            input: self.input,
            forces,
        };
        let mut scene = Scene {
            name: self.name,
            masses: self.masses,
            springs,
            contact,
            contact_name: CONTACT.to_owned(),
            excitation,
            damping: self.damping,
            damping_from: self.damping_from,
            stiction: self.stiction,
            stiffness: self.stiffness,
            precision: Precision::F64,
            provide: Vec::new(),
            declared: Declared::default(),
            friction: self.friction,
            stepping,
            joints,
        };
        if unknown.is_empty() {
            scene.unite();
        }
        scene.provide = provided(&scene);
        if unknown.is_empty() {
            return System::try_from(scene);
        }
        let errors = validate_known(&scene, &checks).err().unwrap_or_default();
        Err(InvalidScene { unknown, errors })
    }
}

/// Returns the field `provide`, the list of solvers that emitted code of a scene contains. The list depends on the
/// friction law and on the settings of the stepper.
fn provided(scene: &Scene) -> Vec<Provide> {
    if scene.friction != FrictionLaw::Coulomb {
        return vec![Provide::Stepper];
    }
    let mut provide = scene.default_provide();
    if scene.stepping != StepperOptions::default() {
        provide.push(Provide::Stepper);
    }
    provide
}

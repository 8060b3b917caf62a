//! Several contacts, dashpots, stops and constant forces of a scene.

use super::{ContactSides, FrictionLaw, Node, Scene};
use crate::validate::can_be_single;

/// Name of the contact of the field `contact`. No mass can have this name.
pub const CONTACT: &str = "contact";

/// Returns the default of [`Scene::contact_name`].
#[cfg(feature = "serde")]
pub(super) fn contact_name() -> String {
    CONTACT.to_owned()
}

/// Friction law of a contact of the field `contacts`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct JointLaw {
    /// Stiffness of an elastic contact (Jenkins element), in the scene's own units (N/m in SI). `None` for a rigid
    /// contact.
    pub stiffness: Option<f64>,
    /// μ, the ratio of static to kinetic friction force, at least 1.
    pub stiction: f64,
    /// The kinetic friction force of this contact, divided by the common friction force F.
    pub share: f64,
    /// Speed of the surface of the second side relative to its node, in the scene's own units (m/s in SI). It is the
    /// speed of a belt, and 0 for a contact without a belt.
    #[cfg_attr(feature = "serde", serde(default))]
    pub speed: f64,
}

impl Default for JointLaw {
    /// Returns the law of a rigid contact with μ = 1, the friction force F and no belt.
    fn default() -> Self {
        Self {
            stiffness: None,
            stiction: 1.0,
            share: 1.0,
            speed: 0.0,
        }
    }
}

/// A contact of the field `contacts`, with its name.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct NamedContact {
    /// The name of the contact, a Rust identifier.
    pub name: String,
    /// The two sides of the contact.
    pub sides: ContactSides,
    /// The friction law of the contact: its stiffness, μ, share and speed.
    pub law: JointLaw,
}

/// A dashpot between two nodes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct Damper {
    /// The end of the dashpot that the description writes first.
    pub from: Node,
    /// The end of the dashpot that the description writes second.
    pub to: Node,
    /// Force divided by relative velocity, in the scene's own units (N·s/m in SI).
    pub coefficient: f64,
}

/// A one-sided stop between two nodes, with its name. It acts while the displacement of the first node minus that of
/// the second exceeds the gap.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct NamedStop {
    /// The name of the stop, a Rust identifier.
    pub name: String,
    /// The two sides of the stop. Their order gives its direction.
    pub sides: ContactSides,
    /// The gap of the stop, and the force or the rebound behind the gap.
    pub law: StopLaw,
}

/// Gap of a stop, and the force or the rebound behind the gap.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct StopLaw {
    /// Relative displacement at which the stop begins to act, in the scene's own units (m in SI). A negative gap is a
    /// preload.
    pub gap: f64,
    /// The force or the rebound behind the gap.
    pub impact: Impact,
}

/// Force or rebound of a stop behind its gap.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub enum Impact {
    /// A spring and a dashpot side by side.
    Spring {
        /// Stiffness of the spring, greater than 0, in the scene's own units (N/m in SI).
        stiffness: f64,
        /// Force of the dashpot divided by relative velocity, at least 0, in the scene's own units (N·s/m in SI).
        damping: f64,
    },
    /// A rigid stop. The number is the coefficient of restitution from 0 to 1: the speed after the impact, divided by
    /// the speed before it.
    Restitution(f64),
}

impl Impact {
    /// Returns the stiffness, which a rigid stop does not have, the damping and the coefficient of restitution.
    #[must_use]
    pub fn numbers(self) -> (Option<f64>, f64, f64) {
        match self {
            Self::Spring { stiffness, damping } => (Some(stiffness), damping, 0.0),
            Self::Restitution(restitution) => (None, 0.0, restitution),
        }
    }
}

/// A constant force on a mass.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct ConstantForce {
    /// Index of the mass on which the force acts.
    pub mass: usize,
    /// The force, positive in the direction of the displacement, in the scene's own units (N in SI).
    pub force: f64,
}

/// The contacts of the field `contacts`, the dashpots, the stops and the constant forces. All lists are empty for a
/// scene with a single contact and without dashpots, stops and constant forces.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct Joints {
    /// The contacts of the field `contacts`. The list is empty if the scene has a single contact.
    pub contacts: Vec<NamedContact>,
    /// The dashpots of the scene.
    pub dampers: Vec<Damper>,
    /// The stops of the scene.
    #[cfg_attr(feature = "serde", serde(default))]
    pub stops: Vec<NamedStop>,
    /// The constant forces of the scene.
    #[cfg_attr(feature = "serde", serde(default))]
    pub constant: Vec<ConstantForce>,
}

impl Joints {
    /// Returns true if the scene has a single contact, no dashpots, no stops and no constant forces.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.contacts.is_empty() && self.has_no_more_than_contacts()
    }

    /// Returns true if the scene has no dashpots, no stops and no constant forces.
    fn has_no_more_than_contacts(&self) -> bool {
        self.dampers.is_empty() && self.stops.is_empty() && self.constant.is_empty()
    }
}

impl Scene {
    /// Returns true if the solver for several contacts computes the motions of the scene. It computes them for several
    /// contacts, for a share that is not 1, for a belt, for dashpots, stops and constant forces, and for masses that no
    /// spring holds.
    #[must_use]
    #[doc(hidden)]
    pub fn is_joined(&self) -> bool {
        !self.joints.is_empty()
    }

    /// Returns true if the solver for several contacts computes the steady states of the scene. It computes them for
    /// every scene of [`is_joined`](Self::is_joined), and for kinetic friction that depends on the speed.
    #[must_use]
    #[doc(hidden)]
    pub fn has_joined_states(&self) -> bool {
        self.is_joined() || self.friction != FrictionLaw::Coulomb
    }

    /// Returns true if the scene contains a length or a speed of its own, so that its answers depend on the size of the
    /// load and not only on β.
    ///
    /// Stribeck friction and belts contain a speed, and stops contain a length. A constant force deflects the springs
    /// by a length of its own.
    #[must_use]
    pub fn has_length(&self) -> bool {
        self.friction != FrictionLaw::Coulomb || !self.has_linear_states()
    }

    /// Returns true if the equations are linear and without constant terms while all contacts stick or slide. The scene
    /// then has neither stops nor moving surfaces nor constant forces.
    #[must_use]
    #[doc(hidden)]
    pub fn has_linear_states(&self) -> bool {
        let mut contacts = self.joints.contacts.iter();
        self.joints.stops.is_empty()
            && self.joints.constant.is_empty()
            && contacts.all(|contact| contact.law.speed == 0.0)
    }

    /// Moves the only contact of [`Joints::contacts`] to the fields of a single contact, and keeps its name. The scene
    /// stays as it is if it has several contacts, a share that is not 1, a speed that is not 0, a dashpot, a stop, a
    /// constant force, or a mass that no spring holds.
    #[doc(hidden)]
    pub fn unite(&mut self) {
        let [only] = self.joints.contacts.as_slice() else {
            return;
        };
        let JointLaw {
            stiffness,
            stiction,
            share,
            speed,
        } = only.law;
        // A field of the single contact beside `contacts` is an error, which another check reports.
        let own_law = self.stiction == 1.0 && self.stiffness.is_none();
        // The parser has already reported a number that is NaN.
        let read = !stiction.is_nan() && !stiffness.is_some_and(f64::is_nan);
        let alone = self.joints.has_no_more_than_contacts() && share == 1.0 && speed == 0.0;
        let united = Self {
            contact: only.sides,
            contact_name: only.name.clone(),
            stiction,
            stiffness,
            joints: Joints::default(),
            ..self.clone()
        };
        if own_law && read && alone && can_be_single(&united) {
            *self = united;
        }
    }

    /// Multiplies the kinetic friction of every rigid contact by `rest`, the friction at rest over F. The ratio of the static
    /// friction to F does not change, unless it is below `rest`.
    pub fn raise_rigid(&mut self, rest: f64) {
        if self.joints.contacts.is_empty() && self.stiffness.is_none() {
            self.joints.contacts = self.named_contacts();
            self.stiction = 1.0;
        }
        let contacts = self.joints.contacts.iter_mut();
        for contact in contacts.filter(|contact| contact.law.stiffness.is_none()) {
            contact.law.share *= rest;
            contact.law.stiction = (contact.law.stiction / rest).max(1.0);
        }
    }

    /// Returns the names of the contacts, and then of the stops, in the order of the scene description.
    #[must_use]
    pub fn names_of_contacts(&self) -> Vec<String> {
        let contacts = self.named_contacts().into_iter();
        let stops = self.joints.stops.iter().map(|stop| stop.name.clone());
        contacts.map(|contact| contact.name).chain(stops).collect()
    }

    /// Returns the two nodes of the contact or stop with this index. Stops follow the contacts.
    #[must_use]
    pub fn sides_of_contact(&self, index: usize) -> Option<ContactSides> {
        let contacts = self.named_contacts().into_iter();
        let stops = self.joints.stops.iter().map(|stop| stop.sides);
        contacts
            .map(|contact| contact.sides)
            .chain(stops)
            .nth(index)
    }

    /// Returns every contact with its name.
    #[must_use]
    #[doc(hidden)]
    pub fn named_contacts(&self) -> Vec<NamedContact> {
        if !self.joints.contacts.is_empty() {
            return self.joints.contacts.clone();
        }
        vec![NamedContact {
            name: self.contact_name.clone(),
            sides: self.contact,
            law: JointLaw {
                stiffness: self.stiffness,
                stiction: self.stiction,
                share: 1.0,
                speed: 0.0,
            },
        }]
    }
}

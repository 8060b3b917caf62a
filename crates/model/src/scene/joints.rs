//! Several contacts and dashpots of a scene.

use super::{ContactSides, Node, Scene};

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
}

impl Default for JointLaw {
    /// Returns the law of a rigid contact with μ = 1 and the friction force F.
    fn default() -> Self {
        Self {
            stiffness: None,
            stiction: 1.0,
            share: 1.0,
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
    /// The friction law of the contact: its stiffness, μ and share.
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

/// The contacts of the field `contacts`, and the dashpots. Both lists are empty for a scene with the field `contact`
/// and without dashpots.
#[derive(Clone, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(hidden)]
pub struct Joints {
    /// The contacts of the field `contacts`. The list is empty if the scene has the field `contact`.
    pub contacts: Vec<NamedContact>,
    /// The dashpots of the scene.
    pub dampers: Vec<Damper>,
}

impl Joints {
    /// Returns true if the scene has neither the field `contacts` nor dashpots.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.contacts.is_empty() && self.dampers.is_empty()
    }
}

impl Scene {
    /// Returns true if the scene has the field `contacts` or `dampers`. The solver for several contacts then computes
    /// the motions of the scene.
    #[must_use]
    #[doc(hidden)]
    pub fn is_joined(&self) -> bool {
        !self.joints.is_empty()
    }

    /// Returns every contact with its name. A contact from the field `contact` has the name `contact`.
    #[must_use]
    #[doc(hidden)]
    pub fn named_contacts(&self) -> Vec<NamedContact> {
        if !self.joints.contacts.is_empty() {
            return self.joints.contacts.clone();
        }
        vec![NamedContact {
            name: "contact".to_owned(),
            sides: self.contact,
            law: JointLaw {
                stiffness: self.stiffness,
                stiction: self.stiction,
                share: 1.0,
            },
        }]
    }
}

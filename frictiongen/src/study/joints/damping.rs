//! Computes the damping matrix of a chain from modal damping ratios, or from the two factors of Rayleigh damping.

use super::{Chain, JointError};
use frictiongen_kernel::joints::at;
use frictiongen_model::joined::{at_rest, damping_matrix};
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{
    CONTACT, ContactSides, Damping, DampingFrom, Declared, Excitation, FrictionLaw, Joints, Mass,
    Node, Precision, Scene, Spring, StepperOptions,
};

impl Chain {
    /// Sets the damping ratio of each mode of the chain without contacts, in ascending order of natural frequency.
    /// `ratios` also has an entry for a rigid-body mode, which deforms no spring. This entry has no effect.
    ///
    /// # Errors
    ///
    /// Same errors as [`Chain::model`]. [`JointError::Number`] also if there is not one ratio for each mode, or if a
    /// ratio is negative or NaN.
    pub fn damp_modes(&mut self, ratios: &[f64]) -> Result<(), JointError> {
        if ratios.len() != self.masses.len() || ratios.iter().any(|ratio| !(*ratio >= 0.0)) {
            return Err(JointError::Number("a damping ratio"));
        }
        self.damp(Damping::Modal(ratios.to_vec()))
    }

    /// Sets the damping matrix to aM + bK, where a is `mass`, b is `stiffness`, M is the mass matrix and K the
    /// stiffness matrix.
    ///
    /// # Errors
    ///
    /// Same errors as [`Chain::model`].
    pub fn damp_by_rayleigh(&mut self, mass: f64, stiffness: f64) -> Result<(), JointError> {
        self.damp(Damping::Rayleigh { mass, stiffness })
    }

    fn damp(&mut self, damping: Damping) -> Result<(), JointError> {
        self.model()?;
        let scene = self.scene(damping);
        let modal = at_rest(&scene, Modal::of(&scene));
        self.damping = damping_matrix(&scene, &modal);
        Ok(())
    }

    /// Returns a scene with the masses and springs of this chain and with the given damping. It has no dashpots.
    fn scene(&self, damping: Damping) -> Scene {
        let springs = self.springs.iter();
        let springs = springs.map(|&(from, to, stiffness)| Spring {
            from,
            to,
            stiffness,
        });
        let masses = 0..self.masses.len();
        Scene {
            name: "Chain".to_owned(),
            masses: masses
                .map(|index| Mass {
                    name: format!("mass_{index}"),
                    value: at(&self.masses, index),
                })
                .collect(),
            springs: springs.collect(),
            contact: ContactSides {
                from: Node::Mass(0),
                to: Node::Wall,
            },
            contact_name: CONTACT.to_owned(),
            excitation: Excitation::Force(0),
            damping,
            damping_from: DampingFrom::Rest,
            stiction: 1.0,
            stiffness: None,
            precision: Precision::F64,
            provide: Vec::new(),
            declared: Declared::default(),
            friction: FrictionLaw::default(),
            stepping: StepperOptions::default(),
            joints: Joints::default(),
        }
    }
}

//! Converts a scene to the chain that the solver for several contacts uses, in the units of the scene description.

use super::error::{JoinedError, UnknownContact};
use crate::study::error::UnknownMass;
use crate::study::joints::{Chain, EndStop, Joint, MAX_MASSES, Wave};
use crate::study::start::InitialState;
use crate::study::system::System;
use crate::{OutOfDomain, Unsupported};
use frictiongen_kernel::Float;
use frictiongen_model::joined::{damping_matrix, numbered};
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::Scene;

/// Solver for the responses of a scene with several contacts or dashpots.
#[derive(Clone, Debug)]
pub struct Joined<'a> {
    scene: &'a Scene,
    /// False if the description has no field `excitation`.
    is_loaded: bool,
    /// The chain without loads, for a common friction of 1. The friction force of each contact is then its share of
    /// the common friction.
    chain: Chain,
    /// Reference angular frequency √(k₁/m₁), in rad per unit of time.
    reference: f64,
    /// Unit of displacement for results in ratios: P/k₁, or Y for base motion. The solver needs this unit if the scene has
    /// a length or a speed of its own.
    length: Option<f64>,
    /// Initial state of the motions to steady states, if the system has one.
    start: Option<InitialState>,
}

impl<S: Float> System<S> {
    /// Returns a solver for a scene with several contacts, dashpots, or masses without a path of springs to a support.
    /// The solver also supports a scene with a single contact, which has the name `contact`. It computes in `f64`.
    ///
    /// # Errors
    /// [`JoinedError`] for more than 1000 masses.
    #[doc(hidden)]
    pub fn joined(&self) -> Result<Joined<'_>, JoinedError> {
        let count = self.scene().masses.len();
        if count > MAX_MASSES {
            return Err(JoinedError::TooManyMasses(count));
        }
        Ok(Joined {
            is_loaded: self.loaded().is_ok(),
            start: self.start.clone(),
            ..Joined::new(self.scene(), self.modal())
        })
    }
}

impl<'a> Joined<'a> {
    fn new(scene: &'a Scene, modal: &Modal) -> Self {
        let masses: Vec<f64> = scene.masses.iter().map(|mass| mass.value).collect();
        let springs = scene.springs.iter();
        let dampers = scene.joints.dampers.iter();
        let contacts = scene.named_contacts().into_iter().map(|contact| Joint {
            ends: (contact.sides.from, contact.sides.to),
            level: Wave::constant(contact.law.share),
            stiction: contact.law.stiction,
            stiffness: contact.law.stiffness,
            speed: contact.law.speed,
        });
        let stops = scene.joints.stops.iter().map(|stop| EndStop {
            ends: (stop.sides.from, stop.sides.to),
            law: stop.law,
        });
        let constant = scene.joints.constant.iter();
        let mut chain = Chain {
            springs: springs
                .map(|spring| (spring.from, spring.to, spring.stiffness))
                .collect(),
            dashpots: dampers
                .map(|damper| (damper.from, damper.to, damper.coefficient))
                .collect(),
            contacts: contacts.collect(),
            stops: stops.collect(),
            constant: constant.map(|own| (own.mass, own.force)).collect(),
            damping_from_base: scene.is_damped_from_base(),
            law: scene.friction.points().to_vec(),
            ..Chain::default()
        };
        chain.masses = masses;
        chain.damping = damping_matrix(scene, modal);
        Self {
            scene,
            is_loaded: true,
            chain,
            reference: modal.reference.to_f64(),
            length: None,
            start: None,
        }
    }

    /// Returns the initial state of the motions to steady states, if the system has one.
    pub(super) fn start(&self) -> Option<&InitialState> {
        self.start.as_ref()
    }

    /// Sets the initial state of the motions to steady states.
    pub(super) fn set_start(&mut self, start: Option<InitialState>) {
        self.start = start;
    }

    /// Fails if the description has no field `excitation`.
    pub(super) fn check_load(&self) -> Result<(), OutOfDomain> {
        match self.is_loaded {
            true => Ok(()),
            false => Err(Unsupported::NoExcitation.into()),
        }
    }

    /// Returns the scene that the results describe.
    #[must_use]
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// Returns the chain without loads, for a common friction of 1. The friction force of each contact is then its
    /// share of the common friction.
    #[must_use]
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// Returns this solver with the unit of displacement for results in ratios. `length` is this unit: P/k₁, or Y for
    /// base motion. Only results of a scene with a length or a speed of its own depend on it, for example with
    /// `friction: stribeck` or a stop.
    #[must_use]
    pub fn with_length(&self, length: f64) -> Self {
        Self {
            length: Some(length),
            ..self.clone()
        }
    }

    /// Returns the unit of displacement for results in ratios (P/k₁, or Y for base motion), if it is known.
    pub(super) fn length(&self) -> Option<f64> {
        self.length
    }

    /// Replaces each contact's share of the common friction. `shares` has the order of the scene description.
    fn set_shares(&mut self, shares: &[f64]) {
        for (contact, share) in self.chain.contacts.iter_mut().zip(shares) {
            contact.level = Wave::constant(*share);
        }
    }

    /// Returns this scene with other shares of the common friction. A contact without a number in `shares` keeps its
    /// share.
    #[must_use]
    pub fn with_shares(&self, shares: &[f64]) -> Self {
        let mut joined = self.clone();
        joined.set_shares(shares);
        joined
    }

    /// Returns the names of the contacts, and then of the stops, in the order of the scene description.
    #[must_use]
    pub fn contact_names(&self) -> Vec<String> {
        self.scene.names_of_contacts()
    }

    /// Returns the factor that converts the sign of the solver for a contact to the sign of the scene description.
    /// With this factor, the relative displacement of a contact `a - b` of two masses is x_b − x_a. The factor is −1
    /// if the first mass of the contact is the later of its two masses, and otherwise 1. Results in N and m for a
    /// scene with a single contact have the same sign.
    #[must_use]
    pub fn sign(&self, contact: usize) -> f64 {
        match self.scene.sides_of_contact(contact) {
            Some(sides) if sides.is_reversed() => -1.0,
            _ => 1.0,
        }
    }

    /// Returns the numbers of the two nodes of a contact or stop. Its relative displacement is that of the first minus
    /// that of the second.
    pub(super) fn nodes(&self, contact: usize) -> Option<(usize, usize)> {
        let contacts = self.chain.contacts.iter().map(|contact| contact.ends);
        let stops = self.chain.stops.iter().map(|stop| stop.ends);
        let (from, to) = contacts.chain(stops).nth(contact)?;
        numbered(self.chain.masses.len(), from, to)
    }

    /// Returns the index of the contact called `name` in the scene description.
    pub(super) fn contact_index(&self, name: &str) -> Result<usize, UnknownContact> {
        let known = self.contact_names();
        let found = known.iter().position(|known| known == name);
        found.ok_or_else(|| UnknownContact {
            name: name.to_owned(),
            known,
        })
    }

    /// Returns the index of the mass called `name` in the scene description.
    pub(super) fn mass_index(&self, name: &str) -> Result<usize, UnknownMass> {
        let masses = || self.scene.masses.iter();
        let found = masses().position(|mass| mass.name == name);
        found.ok_or_else(|| UnknownMass {
            name: name.to_owned(),
            known: masses().map(|mass| mass.name.clone()).collect(),
        })
    }

    /// Returns the reference angular frequency √(k₁/m₁), in rad per unit of time.
    pub(in crate::study) fn reference(&self) -> f64 {
        self.reference
    }
}

//! The exact continuous motion at one friction ratio.

use super::at::At;
use super::scene::Scene;
use crate::response::coefficients::{Friction, Fundamental};
use crate::response::motion::Motion;

/// The motion of the contact or of a mass of a scene.
pub type MotionOf<T> = Motion<<T as Scene>::Scalar, <T as Scene>::Decay, <T as Scene>::Waves>;

/// A scene that provides `motion`.
pub trait ProvidesMotion: Scene {
    /// The motion, with a method for each mass.
    type Motion: From<Continuous<Self>>;
}

/// The exact continuous motion at one frequency ratio and one friction ratio.
#[derive(Clone, Debug)]
pub struct Continuous<T: Scene> {
    at: At<T>,
    friction: Friction<T::Scalar>,
}

impl<T: Scene + Copy> Copy for Continuous<T> where T::Modes: Copy {}

impl<T: Scene> Continuous<T> {
    /// The motion with this friction, which [`At::motion`] has admitted.
    #[inline]
    pub(super) fn new(at: At<T>, friction: Friction<T::Scalar>) -> Self {
        Self { at, friction }
    }

    /// The scene at the frequency of this motion.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &At<T> {
        &self.at
    }

    /// What the friction ratio adds to the sums.
    #[inline]
    #[must_use]
    pub fn friction(&self) -> &Friction<T::Scalar> {
        &self.friction
    }

    /// The relative motion in the contact: x̄ of the mass, of the mass from the base, or of the later mass from the
    /// earlier.
    #[inline]
    #[must_use]
    pub fn contact(&self) -> MotionOf<T> {
        T::contact_motion(&self.at, &self.friction)
    }

    /// The same as [`mass_at`](Self::mass_at); rest if there is no such mass.
    #[inline]
    #[must_use]
    pub fn mass(&self, mass: usize) -> MotionOf<T> {
        self.mass_at(mass).unwrap_or_else(|| {
            let rest = Fundamental::at_rest();
            Motion::of_mass(self.friction, rest, self.at.scene().idle())
        })
    }

    /// The motion of a mass (5.50 and its exact form, 7.29), by its place in the description; none if there is no
    /// such mass, or the scene does not provide its motion.
    #[inline]
    #[must_use]
    pub fn mass_at(&self, mass: usize) -> Option<MotionOf<T>> {
        let scene = self.at.scene();
        if !scene.moves(mass) || scene.shape(mass).is_none() {
            return None;
        }
        if scene.numbers().moves_as_contact(mass) {
            return Some(self.contact());
        }
        T::mass_motion(&self.at, &self.friction, mass)
    }
}

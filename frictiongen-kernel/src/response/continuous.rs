//! The exact continuous motion at one friction ratio.

use super::at::At;
use super::scene::Scene;
use crate::errors::NotContinuous;
use crate::response::coefficients::{Friction, Fundamental};
use crate::response::motion::Motion;

/// The motion of the contact or of a mass of a scene.
pub type MotionOf<T> = Motion<<T as Scene>::Scalar, <T as Scene>::Decay, <T as Scene>::Waves>;

/// A scene that provides `motion`.
///
/// The formulas that have a body here are those of every chain; a generator writes its own where that is faster.
pub trait ProvidesMotion: Scene {
    /// The motion, with a method for each mass.
    type Motion: From<Continuous<Self>>;

    /// The relative motion in the contact.
    #[inline]
    fn contact_motion(at: &At<Self>, friction: &Friction<Self::Scalar>) -> MotionOf<Self> {
        let numbers = at.scene.numbers();
        let mut waves = at.scene.idle();
        let chain = numbers.chain;
        let modes = numbers.modes.iter().zip(at.modes.as_ref());
        for (wave, (mode, functions)) in waves.as_mut().iter_mut().zip(modes) {
            *wave = chain.contact_wave(mode, functions, &at.contact, friction, at.inverse_r);
        }
        let fundamental = chain.contact_fundamental(&at.contact, friction);
        Motion::of_contact(*friction, fundamental, waves)
    }

    /// The motion of a mass that does not move as the contact does; none if there is no such mass.
    #[inline]
    fn mass_motion(
        at: &At<Self>,
        friction: &Friction<Self::Scalar>,
        mass: usize,
    ) -> Option<MotionOf<Self>> {
        let numbers = at.scene.numbers();
        let (shape, chain) = (at.scene.shape(mass)?, numbers.chain);
        let (contact, modes) = (&at.contact, at.modes.as_ref());
        let fundamental =
            chain.fundamental(shape, numbers.modes, modes, contact, friction, at.inverse_r);
        let mut waves = at.scene.idle();
        let modes = numbers.modes.iter().zip(modes).zip(shape);
        for (wave, ((mode, functions), component)) in waves.as_mut().iter_mut().zip(modes) {
            *wave = chain.mass_wave(mode, *component, functions, contact, friction, at.inverse_r);
        }
        Some(Motion::of_mass(*friction, fundamental, waves))
    }
}

impl<T: ProvidesMotion> At<T> {
    /// The exact continuous motion at the friction ratio β = F/P.  One or two
    /// searches decide whether β is below β_lim.
    ///
    /// # Errors
    /// [`NotContinuous`] says which regime it is instead, or that an undamped resonance is unbounded at this β, or
    /// that β is out of the domain.
    pub fn motion(&self, beta: T::Scalar) -> Result<T::Motion, NotContinuous> {
        let beta = self.admitted(beta)?;
        Ok(self.kept().closed_form(beta).into())
    }

    /// β, if the motion at it is continuous and bounded.
    ///
    /// # Errors
    /// As of [`motion`](Self::motion).
    #[inline]
    pub(crate) fn admitted(&self, beta: T::Scalar) -> Result<T::Scalar, NotContinuous> {
        let numbers = self.scene.numbers();
        self.scene.with_idle(|waves| {
            numbers.chain.admitted(
                self.r,
                beta,
                self.sliding_limit(),
                numbers.ends.continuous_at_infinity,
                numbers.unbounded,
                &self.contact,
                numbers.modes,
                self.modes.as_ref(),
                waves,
            )
        })
    }

    /// The closed form of the continuous motion at any β, 0 ≤ β < |V|/|U|: it is the motion only where
    /// [`motion`](Self::motion) gives it.
    #[inline]
    #[must_use]
    pub fn closed_form(self, beta: T::Scalar) -> Continuous<T> {
        let chain = self.scene.numbers().chain;
        let friction = chain.friction(&self.contact, self.inverse_r, beta);
        Continuous { at: self, friction }
    }
}

/// The exact continuous motion at one frequency ratio and one friction ratio.
#[derive(Clone, Debug)]
pub struct Continuous<T: Scene> {
    at: At<T>,
    friction: Friction<T::Scalar>,
}

impl<T: Scene + Copy> Copy for Continuous<T> where T::Modes: Copy {}

impl<T: ProvidesMotion> Continuous<T> {
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
            let at_rest = Fundamental::at_rest();
            Motion::of_mass(self.friction, at_rest, self.at.scene().idle())
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

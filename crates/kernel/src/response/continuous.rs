//! Exact continuous motion at one frequency ratio and one friction ratio. The contact slides all the time.

use super::at::At;
use super::scene::Scene;
use crate::combination::Combination;
use crate::contact::regime::check_beta;
use crate::errors::NotContinuous;
use crate::number::scalar::Scalar;
use crate::response::coefficients::{Friction, Fundamental};
use crate::response::motion::Motion;

/// Type of the exact continuous motion of the contact (relative motion) or of one mass.
pub type MotionOf<T> = Motion<<T as Scene>::Scalar, <T as Scene>::Decay, <T as Scene>::Waves>;

/// Trait of scenes that provide the exact continuous motion through the method `motion`.
///
/// The default methods are valid for every chain. The code generator writes faster methods for some scenes.
pub trait ProvidesMotion: Scene {
    /// Type that `motion` returns. In emitted code this type has one method for each mass.
    type Motion: From<Continuous<Self>>;

    /// Returns the relative motion of the contact. `friction` contains the friction ratio, and the amplitude and phase
    /// of the contact.
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

    /// Returns the motion of a mass whose motion differs from that of the contact. Returns `None` if the scene has no
    /// mass with this index.
    #[inline]
    fn mass_motion(
        at: &At<Self>,
        friction: &Friction<Self::Scalar>,
        mass: usize,
    ) -> Option<MotionOf<Self>> {
        let shape = at.scene.shape(mass)?;
        let (fundamental, waves) = fundamental_and_waves(at, friction, shape);
        Some(Motion::of_mass(*friction, fundamental, waves))
    }
}

/// Returns the coefficients of cos τ and sin τ in the closed form of a motion, and the term of each mode in this
/// motion. `shape` contains the component of the motion in each mode shape.
#[inline]
fn fundamental_and_waves<T: Scene>(
    at: &At<T>,
    friction: &Friction<T::Scalar>,
    shape: &[T::Scalar],
) -> (Fundamental<T::Scalar>, T::Waves) {
    let numbers = at.scene.numbers();
    let chain = numbers.chain;
    let (contact, modes) = (&at.contact, at.modes.as_ref());
    let (inverse_r, quadratures) = (at.inverse_r, at.scene.quadratures());
    // A scene without loads in quadrature uses the shorter formulas.
    let fundamental = if quadratures.is_empty() {
        chain.fundamental(shape, numbers.modes, modes, contact, friction, inverse_r)
    } else {
        let loaded = (numbers.modes, quadratures);
        chain.fundamental_loaded(shape, loaded, modes, contact, friction, inverse_r)
    };
    let mut waves = at.scene.idle();
    let modes = numbers.modes.iter().zip(modes).zip(shape);
    for (wave, ((mode, functions), component)) in waves.as_mut().iter_mut().zip(modes) {
        *wave = chain.mass_wave(mode, *component, functions, contact, friction, at.inverse_r);
    }
    (fundamental, waves)
}

impl<T: ProvidesMotion> At<T> {
    /// Returns the exact continuous motion at the friction ratio β = F/P. The call makes one or two searches, to decide
    /// whether β is below β_lim, the limit of continuous motion.
    ///
    /// # Errors
    /// [`NotContinuous`] gives the regime if the motion is not continuous. [`NotContinuous`] is also the error if r is
    /// an undamped resonance at which this β does not bound the amplitude, and for a β outside the domain.
    pub fn motion(&self, beta: T::Scalar) -> Result<T::Motion, NotContinuous> {
        let beta = self.admitted(beta)?;
        Ok(self.kept().closed_form(beta).into())
    }

    /// Checks that the motion at the friction ratio β is continuous and bounded. Returns β, or 0 at r = ∞ if friction
    /// has no effect there.
    ///
    /// # Errors
    /// The errors of [`motion`](Self::motion).
    #[inline]
    pub(crate) fn admitted(&self, beta: T::Scalar) -> Result<T::Scalar, NotContinuous> {
        let numbers = self.scene.numbers();
        if self.is_elastic() {
            // An elastic contact sticks after each reversal, so that no continuous motion exists.
            return Err(
                if check_beta(beta).map_err(|_| NotContinuous::OutOfDomain)? < self.sliding_limit()
                {
                    NotContinuous::StickSlip
                } else {
                    NotContinuous::Stuck
                },
            );
        }
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

    /// Returns the closed form of the continuous motion at the friction ratio β, without a check of the regime. β must
    /// satisfy 0 ≤ β < |V|/|U|, because the formula has no real value at a larger β. The closed form is a steady state
    /// only if [`motion`](Self::motion) returns a motion for this β.
    #[inline]
    #[must_use]
    pub fn closed_form(self, beta: T::Scalar) -> Continuous<T> {
        let chain = self.scene.numbers().chain;
        let friction = chain.friction(&self.contact, self.inverse_r, beta);
        Continuous { at: self, friction }
    }
}

/// Exact continuous motion at one frequency ratio and one friction ratio.
#[derive(Clone, Debug)]
pub struct Continuous<T: Scene> {
    at: At<T>,
    friction: Friction<T::Scalar>,
}

impl<T: Scene + Copy> Copy for Continuous<T> where T::Modes: Copy {}

impl<T: ProvidesMotion> Continuous<T> {
    /// Returns the scene at the frequency ratio of this continuous motion.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &At<T> {
        &self.at
    }

    /// Returns the amplitude Z and the phase φ of the contact's relative motion at this friction ratio, with
    /// intermediate results of the calculation.
    #[inline]
    #[must_use]
    pub fn friction(&self) -> &Friction<T::Scalar> {
        &self.friction
    }

    /// Returns the relative motion of the contact. For a mass that slides on a wall, the relative motion is the
    /// displacement x̄ of the mass. For a mass that slides on a base, it is x̄ of the mass minus the displacement of
    /// the base. If two masses slide on each other, it is a difference: x̄ of the mass that comes later in the scene
    /// description, minus x̄ of the other mass.
    #[inline]
    #[must_use]
    pub fn contact(&self) -> MotionOf<T> {
        T::contact_motion(&self.at, &self.friction)
    }

    /// Returns the motion of a mass, from its index in the scene description, as [`mass_at`](Self::mass_at) does. If
    /// the scene has no mass with this index, the function returns a motion at rest.
    #[inline]
    #[must_use]
    pub fn mass(&self, mass: usize) -> MotionOf<T> {
        self.mass_at(mass).unwrap_or_else(|| {
            let at_rest = Fundamental::at_rest();
            Motion::of_mass(self.friction, at_rest, self.at.scene().idle())
        })
    }

    /// Returns the motion of a mass, from its index in the scene description (5.50 and its exact form, 7.29). Returns
    /// `None` if the scene has no mass with this index or does not provide the motion of this mass.
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

    /// Returns the continuous motion of a linear combination of masses and base.
    #[must_use]
    pub fn combination(&self, combination: Combination<'_, T::Scalar>) -> MotionOf<T> {
        let Combination { shape, base } = combination;
        let (mut fundamental, waves) = fundamental_and_waves(&self.at, &self.friction, shape);
        // cos τ_e is cos(τ + φ), because τ is 0 at the maximum of the contact, which lags behind the excitation by φ.
        let half_turns = self.friction.phase * T::Scalar::inverse_pi();
        let (sine, cosine) = half_turns.sin_cos_pi();
        fundamental.cosine = fundamental.cosine + base * cosine;
        fundamental.sine = fundamental.sine - base * sine;
        fundamental.response.re = fundamental.response.re + base;
        Motion::of_mass(self.friction, fundamental, waves)
    }
}

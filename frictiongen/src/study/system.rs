//! The run-time system: the same closed forms, over vectors instead of arrays.

use crate::system::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady, StuckAt};
use crate::{Complex, Error, NotContinuous, OutOfDomain, Regime, StuckResonance};
use frictiongen_codegen::{Diagnostics, Limits, parse_text};
use frictiongen_kernel::chain::{Chain, ContactAt, ModeAt, Others};
use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::decay::{Damped, Decay};
use frictiongen_kernel::mode::{Mode, ModeResponse};
use frictiongen_kernel::motion::Friction;
use frictiongen_kernel::steady::{self, Motion, motion_wave};
use frictiongen_kernel::wave::Wave;
use frictiongen_kernel::{Float, Scalar};
use frictiongen_model::modal::{Modal, Reduced};
use frictiongen_model::scene::Scene;

/// A scene at run time.
///
/// ```
/// use frictiongen::study::System;
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let system: System = "struct Block {
///     masses: { block: 2.0 },
///     springs: { base - block: 50.0 },
///     contact: block - wall,
///     excitation: block,
/// }"
/// .parse()?;
/// let at = system.at(0.9)?;
/// assert!(at.continuous_limit() > 0.2);
/// assert!(at.motion(0.2)?.mass("block")?.amplitude() > 4.0);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct System<S = f64> {
    scene: Scene,
    modal: Modal,
    reduced: Reduced<S>,
    resonances: Vec<S>,
    unbounded: Vec<S>,
    invisible: Vec<S>,
}

/// No mass of this name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMass {
    /// What was asked for.
    pub name: String,
    /// What there is.
    pub known: Vec<String>,
}

impl std::fmt::Display for UnknownMass {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "there is no mass `{}`; the masses are {}",
            self.name,
            self.known.join(", ")
        )
    }
}

impl std::error::Error for UnknownMass {}

/// How many masses a run-time scene may have.
pub const MAX_MASSES: usize = 1000;

impl<S: Float> std::str::FromStr for System<S> {
    type Err = Diagnostics;

    fn from_str(text: &str) -> Result<Self, Diagnostics> {
        let limits = Limits { masses: MAX_MASSES };
        Ok(Self::from_scene(parse_text(text, &limits)?.scene))
    }
}

/// A double-double rounded once to a scalar.
fn rounded<S: Scalar>(value: Dd) -> S {
    // `constant` rounds an f64; what the f64 left out still counts for wider scalars.
    S::constant(value.hi) + S::constant(value.lo)
}

impl<S: Float> System<S> {
    /// The system of a scene that is known to be valid.
    pub fn from_scene(scene: Scene) -> Self {
        let modal = Modal::of(&scene);
        let reduced = modal.reduced(rounded::<S>);
        let resonances: Vec<S> = modal
            .resonances
            .iter()
            .map(|value| rounded(*value))
            .collect();
        let unbounded = modal.unbounded(false).into_iter().map(rounded).collect();
        let invisible = modal.unbounded(true).into_iter().map(rounded).collect();
        Self {
            scene,
            modal,
            reduced,
            resonances,
            unbounded,
            invisible,
        }
    }

    /// The scene as it was described.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The modal analysis behind it, to about 30 digits.
    #[must_use]
    pub fn modal(&self) -> &Modal {
        &self.modal
    }

    /// ω_i, rad/s in the scene's own units, ascending.
    #[must_use]
    pub fn natural_frequencies(&self) -> Vec<S> {
        self.modal
            .natural_frequencies()
            .into_iter()
            .map(rounded)
            .collect()
    }

    /// √λ_i: the frequency ratios of the undamped resonances, ascending.
    #[must_use]
    pub fn resonances(&self) -> &[S] {
        &self.resonances
    }

    /// φ by mode and mass, with φᵀΓφ = 1.
    #[must_use]
    pub fn mode_shapes(&self) -> Vec<Vec<S>> {
        let shapes = self.modal.shapes.iter();
        shapes
            .map(|shape| shape.iter().map(|value| rounded(*value)).collect())
            .collect()
    }

    /// rad/s → r = ω√(m₁/k₁).
    #[must_use]
    pub fn frequency_ratio(&self, omega: S) -> S {
        omega / rounded(self.modal.reference)
    }

    /// Friction force and load amplitude → β = F/P; for base motion of amplitude Y, P = k₁Y.
    #[must_use]
    pub fn friction_ratio(&self, friction: S, load: S) -> S {
        friction / load
    }

    /// The scene at the frequency ratio r.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r; 0 and ∞ answer with the limits.
    pub fn at(&self, r: S) -> Result<SystemAt<'_, S>, OutOfDomain> {
        let r = steady::check_ratio(r, "r")?;
        let (low, high) = S::INVERSE_RATIO_RANGE;
        let inverse_r = (S::constant(1.0) / r).max(low).min(high);
        let Reduced { modes, chain, .. } = &self.reduced;
        let mut responses = vec![ModeResponse::zero(); modes.len()];
        let scale = Chain::responses(modes, inverse_r, &mut responses);
        let mut modes_at = vec![ModeAt::zero(); modes.len()];
        let contact = chain.contact(modes, &responses, scale, inverse_r, &mut modes_at);
        Ok(SystemAt {
            system: self,
            r,
            inverse_r,
            contact,
            modes: modes_at,
        })
    }

    /// β_n,i: the friction ratio below which the i-th undamped resonance is unbounded (6.2, 6.26);
    /// none for a mode that the contact does not drive.
    #[must_use]
    pub fn resonance_thresholds(&self) -> Vec<Option<S>> {
        self.modal
            .resonance_thresholds()
            .into_iter()
            .map(|value| value.map(rounded))
            .collect()
    }

    fn mass_index(&self, name: &str) -> Result<usize, UnknownMass> {
        self.scene
            .masses
            .iter()
            .position(|mass| mass.name == name)
            .ok_or_else(|| self.unknown(name))
    }

    fn unknown(&self, name: &str) -> UnknownMass {
        UnknownMass {
            name: name.to_owned(),
            known: self
                .scene
                .masses
                .iter()
                .map(|mass| mass.name.clone())
                .collect(),
        }
    }
}

/// A system at one frequency ratio.
#[derive(Clone, Debug)]
pub struct SystemAt<'a, S = f64> {
    system: &'a System<S>,
    r: S,
    inverse_r: S,
    contact: ContactAt<S>,
    modes: Vec<ModeAt<S>>,
}

impl<'a, S: Float> SystemAt<'a, S> {
    fn waves(&self) -> Vec<Wave<S, Damped<S>>> {
        let zip = self.system.reduced.modes.iter().zip(&self.modes);
        zip.map(|(mode, at)| Wave::rest(at.x, Damped::of(mode)))
            .collect()
    }

    fn continuous(&self, constraint: S) -> S {
        let Reduced { chain, ends, .. } = &self.system.reduced;
        let limit = chain.continuous_limit(&self.contact, constraint);
        steady::with_ends(self.r, limit, S::constant(0.0), ends.continuous_at_infinity)
    }

    /// β_lim, exact, and how often the search evaluated the velocity constraint for it.
    #[must_use]
    pub fn continuous_limit_counted(&self) -> (S, u32) {
        let Reduced { modes, chain, .. } = &self.system.reduced;
        let peak = chain.velocity_constraint(&self.contact, modes, &self.modes, &mut self.waves());
        (self.continuous(peak.value), peak.evaluations)
    }

    /// β_lim, the exact boundary of continuous motion (5.65, 5.80, 5.96, 7.49).
    #[must_use]
    pub fn continuous_limit(&self) -> S {
        self.continuous_limit_counted().0
    }

    /// β_lim with S replaced by its limit for τ → 0 (5.64).
    #[must_use]
    pub fn continuous_limit_without_search(&self) -> S {
        self.continuous(self.system.reduced.chain.break_away(&self.contact))
    }

    /// β_lim with S as the sum of each mode's own maximum (5.55, 7.37), as the thesis prints it.
    #[must_use]
    pub fn continuous_limit_per_mode(&self) -> S {
        let Reduced { modes, chain, .. } = &self.system.reduced;
        self.continuous(chain.constraint_per_mode::<Damped<S>>(&self.contact, modes, &self.modes))
    }

    /// β*_lim, beyond which the contact never slides (6.11, 6.27, 6.33).
    #[must_use]
    pub fn sliding_limit(&self) -> S {
        let Reduced { chain, ends, .. } = &self.system.reduced;
        let limit = chain.sliding_limit(&self.contact);
        steady::with_ends(
            self.r,
            limit,
            ends.sliding_at_rest,
            ends.sliding_at_infinity,
        )
    }

    /// The regime at β = F/P.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn regime(&self, beta: S) -> Result<Regime, OutOfDomain> {
        let beta = steady::check_beta(beta)?;
        Ok(steady::regime(
            beta,
            self.continuous_limit(),
            self.sliding_limit(),
        ))
    }

    /// β/min(β_lim, β*_lim) − 1: negative in the continuous regime.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn margin(&self, beta: S) -> Result<S, OutOfDomain> {
        let beta = steady::check_beta(beta)?;
        Ok(steady::margin(
            beta,
            self.continuous_limit(),
            self.sliding_limit(),
        ))
    }

    fn others(&self) -> Vec<Others<S>> {
        let Reduced { modes, chain, .. } = &self.system.reduced;
        let mut others = vec![Others::zero(); modes.len()];
        chain.without_each(
            modes,
            &self.modes,
            self.contact.scale,
            self.inverse_r,
            &mut others,
        );
        others
    }

    /// The exact continuous motion at β = F/P.
    ///
    /// # Errors
    /// [`NotContinuous`] says which regime it is instead.
    pub fn motion(&self, beta: S) -> Result<SystemMotion<'a, S>, NotContinuous> {
        let Self {
            system,
            r,
            contact,
            modes,
            ..
        } = self;
        let Reduced {
            modes: constants,
            chain,
            ..
        } = &system.reduced;
        let beta = chain.admitted(
            *r,
            beta,
            self.sliding_limit(),
            &system.unbounded,
            contact,
            constants,
            modes,
            &mut self.waves(),
        )?;
        Ok(SystemMotion {
            at: self.clone(),
            others: self.others(),
            friction: chain.friction(&self.contact, self.inverse_r, beta),
        })
    }

    /// The response while the contact is stuck.
    ///
    /// # Errors
    /// [`StuckResonance`] on an undamped resonance of the chain with its contact stuck.
    pub fn stuck(&self) -> Result<SystemStuck<'a, S>, StuckResonance> {
        let Self {
            system, r, contact, ..
        } = self;
        system
            .reduced
            .chain
            .stuck_admitted(*r, contact, &system.invisible)?;
        Ok(SystemStuck {
            at: self.clone(),
            others: self.others(),
        })
    }
}

/// The exact continuous motion of a system.
#[derive(Clone, Debug)]
pub struct SystemMotion<'a, S = f64> {
    at: SystemAt<'a, S>,
    others: Vec<Others<S>>,
    friction: Friction<S>,
}

/// The motion of the contact or of a mass of a run-time system.
pub type SystemSteady<S = f64> = Motion<S, Damped<S>, Vec<Wave<S, Damped<S>>>>;

impl<S: Float> SystemMotion<'_, S> {
    /// The relative motion in the contact.
    #[must_use]
    pub fn contact(&self) -> SystemSteady<S> {
        let SystemAt {
            system, contact, ..
        } = &self.at;
        let carrier = system
            .reduced
            .chain
            .contact_carrier(contact, &self.friction);
        Motion::of_contact(self.friction, carrier, self.waves(|mode, _| mode.mobility))
    }

    /// The motion of a mass.
    ///
    /// # Errors
    /// [`UnknownMass`] if there is none of this name.
    pub fn mass(&self, name: &str) -> Result<SystemSteady<S>, UnknownMass> {
        let index = self.at.system.mass_index(name)?;
        self.mass_at(index)
            .ok_or_else(|| self.at.system.unknown(name))
    }

    /// The motion of a mass, by its place in the description.
    #[must_use]
    pub fn mass_at(&self, index: usize) -> Option<SystemSteady<S>> {
        let SystemAt {
            system,
            contact,
            modes,
            ..
        } = &self.at;
        let Reduced {
            modes: constants,
            chain,
            shapes,
            ..
        } = &system.reduced;
        let shape = shapes.get(index)?;
        if chain.on_moving_base.is_none() && system.modal.contact == (index, None) {
            return Some(self.contact());
        }
        let carrier = chain.carrier(
            shape,
            constants,
            modes,
            &self.others,
            contact,
            &self.friction,
        );
        let residue = |mode: &Mode<S>, component: S| component * mode.contact;
        let waves = self.waves(|mode, i| residue(mode, shape.get(i).copied().unwrap_or(mode.zeta)));
        Some(Motion::of_mass(self.friction, carrier, waves))
    }

    fn waves(&self, residue: impl Fn(&Mode<S>, usize) -> S) -> Vec<Wave<S, Damped<S>>> {
        let SystemAt {
            system,
            contact,
            modes,
            inverse_r,
            ..
        } = &self.at;
        let Reduced {
            modes: constants,
            chain,
            ..
        } = &system.reduced;
        let mut waves = Vec::with_capacity(modes.len());
        for (index, (mode, at)) in constants.iter().zip(modes).enumerate() {
            if mode.in_contact {
                let share = chain.share(
                    at,
                    residue(mode, index),
                    contact,
                    &self.friction,
                    *inverse_r,
                    index,
                );
                waves.push(motion_wave(at.x, Damped::of(mode), share));
            }
        }
        waves
    }
}

/// The response of a system while its contact is stuck.
#[derive(Clone, Debug)]
pub struct SystemStuck<'a, S = f64> {
    at: SystemAt<'a, S>,
    others: Vec<Others<S>>,
}

impl<S: Float> SystemStuck<'_, S> {
    /// The complex amplitude of a mass.
    ///
    /// # Errors
    /// [`UnknownMass`] if there is none of this name.
    pub fn mass(&self, name: &str) -> Result<Complex<S>, UnknownMass> {
        let index = self.at.system.mass_index(name)?;
        self.mass_at(index)
            .ok_or_else(|| self.at.system.unknown(name))
    }

    /// The complex amplitude of a mass, by its place in the description.
    #[must_use]
    pub fn mass_at(&self, index: usize) -> Option<Complex<S>> {
        let SystemAt {
            system,
            contact,
            modes,
            inverse_r,
            ..
        } = &self.at;
        let Reduced {
            modes: constants,
            chain,
            shapes,
            ..
        } = &system.reduced;
        let shape = shapes.get(index)?;
        Some(chain.stuck(shape, constants, modes, &self.others, contact, *inverse_r))
    }
}

impl<S: Float> StuckAt for SystemAt<'_, S> {
    fn stuck_mass(&self, index: usize) -> Result<Option<Complex<S>>, StuckResonance> {
        Ok(self.stuck()?.mass_at(index))
    }
}

impl<S: Float> FrictionSystem for System<S> {
    type Scalar = S;
    type At<'a> = SystemAt<'a, S>;

    fn resonances(&self) -> &[S] {
        &self.resonances
    }
    fn masses(&self) -> usize {
        self.scene.masses.len()
    }
    fn mass_name(&self, index: usize) -> Option<&str> {
        self.scene.masses.get(index).map(|mass| mass.name.as_str())
    }
    fn at(&self, r: S) -> Result<SystemAt<'_, S>, OutOfDomain> {
        Self::at(self, r)
    }
}

impl<S: Float> LimitsAt for SystemAt<'_, S> {
    type Scalar = S;

    fn continuous_limit(&self) -> S {
        Self::continuous_limit(self)
    }
    fn continuous_limit_without_search(&self) -> S {
        Self::continuous_limit_without_search(self)
    }
    fn continuous_limit_per_mode(&self) -> S {
        Self::continuous_limit_per_mode(self)
    }
    fn sliding_limit(&self) -> S {
        Self::sliding_limit(self)
    }
    fn regime(&self, beta: S) -> Result<Regime, OutOfDomain> {
        Self::regime(self, beta)
    }
    fn margin(&self, beta: S) -> Result<S, OutOfDomain> {
        Self::margin(self, beta)
    }
}

impl<'a, S: Float> MotionAt for SystemAt<'a, S> {
    type Motion = SystemMotion<'a, S>;

    fn motion(&self, beta: S) -> Result<SystemMotion<'a, S>, NotContinuous> {
        Self::motion(self, beta)
    }
}

impl<S: Float> ContinuousMotion for SystemMotion<'_, S> {
    type Scalar = S;

    fn ask<T>(&self, of: Of, question: impl FnOnce(&dyn Steady<Scalar = S>) -> T) -> Option<T> {
        match of {
            Of::Contact => Some(question(&self.contact())),
            Of::Mass(index) => self.mass_at(index).map(|motion| question(&motion)),
        }
    }
}

/// So that one function can use `?` on everything that a run-time system answers.
#[derive(Clone, Debug, PartialEq)]
pub enum StudyError {
    /// The description does not make a scene.
    Description(Diagnostics),
    /// An answer that a solver refuses.
    Solver(Error),
    /// A mass that is not there.
    UnknownMass(UnknownMass),
}

impl std::fmt::Display for StudyError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Description(error) => error.fmt(f),
            Self::Solver(error) => error.fmt(f),
            Self::UnknownMass(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for StudyError {}

impl From<Diagnostics> for StudyError {
    fn from(error: Diagnostics) -> Self {
        Self::Description(error)
    }
}

impl From<UnknownMass> for StudyError {
    fn from(error: UnknownMass) -> Self {
        Self::UnknownMass(error)
    }
}

impl From<Error> for StudyError {
    fn from(error: Error) -> Self {
        Self::Solver(error)
    }
}

impl From<OutOfDomain> for StudyError {
    fn from(error: OutOfDomain) -> Self {
        Self::Solver(error.into())
    }
}

impl From<NotContinuous> for StudyError {
    fn from(error: NotContinuous) -> Self {
        Self::Solver(error.into())
    }
}

impl From<StuckResonance> for StudyError {
    fn from(error: StuckResonance) -> Self {
        Self::Solver(error.into())
    }
}

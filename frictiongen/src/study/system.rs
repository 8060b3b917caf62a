//! The run-time system, which evaluates the closed forms. It stores its data in vectors, because the number of masses
//! is known only at run time.

use super::error::{InvalidScene, UnknownMass};
use super::large;
use super::start::InitialState;
use crate::{OutOfDomain, Unsupported};
use frictiongen_kernel::Float;
use frictiongen_kernel::contact::driven::DrivenModes;
use frictiongen_kernel::contact::regime::Limits;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::response::{At, Scene as _};
use frictiongen_model::modal::Modal;
use frictiongen_model::reduced::Reduced;
use frictiongen_model::scene::{FrictionLaw, Scene};
use frictiongen_model::stepping::StepperSettings;
use frictiongen_model::transient::Transient;
use frictiongen_model::validate::validate;
use frictiongen_syntax::{Diagnostics, read_with_or_without_load};
use std::sync::OnceLock;

/// A scene at run time, with its modal data. All solvers start from this type.
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
    pub(super) scene: Scene,
    /// False if the description has no field `excitation`. Only a free vibration is then possible.
    is_loaded: bool,
    pub(super) modal: Modal,
    pub(super) reduced: Reduced<S>,
    resonances: Vec<S>,
    pub(super) reference: S,
    /// The smallest and the largest 1/r at which the code evaluates the closed forms.
    pub(super) range: (S, S),
    /// True if the load acts on the mass in the contact and μ = 1. The limit of sliding β*_lim is then 1 at every
    /// frequency.
    pub(super) sliding_limit_is_one: bool,
    /// Data of the modes that the contact drives, for a fast computation of the limits without a search over the
    /// cycle. `None` if [`DrivenModes`] does not support the chain or the scalar type, for example for a damped chain.
    pub(super) driven: Option<DrivenModes<S>>,
    /// The initial state of motions to a steady state, if the user gives one.
    pub(super) start: Option<InitialState>,
    transient: OnceLock<Transient<S>>,
    steps: OnceLock<StepperSettings<S>>,
    loses_motion: OnceLock<bool>,
    exact_shapes: OnceLock<Vec<Dd>>,
    exact_shapes_in_time: OnceLock<Vec<Dd>>,
}

impl<S: Float> std::str::FromStr for System<S> {
    type Err = Diagnostics;

    fn from_str(text: &str) -> Result<Self, Diagnostics> {
        let (scene, is_loaded) = read_with_or_without_load(text)?;
        Ok(Self {
            is_loaded,
            ..Self::from_scene(scene)
        })
    }
}

impl<S: Float> TryFrom<Scene> for System<S> {
    type Error = InvalidScene;

    fn try_from(scene: Scene) -> Result<Self, InvalidScene> {
        validate(&scene).map_err(|errors| InvalidScene {
            unknown: Vec::new(),
            errors,
        })?;
        Ok(Self::from_scene(scene))
    }
}

/// Rounds a double-double number to the scalar type, with a single rounding.
pub(super) fn rounded<S: Float>(value: Dd) -> S {
    let plain = S::constant(value.hi);
    if plain.to_f64() == value.hi {
        // `plain` contains only the high part. A number type wider than `f64` also has digits for the low part.
        return plain + S::constant(value.lo);
    }
    // The high part may lie halfway between two numbers of a narrower type, such as `f32`. The sign of the low part
    // then decides. The code rounds the neighbouring `f64` number on that side, so that the result is correct.
    S::constant(match value.lo.partial_cmp(&0.0) {
        Some(std::cmp::Ordering::Greater) => value.hi.next_up(),
        Some(std::cmp::Ordering::Less) => value.hi.next_down(),
        _ => value.hi,
    })
}

impl<S: Float> System<S> {
    /// Creates the system of a valid scene.
    fn from_scene(scene: Scene) -> Self {
        let modal = large::modal(&scene);
        let modal = if scene.is_joined() {
            frictiongen_model::joined::at_rest(&scene, modal)
        } else {
            modal
        };
        Self::with_data(scene, modal.clone(), &modal, rounded::<S>)
    }

    /// Creates the system from its modal data. `data` contains these data in a number type that may have derivatives.
    /// `to` converts every number of `data` to the scalar type.
    pub(super) fn with_data<T: Float>(
        scene: Scene,
        modal: Modal,
        data: &Modal<T>,
        to: impl Fn(T) -> S,
    ) -> Self {
        let all = |values: Vec<T>| values.into_iter().map(&to).collect();
        let reduced = data.reduced(&to);
        let range = (&reduced).inverse_ratio_range();
        // β*_lim may have a derivative with respect to μ. A number type with derivatives must therefore not use the
        // constant 1.
        let chain = &reduced.chain;
        let in_phase = reduced.quadratures.is_empty();
        let sliding_limit_is_one =
            !S::CARRIES && in_phase && chain.sliding_limit_is_one(&reduced.modes);
        Self {
            scene,
            is_loaded: true,
            modal,
            driven: DrivenModes::of(&reduced.chain, &reduced.modes),
            reduced,
            range,
            sliding_limit_is_one,
            resonances: all(data.resonances.clone()),
            reference: to(data.reference),
            start: None,
            transient: OnceLock::new(),
            steps: OnceLock::new(),
            loses_motion: OnceLock::new(),
            exact_shapes: OnceLock::new(),
            exact_shapes_in_time: OnceLock::new(),
        }
    }

    /// Returns this system in double precision, without derivatives.
    pub(super) fn without_derivatives(&self) -> System {
        System::with_data(
            self.scene.clone(),
            self.modal.clone(),
            &self.modal,
            rounded::<f64>,
        )
    }

    /// Returns the modal data for motions in time. The first call computes them.
    pub(super) fn transient(&self) -> &Transient<S> {
        self.transient
            .get_or_init(|| Transient::of(&self.scene, &self.modal, rounded::<S>))
    }

    /// Returns true if a simulation in time would lose more than half of the digits. The reason is then that too many
    /// modes are at or beyond critical damping.
    pub(super) fn loses_motion(&self) -> bool {
        *self
            .loses_motion
            .get_or_init(|| self.transient().excess_loss().is_some())
    }

    /// Returns the components of all masses in the modes of the closed forms, to about 30 digits. The list begins with
    /// the components of the first mass in all modes. The first call computes the list.
    pub(super) fn exact_shapes(&self) -> &[Dd] {
        self.exact_shapes
            .get_or_init(|| self.modal.reduced(|value| value).shapes)
    }

    /// Returns the components of all masses in the modes of motions in time, to about 30 digits.
    /// [`exact_shapes`](Self::exact_shapes) returns the same numbers in another order of the modes.
    pub(super) fn exact_shapes_in_time(&self) -> &[Dd] {
        self.exact_shapes_in_time
            .get_or_init(|| Transient::of(&self.scene, &self.modal, |value| value).shapes)
    }

    /// Returns the settings of a stepper in which a force can act on every mass.
    pub(super) fn steps(&self) -> &StepperSettings<S> {
        let masses = 0..self.scene.masses.len();
        self.steps
            .get_or_init(|| StepperSettings::of(&self.scene, &self.modal, masses, rounded::<S>))
    }

    /// Returns a description of the scene as text. This also works for a scene that was built in code, fitted or
    /// changed. The description has no comments. Parsing it gives an equal scene, with the same numbers to the last
    /// bit.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: frictiongen::System = "struct Block {
    ///     masses: { block: 2.0 },
    ///     springs: { base - block: 50.0 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let softer = block.with_value(block.tunable_named("k base - block")?, 20.0)?;
    /// assert!(softer.description().contains("springs: { base - block: 20.0 },"));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn description(&self) -> String {
        let text = frictiongen_syntax::written(&self.scene);
        if self.is_loaded {
            return text;
        }
        let lines = text.split_inclusive('\n');
        let lines = lines.filter(|line| !line.trim_start().starts_with("excitation:"));
        lines.collect()
    }

    /// Returns the scene of this system, as text or code describes it.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Returns the modal analysis of the system: natural frequencies, mode shapes and damping ratios. For up to 64
    /// masses its numbers have about 30 digits. For more masses they are in double precision. Natural frequencies then
    /// have a relative error of about 1e-13. Mode shapes then have an error of about 1e-13, divided by the relative
    /// distance between neighbouring natural frequencies.
    #[must_use]
    pub fn modal(&self) -> &Modal {
        &self.modal
    }

    /// Returns the natural frequencies ω_i in rad/s, in ascending order, from the masses and stiffnesses of the scene
    /// description.
    #[must_use]
    pub fn natural_frequencies(&self) -> Vec<S> {
        self.modal
            .natural_frequencies()
            .into_iter()
            .map(rounded)
            .collect()
    }

    /// Returns √λ_i, the frequency ratios of the undamped resonances, in ascending order.
    #[must_use]
    pub fn resonances(&self) -> &[S] {
        &self.resonances
    }

    /// Returns the mode shapes φ with φᵀΓφ = 1, where Γ is the mass matrix divided by m₁. The outer list has one entry
    /// for each mode, and the inner list one for each mass.
    #[must_use]
    pub fn mode_shapes(&self) -> Vec<Vec<S>> {
        let shapes = self.modal.shapes.iter();
        shapes
            .map(|shape| shape.iter().map(|value| rounded(*value)).collect())
            .collect()
    }

    /// Converts an angular frequency in rad/s to r = ω√(m₁/k₁).
    #[must_use]
    pub fn frequency_ratio(&self, omega: S) -> S {
        omega / self.reference
    }

    /// Returns the friction ratio β = F/P for the friction force F and the amplitude P of the load. For base motion of
    /// amplitude Y, pass k₁Y as `load`.
    #[must_use]
    pub fn friction_ratio(&self, friction: S, load: S) -> S {
        friction / load
    }

    /// Returns an upper bound on β_lim, and the exact β*_lim (6.11, 6.27, 6.33), without a search over time. In place
    /// of the maximum S of the velocity constraint, the bound uses the limit of the constraint for τ → 0 (5.64). If no
    /// other result is needed at this r, this call is the fastest.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r. At r = 0 and r = ∞ the call returns the limit values. [`OutOfDomain`]
    /// also for `friction: stribeck`, and for a scene with several contacts or dashpots. The exact continuous response
    /// requires one contact, with a kinetic friction force that does not depend on the speed.
    pub fn limits_without_search(&self, r: S) -> Result<Limits<S>, OutOfDomain> {
        self.constant_force()?;
        At::limits_without_search(&self, r)
    }

    /// Returns the threshold β_n,i of every resonance i (6.2, 6.26). If β is below this threshold, the amplitude at
    /// the undamped resonance is unbounded. The entry is `None` for a mode that the contact does not drive, and for a
    /// scene with `contacts` or `dampers`. The thresholds hold for a constant kinetic friction force F.
    #[must_use]
    pub fn resonance_thresholds(&self) -> Vec<Option<S>> {
        if self.scene.is_joined() {
            return vec![None; self.resonances.len()];
        }
        // At large amplitudes, an elastic contact dissipates as much energy in a cycle as a rigid contact. The
        // thresholds of both contacts are therefore the same.
        self.modal
            .resonance_thresholds()
            .into_iter()
            .map(|value| value.map(rounded))
            .collect()
    }

    /// Returns the displacement x̄ of every mass for the frequency ratio r → 0, at the friction ratio β (6.5). Returns
    /// `None` if the contact is stuck at r = 0, and for an elastic contact.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let chain: frictiongen::System = "struct Chain {
    ///     masses: { first: 1, second: 1, third: 1 },
    ///     springs: { base - first: 1, first - second: 1, second - third: 1 },
    ///     contact: second - wall,
    ///     excitation: first,
    /// }"
    /// .parse()?;
    /// let start = chain.quasi_static_start(0.3).ok_or("stuck")?;
    /// assert!((start[0] - 0.7).abs() < 1e-15 && (start[2] - 0.4).abs() < 1e-15);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn quasi_static_start(&self, beta: S) -> Option<Vec<S>> {
        self.rigid().ok()?;
        let start = self.modal.quasi_static_start(Dd::from(beta.to_f64()))?;
        Some(start.into_iter().map(rounded).collect())
    }

    /// Returns the peak amplitude |x̄| of a mass at a damped resonance, estimated for small ζ (7.60). `mode` is the
    /// index of the resonance in ascending order, and `mass` the index in the scene description. Returns `None` for a
    /// mode without damping, and for an elastic contact.
    #[must_use]
    pub fn resonant_peak_estimate(&self, mode: usize, mass: usize, beta: S) -> Option<S> {
        self.rigid().ok()?;
        let beta = Dd::from(beta.to_f64());
        self.modal
            .resonant_peak_estimate(mode, mass, beta)
            .map(rounded)
    }

    /// Returns β_lim and β*_lim for the frequency ratio r → ∞ (6.28). For a rigid contact on a moving base the two
    /// limits are infinite. For an elastic contact of stiffness k, β_lim is 0. Its β*_lim is k/(μk₁) on a moving base,
    /// and otherwise 0. A scene with `contacts` or `dampers` has no closed form of these limits, and they are NaN.
    #[must_use]
    pub fn high_frequency_limits(&self) -> (S, S) {
        if self.scene.is_joined() {
            return (S::constant(f64::NAN), S::constant(f64::NAN));
        }
        let ends = &self.reduced.ends;
        (ends.continuous_at_infinity, ends.sliding_at_infinity)
    }

    /// Fails if the description has no field `excitation`.
    pub(crate) fn loaded(&self) -> Result<(), Unsupported> {
        match self.is_loaded {
            true => Ok(()),
            false => Err(Unsupported::NoExcitation),
        }
    }

    /// Fails if the scene has several contacts or dashpots.
    pub(crate) fn single(&self) -> Result<(), Unsupported> {
        if self.scene.is_joined() {
            Err(Unsupported::SeveralContacts)
        } else {
            Ok(())
        }
    }

    /// Fails if the contact is elastic, or if the scene has several contacts or dashpots.
    pub(crate) fn rigid(&self) -> Result<(), OutOfDomain> {
        self.single()?;
        match self.scene.stiffness {
            None => Ok(()),
            Some(_) => Err(Unsupported::ElasticContact.into()),
        }
    }

    /// Fails if the kinetic friction force depends on the speed, if the scene has several contacts or dashpots, or if it
    /// has no excitation. The closed forms and the motion from event to event require one contact with a constant kinetic
    /// friction force, and a load.
    pub(super) fn constant_force(&self) -> Result<(), OutOfDomain> {
        self.single()?;
        self.loaded()?;
        match self.scene.friction {
            FrictionLaw::Coulomb => Ok(()),
            FrictionLaw::Stribeck(_) => Err(Unsupported::FrictionLaw.into()),
        }
    }

    pub(super) fn mass_index(&self, name: &str) -> Result<usize, UnknownMass> {
        self.scene
            .masses
            .iter()
            .position(|mass| mass.name == name)
            .ok_or_else(|| self.unknown(name))
    }

    pub(super) fn unknown(&self, name: &str) -> UnknownMass {
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

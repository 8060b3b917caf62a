//! Systems whose results have derivatives. To compute them, the code evaluates the formulas with dual numbers.

use super::at::SystemAt;
use super::orbit::SystemOrbit;
use super::parameter::quantities;
use super::system::System;
use crate::OutOfDomain;
use crate::system::FrictionSystem;
use frictiongen_kernel::motion::Part;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::orbit::{self, CarryingStorage, NoDerivative, Orbit};
use frictiongen_kernel::{Float, Scalar};
use frictiongen_model::modal::Modal;

use frictiongen_model::sensitivity::Quantity;
use frictiongen_model::stepping::StepperSettings;
use frictiongen_model::transient::Transient;
use std::sync::OnceLock;

/// A number with its derivative, each with about 30 digits. A [`Varied`] system uses such numbers, so that its
/// derivatives have enough digits close to a resonance.
pub type Sensitive = Dual<Dd>;

/// A system whose results have derivatives with respect to one quantity of the scene description.
///
/// For derivatives with respect to r or β, pass `Dual::variable` to an [`unvaried`](System::unvaried) system. In all
/// other derivatives r and β are constant. For derivatives at a constant angular frequency, pass r from
/// [`frequency_ratio`](Self::frequency_ratio). This r varies with the first mass and the first spring.
///
/// ```
/// use frictiongen::study::{System, sensitivity::{Quantity, Sensitive}};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let frame: System = "struct Frame {
///     masses: { lower: 3.27, upper: 3.25 },
///     springs: { base - lower: 1190.0, lower - upper: 1323.0 },
///     contact: upper - wall,
///     excitation: base,
///     damping: modal[0.010, 0.012],
/// }"
/// .parse()?;
/// let heavier = frame.along(Quantity::Mass(1)).ok_or("no such mass")?;
/// let limit = heavier.at(Sensitive::fixed(0.9.into()))?.continuous_limit();
/// // One more gram changes the limit by a thousandth of the derivative.
/// let mut scene = frame.scene().clone();
/// scene.masses[1].value = 3.251;
/// let moved = System::<f64>::try_from(scene)?.at(0.9)?.continuous_limit();
/// let expected = limit.value.to_f64() + 0.001 * limit.slope.to_f64();
/// assert!((moved - expected).abs() < 1e-6 * moved);
/// # Ok(())
/// # }
/// ```
///
/// Derivatives exist for steady states with stops ([`orbit`](Self::orbit)) and for steppers
/// ([`stepper`](Self::stepper)) too. Simulations in time have no derivatives.
#[derive(Clone, Debug)]
pub struct Varied {
    system: System<Sensitive>,
    data: Modal<Sensitive>,
    /// The system without derivatives. The first use computes it.
    plain: OnceLock<System>,
    /// The data for motions in time, with derivatives, or `None` if these derivatives do not exist. The first use
    /// computes the data.
    transient: OnceLock<Option<Transient<Sensitive>>>,
    /// The quantity with respect to which the results have derivatives. `None` for derivatives with respect to r or β.
    pub(super) quantity: Option<Quantity>,
    /// The settings of a stepper with derivatives. The first use computes them.
    pub(super) steps: OnceLock<StepperSettings<Sensitive>>,
}

impl Varied {
    /// Returns the system at the frequency ratio r.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r, for `friction: stribeck`, and for a scene with several contacts or
    /// dashpots.
    pub fn at(&self, r: Sensitive) -> Result<SystemAt<'_, Sensitive>, OutOfDomain> {
        self.system.at(r)
    }

    /// Converts an angular frequency in rad/s to the frequency ratio r = ω√(m₁/k₁).
    #[must_use]
    pub fn frequency_ratio(&self, omega: Sensitive) -> Sensitive {
        self.system.frequency_ratio(omega)
    }

    /// Returns the steady state that the motion from rest reaches at r and β, in any regime. Every result of the steady
    /// state has a derivative.
    ///
    /// The results are amplitudes, phases, harmonics, displacements at an instant, and the times and durations of
    /// stops. The search finds the steady state without derivatives. One more pass over the period with dual numbers
    /// then gives the derivatives. The Floquet multipliers have no derivatives.
    ///
    /// An amplitude and a phase have a derivative if the steady state has one. If the contact stops at its largest
    /// displacement, the phase of the contact belongs to the beginning of the stop.
    ///
    /// ```
    /// use frictiongen::study::{System, sensitivity::{Quantity, Sensitive}};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// // The contact stops twice a cycle.
    /// let beta = Sensitive::variable(0.4.into());
    /// let varied = block.unvaried();
    /// let orbit = varied.orbit(Sensitive::fixed(0.3.into()), beta)?;
    /// let amplitude = orbit.mass("block")?.amplitude();
    /// let at = block.at(0.3)?;
    /// let amplitude_at = |beta| Some(at.orbit(beta).ok()?.mass("block").ok()?.amplitude());
    /// let amplitudes = [0.4 - 1e-5, 0.4 + 1e-5].map(amplitude_at);
    /// if let [Some(below), Some(above)] = amplitudes {
    ///     assert!((amplitude.slope.to_f64() - (above - below) / 2e-5).abs() < 1e-9);
    /// }
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`NoDerivative`] if no steady state exists, or if the motion does not repeat. [`NoDerivative`] also if the
    /// steady state belongs to a continuum, and if a stop or reversal is about to appear or disappear.
    pub fn orbit(
        &self,
        r: Sensitive,
        beta: Sensitive,
    ) -> Result<SystemOrbit<'_, Sensitive>, NoDerivative> {
        let plain = self.plain();
        let orbit = plain.at(r.value.to_f64())?.orbit(beta.value.to_f64())?;
        self.orbit_along(&orbit, r, beta)
    }

    /// Adds derivatives to a known steady state of the same scene, as [`orbit`](Self::orbit) does. The values of r and
    /// β must be those of the known steady state.
    ///
    /// # Errors
    /// [`NoDerivative`] in the same cases as [`orbit`](Self::orbit).
    pub fn orbit_along(
        &self,
        plain: &SystemOrbit<'_>,
        r: Sensitive,
        beta: Sensitive,
    ) -> Result<SystemOrbit<'_, Sensitive>, NoDerivative> {
        let transient = self.transient().ok_or(NoDerivative::Degenerate)?;
        let dynamics = transient.contact_dynamics();
        let zero = Sensitive::constant(0.0);
        let (modes, size) = (dynamics.modes.len(), dynamics.state_size());
        let orbit = Orbit::carrying(
            &plain.orbit,
            dynamics,
            (r, beta),
            CarryingStorage {
                parts: vec![Part::empty(); dynamics.oscillators()],
                numbers: vec![zero; orbit::numbers_of(modes, size)],
                masses: &mut vec![zero; 2 * modes],
                multipliers: Vec::new(),
            },
        )?;
        Ok(SystemOrbit {
            system: &self.system,
            orbit,
            from_rest: plain.from_rest,
            unsettled: plain.unsettled,
            slides: false,
        })
    }

    /// Returns the system with its numbers and their derivatives rounded to double precision.
    #[cfg(feature = "measure")]
    pub(super) fn rounded(&self) -> System<Dual<f64>> {
        let (scene, modal) = (self.system.scene().clone(), self.system.modal.clone());
        System::with_data(scene, modal, &self.data, rounded)
    }

    /// Returns the system without derivatives.
    pub(super) fn plain(&self) -> &System {
        self.plain.get_or_init(|| self.system.without_derivatives())
    }

    /// Returns the system with derivatives.
    pub(super) fn system(&self) -> &System<Sensitive> {
        &self.system
    }

    /// Returns the data for motions in time, with derivatives. Returns `None` if a single mode has no derivative. One
    /// reason is that several modes have the same frequency, and a change of the varied quantity separates them.
    /// [`Transient::along`] lists all reasons.
    pub(super) fn transient(&self) -> Option<&Transient<Sensitive>> {
        let transient = self
            .transient
            .get_or_init(|| Transient::along(self.system.scene(), &self.data, |value| value));
        transient.as_ref()
    }

    /// Returns the modal data with derivatives, for resonances, mode shapes, resonance thresholds, and the limits for
    /// r = 0 and r → ∞.
    #[must_use]
    pub fn modal(&self) -> &Modal<Sensitive> {
        &self.data
    }
}

/// Rounds a number and its derivative to double precision.
pub(super) fn rounded(number: Sensitive) -> Dual<f64> {
    Dual {
        value: number.value.to_f64(),
        slope: number.slope.to_f64(),
    }
}

impl FrictionSystem for Varied {
    type Scalar = Sensitive;
    type At<'a> = SystemAt<'a, Sensitive>;

    fn resonances(&self) -> &[Sensitive] {
        self.system.resonances()
    }
    fn masses(&self) -> usize {
        self.system.masses()
    }
    fn mass_name(&self, index: usize) -> Option<&str> {
        self.system.mass_name(index)
    }
    fn at(&self, r: Sensitive) -> Result<SystemAt<'_, Sensitive>, OutOfDomain> {
        self.system.at(r)
    }
}

impl<S: Float> System<S> {
    /// Returns this system with derivatives with respect to `quantity`. Returns `None` if the scene does not have this
    /// quantity.
    #[must_use]
    pub fn along(&self, quantity: Quantity) -> Option<Varied> {
        let data = self.modal.along(&self.scene, quantity)?;
        Some(self.varied(data, Some(quantity)))
    }

    /// Returns this system without a varied quantity, for derivatives with respect to r or β.
    #[must_use]
    pub fn unvaried(&self) -> Varied {
        self.varied(self.modal.fixed(), None)
    }

    fn varied(&self, data: Modal<Sensitive>, quantity: Option<Quantity>) -> Varied {
        let system =
            System::with_data(self.scene.clone(), self.modal.clone(), &data, |value| value);
        Varied {
            system,
            data,
            plain: OnceLock::new(),
            transient: OnceLock::new(),
            quantity,
            steps: OnceLock::new(),
        }
    }

    /// Returns a result and its derivative with respect to every quantity of the scene description, in the unit of that
    /// quantity. `question` computes the result from a [`Varied`] system.
    ///
    /// # Errors
    /// The first error that `question` returns.
    ///
    /// ```
    /// use frictiongen::study::{System, sensitivity::{Quantity, Sensitive}};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 2.0 },
    ///     springs: { base - block: 50.0 },
    ///     contact: block - wall,
    ///     excitation: block,
    ///     stiction: 1.1,
    /// }"
    /// .parse()?;
    /// // A single mass sticks permanently beyond β = 1/μ, whatever its mass.
    /// let gradient = block.sensitivities(|block| {
    ///     let r = block.frequency_ratio(Sensitive::fixed(3.0.into()));
    ///     Ok::<_, frictiongen::OutOfDomain>(block.at(r)?.sliding_limit())
    /// })?;
    /// let of = |quantity| gradient.iter().find(|(found, _)| *found == quantity);
    /// assert!(of(Quantity::Mass(0)).is_some_and(|(_, limit)| limit.slope.abs() < 1e-15));
    /// assert!(of(Quantity::Stiction).is_some_and(|(_, limit)| limit.slope < 0.0));
    /// # Ok(())
    /// # }
    /// ```
    pub fn sensitivities<E>(
        &self,
        question: impl Fn(&Varied) -> Result<Sensitive, E>,
    ) -> Result<Vec<(Quantity, Dual<f64>)>, E> {
        let mut gradient = Vec::new();
        for quantity in quantities(&self.scene) {
            if let Some(varied) = self.along(quantity) {
                gradient.push((quantity, rounded(question(&varied)?)));
            }
        }
        Ok(gradient)
    }
}

//! Conversions between physical units and non-dimensional groups: hertz and r, newtons and β, metres and x̄.
//!
//! The units are those of the scene. With masses in kg and stiffnesses in N/m, a force is in N, a length in m and an
//! angular frequency in rad/s. The groups refer to the first mass m₁ and the first spring k₁ of the scene description.
//! Another order of masses or springs therefore gives other groups, but the same physical results.

pub use super::error::LoadError;
use super::system::System;
use crate::Complex;
use frictiongen_kernel::Float;
use frictiongen_model::scene::Excitation;

/// The load of a scene, given by its amplitude. It is a force on a mass, or a motion of the base.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Load<S = f64> {
    /// The load is a force P cos ωt on a mass. The field is its amplitude P, in N in SI units.
    Force(S),
    /// The load is a motion Y cos ωt of the base. The field is its amplitude Y, in m in SI units.
    Base(S),
    /// Base motion whose velocity has the amplitude v at every frequency. The field is v, in m/s in SI units. The
    /// amplitude of the base motion is Y = v/ω.
    BaseVelocity(S),
    /// Base motion whose acceleration has the amplitude a at every frequency. The field is a, in m/s² in SI units. The
    /// amplitude of the base motion is Y = a/ω².
    BaseAcceleration(S),
    /// Unbalance of a rotor. The field is m·e, mass times eccentricity, in kg·m in SI units. The unbalance causes a
    /// force of amplitude P = m·e·ω².
    Unbalance(S),
}

impl<S: Copy> Load<S> {
    /// Returns the number that describes the load, in the unit of this load. It is for example P of a force, or Y of a
    /// base motion.
    #[must_use]
    pub fn amplitude(&self) -> S {
        match self {
            Self::Force(amplitude)
            | Self::Base(amplitude)
            | Self::BaseVelocity(amplitude)
            | Self::BaseAcceleration(amplitude)
            | Self::Unbalance(amplitude) => *amplitude,
        }
    }

    /// Returns the same load with its number converted by a function.
    pub(super) fn map<T>(self, convert: impl FnOnce(S) -> T) -> Load<T> {
        match self {
            Self::Force(amplitude) => Load::Force(convert(amplitude)),
            Self::Base(amplitude) => Load::Base(convert(amplitude)),
            Self::BaseVelocity(amplitude) => Load::BaseVelocity(convert(amplitude)),
            Self::BaseAcceleration(amplitude) => Load::BaseAcceleration(convert(amplitude)),
            Self::Unbalance(amplitude) => Load::Unbalance(convert(amplitude)),
        }
    }

    /// Returns a reference to the number that describes the load, so that the caller can change the number.
    pub(super) fn amplitude_mut(&mut self) -> &mut S {
        match self {
            Self::Force(amplitude)
            | Self::Base(amplitude)
            | Self::BaseVelocity(amplitude)
            | Self::BaseAcceleration(amplitude)
            | Self::Unbalance(amplitude) => amplitude,
        }
    }

    /// Returns true if the load is a motion of the base.
    #[must_use]
    pub fn is_base_motion(&self) -> bool {
        !matches!(self, Self::Force(_) | Self::Unbalance(_))
    }

    /// Returns the exponent n of the load, whose amplitude P or Y is proportional to ω⁻ⁿ. For a constant amplitude n
    /// is 0.
    #[must_use]
    pub fn fall(&self) -> i32 {
        match self {
            Self::Force(_) | Self::Base(_) => 0,
            Self::BaseVelocity(_) => 1,
            Self::BaseAcceleration(_) => 2,
            Self::Unbalance(_) => -2,
        }
    }
}

impl<S: Float> Load<S> {
    /// Returns the load at one angular frequency ω in rad/s, as a force P or a base motion Y.
    ///
    /// ```
    /// use frictiongen::study::units::Load;
    ///
    /// // A base acceleration of 2 m/s² at ω = 10 rad/s is a motion of 20 mm.
    /// assert_eq!(Load::BaseAcceleration(2.0).at(10.0), Load::Base(0.02));
    /// ```
    #[must_use]
    pub fn at(&self, omega: S) -> Self {
        match *self {
            Self::BaseVelocity(velocity) => Self::Base(velocity / omega),
            Self::BaseAcceleration(acceleration) => Self::Base(acceleration / (omega * omega)),
            Self::Unbalance(unbalance) => Self::Force(unbalance * (omega * omega)),
            constant => constant,
        }
    }
}

/// The units of length and force under a load. They convert non-dimensional results to physical results (see
/// [`System::load_scale`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadScale<S = f64> {
    length: S,
    force: S,
}

impl LoadScale {
    /// Conversion with the unit 1 m for lengths and 1 N for forces.
    pub(super) const UNIT: Self = Self {
        length: 1.0,
        force: 1.0,
    };
}

impl<S: Float> LoadScale<S> {
    /// Returns the units of length and force of the same load after its amplitude is multiplied by a factor.
    pub(super) fn times(&self, factor: S) -> Self {
        Self {
            length: self.length * factor,
            force: self.force * factor,
        }
    }

    /// Returns the unit of length, the factor from x̄ to x: P/k₁ (Y for base motion).
    #[must_use]
    pub fn length(&self) -> S {
        self.length
    }

    /// Returns the unit of force, the factor from β, β_lim and β*_lim to forces: P (k₁Y for base motion).
    #[must_use]
    pub fn force(&self) -> S {
        self.force
    }

    /// Converts a non-dimensional displacement x̄ to a displacement x, which is a length.
    #[must_use]
    pub fn displacement(&self, ratio: S) -> S {
        ratio * self.length
    }

    /// Converts a displacement x, which is a length, to a non-dimensional displacement x̄.
    #[must_use]
    pub fn displacement_ratio(&self, displacement: S) -> S {
        displacement / self.length
    }

    /// Converts a non-dimensional velocity dx̄/dτ to a velocity dx/dt, at the angular frequency ω in rad/s.
    #[must_use]
    pub fn velocity(&self, rate: S, omega: S) -> S {
        rate * self.length * omega
    }

    /// Converts a velocity dx/dt to a non-dimensional velocity dx̄/dτ, at the angular frequency ω in rad/s.
    #[must_use]
    pub fn velocity_ratio(&self, velocity: S, omega: S) -> S {
        velocity / self.length / omega
    }

    /// Converts a friction ratio, which is β or a limit of β, to a friction force F.
    #[must_use]
    pub fn friction(&self, beta: S) -> S {
        beta * self.force
    }

    /// Converts a friction force F to a friction ratio β.
    #[must_use]
    pub fn friction_ratio(&self, friction: S) -> S {
        friction / self.force
    }
}

/// Converts a frequency in Hz to an angular frequency in rad/s.
#[must_use]
pub fn angular_frequency<S: Float>(hertz: S) -> S {
    S::constant(2.0) * S::pi() * hertz
}

/// Converts an angular frequency in rad/s to a frequency in Hz.
#[must_use]
pub fn hertz<S: Float>(omega: S) -> S {
    omega / (S::constant(2.0) * S::pi())
}

/// Converts a phase τ = ωt to a time in seconds, at the angular frequency ω in rad/s.
#[must_use]
pub fn seconds<S: Float>(tau: S, omega: S) -> S {
    tau / omega
}

/// Returns the lag of the negated motion: `lag` plus or minus π, in (−π, π].
///
/// A lag refers to the instant of the largest displacement. A rigid contact that never slides has no such instant, and
/// its phase is 0. [`SystemOrbit::reversed_contact_phase`](super::orbit::SystemOrbit::reversed_contact_phase) leaves
/// this phase unchanged.
#[must_use]
pub fn reversed_phase<S: Float>(lag: S) -> S {
    if S::constant(0.0) < lag {
        lag - S::pi()
    } else {
        lag + S::pi()
    }
}

/// Returns the lag of the fundamental component X₁ of a motion, in rad, in (−π, π]. `centred` is the centred amplitude
/// of the motion. Returns `None` if X₁ is 0 or consists only of rounding errors.
#[must_use]
pub fn fundamental_phase(x1: Complex<f64>, centred: f64) -> Option<f64> {
    let (size, lag) = polar(x1);
    (1e-12 * centred < size && centred != 0.0).then_some(lag)
}

/// Returns the amplitude |X| of Re X e^{iτ}, and its lag −arg X behind cos τ, in rad, in (−π, π].
#[must_use]
pub fn polar(x: Complex<f64>) -> (f64, f64) {
    let lag = -x.im.atan2(x.re);
    let half_turn = std::f64::consts::PI;
    (
        x.re.hypot(x.im),
        if lag == -half_turn { half_turn } else { lag },
    )
}

impl<S: Float> System<S> {
    /// Returns the units of length and force that a load gives to the non-dimensional results. If the amplitude of the
    /// load depends on frequency, the units are those at r = 1. [`load_scale_at`](Self::load_scale_at) returns those at
    /// another r.
    ///
    /// ```
    /// use frictiongen::study::{System, units::Load};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let system: System = "struct Block {
    ///     masses: { block: 2.0 },            // kg
    ///     springs: { base - block: 50.0 },   // N/m
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let scale = system.load_scale(Load::Force(10.0))?;           // N
    /// let at = system.at(system.frequency_ratio_at_hertz(1.2))?;
    /// let motion = at.motion(scale.friction_ratio(2.0))?;          // N
    /// let metres = scale.displacement(motion.mass("block")?.amplitude());
    /// let newtons = scale.friction(at.continuous_limit());
    /// assert!((metres - 0.15029).abs() < 1e-5 && (newtons - 6.45338).abs() < 1e-5);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`LoadError`] for a force if the base moves, and for a base motion if a force drives a mass. [`LoadError`] also
    /// for an amplitude that is 0, negative, infinite or NaN, and if P/k₁ or k₁Y is out of the scalar's range.
    pub fn load_scale(&self, load: Load<S>) -> Result<LoadScale<S>, LoadError> {
        self.load_scale_at(load, S::constant(1.0))
    }

    /// Checks that a load is of the kind that excites the scene: a force on a mass, or a motion of the base.
    pub(crate) fn fits(&self, load: Load<S>) -> Result<(), LoadError> {
        match self.scene.excitation {
            Excitation::Base if !load.is_base_motion() => Err(LoadError::DrivenByBase),
            Excitation::Force(index) if load.is_base_motion() => {
                let mass = self.scene.masses.get(index);
                let name = mass.map_or_else(String::new, |mass| mass.name.clone());
                Err(LoadError::DrivenByForce(name))
            }
            _ => Ok(()),
        }
    }

    /// Returns the units of length and force of a load at the frequency ratio r.
    ///
    /// # Errors
    /// Same errors as [`load_scale`](Self::load_scale).
    pub fn load_scale_at(&self, load: Load<S>, r: S) -> Result<LoadScale<S>, LoadError> {
        let usable = |value: S| value > S::constant(0.0) && value.is_finite();
        self.fits(load)?;
        if !usable(load.amplitude()) {
            return Err(LoadError::Amplitude);
        }
        let base_moves = self.scene.excitation == Excitation::Base;
        let stiffness = S::constant(self.scene.first_stiffness());
        let amplitude = load.at(self.angular_frequency(r)).amplitude();
        let scale = if base_moves {
            LoadScale {
                length: amplitude,
                force: stiffness * amplitude,
            }
        } else {
            LoadScale {
                length: amplitude / stiffness,
                force: amplitude,
            }
        };
        if usable(scale.length) && usable(scale.force) {
            Ok(scale)
        } else {
            Err(LoadError::OutOfRange)
        }
    }

    /// Returns the units of length and force of a load of constant amplitude.
    ///
    /// # Errors
    /// Same errors as [`load_scale`](Self::load_scale). [`LoadError::Varies`] for a load whose amplitude depends on
    /// frequency.
    pub fn constant_scale(&self, load: Load<S>) -> Result<LoadScale<S>, LoadError> {
        match load.fall() {
            0 => self.load_scale(load),
            _ => self.load_scale(load).and(Err(LoadError::Varies)),
        }
    }

    /// Converts a frequency in Hz to the frequency ratio r.
    #[must_use]
    pub fn frequency_ratio_at_hertz(&self, hertz: S) -> S {
        self.frequency_ratio(angular_frequency(hertz))
    }

    /// Converts the frequency ratio r to the angular frequency ω in rad/s.
    #[must_use]
    pub fn angular_frequency(&self, r: S) -> S {
        r * self.reference
    }

    /// Converts the frequency ratio r to a frequency in Hz.
    #[must_use]
    pub fn hertz(&self, r: S) -> S {
        hertz(self.angular_frequency(r))
    }

    /// Returns true if the contact's relative motion has opposite signs in the results and in the scene description.
    ///
    /// A contact `a - b` in a description is the motion of b relative to a. The results contain the motion of the mass
    /// listed later relative to the mass listed earlier. If these two motions have opposite signs, their phases differ
    /// by half a turn ([`reversed_phase`]). A contact of one mass with a support is never reversed, because the
    /// results contain the motion of the mass.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let system = |masses| -> Result<frictiongen::System, _> {
    ///     format!(
    ///         "struct Pair {{ masses: {{ {masses} }}, springs: {{ base - a: 1, a - b: 1 }},
    ///          contact: a - b, excitation: base }}"
    ///     )
    ///     .parse()
    /// };
    /// assert!(!system("a: 1, b: 2")?.contact_is_reversed());
    /// assert!(system("b: 2, a: 1")?.contact_is_reversed());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn contact_is_reversed(&self) -> bool {
        self.scene.contact.is_reversed()
    }
}

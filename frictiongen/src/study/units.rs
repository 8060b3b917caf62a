//! Physical units beside the dimensionless groups: hertz beside r, newtons and metres beside β and x̄.
//!
//! Units are the scene's own. With masses in kg and stiffnesses in N/m a force is in N, a length in m and an
//! angular frequency in rad/s. The groups refer to the first mass m₁ and the first spring k₁ of the description, so
//! another order of masses or springs gives other groups. What is physical stays the same.

pub use super::error::LoadError;
use super::system::System;
use crate::Complex;
use frictiongen_kernel::Float;
use frictiongen_model::scene::{Excitation, Node};

/// The amplitude of the load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Load<S = f64> {
    /// P, of a force P cos ωt on a mass: N in SI.
    Force(S),
    /// Y, of a motion Y cos ωt of the base: m in SI.
    Base(S),
}

impl<S: Copy> Load<S> {
    /// P or Y.
    #[must_use]
    pub fn amplitude(&self) -> S {
        match self {
            Self::Force(amplitude) | Self::Base(amplitude) => *amplitude,
        }
    }
}

/// What a load makes of the dimensionless answers: see [`System::load_scale`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadScale<S = f64> {
    length: S,
    force: S,
}

impl<S: Float> LoadScale<S> {
    /// The unit of x̄: P/k₁, for base motion Y.
    #[must_use]
    pub fn length(&self) -> S {
        self.length
    }

    /// The unit of β and of both limits: P, for base motion k₁Y.
    #[must_use]
    pub fn force(&self) -> S {
        self.force
    }

    /// x̄ → x, a length.
    #[must_use]
    pub fn displacement(&self, ratio: S) -> S {
        ratio * self.length
    }

    /// x, a length → x̄.
    #[must_use]
    pub fn displacement_ratio(&self, displacement: S) -> S {
        displacement / self.length
    }

    /// dx̄/dτ → dx/dt, a velocity, at the angular frequency ω in rad/s.
    #[must_use]
    pub fn velocity(&self, rate: S, omega: S) -> S {
        rate * self.length * omega
    }

    /// dx/dt → dx̄/dτ, at the angular frequency ω in rad/s.
    #[must_use]
    pub fn velocity_ratio(&self, velocity: S, omega: S) -> S {
        velocity / self.length / omega
    }

    /// β, or a limit of it → the friction force F.
    #[must_use]
    pub fn friction(&self, beta: S) -> S {
        beta * self.force
    }

    /// The friction force F → β.
    #[must_use]
    pub fn friction_ratio(&self, friction: S) -> S {
        friction / self.force
    }
}

/// Hz → rad/s.
#[must_use]
pub fn angular_frequency<S: Float>(hertz: S) -> S {
    S::constant(2.0) * S::pi() * hertz
}

/// rad/s → Hz.
#[must_use]
pub fn hertz<S: Float>(omega: S) -> S {
    omega / (S::constant(2.0) * S::pi())
}

/// τ → seconds, at the angular frequency ω in rad/s.
#[must_use]
pub fn seconds<S: Float>(tau: S, omega: S) -> S {
    tau / omega
}

/// The lag of a motion → that of the motion with the opposite sign, half a turn away, in (−π, π].
///
/// A steady state whose contact stops where it is farthest is farthest all along a stop:
/// [`SystemOrbit::reversed_contact_phase`](super::SystemOrbit::reversed_contact_phase) knows of that.
#[must_use]
pub fn reversed_phase<S: Float>(lag: S) -> S {
    if S::constant(0.0) < lag {
        lag - S::pi()
    } else {
        lag + S::pi()
    }
}

/// The lag of the fundamental component X₁ of a motion of this centred amplitude, rad, in (−π, π]; none for what does not
/// move but by rounding.
#[must_use]
pub fn fundamental_phase(x1: Complex<f64>, centred: f64) -> Option<f64> {
    let (size, lag) = polar(x1);
    (1e-12 * centred < size && centred != 0.0).then_some(lag)
}

/// X → |X| and −arg X in (−π, π]: the amplitude of Re X e^{iτ}, and its lag behind cos τ.
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
    /// The units of length and force that a load gives to the answers.
    ///
    /// ```
    /// use frictiongen::study::{Load, System};
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
    /// [`LoadError`] for a force where the base moves and a base motion where a force drives a mass, for an
    /// amplitude that is not above 0 and finite, and where P/k₁ or k₁Y leaves the scalar's range.
    pub fn load_scale(&self, load: Load<S>) -> Result<LoadScale<S>, LoadError> {
        let usable = |value: S| value > S::constant(0.0) && value.is_finite();
        let (Load::Force(amplitude) | Load::Base(amplitude)) = load;
        match (load, self.scene.excitation) {
            (Load::Force(_), Excitation::Base) => return Err(LoadError::DrivenByBase),
            (Load::Base(_), Excitation::Force(index)) => {
                let mass = self.scene.masses.get(index);
                let name = mass.map_or_else(String::new, |mass| mass.name.clone());
                return Err(LoadError::DrivenByForce(name));
            }
            _ if !usable(amplitude) => return Err(LoadError::Amplitude),
            _ => {}
        }
        // A scene has a spring.
        let first = self.scene.springs.first();
        let stiffness = S::constant(first.map_or(1.0, |spring| spring.stiffness));
        let scale = match load {
            Load::Force(force) => LoadScale {
                length: force / stiffness,
                force,
            },
            Load::Base(length) => LoadScale {
                length,
                force: stiffness * length,
            },
        };
        if usable(scale.length) && usable(scale.force) {
            Ok(scale)
        } else {
            Err(LoadError::OutOfRange)
        }
    }

    /// Hz → r.
    #[must_use]
    pub fn frequency_ratio_at_hertz(&self, hertz: S) -> S {
        self.frequency_ratio(angular_frequency(hertz))
    }

    /// r → ω in rad/s.
    #[must_use]
    pub fn angular_frequency(&self, r: S) -> S {
        r * self.reference
    }

    /// r → Hz.
    #[must_use]
    pub fn hertz(&self, r: S) -> S {
        hertz(self.angular_frequency(r))
    }

    /// Whether the relative motion between two masses has the opposite sign of what the contact says: `a - b` is the
    /// motion of b relative to a, the answers are that of the mass listed later relative to the earlier one. A phase
    /// differs by half a turn ([`reversed_phase`]). Never so for a contact of one mass, whose own motion counts.
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
        let contact = self.scene.contact;
        matches!((contact.from, contact.to), (Node::Mass(from), Node::Mass(to)) if from > to)
    }
}

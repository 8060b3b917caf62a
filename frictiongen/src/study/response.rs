//! The steady response in whatever regime: closed form, steady state with stops, or stuck.

use super::at::SystemAt;
use super::motion::{SystemMotion, SystemStuck};
use super::orbit::SystemOrbit;
use super::system::System;
use super::units::{polar, reversed_phase};
use crate::{Complex, Error, NotContinuous, Of, OutOfDomain, Regime};
use frictiongen_kernel::response::Scene as _;

/// The steady response of a system at one frequency ratio and one friction ratio.
///
/// ```
/// use frictiongen::{Of, Regime, System};
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
/// let at = frame.at(0.9)?;
/// for (beta, regime) in [(0.3, Regime::Continuous), (0.7, Regime::StickSlip), (1.0, Regime::Stuck)] {
///     let response = at.response(beta)?;
///     assert_eq!(response.regime(), regime);
///     let lower = response.swing(Of::Mass(0)).ok_or("no such mass")?;
///     println!("the lower mass moves by {} Y", lower.amplitude);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub enum SystemResponse<'a> {
    /// The contact slides all the time: the closed form.
    Continuous(SystemMotion<'a>),
    /// Between the limits: the steady state that is reached from rest.
    StickSlip(Box<SystemOrbit<'a>>),
    /// The contact never slides.
    Stuck(SystemStuck<'a>),
}

/// How far something swings, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// The largest |x̄| of the period: over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// The lag of that maximum behind the excitation's, rad, in (−π, π]; none for what does not move.
    pub phase: Option<f64>,
}

impl Swing {
    /// Of what does not move.
    pub const REST: Self = Self {
        amplitude: 0.0,
        phase: None,
    };
}

/// What the motion of the contact or of a mass is measured by, over P/k₁, for base motion over Y.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Size {
    /// The largest |x̄|.
    Displacement,
    /// The largest |dx̄/dτ|; times ω it is a velocity.
    Velocity,
    /// The largest |d²x̄/dτ²|; times ω² it is an acceleration.
    Acceleration,
}

impl<'a> SystemAt<'a> {
    /// The steady response at β = F/P, in whatever regime.
    ///
    /// # Errors
    /// [`NotContinuous::Unbounded`] and [`StuckResonance`](crate::StuckResonance) on an undamped resonance,
    /// [`NoOrbit`](crate::NoOrbit) where no steady state with stops was found, [`OutOfDomain`] for NaN, negative and
    /// infinite β.
    pub fn response(&self, beta: f64) -> Result<SystemResponse<'a>, Error> {
        match self.motion(beta) {
            Ok(motion) => Ok(SystemResponse::Continuous(motion)),
            Err(NotContinuous::Stuck) => Ok(SystemResponse::Stuck(self.stuck()?)),
            Err(NotContinuous::StickSlip) => {
                let orbit = self.orbit_or_last_cycles(beta)?;
                Ok(SystemResponse::StickSlip(Box::new(orbit)))
            }
            Err(NotContinuous::OutOfDomain) => Err(OutOfDomain { argument: "beta" }.into()),
            Err(error) => Err(error.into()),
        }
    }
}

impl SystemResponse<'_> {
    /// Which regime it is.
    #[must_use]
    pub fn regime(&self) -> Regime {
        match self {
            Self::Continuous(_) => Regime::Continuous,
            Self::StickSlip(_) => Regime::StickSlip,
            Self::Stuck(_) => Regime::Stuck,
        }
    }

    /// Whether it is a motion that repeats; otherwise it is that of the last 64 cycles of a run that did not settle.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        match self {
            Self::StickSlip(orbit) => orbit.is_settled(),
            _ => true,
        }
    }

    /// Amplitude and phase of the contact or of a mass; none if there is no such mass.
    #[must_use]
    pub fn swing(&self, of: Of) -> Option<Swing> {
        let moving = |(amplitude, phase)| Swing {
            amplitude,
            phase: Some(phase),
        };
        match (self, of) {
            (Self::Continuous(motion), _) => {
                let motion = match of {
                    Of::Contact => motion.contact(),
                    Of::Mass(index) => motion.mass_at(index)?,
                };
                let largest = motion.largest();
                Some(moving((largest.amplitude, largest.phase)))
            }
            (Self::StickSlip(orbit), Of::Contact) => Some(moving(orbit.contact().largest())),
            (Self::StickSlip(orbit), Of::Mass(index)) => {
                Some(moving(orbit.mass_at(index)?.largest()))
            }
            (Self::Stuck(_), Of::Contact) => Some(Swing::REST),
            (Self::Stuck(stuck), Of::Mass(index)) => {
                let (amplitude, phase) = polar(stuck.mass_at(index)?);
                let at_rest = amplitude == 0.0;
                Some(if at_rest {
                    Swing::REST
                } else {
                    moving((amplitude, phase))
                })
            }
        }
    }

    /// The phase of the contact's motion with the opposite sign, as
    /// [`contact_is_reversed`](System::contact_is_reversed) asks for; none for a contact that does not move.
    #[must_use]
    pub fn reversed_contact_phase(&self) -> Option<f64> {
        match self {
            Self::StickSlip(orbit) => Some(orbit.reversed_contact_phase()),
            _ => self.swing(Of::Contact)?.phase.map(reversed_phase),
        }
    }

    /// The monoharmonic estimate of an amplitude (5.50, 7.33); none in another regime than the continuous one, and if there
    /// is no such mass.
    #[must_use]
    pub fn monoharmonic(&self, of: Of) -> Option<f64> {
        let Self::Continuous(motion) = self else {
            return None;
        };
        let motion = match of {
            Of::Contact => motion.contact(),
            Of::Mass(index) => motion.mass_at(index)?,
        };
        Some(motion.amplitude_monoharmonic())
    }

    /// The largest displacement, velocity or acceleration of the contact or of a mass; none if there is no such mass.
    ///
    /// An acceleration jumps where the friction force does, and counts on both sides.
    #[must_use]
    pub fn largest(&self, of: Of, size: Size) -> Option<f64> {
        if size == Size::Displacement {
            return Some(self.swing(of)?.amplitude);
        }
        match self {
            // The same motion, segment by segment.
            Self::Continuous(motion) => {
                fastest(&motion.at().orbit(motion.friction().beta).ok()?, of, size)
            }
            Self::StickSlip(orbit) => fastest(orbit, of, size),
            // One harmonic: all sizes are the same.
            Self::Stuck(_) => Some(self.swing(of)?.amplitude),
        }
    }

    /// X_n of the contact or of a mass, with x̄ = Re Σ X_n e^{inτ} and τ from a maximum of the excitation; none if there is
    /// no such mass.
    #[must_use]
    pub fn harmonic(&self, of: Of, n: u32) -> Option<Complex<f64>> {
        let none = Complex::new(0.0, 0.0);
        Some(match (self, of) {
            (Self::Continuous(motion), Of::Contact) => motion.contact().harmonic(n),
            (Self::Continuous(motion), Of::Mass(index)) => motion.mass_at(index)?.harmonic(n),
            (Self::StickSlip(orbit), Of::Contact) => orbit.contact().harmonic(n),
            (Self::StickSlip(orbit), Of::Mass(index)) => orbit.mass_at(index)?.harmonic(n),
            (Self::Stuck(_), Of::Contact) => none,
            (Self::Stuck(stuck), Of::Mass(index)) => {
                let amplitude = stuck.mass_at(index)?;
                if n == 1 { amplitude } else { none }
            }
        })
    }

    /// The largest friction force of the period over P: β while the contact slides, μβ where it stops and breaks away,
    /// and what holds it where it never slides, μβ*_lim. A contact that came to rest off its middle carries a constant
    /// force beside.
    #[must_use]
    pub fn contact_force(&self) -> f64 {
        match self {
            Self::Continuous(motion) => motion.friction().beta,
            Self::StickSlip(orbit) if orbit.stops() == 0 => orbit.beta(),
            Self::StickSlip(orbit) => orbit.beta() * stiction(orbit.system),
            Self::Stuck(stuck) => {
                let at = stuck.at();
                at.sliding_limit() * stiction(at.scene())
            }
        }
    }

    /// The work that friction takes out of a cycle of the excitation, over P²/k₁; for base motion over k₁Y².
    #[must_use]
    pub fn friction_work(&self) -> f64 {
        match self {
            // Back and forth over twice the amplitude.
            Self::Continuous(motion) => 4.0 * motion.friction().beta * motion.contact().amplitude(),
            Self::StickSlip(orbit) => {
                orbit.beta() * orbit.sliding_distance() / f64::from(orbit.period())
            }
            Self::Stuck(_) => 0.0,
        }
    }
}

/// The largest velocity or acceleration in a steady state.
fn fastest(orbit: &SystemOrbit<'_>, of: Of, size: Size) -> Option<f64> {
    let motion = match of {
        Of::Contact => orbit.contact(),
        Of::Mass(index) => orbit.mass_at(index)?,
    };
    Some(match size {
        Size::Displacement => motion.amplitude(),
        Size::Velocity => motion.largest_velocity(),
        Size::Acceleration => motion.largest_acceleration(),
    })
}

/// μ.
fn stiction(system: &System) -> f64 {
    (&system).numbers().chain.stiction
}

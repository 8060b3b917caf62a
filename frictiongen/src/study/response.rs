//! The steady response in any regime: continuous, stick-slip or stuck.

pub use super::held::SystemHeld;
pub use super::motion::SystemSteady;
pub use super::motion::{SystemMotion, SystemStuck};
use super::orbit::SystemOrbit;
pub use super::quantity::MotionQuantity;
use super::rates::largest_rate;
use super::system::System;
use super::units::{fundamental_phase, polar, reversed_phase};
use crate::{Complex, Of, Regime};
use frictiongen_kernel::response::Scene as _;
use std::f64::consts::TAU;

/// The steady response of a system at one frequency ratio and one friction ratio.
///
/// [`InitialState`](super::InitialState) says which of several steady states is the answer.
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
    /// The continuous response in closed form: the contact slides all the time.
    Continuous(SystemMotion<'a>),
    /// A steady state that is neither the closed form nor stuck, computed from event to event. If the motion does not
    /// settle, the response contains the last 64 cycles that were computed.
    StickSlip(Box<SystemOrbit<'a>>),
    /// The stuck response: the contact never slides.
    Stuck(SystemHeld<'a>),
}

/// The amplitude of a motion, which is its largest displacement |x̄|, and the phase of this largest displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// The largest |x̄| in the period, where x̄ = x/(P/k₁) (x/Y for base motion).
    pub amplitude: f64,
    /// Lag behind the maximum of the excitation, in rad, in (−π, π]. It belongs to the instant at which |x̄| reaches
    /// `amplitude`. If x̄ is negative at this instant, half a turn is added. `None` if the contact or mass does not
    /// move.
    pub phase: Option<f64>,
}

impl Swing {
    /// Amplitude and phase of a contact or mass that does not move: the amplitude is 0, and there is no phase.
    pub const REST: Self = Self {
        amplitude: 0.0,
        phase: None,
    };
}

impl SystemResponse<'_> {
    /// Returns the regime of this response: continuous, stick-slip or stuck.
    #[must_use]
    pub fn regime(&self) -> Regime {
        match self {
            Self::Continuous(_) => Regime::Continuous,
            Self::StickSlip(orbit) if orbit.slides => Regime::Continuous,
            Self::StickSlip(_) => Regime::StickSlip,
            Self::Stuck(_) => Regime::Stuck,
        }
    }

    /// Returns true if the motion repeats. If false, the response contains the last 64 computed cycles of a motion that
    /// did not settle.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        match self {
            Self::StickSlip(orbit) => orbit.is_settled(),
            _ => true,
        }
    }

    /// Returns amplitude and phase of the motion `of`: the contact, a mass, or a combination of masses and base.
    /// Returns `None` if the scene does not have this motion.
    #[must_use]
    pub fn swing(&self, of: Of) -> Option<Swing> {
        let moving = |(amplitude, phase)| Swing {
            amplitude,
            phase: Some(phase),
        };
        match self {
            Self::Continuous(motion) => {
                let largest = motion.motion_of(of)?.largest();
                Some(moving((largest.amplitude, largest.phase)))
            }
            Self::StickSlip(orbit) => orbit.ask_of(of, |motion| moving(motion.largest())),
            Self::Stuck(held) => {
                let (harmonic, offset) = held.motion_of(of)?;
                let (amplitude, phase) = polar(harmonic);
                // The largest |x̄| occurs at the extreme of the motion on the side of the constant displacement.
                Some(Swing {
                    amplitude: amplitude + offset.abs(),
                    phase: (amplitude != 0.0).then_some(phase),
                })
            }
        }
    }

    /// Returns the centred amplitude of a motion: half the distance between the least and the largest x̄, where x̄ =
    /// x/(P/k₁) (x/Y for base motion). Returns `None` if the scene does not have this motion.
    pub(super) fn centred_amplitude(&self, of: Of) -> Option<f64> {
        match self {
            Self::Continuous(_) => Some(self.swing(of)?.amplitude),
            Self::StickSlip(orbit) => orbit.ask_of(of, |motion| motion.centred_amplitude()),
            Self::Stuck(held) => Some(polar(held.motion_of(of)?.0).0),
        }
    }

    /// Returns the lag −arg X₁ of the fundamental component of a motion behind the excitation, in rad, in (−π, π].
    /// Returns `None` if the contact or mass does not move, and if the scene does not have this motion.
    #[must_use]
    pub fn fundamental_phase(&self, of: Of) -> Option<f64> {
        fundamental_phase(self.harmonic(of, 1)?, self.centred_amplitude(of)?)
    }

    /// Returns the offset (max z̄ + min z̄)/2 of the contact's relative motion, divided by P/k₁ (by Y for base motion). A
    /// symmetric motion has offset 0. If the contact never slides, the offset is the place at which the motion from
    /// rest, or from the initial state of the system, leaves the contact.
    #[must_use]
    pub fn offset(&self) -> f64 {
        match self {
            Self::Continuous(_) => 0.0,
            Self::StickSlip(orbit) => orbit.offset(),
            Self::Stuck(held) => held.offset,
        }
    }

    /// Returns the largest |offset| of the contact in a continuum of steady states, divided by P/k₁ (by Y for base
    /// motion). The states of a continuum differ by their offset. Returns `None` if this state does not belong to a
    /// continuum, or if the bound is unknown. See
    /// [`SystemOrbit::offset_range`](frictiongen_kernel::orbit::Orbit::offset_range).
    #[must_use]
    pub fn offset_range(&self) -> Option<f64> {
        match self {
            Self::Continuous(_) => None,
            Self::StickSlip(orbit) => orbit.offset_range(),
            Self::Stuck(held) => Some(held.offset_range),
        }
    }

    /// Returns true if the response is marginal: it belongs to a continuum of steady states.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        match self {
            Self::Continuous(_) => false,
            Self::StickSlip(orbit) => orbit.is_marginal(),
            Self::Stuck(_) => true,
        }
    }

    /// Returns true if the motion from rest ends in this response. If the result is false, the motion from rest does
    /// not settle, and this response is another stable state.
    #[must_use]
    pub fn is_from_rest(&self) -> bool {
        match self {
            Self::StickSlip(orbit) => orbit.is_from_rest(),
            Self::Stuck(held) => held.from_rest,
            Self::Continuous(motion) => motion.is_from_rest(),
        }
    }

    /// Returns the phase of the contact's relative motion with the opposite sign, in rad. If
    /// [`contact_is_reversed`](System::contact_is_reversed) is true, this phase follows the sign convention of the
    /// scene description. Returns `None` for a contact that does not move.
    #[must_use]
    pub fn reversed_contact_phase(&self) -> Option<f64> {
        match self {
            Self::StickSlip(orbit) => Some(orbit.reversed_contact_phase()),
            _ => self.swing(Of::Contact)?.phase.map(reversed_phase),
        }
    }

    /// Returns the monoharmonic estimate of an amplitude, from the fundamental harmonic alone (5.50, 7.33). Returns
    /// `None` if the regime is not continuous, or if the scene does not have this motion.
    #[must_use]
    pub fn monoharmonic(&self, of: Of) -> Option<f64> {
        let Self::Continuous(motion) = self else {
            return None;
        };
        Some(motion.motion_of(of)?.amplitude_monoharmonic())
    }

    /// Returns the quantity `size` of the motion `of`, for example the largest velocity of a mass. Returns `None` if
    /// the scene does not have this motion, or if the motion does not have this quantity.
    ///
    /// An acceleration jumps when the friction force jumps. The result includes the values on both sides of a jump.
    #[must_use]
    pub fn largest(&self, of: Of, size: MotionQuantity) -> Option<f64> {
        match size {
            MotionQuantity::Displacement => return Some(self.swing(of)?.amplitude),
            MotionQuantity::Force => return (of == Of::Contact).then(|| self.contact_force()),
            MotionQuantity::Energy => return (of == Of::Contact).then(|| self.friction_work()),
            MotionQuantity::Damping => {
                let centred = |of| self.centred_amplitude(of);
                return equivalent_damping(self.system(), of, self.friction_work(), centred);
            }
            MotionQuantity::Velocity | MotionQuantity::Acceleration => {}
        }
        match self {
            Self::Continuous(motion) => largest_rate(motion, of, size),
            Self::StickSlip(orbit) => fastest(orbit, of, size),
            // While the contact is stuck, the motion of the chain has a single harmonic. About its mean, x̄, dx̄/dτ and
            // d²x̄/dτ² therefore have equal amplitudes.
            Self::Stuck(_) => self.centred_amplitude(of),
        }
    }

    /// Returns X_n, the complex amplitude of harmonic n in x̄ = Re Σ X_n e^{inτ}, for the contact or a mass. The phase
    /// τ is 0 at a maximum of the excitation. Returns `None` if the scene does not have this motion.
    #[must_use]
    pub fn harmonic(&self, of: Of, n: u32) -> Option<Complex<f64>> {
        match self {
            Self::Continuous(motion) => Some(motion.motion_of(of)?.harmonic(n)),
            Self::StickSlip(orbit) => orbit.ask_of(of, |motion| motion.harmonic(n)),
            Self::Stuck(held) => {
                let (harmonic, offset) = held.motion_of(of)?;
                Some(match n {
                    0 => Complex::new(offset, 0.0),
                    1 => harmonic,
                    _ => Complex::new(0.0, 0.0),
                })
            }
        }
    }

    /// Returns the largest friction force in the period, divided by the load amplitude P (by k₁Y for base motion). If
    /// the contact slides without a stop, the result is β. If the contact stops and breaks away, the result is μβ. If
    /// the contact never slides, the result is μβ*_lim plus the constant force of an initial state.
    #[must_use]
    pub fn contact_force(&self) -> f64 {
        match self {
            Self::Continuous(motion) => motion.friction().beta,
            Self::StickSlip(orbit) if orbit.stops() == 0 => orbit.beta(),
            Self::StickSlip(orbit) => orbit.beta() * stiction(orbit.system),
            Self::Stuck(held) => {
                let at = held.at();
                let forced = at.sliding_limit() * stiction(at.scene());
                forced + held.constant_force().abs()
            }
        }
    }

    fn system(&self) -> &System {
        match self {
            Self::Continuous(motion) => motion.at().scene(),
            Self::StickSlip(orbit) => orbit.system,
            Self::Stuck(held) => held.at().scene(),
        }
    }

    /// Returns the energy that friction dissipates in one cycle of the excitation, divided by P²/k₁ (by k₁Y² for base
    /// motion).
    #[must_use]
    pub fn friction_work(&self) -> f64 {
        match self {
            // In a cycle the contact slides forwards and backwards, over a distance of four amplitudes in total.
            Self::Continuous(motion) => 4.0 * motion.friction().beta * motion.contact().amplitude(),
            Self::StickSlip(orbit) => {
                orbit.beta() * orbit.sliding_distance() / f64::from(orbit.period())
            }
            Self::Stuck(_) => 0.0,
        }
    }
}

/// Returns the equivalent viscous damping ratio of a contact that dissipates `energy` in a cycle. The ratio contains
/// the strain energy of all springs if `of` is the contact, and of one spring if `of` is this spring. Returns `None`
/// for any other motion, and if no spring is deformed. `centred` returns the centred amplitude of a motion.
pub(super) fn equivalent_damping(
    system: &System,
    of: Of,
    energy: f64,
    centred: impl Fn(Of) -> Option<f64>,
) -> Option<f64> {
    let scene = system.scene();
    // The force of a spring divided by P is f̄ = κx̄, with the stiffness ratio κ. Therefore ½κx̄² = ½f̄²/κ.
    let strain = |index: usize| {
        let force = centred(Of::Spring(index))?;
        let stiffness = scene.springs.get(index)?.stiffness / scene.first_stiffness();
        Some(0.5 * force * force / stiffness)
    };
    let stored = match of {
        Of::Contact => (0..scene.springs.len()).map(strain).sum::<Option<f64>>()?,
        Of::Spring(index) => strain(index)?,
        _ => return None,
    };
    (0.0 < stored).then(|| energy / (2.0 * TAU * stored))
}

/// Returns the largest velocity or acceleration of the motion `of` in a steady state. If `size` is the displacement,
/// the result is the amplitude.
fn fastest(orbit: &SystemOrbit<'_>, of: Of, size: MotionQuantity) -> Option<f64> {
    orbit.ask_of(of, |motion| match size {
        MotionQuantity::Velocity => motion.largest_velocity(),
        MotionQuantity::Acceleration => motion.largest_acceleration(),
        _ => motion.amplitude(),
    })
}

/// Returns μ, the ratio of static to kinetic friction.
fn stiction(system: &System) -> f64 {
    (&system).numbers().chain.stiction
}

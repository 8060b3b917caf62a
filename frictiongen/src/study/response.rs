//! The steady response in whatever regime: closed form, steady state with stops, or stuck.

use super::at::SystemAt;
use super::motion::{SystemMotion, SystemStuck};
use super::orbit::SystemOrbit;
use super::system::System;
use super::units::{polar, reversed_phase};
use crate::{Complex, Error, NoOrbit, NotContinuous, Of, OutOfDomain, Regime, StuckResonance};
use frictiongen_kernel::Float;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_kernel::response::Scene as _;
use std::ops::Deref;

/// A multiplier counts as on the unit circle within so many roundings, as it does for a steady state.
const ON_CIRCLE: f64 = 4096.0;

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
    /// The steady state from event to event.
    StickSlip(Box<SystemOrbit<'a>>),
    /// The contact never slides.
    Stuck(SystemHeld<'a>),
}

/// The response while the contact is stuck, at the offset where it came to rest.
#[derive(Clone, Debug)]
pub struct SystemHeld<'a> {
    stuck: SystemStuck<'a>,
    offset: f64,
    offset_range: f64,
    from_rest: bool,
}

impl<'a> SystemHeld<'a> {
    /// z̄ of the contact: 0 if it sticks at its centre.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// The largest |z̄| at which friction can hold the contact.
    #[must_use]
    pub fn offset_range(&self) -> f64 {
        self.offset_range
    }

    /// The constant friction force that holds the contact off its centre, over P, for base motion over k₁Y; positive
    /// against positive sliding.
    #[must_use]
    pub fn constant_force(&self) -> f64 {
        -(self.offset / receptance(self.stuck.at().scene()))
    }

    /// The constant displacement of a mass that the offset brings about; none if there is no such mass.
    #[must_use]
    pub fn mass_offset(&self, index: usize) -> Option<f64> {
        let system = *self.stuck.at().scene();
        Some(self.offset * static_share(system, index)?)
    }
}

impl<'a> Deref for SystemHeld<'a> {
    type Target = SystemStuck<'a>;

    fn deref(&self) -> &Self::Target {
        &self.stuck
    }
}

/// By how much a constant displacement of the contact moves a mass, Σφ_k(φᵀw)/λ over Σ(φᵀw)²/λ.
pub(super) fn static_share<S: Float>(system: &System<S>, mass: usize) -> Option<S> {
    let zero = S::constant(0.0);
    let shape = system.shape(mass)?;
    let (mut moved, mut receptance) = (zero, zero);
    for (mode, component) in system.numbers().modes.iter().zip(shape) {
        let lambda = mode.resonance * mode.resonance;
        moved = moved + *component * mode.contact / lambda;
        receptance = receptance + mode.contact * mode.contact / lambda;
    }
    Some(moved / receptance)
}

/// The state of a steady motion where the excitation is at its maximum.
#[derive(Clone, Debug)]
pub(super) struct Carried {
    r: f64,
    displacements: Vec<f64>,
    velocities: Vec<f64>,
}

impl Carried {
    fn of(orbit: &SystemOrbit<'_>, r: f64) -> Self {
        let tau = -orbit.origin();
        let masses = 0..orbit.system.scene().masses.len();
        let (displacements, velocities) = masses
            .filter_map(|mass| orbit.mass_at(mass))
            .map(|motion| (motion.displacement(tau), motion.velocity(tau)))
            .unzip();
        Self {
            r,
            displacements,
            velocities,
        }
    }
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
    /// The steady response at β = F/P, in whatever regime: the state that motion from rest ends in.
    ///
    /// With μ = 1 that is the closed form for every β < β_lim, except for a chain without damping at r = 1/2n, where it is
    /// one of a continuum.  With μ > 1 other states may exist beside the closed form and beside the stuck state, and the
    /// motion is followed.
    ///
    /// Where motion from rest does not settle, the answer is another stable steady state, found from the closed form, a
    /// neighbouring friction ratio or the stuck state; [`SystemOrbit::is_from_rest`] is false then.  Where none is found
    /// either, the answer is the last 64 cycles of the motion from rest.
    ///
    /// # Errors
    /// [`NotContinuous::Unbounded`] and [`StuckResonance`](crate::StuckResonance) on an undamped resonance,
    /// [`NoOrbit`](crate::NoOrbit) where there is no steady state to follow, [`OutOfDomain`] for NaN, negative and
    /// infinite β.
    pub fn response(&self, beta: f64) -> Result<SystemResponse<'a>, Error> {
        let motion = self.motion(beta);
        match motion {
            Ok(motion) if self.is_unique() => Ok(SystemResponse::Continuous(motion)),
            Err(NotContinuous::OutOfDomain) => Err(OutOfDomain { argument: "beta" }.into()),
            Err(NotContinuous::Unbounded) if beta < self.sliding_limit() => {
                Err(NotContinuous::Unbounded.into())
            }
            // Neither 0 nor ∞ has a cycle to follow.
            Ok(motion) if !self.has_cycles() => Ok(SystemResponse::Continuous(motion)),
            Err(NotContinuous::Stuck) if !self.has_cycles() => {
                Ok(SystemResponse::Stuck(self.held(0.0, 0.0)?))
            }
            motion => {
                let orbit = self.settled_orbit(beta)?;
                self.told(orbit, motion.ok())
            }
        }
    }

    /// The response that motion from another state ends in, with the state to carry on from.
    pub(super) fn response_from(
        &self,
        beta: f64,
        start: Option<&Carried>,
    ) -> Result<(SystemResponse<'a>, Carried), Error> {
        let motion = match self.motion(beta) {
            Err(NotContinuous::OutOfDomain) => {
                return Err(OutOfDomain { argument: "beta" }.into());
            }
            motion => motion.ok(),
        };
        let r = self.frequency_ratio();
        let orbit = match start {
            None => self.orbit_or_last_cycles(beta)?,
            Some(carried) => {
                // A velocity in time is r times dx̄/dτ.
                let factor = carried.r / r;
                let velocities: Vec<f64> = carried.velocities.iter().map(|v| v * factor).collect();
                self.orbit_or_last_cycles_from(beta, (&carried.displacements, &velocities))?
            }
        };
        let carried = Carried::of(&orbit, r);
        Ok((self.told(orbit, motion)?, carried))
    }

    /// The response that an orbit is.
    fn told(
        &self,
        orbit: SystemOrbit<'a>,
        motion: Option<SystemMotion<'a>>,
    ) -> Result<SystemResponse<'a>, Error> {
        let slides = slides_twice(&orbit);
        match motion {
            // Within rounding below β*_lim a motion may be too small to be seen.
            _ if orbit.is_settled()
                && orbit.never_slides()
                && !(orbit.beta() < self.sliding_limit()) =>
            {
                let range = orbit.offset_range().unwrap_or(0.0);
                let mut held = self.held(orbit.offset(), range)?;
                held.from_rest = orbit.is_from_rest();
                Ok(SystemResponse::Stuck(held))
            }
            Some(motion) if slides && orbit.is_symmetric() => {
                Ok(SystemResponse::Continuous(motion))
            }
            // Another of the closed form's continuum.
            Some(_) if slides => Ok(SystemResponse::StickSlip(Box::new(orbit.sliding()))),
            _ => Ok(SystemResponse::StickSlip(Box::new(orbit))),
        }
    }

    /// The response with so much friction that the contact stays where it is at rest: at its centre, or for a contact with
    /// the moving base where the base has gone by then.
    pub(super) fn locked(&self) -> Result<SystemResponse<'a>, Error> {
        let offset = -share_of_base(self.scene());
        Ok(SystemResponse::Stuck(self.held(offset, f64::INFINITY)?))
    }

    /// The response while the contact is stuck at an offset.
    fn held(&self, offset: f64, offset_range: f64) -> Result<SystemHeld<'a>, StuckResonance> {
        Ok(SystemHeld {
            stuck: self.stuck()?,
            offset,
            offset_range,
            from_rest: true,
        })
    }

    /// The steady state that motion from rest ends in; where it does not settle, another that is stable.
    fn settled_orbit(&self, beta: f64) -> Result<SystemOrbit<'a>, NoOrbit> {
        let last = self.orbit_or_last_cycles(beta)?;
        if last.is_settled() {
            return Ok(last);
        }
        let mut others = self.states(beta)?;
        let other = others.find(|orbit| orbit.is_stable());
        Ok(other.map_or(last, SystemOrbit::not_from_rest))
    }

    /// Whether no other steady state can exist beside the closed form: with μ = 1, unless an undamped mode turns an even
    /// number of times in half a period.
    fn is_unique(&self) -> bool {
        let numbers = self.scene().numbers();
        let even = |x: f64| {
            let half = x * 0.5;
            half > 0.5 && (half - half.round()).abs() <= ON_CIRCLE * f64::EPSILON * half
        };
        let inverse = self.inverse_ratio();
        let marginal = |mode: &Mode<f64>| {
            mode.kind == Kind::Undamped && mode.in_contact && even(mode.resonance * inverse)
        };
        numbers.chain.stiction <= 1.0 && !numbers.modes.iter().any(marginal)
    }

    /// Whether r is neither 0 nor infinite.
    fn has_cycles(&self) -> bool {
        let r = self.frequency_ratio();
        0.0 < r && r.is_finite()
    }
}

impl SystemResponse<'_> {
    /// Which regime it is.
    #[must_use]
    pub fn regime(&self) -> Regime {
        match self {
            Self::Continuous(_) => Regime::Continuous,
            Self::StickSlip(orbit) if orbit.slides => Regime::Continuous,
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
            (Self::Stuck(held), Of::Contact) => Some(Swing {
                amplitude: held.offset.abs(),
                phase: None,
            }),
            (Self::Stuck(held), Of::Mass(index)) => {
                let (amplitude, phase) = polar(held.mass_at(index)?);
                // The largest |x̄| is on the side of the offset, where the motion turns.
                Some(Swing {
                    amplitude: amplitude + held.mass_offset(index)?.abs(),
                    phase: (amplitude != 0.0).then_some(phase),
                })
            }
        }
    }

    /// Half the distance between the least and the largest x̄: the amplitude about the motion's own middle, over P/k₁, for
    /// base motion over Y; none if there is no such mass.
    #[must_use]
    pub fn centred_amplitude(&self, of: Of) -> Option<f64> {
        match (self, of) {
            (Self::Continuous(_), _) => Some(self.swing(of)?.amplitude),
            (Self::StickSlip(orbit), Of::Contact) => Some(orbit.contact().centred_amplitude()),
            (Self::StickSlip(orbit), Of::Mass(index)) => {
                Some(orbit.mass_at(index)?.centred_amplitude())
            }
            (Self::Stuck(_), Of::Contact) => Some(0.0),
            (Self::Stuck(held), Of::Mass(index)) => Some(polar(held.mass_at(index)?).0),
        }
    }

    /// The middle of the contact's relative motion, over P/k₁, for base motion over Y; 0 for a symmetric motion.
    #[must_use]
    pub fn offset(&self) -> f64 {
        match self {
            Self::Continuous(_) => 0.0,
            Self::StickSlip(orbit) => orbit.offset(),
            Self::Stuck(held) => held.offset,
        }
    }

    /// How far off its centre the contact may be in a state of the same continuum, as
    /// [`SystemOrbit::offset_range`](frictiongen_kernel::orbit::Orbit::offset_range) gives it.
    #[must_use]
    pub fn offset_range(&self) -> Option<f64> {
        match self {
            Self::Continuous(_) => None,
            Self::StickSlip(orbit) => orbit.offset_range(),
            Self::Stuck(held) => Some(held.offset_range),
        }
    }

    /// Whether it is one of a continuum of steady states.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        match self {
            Self::Continuous(_) => false,
            Self::StickSlip(orbit) => orbit.is_marginal(),
            Self::Stuck(_) => true,
        }
    }

    /// Whether motion from rest ends in it; false for another stable state, where motion from rest does not settle.
    #[must_use]
    pub fn is_from_rest(&self) -> bool {
        match self {
            Self::StickSlip(orbit) => orbit.is_from_rest(),
            Self::Stuck(held) => held.from_rest,
            Self::Continuous(_) => true,
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
            // One harmonic: all sizes are the same, but for the offset.
            Self::Stuck(_) => self.centred_amplitude(of),
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
            (Self::Stuck(held), Of::Contact) if n == 0 => Complex::new(held.offset, 0.0),
            (Self::Stuck(_), Of::Contact) => none,
            (Self::Stuck(held), Of::Mass(index)) => {
                let amplitude = held.mass_at(index)?;
                match n {
                    0 => Complex::new(held.mass_offset(index)?, 0.0),
                    1 => amplitude,
                    _ => none,
                }
            }
        })
    }

    /// The largest friction force of the period over P: β while the contact slides, μβ where it stops and breaks away,
    /// and what holds it where it never slides, μβ*_lim and the constant force of its offset.
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

/// Whether it slides all the time and turns twice in a cycle, as the closed form does.
fn slides_twice(orbit: &SystemOrbit<'_>) -> bool {
    orbit.is_settled() && (orbit.stops(), orbit.reversals(), orbit.period()) == (0, 2, 1)
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

/// s: 1 for a contact with the moving base.
pub(super) fn share_of_base(system: &System) -> f64 {
    let on_base = (&system).numbers().chain.on_moving_base.is_some();
    f64::from(u8::from(on_base))
}

/// wᵀK̄⁻¹w, by how much a unit of constant force moves the contact.
fn receptance(system: &System) -> f64 {
    let modes = system.numbers().modes.iter();
    let terms = modes.map(|mode| (mode.contact / mode.resonance).powi(2));
    terms.sum()
}

/// μ.
fn stiction(system: &System) -> f64 {
    (&system).numbers().chain.stiction
}

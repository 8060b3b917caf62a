//! Rows and columns of responses and of steady states, over frequency and friction.

mod orbit;
mod response;

pub use orbit::{OrbitRow, OrbitTable};
pub use response::{ResponseRow, ResponseTable};

use super::motion::PartMotion;
use super::setting::MovingPart;
use crate::Complex;
use crate::Regime;
use crate::study::joined::Waveform;
use crate::study::units::{fundamental_phase, reversed_phase};
use crate::study::{
    orbit::SystemOrbitMotion,
    response::{MotionQuantity, Swing, SystemResponse},
};

/// The motion of the contact or of a mass in a row, in non-dimensional groups. A quantity is `None` if the result does
/// not contain it.
#[derive(Clone, Debug, Default)]
pub(super) struct MotionGroups {
    swing: Option<Swing>,
    fundamental_phase: Option<f64>,
    monoharmonic: Option<f64>,
    rates: Option<(f64, f64)>,
    contact: Option<(f64, f64)>,
    damping: Option<f64>,
    harmonics: Vec<Complex<f64>>,
}

impl MotionGroups {
    /// Reads the motion from a response in any regime.
    fn of_response(response: &SystemResponse<'_>, part: &MovingPart, orders: &[u32]) -> Self {
        let of = part.of;
        let rates = || {
            let velocity = response.largest(of, MotionQuantity::Velocity)?;
            Some((
                velocity,
                response.largest(of, MotionQuantity::Acceleration)?,
            ))
        };
        let harmonics = orders.iter().map(|order| response.harmonic(of, *order));
        Self {
            swing: response.swing(of),
            fundamental_phase: response.fundamental_phase(of),
            monoharmonic: response.monoharmonic(of),
            rates: if part.has_rate() { rates() } else { None },
            contact: Some((response.contact_force(), response.friction_work())),
            damping: if part.has_rate() {
                response.largest(of, MotionQuantity::Damping)
            } else {
                None
            },
            harmonics: harmonics.collect::<Option<_>>().unwrap_or_default(),
        }
    }

    /// Reads the motion from a steady state.
    fn of_orbit(motion: &SystemOrbitMotion<'_, '_>, orders: &[u32]) -> Self {
        let (amplitude, phase) = motion.largest();
        let centred = motion.centred_amplitude();
        Self {
            swing: Some(Swing {
                amplitude,
                phase: Some(phase),
            }),
            fundamental_phase: fundamental_phase(motion.harmonic(1), centred),
            monoharmonic: None,
            rates: Some((motion.largest_velocity(), motion.largest_acceleration())),
            contact: None,
            damping: None,
            harmonics: orders.iter().map(|order| motion.harmonic(*order)).collect(),
        }
    }

    /// Reads the amplitude alone.
    pub(super) fn of_amplitude(amplitude: f64) -> Self {
        Self {
            swing: Some(Swing {
                amplitude,
                phase: None,
            }),
            ..Self::default()
        }
    }

    /// Adds the phases and the harmonics of a motion to its amplitude.
    pub(super) fn with_course(mut self, course: &Waveform, orders: &[u32]) -> Self {
        let moves = |_: &f64| self.swing.is_some_and(|swing| swing.amplitude > 0.0);
        let phase = Some(course.phase()).filter(moves);
        self.fundamental_phase = fundamental_phase(course.harmonic(1), course.centred_amplitude());
        self.harmonics = orders.iter().map(|order| course.harmonic(*order)).collect();
        if let Some(swing) = &mut self.swing {
            swing.phase = phase;
        }
        self
    }

    /// Reverses the sign of the motion. `phase` is the phase that the reversed motion has.
    fn turn(&mut self, phase: Option<f64>) {
        if let Some(swing) = &mut self.swing {
            swing.phase = phase;
        }
        self.fundamental_phase = self.fundamental_phase.map(reversed_phase);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(0.0 - harmonic.re, 0.0 - harmonic.im);
        }
    }

    /// Sets displacements at the frequency ratio r = ∞ to exactly zero. The formulas use a large, finite r in place of
    /// ∞, and therefore give small numbers instead of zero.
    fn settle(&mut self) {
        let settled = |value: f64| if value.abs() < 1e-100 { 0.0 } else { value };
        if let Some(swing) = &mut self.swing {
            swing.amplitude = settled(swing.amplitude);
        }
        self.monoharmonic = self.monoharmonic.map(settled);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(settled(harmonic.re), settled(harmonic.im));
        }
    }

    /// Removes the phase of a motion whose amplitude is 0, because its phase is undefined.
    fn leave_out_phase(&mut self) {
        if let Some(swing) = &mut self.swing {
            swing.phase = swing.phase.filter(|_| swing.amplitude != 0.0);
        }
    }

    /// Removes the quantities that give no information while the contact is stuck: the harmonics, because a stuck
    /// response has only its fundamental component, and the motion of a contact that is at rest.
    fn leave_out_stuck(&mut self, at_rest: bool) {
        self.harmonics.clear();
        if at_rest {
            let contact = self.contact;
            *self = Self {
                contact,
                ..Self::default()
            };
        }
    }

    pub(super) fn view(&self) -> PartMotion<'_> {
        PartMotion {
            swing: self.swing,
            fundamental_phase: self.fundamental_phase,
            monoharmonic: self.monoharmonic,
            rates: self.rates,
            contact: self.contact,
            damping: self.damping,
            harmonics: &self.harmonics,
        }
    }
}

/// Returns true if the contact never slides in a response.
fn is_stuck(response: &SystemResponse<'_>) -> bool {
    response.regime() == Regime::Stuck
}

//! What was measured of one frequency, and how much of it is used.

use crate::Complex;
use crate::measure::Measured;
use crate::study::scene::Excitation;
use crate::study::{Load, System};

/// What was measured at one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// The driving frequency, Hz.
    pub hertz: f64,
    /// The load with its measured amplitude.
    pub load: Load,
    /// The standard deviation of that amplitude.
    pub load_deviation: f64,
    /// The motions.
    pub motions: Vec<Datum>,
}

/// A harmonic of a mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Datum {
    /// The mass, by its place.
    pub mass: usize,
    /// n.
    pub harmonic: u32,
    /// X_n over the amplitude of the load (m/m or m/N), with τ = 0 at a maximum of the load.
    pub value: Complex<f64>,
    /// The standard deviation of its real part, and of its imaginary one, as far as the mass's own channel has it.
    pub deviation: f64,
}

impl Observation {
    /// Of the steady part of a recording: the fundamental of each mass, and the odd harmonics up to `harmonics`.
    #[must_use]
    pub fn of(measured: &Measured, system: &System, harmonics: u32) -> Self {
        let amplitude = measured.drive_amplitude();
        let load = match system.scene().excitation {
            Excitation::Base => Load::Base(amplitude),
            Excitation::Force(_) => Load::Force(amplitude),
        };
        let orders = (1..=harmonics.max(1)).step_by(2);
        let motions = orders.flat_map(|harmonic| {
            measured.masses.iter().filter_map(move |(mass, tone)| {
                Some(Datum {
                    mass: *mass,
                    harmonic,
                    value: measured.harmonic(*mass, harmonic)?,
                    deviation: tone.deviation / amplitude,
                })
            })
        });
        Self {
            hertz: measured.hertz,
            load,
            load_deviation: measured.drive.deviation,
            motions: motions.collect(),
        }
    }
}

/// What of a motion is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Using {
    /// Amplitude and phase.
    #[default]
    Complex,
    /// The amplitude alone.
    Amplitude,
    /// The phase alone, of motions of a likely size.
    Phase,
    /// The phase alone, of motions whose size was not measured: of [`Datum::value`] only the direction counts.
    PhaseAlone,
}

impl Using {
    /// Whether phases are compared, and nothing else.
    pub(super) fn is_phase(self) -> bool {
        matches!(self, Self::Phase | Self::PhaseAlone)
    }
}

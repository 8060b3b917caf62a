//! Measured motions at one frequency, and the quantities of these motions that a fit compares.

use crate::Complex;
use crate::measure::Measured;
use crate::study::scene::Excitation;
use crate::study::{System, units::Load};

/// Measured motions of the masses at one driving frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// Driving frequency of the measurement, in Hz.
    pub hertz: f64,
    /// Load of the scene, with its measured amplitude.
    pub load: Load,
    /// Standard deviation of the load's amplitude, in the unit of the load.
    pub load_deviation: f64,
    /// Measured motions of the masses at the driving frequency.
    pub motions: Vec<Datum>,
}

/// A measured harmonic of the motion of one mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Datum {
    /// Index of the mass in the scene description.
    pub mass: usize,
    /// Order n of the harmonic.
    pub harmonic: u32,
    /// Complex amplitude X_n divided by the amplitude of the load, in m/m or m/N. In the displacement Re Σ X_n
    /// e^{inτ}, the phase τ is 0 at a maximum of the load.
    pub value: Complex<f64>,
    /// Standard deviation of the real part and of the imaginary part of [`value`](Self::value), due to the noise of the
    /// mass's own channel.
    pub deviation: f64,
}

impl Observation {
    /// Creates the observation from the steady interval of a recording. The observation contains the fundamental of
    /// each mass, and the odd harmonics up to order `harmonics`.
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

/// The quantities of a motion that a fit compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Using {
    /// The fit compares amplitude and phase of each motion.
    #[default]
    Complex,
    /// The fit compares the amplitude alone.
    Amplitude,
    /// The fit compares the phase. It uses the amplitude only to check that the motion is plausible.
    Phase,
    /// The fit compares the phase of motions without a measured amplitude. The code uses only the argument of
    /// [`Datum::value`].
    PhaseAlone,
}

impl Using {
    /// Returns true if the fit compares only phases.
    pub(super) fn is_phase(self) -> bool {
        matches!(self, Self::Phase | Self::PhaseAlone)
    }
}

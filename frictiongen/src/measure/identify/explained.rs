//! Decides whether a scene can explain a measurement, and returns the scene's response for each observation.

use super::answer::Explained;
use super::friction::{IdentifyProblem, PLACES};
use super::model;
use super::observation::Using;
use crate::measure::MeasureError;
use crate::study::System;
use crate::study::units::polar;
use std::f64::consts::PI;

/// Smallest unexplained fraction of the motion at which the scene does not explain a measurement. The fraction is the
/// root mean square of the unexplained motion, divided by that of the larger of measured and computed motion.
const GROSS: f64 = 0.5;
/// Unexplained fraction of the motion below which a corrected unit explains the measurement. The fraction is the root
/// mean square of the unexplained motion, divided by that of the larger of measured and computed motion.
const MENDED: f64 = 0.2;
/// Bound below which measured amplitudes are so small that their unit may be wrong. The bound is relative to the
/// largest amplitude that the scene has at any friction force.
const TINY: f64 = 0.01;
/// Smallest difference between measured and computed phases, in rad (15°), at which the scene does not explain the
/// phases. The difference is a root mean square over all motions.
const TURNED: f64 = PI / 12.0;

impl IdentifyProblem<'_> {
    /// Returns the unexplained fraction of the motion at the friction force `friction`, in N. The code first divides
    /// the measured motion by `factor`. The other results are the mass with the largest unexplained motion, and the
    /// measured and computed amplitude of this mass.
    fn unexplained(&self, friction: f64, factor: f64) -> Option<(f64, usize, f64, f64)> {
        let (mut left, mut all) = (0.0, 0.0);
        let mut worst = (0.0, 0, 0.0, 0.0);
        for seen in self.observations {
            let answer = model::answer(self.system, seen, friction)?;
            for (datum, value) in seen.motions.iter().zip(&answer.values) {
                let measured = datum.value / factor;
                let size = measured.norm().max(value.norm());
                let apart = match self.using {
                    Using::Complex => (measured - value).norm(),
                    _ => (measured.norm() - value.norm()).abs(),
                };
                // If the noise can cause the difference between measured and computed motion, the motion is explained.
                let apart = (apart - 5.0 * datum.deviation / factor.abs()).max(0.0);
                left += apart * apart;
                all += size * size;
                if worst.0 <= apart {
                    worst = (apart, datum.mass, datum.value.norm(), value.norm());
                }
            }
        }
        Some((
            (left / all.max(f64::MIN_POSITIVE)).sqrt(),
            worst.1,
            worst.2,
            worst.3,
        ))
    }

    /// Returns an error if the scene with the friction force `friction`, in N, does not explain the measurement.
    pub(super) fn explains(&self, friction: f64) -> Result<(), MeasureError> {
        if self.using == Using::PhaseAlone {
            return self.turns_alike(friction);
        }
        // If the fit compares only phases, the amplitude only has to be plausible. A larger unexplained fraction is
        // therefore allowed.
        let gross = if self.using == Using::Phase {
            0.9
        } else {
            GROSS
        };
        let Some((part, mass, measured, nearest)) = self.unexplained(friction, 1.0) else {
            return Err(MeasureError::NoFit);
        };
        if part < gross {
            return Ok(());
        }
        let name = self.system.scene().masses.get(mass);
        let mass = name.map_or_else(String::new, |mass| mass.name.clone());
        for factor in [1e3, 1e-3, 1e6, 1e-6] {
            if self.mends(factor) {
                return Err(MeasureError::WrongUnit { factor, mass });
            }
        }
        Err(MeasureError::NotExplained {
            mass,
            measured,
            nearest,
        })
    }

    /// Returns evenly spaced friction forces in N, from 0 to the upper end of the scanned range.
    fn forces(&self) -> impl Iterator<Item = f64> {
        let end = self.range.1;
        (0..=PLACES).map(move |i| end * f64::from(i) / f64::from(PLACES))
    }

    /// Returns true if some friction force explains the motion after the measured amplitudes are divided by `factor`.
    fn mends(&self, factor: f64) -> bool {
        let parts = self
            .forces()
            .filter_map(|force| Some(self.unexplained(force, factor)?.0));
        parts.fold(f64::INFINITY, f64::min) < MENDED
    }

    /// Returns true if the unit of amplitudes that were measured without phases is in doubt. The unit is in doubt under
    /// two conditions. The amplitudes must be as small as with an almost stuck contact. In addition, the scene must
    /// explain amplitudes that are 1000 or a million times as large.
    pub(super) fn doubts_unit(&self) -> bool {
        if self.using != Using::Amplitude {
            return false;
        }
        let is_tiny = self.observations.iter().all(|seen| {
            let answers = self
                .forces()
                .filter_map(|force| model::answer(self.system, seen, force));
            let mut largest = vec![0.0_f64; seen.motions.len()];
            for answer in answers {
                for (size, value) in largest.iter_mut().zip(&answer.values) {
                    *size = size.max(value.norm());
                }
            }
            let mut pairs = seen.motions.iter().zip(&largest);
            pairs.all(|(datum, largest)| datum.value.norm() < TINY * largest)
        });
        is_tiny && [1e-3, 1e-6].into_iter().any(|factor| self.mends(factor))
    }

    /// Fails if the root mean square of the differences between measured and computed phases is at least [`TURNED`].
    fn turns_alike(&self, friction: f64) -> Result<(), MeasureError> {
        let (mut squares, mut count) = (0.0, 0.0);
        let mut worst = (0.0, 0, 0.0, 0.0);
        for seen in self.observations {
            let answer = model::answer(self.system, seen, friction).ok_or(MeasureError::NoFit)?;
            for (datum, value) in seen.motions.iter().zip(&answer.values) {
                // A motion of zero amplitude has no phase, so that it explains no measured phase.
                let (size, lag) = polar(value * datum.value.conj());
                let apart = if 0.0 < size { lag.abs() } else { PI };
                // If the noise can cause the difference of two phases, the phase is explained.
                let noise = 5.0 * datum.deviation / datum.value.norm();
                let apart = (apart - noise).max(0.0);
                squares += apart * apart;
                count += 1.0;
                if worst.0 <= apart {
                    worst = (apart, datum.mass, polar(datum.value).1, polar(*value).1);
                }
            }
        }
        if squares < TURNED * TURNED * count {
            return Ok(());
        }
        let name = self.system.scene().masses.get(worst.1);
        Err(MeasureError::PhaseNotExplained {
            mass: name.map_or_else(String::new, |mass| mass.name.clone()),
            measured: worst.2.to_degrees(),
            nearest: worst.3.to_degrees(),
        })
    }

    /// Returns the scene's response at each observation, with β, r and the regime.
    pub(super) fn explained(
        &self,
        system: &System,
        friction: f64,
    ) -> Result<Vec<Explained>, MeasureError> {
        let answers = self.observations.iter().map(|seen| {
            let answer = model::answer(system, seen, friction).ok_or(MeasureError::NoFit)?;
            Ok(Explained {
                beta: answer.beta,
                r: answer.r,
                regime: answer.regime,
                model: answer.values,
            })
        });
        answers.collect()
    }
}

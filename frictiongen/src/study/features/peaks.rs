//! Resonant peaks, both estimated and exact, and crossings: frequencies at which a motion has the same exact amplitude
//! for two frictions.

use super::places::{changes, merge, samples, steps};
use super::sensed::Sensed;
use super::{FeatureError, Features, check_friction, check_range};
use crate::study::optimum::Band;
use crate::study::physical::swing;
use crate::study::sensitivity::{Sensitive, Varied};
use crate::{Of, Regime};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// The exact peak of a motion: its largest amplitude near a resonance, over all regimes.
#[derive(Clone, Debug, PartialEq)]
pub struct TruePeak {
    /// Frequency ratio r of the peak.
    pub r: f64,
    /// Frequency of the peak, in Hz under a load. The frequency has derivatives only if the peak is smooth.
    pub frequency: Sensed,
    /// Amplitude at the peak, in m under a load. The amplitude is infinite on an undamped resonance if the friction is
    /// less than the threshold.
    pub amplitude: Sensed,
    /// Regime at the peak. `None` if the amplitude is infinite.
    pub regime: Option<Regime>,
}

/// The peak of a motion at a resonance of the chain: its estimate and its exact value.
#[derive(Clone, Debug, PartialEq)]
pub struct ResonantPeak {
    /// Index of the mode, counted from 0.
    pub mode: usize,
    /// Frequency ratio √λ_i of the resonance.
    pub resonance: f64,
    /// Amplitude of the peak, estimated for small ζ (7.60), in m under a load.
    ///
    /// `None` without damping, and for the contact's motion between two masses or on a moving base. `None` also for a
    /// negative estimate. Friction has then removed the peak.
    pub estimate: Option<Sensed>,
    /// The largest amplitude over all regimes, in the range between the midpoints to the neighbouring resonances.
    /// `None` if the largest amplitude is at a bound of this range. The motion then has no peak.
    pub peak: Option<TruePeak>,
}

/// A crossing: a frequency at which a motion has the same exact amplitude for two frictions.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// Frequency ratio r of the crossing.
    pub r: f64,
    /// Frequency of the crossing, in Hz under a load. In its derivative with respect to friction, the ratio of the two
    /// frictions is constant.
    pub frequency: Sensed,
    /// The amplitude at the crossing, in m under a load. It is the same for both frictions.
    pub amplitude: f64,
}

/// Number of samples in each range of frequencies in which the contact slides all the time with both frictions.
/// Further samples cover the requested range and are evenly spaced in 1/r.
const SAMPLES: usize = 128;
/// Step of a finite difference next to a peak, divided by r.
const BESIDE: f64 = 1e-6;
/// Relative tolerance of the test for a smooth peak. Near a smooth peak the slope of the amplitude is proportional to
/// the distance from the peak.
const STRAIGHT: f64 = 0.1;

impl Features<'_> {
    /// Returns the peak of a motion at every resonance of the chain at the friction ratio β: the estimate (7.60) and
    /// the largest amplitude over all regimes.
    ///
    /// The call samples the exact amplitude and refines its peaks. The samples are close together in three places:
    /// near the resonances of the free chain, near the resonances of the chain with its contact stuck, and near the
    /// sub-harmonics of all these resonances. Further samples are in 96 even steps. The call may miss narrow peaks.
    /// Closer samples would take too long, because each steady state with stops needs much computing work.
    ///
    /// # Errors
    /// [`FeatureError::Friction`] for an invalid friction ratio. [`FeatureError::UnknownMass`] for a mass that the
    /// scene does not have.
    pub fn resonant_peaks(&self, of: Of, beta: f64) -> Result<Vec<ResonantPeak>, FeatureError> {
        check_friction(beta)?;
        let mass = self.mass_of(of)?;
        let modal = self.system.modal();
        let estimated = match of {
            Of::Mass(mass) => Some(mass),
            // The estimate describes the motion of a mass. On a moving base the contact has another motion than its
            // mass. On a support at rest the two motions are equal.
            Of::Contact if modal.on_moving_base => None,
            Of::Contact => modal.rubbing().or(mass),
            _ => None,
        };
        let places: Vec<f64> = modal.resonances.iter().map(|r| r.to_f64()).collect();
        let mut peaks = Vec::new();
        for (mode, resonance) in places.iter().enumerate() {
            let beside = |other: Option<&f64>| other.map(|other| 0.5 * (other + resonance));
            let before = mode.checked_sub(1).and_then(|before| places.get(before));
            let low = beside(before).unwrap_or(0.5 * resonance);
            let high = beside(places.get(mode + 1)).unwrap_or(1.5 * resonance);
            peaks.push(ResonantPeak {
                mode,
                resonance: *resonance,
                estimate: estimated.and_then(|mass| self.estimated(mode, mass, beta)),
                peak: if low < high {
                    self.true_peak(of, beta, [low, high])
                } else {
                    None
                },
            });
        }
        Ok(peaks)
    }

    /// Returns the estimate (7.60) of a peak's amplitude, if the estimate is positive.
    fn estimated(&self, mode: usize, mass: usize, beta: f64) -> Option<Sensed> {
        let value = self.system.resonant_peak_estimate(mode, mass, beta)?;
        if !(0.0 < value) {
            return None;
        }
        let scale = self.variations.scale;
        let value = self.variations.length(value);
        Some(self.variations.sensed(value, Some(beta), |variation| {
            let friction = variation.beta(beta, scale);
            let modal = variation.varied.modal();
            let peak = modal.resonant_peak_estimate(mode, mass, friction)?;
            Some(peak * variation.length)
        }))
    }

    fn true_peak(&self, of: Of, beta: f64, range: [f64; 2]) -> Option<TruePeak> {
        let peaks = Band::peaks_of(self.system, of, range, beta);
        let best = peaks.first().filter(|peak| !peak.edge)?;
        let none = |value: f64| Sensed {
            value,
            slopes: Vec::new(),
        };
        if best.value.is_infinite() {
            // A peak with infinite amplitude is exactly at a resonance.
            let frequency = self
                .variations
                .of_frequency(best.r, Some(beta), |variation| {
                    let mut modes = variation.varied.modal().resonances.iter();
                    let own = modes.find(|resonance| resonance.value.to_f64() == best.r)?;
                    Some(own.slope)
                });
            return Some(TruePeak {
                r: best.r,
                frequency,
                amplitude: none(f64::INFINITY),
                regime: None,
            });
        }
        let smooth = self.smooth(of, beta, best.r);
        let r = smooth.as_ref().map_or(best.r, |(r, _)| *r);
        let response = self.system.at(r).ok()?.response(beta).ok()?;
        let scale = self.variations.scale;
        let value = self.variations.length(best.value);
        // At a peak the amplitude does not change with r. The derivatives of the peak's amplitude are therefore
        // derivatives at a constant frequency.
        let amplitude = self.variations.sensed(value, Some(beta), |variation| {
            let friction = variation.beta(beta, scale);
            let r = Dual::fixed(Dd::from(r));
            let answer = swing(&variation.varied, &response, (r, friction), of, false);
            Some(answer.ok()?.0 * variation.length)
        });
        let regime = Some(response.regime());
        Some(match smooth {
            Some((r, frequency)) => TruePeak {
                r,
                frequency,
                amplitude,
                regime,
            },
            // The amplitude has a kink where the regime changes. A peak at a kink moves with the boundary of the
            // regime, and therefore has no derivatives.
            None => TruePeak {
                r,
                frequency: self.variations.of_frequency(r, Some(beta), |_| None),
                amplitude: none(value),
                regime,
            },
        })
    }

    /// Returns the frequency ratio of a smooth peak near r, and its frequency with derivatives. Returns `None` if the
    /// amplitude has a kink.
    ///
    /// At a smooth peak, ∂A/∂r = 0 for the amplitude A. The derivative of the peak's frequency ratio with respect to a
    /// parameter p is therefore dr/dp = −(∂²A/∂r∂p)/(∂²A/∂r²). The second derivatives are finite differences of exact
    /// first derivatives.
    fn smooth(&self, of: Of, beta: f64, r: f64) -> Option<(f64, Sensed)> {
        let slope = |varied: &Varied, r: Sensitive, beta: Sensitive| {
            let at = self.system.at(r.value.to_f64()).ok()?;
            let response = at.response(beta.value.to_f64()).ok()?;
            let answer = swing(varied, &response, (r, beta), of, false);
            Some(answer.ok()?.0.slope.to_f64())
        };
        let fixed = Dual::fixed(Dd::from(beta));
        let along = |r: f64| {
            let r = Dual::variable(Dd::from(r));
            slope(&self.variations.unvaried, r, fixed)
        };
        let step = BESIDE * r;
        let [far, below, above, beyond] =
            [-2.0, -1.0, 1.0, 2.0].map(|steps| along(r + steps * step));
        let (far, below, above, beyond) = (far?, below?, above?, beyond?);
        let bent = |near: f64, far: f64| (far - 2.0 * near).abs() < STRAIGHT * far.abs();
        if !(0.0 < below && above < 0.0 && bent(below, far) && bent(above, beyond)) {
            return None;
        }
        let bend = (above - below) / (2.0 * step);
        // Near a peak the amplitude is flat. The amplitude alone therefore gives only half of the digits of the peak's
        // position. The zero of the slope gives more digits.
        let r = r - along(r)? / bend;
        let scale = self.variations.scale;
        let frequency = self.variations.of_frequency(r, Some(beta), |variation| {
            let friction = variation.beta(beta, scale);
            let moved = |r: f64| slope(&variation.varied, Dual::fixed(Dd::from(r)), friction);
            let mixed = (moved(r + step)? - moved(r - step)?) / (2.0 * step);
            Some(Dd::from(-mixed / bend))
        });
        Some((r, frequency))
    }

    /// Returns the crossings of a motion, in ascending order: the frequencies at which its exact amplitudes at two
    /// friction ratios are equal. At a crossing the contact slides all the time at both friction ratios. The chain may
    /// be damped.
    ///
    /// The list comes from samples. It separates two crossings if their distance in 1/r exceeds one of
    /// [`Certainty::STEPS`](super::Certainty::STEPS) equal steps of the range.
    ///
    /// Each pair of friction ratios has its own crossings. For the contact's motion without damping, the two amplitudes
    /// only touch, at the [`invariant_points`](Self::invariant_points). The list does not contain these points.
    ///
    /// # Errors
    /// [`FeatureError::Friction`], [`FeatureError::Range`], [`FeatureError::UnknownMass`], [`FeatureError::Crowded`].
    pub fn crossings(
        &self,
        of: Of,
        [one, other]: [f64; 2],
        range: [f64; 2],
    ) -> Result<Vec<Crossing>, FeatureError> {
        check_friction(one)?;
        check_friction(other)?;
        check_range(range)?;
        self.mass_of(of)?;
        let (less, more) = (one.min(other), one.max(other));
        if less == more {
            return Ok(Vec::new());
        }
        let amplitude = |r: f64, beta: f64| -> Option<f64> {
            let motion = self.system.at(r).ok()?.motion(beta).ok()?;
            Some(motion.motion_of(of)?.amplitude())
        };
        let difference = |r: f64| match (amplitude(r, more), amplitude(r, less)) {
            (Some(more), Some(less)) => more - less,
            _ => f64::NAN,
        };
        let (regimes, _) = self.regimes(more, range)?;
        let resonances: Vec<f64> = self
            .system
            .modal()
            .resonances
            .iter()
            .map(|r| r.to_f64())
            .collect();
        let steps = steps(range);
        let mut found = Vec::new();
        for stretch in regimes
            .iter()
            .filter(|range| range.regime == Regime::Continuous)
        {
            let marks: Vec<f64> = resonances
                .iter()
                .copied()
                .filter(|r| stretch.from < *r && *r < stretch.to)
                .collect();
            // Another regime begins at each bound of the range. All samples therefore lie slightly inside the range.
            let ends = [stretch.from * (1.0 + 1e-12), stretch.to * (1.0 - 1e-12)];
            let mut places = samples(ends, SAMPLES, &marks);
            merge(&mut places, &steps);
            for r in changes(&places, difference) {
                let Some(height) = amplitude(r, less) else {
                    continue;
                };
                let on_pole = marks.iter().any(|mark| (r - mark).abs() <= 1e-12 * mark);
                if on_pole || !(difference(r).abs() <= 1e-9 * height) {
                    continue;
                }
                let share = Dual::fixed(Dd::from(less) / Dd::from(more));
                let frequency = self.variations.of_place(r, more, |varied, r, beta| {
                    let of_friction = |beta| {
                        let motion = varied.at(r).ok()?.motion(beta).ok()?;
                        Some(motion.motion_of(of)?.amplitude())
                    };
                    Some(of_friction(beta)? - of_friction(beta * share)?)
                });
                found.push(Crossing {
                    r,
                    frequency,
                    amplitude: self.variations.length(height),
                });
            }
        }
        Ok(found)
    }
}

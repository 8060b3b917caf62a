//! Resonant peaks, estimated and true, and where the exact amplitudes of two frictions cross.

use super::places::{changes, merge, samples, steps};
use super::sensed::Sensed;
use super::{FeatureError, Features, check_friction, check_range};
use crate::study::optimum::Friction;
use crate::study::optimum::peaks::Band;
use crate::study::physical::swing;
use crate::study::sensitivity::{Sensitive, Varied};
use crate::{Of, Regime};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// The largest amplitude about a resonance.
#[derive(Clone, Debug, PartialEq)]
pub struct TruePeak {
    /// r.
    pub r: f64,
    /// In Hz under a load; with its derivatives where the peak is smooth.
    pub frequency: Sensed,
    /// In m under a load; infinite on an undamped resonance below its threshold.
    pub amplitude: Sensed,
    /// The regime there; none where it is infinite.
    pub regime: Option<Regime>,
}

/// The peak of a motion at a resonance of the chain.
#[derive(Clone, Debug, PartialEq)]
pub struct ResonantPeak {
    /// The mode, counted from 0.
    pub mode: usize,
    /// √λ_i.
    pub resonance: f64,
    /// The estimate for small ζ (7.60): in m under a load.  None without damping, for the contact's motion between two masses
    /// or on a moving base, and where it is negative: friction has then taken the peak.
    pub estimate: Option<Sensed>,
    /// The largest amplitude between the middles of the gaps to the neighbouring resonances, over all regimes; none if it is
    /// largest at an end: then there is no peak.
    pub peak: Option<TruePeak>,
}

/// Where the exact amplitudes of two frictions are the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// r.
    pub r: f64,
    /// In Hz under a load; with its derivatives, the friction's at a constant ratio of both.
    pub frequency: Sensed,
    /// The amplitude there: in m under a load.
    pub amplitude: f64,
}

/// Samples over each range in which both frictions let the contact slide all the time, beside the steps of the range.
const SAMPLES: usize = 128;
/// The step of a difference beside a peak, of r.
const BESIDE: f64 = 1e-6;
/// Beside a smooth peak the slope grows in proportion to the distance, to this part.
const STRAIGHT: f64 = 0.1;

impl Features<'_> {
    /// The peak of a motion at every resonance of the chain, at β: what (7.60) estimates and the largest amplitude itself,
    /// over all regimes.  The true peaks are sampled and refined: closely about the resonances of the chain and of the chain
    /// with its contact stuck and about their odd sub-harmonics, and at 96 places between.  An amplitude that is steady over
    /// frequency costs much where the motion stops; no resolution is promised.
    ///
    /// # Errors
    /// [`FeatureError::Friction`], [`FeatureError::UnknownMass`].
    pub fn resonant_peaks(&self, of: Of, beta: f64) -> Result<Vec<ResonantPeak>, FeatureError> {
        check_friction(beta)?;
        let mass = self.mass_of(of)?;
        let modal = self.system.modal();
        let estimated = match of {
            Of::Mass(mass) => Some(mass),
            // The contact's motion is that of its mass, against a support at rest.
            Of::Contact if modal.on_moving_base => None,
            Of::Contact => modal.rubbing().or(mass),
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

    /// (7.60), if it is positive.
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
        let band = Band::new(self.system, of, range);
        let peaks = band.peaks(Friction::Ratio(beta));
        let best = peaks.first().filter(|peak| !peak.edge)?;
        let none = |value: f64| Sensed {
            value,
            slopes: Vec::new(),
        };
        if best.value.is_infinite() {
            // It stays on its resonance.
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
        // At a peak the amplitude does not change with r: its derivatives are those at a constant r, or at a constant Hz.
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
            // On a kink, where the regime changes, the peak moves along it.
            None => TruePeak {
                r,
                frequency: self.variations.of_frequency(r, Some(beta), |_| None),
                amplitude: none(value),
                regime,
            },
        })
    }

    /// The place of a smooth peak near r, and how it moves; none where the amplitude has a kink.
    ///
    /// ∂A/∂r is 0 there, so that dr/dp = −(∂²A/∂r∂p)/(∂²A/∂r²).  Second derivatives are differences of exact first ones.
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
        // The amplitude itself is flat and tells the place to half of the digits only.
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

    /// Where the exact amplitudes of a motion at two friction ratios cross, as long as the contact slides all the time at
    /// both: ascending.  With damping too.  Sampled: two that are further apart than one of
    /// [`Certainty::STEPS`](super::Certainty::STEPS) equal parts of the range, over 1/r, are told apart.
    ///
    /// Each pair of frictions has its own crossings; of the contact's motion without damping they are the
    /// [`invariant_points`](Self::invariant_points), where the amplitudes touch, and are not listed here.
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
            Some(match of {
                Of::Contact => motion.contact().amplitude(),
                Of::Mass(mass) => motion.mass_at(mass)?.amplitude(),
            })
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
            // The end of the regime belongs to another.
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
                        Some(match of {
                            Of::Contact => motion.contact().amplitude(),
                            Of::Mass(mass) => motion.mass_at(mass)?.amplitude(),
                        })
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

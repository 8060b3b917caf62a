//! Resonant peaks, estimated and true, and where the exact amplitudes of two frictions cross.

use super::places::{changes, samples};
use super::sensed::Sensed;
use super::{FeatureError, Features, check_friction, check_range};
use crate::study::optimum::peaks::Band;
use crate::study::optimum::{Friction, PEAK_PLACE};
use crate::study::physical::swing;
use crate::{Of, Regime};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// The largest amplitude about a resonance.
#[derive(Clone, Debug, PartialEq)]
pub struct TruePeak {
    /// r, to 1e-8 of it where the peak is smooth: an amplitude is flat there.
    pub r: f64,
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

/// Samples over each range in which both frictions let the contact slide all the time.
const SAMPLES: usize = 512;

impl Features<'_> {
    /// The peak of a motion at every resonance of the chain, at β: what (7.60) estimates and the largest amplitude itself,
    /// over all regimes.  The true peaks are sampled and refined: [`Certainty::Sampled`](super::Certainty::Sampled).
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
            return Some(TruePeak {
                r: best.r,
                amplitude: none(f64::INFINITY),
                regime: None,
            });
        }
        let response = self.system.at(best.r).ok()?.response(beta).ok()?;
        let scale = self.variations.scale;
        let value = self.variations.length(best.value);
        // At a peak the amplitude does not change with r: its derivatives are those at a constant r, or at a constant Hz.
        let amplitude = self.variations.sensed(value, Some(beta), |variation| {
            let friction = variation.beta(beta, scale);
            let r = Dual::fixed(Dd::from(best.r));
            let answer = swing(&variation.varied, &response, (r, friction), of, false);
            Some(answer.ok()?.0 * variation.length)
        });
        let smooth = PEAK_PLACE * 1e3 * best.r;
        let beside = |r: f64| self.system.at(r).ok()?.response(beta).ok()?.swing(of);
        let kinked = [best.r - smooth, best.r + smooth].iter().any(|r| {
            beside(*r).is_none_or(|swing| (best.value - swing.amplitude) > 1e-7 * best.value)
        });
        Some(TruePeak {
            r: best.r,
            // On a kink, where the regime changes, the peak moves along it.
            amplitude: if kinked { none(value) } else { amplitude },
            regime: Some(response.regime()),
        })
    }

    /// Where the exact amplitudes of a motion at two friction ratios cross, as long as the contact slides all the time at
    /// both: ascending.  With damping too.  Sampled: [`Certainty::Sampled`](super::Certainty::Sampled).
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
        let gain = |r: f64| match (amplitude(r, more), amplitude(r, less)) {
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
            for r in changes(&samples(ends, SAMPLES, &marks), gain) {
                let Some(height) = amplitude(r, less) else {
                    continue;
                };
                let on_pole = marks.iter().any(|mark| (r - mark).abs() <= 1e-12 * mark);
                if on_pole || !(gain(r).abs() <= 1e-9 * height) {
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

//! Computes all features.

use crate::asked::Part;
use frictiongen::study::{
    Antiresonance, Certainty, Crossing, FeatureError, Features, HeldResonance, InvariantPoint,
    Inversion, LimitsAtEnd, Measured, RegimeRange, Resonance, ResonantPeak, Sensed, SlidingRange,
};

/// A feature of a motion.
pub struct Named<T> {
    /// Name of the motion.
    pub of: String,
    /// The feature.
    pub it: T,
}

/// A feature at a friction.
pub struct At<T> {
    /// Friction ratio β.
    pub beta: f64,
    /// The feature.
    pub it: T,
}

/// Lists of features, each in the order of the library.
pub struct Found {
    /// Resonances of the chain.
    pub resonances: Vec<Resonance>,
    /// Resonances of the chain with its contact stuck.
    pub held: Vec<HeldResonance>,
    /// Limits for r → 0 and r → ∞.
    pub ends: Vec<(f64, LimitsAtEnd)>,
    /// Frequencies at which a motion vanishes without friction.
    pub antiresonances: Vec<Named<Antiresonance>>,
    /// Frequencies at which no friction changes a motion.
    pub invariant: Vec<Named<(Measured, InvariantPoint)>>,
    /// Ranges in which friction enlarges a motion.
    pub inversions: Vec<Named<(Measured, Inversion)>>,
    /// Motion of each mass for r → 0; `None` where the contact is stuck.
    pub starts: Vec<At<Named<Option<Sensed>>>>,
    /// Ranges in which the contact slides.
    pub sliding: Vec<At<SlidingRange>>,
    /// Regimes along frequency.
    pub regimes: Vec<At<(Certainty, RegimeRange)>>,
    /// Peaks at the resonances.
    pub peaks: Vec<At<Named<ResonantPeak>>>,
    /// Frequencies at which two neighbouring frictions give the same amplitude.
    pub crossings: Vec<At<Named<(f64, Crossing)>>>,
}

impl Found {
    /// Computes all features in a range.
    pub fn of(
        features: &Features<'_>,
        parts: &[Part],
        frictions: &[f64],
        range: [f64; 2],
    ) -> Result<Self, FeatureError> {
        let mut found = Self {
            resonances: features.resonances(),
            held: features.held_resonances(),
            ends: vec![
                (0.0, features.limits_at_rest()),
                (f64::INFINITY, features.limits_at_infinity()),
            ],
            antiresonances: Vec::new(),
            invariant: Vec::new(),
            inversions: Vec::new(),
            starts: Vec::new(),
            sliding: Vec::new(),
            regimes: Vec::new(),
            peaks: Vec::new(),
            crossings: Vec::new(),
        };
        if !features.system().modal().is_damped() {
            for part in parts {
                found.undamped(features, part, range)?;
            }
        }
        for beta in frictions {
            found.with_friction(features, parts, *beta, range)?;
        }
        for pair in frictions.windows(2) {
            let &[one, other] = pair else { continue };
            for part in parts {
                let crossings = features.crossings(part.of, [one, other], range)?;
                let of = part.name.as_str();
                found.crossings.extend(crossings.into_iter().map(|it| At {
                    beta: one,
                    it: Named {
                        of: of.to_owned(),
                        it: (other, it),
                    },
                }));
            }
        }
        Ok(found)
    }

    fn undamped(
        &mut self,
        features: &Features<'_>,
        part: &Part,
        range: [f64; 2],
    ) -> Result<(), FeatureError> {
        fn named<T>(part: &Part, it: T) -> Named<T> {
            let of = part.name.clone();
            Named { of, it }
        }
        let zeros = features.antiresonances(part.of, range)?;
        self.antiresonances
            .extend(zeros.into_iter().map(|it| named(part, it)));
        for measured in [Measured::Amplitude, Measured::Fundamental] {
            let points = features.invariant_points(part.of, measured, range)?;
            self.invariant
                .extend(points.into_iter().map(|it| named(part, (measured, it))));
            let ranges = features.inversions(part.of, measured, range)?;
            self.inversions
                .extend(ranges.into_iter().map(|it| named(part, (measured, it))));
        }
        Ok(())
    }

    fn with_friction(
        &mut self,
        features: &Features<'_>,
        parts: &[Part],
        beta: f64,
        range: [f64; 2],
    ) -> Result<(), FeatureError> {
        let mut starts = features.quasi_static_start(beta)?.map(Vec::into_iter);
        for mass in &features.system().scene().masses {
            let of = mass.name.clone();
            let it = starts.as_mut().and_then(Iterator::next);
            self.starts.push(At {
                beta,
                it: Named { of, it },
            });
        }
        let ranges = features.sliding_ranges(beta, range)?;
        self.sliding
            .extend(ranges.into_iter().map(|it| At { beta, it }));
        let (regimes, certainty) = features.regimes(beta, range)?;
        self.regimes.extend(regimes.into_iter().map(|it| At {
            beta,
            it: (certainty, it),
        }));
        for part in parts {
            let peaks = features.resonant_peaks(part.of, beta)?;
            self.peaks.extend(peaks.into_iter().map(|it| At {
                beta,
                it: Named {
                    of: part.name.clone(),
                    it,
                },
            }));
        }
        Ok(())
    }
}

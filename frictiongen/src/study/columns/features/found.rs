//! Computes all features of a system's response: resonances, limits, invariant points, ranges and peaks.

use crate::study::columns::column::TableRow;
use crate::study::columns::setting::MovingPart;
use crate::study::features::{
    Antiresonance, Certainty, Crossing, FeatureError, Features, HeldResonance, InvariantPoint,
    InvariantQuantity, Inversion, LimitsAtEnd, RegimeRange, Resonance, ResonantPeak, Sensed,
    SlidingRange,
};

/// A feature of the response that belongs to the motion of the contact or of a mass.
pub(super) struct Named<T> {
    /// Name of the contact or mass that has the feature.
    pub(super) of: String,
    /// Data of the feature itself, such as a resonance or a range.
    pub(super) it: T,
}

/// A feature of the response at one friction ratio.
pub(super) struct FeatureAt<T> {
    /// Friction ratio β = F/P (F/(k₁Y) for base motion).
    pub(super) beta: f64,
    /// Data of the feature itself, such as a resonance or a range.
    pub(super) it: T,
}

/// All features of a response, in lists. Each list keeps the order in which the library returns its features.
pub struct FeatureLists {
    /// Resonances of the chain.
    pub(super) resonances: Vec<NumberedResonance>,
    /// Resonances of the chain with its contact stuck.
    pub(super) held: Vec<HeldResonance>,
    /// The limit of continuous motion β_lim and the limit of sliding β*_lim, both for r → 0 and for r → ∞.
    pub(super) ends: Vec<EndRow>,
    /// Antiresonances: frequencies at which a motion vanishes without friction.
    pub(super) antiresonances: Vec<Named<Antiresonance>>,
    /// Invariant points: frequencies at which friction does not change the amplitude of a motion.
    pub(super) invariant: Vec<Named<(InvariantQuantity, InvariantPoint)>>,
    /// Inversions: ranges of frequency in which the amplitude of a motion increases with friction.
    pub(super) inversions: Vec<Named<(InvariantQuantity, Inversion)>>,
    /// Quasi-static start: displacement of each mass for the frequency ratio r → 0. `None` if the contact is stuck.
    pub(super) starts: Vec<FeatureAt<Named<Option<Sensed>>>>,
    /// Ranges of frequency in which the contact slides.
    pub(super) sliding: Vec<FeatureAt<SlidingRange>>,
    /// Ranges of frequency. In each range the contact has a single regime.
    pub(super) regimes: Vec<FeatureAt<(Certainty, RegimeRange)>>,
    /// Largest amplitudes near the resonances.
    pub(super) peaks: Vec<FeatureAt<Named<ResonantPeak>>>,
    /// Crossings: frequencies at which a motion has the same amplitude for two neighbouring friction ratios of the
    /// request. The number in an entry is the second of the two friction ratios.
    pub(super) crossings: Vec<FeatureAt<Named<(f64, Crossing)>>>,
}

impl<T> TableRow for Named<T> {}

impl<T> TableRow for FeatureAt<T> {}

impl TableRow for HeldResonance {}

/// A resonance of the chain, with the number of its mode, counted from 1.
pub(super) struct NumberedResonance {
    pub(super) number: usize,
    pub(super) it: Resonance,
}

impl TableRow for NumberedResonance {}

/// The limit of continuous motion β_lim and the limit of sliding β*_lim, for r → 0 or for r → ∞.
pub(super) struct EndRow {
    pub(super) r: f64,
    pub(super) limits: LimitsAtEnd,
}

impl TableRow for EndRow {}

impl FeatureLists {
    /// Computes all features of a response in a range of frequency ratios.
    ///
    /// # Errors
    /// Same errors as the calls of [`Features`].
    pub fn of(
        features: &Features<'_>,
        parts: &[MovingPart],
        frictions: &[f64],
        range: [f64; 2],
    ) -> Result<Self, FeatureError> {
        let mut found = Self {
            resonances: (1..)
                .zip(features.resonances())
                .map(|(number, it)| NumberedResonance { number, it })
                .collect(),
            held: features.held_resonances(),
            ends: vec![
                EndRow {
                    r: 0.0,
                    limits: features.limits_at_rest(),
                },
                EndRow {
                    r: f64::INFINITY,
                    limits: features.limits_at_infinity(),
                },
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
                found
                    .crossings
                    .extend(crossings.into_iter().map(|it| FeatureAt {
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
        part: &MovingPart,
        range: [f64; 2],
    ) -> Result<(), FeatureError> {
        fn named<T>(part: &MovingPart, it: T) -> Named<T> {
            let of = part.name.clone();
            Named { of, it }
        }
        let zeros = features.antiresonances(part.of, range)?;
        self.antiresonances
            .extend(zeros.into_iter().map(|it| named(part, it)));
        for measured in [InvariantQuantity::Amplitude, InvariantQuantity::Fundamental] {
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
        parts: &[MovingPart],
        beta: f64,
        range: [f64; 2],
    ) -> Result<(), FeatureError> {
        let mut starts = features.quasi_static_start(beta)?.map(Vec::into_iter);
        // The library does not compute the quasi-static start (the displacements for r → 0) of a chain with an elastic
        // contact.
        let scene = features.system().scene();
        let masses = scene.masses.iter().filter(|_| scene.stiffness.is_none());
        for mass in masses {
            let of = mass.name.clone();
            let it = starts.as_mut().and_then(Iterator::next);
            self.starts.push(FeatureAt {
                beta,
                it: Named { of, it },
            });
        }
        let ranges = features.sliding_ranges(beta, range)?;
        self.sliding
            .extend(ranges.into_iter().map(|it| FeatureAt { beta, it }));
        let (regimes, certainty) = features.regimes(beta, range)?;
        self.regimes.extend(regimes.into_iter().map(|it| FeatureAt {
            beta,
            it: (certainty, it),
        }));
        for part in parts {
            let peaks = features.resonant_peaks(part.of, beta)?;
            self.peaks.extend(peaks.into_iter().map(|it| FeatureAt {
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

//! Collects the features of a response as lines, one for each feature.

use crate::study::columns::column::TableRow;
use crate::study::columns::setting::{MovingPart, Setting};
use crate::study::response::SystemResponse;
use crate::study::{
    features::{Certainty, FeatureError, Features, InvariantQuantity, RegimeEnd, Sensed},
    sensitivity::Parameter,
    words,
};
use crate::{Of, Regime};

/// Method that found a feature. The method determines how certain the feature is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// A formula gives the feature.
    Exact,
    /// The monoharmonic formula (7.60) of the thesis gives the feature. The result is an approximation of the exact
    /// peak.
    Estimate,
    /// Interval arithmetic has found the feature. Interval arithmetic finds every feature of this type in the range.
    All,
    /// A search from closely spaced samples has found the feature. The search may miss two features that are closer to
    /// each other than two neighbouring samples.
    Sampled,
}

impl Ground {
    /// Returns the word that the table prints for the method.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Estimate => "estimate",
            Self::All => words::certainty(Certainty::Proven),
            Self::Sampled => words::certainty(Certainty::SAMPLED),
        }
    }
}

/// A feature of the response with its numbers, as one line of the table.
#[derive(Clone, Debug)]
pub struct FeatureLine {
    /// Name of the feature.
    pub feature: &'static str,
    /// The chain, the contact or the mass that has the feature.
    pub of: String,
    /// Details of the feature in words, such as the condition of an invariant point.
    pub detail: String,
    /// Frequency ratio r of the feature, or the frequency ratio at which the feature begins. `None` if the feature has
    /// no frequency.
    pub r: Option<f64>,
    /// Frequency ratio r at which the feature ends, if it is a range.
    pub to: Option<f64>,
    /// Friction at which the feature exists, or up to which the feature is valid. Under a load it is a force in N, and
    /// otherwise a friction ratio β.
    pub friction: Option<f64>,
    /// Amplitude of the motion at the feature. Under a load it is in m, and otherwise a non-dimensional group.
    pub amplitude: Option<f64>,
    /// The method that found the feature.
    pub ground: Ground,
    /// Numbers of the feature, each with its name, its value and its derivatives with respect to the parameters. The
    /// printed table contains the strongest derivative of the first number.
    pub sensed: Vec<(&'static str, Sensed)>,
}

impl FeatureLine {
    pub(super) fn new(feature: &'static str, of: impl Into<String>, ground: Ground) -> Self {
        Self {
            feature,
            of: of.into(),
            detail: String::new(),
            r: None,
            to: None,
            friction: None,
            amplitude: None,
            ground,
            sensed: Vec::new(),
        }
    }

    fn at(mut self, r: f64, frequency: Sensed) -> Self {
        self.r = Some(r);
        self.sensed.push(("frequency", frequency));
        self
    }

    fn with_friction(mut self, friction: Sensed) -> Self {
        self.friction = Some(friction.value);
        self.sensed.push(("friction", friction));
        self
    }

    fn with_amplitude(mut self, amplitude: Sensed) -> Self {
        self.amplitude = Some(amplitude.value);
        self.sensed.push(("amplitude", amplitude));
        self
    }

    /// Returns the name of the feature's first number, and the parameter to which this number is most sensitive. The
    /// third item is the change of the number in per cent for a change of the parameter by one per cent.
    #[must_use]
    pub fn strongest(&self) -> Option<(&'static str, Parameter, f64)> {
        let (name, sensed) = self.sensed.first()?;
        let (parameter, relative) = sensed.strongest()?;
        Some((name, parameter, relative))
    }

    pub(super) fn saying(mut self, detail: impl Into<String>) -> Self {
        self.detail = detail.into();
        self
    }
}

impl TableRow for FeatureLine {}

/// A request for features: the friction ratios and the range of frequency ratios.
#[derive(Clone, Copy, Debug)]
pub struct FeaturesAsked<'a> {
    /// Range of the frequency ratio r in which the features are listed.
    pub range: [f64; 2],
    /// Friction ratios β for which the features are computed.
    pub frictions: &'a [f64],
    /// True if the result contains the exact peaks. For a chain of many masses, their computation takes much time.
    pub peaks: bool,
}

/// Returns all features of a scene. Features that do not depend on friction come first.
pub(super) fn lines(
    features: &Features<'_>,
    setting: &Setting<'_>,
    asked: FeaturesAsked<'_>,
) -> Result<Vec<FeatureLine>, FeatureError> {
    let (system, measure, parts) = (setting.system, &setting.measure, setting.parts);
    let FeaturesAsked {
        range,
        frictions,
        peaks,
    } = asked;
    let mut lines = Vec::new();
    resonances(features, &mut lines);
    ends(features, &mut lines);
    if !system.modal().is_damped() {
        for part in parts {
            undamped(features, part, range, &mut lines)?;
        }
    }
    for beta in frictions {
        let own = AtOneFriction {
            features,
            friction: measure.force(*beta),
            beta: *beta,
            range,
        };
        let parts = if peaks { parts } else { &[] };
        own.lines(parts, &mut lines)?;
    }
    for pair in frictions.windows(2) {
        let &[one, other] = pair else { continue };
        for part in parts {
            let found = features.crossings(part.of, [one, other], range)?;
            for crossing in found {
                let [one, other] = [one, other].map(|beta| measure.force(beta));
                let mut line = FeatureLine::new("same amplitude", &part.name, Ground::Sampled)
                    .at(crossing.r, crossing.frequency)
                    .saying(format!("with friction {one:?} and {other:?}"));
                line.amplitude = Some(crossing.amplitude);
                lines.push(line);
            }
        }
    }
    Ok(lines)
}

fn resonances(features: &Features<'_>, lines: &mut Vec<FeatureLine>) {
    let elastic = features.system().scene().stiffness.is_some();
    for (mode, resonance) in (1..).zip(features.resonances()) {
        let damped = 0.0 < resonance.damping_ratio;
        let of = format!("mode {mode}");
        let mut line = FeatureLine::new("resonance", of.as_str(), Ground::Exact)
            .at(resonance.r, resonance.frequency);
        let bounded = if damped {
            "slides all the time up to"
        } else {
            "bounded from"
        };
        match resonance.threshold {
            Some(threshold) if !damped => line = line.with_friction(threshold).saying(bounded),
            Some(threshold) => {
                if elastic {
                    line = line.saying("sticks after each reversal");
                } else {
                    line = line.saying(bounded);
                    line.friction = Some(resonance.continuous_limit);
                }
                let mut without = FeatureLine::new("threshold without damping", of, Ground::Exact)
                    .with_friction(threshold);
                without.r = Some(resonance.r);
                lines.push(without);
            }
            None => line = line.saying("the contact does not touch it"),
        }
        lines.push(line);
    }
    for held in features.held_resonances() {
        let detail = match (held.new, held.sliding_limit.is_infinite()) {
            (false, _) => "the contact does not touch it",
            (true, true) => "slides whatever the friction",
            (true, false) => "slides up to",
        };
        let mut line = FeatureLine::new("resonance if stuck", "", Ground::Exact)
            .at(held.r, held.frequency)
            .saying(detail);
        if held.new {
            line.friction = Some(held.sliding_limit);
        }
        lines.push(line);
    }
}

fn ends(features: &Features<'_>, lines: &mut Vec<FeatureLine>) {
    let rest = features.limits_at_rest();
    let contact = features.system().name_of_motion(Of::Contact);
    lines.push(
        FeatureLine::new("limit for r -> 0", &contact, Ground::Exact)
            .with_friction(rest.sliding)
            .saying("slides up to"),
    );
    let infinity = features.limits_at_infinity();
    let elastic = features.system().scene().stiffness.is_some();
    for (limit, detail) in [
        (infinity.continuous, "slides all the time up to"),
        (infinity.sliding, "slides up to"),
    ] {
        // An elastic contact never slides all the time.
        if elastic && detail == "slides all the time up to" {
            continue;
        }
        lines.push(
            FeatureLine::new("limit for r -> inf", &contact, Ground::Exact)
                .with_friction(limit)
                .saying(detail),
        );
    }
}

fn undamped(
    features: &Features<'_>,
    part: &MovingPart,
    range: [f64; 2],
    lines: &mut Vec<FeatureLine>,
) -> Result<(), FeatureError> {
    for zero in features.antiresonances(part.of, range)? {
        lines.push(
            FeatureLine::new("antiresonance", &part.name, Ground::All).at(zero.r, zero.frequency),
        );
    }
    for measured in [InvariantQuantity::Amplitude, InvariantQuantity::Fundamental] {
        let name = words::measured(measured);
        for point in features.invariant_points(part.of, measured, range)? {
            let condition = words::condition(&point);
            let mut line = FeatureLine::new("invariant point", &part.name, Ground::All)
                .at(point.r, point.frequency)
                .saying(format!("{name}: {condition}"));
            line.amplitude = Some(point.amplitude);
            line.friction = Some(point.continuous_limit);
            lines.push(line);
        }
        for found in features.inversions(part.of, measured, range)? {
            let [from, to] = [found.from_edge, found.to_edge].map(words::edge);
            let mut line = FeatureLine::new("grows with friction", &part.name, Ground::All)
                .saying(format!("{name}: {from} to {to}"));
            (line.r, line.to) = (Some(found.from), Some(found.to));
            lines.push(line);
        }
    }
    Ok(())
}

/// The features of a response at one friction ratio.
struct AtOneFriction<'f, 's> {
    features: &'f Features<'s>,
    beta: f64,
    friction: f64,
    range: [f64; 2],
}

/// Returns a text that states for which fraction of the period an elastic contact sticks.
fn sticks(share: f64) -> String {
    format!("sticks {:.0} % of the period", 100.0 * share)
}

impl AtOneFriction<'_, '_> {
    /// Returns the fraction of the period during which an elastic contact sticks. Returns `None` for a rigid contact,
    /// and for every regime except stick-slip.
    fn sticking(&self, regime: Regime, r: f64) -> Option<f64> {
        let system = self.features.system();
        if system.scene().stiffness.is_none() || regime != Regime::StickSlip {
            return None;
        }
        match system.at(r).ok()?.response(self.beta).ok()? {
            SystemResponse::StickSlip(orbit) => Some(orbit.stuck_fraction()),
            _ => None,
        }
    }

    /// Returns a line for a feature of the response at this friction ratio.
    fn line(&self, feature: &'static str, of: &str, ground: Ground) -> FeatureLine {
        let mut line = FeatureLine::new(feature, of, ground);
        line.friction = Some(self.friction);
        line
    }

    fn lines(
        &self,
        parts: &[MovingPart],
        lines: &mut Vec<FeatureLine>,
    ) -> Result<(), FeatureError> {
        let scene = self.features.system().scene();
        let (masses, elastic) = (&scene.masses, scene.stiffness.is_some());
        let contact = self.features.system().name_of_motion(Of::Contact);
        match self.features.quasi_static_start(self.beta)? {
            Some(start) => {
                for (mass, start) in masses.iter().zip(start) {
                    let line = self.line("quasi-static start", &mass.name, Ground::Exact);
                    lines.push(line.with_amplitude(start));
                }
            }
            None if elastic => {}
            None => lines.push(
                self.line("quasi-static start", &contact, Ground::Exact)
                    .saying("stuck"),
            ),
        }
        for found in self.features.sliding_ranges(self.beta, self.range)? {
            let mut line = self.line("slides", &contact, Ground::All);
            line = line.saying(match elastic {
                true => "in turns",
                false => "all the time or in turns",
            });
            (line.r, line.to) = (Some(found.from), Some(found.to));
            let ends = [
                ("frequency", found.from_frequency),
                ("to_frequency", found.to_frequency),
            ];
            let known = ends.into_iter();
            line.sensed
                .extend(known.filter_map(|(name, sensed)| Some((name, sensed?))));
            lines.push(line);
        }
        let (ranges, certainty) = self.features.regimes(self.beta, self.range)?;
        let ground = match certainty {
            Certainty::Proven => Ground::All,
            Certainty::Sampled { .. } => Ground::Sampled,
        };
        for found in ranges {
            let mut line = self.line("regime", &contact, ground);
            let middle = 0.5 * (found.from + found.to);
            line = line.saying(match self.sticking(found.regime, middle) {
                Some(share) => format!("stick-slip ({} in mid-range)", sticks(share)),
                None => words::regime(found.regime).to_owned(),
            });
            (line.r, line.to) = (Some(found.from), Some(found.to));
            if let RegimeEnd::Continuous(sensed) | RegimeEnd::Sliding(sensed) = found.end {
                line.sensed.push(("to_frequency", sensed));
            }
            lines.push(line);
        }
        for part in parts {
            for peak in self.features.resonant_peaks(part.of, self.beta)? {
                if let Some(estimate) = peak.estimate {
                    let mut line = self
                        .line("peak by estimate", &part.name, Ground::Estimate)
                        .with_amplitude(estimate)
                        .saying(format!("mode {}", peak.mode + 1));
                    line.r = Some(peak.resonance);
                    lines.push(line);
                }
                if let Some(found) = peak.peak {
                    let mut regime = found.regime.map_or("unbounded", words::regime).to_owned();
                    let share = found.regime.and_then(|one| self.sticking(one, found.r));
                    if let Some(share) = share {
                        regime += &format!(" ({})", sticks(share));
                    }
                    let line = self
                        .line("peak", &part.name, Ground::Sampled)
                        .with_amplitude(found.amplitude)
                        .saying(format!("mode {}: {regime}", peak.mode + 1));
                    lines.push(line.at(found.r, found.frequency));
                }
            }
        }
        Ok(())
    }
}

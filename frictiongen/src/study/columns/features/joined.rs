//! Lines of the features of a scene with several contacts, with dashpots, or with masses that no path of springs
//! connects to a support.

use super::lines::{FeatureLine, Ground};
use crate::Of;
use crate::study::columns::setting::{MovingPart, Setting};
use crate::study::features::FeatureError;
use crate::study::joined::{DampedMode, DampedModes, Joined, JoinedError};
use crate::study::response::MotionQuantity;

/// Largest number of names in the words for a set of stuck contacts.
const MOST_NAMES: usize = 4;

/// Returns the words for a set of stuck contacts.
#[must_use]
pub fn words_of_set(stuck: &[String]) -> String {
    match stuck {
        [] => "free".to_owned(),
        names if MOST_NAMES < names.len() => format!("all {} contacts stuck", names.len()),
        names => format!("{} stuck", names.join(" + ")),
    }
}

/// The features of one scene in a range of frequency ratios.
struct Search<'s> {
    setting: &'s Setting<'s>,
    joined: Joined<'s>,
    range: [f64; 2],
    lines: Vec<FeatureLine>,
}

/// Returns all features of a scene. The list has no derivatives.
pub(super) fn lines(
    setting: &Setting<'_>,
    range: [f64; 2],
) -> Result<Vec<FeatureLine>, FeatureError> {
    let joined = setting.system.joined()?;
    let is_physical = setting.frequency.is_physical() && setting.measure.scale().is_some();
    if !is_physical && joined.scene().springs.is_empty() {
        return Err(JoinedError::NoSpring.into());
    }
    let joined = match setting.measure.scale() {
        Some(scale) => joined.with_length(scale.length()),
        None => joined,
    };
    let sets = joined.damped_modes()?;
    let mut search = Search {
        setting,
        joined,
        range,
        lines: Vec::new(),
    };
    for set in &sets {
        search.resonances(set);
    }
    search.largest_limit(sets.last())?;
    search.continuous_limits(sets.first());
    if !search.joined.is_damped() {
        for part in setting.parts {
            search.antiresonances(part)?;
        }
    }
    Ok(search.lines)
}

impl Search<'_> {
    fn ratio(&self, mode: &DampedMode) -> f64 {
        mode.frequency / self.setting.system.angular_frequency(1.0)
    }

    fn is_inside(&self, r: f64) -> bool {
        let [from, to] = self.range;
        from <= r && r <= to
    }

    /// Adds a line for each mode of a set. The line of an oscillation has the friction from which no contact slides at
    /// its frequency.
    fn resonances(&mut self, set: &DampedModes) {
        for (number, mode) in (1..).zip(&set.modes) {
            let of = words_of_set(&set.stuck);
            let Some(zeta) = mode.damping_ratio else {
                let detail = format!("mode {number}: rate {:.6} 1/s", mode.decay_rate);
                let line = FeatureLine::new("decay", of, Ground::Exact);
                self.lines.push(line.saying(detail));
                continue;
            };
            let mut line = FeatureLine::new("resonance", of, Ground::Exact);
            line.r = Some(self.ratio(mode));
            if mode.frequency == 0.0 {
                self.lines
                    .push(line.saying(format!("mode {number}: rigid body")));
                continue;
            }
            let mut detail = match zeta {
                0.0 => format!("mode {number}: undamped"),
                zeta if zeta < 1e-3 => format!("mode {number}: zeta {zeta:.5e}"),
                zeta => format!("mode {number}: zeta {zeta:.6}"),
            };
            if let Ok(found) = self.joined.stuck_limit(self.ratio(mode)) {
                line.friction = Some(self.setting.measure.force(found.limit));
                detail += &match found.limit {
                    limit if limit.is_infinite() => "; slides whatever the friction".to_owned(),
                    _ => format!("; {} slides below", found.first),
                };
            }
            self.lines.push(line.saying(detail));
        }
    }

    /// Adds the largest friction from which no contact slides.
    fn largest_limit(&mut self, stuck: Option<&DampedModes>) -> Result<(), FeatureError> {
        let marks: Vec<f64> = stuck
            .iter()
            .flat_map(|set| &set.modes)
            .map(|mode| self.ratio(mode))
            .collect();
        let found = match self.joined.largest_stuck_limit(self.range, &marks) {
            Ok(Some(found)) => found,
            // The scene has no closed form of this limit, or needs a load for it.
            Ok(None)
            | Err(
                JoinedError::NotLinear | JoinedError::NoAmplitude | JoinedError::OutOfDomain(_),
            ) => return Ok(()),
            Err(error) => return Err(error.into()),
        };
        let mut line = FeatureLine::new("limit of sliding", found.first, Ground::Sampled)
            .saying("largest in the range; slides up to");
        line.r = Some(found.r);
        line.friction = Some(self.setting.measure.force(found.limit));
        self.lines.push(line);
        Ok(())
    }

    /// Adds the friction up to which all contacts slide all the time, at each damped resonance without friction. An
    /// elastic contact sticks after each reversal. On an undamped resonance, the amplitude is unbounded below a
    /// threshold.
    fn continuous_limits(&mut self, free: Option<&DampedModes>) {
        let mut contacts = self.joined.chain().contacts.iter();
        if contacts.any(|contact| contact.stiffness.is_some()) {
            return;
        }
        for mode in free.iter().flat_map(|set| &set.modes) {
            let r = self.ratio(mode);
            if !self.is_inside(r) || mode.damping_ratio == Some(0.0) {
                continue;
            }
            let Ok(limit) = self.joined.at_any(r).and_then(|at| at.continuous_limit()) else {
                continue;
            };
            let mut line = FeatureLine::new(
                "limit of continuous motion",
                "all contacts",
                Ground::Sampled,
            )
            .saying("slide all the time up to");
            line.r = Some(r);
            line.friction = Some(self.setting.measure.force(limit));
            self.lines.push(line);
        }
    }

    /// Adds the antiresonances of a mass in the chain on which no contact acts, and in the chain with all contacts
    /// stuck.
    fn antiresonances(&mut self, part: &MovingPart) -> Result<(), FeatureError> {
        let (Of::Mass(mass), MotionQuantity::Displacement) = (part.of, part.size) else {
            return Err(FeatureError::Combination);
        };
        for (is_stuck, detail) in [(false, "free"), (true, "all contacts stuck")] {
            for r in self.joined.antiresonances(mass, self.range, is_stuck)? {
                let mut line = FeatureLine::new("antiresonance", &part.name, Ground::All);
                line.r = Some(r);
                self.lines.push(line.saying(detail));
            }
        }
        Ok(())
    }
}

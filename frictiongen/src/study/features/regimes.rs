//! Regimes over frequency at a given friction ratio.

use super::functions::Target;
use super::isolate::MotionFunction;
use super::places::{changes, merge, samples, steps};
use super::sensed::Sensed;
use super::sliding::Bound;
use super::{Certainty, FeatureError, Features, check_friction, check_range, exact};
use crate::Regime;

/// The reason why a range of frequencies with one regime ends at its upper bound.
#[derive(Clone, Debug, PartialEq)]
pub enum RegimeEnd {
    /// The requested range of frequencies ends at this bound.
    Range,
    /// At this bound the limit of continuous motion β_lim equals the friction. The field is the frequency, in Hz under
    /// a load.
    Continuous(Sensed),
    /// At this bound the limit of sliding β*_lim equals the friction. The field is the frequency, in Hz under a load.
    Sliding(Sensed),
}

/// A range of the frequency ratio r with a single regime.
#[derive(Clone, Debug, PartialEq)]
pub struct RegimeRange {
    /// Lower bound of the range, as frequency ratio r.
    pub from: f64,
    /// Upper bound of the range, as frequency ratio r.
    pub to: f64,
    /// Regime of the contact in this range of frequency ratios.
    pub regime: Regime,
    /// Reason why the range ends at its upper bound.
    pub end: RegimeEnd,
}

/// Number of samples in each interval of frequencies in which β_lim may exceed β. Further samples cover the requested
/// range and are evenly spaced in 1/r.
const SAMPLES: usize = 128;
/// Largest number of odd sub-harmonics of a resonance near which the search uses additional samples.
const SUBHARMONICS: usize = 12;

impl Features<'_> {
    /// Returns the regimes over the frequency ratio r at the friction ratio β, in ascending order, and the completeness
    /// of the list.
    ///
    /// Interval arithmetic finds the frequencies at which β*_lim = β. β_lim, however, depends on a search over the half
    /// period. Let √λ_N be the highest resonance. Without damping β_lim has a closed form for r ≥ √λ_N/2. At every r,
    /// this closed form is an upper bound on β_lim.
    ///
    /// For an elastic contact, the list is always proven complete. For a rigid contact without damping, it is proven
    /// complete if the range lies above √λ_N/2. Otherwise the code samples the intervals in which the closed form
    /// exceeds β. In these intervals the search may miss a regime whose range is narrower than one of
    /// [`Certainty::STEPS`] equal steps in 1/r.
    ///
    /// # Errors
    /// [`FeatureError::Friction`], [`FeatureError::Range`], [`FeatureError::Crowded`].
    pub fn regimes(
        &self,
        beta: f64,
        range: [f64; 2],
    ) -> Result<(Vec<RegimeRange>, Certainty), FeatureError> {
        check_friction(beta)?;
        check_range(range)?;
        let [from, to] = range;
        let mut places: Vec<(f64, RegimeEnd)> = Vec::new();
        for Bound { r, frequency } in self.sliding_bounds(beta, range)? {
            places.push((r, RegimeEnd::Sliding(frequency)));
        }
        let (bounds, certainty) = self.continuous_bounds(beta, range)?;
        for Bound { r, frequency } in bounds {
            places.push((r, RegimeEnd::Continuous(frequency)));
        }
        places.retain(|(r, _)| from < *r && *r < to);
        places.push((to, RegimeEnd::Range));
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut found: Vec<RegimeRange> = Vec::new();
        let mut start = from;
        for (end, why) in places {
            if !(start < end) {
                continue;
            }
            let middle = 0.5 * (start + end);
            let at = self.system.at(middle);
            let regime = at.ok().and_then(|at| at.regime(beta).ok());
            let Some(regime) = regime else { continue };
            match found.last_mut() {
                Some(last) if last.regime == regime => {
                    (last.to, last.end) = (end, why);
                }
                _ => found.push(RegimeRange {
                    from: start,
                    to: end,
                    regime,
                    end: why,
                }),
            }
            start = end;
        }
        Ok((found, certainty))
    }

    /// Returns the frequencies of the range at which β_lim = β, and the completeness of the list.
    fn continuous_bounds(
        &self,
        beta: f64,
        range: [f64; 2],
    ) -> Result<(Vec<Bound>, Certainty), FeatureError> {
        let [from, to] = range;
        let modal = self.system.modal();
        // An elastic contact sticks after each reversal. Its β_lim is therefore 0 at every frequency.
        if beta == 0.0 || modal.compliance.is_some() {
            return Ok((Vec::new(), Certainty::Proven));
        }
        let fastest = modal.resonances.last().map_or(0.0, |last| last.to_f64());
        let closed = if modal.is_damped() { to } else { 0.5 * fastest };
        let mut bounds = Vec::new();
        // For frequency ratios above `closed`, β_lim equals its closed form. The search uses samples only below
        // `closed`.
        let function = MotionFunction::new(modal, None, Target::Continuous(exact(beta)));
        let mut edges = vec![from];
        let mut marks = Vec::new();
        if !modal.is_damped() {
            for zero in function.zeros(range)? {
                let r = zero.r();
                if closed <= r {
                    bounds.push(Bound {
                        r,
                        frequency: self.variations.of_zero(&function, &zero, Some(beta)),
                    });
                } else {
                    edges.push(r);
                }
            }
            let still = MotionFunction::new(modal, None, Target::FreeContact);
            marks.extend(still.zeros(range)?.iter().map(|zero| zero.r()));
            marks.extend(function.poles(range)?.iter().map(|pole| 1.0 / pole.y));
        } else {
            for resonance in &modal.resonances {
                let orders = (0..=SUBHARMONICS).map(|i| (2 * i + 1) as f64);
                marks.extend(orders.map(|order| resonance.to_f64() / order));
            }
            marks.extend(
                self.system
                    .dynamics()
                    .held
                    .iter()
                    .map(|mode| mode.frequency),
            );
        }
        let last = closed.min(to);
        if !(from < last) {
            return Ok((bounds, Certainty::Proven));
        }
        edges.push(last);
        let steps = steps([from, last]);
        let limit = |r: f64| (self.continuous_limit(r) / beta).ln();
        for stretch in edges.windows(2) {
            let &[low, high] = stretch else { continue };
            if !(low < high) {
                continue;
            }
            let upper = |r: f64| {
                let limits = self.system.limits_without_search(r);
                limits.is_ok_and(|limits| beta < limits.continuous)
            };
            if !modal.is_damped() && !upper(0.5 * (low + high)) {
                // The upper bound on β_lim is less than β in the whole interval. The interval therefore needs no
                // samples.
                bounds.push(self.continuous_bound(low, beta));
                continue;
            }
            let own: Vec<f64> = marks
                .iter()
                .copied()
                .filter(|r| low <= *r && *r <= high)
                .collect();
            let mut places = samples([low, high], SAMPLES, &own);
            merge(&mut places, &steps);
            for r in changes(&places, limit) {
                bounds.push(self.continuous_bound(r, beta));
            }
            bounds.push(self.continuous_bound(low, beta));
        }
        bounds.sort_by(|a, b| a.r.total_cmp(&b.r));
        bounds.dedup_by(|b, a| (b.r - a.r).abs() <= 1e-14 * a.r);
        Ok((bounds, Certainty::SAMPLED))
    }

    /// Returns a frequency ratio at which β_lim = β, with the derivatives of the frequency.
    fn continuous_bound(&self, r: f64, beta: f64) -> Bound {
        let frequency = self.variations.of_place(r, beta, |varied, r, beta| {
            let limit = varied.at(r).ok()?.continuous_limit();
            Some(limit - beta)
        });
        Bound { r, frequency }
    }
}

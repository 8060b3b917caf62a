//! Resonances of the chain with its contact stuck, and the ranges of frequency in which the contact slides at a given
//! friction.

use super::functions::Target;
use super::isolate::MotionFunction;
use super::sensed::Sensed;
use super::{FeatureError, Features, check_friction, check_range, exact};
use frictiongen_kernel::number::dd::Dd;

/// A resonance of the chain with its contact stuck.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldResonance {
    /// Undamped frequency ratio r of the resonance.
    pub r: f64,
    /// Frequency of the resonance, in Hz under a load.
    pub frequency: Sensed,
    /// Modal damping ratio ζ of the mode at the resonance.
    pub damping_ratio: f64,
    /// True if the free chain does not have this mode. False for a mode that the contact does not drive, because the
    /// free chain has the same mode.
    pub new: bool,
    /// Limit of sliding β*_lim at the resonance, in N under a load. The limit is infinite if the contact slides with
    /// any friction.
    pub sliding_limit: f64,
}

/// A range of the frequency ratio r in which the contact slides with a given friction, and with every smaller friction.
#[derive(Clone, Debug, PartialEq)]
pub struct SlidingRange {
    /// Lower bound of the range, as frequency ratio r.
    pub from: f64,
    /// Frequency of the lower bound, in Hz under a load. `None` at a bound of the requested range.
    pub from_frequency: Option<Sensed>,
    /// Upper bound of the range, as frequency ratio r.
    pub to: f64,
    /// Frequency of the upper bound, in Hz under a load. `None` at a bound of the requested range.
    pub to_frequency: Option<Sensed>,
}

/// Relative tolerance of the comparison of β*_lim with β on a resonance.
const ON_POLE: f64 = 1e-13;

/// A frequency at which one of the limits β_lim and β*_lim equals the friction ratio β.
#[derive(Clone, Debug)]
pub(super) struct Bound {
    pub r: f64,
    pub frequency: Sensed,
}

impl Features<'_> {
    /// Returns the resonances of the chain with its contact stuck, in ascending order. One resonance of the stuck chain
    /// lies between every two neighbouring resonances of modes that the contact drives. With an elastic contact, one
    /// further resonance of the stuck chain lies above the resonances of all modes that the contact drives. All further
    /// resonances belong to modes that the contact does not drive.
    #[must_use]
    pub fn held_resonances(&self) -> Vec<HeldResonance> {
        let dynamics = self.system.dynamics();
        let mut all = Vec::new();
        for (index, mode) in dynamics.held.iter().enumerate() {
            let frequency = self
                .variations
                .of_frequency(mode.frequency, None, |variation| {
                    let dynamics = variation.varied.transient()?.dynamics();
                    Some(dynamics.held.get(index)?.frequency.slope)
                });
            all.push(HeldResonance {
                r: mode.frequency,
                frequency,
                damping_ratio: mode.zeta,
                new: true,
                sliding_limit: 0.0,
            });
        }
        let modes = dynamics.modes.iter().enumerate();
        for (index, mode) in modes.filter(|(_, mode)| !mode.in_contact) {
            let frequency = self
                .variations
                .of_frequency(mode.resonance, None, |variation| {
                    let dynamics = variation.varied.transient()?.dynamics();
                    Some(dynamics.modes.get(index)?.resonance.slope)
                });
            all.push(HeldResonance {
                r: mode.resonance,
                frequency,
                damping_ratio: mode.zeta,
                new: false,
                sliding_limit: 0.0,
            });
        }
        for held in &mut all {
            held.sliding_limit = self.variations.friction(self.held_limit(held));
        }
        all.sort_by(|a, b| a.r.total_cmp(&b.r));
        all
    }

    /// Returns β*_lim on a resonance of the chain with its contact stuck. Without damping, the receptance H at this
    /// frequency is zero apart from rounding. If the limit grows as the inverse of the distance from the resonance, the
    /// result is infinite.
    fn held_limit(&self, held: &HeldResonance) -> f64 {
        let limit = self.sliding_limit(held.r);
        if held.damping_ratio > 0.0 || !held.new {
            return limit;
        }
        let beside = |distance: f64| self.sliding_limit(held.r * (1.0 + distance));
        if 5.0 * beside(1e-6) < beside(1e-7) {
            f64::INFINITY
        } else {
            limit
        }
    }

    /// Returns all frequencies in the range at which β*_lim = β, in ascending order.
    pub(super) fn sliding_bounds(
        &self,
        beta: f64,
        range: [f64; 2],
    ) -> Result<Vec<Bound>, FeatureError> {
        let modal = self.system.modal();
        let beta_exact = exact(beta);
        let signs: &[Dd] = if modal.is_damped() {
            &[Dd::ONE]
        } else {
            &[Dd::ONE, Dd { hi: -1.0, lo: 0.0 }]
        };
        let mut bounds = Vec::new();
        for sign in signs {
            let target = Target::Sliding(beta_exact * *sign);
            let function = MotionFunction::new(modal, None, target);
            for zero in function.zeros(range)? {
                bounds.push(Bound {
                    r: zero.r(),
                    frequency: self.variations.of_zero(&function, &zero, Some(beta)),
                });
            }
        }
        // V is the motion of the contact without friction, and H its receptance. V and H have poles on an undamped
        // resonance. On this resonance, β*_lim can equal β although V − βμH has no zero.
        let resonances = modal.resonances.iter().zip(&modal.damping_ratios);
        for (resonance, zeta) in resonances {
            let r = resonance.to_f64();
            let near = (self.sliding_limit(r) / beta - 1.0).abs() <= ON_POLE;
            if zeta.is_zero() && near && range[0] < r && r < range[1] {
                let frequency = self.variations.of_place(r, beta, |varied, r, beta| {
                    Some(varied.at(r).ok()?.sliding_limit() - beta)
                });
                bounds.push(Bound { r, frequency });
            }
        }
        bounds.sort_by(|a, b| a.r.total_cmp(&b.r));
        Ok(bounds)
    }

    /// Returns all ranges of the frequency ratio r in which β < β*_lim, in ascending order (a general form of 6.13). In
    /// these ranges the contact slides, all the time or with stops, with this friction and with every smaller friction.
    ///
    /// # Errors
    /// [`FeatureError::Friction`], [`FeatureError::Range`], [`FeatureError::Crowded`].
    pub fn sliding_ranges(
        &self,
        beta: f64,
        range: [f64; 2],
    ) -> Result<Vec<SlidingRange>, FeatureError> {
        check_friction(beta)?;
        check_range(range)?;
        let [from, to] = range;
        let mut places: Vec<(f64, Option<Sensed>)> = vec![(from, None)];
        for bound in self.sliding_bounds(beta, range)? {
            if from < bound.r && bound.r < to {
                places.push((bound.r, Some(bound.frequency)));
            }
        }
        places.push((to, None));
        let mut found: Vec<SlidingRange> = Vec::new();
        for pair in places.windows(2) {
            let [(from, before), (to, after)] = pair else {
                continue;
            };
            if !(beta < self.sliding_limit(0.5 * (from + to))) {
                continue;
            }
            match found.last_mut() {
                // The limit β*_lim only touches β at the common bound of the two ranges. The two ranges therefore
                // become one range.
                Some(last) if last.to == *from => {
                    (last.to, last.to_frequency) = (*to, after.clone());
                }
                _ => found.push(SlidingRange {
                    from: *from,
                    from_frequency: before.clone(),
                    to: *to,
                    to_frequency: after.clone(),
                }),
            }
        }
        Ok(found)
    }
}

//! Features of the response for emitted and run-time systems, computed without allocation: friction thresholds of the
//! resonances, limits for the frequency ratio r → 0 and r → ∞, and changes of the regime.
//!
//! `System::features` (feature `study`) finds more features. It also needs the mode shapes of the scene, and it says
//! which of its lists are complete.
//!
//! ```
//! use frictiongen::features::{self, Change};
//! use frictiongen::{Regime, friction_system};
//!
//! friction_system! {
//!     struct Chain {
//!         masses: { first: 1.0, second: 1.0 },
//!         springs: { base - first: 1.0, first - second: 1.0 },
//!         contact: first - wall,
//!         excitation: first,
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn core::error::Error>> {
//! // With less friction than π/4 of the load both resonances are unbounded.
//! let mut thresholds = [0.0; 2];
//! features::thresholds_into(&Chain, &mut thresholds)?;
//! assert!(thresholds.iter().all(|beta| (beta - core::f64::consts::FRAC_PI_4).abs() < 1e-12));
//!
//! // β_∞ = 2/√(4 + π²).
//! assert!((features::limits_at_infinity(&Chain)?.continuous - 0.537029).abs() < 1e-6);
//!
//! // From which frequency on does a contact slide all the time at β = 0.4?
//! let mut changes = features::regime_changes(&Chain, 0.4, [0.53, 0.7], 100)?;
//! let Change { r, before, after } = changes.next().ok_or("no change")?;
//! assert!((r - 0.55875).abs() < 5e-6);
//! assert_eq!((before, after), (Regime::StickSlip, Regime::Continuous));
//! assert!(changes.next().is_none());
//! # Ok(())
//! # }
//! ```

use crate::sweep::SweepError;
use crate::{FrictionSystem, Limits, LimitsAt, OutOfDomain, Regime};
use frictiongen_kernel::{Float, Scalar};

/// Writes the limit of continuous motion β_lim at every resonance into the caller's slice. The entries have the order
/// of the resonances, which is ascending in frequency.
///
/// Without damping, β_lim at resonance i is the threshold β_n,i (6.2, 6.26). At a smaller friction ratio the amplitude
/// of the steady state is unbounded. With damping, (7.62) estimates β_lim. If the contact does not drive a mode, the
/// entry of this mode has no meaning.
///
/// # Errors
/// [`SweepError::Length`] for a slice whose length is not the number of resonances. The slice then stays unchanged.
pub fn thresholds_into<F: FrictionSystem>(
    system: &F,
    thresholds: &mut [F::Scalar],
) -> Result<(), SweepError> {
    let resonances = system.resonances();
    if resonances.len() != thresholds.len() {
        return Err(SweepError::Length {
            points: resonances.len(),
            room: thresholds.len(),
        });
    }
    for (r, threshold) in resonances.iter().zip(thresholds) {
        let at = system.at(*r).map_err(SweepError::OutOfDomain)?;
        *threshold = at.continuous_limit();
    }
    Ok(())
}

/// Returns β_lim and β*_lim for the frequency ratio r → 0. β_lim is 0 (6.4). The contact slides for r → 0 if β < β*_lim
/// (6.5).
///
/// # Errors
/// Returns no error, because r = 0 is in the domain.
pub fn limits_at_rest<F: FrictionSystem>(system: &F) -> Result<Limits<F::Scalar>, OutOfDomain> {
    Ok(system.at(F::Scalar::constant(0.0))?.limits())
}

/// Returns β_lim and β*_lim for the frequency ratio r → ∞ (6.28). Both are infinite for a contact with a moving base.
///
/// # Errors
/// Returns no error, because r = ∞ is in the domain.
pub fn limits_at_infinity<F: FrictionSystem>(system: &F) -> Result<Limits<F::Scalar>, OutOfDomain> {
    Ok(system.at(F::Scalar::constant(f64::INFINITY))?.limits())
}

/// A frequency ratio at which the regime changes, with the regimes just below and just above this frequency ratio.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change<S> {
    /// Highest frequency ratio r at which the regime is `before`.
    pub r: S,
    /// Regime at frequency ratios just below the change at r.
    pub before: Regime,
    /// Regime at frequency ratios just above the change at r.
    pub after: Regime,
}

/// Iterator over the changes of the regime, in ascending order of frequency. [`regime_changes`] creates it.
#[derive(Clone, Debug)]
pub struct RegimeChanges<'s, F: FrictionSystem> {
    system: &'s F,
    beta: F::Scalar,
    range: [F::Scalar; 2],
    steps: u32,
    step: u32,
    last: (F::Scalar, Regime),
}

/// Finds the changes of the regime over a range of frequency ratios at the friction ratio β, in ascending order.
/// Bisection locates each change to the last digit of the number type.
///
/// The search evaluates the regime at `steps` + 1 frequency ratios. It misses a regime whose whole range lies between
/// two neighbouring frequency ratios. `System::features` misses fewer regimes, and says whether its list is complete.
///
/// # Errors
/// [`OutOfDomain`] unless the range begins above 0 and ends at a larger, finite r. [`OutOfDomain`] also for NaN,
/// negative and infinite β, and for zero steps.
pub fn regime_changes<F: FrictionSystem>(
    system: &F,
    beta: F::Scalar,
    range: [F::Scalar; 2],
    steps: u32,
) -> Result<RegimeChanges<'_, F>, OutOfDomain> {
    let [from, to] = range;
    if !(F::Scalar::constant(0.0) < from && from < to && to.is_finite()) {
        return Err(OutOfDomain::Range);
    }
    if steps == 0 {
        return Err(OutOfDomain::Intervals);
    }
    Ok(RegimeChanges {
        system,
        beta,
        range,
        steps,
        step: 0,
        last: (from, system.at(from)?.regime(beta)?),
    })
}

impl<F: FrictionSystem> RegimeChanges<'_, F> {
    fn regime(&self, r: F::Scalar) -> Option<Regime> {
        self.system.at(r).ok()?.regime(self.beta).ok()
    }

    /// Returns the next frequency ratio at which the iterator evaluates the regime, or `None` after the end of the
    /// range.
    fn next_place(&mut self) -> Option<F::Scalar> {
        if self.steps <= self.step {
            return None;
        }
        self.step += 1;
        let [from, to] = self.range;
        let share = f64::from(self.step) / f64::from(self.steps);
        Some(if self.step < self.steps {
            from + (to - from) * F::Scalar::constant(share)
        } else {
            to
        })
    }
}

impl<F: FrictionSystem> Iterator for RegimeChanges<'_, F> {
    type Item = Change<F::Scalar>;

    fn next(&mut self) -> Option<Change<F::Scalar>> {
        loop {
            let place = self.next_place()?;
            let regime = self.regime(place)?;
            let (start, before) = self.last;
            if regime == before {
                self.last = (place, regime);
                continue;
            }
            let (mut low, mut high, mut after) = (start, place, regime);
            loop {
                let middle = (low + high) * F::Scalar::constant(0.5);
                if !(low < middle && middle < high) {
                    break;
                }
                let regime = self.regime(middle)?;
                if regime == before {
                    low = middle;
                } else {
                    (high, after) = (middle, regime);
                }
            }
            // A third regime may lie between the two evaluated frequency ratios. The search therefore continues from
            // the change that it has found, not from the upper frequency ratio.
            self.last = (high, after);
            self.step -= 1;
            return Some(Change {
                r: low,
                before,
                after,
            });
        }
    }
}

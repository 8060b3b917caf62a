//! Finds the best common friction: the friction with which the largest amplitude of a mass over a band of frequencies
//! is smallest.

use super::error::JoinedError;
use super::scene::Joined;
use crate::study::golden::smallest;
use crate::study::joints::JointError;
use crate::{Given, OutOfDomain};

/// Number of frequency ratios in the grid over the band.
const FREQUENCIES: usize = 40;
/// Number of frequency ratios at which the closed forms show the resonances of the linear chains.
const LINEAR: usize = 2000;
/// Number of friction values in the grid of the search, without friction 0.
const FRICTIONS: usize = 32;
/// Smallest friction of the grid, divided by the median of β*_lim (limit of the stuck state) over the band.
const LEAST: f64 = 0.02;
/// Largest possible friction of the grid, divided by the median of β*_lim. Next to an undamped resonance of the stuck
/// chain β*_lim has no bound.
const MOST: f64 = 1000.0;
/// Number of golden sections in each refinement of a friction or of a frequency.
const STEPS: usize = 14;
/// The search refines a maximum over frequency if its amplitude, divided by the largest amplitude, is at least this.
const WORTH: f64 = 0.8;
/// The search refines a minimum over friction if its amplitude, divided by the best amplitude, is at most this.
const NEARLY: f64 = 1.3;
/// Smaller of the two fractions into which a golden section divides an interval.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// Result of a search for the best common friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoinedOptimum {
    /// The best common friction β.
    pub friction: f64,
    /// The largest amplitude of the mass over the band with the best friction.
    pub amplitude: f64,
    /// Frequency ratio r of the largest amplitude in the band.
    pub r: f64,
    /// Number of steady states that the search has computed.
    pub evaluations: usize,
    /// Number of frequency ratios that the search compares for each friction, before it refines the largest amplitude.
    /// A narrower peak between two of them can be missed.
    pub frequencies: usize,
    /// Number of frictions that the search has compared.
    pub frictions: usize,
    /// False if the caller's function `watch` stopped the search. The result is then the best friction that the search
    /// had found.
    pub is_complete: bool,
}

/// Reason why a search for the best friction ends early.
pub(super) enum Early {
    /// The caller's function `watch` stopped the search.
    Stopped,
    /// The computation of a steady state failed.
    Failed(JoinedError),
}

impl From<JoinedError> for Early {
    fn from(error: JoinedError) -> Self {
        Self::Failed(error)
    }
}

impl Joined<'_> {
    /// Finds the common friction with which the largest amplitude of a mass over a band of frequency ratios is
    /// smallest.
    ///
    /// The search compares friction 0 and 32 frictions in geometric steps, and narrows the intervals around the best
    /// ones by golden sections. For each friction it evaluates 40 frequencies in geometric steps and the resonances of
    /// the chain with each contact either free or stuck, and refines the largest maxima over frequency. The search can
    /// miss a peak or a minimum that is narrower than its grids.
    ///
    /// # Errors
    /// [`JoinedError::UnknownMass`] if no mass has this name. [`OutOfDomain`] if a bound of the band is not above 0
    /// and finite, or if the upper bound does not exceed the lower bound. [`JoinedError::Engine`] if a motion has too
    /// many events. A motion from rest that does not settle is not an error. The search then takes the largest
    /// amplitude in cycles 513 to 576 of this motion.
    pub fn optimum(
        &self,
        mass: &str,
        (from, to): (f64, f64),
    ) -> Result<JoinedOptimum, JoinedError> {
        self.optimum_watched(mass, (from, to), &|| true)
    }

    /// Finds the best common friction, as [`optimum`](Self::optimum) does. The search calls `watch` before each steady
    /// state, and stops if `watch` returns false.
    ///
    /// # Errors
    /// Same errors as [`optimum`](Self::optimum). [`JoinedError::Stopped`] if the search stops before it has compared
    /// two frictions.
    pub fn optimum_watched(
        &self,
        mass: &str,
        band: (f64, f64),
        watch: &dyn Fn() -> bool,
    ) -> Result<JoinedOptimum, JoinedError> {
        let mut search = FrictionSearch::new(self, mass, band, watch)?;
        match search.run() {
            Ok(()) => search.found(true),
            Err(Early::Stopped) => search.found(false),
            Err(Early::Failed(error)) => Err(error),
        }
    }
}

/// A search for the best common friction.
pub(super) struct FrictionSearch<'j, 'a> {
    joined: Joined<'a>,
    mass: usize,
    /// Frequency ratios r at which the search evaluates each friction, in ascending order, with the latest amplitudes.
    grid: Vec<(f64, f64)>,
    evaluations: usize,
    frictions: usize,
    watch: &'j dyn Fn() -> bool,
    /// The best friction so far, with its largest amplitude over the band and the frequency ratio of this amplitude.
    best: Option<(f64, (f64, f64))>,
}

impl<'j, 'a> FrictionSearch<'j, 'a> {
    /// Prepares a search for the best common friction.
    pub(super) fn new(
        joined: &Joined<'a>,
        mass: &str,
        (from, to): (f64, f64),
        watch: &'j dyn Fn() -> bool,
    ) -> Result<Self, JoinedError> {
        let index = joined.mass_index(mass)?;
        for end in [from, to] {
            if !(end > 0.0 && end.is_finite()) {
                return Err(OutOfDomain::FrequencyRatioInTime(Given::of(end)).into());
            }
        }
        if !(from < to) {
            return Err(OutOfDomain::Range.into());
        }
        let mut grid = geometric((from, to), FREQUENCIES);
        grid.extend(resonances(joined, mass, (from, to))?);
        grid.sort_by(f64::total_cmp);
        grid.dedup();
        Ok(Self {
            joined: joined.clone(),
            mass: index,
            grid: grid.into_iter().map(|r| (r, 0.0)).collect(),
            evaluations: 0,
            frictions: 0,
            watch,
            best: None,
        })
    }

    /// Replaces each contact's share of the common friction.
    pub(super) fn set_shares(&mut self, shares: &[f64]) {
        self.joined.set_shares(shares);
    }

    /// Returns the result for a friction and its peak, with the counts of this search. `is_complete` is false if the
    /// caller stopped the search.
    pub(super) fn told(
        &self,
        friction: f64,
        (amplitude, r): (f64, f64),
        is_complete: bool,
    ) -> JoinedOptimum {
        JoinedOptimum {
            friction,
            amplitude,
            r,
            evaluations: self.evaluations,
            frequencies: self.grid.len(),
            frictions: self.frictions,
            is_complete,
        }
    }

    fn found(&self, is_complete: bool) -> Result<JoinedOptimum, JoinedError> {
        let (friction, peak) = self.best.ok_or(JoinedError::Stopped)?;
        Ok(self.told(friction, peak, is_complete))
    }

    /// Searches for the best friction, first on a grid of frictions and then by golden sections.
    fn run(&mut self) -> Result<(), Early> {
        let mut tried = vec![0.0];
        tried.extend(geometric(self.range()?, FRICTIONS));
        let mut peaks = Vec::new();
        // The search begins with the largest friction, because a small friction may leave a resonance unbounded.
        for friction in tried.iter().rev() {
            let cutoff = NEARLY * self.least();
            peaks.push((*friction, self.peak(*friction, cutoff)?));
        }
        let level = |place: Option<usize>| {
            let peak = place.and_then(|place| peaks.get(place));
            peak.map_or((f64::NAN, f64::INFINITY), |peak| *peak)
        };
        let mut valleys = Vec::new();
        for place in 0..peaks.len() {
            let [above, at, below] =
                [place.checked_sub(1), Some(place), Some(place + 1)].map(level);
            if at.1.is_finite() && at.1 <= above.1 && at.1 <= below.1 {
                let ends = [below.0, above.0].map(|end| if end.is_nan() { at.0 } else { end });
                valleys.push((at, ends));
            }
        }
        valleys.sort_by(|(a, _), (b, _)| a.1.total_cmp(&b.1));
        for (at, ends) in valleys {
            self.narrow(at, ends)?;
        }
        Ok(())
    }

    /// Narrows an interval of frictions around its best friction by golden sections.
    fn narrow(&mut self, (mut at, mut least): (f64, f64), ends: [f64; 2]) -> Result<(), Early> {
        let [mut low, mut high] = ends;
        for _ in 0..STEPS {
            if NEARLY * self.least() < least {
                break;
            }
            let side = if high - at < at - low { low } else { high };
            let tried = at + GOLDEN * (side - at);
            let amplitude = self.peak(tried, least)?;
            let mut worse = tried;
            if amplitude < least {
                worse = at;
                (at, least) = (tried, amplitude);
            }
            if worse < at {
                low = worse;
            } else {
                high = worse;
            }
        }
        Ok(())
    }

    /// Returns the smallest and the largest friction of the grid, apart from 0. With the largest friction no contact
    /// slides at any frequency of the band, except next to a resonance of the stuck chain.
    fn range(&self) -> Result<(f64, f64), Early> {
        let mut limits = Vec::new();
        for (r, _) in &self.grid {
            match self.joined.at_any(*r)?.stuck() {
                Ok(stuck) => limits.push(stuck.limit()),
                // On an undamped resonance of the chain with its contacts stuck, no friction force keeps all contacts
                // stuck.
                Err(JoinedError::Resonance) => {}
                Err(error) => return Err(error.into()),
            }
        }
        limits.sort_by(f64::total_cmp);
        limits.retain(|limit| 0.0 < *limit);
        let middle = limits.get(limits.len() / 2).copied().unwrap_or(1.0);
        let most = limits.last().copied().unwrap_or(1.0);
        Ok((LEAST * middle, most.min(MOST * middle)))
    }

    /// Returns the amplitude of the mass at one frequency ratio and one common friction.
    fn amplitude(&mut self, r: f64, friction: f64) -> Result<f64, Early> {
        if !(self.watch)() {
            return Err(Early::Stopped);
        }
        self.evaluations += 1;
        let at = self.joined.at_any(r)?;
        if friction == 0.0 {
            return Ok(match at.linear() {
                Ok(linear) => linear.displacement(self.mass).norm(),
                Err(JoinedError::Resonance) => f64::INFINITY,
                Err(error) => return Err(error.into()),
            });
        }
        let amplitudes = match at.orbit(friction) {
            Ok(orbit) => orbit.amplitudes(),
            // The common friction may be just below the limit of the stuck state. The contacts then move less and less
            // in each cycle, but never come to rest.
            Err(JoinedError::Engine(JointError::NotSteady)) => at.last_cycles(friction)?,
            Err(error) => return Err(error.into()),
        };
        Ok(amplitudes.get(self.mass).copied().unwrap_or_default())
    }

    /// Returns the smallest peak so far.
    fn least(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |(_, peak)| peak.0)
    }

    /// Returns the largest amplitude over the band with one friction, or an amplitude above `cutoff`. Stores the peak if
    /// it is the best so far.
    fn peak(&mut self, friction: f64, cutoff: f64) -> Result<f64, Early> {
        let peak = self.largest(friction, cutoff)?;
        if peak.0 < self.least() {
            self.best = Some((friction, peak));
        }
        Ok(peak.0)
    }

    /// Returns the largest amplitude over the band with one friction, and its frequency ratio. Ends early with the
    /// first amplitude above `cutoff`.
    pub(super) fn largest(&mut self, friction: f64, cutoff: f64) -> Result<(f64, f64), Early> {
        self.frictions += 1;
        let mut order: Vec<usize> = (0..self.grid.len()).collect();
        let known = |place: &usize| self.grid.get(*place).map_or(0.0, |(_, known)| *known);
        order.sort_by(|a, b| known(b).total_cmp(&known(a)));
        let mut best = (0.0, f64::NAN);
        for place in order {
            let r = self.grid.get(place).map_or(f64::NAN, |(r, _)| *r);
            let amplitude = self.amplitude(r, friction)?;
            if let Some((_, known)) = self.grid.get_mut(place) {
                *known = amplitude;
            }
            if best.0 < amplitude {
                best = (amplitude, r);
            }
            if cutoff < amplitude {
                return Ok(best);
            }
        }
        for ends in maxima(&self.grid, WORTH * best.0) {
            let (r, amplitude) = smallest(ends, (STEPS, 0.0), |r| -> Result<f64, Early> {
                Ok(-self.amplitude(r, friction)?)
            })?;
            if best.0 < -amplitude {
                best = (-amplitude, r);
            }
        }
        Ok(best)
    }
}

/// Returns `count` numbers in geometric steps, from the first to the last.
fn geometric((from, to): (f64, f64), count: usize) -> Vec<f64> {
    let share = |part: usize| part as f64 / (count - 1) as f64;
    let number = |part: usize| from * (to / from).powf(share(part)).clamp(1.0, to / from);
    (0..count).map(number).collect()
}

/// Returns the neighbours of each local maximum whose amplitude is at least `least`.
fn maxima(points: &[(f64, f64)], least: f64) -> Vec<(f64, f64)> {
    let neighbours = |place: usize| {
        let at = points.get(place)?;
        let low = points.get(place.saturating_sub(1))?;
        let high = points.get(place + 1).unwrap_or(at);
        (least <= at.1 && low.1 <= at.1 && high.1 <= at.1).then_some((low.0, high.0))
    };
    (0..points.len()).filter_map(neighbours).collect()
}

/// Returns the resonances of the mass within the band, for each choice of contacts that stick while the others have no
/// friction. Of many contacts, every third has the same state.
fn resonances(joined: &Joined<'_>, mass: &str, band: (f64, f64)) -> Result<Vec<f64>, JoinedError> {
    let contacts = joined.contact_names().len();
    let mut found = Vec::new();
    for stuck in 0..1_u32 << contacts.min(3) {
        let share = |contact: usize| f64::from((stuck >> (contact % 3)) & 1);
        let linear = joined.with_shares(&(0..contacts).map(share).collect::<Vec<_>>());
        let amplitude = |r: f64| match linear.at_any(r)?.stuck() {
            Ok(state) => Ok(state.mass(mass)?.norm()),
            Err(JoinedError::Resonance) => Ok(f64::INFINITY),
            Err(error) => Err(error),
        };
        let points = geometric(band, LINEAR).into_iter();
        let points = points.map(|r| Ok((r, amplitude(r)?)));
        let points = points.collect::<Result<Vec<_>, JoinedError>>()?;
        for ends in maxima(&points, 0.0) {
            let (r, _) = smallest(ends, (STEPS, 0.0), |r| amplitude(r).map(|x| -x))?;
            found.push(r);
        }
    }
    Ok(found)
}

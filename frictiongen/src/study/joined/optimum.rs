//! Finds the best common friction: the friction with which the largest amplitude of a mass over a band of frequencies
//! is smallest.

use super::error::JoinedError;
use super::scene::Joined;
use crate::study::golden::smallest;
use crate::study::joints::JointError;
use crate::{Given, OutOfDomain};

/// Number of frequency ratios in the grid over the band.
const FREQUENCIES: usize = 25;
/// Number of friction values in the first grid of the search.
const FRICTIONS: usize = 11;
/// Number of golden sections in each refinement of the search.
const STEPS: usize = 8;
/// Smallest friction of the search's first grid, divided by the largest friction of this grid. The largest friction is
/// the largest β*_lim (limit of the stuck state) in the band. With the largest friction, no contact slides.
const LEAST: f64 = 0.01;

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
    /// The search first compares 11 frictions at 13 equally spaced frequencies. Then it refines the best friction by
    /// golden sections at 25 frequencies. Finally it refines the frequency of the largest peak. The search can miss a
    /// minimum or a peak that is narrower than its grids. The search tries no friction above the largest limit of the
    /// stuck state, because all contacts are then stuck at every frequency of the band.
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

/// Accuracy with which the search computes the largest amplitude over the band.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum BandAccuracy {
    /// The search evaluates every second frequency of the grid over the band.
    Roughly,
    /// The search evaluates every frequency of the grid over the band.
    OnGrid,
    /// The search evaluates every frequency of the grid, and then searches between the grid's frequencies for the peak.
    Refined,
}

/// A search for the best common friction.
pub(super) struct FrictionSearch<'j, 'a> {
    joined: Joined<'a>,
    mass: usize,
    /// Frequency ratios r of the grid over the band.
    grid: Vec<f64>,
    evaluations: usize,
    watch: &'j dyn Fn() -> bool,
    /// The smallest peak so far. A peak of higher accuracy replaces every peak of lower accuracy.
    best: Option<FrictionPeak>,
}

/// The largest amplitude of the mass over the band with one friction.
#[derive(Clone, Copy, Debug)]
struct FrictionPeak {
    closely: BandAccuracy,
    friction: f64,
    amplitude: f64,
    r: f64,
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
        let place = |part: usize| from + (to - from) * part as f64 / (FREQUENCIES - 1) as f64;
        Ok(Self {
            joined: joined.clone(),
            mass: index,
            grid: (0..FREQUENCIES).map(place).collect(),
            evaluations: 0,
            watch,
            best: None,
        })
    }

    /// Replaces each contact's share of the common friction.
    pub(super) fn set_shares(&mut self, shares: &[f64]) {
        self.joined.set_shares(shares);
    }

    /// Returns the number of steady states that the search has computed so far.
    pub(super) fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// Returns the best friction that the search has found so far. `is_complete` is false if the caller stopped the
    /// search.
    fn found(&self, is_complete: bool) -> Result<JoinedOptimum, JoinedError> {
        let best = self.best.ok_or(JoinedError::Stopped)?;
        Ok(JoinedOptimum {
            friction: best.friction,
            amplitude: best.amplitude,
            r: best.r,
            evaluations: self.evaluations,
            is_complete,
        })
    }

    /// Searches for the best friction, first on a grid of frictions and then by golden sections. Finally refines the
    /// peak with this friction.
    fn run(&mut self) -> Result<(), Early> {
        let most = self.most()?;
        let ratio = LEAST.powf(1.0 / (FRICTIONS - 1) as f64);
        let tried = (0..FRICTIONS).map(|part| most * ratio.powi(part as i32));
        let tried: Vec<f64> = tried.collect();
        let mut best = (f64::INFINITY, 0);
        for (place, friction) in tried.iter().enumerate() {
            let (amplitude, _) = self.peak(*friction, BandAccuracy::Roughly)?;
            if amplitude < best.0 {
                best = (amplitude, place);
            }
        }
        // The frictions in `tried` are in descending order. The neighbour in front of the best friction is therefore
        // larger.
        let high = tried.get(best.1.saturating_sub(1)).copied();
        let low = tried.get(best.1 + 1).copied();
        let ends = (low.unwrap_or(LEAST * most), high.unwrap_or(most));
        let (friction, _) = smallest(ends, (STEPS, 0.0), |friction| {
            let peak = self.peak(friction, BandAccuracy::OnGrid);
            peak.map(|(amplitude, _)| amplitude)
        })?;
        self.peak(friction, BandAccuracy::Refined).map(|_| ())
    }

    /// Returns the largest β*_lim (limit of the stuck state) over the frequencies of the grid. With this common
    /// friction, no contact slides at any of these frequencies. Frequencies at an undamped resonance of the stuck
    /// chain do not count.
    fn most(&self) -> Result<f64, Early> {
        let mut most = 0.0_f64;
        for r in &self.grid {
            match self.joined.at_any(*r)?.stuck() {
                Ok(stuck) => most = most.max(stuck.limit()),
                // On an undamped resonance of the chain with its contacts stuck, no friction force keeps all contacts
                // stuck.
                Err(JoinedError::Resonance) => {}
                Err(error) => return Err(error.into()),
            }
        }
        Ok(most)
    }

    /// Returns the amplitude of the mass at one frequency ratio and one common friction.
    fn amplitude(&mut self, r: f64, friction: f64) -> Result<f64, Early> {
        if !(self.watch)() {
            return Err(Early::Stopped);
        }
        self.evaluations += 1;
        let at = self.joined.at_any(r)?;
        let amplitudes = match at.orbit(friction) {
            Ok(orbit) => orbit.amplitudes(),
            // The common friction may be just below the limit of the stuck state. The contacts then move less and less
            // in each cycle, but never come to rest.
            Err(JoinedError::Engine(JointError::NotSteady)) => at.last_cycles(friction)?,
            Err(error) => return Err(error.into()),
        };
        Ok(amplitudes.get(self.mass).copied().unwrap_or_default())
    }

    /// Returns the largest amplitude over the band with one friction, and its frequency ratio. Stores this peak if it
    /// is the best so far.
    fn peak(&mut self, friction: f64, closely: BandAccuracy) -> Result<(f64, f64), Early> {
        let (amplitude, r) = self.largest(friction, closely)?;
        let is_better = self.best.is_none_or(|best| {
            best.closely < closely || (best.closely == closely && amplitude < best.amplitude)
        });
        if is_better {
            self.best = Some(FrictionPeak {
                closely,
                friction,
                amplitude,
                r,
            });
        }
        Ok((amplitude, r))
    }

    /// Returns the largest amplitude over the band with one friction, and its frequency ratio.
    pub(super) fn largest(
        &mut self,
        friction: f64,
        closely: BandAccuracy,
    ) -> Result<(f64, f64), Early> {
        let mut best = (0.0, 0);
        let grid = self.grid.clone();
        let stride = if closely == BandAccuracy::Roughly {
            2
        } else {
            1
        };
        for (place, r) in grid.iter().enumerate().step_by(stride) {
            let amplitude = self.amplitude(*r, friction)?;
            if amplitude > best.0 {
                best = (amplitude, place);
            }
        }
        let near = |place: usize| grid.get(place.min(FREQUENCIES - 1)).copied();
        let around = (near(best.1.saturating_sub(1)), near(best.1 + 1));
        let (Some(low), Some(high), Some(r)) = (around.0, around.1, near(best.1)) else {
            return Ok((best.0, f64::NAN));
        };
        if closely != BandAccuracy::Refined {
            return Ok((best.0, r));
        }
        let (place, value) = smallest((low, high), (STEPS, 0.0), |r| {
            self.amplitude(r, friction).map(|amplitude| -amplitude)
        })?;
        Ok(if -value > best.0 {
            (-value, place)
        } else {
            (best.0, r)
        })
    }
}

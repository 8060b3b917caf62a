//! The best friction of a longer chain: of many frictions tried at many frequencies, where the exact one takes minutes.

use super::answer::{Answer, Peak};
use super::asked::Asked;
use super::found::{STUCK, found};
use frictiongen::study::{Map, MapRequest, OptimumKind};
use frictiongen::{Error, NoOrbit, NotContinuous, Of};

/// Frequencies evenly over the range.
const EVEN: usize = 41;
/// Frequencies about each resonance, of the chain and of the chain with its contact stuck, as shares of its damping ratio.
const BESIDE: [f64; 9] = [-10.0, -6.0, -3.0, -1.0, 0.0, 1.0, 3.0, 6.0, 10.0];
/// Where there is next to no damping, as if it were so much.
const LEAST_DAMPING: f64 = 5e-3;
/// Frictions of the first round, besides none: from this share of the middle sliding limit on, each larger by the same factor,
const FRICTIONS: usize = 24;
const LEAST: f64 = 0.03;
/// and up to this multiple of it where nothing holds the contact everywhere.
const MOST: f64 = 30.0;
/// Frictions of the second round, between the neighbours of the best.
const FINER: usize = 9;
/// So often is it looked more closely at the largest amplitudes, at so many frequencies to each side,
const CLOSER: usize = 3;
const CELLS: usize = 6;
/// wherever there is this share of the largest.
const WORTH: f64 = 0.8;
/// How far above the least an amplitude may be that counts as good.
const GOOD: f64 = 0.1;
/// Amplitudes that differ by less are the same.
const SAME: f64 = 1e-9;

/// The largest amplitude of a motion over all frequencies tried.
#[derive(Clone, Copy, Debug)]
struct Most {
    beta: f64,
    amplitude: f64,
}

/// What was tried.
pub struct Trial {
    of: Vec<Of>,
    frequencies: Vec<f64>,
    /// By motion, ascending in friction.
    rounds: Vec<Vec<Most>>,
    stuck: Vec<f64>,
    /// From this friction on the contact is stuck at all frequencies tried.
    locked: f64,
}

impl Trial {
    /// The first round, of all motions at once.
    pub fn of(asked: &Asked, of: Vec<Of>) -> Result<Self, Error> {
        let frequencies = frequencies(asked);
        let stuck = of.iter().map(|of| {
            let amplitudes = frequencies
                .iter()
                .map(|r| match found(asked, *r, STUCK, *of) {
                    Ok((_, swing)) => swing.amplitude,
                    Err(_) => f64::INFINITY,
                });
            amplitudes.fold(0.0, f64::max)
        });
        let limits = frequencies.iter();
        let limits = limits.filter_map(|r| Some(asked.system.at(*r).ok()?.sliding_limit()));
        let mut trial = Self {
            locked: limits.fold(0.0, f64::max),
            stuck: stuck.collect(),
            rounds: vec![Vec::new(); of.len()],
            frequencies,
            of,
        };
        let frictions = frictions(asked, trial.locked);
        trial.round(asked, &frictions, None)?;
        Ok(trial)
    }

    /// Tries some frictions for one motion or all.
    fn round(
        &mut self,
        asked: &Asked,
        frictions: &[f64],
        only: Option<usize>,
    ) -> Result<(), Error> {
        let places = 0..self.of.len();
        let wanted: Vec<usize> = places
            .filter(|place| only.is_none_or(|only| only == *place))
            .collect();
        let request = MapRequest {
            r: self.frequencies.clone(),
            beta: frictions.to_vec(),
            of: wanted
                .iter()
                .filter_map(|place| self.of.get(*place))
                .copied()
                .collect(),
        };
        let map = asked.system.map(&request, |_| true)?;
        for (column, place) in wanted.into_iter().enumerate() {
            if let Some(round) = self.rounds.get_mut(place) {
                round.extend(largest(&map, column));
                round.sort_by(|a, b| a.beta.total_cmp(&b.beta));
                round.dedup_by(|a, b| a.beta == b.beta);
            }
        }
        Ok(())
    }

    /// The best of one motion, once more between its neighbours; none where every friction leaves it without bound.
    pub fn best(&mut self, asked: &Asked, place: usize) -> Result<Option<Answer>, Error> {
        let (Some(of), Some(stuck)) = (self.of.get(place), self.stuck.get(place)) else {
            return Ok(None);
        };
        let (of, stuck) = (*of, *stuck);
        let Some((low, first, high)) = self.about_best(place) else {
            return Ok(None);
        };
        let sticks = stuck <= first.amplitude * (1.0 + SAME);
        if !sticks && first.beta > 0.0 {
            let step = (high - low) / (FINER + 1) as f64;
            let finer: Vec<f64> = (1..=FINER).map(|i| low + step * i as f64).collect();
            self.round(asked, &finer, Some(place))?;
        }
        let Some((_, best, _)) = self.about_best(place) else {
            return Ok(None);
        };
        let tried = self.rounds.get(place).map_or(&[][..], Vec::as_slice);
        let good = |most: &&Most| most.amplitude <= best.amplitude * (1.0 + GOOD);
        let before = tried.iter().rev().skip_while(|most| best.beta < most.beta);
        let after = tried.iter().skip_while(|most| most.beta < best.beta);
        let end = |last: Option<&Most>| last.map_or(best.beta, |most| most.beta);
        let within = (
            end(before.take_while(good).last()),
            end(after.take_while(good).last()),
        );
        let unbounded = tried.iter().take_while(|most| most.amplitude.is_infinite());
        let answer = Answer {
            beta: best.beta,
            amplitude: best.amplitude,
            kind: (best.beta == 0.0).then_some(OptimumKind::NoFriction),
            peaks: Vec::new(),
            without_friction: tried.first().map_or(f64::NAN, |first| first.amplitude),
            with_contact_locked: stuck,
            within: Some(within),
            unbounded_to: unbounded.last().map_or(0.0, |most| most.beta),
            tried: Some((tried.len(), self.frequencies.len())),
            exact: None,
        };
        if sticks {
            return Ok(Some(Answer {
                beta: self.locked,
                amplitude: stuck,
                kind: Some(OptimumKind::Stuck),
                within: Some((self.locked, f64::INFINITY)),
                ..answer
            }));
        }
        let peak = self.peak(asked, best.beta, of)?;
        let peak = peak.filter(|peak| best.amplitude <= peak.amplitude);
        Ok(Some(Answer {
            amplitude: peak.as_ref().map_or(best.amplitude, |peak| peak.amplitude),
            peaks: peak.into_iter().collect(),
            ..answer
        }))
    }

    /// The largest amplitude with a friction, looked for more closely about the largest of the frequencies tried.
    fn peak(&self, asked: &Asked, beta: f64, of: Of) -> Result<Option<Peak>, Error> {
        let mut places = self.frequencies.clone();
        let mut best = None;
        for _ in 0..=CLOSER {
            let request = MapRequest {
                r: places.clone(),
                beta: vec![beta],
                of: vec![of],
            };
            let map = asked.system.map(&request, |_| true)?;
            let seen: Vec<Peak> = map
                .points()
                .filter_map(|(r, _, point)| {
                    let point = point.as_ref().ok()?;
                    Some(Peak {
                        r,
                        amplitude: *point.amplitudes.first()?,
                        regime: point.pattern.regime,
                        at_end: r == asked.band.from || r == asked.band.to,
                    })
                })
                .collect();
            let largest = |a: &Peak, b: &Peak| a.amplitude.total_cmp(&b.amplitude);
            let Some(top) = seen.iter().cloned().chain(best).max_by(largest) else {
                return Ok(None);
            };
            places = closer(&seen, WORTH * top.amplitude);
            best = Some(top);
        }
        Ok(best)
    }

    /// The best of those tried, and its neighbours.
    fn about_best(&self, place: usize) -> Option<(f64, Most, f64)> {
        let tried = self.rounds.get(place)?;
        let finite = tried
            .iter()
            .enumerate()
            .filter(|(_, most)| most.amplitude.is_finite());
        // Of equal ones the least friction.
        let (index, best) = finite.min_by(|a, b| a.1.amplitude.total_cmp(&b.1.amplitude))?;
        let before = index.checked_sub(1).and_then(|before| tried.get(before));
        let after = tried.get(index + 1);
        Some((
            before.map_or(best.beta, |most| most.beta),
            *best,
            after.map_or(best.beta, |most| most.beta),
        ))
    }
}

/// The largest amplitudes of a motion of a map, for each friction.
fn largest(map: &Map, column: usize) -> Vec<Most> {
    let each = map.beta.iter().enumerate().map(|(row, beta)| {
        let points = map
            .columns
            .iter()
            .filter_map(|column| column.points.get(row));
        let amplitudes = points.filter_map(|point| match point {
            Ok(point) => point.amplitudes.get(column).copied(),
            Err(
                Error::NotContinuous(NotContinuous::Unbounded)
                | Error::NoOrbit(NoOrbit::Unbounded | NoOrbit::Undamped(_))
                | Error::StuckResonance(_),
            ) => Some(f64::INFINITY),
            // A motion with too many stops to be followed is a small one.
            Err(_) => None,
        });
        Most {
            beta: *beta,
            amplitude: amplitudes.fold(0.0, f64::max),
        }
    });
    each.collect()
}

/// Frequencies on both sides of every local maximum that may be the largest.
fn closer(seen: &[Peak], least: f64) -> Vec<f64> {
    let mut places = Vec::new();
    for (index, peak) in seen.iter().enumerate() {
        let beside = |place: Option<usize>| place.and_then(|place| seen.get(place));
        let sides = [beside(index.checked_sub(1)), beside(Some(index + 1))];
        let top = sides
            .iter()
            .flatten()
            .all(|side| side.amplitude <= peak.amplitude);
        if !top || peak.amplitude < least {
            continue;
        }
        for side in sides.into_iter().flatten() {
            let step = (side.r - peak.r) / (CELLS + 1) as f64;
            places.extend((1..=CELLS).map(|i| peak.r + step * i as f64));
        }
        places.push(peak.r);
    }
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// Where it is looked, ascending.
fn frequencies(asked: &Asked) -> Vec<f64> {
    let (from, to) = (asked.band.from, asked.band.to);
    let mut all: Vec<f64> = asked.even(EVEN).collect();
    let modal = asked.system.modal();
    let free = modal.resonances.iter().zip(&modal.damping_ratios);
    let free = free.map(|(resonance, zeta)| (resonance.hi, zeta.hi));
    let features = asked.system.features(None);
    let held = features.map_or_else(|_| Vec::new(), |features| features.held_resonances());
    let held = held.iter().map(|mode| (mode.r, mode.damping_ratio));
    for (resonance, zeta) in free.chain(held) {
        all.extend(BESIDE.map(|share| resonance * (1.0 + share * zeta.max(LEAST_DAMPING))));
    }
    all.retain(|r| from <= *r && *r <= to);
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// None, and from a little to so much that nothing slides.
fn frictions(asked: &Asked, locked: f64) -> Vec<f64> {
    let limits = asked.sliding_limits();
    let middle = limits.get(limits.len() / 2).copied().unwrap_or(1.0);
    let middle = if 0.0 < middle { middle } else { 1.0 };
    let low = LEAST * middle;
    let high = locked.clamp(2.0 * low, MOST * middle);
    let factor = (high / low).powf(1.0 / (FRICTIONS - 1) as f64);
    let mut all = vec![0.0];
    all.extend((0..FRICTIONS).map(|i| low * factor.powi(i as i32)));
    all
}

//! Periodic loads, and their samples at the steps of the stepper.

use super::error::PeriodicError;
use crate::study::System;
use crate::study::scene::{Excitation, StepInput};
use std::f64::consts::TAU;

/// Number of samples in a cycle of the load's highest harmonic.
const IN_A_CYCLE: usize = 1024;
/// Largest order of a harmonic of the load.
const MOST_ORDER: u32 = 1000;
/// Largest number of steps in a period of the load.
const MOST_STEPS: usize = 65_536;
/// Largest angle by which the fastest mode advances in a step, in rad. This bound limits the error of the cubics that
/// give the largest displacements between steps.
const ANGLE: f64 = 0.1;
/// Largest relative difference at which the last and the first sample of a table are treated as equal.
const SAME: f64 = 1e-9;
/// Largest mean of the base's acceleration or velocity that is treated as rounding in the table, divided by the largest
/// value in the table.
const MEAN: f64 = 1e-6;
/// Number of iterations that compute the spline through displacements. Each iteration divides the error by more than 2.
const SWEEPS: usize = 64;

/// One harmonic a_n cos(nωt − φ) of a periodic load, where 2π/ω is the period of the load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Order n of the harmonic. Order 0 is a constant.
    pub order: u32,
    /// Amplitude a_n of the harmonic: a force, or a displacement of the base.
    pub amplitude: f64,
    /// Lag φ of the harmonic, in rad.
    pub lag: f64,
}

/// Physical quantity in a table of the base's motion: displacement, velocity or acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BaseTable {
    /// The samples are displacements. A periodic cubic spline interpolates them.
    Displacement,
    /// The samples are velocities. Straight lines interpolate them.
    Velocity,
    /// The samples are accelerations. Straight lines interpolate them.
    Acceleration,
}

/// A periodic load over one period, in the units of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicLoad(LoadKind);

#[derive(Clone, Debug, PartialEq)]
enum LoadKind {
    /// The load is a table of forces. The fields are the time between samples, and the forces without the last sample.
    Forces(f64, Vec<f64>),
    /// The load is a base motion. The fields are the time between samples, and displacement and velocity at each
    /// sample.
    Base(f64, Vec<[f64; 2]>),
    /// The load is a sum of harmonics. The fields are its period and the list of its harmonics.
    Harmonics(f64, Vec<Harmonic>),
}

/// Load at one step: displacement and velocity of the base, force, and time derivative of the force.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LoadPoint {
    pub base: [f64; 2],
    pub force: f64,
    pub slope: f64,
}

/// The load at all steps of one period of the load.
#[derive(Clone, Debug)]
pub(super) struct Sampled {
    pub step: f64,
    pub points: Vec<LoadPoint>,
    /// True if forces are cubic functions of time within a step.
    pub cubic: bool,
    /// True if the load is constant within a step.
    pub hold: bool,
}

impl Sampled {
    /// Returns the load at a step. The index may exceed the number of steps in a period.
    pub fn at(&self, step: usize) -> LoadPoint {
        let place = step.checked_rem(self.points.len()).unwrap_or(0);
        self.points.get(place).copied().unwrap_or_default()
    }
}

impl PeriodicLoad {
    /// Creates a force on the excited mass from samples with the time step `step`, in s. The last sample repeats the
    /// first sample.
    ///
    /// # Errors
    /// [`PeriodicError`] for fewer than three samples, for a time step that is not positive, for numbers that are not
    /// finite, and if the last sample differs from the first sample.
    pub fn forces(step: f64, samples: &[f64]) -> Result<Self, PeriodicError> {
        Ok(Self(LoadKind::Forces(
            step,
            closed(step, samples)?.to_vec(),
        )))
    }

    /// Creates a motion of the base from samples of `quantity` (displacement, velocity or acceleration) with the time
    /// step `step`, in s. The last sample repeats the first sample. The function subtracts the mean displacement.
    ///
    /// # Errors
    /// Same errors as [`forces`](Self::forces), and [`PeriodicError::Drifts`] if the base does not return to its
    /// position.
    pub fn base(step: f64, samples: &[f64], quantity: BaseTable) -> Result<Self, PeriodicError> {
        let samples = closed(step, samples)?;
        let next = |values: &[f64], k: usize| at(values, (k + 1) % values.len().max(1));
        let count = samples.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let motion = match quantity {
            BaseTable::Velocity => {
                let rates = settled(samples, "velocity")?;
                let mut place = 0.0;
                let places = rates.iter().enumerate().map(|(k, rate)| {
                    let here = place;
                    place += 0.5 * step * (rate + next(&rates, k));
                    [here, *rate]
                });
                places.collect()
            }
            BaseTable::Acceleration => integrated(step, &settled(samples, "acceleration")?),
            BaseTable::Displacement => {
                let bends = spline(step, samples);
                let rate = |k: usize| {
                    let rise = (next(samples, k) - at(samples, k)) / step;
                    rise - step * (2.0 * at(&bends, k) + next(&bends, k)) / 6.0
                };
                let places = samples.iter().enumerate();
                places.map(|(k, place)| [*place, rate(k)]).collect()
            }
        };
        let mut motion: Vec<[f64; 2]> = motion;
        let places: Vec<f64> = motion.iter().map(|[place, _]| *place).collect();
        let centre = mean(&places);
        for [place, _] in &mut motion {
            *place -= centre;
        }
        Ok(Self(LoadKind::Base(step, motion)))
    }

    /// Creates a load as a sum of harmonics of the frequency 1/`period`. The load is the force on the excited mass, or
    /// the displacement of the base.
    ///
    /// # Errors
    /// [`PeriodicError`] for an empty list, for an order above 1000, for a period that is not positive, and for
    /// numbers that are not finite.
    pub fn harmonics(period: f64, harmonics: &[Harmonic]) -> Result<Self, PeriodicError> {
        if harmonics.is_empty() {
            return Err(PeriodicError::NoHarmonics);
        }
        if let Some(high) = harmonics.iter().find(|one| MOST_ORDER < one.order) {
            return Err(PeriodicError::Order(high.order));
        }
        let numbers = harmonics.iter().flat_map(|one| [one.amplitude, one.lag]);
        let sound = numbers.into_iter().all(f64::is_finite);
        if !(sound && 0.0 < period && period.is_finite()) {
            return Err(PeriodicError::Number);
        }
        Ok(Self(LoadKind::Harmonics(period, harmonics.to_vec())))
    }

    /// Returns the load at the steps that the search uses for this system.
    pub(super) fn sampled(&self, system: &System) -> Result<Sampled, PeriodicError> {
        let scene = system.scene();
        let moving = scene.excitation == Excitation::Base;
        let hold = scene.stepping.input == StepInput::Hold;
        match &self.0 {
            LoadKind::Forces(..) if moving => return Err(PeriodicError::BaseMoves),
            LoadKind::Base(..) if !moving => return Err(PeriodicError::BaseAtRest),
            LoadKind::Forces(..) => {}
            _ if hold => return Err(PeriodicError::Held),
            _ => {}
        }
        let fastest = system.natural_frequencies().into_iter().fold(0.0, f64::max);
        let parts = |step: f64, count: usize| {
            let parts = (step * fastest / ANGLE).ceil().max(1.0);
            let steps = parts * count as f64;
            (steps <= MOST_STEPS as f64)
                .then_some(parts as usize)
                .ok_or(PeriodicError::Long)
        };
        let (step, points) = match &self.0 {
            LoadKind::Forces(step, forces) => {
                let parts = parts(*step, forces.len())?;
                let rise = |k: usize| at(forces, (k + 1) % forces.len().max(1)) - at(forces, k);
                let point = |k: usize, share: f64| LoadPoint {
                    force: at(forces, k) + if hold { 0.0 } else { share * rise(k) },
                    ..LoadPoint::default()
                };
                (step / parts as f64, divided(forces.len(), parts, point))
            }
            LoadKind::Base(step, motion) => {
                let parts = parts(*step, motion.len())?;
                let ends = |k: usize| [k, (k + 1) % motion.len().max(1)];
                let point = |k: usize, share: f64| LoadPoint {
                    base: hermite(
                        ends(k).map(|k| motion.get(k).copied().unwrap_or_default()),
                        *step,
                        share,
                    ),
                    ..LoadPoint::default()
                };
                (step / parts as f64, divided(motion.len(), parts, point))
            }
            LoadKind::Harmonics(period, harmonics) => {
                let highest = harmonics.iter().map(|one| one.order).max().unwrap_or(1);
                let count = IN_A_CYCLE * highest.max(1) as usize;
                let count = count * parts(period / count as f64, count)?;
                let points = (0..count).map(|k| {
                    let [value, rate] = summed(harmonics, *period, k as f64 / count as f64);
                    match moving {
                        true => LoadPoint {
                            base: [value, rate],
                            ..LoadPoint::default()
                        },
                        false => LoadPoint {
                            force: value,
                            slope: rate,
                            ..LoadPoint::default()
                        },
                    }
                });
                (period / count as f64, points.collect())
            }
        };
        Ok(Sampled {
            step,
            points,
            cubic: matches!(self.0, LoadKind::Harmonics(..)) && !moving,
            hold,
        })
    }
}

/// Checks the samples of a table, and returns them without the last sample, which repeats the first sample.
fn closed(step: f64, samples: &[f64]) -> Result<&[f64], PeriodicError> {
    let [first, .., last] = samples else {
        return Err(PeriodicError::Short);
    };
    if samples.len() < 3 {
        return Err(PeriodicError::Short);
    }
    if !(0.0 < step && step.is_finite() && samples.iter().all(|value| value.is_finite())) {
        return Err(PeriodicError::Number);
    }
    let most = samples
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    if SAME * most < (first - last).abs() {
        return Err(PeriodicError::Open(*first, *last));
    }
    Ok(samples.split_last().map_or(samples, |(_, before)| before))
}

/// Returns velocities or accelerations of the base without their mean value. Fails if the mean value is larger than
/// rounding.
fn settled(rates: &[f64], quantity: &'static str) -> Result<Vec<f64>, PeriodicError> {
    let most = rates
        .iter()
        .fold(0.0_f64, |most, rate| most.max(rate.abs()));
    let mean = rates.iter().sum::<f64>() / rates.len() as f64;
    if MEAN * most < mean.abs() {
        return Err(PeriodicError::Drifts(quantity, mean));
    }
    Ok(rates.iter().map(|rate| rate - mean).collect())
}

/// Integrates accelerations. Returns displacement and velocity of the base at the samples. The acceleration changes
/// linearly between samples.
fn integrated(step: f64, accelerations: &[f64]) -> Vec<[f64; 2]> {
    let next = |k: usize| at(accelerations, (k + 1) % accelerations.len().max(1));
    let (mut place, mut rate) = (0.0, 0.0);
    let mut motion = Vec::with_capacity(accelerations.len());
    for (k, here) in accelerations.iter().enumerate() {
        motion.push([place, rate]);
        place += step * (rate + step * (2.0 * here + next(k)) / 6.0);
        rate += 0.5 * step * (here + next(k));
    }
    // The integration starts from velocity 0, so that the base drifts. The loop subtracts this drift. The displacement
    // at the end of the period then equals that at the start.
    let count = accelerations.len() as f64;
    let drift = place / (count * step);
    for (k, [place, rate]) in motion.iter_mut().enumerate() {
        *place -= drift * step * k as f64;
        *rate -= drift;
    }
    motion
}

/// Returns the second derivatives of the periodic cubic spline through displacements.
fn spline(step: f64, places: &[f64]) -> Vec<f64> {
    let count = places.len();
    let mut bends = vec![0.0; count];
    for _ in 0..SWEEPS {
        for k in 0..count {
            let [before, after] = [(k + count - 1) % count, (k + 1) % count];
            let bend = at(places, before) - 2.0 * at(places, k) + at(places, after);
            let bend = 6.0 * bend / (step * step) - at(&bends, before) - at(&bends, after);
            if let Some(to) = bends.get_mut(k) {
                *to = 0.25 * bend;
            }
        }
    }
    bends
}

/// Returns the load at the steps of the search. Each time step of the table is divided into `parts` equal steps.
fn divided(count: usize, parts: usize, point: impl Fn(usize, f64) -> LoadPoint) -> Vec<LoadPoint> {
    let steps = (0..count).flat_map(|k| (0..parts).map(move |part| (k, part)));
    steps
        .map(|(k, part)| point(k, part as f64 / parts as f64))
        .collect()
}

/// Returns displacement and velocity at a fraction of a step, on the cubic between two samples.
fn hermite([[x0, v0], [x1, v1]]: [[f64; 2]; 2], step: f64, share: f64) -> [f64; 2] {
    let (v0, v1, rise) = (v0 * step, v1 * step, x1 - x0);
    let (c, d) = (3.0 * rise - 2.0 * v0 - v1, v0 + v1 - 2.0 * rise);
    [
        x0 + share * (v0 + share * (c + share * d)),
        (v0 + share * (2.0 * c + share * 3.0 * d)) / step,
    ]
}

/// Returns the value of a sum of harmonics and its derivative in time, at a fraction of the period.
fn summed(harmonics: &[Harmonic], period: f64, share: f64) -> [f64; 2] {
    harmonics.iter().fold([0.0; 2], |[value, rate], one| {
        let order = f64::from(one.order);
        let (sine, cosine) = (TAU * order * share - one.lag).sin_cos();
        let omega = TAU * order / period;
        [
            value + one.amplitude * cosine,
            rate - one.amplitude * omega * sine,
        ]
    })
}

fn at(values: &[f64], place: usize) -> f64 {
    values.get(place).copied().unwrap_or(0.0)
}

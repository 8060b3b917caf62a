//! Converts a recording to the inputs of a scene's stepper, one input for each sample.

use super::{Channel, Dimension, MeasureError, Recording};
use crate::System;
use crate::study::SystemInput;
use crate::study::scene::Excitation;

/// The inputs of a stepper at every sample of a recording: base motion or forces, and the friction force.
///
/// The base motion is a recorded displacement, velocity or acceleration. Between samples, the code joins displacements
/// by a cubic spline, and velocities or accelerations by straight lines. The base starts at rest, and displacements are
/// relative to the first sample. Straight lines also join samples of forces and of a recorded friction force.
///
/// ```
/// use frictiongen::System;
/// use frictiongen::measure::{CsvRequest, Inputs, Recording};
///
/// let block: System = "struct Block {
///     masses: { plate: 2.0 }, springs: { base - plate: 800.0 },
///     contact: plate - wall, excitation: plate,
/// }".parse()?;
/// let text = "time_s,force_N\n0,0\n0.01,3\n0.02,5\n0.03,5\n";
/// let recording = Recording::inputs_from_csv(text, &CsvRequest::default())?;
/// let inputs = Inputs::of(&recording, &block, Some(1.5))?;
/// let mut step = block.stepper(inputs.dt())?;
/// step.begin(inputs.at(0))?;
/// for sample in 1..inputs.len() {
///     step.advance(inputs.at(sample))?;
/// }
/// assert!(step.mass("plate")?.displacement() > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Inputs<'r> {
    dt: f64,
    len: usize,
    base: Option<Vec<[f64; 2]>>,
    /// The recorded force on the excited mass, or `None` if it was not recorded.
    force: Option<SiChannel<'r>>,
    /// The recorded forces on other masses, each with the name of the mass.
    others: Vec<(&'r str, SiChannel<'r>)>,
    friction: DriveFriction<'r>,
}

/// A channel of a recording, with the factor that converts its samples to SI units.
#[derive(Clone, Copy, Debug)]
struct SiChannel<'r> {
    samples: &'r [f64],
    scale: f64,
}

impl SiChannel<'_> {
    fn at(&self, sample: usize) -> f64 {
        self.samples.get(sample).copied().unwrap_or(0.0) * self.scale
    }
}

#[derive(Clone, Copy, Debug)]
enum DriveFriction<'r> {
    Constant(f64),
    Recorded(SiChannel<'r>),
}

impl<'r> Inputs<'r> {
    /// Collects the inputs of a scene from the channels of a recording. The channel `base` is the base motion, and
    /// `force` the force on the excited mass. Other channels are forces on the masses of the same name. The kinetic
    /// friction force is the argument `friction`, in N, or the channel `friction`.
    ///
    /// # Errors
    /// [`MeasureError`] for channels with other names, for units that do not fit, and for a missing excitation.
    /// [`MeasureError`] also for a friction force that is missing or given twice.
    pub fn of(
        recording: &'r Recording,
        system: &System,
        friction: Option<f64>,
    ) -> Result<Self, MeasureError> {
        let channels: Vec<&Channel> = recording.channels().iter().collect();
        Self::of_channels((recording, &channels), system, friction)
    }

    /// Collects the inputs of a scene from the given channels of a recording. [`of`](Self::of) uses all channels.
    pub(super) fn of_channels(
        (recording, channels): (&Recording, &[&'r Channel]),
        system: &System,
        friction: Option<f64>,
    ) -> Result<Self, MeasureError> {
        let scene = system.scene();
        let moving = scene.excitation == Excitation::Base;
        let dt = 1.0 / recording.rate();
        let mut inputs = Self {
            dt,
            len: recording.len(),
            base: None,
            force: None,
            others: Vec::new(),
            friction: DriveFriction::Constant(friction.unwrap_or(0.0)),
        };
        let mut recorded = None;
        for channel in channels.iter().copied() {
            let name = channel.name.as_str();
            let is_mass = scene.masses.iter().any(|mass| mass.name == name);
            match name {
                "friction" if !is_mass => recorded = Some(force(channel)?),
                "base" if moving => inputs.base = Some(base(channel, dt)?),
                "force" if !moving && !is_mass => inputs.force = Some(force(channel)?),
                _ if is_mass => inputs.others.push((name, force(channel)?)),
                _ => {
                    let drive = if moving { "base" } else { "force" };
                    let masses = scene.masses.iter().map(|mass| mass.name.clone());
                    let known = [drive.to_owned(), "friction".to_owned()];
                    return Err(MeasureError::NoSuchPlace {
                        channel: name.to_owned(),
                        known: known.into_iter().chain(masses).collect(),
                    });
                }
            }
        }
        match (recorded, friction) {
            (Some(track), None) => inputs.friction = DriveFriction::Recorded(track),
            (None, Some(_)) => {}
            (None, None) => return Err(MeasureError::NoFriction),
            (Some(_), Some(_)) => return Err(MeasureError::TwoFrictions),
        }
        let driven = inputs.base.is_some() || inputs.force.is_some() || !inputs.others.is_empty();
        if !driven {
            return Err(MeasureError::NoDrive(if moving { "base" } else { "force" }));
        }
        Ok(inputs)
    }

    /// Returns the time between two samples of the recording, in s.
    #[must_use]
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// Returns the number of samples in the recording.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Returns false, because a recording always has samples.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Returns the stepper's input at a sample, counted from 0.
    pub fn at(&self, sample: usize) -> SystemInput<'r> {
        let mut input = match &self.base {
            Some(base) => {
                let [place, velocity] = base.get(sample).copied().unwrap_or_default();
                SystemInput::base(place, velocity)
            }
            None => SystemInput::force(self.force.map_or(0.0, |track| track.at(sample))),
        };
        for (name, track) in &self.others {
            input = input.on(name, track.at(sample));
        }
        input.friction(self.friction_at(sample))
    }

    fn friction_at(&self, sample: usize) -> f64 {
        match self.friction {
            DriveFriction::Constant(force) => force,
            DriveFriction::Recorded(track) => track.at(sample),
        }
    }
}

/// Input of a scene with several contacts at one sample. Each mass has the name of its channel in the recording.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct DriveSample<'r> {
    /// Displacement of the base in m, and its velocity in m/s, at the sample.
    pub base: [f64; 2],
    /// Force on the excited mass at the sample, in N.
    pub force: f64,
    /// Forces on other masses at the sample, in N. Each force has the name of its mass.
    pub others: Vec<(&'r str, f64)>,
    /// Kinetic friction force, in N. The force of each contact is this force times the contact's share.
    pub friction: f64,
}

impl<'r> Inputs<'r> {
    /// Returns the input at a sample, counted from 0, for a scene with several contacts.
    #[doc(hidden)]
    #[must_use]
    pub fn sample(&self, sample: usize) -> DriveSample<'r> {
        let base = self.base.as_ref().and_then(|base| base.get(sample));
        let others = self.others.iter();
        DriveSample {
            base: base.copied().unwrap_or_default(),
            force: self.force.map_or(0.0, |track| track.at(sample)),
            others: others
                .map(|(name, track)| (*name, track.at(sample)))
                .collect(),
            friction: self.friction_at(sample),
        }
    }
}

fn force(channel: &Channel) -> Result<SiChannel<'_>, MeasureError> {
    if channel.unit.dimension() != Dimension::Force {
        return Err(wrong(channel));
    }
    Ok(SiChannel {
        samples: &channel.samples,
        scale: channel.unit.scale(),
    })
}

fn wrong(channel: &Channel) -> MeasureError {
    MeasureError::WrongDimension {
        channel: channel.name.clone(),
        unit: channel.unit.name(),
    }
}

/// Returns displacement and velocity of the base, in m and m/s, at every sample.
fn base(channel: &Channel, dt: f64) -> Result<Vec<[f64; 2]>, MeasureError> {
    let scale = channel.unit.scale();
    let values = channel.samples.iter().map(|value| value * scale);
    Ok(match channel.unit.dimension() {
        Dimension::Displacement => {
            let first = channel.samples.first().map_or(0.0, |value| value * scale);
            let places: Vec<f64> = values.map(|value| value - first).collect();
            let slopes = spline_slopes(&places);
            let both = places.iter().zip(slopes);
            both.map(|(place, slope)| [*place, slope / dt]).collect()
        }
        Dimension::Velocity => {
            let mut place = 0.0;
            let mut last = None;
            values
                .map(|velocity| {
                    place += 0.5 * dt * last.map_or(0.0, |last: f64| last + velocity);
                    last = Some(velocity);
                    [place, velocity]
                })
                .collect()
        }
        Dimension::Acceleration => {
            let (mut place, mut velocity) = (0.0, 0.0);
            let mut last: Option<f64> = None;
            values
                .map(|acceleration| {
                    if let Some(last) = last {
                        place += dt * velocity + dt * dt / 6.0 * (2.0 * last + acceleration);
                        velocity += 0.5 * dt * (last + acceleration);
                    }
                    last = Some(acceleration);
                    [place, velocity]
                })
                .collect()
        }
        _ => return Err(wrong(channel)),
    })
}

/// Returns the acceleration of the base, in m/s², at the start and at the end of every step from one sample to the
/// next. The acceleration changes linearly within a step.
pub(super) fn accelerations(channel: &Channel, dt: f64) -> Result<Vec<[f64; 2]>, MeasureError> {
    let scale = channel.unit.scale();
    let pairs = channel.samples.windows(2);
    let pairs = pairs.filter_map(|pair| Some([pair.first()? * scale, pair.get(1)? * scale]));
    Ok(match channel.unit.dimension() {
        Dimension::Acceleration => pairs.collect(),
        Dimension::Velocity => pairs.map(|[a, b]| [(b - a) / dt; 2]).collect(),
        Dimension::Displacement => {
            let motion = base(channel, dt)?;
            let steps = motion.windows(2).filter_map(|pair| {
                let [[x, v], [y, w]] = pair else { return None };
                let chord = 3.0 * (y - x) / dt;
                let acceleration = 2.0 / dt;
                Some([
                    acceleration * (chord - 2.0 * v - w),
                    acceleration * (v + 2.0 * w - chord),
                ])
            });
            steps.collect()
        }
        _ => return Err(wrong(channel)),
    })
}

/// Returns the slopes, per sample step, of the cubic spline through `values`. The spline begins with slope 0 and ends
/// with curvature 0.
fn spline_slopes(values: &[f64]) -> Vec<f64> {
    // The slopes s_i at the samples y_i satisfy s₀ = 0, s_{i−1} + 4s_i + s_{i+1} = 3(y_{i+1} − y_{i−1}) and s_{n−1} +
    // 2s_n = 3(y_n − y_{n−1}).
    let last = values.len().saturating_sub(1);
    let value = |index: usize| values.get(index).copied().unwrap_or(0.0);
    let mut factors = vec![0.0];
    let mut slopes = vec![0.0];
    for index in 1..=last {
        let (diagonal, right) = if index == last {
            (2.0, 3.0 * (value(index) - value(index - 1)))
        } else {
            (4.0, 3.0 * (value(index + 1) - value(index - 1)))
        };
        let before = slopes.last().copied().unwrap_or(0.0);
        let factor = factors.last().copied().unwrap_or(0.0);
        let pivot = diagonal - factor;
        slopes.push((right - before) / pivot);
        factors.push(1.0 / pivot);
    }
    for index in (1..last).rev() {
        let next = slopes.get(index + 1).copied().unwrap_or(0.0);
        if let (Some(slope), Some(factor)) = (slopes.get_mut(index), factors.get(index)) {
            *slope -= factor * next;
        }
    }
    slopes.truncate(values.len());
    slopes
}

#[cfg(test)]
mod tests {
    use super::spline_slopes;

    #[test]
    fn a_spline_keeps_what_it_can() {
        // The cubic y = s²(3n − s) has slope 0 at s = 0 and curvature 0 at s = n. The spline has the same end
        // conditions, so that it must reproduce this cubic.
        let n = 20_u32;
        let value = |s: f64| s * s * (3.0 * f64::from(n) - s);
        let slope = |s: f64| 6.0 * f64::from(n) * s - 3.0 * s * s;
        let values: Vec<f64> = (0..=n).map(|s| value(f64::from(s))).collect();
        for (s, found) in (0..=n).zip(spline_slopes(&values)) {
            // The tolerance covers the rounding of values up to 16,000.
            assert!((found - slope(f64::from(s))).abs() < 1e-11, "{s}: {found}");
        }
        assert_eq!(spline_slopes(&[1.0]), [0.0]);
        assert_eq!(spline_slopes(&[]), [0.0_f64; 0]);
    }
}

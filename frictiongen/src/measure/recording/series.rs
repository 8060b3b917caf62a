//! Recordings: several signals, sampled at the same times.

use super::Channel;
use super::{check, rate};
use crate::measure::MeasureError;

/// A recording: samples of several channels. They are evenly spaced in time, except in recordings of inputs
/// ([`Recording::inputs_at`]).
///
/// [`Recording::new`] rejects an unusable recording: one with too few samples, with values that are not finite, or
/// with a channel that never changes or is clipped.
///
/// ```
/// use frictiongen::measure::{CsvRequest, MeasureError, Recording};
///
/// let text = "time_s,base_mm,plate_mm\n0,1.0,0.5\n0.001,0.9,NaN\n";
/// let error = Recording::from_csv(text, &CsvRequest::default());
/// assert!(matches!(error, Err(MeasureError::NotANumber { line: 3, .. })));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    rate: f64,
    channels: Vec<Channel>,
    /// The times of samples that are not evenly spaced.
    uneven: Option<Uneven>,
}

/// Times of samples that are not evenly spaced.
#[derive(Clone, Debug, PartialEq)]
struct Uneven {
    /// Times since the first sample, in s.
    times: Vec<f64>,
    /// The first uneven step, as the error of a call that needs even steps.
    error: MeasureError,
}

impl Recording {
    /// Creates a recording from channels with `rate` samples per second.
    ///
    /// # Errors
    /// [`MeasureError`] for a rate that is not above 0, for too few samples, and for channels of different lengths or
    /// with the same name. [`MeasureError`] also for values that are not finite, and for a channel that is constant or
    /// clipped.
    pub fn new(rate: f64, channels: Vec<Channel>) -> Result<Self, MeasureError> {
        check::channels(&channels)?;
        Self::inputs(rate, channels)
    }

    /// Creates a recording of the inputs that drive a scene. A single channel is enough, and a channel may be
    /// constant.
    ///
    /// # Errors
    /// [`MeasureError`] for a rate that is not above 0, and for fewer than two samples. [`MeasureError`] also for
    /// channels of different lengths or with the same name, and for values that are not finite.
    pub fn inputs(rate: f64, channels: Vec<Channel>) -> Result<Self, MeasureError> {
        check::form(&channels, 2)?;
        if !(0.0 < rate && rate.is_finite()) {
            return Err(MeasureError::NoRate);
        }
        Ok(Self {
            rate,
            channels,
            uneven: None,
        })
    }

    /// Creates a recording of the inputs that drive a scene, as [`inputs`](Self::inputs) does, from the times of the samples
    /// in s. The steps may differ. `place` returns the name of a sample for an error.
    ///
    /// ```
    /// use frictiongen::measure::{Channel, Recording, Unit};
    ///
    /// let base = Channel { name: "base".to_owned(), unit: Unit::MILLIMETRE, samples: vec![0.0, 1.0, 0.0] };
    /// let recording = Recording::inputs_at(&[0.0, 0.25, 0.75], vec![base])?;
    /// assert!(recording.even_rate().is_err());
    /// # Ok::<(), frictiongen::measure::MeasureError>(())
    /// ```
    ///
    /// # Errors
    /// Same errors as [`inputs`](Self::inputs), and [`MeasureError::MixedRates`] for times that do not increase.
    pub fn inputs_at(times: &[f64], channels: Vec<Channel>) -> Result<Self, MeasureError> {
        Self::inputs_named(times, channels, |index| format!("sample {index}"))
    }

    /// Creates a recording of inputs from the times of the samples. `place` returns the name of a sample for an error.
    pub(super) fn inputs_named(
        times: &[f64],
        channels: Vec<Channel>,
        place: impl Fn(usize) -> String,
    ) -> Result<Self, MeasureError> {
        let error = match rate::even_rate(times, place) {
            Ok(rate) => return Self::inputs(rate, channels),
            Err(error) => error,
        };
        let steps = times.windows(2).filter_map(|pair| match pair {
            [before, after] => Some(after - before),
            _ => None,
        });
        let ascends = steps.clone().all(|step| 0.0 < step && step.is_finite());
        let shortest = steps.fold(f64::INFINITY, f64::min);
        if !ascends {
            return Err(error);
        }
        let recording = Self::inputs(1.0 / shortest, channels)?;
        if recording.len() != times.len() {
            return Err(MeasureError::Lengths("time".to_owned()));
        }
        let first = times.first().copied().unwrap_or(0.0);
        let times = times.iter().map(|time| time - first).collect();
        Ok(Self {
            uneven: Some(Uneven { times, error }),
            ..recording
        })
    }

    /// Returns the sampling rate, in samples per second, from the times of the samples in s. The times must be evenly
    /// spaced, apart from the rounding of a clock.
    ///
    /// ```
    /// use frictiongen::measure::Recording;
    ///
    /// assert_eq!(Recording::rate_of(&[0.0, 0.25, 0.5])?, 4.0);
    /// assert!(Recording::rate_of(&[0.0, 0.25, 0.75]).is_err());
    /// # Ok::<(), frictiongen::measure::MeasureError>(())
    /// ```
    ///
    /// # Errors
    /// [`MeasureError::MixedRates`] for uneven times, and [`MeasureError::TooShort`] for fewer than two times.
    pub fn rate_of(times: &[f64]) -> Result<f64, MeasureError> {
        if times.len() < 2 {
            return Err(MeasureError::TooShort {
                found: format!("{} times", times.len()),
                needed: "2",
            });
        }
        rate::even_rate(times, |index| format!("sample {index}"))
    }

    /// Returns the sampling rate, in samples per second. If the samples are not evenly spaced, this is the rate of the
    /// shortest step.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// Returns the sampling rate, in samples per second, of evenly spaced samples.
    ///
    /// # Errors
    /// [`MeasureError::MixedRates`] if the samples are not evenly spaced.
    pub fn even_rate(&self) -> Result<f64, MeasureError> {
        match &self.uneven {
            None => Ok(self.rate),
            Some(uneven) => Err(uneven.error.clone()),
        }
    }

    /// Returns the times since the first sample in s, if the samples are not evenly spaced.
    #[must_use]
    pub fn uneven_times(&self) -> Option<&[f64]> {
        self.uneven.as_ref().map(|uneven| uneven.times.as_slice())
    }

    /// Returns all channels of the recording.
    #[must_use]
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// Returns the channel with the given name, or `None` if no channel has this name.
    #[must_use]
    pub fn channel(&self, name: &str) -> Option<&Channel> {
        self.channels.iter().find(|channel| channel.name == name)
    }

    /// Returns the number of samples in each channel.
    #[must_use]
    pub fn len(&self) -> usize {
        self.channels
            .first()
            .map_or(0, |channel| channel.samples.len())
    }

    /// Returns false, because a recording always has samples.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

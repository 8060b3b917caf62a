//! Signals that were sampled together.

use super::channel::Channel;
use super::{check, rate};
use crate::measure::MeasureError;

/// Evenly spaced samples of several channels.
///
/// A recording that cannot tell anything is refused when it is made: no samples, values that are not finite, a channel that
/// never changes, or one that is clipped.
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
}

impl Recording {
    /// Samples at `rate` a second.
    ///
    /// # Errors
    /// [`MeasureError`] for a rate that is not above 0, no samples or a few, channels of different lengths or of the same
    /// name, values that are not finite, and a channel that is constant or clipped.
    pub fn new(rate: f64, channels: Vec<Channel>) -> Result<Self, MeasureError> {
        check::channels(&channels)?;
        Self::inputs(rate, channels)
    }

    /// The same of what drives a scene: one channel will do, and a constant one too.
    ///
    /// # Errors
    /// [`MeasureError`] for a rate that is not above 0, no samples, channels of different lengths or of the same name, and values
    /// that are not finite.
    pub fn inputs(rate: f64, channels: Vec<Channel>) -> Result<Self, MeasureError> {
        check::form(&channels, 2)?;
        if !(0.0 < rate && rate.is_finite()) {
            return Err(MeasureError::NoRate);
        }
        Ok(Self { rate, channels })
    }

    /// How many samples a second there are in a row of times, in s, which are evenly spaced but for what a clock rounds.
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
    /// [`MeasureError::MixedRates`]; [`MeasureError::TooShort`] for fewer than two.
    pub fn rate_of(times: &[f64]) -> Result<f64, MeasureError> {
        if times.len() < 2 {
            return Err(MeasureError::TooShort {
                found: format!("{} times", times.len()),
                needed: "2",
            });
        }
        rate::even_rate(times, |index| format!("sample {index}"))
    }

    /// How many samples a second has.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// All channels.
    #[must_use]
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// A channel by its name.
    #[must_use]
    pub fn channel(&self, name: &str) -> Option<&Channel> {
        self.channels.iter().find(|channel| channel.name == name)
    }

    /// How many samples each channel has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.channels
            .first()
            .map_or(0, |channel| channel.samples.len())
    }

    /// Whether there are none, which never is so.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

//! Recordings: samples of several channels, from arrays or from files.

use crate::asked::{Optional, numbers, one};
use crate::errors::{domain, measurement, wrong_type};
use frictiongen::measure::{Channel, CsvColumn, CsvRequest, MeasureError, Recording, Unit};
use numpy::PyArray1;
use pyo3::prelude::*;

/// A recording, with its name for messages to the user.
#[pyclass(frozen, module = "frictiongen._native", name = "Recording")]
pub struct NativeRecording {
    /// The recording, as a type of the Rust library.
    pub recording: Recording,
    /// Name of the file from which the recording comes. `None` if the recording comes from arrays.
    pub source: Option<String>,
}

impl NativeRecording {
    /// Returns the name of this recording for a message. `place` is the index of the recording, and `of` the number of
    /// recordings.
    pub fn called(&self, place: usize, of: usize) -> Option<String> {
        let number = || (1 < of).then(|| format!("recording {}", place + 1));
        self.source.clone().or_else(number)
    }
}

/// Reads the sampling rate in Hz, if the caller gave one.
fn rate_of(given: Option<&Bound<'_, PyAny>>) -> PyResult<Option<f64>> {
    let rate = given.map(|given| one("rate", given)).transpose()?;
    match rate {
        Some(rate) if !(0.0 < rate && rate.is_finite()) => Err(domain(format_args!(
            "rate is {rate:?}: the number of samples a second must be above 0 and finite"
        ))),
        rate => Ok(rate),
    }
}

fn unit_of(name: &str, unit: &str) -> PyResult<Unit> {
    unit.parse()
        .map_err(|error| domain(format_args!("the channel `{name}`: {error}")))
}

#[pymethods]
impl NativeRecording {
    /// Creates a recording from Python arrays. Each channel has a name, samples and a unit.
    #[new]
    fn new<'py>(
        py: Python<'py>,
        channels: Vec<(String, Bound<'py, PyAny>, Option<String>)>,
        rate: Optional<'py>,
        times: Optional<'py>,
        drives: bool,
    ) -> PyResult<Self> {
        let told = |error: MeasureError| measurement(py, None, &error);
        let mut listed = Vec::new();
        for (name, samples, unit) in channels {
            let argument = format!("the channel `{name}`");
            let Some(unit) = unit else {
                return Err(told(MeasureError::NoUnit(name)));
            };
            let given = numbers(&argument, &samples)?;
            if given.is_one {
                return Err(domain(format_args!(
                    "{argument}: a row of samples is needed, not one number"
                )));
            }
            listed.push(Channel {
                unit: unit_of(&name, &unit)?,
                name,
                samples: given.values,
            });
        }
        let sampling = match (rate_of(rate.as_ref())?, times) {
            (Some(_), Some(_)) => {
                return Err(domain("give either rate or time_s, not both"));
            }
            (None, None) => return Err(told(MeasureError::NoRate)),
            (Some(rate), None) => Ok(rate),
            (None, Some(times)) => {
                let times = numbers("time_s", &times)?;
                if let Some(channel) = listed.first()
                    && channel.samples.len() != times.values.len()
                {
                    return Err(domain(format_args!(
                        "time_s: {} times are given, but `{}` has {} samples",
                        times.values.len(),
                        channel.name,
                        channel.samples.len()
                    )));
                }
                match Recording::rate_of(&times.values) {
                    Ok(rate) => Ok(rate),
                    // Only inputs may have uneven times.
                    Err(_) if drives => Err(times.values),
                    Err(error) => return Err(measurement(py, Some("time_s"), &error)),
                }
            }
        };
        let uneven = sampling.is_err();
        let recording = py.detach(|| match sampling {
            Err(times) => Recording::inputs_at(&times, listed),
            Ok(rate) if drives => Recording::inputs(rate, listed),
            Ok(rate) => Recording::new(rate, listed),
        });
        Ok(Self {
            recording: recording.map_err(|error| {
                let source = uneven.then_some("time_s");
                measurement(py, source, &error)
            })?,
            source: None,
        })
    }

    /// Reads a recording from a text. `channels` names the columns to read, with their units.
    #[staticmethod]
    fn read<'py>(
        py: Python<'py>,
        text: &str,
        source: Option<String>,
        channels: Vec<(String, String, Option<String>)>,
        rate: Optional<'py>,
        drives: bool,
    ) -> PyResult<Self> {
        let mut columns = Vec::new();
        for (name, column, unit) in channels {
            let unit = unit.map(|unit| unit_of(&name, &unit)).transpose()?;
            columns.push(CsvColumn { name, column, unit });
        }
        let request = CsvRequest {
            rate: rate_of(rate.as_ref())?,
            columns,
        };
        let recording = py.detach(|| {
            if drives {
                Recording::inputs_from_csv(text, &request)
            } else {
                Recording::from_text(text, &request)
            }
        });
        Ok(Self {
            recording: recording.map_err(|error| measurement(py, source.as_deref(), &error))?,
            source,
        })
    }

    /// Returns the sampling rate, Hz.
    #[getter]
    fn rate(&self) -> f64 {
        self.recording.rate()
    }

    /// Returns the times since the first sample in s, if the samples are not evenly spaced.
    #[getter]
    fn uneven_times<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        let times = self.recording.uneven_times();
        times.map(|times| PyArray1::from_slice(py, times))
    }

    /// Returns the name and the unit of each channel of the recording.
    #[getter]
    fn channels(&self) -> Vec<(String, &'static str)> {
        let channels = self.recording.channels().iter();
        channels
            .map(|channel| (channel.name.clone(), channel.unit.name()))
            .collect()
    }

    /// Returns the samples of a channel, in the unit of the channel.
    fn samples<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        match self.recording.channel(name) {
            Some(channel) => Ok(PyArray1::from_slice(py, &channel.samples)),
            None => Err(wrong_type(format_args!("there is no channel `{name}`"))),
        }
    }

    /// Returns the recording as CSV text, which `read` accepts.
    fn to_csv(&self, py: Python<'_>) -> String {
        py.detach(|| self.recording.to_csv())
    }

    /// Returns the recording as the text of a universal file (UFF 58).
    fn to_uff58(&self, py: Python<'_>) -> String {
        py.detach(|| self.recording.to_uff58())
    }

    fn __len__(&self) -> usize {
        self.recording.len()
    }
}

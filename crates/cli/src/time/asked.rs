//! Parses the options for the length of a motion over time.

use crate::args::TimeArguments;
use crate::asked::whole;
use crate::failure::Failure;
use frictiongen::study::history::MOST_SAMPLES;

/// Upper bound on each of three numbers: cycles, skipped cycles, and samples in a cycle.
const MOST: u32 = MOST_SAMPLES as u32;

/// Length of the motion over time that the user requests, and the form of its output.
#[derive(Clone, Copy, Debug)]
pub struct TimeRequest {
    /// Number of cycles of the excitation in the output.
    pub cycles: u32,
    /// Number of cycles of the excitation before the first cycle of the output.
    pub skip: u32,
    /// Number of samples in a cycle of the excitation.
    pub samples: u32,
    /// True if the output is one period of the steady state. If false, the output is a run from the initial state.
    pub steady: bool,
    /// True if the output is the spectrum. If false, the output is samples or events.
    pub spectrum: bool,
}

impl TimeRequest {
    /// Request for one period of the steady state, with as many samples as a picture needs.
    #[cfg(feature = "pictures")]
    pub const PERIOD: Self = Self {
        cycles: 1,
        skip: 0,
        samples: 200,
        steady: true,
        spectrum: false,
    };

    /// Reads the options of `frictiongen time`.
    pub fn parse(arguments: &TimeArguments) -> Result<Self, Failure> {
        let number = |option, text: &Option<String>, least, default| match text {
            Some(text) => whole(option, text, least..=MOST),
            None => Ok(default),
        };
        let asked = Self {
            cycles: number("--cycles", &arguments.cycles, 1, 10)?,
            skip: number("--skip", &arguments.skip, 0, 0)?,
            samples: number(
                "--samples",
                &arguments.samples,
                2,
                if arguments.until.is_some() { 1000 } else { 200 },
            )?,
            steady: arguments.steady,
            spectrum: arguments.spectrum,
        };
        if asked.samples.is_multiple_of(2) {
            Ok(asked)
        } else {
            Err(Failure::new(format_args!(
                "--samples `{}`: an even number is needed",
                asked.samples
            )))
        }
    }
}

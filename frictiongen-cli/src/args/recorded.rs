//! Arguments of the commands that read recordings, with the text that `--help` prints below their options.

use super::FormatArguments;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The scene and its recordings.
#[derive(Debug, Args)]
pub struct RecordingArguments {
    /// File with the description; standard input if it is -
    #[arg(value_name = "FILE")]
    pub scene: PathBuf,
    /// Recordings, as CSV or UFF58
    #[arg(value_name = "RECORDING", required = true)]
    pub recordings: Vec<PathBuf>,
    /// Column and unit of a channel: base, force or a mass; may be given more than once [default: by name]
    #[arg(long, value_name = "NAME=COLUMN:UNIT")]
    pub channel: Vec<String>,
    /// Samples per second, if no column has the time
    #[arg(long, value_name = "HZ", allow_hyphen_values = true)]
    pub rate: Option<String>,
}

/// Arguments of `frictiongen transmissibility`.
#[derive(Debug, Args)]
pub struct TransmissibilityArguments {
    /// The description and the recordings.
    #[command(flatten)]
    pub recordings: RecordingArguments,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file; the file extension sets the format: .csv, .json
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// The quantities of a motion that are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum By {
    /// Amplitude and phase.
    #[default]
    Both,
    /// The amplitude alone.
    Amplitude,
    /// The phase alone.
    Phase,
}

/// An unknown that is fitted together with the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Also {
    /// One damping ratio for all modes.
    Damping,
    /// A factor on all natural frequencies.
    Frequency,
    /// Static over kinetic friction. Only motions with stops depend on it.
    Stiction,
}

/// Arguments of `frictiongen identify`.
#[derive(Debug, Args)]
pub struct IdentifyArguments {
    /// The description and the recordings.
    #[command(flatten)]
    pub recordings: RecordingArguments,
    /// Quantities that are compared with the recording
    #[arg(long, value_enum, default_value_t)]
    pub by: By,
    /// Use only this mass; may be given more than once [default: every recorded mass]
    #[arg(long, value_name = "NAME")]
    pub mass: Vec<String>,
    /// Fit this too, together with the friction force; may be given more than once
    #[arg(long, value_enum)]
    pub also: Vec<Also>,
    /// Use also the odd harmonics up to order N
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Range of friction forces to search, in N [default: from 0 to where the contact is stuck]
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    pub between: Option<String>,
    /// The recording is a free vibration of a scene with one mass
    #[arg(long, conflicts_with_all = ["by", "mass", "harmonics", "between"])]
    pub decay: bool,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file; .csv and .json have the answers, .svg (and .png with the feature png) shows the residuals
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen fit`.
#[derive(Debug, Args)]
pub struct FitArguments {
    /// File with the description, whose values are the first guess; standard input if it is -
    #[arg(value_name = "FILE")]
    pub scene: PathBuf,
    /// The sweep, as CSV: frequency_Hz, and NAME.transmissibility and NAME.deviation of masses
    #[arg(value_name = "SWEEP")]
    pub sweep: PathBuf,
    /// Fit also one damping ratio for all modes
    #[arg(long)]
    pub damping: bool,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file; the file extension sets the format: .csv, .json
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen drive`.
#[derive(Debug, Args)]
pub struct DriveArguments {
    /// The description and the recordings.
    #[command(flatten)]
    pub recordings: RecordingArguments,
    /// Kinetic friction force F in N [default: the channel friction]
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub friction: Option<String>,
    /// Print only this mass, or the contact; may be given more than once [default: every mass and the contact]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file; the file extension sets the format: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Text below the options of `drive`.
pub const DRIVES: &str = "\
Recording:
  A CSV of the inputs at even times: base, or force on the excited mass, names of masses for forces on
  them, and friction where it changes:
    time_s,base_m_s2
  The base comes as displacement, velocity or acceleration. It goes along the cubic spline through
  displacements, and in straight lines between velocities or accelerations; forces go in straight lines.
  --channel base=EW:m_s2  the column EW is the acceleration of the base
  The chain starts from rest; displacements of the base count from the first sample.

Quantities:
  displacement, velocity  of a mass; of the contact the relative motion
  force           the friction force in N; what holds the contact while it sticks
  state           sticks, or which way it slides, at the sample
  events          stops, break-aways and reversals since the sample before

Below the table, and in the JSON: the work of the load, and what friction and damping took of it, in J;
in how many steps more events happened than are followed.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

/// Text below the options of all commands that read recordings.
pub const RECORDINGS: &str = "\
Recordings:
  A CSV has one line of names with their units, then numbers, separated by commas, semicolons or tabs:
    time_s,base_mm,upper_m_s2
  or a second line with the units. base is the motion of the base, force the force that drives; other
  names are masses. Units: m, cm, mm, um, m_s, mm_s, m_s2, mm_s2, g, N, mN, kN, s, ms, us. A unit is
  never guessed. Displacements, velocities and accelerations may be mixed.
  A universal file has a data set 58 for each channel, with the unit as label of its ordinate.
  --channel upper=AI1:mm  the column AI1 is the mass upper, in mm; columns not named are left out
  --channel upper=3:mm    the third column
  A recording has one driving frequency, or is a free vibration for --decay of identify.
  The steady part is found; a constant or clipped channel, a drive that drifts, uneven steps of time
  and fewer than 8 cycles are errors.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

/// Text below the options of `identify`.
pub const IDENTIFICATIONS: &str = "\
Answers:
  not explained   the description does not move like the rig: residuals exceed what noise makes once in
                  1000 recordings, and the force may be far from the rig's
  told            the interval of 95 % holds one friction force, and is narrower than that is large
  several levels  several friction forces give this response: each with its interval
  stuck           the contact never slides: the interval begins at the least force that holds it
  not told        the response hardly changes with friction here, as at an invariant point
  all but stuck   amplitudes without phases are so small that a unit may be wrong by 1000

Quantities:
  friction force  F in N, for a scene in kg and N/m
  condition       how much a relative error of the data grows on the way to the friction force
  misfit          sum of squares of residuals over deviations, by degrees of freedom: 1 where noise
                  is all that is left; where it is more than chance the answer is not explained, and
                  the intervals are wider
  amplitude, lag  of the fundamental over the excitation, measured and computed

";

/// Text below the options of `fit`.
pub const FITS: &str = "\
The sweep is measured without friction; `frictiongen transmissibility -o sweep.csv` writes one from
recordings. The scene is driven by its base. One storey gives its natural frequency, two r, gamma and
kappa (thesis 6.15 to 6.20), more alike. The first mass stays, since a base tells ratios alone.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

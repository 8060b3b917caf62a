//! Arguments of the commands that read recordings, with the text that `--help` prints below their options.

use super::FormatArguments;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Arguments for the scene and its recordings.
#[derive(Debug, Args)]
pub struct RecordingArguments {
    /// File with the description; standard input if it is -
    #[arg(value_name = "FILE")]
    pub scene: PathBuf,
    /// Files with recordings over time, as CSV or UFF58 (universal file format)
    #[arg(value_name = "RECORDING", required = true)]
    pub recordings: Vec<PathBuf>,
    /// Column and unit of the base motion, of the force or of a mass, as NAME=COLUMN:UNIT; may be given more than once
    /// [default: the column NAME]
    #[arg(long, value_name = "NAME=COLUMN:UNIT")]
    pub channel: Vec<String>,
    /// Sampling rate in Hz (samples per second), for recordings without a time column
    #[arg(long, value_name = "HZ", allow_hyphen_values = true)]
    pub rate: Option<String>,
}

/// Arguments of `frictiongen transmissibility`.
#[derive(Debug, Args)]
pub struct TransmissibilityArguments {
    /// Arguments for the description and the recordings.
    #[command(flatten)]
    pub recordings: RecordingArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv or .json
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Quantities of the motion that the command compares with the recording: amplitude, phase, or both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum By {
    /// Compare amplitude and phase.
    #[default]
    Both,
    /// Compare the amplitude alone.
    Amplitude,
    /// Compare the phase alone.
    Phase,
}

/// An unknown that the command fits together with the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Also {
    /// Fit one damping ratio for all modes.
    Damping,
    /// Fit one factor on all natural frequencies.
    Frequency,
    /// Fit the ratio μ of static to kinetic friction, which affects only motions with stops.
    Stiction,
    /// Fit the stiffness of an elastic contact. The description contains a first guess.
    Stiffness,
}

/// Arguments of `frictiongen identify`.
#[derive(Debug, Args)]
pub struct IdentifyArguments {
    /// Arguments for the description and the recordings.
    #[command(flatten)]
    pub recordings: RecordingArguments,
    /// Compare the amplitude, the phase or both with the recording
    #[arg(long, value_enum, default_value_t)]
    pub by: By,
    /// Use only the recorded motion of this mass; may be given more than once [default: every recorded mass]
    #[arg(long, value_name = "NAME")]
    pub mass: Vec<String>,
    /// Fit this unknown together with the friction force; may be given more than once
    #[arg(long, value_enum)]
    pub also: Vec<Also>,
    /// Compare also the odd harmonics of the motion up to order N, for example 5
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Range of friction forces to search, in N [default: from 0 to the force at which the contact is stuck]
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    pub between: Option<String>,
    /// Find the friction from the decay of a recorded free vibration, for a scene with one mass
    #[arg(long, conflicts_with_all = ["by", "mass", "harmonics", "between"])]
    pub decay: bool,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file: the answers as .csv or .json, or the residuals as .svg (.png with the feature png)
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen fit`.
#[derive(Debug, Args)]
pub struct FitArguments {
    /// File with the description, whose values are the first guess; standard input if it is -
    #[arg(value_name = "FILE")]
    pub scene: PathBuf,
    /// Measured sweep as CSV, with the column frequency_Hz, and the columns NAME.transmissibility and NAME.deviation
    /// for each mass. With --friction or --vary, a recording of the whole motion as CSV
    #[arg(value_name = "SWEEP")]
    pub sweep: PathBuf,
    /// Fit also one damping ratio for all modes
    #[arg(long, conflicts_with_all = ["friction", "vary"])]
    pub damping: bool,
    /// Fit the kinetic friction force to a recording of the whole motion; F in N is the first guess
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub friction: Option<String>,
    /// Fit this number of the description to a recording of the whole motion, such as `mu`, `k2`, `m upper` or `zeta`;
    /// may be given more than once
    #[arg(long, value_name = "NAME")]
    pub vary: Vec<String>,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv or .json
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen drive`.
#[derive(Debug, Args)]
pub struct DriveArguments {
    /// Arguments for the description and the recordings.
    #[command(flatten)]
    pub recordings: RecordingArguments,
    /// Input over time, instead of a recording, for example "step 5 N from 0.5 s" or "half-sine 10 g for 11 ms"; may be
    /// given more than once. `frictiongen time --help` lists all inputs
    #[arg(
        long,
        value_name = "TEXT",
        requires = "until",
        requires = "friction",
        conflicts_with_all = ["recordings", "channel", "rate", "after", "spectrum"]
    )]
    pub input: Vec<String>,
    /// End of the motion under --input, in s
    #[arg(long, value_name = "S", allow_hyphen_values = true, requires = "input")]
    pub until: Option<String>,
    /// Number of sample intervals of the motion under --input [default: 1000]
    #[arg(long, value_name = "N", allow_hyphen_values = true, requires = "input")]
    pub samples: Option<String>,
    /// Kinetic friction force F in N, constant over time; with --peaks also a grid of forces [default: the channel
    /// `friction` of the recording]
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub friction: Option<String>,
    /// Print the largest value of each quantity and its instant, exact also between samples, and the value at the end
    #[arg(long)]
    pub peaks: bool,
    /// Print only this quantity: a mass, `contact`, a difference of two masses such as `roof-first`, a spring force
    /// `spring(a-b)`, the base shear `shear`; may be given more than once [default: the contact and every mass,
    /// relative to the base if the base moves]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Follow the motion for S seconds after the record, where forces, velocities and accelerations are 0, and
    /// displacements and friction keep their last value
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub after: Option<String>,
    /// Print the response spectrum of the recorded base motion instead of the motion, for the damping ratio ZETA, for
    /// example 0.05
    #[arg(long, value_name = "ZETA", allow_hyphen_values = true, conflicts_with_all = ["friction", "of", "after", "peaks"])]
    pub spectrum: Option<String>,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv, .json, .svg, or .png if the program has the
    /// feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Text below the options of `drive`.
pub const DRIVES: &str = "\
Recording:
  A CSV file has the inputs at increasing times. The steps may differ:
    time_s,base_m_s2
  The column `base` is the motion of the base: displacement, velocity or acceleration. The column `force` is
  the force on the excited mass. A column with the name of a mass is a force on that mass. The column
  `friction` is the friction force, if it changes. Straight lines join the samples of each column, also of
  displacements: a step of the base takes one sample interval, and nothing moves before it. Under velocities
  the base moves in parabolas, under accelerations in cubics.
  --channel base=EW:m_s2  the column EW is the acceleration of the base
  A file may also contain only numbers, separated by blanks, tabs or semicolons. Decimal commas are allowed.
  If there are several columns, the first is the time in s, unless --rate gives the samples per second:
  --channel base=2:g          time in s and acceleration in g
  --rate 100 --channel base=1:m_s2   one column
  A PEER AT2 record (a header with NPTS and DT, then accelerations in g) needs no option.
  At the first sample all masses are at rest relative to the base, and displacements are 0. The base has the
  first recorded velocity there; with displacements or accelerations its velocity is 0.

Inputs (--input TEXT --until S):
  An input in closed form takes the place of the recording, as in `frictiongen time`. All masses start at rest with
  the displacement 0, and the base then moves or jumps.
  --input \"half-sine 10 g for 11 ms\"   --input \"step 5 N on roof from 0.5 s\"

Quantities:
  displacement, velocity  motion of a mass, or relative motion of the contact. If the base moves, the motion of
                  a mass is relative to the base by default (roof-base); `--of roof` gives the absolute motion
  friction        the friction force in N; while the contact sticks, the force that keeps it at rest
  state           stuck, or the direction of sliding
  slip, energy    distance that the slider has travelled, and energy that friction has dissipated since the start
  force           the force in N of a stop, whose state is open or shut
  events          number of stops, break-aways and reversals of all contacts since the previous sample
With the field `contacts`, --friction or the channel `friction` is the common force F, each contact has its share of
F, and --of may name contacts.

The lines above the table, and the JSON, contain the work of the load, the energy that friction and damping
dissipated, and the friction energy of each contact, in J. They also contain the number of steps with more events
than the stepper can follow.

Peaks (--peaks):
  peak, time, end  the value with the largest absolute value, its first instant, and the value at the end
  slip(pads), force(pads)  relative displacement and force of a contact or a stop
  energy(pads)    energy that friction has dissipated in a contact
  roof-base, roof-first  displacements relative to the base, and between two masses that a spring joins
  accel(roof), shear  absolute acceleration of a mass, and base shear
--of may also name other quantities, such as vel(roof-base).

Response spectrum (--spectrum ZETA):
  The spectrum is the largest displacement of a linear oscillator relative to the base within the record,
  as a function of the period of the oscillator. Lines with a mode have the natural periods of the scene.
  Other lines have 60 periods in a decade, from two time steps to the length of the record. The steps must be equal.
  pseudo_velocity, pseudo_acceleration  displacement times omega, and displacement times omega^2

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

/// Text below the options of all commands that read recordings.
pub const RECORDINGS: &str = "\
Recordings:
  A CSV file has a line of names with units, then numbers, separated by commas, semicolons or tabs:
    time_s,base_mm,upper_m_s2
  The units can also be in a second line. base is the motion of the base, and force is the exciting
  force. Other names are masses. Units are m, cm, mm, um, m_s, mm_s, m_s2, cm_s2, mm_s2,
  in_s2, ft_s2, g, Gal, N, mN, kN, s, ms, us.
  Every channel needs a unit. Displacements, velocities and accelerations can be mixed.
  A universal file has a data set 58 for each channel, with the unit as label of its ordinate.
  --channel upper=AI1:mm  the column AI1 is the mass upper, in mm; the command ignores other columns
  --channel upper=3:mm    the third column is the mass upper
  A recording must have one driving frequency. Only `identify --decay` reads a free vibration.
  The command finds the steady interval of the recording. A constant or clipped channel, a drifting
  excitation, uneven time steps and fewer than 8 cycles are errors.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

/// Text below the options of `identify`.
pub const IDENTIFICATIONS: &str = "\
Answers:
  not explained   the residuals are too large for noise alone (probability below 1/1000), so that the
                  description does not fit the rig. The friction force in the answer may be wrong
  determined      the measurement determines the force. The 95 % interval contains one solution, and its
                  width is smaller than the force
  several levels  several friction forces give this response; each has its own interval
  stuck           the contact never slides; the interval begins at the smallest force that keeps the contact stuck
  not determined  the measurement does not determine the force, because the response hardly changes with
                  friction at this frequency, for example at an invariant point
  almost stuck    the amplitudes, without phases, are so small that a unit may be wrong by a factor of 1000

Quantities:
  friction force  F in N, for a scene in kg and N/m
  condition       largest ratio of the relative error of a fitted value to the relative error of the data
  misfit          sum of the squares of residuals over deviations, divided by the degrees of freedom. It
                  is about 1 if the residuals are noise. If it is larger than chance allows, the answer is
                  `not explained`, and the intervals are wider
  amplitude, lag  amplitude and lag of the fundamental component relative to the excitation, measured
                  and computed

";

/// Text below the options of `fit`.
pub const FITS: &str = "\
The sweep must be measured without friction, and the scene must be driven by its base. The command
`frictiongen transmissibility -o sweep.csv` writes a sweep from recordings. With one mass the fit gives
the natural frequency. With two masses it gives the frequency ratio r per Hz, the mass ratio gamma and the
stiffness ratio kappa (equations 6.15 to 6.20 of the thesis). Each further mass adds a mass ratio and a
stiffness ratio. Base motion determines only ratios. The first mass therefore keeps its value.

Recordings of the whole motion (--friction, --vary):
  The fit compares every sample with the motion of the scene from rest under the recorded excitation. The
  recording has the channels of `frictiongen drive`, and displacements or velocities of one or more masses,
  which are absolute. Displacements are relative to the first sample. If the recording has a channel friction,
  leave --friction out.
  The names of --vary are those of `frictiongen optimum --vary`. The values of the description are the first
  guess. Intervals assume that the residuals are random noise.
  derivatives  exact, through all stops, break-aways and reversals. At a motion that grazes an event, the fit
               uses a difference of two motions instead, and the output gives the number of such differences.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

//! Arguments of `frictiongen periodic`, with the text that `--help` prints below its options.

use super::FormatArguments;
use clap::Args;
use std::path::PathBuf;

/// Arguments of `frictiongen periodic`.
#[derive(Debug, Args)]
pub struct PeriodicArguments {
    /// File with the description; standard input if it is -
    #[arg(value_name = "FILE")]
    pub scene: PathBuf,
    /// File with the load over one period, as CSV or as columns of numbers
    #[arg(value_name = "TABLE", conflicts_with_all = ["harmonics"])]
    pub table: Option<PathBuf>,
    /// Load as a sum of harmonics ORDER:AMPLITUDE@DEGREES, instead of a table; amplitudes in N, for base motion in m;
    /// for example 1:100@0,3:20@45
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Frequency of the harmonic of order 1 in Hz; --harmonics needs it
    #[arg(long, value_name = "HZ", allow_hyphen_values = true)]
    pub hz: Option<String>,
    /// Kinetic friction forces F in N: a number, a range a:step:b, or a list with commas
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub friction: String,
    /// Keep each force of the table constant until the next sample, as in a square wave
    #[arg(long)]
    pub hold: bool,
    /// Print only this quantity: a mass, `contact`, a difference of two masses such as `roof-first`, a spring force
    /// `spring(a-b)`, the base shear `shear`; may be given more than once [default: the contact and every mass,
    /// relative to the base if the base moves]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Print the motion over one period instead of the smallest and largest values
    #[arg(long)]
    pub motion: bool,
    /// Column and unit of the load in the table, as base=COLUMN:UNIT or force=COLUMN:UNIT [default: the column base or
    /// force]
    #[arg(long, value_name = "NAME=COLUMN:UNIT")]
    pub channel: Vec<String>,
    /// Sampling rate in Hz (samples per second), for a table without a time column
    #[arg(long, value_name = "HZ", allow_hyphen_values = true)]
    pub rate: Option<String>,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv or .json, with --motion also .svg or .png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Text below the options of `periodic`.
pub const PERIODICS: &str = "\
Load:
  A table has the load at evenly spaced times over one period. The last line repeats the load of the
  first line, one period later:
    time_s,force_N
  The column `force` is the force on the excited mass. The column `base` is the motion of the base, as in
  `drive`. Forces and accelerations change linearly between samples. With --hold a force is constant until
  the next sample. The command interpolates displacements of the base by a periodic cubic spline.
  The load of --harmonics is the sum of AMPLITUDE cos(ORDER omega t - DEGREES). It is a force in N, or a
  displacement of the base in m. The order 0 is a constant.
  The closed forms of `limits`, `response`, `optimum`, `map` and `sensitivity` need a cosine load. For a
  cosine load, `orbit` also gives the steady states. Other periodic loads have no friction ratio beta.

Quantities:
  state       stable: small deviations die out; marginal: the position of the contact depends on the
              earlier motion
  period      number of periods of the load after which the motion from rest repeats, at most 64
  events      number of stops, break-aways and reversals of the contact in a period of the motion
  stuck       fraction of the period in which the contact sticks, with an error of about one step
  multiplier  largest Floquet multiplier of a period; JSON has all multipliers
  load, friction, damping  work of the load, and energies that friction and damping dissipate, in a period, in J
  least, largest  smallest and largest value of each motion in a period: displacements in m,
                  forces in N

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

//! What can be typed.

use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

const GRIDS: &str = "\
Grids:
  A grid is a number, a range a:step:b (b included), or a comma-separated list of those:
  0.9   0.2:0.01:2.5   0,0.5,1:0.1:2,inf
  A grid of decimal numbers has decimal points. A frequency may be 0 and inf; a friction is
  finite. At most 10 million points.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

const UNITS: &str = "\
Units:
  The scene's own: with masses in kg and springs in N/m, forces are in N, lengths in m and
  angular frequencies in rad/s.
  --hz or --omega       adds frequency_Hz (and omega_rad_s) beside r
  --force P or --base Y adds friction_N, gives amplitudes in m and phases in degrees; limits come
                        as friction forces in N beside beta
  r and beta refer to the first mass and the first spring listed: another order of them changes r
  and beta, and no physical answer. In degrees, the phase of a contact a - b of two masses is that
  of b relative to a.

";

const LIMITS: &str = "\
Quantities:
  continuous limit  beta_lim, exact: below both limits the contact slides all the time
  without search    beta_lim with the velocity constraint taken at the reversal alone: not smaller
  per mode          beta_lim with each mode's own maximum of the constraint: not larger
  sliding limit     beta*_lim: at it and beyond it the contact never slides

";

const RESPONSES: &str = "\
Regimes:
  continuous  the contact slides all the time: exact amplitudes, phases and harmonics
  stick-slip  the contact stops and slides in turn: the steady state from rest
  stuck       the contact never slides: amplitude and phase of each mass
  unbounded   on an undamped resonance: the margin says whether the contact slides (negative)
              or is stuck

Answers:
  closed form  exact, of a contact that always or never slides
  orbit        exact, from event to event: as `orbit` gives it, with its stability
  subharmonic  the same, of a stable state that repeats after several cycles
  last 64 cycles  the motion does not settle: what it did last, the amplitude the largest seen
  otherwise    why there is none, in the words of `orbit`; its cells are empty (JSON: null)
  no cycle     at a frequency ratio of 0 or infinity, between the limits

Quantities:
  margin      beta/min(beta_lim, beta*_lim) - 1, negative in the continuous regime
  amplitude   largest displacement of the cycle over P/k1, for base motion over Y; with a load, m
  phase       lag of that maximum behind the excitation's, rad, in (-pi, pi]; with a load, degrees
  X_n         harmonics, x = Re(sum of X_n exp(i n t)): amplitude |X_n| and lag -arg X_n, rad;
              with a load, m and degrees

";

const ORBITS: &str = "\
Regimes:
  as `response` gives them: continuous, stick-slip, stuck, unbounded

States:
  stable     small deviations die
  marginal   some deviation stays, or dies more slowly than any power: one of a continuum of
             steady states, or at its end; also the stuck contact, which stays where it is
  unbounded  none: on an undamped resonance
  undamped   none: nothing damps a mode that the load drives and the contact does not touch
  unstable   none was found that deviations do not leave
  unsettled  none: the motion from rest repeats neither after one cycle nor after up to 64; the values
             are of its last 64 cycles, and the amplitude is the largest in those
  crowded    a cycle has more than 64 segments

Quantities:
  period      after how many cycles of the excitation the motion repeats: 1, or more for a subharmonic state
  stops       how often the contact stops in a period
  reversals   how often it changes its direction without a stop
  stuck       the part of the period for which it sticks
  multiplier  by how much the deviation that dies most slowly is multiplied in a period
  amplitude   largest displacement of the period over P/k1, for base motion over Y; with a load, m
  phase       lag of that maximum behind the excitation's, rad, in (-pi, pi]; with a load, degrees
  X_n         harmonics, x = Re(sum of X_n exp(i n t)): amplitude |X_n| and lag -arg X_n, rad;
              X_0 is the mean; with a load, m and degrees

";

const OPTIMA: &str = "\
What is searched:
  The largest amplitude over the band a:b at one friction, over all regimes: about every resonance,
  of the chain and of the chain with its contact stuck, their sub-harmonics, where the regime
  changes, and on a grid between. The least of it between no friction and so much that the contact
  is stuck over the whole band; infinite where an undamped resonance is not bounded.

Quantities:
  friction     in N with a load, else beta
  what limits it  equal peaks: one rises with friction, another falls; or one peak at its least
  above the best  the friction between which the largest amplitude is within 1, 5 and 10 per cent
  per cent of it  how the optimum moves with each parameter, while friction follows; with a load

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.

";

const SENSITIVITIES: &str = "\
Parameters:
  m, k      each mass and spring
  zeta i    the damping ratio of mode i; a, b of Rayleigh damping
  mu        static over kinetic friction force
  F, P or Y, f  with a load: friction force, load and frequency in Hz. All derivatives are taken at
            constant values of the others, so that the first mass and spring move r and beta
  beta, r   without a load: derivatives are taken at constant r and beta

Answers:
  exact       derivatives of the closed form, of the steady state with stops, or of the stuck response
  bend        none: an event is about to come or to go, or a limit is met
  marginal    none: the steady state is one of a continuum
  degenerate  none: two modes coincide and move apart, or the contact is about to drive a mode
  otherwise   why there is no steady state, in the words of `orbit`

Quantities:
  X, d/dp     on the first line the answer, then its derivative with respect to the parameter
  (p/X) d/dp  by how many per cent X changes for one per cent of p; of a phase p d/dp
  limits      beta_lim and beta*_lim at this frequency; with a load in N

";

const GRIDS_IN_TIME: &str = "\
Grids:
  A grid is a number, a range a:step:b (b included), or a comma-separated list of those:
  0.9   0.2:0.01:2.5   0.5,1:0.1:2
  A grid of decimal numbers has decimal points. A frequency is above 0 and below infinity:
  at 0 a cycle never ends, and at infinity nothing has time to move (`limits` and `response` answer
  at both). A friction is finite. At most 10 million points.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

const CURVES: &str = "\
Curves:
  The range is refined where a curve bends and at its peaks. A piece is what may be joined: it ends
  where the regime changes, at a pole, at a jump, and where there is no answer.
  answer   closed form, orbit, or last 64 cycles of a motion that does not settle; otherwise why
           there is none, in the words of `orbit`
  force    largest friction force of the cycle over P (base motion: k1 Y); with a load, N
  work     that friction takes out of a cycle over P^2/k1 (base motion: k1 Y^2); with a load, the
           mean power in W

";

const RANGES: &str = "\
Ranges:
  A range of frequencies is a:b, above 0; a:step:b also says how far apart points are at most.
  Frictions are a number, a range a:step:b, or a comma-separated list of those.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

const MAPS: &str = "\
Regions:
  continuous        the contact slides all the time
  stuck             it never slides
  n stops           it stops n times in a cycle of the excitation
  sliding reversals its direction changes without a stop, in a motion other than the continuous one
  subharmonic       the motion repeats after several cycles
  unsettled         it does not repeat; otherwise why there is no answer, in the words of `orbit`
A region's boundary with the continuous and the stuck regime is a limit, exactly. --boundaries traces
the others by halving: each digit takes the motion longer to settle. 3 are a picture's.
Ctrl-C keeps the frequencies that are done.

";

const TABLES: &str = "\
What the description declares (accuracy, range, side, budget) holds where no option says otherwise.

Without --format the figures of the tables are printed: accuracy, pieces, bytes, the largest errors
and where, operations. With it, the code or the data:
  rust  a file without dependencies: limits(r), and contact(r, beta) if the scene provides a motion
  c     the same in C99; with -o name.c the header name.h beside it
  json  the tables as data

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

/// Exact solutions of mass-spring chains with one Coulomb friction contact.
#[derive(Debug, Parser)]
#[command(name = "frictiongen", version)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// The limits of continuous motion and of sliding over frequency
    #[command(after_help = format!("{LIMITS}{UNITS}{GRIDS}"))]
    Limits(LimitsArguments),
    /// Regime, amplitudes, phases and harmonics over frequency and friction
    #[command(after_help = format!("{RESPONSES}{UNITS}{GRIDS}"))]
    Response(ResponseArguments),
    /// The steady state from rest over frequency and friction, stops included
    #[command(after_help = format!("{ORBITS}{UNITS}{GRIDS_IN_TIME}"))]
    Orbit(OrbitArguments),
    /// The derivatives of amplitude, phase and limits with respect to every parameter, in any regime
    #[command(after_help = format!("{SENSITIVITIES}{UNITS}{GRIDS_IN_TIME}"))]
    Sensitivity(SensitivityArguments),
    /// The friction that keeps the largest amplitude over a band of frequencies smallest
    #[command(after_help = format!("{OPTIMA}{UNITS}"))]
    Optimum(OptimumArguments),
    /// Responses along frequency in every regime, refined where they bend
    #[command(after_help = format!("{CURVES}{UNITS}{RANGES}"))]
    Curve(CurveArguments),
    /// What the contact does over frequency and friction
    #[command(after_help = format!("{MAPS}{UNITS}{GRIDS}"))]
    Map(MapArguments),
    /// Tables of the limits and of the contact's motion, to a declared accuracy
    #[command(after_help = TABLES)]
    Compile(CompileArguments),
    /// The Rust that the macro emits for a description
    Expand(ExpandArguments),
}

/// Which description.
#[derive(Debug, Args)]
pub struct FileArgument {
    /// The description; standard input if it is - or left out
    pub file: Option<PathBuf>,
}

/// In which format numbers are printed; a table unless one is chosen.
#[derive(Debug, Args)]
#[group(multiple = false)]
pub struct FormatArguments {
    /// Print JSON; infinity is the string "inf"
    #[arg(long)]
    pub json: bool,
    /// Print CSV, every number with all its digits
    #[arg(long)]
    pub csv: bool,
}

/// The frequency of the excitation, in one of three ways.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrequencyArguments {
    /// Frequency ratios r = omega sqrt(m1/k1)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// In place of --r, frequencies in Hz
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub hz: Option<String>,
    /// In place of --r, angular frequencies in rad/s
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub omega: Option<String>,
}

/// The friction, in one of two ways.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrictionArguments {
    /// Friction ratios beta = F/P, for base motion F/(k1 Y)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// In place of --beta, kinetic friction forces F in N; needs --force or --base
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub friction: Option<String>,
}

/// The amplitude of the load, where answers are wanted in N and m.
#[derive(Debug, Args)]
pub struct LoadArguments {
    /// Amplitude P of the force in N, where a force on a mass drives the scene
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Amplitude Y of the base motion in m, where the base drives the scene
    #[arg(long, value_name = "Y", allow_hyphen_values = true)]
    pub base: Option<String>,
}

/// Of `frictiongen limits`.
#[derive(Debug, Args)]
pub struct LimitsArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen response`.
#[derive(Debug, Args)]
pub struct ResponseArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The friction.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Only this mass; may be given more than once [default: every mass]
    #[arg(long, value_name = "NAME")]
    pub mass: Vec<String>,
    /// Also the harmonics X_1, X_3, ... up to this one
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen orbit`.
#[derive(Debug, Args)]
pub struct OrbitArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The friction.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Only this mass; may be given more than once [default: every mass]
    #[arg(long, value_name = "NAME")]
    pub mass: Vec<String>,
    /// Also the harmonics X_0, X_1, ... up to this one
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen curve`.
#[derive(Debug, Args)]
pub struct CurveArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The friction.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Only this mass, or `contact`; may be given more than once [default: all]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// How far a straight line between neighbours may stray, relative to the curve [default: 5e-4]
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub accuracy: Option<String>,
    /// Also the harmonics X_1, X_2, ... up to this one
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Also velocities and accelerations
    #[arg(long)]
    pub rates: bool,
    /// Write to this file; its ending decides: .csv, .json, .svg, .png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// What the colours of a map tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Shade {
    /// What the contact does: regimes, and how often it stops.
    #[default]
    Regime,
    /// The part of the period for which the contact sticks.
    Stuck,
    /// The amplitude of the first motion asked for.
    Amplitude,
}

/// Of `frictiongen map`.
#[derive(Debug, Args)]
pub struct MapArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The friction.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Only the amplitude of this mass, or `contact`; may be given more than once [default: all]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// In place of the points, the boundaries between them, to this many significant digits
    #[arg(long, value_name = "DIGITS", allow_hyphen_values = true)]
    pub boundaries: Option<String>,
    /// What the colours of a picture tell
    #[arg(long, value_enum, default_value_t)]
    pub shade: Shade,
    /// Write to this file; its ending decides: .csv, .json, .svg, .png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen sensitivity`.
#[derive(Debug, Args)]
pub struct SensitivityArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The friction.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Of this mass, or of `contact`
    #[arg(long, value_name = "NAME")]
    pub of: String,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen optimum`.
#[derive(Debug, Args)]
pub struct OptimumArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The band a:b.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// The amplitude of this mass, or of `contact`
    #[arg(long, value_name = "NAME")]
    pub of: String,
    /// Choose a spring `a - b` or the damping `zeta 1` of a mode too; `=from:to` says where
    /// [default: from a quarter to four times its value]
    #[arg(long, value_name = "WHAT", allow_hyphen_values = true)]
    pub vary: Option<String>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// In which form tables are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableFormat {
    /// Rust.
    Rust,
    /// C99.
    C,
    /// Data.
    Json,
}

/// Of `frictiongen compile`.
#[derive(Debug, Args)]
pub struct CompileArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The largest relative error of an answer; of a phase in radians
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub accuracy: Option<String>,
    /// In place of an accuracy, bytes: the best accuracy that fits
    #[arg(
        long,
        value_name = "BYTES",
        allow_hyphen_values = true,
        conflicts_with = "accuracy"
    )]
    pub budget: Option<String>,
    /// Frequency ratios from a to b
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// beta_lim never above, beta*_lim never below the exact one
    #[arg(long)]
    pub safe: bool,
    /// Print code or data instead of the figures
    #[arg(long, value_enum)]
    pub format: Option<TableFormat>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Of `frictiongen expand`.
#[derive(Debug, Args)]
pub struct ExpandArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

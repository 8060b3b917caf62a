//! Arguments of `frictiongen report`.

use super::{FileArgument, FrequencyArguments, FrictionArguments, LoadArguments};
use clap::Args;
use std::path::PathBuf;

pub const REPORTS: &str = "\
The page:
  The page shows a drawing of the scene, its modes, amplitudes and phases at several frictions, the
  regime map with both limits, the best friction, and the cost of the emitted code. It is one file and
  needs no network. A script in the page shows the values at the pointer, or at a point that the arrow keys
  select. A JSON block with a version number contains every number of the page.

Defaults, which the page also states:
  range      from 0.3 times the lowest to 1.5 times the highest resonance
  frictions  0.1, 0.3 and 0.7 times the median of the sliding limit over the range, and the best friction;
             also no friction, and the stuck contact
  motions    the contact and every mass, for up to four masses. For a longer chain: the contact, the masses
             at the contact and at the load, the last mass, and the mass that moves farthest with the
             contact stuck
  best       the friction with the smallest peak of each mass, as `frictiongen optimum` finds it. If the
             chain has more than four masses, the page has it for the two masses that move farthest with
             the contact stuck
With several contacts or dashpots the page shows a drawing, the responses without friction and with all
contacts stuck, amplitudes and stuck fractions at several frictions, the regime map, a hysteresis loop of
each contact, and the contact that slides first. Its default frictions are 0.1, 0.3 and 0.7 times the
median of the friction from which no contact slides. This page has no script.

Without --base or --force, the page uses the non-dimensional groups r and beta.

";

pub const RANGES: &str = "\
Ranges:
  A range of frequencies is a:b, above 0. Frictions are a number, a range a:step:b, or a
  comma-separated list of those, up to 6.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

/// Arguments of `frictiongen report`.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Options for the range of frequencies.
    #[command(flatten)]
    range: RangeArguments,
    /// Options for the frictions.
    #[command(flatten)]
    levels: LevelArguments,
    /// Options for the amplitude of the load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Show only this mass, or `contact`; may be given more than once [default: see `motions` below]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Add the playground, an interactive page with this scene, to the report; the report then has about 2 MB
    #[arg(long)]
    pub live: bool,
    /// File with the playground for --live, an interactive page that scripts/playground creates [default:
    /// playground.html in the folder of this program]
    #[arg(long, value_name = "PAGE", requires = "live")]
    pub page: Option<PathBuf>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Options for an optional range of frequencies, as ratios r, in Hz or in rad/s.
#[derive(Debug, Args)]
#[group(multiple = false)]
struct RangeArguments {
    /// Range of frequency ratios r = omega sqrt(m1/k1), with the first mass m1 and the first spring k1, from a to b
    /// [default: around the resonances]
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    r: Option<String>,
    /// Range of frequencies in Hz, from a to b, instead of --r
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    hz: Option<String>,
    /// Range of angular frequencies omega in rad/s, from a to b, instead of --r
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    omega: Option<String>,
}

/// Options for optional frictions, as ratios β or as forces in N.
#[derive(Debug, Args)]
#[group(multiple = false)]
struct LevelArguments {
    /// Friction ratios: beta = F/P for the force amplitude P, beta = F/(k1 Y) for the base amplitude Y; for example
    /// 0.1,0.3
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    beta: Option<String>,
    /// Kinetic friction forces F in N, instead of --beta; needs --force or --base
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    friction: Option<String>,
}

impl ReportArguments {
    /// Returns the frequency options, if the user gives a range of frequencies.
    pub fn range(&self) -> Option<FrequencyArguments> {
        let RangeArguments { r, hz, omega } = &self.range;
        let given = [r, hz, omega].iter().any(|text| text.is_some());
        given.then(|| FrequencyArguments {
            r: r.clone(),
            hz: hz.clone(),
            omega: omega.clone(),
        })
    }

    /// Returns the friction options, if the user gives frictions.
    pub fn frictions(&self) -> Option<FrictionArguments> {
        let LevelArguments { beta, friction } = &self.levels;
        let given = beta.is_some() || friction.is_some();
        given.then(|| FrictionArguments {
            beta: beta.clone(),
            friction: friction.clone(),
        })
    }
}

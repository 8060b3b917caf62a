//! The quantities that are measured. Emitted scenes and `System` compute them with the same code.

use crate::scenes::Orbit;
use frictiongen::kernel::{Float, Scalar};
use frictiongen::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady};

/// A quantity that a scene computes and whose time is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Method {
    /// Both limits β_lim and β*_lim. A guaranteed search finds the value S of the velocity constraint.
    Limits,
    /// Both limits without search. The formula of β_lim takes the velocity constraint for τ → 0 in place of S.
    WithoutSearch,
    /// Both limits, where S of the velocity constraint is the sum of the maxima of each mode.
    PerMode,
    /// Exact amplitude of a mass in continuous motion.
    Amplitude,
    /// Estimate of a mass's amplitude from its fundamental harmonic.
    Monoharmonic,
    /// Modulus of the fundamental harmonic of a mass's motion.
    Fundamental,
    /// Exact amplitude of the contact in continuous motion.
    Contact,
    /// Amplitude of the contact in a steady state with stops.
    Orbit,
}

impl Method {
    /// Quantities that every emitted scene computes with closed formulas.
    pub const CLOSED: [Self; 6] = [
        Self::Limits,
        Self::WithoutSearch,
        Self::PerMode,
        Self::Amplitude,
        Self::Monoharmonic,
        Self::Fundamental,
    ];

    /// Quantities whose exact value is computed at points of continuous motion.
    pub const JUDGED: [Self; 7] = [
        Self::Limits,
        Self::WithoutSearch,
        Self::PerMode,
        Self::Amplitude,
        Self::Monoharmonic,
        Self::Fundamental,
        Self::Contact,
    ];

    /// Returns the name of the quantity in printed tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Limits => "limits, exact S",
            Self::WithoutSearch => "limits without search",
            Self::PerMode => "limits per mode",
            Self::Amplitude => "amplitude, exact",
            Self::Monoharmonic => "amplitude, monoharmonic",
            Self::Fundamental => "fundamental",
            Self::Contact => "amplitude of the contact",
            Self::Orbit => "steady state with stops",
        }
    }

    /// Returns the quantity that this quantity approximates. An exact quantity returns itself.
    pub fn exact(self) -> Self {
        match self {
            Self::Limits | Self::WithoutSearch | Self::PerMode => Self::Limits,
            Self::Amplitude | Self::Monoharmonic | Self::Fundamental => Self::Amplitude,
            Self::Contact => Self::Contact,
            Self::Orbit => Self::Orbit,
        }
    }
}

/// A point (r, β), or a result. A result has two numbers: both limits, or the same amplitude twice.
pub type Pair<S> = [S; 2];
/// Function that computes a quantity at each of several points. Its result is NaN where the quantity does not exist.
pub type Fill<S> = Box<dyn Fn(Method, &[Pair<S>], &mut [Pair<S>])>;

/// Creates the function that computes the quantities of a system. `watched` is the index of the observed mass.
pub fn filler<F>(system: F, watched: usize, orbit: Orbit<F::Scalar>) -> Fill<F::Scalar>
where
    F: FrictionSystem + 'static,
    for<'a> F::At<'a>: MotionAt<Scalar = F::Scalar>,
{
    let mass = Of::Mass(watched);
    Box::new(move |method, points, out| match method {
        Method::Limits => limits(&system, points, out, |at| at.continuous_limit()),
        Method::WithoutSearch => each(points, out, |[r, _]| {
            let limits = system.limits_without_search(r).ok()?;
            Some([limits.continuous, limits.sliding])
        }),
        Method::PerMode => limits(&system, points, out, |at| at.continuous_limit_per_mode()),
        Method::Amplitude => response(&system, mass, points, out, |motion| motion.amplitude()),
        Method::Monoharmonic => {
            response(&system, mass, points, out, |motion| {
                motion.amplitude_monoharmonic()
            });
        }
        Method::Fundamental => response(&system, mass, points, out, |motion| {
            let first = motion.harmonic(1);
            (first.re * first.re + first.im * first.im).sqrt()
        }),
        Method::Contact => {
            response(&system, Of::Contact, points, out, |motion| {
                motion.amplitude()
            });
        }
        Method::Orbit => each(points, out, |[r, beta]| {
            let amplitude = orbit.and_then(|orbit| orbit(r, beta))?;
            Some([amplitude, amplitude])
        }),
    })
}

/// Computes a result at each point and writes it to the output. Without a result it writes NaN.
pub fn each<S: Float>(
    points: &[Pair<S>],
    out: &mut [Pair<S>],
    f: impl Fn(Pair<S>) -> Option<Pair<S>>,
) {
    for (point, out) in points.iter().zip(out) {
        *out = f(*point).unwrap_or([S::constant(f64::NAN); 2]);
    }
}

/// Computes both limits of a system at each point.
pub fn limits<F>(
    system: &F,
    points: &[Pair<F::Scalar>],
    out: &mut [Pair<F::Scalar>],
    continuous: impl Fn(&F::At<'_>) -> F::Scalar,
) where
    F: FrictionSystem,
{
    each(points, out, |[r, _]| {
        let at = system.at(r).ok()?;
        Some([continuous(&at), at.sliding_limit()])
    });
}

fn response<F>(
    system: &F,
    of: Of,
    points: &[Pair<F::Scalar>],
    out: &mut [Pair<F::Scalar>],
    question: impl Fn(&dyn Steady<Scalar = F::Scalar>) -> F::Scalar,
) where
    F: FrictionSystem,
    for<'a> F::At<'a>: MotionAt<Scalar = F::Scalar>,
{
    each(points, out, |[r, beta]| {
        let motion = system.at(r).ok()?.motion(beta).ok()?;
        let answer = motion.ask(of, |steady| question(steady))?;
        Some([answer, answer])
    });
}

//! Quantities that are measured. Emitted and run-time systems compute them in the same way.

use crate::scenes::Orbit;
use crate::without_search;
use frictiongen::kernel::{Float, Scalar};
use frictiongen::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady};

/// A quantity that a scene computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Method {
    /// Both limits β_lim and β*_lim. S of the velocity constraint comes from the guaranteed search.
    Limits,
    /// Both limits, where S is the velocity constraint for τ → 0.
    WithoutSearch,
    /// Both limits, where S is the sum of the maxima of each mode.
    PerMode,
    /// Exact maximum of a mass's motion.
    Amplitude,
    /// Monoharmonic estimate of a mass's amplitude.
    Monoharmonic,
    /// Modulus of the fundamental of a mass's motion.
    Fundamental,
    /// Amplitude of the continuous motion in the contact.
    Contact,
    /// Amplitude of the contact in a steady state with stops.
    Orbit,
}

impl Method {
    /// Quantities that every emitted scene computes.
    pub const CLOSED: [Self; 6] = [
        Self::Limits,
        Self::WithoutSearch,
        Self::PerMode,
        Self::Amplitude,
        Self::Monoharmonic,
        Self::Fundamental,
    ];

    /// Quantities for which the exact value is computed at continuous points.
    pub const JUDGED: [Self; 7] = [
        Self::Limits,
        Self::WithoutSearch,
        Self::PerMode,
        Self::Amplitude,
        Self::Monoharmonic,
        Self::Fundamental,
        Self::Contact,
    ];

    /// Returns the name of the quantity in the tables.
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

    /// Returns the quantity with the exact value that this quantity approximates.
    pub fn exact(self) -> Self {
        match self {
            Self::Limits | Self::WithoutSearch | Self::PerMode => Self::Limits,
            Self::Amplitude | Self::Monoharmonic | Self::Fundamental => Self::Amplitude,
            Self::Contact => Self::Contact,
            Self::Orbit => Self::Orbit,
        }
    }
}

/// A point (r, β), or the two numbers of a result. A result is both limits, or the amplitude twice.
pub type Pair<S> = [S; 2];
/// Function that computes a quantity at every point. It gives NaN where there is no result.
pub type Fill<S> = Box<dyn Fn(Method, &[Pair<S>], &mut [Pair<S>])>;

/// Creates the function that computes the quantities of a system, emitted or not.
pub fn filler<F>(system: F, watched: usize, orbit: Orbit<F::Scalar>) -> Fill<F::Scalar>
where
    F: FrictionSystem + 'static,
    for<'a> F::At<'a>: MotionAt<Scalar = F::Scalar>,
{
    let mass = Of::Mass(watched);
    Box::new(move |method, points, out| match method {
        Method::Limits => limits(&system, points, out, |at| at.continuous_limit()),
        Method::WithoutSearch => {
            each(points, out, |[r, _]| without_search::limits(&system, r));
        }
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

/// Computes one result at each point, and writes it to the output.
pub fn each<S: Float>(
    points: &[Pair<S>],
    out: &mut [Pair<S>],
    f: impl Fn(Pair<S>) -> Option<Pair<S>>,
) {
    for (point, out) in points.iter().zip(out) {
        *out = f(*point).unwrap_or([S::constant(f64::NAN); 2]);
    }
}

/// Computes both limits at each point.
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

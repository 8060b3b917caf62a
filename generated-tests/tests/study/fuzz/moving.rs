//! Calls the functions of a simulation, and of a steady state with stops, and checks that their results are numbers.

use crate::fuzz::functions::{is_number, promise};
use frictiongen::kernel::Float;
use frictiongen::kernel::motion::ContactChain;
use frictiongen::kernel::number::complex::Complex;
use frictiongen::kernel::orbit::{Orbit, OrbitMotion};
use frictiongen::kernel::simulation::{Part, Simulation};

/// Number of segments of a run that the test checks.
const SEGMENTS: usize = 24;

fn number<S: Float>(value: S, what: &str) -> Result<(), String> {
    promise(is_number(value), || format!("{what} is NaN"))
}

/// Checks that a run advances in segments of non-negative length, and that its state has numbers.
pub fn run<S, P>(run: &mut Simulation<'_, S, P>, masses: usize) -> Result<(), String>
where
    S: Float,
    P: AsMut<[Part<S>]> + AsRef<[Part<S>]>,
{
    for _ in 0..SEGMENTS {
        let segment = run.next().ok_or("a run never ends")?;
        let (zero, length) = (S::constant(0.0), segment.length);
        promise(zero <= length, || format!("a segment of {length:?}"))?;
        number(segment.start, "the start of a segment")?;
        number(run.phase(), "the phase")?;
        number(run.friction(), "the friction")?;
        let (z, velocity) = run.relative();
        number(z, "the relative displacement")?;
        number(velocity, "the relative velocity")?;
        for mass in 0..masses {
            let moment = run.mass(mass);
            number(moment.displacement(), "a displacement")?;
            number(moment.velocity(), "a velocity")?;
        }
    }
    Ok(())
}

/// Checks that a steady state returns numbers.
pub fn orbit<S, P, V, C, K>(
    orbit: &Orbit<'_, S, P, V, C, K>,
    masses: usize,
    tau: S,
    order: u32,
) -> Result<(), String>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    let (zero, stuck) = (S::constant(0.0), orbit.stuck_fraction());
    let most = S::constant(1.0 + 1e-3);
    promise(zero <= stuck && stuck <= most, || {
        format!("stuck for {stuck:?} of a cycle")
    })?;
    number(orbit.origin(), "the origin")?;
    for multiplier in orbit.multipliers() {
        number(multiplier.re, "a multiplier")?;
        number(multiplier.im, "a multiplier")?;
    }
    moves(&orbit.contact(), tau, order).map_err(|problem| format!("contact: {problem}"))?;
    for mass in 0..masses {
        moves(&orbit.mass(mass), tau, order)
            .map_err(|problem| format!("mass {mass}: {problem}"))?;
    }
    Ok(())
}

fn moves<S, P, V, C, K>(
    motion: &OrbitMotion<'_, '_, S, P, V, C, K>,
    tau: S,
    order: u32,
) -> Result<(), String>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    let (amplitude, phase) = (motion.amplitude(), motion.phase());
    promise(S::constant(0.0) <= amplitude, || {
        format!("amplitude {amplitude:?}")
    })?;
    promise(-S::pi() <= phase && phase <= S::pi(), || {
        format!("phase {phase:?}")
    })?;
    if tau.is_finite() {
        number(motion.displacement(tau), "the displacement")?;
        number(motion.velocity(tau), "the velocity")?;
    }
    let harmonic = motion.harmonic(order);
    number(harmonic.re, "a harmonic")?;
    number(harmonic.im, "a harmonic")
}

//! Computes the steady state at one frequency ratio and one friction ratio.

use crate::asked::{self, Mass};
use frictiongen::study::{SystemAt, SystemOrbit, SystemOrbitMotion};
use frictiongen::{Complex, NoOrbit, OutOfDomain};

/// The steady state at one frequency ratio and one friction ratio.
#[derive(Debug)]
pub struct Point {
    /// r.
    pub r: f64,
    /// β.
    pub beta: f64,
    /// Continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// Stable, marginal, unsettled, or why there is none.
    pub state: &'static str,
    /// What there is.
    pub orbit: Option<Steady>,
}

/// A steady state, or the last cycles of a motion that does not settle.
#[derive(Debug)]
pub struct Steady {
    /// What repeats, if anything does.
    pub period: Option<Period>,
    /// The part of the period for which it sticks.
    pub stuck_fraction: f64,
    /// When it sticks: start and length in τ.
    pub sticking: Vec<(f64, f64)>,
    /// Floquet multipliers.
    pub multipliers: Vec<Complex<f64>>,
    /// The contact and the masses asked for, in their order.
    pub movements: Vec<Movement>,
}

/// How a motion repeats.
#[derive(Debug)]
pub struct Period {
    /// After how many cycles.
    pub cycles: usize,
    /// Whether half a period repeats with the opposite sign.
    pub symmetric: bool,
    /// How often the contact stops in a period.
    pub stops: usize,
    /// How often it reverses without a stop.
    pub reversals: usize,
}

/// How the contact or a mass moves.
#[derive(Clone, Debug)]
pub struct Movement {
    /// Largest displacement.
    pub amplitude: f64,
    /// Its lag.
    pub phase: f64,
    /// The harmonics asked for, in ascending order.
    pub harmonics: Vec<Complex<f64>>,
}

impl Movement {
    fn of(motion: &SystemOrbitMotion<'_, '_>, orders: &[u32]) -> Self {
        let (amplitude, phase) = motion.largest();
        Self {
            amplitude,
            phase,
            harmonics: orders.iter().map(|order| motion.harmonic(*order)).collect(),
        }
    }
}

impl Steady {
    fn of(orbit: &SystemOrbit<'_>, masses: &[Mass], orders: &[u32]) -> Self {
        let contact = std::iter::once(orbit.contact());
        let masses = masses.iter().filter_map(|mass| orbit.mass_at(mass.index));
        Self {
            period: orbit.is_settled().then(|| Period {
                cycles: orbit.period() as usize,
                symmetric: orbit.is_symmetric(),
                stops: orbit.stops(),
                reversals: orbit.reversals(),
            }),
            stuck_fraction: orbit.stuck_fraction(),
            sticking: orbit.sticking_intervals().collect(),
            multipliers: orbit.multipliers().to_vec(),
            movements: contact
                .chain(masses)
                .map(|motion| Movement::of(&motion, orders))
                .collect(),
        }
    }

    /// The largest modulus of a multiplier, if there are any.
    pub fn largest_multiplier(&self) -> Option<f64> {
        let moduli = self
            .multipliers
            .iter()
            .map(|value| value.re.hypot(value.im));
        moduli.reduce(f64::max)
    }
}

/// Computes a point.
pub fn answer(
    at: &SystemAt<'_>,
    (r, beta): (f64, f64),
    masses: &[Mass],
    orders: &[u32],
) -> Result<Point, OutOfDomain> {
    let regime = asked::regime(at, &at.motion(beta))?;
    let (state, orbit) = match at.orbit_or_last_cycles(beta) {
        Ok(orbit) => {
            let state = match (orbit.is_marginal(), orbit.is_stable()) {
                _ if !orbit.is_settled() => asked::reason(NoOrbit::Unsettled),
                (true, _) => "marginal",
                (false, true) => "stable",
                (false, false) => "unstable",
            };
            (state, Some(Steady::of(&orbit, masses, orders)))
        }
        Err(NoOrbit::OutOfDomain(error)) => return Err(error),
        Err(error) => (asked::reason(error), None),
    };
    Ok(Point {
        r,
        beta,
        regime,
        state,
        orbit,
    })
}

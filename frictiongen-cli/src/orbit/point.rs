//! Computes the steady state at one frequency ratio and one friction ratio.

use crate::asked::Mass;
use crate::frequency::Frequency;
use crate::friction::Friction;
use frictiongen::study::units::{fundamental_phase, reversed_phase};
use frictiongen::study::{SystemAt, SystemOrbit, SystemOrbitMotion, words};
use frictiongen::{Complex, Given, NoOrbit, NotContinuous, OutOfDomain, Regime};

/// The steady state at one frequency ratio and one friction ratio.
#[derive(Debug)]
pub struct Point {
    /// The frequency.
    pub frequency: Frequency,
    /// The friction.
    pub friction: Friction,
    /// Regime of the contact: continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// Stable, marginal or unsettled, or the reason why there is no steady state.
    pub state: &'static str,
    /// The steady state, if there is one.
    pub orbit: Option<Steady>,
}

/// A steady state, or the last cycles of a motion that does not settle.
#[derive(Debug)]
pub struct Steady {
    /// Data of the periodic motion, if the motion repeats.
    pub period: Option<Period>,
    /// True if motion from rest reaches this state.
    pub from_rest: bool,
    /// True if this state is a member of a continuum of steady states.
    pub marginal: bool,
    /// Mean of the contact's largest and smallest displacement, over P/k₁, for base motion over Y.
    pub offset: f64,
    /// Fraction of the period during which the contact sticks.
    pub stuck_fraction: f64,
    /// Stops of the contact: start and length in τ.
    pub sticking: Vec<(f64, f64)>,
    /// Floquet multipliers.
    pub multipliers: Vec<Complex<f64>>,
    /// Movements of the contact and of the requested masses, in their order.
    pub movements: Vec<Movement>,
}

/// Data of a periodic motion.
#[derive(Debug)]
pub struct Period {
    /// Number of excitation cycles in the period.
    pub cycles: usize,
    /// True if the second half of the period is the first with the opposite sign.
    pub symmetric: bool,
    /// Number of stops of the contact in a period.
    pub stops: usize,
    /// Number of reversals without a stop in a period.
    pub reversals: usize,
}

/// Movement of the contact or of a mass.
#[derive(Clone, Debug)]
pub struct Movement {
    /// Largest displacement.
    pub amplitude: f64,
    /// Lag of the largest displacement behind the maximum of the excitation.
    pub phase: f64,
    /// Half the distance between the smallest and the largest displacement.
    pub centred: f64,
    /// Lag of the fundamental component; `None` for a part that does not move.
    pub fundamental_phase: Option<f64>,
    /// The requested harmonics, in ascending order.
    pub harmonics: Vec<Complex<f64>>,
}

impl Movement {
    fn of(motion: &SystemOrbitMotion<'_, '_>, orders: &[u32]) -> Self {
        let (amplitude, phase) = motion.largest();
        let centred = motion.centred_amplitude();
        Self {
            amplitude,
            phase,
            centred,
            fundamental_phase: fundamental_phase(motion.harmonic(1), centred),
            harmonics: orders.iter().map(|order| motion.harmonic(*order)).collect(),
        }
    }

    /// Reverses the sign of the movement, which then has this phase.
    fn turn(&mut self, phase: f64) {
        self.phase = phase;
        self.fundamental_phase = self.fundamental_phase.map(reversed_phase);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(0.0 - harmonic.re, 0.0 - harmonic.im);
        }
    }
}

impl Steady {
    fn of(orbit: &SystemOrbit<'_>, question: &Question<'_>) -> Self {
        let mut contact = Movement::of(&orbit.contact(), question.orders);
        if question.turn_contact {
            contact.turn(orbit.reversed_contact_phase());
        }
        let masses = question.masses.iter();
        let masses = masses.filter_map(|mass| orbit.mass_at(mass.index));
        let masses = masses.map(|motion| Movement::of(&motion, question.orders));
        Self {
            period: orbit.is_settled().then(|| Period {
                cycles: orbit.period() as usize,
                symmetric: orbit.is_symmetric(),
                stops: orbit.stops(),
                reversals: orbit.reversals(),
            }),
            from_rest: orbit.is_from_rest(),
            marginal: orbit.is_marginal(),
            offset: match question.turn_contact {
                true => 0.0 - orbit.offset(),
                false => orbit.offset(),
            },
            stuck_fraction: orbit.stuck_fraction(),
            sticking: orbit.sticking_intervals().collect(),
            multipliers: orbit.multipliers().to_vec(),
            movements: std::iter::once(contact).chain(masses).collect(),
        }
    }

    /// Returns the length of the longest stop of the contact, in τ, if it stops.
    pub fn longest_stop(&self) -> Option<f64> {
        let lengths = self.sticking.iter().map(|(_, length)| *length);
        lengths.reduce(f64::max)
    }

    /// Returns the largest modulus of a Floquet multiplier, if there are any.
    pub fn largest_multiplier(&self) -> Option<f64> {
        let moduli = self
            .multipliers
            .iter()
            .map(|value| value.re.hypot(value.im));
        moduli.reduce(f64::max)
    }
}

/// The question at every point.
pub struct Question<'a> {
    /// The masses to answer for.
    pub masses: &'a [Mass],
    /// The orders of the harmonics.
    pub orders: &'a [u32],
    /// True if the sign of the contact's motion is reversed.
    pub turn_contact: bool,
}

/// Computes a point.
pub fn answer(
    at: &SystemAt<'_>,
    (frequency, friction): (Frequency, Friction),
    question: &Question<'_>,
) -> Result<Point, OutOfDomain> {
    let beta = friction.beta;
    match at.orbit_or_last_cycles(beta) {
        Ok(orbit) => {
            let mut point = found(at, (frequency, friction), &orbit, question);
            // Where the motion does not settle, `response` answers with another state, whose regime is written here.
            if !orbit.is_settled()
                && let Ok(response) = at.response(beta)
            {
                point.regime = words::regime(response.regime());
            }
            Ok(point)
        }
        Err(NoOrbit::OutOfDomain(error)) => Err(error),
        Err(error) => none(at, (frequency, friction), error),
    }
}

/// Computes every steady state at a point that can be found. If there is none, it returns one point with the reason.
pub fn states(
    at: &SystemAt<'_>,
    (frequency, friction): (Frequency, Friction),
    question: &Question<'_>,
) -> Result<Vec<Point>, OutOfDomain> {
    let states = at.states(friction.beta)?;
    let points = states.map(|orbit| found(at, (frequency, friction), &orbit, question));
    let points: Vec<Point> = points.collect();
    if points.is_empty() {
        return Ok(vec![answer(at, (frequency, friction), question)?]);
    }
    Ok(points)
}

fn found(
    at: &SystemAt<'_>,
    (frequency, friction): (Frequency, Friction),
    orbit: &SystemOrbit<'_>,
    question: &Question<'_>,
) -> Point {
    Point {
        frequency,
        friction,
        regime: words::regime(at.regime_of(orbit)),
        state: words::state(orbit),
        orbit: Some(Steady::of(orbit, question)),
    }
}

fn none(
    at: &SystemAt<'_>,
    (frequency, friction): (Frequency, Friction),
    reason: NoOrbit,
) -> Result<Point, OutOfDomain> {
    Ok(Point {
        frequency,
        friction,
        regime: regime(at, friction.beta)?,
        state: words::reason(reason),
        orbit: None,
    })
}

/// Returns the regime in a word, where there is no steady state.
fn regime(at: &SystemAt<'_>, beta: f64) -> Result<&'static str, OutOfDomain> {
    Ok(match at.motion(beta) {
        Ok(_) => words::regime(Regime::Continuous),
        Err(NotContinuous::StickSlip) => words::regime(Regime::StickSlip),
        Err(NotContinuous::Stuck) if at.stuck().is_ok() => words::regime(Regime::Stuck),
        // This is an undamped resonance of the chain, or of the chain with its contact stuck.
        Err(NotContinuous::Stuck | NotContinuous::Unbounded) => "unbounded",
        Err(_) => return Err(OutOfDomain::FrictionRatio(Given::of(beta))),
    })
}

//! Computes the steady state at one frequency ratio and one friction ratio.

use crate::asked::Mass;
use crate::frequency::Frequency;
use crate::friction::Friction;
use frictiongen::study::units::{fundamental_phase, reversed_phase};
use frictiongen::study::{SystemAt, SystemMotion, SystemOrbit, SystemOrbitMotion, words};
use frictiongen::{Complex, NoOrbit, NotContinuous, OutOfDomain, Regime};

/// The steady state at one frequency ratio and one friction ratio.
#[derive(Debug)]
pub struct Point {
    /// At which frequency.
    pub frequency: Frequency,
    /// At which friction.
    pub friction: Friction,
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
    /// Whether motion from rest ends in it.
    pub from_rest: bool,
    /// Whether it is one of a continuum.
    pub marginal: bool,
    /// The middle of the contact's motion, over P/k₁, for base motion over Y.
    pub offset: f64,
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
    /// The amplitude about the motion's own middle.
    pub centred: f64,
    /// The lag of the fundamental component; none for what does not move.
    pub fundamental_phase: Option<f64>,
    /// The harmonics asked for, in ascending order.
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

    /// The same with the opposite sign, where it has this phase.
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

    /// How long the contact sticks at most without a break, in τ, if it sticks.
    pub fn longest_stop(&self) -> Option<f64> {
        let lengths = self.sticking.iter().map(|(_, length)| *length);
        lengths.reduce(f64::max)
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

/// What is asked at every point.
pub struct Question<'a> {
    /// Of which masses.
    pub masses: &'a [Mass],
    /// Which harmonics.
    pub orders: &'a [u32],
    /// Whether the contact's motion is asked for with the opposite sign.
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
            // Where motion does not settle, `response` answers with another state: this is that state's regime.
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

/// Computes every steady state at a point that is found; one point that says why where there is none.
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
        regime: regime(at, &at.motion(friction.beta))?,
        state: words::reason(reason),
        orbit: None,
    })
}

/// The regime in a word, where there is no steady state.
fn regime(
    at: &SystemAt<'_>,
    motion: &Result<SystemMotion<'_>, NotContinuous>,
) -> Result<&'static str, OutOfDomain> {
    Ok(match motion {
        Ok(_) => words::regime(Regime::Continuous),
        Err(NotContinuous::StickSlip) => words::regime(Regime::StickSlip),
        Err(NotContinuous::Stuck) if at.stuck().is_ok() => words::regime(Regime::Stuck),
        // On an undamped resonance, of the chain or of the chain with its contact stuck.
        Err(NotContinuous::Stuck | NotContinuous::Unbounded) => "unbounded",
        Err(_) => return Err(OutOfDomain { argument: "beta" }),
    })
}

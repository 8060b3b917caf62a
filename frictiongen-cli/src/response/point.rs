//! Computes the response at one frequency ratio and one friction ratio.

use crate::asked::{self, Mass};
use crate::failure::Failure;
use crate::frequency::Frequency;
use crate::friction::{Friction, Frictions};
use crate::output::Visitor;
use frictiongen::study::units::{polar, reversed_phase};
use frictiongen::study::{SystemAt, SystemMotion, SystemOrbitMotion, SystemSteady, words};
use frictiongen::{Complex, Limits, NotContinuous, OutOfDomain};

/// The response at one frequency ratio and one friction ratio.
#[derive(Debug)]
pub struct Point {
    /// At which frequency.
    pub frequency: Frequency,
    /// At which friction.
    pub friction: Friction,
    /// Continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// β/min(β_lim, β*_lim) − 1.
    pub margin: f64,
    /// Where the motion comes from, or why there is none.
    pub answer: &'static str,
    /// The relative motion in the contact.
    pub contact: Movement,
    /// The motion of the masses asked for, in their order.
    pub masses: Vec<Movement>,
}

/// How the contact or a mass moves; nothing where that is not known.
#[derive(Clone, Debug, Default)]
pub struct Movement {
    /// Largest displacement, and its lag.
    pub swing: Option<(f64, f64)>,
    /// The monoharmonic estimate of the amplitude.
    pub monoharmonic: Option<f64>,
    /// The harmonics asked for, in ascending order.
    pub harmonics: Vec<Complex<f64>>,
}

impl Movement {
    fn continuous(motion: &SystemSteady, orders: &[u32]) -> Self {
        let largest = motion.largest();
        Self {
            swing: Some((largest.amplitude, largest.phase)),
            monoharmonic: Some(motion.amplitude_monoharmonic()),
            harmonics: orders.iter().map(|order| motion.harmonic(*order)).collect(),
        }
    }

    fn orbit(motion: &SystemOrbitMotion<'_, '_>, orders: &[u32]) -> Self {
        Self {
            swing: Some(motion.largest()),
            monoharmonic: None,
            harmonics: orders.iter().map(|order| motion.harmonic(*order)).collect(),
        }
    }

    /// The same with the opposite sign, where it has this phase.
    fn turn(&mut self, phase: f64) {
        self.swing = self.swing.map(|(size, _)| (size, phase));
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(0.0 - harmonic.re, 0.0 - harmonic.im);
        }
    }

    /// What is left where nothing has time to move: the formulas are evaluated at a finite r.
    fn at_infinity(&mut self) {
        let settled = |value: f64| if value.abs() < 1e-100 { 0.0 } else { value };
        self.swing = self.swing.map(|(size, phase)| (settled(size), phase));
        self.monoharmonic = self.monoharmonic.map(settled);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(settled(harmonic.re), settled(harmonic.im));
        }
    }

    fn stuck(amplitude: Complex<f64>) -> Self {
        Self {
            swing: Some(polar(amplitude)),
            ..Self::default()
        }
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

impl Question<'_> {
    /// Computes the points at one frequency ratio, until the visitor fails.
    pub fn answers(
        &self,
        at: &SystemAt<'_>,
        frequency: Frequency,
        frictions: &Frictions,
        visit: Visitor<'_, Point>,
    ) -> Result<(), Failure> {
        // One search for all β.
        let limits = at.limits();
        for friction in frictions.iter() {
            let point = self.answer(at, &limits, frequency, friction);
            visit(&point.map_err(Failure::new)?)?;
        }
        Ok(())
    }

    fn answer(
        &self,
        at: &SystemAt<'_>,
        limits: &Limits<f64>,
        frequency: Frequency,
        friction: Friction,
    ) -> Result<Point, OutOfDomain> {
        let beta = friction.beta;
        let mut point = Point {
            frequency,
            friction,
            regime: "",
            margin: limits.margin(beta)?,
            answer: "closed form",
            contact: Movement::default(),
            masses: vec![Movement::default(); self.masses.len()],
        };
        let motion = at.motion(beta);
        point.regime = asked::regime(at, &motion)?;
        match motion {
            Ok(motion) => {
                point.contact = Movement::continuous(&motion.contact(), self.orders);
                if let (true, Some((_, phase))) = (self.turn_contact, point.contact.swing) {
                    point.contact.turn(reversed_phase(phase));
                }
                point.masses = self.each(|mass| self.mass(&motion, mass));
            }
            Err(NotContinuous::Stuck) => match at.stuck() {
                Ok(stuck) => {
                    point.masses =
                        self.each(|mass| stuck.mass(&mass.name).ok().map(Movement::stuck));
                }
                Err(_) => point.answer = "unbounded",
            },
            Err(NotContinuous::StickSlip) => self.orbit(at, &mut point),
            Err(NotContinuous::Unbounded) => point.answer = "unbounded",
            Err(_) => return Err(OutOfDomain { argument: "beta" }),
        }
        if frequency.r.is_infinite() {
            point.contact.at_infinity();
            point.masses.iter_mut().for_each(Movement::at_infinity);
        }
        Ok(point)
    }

    fn orbit(&self, at: &SystemAt<'_>, point: &mut Point) {
        match at.orbit_or_last_cycles(point.friction.beta) {
            Ok(orbit) => {
                point.answer = words::found(&orbit);
                point.contact = Movement::orbit(&orbit.contact(), self.orders);
                if self.turn_contact {
                    point.contact.turn(orbit.reversed_contact_phase());
                }
                point.masses = self.each(|mass| {
                    let motion = orbit.mass_at(mass.index)?;
                    Some(Movement::orbit(&motion, self.orders))
                });
            }
            Err(error) => point.answer = words::reason(error),
        }
    }

    fn each(&self, movement: impl Fn(&Mass) -> Option<Movement>) -> Vec<Movement> {
        let masses = self.masses.iter();
        masses
            .map(|mass| movement(mass).unwrap_or_default())
            .collect()
    }

    fn mass(&self, motion: &SystemMotion<'_>, mass: &Mass) -> Option<Movement> {
        let motion = motion.mass_at(mass.index)?;
        Some(Movement::continuous(&motion, self.orders))
    }
}

//! Computes the response at one frequency ratio and one friction ratio.

use crate::asked::Mass;
use crate::failure::Failure;
use crate::frequency::Frequency;
use crate::friction::{Friction, Frictions};
use crate::output::Visitor;
use frictiongen::study::units::reversed_phase;
use frictiongen::study::{Swing, SystemAt, SystemResponse, words};
use frictiongen::{Complex, Limits, Of, OutOfDomain, Regime};

/// The response at one frequency ratio and one friction ratio.
#[derive(Debug)]
pub struct Point {
    /// The frequency.
    pub frequency: Frequency,
    /// The friction.
    pub friction: Friction,
    /// Regime of the contact: continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// Margin β/min(β_lim, β*_lim) − 1.
    pub margin: f64,
    /// Method that computed the motion, or the reason why there is none.
    pub answer: &'static str,
    /// Mean of the contact's largest and smallest displacement, over P/k₁, for base motion over Y.
    pub offset: Option<f64>,
    /// True if the state is a member of a continuum of steady states.
    pub marginal: Option<bool>,
    /// True if motion from rest reaches the state.
    pub from_rest: Option<bool>,
    /// The relative motion in the contact.
    pub contact: Movement,
    /// Motions of the requested masses, in their order.
    pub masses: Vec<Movement>,
}

/// Movement of the contact or of a mass. Unknown quantities are `None`.
#[derive(Clone, Debug, Default)]
pub struct Movement {
    /// Largest displacement, and its lag behind the maximum of the excitation.
    pub swing: Option<Swing>,
    /// Half the distance between the smallest and the largest displacement.
    pub centred: Option<f64>,
    /// Lag of the fundamental component.
    pub fundamental_phase: Option<f64>,
    /// The monoharmonic estimate of the amplitude.
    pub monoharmonic: Option<f64>,
    /// The requested harmonics, in ascending order.
    pub harmonics: Vec<Complex<f64>>,
}

impl Movement {
    /// Reverses the sign of the movement, which then has this phase.
    fn turn(&mut self, phase: Option<f64>) {
        if let Some(swing) = &mut self.swing {
            swing.phase = phase;
        }
        self.fundamental_phase = self.fundamental_phase.map(reversed_phase);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(0.0 - harmonic.re, 0.0 - harmonic.im);
        }
    }

    /// Sets displacements that vanish at r = ∞ to zero. The formulas are evaluated at a large, finite r.
    fn at_infinity(&mut self) {
        let settled = |value: f64| if value.abs() < 1e-100 { 0.0 } else { value };
        if let Some(swing) = &mut self.swing {
            swing.amplitude = settled(swing.amplitude);
        }
        self.centred = self.centred.map(settled);
        self.monoharmonic = self.monoharmonic.map(settled);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(settled(harmonic.re), settled(harmonic.im));
        }
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

impl Question<'_> {
    /// Computes the points at one frequency ratio until the visitor fails.
    pub fn answers(
        &self,
        at: &SystemAt<'_>,
        frequency: Frequency,
        frictions: &Frictions,
        visit: Visitor<'_, Point>,
    ) -> Result<(), Failure> {
        // One search for the limits serves all β.
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
        let margin = limits.margin(friction.beta)?;
        let mut point = Point {
            frequency,
            friction,
            regime: "",
            margin,
            answer: "",
            offset: None,
            marginal: None,
            from_rest: None,
            contact: Movement::default(),
            masses: vec![Movement::default(); self.masses.len()],
        };
        match at.response(friction.beta) {
            Ok(response) => {
                point.regime = words::regime(response.regime());
                point.answer = words::answer(&response);
                let sign = if self.turn_contact { -1.0 } else { 1.0 };
                point.offset = Some(sign * response.offset());
                point.marginal = Some(response.is_marginal());
                point.from_rest = Some(response.is_from_rest());
                point.contact = self.contact(&response);
                let masses = self.masses.iter();
                let moving = |mass: &Mass| self.movement(&response, Of::Mass(mass.index));
                point.masses = masses.map(moving).collect();
            }
            Err(error) => {
                point.regime = words::regime_without(error);
                point.answer = words::no_answer(error);
            }
        }
        if frequency.r.is_infinite() {
            point.contact.at_infinity();
            point.masses.iter_mut().for_each(Movement::at_infinity);
        }
        Ok(point)
    }

    /// Returns the movement of the contact, which is empty if the contact never slides.
    fn contact(&self, response: &SystemResponse<'_>) -> Movement {
        if response.regime() == Regime::Stuck {
            return Movement::default();
        }
        let mut contact = self.movement(response, Of::Contact);
        if self.turn_contact {
            contact.turn(response.reversed_contact_phase());
        }
        contact
    }

    fn movement(&self, response: &SystemResponse<'_>, of: Of) -> Movement {
        let orders = self.orders.iter();
        Movement {
            swing: response.swing(of),
            centred: response.centred_amplitude(of),
            fundamental_phase: response.fundamental_phase(of),
            monoharmonic: response.monoharmonic(of),
            harmonics: match response.regime() {
                // A stuck response has one harmonic, which is the motion itself.
                Regime::Stuck => Vec::new(),
                _ => orders
                    .filter_map(|order| response.harmonic(of, *order))
                    .collect(),
            },
        }
    }
}

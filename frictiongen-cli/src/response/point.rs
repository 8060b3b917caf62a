//! Computes the response at one frequency ratio and one friction ratio.

use crate::asked::{Mass, polar};
use crate::failure::Failure;
use crate::output::Visitor;
use frictiongen::study::{SystemAt, SystemMotion, SystemSteady};
use frictiongen::{Complex, NotContinuous, OutOfDomain};

/// The response at one frequency ratio and one friction ratio.
#[derive(Debug)]
pub struct Point {
    /// r.
    pub r: f64,
    /// β.
    pub beta: f64,
    /// Continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// β/min(β_lim, β*_lim) − 1.
    pub margin: f64,
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
        Self {
            swing: Some((motion.amplitude(), motion.phase())),
            monoharmonic: Some(motion.amplitude_monoharmonic()),
            harmonics: orders.iter().map(|order| motion.harmonic(*order)).collect(),
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
}

impl Question<'_> {
    /// Computes the points at one frequency ratio, until the visitor fails.
    pub fn answers(
        &self,
        at: &SystemAt<'_>,
        (r, beta): (f64, &[f64]),
        visit: Visitor<'_, Point>,
    ) -> Result<(), Failure> {
        for &beta in beta {
            visit(&self.answer(at, r, beta).map_err(Failure::new)?)?;
        }
        Ok(())
    }

    fn answer(&self, at: &SystemAt<'_>, r: f64, beta: f64) -> Result<Point, OutOfDomain> {
        let mut point = Point {
            r,
            beta,
            regime: "",
            margin: at.margin(beta)?,
            contact: Movement::default(),
            masses: vec![Movement::default(); self.masses.len()],
        };
        match at.motion(beta) {
            Ok(motion) => {
                point.regime = "continuous";
                point.contact = Movement::continuous(&motion.contact(), self.orders);
                point.masses = self.each(|mass| self.mass(&motion, mass));
            }
            Err(NotContinuous::StickSlip) => point.regime = "stick-slip",
            Err(NotContinuous::Unbounded) => point.regime = "unbounded",
            Err(NotContinuous::Stuck) => self.stuck(at, &mut point),
            Err(NotContinuous::OutOfDomain) => return Err(OutOfDomain { argument: "beta" }),
        }
        Ok(point)
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

    fn stuck(&self, at: &SystemAt<'_>, point: &mut Point) {
        match at.stuck() {
            Ok(stuck) => {
                point.regime = "stuck";
                point.masses = self.each(|mass| stuck.mass(&mass.name).ok().map(Movement::stuck));
            }
            // An undamped resonance that the contact does not reach.
            Err(_) => point.regime = "unbounded",
        }
    }
}

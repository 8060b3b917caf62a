//! Linear responses of a chain to its load, in closed form: the response without friction, and the response while all
//! contacts stick.

use super::combination::Combination;
use super::error::UnknownContact;
use super::scene::Joined;
use super::units::AnswerUnits;
use crate::study::error::UnknownMass;
use crate::study::joints::StuckResponse;
use crate::study::response::MotionQuantity;
use crate::{Complex, Of};

/// Linear response of a chain to its load: the complex amplitude of each mass.
#[derive(Clone, Debug)]
pub struct LinearResponse<'a> {
    joined: Joined<'a>,
    displacements: Vec<Complex<f64>>,
    units: AnswerUnits,
}

impl<'a> LinearResponse<'a> {
    pub(super) fn new(
        joined: Joined<'a>,
        displacements: Vec<Complex<f64>>,
        units: AnswerUnits,
    ) -> Self {
        Self {
            joined,
            displacements,
            units,
        }
    }

    /// Returns the complex amplitude X of the mass called `name`. The displacement of the mass is x̄ = Re X exp(iτ),
    /// with the phase τ = ωt of the load.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<Complex<f64>, UnknownMass> {
        let mass = self.joined.mass_index(name)?;
        Ok(self.displacement(mass))
    }

    /// Returns the complex amplitude X of the mass with this index.
    pub(in crate::study) fn displacement(&self, mass: usize) -> Complex<f64> {
        let found = self.displacements.get(mass).copied();
        found.unwrap_or_default() / self.units.length
    }

    /// Returns the amplitude of a motion, of its derivative with respect to τ, or of the force of a spring. Contacts have no
    /// force and dissipate no energy. Returns `None` for a quantity that the motion does not have.
    #[must_use]
    pub fn amplitude(&self, of: Of, size: MotionQuantity) -> Option<f64> {
        if of_contact_alone(of, size) {
            return Some(0.0);
        }
        let combination = Combination::of(self.joined.scene(), of, size)?;
        Some(combination.of_linear(|mass| self.displacement(mass), self.units))
    }

    /// Returns displacement and velocity of every mass at a maximum of the load. `omega` is the angular frequency of
    /// the load.
    #[must_use]
    pub fn state(&self, omega: f64) -> (Vec<f64>, Vec<f64>) {
        let all = || self.displacements.iter();
        let x = all().map(|x| x.re / self.units.length);
        let v = all().map(|x| -omega * x.im / self.units.speed);
        (x.collect(), v.collect())
    }
}

/// State of a scene with several contacts in which no contact slides.
#[derive(Clone, Debug)]
pub struct StuckState<'a> {
    linear: LinearResponse<'a>,
    forces: Vec<f64>,
    limit: f64,
    first: String,
}

impl<'a> StuckState<'a> {
    pub(super) fn new(joined: Joined<'a>, response: StuckResponse, units: AnswerUnits) -> Self {
        let (limit, first) = response.limit.unwrap_or((0.0, 0));
        let names = joined.contact_names();
        Self {
            first: names.get(first).cloned().unwrap_or_default(),
            limit,
            forces: response.forces.iter().map(|f| f / units.force).collect(),
            linear: LinearResponse::new(joined, response.displacements, units),
        }
    }

    /// Returns β*_lim, the smallest common friction at which no contact slides. If the load is in N or m, the result
    /// is a force in N.
    ///
    /// The limit is the largest value of |f|/(μ·share) among the contacts. f is the amplitude of the force in a
    /// contact, and μ its ratio of static to kinetic friction. The share is the contact's friction force divided by
    /// the common friction.
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// Returns the name of the contact that slides first if the common friction falls below the limit β*_lim.
    #[must_use]
    pub fn first(&self) -> &str {
        &self.first
    }

    /// Returns the complex amplitude of the displacement of the mass called `name`, while no contact slides.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<Complex<f64>, UnknownMass> {
        self.linear.mass(name)
    }

    /// Returns the amplitude of a motion, of its derivative with respect to τ, or of the force of a spring or of a contact,
    /// while no contact slides. Contacts dissipate no energy. Returns `None` for a quantity that the motion does not have.
    #[must_use]
    pub fn amplitude(&self, of: Of, size: MotionQuantity) -> Option<f64> {
        match (of, size) {
            (Of::ContactAt(index), MotionQuantity::Force) => self.forces.get(index).copied(),
            _ => self.linear.amplitude(of, size),
        }
    }

    /// Returns the amplitude of the force in the contact called `name`, while no contact slides.
    ///
    /// # Errors
    /// [`UnknownContact`] if no contact has this name.
    pub fn force(&self, name: &str) -> Result<f64, UnknownContact> {
        let contact = self.linear.joined.contact_index(name)?;
        Ok(self.forces.get(contact).copied().unwrap_or_default())
    }

    /// Returns displacement and velocity of every mass at a maximum of the load, while no contact slides. `omega` is
    /// the angular frequency of the load.
    pub(super) fn state(&self, omega: f64) -> (Vec<f64>, Vec<f64>) {
        self.linear.state(omega)
    }
}

/// Returns true for a quantity that a contact has and other motions do not have, or a damping ratio.
fn of_contact_alone(of: Of, size: MotionQuantity) -> bool {
    match size {
        MotionQuantity::Damping => true,
        MotionQuantity::Force | MotionQuantity::Energy => matches!(of, Of::ContactAt(_)),
        _ => false,
    }
}

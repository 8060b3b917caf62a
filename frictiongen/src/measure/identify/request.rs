//! Options of an identification.

use super::observation::Using;
use crate::study::{System, sensitivity::Quantity};

/// An unknown that the call fits together with the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unknown {
    /// The unknown is the ratio μ of static to kinetic friction. Only motions in which the contact stops depend on μ.
    Stiction,
    /// The unknown is a common factor on all natural frequencies. The masses keep their values.
    Frequencies,
    /// The unknown is one damping ratio for all modes.
    Damping,
    /// The unknown is a number of the scene description, such as a mass or a stiffness.
    Quantity(Quantity),
}

impl Unknown {
    /// Returns the symbol of the unknown, with the names in the scene description.
    #[must_use]
    pub fn symbol(&self, system: &System) -> String {
        match self {
            Self::Stiction => "mu".to_owned(),
            Self::Frequencies => "frequency factor".to_owned(),
            Self::Damping => "zeta".to_owned(),
            Self::Quantity(quantity) => {
                let point = crate::study::sensitivity::OperatingPoint::Groups { r: 1.0, beta: 0.0 };
                crate::study::sensitivity::Parameter::Quantity(*quantity)
                    .symbol(system.scene(), &point)
            }
        }
    }
}

/// Options of an identification.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IdentifyRequest {
    /// The quantities of each motion that the fit compares.
    pub using: Using,
    /// Unknowns that the identification fits together with the friction force.
    pub unknowns: Vec<Unknown>,
    /// Range of the friction forces for the scan, in N. `None` selects the range up to the force at which the contact
    /// is stuck at every frequency.
    pub range: Option<(f64, f64)>,
}

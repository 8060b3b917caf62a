//! What is asked of measurements.

use super::observation::Using;
use crate::study::{Quantity, System};

/// What is looked for beside the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unknown {
    /// μ, which shows where the contact stops.
    Stiction,
    /// A factor on all natural frequencies; masses stay.
    Frequencies,
    /// One damping ratio for all modes.
    Damping,
    /// A number of the description.
    Quantity(Quantity),
}

impl Unknown {
    /// Its symbol, with the names of the description.
    #[must_use]
    pub fn symbol(&self, system: &System) -> String {
        match self {
            Self::Stiction => "mu".to_owned(),
            Self::Frequencies => "frequency factor".to_owned(),
            Self::Damping => "zeta".to_owned(),
            Self::Quantity(quantity) => {
                let point = crate::study::OperatingPoint::Groups { r: 1.0, beta: 0.0 };
                crate::study::Parameter::Quantity(*quantity).symbol(system.scene(), &point)
            }
        }
    }
}

/// What is asked of measurements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IdentifyRequest {
    /// What of each motion is compared.
    pub using: Using,
    /// What is looked for beside the friction force.
    pub unknowns: Vec<Unknown>,
    /// Between which friction forces, N; up to where the contact is stuck at every frequency if this is none.
    pub range: Option<(f64, f64)>,
}

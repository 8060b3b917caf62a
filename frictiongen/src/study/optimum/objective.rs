//! The quantity whose largest value over a band of frequencies the search minimises. The module also converts values
//! at different frequencies to the same units.

use crate::Of;
use crate::study::response::{MotionQuantity, SystemResponse};
use crate::study::system::System;

/// A quantity of a motion under a load whose amplitude may depend on frequency.
///
/// The values of the quantity at different frequencies are comparable. The unit of displacement is P/k₁ (Y for base
/// motion), with the amplitude P or Y that the load has at r = 1. The unit of time is √(m₁/k₁). A friction is the
/// friction force divided by P (by k₁Y for base motion), again with the load at r = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study) struct Objective {
    pub of: Of,
    pub size: MotionQuantity,
    /// Exponent n of the load: its amplitude is proportional to r⁻ⁿ. The friction ratio of a constant friction force is
    /// then proportional to rⁿ.
    pub fall: i32,
}

impl Objective {
    /// Returns the displacement of a motion as the quantity to minimise, under a load of constant amplitude.
    pub fn displacement(of: Of) -> Self {
        Self {
            of,
            size: MotionQuantity::Displacement,
            fall: 0,
        }
    }

    /// Returns true if the quantity has the exact derivatives of the response. Only a displacement under a load of
    /// constant amplitude has exact derivatives.
    pub fn has_derivatives(&self) -> bool {
        self.size == MotionQuantity::Displacement && self.fall == 0 && !self.of.is_force()
    }

    /// Returns true if the motion has this quantity, and the search can minimise the quantity.
    pub fn is_sound(&self) -> bool {
        match self.size {
            MotionQuantity::Displacement => true,
            MotionQuantity::Velocity | MotionQuantity::Acceleration => !self.of.is_force(),
            MotionQuantity::Force | MotionQuantity::Energy => {
                matches!(self.of, Of::Contact | Of::ContactAt(_))
            }
            // The best damping ratio is the largest. This search, however, seeks the smallest value of a quantity.
            MotionQuantity::Damping => false,
        }
    }

    /// Returns the factor that makes a value of the quantity at r comparable with values at other frequencies.
    pub fn factor(&self, r: f64) -> f64 {
        let rate = match self.size {
            MotionQuantity::Velocity => 1,
            MotionQuantity::Acceleration => 2,
            // An energy is a force times a displacement. Each of the two units is proportional to r⁻ⁿ, where n is
            // `fall`.
            MotionQuantity::Energy => -self.fall,
            MotionQuantity::Displacement | MotionQuantity::Force => 0,
            MotionQuantity::Damping => return 1.0,
        };
        r.powi(rate - self.fall)
    }

    /// Returns the quantity in a response, in the units of the load at the frequency of the response. Returns `None` if
    /// the scene does not have the motion of the quantity.
    pub fn of_response(&self, response: &SystemResponse<'_>) -> Option<f64> {
        response.largest(self.of, self.size)
    }

    /// Returns true if the quantity is constant while the contact is stuck, as the contact's own motion is.
    pub fn rests_if_stuck(&self, system: &System) -> bool {
        let own = |of: Of| system.simplest(of) == Of::Contact;
        let turned = matches!(self.of, Of::Relative(of, to) if own(Of::Relative(to, of)));
        self.size != MotionQuantity::Force && (own(self.of) || turned)
    }
}

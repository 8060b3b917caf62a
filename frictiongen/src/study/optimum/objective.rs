//! The quantity whose largest value over a band is minimised. The module also defines the load, which makes values at
//! different frequencies comparable.

use super::places;
use crate::Of;
use crate::study::response::{MotionQuantity, SystemResponse};
use crate::study::system::System;

/// A quantity of a motion under a load whose amplitude may depend on frequency.
///
/// Its values at different frequencies are comparable. The unit of displacement is that of the load at r = 1, and the
/// unit of time is that of the scene, √(m₁/k₁). Friction is the friction force, divided by the load's unit of force at
/// r = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study) struct Objective {
    pub of: Of,
    pub size: MotionQuantity,
    /// Exponent n of the load, whose amplitude is proportional to r⁻ⁿ. The friction ratio of a constant friction force
    /// is then proportional to rⁿ.
    pub fall: i32,
}

impl Objective {
    /// The displacement of a motion under a load of constant amplitude.
    pub fn displacement(of: Of) -> Self {
        Self {
            of,
            size: MotionQuantity::Displacement,
            fall: 0,
        }
    }

    /// Returns true if the exact derivatives of the response apply: for displacements under a load of constant
    /// amplitude.
    pub fn has_derivatives(&self) -> bool {
        self.size == MotionQuantity::Displacement && self.fall == 0 && !self.of.is_force()
    }

    /// Returns true if the motion has this quantity.
    pub fn is_sound(&self) -> bool {
        match self.size {
            MotionQuantity::Displacement => true,
            MotionQuantity::Velocity | MotionQuantity::Acceleration => !self.of.is_force(),
            MotionQuantity::Force | MotionQuantity::Energy => self.of == Of::Contact,
            // The best damping ratio is the largest one, which this search does not seek.
            MotionQuantity::Damping => false,
        }
    }

    /// Returns true for the force in springs, whose value may depend on the offset of a stuck contact. When friction
    /// changes, such a value may pass through 0. Its value at one friction therefore does not bound its value at
    /// another friction.
    pub fn depends_on_offset(&self) -> bool {
        self.of.is_force()
    }

    /// Returns the friction ratio at r for a friction.
    pub fn beta(&self, friction: f64, r: f64) -> f64 {
        friction * r.powi(self.fall)
    }

    /// Returns the factor that makes a value at r comparable with values at other frequencies.
    pub fn factor(&self, r: f64) -> f64 {
        let rate = match self.size {
            MotionQuantity::Velocity => 1,
            MotionQuantity::Acceleration => 2,
            // Energy is a product of a force and a displacement.
            MotionQuantity::Energy => -self.fall,
            MotionQuantity::Displacement | MotionQuantity::Force => 0,
            MotionQuantity::Damping => return 1.0,
        };
        r.powi(rate - self.fall)
    }

    /// Returns the quantity of a response, in the units of the load at r. Returns `None` if the scene has no such
    /// motion.
    pub fn of_response(&self, response: &SystemResponse<'_>) -> Option<f64> {
        response.largest(self.of, self.size)
    }

    /// Returns the limits β_lim and β*_lim at r, converted to frictions.
    pub fn limits(&self, system: &System, r: f64) -> [f64; 2] {
        let factor = r.powi(self.fall);
        places::limits(system, r).map(|limit| limit / factor)
    }

    /// Returns true if the quantity is constant while the contact is stuck: the contact's own motion.
    pub fn rests_if_stuck(&self, system: &System) -> bool {
        let own = |of: Of| system.simplest(of) == Of::Contact;
        let turned = matches!(self.of, Of::Relative(of, to) if own(Of::Relative(to, of)));
        self.size != MotionQuantity::Force && (own(self.of) || turned)
    }
}

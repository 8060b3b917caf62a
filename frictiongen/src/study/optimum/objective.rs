//! The quantity whose largest value over a band is minimised, and the load under which it is compared between
//! frequencies.

use super::places;
use crate::Of;
use crate::study::response::{Size, SystemResponse};
use crate::study::system::System;
use crate::study::units::LoadScale;

/// A quantity of a motion under a load whose amplitude may depend on frequency.
///
/// Its values at different frequencies are comparable. The unit of displacement is that of the load at r = 1, and the
/// unit of time is that of the scene, √(m₁/k₁). Friction is the friction force over the load's unit of force at r = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study) struct Objective {
    pub of: Of,
    pub size: Size,
    /// Exponent n with which the load falls over frequency: its amplitude is proportional to r⁻ⁿ. The friction ratio of
    /// a constant friction force is then proportional to rⁿ.
    pub fall: i32,
}

impl Objective {
    /// The displacement of a motion under a load of constant amplitude.
    pub fn displacement(of: Of) -> Self {
        Self {
            of,
            size: Size::Displacement,
            fall: 0,
        }
    }

    /// Returns true if the exact derivatives of the response apply: for displacements under a load of constant
    /// amplitude.
    pub fn has_derivatives(&self) -> bool {
        self.size == Size::Displacement && self.fall == 0 && !self.of.is_force()
    }

    /// Returns true if the motion has this quantity.
    pub fn is_sound(&self) -> bool {
        match self.size {
            Size::Displacement => true,
            Size::Velocity | Size::Acceleration => !self.of.is_force(),
            Size::Force | Size::Energy => self.of == Of::Contact,
        }
    }

    /// Returns the SI unit of a value under a load, or 1 without a load.
    pub fn unit(&self, system: &System, scale: Option<LoadScale>) -> f64 {
        let Some(scale) = scale else { return 1.0 };
        let (length, force) = (scale.length(), scale.force());
        let omega = system.angular_frequency(1.0);
        match self.size {
            Size::Displacement if self.of.is_force() => force,
            Size::Displacement => length,
            Size::Velocity => length * omega,
            Size::Acceleration => length * omega * omega,
            Size::Force => force,
            Size::Energy => force * length,
        }
    }

    /// Writes a value with its unit, for a message.
    pub fn written(&self, system: &System, scale: Option<LoadScale>, value: f64) -> String {
        let number = short(value * self.unit(system, scale));
        if scale.is_none() {
            return number;
        }
        let unit = match self.size {
            Size::Displacement if self.of.is_force() => "N",
            Size::Displacement => {
                return format!("{} mm", short(1e3 * value * self.unit(system, scale)));
            }
            Size::Velocity => "m/s",
            Size::Acceleration => "m/s2",
            Size::Force => "N",
            Size::Energy => "J",
        };
        format!("{number} {unit}")
    }

    /// Returns the name of the quantity, as [`System::quantity_named`] reads it.
    pub fn name(&self, system: &System) -> String {
        let motion = system.name_of_motion(self.of);
        match self.size {
            Size::Displacement => motion,
            Size::Velocity => format!("vel({motion})"),
            Size::Acceleration => format!("accel({motion})"),
            Size::Force => format!("force({motion})"),
            Size::Energy => format!("energy({motion})"),
        }
    }

    /// Returns the friction ratio at r of a friction.
    pub fn beta(&self, friction: f64, r: f64) -> f64 {
        friction * r.powi(self.fall)
    }

    /// Returns the factor by which a value at r is multiplied, so that values at different frequencies are comparable.
    pub fn factor(&self, r: f64) -> f64 {
        let rate = match self.size {
            Size::Velocity => 1,
            Size::Acceleration => 2,
            // Energy is a product of a force and a displacement.
            Size::Energy => -self.fall,
            Size::Displacement | Size::Force => 0,
        };
        r.powi(rate - self.fall)
    }

    /// Returns the quantity of a response, in the units of r. `None` if the scene has no such motion.
    pub fn of_response(&self, response: &SystemResponse<'_>) -> Option<f64> {
        response.largest(self.of, self.size)
    }

    /// Returns the limits of friction at r, β_lim and β*_lim, as frictions.
    pub fn limits(&self, system: &System, r: f64) -> [f64; 2] {
        let factor = r.powi(self.fall);
        places::limits(system, r).map(|limit| limit / factor)
    }

    /// Returns true if the quantity is constant while the contact is stuck: the contact's own motion.
    pub fn rests_if_stuck(&self, system: &System) -> bool {
        let own = |of: Of| system.simplest(of) == Of::Contact;
        let turned = matches!(self.of, Of::Relative(of, to) if own(Of::Relative(to, of)));
        self.size != Size::Force && (own(self.of) || turned)
    }
}

/// Writes a number with four digits.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let decimals = (3.0 - value.abs().log10().floor()).clamp(0.0, 12.0) as usize;
    format!("{value:.decimals$}")
}

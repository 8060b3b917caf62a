//! Units of the results in tables: SI units if the amplitude of the load is given, otherwise non-dimensional groups.

use crate::Of;
use crate::study::scene::Excitation;
use crate::study::{
    System,
    units::{Load, LoadError, LoadScale},
};
use std::f64::consts::TAU;

/// Physical quantity of a number in a table, such as a length. The quantity determines the unit of the number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhysicalQuantity {
    /// The number is a ratio without a unit, or its unit is in another column.
    One,
    /// The number is a displacement. It is in m under a load, and otherwise divided by P/k₁ (by Y for base motion).
    Length,
    /// The number is a velocity. It is in m/s under a load, and otherwise dx̄/dτ.
    Velocity,
    /// The number is an acceleration. It is in m/s² under a load, and otherwise d²x̄/dτ².
    Acceleration,
    /// The number is a phase. It is in degrees under a load, and otherwise in rad.
    Angle,
    /// The number is a force. It is in N under a load, and otherwise divided by P (by k₁Y for base motion).
    Force,
    /// The number is a mean power in W under a load. Without a load it is the work in a cycle, divided by P²/k₁ (by
    /// k₁Y² for base motion).
    Power,
    /// The number is an energy in a cycle. It is in J under a load, and otherwise divided by P²/k₁ (by k₁Y² for base
    /// motion).
    Energy,
    /// The number is a frequency in Hz.
    Hertz,
    /// The number is an angular frequency in rad/s.
    AngularFrequency,
    /// The number is a time in s.
    Time,
}

/// Units of the results in tables: SI units if the amplitude of the load is given, otherwise non-dimensional groups.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    scale: Option<LoadScale>,
    load: Option<Load>,
    base_motion: bool,
    reversed: bool,
    /// Angular frequency at the frequency ratio r = 1, in rad/s.
    reference: f64,
}

impl Measure {
    /// Returns the units without a load: non-dimensional groups.
    #[must_use]
    pub fn groups(system: &System) -> Self {
        Self {
            scale: None,
            load: None,
            base_motion: system.scene().excitation == Excitation::Base,
            reversed: system.contact_is_reversed(),
            reference: system.angular_frequency(1.0),
        }
    }

    /// Returns the units under a load: N, m, Hz, degrees.
    ///
    /// # Errors
    /// Same errors as [`System::load_scale`].
    pub fn under(system: &System, load: Load) -> Result<Self, LoadError> {
        Ok(Self {
            scale: Some(system.load_scale(load)?),
            load: Some(load),
            ..Self::groups(system)
        })
    }

    /// Returns the units of results that are already in SI units.
    #[must_use]
    pub fn si(system: &System) -> Self {
        Self {
            scale: Some(LoadScale::UNIT),
            ..Self::groups(system)
        }
    }

    /// Returns the exponent n of the load. The amplitude of the load is proportional to ω⁻ⁿ. Without a load the result
    /// is 0.
    #[must_use]
    pub fn fall(&self) -> i32 {
        self.load.map_or(0, |load| load.fall())
    }

    /// Returns the units of length and force at an angular frequency in rad/s, or `None` without a load. If the angular
    /// frequency is NaN, returns the units at r = 1.
    #[must_use]
    pub fn scale_at(&self, omega: f64) -> Option<LoadScale> {
        let factor = match self.fall() {
            0 => return self.scale,
            _ if omega.is_nan() => return self.scale,
            fall => (self.reference / omega).powi(fall),
        };
        self.scale.map(|scale| scale.times(factor))
    }

    /// Returns the units of length and force, or `None` without a load. If the amplitude of the load depends on
    /// frequency, the units are those at the frequency ratio r = 1.
    #[must_use]
    pub fn scale(&self) -> Option<LoadScale> {
        self.scale
    }

    /// Returns the load, or `None` without a load. The amplitude of the load determines the units of length and force,
    /// for example P/k₁ and P.
    #[must_use]
    pub fn load(&self) -> Option<Load> {
        self.load
    }

    /// Returns true for results in SI units without a load: those of a free vibration.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.scale.is_some() && self.load.is_none()
    }

    /// Returns true if the excitation is base motion.
    #[must_use]
    pub fn is_base_motion(&self) -> bool {
        self.base_motion
    }

    /// Returns true if these units reverse the sign of the contact's motion. Under a load the sign follows the order
    /// of the contact's two sides in the scene description. Otherwise the sign follows the order of the masses.
    #[must_use]
    pub fn turns_contact(&self) -> bool {
        self.reversed && self.scale.is_some()
    }

    /// Returns true if the motion is that of the contact, and these units reverse its sign.
    #[must_use]
    pub fn turns(&self, of: Of) -> bool {
        of == Of::Contact && self.turns_contact()
    }

    /// Returns the sign, 1 or −1, by which the contact's displacement is multiplied in these units.
    #[must_use]
    pub fn sign(&self) -> f64 {
        if self.turns_contact() { -1.0 } else { 1.0 }
    }

    /// Converts a non-dimensional group to these units. For velocities, accelerations and powers, `omega` is the
    /// angular frequency ω in rad/s.
    #[must_use]
    pub fn convert(&self, dimension: PhysicalQuantity, value: f64, omega: f64) -> f64 {
        let here = Self {
            scale: self.scale_at(omega),
            ..*self
        };
        match dimension {
            PhysicalQuantity::Length => here.length(value),
            PhysicalQuantity::Velocity => here.velocity(value, omega),
            PhysicalQuantity::Acceleration => here.acceleration(value, omega),
            PhysicalQuantity::Angle => here.angle(value),
            PhysicalQuantity::Force => here.force(value),
            PhysicalQuantity::Power => here.power(value, omega),
            PhysicalQuantity::Energy => here
                .scale
                .map_or(value, |scale| scale.displacement(scale.friction(value))),
            PhysicalQuantity::One
            | PhysicalQuantity::Hertz
            | PhysicalQuantity::AngularFrequency
            | PhysicalQuantity::Time => value,
        }
    }

    /// Converts a non-dimensional displacement x̄ to these units. Under a load the result is in m.
    #[must_use]
    pub fn length(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.displacement(ratio))
    }

    /// Converts a displacement in these units back to the non-dimensional group x̄.
    #[must_use]
    pub fn length_ratio(&self, length: f64) -> f64 {
        self.scale
            .map_or(length, |scale| scale.displacement_ratio(length))
    }

    /// Converts a non-dimensional velocity dx̄/dτ to these units, at an angular frequency in rad/s.
    #[must_use]
    pub fn velocity(&self, rate: f64, omega: f64) -> f64 {
        self.scale.map_or(rate, |scale| scale.velocity(rate, omega))
    }

    /// Converts a non-dimensional acceleration d²x̄/dτ² to these units, at the angular frequency ω in rad/s.
    #[must_use]
    pub fn acceleration(&self, rate: f64, omega: f64) -> f64 {
        self.scale
            .map_or(rate, |scale| scale.velocity(rate, omega) * omega)
    }

    /// Converts the work in a cycle, divided by P²/k₁, to these units. Under a load the result is the mean power in W.
    /// `omega` is the angular frequency ω in rad/s.
    #[must_use]
    pub fn power(&self, work: f64, omega: f64) -> f64 {
        self.scale.map_or(work, |scale| {
            scale.displacement(scale.friction(work)) * omega / TAU
        })
    }

    /// Converts a force divided by P, such as β, to these units. Under a load the result is in N.
    #[must_use]
    pub fn force(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.friction(ratio))
    }

    /// Converts a phase in rad to these units, which are degrees under a load and otherwise rad.
    #[must_use]
    pub fn angle(&self, radians: f64) -> f64 {
        self.scale.map_or(radians, |_| radians.to_degrees())
    }

    /// Returns the name of a column for a quantity. Under a load the name contains the unit, as in `amplitude_m`.
    /// Otherwise it is the quantity alone, as in `amplitude`.
    #[must_use]
    pub fn name(&self, name: &str, dimension: PhysicalQuantity) -> String {
        let (suffix, always) = match dimension {
            PhysicalQuantity::One => ("", true),
            PhysicalQuantity::Length => ("_m", false),
            PhysicalQuantity::Velocity => ("_m_s", false),
            PhysicalQuantity::Acceleration => ("_m_s2", false),
            PhysicalQuantity::Angle => ("_deg", false),
            PhysicalQuantity::Force => ("_N", false),
            PhysicalQuantity::Power => ("_W", false),
            PhysicalQuantity::Energy => ("_J", false),
            PhysicalQuantity::Hertz => ("_Hz", true),
            PhysicalQuantity::AngularFrequency => ("_rad_s", true),
            PhysicalQuantity::Time => ("_s", true),
        };
        let suffix = if always || self.scale.is_some() {
            suffix
        } else {
            ""
        };
        format!("{name}{suffix}")
    }

    /// Returns the unit of a quantity, such as `m`. For a ratio, returns the reference quantity, such as `P/k1`.
    #[must_use]
    pub fn unit_or_reference(&self, dimension: PhysicalQuantity) -> &'static str {
        match self.unit(dimension) {
            "" => self.reference(dimension),
            unit => unit,
        }
    }

    /// Returns the unit of a column, which is empty for ratios.
    #[must_use]
    pub fn unit(&self, dimension: PhysicalQuantity) -> &'static str {
        match (dimension, self.scale) {
            (PhysicalQuantity::Hertz, _) => "Hz",
            (PhysicalQuantity::AngularFrequency, _) => "rad/s",
            (PhysicalQuantity::Time, _) => "s",
            (PhysicalQuantity::Angle, None) => "rad",
            (PhysicalQuantity::One, _) | (_, None) => "",
            (PhysicalQuantity::Length, _) => "m",
            (PhysicalQuantity::Velocity, _) => "m/s",
            (PhysicalQuantity::Acceleration, _) => "m/s2",
            (PhysicalQuantity::Angle, _) => "deg",
            (PhysicalQuantity::Force, _) => "N",
            (PhysicalQuantity::Power, _) => "W",
            (PhysicalQuantity::Energy, _) => "J",
        }
    }

    /// Returns the reference of a non-dimensional group for a heading, for example `Y` or `P/k1`. The text is empty
    /// under a load.
    #[must_use]
    pub fn reference(&self, dimension: PhysicalQuantity) -> &'static str {
        match (dimension, self.scale, self.base_motion) {
            (_, Some(_), _) => "",
            (
                PhysicalQuantity::Length
                | PhysicalQuantity::Velocity
                | PhysicalQuantity::Acceleration,
                _,
                true,
            ) => "Y",
            (
                PhysicalQuantity::Length
                | PhysicalQuantity::Velocity
                | PhysicalQuantity::Acceleration,
                _,
                false,
            ) => "P/k1",
            (PhysicalQuantity::Force, _, true) => "k1 Y",
            (PhysicalQuantity::Force, _, false) => "P",
            _ => "",
        }
    }

    /// Returns the unit or the reference of a column in brackets, for a heading: `(m)`, `(of Y)`.
    #[must_use]
    pub fn title(&self, dimension: PhysicalQuantity) -> &'static str {
        match (self.unit(dimension), self.reference(dimension)) {
            ("m", _) => "(m)",
            ("m/s", _) => "(m/s)",
            ("m/s2", _) => "(m/s2)",
            ("deg", _) => "(deg)",
            ("rad", _) => "(rad)",
            ("N", _) => "(N)",
            ("W", _) => "(W)",
            ("J", _) => "(J)",
            ("Hz", _) => "(Hz)",
            ("rad/s", _) => "(rad/s)",
            ("s", _) => "(s)",
            (_, "Y") => "(of Y)",
            (_, "P/k1") => "(of P/k1)",
            (_, "k1 Y") => "(of k1 Y)",
            (_, "P") => "(of P)",
            _ => "",
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::{Measure, PhysicalQuantity};
    use crate::study::{System, units::Load};

    #[test]
    fn names_units_and_headings() {
        let system: System = "struct Block { masses: { block: 2 }, springs: { base - block: 50 },
            contact: block - wall, excitation: base }"
            .parse()
            .unwrap();
        let groups = Measure::groups(&system);
        let metres = Measure::under(&system, Load::Base(0.1)).unwrap();
        let cases = [
            (PhysicalQuantity::One, ["", "", ""], ["", "", ""]),
            (
                PhysicalQuantity::Length,
                ["", "", "(of Y)"],
                ["_m", "m", "(m)"],
            ),
            (
                PhysicalQuantity::Velocity,
                ["", "", "(of Y)"],
                ["_m_s", "m/s", "(m/s)"],
            ),
            (
                PhysicalQuantity::Acceleration,
                ["", "", "(of Y)"],
                ["_m_s2", "m/s2", "(m/s2)"],
            ),
            (
                PhysicalQuantity::Angle,
                ["", "rad", "(rad)"],
                ["_deg", "deg", "(deg)"],
            ),
            (
                PhysicalQuantity::Force,
                ["", "", "(of k1 Y)"],
                ["_N", "N", "(N)"],
            ),
            (PhysicalQuantity::Power, ["", "", ""], ["_W", "W", "(W)"]),
            (PhysicalQuantity::Energy, ["", "", ""], ["_J", "J", "(J)"]),
            (
                PhysicalQuantity::Hertz,
                ["_Hz", "Hz", "(Hz)"],
                ["_Hz", "Hz", "(Hz)"],
            ),
            (
                PhysicalQuantity::AngularFrequency,
                ["_rad_s", "rad/s", "(rad/s)"],
                ["_rad_s", "rad/s", "(rad/s)"],
            ),
            (
                PhysicalQuantity::Time,
                ["_s", "s", "(s)"],
                ["_s", "s", "(s)"],
            ),
        ];
        for (dimension, without, with) in cases {
            for (measure, [ending, unit, title]) in [(&groups, without), (&metres, with)] {
                assert_eq!(measure.name("x", dimension), format!("x{ending}"));
                assert_eq!(measure.unit(dimension), unit, "{dimension:?}");
                assert_eq!(measure.title(dimension), title, "{dimension:?}");
            }
        }
        assert_eq!(metres.convert(PhysicalQuantity::Force, 1.0, 0.0), 5.0);
        assert_eq!(
            metres.convert(PhysicalQuantity::Acceleration, 1.0, 2.0),
            0.4
        );
        assert_eq!(
            groups.convert(PhysicalQuantity::Acceleration, 1.0, 3.0),
            1.0
        );
    }
}

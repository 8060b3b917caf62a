//! The units of recordings.

/// The physical quantity that a channel measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// Displacement, with the SI unit m.
    Displacement,
    /// Velocity, with the SI unit m/s.
    Velocity,
    /// Acceleration, with the SI unit m/s².
    Acceleration,
    /// Force, with the SI unit N.
    Force,
    /// Time, with the SI unit s.
    Time,
}

impl Dimension {
    /// Returns the quantity with an example of a unit, for a message.
    pub(in crate::measure) fn needed(self) -> &'static str {
        match self {
            Self::Displacement => "a displacement, in a unit such as mm",
            Self::Velocity => "a velocity, in a unit such as m/s",
            Self::Acceleration => "an acceleration, in a unit such as m/s2 or g",
            Self::Force => "a force, in a unit such as N",
            Self::Time => "a time, in a unit such as s",
        }
    }
}

/// A motion as the necessary quantity of a channel, for a message.
pub(in crate::measure) const MOTION: &str = "a motion, in a unit such as mm, m/s or g";

/// A unit of measurement: its physical quantity and its size in SI units.
///
/// ```
/// use frictiongen::measure::{Dimension, Unit};
///
/// let unit: Unit = "mm/s".parse()?;
/// assert_eq!((unit.dimension(), unit.scale()), (Dimension::Velocity, 1e-3));
/// # Ok::<(), frictiongen::measure::MeasureError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    name: &'static str,
    dimension: Dimension,
    scale: f64,
}

/// Standard acceleration of gravity, in m/s² (exact by definition).
const GRAVITY: f64 = 9.806_65;

use Dimension::{Acceleration, Displacement, Force, Time, Velocity};

/// All known units. Each entry has the unit's name, its ending in the name of a column, its quantity, and its size in
/// SI units.
pub(super) const UNITS: [(&str, &str, Dimension, f64); 19] = [
    ("m", "m", Displacement, 1.0),
    ("cm", "cm", Displacement, 1e-2),
    ("mm", "mm", Displacement, 1e-3),
    ("um", "um", Displacement, 1e-6),
    ("m/s", "m_s", Velocity, 1.0),
    ("mm/s", "mm_s", Velocity, 1e-3),
    ("m/s2", "m_s2", Acceleration, 1.0),
    ("mm/s2", "mm_s2", Acceleration, 1e-3),
    ("g", "g", Acceleration, GRAVITY),
    ("cm/s2", "cm_s2", Acceleration, 1e-2),
    ("Gal", "gal", Acceleration, 1e-2),
    ("in/s2", "in_s2", Acceleration, 0.0254),
    ("ft/s2", "ft_s2", Acceleration, 0.3048),
    ("N", "N", Force, 1.0),
    ("mN", "mN", Force, 1e-3),
    ("kN", "kN", Force, 1e3),
    ("s", "s", Time, 1.0),
    ("ms", "ms", Time, 1e-3),
    ("us", "us", Time, 1e-6),
];

impl Unit {
    /// Unit metre (m) of a displacement.
    pub const METRE: Self = Self::of(UNITS[0]);
    /// Unit millimetre (mm) of a displacement.
    pub const MILLIMETRE: Self = Self::of(UNITS[2]);
    /// Unit metre per second (m/s) of a velocity.
    pub const METRE_PER_SECOND: Self = Self::of(UNITS[4]);
    /// Unit metre per second squared (m/s²) of an acceleration.
    pub const METRE_PER_SECOND_SQUARED: Self = Self::of(UNITS[6]);
    /// Unit newton (N) of a force.
    pub const NEWTON: Self = Self::of(UNITS[13]);

    /// Unit g, the standard acceleration of gravity 9.80665 m/s².
    pub(super) const GRAVITY: Self = Self::of(UNITS[8]);

    pub(super) const fn of(
        (name, _, dimension, scale): (&'static str, &str, Dimension, f64),
    ) -> Self {
        Self {
            name,
            dimension,
            scale,
        }
    }

    /// Returns the name of this unit, for example `mm/s2`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the physical quantity that this unit measures.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Returns the size of this unit in the SI unit of its quantity, for example 0.001 for the millimetre.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Returns the names of all known units as one text, for messages.
    #[must_use]
    pub fn known() -> String {
        UNITS.map(|unit| unit.0).join(", ")
    }

    /// Returns the ending of a column's name that denotes this unit, for example `mm_s2`.
    pub(super) fn ending(&self) -> &'static str {
        let found = UNITS.iter().find(|unit| unit.0 == self.name);
        found.map_or("", |unit| unit.1)
    }
}

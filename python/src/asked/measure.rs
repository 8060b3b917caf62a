//! Units of displacements, phases and limits: those of a load, or non-dimensional groups.

use super::numbers::one;
use crate::errors::domain;
use frictiongen::study::scene::Excitation;
use frictiongen::study::{Load, LoadError, LoadScale};
use frictiongen::{Of, System};
use pyo3::prelude::*;
use std::f64::consts::TAU;

/// The arguments `force` and `base`.
pub type LoadArguments<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// Units of the answers.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    scale: Option<LoadScale>,
    load: Option<Load>,
    base_motion: bool,
    reversed: bool,
}

impl Measure {
    /// Makes the units from the load arguments, if a load is given.
    pub fn of(system: &System, (force, base): &LoadArguments<'_>) -> PyResult<Self> {
        let mut measure = Self {
            scale: None,
            load: None,
            base_motion: system.scene().excitation == Excitation::Base,
            reversed: system.contact_is_reversed(),
        };
        let (argument, load) = match (force, base) {
            (None, None) => return Ok(measure),
            (Some(_), Some(_)) => {
                return Err(domain(
                    "force and base: a scene has one load, give one of them",
                ));
            }
            (Some(force), None) => ("force", Load::Force(one("force", force)?)),
            (None, Some(base)) => ("base", Load::Base(one("base", base)?)),
        };
        let scale = system.load_scale(load).map_err(|error| match error {
            LoadError::DrivenByBase | LoadError::DrivenByForce(_) => domain(format_args!(
                "{argument}: {error}; its load is given by {}",
                measure.argument()
            )),
            _ => domain(format_args!("{argument}: {error}")),
        })?;
        measure.scale = Some(scale);
        measure.load = Some(load);
        Ok(measure)
    }

    /// Returns the units, if a load is given.
    pub fn scale(&self) -> Option<LoadScale> {
        self.scale
    }

    /// Returns the load, if one is given.
    pub fn load(&self) -> Option<Load> {
        self.load
    }

    /// Returns the argument that gives the load of this scene.
    pub fn argument(&self) -> &'static str {
        if self.base_motion { "base" } else { "force" }
    }

    /// Returns whether this is the contact's motion and its sign is reversed, so that the answer does not depend on the
    /// order of the masses.
    pub fn turns(&self, of: Of) -> bool {
        of == Of::Contact && self.reversed && self.scale.is_some()
    }

    /// Returns the sign of the contact's displacement.
    pub fn sign(&self) -> f64 {
        if self.turns(Of::Contact) { -1.0 } else { 1.0 }
    }

    /// Returns a displacement in these units.
    pub fn length(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.displacement(ratio))
    }

    /// Returns a velocity in these units, at an angular frequency in rad/s.
    pub fn velocity(&self, rate: f64, omega: f64) -> f64 {
        self.scale.map_or(rate, |scale| scale.velocity(rate, omega))
    }

    /// Returns d²x̄/dτ² at the angular frequency ω, or the acceleration if the load is known.
    pub fn acceleration(&self, rate: f64, omega: f64) -> f64 {
        self.scale
            .map_or(rate, |scale| scale.velocity(rate, omega) * omega)
    }

    /// Returns the work of a cycle over P²/k₁, or the mean power if the load is known.
    pub fn power(&self, work: f64, omega: f64) -> f64 {
        self.scale.map_or(work, |scale| {
            scale.displacement(scale.friction(work)) * omega / TAU
        })
    }

    /// Returns a force in these units.
    pub fn force(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.friction(ratio))
    }

    /// Returns a phase in these units.
    pub fn angle(&self, radians: f64) -> f64 {
        self.scale.map_or(radians, |_| radians.to_degrees())
    }

    /// Returns a name, with its unit if the load is known: `amplitude`, `_m`.
    pub fn name(&self, name: &str, unit: &str) -> String {
        format!("{name}{}", self.scale.map_or("", |_| unit))
    }
}

//! What displacements, phases and limits are counted in: the units of a load, or groups.

use super::numbers::one;
use crate::errors::domain;
use frictiongen::study::scene::Excitation;
use frictiongen::study::{Load, LoadError, LoadScale};
use frictiongen::{Of, System};
use pyo3::prelude::*;
use std::f64::consts::TAU;

/// `force` and `base`.
pub type LoadArguments<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// What answers are counted in.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    scale: Option<LoadScale>,
    load: Option<Load>,
    base_motion: bool,
    reversed: bool,
}

impl Measure {
    /// As the load says that is given, if any is.
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

    /// The units, if a load is given.
    pub fn scale(&self) -> Option<LoadScale> {
        self.scale
    }

    /// The load, if one is given.
    pub fn load(&self) -> Option<Load> {
        self.load
    }

    /// The argument that gives the load of this scene.
    pub fn argument(&self) -> &'static str {
        if self.base_motion { "base" } else { "force" }
    }

    /// Whether the motion is the contact's and is turned round, so that no order of masses changes it.
    pub fn turns(&self, of: Of) -> bool {
        of == Of::Contact && self.reversed && self.scale.is_some()
    }

    /// The sign of the contact's displacement.
    pub fn sign(&self) -> f64 {
        if self.turns(Of::Contact) { -1.0 } else { 1.0 }
    }

    /// A displacement.
    pub fn length(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.displacement(ratio))
    }

    /// A velocity, at an angular frequency.
    pub fn velocity(&self, rate: f64, omega: f64) -> f64 {
        self.scale.map_or(rate, |scale| scale.velocity(rate, omega))
    }

    /// d²x̄/dτ², at the angular frequency ω; an acceleration where the load is known.
    pub fn acceleration(&self, rate: f64, omega: f64) -> f64 {
        self.scale
            .map_or(rate, |scale| scale.velocity(rate, omega) * omega)
    }

    /// The work of a cycle over P²/k₁; the mean power where the load is known.
    pub fn power(&self, work: f64, omega: f64) -> f64 {
        self.scale.map_or(work, |scale| {
            scale.displacement(scale.friction(work)) * omega / TAU
        })
    }

    /// A force.
    pub fn force(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.friction(ratio))
    }

    /// A phase.
    pub fn angle(&self, radians: f64) -> f64 {
        self.scale.map_or(radians, |_| radians.to_degrees())
    }

    /// A name with its unit where the load is known: `amplitude`, `_m`.
    pub fn name(&self, name: &str, unit: &str) -> String {
        format!("{name}{}", self.scale.map_or("", |_| unit))
    }
}

//! Units of displacements, phases and limits: those of a load, or non-dimensional groups.

use crate::args::LoadArguments;
use crate::asked::number;
use crate::failure::Failure;
use frictiongen::System;
use frictiongen::study::scene::Excitation;
use frictiongen::study::{Load, LoadError, LoadScale};

/// Units of displacements and phases.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    scale: Option<LoadScale>,
    load: Option<Load>,
    base_motion: bool,
    reversed: bool,
}

impl Measure {
    /// Makes the units from the load options, if a load is given.
    pub fn of(arguments: &LoadArguments, system: &System) -> Result<Self, Failure> {
        let mut measure = Self::none(system);
        if let Some(text) = &arguments.force {
            let load = Load::Force(number("--force", text)?);
            measure.load = Some(load);
            measure.scale = Some(measure.checked(system, load, "--force", text)?);
        }
        if let Some(text) = &arguments.base {
            let load = Load::Base(number("--base", text)?);
            measure.load = Some(load);
            measure.scale = Some(measure.checked(system, load, "--base", text)?);
        }
        Ok(measure)
    }

    /// Makes the units without a load, which are non-dimensional groups.
    pub fn none(system: &System) -> Self {
        Self {
            scale: None,
            load: None,
            base_motion: system.scene().excitation == Excitation::Base,
            reversed: system.contact_is_reversed(),
        }
    }

    fn checked(
        &self,
        system: &System,
        load: Load,
        option: &str,
        text: &str,
    ) -> Result<LoadScale, Failure> {
        system.load_scale(load).map_err(|error| match error {
            LoadError::DrivenByBase | LoadError::DrivenByForce(_) => Failure::new(format_args!(
                "{option}: {error}; its load is given by {}",
                self.option()
            )),
            _ => Failure::new(format_args!("{option} `{text}`: {error}")),
        })
    }

    /// Returns the units, if a load is given.
    pub fn scale(&self) -> Option<LoadScale> {
        self.scale
    }

    /// Returns the load, if one is given.
    pub fn load(&self) -> Option<Load> {
        self.load
    }

    /// Returns the option that gives the load of this scene.
    pub fn option(&self) -> &'static str {
        if self.base_motion {
            "--base"
        } else {
            "--force"
        }
    }

    /// Returns whether the sign of the contact's motion is reversed, so that the answer does not depend on the order of
    /// the masses.
    pub fn turns_contact(&self) -> bool {
        self.reversed && self.scale.is_some()
    }

    /// Returns the load and its units of force and length, in words.
    pub fn description(&self, number: impl Fn(f64) -> String) -> Option<String> {
        let scale = self.scale?;
        let (force, length) = (number(scale.force()), number(scale.length()));
        Some(if self.base_motion {
            format!("Y = {length} m, k1 Y = {force} N")
        } else {
            format!("P = {force} N, P/k1 = {length} m")
        })
    }

    /// Returns a displacement in these units.
    pub fn length(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.displacement(ratio))
    }

    /// Converts a displacement in these units back to the non-dimensional ratio.
    #[cfg(feature = "pictures")]
    pub fn length_ratio(&self, length: f64) -> f64 {
        self.scale
            .map_or(length, |scale| scale.displacement_ratio(length))
    }

    /// Returns a velocity in these units, at an angular frequency in rad/s.
    pub fn velocity(&self, rate: f64, omega: f64) -> f64 {
        self.scale.map_or(rate, |scale| scale.velocity(rate, omega))
    }

    /// Returns a force in these units.
    pub fn force(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.friction(ratio))
    }

    /// Returns a phase in these units.
    pub fn angle(&self, radians: f64) -> f64 {
        match self.scale {
            Some(_) => radians.to_degrees(),
            None => radians,
        }
    }

    /// Returns the name of a displacement with its unit.
    pub fn length_name(&self, name: &str) -> String {
        self.named(name, "_m")
    }

    /// Returns the name of a velocity with its unit.
    pub fn velocity_name(&self, name: &str) -> String {
        self.named(name, "_m_s")
    }

    /// Returns the name of a force with its unit.
    pub fn force_name(&self, name: &str) -> String {
        self.named(name, "_N")
    }

    /// Returns the name of a phase with its unit.
    pub fn angle_name(&self, name: &str) -> String {
        self.named(name, "_deg")
    }

    fn named(&self, name: &str, unit: &str) -> String {
        let unit = self.scale.map_or("", |_| unit);
        format!("{name}{unit}")
    }

    /// Returns d²x̄/dτ² at the angular frequency ω, or the acceleration if the load is known.
    pub fn acceleration(&self, rate: f64, omega: f64) -> f64 {
        self.scale
            .map_or(rate, |scale| scale.velocity(rate, omega) * omega)
    }

    /// Returns the work of a cycle over P²/k₁, or the mean power if the load is known.
    pub fn power(&self, work: f64, omega: f64) -> f64 {
        self.scale.map_or(work, |scale| {
            scale.displacement(scale.friction(work)) * omega / (2.0 * std::f64::consts::PI)
        })
    }

    /// Returns one of two names: the first without a load, the second with one.
    pub fn name(&self, ratio: &str, physical: &str) -> String {
        self.scale.map_or(ratio, |_| physical).to_owned()
    }

    /// Returns the unit of a displacement for a heading.
    pub fn length_title(&self) -> &'static str {
        match (self.scale, self.base_motion) {
            (Some(_), _) => "(m)",
            (None, true) => "(of Y)",
            (None, false) => "(of P/k1)",
        }
    }

    /// Returns the unit of a velocity for a heading.
    pub fn velocity_title(&self) -> &'static str {
        self.scale.map_or(self.length_title(), |_| "(m/s)")
    }

    /// Returns the unit of a force for a heading.
    pub fn force_title(&self) -> &'static str {
        match (self.scale, self.base_motion) {
            (Some(_), _) => "(N)",
            (None, true) => "(of k1 Y)",
            (None, false) => "(of P)",
        }
    }

    /// Returns the unit of a phase for a heading.
    pub fn angle_title(&self) -> &'static str {
        self.scale.map_or("(rad)", |_| "(deg)")
    }
}

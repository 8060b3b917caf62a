//! What displacements, phases and limits are counted in: the units of a load, or groups.

use crate::args::LoadArguments;
use crate::asked::number;
use crate::failure::Failure;
use frictiongen::System;
use frictiongen::study::scene::Excitation;
use frictiongen::study::{Load, LoadError, LoadScale};

/// What displacements and phases are counted in.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    scale: Option<LoadScale>,
    load: Option<Load>,
    base_motion: bool,
    reversed: bool,
}

impl Measure {
    /// As the load says that is given, if any is.
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

    /// Without a load.
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

    /// The units, if a load is given.
    pub fn scale(&self) -> Option<LoadScale> {
        self.scale
    }

    /// The load, if one is given.
    pub fn load(&self) -> Option<Load> {
        self.load
    }

    /// The option that gives the load of this scene.
    pub fn option(&self) -> &'static str {
        if self.base_motion {
            "--base"
        } else {
            "--force"
        }
    }

    /// Whether the contact's motion is to be turned round, so that no order of masses changes it.
    pub fn turns_contact(&self) -> bool {
        self.reversed && self.scale.is_some()
    }

    /// The load and what it makes of the groups, in words.
    pub fn description(&self, number: impl Fn(f64) -> String) -> Option<String> {
        let scale = self.scale?;
        let (force, length) = (number(scale.force()), number(scale.length()));
        Some(if self.base_motion {
            format!("Y = {length} m, k1 Y = {force} N")
        } else {
            format!("P = {force} N, P/k1 = {length} m")
        })
    }

    /// A displacement.
    pub fn length(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.displacement(ratio))
    }

    /// A displacement that is in units already → the multiple that it is.
    #[cfg(feature = "pictures")]
    pub fn length_ratio(&self, length: f64) -> f64 {
        self.scale
            .map_or(length, |scale| scale.displacement_ratio(length))
    }

    /// A velocity, at an angular frequency.
    pub fn velocity(&self, rate: f64, omega: f64) -> f64 {
        self.scale.map_or(rate, |scale| scale.velocity(rate, omega))
    }

    /// A force.
    pub fn force(&self, ratio: f64) -> f64 {
        self.scale.map_or(ratio, |scale| scale.friction(ratio))
    }

    /// A phase.
    pub fn angle(&self, radians: f64) -> f64 {
        match self.scale {
            Some(_) => radians.to_degrees(),
            None => radians,
        }
    }

    /// The name of a displacement, with its unit.
    pub fn length_name(&self, name: &str) -> String {
        self.named(name, "_m")
    }

    /// The name of a velocity, with its unit.
    pub fn velocity_name(&self, name: &str) -> String {
        self.named(name, "_m_s")
    }

    /// The name of a force, with its unit.
    pub fn force_name(&self, name: &str) -> String {
        self.named(name, "_N")
    }

    /// The name of a phase, with its unit.
    pub fn angle_name(&self, name: &str) -> String {
        self.named(name, "_deg")
    }

    fn named(&self, name: &str, unit: &str) -> String {
        let unit = self.scale.map_or("", |_| unit);
        format!("{name}{unit}")
    }

    /// d²x̄/dτ², at the angular frequency ω; an acceleration where the load is known.
    pub fn acceleration(&self, rate: f64, omega: f64) -> f64 {
        self.scale
            .map_or(rate, |scale| scale.velocity(rate, omega) * omega)
    }

    /// The work of a cycle over P²/k₁; the mean power where the load is known.
    pub fn power(&self, work: f64, omega: f64) -> f64 {
        self.scale.map_or(work, |scale| {
            scale.displacement(scale.friction(work)) * omega / (2.0 * std::f64::consts::PI)
        })
    }

    /// A name with one of two endings: without a load, and with one.
    pub fn name(&self, ratio: &str, physical: &str) -> String {
        self.scale.map_or(ratio, |_| physical).to_owned()
    }

    /// The unit of a displacement, in a heading.
    pub fn length_title(&self) -> &'static str {
        match (self.scale, self.base_motion) {
            (Some(_), _) => "(m)",
            (None, true) => "(of Y)",
            (None, false) => "(of P/k1)",
        }
    }

    /// The unit of a velocity, in a heading.
    pub fn velocity_title(&self) -> &'static str {
        self.scale.map_or(self.length_title(), |_| "(m/s)")
    }

    /// The unit of a force, in a heading.
    pub fn force_title(&self) -> &'static str {
        match (self.scale, self.base_motion) {
            (Some(_), _) => "(N)",
            (None, true) => "(of k1 Y)",
            (None, false) => "(of P)",
        }
    }

    /// The unit of a phase, in a heading.
    pub fn angle_title(&self) -> &'static str {
        self.scale.map_or("(rad)", |_| "(deg)")
    }
}

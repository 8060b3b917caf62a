//! Reads a description with errors as far as necessary to find out which methods the emitted type would have.

use std::collections::HashSet;

use frictiongen_model::scene::Precision;
use frictiongen_model::validate::may_name;

use crate::parse::Name;
use crate::parse::syntax::Syntax;

/// The fields of a description with errors that determine the methods of its type.
pub struct Readable<'s> {
    /// The masses whose names are valid method names.
    pub mass_names: Vec<&'s Name>,
    /// The scalar type of the scene.
    pub precision: Precision,
    /// True if the excitation is a motion of the base.
    pub on_base: bool,
    /// Masses on which the stepper may apply a force, as indices into `mass_names`.
    pub forces: Vec<usize>,
    /// True if the description declares the step of a stepper.
    pub has_step: bool,
}

impl Syntax {
    /// Returns the fields that the parser could read in spite of errors in the description.
    #[must_use]
    pub fn readable(&self) -> Readable<'_> {
        let fields = &self.fields;
        let mut seen = HashSet::new();
        let mass_names: Vec<&Name> = self
            .mass_names()
            .filter(|name| may_name(&name.text, true))
            .filter(|name| seen.insert(name.text.as_str()))
            .collect();
        let excitation = fields.excitation.given().map(|name| name.text.as_str());
        let loaded = fields.force.given();
        let loaded = loaded.map_or(&[][..], |force| &force.list.entries);
        let mut forces: Vec<usize> = loaded
            .iter()
            .filter(|name| excitation != Some(name.text.as_str()))
            .filter_map(|name| mass_names.iter().position(|mass| mass.text == name.text))
            .collect();
        forces.sort_unstable();
        forces.dedup();
        Readable {
            mass_names,
            precision: fields.scalar.given().copied().unwrap_or_default(),
            on_base: excitation == Some("base"),
            forces,
            has_step: !fields.step.is_missing(),
        }
    }
}

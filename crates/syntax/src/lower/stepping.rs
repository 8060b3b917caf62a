//! Converts the friction law and the fields of the stepper from the syntax tree to fields of the scene.

use frictiongen_model::scene::{FrictionLaw, StepperOptions};
use frictiongen_model::validate::Path;

use super::resolve::Lowering;
use crate::parse::Name;
use crate::parse::syntax::{Fields, LawEntry};

impl<'s> Lowering<'s, '_> {
    pub(super) fn friction(&mut self, fields: &Fields) -> FrictionLaw {
        let Some(entry) = fields.friction.given() else {
            return FrictionLaw::Coulomb;
        };
        let LawEntry::Stribeck(points) = &entry.law else {
            return FrictionLaw::Coulomb;
        };
        let points = points.iter().enumerate();
        let points = points.map(|(index, [speed, level])| {
            [
                self.number(*speed, Path::Friction(Some(2 * index))),
                self.number(*level, Path::Friction(Some(2 * index + 1))),
            ]
        });
        FrictionLaw::Stribeck(points.collect())
    }

    /// Returns the settings of the stepper, and the names of the masses in the field `force`, as written in the
    /// description. The stepper may apply a force to these masses.
    pub(super) fn stepping(&mut self, fields: &'s Fields) -> (StepperOptions, Vec<&'s Name>) {
        let (mut forces, mut entries) = (Vec::new(), Vec::new());
        let written = fields.force.given();
        for name in written.map_or(&[][..], |force| &force.list.entries) {
            if let Ok(mass) = self.mass(name, &[]) {
                forces.push(mass);
                entries.push(name);
            }
        }
        let step = fields.step.given();
        let input = fields.input.given();
        let stepping = StepperOptions {
            step: step.map(|step| self.number(*step, Path::Step)),
            input: input.map(|input| input.value).unwrap_or_default(),
            forces,
        };
        (stepping, entries)
    }
}

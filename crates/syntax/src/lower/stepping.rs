//! Converts the friction law and the fields of the stepper from the syntax tree to fields of the scene.

use frictiongen_model::scene::{FrictionLaw, StepperOptions};
use frictiongen_model::stribeck::{ACCURACY, FINEST, HIGHEST, SmoothLaw};
use frictiongen_model::validate::Path;

use super::resolve::Lowering;
use crate::parse::syntax::{Fields, JointEntry, LawEntry};
use crate::parse::{Name, Number};

impl<'s> Lowering<'s, '_> {
    pub(super) fn friction(
        &mut self,
        fields: &Fields,
        contacts: &[&JointEntry],
    ) -> (FrictionLaw, Option<SmoothLaw>) {
        let Some(entry) = fields.friction.given() else {
            return (FrictionLaw::Coulomb, None);
        };
        let points = match &entry.law {
            LawEntry::Coulomb => return (FrictionLaw::Coulomb, None),
            LawEntry::Stribeck(points) => points,
            LawEntry::Decaying(numbers) => {
                let law = self.decaying(numbers, fields, contacts);
                let points = law.iter().map(|law| law.points.clone());
                let law_of = points.map(FrictionLaw::Stribeck).next();
                return (law_of.unwrap_or_default(), law);
            }
        };
        let points = points.iter().enumerate();
        let points = points.map(|(index, [speed, level])| {
            [
                self.number(*speed, Path::Friction(Some(2 * index))),
                self.number(*level, Path::Friction(Some(2 * index + 1))),
            ]
        });
        (FrictionLaw::Stribeck(points.collect()), None)
    }

    /// Returns the lines of a friction that decays with the speed. Reports numbers outside their range.
    fn decaying(
        &mut self,
        numbers: &[Number],
        fields: &Fields,
        contacts: &[&JointEntry],
    ) -> Option<SmoothLaw> {
        let mut values = numbers.iter().map(|number| (number.place, number.value));
        let (at_rest, rest) = values.next()?;
        let (at_speed, speed) = values.next()?;
        let accuracy = values.next();
        let (rest, speed) = (rest?, speed?);
        let problems = &mut *self.problems;
        if !(1.0 < rest && rest <= HIGHEST) {
            let message = format!(
                "the friction at rest is {rest:?} times F, but must be above 1 and at most {HIGHEST} times F; for a constant friction, leave `stribeck` out"
            );
            problems.report(at_rest, message);
            return None;
        }
        if !(0.0 < speed && speed.is_finite()) {
            let message = format!("the speed of the decay must be above zero, but it is {speed:?}");
            problems.report(at_speed, message);
            return None;
        }
        let own = accuracy.map_or(Some(ACCURACY), |(_, value)| value)?;
        if let Some((place, _)) = accuracy
            && !(FINEST..1.0).contains(&own)
        {
            let message = format!(
                "the accuracy of `stribeck` is a fraction of F, from {FINEST:?} to below 1, but it is {own:?}; leave it out for {ACCURACY:?}"
            );
            problems.report(place, message);
            return None;
        }
        let stictions = contacts.iter().map(|contact| contact.stiction);
        let stictions = stictions.chain([fields.stiction.given().copied()]);
        for number in stictions.flatten() {
            let Some(stiction) = number.value.filter(|stiction| *stiction < rest) else {
                continue;
            };
            let message = format!(
                "the static friction, {stiction:?} times F, is below the friction at rest of `stribeck`, {rest:?} times F; write `stiction: {rest:?}` or more, or leave it out for {rest:?}"
            );
            problems.report(number.place, message);
        }
        Some(SmoothLaw::decaying(rest, speed, own))
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

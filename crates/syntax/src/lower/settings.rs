//! Converts the damping, the declarations and the provided items from the syntax tree to fields of the scene.

use std::collections::HashSet;

use frictiongen_model::scene::{Accuracy, Damping, Declared, Provide, Range};
use frictiongen_model::validate::Path;

use super::resolve::Lowering;
use crate::diagnostics::Reported;
use crate::parse::syntax::{
    AccuracyEntry, DampingKind, Fields, Placed, ProvideEntry, ProvideKind, RangeSyntax, Slot,
};
use crate::parse::{List, Name};

impl<'s> Lowering<'s, '_> {
    pub(super) fn damping(&mut self, fields: &Fields) -> Damping {
        let Some(entry) = fields.damping.given() else {
            return Damping::None;
        };
        match &entry.kind {
            DampingKind::None => Damping::None,
            DampingKind::Uniform(ratio) => {
                Damping::Uniform(self.number(*ratio, Path::Damping(Some(0))))
            }
            DampingKind::Modal(ratios) => Damping::Modal(
                ratios
                    .iter()
                    .enumerate()
                    .map(|(index, ratio)| self.number(*ratio, Path::Damping(Some(index))))
                    .collect(),
            ),
            DampingKind::Rayleigh(mass, stiffness) => Damping::Rayleigh {
                mass: self.number(*mass, Path::Damping(Some(0))),
                stiffness: self.number(*stiffness, Path::Damping(Some(1))),
            },
        }
    }

    pub(super) fn declared(&mut self, fields: &Fields) -> Declared {
        let broken = matches!(fields.accuracy, Slot::Broken)
            || matches!(fields.range, Slot::Broken)
            || matches!(fields.side, Slot::Broken)
            || matches!(fields.budget, Slot::Broken)
            || matches!(fields.beyond, Slot::Broken)
            || matches!(fields.proof, Slot::Broken);
        if broken {
            // The parser has already reported the error. The other declarations cannot be checked without this field.
            return Declared::default();
        }
        let accuracy = match fields.accuracy.given() {
            Some(AccuracyEntry::Relative(value)) => {
                Accuracy::Relative(self.number(*value, Path::Accuracy))
            }
            Some(AccuracyEntry::Exact) | None => Accuracy::Exact,
        };
        let budget = fields.budget.given();
        let budget = budget.map(|bytes| self.number(*bytes, Path::Budget));
        let range = fields.range.given().map(|range| {
            let mut ends = |span: Option<RangeSyntax>, path, default| match span {
                Some(RangeSyntax { low, high }) => {
                    (self.number(low, path), self.number(high, path))
                }
                None => default,
            };
            let any = (0.0, f64::INFINITY);
            Range {
                r: ends(range.ratio, Path::RangeOfRatio, any),
                beta: ends(range.friction, Path::RangeOfFriction, any),
            }
        });
        Declared {
            accuracy,
            range,
            side: fields
                .side
                .given()
                .map(|side| side.value)
                .unwrap_or_default(),
            budget,
            beyond: fields
                .beyond
                .given()
                .map(|beyond| beyond.value)
                .unwrap_or_default(),
            proof: fields
                .proof
                .given()
                .map(|proof| proof.value)
                .unwrap_or_default(),
        }
    }

    /// Returns the items of the field `provide` that the parser could read, each with its entry in the description.
    /// Returns `None` in place of the items if the scene has the default items.
    pub(super) fn provide(
        &mut self,
        fields: &'s Fields,
    ) -> (Option<Vec<Provide>>, Vec<&'s ProvideEntry>) {
        let default = || (None, Vec::new());
        self.checks.provide = match &fields.provide {
            Slot::Missing => true,
            Slot::Broken => false,
            Slot::Given(written) => written.list.complete,
        };
        let Slot::Given(Placed { list, .. }) = &fields.provide else {
            return default();
        };
        // A list whose entries all have errors counts as missing. Only a list without any written entry is an error of
        // its own.
        if list.entries.is_empty() && !list.complete {
            return default();
        }
        let provide = list
            .entries
            .iter()
            .map(|entry| match &entry.kind {
                ProvideKind::Limits => Provide::Limits,
                ProvideKind::Motion(None) => Provide::Motion(None),
                ProvideKind::Motion(Some(names)) => self.motion(names),
                ProvideKind::Stuck => Provide::Stuck,
                ProvideKind::Orbit => Provide::Orbit,
                ProvideKind::Simulation => Provide::Simulation,
                ProvideKind::Stepper => Provide::Stepper,
                ProvideKind::SelfCheck => Provide::SelfCheck,
            })
            .collect();
        (Some(provide), list.entries.iter().collect())
    }

    fn motion(&mut self, names: &List<Name>) -> Provide {
        let mut masses = Vec::new();
        let mut seen = HashSet::new();
        let mut sound = names.complete;
        for name in &names.entries {
            if name.text == "contact" {
                self.problems.report(
                    name.place,
                    "the motion of the contact is always provided; delete `contact`",
                );
                sound = false;
                continue;
            }
            match self.mass(name, &[]) {
                Ok(mass) if !seen.insert(mass) => {
                    let message = format!("`{}` is named twice; name it once", name.text);
                    self.problems.report(name.place, message);
                }
                Ok(mass) => masses.push(mass),
                Err(Reported) => sound = false,
            }
        }
        // If all entries of a list have errors, the list becomes empty. This is not an error of its own.
        Provide::Motion((sound || !masses.is_empty()).then_some(masses))
    }
}

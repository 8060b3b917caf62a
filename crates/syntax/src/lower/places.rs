//! Positions of a scene's items (masses, springs, fields, …) in the description.

use frictiongen_model::validate::Path;

use crate::diagnostics::TokenPosition;
use crate::parse::Name;
use crate::parse::syntax::{
    AccuracyEntry, DampingKind, JointEntry, LawEntry, MassEntry, ProvideEntry, SpringEntry,
    StopEntry, Syntax,
};

/// The entries of a description from which the items of a scene come.
pub(super) struct Places<'s> {
    pub(super) syntax: &'s Syntax,
    /// Entry in the description for each spring of the scene. The list has no entry for a spring with an error,
    /// because the scene does not contain this spring.
    pub(super) springs: Vec<&'s SpringEntry>,
    /// Entry in the description for each contact of the field `contacts`.
    pub(super) contacts: Vec<&'s JointEntry>,
    /// Entry in the description for each dashpot.
    pub(super) dampers: Vec<&'s SpringEntry>,
    /// Entry in the description for each stop.
    pub(super) stops: Vec<&'s StopEntry>,
    /// Entry in the description for each constant force.
    pub(super) constant: Vec<&'s MassEntry>,
    /// Entry in the description for each item of the field `provide`.
    pub(super) provide: Vec<&'s ProvideEntry>,
    /// Name, as written in the description, of each mass in the field `force`. The stepper may apply a force to these
    /// masses.
    pub(super) force: Vec<&'s Name>,
}

impl Places<'_> {
    /// Returns the position of an item of the scene in the description. If the description does not contain the item,
    /// returns the position of the scene's name.
    pub(super) fn of(&self, path: Path) -> TokenPosition {
        self.find(path).unwrap_or(self.syntax.place)
    }

    /// Returns the position of an item of the scene in the description, or `None` if the description does not contain
    /// the item.
    pub(super) fn find(&self, path: Path) -> Option<TokenPosition> {
        let fields = &self.syntax.fields;
        let mass = |index: usize| {
            fields
                .masses
                .given()
                .and_then(|masses| masses.list.entries.get(index))
        };
        let spring = |index: usize| self.springs.get(index);
        let joint = |index: usize| self.contacts.get(index);
        let damper = |index: usize| self.dampers.get(index);
        let stop = |index: usize| self.stops.get(index);
        let constant = |index: usize| self.constant.get(index);
        match path {
            Path::Scene => None,
            Path::Masses => fields.masses.given().map(|masses| masses.place),
            Path::Mass(index) => mass(index).map(|mass| mass.value.place),
            Path::MassName(index) => mass(index).map(|mass| mass.name.place),
            Path::Springs => fields.springs.given().map(|springs| springs.place),
            Path::Spring(index) => spring(index).map(|spring| spring.stiffness.place),
            Path::SpringFrom(index) => spring(index).map(|spring| spring.from.place),
            Path::SpringTo(index) => spring(index).map(|spring| spring.to.place),
            // The description may have its single contact in the field `contacts`.
            Path::Contact | Path::ContactFrom => {
                let contact = fields.contact.given().map(|contact| contact.from.place);
                contact.or_else(|| self.find(Path::JointFrom(0)))
            }
            Path::ContactTo => {
                let contact = fields.contact.given().map(|contact| contact.to.place);
                contact.or_else(|| self.find(Path::JointTo(0)))
            }
            Path::JointName(index) => joint(index).map(|entry| entry.name.place),
            Path::JointFrom(index) => joint(index).map(|entry| entry.from.place),
            Path::JointTo(index) => joint(index).map(|entry| entry.to.place),
            Path::JointStiffness(index) => joint(index)?.stiffness.map(|number| number.place),
            Path::JointStiction(index) => joint(index)?.stiction.map(|number| number.place),
            Path::JointShare(index) => joint(index)?.share.map(|number| number.place),
            Path::JointSpeed(index) => joint(index)?.speed.map(|number| number.place),
            Path::Damper(index) => damper(index).map(|entry| entry.stiffness.place),
            Path::DamperFrom(index) => damper(index).map(|entry| entry.from.place),
            Path::DamperTo(index) => damper(index).map(|entry| entry.to.place),
            Path::StopName(index) => stop(index).map(|entry| entry.name.place),
            Path::StopFrom(index) => stop(index).map(|entry| entry.from.place),
            Path::StopTo(index) => stop(index).map(|entry| entry.to.place),
            Path::StopGap(index) => stop(index)?.gap.map(|number| number.place),
            Path::StopStiffness(index) => stop(index)?.stiffness.map(|number| number.place),
            Path::StopDamping(index) => stop(index)?.damping.map(|number| number.place),
            Path::StopRestitution(index) => stop(index)?.restitution.map(|number| number.place),
            Path::Constant(index) => constant(index).map(|entry| entry.value.place),
            Path::ConstantMass(index) => constant(index).map(|entry| entry.name.place),
            Path::Excitation => fields.excitation.given().map(|name| name.place),
            Path::Damping(index) => self.damping(index),
            Path::DampingFrom => fields.damping_from.given().map(|choice| choice.place),
            Path::Stiction => {
                let stiction = fields.stiction.given().map(|number| number.place);
                stiction.or_else(|| self.find(Path::JointStiction(0)))
            }
            Path::Stiffness => {
                let stiffness = fields.stiffness.given().map(|number| number.place);
                stiffness.or_else(|| self.find(Path::JointStiffness(0)))
            }
            Path::Provide(None) => fields.provide.given().map(|provide| provide.place),
            Path::Provide(Some(index)) => self.provide.get(index).map(|entry| entry.place),
            Path::Accuracy => match fields.accuracy.given() {
                Some(AccuracyEntry::Relative(number)) => Some(number.place),
                _ => None,
            },
            Path::Range => fields.range.given().map(|range| range.place),
            Path::RangeOfRatio => {
                let range = fields.range.given().and_then(|range| range.ratio);
                range.map(|span| span.low.place)
            }
            Path::RangeOfFriction => {
                let range = fields.range.given().and_then(|range| range.friction);
                range.map(|span| span.low.place)
            }
            Path::Side => fields.side.given().map(|choice| choice.place),
            Path::Budget => fields.budget.given().map(|number| number.place),
            Path::Beyond => fields.beyond.given().map(|choice| choice.place),
            Path::Proof => fields.proof.given().map(|choice| choice.place),
            Path::Friction(index) => self.friction(index),
            Path::Step => fields.step.given().map(|number| number.place),
            Path::Input => fields.input.given().map(|choice| choice.place),
            Path::Force(None) => fields.force.given().map(|force| force.place),
            Path::Force(Some(index)) => self.force.get(index).map(|name| name.place),
        }
    }

    fn friction(&self, index: Option<usize>) -> Option<TokenPosition> {
        let friction = self.syntax.fields.friction.given()?;
        let number = index.and_then(|index| match &friction.law {
            LawEntry::Coulomb => None,
            LawEntry::Stribeck(points) => points.as_flattened().get(index),
            LawEntry::Decaying(numbers) => numbers.get(index),
        });
        Some(number.map_or(friction.place, |number| number.place))
    }

    fn damping(&self, index: Option<usize>) -> Option<TokenPosition> {
        let damping = self.syntax.fields.damping.given()?;
        let number = index.and_then(|index| match &damping.kind {
            DampingKind::None => None,
            DampingKind::Uniform(ratio) => Some(ratio),
            DampingKind::Modal(ratios) => ratios.get(index),
            DampingKind::Rayleigh(mass, stiffness) => [mass, stiffness].get(index).copied(),
        });
        Some(number.map_or(damping.place, |number| number.place))
    }
}

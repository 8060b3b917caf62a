//! Converts parsed contacts and dashpots to the contacts and dashpots of a scene.

use frictiongen_model::scene::{ContactSides, Damper, JointLaw, Joints, NamedContact};
use frictiongen_model::validate::Path;

use super::resolve::Lowering;
use crate::parse::syntax::{Fields, JointEntry, SpringEntry};

/// The contacts and dashpots of a scene, each with a reference to its entry in the description.
pub(super) struct LoweredJoints<'s> {
    pub(super) joints: Joints,
    pub(super) contacts: Vec<&'s JointEntry>,
    pub(super) dampers: Vec<&'s SpringEntry>,
}

impl<'s> Lowering<'s, '_> {
    /// Returns the contacts and dashpots of the description, except those with a node that does not exist.
    pub(super) fn joints(&mut self, fields: &'s Fields) -> LoweredJoints<'s> {
        let mut lowered = LoweredJoints {
            joints: Joints::default(),
            contacts: Vec::new(),
            dampers: Vec::new(),
        };
        if let (Some(one), Some(_)) = (fields.contact.given(), fields.contacts.given()) {
            self.problems.report(
                one.from.place,
                "`contact` and `contacts` exclude each other; keep one of the two fields",
            );
        }
        self.checks.joints = fields.contacts.is_read() && fields.dampers.is_read();
        if let Some(written) = fields.contacts.given() {
            self.checks.joints &= written.list.complete;
            for entry in &written.list.entries {
                self.named_contact(entry, &mut lowered);
            }
        }
        if let Some(written) = fields.dampers.given() {
            self.checks.joints &= written.list.complete;
            for entry in &written.list.entries {
                self.damper(entry, &mut lowered);
            }
        }
        lowered
    }

    fn named_contact(&mut self, entry: &'s JointEntry, lowered: &mut LoweredJoints<'s>) {
        self.checks.joints &= entry.complete;
        // The code looks up both nodes before it returns an error, so that it reports errors in both nodes.
        let (from, to) = (self.node(&entry.from), self.node(&entry.to));
        let (Ok(from), Ok(to)) = (from, to) else {
            self.checks.joints = false;
            return;
        };
        let index = lowered.contacts.len();
        let stiffness = entry.stiffness;
        let stiffness = stiffness.map(|number| self.number(number, Path::JointStiffness(index)));
        let mut or_one = |number: Option<_>, path| match number {
            Some(number) => self.number(number, path),
            None => 1.0,
        };
        let law = JointLaw {
            stiffness,
            stiction: or_one(entry.stiction, Path::JointStiction(index)),
            share: or_one(entry.share, Path::JointShare(index)),
        };
        lowered.joints.contacts.push(NamedContact {
            name: entry.name.text.clone(),
            sides: ContactSides { from, to },
            law,
        });
        lowered.contacts.push(entry);
    }

    fn damper(&mut self, entry: &'s SpringEntry, lowered: &mut LoweredJoints<'s>) {
        let (from, to) = (self.node(&entry.from), self.node(&entry.to));
        let (Ok(from), Ok(to)) = (from, to) else {
            self.checks.joints = false;
            return;
        };
        let path = Path::Damper(lowered.dampers.len());
        let coefficient = self.number(entry.stiffness, path);
        lowered.joints.dampers.push(Damper {
            from,
            to,
            coefficient,
        });
        lowered.dampers.push(entry);
    }
}

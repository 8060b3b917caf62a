//! Converts parsed contacts, dashpots, stops and constant forces to those of a scene.

use frictiongen_model::scene::{
    ConstantForce, ContactSides, Damper, Impact, JointLaw, Joints, NamedContact, NamedStop, StopLaw,
};
use frictiongen_model::validate::Path;

use super::resolve::Lowering;
use crate::parse::Number;
use crate::parse::syntax::{Fields, JointEntry, MassEntry, SpringEntry, StopEntry};

/// The contacts, dashpots, stops and constant forces of a scene, each with a reference to its entry in the description.
pub(super) struct LoweredJoints<'s> {
    pub(super) joints: Joints,
    pub(super) contacts: Vec<&'s JointEntry>,
    pub(super) dampers: Vec<&'s SpringEntry>,
    pub(super) stops: Vec<&'s StopEntry>,
    pub(super) constant: Vec<&'s MassEntry>,
}

impl<'s> Lowering<'s, '_> {
    /// Returns the contacts, dashpots, stops and constant forces of the description, except those with a node that does
    /// not exist.
    pub(super) fn joints(&mut self, fields: &'s Fields) -> LoweredJoints<'s> {
        let mut lowered = LoweredJoints {
            joints: Joints::default(),
            contacts: Vec::new(),
            dampers: Vec::new(),
            stops: Vec::new(),
            constant: Vec::new(),
        };
        if let (Some(one), Some(_)) = (fields.contact.given(), fields.contacts.given()) {
            self.problems.report(
                one.from.place,
                "`contact` and `contacts` exclude each other; keep one of the two fields",
            );
        }
        self.checks.joints = fields.contacts.is_read()
            && fields.dampers.is_read()
            && fields.stops.is_read()
            && fields.constant.is_read();
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
        if let Some(written) = fields.stops.given() {
            self.checks.joints &= written.list.complete;
            for entry in &written.list.entries {
                self.stop(entry, &mut lowered);
            }
        }
        if let Some(written) = fields.constant.given() {
            self.checks.joints &= written.list.complete;
            for entry in &written.list.entries {
                self.constant(entry, &mut lowered);
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
        let mut or = |default, number: Option<_>, path| match number {
            Some(number) => self.number(number, path),
            None => default,
        };
        let law = JointLaw {
            stiffness,
            stiction: or(1.0, entry.stiction, Path::JointStiction(index)),
            share: or(1.0, entry.share, Path::JointShare(index)),
            speed: or(0.0, entry.speed, Path::JointSpeed(index)),
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

    fn stop(&mut self, entry: &'s StopEntry, lowered: &mut LoweredJoints<'s>) {
        self.checks.joints &= entry.complete;
        let (from, to) = (self.node(&entry.from), self.node(&entry.to));
        let (Ok(from), Ok(to)) = (from, to) else {
            self.checks.joints = false;
            return;
        };
        let index = lowered.stops.len();
        // The parser has already reported a missing property, so the lowering treats it as a number that the parser
        // could not read.
        let unread = Number {
            value: None,
            place: entry.name.place,
        };
        let gap = self.number(entry.gap.unwrap_or(unread), Path::StopGap(index));
        let impact = match (entry.stiffness, entry.restitution) {
            (None, Some(number)) => {
                Impact::Restitution(self.number(number, Path::StopRestitution(index)))
            }
            (stiffness, _) => Impact::Spring {
                stiffness: self.number(stiffness.unwrap_or(unread), Path::StopStiffness(index)),
                damping: match entry.damping {
                    Some(number) => self.number(number, Path::StopDamping(index)),
                    None => 0.0,
                },
            },
        };
        lowered.joints.stops.push(NamedStop {
            name: entry.name.text.clone(),
            sides: ContactSides { from, to },
            law: StopLaw { gap, impact },
        });
        lowered.stops.push(entry);
    }

    fn constant(&mut self, entry: &'s MassEntry, lowered: &mut LoweredJoints<'s>) {
        let text = entry.name.text.as_str();
        let mass = if ["base", "wall"].contains(&text) {
            Err(self.problems.report(
                entry.name.place,
                format!("`{text}` is a support, on which a force has no effect; write the name of a mass"),
            ))
        } else {
            self.mass(&entry.name, &[])
        };
        let Ok(mass) = mass else {
            self.checks.joints = false;
            return;
        };
        let path = Path::Constant(lowered.constant.len());
        let force = self.number(entry.value, path);
        lowered.joints.constant.push(ConstantForce { mass, force });
        lowered.constant.push(entry);
    }
}

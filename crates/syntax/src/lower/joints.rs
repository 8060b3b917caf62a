//! Converts parsed contacts, dashpots, stops and constant forces to those of a scene.

use frictiongen_model::scene::{
    ConstantForce, ContactSides, Damper, Impact, JointLaw, Joints, NamedContact, NamedStop, Node,
    StopLaw,
};
use frictiongen_model::validate::Path;

use super::resolve::Lowering;
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
    /// Returns the contacts and dashpots of the description, except those with a node that does not exist.
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
        let mut or_one = |number: Option<_>, path| match number {
            Some(number) => self.number(number, path),
            None => 1.0,
        };
        let law = JointLaw {
            stiffness,
            stiction: or_one(entry.stiction, Path::JointStiction(index)),
            share: or_one(entry.share, Path::JointShare(index)),
            speed: entry
                .speed
                .map_or(0.0, |number| self.number(number, Path::JointSpeed(index))),
        };
        lowered.joints.contacts.push(NamedContact {
            name: entry.name.text.clone(),
            sides: ContactSides { from, to },
            law,
        });
        lowered.contacts.push(entry);
    }

    fn stop(&mut self, entry: &'s StopEntry, lowered: &mut LoweredJoints<'s>) {
        self.checks.joints &= entry.complete;
        let (from, to) = (self.node(&entry.from), self.node(&entry.to));
        let index = lowered.stops.len();
        let law = self.stop_law(entry, index);
        let (Ok(from), Ok(to), Some(law)) = (from, to, law) else {
            self.checks.joints = false;
            return;
        };
        lowered.joints.stops.push(NamedStop {
            name: entry.name.text.clone(),
            sides: ContactSides { from, to },
            law,
        });
        lowered.stops.push(entry);
    }

    /// Returns the gap and the impact of a stop, or `None` if the description does not say them.
    fn stop_law(&mut self, entry: &StopEntry, index: usize) -> Option<StopLaw> {
        let name = &entry.name.text;
        let mut report = |place, message: String| {
            if entry.complete {
                self.problems.report(place, message);
            }
        };
        if entry.gap.is_none() {
            report(
                entry.name.place,
                format!(
                    "the stop `{name}` has no gap; add, for example, `gap: 0.01`, or `gap: 0` if its sides touch"
                ),
            );
        }
        match (entry.stiffness, entry.restitution) {
            (None, None) => report(
                entry.name.place,
                format!(
                    "the stop `{name}` has neither a stiffness nor a restitution; add one of them, for example `stiffness: 1e6`"
                ),
            ),
            (Some(_), Some(second)) => report(
                second.place,
                format!(
                    "`stiffness` and `restitution` exclude each other; keep one of them for the stop `{name}`"
                ),
            ),
            (None, Some(_)) if entry.damping.is_some() => {
                let place = entry
                    .damping
                    .map_or(entry.name.place, |damping| damping.place);
                report(
                    place,
                    format!(
                        "`damping` needs a `stiffness`; the restitution of the stop `{name}` already contains its loss"
                    ),
                );
            }
            _ => {}
        }
        let impact = match (entry.stiffness, entry.restitution, entry.damping) {
            (Some(stiffness), None, damping) => Impact::Spring {
                stiffness: self.number(stiffness, Path::StopStiffness(index)),
                damping: damping.map_or(0.0, |damping| {
                    self.number(damping, Path::StopDamping(index))
                }),
            },
            (None, Some(restitution), None) => {
                Impact::Restitution(self.number(restitution, Path::StopRestitution(index)))
            }
            _ => return None,
        };
        let gap = self.number(entry.gap?, Path::StopGap(index));
        Some(StopLaw { gap, impact })
    }

    fn constant(&mut self, entry: &'s MassEntry, lowered: &mut LoweredJoints<'s>) {
        let mass = match self.node(&entry.name) {
            Ok(Node::Mass(mass)) => mass,
            Ok(Node::Base | Node::Wall) => {
                let message = format!(
                    "a constant force acts on a mass, and `{}` is a support; write the name of a mass",
                    entry.name.text
                );
                self.problems.report(entry.name.place, message);
                self.checks.joints = false;
                return;
            }
            Err(_) => {
                self.checks.joints = false;
                return;
            }
        };
        let path = Path::Constant(lowered.constant.len());
        let force = self.number(entry.value, path);
        lowered.joints.constant.push(ConstantForce { mass, force });
        lowered.constant.push(entry);
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

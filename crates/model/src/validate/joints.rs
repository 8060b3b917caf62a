//! Checks of several contacts and of dashpots.

use std::collections::HashMap;

use super::checks::{Checks, LARGEST, SMALLEST, check_node};
use super::error::SceneError;
use super::names::{is_keyword, is_name, is_reserved};
use super::path::Path;
use super::springs::pair_of;
use super::stops;
use crate::scene::{CONTACT, Excitation, FrictionLaw, NamedContact, Node, Scene};

/// Largest number of contacts of a scene.
pub const MOST_CONTACTS: usize = 16;
/// Largest number of masses of a scene with `contacts`, `dampers`, `stops` or `constant`.
pub const MOST_JOINED: usize = 64;

/// Reports errors in contacts, dashpots, stops and constant forces, and fields that are incompatible with them.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    check_sizes(scene, checks, errors);
    let contacts = &scene.joints.contacts;
    let mut sound = true;
    for (index, contact) in contacts.iter().enumerate() {
        sound &= check_sides(scene, contact, index, errors);
        check_law(contact, index, errors);
    }
    sound &= check_dampers(scene, errors);
    sound &= stops::check(scene, errors);
    stops::check_constant(scene, errors);
    check_fields(scene, errors);
    // If an entry is faulty, `check_touched` might report that a mass has no connection, although this entry connects
    // it.
    if sound && checks.joints && checks.springs && checks.masses {
        check_loops(scene, errors);
        check_touched(scene, checks, errors);
    }
}

fn check_sizes(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    let count = scene.joints.contacts.len();
    if count > MOST_CONTACTS {
        errors.push(SceneError::TooManyContacts {
            path: Path::JointName(MOST_CONTACTS),
            count,
            limit: MOST_CONTACTS,
        });
    }
    let count = scene.masses.len();
    if (MOST_JOINED + 1..=checks.most_masses).contains(&count) {
        errors.push(SceneError::TooManyMasses {
            path: Path::MassName(MOST_JOINED),
            count,
            limit: MOST_JOINED,
        });
    }
}

/// Reports errors in the names of the contacts. The name `contact` of a single contact needs no check.
pub(super) fn check_names(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    let contacts = scene.named_contacts();
    for (index, contact) in contacts.iter().enumerate() {
        let single = scene.joints.contacts.is_empty();
        if single && contact.name == CONTACT {
            return;
        }
        let (name, path) = (contact.name.clone(), Path::JointName(index));
        if checks.emitted && is_keyword(&name) {
            errors.push(SceneError::ContactKeyword { path, name });
        } else if is_reserved(&name, checks.emitted) {
            errors.push(SceneError::ContactReserved { path, name });
        } else if !is_name(&name) {
            errors.push(SceneError::ContactNotAName { path, name });
        } else if scene.masses.iter().any(|mass| mass.name == name) {
            errors.push(SceneError::ContactNamedAsMass { path, name });
        } else if contacts.iter().take(index).any(|other| other.name == name) {
            errors.push(SceneError::DuplicateContact { path, name });
        }
    }
}

/// Reports errors in the sides of a contact. Returns true if the sides have no errors.
fn check_sides(
    scene: &Scene,
    contact: &NamedContact,
    index: usize,
    errors: &mut Vec<SceneError>,
) -> bool {
    let before = errors.len();
    let (from, to) = (contact.sides.from, contact.sides.to);
    check_node(scene, from, Path::JointFrom(index), errors);
    check_node(scene, to, Path::JointTo(index), errors);
    let name = |node| scene.node_name(node).to_owned();
    let earlier = scene.joints.contacts.iter().take(index);
    let same = |other: &&NamedContact| {
        pair_of(other.sides.from, other.sides.to) == pair_of(from, to)
            && other.law.stiffness.is_none()
    };
    if !is_mass(from) && !is_mass(to) {
        let path = Path::JointFrom(index);
        errors.push(SceneError::ContactWithoutMass { path });
    } else if from == to {
        let (path, name) = (Path::JointTo(index), name(from));
        errors.push(SceneError::ContactWithItself { path, name });
    } else if contact.law.stiffness.is_none() {
        let shares: Vec<f64> = earlier.filter(same).map(|other| other.law.share).collect();
        if !shares.is_empty() {
            let sum = shares.iter().sum::<f64>() + contact.law.share;
            errors.push(SceneError::ParallelContacts {
                path: Path::JointFrom(index),
                from: name(from),
                to: name(to),
                sum: told(sum, " with the share"),
            });
        }
    }
    errors.len() == before
}

/// Returns `words` followed by the sum as text. Returns an empty text if a term of the sum is unreadable in the
/// description.
pub(super) fn told(sum: f64, words: &str) -> String {
    if sum.is_finite() {
        format!("{words} {sum:?}")
    } else {
        String::new()
    }
}

pub(super) fn is_mass(node: Node) -> bool {
    matches!(node, Node::Mass(_))
}

fn check_law(contact: &NamedContact, index: usize, errors: &mut Vec<SceneError>) {
    let (name, law) = (&contact.name, &contact.law);
    if let Some(value) = law.stiffness {
        let path = Path::JointStiffness(index);
        let what = format!("the stiffness of the contact `{name}`");
        if value.is_nan() {
            errors.push(SceneError::NotFinite { path, what, value });
        } else if value == f64::INFINITY {
            errors.push(SceneError::StiffnessInfinite { path });
        } else if value <= 0.0 {
            let name = name.clone();
            errors.push(SceneError::JointStiffnessNotPositive { path, name, value });
        } else if !(SMALLEST..=LARGEST).contains(&value) {
            errors.push(SceneError::OutOfScale { path, what, value });
        }
    }
    let (value, path) = (law.stiction, Path::JointStiction(index));
    let what = format!("μ of the contact `{name}`");
    if !value.is_finite() {
        errors.push(SceneError::NotFinite { path, what, value });
    } else if value < 1.0 {
        errors.push(SceneError::StictionBelowOne { path, value });
    } else if value > LARGEST {
        errors.push(SceneError::OutOfScale { path, what, value });
    }
    let (value, path) = (law.share, Path::JointShare(index));
    let what = format!("the share of the contact `{name}`");
    if !value.is_finite() {
        errors.push(SceneError::NotFinite { path, what, value });
    } else if value <= 0.0 {
        let name = name.clone();
        errors.push(SceneError::ShareNotPositive { path, name, value });
    } else if !(SMALLEST..=LARGEST).contains(&value) {
        errors.push(SceneError::OutOfScale { path, what, value });
    }
    let what = format!("the speed of the contact `{name}`");
    stops::check_signed(law.speed, Path::JointSpeed(index), what, errors);
}

/// Reports errors in the dashpots. Returns true if the ends of all dashpots are valid.
fn check_dampers(scene: &Scene, errors: &mut Vec<SceneError>) -> bool {
    let mut sums: HashMap<(usize, usize), f64> = HashMap::new();
    let mut sound = true;
    for (index, damper) in scene.joints.dampers.iter().enumerate() {
        let before = errors.len();
        let (from, to) = (damper.from, damper.to);
        check_node(scene, from, Path::DamperFrom(index), errors);
        check_node(scene, to, Path::DamperTo(index), errors);
        let names = [from, to].map(|node| scene.node_name(node).to_owned());
        let [first, second] = names;
        let earlier = sums.get(&pair_of(from, to)).copied();
        if from == to {
            let path = Path::DamperTo(index);
            errors.push(SceneError::DamperToItself { path, name: first });
        } else if !is_mass(from) && !is_mass(to) {
            let path = Path::DamperFrom(index);
            errors.push(SceneError::DamperWithoutMass { path });
        } else if let Some(earlier) = earlier {
            errors.push(SceneError::ParallelDampers {
                path: Path::DamperFrom(index),
                from: first,
                to: second,
                sum: told(earlier + damper.coefficient, " of"),
            });
        }
        *sums.entry(pair_of(from, to)).or_insert(0.0) += damper.coefficient;
        sound &= errors.len() == before;
        let (value, path) = (damper.coefficient, Path::Damper(index));
        let [from, to] = [from, to].map(|node| scene.node_name(node).to_owned());
        let what = format!("the coefficient of `{from} - {to}`");
        if !value.is_finite() {
            errors.push(SceneError::NotFinite { path, what, value });
        } else if value <= 0.0 {
            errors.push(SceneError::DamperNotPositive {
                path,
                from,
                to,
                value,
            });
        } else if !(SMALLEST..=LARGEST).contains(&value) {
            errors.push(SceneError::OutOfScale { path, what, value });
        }
    }
    sound
}

/// Reports fields that are incompatible with several contacts or dashpots.
fn check_fields(scene: &Scene, errors: &mut Vec<SceneError>) {
    if !scene.joints.contacts.is_empty() {
        let fields = [
            (scene.stiction != 1.0, Path::Stiction, "stiction", "1.2"),
            (
                scene.stiffness.is_some(),
                Path::Stiffness,
                "stiffness",
                "5e4",
            ),
        ];
        for (given, path, field, example) in fields {
            if given {
                let (field, example) = (field.to_owned(), example.to_owned());
                errors.push(SceneError::LawOfEachContact {
                    path,
                    field,
                    example,
                });
            }
        }
    }
    let contacts = &scene.joints.contacts;
    let all_elastic = !contacts.is_empty()
        && contacts
            .iter()
            .all(|contact| contact.law.stiffness.is_some());
    if scene.friction != FrictionLaw::Coulomb && all_elastic {
        let path = Path::Friction(None);
        errors.push(SceneError::StribeckAllElastic { path });
    }
}

/// Reports rigid contacts that form a loop. The base and the wall count as one node.
fn check_loops(scene: &Scene, errors: &mut Vec<SceneError>) {
    let ground = scene.masses.len();
    let node = |node: Node| match node {
        Node::Mass(index) => index,
        Node::Base | Node::Wall => ground,
    };
    let mut tree: Vec<(usize, usize, usize)> = Vec::new();
    let contacts = scene.joints.contacts.iter().enumerate();
    for (index, contact) in contacts.filter(|(_, contact)| contact.law.stiffness.is_none()) {
        let (from, to) = (node(contact.sides.from), node(contact.sides.to));
        if let Some(others) = path(&tree, from, to) {
            let in_loop = scene.joints.contacts.iter().enumerate();
            let in_loop = in_loop.filter(|(other, _)| others.contains(other));
            let names: Vec<_> = in_loop
                .map(|(_, other)| format!("`{}`", other.name))
                .collect();
            errors.push(SceneError::RedundantContacts {
                path: Path::JointName(index),
                names: format!("{} and `{}`", names.join(", "), contact.name),
            });
            return;
        }
        tree.push((from, to, index));
    }
}

/// Returns the indices of the contacts on the path between two nodes, in a graph of contacts without loops. Returns
/// `None` if no path exists.
fn path(tree: &[(usize, usize, usize)], from: usize, to: usize) -> Option<Vec<usize>> {
    let mut reached: Vec<(usize, Vec<usize>)> = vec![(from, Vec::new())];
    let mut next = 0;
    while let Some((node, way)) = reached.get(next).cloned() {
        if node == to {
            return Some(way);
        }
        for (a, b, contact) in tree {
            let other = if *a == node {
                *b
            } else if *b == node {
                *a
            } else {
                continue;
            };
            if !reached.iter().any(|(node, _)| *node == other) {
                let mut way = way.clone();
                way.push(*contact);
                reached.push((other, way));
            }
        }
        next += 1;
    }
    None
}

/// Reports masses without any spring, contact, dashpot or stop, and a moving base that is connected to no mass.
fn check_touched(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    if !checks.contact {
        return;
    }
    let springs = scene.springs.iter().map(|spring| [spring.from, spring.to]);
    let dampers = scene.joints.dampers.iter();
    let dampers = dampers.map(|damper| [damper.from, damper.to]);
    let contacts = scene.named_contacts();
    let contacts = contacts.iter().map(|contact| contact.sides);
    let stops = scene.joints.stops.iter().map(|stop| stop.sides);
    let sides = contacts.chain(stops).map(|sides| [sides.from, sides.to]);
    let touched: Vec<Node> = springs.chain(dampers).chain(sides).flatten().collect();
    for (index, mass) in scene.masses.iter().enumerate() {
        if !touched.contains(&Node::Mass(index)) {
            errors.push(SceneError::Untouched {
                path: Path::MassName(index),
                name: mass.name.clone(),
            });
        }
    }
    let moves = checks.excitation && scene.excitation == Excitation::Base;
    if moves && !touched.contains(&Node::Base) {
        let path = Path::Excitation;
        errors.push(SceneError::IdleJoinedBase { path });
    }
}

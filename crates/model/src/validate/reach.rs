//! Checks on the graph of springs: each mass needs a support, and a chain of springs must connect the load to the
//! contact.
//!
//! A support transmits no motion, so the supports divide the graph of springs into components. A component is a set
//! of masses that springs connect without a support between them.

use std::collections::{BTreeMap, HashSet};

use super::checks::Checks;
use super::error::SceneError;
use super::names::may_name;
use super::path::Path;
use crate::scene::{ContactSides, Excitation, Node, Scene};

/// Reports masses without a support, and a contact that can never slide.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    if !checks.springs || scene.springs.is_empty() || scene.masses.is_empty() {
        return;
    }
    let parts = Parts::new(scene);
    let held = check_held(scene, checks, &parts, errors);
    if held && checks.excitation && checks.contact && is_sound(scene) {
        check_slides(scene, &parts, errors);
    }
}

/// The component of the spring graph to which each mass belongs. A component has the smallest index of its masses as
/// its number.
struct Parts(Vec<usize>);

impl Parts {
    fn new(scene: &Scene) -> Self {
        let mut parent: Vec<usize> = (0..scene.masses.len()).collect();
        for spring in &scene.springs {
            if let (Node::Mass(from), Node::Mass(to)) = (spring.from, spring.to) {
                let (from, to) = (root(&mut parent, from), root(&mut parent, to));
                if let Some(above) = parent.get_mut(from.max(to)) {
                    *above = from.min(to);
                }
            }
        }
        for mass in 0..parent.len() {
            root(&mut parent, mass);
        }
        Self(parent)
    }

    fn of(&self, mass: usize) -> usize {
        self.0.get(mass).copied().unwrap_or(mass)
    }
}

/// Returns the smallest mass index in the component of `mass`. Path compression makes the search fast for long chains.
fn root(parent: &mut [usize], mass: usize) -> usize {
    let mut top = mass;
    while let Some(&above) = parent.get(top)
        && above != top
    {
        top = above;
    }
    let mut next = mass;
    while let Some(above) = parent.get_mut(next)
        && *above != top
    {
        next = core::mem::replace(above, top);
    }
    top
}

/// Returns the components of the spring graph that have a spring to a support. `support` is true for the nodes that
/// count as supports.
fn joined(scene: &Scene, parts: &Parts, support: impl Fn(Node) -> bool) -> HashSet<usize> {
    scene
        .springs
        .iter()
        .filter_map(|spring| match (spring.from, spring.to) {
            (Node::Mass(mass), other) | (other, Node::Mass(mass)) if support(other) => {
                Some(parts.of(mass))
            }
            _ => None,
        })
        .collect()
}

/// Returns true if contact and excitation are valid. If they are not, the error "never slides" would only repeat an
/// error that is already reported.
fn is_sound(scene: &Scene) -> bool {
    let exists = |node| !matches!(node, Node::Mass(index) if index >= scene.masses.len());
    let (from, to) = (scene.contact.from, scene.contact.to);
    let is_mass = |node| matches!(node, Node::Mass(_));
    let driven = match scene.excitation {
        Excitation::Force(mass) => Node::Mass(mass),
        Excitation::Base => Node::Base,
    };
    from != to && (is_mass(from) || is_mass(to)) && [from, to, driven].into_iter().all(exists)
}

/// Reports every component without a support. Returns true if every component has a support and all names are valid.
fn check_held(scene: &Scene, checks: &Checks, parts: &Parts, errors: &mut Vec<SceneError>) -> bool {
    let held = joined(scene, parts, |node| !matches!(node, Node::Mass(_)));
    let mut floating: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    let mut names = HashSet::new();
    let mut sound = true;
    for (index, mass) in scene.masses.iter().enumerate() {
        let part = parts.of(index);
        if !may_name(&mass.name, checks.emitted) || !names.insert(mass.name.as_str()) {
            // No spring can name a mass whose name is invalid. The code therefore reports only the invalid name, not
            // the missing support.
            sound = false;
        } else if !held.contains(&part) {
            floating.entry(part).or_default().push(mass.name.clone());
        }
    }
    sound &= floating.is_empty();
    let ContactSides { from, to } = scene.contact;
    let contact = format!(
        "contact: {} - {}",
        scene.node_name(from),
        scene.node_name(to)
    );
    for (part, mut names) in floating {
        let path = Path::MassName(part);
        let (name, contact) = (names.remove(0), contact.clone());
        errors.push(if names.is_empty() {
            SceneError::NotHeld {
                path,
                name,
                contact,
            }
        } else {
            let shown: Vec<_> = names
                .iter()
                .take(8)
                .map(|name| format!("`{name}`"))
                .collect();
            let more = if names.len() > shown.len() {
                ", …"
            } else {
                ""
            };
            SceneError::GroupNotHeld {
                path,
                name,
                others: shown.join(", ") + more,
                contact,
            }
        });
    }
    sound
}

fn check_slides(scene: &Scene, parts: &Parts, errors: &mut Vec<SceneError>) {
    let (from, to) = (scene.contact.from, scene.contact.to);
    let driven = match scene.excitation {
        Excitation::Force(mass) => HashSet::from([parts.of(mass)]),
        // The base is one side of the contact, so the load reaches the contact without springs.
        Excitation::Base if from == Node::Base || to == Node::Base => return,
        Excitation::Base => {
            let driven = joined(scene, parts, |node| node == Node::Base);
            if driven.is_empty() {
                errors.push(SceneError::IdleBase {
                    path: Path::Excitation,
                });
                return;
            }
            driven
        }
    };
    let moves = |node| matches!(node, Node::Mass(mass) if driven.contains(&parts.of(mass)));
    if moves(from) || moves(to) {
        return;
    }
    let load = match scene.excitation {
        Excitation::Force(mass) => {
            format!(
                "the mass `{}`, where the force acts,",
                scene.node_name(Node::Mass(mass))
            )
        }
        Excitation::Base => "the moving base".to_owned(),
    };
    errors.push(SceneError::NeverSlides {
        path: Path::Contact,
        load,
        contact: format!("{} - {}", scene.node_name(from), scene.node_name(to)),
    });
}

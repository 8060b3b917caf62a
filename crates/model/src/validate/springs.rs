//! Checks of each spring: its two ends and its stiffness.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use super::checks::{Checks, LARGEST, SMALLEST, check_node};
use super::error::SceneError;
use super::path::Path;
use crate::scene::{Node, Scene, Spring};

/// Reports errors in the ends and the stiffnesses of the springs.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    if scene.springs.is_empty() && checks.springs && !checks.joined(scene) {
        errors.push(SceneError::NoSprings {
            path: Path::Springs,
        });
    }
    let sums = sums(&scene.springs);
    let mut first = HashMap::new();
    for (index, spring) in scene.springs.iter().enumerate() {
        check_node(scene, spring.from, Path::SpringFrom(index), errors);
        check_node(scene, spring.to, Path::SpringTo(index), errors);
        let from = scene.node_name(spring.from).to_owned();
        let to = scene.node_name(spring.to).to_owned();
        let sound = if spring.from == spring.to {
            errors.push(SceneError::SpringToItself {
                path: Path::SpringTo(index),
                name: to.clone(),
            });
            false
        } else if !matches!(spring.from, Node::Mass(_)) && !matches!(spring.to, Node::Mass(_)) {
            errors.push(SceneError::SpringWithoutMass {
                path: Path::SpringFrom(index),
            });
            false
        } else {
            true
        };
        if sound {
            match first.entry(pair(spring)) {
                Entry::Vacant(vacant) => {
                    vacant.insert(index);
                }
                Entry::Occupied(earlier) => {
                    // The message omits the total stiffness if one of the stiffnesses could not be read.
                    let total = sums.get(earlier.key()).filter(|total| total.is_finite());
                    errors.push(SceneError::ParallelSprings {
                        path: Path::SpringFrom(index),
                        from: from.clone(),
                        to: to.clone(),
                        sum: total.map_or_else(String::new, |total| format!(" of {total:?}")),
                    });
                }
            }
        }

        let (path, value) = (Path::Spring(index), spring.stiffness);
        let what = || format!("the stiffness of `{from} - {to}`");
        if !value.is_finite() {
            errors.push(SceneError::NotFinite {
                path,
                what: what(),
                value,
            });
        } else if value <= 0.0 {
            errors.push(SceneError::StiffnessNotPositive {
                path,
                from,
                to,
                value,
            });
        } else if !(SMALLEST..=LARGEST).contains(&value) {
            errors.push(SceneError::OutOfScale {
                path,
                what: what(),
                value,
            });
        }
    }
}

/// Returns the total stiffness of the springs between each pair of nodes. If two springs join the same nodes, the
/// message recommends one spring with this stiffness.
fn sums(springs: &[Spring]) -> HashMap<(usize, usize), f64> {
    let mut sums = HashMap::new();
    for spring in springs {
        *sums.entry(pair(spring)).or_insert(0.0) += spring.stiffness;
    }
    sums
}

fn pair(spring: &Spring) -> (usize, usize) {
    pair_of(spring.from, spring.to)
}

/// Returns two nodes in ascending order, so that `a - b` and `b - a` give the same pair.
pub(super) fn pair_of(from: Node, to: Node) -> (usize, usize) {
    let key = |node| match node {
        Node::Mass(index) => index,
        Node::Base => usize::MAX - 1,
        Node::Wall => usize::MAX,
    };
    let (from, to) = (key(from), key(to));
    (from.min(to), from.max(to))
}

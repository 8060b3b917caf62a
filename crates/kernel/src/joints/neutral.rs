//! Counts the motions of a chain that change no force.

use super::model::Model;
use super::size::Size;
use crate::Float;

/// Returns the number of independent motions that change no force. `keeps` returns true for a contact that keeps its
/// position. One such motion is a displacement of a part of the chain that neither a spring nor such a contact keeps
/// in position. A constant velocity of a part without any connection to a support is also such a motion.
pub(super) fn neutral<S: Float, Z: Size>(
    model: &Model<S, Z>,
    keeps: impl Fn(usize) -> bool,
) -> usize {
    let mut parts = model.size.nodes(0);
    for (node, part) in parts.as_mut().iter_mut().enumerate() {
        *part = node;
    }
    for &(plus, minus, _) in model.springs.as_ref() {
        join(parts.as_mut(), (plus, minus));
    }
    let contacts = || model.contacts().iter().enumerate();
    let contacts = || contacts().filter(|(_, contact)| contact.has_friction());
    for (_, contact) in contacts().filter(|(j, _)| keeps(*j)) {
        join(parts.as_mut(), (contact.plus, contact.minus));
    }
    let places = roots(model, parts.as_ref()).count();
    for &(plus, minus, _) in model.dashpots.as_ref() {
        join(parts.as_mut(), (plus, minus));
    }
    for (_, contact) in contacts() {
        join(parts.as_mut(), (contact.plus, contact.minus));
    }
    let all = parts.as_ref();
    let moving = roots(model, all).filter(|root| !is_damped(model, all, *root));
    places + moving.count()
}

/// Joins the parts of a chain to which two nodes belong. The number of a part is the largest index of its nodes. The
/// wall and the base have the largest indices. The number therefore shows whether the part contains a support.
fn join(parts: &mut [usize], (plus, minus): (usize, usize)) {
    let of = |node: usize| parts.get(node).copied().unwrap_or(node);
    let (one, other) = (of(plus), of(minus));
    let (from, to) = (one.min(other), one.max(other));
    for part in parts.iter_mut().filter(|part| **part == from) {
        *part = to;
    }
}

/// Returns the numbers of all parts of the chain that contain neither the wall nor the base.
fn roots<S: Float, Z: Size>(model: &Model<S, Z>, parts: &[usize]) -> impl Iterator<Item = usize> {
    (0..model.wall()).filter(move |root| parts.contains(root))
}

/// Returns true if the damping matrix gives a force when all nodes of a part of the chain move with the same velocity.
fn is_damped<S: Float, Z: Size>(model: &Model<S, Z>, parts: &[usize], root: usize) -> bool {
    let belongs = |node: usize| parts.get(node) == Some(&root);
    let small = S::constant(if S::EPSILON < 1e-10 { 1e-9 } else { 1e-4 });
    let rows = model.damping_rows().enumerate();
    let mut rows = rows.filter(|(row, _)| belongs(*row));
    rows.any(|(_, row)| {
        let (mut sum, mut size) = (S::constant(0.0), S::constant(0.0));
        for (column, entry) in row.iter().enumerate() {
            size = size + entry.abs();
            if belongs(column) {
                sum = sum + *entry;
            }
        }
        sum.abs() > small * size
    })
}

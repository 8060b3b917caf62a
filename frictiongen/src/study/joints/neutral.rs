//! Counts the motions of a chain that no force resists.

use super::Model;
use frictiongen_kernel::joints::at;

/// Returns the number of independent motions that change no force. These are displacements of parts that neither a
/// spring nor a contact holds in position, and constant velocities of parts without any connection to a support.
pub fn neutral(model: &Model, keeps: impl Fn(usize) -> bool) -> usize {
    let springs = model.springs.iter().map(|&(plus, minus, _)| (plus, minus));
    let contacts = |keeps: &dyn Fn(usize) -> bool| -> Vec<(usize, usize)> {
        let contacts = model.contacts.iter().enumerate();
        let kept = contacts.filter(|(j, contact)| !contact.is_free() && keeps(*j));
        kept.map(|(_, contact)| (contact.plus, contact.minus))
            .collect()
    };
    let held: Vec<_> = springs.chain(contacts(&keeps)).collect();
    let dashpots = model.dashpots.iter().map(|&(plus, minus, _)| (plus, minus));
    let all = held.iter().copied().chain(dashpots);
    let all: Vec<_> = all.chain(contacts(&|_| true)).collect();
    let damped = |part: &Vec<usize>| {
        let rows = model.damping_rows().enumerate();
        let mut rows = rows.filter(|(row, _)| part.contains(row));
        rows.any(|(_, row)| {
            let sum: f64 = part.iter().map(|&node| at(row, node)).sum();
            let size: f64 = row.iter().map(|c| c.abs()).sum();
            sum.abs() > 1e-9 * size
        })
    };
    let moving = floating(model, &all);
    floating(model, &held).len() + moving.iter().filter(|part| !damped(part)).count()
}

/// Returns the masses of each connected part of a graph that contains no support.
fn floating(model: &Model, links: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let mut part: Vec<usize> = (0..model.masses.len() + 2).collect();
    for &(plus, minus) in links {
        let of = |node: usize| part.get(node).copied().unwrap_or(node);
        let (one, other) = (of(plus), of(minus));
        // The supports have the largest numbers.
        let (from, to) = (one.min(other), one.max(other));
        for part in part.iter_mut().filter(|part| **part == from) {
            *part = to;
        }
    }
    let parts = (0..model.masses.len()).map(|root| {
        let nodes = part.iter().enumerate();
        let nodes = nodes.filter(|(_, of)| **of == root).map(|(node, _)| node);
        nodes.collect::<Vec<usize>>()
    });
    parts.filter(|part| !part.is_empty()).collect()
}

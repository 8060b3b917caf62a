//! Prints several alternative formulas, for example one for each mass, of which the emitted code evaluates one. The
//! emitted code first computes the operations that all alternatives share.

use super::count::OperationCount;
use super::print::{Printed, Printer};
use super::{Graph, Id, Operand, Recorded, operands};
use frictiongen_model::scene::Precision;
use proc_macro2::TokenStream;
use std::collections::BTreeSet;

/// One of several alternative formulas: its operations, each with the name of its value, and its outputs.
pub struct Alternative {
    nodes: Vec<Recorded>,
    outputs: Vec<Operand>,
}

impl Alternative {
    /// Takes the operations on which `outputs` depend, and then clears all names in the graph. The formula of the next
    /// alternative gives new names, because a shared operation may have another meaning in the next alternative.
    #[must_use]
    pub fn of(graph: &Graph, outputs: Vec<Operand>) -> Self {
        let nodes = graph.reachable(&outputs);
        graph.unname();
        Self { nodes, outputs }
    }

    fn has(&self, (id, _, name): &Recorded) -> bool {
        let place = self.nodes.binary_search_by_key(id, |(id, ..)| *id);
        let node = place.ok().and_then(|place| self.nodes.get(place));
        matches!(node, Some((_, _, same)) if same == name)
    }
}

/// Returns the number of operations of the alternative that has the most.
#[must_use]
pub fn most_operations(graph: &Graph, alternatives: &[Alternative]) -> OperationCount {
    let counts = alternatives
        .iter()
        .map(|alternative| OperationCount::of(graph, &alternative.outputs));
    counts.max_by_key(OperationCount::total).unwrap_or_default()
}

/// Puts equal alternatives into one group. Each alternative in `all` has a key. Returns the keys of each group, and
/// the alternative that the group shares.
pub fn grouped<T>(all: impl Iterator<Item = (T, Alternative)>) -> (Vec<Vec<T>>, Vec<Alternative>) {
    let (mut groups, mut alternatives): (Vec<Vec<T>>, Vec<Alternative>) = (Vec::new(), Vec::new());
    for (of, alternative) in all {
        let mut known = groups.iter_mut().zip(&alternatives);
        let same = known.find(|(_, known)| known.outputs == alternative.outputs);
        if let Some((group, _)) = same {
            group.push(of);
        } else {
            groups.push(vec![of]);
            alternatives.push(alternative);
        }
    }
    (groups, alternatives)
}

/// Prints alternatives as Rust code. The first result has the statements that all alternatives share. The second has
/// the remaining statements and the outputs of each alternative.
#[must_use]
pub fn print(
    alternatives: &[Alternative],
    precision: Precision,
    taken: &[&str],
) -> (TokenStream, Vec<Printed>) {
    let mut printer = Printer::new(precision, taken);
    let common = common(alternatives);
    let ids: BTreeSet<Id> = common.iter().map(|(id, ..)| *id).collect();
    // An operation that all alternatives share gets a name only if an output, or an operation that is not shared, uses
    // it directly.
    let mut border = BTreeSet::new();
    for Alternative { nodes, outputs } in alternatives {
        let rest = nodes.iter().filter(|(id, ..)| !ids.contains(id));
        border.extend(rest.flat_map(|(_, node, _)| operands(node)));
        border.extend(outputs.iter().filter_map(super::operand_id));
    }
    let bound: Vec<Operand> = border
        .intersection(&ids)
        .map(|id| Operand::Node(*id))
        .collect();
    printer.visit_all(&common, &bound, 2);
    let statements = printer.statements();
    let alternatives = alternatives.iter().map(|Alternative { nodes, outputs }| {
        let mut printer = printer.clone();
        printer.visit_all(nodes, outputs, 1);
        printer.printed(outputs)
    });
    (statements, alternatives.collect())
}

/// Returns the operations that all alternatives need under the same name. The list is empty if only one alternative
/// exists.
fn common(alternatives: &[Alternative]) -> Vec<Recorded> {
    let [first, others @ ..] = alternatives else {
        return Vec::new();
    };
    if others.is_empty() {
        return Vec::new();
    }
    let mut common: Vec<Recorded> = Vec::new();
    let mut ids = BTreeSet::new();
    // Operands come before the operations that use them, so one pass finds all common operations.
    for node in &first.nodes {
        let whole = operands(&node.1).iter().all(|id| ids.contains(id));
        if whole && others.iter().all(|other| other.has(node)) {
            ids.insert(node.0);
            common.push(node.clone());
        }
    }
    common
}

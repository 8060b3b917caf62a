//! Masses that rigid contacts join while they stick. Such contacts never close a loop, so they make trees.

use super::model::{Contact, Model};
use super::size::{Size, add, at, set};
use crate::Float;

/// Root of a node that the construction has not reached yet.
const NONE: usize = usize::MAX;

/// A contact of a tree, from the side of the node that is farther from the root.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Branch {
    child: usize,
    parent: usize,
    contact: usize,
    /// True if the child counts positive in z.
    child_is_plus: bool,
}

impl Branch {
    fn turned<S: Float>(&self, value: S) -> S {
        if self.child_is_plus { value } else { -value }
    }
}

/// The trees of one pattern of sticking contacts.
#[derive(Clone, Debug)]
pub struct Tree<S: Float, Z: Size> {
    /// Branches, those near a root first, then unused entries.
    branches: Z::Contacts<Branch>,
    /// Number of branches.
    count: usize,
    /// Root of each node.
    roots: Z::Nodes<usize>,
    /// Mass of each tree, at its root.
    masses: Z::Nodes<S>,
}

impl<S: Float, Z: Size> Tree<S, Z> {
    /// Joins the masses of the contacts that stick. A support is always a root.
    pub fn new(model: &Model<S, Z>, sticks: impl Fn(usize) -> bool) -> Self {
        let unused = Branch {
            child: NONE,
            parent: NONE,
            contact: NONE,
            child_is_plus: false,
        };
        let mut tree = Self {
            branches: model.size.contacts(unused),
            count: 0,
            roots: model.size.nodes(NONE),
            masses: model.size.nodes(S::constant(0.0)),
        };
        let supports = [model.base_node(), model.wall()];
        for root in supports.into_iter().chain(0..model.wall()) {
            tree.grow(model, &sticks, root);
        }
        tree
    }

    /// Visits everything that hangs on a root. The branches of this root are the queue of the nodes to visit.
    fn grow(&mut self, model: &Model<S, Z>, sticks: &impl Fn(usize) -> bool, root: usize) {
        if self.root_of(root) != NONE {
            return;
        }
        let mut next = self.count;
        let mut node = root;
        loop {
            set(self.roots.as_mut(), node, root);
            add(self.masses.as_mut(), root, at(model.masses(), node));
            for (j, contact) in model.contacts().iter().enumerate() {
                if sticks(j) && contact.is_rigid() {
                    self.hang(j, contact, node);
                }
            }
            let Some(branch) = self.branches().get(next) else {
                return;
            };
            node = branch.child;
            next += 1;
        }
    }

    /// Adds the branch of a contact at a node, if the other end is new.
    fn hang(&mut self, index: usize, contact: &Contact<S>, node: usize) {
        let (child, child_is_plus) = match node {
            node if node == contact.plus => (contact.minus, false),
            node if node == contact.minus => (contact.plus, true),
            _ => return,
        };
        if self.root_of(child) != NONE {
            return;
        }
        let branch = Branch {
            child,
            parent: node,
            contact: index,
            child_is_plus,
        };
        set(self.branches.as_mut(), self.count, branch);
        self.count += 1;
    }

    fn branches(&self) -> &[Branch] {
        let branches = self.branches.as_ref();
        branches.get(..self.count).unwrap_or(branches)
    }

    fn root_of(&self, node: usize) -> usize {
        self.roots.as_ref().get(node).copied().unwrap_or(node)
    }

    /// Returns the root of a node.
    pub fn root(&self, node: usize) -> usize {
        self.root_of(node)
    }

    /// Returns the mass of the tree of a root.
    pub fn mass(&self, root: usize) -> S {
        at(self.masses.as_ref(), root)
    }

    /// Sets the displacements of all nodes from those of the roots, and makes velocities in a tree equal to the root's.
    pub fn place(&self, x: &mut [S], v: &mut [S], places: &[S]) {
        for branch in self.branches() {
            let (place, speed) = (at(x, branch.parent), at(v, branch.parent));
            let place = place + branch.turned(at(places, branch.contact));
            set(x, branch.child, place);
            set(v, branch.child, speed);
        }
    }

    /// Gives every tree without a support the velocity that keeps its momentum.
    pub fn meet(&self, model: &Model<S, Z>, v: &mut [S]) {
        let mut moments = model.size.nodes(S::constant(0.0));
        let mut differ = model.size.nodes(false);
        for (node, &root) in self.roots.as_ref().iter().enumerate() {
            let moment = at(model.masses(), node) * at(v, node);
            add(moments.as_mut(), root, moment);
            if at(v, node) != at(v, root) {
                set(differ.as_mut(), root, true);
            }
        }
        for root in 0..model.wall() {
            if differ.as_ref().get(root) == Some(&true) {
                let moment = at(moments.as_ref(), root);
                set(v, root, moment / self.mass(root));
            }
        }
        for branch in self.branches() {
            let speed = at(v, branch.parent);
            set(v, branch.child, speed);
        }
    }

    /// Returns the accelerations of all nodes, and adds the forces of the contacts that stick to `holds`, by contact.
    pub fn accelerate(
        &self,
        model: &Model<S, Z>,
        forces: &[S],
        base: S,
        holds: &mut [S],
    ) -> Z::Nodes<S> {
        let mut total = model.size.nodes(S::constant(0.0));
        for (force, &root) in forces.iter().zip(self.roots.as_ref()) {
            add(total.as_mut(), root, *force);
        }
        let of_root = |root: usize| match root {
            root if root < model.wall() => at(total.as_ref(), root) / self.mass(root),
            root if root == model.wall() => S::constant(0.0),
            _ => base,
        };
        let mut accelerations = model.size.nodes(S::constant(0.0));
        let mut rest = model.size.nodes(S::constant(0.0));
        let nodes = accelerations.as_mut().iter_mut().zip(rest.as_mut());
        for (node, (acceleration, rest)) in nodes.enumerate() {
            *acceleration = of_root(self.root_of(node));
            *rest = at(forces, node) - at(model.masses(), node) * *acceleration;
        }
        for branch in self.branches().iter().rev() {
            let held = at(rest.as_ref(), branch.child);
            set(holds, branch.contact, branch.turned(held));
            add(rest.as_mut(), branch.parent, held);
        }
        accelerations
    }
}

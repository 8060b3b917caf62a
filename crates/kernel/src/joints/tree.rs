//! Groups of masses that sticking rigid contacts connect, so that the masses of a group move together. These contacts
//! never form a loop. Each group is therefore a tree.

use super::model::{Contact, Model};
use super::size::{Size, add, at, set};
use super::state::{STUCK, State};
use crate::Float;

/// Mark for a node that does not belong to a tree yet.
pub(super) const NONE: usize = usize::MAX;

/// A contact in a tree. It connects a node (child) to its neighbour on the way to the root (parent).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Branch {
    child: usize,
    parent: usize,
    contact: usize,
    /// True if the child is the node `plus` of the contact.
    child_is_plus: bool,
}

/// Entry of the list of branches that no contact uses yet.
pub(super) const UNUSED: Branch = Branch {
    child: NONE,
    parent: NONE,
    contact: NONE,
    child_is_plus: false,
};

impl Branch {
    fn turned<S: Float>(&self, value: S) -> S {
        if self.child_is_plus { value } else { -value }
    }
}

/// Trees of the masses that sticking rigid contacts connect, for one set of sticking contacts.
#[derive(Clone, Debug)]
pub struct Tree<S: Float, Z: Size> {
    /// True for each contact that sticks.
    stuck: Z::Contacts<bool>,
    /// Contacts of all trees. In the list, a contact comes after all contacts between it and the root. Unused entries
    /// are at the end.
    branches: Z::Contacts<Branch>,
    /// Number of contacts that belong to the trees.
    count: usize,
    /// For each node, the root of the tree that contains the node.
    roots: Z::Nodes<usize>,
    /// Total mass of each tree, at the index of the tree's root.
    masses: Z::Nodes<S>,
}

impl<S: Float, Z: Size> Tree<S, Z> {
    /// Returns no trees, from one [`UNUSED`] and one `false` for each contact, and one [`NONE`] and one 0 for each node.
    pub(super) const fn empty(
        branches: Z::Contacts<Branch>,
        stuck: Z::Contacts<bool>,
        roots: Z::Nodes<usize>,
        masses: Z::Nodes<S>,
    ) -> Self {
        Self {
            stuck,
            branches,
            count: 0,
            roots,
            masses,
        }
    }

    /// Builds the trees of the masses that sticking rigid contacts connect. If a tree contains the wall or the base,
    /// this support is its root.
    pub fn new(model: &Model<S, Z>, sticks: impl Fn(usize) -> bool) -> Self {
        let mut tree = Self::empty(
            model.size.contacts(UNUSED),
            model.size.contacts(false),
            model.size.nodes(NONE),
            model.size.nodes(S::constant(0.0)),
        );
        for (j, stuck) in tree.stuck.as_mut().iter_mut().enumerate() {
            *stuck = sticks(j);
        }
        let supports = [model.base_node(), model.wall()];
        for root in supports.into_iter().chain(0..model.wall()) {
            tree.grow(model, &sticks, root);
        }
        tree
    }

    /// Returns true if the trees are those of the sticking contacts of a state.
    pub(super) fn is_of(&self, state: &State<S, Z>) -> bool {
        let is_built = self.roots.as_ref().first() != Some(&NONE);
        let mut contacts = self.stuck.as_ref().iter().enumerate();
        is_built && contacts.all(|(j, stuck)| *stuck == (state.phase(j) == STUCK))
    }

    /// Builds the tree of all nodes that sticking contacts connect to the node `root`. The list of contacts also serves
    /// as the queue of nodes to visit.
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

    /// Adds a contact to the tree of a node, unless the other node of the contact already belongs to a tree.
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

    /// Returns true if no sticking contact connects two nodes.
    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    fn branches(&self) -> &[Branch] {
        let branches = self.branches.as_ref();
        branches.get(..self.count).unwrap_or(branches)
    }

    fn root_of(&self, node: usize) -> usize {
        self.roots.as_ref().get(node).copied().unwrap_or(node)
    }

    /// Returns the root of the tree that contains a node.
    pub fn root(&self, node: usize) -> usize {
        self.root_of(node)
    }

    /// Returns true if the relative displacement of a contact is constant, because sticking rigid contacts connect its
    /// two nodes. A moving surface may change it.
    pub(super) fn connects(&self, contact: &Contact<S>) -> bool {
        self.root_of(contact.plus) == self.root_of(contact.minus)
    }

    /// Returns the total mass of the tree with the root `root`.
    pub fn mass(&self, root: usize) -> S {
        at(self.masses.as_ref(), root)
    }

    /// Adds the velocities of moving surfaces to those of the nodes, which are equal within each tree. `factor` is 1, or
    /// −1 to subtract them again.
    fn carry(&self, model: &Model<S, Z>, v: &mut [S], factor: S) {
        let mut carried = model.size.nodes(S::constant(0.0));
        for branch in self.branches() {
            let own = branch.turned(factor * model.speed(branch.contact));
            let speed = at(carried.as_ref(), branch.parent) + own;
            set(carried.as_mut(), branch.child, speed);
            add(v, branch.child, speed);
        }
    }

    /// Places all nodes as [`place`](Self::place) does, for a motion in which surfaces of contacts may move.
    pub(super) fn place_moving(
        &self,
        model: &Model<S, Z>,
        (x, v): (&mut [S], &mut [S]),
        places: &[S],
    ) {
        self.place(x, v, places);
        if model.has_belts() {
            self.carry(model, v, S::constant(1.0));
        }
    }

    /// Gives the nodes of each tree common velocities as [`meet`](Self::meet) does, for a motion in which surfaces of
    /// contacts may move.
    pub(super) fn meet_moving(&self, model: &Model<S, Z>, v: &mut [S]) {
        let moves = model.has_belts();
        if moves {
            self.carry(model, v, S::constant(-1.0));
        }
        self.meet(model, v);
        if moves {
            self.carry(model, v, S::constant(1.0));
        }
    }

    /// Computes the displacements of all nodes from those of the roots and from `places`, the relative displacements
    /// of the contacts. Gives all nodes of a tree the velocity of its root.
    pub fn place(&self, x: &mut [S], v: &mut [S], places: &[S]) {
        for branch in self.branches() {
            let (place, speed) = (at(x, branch.parent), at(v, branch.parent));
            let place = place + branch.turned(at(places, branch.contact));
            set(x, branch.child, place);
            set(v, branch.child, speed);
        }
    }

    /// Makes the displacements and velocities in a state exactly those of masses that move together.
    pub(super) fn settle(&self, model: &Model<S, Z>, state: &mut State<S, Z>, time: S) {
        if self.count == 0 {
            return;
        }
        let (mut x, mut v) = state.nodes(model, time);
        self.place_moving(model, (x.as_mut(), v.as_mut()), state.places.as_ref());
        state.keep_places(x.as_ref());
        state.keep_speeds(v.as_ref());
    }

    /// Gives all nodes of a tree the same velocity, so that the momentum of the tree does not change. All nodes of a
    /// tree with a support get the velocity of the support.
    pub fn meet(&self, model: &Model<S, Z>, v: &mut [S]) {
        let mut moments = model.size.nodes(S::constant(0.0));
        let mut differ = model.size.nodes(false);
        for (node, &root) in self.roots.as_ref().iter().enumerate() {
            let moment = at(model.masses(), node) * at(v, node);
            add(moments.as_mut(), root, moment);
            // The difference of dual numbers of the same value may have a derivative.
            if !(at(v, node) - at(v, root)).vanishes() {
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

    /// Returns the acceleration of each node. `forces` contains the force on each node, and `base` is the acceleration
    /// of the base. Writes the force of each sticking contact to `holds`.
    pub fn accelerate(
        &self,
        model: &Model<S, Z>,
        forces: &[S],
        base: S,
        holds: &mut [S],
    ) -> Z::Nodes<S> {
        let mut accelerations = model.size.nodes(S::constant(0.0));
        let mut rest = model.size.nodes(S::constant(0.0));
        let results = (accelerations.as_mut(), holds);
        self.accelerate_in(model, (forces, base), rest.as_mut(), results);
        accelerations
    }

    /// Computes the acceleration of each node and the force of each sticking contact, as
    /// [`accelerate`](Self::accelerate) does. The function needs no new arrays, because `rest` is working memory.
    pub(super) fn accelerate_in(
        &self,
        model: &Model<S, Z>,
        (forces, base): (&[S], S),
        rest: &mut [S],
        (accelerations, holds): (&mut [S], &mut [S]),
    ) {
        if self.count == 0 {
            // No contact sticks, so that every mass moves alone.
            let supports = [S::constant(0.0), base];
            let alone = forces
                .iter()
                .zip(model.masses())
                .map(|(force, mass)| *force / *mass);
            for (acceleration, own) in accelerations.iter_mut().zip(alone.chain(supports)) {
                *acceleration = own;
            }
            return;
        }
        // `rest` receives the total force on each tree at the index of its root.
        rest.fill(S::constant(0.0));
        for (force, &root) in forces.iter().zip(self.roots.as_ref()) {
            add(rest, root, *force);
        }
        for (node, acceleration) in accelerations.iter_mut().enumerate() {
            *acceleration = match self.root_of(node) {
                root if root < model.wall() => at(rest, root) / self.mass(root),
                root if root == model.wall() => S::constant(0.0),
                _ => base,
            };
        }
        for (node, (acceleration, rest)) in accelerations.iter().zip(rest.iter_mut()).enumerate() {
            *rest = at(forces, node) - at(model.masses(), node) * *acceleration;
        }
        for branch in self.branches().iter().rev() {
            let held = at(rest, branch.child);
            set(holds, branch.contact, branch.turned(held));
            add(rest, branch.parent, held);
        }
    }
}

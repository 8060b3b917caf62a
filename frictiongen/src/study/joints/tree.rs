//! Masses that rigid contacts join while they stick. Such contacts never close a loop, so they make trees.

use super::model::{Model, add, at};

/// A contact of a tree, from the side of the node that is farther from the root.
#[derive(Clone, Copy, Debug)]
struct Branch {
    child: usize,
    parent: usize,
    contact: usize,
    /// 1 if the child counts positive in z, otherwise −1.
    sign: f64,
}

/// The trees of one pattern of sticking contacts.
#[derive(Clone, Debug)]
pub struct Tree {
    /// Branches, those near a root first.
    branches: Vec<Branch>,
    /// Root of each node.
    roots: Vec<usize>,
    /// Mass of each tree, at its root.
    masses: Vec<f64>,
}

impl Tree {
    /// Joins the masses of the contacts that stick. A support is always a root.
    pub fn new(model: &Model, sticks: impl Fn(usize) -> bool) -> Self {
        let nodes = model.masses.len() + 2;
        let mut edges = vec![Vec::new(); nodes];
        for (contact, c) in model.contacts.iter().enumerate() {
            if sticks(contact) && c.is_rigid() {
                let ends = [(c.plus, c.minus, -1.0), (c.minus, c.plus, 1.0)];
                for (parent, child, sign) in ends {
                    if let Some(edges) = edges.get_mut(parent) {
                        edges.push(Branch {
                            child,
                            parent,
                            contact,
                            sign,
                        });
                    }
                }
            }
        }
        let mut tree = Self {
            branches: Vec::new(),
            roots: vec![usize::MAX; nodes],
            masses: vec![0.0; nodes],
        };
        for root in [model.base_node(), model.wall()]
            .into_iter()
            .chain(0..model.masses.len())
        {
            tree.grow(model, &edges, root);
        }
        tree
    }

    /// Visits everything that hangs on a root.
    fn grow(&mut self, model: &Model, edges: &[Vec<Branch>], root: usize) {
        if self.roots.get(root).is_none_or(|&of| of != usize::MAX) {
            return;
        }
        let mut waiting = std::collections::VecDeque::from([root]);
        while let Some(node) = waiting.pop_front() {
            if let Some(of) = self.roots.get_mut(node) {
                *of = root;
            }
            add(&mut self.masses, root, at(&model.masses, node));
            for branch in edges.get(node).into_iter().flatten() {
                let new = self.roots.get(branch.child) == Some(&usize::MAX);
                if new {
                    self.branches.push(*branch);
                    waiting.push_back(branch.child);
                }
            }
        }
    }

    /// Returns the root of a node.
    pub fn root(&self, node: usize) -> usize {
        self.roots.get(node).copied().unwrap_or(node)
    }

    /// Returns the mass of the tree of a root.
    pub fn mass(&self, root: usize) -> f64 {
        at(&self.masses, root)
    }

    /// Sets the displacements of all nodes from those of the roots, and makes velocities in a tree equal to the root's.
    pub fn place(&self, x: &mut [f64], v: &mut [f64], places: &[f64]) {
        for branch in &self.branches {
            let (place, speed) = (at(x, branch.parent), at(v, branch.parent));
            let place = place + branch.sign * at(places, branch.contact);
            set(x, branch.child, place);
            set(v, branch.child, speed);
        }
    }

    /// Gives every tree without a support the velocity that keeps its momentum.
    pub fn meet(&self, model: &Model, v: &mut [f64]) {
        let mut moments = vec![0.0; v.len()];
        let mut differ = vec![false; v.len()];
        for (node, &root) in self.roots.iter().enumerate() {
            add(&mut moments, root, at(&model.masses, node) * at(v, node));
            if at(v, node) != at(v, root)
                && let Some(differ) = differ.get_mut(root)
            {
                *differ = true;
            }
        }
        for root in 0..model.masses.len() {
            if differ.get(root) == Some(&true) {
                set(v, root, at(&moments, root) / at(&self.masses, root));
            }
        }
        for branch in &self.branches {
            let speed = at(v, branch.parent);
            set(v, branch.child, speed);
        }
    }

    /// Returns the accelerations of all nodes, and adds the forces of the contacts that stick to `holds`, by contact.
    pub fn accelerate(
        &self,
        model: &Model,
        forces: &[f64],
        base: f64,
        holds: &mut [f64],
    ) -> Vec<f64> {
        let mut total = vec![0.0; forces.len()];
        for (force, &root) in forces.iter().zip(&self.roots) {
            add(&mut total, root, *force);
        }
        let of_root = |root: usize| match root {
            root if root < model.wall() => at(&total, root) / at(&self.masses, root),
            root if root == model.wall() => 0.0,
            _ => base,
        };
        let accelerations: Vec<f64> = self.roots.iter().map(|&root| of_root(root)).collect();
        let rest = forces.iter().zip(&accelerations).enumerate();
        let mut rest: Vec<f64> = rest
            .map(|(node, (force, a))| force - at(&model.masses, node) * a)
            .collect();
        for branch in self.branches.iter().rev() {
            let held = at(&rest, branch.child);
            set(holds, branch.contact, branch.sign * held);
            add(&mut rest, branch.parent, held);
        }
        accelerations
    }
}

/// Sets one number of a list.
pub fn set(nodes: &mut [f64], index: usize, value: f64) {
    if let Some(node) = nodes.get_mut(index) {
        *node = value;
    }
}

//! Response of a chain with several contacts if no contact slides. The chain is then linear, and the response has a
//! closed form.

use super::model::Model;
use super::size::{Size, add, at, set};
use super::tree::Tree;
use super::wave::Wave;
use crate::Float;
use crate::number::complex::Complex;
use crate::number::matrix::SquareMatrix;

/// Response of a chain with several contacts if no contact slides. All loads have the same frequency.
#[derive(Clone, Debug)]
pub struct StuckResponse<S: Float, Z: Size> {
    /// Complex amplitude X of the displacement of each mass: x = Re X exp(iωt).
    pub displacements: Z::Masses<Complex<S>>,
    /// Amplitude of the force in each contact, in the order of the scene description.
    pub forces: Z::Contacts<S>,
    /// Smallest common factor on all friction forces at which no contact slides, and the index of the contact that
    /// slides first below this factor. `None` if no contact has a friction force.
    pub limit: Option<(S, usize)>,
}

/// Complex amplitudes of the displacements of all nodes, as real and imaginary parts. The nodes are the masses, the
/// wall and the base.
struct Shape<S: Float, Z: Size> {
    re: Z::Nodes<S>,
    im: Z::Nodes<S>,
}

impl<S: Float, Z: Size> Shape<S, Z> {
    fn of(model: &Model<S, Z>) -> Self {
        let zeros = || model.size.nodes(S::constant(0.0));
        Self {
            re: zeros(),
            im: zeros(),
        }
    }

    /// Adds a complex amplitude to the displacement of every node that belongs to one tree (nodes that move together).
    fn lift(&mut self, tree: &Tree<S, Z>, root: usize, (re, im): (S, S)) {
        for node in 0..self.re.as_ref().len() {
            if tree.root(node) == root {
                add(self.re.as_mut(), node, re);
                add(self.im.as_mut(), node, im);
            }
        }
    }

    /// Returns the sum of the real parts and the sum of the imaginary parts over the nodes of one tree (nodes that move
    /// together).
    fn sums(&self, tree: &Tree<S, Z>, root: usize) -> (S, S) {
        let sum = |values: &[S]| {
            let nodes = values.iter().enumerate();
            let nodes = nodes.filter(|(node, _)| tree.root(*node) == root);
            nodes.fold(S::constant(0.0), |sum, (_, value)| sum + *value)
        };
        (sum(self.re.as_ref()), sum(self.im.as_ref()))
    }

    /// Adds the complex amplitudes of the loads to the forces on the nodes.
    fn load(&mut self, model: &Model<S, Z>) {
        let loads = model.loads.as_ref().iter();
        for (mass, load) in loads.filter(|(_, load)| !load.is_constant_load()) {
            let (re, im) = amplitude(load);
            add(self.re.as_mut(), *mass, re);
            add(self.im.as_mut(), *mass, im);
        }
    }

    /// Returns the complex amplitudes of the forces of springs, dashpots and elastic contacts, for displacements that
    /// vibrate with the angular frequency `omega`.
    fn pulls(&self, model: &Model<S, Z>, omega: S) -> Self {
        let pulls = |place: &Z::Nodes<S>, quarter: &Z::Nodes<S>, rate: S| {
            let mut speed = quarter.clone();
            for speed in speed.as_mut() {
                *speed = rate * *speed;
            }
            let zero = |_| S::constant(0.0);
            let mut forces = model.forces(place.as_ref(), speed.as_ref(), zero, None);
            for contact in model.contacts() {
                if let Some(stiffness) = contact.stiffness.filter(|_| contact.has_friction()) {
                    let force = stiffness * contact.across(place.as_ref());
                    contact.pull(forces.as_mut(), force);
                }
            }
            forces
        };
        Self {
            re: pulls(&self.re, &self.im, -omega),
            im: pulls(&self.im, &self.re, omega),
        }
    }
}

/// Returns the complex amplitude of the harmonic part of a function of time, as its real and imaginary part.
fn amplitude<S: Float>(wave: &Wave<S>) -> (S, S) {
    let (sin, cos) = (wave.phase * S::inverse_pi()).sin_cos_pi();
    (wave.amplitude * cos, wave.amplitude * sin)
}

impl<S: Float, Z: Size> Model<S, Z> {
    /// Returns the response if no contact slides, under loads of the angular frequency ω. The response includes neither
    /// constant loads and stops nor constant forces that an earlier motion has left in elastic contacts. Contacts without a
    /// friction force have no effect. Returns `None` at an undamped resonance.
    pub fn stuck(&self, omega: S) -> Option<StuckResponse<S, Z>> {
        let free = |j: usize| {
            self.contact(j)
                .is_none_or(|contact| !contact.has_friction())
        };
        let tree = Tree::new(self, |j| !free(j));
        let mut roots = self.size.masses(0);
        let mut count = 0;
        for node in (0..self.wall()).filter(|node| tree.root(*node) == *node) {
            set(roots.as_mut(), count, node);
            count += 1;
        }
        let roots = roots.as_ref().iter().take(count).copied();
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        // The real parts of the complex equations come first, and their imaginary parts second.
        let size = 2 * count;
        let mut matrix = self.size.square(zero);
        let mut known = self.size.unknowns(zero);
        for (column, root) in roots.clone().enumerate() {
            let mut unit = Shape::of(self);
            unit.lift(&tree, root, (one, zero));
            let forces = unit.pulls(self, omega);
            for (row, own) in roots.clone().enumerate() {
                let (mut re, im) = forces.sums(&tree, own);
                if own == root {
                    re = re + omega * omega * tree.mass(root);
                }
                for (row, column, value) in [
                    (row, column, re),
                    (count + row, count + column, re),
                    (count + row, column, im),
                    (row, count + column, -im),
                ] {
                    set(matrix.as_mut(), column * size + row, value);
                }
            }
        }
        let mut shape = Shape::of(self);
        shape.lift(&tree, self.base_node(), amplitude(&self.base.wave));
        let mut loads = shape.pulls(self, omega);
        loads.load(self);
        for (row, root) in roots.clone().enumerate() {
            let (re, im) = loads.sums(&tree, root);
            set(known.as_mut(), row, re);
            set(known.as_mut(), count + row, im);
        }
        // If sticking rigid contacts connect every mass to a support, the system has no equations.
        if !SquareMatrix::new(matrix.as_mut(), size).solve_shifted(zero, known.as_mut()) {
            return None;
        }
        for (row, root) in roots.enumerate() {
            let response = (at(known.as_ref(), row), at(known.as_ref(), count + row));
            shape.lift(&tree, root, response);
        }
        let mut all = shape.re.as_ref().iter().chain(shape.im.as_ref());
        if !all.all(|value| value.is_finite()) {
            return None;
        }
        Some(self.stuck_with(&tree, &shape, omega))
    }

    /// Computes the contact forces and the limit of the stuck state from the complex displacements of the nodes.
    fn stuck_with(&self, tree: &Tree<S, Z>, shape: &Shape<S, Z>, omega: S) -> StuckResponse<S, Z> {
        let zero = S::constant(0.0);
        let mut pulls = shape.pulls(self, omega);
        pulls.load(self);
        let held = |forces: &Z::Nodes<S>, place: &Z::Nodes<S>| {
            let mut holds = self.size.contacts(zero);
            let base = -omega * omega * at(place.as_ref(), self.base_node());
            tree.accelerate(self, forces.as_ref(), base, holds.as_mut());
            holds
        };
        let (re, im) = (held(&pulls.re, &shape.re), held(&pulls.im, &shape.im));
        let mut forces = self.size.contacts(zero);
        let mut limit = None;
        for (j, contact) in self.contacts().iter().enumerate() {
            if !contact.has_friction() {
                continue;
            }
            let across = |nodes: &Z::Nodes<S>| contact.across(nodes.as_ref());
            let force = match contact.stiffness {
                Some(stiffness) => stiffness * across(&shape.re).hypot(across(&shape.im)),
                None => at(re.as_ref(), j).hypot(at(im.as_ref(), j)),
            };
            set(forces.as_mut(), j, force);
            let factor = force / (contact.stiction * contact.level.constant);
            if limit.is_none_or(|(most, _)| factor > most) {
                limit = Some((factor, j));
            }
        }
        let mut displacements = self.size.masses(Complex::new(zero, zero));
        let parts = shape.re.as_ref().iter().zip(shape.im.as_ref());
        for (own, (re, im)) in displacements.as_mut().iter_mut().zip(parts) {
            *own = Complex::new(*re, *im);
        }
        StuckResponse {
            displacements,
            forces,
            limit,
        }
    }
}

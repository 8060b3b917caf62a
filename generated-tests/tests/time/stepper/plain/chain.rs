//! A scene as matrices, in SI units or the other units of its description.

use frictiongen_model::scene::{Damping, DampingFrom, Excitation, Node, Scene};
use nalgebra::{DMatrix, DVector};

/// The equations of motion Mẍ + Cẋ + Kx + w f = p(t) + k_base y(t), with z = wᵀx − s y. f is the contact force, and y
/// the displacement of the base.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The masses, the diagonal of M.
    pub m: DVector<f64>,
    pub c: DMatrix<f64>,
    pub k: DMatrix<f64>,
    /// Direction vector of the contact.
    pub w: DVector<f64>,
    /// 1 if the contact rubs on the moving base, otherwise 0.
    pub s: f64,
    /// Stiffness k_base of the springs from each mass to the base.
    pub to_base: DVector<f64>,
    /// The vector e: 1 for each mass if damping acts on velocities relative to the moving base, otherwise 0.
    pub carried: DVector<f64>,
    /// Inverse effective mass of the contact, wᵀM⁻¹w.
    pub inverse_mass: f64,
    /// Ratio of static to kinetic friction force.
    pub mu: f64,
    /// Points (speed, kinetic friction force over F): (0, 1), then the points of the law.
    pub law: Vec<[f64; 2]>,
    /// Largest rate of any motion of the chain, in 1/s.
    pub fastest: f64,
}

impl Chain {
    /// Returns the matrices of a scene. `law` has the points of a kinetic friction force that depends on the speed. It
    /// is empty for Coulomb's law.
    pub fn of(scene: &Scene, law: &[[f64; 2]]) -> Self {
        let n = scene.masses.len();
        let m: DVector<f64> = DVector::from_iterator(n, scene.masses.iter().map(|mass| mass.value));
        let mut k = DMatrix::zeros(n, n);
        let mut to_base = DVector::zeros(n);
        for spring in &scene.springs {
            let ends = [spring.from, spring.to];
            for (one, other) in [(0, 1), (1, 0)] {
                let Node::Mass(i) = ends[one] else { continue };
                k[(i, i)] += spring.stiffness;
                match ends[other] {
                    Node::Mass(j) => k[(i, j)] -= spring.stiffness,
                    Node::Base => to_base[i] += spring.stiffness,
                    Node::Wall => {}
                }
            }
        }
        let base_moves = scene.excitation == Excitation::Base;
        let (w, s) = contact(scene, base_moves);
        let root = m.map(f64::sqrt);
        let scaled = DMatrix::from_fn(n, n, |i, j| k[(i, j)] / (root[i] * root[j]));
        let scaled: DMatrix<f64> = scaled;
        let eigen = scaled.symmetric_eigen();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        let omega: Vec<f64> = order
            .iter()
            .map(|i| eigen.eigenvalues[*i].max(0.0).sqrt())
            .collect();
        let zeta = |mode: usize| match &scene.damping {
            Damping::None => 0.0,
            Damping::Uniform(zeta) => *zeta,
            Damping::Modal(all) => all[mode],
            Damping::Rayleigh { mass, stiffness } => {
                0.5 * (mass / omega[mode] + stiffness * omega[mode])
            }
        };
        let mut c = DMatrix::zeros(n, n);
        match scene.damping {
            Damping::Rayleigh { mass, stiffness } => {
                c = &k * stiffness + DMatrix::from_diagonal(&(&m * mass));
            }
            _ => {
                for (mode, column) in order.iter().enumerate() {
                    // The eigenvectors are scaled to Mφ with φᵀMφ = 1.
                    let shape = eigen.eigenvectors.column(*column).component_mul(&root);
                    c += &shape * shape.transpose() * (2.0 * zeta(mode) * omega[mode]);
                }
            }
        }
        let inverse_mass = w.iter().zip(&m).map(|(w, m)| w * w / m).sum();
        let fastest = (0..n)
            .map(|mode| omega[mode] * (1.0 + 2.0 * zeta(mode)))
            .fold(0.0, f64::max);
        let relative = base_moves && scene.damping_from == DampingFrom::Base;
        let carried = DVector::from_element(n, f64::from(u8::from(relative)));
        let mut points = vec![[0.0, 1.0]];
        points.extend_from_slice(law);
        Self {
            m,
            c,
            k,
            w,
            s,
            to_base,
            carried,
            inverse_mass,
            mu: scene.stiction,
            law: points,
            fastest,
        }
    }

    /// Returns the largest rate of any motion, in 1/s. It includes the effect of the friction law's slopes, which are
    /// proportional to F.
    pub fn rate(&self, friction: f64) -> f64 {
        let slopes = self.law.windows(2).map(|ends| {
            let [[v0, f0], [v1, f1]] = [ends[0], ends[1]];
            ((f1 - f0) / (v1 - v0)).abs()
        });
        self.fastest + slopes.fold(0.0, f64::max) * friction * self.inverse_mass
    }
}

fn contact(scene: &Scene, base_moves: bool) -> (DVector<f64>, f64) {
    let mut w = DVector::zeros(scene.masses.len());
    let mut s = 0.0;
    match [scene.contact.from, scene.contact.to] {
        [Node::Mass(a), Node::Mass(b)] => {
            w[a.min(b)] = -1.0;
            w[a.max(b)] = 1.0;
        }
        [Node::Mass(j), support] | [support, Node::Mass(j)] => {
            w[j] = 1.0;
            if support == Node::Base && base_moves {
                s = 1.0;
            }
        }
        _ => panic!("a contact without a mass"),
    }
    (w, s)
}

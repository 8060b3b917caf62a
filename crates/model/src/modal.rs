//! Modal data of a scene: resonances, damping ratios, mode shapes and modal loads. The module does all linear algebra
//! of a scene, in double-double.

use crate::jacobi::{self, ColumnMatrix, dot};
use crate::modal_sums::{cleaned, inertial_drag, projected, static_sums};
use crate::scene::{ContactSides, Damping, Excitation, Node, Scene};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::response::Ends;

/// Bound on a residue that is only rounding noise, divided by the largest value that the residue can have. The code
/// sets a residue within this bound to exactly zero.
pub(crate) const NOISE: f64 = 1e-26;

/// A scene in modal coordinates (section 2 of `docs/derivation.md`), to about 30 digits. The type `T` is a number, or a
/// number with its derivative ([`Modal::along`]).
#[derive(Clone, Debug)]
pub struct Modal<T = Dd> {
    /// √λ_i, the undamped resonances as frequency ratios r, in ascending order.
    pub resonances: Vec<T>,
    /// ζ_i, the modal damping ratio of each mode.
    pub damping_ratios: Vec<T>,
    /// φ, the components of the mode shapes, as one list for each mode with one entry for each mass. The shapes are
    /// normalised to φᵀΓφ = 1, where Γ is the diagonal matrix of the mass ratios.
    pub shapes: Vec<Vec<T>>,
    /// φᵀp, the load on each mode, from the load vector p.
    pub loads: Vec<T>,
    /// φᵀw, the relative displacement of the contact in each mode, from the contact direction w.
    pub contacts: Vec<T>,
    /// φᵀΓ1, the participation factor of each mode for base motion, where Γ is the diagonal matrix of the mass
    /// ratios. The list is empty unless damping acts on velocities relative to the moving base.
    pub participations: Vec<T>,
    /// Force φᵀK_w𝟏 of the springs to the wall on each mode, if all masses move by 1. K_w is the matrix of these
    /// springs, and 𝟏 is a vector of ones. The list is empty unless damping acts on velocities relative to the moving
    /// base.
    pub walls: Vec<T>,
    /// wᵀΓ⁻¹C̄1/r, the relative acceleration of the contact that damping causes if the base moves at unit velocity. w
    /// is the contact direction, Γ the matrix of the mass ratios and C̄ the damping matrix. This acceleration is 0
    /// unless damping acts on velocities relative to the moving base.
    pub inertial_drag: T,
    /// m* = wᵀΓ⁻¹w, the inverse effective mass of the contact. w is the contact direction, and Γ the matrix of the mass
    /// ratios.
    pub inverse_mass: T,
    /// wᵀΓ⁻¹p, the relative acceleration of the contact under a unit load if the springs exert no force. w is the
    /// contact direction, Γ the matrix of the mass ratios and p the load vector.
    pub inertial_load: T,
    /// wᵀK̄⁻¹p − s, the static relative displacement of the contact under a unit load. w is the contact direction, K̄
    /// the stiffness matrix and p the load vector. s is 1 if the contact slides on the moving base, otherwise 0.
    pub static_motion: T,
    /// wᵀK̄⁻¹w, the static relative displacement of the contact under a unit force in the contact. w is the contact
    /// direction, and K̄ the stiffness matrix.
    pub static_receptance: T,
    /// True if the contact slides on the moving base. Its relative displacement is then z̄ = wᵀx̄ − cos τ_e, with the
    /// contact direction w and the phase τ_e of the base.
    pub on_moving_base: bool,
    /// √(k₁/m₁), the reference frequency of all frequency ratios, in rad/s in the scene's own units.
    pub reference: T,
    /// μ, the ratio of static to kinetic friction force.
    pub stiction: T,
    /// k₁/k, the non-dimensional compliance of an elastic contact with the stiffness k. `None` for a rigid contact.
    pub compliance: Option<T>,
    /// The contact's masses by index: the two masses in ascending order, or a single mass and `None`.
    pub contact: (usize, Option<usize>),
    /// True if masses beyond the contact can act as an absorber ([`Scene::has_absorber`]).
    pub has_absorber: bool,
}

fn dd(value: f64) -> Dd {
    Dd::from(value)
}

/// Returns the contact direction w as pairs (index of a mass, sign). In a contact between two masses, the mass with the
/// lower index has the sign −1.
fn direction(contact: ContactSides) -> Vec<(usize, f64)> {
    match (contact.from, contact.to) {
        (Node::Mass(a), Node::Mass(b)) => vec![(a.min(b), -1.0), (a.max(b), 1.0)],
        (Node::Mass(j), _) | (_, Node::Mass(j)) => vec![(j, 1.0)],
        _ => Vec::new(),
    }
}

/// Matrix and vectors of a scene before its modal analysis. Each entry is divided by √γ of its mass.
struct Assembled {
    /// √γ_i, the square roots of the mass ratios.
    root_gamma: Vec<Dd>,
    /// √(k₁/m₁), the reference frequency of all frequency ratios.
    reference: Dd,
    /// G = diag(√κ)·E·diag(1/√γ), stored by columns. E is the incidence matrix of the springs. The singular values of G
    /// are the √λ.
    g: ColumnMatrix,
    /// Load vector p, with each entry divided by √γ of its mass.
    p_scaled: Vec<Dd>,
    /// Contact direction w, with each entry divided by √γ of its mass.
    w_scaled: Vec<Dd>,
    /// K_w1, the stiffnesses of the springs between each mass and the wall, with each entry divided by √γ of its mass.
    wall_scaled: Vec<Dd>,
}

impl Assembled {
    fn of(scene: &Scene) -> Self {
        let n = scene.masses.len();
        let m1 = dd(scene.masses.first().map_or(1.0, |mass| mass.value));
        let k1 = dd(scene.first_stiffness());
        let root_gamma: Vec<Dd> = scene
            .masses
            .iter()
            .map(|mass| (dd(mass.value) / m1).sqrt())
            .collect();
        let kappa: Vec<Dd> = scene
            .springs
            .iter()
            .map(|spring| dd(spring.stiffness) / k1)
            .collect();
        let mut g: ColumnMatrix = vec![vec![dd(0.0); kappa.len()]; n];
        let (mut p, mut walls) = (vec![dd(0.0); n], vec![dd(0.0); n]);
        for (row, (spring, kappa)) in scene.springs.iter().zip(&kappa).enumerate() {
            let root = kappa.sqrt();
            for (node, sign) in [(spring.from, -1.0), (spring.to, 1.0)] {
                if let Node::Mass(mass) = node
                    && let (Some(root_gamma), Some(entry)) = (
                        root_gamma.get(mass),
                        g.get_mut(mass).and_then(|c| c.get_mut(row)),
                    )
                {
                    *entry = dd(sign) * root / *root_gamma;
                }
            }
            let joined = match (spring.from, spring.to) {
                (Node::Base, Node::Mass(mass)) | (Node::Mass(mass), Node::Base) => Some(mass),
                _ => None,
            };
            if let (Excitation::Base, Some(p)) =
                (scene.excitation, joined.and_then(|mass| p.get_mut(mass)))
            {
                *p = *p + *kappa;
            }
            if let (Node::Wall, Node::Mass(mass)) | (Node::Mass(mass), Node::Wall) =
                (spring.from, spring.to)
                && let Some(wall) = walls.get_mut(mass)
            {
                *wall = *wall + *kappa;
            }
        }
        if let Excitation::Force(mass) = scene.excitation
            && let Some(p) = p.get_mut(mass)
        {
            *p = dd(1.0);
        }
        let mut w = vec![dd(0.0); n];
        for (mass, sign) in direction(scene.contact) {
            if let Some(w) = w.get_mut(mass) {
                *w = dd(sign);
            }
        }
        let scaled = |vector: Vec<Dd>| -> Vec<Dd> {
            vector
                .iter()
                .zip(&root_gamma)
                .map(|(value, root)| *value / *root)
                .collect()
        };
        let (p_scaled, w_scaled, wall_scaled) = (scaled(p), scaled(w), scaled(walls));
        Self {
            reference: (k1 / m1).sqrt(),
            root_gamma,
            g,
            p_scaled,
            w_scaled,
            wall_scaled,
        }
    }
}

impl Modal {
    /// Returns the modal analysis of a valid scene, computed in double-double.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let mut assembled = Assembled::of(scene);
        let (resonances, vectors) = jacobi::singular(std::mem::take(&mut assembled.g));
        Self::assembled(scene, &assembled, resonances, &vectors, NOISE)
    }

    /// Returns the modal analysis of a scene by a solver that the caller provides. The solver receives the columns of
    /// G, where GᵀG has the eigenvalues λ. It returns the singular values of G in ascending order, and the right
    /// singular vectors as columns. A modal value below `noise` times the largest value that it can have becomes
    /// zero.
    #[must_use]
    pub fn solved_by(
        scene: &Scene,
        noise: f64,
        solver: impl FnOnce(&[Vec<f64>]) -> (Vec<f64>, Vec<Vec<f64>>),
    ) -> Self {
        let assembled = Assembled::of(scene);
        let plain = |column: &Vec<Dd>| column.iter().map(|value| value.to_f64()).collect();
        let g: Vec<Vec<f64>> = assembled.g.iter().map(plain).collect();
        let (resonances, vectors) = solver(&g);
        let exact = |column: Vec<f64>| column.into_iter().map(dd).collect::<Vec<_>>();
        let vectors: ColumnMatrix = vectors.into_iter().map(exact).collect();
        Self::assembled(scene, &assembled, exact(resonances), &vectors, noise)
    }

    fn assembled(
        scene: &Scene,
        assembled: &Assembled,
        resonances: Vec<Dd>,
        vectors: &[Vec<Dd>],
        noise: f64,
    ) -> Self {
        let Assembled {
            root_gamma,
            reference,
            p_scaled,
            w_scaled,
            wall_scaled,
            ..
        } = assembled;
        let reference = *reference;
        // The solver's orthonormal vectors, divided by √γ, are the mode shapes.
        let n = vectors.len();
        let mut shapes = Vec::with_capacity(n);
        let (mut loads, mut contacts) = (Vec::with_capacity(n), Vec::with_capacity(n));
        let (mut participations, mut walls) = (Vec::new(), Vec::new());
        for vector in vectors {
            let mut shape: Vec<Dd> = vector
                .iter()
                .zip(root_gamma)
                .map(|(value, root)| *value / *root)
                .collect();
            let largest = shape
                .iter()
                .fold(dd(0.0), |most, value| most.max(value.abs()));
            for value in &mut shape {
                if value.abs() < largest * dd(noise) {
                    *value = dd(0.0);
                }
            }
            let leading = shape.iter().find(|value| largest * dd(1e-10) < value.abs());
            let sign = if leading.is_some_and(|value| *value < dd(0.0)) {
                dd(-1.0)
            } else {
                dd(1.0)
            };
            shapes.push(shape.iter().map(|value| *value * sign).collect::<Vec<_>>());
            loads.push(projected(vector, p_scaled, noise) * sign);
            contacts.push(projected(vector, w_scaled, noise) * sign);
            if scene.is_damped_from_base() {
                participations.push(projected(vector, root_gamma, noise) * sign);
                walls.push(projected(vector, wall_scaled, noise) * sign);
            }
        }

        let damping_ratios = damping_ratios(&scene.damping, &resonances, reference);
        let on_moving_base = matches!(scene.excitation, Excitation::Base)
            && (scene.contact.from == Node::Base || scene.contact.to == Node::Base);
        let carried = if on_moving_base { dd(1.0) } else { dd(0.0) };
        let (static_motion, static_receptance) =
            static_sums(carried, &resonances, &loads, &contacts, noise);
        let products = || w_scaled.iter().zip(p_scaled).map(|(w, p)| *w * *p);
        let inertial_load = cleaned(
            products().fold(dd(0.0), |sum, term| sum + term),
            products().fold(dd(0.0), |sum, term| sum + term.abs()),
            NOISE,
        );
        let inertial_drag = inertial_drag(
            (&resonances, &damping_ratios),
            (&contacts, &participations),
            noise,
        );
        let sides: Vec<usize> = direction(scene.contact)
            .into_iter()
            .map(|(mass, _)| mass)
            .collect();
        Self {
            resonances,
            damping_ratios,
            shapes,
            loads,
            contacts,
            participations,
            walls,
            inertial_drag,
            inverse_mass: dot(w_scaled, w_scaled),
            inertial_load,
            static_motion,
            static_receptance,
            on_moving_base,
            reference,
            stiction: dd(scene.stiction),
            compliance: scene
                .stiffness
                .map(|stiffness| dd(scene.first_stiffness()) / dd(stiffness)),
            contact: (sides.first().copied().unwrap_or(0), sides.get(1).copied()),
            has_absorber: scene.has_absorber(),
        }
    }
}

impl<T: Float> Modal<T> {
    /// Returns the index of the mass that slides on a support. Returns `None` if two masses slide on each other.
    #[must_use]
    pub fn rubbing(&self) -> Option<usize> {
        let (mass, other) = self.contact;
        other.is_none().then_some(mass)
    }

    /// Returns the undamped natural frequencies ω_i, in rad/s in the scene's own units.
    #[must_use]
    pub fn natural_frequencies(&self) -> Vec<T> {
        self.resonances
            .iter()
            .map(|resonance| *resonance * self.reference)
            .collect()
    }

    /// Returns the undamped resonances that the load drives, as frequency ratios. At these resonances the continuous
    /// motion may be unbounded. If `invisible` is true, the result contains only the resonances of modes in which the
    /// contact does not move. At these resonances even the motion with a stuck contact is unbounded.
    #[must_use]
    pub fn unbounded(&self, invisible: bool) -> Vec<T> {
        let zero = T::constant(0.0);
        let modes = self
            .resonances
            .iter()
            .zip(&self.damping_ratios)
            .zip(&self.loads)
            .zip(&self.contacts);
        modes
            .filter(|(((_, zeta), load), contact)| {
                **zeta == zero && **load != zero && (!invisible || **contact == zero)
            })
            .map(|(((resonance, _), _), _)| *resonance)
            .collect()
    }

    /// Returns true if any mode is damped. A mode without damping counts as damped if its damping has a derivative
    /// that is not 0.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        self.damping_ratios.iter().any(|zeta| !zeta.vanishes())
    }

    /// Returns the limiting values of β_lim and β*_lim at r = 0 and r = ∞.
    #[must_use]
    pub fn ends(&self) -> Ends<T> {
        let mu = self.stiction;
        if let Some(compliance) = self.compliance {
            // For r → ∞ the force in a stuck elastic contact is the displacement of the contact divided by the
            // compliance.
            let zero = T::constant(0.0);
            let receptance = self.static_receptance + compliance;
            return Ends {
                sliding_at_rest: self.static_motion.abs() / (mu * receptance),
                continuous_at_infinity: zero,
                sliding_at_infinity: if self.on_moving_base {
                    T::constant(1.0) / (mu * compliance)
                } else {
                    zero
                },
            };
        }
        let sliding = self.static_motion.abs() / (mu * self.static_receptance);
        // If damping acts on velocities relative to the moving base, the force on the contact is proportional to r for
        // large r. The limits for r → ∞ are then infinite, as for a contact on the moving base.
        if self.on_moving_base || !self.inertial_drag.is_zero() {
            let infinity = T::constant(f64::INFINITY);
            return Ends {
                sliding_at_rest: sliding,
                continuous_at_infinity: infinity,
                sliding_at_infinity: infinity,
            };
        }
        let ratio = self.inertial_load.abs() / self.inverse_mass;
        let root = (T::constant(4.0) * mu * mu + T::pi() * T::pi()).sqrt();
        Ends {
            sliding_at_rest: sliding,
            continuous_at_infinity: ratio * T::constant(2.0) / root,
            sliding_at_infinity: ratio / mu,
        }
    }
}

/// Returns the modal damping ratio ζ = (a/ω + bω)/2 of a mode with natural frequency ω, for Rayleigh damping C = aM +
/// bK.
pub(crate) fn rayleigh<T: Float>(mass: T, stiffness: T, omega: T) -> T {
    (mass / omega + stiffness * omega) * T::constant(0.5)
}

fn damping_ratios(damping: &Damping, resonances: &[Dd], reference: Dd) -> Vec<Dd> {
    match damping {
        Damping::None => vec![dd(0.0); resonances.len()],
        Damping::Uniform(zeta) => vec![dd(*zeta); resonances.len()],
        Damping::Modal(list) => (0..resonances.len())
            .map(|i| dd(list.get(i).copied().unwrap_or(0.0)))
            .collect(),
        Damping::Rayleigh { mass, stiffness } => resonances
            .iter()
            .map(|resonance| rayleigh(dd(*mass), dd(*stiffness), *resonance * reference))
            .collect(),
    }
}

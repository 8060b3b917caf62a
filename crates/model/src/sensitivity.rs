//! Derivatives of the modal data with respect to the quantities of a scene. The module computes them by first-order
//! perturbation of the modes, in double-double.
//!
//! The modes are the eigenvectors of GᵀG, the stiffness matrix scaled by the masses. γ and κ are the mass and
//! stiffness ratios, Γ is the diagonal matrix of γ, and λ are the squared resonances. With v = √Γφ, the change of GᵀG
//! has, for the modes i and j, the entry vᵢᵀ(dGᵀG)vⱼ = Σ_e (dκ/κ)ₑ κₑδᵢₑδⱼₑ − ½(λ_i + λ_j) Σ_m (dγ/γ)_m vᵢₘvⱼₘ. δᵢₑ is
//! the elongation of spring e in mode i.

mod base;
mod equal;

use crate::modal::{Modal, rayleigh};
use crate::modal_sums::{inertial_drag, static_sums};
use crate::scene::{Damping, Excitation, Node, Scene};
use equal::{adapt_equal_modes, equal};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// A quantity of a scene with respect to which results have a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// The value of a mass, given by its index in the description.
    Mass(usize),
    /// The stiffness of a spring, given by its index in the description.
    Stiffness(usize),
    /// The factor a of the mass matrix in Rayleigh damping C = aM + bK.
    MassDamping,
    /// The factor b of the stiffness matrix in Rayleigh damping C = aM + bK.
    StiffnessDamping,
    /// The stiffness of an elastic contact.
    ContactStiffness,
    /// μ, the ratio of static to kinetic friction force.
    Stiction,
    /// √λ, the resonance of the mode with this index, as a frequency ratio. All other modal data stay fixed.
    Resonance(usize),
    /// ζ, the modal damping ratio of the mode with this index.
    DampingRatio(usize),
    /// φᵀp, the load on the mode with this index.
    Load(usize),
    /// φᵀw, the relative displacement of the contact in the mode with this index.
    Contact(usize),
    /// The component of a mass in a mode shape.
    Shape {
        /// The index of the mode, in ascending order of resonance.
        mode: usize,
        /// The index of the mass in the description.
        mass: usize,
    },
}

fn dd(value: f64) -> Dd {
    Dd::from(value)
}

fn dual(value: Dd, slope: Dd) -> Dual<Dd> {
    Dual { value, slope }
}

fn fixed(values: &[Dd]) -> Vec<Dual<Dd>> {
    values.iter().copied().map(Dual::fixed).collect()
}

impl Modal {
    /// Returns the modal data as dual numbers, all with the derivative 0.
    #[must_use]
    pub fn fixed(&self) -> Modal<Dual<Dd>> {
        Modal {
            resonances: fixed(&self.resonances),
            damping_ratios: fixed(&self.damping_ratios),
            shapes: self.shapes.iter().map(|shape| fixed(shape)).collect(),
            loads: fixed(&self.loads),
            contacts: fixed(&self.contacts),
            participations: fixed(&self.participations),
            walls: fixed(&self.walls),
            inertial_drag: Dual::fixed(self.inertial_drag),
            inverse_mass: Dual::fixed(self.inverse_mass),
            inertial_load: Dual::fixed(self.inertial_load),
            static_motion: Dual::fixed(self.static_motion),
            static_receptance: Dual::fixed(self.static_receptance),
            on_moving_base: self.on_moving_base,
            reference: Dual::fixed(self.reference),
            stiction: Dual::fixed(self.stiction),
            compliance: self.compliance.map(Dual::fixed),
            contact: self.contact,
            has_absorber: self.has_absorber,
        }
    }

    /// Returns the modal data with derivatives with respect to one quantity of the scene. `scene` must be the scene of
    /// this modal analysis. Returns `None` if the scene does not have this quantity.
    #[must_use]
    pub fn along(&self, scene: &Scene, quantity: Quantity) -> Option<Modal<Dual<Dd>>> {
        let mut along = self.fixed();
        let one = dd(1.0);
        match quantity {
            Quantity::Mass(_) | Quantity::Stiffness(_) => {
                RelativeChange::of(scene, quantity)?.perturb(self, scene, &mut along);
                // The compliance ρ = k₁/k of an elastic contact is proportional to the stiffness k₁ of the first
                // spring.
                if let (Quantity::Stiffness(0), Some(compliance)) =
                    (quantity, along.compliance.as_mut())
                {
                    compliance.slope = compliance.value / dd(scene.first_stiffness());
                }
            }
            Quantity::MassDamping | Quantity::StiffnessDamping => {
                let (a, b) = factors(scene, Some(quantity))?;
                along.damp(a, b);
            }
            Quantity::ContactStiffness => {
                let stiffness = dd(scene.stiffness?);
                let compliance = along.compliance.as_mut()?;
                compliance.slope = -(compliance.value / stiffness);
            }
            Quantity::Stiction => along.stiction.slope = one,
            Quantity::Resonance(mode) => along.resonances.get_mut(mode)?.slope = one,
            Quantity::DampingRatio(mode) => along.damping_ratios.get_mut(mode)?.slope = one,
            Quantity::Load(mode) => along.loads.get_mut(mode)?.slope = one,
            Quantity::Contact(mode) => {
                let contact = along.contacts.get_mut(mode)?;
                contact.slope = one;
                along.inverse_mass.slope = contact.value + contact.value;
                along.inertial_load.slope = along.loads.get(mode)?.value;
            }
            Quantity::Shape { mode, mass } => {
                along.shapes.get_mut(mode)?.get_mut(mass)?.slope = one;
            }
        }
        if let Quantity::Load(mode) = quantity {
            along.inertial_load.slope = self.contacts.get(mode).copied()?;
        }
        let carried = Dual::constant(if self.on_moving_base { 1.0 } else { 0.0 });
        let (motion, receptance) = static_sums(
            carried,
            &along.resonances,
            &along.loads,
            &along.contacts,
            crate::modal::NOISE,
        );
        (along.static_motion, along.static_receptance) = (motion, receptance);
        along.inertial_drag = inertial_drag(
            (&along.resonances, &along.damping_ratios),
            (&along.contacts, &along.participations),
            crate::modal::NOISE,
        );
        Some(along)
    }
}

impl Modal<Dual<Dd>> {
    /// Sets the damping ratio ζ of every mode, with its derivative, for Rayleigh damping C = aM + bK.
    fn damp(&mut self, a: Dual<Dd>, b: Dual<Dd>) {
        for (zeta, resonance) in self.damping_ratios.iter_mut().zip(&self.resonances) {
            *zeta = rayleigh(a, b, *resonance * self.reference);
        }
    }
}

/// Returns the factors a and b of Rayleigh damping. If `along` names one of these factors, this factor is the variable
/// of the derivative.
fn factors(scene: &Scene, along: Option<Quantity>) -> Option<(Dual<Dd>, Dual<Dd>)> {
    let Damping::Rayleigh { mass, stiffness } = scene.damping else {
        return None;
    };
    let of = |value: f64, own: Quantity| {
        if along == Some(own) {
            Dual::variable(dd(value))
        } else {
            Dual::fixed(dd(value))
        }
    };
    Some((
        of(mass, Quantity::MassDamping),
        of(stiffness, Quantity::StiffnessDamping),
    ))
}

/// Relative changes dγ/γ of each mass ratio and dκ/κ of each stiffness ratio. The first mass and the first spring are
/// the references. A change of the first mass or of the first spring therefore changes all other ratios.
struct RelativeChange {
    masses: Vec<Dd>,
    springs: Vec<Dd>,
    /// d(√(k₁/m₁))/√(k₁/m₁), the relative change of the reference frequency.
    reference: Dd,
}

impl RelativeChange {
    fn of(scene: &Scene, quantity: Quantity) -> Option<Self> {
        let (zero, half) = (dd(0.0), dd(0.5));
        let mut change = Self {
            masses: vec![zero; scene.masses.len()],
            springs: vec![zero; scene.springs.len()],
            reference: zero,
        };
        let (list, place, value, sign) = match quantity {
            Quantity::Mass(place) => {
                let value = scene.masses.get(place)?.value;
                (&mut change.masses, place, value, -half)
            }
            Quantity::Stiffness(place) => {
                let value = scene.springs.get(place)?.stiffness;
                (&mut change.springs, place, value, half)
            }
            _ => return None,
        };
        let relative = dd(1.0) / dd(value);
        if place == 0 {
            list.iter_mut()
                .skip(1)
                .for_each(|change| *change = -relative);
            change.reference = sign * relative;
        } else if let Some(change) = list.get_mut(place) {
            *change = relative;
        }
        Some(change)
    }

    fn perturb(&self, modal: &Modal, scene: &Scene, along: &mut Modal<Dual<Dd>>) {
        let m1 = scene.masses.first().map_or(1.0, |mass| mass.value);
        let k1 = scene.first_stiffness();
        let gamma: Vec<Dd> = scene
            .masses
            .iter()
            .map(|mass| dd(mass.value) / dd(m1))
            .collect();
        let kappa: Vec<Dd> = scene
            .springs
            .iter()
            .map(|spring| dd(spring.stiffness) / dd(k1))
            .collect();
        let n = modal.resonances.len();
        let at = |list: &[Dd], i: usize| list.get(i).copied().unwrap_or_default();
        let mut shapes = modal.shapes.clone();
        let mut matrix = self.between(&shapes, &modal.resonances, scene, &gamma, &kappa);
        let turned = adapt_equal_modes(&mut matrix, &mut shapes, &modal.resonances);

        // The derivative of mode shape i is dφ_i = Σ φ_j b_ij/(λ_i − λ_j) − ½ (dγ/γ) φ_i, with the entries b_ij of
        // `matrix`. The sum covers the modes j whose frequency differs from that of mode i.
        let half = dd(0.5);
        for i in 0..n {
            let root = at(&modal.resonances, i);
            let row = matrix.get(i).map_or(&[][..], Vec::as_slice);
            if let Some(resonance) = along.resonances.get_mut(i) {
                resonance.slope = at(row, i) / (root + root);
            }
            let shape = shapes.get(i).map_or(&[][..], Vec::as_slice);
            let mut slopes: Vec<Dd> = shape
                .iter()
                .zip(&self.masses)
                .map(|(value, change)| -(half * *change * *value))
                .collect();
            for (j, other) in shapes.iter().enumerate() {
                let gap = root - at(&modal.resonances, j);
                if j == i || equal(root, at(&modal.resonances, j)) {
                    continue;
                }
                let weight = at(row, j) / (gap * (root + at(&modal.resonances, j)));
                for (slope, value) in slopes.iter_mut().zip(other) {
                    *slope = *slope + weight * *value;
                }
            }
            if let Some(target) = along.shapes.get_mut(i) {
                *target = shape
                    .iter()
                    .zip(slopes)
                    .map(|(value, slope)| dual(*value, slope))
                    .collect();
            }
        }
        along.reference.slope = self.reference * modal.reference;
        self.project(modal, scene, (&gamma, &kappa), &turned, along);
        if let Some((a, b)) = factors(scene, None) {
            along.damp(a, b);
        }
    }

    /// Returns vᵢᵀ(dGᵀG)vⱼ for every pair of modes i and j. The result is the change of the stiffness matrix K̄ = GᵀG,
    /// scaled by the masses, in coordinates of the modes. v = √Γφ is a mode's scaled shape.
    fn between(
        &self,
        shapes: &[Vec<Dd>],
        resonances: &[Dd],
        scene: &Scene,
        gamma: &[Dd],
        kappa: &[Dd],
    ) -> Vec<Vec<Dd>> {
        let place = |shape: &[Dd], node: Node| match node {
            Node::Mass(mass) => shape.get(mass).copied().unwrap_or_default(),
            Node::Base | Node::Wall => dd(0.0),
        };
        let elongation = |shape: &[Dd]| -> Vec<Dd> {
            let springs = scene.springs.iter();
            springs
                .map(|spring| place(shape, spring.to) - place(shape, spring.from))
                .collect()
        };
        let elongations: Vec<Vec<Dd>> = shapes.iter().map(|shape| elongation(shape)).collect();
        let lambdas: Vec<Dd> = resonances.iter().map(|root| *root * *root).collect();
        let entry = |i: usize, j: usize| {
            let mut sum = dd(0.0);
            if let (Some(a), Some(b)) = (elongations.get(i), elongations.get(j)) {
                for (((change, kappa), a), b) in self.springs.iter().zip(kappa).zip(a).zip(b) {
                    sum = sum + *change * *kappa * *a * *b;
                }
            }
            let mut mass = dd(0.0);
            if let (Some(a), Some(b)) = (shapes.get(i), shapes.get(j)) {
                for (((change, gamma), a), b) in self.masses.iter().zip(gamma).zip(a).zip(b) {
                    mass = mass + *change * *gamma * *a * *b;
                }
            }
            let pair = [i, j].map(|k| lambdas.get(k).copied().unwrap_or_default());
            let [a, b] = pair;
            sum - dd(0.5) * (a + b) * mass
        };
        let n = shapes.len();
        (0..n)
            .map(|i| (0..n).map(|j| entry(i, j)).collect())
            .collect()
    }

    /// Sets the derivatives of the modal loads φᵀp and of the contact displacements φᵀw in the modes. Also sets the
    /// derivatives of all modal data that depend on them.
    fn project(
        &self,
        modal: &Modal,
        scene: &Scene,
        (gamma, kappa): (&[Dd], &[Dd]),
        turned: &[bool],
        along: &mut Modal<Dual<Dd>>,
    ) {
        let zero = Dual::constant(0.0);
        let n = gamma.len();
        let mut p = vec![zero; n];
        match scene.excitation {
            Excitation::Force(mass) => {
                if let Some(p) = p.get_mut(mass) {
                    *p = Dual::constant(1.0);
                }
            }
            Excitation::Base => {
                for ((spring, kappa), change) in scene.springs.iter().zip(kappa).zip(&self.springs)
                {
                    if let (Node::Base, Node::Mass(mass)) | (Node::Mass(mass), Node::Base) =
                        (spring.from, spring.to)
                        && let Some(p) = p.get_mut(mass)
                    {
                        *p = *p + dual(*kappa, *kappa * *change);
                    }
                }
            }
        }
        let mut w = vec![zero; n];
        let (first, second) = modal.contact;
        for (mass, sign) in match second {
            Some(second) => vec![(first, -1.0), (second, 1.0)],
            None => vec![(first, 1.0)],
        } {
            if let Some(w) = w.get_mut(mass) {
                *w = Dual::constant(sign);
            }
        }
        let projections = along.loads.iter_mut().zip(&mut along.contacts);
        for (((load, contact), shape), turned) in projections.zip(&along.shapes).zip(turned) {
            for (projection, on) in [(load, &p), (contact, &w)] {
                set(projection, shape, on, *turned);
            }
        }
        self.project_base(scene, (gamma, kappa), turned, along);
        let over_mass = |a: &[Dual<Dd>], b: &[Dual<Dd>]| {
            let masses = gamma.iter().zip(&self.masses);
            masses
                .zip(a.iter().zip(b))
                .fold(zero, |sum, ((gamma, change), (a, b))| {
                    sum + *a * *b / dual(*gamma, *gamma * *change)
                })
        };
        along.inverse_mass = over_mass(&w, &w);
        along.inertial_load.slope = over_mass(&w, &p).slope;
    }
}

/// Sets the derivative of `projection`, the product of a mode shape and a vector. `turned` is true if the
/// differentiation has rotated the shapes of modes with equal frequency. The function then also sets the value.
/// Otherwise the value from the modal analysis stays, because the analysis has set rounding noise to zero.
fn set(projection: &mut Dual<Dd>, shape: &[Dual<Dd>], on: &[Dual<Dd>], turned: bool) {
    let products = shape.iter().zip(on);
    let product = products.fold(Dual::constant(0.0), |sum, (a, b)| sum + *a * *b);
    projection.slope = product.slope;
    if turned {
        projection.value = product.value;
    }
}

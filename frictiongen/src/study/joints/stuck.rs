//! Response of a chain while no contact slides. The chain is then linear, and the response has a closed form.

use super::{Chain, JointError, Model, Tree};
use frictiongen_kernel::joints::{add, at};
use nalgebra::{Complex, DMatrix, DVector};

/// Response while no contact slides, under loads of one frequency.
#[derive(Clone, Debug)]
pub struct StuckResponse {
    /// Amplitude of each mass.
    pub amplitudes: Vec<f64>,
    /// Complex amplitude X of each mass: x = Re X exp(iωt).
    pub displacements: Vec<Complex<f64>>,
    /// Amplitude of the force in each contact.
    pub forces: Vec<f64>,
    /// Factor on all friction forces at which the first contact is about to slide, and the index of this contact.
    /// `None` if no contact has a friction force.
    pub limit: Option<(f64, usize)>,
}

/// Complex amplitudes of the displacements of all nodes.
#[derive(Clone)]
struct Shape {
    re: Vec<f64>,
    im: Vec<f64>,
}

/// Returns the response while no contact slides. The response does not include constant loads, and no earlier motion
/// has left a constant force in an elastic contact.
///
/// # Errors
///
/// [`JointError::Number`] if the loads have several frequencies, or if the frequency is a resonance.
pub fn stuck_response(chain: &Chain) -> Result<StuckResponse, JointError> {
    let model = chain.model()?;
    let omega = frequency(chain)?;
    let tree = Tree::new(&model, |j| {
        model
            .contacts
            .get(j)
            .is_some_and(|contact| !contact.is_free())
    });
    let roots: Vec<usize> = (0..model.wall())
        .filter(|&node| tree.root(node) == node)
        .collect();
    let nodes = model.wall() + 2;
    let unit = |root: usize| Shape {
        re: (0..nodes)
            .map(|node| f64::from(u8::from(tree.root(node) == root)))
            .collect(),
        im: vec![0.0; nodes],
    };
    let sums = |forces: &Shape| {
        let sum = |values: &[f64], root: usize| -> f64 {
            let nodes = values.iter().enumerate();
            nodes
                .filter(|(node, _)| tree.root(*node) == root)
                .map(|(_, value)| value)
                .sum()
        };
        let sums = roots
            .iter()
            .map(|&root| Complex::new(sum(&forces.re, root), sum(&forces.im, root)));
        DVector::from_iterator(roots.len(), sums)
    };
    let mut matrix = DMatrix::zeros(roots.len(), roots.len());
    for (column, &root) in roots.iter().enumerate() {
        let mut forces = sums(&pulls(&model, &unit(root), omega));
        if let Some(own) = forces.get_mut(column) {
            *own += omega * omega * tree.mass(root);
        }
        matrix.set_column(column, &-forces);
    }
    let mut known = unit(model.base_node());
    turn(&mut known, chain.base.amplitude, chain.base.phase);
    let base = known.clone();
    let mut loads = pulls(&model, &known, omega);
    for (mass, load) in &chain.loads {
        add(&mut loads.re, *mass, load.amplitude * load.phase.cos());
        add(&mut loads.im, *mass, load.amplitude * load.phase.sin());
    }
    // Every mass may be held by a support.
    let response = if roots.is_empty() {
        DVector::zeros(0)
    } else {
        let response = matrix.lu().solve(&sums(&loads));
        response.ok_or(JointError::Number("the frequency"))?
    };
    let mut shape = base;
    for (&root, value) in roots.iter().zip(response.iter()) {
        let unit = unit(root);
        for (node, one) in unit.re.iter().enumerate() {
            add(&mut shape.re, node, one * value.re);
            add(&mut shape.im, node, one * value.im);
        }
    }
    if shape
        .re
        .iter()
        .chain(&shape.im)
        .any(|value| !value.is_finite())
    {
        return Err(JointError::Number("the frequency"));
    }
    Ok(answer(&model, &tree, chain, &shape))
}

/// Returns the common frequency of all loads.
fn frequency(chain: &Chain) -> Result<f64, JointError> {
    let waves = chain
        .loads
        .iter()
        .map(|(_, wave)| wave)
        .chain([&chain.base]);
    let mut found = waves
        .filter(|wave| wave.amplitude != 0.0)
        .map(|wave| wave.omega);
    let omega = found.next().ok_or(JointError::Number("the load"))?;
    if omega > 0.0 && found.all(|other| other == omega) {
        Ok(omega)
    } else {
        Err(JointError::Number("the frequency of the loads"))
    }
}

/// Multiplies real displacements by a complex amplitude.
fn turn(shape: &mut Shape, amplitude: f64, phase: f64) {
    for (re, im) in shape.re.iter_mut().zip(&mut shape.im) {
        (*re, *im) = (*re * amplitude * phase.cos(), *re * amplitude * phase.sin());
    }
}

/// Returns the forces of springs, dashpots and elastic contacts for vibrating displacements.
fn pulls(model: &Model, shape: &Shape, omega: f64) -> Shape {
    let speed = |values: &[f64], factor: f64| values.iter().map(|x| factor * x).collect::<Vec<_>>();
    let mut re = model.forces(&shape.re, &speed(&shape.im, -omega), |_| 0.0, None);
    let mut im = model.forces(&shape.im, &speed(&shape.re, omega), |_| 0.0, None);
    for contact in &model.contacts {
        if let Some(stiffness) = contact.stiffness.filter(|_| !contact.is_free()) {
            contact.pull(&mut re, stiffness * contact.across(&shape.re));
            contact.pull(&mut im, stiffness * contact.across(&shape.im));
        }
    }
    Shape { re, im }
}

/// Computes the contact forces and the limit of the stuck state from the displacements.
fn answer(model: &Model, tree: &Tree, chain: &Chain, shape: &Shape) -> StuckResponse {
    let omega = frequency(chain).unwrap_or(0.0);
    let mut pulls = pulls(model, shape, omega);
    for (mass, load) in &chain.loads {
        add(&mut pulls.re, *mass, load.amplitude * load.phase.cos());
        add(&mut pulls.im, *mass, load.amplitude * load.phase.sin());
    }
    let held = |forces: &[f64], place: &[f64]| {
        let mut holds = vec![0.0; model.contacts.len()];
        let base = -omega * omega * at(place, model.base_node());
        tree.accelerate(model, forces, base, &mut holds);
        holds
    };
    let (re, im) = (held(&pulls.re, &shape.re), held(&pulls.im, &shape.im));
    let contacts = model.contacts.iter().enumerate();
    let forces: Vec<f64> = contacts
        .map(|(j, contact)| match contact.stiffness {
            _ if contact.is_free() => 0.0,
            Some(stiffness) => {
                stiffness * contact.across(&shape.re).hypot(contact.across(&shape.im))
            }
            None => at(&re, j).hypot(at(&im, j)),
        })
        .collect();
    let contacts = model.contacts.iter().zip(&forces).enumerate();
    let factors = contacts.filter(|(_, (contact, _))| !contact.is_free());
    let limit = factors
        .map(|(j, (contact, force))| (force / (contact.stiction * contact.level.constant), j))
        .reduce(|best, other| if other.0 > best.0 { other } else { best });
    let masses = shape.re.iter().zip(&shape.im).take(model.wall());
    let complex = masses.clone().map(|(re, im)| Complex::new(*re, *im));
    StuckResponse {
        displacements: complex.collect(),
        amplitudes: masses.map(|(re, im)| re.hypot(*im)).collect(),
        forces,
        limit,
    }
}

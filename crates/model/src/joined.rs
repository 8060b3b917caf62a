//! Modal data and the damping matrix of scenes with several contacts or dashpots.

use crate::modal::Modal;
use crate::scene::{ContactSides, Damping, Node, Scene};
use crate::sensitivity::Quantity;
use frictiongen_kernel::Float;
use frictiongen_kernel::joints::{Contact, Curve, Heap, Link, Model, Wave};
use frictiongen_kernel::number::dd::Dd;

/// Natural frequencies of at most this fraction of the largest natural frequency count as 0. They belong to rigid-body
/// modes, in which no spring deforms.
const RIGID: f64 = 1e-13;

/// Returns the modal data with natural frequencies of exactly 0 for rigid-body modes, in which no spring deforms.
#[must_use]
pub fn at_rest<T: Float>(scene: &Scene, mut modal: Modal<T>) -> Modal<T> {
    let most = modal.resonances.iter().map(|root| root.to_f64());
    let most = most.fold(0.0, f64::max);
    for (root, ratio) in modal.resonances.iter_mut().zip(&mut modal.damping_ratios) {
        if root.to_f64() <= RIGID * most {
            *root = T::constant(0.0);
            if matches!(scene.damping, Damping::Rayleigh { .. }) {
                *ratio = T::constant(0.0);
            }
        }
    }
    modal
}

/// Returns the damping matrix of the field `damping` by rows, in the units of the description. Without damping the
/// list is empty. Modal damping has no effect on a rigid-body mode, in which no spring deforms. `modal` is the result
/// of [`at_rest`].
#[must_use]
pub fn damping_matrix(scene: &Scene, modal: &Modal) -> Vec<Vec<f64>> {
    let matrix = damping_rows(scene, modal, |_, value| Dd::from(value));
    let rounded = |row: Vec<Dd>| row.into_iter().map(|entry| entry.to_f64()).collect();
    matrix.into_iter().map(rounded).collect()
}

/// Returns the rows of [`damping_matrix`] in the number type of the modal data, which may have a derivative. `number`
/// converts the value of a mass, spring or damping number of the scene to this type.
#[must_use]
pub fn damping_rows<T: Float>(
    scene: &Scene,
    modal: &Modal<T>,
    number: impl Fn(Quantity, f64) -> T,
) -> Vec<Vec<T>> {
    match scene.damping {
        Damping::None => Vec::new(),
        Damping::Uniform(_) | Damping::Modal(_) => of_modes(scene, modal, number),
        Damping::Rayleigh { mass, stiffness } => {
            let mass = number(Quantity::MassDamping, mass);
            let stiffness = number(Quantity::StiffnessDamping, stiffness);
            rayleigh(scene, (mass, stiffness), number)
        }
    }
}

/// Returns the chain of a scene without loads, friction, stops and moving surfaces. `loaded` contains the indices of the
/// masses on which a load can act. `modal` is the result of [`at_rest`].
#[must_use]
pub fn unloaded<S: Float>(scene: &Scene, modal: &Modal, loaded: &[usize]) -> Model<S, Heap> {
    let masses = scene.masses.len();
    let link = |from, to, value: f64| -> Option<Link<S>> {
        let (plus, minus) = numbered(masses, from, to)?;
        Some((plus, minus, S::constant(value)))
    };
    let springs = scene.springs.iter();
    let dampers = scene.joints.dampers.iter();
    let damping = damping_matrix(scene, modal).into_iter().flatten();
    let contacts = scene.named_contacts().into_iter().filter_map(|contact| {
        let (plus, minus) = numbered(masses, contact.sides.from, contact.sides.to)?;
        Some(Contact {
            plus,
            minus,
            level: Wave::zero(),
            stiction: S::constant(contact.law.stiction),
            stiffness: contact.law.stiffness.map(S::constant),
            speed: S::constant(0.0),
            stop: None,
        })
    });
    let mut model = Model {
        size: Heap {
            masses,
            contacts: scene.named_contacts().len(),
            loads: loaded.len(),
        },
        masses: scene
            .masses
            .iter()
            .map(|mass| S::constant(mass.value))
            .collect(),
        springs: springs
            .filter_map(|spring| link(spring.from, spring.to, spring.stiffness))
            .collect(),
        dashpots: dampers
            .filter_map(|damper| link(damper.from, damper.to, damper.coefficient))
            .collect(),
        damping: damping.map(S::constant).collect(),
        damping_from_base: scene.is_damped_from_base(),
        contacts: contacts.collect(),
        law: Vec::new(),
        loads: loaded.iter().map(|mass| (*mass, Wave::zero())).collect(),
        base: Curve::zero(),
        stretch: S::constant(1.0),
    };
    model.set_stretch();
    model
}

/// Returns the damping matrix Σ 2ζω (Mφ)(Mφ)ᵀ/m₁ over the modes. M is the mass matrix, and the mode shapes φ are
/// normalised to φᵀMφ = m₁.
fn of_modes<T: Float>(
    scene: &Scene,
    modal: &Modal<T>,
    number: impl Fn(Quantity, f64) -> T,
) -> Vec<Vec<T>> {
    let masses = scene.masses.iter().enumerate();
    let masses: Vec<T> = masses
        .map(|(index, mass)| number(Quantity::Mass(index), mass.value))
        .collect();
    let zero = T::constant(0.0);
    let first = masses.first().copied().unwrap_or(T::constant(1.0));
    let mut matrix = vec![vec![zero; masses.len()]; masses.len()];
    let rates = modal.natural_frequencies().into_iter();
    let modes = rates.zip(&modal.damping_ratios).zip(&modal.shapes);
    for ((rate, ratio), shape) in modes {
        let factor = T::constant(2.0) * *ratio * rate / first;
        let moments = shape.iter().zip(&masses);
        let moments: Vec<T> = moments.map(|(shape, mass)| *shape * *mass).collect();
        for (row, left) in matrix.iter_mut().zip(&moments) {
            for (entry, right) in row.iter_mut().zip(&moments) {
                *entry = *entry + factor * *left * *right;
            }
        }
    }
    matrix
}

/// Returns the damping matrix aM + bK of Rayleigh damping, from the factors a and b.
fn rayleigh<T: Float>(
    scene: &Scene,
    (mass, stiffness): (T, T),
    number: impl Fn(Quantity, f64) -> T,
) -> Vec<Vec<T>> {
    let count = scene.masses.len();
    let mut matrix = vec![vec![T::constant(0.0); count]; count];
    let mut add = |row: usize, column: usize, value: T| {
        if let Some(entry) = matrix.get_mut(row).and_then(|row| row.get_mut(column)) {
            *entry = *entry + value;
        }
    };
    for (index, own) in scene.masses.iter().enumerate() {
        add(
            index,
            index,
            mass * number(Quantity::Mass(index), own.value),
        );
    }
    for (index, spring) in scene.springs.iter().enumerate() {
        let value = stiffness * number(Quantity::Stiffness(index), spring.stiffness);
        let ends = [spring.from, spring.to].map(|node| match node {
            Node::Mass(mass) => Some(mass),
            Node::Base | Node::Wall => None,
        });
        for end in ends.into_iter().flatten() {
            add(end, end, value);
        }
        if let [Some(a), Some(b)] = ends {
            add(a, b, -value);
            add(b, a, -value);
        }
    }
    matrix
}

/// Returns true if the node whose motion counts as positive is the second of two sides. [`numbered`] then exchanges the
/// two.
#[must_use]
pub fn is_turned(masses: usize, sides: ContactSides) -> bool {
    let number = |node| match node {
        Node::Mass(index) => index,
        Node::Wall => masses,
        Node::Base => masses + 1,
    };
    numbered(masses, sides.from, sides.to).is_some_and(|(plus, _)| plus != number(sides.from))
}

/// Returns the numbers of the two nodes of a spring, dashpot or contact. The numbers of the masses are their indices.
/// The wall and the base have the next two numbers. The node whose motion counts as positive comes first: the later
/// mass, or the mass if the other node is a support. Returns `None` if a node does not exist, if both nodes are the
/// same, or if neither is a mass.
#[must_use]
pub fn numbered(masses: usize, from: Node, to: Node) -> Option<(usize, usize)> {
    let number = |node| match node {
        Node::Mass(index) => (index < masses).then_some(index),
        Node::Wall => Some(masses),
        Node::Base => Some(masses + 1),
    };
    let (from, to) = (number(from)?, number(to)?);
    let (low, high) = (from.min(to), from.max(to));
    if from == to || low >= masses {
        return None;
    }
    Some(if high >= masses {
        (low, high)
    } else {
        (high, low)
    })
}

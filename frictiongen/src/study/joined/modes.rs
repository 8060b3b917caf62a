//! Damped modes of a chain with each set of its contacts stuck.

use super::error::JoinedError;
use super::scene::Joined;
use crate::Complex;
use crate::study::joints::Chain;
use crate::study::large::singular;
use crate::study::system::System;
use frictiongen_kernel::Float;
use frictiongen_model::scene::Node;
use nalgebra::{DMatrix, DVector, Schur};

/// Largest number of contacts for which the list contains every set of stuck contacts. With more contacts it contains
/// no contact, each contact alone, and all contacts.
const ALL_SETS: usize = 4;
/// Largest natural frequency of a rigid-body mode, divided by the largest natural frequency. Rounding causes it.
const RIGID: f64 = 1e-13;
/// Largest |Im λ| of a root λ that counts as real, divided by |λ|. Rounding splits a double root by about this much.
const CRITICAL: f64 = 1e-7;
/// Largest damping ratio of a root that counts as undamped. Rounding causes it.
const UNDAMPED: f64 = 1e-15;
/// Largest modulus of a root that counts as 0, divided by the largest natural frequency or damping rate of the chain.
const ZERO: f64 = 1e-12;
/// Largest number of masses for which [`Joined::resonances`] uses the coupling of the modes by damping.
const COUPLED: usize = 64;
/// Number of attempts of the eigenvalue search, each after another orthogonal transformation of the matrix.
const ATTEMPTS: u32 = 4;

/// A mode of the chain as it is, with its dashpots and its modal or Rayleigh damping. A root λ of det(λ²M + λC + K) = 0
/// belongs to the free motion exp(λt).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedMode {
    /// Natural angular frequency |λ| of an oscillation, in rad/s. It is 0 for a rigid-body mode, and for a real root.
    pub frequency: f64,
    /// Damping ratio −Re λ/|λ| of an oscillation, below 1. It is 0 for a rigid-body mode. `None` for a real root: the
    /// motion then decays without oscillation. An overdamped mode has two real roots, and is two entries of the list.
    pub damping_ratio: Option<f64>,
    /// Decay rate −Re λ, in 1/s.
    pub decay_rate: f64,
}

impl DampedMode {
    const RIGID: Self = Self {
        frequency: 0.0,
        damping_ratio: Some(0.0),
        decay_rate: 0.0,
    };

    fn of(root: Complex<f64>) -> Self {
        let size = root.norm();
        let decay_rate = match -root.re {
            rate if rate <= UNDAMPED * size => 0.0,
            rate => rate,
        };
        if root.im <= CRITICAL * size {
            return Self {
                frequency: 0.0,
                damping_ratio: None,
                decay_rate,
            };
        }
        Self {
            frequency: size,
            damping_ratio: Some(decay_rate / size),
            decay_rate,
        }
    }

    /// Returns |λ|.
    fn size(&self) -> f64 {
        self.frequency.max(self.decay_rate)
    }
}

/// The damped modes of a chain while a set of its contacts sticks. The other contacts have no friction.
#[derive(Clone, Debug, PartialEq)]
pub struct DampedModes {
    /// Names of the contacts that stick, in the order of the scene description.
    pub stuck: Vec<String>,
    /// The modes, in ascending order of |λ|.
    pub modes: Vec<DampedMode>,
}

impl<S: Float> System<S> {
    /// Returns the damped modes of the chain: natural frequencies in rad/s, damping ratios, and decay rates in 1/s. The
    /// first set of modes is that of the chain on which no contact acts, and the last set is that of the chain with
    /// all contacts stuck. With up to 4 contacts the list has every set of stuck contacts, and otherwise also each
    /// contact alone.
    ///
    /// A stuck elastic contact is a spring, and a stuck rigid contact joins its two sides. Dashpots couple the modes of
    /// the undamped chain, so that the modes differ from those of [`natural_frequencies`](Self::natural_frequencies).
    /// Stops are open, and moving bases and surfaces are at rest. The time of the computation grows with the cube of
    /// the number of masses.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: frictiongen::System = "struct Block {
    ///     masses: { block: 2 },                                // kg
    ///     springs: { base - block: 50 },                       // N/m
    ///     contacts: { pads: block - wall { stiffness: 150 } },
    ///     dampers: { base - block: 4 },                        // N·s/m
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let [free, stuck] = &block.damped_modes()?[..] else { return Err("two sets".into()) };
    /// assert!(free.stuck.is_empty() && stuck.stuck == ["pads"]);
    /// // √(k/m) and c/(2√(km)), with k = 50 and k = 50 + 150
    /// assert!((free.modes[0].frequency - 5.0).abs() < 1e-12);
    /// assert!((stuck.modes[0].frequency - 10.0).abs() < 1e-12);
    /// assert!((stuck.modes[0].damping_ratio.ok_or("real")? - 0.1).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`JoinedError::TooManyMasses`] for more than 1000 masses. [`JoinedError::Modes`] if the search for eigenvalues
    /// does not converge.
    pub fn damped_modes(&self) -> Result<Vec<DampedModes>, JoinedError> {
        self.joined()?.damped_modes()
    }
}

impl Joined<'_> {
    /// Returns the damped modes of the chain with each set of stuck contacts: see
    /// [`System::damped_modes`](crate::System::damped_modes).
    ///
    /// # Errors
    /// [`JoinedError::Modes`] if the search for eigenvalues does not converge.
    pub fn damped_modes(&self) -> Result<Vec<DampedModes>, JoinedError> {
        let chain = self.chain();
        let names = self.contact_names();
        let sets = sets(chain.contacts.len()).into_iter();
        let of_set = |stuck: u32| {
            let own = names.iter().take(chain.contacts.len()).enumerate();
            let own = own.filter(|(index, _)| is_in(stuck, *index));
            Ok(DampedModes {
                stuck: own.map(|(_, name)| name.clone()).collect(),
                modes: modes(chain, stuck, true).ok_or(JoinedError::Modes)?,
            })
        };
        sets.map(of_set).collect()
    }

    /// Returns the frequency ratio r and the damping ratio of every oscillation, for each set of stuck contacts. The
    /// damping ratio is NaN unless no contact sticks, or all contacts. For a long chain, the damping ratios leave out
    /// the coupling of the modes.
    pub(in crate::study) fn resonances(&self) -> Vec<[f64; 2]> {
        let chain = self.chain();
        let sets = sets(chain.contacts.len());
        let extremes = [sets.first().copied(), sets.last().copied()];
        let of_set = |stuck: &u32| {
            let is_extreme = extremes.contains(&Some(*stuck));
            let modes = modes(chain, *stuck, chain.masses.len() <= COUPLED);
            let modes = modes.unwrap_or_default().into_iter();
            let modes = modes.filter(|mode| 0.0 < mode.frequency);
            modes.map(move |mode| {
                let zeta = mode.damping_ratio.filter(|_| is_extreme);
                [mode.frequency / self.reference(), zeta.unwrap_or(f64::NAN)]
            })
        };
        sets.iter().flat_map(of_set).collect()
    }
}

/// Returns the sets of stuck contacts. Bit i of a set belongs to contact i. The first set is empty, and the last set
/// contains all contacts.
fn sets(contacts: usize) -> Vec<u32> {
    let all = (1_u32 << contacts) - 1;
    match contacts {
        0..=ALL_SETS => (0..=all).collect(),
        _ => {
            let single = (0..contacts).map(|one| 1 << one);
            [0].into_iter().chain(single).chain([all]).collect()
        }
    }
}

fn is_in(set: u32, contact: usize) -> bool {
    set >> contact & 1 == 1
}

/// Returns the modes of a chain in which the contacts of a set stick. If `is_coupled` is false, the function leaves out
/// the coupling of the undamped modes by damping. Returns `None` if a search for eigenvalues does not converge.
fn modes(chain: &Chain, stuck: u32, is_coupled: bool) -> Option<Vec<DampedMode>> {
    let basis = basis(chain, stuck);
    if basis.is_empty() {
        return Some(Vec::new());
    }
    let (frequencies, shapes) = undamped(chain, stuck, &basis);
    let dashpots = stretches(&chain.dashpots, chain.masses.len()) * &basis;
    let own = DMatrix::from_fn(basis.nrows(), basis.nrows(), |row, column| {
        let row = chain.damping.get(row);
        let entry = row.and_then(|row| row.get(column).copied());
        entry.unwrap_or_default()
    });
    let damping = dashpots.tr_mul(&dashpots) + basis.tr_mul(&(own * &basis));
    let damping = &shapes * damping * shapes.transpose();
    let most = frequencies.iter().copied().fold(damping.amax(), f64::max);
    let mut found = Vec::new();
    for group in groups(&damping, is_coupled) {
        let frequencies = group.iter().filter_map(|mode| frequencies.get(*mode));
        let frequencies: Vec<f64> = frequencies.copied().collect();
        let own = DMatrix::from_fn(group.len(), group.len(), |row, column| {
            let place = group.get(row).copied().zip(group.get(column).copied());
            let entry = place.and_then(|place| damping.get(place));
            entry.copied().unwrap_or_default()
        });
        let rigid = frequencies.iter().filter(|own| **own == 0.0).count();
        found.extend((0..rigid).map(|_| DampedMode::RIGID));
        let roots = match (&frequencies[..], own.get(0)) {
            ([frequency], Some(rate)) => of_one(*frequency, *rate).to_vec(),
            _ => of_several(&frequencies, &own)?,
        };
        // A rigid-body mode has one or two roots that are 0. The list has one entry for it.
        let zero = if rigid == 0 { 0.0 } else { ZERO * most };
        let roots = roots.into_iter().filter(|root| zero < root.norm());
        // The roots of an oscillation are conjugate. The list has one of them, with Im λ > 0.
        let roots = roots.filter(|root| -CRITICAL * root.norm() <= root.im);
        found.extend(roots.map(DampedMode::of));
    }
    found.sort_by(|a, b| a.size().total_cmp(&b.size()));
    Some(found)
}

impl Chain {
    /// Returns the springs of the chain, and the elastic contacts of a set that sticks, each as the spring that it is then.
    /// Bit i of the set belongs to contact i.
    pub(in crate::study) fn springs_of(
        &self,
        stuck: u32,
    ) -> impl Iterator<Item = (Node, Node, f64)> {
        let contacts = self.contacts.iter().enumerate();
        let held = contacts.filter(move |(index, _)| is_in(stuck, *index));
        let held = held.filter_map(|(_, own)| Some((own.ends.0, own.ends.1, own.stiffness?)));
        self.springs.iter().copied().chain(held)
    }

    /// Returns the node of each mass after the rigid contacts of a set have joined masses to bodies, or held them. Bit
    /// i of the set belongs to contact i. The bodies have the numbers of masses, in the order of their first masses.
    pub(in crate::study) fn nodes(&self, stuck: u32) -> Vec<Node> {
        let count = self.masses.len();
        let rigid = self.contacts.iter().enumerate();
        let rigid =
            rigid.filter(|(index, joint)| is_in(stuck, *index) && joint.stiffness.is_none());
        // Nodes with the same label move together. The last two nodes are wall and base.
        let mut labels: Vec<usize> = (0..count + 2).collect();
        for (_, joint) in rigid {
            let ends = [joint.ends.0, joint.ends.1].map(|node| match node {
                Node::Mass(mass) => labels.get(mass).copied(),
                Node::Wall => labels.get(count).copied(),
                Node::Base => labels.get(count + 1).copied(),
            });
            join(&mut labels, ends);
        }
        let (base, wall) = (labels.pop(), labels.pop());
        let mut bodies: Vec<usize> = Vec::new();
        let nodes = labels.into_iter().map(|label| match Some(label) {
            label if label == wall => Node::Wall,
            label if label == base => Node::Base,
            _ => {
                let known = bodies.iter().position(|body| *body == label);
                Node::Mass(known.unwrap_or_else(|| {
                    bodies.push(label);
                    bodies.len() - 1
                }))
            }
        });
        nodes.collect()
    }
}

/// Returns a matrix that converts coordinates of the bodies that can still move to displacements of all masses. In
/// these coordinates the mass matrix is the identity.
fn basis(chain: &Chain, stuck: u32) -> DMatrix<f64> {
    let nodes = chain.nodes(stuck);
    let mut bodies: Vec<f64> = Vec::new();
    for (node, mass) in nodes.iter().zip(&chain.masses) {
        let Node::Mass(body) = node else { continue };
        match bodies.get_mut(*body) {
            Some(body) => *body += mass,
            None => bodies.push(*mass),
        }
    }
    DMatrix::from_fn(nodes.len(), bodies.len(), |mass, body| {
        match (nodes.get(mass), bodies.get(body)) {
            (Some(Node::Mass(own)), Some(mass)) if *own == body => 1.0 / mass.sqrt(),
            _ => 0.0,
        }
    })
}

/// Gives the nodes with the first of two labels the second label.
fn join(labels: &mut [usize], ends: [Option<usize>; 2]) {
    let [Some(from), Some(to)] = ends else {
        return;
    };
    for label in labels.iter_mut().filter(|label| **label == from) {
        *label = to;
    }
}

/// Returns a matrix that converts displacements of all masses to the extensions of springs or dashpots, each times the
/// square root of its stiffness or coefficient.
fn stretches(links: &[(Node, Node, f64)], masses: usize) -> DMatrix<f64> {
    DMatrix::from_fn(links.len(), masses, |link, mass| {
        let Some((from, to, value)) = links.get(link) else {
            return 0.0;
        };
        let sign = |node: &Node| f64::from(u8::from(*node == Node::Mass(mass)));
        (sign(from) - sign(to)) * value.sqrt()
    })
}

/// Returns the natural frequencies without damping, and the mode shapes as rows. Rigid-body modes have the frequency 0.
fn undamped(chain: &Chain, stuck: u32, basis: &DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    let springs: Vec<_> = chain.springs_of(stuck).collect();
    let springs = stretches(&springs, chain.masses.len()) * basis;
    let columns = springs.column_iter();
    let columns: Vec<Vec<f64>> = columns.map(|own| own.iter().copied().collect()).collect();
    // The natural frequencies are singular values. As roots of eigenvalues of the stiffness matrix, low frequencies
    // would lose up to half of their digits.
    let (found, shapes) = singular(&columns);
    let largest = found.last().copied().unwrap_or_default();
    let frequencies = found.into_iter().map(|own| match own {
        own if own <= RIGID * largest => 0.0,
        own => own,
    });
    let shapes = DMatrix::from_fn(basis.ncols(), basis.ncols(), |mode, body| {
        let entry = shapes.get(mode).and_then(|shape| shape.get(body));
        entry.copied().unwrap_or_default()
    });
    (frequencies.collect(), shapes)
}

/// Returns the modes in groups. Damping couples only modes of the same group.
fn groups(damping: &DMatrix<f64>, is_coupled: bool) -> Vec<Vec<usize>> {
    let count = damping.nrows();
    let rounding = 4.0 * count as f64 * f64::EPSILON * damping.amax();
    let mut labels: Vec<usize> = (0..count).collect();
    for row in 0..count {
        for column in 0..row {
            let entry = damping.get((row, column)).copied().unwrap_or_default();
            let own = [row, column].map(|mode| labels.get(mode).copied());
            if is_coupled && rounding < entry.abs() && own[0] != own[1] {
                join(&mut labels, own);
            }
        }
    }
    let of_label = |label: usize| {
        let modes = labels.iter().enumerate();
        let modes = modes.filter(move |(_, own)| **own == label);
        modes.map(|(mode, _)| mode).collect::<Vec<usize>>()
    };
    let groups = (0..count).map(of_label);
    groups.filter(|group| !group.is_empty()).collect()
}

/// Returns the roots of λ² + `rate` λ + `frequency`² = 0.
fn of_one(frequency: f64, rate: f64) -> [Complex<f64>; 2] {
    let half = 0.5 * rate;
    let under = (frequency - half) * (frequency + half);
    if under.abs() <= (CRITICAL * frequency).powi(2) {
        return [Complex::new(-frequency, 0.0); 2];
    }
    if 0.0 < under {
        let root = Complex::new(-half, under.sqrt());
        return [root, root.conj()];
    }
    // The difference of `half` and the square root would lose the digits of the slower decay.
    let fast = half + (-under).sqrt();
    [frequency * frequency / fast, fast].map(|rate| Complex::new(-rate, 0.0))
}

/// Returns the roots of several modes that damping couples. `damping` is their damping matrix. The roots leave out one
/// zero for each rigid-body mode.
fn of_several(frequencies: &[f64], damping: &DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let count = frequencies.len();
    let waves = frequencies.iter().copied().enumerate();
    let waves: Vec<(usize, f64)> = waves.filter(|(_, own)| 0.0 < *own).collect();
    // The state has the velocities of the modes, and then their displacements times their natural frequencies. Without
    // damping its matrix is skew, so that its eigenvalues are well conditioned.
    let wave = |state: usize, mode: usize| {
        let own = state.checked_sub(count).and_then(|place| waves.get(place));
        own.filter(|(own, _)| *own == mode)
            .map(|(_, frequency)| *frequency)
    };
    let size = count + waves.len();
    let mut matrix = DMatrix::from_fn(size, size, |row, column| {
        let entry = damping
            .get((row, column))
            .filter(|_| row < count && column < count);
        let between = wave(row, column).or_else(|| wave(column, row).map(|own| -own));
        entry.map_or_else(|| between.unwrap_or_default(), |entry| -entry)
    });
    for attempt in 1..=ATTEMPTS {
        if let Some(found) = Schur::try_new(matrix.clone(), f64::EPSILON, 30 * size) {
            return Some(found.complex_eigenvalues().iter().copied().collect());
        }
        // The search may repeat the same matrix for ever. A reflection keeps the eigenvalues.
        let axis = DVector::from_fn(size, |row, _| (f64::from(attempt) + row as f64).sin());
        let axis = axis.normalize();
        let reflection = DMatrix::identity(size, size) - 2.0 * &axis * axis.transpose();
        matrix = &reflection * matrix * &reflection;
    }
    None
}

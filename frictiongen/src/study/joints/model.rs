//! A chain that has been checked, with its nodes numbered.

use super::series::{Poly, TERMS};
use super::{Chain, JointError, MAX_CONTACTS, MAX_MASSES, Wave};
use frictiongen_model::scene::Node;

/// A spring or a dashpot: two nodes and a coefficient.
type Link = (usize, usize, f64);

/// A contact with numbered nodes.
#[derive(Clone, Debug)]
pub struct Contact {
    /// The node whose displacement counts positive in z.
    pub plus: usize,
    /// The other node.
    pub minus: usize,
    /// Level of the kinetic friction.
    pub level: Wave,
    /// Static over kinetic friction.
    pub stiction: f64,
    /// Stiffness; `None` if rigid.
    pub stiffness: Option<f64>,
}

impl Contact {
    /// Returns true if the contact has no force.
    pub fn is_free(&self) -> bool {
        self.level.is_zero()
    }

    /// Returns whether the contact is rigid.
    pub fn is_rigid(&self) -> bool {
        self.stiffness.is_none()
    }

    /// Returns the difference of a quantity between both nodes.
    pub fn across(&self, nodes: &[f64]) -> f64 {
        at(nodes, self.plus) - at(nodes, self.minus)
    }

    /// Subtracts the contact's force at the one node and adds it at the other.
    pub fn pull(&self, nodes: &mut [f64], force: f64) {
        add(nodes, self.plus, -force);
        add(nodes, self.minus, force);
    }
}

/// A checked chain. The nodes are the masses, then the wall, then the base.
#[derive(Clone, Debug)]
pub struct Model {
    /// The masses.
    pub masses: Vec<f64>,
    pub(super) springs: Vec<Link>,
    pub(super) dashpots: Vec<Link>,
    pub(super) damping: Vec<Vec<f64>>,
    damping_from_base: bool,
    /// The contacts.
    pub contacts: Vec<Contact>,
    loads: Vec<(usize, Wave)>,
    /// The displacement of the base.
    pub base: Wave,
    /// Longest stretch of the series.
    pub stretch: f64,
}

/// Returns one number of a list. Every index of a checked chain is valid.
pub fn at(nodes: &[f64], index: usize) -> f64 {
    nodes.get(index).copied().unwrap_or(0.0)
}

/// Adds to one number of a list.
pub fn add(nodes: &mut [f64], index: usize, value: f64) {
    if let Some(node) = nodes.get_mut(index) {
        *node += value;
    }
}

impl Model {
    /// Checks a chain.
    pub fn new(chain: &Chain) -> Result<Self, JointError> {
        let count = chain.masses.len();
        if !(1..=MAX_MASSES).contains(&count) || chain.contacts.len() > MAX_CONTACTS {
            return Err(JointError::Size);
        }
        check_numbers(chain)?;
        let links = |links: &[(Node, Node, f64)], what| {
            let numbered = links.iter().map(|&(from, to, value)| {
                ends(count, (from, to), what).map(|(plus, minus)| (plus, minus, value))
            });
            numbered.collect::<Result<Vec<Link>, JointError>>()
        };
        let contacts = chain.contacts.iter().map(|joint| {
            let (plus, minus) = ends(count, joint.ends, "a contact")?;
            Ok(Contact {
                plus,
                minus,
                level: joint.level,
                stiction: joint.stiction,
                stiffness: joint.stiffness,
            })
        });
        if chain.loads.iter().any(|&(mass, _)| mass >= count) {
            return Err(JointError::Ends("a load"));
        }
        let mut model = Self {
            masses: chain.masses.clone(),
            springs: links(&chain.springs, "a spring")?,
            dashpots: links(&chain.dashpots, "a dashpot")?,
            damping: chain.damping.clone(),
            damping_from_base: chain.damping_from_base,
            contacts: contacts.collect::<Result<_, JointError>>()?,
            loads: chain.loads.clone(),
            base: chain.base,
            stretch: 0.0,
        };
        model.check_redundant()?;
        model.stretch = model.longest_stretch();
        Ok(model)
    }

    /// Number of masses, which is the node of the wall.
    pub fn wall(&self) -> usize {
        self.masses.len()
    }

    /// The node of the base.
    pub fn base_node(&self) -> usize {
        self.masses.len() + 1
    }

    /// Returns the term of one order of all forces but those of contacts, by node, from the terms of displacements and
    /// velocities. `loads` has the term of each load. `size` gathers the sum of absolute values, if it is given.
    pub fn forces(
        &self,
        x: &[f64],
        v: &[f64],
        loads: &[f64],
        mut size: Option<&mut Vec<f64>>,
    ) -> Vec<f64> {
        let mut force = vec![0.0; self.masses.len() + 2];
        let mut put = |node: usize, value: f64| {
            add(&mut force, node, value);
            if let Some(size) = size.as_deref_mut() {
                add(size, node, value.abs());
            }
        };
        for ((mass, _), load) in self.loads.iter().zip(loads) {
            put(*mass, *load);
        }
        let springs = self.springs.iter().map(|link| (link, x));
        for (&(plus, minus, value), nodes) in
            springs.chain(self.dashpots.iter().map(|link| (link, v)))
        {
            let pull = value * (at(nodes, plus) - at(nodes, minus));
            put(plus, -pull);
            put(minus, pull);
        }
        let base = if self.damping_from_base {
            at(v, self.base_node())
        } else {
            0.0
        };
        for (row, coefficients) in self.damping.iter().enumerate() {
            let sum: f64 = coefficients
                .iter()
                .zip(v)
                .map(|(c, v)| c * (v - base))
                .sum();
            put(row, -sum);
        }
        force
    }

    /// Returns the terms of each load over a stretch.
    pub fn load_terms(&self, time: f64, length: f64) -> Vec<Poly> {
        let loads = self.loads.iter();
        loads
            .map(|(_, wave)| super::series::wave_terms(wave, time, length, 0))
            .collect()
    }

    /// Returns the value of each load.
    pub fn load_values(&self, time: f64) -> Vec<f64> {
        let terms = self.load_terms(time, 0.0);
        terms.iter().map(|terms| at(terms, 0)).collect()
    }

    /// Changes a load, and returns by how much its value at an instant jumps.
    pub fn change_load(&mut self, load: usize, to: Wave, time: f64) -> Option<f64> {
        let (_, wave) = self.loads.get_mut(load)?;
        let value = |wave: &Wave| at(&super::series::wave_terms(wave, time, 0.0, 0), 0);
        let jump = value(&to) - value(wave);
        *wave = to;
        Some(jump)
    }

    /// Returns the power of the loads at given velocities.
    pub fn load_power(&self, time: f64, v: &[f64]) -> f64 {
        let values = self.load_values(time);
        let powers = self.loads.iter().zip(values);
        powers.map(|((mass, _), load)| load * at(v, *mass)).sum()
    }

    /// Refuses rigid contacts that close a loop, the wall and the base counted as one.
    fn check_redundant(&self) -> Result<(), JointError> {
        let ground = |node: usize| node.min(self.wall());
        let mut tree: Vec<(usize, usize, usize)> = Vec::new();
        for (index, contact) in self.contacts.iter().enumerate() {
            if !contact.is_rigid() {
                continue;
            }
            let (from, to) = (ground(contact.plus), ground(contact.minus));
            if let Some(mut loop_) = path(&tree, from, to) {
                loop_.push(index);
                loop_.sort_unstable();
                return Err(JointError::Redundant(loop_));
            }
            tree.push((from, to, index));
        }
        Ok(())
    }

    /// One over a bound on the fastest rate: Gershgorin's circles of M⁻¹K and of M⁻¹C, elastic contacts counted as
    /// springs. A rate s obeys s² ≤ C s + K in norms.
    fn longest_stretch(&self) -> f64 {
        let mut stiff = vec![0.0; self.masses.len() + 2];
        let mut slow = stiff.clone();
        let elastic = self.contacts.iter();
        let elastic =
            elastic.filter_map(|c| c.stiffness.map(|stiffness| (c.plus, c.minus, stiffness)));
        for (plus, minus, value) in self.springs.iter().copied().chain(elastic) {
            self.circle(&mut stiff, (plus, minus, value));
        }
        for link in &self.dashpots {
            self.circle(&mut slow, *link);
        }
        for (row, coefficients) in self.damping.iter().enumerate() {
            add(
                &mut slow,
                row,
                coefficients.iter().map(|c| c.abs()).sum::<f64>(),
            );
        }
        let largest = |values: &[f64]| {
            let rates = values.iter().zip(&self.masses).map(|(k, m)| k / m);
            rates.fold(0.0, f64::max)
        };
        let (stiff, slow) = (largest(&stiff), largest(&slow) / 2.0);
        let waves = self.loads.iter().map(|(_, wave)| wave);
        let waves = waves.chain(self.contacts.iter().map(|contact| &contact.level));
        let waves = waves.chain([&self.base]).filter(|w| w.amplitude != 0.0);
        let waves = waves.map(|wave| wave.omega.abs()).fold(0.0, f64::max);
        1.0 / (slow + (slow * slow + stiff).sqrt()).max(waves)
    }

    /// Adds a link to the circles of its two rows.
    fn circle(&self, circles: &mut [f64], (plus, minus, value): Link) {
        let both = plus.max(minus) < self.masses.len();
        let value = if both { 2.0 * value } else { value };
        add(circles, plus, value);
        add(circles, minus, value);
    }
}

/// Numbers two ends, the positive one first: the later mass, or the mass where the other is a support.
fn ends(
    masses: usize,
    (from, to): (Node, Node),
    what: &'static str,
) -> Result<(usize, usize), JointError> {
    let number = |node| match node {
        Node::Mass(index) if index < masses => Ok(index),
        Node::Mass(_) => Err(JointError::Ends(what)),
        Node::Wall => Ok(masses),
        Node::Base => Ok(masses + 1),
    };
    let (from, to) = (number(from)?, number(to)?);
    let support = from.max(to) >= masses;
    if from == to || from.min(to) >= masses {
        return Err(JointError::Ends(what));
    }
    Ok(if support {
        (from.min(to), from.max(to))
    } else {
        (from.max(to), from.min(to))
    })
}

/// Refuses numbers that cannot be.
fn check_numbers(chain: &Chain) -> Result<(), JointError> {
    let positive = |value: f64| value > 0.0 && value.is_finite();
    let checks = [
        (chain.masses.iter().all(|&m| positive(m)), "a mass"),
        (
            chain.springs.iter().all(|spring| positive(spring.2)),
            "a stiffness of a spring",
        ),
        (
            chain.dashpots.iter().all(|dashpot| positive(dashpot.2)),
            "a coefficient of a dashpot",
        ),
        (
            chain.damping.iter().flatten().all(|c| c.is_finite())
                && chain.damping.len() <= chain.masses.len(),
            "an entry of the damping matrix",
        ),
        (
            chain.loads.iter().all(|(_, load)| load.is_finite()) && chain.base.is_finite(),
            "a load",
        ),
        (
            chain
                .contacts
                .iter()
                .all(|c| level_fits(&c.level, c.stiffness.is_none())),
            "the level of a contact",
        ),
        (
            chain
                .contacts
                .iter()
                .all(|c| c.stiction >= 1.0 && c.stiction.is_finite()),
            "the stiction of a contact",
        ),
        (
            chain
                .contacts
                .iter()
                .all(|c| c.stiffness.is_none_or(positive)),
            "the stiffness of a contact",
        ),
    ];
    match checks.iter().find(|(fits, _)| !fits) {
        Some((_, what)) => Err(JointError::Number(what)),
        None => Ok(()),
    }
}

/// Returns true if a contact, rigid or not, can have a level.
pub fn level_fits(level: &Wave, rigid: bool) -> bool {
    level.is_finite()
        && if level.amplitude == 0.0 && level.slope == 0.0 {
            level.constant >= 0.0
        } else {
            rigid
        }
}

/// Returns the contacts on the way between two nodes of a forest.
fn path(tree: &[(usize, usize, usize)], from: usize, to: usize) -> Option<Vec<usize>> {
    let mut ways = vec![(from, Vec::<usize>::new())];
    while let Some((node, way)) = ways.pop() {
        if node == to {
            return Some(way);
        }
        for &(a, b, contact) in tree {
            let next = match node {
                node if node == a => b,
                node if node == b => a,
                _ => continue,
            };
            if !way.contains(&contact) {
                ways.push((next, way.iter().copied().chain([contact]).collect()));
            }
        }
    }
    None
}

// The terms of a series have one length.
const _: () = assert!(TERMS > 20);

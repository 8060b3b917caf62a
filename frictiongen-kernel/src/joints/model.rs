//! The constants of a chain, with its nodes numbered, and the forces on its nodes.

use super::base::Curve;
use super::series::Poly;
use super::size::{Size, add, at};
use super::wave::Wave;
use crate::Float;

/// A spring or a dashpot: two nodes and a coefficient.
pub type Link<S> = (usize, usize, S);

/// A contact with numbered nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S> {
    /// The node whose displacement counts positive in z.
    pub plus: usize,
    /// The other node.
    pub minus: usize,
    /// Level of the kinetic friction.
    pub level: Wave<S>,
    /// Static over kinetic friction.
    pub stiction: S,
    /// Stiffness; `None` if rigid.
    pub stiffness: Option<S>,
}

impl<S: Float> Contact<S> {
    /// Returns true if the contact has no force.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.level.is_zero()
    }

    /// Returns whether the contact is rigid.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        self.stiffness.is_none()
    }

    /// Returns the difference of a quantity between both nodes.
    #[must_use]
    pub fn across(&self, nodes: &[S]) -> S {
        at(nodes, self.plus) - at(nodes, self.minus)
    }

    /// Subtracts the contact's force at the one node and adds it at the other.
    pub fn pull(&self, nodes: &mut [S], force: S) {
        add(nodes, self.plus, -force);
        add(nodes, self.minus, force);
    }

    /// Returns true if the contact can have a level: a constant that is not negative, or, for a rigid contact, a function
    /// of time.
    #[must_use]
    pub fn fits(&self, level: &Wave<S>) -> bool {
        let varies = !level.amplitude.is_zero() || !level.slope.is_zero();
        level.is_finite()
            && if varies {
                self.is_rigid()
            } else {
                level.constant >= S::constant(0.0)
            }
    }
}

/// A chain whose numbers and nodes have been checked. The nodes are the masses, then the wall, then the base.
#[derive(Clone, Debug)]
pub struct Model<S: Float, Z: Size> {
    /// Numbers of masses, contacts and loads.
    pub size: Z,
    /// The masses.
    pub masses: Z::Constants<S>,
    /// The springs.
    pub springs: Z::Constants<Link<S>>,
    /// The dashpots.
    pub dashpots: Z::Constants<Link<S>>,
    /// The matrix of modal or Rayleigh damping, row after row, or nothing.
    pub damping: Z::Constants<S>,
    /// True if this matrix acts on velocities relative to the base. False if it acts on absolute velocities.
    pub damping_from_base: bool,
    /// The contacts.
    pub contacts: Z::Contacts<Contact<S>>,
    /// Forces on masses.
    pub loads: Z::Loads<(usize, Wave<S>)>,
    /// The displacement of the base.
    pub base: Curve<S>,
    /// Longest stretch of the series.
    pub stretch: S,
}

impl<S: Float, Z: Size> Model<S, Z> {
    /// Number of masses, which is the node of the wall.
    pub fn wall(&self) -> usize {
        self.masses().len()
    }

    /// The node of the base.
    pub fn base_node(&self) -> usize {
        self.wall() + 1
    }

    /// Returns the masses.
    pub fn masses(&self) -> &[S] {
        self.masses.as_ref()
    }

    /// Returns the contacts.
    pub fn contacts(&self) -> &[Contact<S>] {
        self.contacts.as_ref()
    }

    /// Returns one contact.
    pub fn contact(&self, contact: usize) -> Option<&Contact<S>> {
        self.contacts().get(contact)
    }

    /// Returns the rows of the damping matrix.
    pub fn damping_rows(&self) -> impl Iterator<Item = &[S]> {
        self.damping.as_ref().chunks(self.wall().max(1))
    }

    /// Returns the term of one order of all forces but those of contacts, by node, from the terms of displacements and
    /// velocities. `load` has the term of each load. `size` gathers the sum of absolute values, if it is given.
    pub fn forces(
        &self,
        x: &[S],
        v: &[S],
        load: impl Fn(usize) -> S,
        mut size: Option<&mut Z::Nodes<S>>,
    ) -> Z::Nodes<S> {
        let mut force = self.size.nodes(S::constant(0.0));
        let mut put = |node: usize, value: S| {
            add(force.as_mut(), node, value);
            if let Some(size) = size.as_deref_mut() {
                add(size.as_mut(), node, value.abs());
            }
        };
        for (index, (mass, _)) in self.loads.as_ref().iter().enumerate() {
            put(*mass, load(index));
        }
        let springs = self.springs.as_ref().iter().map(|link| (link, x));
        let dashpots = self.dashpots.as_ref().iter().map(|link| (link, v));
        for (&(plus, minus, value), nodes) in springs.chain(dashpots) {
            let pull = value * (at(nodes, plus) - at(nodes, minus));
            put(plus, -pull);
            put(minus, pull);
        }
        let base = if self.damping_from_base {
            at(v, self.base_node())
        } else {
            S::constant(0.0)
        };
        for (row, coefficients) in self.damping_rows().enumerate() {
            let products = coefficients.iter().zip(v);
            let sum = products.fold(S::constant(0.0), |sum, (c, v)| sum + *c * (*v - base));
            put(row, -sum);
        }
        force
    }

    /// Returns the terms of each load over a stretch.
    pub(super) fn load_terms(&self, time: S, length: S) -> impl Iterator<Item = Poly<S>> {
        let loads = self.loads.as_ref().iter();
        loads.map(move |(_, wave)| wave.terms(time, length, 0))
    }

    /// Returns the value of a load at an instant.
    pub fn load_value(&self, load: usize, time: S) -> S {
        let load = self.loads.as_ref().get(load);
        load.map_or(S::constant(0.0), |(_, wave)| wave.value(time, 0))
    }

    /// Changes a load, and returns by how much its value at an instant jumps.
    pub(super) fn change_load(&mut self, load: usize, to: Wave<S>, time: S) -> Option<S> {
        let (_, wave) = self.loads.as_mut().get_mut(load)?;
        let jump = to.value(time, 0) - wave.value(time, 0);
        *wave = to;
        Some(jump)
    }

    /// Returns the power of the loads at given velocities.
    pub fn load_power(&self, time: S, v: &[S]) -> S {
        let loads = self.loads.as_ref().iter();
        loads.fold(S::constant(0.0), |power, (mass, wave)| {
            power + wave.value(time, 0) * at(v, *mass)
        })
    }

    /// Sets the longest stretch to one over a bound on the fastest rate: Gershgorin's circles of M⁻¹K and of M⁻¹C,
    /// elastic contacts counted as springs. A rate s obeys s² ≤ C s + K in norms.
    pub fn set_stretch(&mut self) {
        let mut stiff = self.size.nodes(S::constant(0.0));
        let mut slow = self.size.nodes(S::constant(0.0));
        let elastic = self.contacts().iter();
        let elastic =
            elastic.filter_map(|c| c.stiffness.map(|stiffness| (c.plus, c.minus, stiffness)));
        for link in self.springs.as_ref().iter().copied().chain(elastic) {
            self.circle(stiff.as_mut(), link);
        }
        for link in self.dashpots.as_ref() {
            self.circle(slow.as_mut(), *link);
        }
        for (row, coefficients) in self.damping_rows().enumerate() {
            let sizes = coefficients.iter().map(|c| c.abs());
            let sum = sizes.fold(S::constant(0.0), |sum, c| sum + c);
            add(slow.as_mut(), row, sum);
        }
        let (stiff, slow) = (self.largest(stiff.as_ref()), self.largest(slow.as_ref()));
        let slow = slow / S::constant(2.0);
        let loads = self.loads.as_ref().iter().map(|(_, wave)| wave);
        let levels = self.contacts().iter().map(|contact| &contact.level);
        let waves = loads.chain(levels).chain([&self.base.wave]);
        let waves = waves
            .map(Wave::fastest)
            .fold(S::constant(0.0), crate::Scalar::max);
        let motion = slow + (slow * slow + stiff).sqrt();
        self.stretch = S::constant(1.0) / crate::Scalar::max(motion, waves);
    }

    /// Returns the largest quotient of a number of a node and its mass.
    fn largest(&self, values: &[S]) -> S {
        let rates = values.iter().zip(self.masses()).map(|(k, m)| *k / *m);
        rates.fold(S::constant(0.0), crate::Scalar::max)
    }

    /// Adds a link to the circles of its two rows.
    fn circle(&self, circles: &mut [S], (plus, minus, value): Link<S>) {
        let both = plus.max(minus) < self.wall();
        let value = if both {
            S::constant(2.0) * value
        } else {
            value
        };
        add(circles, plus, value);
        add(circles, minus, value);
    }
}

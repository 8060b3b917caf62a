//! Constants of a chain with several contacts, and the forces on its nodes. The nodes are the masses, the wall and the
//! base. They are numbered in this order.

use super::base::Curve;
use super::poly::{Poly, angle_of, terms_of, terms_within};
use super::size::{Size, add, at};
use super::wave::Wave;
use crate::Float;

/// A spring or a dashpot of a chain: its two nodes, and its stiffness or damping coefficient.
pub type Link<S> = (usize, usize, S);

/// A contact between two nodes of a chain. A node is a mass, the wall or the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S> {
    /// First node of the contact. Its displacement x_plus has a positive sign in the relative displacement z = x_plus −
    /// x_minus.
    pub plus: usize,
    /// Second node of the contact. Its displacement x_minus has a negative sign in the relative displacement z = x_plus
    /// − x_minus.
    pub minus: usize,
    /// Kinetic friction force of the contact as a function of time. The code calls this force the level.
    pub level: Wave<S>,
    /// Ratio μ of the static friction force to the kinetic friction force.
    pub stiction: S,
    /// Stiffness of the spring in an elastic contact or a stop, or `None` for a rigid one.
    pub stiffness: Option<S>,
    /// Velocity of the surface of the second side relative to its node, for a belt. The relative velocity ż is that of
    /// the two nodes minus this velocity.
    pub speed: S,
    /// The law of a stop, or `None` for a contact with friction. A stop has no friction force.
    pub stop: Option<Stop<S>>,
}

/// A stop acts while its two nodes have come nearer than its gap: while σz > g, with the relative displacement z of
/// its nodes. Its spring then has the force k(z − σg). A shut stop has the phase [`STUCK`](super::state::STUCK), and an
/// open stop the phase [`FREE`](super::state::FREE).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop<S> {
    /// Direction σ in which the stop closes: 1 if it closes for an increasing relative displacement, otherwise −1.
    pub side: S,
    /// The gap g. A negative gap is a preload.
    pub gap: S,
    /// Coefficient of the dashpot that acts while the stop is shut. It is 0 for a stop without a spring.
    pub damping: S,
    /// Coefficient of restitution e of a stop without a spring: an impact reverses the relative velocity of the nodes and
    /// multiplies it by e.
    pub restitution: S,
}

/// The nodes of a contact, and the velocity of its moving surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sides<S> {
    pub(super) plus: usize,
    pub(super) minus: usize,
    pub(super) speed: S,
    /// Coefficient of the dashpot of a stop. `None` for a contact with friction.
    pub(super) damping: Option<S>,
}

impl<S: Float> Contact<S> {
    /// Returns true if the contact has no force, because its kinetic friction force is always 0.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.stop.is_none() && self.level.is_zero()
    }

    /// Returns true if the contact has a friction force at some instant.
    pub(super) fn has_friction(&self) -> bool {
        !self.level.is_zero()
    }

    pub(super) fn sides(&self) -> Sides<S> {
        Sides {
            plus: self.plus,
            minus: self.minus,
            speed: self.speed,
            damping: self.stop.map(|stop| stop.damping),
        }
    }

    /// Returns true if the contact is rigid. A rigid contact has no spring.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        self.stiffness.is_none()
    }

    /// Returns the value of a quantity at the node `plus` minus its value at the node `minus`. The argument `nodes`
    /// contains the values at all nodes.
    #[must_use]
    pub fn across(&self, nodes: &[S]) -> S {
        at(nodes, self.plus) - at(nodes, self.minus)
    }

    /// Returns the value of a quantity at the node `plus` minus its value at the node `minus`. `masses` contains its
    /// values at all masses, and `base` is its value at the base. At the wall its value is 0.
    pub(super) fn relative(&self, masses: &[S], base: S) -> S {
        let value = |node: usize| {
            if node > masses.len() {
                base
            } else {
                at(masses, node)
            }
        };
        value(self.plus) - value(self.minus)
    }

    /// Adds the force of the contact to the forces on its two nodes. The node `plus` receives −`force`, and the node
    /// `minus` receives +`force`.
    pub fn pull(&self, nodes: &mut [S], force: S) {
        add(nodes, self.plus, -force);
        add(nodes, self.minus, force);
    }

    /// Returns true if the kinetic friction force of the contact does not change with time.
    #[must_use]
    pub(super) fn has_constant_level(&self) -> bool {
        self.level.amplitude.is_zero() && self.level.slope.is_zero()
    }

    /// Returns true if the kinetic friction force `level` is valid for the contact. A constant force of at least 0 and
    /// a straight line are valid for every contact. A harmonic force is valid only for a rigid contact. All
    /// coefficients of the force must be finite.
    #[must_use]
    pub fn fits(&self, level: &Wave<S>) -> bool {
        let changed = Self {
            level: *level,
            ..*self
        };
        level.is_finite()
            && if changed.has_constant_level() {
                level.constant >= S::constant(0.0)
            } else {
                self.is_rigid() || level.amplitude.is_zero()
            }
    }

    /// Returns the velocity of an elastic contact's two sides relative to the slider while the contact slides forward.
    /// The force of the contact is then its kinetic friction force, so that its spring changes its length with it. The
    /// result is 0 for a rigid contact.
    pub(super) fn creep(&self) -> S {
        self.stiffness
            .map_or(S::constant(0.0), |stiffness| self.level.slope / stiffness)
    }
}

/// A chain with several contacts. Its numbers and its node indices are valid. The nodes are the masses, the wall and
/// the base, in this order.
#[derive(Clone, Debug)]
pub struct Model<S: Float, Z: Size> {
    /// Numbers of masses, contacts and loads in the chain. They determine the lengths of all arrays.
    pub size: Z,
    /// Masses of the chain, in the order of the scene description.
    pub masses: Z::Constants<S>,
    /// Springs of the chain, each with its two nodes and its stiffness.
    pub springs: Z::Constants<Link<S>>,
    /// Dashpots of the chain, each with its two nodes and its damping coefficient.
    pub dashpots: Z::Constants<Link<S>>,
    /// Matrix of modal or Rayleigh damping, row after row. It is empty if the chain has neither kind of damping.
    pub damping: Z::Constants<S>,
    /// True if the damping matrix acts on velocities relative to the base. False if it acts on absolute velocities.
    pub damping_from_base: bool,
    /// Contacts of the chain, in the order of the scene description.
    pub contacts: Z::Contacts<Contact<S>>,
    /// Points (v, φ) of the friction law of all rigid contacts, with ascending v. At the sliding speed v, the kinetic
    /// friction force is φ times the level of the contact. φ is 1 at v = 0, linear between two points, and constant
    /// beyond the last point. Without points, the kinetic friction does not depend on the speed.
    pub law: Z::Points<[S; 2]>,
    /// Loads: forces on masses as functions of time, each with the index of its mass.
    pub loads: Z::Loads<(usize, Wave<S>)>,
    /// Displacement of the base as a function of time.
    pub base: Curve<S>,
    /// Largest duration of a stretch (the time interval of one power series).
    pub stretch: S,
}

impl<S: Float, Z: Size> Model<S, Z> {
    /// Returns the index of the wall's node. It is equal to the number of masses.
    pub fn wall(&self) -> usize {
        self.masses().len()
    }

    /// Returns the index of the base's node, which follows that of the wall.
    pub fn base_node(&self) -> usize {
        self.wall() + 1
    }

    /// Returns the masses of the chain, in the order of the scene description.
    pub fn masses(&self) -> &[S] {
        self.masses.as_ref()
    }

    /// Returns the inverse of the mass of a node, which is 0 for the wall and the base.
    pub(super) fn inverse_mass(&self, node: usize) -> S {
        let mass = self.masses().get(node);
        mass.map_or(S::constant(0.0), |mass| S::constant(1.0) / *mass)
    }

    /// Returns the contacts of the chain, in the order of the scene description.
    pub fn contacts(&self) -> &[Contact<S>] {
        self.contacts.as_ref()
    }

    /// Returns one contact of the chain, or `None` for an invalid index.
    pub fn contact(&self, contact: usize) -> Option<&Contact<S>> {
        self.contacts().get(contact)
    }

    /// Returns the law of a contact that is a stop.
    pub(super) fn stop(&self, contact: usize) -> Option<Stop<S>> {
        if !Z::HAS_PARTS {
            return None;
        }
        self.contact(contact).and_then(|contact| contact.stop)
    }

    /// Returns true if a contact is a stop.
    pub(super) fn is_stop(&self, contact: usize) -> bool {
        self.stop(contact).is_some()
    }

    /// Returns true if the chain has a stop.
    pub(super) fn has_stops(&self) -> bool {
        Z::HAS_PARTS && self.contacts().iter().any(|own| own.stop.is_some())
    }

    /// Returns true if a surface of the chain moves relative to its node.
    pub(super) fn has_belts(&self) -> bool {
        Z::HAS_PARTS && self.contacts().iter().any(|own| !own.speed.is_zero())
    }

    /// Returns the velocity of the moving surface of a contact relative to its node.
    pub(super) fn speed(&self, contact: usize) -> S {
        let zero = S::constant(0.0);
        if !Z::HAS_PARTS {
            return zero;
        }
        self.contact(contact).map_or(zero, |contact| contact.speed)
    }

    /// Returns the relative velocity of a contact. `v` contains the velocities of the nodes.
    pub(super) fn slip(&self, contact: &Contact<S>, v: &[S]) -> S {
        let across = contact.across(v);
        if Z::HAS_PARTS {
            across - contact.speed
        } else {
            across
        }
    }

    /// Returns the static friction force of a contact at the instant `time`.
    pub(super) fn static_friction(&self, contact: usize, time: S) -> S {
        let contact = self.contact(contact);
        contact.map_or(S::constant(0.0), |contact| {
            contact.stiction * contact.level.value(time, 0)
        })
    }

    /// Returns the rows of the matrix of modal or Rayleigh damping.
    pub fn damping_rows(&self) -> impl Iterator<Item = &[S]> {
        self.damping.as_ref().chunks(self.wall().max(1))
    }

    /// Returns one coefficient of the power series of the force on each node, without the contact forces. The
    /// arguments `x` and `v` are the coefficients of the displacements and the velocities. The function `load` returns
    /// the coefficient of each load. If `size` is given, the function adds the absolute value of each term to `size`
    /// at the node of the term.
    pub fn forces(
        &self,
        x: &[S],
        v: &[S],
        load: impl Fn(usize) -> S,
        mut size: Option<&mut Z::Nodes<S>>,
    ) -> Z::Nodes<S> {
        let mut force = self.size.nodes(S::constant(0.0));
        self.put_forces(x, v, load, |node, value| {
            add(force.as_mut(), node, value);
            if let Some(size) = size.as_deref_mut() {
                add(size.as_mut(), node, value.abs());
            }
        });
        force
    }

    /// Computes the forces of [`forces`](Self::forces), and passes each force to `put` together with its node.
    pub(super) fn put_forces(
        &self,
        x: &[S],
        v: &[S],
        load: impl Fn(usize) -> S,
        mut put: impl FnMut(usize, S),
    ) {
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
    }

    /// Returns the power series of each load over a time interval.
    pub(super) fn load_terms(&self, time: S, length: S) -> impl Iterator<Item = Poly<S>> {
        let loads = self.loads.as_ref().iter();
        loads.map(move |(_, wave)| wave.terms(time, length, 0))
    }

    /// Returns the value of a load at the instant `time`.
    pub fn load_value(&self, load: usize, time: S) -> S {
        let load = self.loads.as_ref().get(load);
        load.map_or(S::constant(0.0), |(_, wave)| wave.value(time, 0))
    }

    /// Replaces a load by another function of time. Returns the jump of the load's value at the instant `time`, or
    /// `None` for an invalid index.
    pub(super) fn change_load(&mut self, load: usize, to: Wave<S>, time: S) -> Option<S> {
        let (_, wave) = self.loads.as_mut().get_mut(load)?;
        let jump = to.value(time, 0) - wave.value(time, 0);
        *wave = to;
        Some(jump)
    }

    /// Returns the total power of all loads at the instant `time`. `v` contains the velocities of the masses.
    pub fn load_power(&self, time: S, v: &[S]) -> S {
        let loads = self.loads.as_ref().iter();
        loads.fold(S::constant(0.0), |power, (mass, wave)| {
            power + wave.value(time, 0) * at(v, *mass)
        })
    }

    /// Sets the longest duration of a stretch (time interval of one power series) to a/s. a is 1.5 rad (1 rad in
    /// `f32`). s is an upper bound on the angular frequencies and decay rates of the free motion, and on the
    /// frequencies of loads, base and friction forces.
    ///
    /// A rate s of the free motion satisfies s² ≤ ‖M⁻¹C‖s + ‖M⁻¹K‖, with the mass matrix M, the stiffness matrix K and
    /// the damping matrix C. In K, elastic contacts are springs. Gershgorin's theorem gives upper bounds on the two
    /// norms.
    pub fn set_stretch(&mut self) {
        let mut stiff = self.size.nodes(S::constant(0.0));
        let mut slow = self.size.nodes(S::constant(0.0));
        let elastic = self.contacts().iter();
        let elastic =
            elastic.filter_map(|c| c.stiffness.map(|stiffness| (c.plus, c.minus, stiffness)));
        for link in self.springs.as_ref().iter().copied().chain(elastic) {
            self.circle(stiff.as_mut(), link);
        }
        let dashpots = self.dashpots.as_ref().iter().copied();
        for link in dashpots.chain(self.stop_dashpots()) {
            self.circle(slow.as_mut(), link);
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
        self.stretch = S::constant(angle_of::<S>()) / crate::Scalar::max(motion, waves);
    }

    /// Returns the number of coefficients that power series over a time interval of the duration `length` need, under
    /// inputs of the degree `degree`.
    pub(super) fn terms_within(&self, length: S, degree: usize) -> usize {
        if !self.law.as_ref().is_empty() {
            // The slopes of the friction law are no part of the longest stretch.
            return terms_of::<S>();
        }
        let angle = S::constant(angle_of::<S>()) * length / self.stretch;
        terms_within(angle, degree)
    }

    /// Returns the dashpots of the stops.
    fn stop_dashpots(&self) -> impl Iterator<Item = Link<S>> {
        let contacts = self.contacts().iter().filter(|_| Z::HAS_PARTS);
        contacts.filter_map(|own| own.stop.map(|stop| (own.plus, own.minus, stop.damping)))
    }

    /// Divides each number in `values` by the mass with the same index. Returns the largest quotient.
    fn largest(&self, values: &[S]) -> S {
        let rates = values.iter().zip(self.masses()).map(|(k, m)| *k / *m);
        rates.fold(S::constant(0.0), crate::Scalar::max)
    }

    /// Adds the stiffness of a spring, or the coefficient of a dashpot, to the row sums of its two nodes for
    /// Gershgorin's theorem. Between two masses the coefficient counts twice, because it is also in an off-diagonal
    /// entry of the row.
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

//! Power series of a stretch.

use super::patterns::solve;
use super::{
    Chain, Drive, JointState, MAX_JOINTS, ORDERS, Phase, Room, Series, TERMS, term, whole,
};
use crate::number::scalar::Float;

/// The base over a stretch, and what the holding forces need.
pub(super) struct Stretch<T> {
    /// Length of the stretch.
    pub(super) span: T,
    /// Displacement of the base.
    pub(super) base: Series<T>,
    /// wᵀM⁻¹w′ of each pair of contacts.
    pub(super) mobility: [[T; MAX_JOINTS]; MAX_JOINTS],
}

impl<T: Float> Stretch<T> {
    /// Returns the coefficient of order `n` of the base's velocity.
    pub(super) fn base_velocity(&self, n: usize) -> T {
        term(&self.base, n + 1) * whole(n + 1) / self.span
    }
    /// Returns the coefficient of order `n` of the base's acceleration.
    pub(super) fn base_acceleration(&self, n: usize) -> T {
        term(&self.base, n + 2) * whole((n + 1) * (n + 2)) / (self.span * self.span)
    }
}

/// Returns wᵀM⁻¹w′ of each pair of contacts.
pub(super) fn mobility<T: Float>(chain: &Chain<'_, T>) -> [[T; MAX_JOINTS]; MAX_JOINTS] {
    let mut found = [[T::constant(0.0); MAX_JOINTS]; MAX_JOINTS];
    for (row, joint) in found.iter_mut().zip(chain.joints) {
        for (entry, other) in row.iter_mut().zip(chain.joints) {
            *entry = joint.link.mobility(&other.link, chain.masses);
        }
    }
    found
}

/// Writes the loads, the levels and the base of a stretch that starts at `t`.
pub(super) fn load<T: Float>(
    room: &mut Room<'_, T>,
    stretch: &mut Stretch<T>,
    drive: &impl Drive<T>,
    (t, span): (T, T),
) {
    let zeros = [T::constant(0.0); TERMS];
    stretch.span = span;
    stretch.base = zeros;
    drive.base(t, span, &mut stretch.base);
    for (mass, series) in room.loads.iter_mut().enumerate() {
        *series = zeros;
        drive.force(mass, t, span, series);
    }
    for (joint, series) in room.levels.iter_mut().enumerate() {
        *series = zeros;
        drive.level(joint, t, span, series);
    }
    for (series, x) in room.displacements.iter_mut().zip(room.x.iter()) {
        *series = zeros;
        if let Some(first) = series.first_mut() {
            *first = *x;
        }
    }
    for (series, v) in room.velocities.iter_mut().zip(room.v.iter()) {
        *series = zeros;
        if let Some(first) = series.first_mut() {
            *first = *v;
        }
    }
    for series in room.forces.iter_mut() {
        *series = zeros;
    }
}

/// True if the force of a contact is a holding force.
pub(super) fn holds<T>(rigid: bool, state: &JointState<T>) -> bool {
    rigid && state.phase == Phase::Stuck
}

/// Writes the accelerations of order `n` without the forces of the contacts of `unknown`.
pub(super) fn accelerate<T: Float>(
    chain: &Chain<'_, T>,
    room: &mut Room<'_, T>,
    stretch: &Stretch<T>,
    unknown: &[bool; MAX_JOINTS],
    n: usize,
) {
    let sums = &mut *room.acceleration;
    for (sum, load) in sums.iter_mut().zip(room.loads.iter()) {
        *sum = term(load, n);
    }
    let base = term(&stretch.base, n);
    for (link, stiffness) in chain.springs {
        let z = link.coefficient(room.displacements, n) - link.base * base;
        link.pull(sums, *stiffness * z);
    }
    let base_velocity = stretch.base_velocity(n);
    for (link, damping) in chain.dampers {
        let z = link.coefficient(room.velocities, n) - link.base * base_velocity;
        link.pull(sums, *damping * z);
    }
    let rows = chain.damping.chunks_exact(chain.masses.len().max(1));
    for (sum, row) in sums.iter_mut().zip(rows) {
        let terms = row.iter().zip(room.velocities.iter());
        *sum = terms.fold(*sum, |sum, (c, v)| sum - *c * term(v, n));
    }
    let contacts = chain.joints.iter().zip(room.joints.iter()).zip(unknown);
    let forces = room.forces.iter_mut().zip(room.levels.iter());
    for (((joint, state), &unknown), (force, level)) in contacts.zip(forces) {
        if unknown {
            continue;
        }
        let of_contact = match (state.phase, joint.stiffness) {
            (Phase::Stuck, Some(_)) if n == 0 => state.force,
            (Phase::Stuck, Some(stiffness)) => {
                let z = joint.link.coefficient(room.displacements, n);
                stiffness * (z - joint.link.base * base)
            }
            (phase, _) => phase.signed(term(level, n)),
        };
        if let Some(place) = force.get_mut(n) {
            *place = of_contact;
        }
        joint.link.pull(sums, of_contact);
    }
    for (sum, mass) in sums.iter_mut().zip(chain.masses) {
        *sum = *sum / *mass;
    }
}

/// Writes the series of motion and forces over the stretch.  Returns false if the holding forces are not determined.
pub(super) fn expand<T: Float>(
    chain: &Chain<'_, T>,
    room: &mut Room<'_, T>,
    stretch: &Stretch<T>,
) -> bool {
    let mut held = [false; MAX_JOINTS];
    let contacts = chain.joints.iter().zip(room.joints.iter());
    for (held, (joint, state)) in held.iter_mut().zip(contacts) {
        *held = holds(joint.stiffness.is_none(), state);
    }
    let any = held.contains(&true);
    for n in 0..ORDERS {
        accelerate(chain, room, stretch, &held, n);
        if any && !hold(chain, room, stretch, &held, n) {
            return false;
        }
        let factor = stretch.span / whole(n + 1);
        let series = room
            .displacements
            .iter_mut()
            .zip(room.velocities.iter_mut());
        for ((x, v), a) in series.zip(room.acceleration.iter()) {
            let velocity = term(v, n);
            if let Some(place) = x.get_mut(n + 1) {
                *place = velocity * factor;
            }
            if let Some(place) = v.get_mut(n + 1) {
                *place = *a * factor;
            }
        }
    }
    true
}

/// Adds the holding forces of order `n`.
fn hold<T: Float>(
    chain: &Chain<'_, T>,
    room: &mut Room<'_, T>,
    stretch: &Stretch<T>,
    held: &[bool; MAX_JOINTS],
    n: usize,
) -> bool {
    let mut forces = [T::constant(0.0); MAX_JOINTS];
    let base = stretch.base_acceleration(n);
    for (force, joint) in forces.iter_mut().zip(chain.joints) {
        *force = joint.link.difference(room.acceleration) - joint.link.base * base;
    }
    if !solve(&stretch.mobility, held, chain.joints.len(), &mut forces) {
        return false;
    }
    let contacts = chain.joints.iter().zip(held).zip(forces);
    for (((joint, held), force), series) in contacts.zip(room.forces.iter_mut()) {
        if !held {
            continue;
        }
        if let Some(place) = series.get_mut(n) {
            *place = force;
        }
        let of = |end: Option<usize>| end.map_or(T::constant(1.0), |mass| term(chain.masses, mass));
        let (from, to) = (force / of(joint.link.from), force / of(joint.link.to));
        if let Some(a) = joint
            .link
            .to
            .and_then(|mass| room.acceleration.get_mut(mass))
        {
            *a = *a - to;
        }
        if let Some(a) = joint
            .link
            .from
            .and_then(|mass| room.acceleration.get_mut(mass))
        {
            *a = *a + from;
        }
    }
    true
}

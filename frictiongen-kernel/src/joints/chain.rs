//! Masses, springs, dashpots and contacts.

use super::{Series, term};
use crate::number::scalar::Float;

/// Two points and the relative motion between them, z = x_to − x_from − base·y.
#[derive(Clone, Copy, Debug)]
pub struct Link<T> {
    /// Index of the mass at the first point, or `None` for the wall or the base.
    pub from: Option<usize>,
    /// Index of the mass at the second point, or `None` for the wall or the base.
    pub to: Option<usize>,
    /// 1 if the first point is a base that moves, −1 if the second point is, otherwise 0.
    pub base: T,
}

impl<T: Float> Link<T> {
    /// Returns x_to − x_from.
    pub(super) fn difference(&self, x: &[T]) -> T {
        let of = |end: Option<usize>| end.map_or(T::constant(0.0), |mass| term(x, mass));
        of(self.to) - of(self.from)
    }
    /// Returns x_to − x_from of the coefficients of order `n`.
    pub(super) fn coefficient(&self, x: &[Series<T>], n: usize) -> T {
        let of = |end: Option<usize>| {
            let series = end.and_then(|mass| x.get(mass));
            series.map_or(T::constant(0.0), |series| term(series, n))
        };
        of(self.to) - of(self.from)
    }
    /// Adds a force to both ends.  A positive force pulls the two points towards each other.
    pub(super) fn pull(&self, sums: &mut [T], force: T) {
        if let Some(sum) = self.to.and_then(|mass| sums.get_mut(mass)) {
            *sum = *sum - force;
        }
        if let Some(sum) = self.from.and_then(|mass| sums.get_mut(mass)) {
            *sum = *sum + force;
        }
    }
    /// Returns wᵀM⁻¹w′ of this link and another one.
    pub(super) fn mobility(&self, other: &Self, masses: &[T]) -> T {
        let zero = T::constant(0.0);
        let sign = |link: &Self, mass: Option<usize>| match mass {
            Some(_) if link.to == mass => T::constant(1.0),
            Some(_) if link.from == mass => T::constant(-1.0),
            _ => zero,
        };
        let of = |mass: Option<usize>| match mass {
            Some(index) => sign(self, mass) * sign(other, mass) / term(masses, index),
            None => zero,
        };
        of(self.to) + of(self.from)
    }
}

/// A contact: rigid, or elastic with a spring in series with the slider.
#[derive(Clone, Copy, Debug)]
pub struct Joint<T> {
    /// The two points that the contact joins.
    pub link: Link<T>,
    /// Stiffness of an elastic contact, or `None` for a rigid contact.
    pub stiffness: Option<T>,
    /// μ, the static over the kinetic friction force, at least 1.
    pub stiction: T,
}

/// A chain with several joints, in any consistent units.
#[derive(Clone, Copy, Debug)]
pub struct Chain<'a, T> {
    /// The masses.
    pub masses: &'a [T],
    /// The springs with their stiffness.
    pub springs: &'a [(Link<T>, T)],
    /// The dashpots with force over relative velocity.
    pub dampers: &'a [(Link<T>, T)],
    /// Damping matrix, row by row, or an empty slice without damping.  It acts on absolute velocities.
    pub damping: &'a [T],
    /// The contacts, in the order of the description.
    pub joints: &'a [Joint<T>],
}

impl<T: Float> Chain<'_, T> {
    /// Returns a bound on |s| of every solution e^{st} of the chain with any set of stuck contacts.
    ///
    /// The largest row sums of M⁻¹K and M⁻¹C bound the stiffness Λ and the damping D of a unit motion.  The bounds hold
    /// for every constrained motion.  So |s|² ≤ D|s| + Λ.
    pub(super) fn rate(&self) -> T {
        let zero = T::constant(0.0);
        let (mut stiffest, mut most) = (zero, zero);
        for (index, &mass) in self.masses.iter().enumerate() {
            let row = |link: &Link<T>, factor: T| {
                let at = |end: Option<usize>| end == Some(index);
                let ends = match (link.from, link.to) {
                    (Some(_), Some(_)) => T::constant(2.0),
                    _ => T::constant(1.0),
                };
                if at(link.from) || at(link.to) {
                    factor * ends
                } else {
                    zero
                }
            };
            let springs = self.springs.iter().map(|(link, k)| row(link, *k));
            let elastic = self.joints.iter();
            let elastic = elastic.filter_map(|joint| Some(row(&joint.link, joint.stiffness?)));
            let stiffness = springs.chain(elastic).fold(zero, |sum, k| sum + k);
            let dampers = self.dampers.iter().map(|(link, c)| row(link, *c));
            let count = self.masses.len();
            let rows = self.damping.iter().skip(index * count).take(count);
            let damping = dampers
                .chain(rows.map(|c| c.abs()))
                .fold(zero, |sum, c| sum + c);
            stiffest = stiffest.max(stiffness / mass);
            most = most.max(damping / mass);
        }
        T::constant(0.5) * (most + (most * most + T::constant(4.0) * stiffest).sqrt())
    }

    /// Returns true if some rigid contacts form a loop, with wall and base as one point.  Their holding forces are then
    /// not determined while they all stick.
    #[must_use]
    pub fn is_redundant(&self) -> bool {
        let rigid = || self.joints.iter().filter(|joint| joint.stiffness.is_none());
        // A point belongs to the group of the contacts before it.  A contact within one group closes a loop.
        rigid().enumerate().any(|(index, joint)| {
            let mut reached = [None; super::MAX_JOINTS + 1];
            if let Some(first) = reached.first_mut() {
                *first = Some(joint.link.from);
            }
            let mut count = 1;
            let mut changed = true;
            while changed {
                changed = false;
                for earlier in rigid().take(index) {
                    let holds = |end: Option<usize>, found: &[Option<Option<usize>>]| {
                        found.contains(&Some(end))
                    };
                    let ends = (
                        holds(earlier.link.from, &reached),
                        holds(earlier.link.to, &reached),
                    );
                    let new = match ends {
                        (true, false) => earlier.link.to,
                        (false, true) => earlier.link.from,
                        _ => continue,
                    };
                    if let Some(free) = reached.get_mut(count) {
                        *free = Some(new);
                        count += 1;
                        changed = true;
                    }
                }
            }
            reached.contains(&Some(joint.link.to))
        })
    }
}

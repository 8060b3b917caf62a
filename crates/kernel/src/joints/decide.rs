//! Decides which rigid contacts stick and which slide, at an instant at which their relative velocities are 0.
//!
//! A *pattern* gives each of these contacts a phase: it sticks, or it starts to slide in one of two directions. A
//! pattern *fits* under two conditions. No sticking contact needs a force above its static friction force. Each
//! sliding contact accelerates in its direction of sliding. A contact that has just broken away slides against the
//! friction force that held it.
//!
//! If several patterns fit, the solver takes the pattern with the most sticking contacts. Among patterns with equally
//! many sticking contacts, those come first in which earlier contacts of the scene description stick. The solver tries
//! the positive direction of a sliding contact before the negative.
//!
//! In the first patterns that the solver tries, every contact that has just broken away slides. If none of these
//! patterns fits, the solver tries patterns in which such a contact sticks.

use super::model::{Contact, Model};
use super::size::{Size, add, at, set, sign};
use super::tree::Tree;
use crate::Float;
use crate::errors::Halt;

/// Largest number of patterns that the solver tries at one instant. A pattern gives each contact a phase: it sticks, or
/// it slides forward or backward. Eight contacts that act on each other have 3⁸ = 6561 patterns, ten have 59049. If μ
/// is 1 for all contacts, sixteen contacts need only a few dozen patterns.
pub const MAX_PATTERNS: usize = 100_000;

/// Returns the number of patterns of `contacts` contacts that act on each other.
pub(super) fn all_patterns(contacts: usize) -> usize {
    let contacts = u32::try_from(contacts).unwrap_or(u32::MAX);
    3_usize.saturating_pow(contacts)
}

/// Returns the rounding error of a force, divided by the sum of the absolute values of all forces.
fn rounding<S: Float>() -> S {
    S::constant(if S::EPSILON < 1e-10 { 1e-13 } else { 2e-5 })
}

/// All numbers that decide which rigid contacts stick, at an instant at which several of them have the relative
/// velocity 0.
#[derive(Clone, Debug)]
pub struct Decision<'a, S: Float, Z: Size> {
    /// Constants of the chain to which the contacts belong.
    pub model: &'a Model<S, Z>,
    /// Sum of the forces on each node, without the forces of the contacts in `asked`.
    pub forces: Z::Nodes<S>,
    /// Sum of the absolute values of all forces in `forces`, and of the kinetic friction forces of the contacts in
    /// `asked`. The rounding error of a force is proportional to this sum.
    pub size: S,
    /// Acceleration of the base at this instant.
    pub base: S,
    /// Kinetic friction force of each contact at this instant.
    pub levels: Z::Contacts<S>,
    /// True for each contact whose phase (sticking or sliding) this decision determines.
    pub asked: Z::Contacts<bool>,
    /// Sign of the force of each contact that has just broken away, and 0 for each other contact.
    pub broke: Z::Contacts<i8>,
}

/// Result of the test whether a pattern of sticking and sliding contacts fits.
struct Outcome {
    fits: bool,
    /// First contact that contradicts the pattern, and the phase that the method `pivot` gives this contact next.
    first_wrong: Option<(usize, i8)>,
}

/// Contacts that act on each other through common masses, and the phases that are already known.
struct Group<Z: Size> {
    /// True for each contact that belongs to the group.
    members: Z::Contacts<bool>,
    /// Direction in which each contact must slide, or 0 for a contact whose phase is still open.
    fixed: Z::Contacts<i8>,
}

impl<Z: Size> Group<Z> {
    fn has(&self, contact: usize) -> bool {
        holds(&self.members, contact)
    }

    /// Returns the phases that the search tries for a contact. `going` is the number of contacts in the group that
    /// must still start to slide in the pattern.
    fn choices(&self, contact: usize, going: usize, stop: Option<i8>) -> &'static [i8] {
        match (phase::<Z>(&self.fixed, contact), stop) {
            (1, _) => &[1],
            (-1, _) => &[-1],
            _ if going == 0 => &[0],
            // A stop opens only against the direction in which it closes.
            (_, Some(1)) => &[0, -1],
            (_, Some(_)) => &[0, 1],
            (_, None) => &[0, 1, -1],
        }
    }

    /// Returns the number of contacts in the group whose phase is open. The function counts from the index `first` on.
    fn open(&self, first: usize) -> usize {
        let members = self.members.as_ref().iter().zip(self.fixed.as_ref());
        let open = members.skip(first);
        open.filter(|(member, fixed)| **member && **fixed == 0)
            .count()
    }
}

/// Returns the phase that a pattern gives to a contact.
fn phase<Z: Size>(pattern: &Z::Contacts<i8>, contact: usize) -> i8 {
    pattern.as_ref().get(contact).copied().unwrap_or(0)
}

/// Returns true if `set` contains the contact with the index `contact`.
pub(super) fn holds(set: &impl AsRef<[bool]>, contact: usize) -> bool {
    set.as_ref().get(contact) == Some(&true)
}

impl<S: Float, Z: Size> Decision<'_, S, Z> {
    /// Returns the phase of each contact in `asked`. The phase is 0 if the contact sticks, or the sign of its direction
    /// of sliding.
    ///
    /// # Errors
    ///
    /// [`Halt::Patterns`] after [`MAX_PATTERNS`] patterns. [`Halt::Stalled`] if no pattern fits, even within the
    /// tolerance for rounding errors.
    pub fn decide(&self) -> Result<Z::Contacts<i8>, Halt> {
        self.decide_within(MAX_PATTERNS)
    }

    /// Decides as [`decide`](Self::decide) does, with at most `patterns` patterns.
    pub(super) fn decide_within(&self, patterns: usize) -> Result<Z::Contacts<i8>, Halt> {
        let labels = self.labels();
        let mut left = patterns;
        for goes in [true, false] {
            let mut pattern = self.model.size.contacts(0);
            let mut fits = true;
            for label in 0..self.model.contacts().len() {
                if fits && labels.as_ref().get(label) == Some(&label) {
                    let group = self.group(&labels, label, goes);
                    fits = self.decide_group(&group, &mut pattern, &mut left)?;
                }
            }
            if fits {
                return Ok(pattern);
            }
        }
        // Without rounding errors, one pattern always fits. Here the rounding errors exceed the tolerance.
        Err(Halt::Stalled)
    }

    /// Gives each contact in `asked` a label. Contacts have the same label if they act on each other, directly or
    /// through other contacts in `asked`. The label is the smallest index of these contacts. Two contacts act on each
    /// other directly if they share a mass.
    fn labels(&self) -> Z::Contacts<usize> {
        let wall = self.model.wall();
        let meets = |a: &Contact<S>, b: &Contact<S>| {
            let shares = |node: usize| node < wall && (node == b.plus || node == b.minus);
            shares(a.plus) || shares(a.minus)
        };
        let contacts = self.model.contacts();
        let mut labels = self.model.size.contacts(usize::MAX);
        for (j, contact) in contacts.iter().enumerate() {
            if !holds(&self.asked, j) {
                continue;
            }
            set(labels.as_mut(), j, j);
            for (i, other) in contacts.iter().enumerate().take(j) {
                if holds(&self.asked, i) && meets(contact, other) {
                    let label = |j| labels.as_ref().get(j).copied().unwrap_or(j);
                    let (a, b) = (label(i), label(j));
                    let (from, to) = (a.max(b), a.min(b));
                    for label in labels.as_mut().iter_mut().filter(|label| **label == from) {
                        *label = to;
                    }
                }
            }
        }
        labels
    }

    /// Returns the group of contacts that have the label `label`, and therefore act on each other. If `goes` is true,
    /// every contact that has just broken away must slide.
    fn group(&self, labels: &Z::Contacts<usize>, label: usize, goes: bool) -> Group<Z> {
        let mut group: Group<Z> = Group {
            members: self.model.size.contacts(false),
            fixed: self.model.size.contacts(0),
        };
        for (j, of) in labels.as_ref().iter().enumerate() {
            if *of == label {
                set(group.members.as_mut(), j, true);
                if goes {
                    set(group.fixed.as_mut(), j, phase::<Z>(&self.broke, j));
                }
            }
        }
        group
    }

    /// Finds the phases of the contacts in a group, and writes them into `pattern`. Returns false if no pattern fits.
    fn decide_group(
        &self,
        group: &Group<Z>,
        pattern: &mut Z::Contacts<i8>,
        left: &mut usize,
    ) -> Result<bool, Halt> {
        let contacts = 0..self.model.contacts().len();
        let members = || contacts.clone().filter(|&j| group.has(j));
        for j in members() {
            set(pattern.as_mut(), j, phase::<Z>(&group.fixed, j));
        }
        if self.try_pattern(group, pattern, left)?.fits {
            return Ok(true);
        }
        let mut laws = members().filter_map(|j| self.model.contact(j));
        if laws.all(|c| c.stiction == S::constant(1.0))
            && let Some(found) = self.pivot(group, pattern.clone(), left)?
        {
            let kept = |j: usize| {
                let fixed = phase::<Z>(&group.fixed, j);
                fixed == 0 || fixed == phase::<Z>(&found, j)
            };
            let kept = members().all(kept);
            *pattern = found;
            return Ok(kept);
        }
        for going in 0..=group.open(0) {
            if self.enumerate(group, (0, going), pattern, left)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Searches for a fitting pattern (the phase of each contact) by Murty's rule of the least index. The rule corrects
    /// the first contact that contradicts the pattern, and repeats. If static and kinetic friction are equal, the
    /// method always ends, because the fitting pattern then belongs to the minimum of a strictly convex function.
    fn pivot(
        &self,
        group: &Group<Z>,
        mut pattern: Z::Contacts<i8>,
        left: &mut usize,
    ) -> Result<Option<Z::Contacts<i8>>, Halt> {
        let members = group.members.as_ref().iter();
        let members = members.filter(|member| **member).count();
        // Without rounding errors no pattern returns.
        for _ in 0..all_patterns(members).min(64 * members) {
            let outcome = self.try_pattern(group, &pattern, left)?;
            if outcome.fits {
                return Ok(Some(pattern));
            }
            let Some((contact, phase)) = outcome.first_wrong else {
                break;
            };
            set(pattern.as_mut(), contact, phase);
        }
        Ok(None)
    }

    /// Tries the patterns in which exactly `going` contacts with an open phase slide. A pattern is the phase of each
    /// contact: sticking, or its direction of sliding. Contacts that must slide in a given direction have no open
    /// phase. The recursion is at most as deep as the number of contacts.
    fn enumerate(
        &self,
        group: &Group<Z>,
        (from, going): (usize, usize),
        pattern: &mut Z::Contacts<i8>,
        left: &mut usize,
    ) -> Result<bool, Halt> {
        let contacts = self.model.contacts().len();
        let Some(next) = (from..contacts).find(|&j| group.has(j)) else {
            return Ok(going == 0 && self.try_pattern(group, pattern, left)?.fits);
        };
        if group.open(next) < going {
            return Ok(false);
        }
        let is_open = phase::<Z>(&group.fixed, next) == 0;
        let stop = self.model.stop(next);
        let stop = stop.map(|stop| if stop.side > S::constant(0.0) { 1 } else { -1 });
        for &choice in group.choices(next, going, stop) {
            let goes = usize::from(is_open && choice != 0);
            set(pattern.as_mut(), next, choice);
            let rest = going.saturating_sub(goes);
            if self.enumerate(group, (next + 1, rest), pattern, left)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Tests whether a pattern (the phase of each contact) fits for a group of contacts. If not, finds the first
    /// contact that contradicts the pattern. Returns an error if no pattern is `left`.
    fn try_pattern(
        &self,
        group: &Group<Z>,
        pattern: &Z::Contacts<i8>,
        left: &mut usize,
    ) -> Result<Outcome, Halt> {
        *left = left.checked_sub(1).ok_or(Halt::Patterns)?;
        let (accelerations, forces) = self.accelerations(&group.members, pattern);
        let mut outcome = Outcome {
            fits: true,
            first_wrong: None,
        };
        let contacts = self.model.contacts().iter().enumerate();
        for (j, contact) in contacts.filter(|(j, _)| group.has(*j)) {
            let phase = phase::<Z>(pattern, j);
            let wrong = if phase == 0 {
                let hold = at(forces.as_ref(), j);
                let most = contact.stiction * at(self.levels.as_ref(), j);
                let exceeds = match self.model.stop(j) {
                    // A stop pushes its nodes apart, and cannot hold them together.
                    Some(stop) => stop.side * hold < -self.rounding(),
                    None => hold.abs() > most + self.rounding(),
                };
                exceeds.then_some(if hold > S::constant(0.0) { 1 } else { -1 })
            } else {
                let goes = sign::<S>(phase) * contact.across(accelerations.as_ref());
                let fits = if self.broke.as_ref().get(j) == Some(&phase) {
                    goes >= -self.noise(j)
                } else {
                    goes > S::constant(0.0)
                };
                (!fits).then_some(0)
            };
            if let Some(phase) = wrong {
                outcome.fits = false;
                outcome.first_wrong = outcome.first_wrong.or(Some((j, phase)));
            }
        }
        Ok(outcome)
    }

    /// Returns the rounding error of a force in this decision.
    pub fn rounding(&self) -> S {
        rounding::<S>() * self.size
    }

    /// Returns the rounding error of a contact's relative acceleration in this decision.
    pub fn noise(&self, contact: usize) -> S {
        let zero = S::constant(0.0);
        let Some(contact) = self.model.contact(contact) else {
            return zero;
        };
        let inverse = |node| self.model.inverse_mass(node);
        self.rounding() * (inverse(contact.plus) + inverse(contact.minus))
    }

    /// Returns the acceleration of each node, and the force of each sticking contact, for a pattern. The pattern gives
    /// the phases of the contacts in `contacts`. The other contacts in `asked` have no force. The forces of contacts
    /// outside `asked` are part of the field `forces`.
    pub fn accelerations(
        &self,
        contacts: &Z::Contacts<bool>,
        pattern: &Z::Contacts<i8>,
    ) -> (Z::Nodes<S>, Z::Contacts<S>) {
        let phase = |j: usize| holds(contacts, j).then(|| phase::<Z>(pattern, j));
        let tree = Tree::new(self.model, |j| phase(j) == Some(0));
        let mut forces = self.forces.clone();
        for (j, contact) in self.model.contacts().iter().enumerate() {
            if let Some(phase) = phase(j).filter(|&phase| phase != 0) {
                let force = sign::<S>(phase) * at(self.levels.as_ref(), j);
                contact.pull(forces.as_mut(), force);
            }
        }
        let mut held = self.model.size.contacts(S::constant(0.0));
        let forces = forces.as_ref();
        let accelerations = tree.accelerate(self.model, forces, self.base, held.as_mut());
        (accelerations, held)
    }
}

/// Adds the force of a contact to the forces on its two nodes. Adds the absolute value of this force to the sums
/// `sizes` at these nodes.
pub(super) fn add_contact<S: Float>(
    contact: &Contact<S>,
    force: S,
    (forces, sizes): (&mut [S], &mut [S]),
) {
    contact.pull(forces, force);
    add(sizes, contact.plus, force.abs());
    add(sizes, contact.minus, force.abs());
}

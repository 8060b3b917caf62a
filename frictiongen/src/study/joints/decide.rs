//! Which rigid contacts stick and which go, where their relative velocity is 0.
//!
//! A pattern fits if no contact that sticks has more force than it can hold and every contact that goes accelerates
//! against its friction. What broke away goes, in the direction of its holding force. Of the patterns that fit, the one
//! with the most contacts that stick counts; of those, the first in the order of the description (contacts that come
//! first stick, and go forwards before they go backwards). If none fits in which everything that broke away goes, all
//! patterns are asked.

use super::JointError;
use super::model::{Model, add, at};
use super::tree::Tree;

/// Largest number of patterns that are tried at one instant. Eight contacts that act on each other have 6561, ten 59049.
/// Where the static friction of all of them is the kinetic one, sixteen take a few dozen.
pub const MAX_PATTERNS: usize = 100_000;
/// Rounding of a force, relative to the sum of the absolute values of all forces.
const ROUNDING: f64 = 1e-13;

/// A question: the instant at which contacts have no relative velocity.
#[derive(Clone, Debug)]
pub struct Decision<'a> {
    /// The chain.
    pub model: &'a Model,
    /// All forces by node, without those of the contacts asked.
    pub forces: Vec<f64>,
    /// Sum of their absolute values.
    pub size: f64,
    /// The acceleration of the base.
    pub base: f64,
    /// Level of each contact.
    pub levels: Vec<f64>,
    /// The contacts that are asked.
    pub asked: Vec<usize>,
    /// Those that broke away, with the direction of their force.
    pub broke: Vec<(usize, i8)>,
}

/// Result of one pattern.
struct Outcome {
    fits: bool,
    /// The first contact that does not fit, by its place in the group, and the phase with which `pivot` tries it next.
    first_wrong: Option<(usize, i8)>,
}

impl Decision<'_> {
    /// Returns the phase of each contact asked, by contact.
    pub fn decide(&self) -> Result<Vec<(usize, i8)>, JointError> {
        let groups = self.groups();
        let mut tried = 0;
        for goes in [true, false] {
            let mut decided = Vec::new();
            for group in &groups {
                let Some(pattern) = self.decide_group(group, goes, &mut tried)? else {
                    break;
                };
                decided.extend(group.iter().copied().zip(pattern));
            }
            if decided.len() == self.asked.len() {
                return Ok(decided);
            }
        }
        // One pattern always fits, but for rounding beyond what is allowed for.
        Err(JointError::Stalled)
    }

    /// Divides the contacts asked into groups that have no mass in common, each in the order of the description.
    fn groups(&self) -> Vec<Vec<usize>> {
        let wall = self.model.wall();
        let mut groups: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
        for &contact in &self.asked {
            let Some(c) = self.model.contacts.get(contact) else {
                continue;
            };
            let masses = [c.plus, c.minus];
            let mut joined = (vec![contact], Vec::new());
            joined.1.extend(masses.iter().filter(|&&node| node < wall));
            let (touching, apart) = groups
                .into_iter()
                .partition(|(_, nodes)| nodes.iter().any(|node| joined.1.contains(node)));
            groups = apart;
            for (contacts, nodes) in Vec::from_iter::<Vec<(Vec<usize>, Vec<usize>)>>(touching) {
                joined.0.extend(contacts);
                joined.1.extend(nodes);
            }
            joined.0.sort_unstable();
            groups.push(joined);
        }
        groups.into_iter().map(|(contacts, _)| contacts).collect()
    }

    /// Decides a group, with all that broke away going if `goes` is set.
    fn decide_group(
        &self,
        group: &[usize],
        goes: bool,
        tried: &mut usize,
    ) -> Result<Option<Vec<i8>>, JointError> {
        let broke = |contact: usize| self.broke.iter().find(|(j, _)| goes && *j == contact);
        let fixed: Vec<Option<i8>> = group.iter().map(|&j| broke(j).map(|b| b.1)).collect();
        let likely: Vec<i8> = fixed.iter().map(|fixed| fixed.unwrap_or(0)).collect();
        if self.try_pattern(group, &likely).fits {
            return Ok(Some(likely));
        }
        let mut contacts = group.iter().filter_map(|&j| self.model.contacts.get(j));
        if contacts.all(|c| c.stiction == 1.0)
            && let Some(pattern) = self.pivot(group, likely)
        {
            let mut kept = pattern.iter().zip(&fixed);
            let kept = kept.all(|(phase, fixed)| fixed.is_none_or(|fixed| fixed == *phase));
            return Ok(kept.then_some(pattern));
        }
        let open = fixed.iter().filter(|fixed| fixed.is_none()).count();
        for going in 0..=open {
            let mut pattern = Vec::with_capacity(group.len());
            if self.enumerate((group, &fixed), going, &mut pattern, tried)? {
                return Ok(Some(pattern));
            }
        }
        Ok(None)
    }

    /// Murty's rule of the least index, which ends where static and kinetic friction are equal: there the pattern is
    /// that of the minimum of a strictly convex function.
    fn pivot(&self, group: &[usize], mut pattern: Vec<i8>) -> Option<Vec<i8>> {
        for _ in 0..64 * group.len() {
            let outcome = self.try_pattern(group, &pattern);
            if outcome.fits {
                return Some(pattern);
            }
            let (place, phase) = outcome.first_wrong?;
            *pattern.get_mut(place)? = phase;
        }
        None
    }

    /// Tries all patterns with a given number of contacts that go beside those that broke away.
    fn enumerate(
        &self,
        asked: (&[usize], &[Option<i8>]),
        going: usize,
        pattern: &mut Vec<i8>,
        tried: &mut usize,
    ) -> Result<bool, JointError> {
        let (group, fixed) = asked;
        let Some(next) = fixed.get(pattern.len()) else {
            *tried += 1;
            if *tried > MAX_PATTERNS {
                return Err(JointError::Patterns);
            }
            return Ok(going == 0 && self.try_pattern(group, pattern).fits);
        };
        let left = fixed.iter().skip(pattern.len());
        if left.filter(|fixed| fixed.is_none()).count() < going {
            return Ok(false);
        }
        let choices: &[i8] = match next {
            Some(1) => &[1],
            Some(_) => &[-1],
            None if going == 0 => &[0],
            None => &[0, 1, -1],
        };
        for &choice in choices {
            let goes = usize::from(next.is_none() && choice != 0);
            pattern.push(choice);
            if self.enumerate(asked, going - goes, pattern, tried)? {
                return Ok(true);
            }
            pattern.pop();
        }
        Ok(false)
    }

    /// Tests whether a pattern of a group fits, and finds the first contact that does not.
    fn try_pattern(&self, group: &[usize], pattern: &[i8]) -> Outcome {
        let (accelerations, holds) = self.accelerations(group, pattern);
        let mut outcome = Outcome {
            fits: true,
            first_wrong: None,
        };
        for (place, (&j, &phase)) in group.iter().zip(pattern).enumerate() {
            let Some(contact) = self.model.contacts.get(j) else {
                continue;
            };
            let wrong = if phase == 0 {
                let hold = at(&holds, j);
                let most = contact.stiction * at(&self.levels, j);
                (hold.abs() > most + ROUNDING * self.size).then_some(if hold > 0.0 {
                    1
                } else {
                    -1
                })
            } else {
                let broke = self.broke.contains(&(j, phase));
                let goes = f64::from(phase) * contact.across(&accelerations);
                let fits = if broke {
                    goes >= -self.noise(j)
                } else {
                    goes > 0.0
                };
                (!fits).then_some(0)
            };
            if let Some(phase) = wrong {
                outcome.fits = false;
                outcome.first_wrong = outcome.first_wrong.or(Some((place, phase)));
            }
        }
        outcome
    }

    /// Rounding of a force.
    pub fn rounding(&self) -> f64 {
        ROUNDING * self.size
    }

    /// Rounding of the relative acceleration of a contact.
    pub fn noise(&self, contact: usize) -> f64 {
        let Some(contact) = self.model.contacts.get(contact) else {
            return 0.0;
        };
        let inverse = |node: usize| self.model.masses.get(node).map_or(0.0, |m| 1.0 / m);
        ROUNDING * self.size * (inverse(contact.plus) + inverse(contact.minus))
    }

    /// Returns all accelerations by node, and the forces of the contacts that stick by contact, for a pattern of some
    /// contacts. The others have no force.
    pub fn accelerations(&self, contacts: &[usize], pattern: &[i8]) -> (Vec<f64>, Vec<f64>) {
        let phase = |contact: usize| {
            let place = contacts.iter().position(|&j| j == contact);
            place.and_then(|place| pattern.get(place)).copied()
        };
        let tree = Tree::new(self.model, |contact| phase(contact) == Some(0));
        let mut forces = self.forces.clone();
        for (j, contact) in self.model.contacts.iter().enumerate() {
            if let Some(phase) = phase(j).filter(|&phase| phase != 0) {
                contact.pull(&mut forces, f64::from(phase) * at(&self.levels, j));
            }
        }
        let mut holds = vec![0.0; self.model.contacts.len()];
        let accelerations = tree.accelerate(self.model, &forces, self.base, &mut holds);
        (accelerations, holds)
    }
}

/// Adds the forces of contacts to those of the nodes, and their absolute values to the sum.
pub fn add_contact(
    model: &Model,
    contact: usize,
    force: f64,
    (forces, sizes): (&mut [f64], &mut [f64]),
) {
    if let Some(contact) = model.contacts.get(contact) {
        contact.pull(forces, force);
        add(sizes, contact.plus, force.abs());
        add(sizes, contact.minus, force.abs());
    }
}

//! Which rigid contacts stick and which go, where several have a relative velocity of 0 at one instant.

use super::{MAX_JOINTS, Phase, term};
use crate::number::scalar::Float;

/// Largest number of patterns that one decision tries.
pub const MAX_PATTERNS: usize = 60_000;
/// Roundings of the forces that a comparison allows.
const ROUNDINGS: f64 = 64.0;

/// A rigid contact at relative velocity 0.
#[derive(Clone, Copy, Debug)]
pub struct Candidate<T> {
    /// Relative acceleration without the forces of the candidates.
    pub acceleration: T,
    /// Rounding error of the acceleration.
    pub rounding: T,
    /// Kinetic friction force, above 0.
    pub level: T,
    /// Static over kinetic friction force.
    pub stiction: T,
    /// The direction, for a contact that has just broken away.  Otherwise [`Phase::Stuck`].
    pub gone: Phase,
}

/// Answer of a decision for one contact.
#[derive(Clone, Copy, Debug)]
pub struct Resting<T> {
    /// Sticks or goes, and in which direction.
    pub phase: Phase,
    /// Force of the contact.
    pub force: T,
}

/// A square matrix of the contacts.
type Square<T> = [[T; MAX_JOINTS]; MAX_JOINTS];

/// What a decision asks.
struct Asked<'a, T> {
    candidates: &'a [Candidate<T>],
    mobility: &'a Square<T>,
    forced: bool,
    tried: usize,
}

/// Decides which contacts stick and which go.  `mobility` has wᵀM⁻¹w′ of each pair.
///
/// Contacts that broke away go, in their direction.  Of the patterns that fit, the answer has the most stuck contacts,
/// and of those it is the first in the order of the contacts.  If none fits while the contacts that broke away go, all
/// patterns count.  Returns `None` if more than [`MAX_PATTERNS`] patterns would have to be tried, if no pattern fits, or
/// if holding forces are not determined.
pub fn decide<T: Float>(
    candidates: &[Candidate<T>],
    mobility: &Square<T>,
    answers: &mut [Resting<T>; MAX_JOINTS],
) -> Option<usize> {
    if candidates.len() > MAX_JOINTS {
        return None;
    }
    let forced = candidates
        .iter()
        .filter(|candidate| candidate.gone != Phase::Stuck)
        .count();
    let mut asked = Asked {
        candidates,
        mobility,
        forced: true,
        tried: 0,
    };
    for forced_only in [true, false] {
        asked.forced = forced_only;
        let least = if forced_only { forced } else { 0 };
        for going in least..=candidates.len() {
            let mut pattern = [Phase::Stuck; MAX_JOINTS];
            if assign(&mut asked, &mut pattern, 0, going, answers)? {
                return Some(asked.tried);
            }
        }
        if forced == 0 {
            break;
        }
    }
    None
}

/// Assigns the contacts from `index` on, of which `going` go.  Returns whether a pattern fits, or `None` at the bound.
fn assign<T: Float>(
    asked: &mut Asked<'_, T>,
    pattern: &mut [Phase; MAX_JOINTS],
    index: usize,
    going: usize,
    answers: &mut [Resting<T>; MAX_JOINTS],
) -> Option<bool> {
    let Some(candidate) = asked.candidates.get(index) else {
        asked.tried += 1;
        let within = asked.tried <= MAX_PATTERNS;
        return within.then(|| fits(asked, pattern, answers));
    };
    let rest = asked.candidates.len() - index - 1;
    for phase in [Phase::Stuck, Phase::Positive, Phase::Negative] {
        let goes = usize::from(phase != Phase::Stuck);
        let possible = goes <= going && going - goes <= rest;
        let bound = asked.forced && candidate.gone != Phase::Stuck && candidate.gone != phase;
        if !possible || bound {
            continue;
        }
        if let Some(place) = pattern.get_mut(index) {
            *place = phase;
        }
        if assign(asked, pattern, index + 1, going - goes, answers)? {
            return Some(true);
        }
    }
    Some(false)
}

/// Returns whether a pattern fits, and writes its forces.
fn fits<T: Float>(
    asked: &Asked<'_, T>,
    pattern: &[Phase; MAX_JOINTS],
    answers: &mut [Resting<T>; MAX_JOINTS],
) -> bool {
    let zero = T::constant(0.0);
    let count = asked.candidates.len();
    let mut forces = [zero; MAX_JOINTS];
    let contacts = || pattern.iter().zip(asked.candidates);
    for (force, (phase, candidate)) in forces.iter_mut().zip(contacts()) {
        *force = phase.signed(candidate.level);
    }
    // Holding forces make the accelerations of the stuck contacts 0.
    let mut driven = [zero; MAX_JOINTS];
    let rows = driven.iter_mut().zip(asked.mobility).zip(asked.candidates);
    for ((driven, row), candidate) in rows {
        *driven = candidate.acceleration - product(row, &forces, count);
    }
    let stuck = pattern.map(|phase| phase == Phase::Stuck);
    if !solve(asked.mobility, &stuck, count, &mut driven) {
        return false;
    }
    for ((force, held), stuck) in forces.iter_mut().zip(driven).zip(stuck).take(count) {
        if stuck {
            *force = held;
        }
    }
    let roundings = T::constant(ROUNDINGS * T::EPSILON);
    let one = T::constant(1.0);
    let rows = contacts().zip(asked.mobility).zip(&forces).enumerate();
    for (index, (((phase, candidate), row), &force)) in rows {
        let good = if *phase == Phase::Stuck {
            let limit = candidate.stiction * candidate.level * (one + roundings);
            force.abs() <= limit + candidate.rounding / term(row, index)
        } else {
            let acceleration = candidate.acceleration - product(row, &forces, count);
            let sizes = row.iter().zip(&forces).take(count);
            let size = sizes.fold(candidate.acceleration.abs(), |sum, (a, f)| {
                sum + (*a * *f).abs()
            });
            let free =
                candidate.gone == *phase || (candidate.gone != Phase::Stuck && !asked.forced);
            let least = if free {
                -(size * roundings + candidate.rounding)
            } else {
                zero
            };
            least < phase.signed(acceleration)
        };
        if !good {
            return false;
        }
    }
    for ((answer, phase), force) in answers.iter_mut().zip(pattern).zip(forces) {
        *answer = Resting {
            phase: *phase,
            force,
        };
    }
    true
}

/// Returns the product of a row and the forces of the first `count` contacts.
fn product<T: Float>(row: &[T; MAX_JOINTS], forces: &[T; MAX_JOINTS], count: usize) -> T {
    let pairs = row.iter().zip(forces).take(count);
    pairs.fold(T::constant(0.0), |sum, (a, f)| sum + *a * *f)
}

/// Solves the equations of the contacts of `chosen` by elimination; the matrix is symmetric and positive definite.
/// Returns false if it is singular.
pub(super) fn solve<T: Float>(
    matrix: &Square<T>,
    chosen: &[bool; MAX_JOINTS],
    count: usize,
    right: &mut [T; MAX_JOINTS],
) -> bool {
    let mut work = *matrix;
    let take = |index: usize| index < count && chosen.get(index).copied().unwrap_or(false);
    let tiny = T::constant(T::EPSILON * 16.0);
    for pivot in (0..count).filter(|&index| take(index)) {
        let (Some(row), Some(original)) = (work.get(pivot).copied(), matrix.get(pivot)) else {
            return false;
        };
        let diagonal = term(&row, pivot);
        if diagonal <= tiny * term(original, pivot) {
            return false;
        }
        let known = term(right, pivot);
        for (index, (other, sum)) in work.iter_mut().zip(right.iter_mut()).enumerate() {
            if index <= pivot || !take(index) {
                continue;
            }
            let factor = term(other, pivot) / diagonal;
            for (entry, above) in other.iter_mut().zip(&row).skip(pivot) {
                *entry = *entry - factor * *above;
            }
            *sum = *sum - factor * known;
        }
    }
    for pivot in (0..count).rev().filter(|&index| take(index)) {
        let Some(row) = work.get(pivot) else {
            return false;
        };
        let others = row.iter().zip(right.iter()).enumerate();
        let others = others.filter(|&(index, _)| index > pivot && take(index));
        let sum = others.fold(T::constant(0.0), |sum, (_, (a, x))| sum + *a * *x);
        let diagonal = term(row, pivot);
        if let Some(place) = right.get_mut(pivot) {
            *place = (*place - sum) / diagonal;
        }
    }
    true
}

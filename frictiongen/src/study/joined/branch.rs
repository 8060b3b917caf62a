//! Follows steady states along a parameter of a scene or of its operating point.

use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::parameter::{JoinedParameter, JoinedPoint};
use super::scene::Joined;
use super::sensitivity::{Prepared, operating, prepare, prepare_on, system};
use super::units::AnswerUnits;
use crate::study::joints::{self, BranchEnd, BranchEvent, Chain, Follower};
use crate::study::sensitivity::OperatingPoint;

/// Largest number of points on a branch, unless the caller sets another one.
const DEFAULT_POINTS: usize = 2000;

/// A question for branches of steady states.
#[derive(Clone, Debug)]
pub struct BranchRequest {
    /// The operating point. Its own value of the parameter does not matter.
    pub point: OperatingPoint,
    /// The parameter that varies.
    pub along: JoinedParameter,
    /// First and last value of the parameter. The branch starts at the first value.
    pub interval: (f64, f64),
    /// If true, every steady state that the search finds at the first value starts a branch. Otherwise only the one that
    /// the motion from rest reaches does.
    pub all_states: bool,
    /// 0: the search follows no branch that begins at a bifurcation. 1: it follows those that begin on the first branches.
    /// 2: it also follows those that begin on these, and so on.
    pub switches: usize,
    /// Largest number of points on a branch.
    pub most: usize,
}

/// The bifurcation at which a branch begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parent {
    /// Index of the earlier branch.
    pub branch: usize,
    /// Index of the point on this branch.
    pub point: usize,
}

/// A branch of steady states.
#[derive(Clone, Debug)]
pub struct JoinedBranch<'a> {
    /// The points along the branch.
    pub points: Vec<JoinedBranchPoint<'a>>,
    /// The reason why the branch ends.
    pub end: BranchEnd,
    /// The bifurcation at which the branch begins, or `None` if it begins at the first value of the parameter.
    pub parent: Option<Parent>,
}

/// A point of a branch.
#[derive(Clone, Debug)]
pub struct JoinedBranchPoint<'a> {
    /// Value of the parameter in its own unit.
    pub value: f64,
    /// The operating point.
    pub point: OperatingPoint,
    /// The steady state, stable or not.
    pub orbit: JoinedOrbit<'a>,
    /// True if the motion repeats with the opposite sign after half a period.
    pub is_symmetric: bool,
    /// Events at this point. The list is empty at an ordinary point.
    pub events: Vec<BranchEvent>,
}

impl BranchRequest {
    /// Returns the question for the branch of the state from rest, without switches, and with at most 2000 points.
    #[must_use]
    pub fn new(point: OperatingPoint, along: JoinedParameter, interval: (f64, f64)) -> Self {
        Self {
            point,
            along,
            interval,
            all_states: false,
            switches: 0,
            most: DEFAULT_POINTS,
        }
    }
}

impl<'a> Joined<'a> {
    /// Returns the parameter of a scene or of its operating point with this name. Names are symbols as `sensitivity`
    /// prints them, such as `m upper` or `m.upper`, `k.base-lower`, `mu.pads`, `speed.pads`, and `hz`, `r`, `friction`,
    /// `beta` and `load`.
    ///
    /// # Errors
    /// [`JoinedError::UnknownParameter`] if there is no such parameter. The error lists the parameters.
    pub fn parameter_named(
        &self,
        name: &str,
        point: OperatingPoint,
    ) -> Result<JoinedParameter, JoinedError> {
        let setting = JoinedPoint::new(self.scene(), point);
        setting.named(name).ok_or_else(|| {
            let known = setting.parameters().into_iter();
            let known = known.map(|parameter| parameter.symbol(self.scene(), &point));
            JoinedError::UnknownParameter(name.to_owned(), known.collect())
        })
    }

    /// Follows steady states, stable or not, along a parameter through folds. Each branch has a point at every
    /// bifurcation and at every graze.
    ///
    /// Newton's method with the exact derivatives of a period finds each point (pseudo-arclength continuation). A
    /// branch ends at a bound of the interval, where it returns to its first point, or where no next point is found.
    /// The search is local: it finds no branch that is not connected to one that it knows.
    ///
    /// ```
    /// use frictiongen::System;
    /// use frictiongen::study::joined::{BranchEnd, BranchRequest};
    /// use frictiongen::study::sensitivity::OperatingPoint;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { plate: 2.0 }, springs: { base - plate: 800.0 },
    ///     contact: plate - wall, excitation: base, damping: modal(0.02),
    /// }".parse()?;
    /// let joined = block.joined()?;
    /// let point = OperatingPoint::Groups { r: 0.5, beta: 0.2 };
    /// let along = joined.parameter_named("r", point)?;
    /// let branches = joined.branches(&BranchRequest::new(point, along, (0.5, 1.5)))?;
    /// assert_eq!(branches[0].end, BranchEnd::Bound);
    /// assert!(branches[0].points.iter().all(|point| point.orbit.is_stable()));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`JoinedError::Engine`] if the motion at the first value does not settle, or if no branch starts there. Other
    /// [`JoinedError`]s for an operating point outside the domain.
    pub fn branches(&self, request: &BranchRequest) -> Result<Vec<JoinedBranch<'a>>, JoinedError> {
        let setting = JoinedPoint::new(self.scene(), request.point);
        let system = system(&setting.scene)?;
        let at_value = |value: f64| -> Result<(Prepared, OperatingPoint), JoinedError> {
            let setting = setting.with(request.along, value);
            let is_of_point = matches!(
                request.along,
                JoinedParameter::Friction | JoinedParameter::Load | JoinedParameter::Frequency
            );
            let prepared = match is_of_point {
                true => prepare_on(&system, setting.point),
                false => prepare(&setting),
            };
            Ok((prepared?, setting.point))
        };
        let (first, last) = request.interval;
        at_value(last)?;
        let family = |value: f64| -> Option<(Chain, f64)> {
            let (prepared, _) = at_value(value).ok()?;
            Some((prepared.chain, prepared.omega))
        };
        let seeds = self.seeds(&setting.with(request.along, first), request.all_states)?;
        let most =
            |seed: &joints::Steady| seed.cycle.amplitudes.iter().copied().fold(0.0, f64::max);
        let size = seeds.iter().map(most).fold(0.0, f64::max);
        let follower = Follower {
            family: &family,
            interval: request.interval,
            most: request.most,
            size: if size > 0.0 { size } else { 1.0 },
            masses: self.scene().masses.len(),
        };
        let followed = all_branches(&follower, &seeds, request.switches);
        if followed.is_empty() {
            return Err(joints::JointError::NotSteady.into());
        }
        let point = |own: joints::BranchPoint| -> Result<JoinedBranchPoint<'a>, JoinedError> {
            let (prepared, point) = at_value(own.value)?;
            let units: (f64, AnswerUnits) = (prepared.omega, prepared.units);
            let orbit = JoinedOrbit::new(self.clone(), prepared.chain, units, own.steady);
            Ok(JoinedBranchPoint {
                value: own.value,
                point,
                orbit,
                is_symmetric: own.is_symmetric,
                events: own.events,
            })
        };
        let branches = followed.into_iter().map(|(branch, parent)| {
            let points: Result<Vec<_>, _> = branch.points.into_iter().map(point).collect();
            Ok(JoinedBranch {
                points: points?,
                end: branch.end,
                parent,
            })
        });
        branches.collect()
    }

    /// Returns the steady states at the first value of the parameter.
    fn seeds(
        &self,
        setting: &JoinedPoint,
        all_states: bool,
    ) -> Result<Vec<joints::Steady>, JoinedError> {
        let system = system(&setting.scene)?;
        let mut joined = system.joined()?;
        joined.set_start(self.start().cloned());
        let (at, friction) = operating(&system, &joined, setting.point)?;
        let orbits = match all_states {
            true => at.states(friction)?,
            false => vec![at.orbit(friction)?],
        };
        Ok(orbits.iter().map(|orbit| orbit.steady().clone()).collect())
    }
}

/// Follows the branches of all steady states at the start, and the branches that begin on them.
fn all_branches(
    follower: &Follower<'_>,
    seeds: &[joints::Steady],
    switches: usize,
) -> Vec<(joints::Branch, Option<Parent>)> {
    let mut all: Vec<(joints::Branch, Option<Parent>)> = Vec::new();
    for seed in seeds {
        if all.iter().any(|(branch, _)| follower.ends_at(branch, seed)) {
            continue;
        }
        all.extend(follower.follow(seed).map(|branch| (branch, None)));
    }
    let mut begin = 0;
    for _ in 0..switches {
        let end = all.len();
        for branch in begin..end {
            let points = all.get(branch).map_or(0, |(own, _)| own.points.len());
            for point in 0..points {
                let parent = Parent { branch, point };
                if let Some(found) = switched(follower, &all, parent) {
                    all.push((found, Some(parent)));
                }
            }
        }
        begin = end;
    }
    all
}

/// Follows the branch that begins at a point of a known branch, unless another known branch passes through the point.
fn switched(
    follower: &Follower<'_>,
    all: &[(joints::Branch, Option<Parent>)],
    parent: Parent,
) -> Option<joints::Branch> {
    let (own, _) = all.get(parent.branch)?;
    let at = own.points.get(parent.point)?;
    let mut others = all.iter().enumerate();
    let is_known =
        others.any(|(other, (branch, _))| other != parent.branch && follower.passes(branch, at));
    if !at.begins_branch() || is_known {
        return None;
    }
    follower.switch(at)
}

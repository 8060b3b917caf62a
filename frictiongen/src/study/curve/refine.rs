//! Adds points to a curve where it bends. The first frequency ratios of the curve are called *places*.
//!
//! An interval between two points stays open until a straight line represents the curve within it. In each round the
//! code halves all open intervals. If the bound on work ends the refinement early, the points are therefore about
//! equally close over the whole range.

use super::answer::{Curve, PieceEnd};
use super::pieces::{self, CurveNode};
use super::places::CurvePlace;
use super::point::CurvePoint;
use super::request::CurveRequest;
use super::straight::{Straight, alike};
use crate::study::scene::Damping;
use crate::study::system::System;
use crate::study::work::work;
use crate::{Error, OutOfDomain, Regime};
use rayon::prelude::*;

/// Smallest relative distance of neighbouring points of a curve. At this distance the refinement stops. If the values
/// of the two points still differ, the code treats the difference as a jump.
pub(super) const NARROW: f64 = 1e-7;
/// Smallest relative distance of neighbouring points where amplitudes scatter. Amplitudes scatter if motions do not
/// settle, or if motions from rest end in different steady states at neighbouring points.
pub(super) const NARROW_SCATTERED: f64 = 1e-3;
/// Largest number of open intervals between two neighbouring frequency ratios of the first grid. An interval stays open
/// until a straight line represents the curve within it. If more intervals are open, the code assumes that the
/// amplitudes scatter from point to point.
const MOST_BENT: usize = 32;
/// Smallest relative width of an interval in which the search locates a change in the contact's pattern of stops.
pub(super) const NARROW_PATTERN: f64 = 1e-4;
/// Smallest relative width of an interval in which the search locates a bound of a gap. A gap is a range of frequency
/// ratios without a response.
const NARROW_GAP: f64 = 1e-7;
/// Lower bound on the amplitude to which the tolerance is relative, divided by the median amplitude over the first
/// grid. The bound keeps the refinement from following bends of a very small motion.
const SMALL: f64 = 1e-3;
/// Number of less important frequency ratios (sub-harmonics of resonances) that the code computes before it compares
/// the work with the bound on work.
const AT_ONCE: usize = 16;
/// Median amplitude below which a motion is treated as rounding, divided by the largest median amplitude of all
/// motions.
const ROUNDING: f64 = 1e-6;

/// An interval between two neighbouring nodes of the curve, which the refinement may halve. A node is a frequency ratio
/// with its response.
#[derive(Clone, Copy, Debug)]
struct NodeInterval {
    left: usize,
    right: usize,
    /// True if the curve was straight over the interval whose halving gave this interval. A single test may miss a
    /// bend, because the middle of an interval may be on the straight line by chance.
    was_straight: bool,
    /// Index of the interval of the first grid that contains this interval.
    part: usize,
}

/// Refines one curve: adds points between its first points.
pub(super) struct Refine<'a> {
    pub system: &'a System,
    pub request: &'a CurveRequest,
    pub beta: f64,
    pub straight: Straight,
}

/// Returns true if the offset of a stuck contact can jump between neighbouring frequencies. Without damping, or with
/// static friction above kinetic friction (μ > 1), the offset depends on every earlier slip. It can then jump.
fn offsets_jump(system: &System) -> bool {
    let scene = system.scene();
    1.0 < scene.stiction || scene.damping == Damping::None
}

impl<'a> Refine<'a> {
    pub(super) fn new(system: &'a System, request: &'a CurveRequest, beta: f64) -> Self {
        Self {
            system,
            request,
            beta,
            straight: Straight {
                accuracy: request.accuracy,
                scales: Vec::new(),
                offsets_jump: offsets_jump(system),
                fall: request.fall,
            },
        }
    }

    /// Returns the response at one frequency ratio of the curve.
    pub(super) fn node(&self, place: &CurvePlace) -> CurveNode {
        let (answer, work) = self.answer(place.r);
        CurveNode {
            r: place.r,
            answer,
            cut: place.cut,
            work,
        }
    }

    fn answer(&self, r: f64) -> (Result<CurvePoint, Error>, usize) {
        let at = self.system.at(r).map_err(Error::from);
        let response = at.and_then(|at| at.response(self.request.beta_at(self.beta, r)));
        let work = work(self.system, r, response.as_ref().map_err(|error| *error));
        let point = response.and_then(|response| {
            CurvePoint::of(r, &response, self.request).ok_or_else(|| OutOfDomain::Mass.into())
        });
        (point, work)
    }

    /// Returns, for each motion, a lower bound on the amplitude to which the tolerance is relative. The bound is a
    /// fraction of the median amplitude over the first points, because a pole hardly changes the median.
    pub(super) fn scales(&self, nodes: &[CurveNode]) -> Vec<f64> {
        let median = |index: usize| {
            let points = nodes.iter().filter_map(|node| node.answer.as_ref().ok());
            let sizes = points.filter_map(|point| {
                let amplitude = point.movements.get(index)?.swing.amplitude;
                Some(amplitude * self.straight.unit(point))
            });
            // Points at which nothing moves do not count, because they say nothing about the size of the motion.
            let mut sizes: Vec<f64> = sizes.filter(|size| 0.0 < *size).collect();
            sizes.sort_by(f64::total_cmp);
            SMALL * sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
        };
        let scales: Vec<f64> = (0..self.request.of.len()).map(median).collect();
        // If a stuck contact isolates a mass from the load, its computed motion is rounding. The refinement must not
        // follow bends of a motion that is only rounding.
        let least = ROUNDING * scales.iter().copied().fold(0.0, f64::max);
        scales.into_iter().map(|scale| scale.max(least)).collect()
    }

    /// Computes the points of the first grid. The second result is true if the permitted work sufficed for all points.
    /// The code computes less important points (sub-harmonics of resonances) last.
    fn grid(&self, places: &[CurvePlace]) -> (Vec<CurveNode>, bool) {
        let (spare, needed): (Vec<CurvePlace>, Vec<CurvePlace>) =
            places.iter().partition(|place| place.spare);
        let nodes = |places: &[CurvePlace]| -> Vec<CurveNode> {
            places.par_iter().map(|place| self.node(place)).collect()
        };
        let mut found = nodes(&needed);
        for some in spare.chunks(AT_ONCE) {
            if self.request.work <= spent(&found) {
                return (found, false);
            }
            found.extend(nodes(some));
        }
        (found, true)
    }

    /// Returns the curve through the frequency ratios of the first grid and the points that the refinement adds.
    pub(super) fn refined(mut self, places: &[CurvePlace]) -> Curve {
        let (mut nodes, mut refined) = self.grid(places);
        let mut left = self.request.work.saturating_sub(spent(&nodes));
        nodes.sort_by(|a, b| a.r.total_cmp(&b.r));
        self.straight.scales = self.scales(&nodes);
        let cut = |part: &usize| nodes.get(*part).is_some_and(|node| node.cut.is_some());
        let parts = (0..nodes.len().saturating_sub(1)).filter(|part| !cut(part));
        let mut open: Vec<NodeInterval> = parts
            .map(|part| NodeInterval {
                left: part,
                right: part + 1,
                was_straight: false,
                part,
            })
            .collect();
        while !open.is_empty() {
            let halved = self.worth_halving(&open, &mut nodes);
            let kept = affordable(&halved, &nodes, left);
            refined &= kept == halved.len();
            let (halved, given_up) = halved.split_at(kept);
            self.cut_apart(given_up, &mut nodes);
            let middles: Vec<CurveNode> = halved
                .par_iter()
                .map(|(_, r)| self.node(&CurvePlace::at(*r)))
                .collect();
            left = left.saturating_sub(spent(&middles));
            open = Vec::new();
            for ((interval, _), middle) in halved.iter().zip(middles) {
                open.extend(self.halves(*interval, middle, &mut nodes));
            }
        }
        nodes.sort_by(|a, b| a.r.total_cmp(&b.r));
        pieces::curve((self.beta, self.request.start), nodes.into_iter(), refined)
    }

    /// Returns the middles of all intervals in `open` that are wide enough to halve. If the amplitudes at the two
    /// points of a narrow interval still differ by a jump, the function cuts the curve between the points.
    fn worth_halving(
        &self,
        open: &[NodeInterval],
        nodes: &mut [CurveNode],
    ) -> Vec<(NodeInterval, f64)> {
        let mut in_part = std::collections::HashMap::new();
        for interval in open {
            *in_part.entry(interval.part).or_insert(0_usize) += 1;
        }
        let (mut halved, mut narrow) = (Vec::new(), Vec::new());
        for interval in open {
            let (Some(a), Some(b)) = (nodes.get(interval.left), nodes.get(interval.right)) else {
                continue;
            };
            let few = in_part
                .get(&interval.part)
                .is_none_or(|count| *count <= MOST_BENT);
            let least = match (&a.answer, &b.answer) {
                (Ok(a), Ok(b)) if a.settled && b.settled && (few || self.is_one_state(a, b)) => {
                    NARROW
                }
                (Ok(_), Ok(_)) => NARROW_SCATTERED,
                // If both points have no response for the same reason, points between them give no new information.
                (Err(a), Err(b)) if a == b => continue,
                _ => NARROW_GAP,
            };
            let middle = 0.5 * (a.r + b.r);
            if b.r - a.r <= least * b.r {
                narrow.push((*interval, middle));
            } else if a.r < middle && middle < b.r {
                halved.push((*interval, middle));
            }
        }
        self.cut_apart(&narrow, nodes);
        halved
    }

    /// Returns true if two settled points certainly belong to the same steady state, however steep the curve between
    /// them is. The state is certainly the same in two cases: both points belong to the closed form, or μ ≤ 1 and no
    /// other state exists.
    fn is_one_state(&self, a: &CurvePoint, b: &CurvePoint) -> bool {
        let slides = |point: &CurvePoint| point.regime == Regime::Continuous;
        self.system.scene().stiction <= 1.0 || (slides(a) && slides(b))
    }

    /// Cuts the curve within intervals at whose two points the amplitudes differ by a jump.
    fn cut_apart(&self, intervals: &[(NodeInterval, f64)], nodes: &mut [CurveNode]) {
        for (interval, _) in intervals {
            let ends = [interval.left, interval.right].map(|end| nodes.get(end));
            let apart = match ends.map(|end| end.map(|node| &node.answer)) {
                [Some(Ok(a)), Some(Ok(b))] => !self.straight.touch(a, b),
                _ => false,
            };
            if let Some(left) = nodes.get_mut(interval.left).filter(|_| apart) {
                left.cut = Some(PieceEnd::Jump);
            }
        }
    }

    /// Stores the middle of an interval and returns both halves. Returns no halves if the curve is straight over this
    /// interval and over the longer interval from which it came.
    fn halves(
        &self,
        interval: NodeInterval,
        middle: CurveNode,
        nodes: &mut Vec<CurveNode>,
    ) -> Vec<NodeInterval> {
        let (Some(a), Some(b)) = (nodes.get(interval.left), nodes.get(interval.right)) else {
            return Vec::new();
        };
        let width = b.r - a.r;
        let straight = match (&a.answer, &middle.answer, &b.answer) {
            (Ok(a), Ok(m), Ok(b)) => {
                self.straight.is_straight(a, m, b)
                    && (alike([a, m, b]) || width <= NARROW_PATTERN * middle.r)
            }
            (Err(a), Err(m), Err(b)) => a == m && m == b,
            _ => false,
        };
        let place = nodes.len();
        nodes.push(middle);
        if straight && interval.was_straight {
            return Vec::new();
        }
        let half = |left: usize, right: usize| NodeInterval {
            left,
            right,
            was_straight: straight,
            part: interval.part,
        };
        vec![half(interval.left, place), half(place, interval.right)]
    }
}

/// Returns the total work that the code has spent on the given nodes (frequency ratios with their responses).
pub(super) fn spent(nodes: &[CurveNode]) -> usize {
    nodes.iter().map(|node| node.work).sum()
}

/// Returns the number of intervals, counted from the first, for which the remaining work suffices. As an estimate of
/// the work for the middle of an interval, the code takes the larger work of its two points.
fn affordable(intervals: &[(NodeInterval, f64)], nodes: &[CurveNode], left: usize) -> usize {
    let work = |end: usize| nodes.get(end).map_or(0, |node| node.work);
    let mut sum = 0_usize;
    let within = intervals.iter().take_while(|(interval, _)| {
        sum = sum.saturating_add(work(interval.left).max(work(interval.right)));
        sum <= left
    });
    within.count()
}

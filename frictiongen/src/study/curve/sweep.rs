//! Curves as in a laboratory sweep: the motion at each point starts from the steady state of the previous point. A
//! *place* is a frequency ratio at which the sweep always has a point.

use super::answer::{Curve, PieceEnd};
use super::pieces;
use super::pieces::CurveNode;
use super::places::CurvePlace;
use super::point::CurvePoint;
use super::refine::{NARROW, NARROW_PATTERN, NARROW_SCATTERED, Refine, spent};
use super::request::CurveStart;
use super::straight::alike;
use crate::study::start::InitialState;
use crate::study::work::work;
use crate::{Error, OutOfDomain, Regime};

/// Largest number of jumps between two neighbouring frequency ratios of the sweep's first grid. If more jumps occur,
/// the code assumes that the amplitudes scatter from point to point.
const MOST_JUMPS: u32 = 4;

/// A point of a sweep, with the state from which the next point starts.
struct SweepStep {
    node: CurveNode,
    carried: InitialState,
}

impl Refine<'_> {
    /// Returns the curve that the sweep follows through the given frequency ratios, in the requested direction.
    pub(super) fn swept(mut self, places: &[CurvePlace]) -> Curve {
        let down = self.request.start == CurveStart::Down;
        // A sweep computes the motion at each of these frequency ratios twice, first for the scales and then for the
        // curve. To save work, it leaves out the less important frequency ratios (sub-harmonics of resonances).
        let places = places.iter().filter(|place| !place.spare);
        let mut places: Vec<CurvePlace> = places.copied().collect();
        if down {
            places.reverse();
        }
        // The cut at a pole is stored with the frequency ratio just below the pole.
        let poles: Vec<bool> = places
            .windows(2)
            .map(|pair| {
                let below = if down { pair.last() } else { pair.first() };
                below.is_some_and(|place| place.cut == Some(PieceEnd::Pole))
            })
            .collect();
        let coarse = self.coarse(&places);
        self.straight.scales = self.scales(&coarse);
        let sweep = self;
        let mut left = sweep.request.work.checked_sub(spent(&coarse));
        let mut steps: Vec<SweepStep> = Vec::new();
        if let Some(first) = places.first() {
            steps.push(sweep.step(first.r, &sweep.first()));
        }
        for (place, pole) in places.iter().skip(1).zip(poles) {
            sweep.reach(place.r, pole, &mut steps, &mut left);
        }
        let mut nodes: Vec<CurveNode> = steps.into_iter().map(|step| step.node).collect();
        if down {
            nodes.reverse();
            // Each cut must belong to the node with the lower frequency ratio, also after the reversal of the order.
            let cuts: Vec<Option<PieceEnd>> = nodes.iter().skip(1).map(|node| node.cut).collect();
            for (node, cut) in nodes.iter_mut().zip(cuts.into_iter().chain([None])) {
                node.cut = cut;
            }
        }
        let asked = (sweep.beta, sweep.request.start);
        pieces::curve(asked, nodes.into_iter(), left.is_some())
    }

    /// Returns only the points at the first frequency ratios, without refinement. The amplitudes at these points give
    /// the scale of each motion.
    fn coarse(&self, places: &[CurvePlace]) -> Vec<CurveNode> {
        let mut carried = self.first();
        let nodes = places.iter().map(|place| {
            let step = self.step(place.r, &carried);
            carried.clone_from(&step.carried);
            step.node
        });
        nodes.collect()
    }

    /// Returns the state from which the sweep starts.
    fn first(&self) -> InitialState {
        let rest = || InitialState::rest(self.system.scene().masses.len());
        self.system.start.clone().unwrap_or_else(rest)
    }

    /// Returns the response at the frequency ratio r, for a motion from the state `start`.
    fn step(&self, r: f64, start: &InitialState) -> SweepStep {
        let found = self.system.at(r).map_err(Error::from).and_then(|at| {
            let beta = self.request.beta_at(self.beta, r);
            let (response, carried) = at.response_from(beta, start, self.request.fall)?;
            let point = CurvePoint::of(r, &response, self.request).ok_or(OutOfDomain::Mass)?;
            Ok((point, carried, work(self.system, r, Ok(&response))))
        });
        let (answer, carried, work) = match found {
            Ok((point, carried, work)) => (Ok(point), carried, work),
            // If there is no response at r, the next point starts from the state of the last point with a response.
            Err(error) => (Err(error), start.clone(), work(self.system, r, Err(error))),
        };
        SweepStep {
            node: CurveNode {
                r,
                answer,
                cut: None,
                work,
            },
            carried,
        }
    }

    /// Continues the sweep from the last step to the frequency ratio r, in small steps where the curve bends.
    ///
    /// If a step ends in another steady state, the code halves the step until it has located the jump. The length of a
    /// step alone therefore never causes a jump. `left` is the remaining work. If no work remains, each step goes
    /// directly to the next frequency ratio of the first grid.
    fn reach(&self, r: f64, pole: bool, steps: &mut Vec<SweepStep>, left: &mut Option<usize>) {
        let mut targets = vec![r];
        let mut jumps = 0;
        while let (Some(target), Some(last)) = (targets.last().copied(), steps.last_mut()) {
            let middle = 0.5 * (last.node.r + target);
            let width = (target - last.node.r).abs();
            let narrow = if jumps < MOST_JUMPS && settled(&last.node) {
                NARROW
            } else {
                NARROW_SCATTERED
            };
            let least = last.node.r.min(target);
            if pole
                || left.is_none()
                || width <= narrow * target
                || !(least < middle && middle < least + width)
            {
                let step = self.step(target, &last.carried);
                last.node.cut = self.cut(&last.node, &step.node, pole);
                jumps += u32::from(last.node.cut == Some(PieceEnd::Jump));
                steps.push(step);
                targets.pop();
                continue;
            }
            let between = self.step(middle, &last.carried);
            let end = self.step(target, &between.carried);
            *left = left.and_then(|left| left.checked_sub(between.node.work + end.node.work));
            let done = match (&last.node.answer, &between.node.answer, &end.node.answer) {
                (Ok(a), Ok(m), Ok(b)) => {
                    self.straight.is_straight(a, m, b)
                        && (alike([a, m, b]) || width <= NARROW_PATTERN * target)
                }
                (Err(a), Err(m), Err(b)) => a == m && m == b,
                _ => false,
            };
            if done {
                steps.extend([between, end]);
                targets.pop();
            } else {
                targets.push(middle);
            }
        }
    }

    /// Returns the reason why the curve is cut between two neighbouring nodes (frequency ratios with their responses).
    /// Returns `None` without a cut. `pole` is true at a pole of the motion from rest. A contact that sticks on both sides
    /// of it does not follow that motion.
    fn cut(&self, last: &CurveNode, next: &CurveNode, pole: bool) -> Option<PieceEnd> {
        let sticks = |node: &CurveNode| {
            let answer = node.answer.as_ref();
            answer.is_ok_and(|point| point.regime == Regime::Stuck)
        };
        match (&last.answer, &next.answer) {
            _ if pole && !(sticks(last) && sticks(next)) => Some(PieceEnd::Pole),
            (Ok(a), Ok(b)) if !self.straight.touch(a, b) => Some(PieceEnd::Jump),
            _ => None,
        }
    }
}

fn settled(node: &CurveNode) -> bool {
    node.answer.as_ref().is_ok_and(|point| point.settled)
}

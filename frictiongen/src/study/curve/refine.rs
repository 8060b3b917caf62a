//! Points between two places, as many as the curve bends.

use super::answer::{Curve, End, Gap, Piece};
use super::places::Place;
use super::point::CurvePoint;
use super::request::CurveRequest;
use crate::study::response::Swing;
use crate::study::system::System;
use crate::{Error, OutOfDomain};
use std::f64::consts::PI;

/// Two places nearer than this, relatively, that still differ are on two sides of a jump.
const NARROW: f64 = 1e-7;
/// The same where amplitudes scatter: of motions that do not settle, and where the motion from rest ends in one or another
/// of several steady states, however near its neighbours are.
const NARROW_SCATTERED: f64 = 1e-3;
/// So many jumps between two places of the first grid are each found; beyond, the motion scatters.
const MOST_JUMPS: u32 = 4;
/// Up to which distance, relatively, the place is sought at which the contact begins to stop in another way.
const NARROW_PATTERN: f64 = 1e-4;
/// Up to which distance, relatively, the end of a gap is sought.
const NARROW_GAP: f64 = 1e-7;
/// Below this share of the largest amplitude of the first grid a bend is not followed.
const SMALL: f64 = 1e-3;
/// A motion below this share of another is none.
const ROUNDING: f64 = 1e-6;

/// A place with its response.
#[derive(Clone, Debug)]
pub(super) struct Node {
    r: f64,
    answer: Result<CurvePoint, Error>,
    /// Why the curve is cut between here and the next node, if it is.
    cut: Option<End>,
}

/// Refines one curve.
pub(super) struct Refine<'a> {
    system: &'a System,
    request: &'a CurveRequest,
    beta: f64,
    /// The amplitudes that count, for each motion.
    scales: Vec<f64>,
}

impl<'a> Refine<'a> {
    pub(super) fn new(system: &'a System, request: &'a CurveRequest, beta: f64) -> Self {
        Self {
            system,
            request,
            beta,
            scales: vec![0.0; request.of.len()],
        }
    }

    /// The same, with amplitudes counting against those of the first nodes: against their median, which a pole leaves alone.
    pub(super) fn scaled(mut self, nodes: &[Node]) -> Self {
        for (index, scale) in self.scales.iter_mut().enumerate() {
            let points = nodes.iter().filter_map(|node| node.answer.as_ref().ok());
            let sizes =
                points.filter_map(|point| Some(point.movements.get(index)?.swing.amplitude));
            // What is stuck says nothing of how large a motion is.
            let mut sizes: Vec<f64> = sizes.filter(|size| 0.0 < *size).collect();
            sizes.sort_by(f64::total_cmp);
            *scale = SMALL * sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
        }
        // What a stuck contact cuts off moves by rounding only, whose bends nobody wants.
        let least = ROUNDING * self.scales.iter().copied().fold(0.0, f64::max);
        for scale in &mut self.scales {
            *scale = scale.max(least);
        }
        self
    }

    /// The response at a place.
    pub(super) fn node(&self, place: &Place) -> Node {
        Node {
            r: place.r,
            answer: self.answer(place.r),
            cut: place.cut,
        }
    }

    fn answer(&self, r: f64) -> Result<CurvePoint, Error> {
        let response = self.system.at(r)?.response(self.beta)?;
        CurvePoint::of(r, &response, self.request)
            .ok_or_else(|| OutOfDomain { argument: "mass" }.into())
    }

    /// The first of two nodes, and what lies between them.
    pub(super) fn part(&self, pair: &[Node]) -> Vec<Node> {
        let [left, right] = pair else {
            return Vec::new();
        };
        let mut nodes = vec![left.clone()];
        if left.cut.is_none() {
            self.between(left, right, false, &mut nodes, &mut 0);
        }
        nodes
    }

    /// Adds the nodes that lie between two, the first of which is the last of `nodes`.  An interval is done when it and the
    /// one that it is a half of are straight: in the middle alone a bend may pass by chance.
    fn between(
        &self,
        left: &Node,
        right: &Node,
        was_straight: bool,
        nodes: &mut Vec<Node>,
        jumps: &mut u32,
    ) {
        let width = right.r - left.r;
        let narrow = match (&left.answer, &right.answer) {
            (Ok(a), Ok(b)) if a.settled && b.settled && *jumps < MOST_JUMPS => NARROW,
            (Ok(_), Ok(_)) => NARROW_SCATTERED,
            // Answers of no place between are of no use.
            (Err(a), Err(b)) if a == b => return,
            _ => NARROW_GAP,
        };
        if width <= narrow * right.r {
            let apart = match (&left.answer, &right.answer) {
                (Ok(a), Ok(b)) => !self.touch(a, b),
                _ => false,
            };
            if let Some(last) = nodes.last_mut().filter(|_| apart) {
                last.cut = Some(End::Jump);
                *jumps += 1;
            }
            return;
        }
        let r = 0.5 * (left.r + right.r);
        if !(left.r < r && r < right.r) {
            return;
        }
        let middle = Node {
            r,
            answer: self.answer(r),
            cut: None,
        };
        let straight = match (&left.answer, &middle.answer, &right.answer) {
            (Ok(a), Ok(m), Ok(b)) => {
                self.is_straight(a, m, b) && (alike([a, m, b]) || width <= NARROW_PATTERN * r)
            }
            (Err(a), Err(m), Err(b)) => a == m && m == b,
            _ => false,
        };
        let done = straight && was_straight;
        if !done {
            self.between(left, &middle, straight, nodes, jumps);
        }
        nodes.push(middle.clone());
        if !done {
            self.between(&middle, right, straight, nodes, jumps);
        }
    }

    /// Whether a straight line from a to b passes m as closely as is asked.
    fn is_straight(&self, a: &CurvePoint, m: &CurvePoint, b: &CurvePoint) -> bool {
        let accuracy = self.request.accuracy;
        self.swings([a, m, b]).all(|([a, m, b], scale)| {
            let stray = (m.amplitude - 0.5 * (a.amplitude + b.amplitude)).abs();
            let bends = accuracy * m.amplitude.abs().max(scale);
            // A phase counts as its motion does, which vanishes with the amplitude.
            let phases = match (a.phase, m.phase, b.phase) {
                (Some(a), Some(m), Some(b)) => 0.5 * (turn(a, m) + turn(b, m)).abs(),
                _ => 0.0,
            };
            let counted = m.amplitude.min(a.amplitude.max(b.amplitude));
            stray <= bends && (phases <= 2.0 * PI * accuracy || counted <= scale)
        })
    }

    /// Whether two points next to each other are of one curve.
    fn touch(&self, a: &CurvePoint, b: &CurvePoint) -> bool {
        let reach = 100.0 * self.request.accuracy;
        self.swings([a, b]).all(|([a, b], scale)| {
            let size = a.amplitude.max(b.amplitude).max(scale);
            (a.amplitude - b.amplitude).abs() <= reach * size
        })
    }

    /// Motion by motion, the swings at several points, and the amplitude that counts.
    fn swings<'p, const N: usize>(
        &'p self,
        points: [&'p CurvePoint; N],
    ) -> impl Iterator<Item = ([Swing; N], f64)> + 'p {
        self.scales
            .iter()
            .enumerate()
            .filter_map(move |(index, scale)| {
                let mut swings = [Swing::REST; N];
                for (swing, point) in swings.iter_mut().zip(points) {
                    *swing = point.movements.get(index)?.swing;
                }
                Some((swings, *scale))
            })
    }

    /// The pieces and gaps of the nodes in their order.
    pub(super) fn curve(&self, nodes: impl Iterator<Item = Node>) -> Curve {
        let mut builder = Builder::default();
        for node in nodes {
            match node.answer {
                Ok(point) => builder.point(point),
                Err(reason) => builder.missing(node.r, reason),
            }
            if let Some(cut) = node.cut {
                builder.end(cut);
            }
        }
        builder.end(End::Range);
        Curve {
            beta: self.beta,
            pieces: builder.pieces,
            gaps: builder.gaps,
        }
    }
}

/// Whether the contact does the same at three points.
fn alike(points: [&CurvePoint; 3]) -> bool {
    let pattern = |point: &CurvePoint| (point.stops, point.period, point.settled);
    points
        .iter()
        .all(|point| pattern(point) == pattern(points[0]))
}

/// Phase differences in (−π, π].
fn turn(a: f64, b: f64) -> f64 {
    let difference = a - b;
    difference - 2.0 * PI * (difference / (2.0 * PI)).round()
}

/// Puts nodes together.
#[derive(Default)]
struct Builder {
    pieces: Vec<Piece>,
    gaps: Vec<Gap>,
    open: Vec<CurvePoint>,
    start: Option<End>,
    in_gap: bool,
}

impl Builder {
    fn point(&mut self, point: CurvePoint) {
        self.in_gap = false;
        // On a boundary rounding may put a point into the regime beyond.
        if self
            .open
            .last()
            .is_some_and(|last| last.regime != point.regime)
        {
            self.end(End::Boundary);
        }
        self.open.push(point);
    }

    fn missing(&mut self, r: f64, reason: Error) {
        self.end(End::NoAnswer);
        match self.gaps.last_mut() {
            Some(gap) if self.in_gap && gap.reason == reason => gap.to = r,
            _ => self.gaps.push(Gap {
                from: r,
                to: r,
                reason,
            }),
        }
        self.in_gap = true;
    }

    fn end(&mut self, end: End) {
        let points = std::mem::take(&mut self.open);
        let start = self.start.replace(end).unwrap_or(End::Range);
        if let Some(first) = points.first() {
            self.pieces.push(Piece {
                regime: first.regime,
                points,
                start,
                end,
            });
        }
    }
}

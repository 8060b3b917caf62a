//! Joins the points of a curve into pieces, and the frequencies without a response into gaps.

use super::answer::{Curve, CurvePiece, Gap, PieceEnd};
use super::point::CurvePoint;
use super::request::CurveStart;
use crate::Error;

/// A frequency ratio r of a curve, with the response at this r or the reason why there is none.
#[derive(Clone, Debug)]
pub(super) struct CurveNode {
    pub r: f64,
    pub answer: Result<CurvePoint, Error>,
    /// The reason why the curve is cut between this frequency ratio and the next. `None` without a cut.
    pub cut: Option<PieceEnd>,
    pub work: usize,
}

/// Returns the curve through nodes in ascending order of frequency. A node is a frequency ratio with its response.
pub(super) fn curve(
    (beta, start): (f64, CurveStart),
    nodes: impl Iterator<Item = CurveNode>,
    refined: bool,
) -> Curve {
    let mut builder = PieceBuilder::default();
    for node in nodes {
        match node.answer {
            Ok(point) => builder.point(point),
            Err(reason) => builder.missing(node.r, reason),
        }
        if let Some(cut) = node.cut {
            builder.end(cut);
        }
    }
    builder.end(PieceEnd::Range);
    Curve {
        beta,
        start,
        pieces: builder.pieces,
        gaps: builder.gaps,
        refined,
    }
}

/// Collects nodes (frequency ratios with their responses) in ascending order into pieces and gaps.
#[derive(Default)]
struct PieceBuilder {
    pieces: Vec<CurvePiece>,
    gaps: Vec<Gap>,
    open: Vec<CurvePoint>,
    start: Option<PieceEnd>,
    in_gap: bool,
}

impl PieceBuilder {
    fn point(&mut self, point: CurvePoint) {
        self.in_gap = false;
        // Rounding may put a point on a regime boundary into the wrong regime. The curve therefore needs a cut wherever
        // the regime changes.
        if self
            .open
            .last()
            .is_some_and(|last| last.regime != point.regime)
        {
            self.end(PieceEnd::Boundary);
        }
        self.open.push(point);
    }

    fn missing(&mut self, r: f64, reason: Error) {
        self.end(PieceEnd::NoAnswer);
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

    fn end(&mut self, end: PieceEnd) {
        let points = std::mem::take(&mut self.open);
        let start = self.start.replace(end).unwrap_or(PieceEnd::Range);
        if let Some(first) = points.first() {
            self.pieces.push(CurvePiece {
                regime: first.regime,
                points,
                start,
                end,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NoOrbit, Regime};

    fn node(r: f64, answered: bool) -> CurveNode {
        let point = CurvePoint {
            r,
            regime: Regime::StickSlip,
            stops: 2,
            period: 1,
            settled: true,
            marginal: false,
            from_rest: true,
            offset: 0.0,
            movements: Vec::new(),
            contact_force: 1.0,
            friction_work: 1.0,
        };
        let reason = Error::NoOrbit(NoOrbit::TooManyEvents);
        CurveNode {
            r,
            answer: if answered { Ok(point) } else { Err(reason) },
            cut: None,
            work: 1,
        }
    }

    /// Checks that neighbouring nodes without a response become one gap, and that a point between two such nodes ends
    /// the gap.
    #[test]
    fn a_point_between_gaps_parts_them() {
        let nodes = [(0.1, false), (0.2, false), (0.3, true), (0.4, false)];
        let nodes = nodes.into_iter().map(|(r, answered)| node(r, answered));
        let curve = curve((0.5, CurveStart::Rest), nodes, true);
        let gaps: Vec<[f64; 2]> = curve.gaps.iter().map(|gap| [gap.from, gap.to]).collect();
        assert_eq!(gaps, [[0.1, 0.2], [0.4, 0.4]]);
        assert_eq!(curve.pieces.len(), 1);
    }
}

//! Curves sampled as finely as a picture shows them.

use crate::figure::Axis;

/// Halvings of an interval of the first grid.
const DEPTH: usize = 5;
/// How near, relatively, the end of a curve is approached: it may leave it as a square root.
const EDGE: f64 = 1e-6;
const INTERVALS: usize = 150;
/// How far a curve may stray from its chord, as a share of the axis: under a quarter of a pixel.
const BEND: f64 = 3e-4;
/// Steps beyond this share of the axis are halved.
const STEP: f64 = 0.03;
/// A step beyond this after all halvings, which leave a fraction of a pixel, is a jump: the line breaks.
const JUMP: f64 = 0.25;
/// Pixels by which a left-out point may lie off the drawn line; a picture's own rounding is 0.5.
const SEEN: f64 = 0.2;

/// Pieces of a curve; it breaks where the function has no value, and at jumps.
pub type Pieces = Vec<Vec<(f64, f64)>>;

type Point = (f64, Option<f64>);

/// Samples a function over x; `marks` are places to resolve, such as resonances.
pub fn sample(x: &Axis, y: &Axis, marks: &[f64], function: impl Fn(f64) -> Option<f64>) -> Pieces {
    let value = |at: f64| (at, function(at).filter(|value| value.is_finite()));
    let width = x.high - x.low;
    let mut grid: Vec<f64> = (0..=INTERVALS)
        .map(|i| x.low + width * i as f64 / INTERVALS as f64)
        .chain(marks.iter().flat_map(|mark| {
            // Both sides of a pole, and nothing on it.
            [mark - 1e-7 * width, mark + 1e-7 * width]
        }))
        .filter(|at| x.low <= *at && *at <= x.high)
        .collect();
    grid.sort_by(f64::total_cmp);
    let mut points = Vec::new();
    let mut left: Option<Point> = None;
    for at in grid {
        let right = value(at);
        if let Some(left) = left {
            refine(&value, y, left, right, DEPTH, &mut points);
        }
        points.push(right);
        left = Some(right);
    }
    pieces(&points, y)
}

/// Adds the points that lie inside an interval.
fn refine(
    value: &impl Fn(f64) -> Point,
    y: &Axis,
    left: Point,
    right: Point,
    depth: usize,
    points: &mut Vec<Point>,
) {
    let ends = left.1.is_some() != right.1.is_some();
    if depth == 0 && (!ends || right.0 - left.0 < EDGE * right.0) {
        return;
    }
    let middle = value(0.5 * (left.0 + right.0));
    let finer = match (left.1, middle.1, right.1) {
        (Some(a), Some(m), Some(b)) => {
            let [a, m, b] = [a, m, b].map(|value| y.share(value));
            BEND < (m - 0.5 * (a + b)).abs() || STEP < (b - a).abs()
        }
        (None, None, None) => false,
        _ => true,
    };
    if finer {
        refine(value, y, left, middle, depth.saturating_sub(1), points);
    }
    points.push(middle);
    if finer {
        refine(value, y, middle, right, depth.saturating_sub(1), points);
    }
}

fn pieces(points: &[Point], y: &Axis) -> Pieces {
    let mut pieces: Pieces = Vec::new();
    let mut piece: Vec<(f64, f64)> = Vec::new();
    for (x, value) in points {
        let jumps = match (piece.last(), value) {
            (Some((_, last)), Some(value)) => JUMP < (y.share(*value) - y.share(*last)).abs(),
            (_, None) => true,
            _ => false,
        };
        if jumps && !piece.is_empty() {
            pieces.push(std::mem::take(&mut piece));
        }
        piece.extend(value.map(|value| (*x, value)));
    }
    pieces.push(piece);
    pieces.retain(|piece| 1 < piece.len());
    pieces.iter().flat_map(|piece| clip(piece, y)).collect()
}

/// Cuts off what leaves the axis.
fn clip(piece: &[(f64, f64)], y: &Axis) -> Pieces {
    let inside = |point: &(f64, f64)| y.low <= point.1 && point.1 <= y.high;
    let mut clipped: Pieces = Vec::new();
    let mut current: Vec<(f64, f64)> = Vec::new();
    for pair in piece.windows(2) {
        let &[a, b] = pair else { continue };
        let crossing = |bound: f64| {
            let share = (bound - a.1) / (b.1 - a.1);
            (a.0 + share * (b.0 - a.0), bound)
        };
        let mut kept: Vec<(f64, f64)> = Vec::new();
        if inside(&a) {
            kept.push(a);
        }
        let (first, second) = if a.1 < b.1 {
            (y.low, y.high)
        } else {
            (y.high, y.low)
        };
        for bound in [first, second] {
            if (a.1 < bound) != (b.1 < bound) && a.1 != bound && b.1 != bound {
                kept.push(crossing(bound));
            }
        }
        if inside(&b) {
            kept.push(b);
        }
        if current.last() != kept.first() && !current.is_empty() {
            clipped.push(std::mem::take(&mut current));
        }
        let skip = usize::from(!current.is_empty());
        current.extend(kept.into_iter().skip(skip));
    }
    clipped.push(current);
    clipped.retain(|piece| 1 < piece.len());
    clipped
}

/// Leaves out the points that a straight line already shows: those nearer than `SEEN` to it, with
/// axes of the given numbers of pixels.
#[must_use]
pub fn thin(
    piece: &[(f64, f64)],
    (x, width): (&Axis, f64),
    (y, height): (&Axis, f64),
) -> Vec<(f64, f64)> {
    let pixels: Vec<(f64, f64)> = piece
        .iter()
        .map(|point| (x.share(point.0) * width, y.share(point.1) * height))
        .collect();
    let mut kept: Vec<(f64, f64)> = Vec::new();
    let mut start = 0;
    for end in 1..=piece.len() {
        let straight = end < piece.len()
            && pixels[start + 1..end]
                .iter()
                .all(|point| distance(*point, pixels[start], pixels[end]) < SEEN);
        if !straight {
            kept.push(piece[start]);
            start = end - 1;
        }
    }
    kept.extend(piece.last());
    kept.dedup();
    kept
}

/// From a point to the segment between two others.
fn distance(point: (f64, f64), a: (f64, f64), b: (f64, f64)) -> f64 {
    let along = (b.0 - a.0, b.1 - a.1);
    let from = (point.0 - a.0, point.1 - a.1);
    let square = along.0 * along.0 + along.1 * along.1;
    let share = if 0.0 < square {
        ((from.0 * along.0 + from.1 * along.1) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from.0 - share * along.0).hypot(from.1 - share * along.1)
}

//! Cleans up a panel over frequency: redundant points, whole turns of a phase, and motions that do not settle.

use frictiongen_plot::{Axis, Layer, Marker, Markers, Panel, Point, Scale, desk};

/// Largest distance between a removed point and the remaining line, as a fraction of the axis. It is about a
/// hundredth of a pixel.
const STRAY: f64 = 3e-5;
/// Points farther than this distance beyond an axis are removed. The distance is a multiple of the axis's length.
const BEYOND: f64 = 1.0;
/// A run of phases shorter than this fraction of the axis is removed, because it looks like a speck.
const SPECK: f64 = 2e-3;

/// Returns the panel without points that lie on a straight line between others, and without dots of motions that do
/// not settle.
#[must_use]
pub fn tidy(mut panel: Panel) -> Panel {
    let scattered = |layer: &Layer| {
        matches!(
            layer,
            Layer::Markers(Markers {
                marker: Marker::Dot,
                name: None,
                ..
            })
        )
    };
    panel.layers.retain(|layer| !scattered(layer));
    let (x, y) = (panel.x.clone(), panel.y.clone());
    for layer in &mut panel.layers {
        if let Layer::Line(line) = layer {
            let near = line.pieces.iter().flat_map(|piece| seen(piece, &y));
            let thinned = near.map(|piece| thin(&piece, &x, &y));
            line.pieces = thinned.filter(|piece| 1 < piece.len()).collect();
        }
    }
    panel
}

/// Returns the position of a value along an axis, from 0 at the lower end to 1 at the upper end.
fn share(axis: &Axis, value: f64) -> f64 {
    match axis.scale {
        Scale::Linear => (value - axis.low) / (axis.high - axis.low),
        Scale::Log => {
            let place = |value: f64| value.max(f64::MIN_POSITIVE).ln();
            (place(value) - place(axis.low)) / (place(axis.high) - place(axis.low))
        }
    }
}

/// Cuts a piece of a curve into runs that lie within the axis or near it. Each run keeps one point beyond the axis at
/// each end.
fn seen(piece: &[Point], y: &Axis) -> Vec<Vec<Point>> {
    let far = |point: &Point| !(-BEYOND..=1.0 + BEYOND).contains(&share(y, point.1));
    let mut parts: Vec<Vec<Point>> = vec![Vec::new()];
    let mut last: Option<Point> = None;
    for point in piece {
        if far(point) {
            // The last point beyond the axis is kept rather than the first, because it may be the end of a jump.
            if last.is_some_and(|last| !far(&last)) {
                parts
                    .last_mut()
                    .into_iter()
                    .for_each(|part| part.push(*point));
                parts.push(Vec::new());
            }
        } else if let Some(part) = parts.last_mut() {
            if part.is_empty() {
                part.extend(last);
            }
            part.push(*point);
        }
        last = Some(*point);
    }
    parts
}

/// Returns the points of a curve that are needed to draw it. Points on a straight line between others are left out.
fn thin(piece: &[Point], x: &Axis, y: &Axis) -> Vec<Point> {
    let places: Vec<Point> = piece
        .iter()
        .map(|p| (share(x, p.0), share(y, p.1)))
        .collect();
    let mut kept = vec![false; piece.len()];
    let mut open = vec![(0, piece.len().saturating_sub(1))];
    while let Some((from, to)) = open.pop() {
        for end in [from, to] {
            if let Some(kept) = kept.get_mut(end) {
                *kept = true;
            }
        }
        let (Some(a), Some(b)) = (places.get(from), places.get(to)) else {
            continue;
        };
        let inner = places.iter().enumerate().take(to).skip(from + 1);
        let farthest = inner
            .map(|(index, point)| (index, distance(*point, *a, *b)))
            .max_by(|one, other| one.1.total_cmp(&other.1));
        if let Some((index, _)) = farthest.filter(|(_, away)| STRAY < *away) {
            open.extend([(from, index), (index, to)]);
        }
    }
    let shown = piece.iter().zip(kept).filter(|(_, kept)| *kept);
    shown.map(|(point, _)| *point).collect()
}

/// Returns the distance from a point to the segment from a to b.
fn distance(point: Point, a: Point, b: Point) -> f64 {
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

/// Returns the panel without runs of phases that are too short to be seen as lines. They occur next to frequencies at
/// which an amplitude vanishes.
#[must_use]
pub fn without_specks(mut panel: Panel) -> Panel {
    let least = SPECK * (panel.x.high - panel.x.low);
    let width = |piece: &[Point]| match (piece.first(), piece.last()) {
        (Some(first), Some(last)) => last.0 - first.0,
        _ => 0.0,
    };
    for layer in &mut panel.layers {
        if let Layer::Line(line) = layer {
            line.pieces.retain(|piece| least < width(piece));
        }
    }
    panel
}

/// Returns the panel with its phases folded into (−180, 180] degrees, the range of every table.
#[must_use]
pub fn one_turn(mut panel: Panel) -> Panel {
    for layer in &mut panel.layers {
        match layer {
            Layer::Line(line) => line.pieces = desk::folded(&line.pieces),
            Layer::Markers(markers) => {
                for point in &mut markers.points {
                    point.1 = desk::principal(point.1);
                }
            }
            _ => {}
        }
    }
    panel
}

#[cfg(test)]
mod tests {
    use super::{one_turn, tidy};
    use frictiongen_plot::{Axis, Colour, Layer, Line, Panel, Stroke};

    fn pieces(panel: &Panel, index: usize) -> Vec<Vec<(f64, f64)>> {
        match &panel.layers[index] {
            Layer::Line(line) => line.pieces.clone(),
            _ => Vec::new(),
        }
    }

    fn panel(lines: Vec<(Colour, Vec<(f64, f64)>)>, high: f64) -> Panel {
        let empty = Panel::new("", Axis::new("", 0.0, 1.0), Axis::new("", 0.0, high));
        let drawn = |(colour, piece)| Line::unnamed(colour, Stroke::Solid, vec![piece]);
        lines.into_iter().map(drawn).fold(empty, Panel::with)
    }

    #[test]
    fn straight_lines_need_two_points() {
        let straight = (0..=100).map(|i| f64::from(i) / 100.0).map(|x| (x, x));
        let bent = (0..=100)
            .map(|i| f64::from(i) / 100.0)
            .map(|x| (x, (x - 0.5).abs()));
        let lines = vec![
            (Colour::Black, straight.collect()),
            (Colour::Black, bent.collect()),
        ];
        let tidied = tidy(panel(lines, 1.0));
        assert_eq!(pieces(&tidied, 0), [[(0.0, 0.0), (1.0, 1.0)]]);
        assert_eq!(pieces(&tidied, 1)[0].len(), 3);
    }

    #[test]
    fn a_pole_ends_beyond_the_axis() {
        let pole = (1..=1000)
            .map(|i| f64::from(i) / 1000.0)
            .map(|x| (x, 1.0 / x));
        let tidied = tidy(panel(vec![(Colour::Black, pole.collect())], 4.0));
        let drawn = &pieces(&tidied, 0)[0];
        assert!(
            8.0 < drawn[0].1 && drawn[0].1 < 8.5 && drawn.len() < 400,
            "{}",
            drawn.len()
        );
    }

    #[test]
    fn phases_lie_on_one_turn() {
        let lines = vec![
            (Colour::Black, vec![(0.0, -10.0), (0.5, -20.0)]),
            (Colour::Series(0), vec![(0.0, 350.0), (0.5, 340.0)]),
        ];
        let moved = one_turn(panel(lines, 360.0));
        for index in [0, 1] {
            assert_eq!(pieces(&moved, index), [[(0.0, -10.0), (0.5, -20.0)]]);
        }
    }
}

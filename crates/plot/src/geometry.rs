//! Rectangles, and the clipping of lines and areas to rectangles.

/// A point with its coordinates x and y, in data units or in pixels on paper.
pub type Point = (f64, f64);

/// A rectangle on paper, with y growing downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Rect {
    pub(crate) fn right(&self) -> f64 {
        self.left + self.width
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.top + self.height
    }

    pub(crate) fn contains(&self, (x, y): Point) -> bool {
        self.left <= x && x <= self.right() && self.top <= y && y <= self.bottom()
    }

    /// Returns the start and the end of the piece of the segment from a to b that lies inside the rectangle, as
    /// fractions of the segment. Returns `None` if no piece lies inside.
    fn within(&self, a: Point, b: Point) -> Option<(f64, f64)> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (step, room) in [
            (-dx, a.0 - self.left),
            (dx, self.right() - a.0),
            (-dy, a.1 - self.top),
            (dy, self.bottom() - a.1),
        ] {
            if step == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if step < 0.0 {
                from = from.max(room / step);
            } else {
                to = to.min(room / step);
            }
        }
        (from <= to).then_some((from, to))
    }

    /// Returns the pieces of a polyline that lie inside the rectangle, each as a list of points.
    pub(crate) fn clip(&self, line: &[Point]) -> Vec<Vec<Point>> {
        let mut parts: Vec<Vec<Point>> = Vec::new();
        let mut part: Vec<Point> = Vec::new();
        for pair in line.windows(2) {
            let &[a, b] = pair else { continue };
            let Some((from, to)) = self.within(a, b) else {
                parts.push(std::mem::take(&mut part));
                continue;
            };
            let at = |share: f64| (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1));
            if part.is_empty() || 0.0 < from {
                parts.push(std::mem::take(&mut part));
                part.push(if 0.0 < from { at(from) } else { a });
            }
            part.push(if to < 1.0 { at(to) } else { b });
            if to < 1.0 {
                parts.push(std::mem::take(&mut part));
            }
        }
        parts.push(part);
        parts.retain(|part| 1 < part.len());
        parts
    }

    /// Returns the part of an area that lies inside the rectangle, as a polygon. `outline` is the polygon around the
    /// area.
    pub(crate) fn clip_area(&self, outline: &[Point]) -> Vec<Point> {
        let mut kept = outline.to_vec();
        let (left, right, top, bottom) = (self.left, self.right(), self.top, self.bottom());
        kept = cut(&kept, |p| p.0 - left);
        kept = cut(&kept, |p| right - p.0);
        kept = cut(&kept, |p| p.1 - top);
        cut(&kept, |p| bottom - p.1)
    }
}

/// Returns the part of an area in which the linear function `side` is not negative. The area and the result are
/// polygons.
fn cut(outline: &[Point], side: impl Fn(Point) -> f64) -> Vec<Point> {
    let mut kept = Vec::with_capacity(outline.len() + 4);
    let before = outline.iter().cycle().skip(outline.len().saturating_sub(1));
    for (a, b) in before.zip(outline) {
        let (from, to) = (side(*a), side(*b));
        if (from < 0.0) != (to < 0.0) {
            let share = from / (from - to);
            kept.push((a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1)));
        }
        if 0.0 <= to {
            kept.push(*b);
        }
    }
    kept
}

/// Removes points that do not change the shape of a polyline by more than `tolerance`. Each removed point is at most
/// this distance from the line through the remaining points. The method is that of Douglas and Peucker.
pub(crate) fn thin(line: &[Point], tolerance: f64) -> Vec<Point> {
    let mut keep = vec![false; line.len()];
    let mut open = vec![(0, line.len().saturating_sub(1))];
    while let Some((first, last)) = open.pop() {
        let (Some(a), Some(b)) = (line.get(first), line.get(last)) else {
            continue;
        };
        for end in [first, last] {
            if let Some(kept) = keep.get_mut(end) {
                *kept = true;
            }
        }
        let inner = line.iter().enumerate().take(last).skip(first + 1);
        let farthest = inner
            .map(|(index, point)| (index, distance(*point, *a, *b)))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((index, far)) = farthest
            && tolerance < far
        {
            open.push((first, index));
            open.push((index, last));
        }
    }
    line.iter()
        .zip(keep)
        .filter(|(_, kept)| *kept)
        .map(|(point, _)| *point)
        .collect()
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
    let (dx, dy) = (from.0 - share * along.0, from.1 - share * along.1);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{Rect, distance, thin};

    const UNIT: Rect = Rect {
        left: 0.0,
        top: 0.0,
        width: 10.0,
        height: 10.0,
    };

    #[test]
    fn clips_lines_where_they_cross() {
        assert_eq!(
            UNIT.clip(&[(-5.0, 5.0), (15.0, 5.0)]),
            [[(0.0, 5.0), (10.0, 5.0)]]
        );
        // This line starts inside the rectangle, leaves at y = 10, and returns. Two of its pieces are therefore inside.
        let parts = UNIT.clip(&[(1.0, 5.0), (2.0, 15.0), (8.0, 15.0), (9.0, 5.0)]);
        assert_eq!(
            parts,
            [[(1.0, 5.0), (1.5, 10.0)], [(8.5, 10.0), (9.0, 5.0)]]
        );
        assert!(UNIT.clip(&[(-5.0, 11.0), (15.0, 11.0)]).is_empty());
        assert!(UNIT.clip(&[(-5.0, 6.0), (6.0, 17.0)]).is_empty());
        // A line along the frame counts as inside.
        assert_eq!(UNIT.clip(&[(0.0, 10.0), (10.0, 10.0)]).len(), 1);
        // A line that stays inside has a single piece.
        let inside = [(1.0, 1.0), (2.0, 9.0), (3.0, 1.0)];
        assert_eq!(UNIT.clip(&inside), [inside]);
        assert!(UNIT.clip(&[(1.0, 1.0)]).is_empty() && UNIT.clip(&[]).is_empty());
        let steep = UNIT.clip(&[(5.0, 5.0), (5.0, 1e7)]);
        assert_eq!(steep, [[(5.0, 5.0), (5.0, 10.0)]]);
    }

    #[test]
    fn clips_areas() {
        let around = [(-5.0, -5.0), (15.0, -5.0), (15.0, 15.0), (-5.0, 15.0)];
        let mut corners = UNIT.clip_area(&around);
        corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(
            corners,
            [(0.0, 0.0), (0.0, 10.0), (10.0, 0.0), (10.0, 10.0)]
        );
        assert!(
            UNIT.clip_area(&[(11.0, 0.0), (12.0, 0.0), (12.0, 5.0)])
                .is_empty()
        );
        let inside = [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0)];
        assert_eq!(UNIT.clip_area(&inside), inside);
        assert!(UNIT.clip_area(&[]).is_empty());
    }

    #[test]
    fn thins_what_is_not_seen_and_nothing_else() {
        let line: Vec<(f64, f64)> = (0..=2000)
            .map(|i| f64::from(i) * 0.3)
            .map(|x| (x, 100.0 * (0.02 * x).sin()))
            .collect();
        let few = thin(&line, 0.02);
        assert!(few.len() < line.len() / 6, "{}", few.len());
        for point in &line {
            let near = few
                .windows(2)
                .map(|pair| distance(*point, pair[0], pair[1]));
            assert!(near.fold(f64::INFINITY, f64::min) <= 0.02);
        }
        // A spike (a line that runs back on itself) must keep its tip when it is thinned.
        let spike = [(0.0, 0.0), (10.0, 0.0), (5.0, 0.0), (20.0, 0.0)];
        assert_eq!(thin(&spike[..3], 0.02), spike[..3]);
        assert_eq!(
            thin(&[(0.0, 0.0), (5.0, 0.0), (10.0, 0.0)], 0.02),
            [(0.0, 0.0), (10.0, 0.0)]
        );
        assert_eq!(thin(&[(1.0, 1.0)], 0.02), [(1.0, 1.0)]);
        assert!(thin(&[], 0.02).is_empty());
    }
}

//! Draws maps of cells. Neighbouring cells of one colour become one rectangle, and all rectangles of a colour one
//! path.

use crate::axis::Mapping;
use crate::figure::Sample;
use crate::frame::Frame;
use crate::geometry::Rect;
use crate::layer::{Cells, Raster};
use crate::legend::Legend;
use crate::palette::Fill;
use crate::svg::Canvas;

/// Number of different colours in a map of values.
const SHADES: f64 = 96.0;

/// Draws a map of cells. Returns true if any cell is visible.
pub(crate) fn draw(
    canvas: &mut Canvas,
    raster: &Raster,
    frame: &Frame,
    legend: &mut Legend,
) -> bool {
    match &raster.cells {
        Cells::Classes { classes, cells } => {
            let mut any = false;
            for (index, (name, fill)) in classes.iter().enumerate() {
                let shown: Vec<bool> = cells.iter().map(|cell| *cell == Some(index)).collect();
                let runs = runs(raster, &shown, frame);
                if !runs.is_empty() {
                    any = true;
                    canvas.cells(&runs, fill.rgb());
                    legend.add(name, Sample::Fill(*fill));
                }
            }
            any
        }
        Cells::Values { bar, cells } => {
            let share = Mapping::new(bar, 0.0, 1.0);
            let shade = |value: &f64| {
                share
                    .at(*value)
                    .map(|share| (share.clamp(0.0, 1.0) * SHADES).round() as i32)
            };
            let shades: Vec<Option<i32>> = cells.iter().map(shade).collect();
            let mut any = false;
            for index in 0..=SHADES as i32 {
                let shown: Vec<bool> = shades.iter().map(|shade| *shade == Some(index)).collect();
                let runs = runs(raster, &shown, frame);
                any |= !runs.is_empty();
                canvas.cells(&runs, Fill::Map(f64::from(index) / SHADES).rgb());
            }
            any
        }
    }
}

/// Joins neighbouring cells that are marked in `shown` to rectangles, clipped to the frame.
fn runs(raster: &Raster, shown: &[bool], frame: &Frame) -> Vec<Rect> {
    let columns = raster.columns.max(1);
    let rows = shown.len() / columns;
    let ends = [
        frame.x.at(raster.x.0),
        frame.x.at(raster.x.1),
        frame.y.at(raster.y.0),
        frame.y.at(raster.y.1),
    ];
    let [Some(left), Some(right), Some(bottom), Some(top)] = ends else {
        return Vec::new();
    };
    let (outer, mut found) = (frame.rect, Vec::new());
    let x = |column: usize| {
        (left + (right - left) * column as f64 / columns as f64).clamp(outer.left, outer.right())
    };
    let y = |row: usize| {
        (bottom + (top - bottom) * row as f64 / rows as f64).clamp(outer.top, outer.bottom())
    };
    for (row, cells) in shown.chunks_exact(columns).enumerate() {
        let mut start = None;
        for (column, shown) in cells.iter().copied().chain([false]).enumerate() {
            match (start, shown) {
                (None, true) => start = Some(column),
                (Some(first), false) => {
                    let (a, b) = (x(first), x(column));
                    let (low, high) = (y(row), y(row + 1));
                    if a != b && low != high {
                        found.push(Rect {
                            left: a.min(b),
                            top: low.min(high),
                            width: (b - a).abs(),
                            height: (high - low).abs(),
                        });
                    }
                    start = None;
                }
                _ => {}
            }
        }
    }
    found
}

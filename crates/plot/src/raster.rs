//! Draws maps of cells. Neighbouring cells of the same colour become one rectangle, and all rectangles of a colour
//! become one path.

use crate::axis::Mapping;
use crate::figure::LegendSample;
use crate::frame::Frame;
use crate::geometry::Rect;
use crate::layer::{Cells, Raster};
use crate::legend::Legend;
use crate::palette::Fill;
use crate::svg::{Canvas, CellGrid};

/// Smallest fraction of a cell outside the frame for which the code cuts the cell. A smaller fraction is a rounding
/// error.
const CUT: f64 = 0.01;
/// Number of steps between the first and the last colour of a map of values. The map has one colour more than steps.
const SHADES: f64 = 96.0;

/// Draws a map of cells, and adds its visible classes to the legend. Returns true if any cell is visible.
pub(crate) fn draw(
    canvas: &mut Canvas,
    raster: &Raster,
    frame: &Frame,
    legend: &mut Legend,
) -> bool {
    let Some(grid) = grid(raster, frame) else {
        return false;
    };
    match &raster.cells {
        Cells::Classes { classes, cells } => {
            let mut any = false;
            for (index, (name, fill)) in classes.iter().enumerate() {
                let shown: Vec<bool> = cells.iter().map(|cell| *cell == Some(index)).collect();
                let runs = runs(raster, &shown, grid, frame);
                if !runs.is_empty() {
                    any = true;
                    canvas.cells(&runs, grid, fill.rgb());
                    legend.add(name, LegendSample::Fill(*fill));
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
                let runs = runs(raster, &shown, grid, frame);
                any |= !runs.is_empty();
                canvas.cells(&runs, grid, Fill::Map(f64::from(index) / SHADES).rgb());
            }
            any
        }
    }
}

/// Returns the position and size of a map's cells on the page. Returns `None` if an axis of the panel cannot show a
/// bound of the map.
fn grid(raster: &Raster, frame: &Frame) -> Option<CellGrid> {
    let (columns, rows) = (raster.columns.max(1), raster.rows());
    let (left, right) = (frame.x.at(raster.x.0)?, frame.x.at(raster.x.1)?);
    let (bottom, top) = (frame.y.at(raster.y.0)?, frame.y.at(raster.y.1)?);
    let cell = (
        (right - left) / columns as f64,
        (top - bottom) / rows.max(1) as f64,
    );
    (cell.0 != 0.0 && cell.1 != 0.0).then_some(CellGrid {
        origin: (left, bottom),
        cell,
    })
}

/// Joins neighbouring cells of a row for which `shown` is true, and returns the rectangles, in units of a cell. The
/// rectangles end at the frame of the panel.
fn runs(raster: &Raster, shown: &[bool], grid: CellGrid, frame: &Frame) -> Vec<Rect> {
    let columns = raster.columns.max(1);
    let (outer, mut found) = (frame.rect, Vec::new());
    let within = |index: usize, origin: f64, cell: f64, (low, high): (f64, f64)| {
        let (low, high) = ((low - origin) / cell, (high - origin) / cell);
        let (low, high) = (low.min(high), low.max(high));
        // Because of rounding, the frame may cut off a very small fraction of a cell. The rectangle then contains the
        // whole cell.
        let inside = (index as f64).clamp(low, high);
        if (inside - index as f64).abs() < CUT {
            index as f64
        } else {
            inside
        }
    };
    let x = |column| {
        within(
            column,
            grid.origin.0,
            grid.cell.0,
            (outer.left, outer.right()),
        )
    };
    let y = |row| within(row, grid.origin.1, grid.cell.1, (outer.top, outer.bottom()));
    for (row, cells) in shown.chunks_exact(columns).enumerate() {
        let mut start = None;
        for (column, shown) in cells.iter().copied().chain([false]).enumerate() {
            match (start, shown) {
                (None, true) => start = Some(column),
                (Some(first), false) => {
                    let (from, to) = (x(first), x(column));
                    let (low, high) = (y(row), y(row + 1));
                    if from < to && low < high {
                        found.push(Rect {
                            left: from,
                            top: low,
                            width: to - from,
                            height: high - low,
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

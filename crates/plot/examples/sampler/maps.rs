//! Draws figures of regions and maps.

use crate::{curve, damped};
use frictiongen_plot::{
    Anchor, Axis, Cells, Colour, Figure, Fill, Line, Marker, Markers, Note, Panel, Raster, Region,
    Stroke,
};

/// Names of the classes of a map.
const STOPS: [&str; 5] = ["no stop", "1 stop", "2 stops", "3 stops", "4 stops"];

/// Returns the figure of regions and maps.
pub fn maps() -> Figure {
    let x = || Axis::new("frequency ratio *r*", 0.0, 2.0);
    let lower = |r: f64| 0.8 * r * r / (0.3 + r * r);
    let upper = |r: f64| lower(r) + 0.25 + 0.3 * (-8.0 * (r - 1.0) * (r - 1.0)).exp();
    let places: Vec<f64> = curve(0.0, 2.0, 400, |r| r)
        .iter()
        .map(|point| point.0)
        .collect();
    let strip = |low: &dyn Fn(f64) -> f64, high: &dyn Fn(f64) -> f64| -> Vec<(f64, f64, f64)> {
        places.iter().map(|r| (*r, low(*r), high(*r))).collect()
    };
    let regions = Panel::new(
        "**(a)** regimes",
        x(),
        Axis::new("friction ratio *β*", 0.0, 1.5),
    )
    .with(
        Region::between("continuous", Fill::Class(0), &strip(&|_| 0.0, &lower))
            .named_at((1.3, 0.25)),
    )
    .with(
        Region::between("stick-slip", Fill::Class(1), &strip(&lower, &upper)).named_at((1.5, 0.8)),
    )
    .with(Region::between("stuck", Fill::Class(2), &strip(&upper, &|_| 1.6)).named_at((0.5, 1.2)))
    .with(Line::new(
        "*β*_lim",
        Colour::Black,
        Stroke::Solid,
        vec![curve(0.0, 2.0, 400, lower)],
    ))
    .with(Line::new(
        "*β*^*_lim",
        Colour::Black,
        Stroke::Dashed,
        vec![curve(0.0, 2.0, 400, upper)],
    ));
    let (columns, rows) = (120_usize, 90_usize);
    let cell = |index: usize| {
        let (column, row) = (index % columns, index / columns);
        (
            2.0 * (column as f64 + 0.5) / columns as f64,
            1.5 * (row as f64 + 0.5) / rows as f64,
        )
    };
    let stops = |index: usize| {
        let (r, beta) = cell(index);
        let count = (beta / (0.3 + 0.7 * r)) * 4.0;
        (beta < upper(r)).then_some((count as usize).min(4))
    };
    let classes = (0..5)
        .map(|i| {
            (
                STOPS.get(i).copied().unwrap_or_default().into(),
                Fill::Class(i),
            )
        })
        .collect();
    let cells = Cells::Classes {
        classes,
        cells: (0..columns * rows).map(stops).collect(),
    };
    let stopping = Panel::new(
        "**(b)** stops a cycle",
        x(),
        Axis::new("friction ratio *β*", 0.0, 1.5),
    )
    .with(Raster {
        x: (0.0, 2.0),
        y: (0.0, 1.5),
        columns,
        cells,
    })
    .with(Line::new(
        "*β*_lim",
        Colour::Black,
        Stroke::Solid,
        vec![curve(0.0, 2.0, 400, lower)],
    ));
    let value = |index: usize| {
        let (r, beta) = cell(index);
        damped(r, 0.05 + beta).0
    };
    let cells = Cells::Values {
        bar: Axis::log("*X̄*", 0.1, 10.0),
        cells: (0..columns * rows).map(value).collect(),
    };
    let heat = Panel::new(
        "**(c)** amplitude",
        x(),
        Axis::new("friction ratio *β*", 0.0, 1.5),
    )
    .with(Raster {
        x: (0.0, 2.0),
        y: (0.0, 1.5),
        columns,
        cells,
    });
    let decay = Panel::new(
        "**(d)** decay",
        Axis::log("*ζ*_1", 1e-4, 1.0),
        Axis::log("|*β* − *β*_lim|", 1e-9, 10.0),
    )
    .with(Line::new(
        "first order",
        Colour::Series(0),
        Stroke::Solid,
        vec![curve(1e-4, 1.0, 4000, |z| z)],
    ))
    .with(Line::new(
        "second order",
        Colour::Series(1),
        Stroke::Solid,
        vec![curve(1e-4, 1.0, 4000, |z| z * z)],
    ))
    .with(Markers::new(
        "measured",
        Colour::Series(3),
        Marker::Square,
        vec![(1e-3, 2e-3), (1e-2, 1e-2), (1e-1, 8e-2)],
    ))
    .with(Markers::new(
        "trials",
        Colour::Series(4),
        Marker::Cross,
        vec![(1e-3, 2e-6), (1e-2, 1e-4), (1e-1, 8e-3)],
    ))
    .with(Markers::new(
        "runs",
        Colour::Series(5),
        Marker::Triangle,
        vec![(2e-3, 2e-7), (2e-2, 2e-4)],
    ))
    .with(Markers::new(
        "points",
        Colour::Series(6),
        Marker::Dot,
        vec![(4e-3, 2e-7), (4e-2, 2e-4)],
    ))
    .with(Note::new("slope 1", (0.02, 0.2), Anchor::End));
    Figure::new(
        "3.12",
        "regimes and stops over frequency and friction",
        2,
        vec![regions, stopping, heat, decay],
    )
    .with_caption("Regions are named where they lie; 10^{−9} < |*β* − *β*_lim| ≤ 10.")
}

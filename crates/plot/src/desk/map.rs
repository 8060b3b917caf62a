//! Figures of maps over frequency and friction.

use super::regimes::limit_lines;
use super::scales::{Scales, short};
use crate::{Axis, Cells, Colour, Figure, Fill, Label, Line, Panel, Point, Raster, Stroke};
use frictiongen::study::map::{Boundary, LimitLines, Map, MapPoint, Pattern};
use frictiongen::{Error, Regime};

/// The quantity that the colours of a map show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// The regime of the contact.
    Regime,
    /// Number of stops of the contact in a period. In every map, equal numbers have the same colour.
    Stops,
    /// Fraction of the period during which the contact sticks.
    Stuck,
    /// Amplitude of a motion, by its index among the requested motions.
    Amplitude(usize),
}

/// Number of cells along an axis of a map, if the sampled values on this axis are not evenly spaced. If they are evenly
/// spaced, the axis has one cell for each value.
const CELLS: usize = 400;

/// Returns a figure of a map over frequency and friction. Lines over the map show the limits of [`LimitLines`] and
/// the traced boundaries between different stick-slip motions.
#[must_use]
pub fn map_figure(
    title: impl Into<Label>,
    map: &Map,
    lines: &LimitLines,
    boundaries: &[Boundary],
    shade: Shade,
    scales: &Scales,
) -> Figure {
    Figure::new(
        "",
        title,
        1,
        vec![map_panel("", map, lines, boundaries, shade, scales)],
    )
}

/// Returns a panel of a map over frequency and friction. Lines over the map show the limits of [`LimitLines`] and the
/// traced boundaries between different stick-slip motions.
#[must_use]
pub fn map_panel(
    title: impl Into<Label>,
    map: &Map,
    lines: &LimitLines,
    boundaries: &[Boundary],
    shade: Shade,
    scales: &Scales,
) -> Panel {
    let r: Vec<f64> = map.columns.iter().map(|column| column.r).collect();
    let (across, up) = (AxisCells::of(&r), AxisCells::of(&map.beta));
    let ends = |ends: (f64, f64), scale: &dyn Fn(f64) -> f64| (scale(ends.0), scale(ends.1));
    let x = ends(across.ends, &|r| scales.frequency(r));
    let y = ends(up.ends, &|beta| scales.friction(beta));
    let found = |row: &usize, column: &usize| map.columns.get(*column)?.points.get(*row);
    let places: Vec<Option<&Result<MapPoint, Error>>> = up
        .places
        .iter()
        .flat_map(|row| across.places.iter().map(move |column| found(row, column)))
        .collect();
    let cells = match shade {
        Shade::Regime => classes(&places),
        Shade::Stops => stops(&places),
        Shade::Stuck => Cells::Values {
            bar: Axis::new("stuck fraction of the period", 0.0, 1.0),
            cells: values(&places, |point| point.stuck_fraction),
        },
        Shade::Amplitude(part) => {
            let read = |point: &MapPoint| {
                point
                    .amplitudes
                    .get(part)
                    .map_or(f64::NAN, |size| scales.length(*size))
            };
            let cells = values(&places, read);
            let (end, most) = upper(&cells);
            let mut label = scales.length_text().to_owned();
            if end < most {
                label += &format!("; top colour ≥ {}, largest {}", short(end), short(most));
            }
            Cells::Values {
                bar: Axis::new(label, 0.0, end),
                cells,
            }
        }
    };
    let top = up.ends.1;
    let panel = Panel::new(
        title,
        Axis::new(scales.frequency_label(), x.0, x.1),
        Axis::new(scales.friction_label(), y.0, y.1),
    );
    let columns = across.places.len();
    let mut panel = panel.with(Raster {
        x,
        y,
        columns,
        cells,
    });
    let traced = trace(map, boundaries, scales);
    if !traced.is_empty() {
        panel = panel.with(Line::new(
            "boundaries traced",
            Colour::Grey,
            Stroke::Thin,
            traced,
        ));
    }
    let [continuous, sliding] = limit_lines(lines, top, scales, Colour::Black);
    panel.with(continuous).with(sliding)
}

/// The cells of a map along one axis. All cells have the same width, and each cell shows one sampled value.
pub(super) struct AxisCells {
    /// Lower and upper end of the range that the cells cover.
    pub ends: (f64, f64),
    /// For each cell, the index of the sampled value nearest to the middle of the cell.
    pub places: Vec<usize>,
}

impl AxisCells {
    pub fn of(values: &[f64]) -> Self {
        let (Some(first), Some(last)) = (values.first(), values.last()) else {
            return Self {
                ends: (0.0, 1.0),
                places: Vec::new(),
            };
        };
        let (low, high) = (first.min(*last), first.max(*last));
        let gaps = values.len().max(2) - 1;
        let step = (high - low) / gaps as f64;
        let even = values.windows(2).all(|pair| match pair {
            [a, b] => (b - a - step).abs() <= 1e-6 * step,
            _ => false,
        });
        if even {
            let half = 0.5 * step;
            // The first and the last value are in the middle of their cells. The cells therefore extend beyond these
            // values by half a cell, but not below 0.
            return Self {
                ends: ((low - half).max(0.0), high + half),
                places: (0..values.len()).collect(),
            };
        }
        let nearest = |at: f64| {
            let all = values.iter().enumerate();
            let best = all.min_by(|a, b| (a.1 - at).abs().total_cmp(&(b.1 - at).abs()));
            best.map_or(0, |(index, _)| index)
        };
        let middle = |i: usize| low + (high - low) * (i as f64 + 0.5) / CELLS as f64;
        Self {
            ends: (low, high),
            places: (0..CELLS).map(|i| nearest(middle(i))).collect(),
        }
    }
}

type SampledPlaces<'a> = [Option<&'a Result<MapPoint, Error>>];

fn values(places: &SampledPlaces<'_>, read: impl Fn(&MapPoint) -> f64) -> Vec<f64> {
    let value = |place: &Option<&Result<MapPoint, Error>>| match place {
        Some(Ok(point)) => read(point),
        _ => f64::NAN,
    };
    places.iter().map(value).collect()
}

/// Returns the upper end of a map's colour scale, and the largest value of its cells. The upper end is at most twice
/// the value that nine tenths of the cells do not exceed. Otherwise large values near a pole would give all other cells
/// the same colour.
pub(super) fn upper(cells: &[f64]) -> (f64, f64) {
    let mut finite: Vec<f64> = cells
        .iter()
        .copied()
        .filter(|value| value.is_finite())
        .collect();
    finite.sort_by(f64::total_cmp);
    let most = finite.last().copied().unwrap_or(1.0);
    let usual = finite.get(finite.len() * 9 / 10).copied().unwrap_or(1.0);
    // If nine tenths of the values are zero, the largest value is the end of the scale.
    let end = if 0.0 < usual {
        most.min(2.0 * usual)
    } else {
        most
    };
    (if 0.0 < end { end } else { 1.0 }, most)
}

fn classes(places: &SampledPlaces<'_>) -> Cells {
    let mut names: Vec<String> = ["continuous", "stick-slip: 2 stops", "stuck"]
        .map(str::to_owned)
        .into();
    let mut cells = Vec::with_capacity(places.len());
    for place in places {
        let Some(found) = place else {
            cells.push(None);
            continue;
        };
        let name = match found {
            Ok(point) => class(point.pattern),
            Err(_) => "no steady state".to_owned(),
        };
        let known = names.iter().position(|known| *known == name);
        cells.push(Some(known.unwrap_or_else(|| {
            names.push(name);
            names.len() - 1
        })));
    }
    let classes = names
        .into_iter()
        .enumerate()
        .map(|(index, name)| (Label::from(name), Fill::Class(index)));
    Cells::Classes {
        classes: classes.collect(),
        cells,
    }
}

/// Classes of a map that shows the number of stops in a period. Each class has its name and the index of its colour.
/// The classes for continuous motion, two stops and stuck have the same colours as in a map of regimes.
const STOPS: [(&str, usize); 8] = [
    ("continuous", 0),
    ("reversals only", 7),
    ("1 stop", 4),
    ("2 stops", 1),
    ("3 or 4 stops", 3),
    ("more stops", 6),
    ("longer period, or none", 5),
    ("stuck", 2),
];

fn stops(places: &SampledPlaces<'_>) -> Cells {
    let class = |pattern: Pattern| match (pattern.regime, pattern.period, pattern.stops) {
        (Regime::Continuous, ..) => 0,
        (Regime::Stuck, ..) => 7,
        (_, 1, 0) => 1,
        (_, 1, 1) => 2,
        (_, 1, 2) => 3,
        (_, 1, 3..=4) => 4,
        (_, 1, _) => 5,
        _ => 6,
    };
    let cells = places.iter().map(|place| match place {
        Some(Ok(point)) => Some(class(point.pattern)),
        _ => None,
    });
    Cells::Classes {
        classes: STOPS
            .map(|(name, index)| (Label::from(name), Fill::Class(index)))
            .to_vec(),
        cells: cells.collect(),
    }
}

/// Returns the legend name of the class to which a motion belongs. Motions with rare numbers of stops share a class.
fn class(pattern: Pattern) -> String {
    match (pattern.regime, pattern.period, pattern.stops) {
        (Regime::Continuous, ..) => "continuous".to_owned(),
        (Regime::Stuck, ..) => "stuck".to_owned(),
        (_, 0, _) => "stick-slip: unsettled".to_owned(),
        (_, 1, 0..=1) => "stick-slip: fewer stops".to_owned(),
        (_, 1, 2) => "stick-slip: 2 stops".to_owned(),
        (_, 1, 3..=4) => "stick-slip: 3 or 4 stops".to_owned(),
        (_, 1, _) => "stick-slip: more stops".to_owned(),
        _ => "stick-slip: subharmonic".to_owned(),
    }
}

/// Returns lines along the boundaries between different stick-slip motions in a map. A line joins boundaries in
/// neighbouring columns that separate the same two motions.
fn trace(map: &Map, boundaries: &[Boundary], scales: &Scales) -> Vec<Vec<Point>> {
    let inner = |of: &&Boundary| {
        let slips = |side: &Result<Pattern, Error>| {
            side.as_ref()
                .is_ok_and(|pattern| pattern.regime == Regime::StickSlip)
        };
        slips(&of.below) && slips(&of.above)
    };
    let mut open: Vec<(usize, Vec<&Boundary>)> = Vec::new();
    let mut done: Vec<Vec<&Boundary>> = Vec::new();
    let height = match (map.beta.first(), map.beta.last()) {
        (Some(first), Some(last)) => 0.05 * (last - first).abs(),
        _ => 0.0,
    };
    for (index, column) in map.columns.iter().enumerate() {
        for boundary in boundaries
            .iter()
            .filter(inner)
            .filter(|boundary| boundary.r == column.r)
        {
            // A boundary continues a line that ends in the previous column and separates the same two motions. The code
            // takes the nearest such line.
            let fits = |(at, line): &(usize, Vec<&Boundary>)| {
                let last = line.last()?;
                let same = last.below == boundary.below && last.above == boundary.above;
                let away = (last.beta - boundary.beta).abs();
                (at + 1 == index && same && away < height).then_some(away)
            };
            let nearest = open
                .iter()
                .enumerate()
                .filter_map(|(place, line)| Some((place, fits(line)?)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            match nearest.and_then(|(place, _)| open.get_mut(place)) {
                Some((at, line)) => {
                    *at = index;
                    line.push(boundary);
                }
                None => open.push((index, vec![boundary])),
            }
        }
        let (kept, ended): (Vec<_>, Vec<_>) = open.into_iter().partition(|(at, _)| *at == index);
        open = kept;
        done.extend(ended.into_iter().map(|(_, line)| line));
    }
    done.extend(open.into_iter().map(|(_, line)| line));
    let lines = done.into_iter().filter(|line| 1 < line.len());
    let place = |of: &&Boundary| (scales.frequency(of.r), scales.friction(of.beta));
    lines.map(|line| line.iter().map(place).collect()).collect()
}

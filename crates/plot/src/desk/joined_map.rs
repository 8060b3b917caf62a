//! Maps of scenes with several contacts over frequency and friction.

use super::map::{AxisCells, upper};
use super::scales::Scales;
use crate::{Axis, Cells, Colour, Figure, Fill, Label, Line, Panel, Point, Raster, Stroke};

/// If a map already has more classes than this number, all further sets of contacts that never slide share one class.
/// Otherwise each set has its own class and colour.
const CLASSES: usize = 6;

/// The class of one cell of a map. It says which contacts slide in the steady state at the cell's frequency and
/// friction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JoinedClasses {
    /// All contacts slide all the time.
    Slide,
    /// Some contacts stick during a fraction of the period, but every contact slides at some time.
    Stick,
    /// The named contacts never slide, and all other contacts slide.
    Held(String),
    /// No contact slides.
    Stuck,
    /// The motion from rest reaches no steady state.
    Unsettled,
}

/// The cells of a map over frequency and friction. The cells of the lowest friction come first. The cells of one
/// friction have the order of the frequencies.
#[derive(Clone, Debug)]
pub enum JoinedCells {
    /// The class of each cell.
    Regimes(Vec<JoinedClasses>),
    /// The value of each cell. The first field is the label of the colour bar.
    Values(Label, Vec<f64>),
}

impl JoinedClasses {
    fn name(&self) -> String {
        match self {
            Self::Slide => "all contacts slide".to_owned(),
            Self::Stick => "some contacts stick".to_owned(),
            Self::Held(names) => format!("never slides: {names}"),
            Self::Stuck => "all contacts are stuck".to_owned(),
            Self::Unsettled => "no steady state".to_owned(),
        }
    }
}

/// Returns a figure of a map over frequencies and frictions. All numbers are in the units of the axes. The points of
/// `limit` give, for each frequency, the friction above which no contact slides.
#[must_use]
pub fn joined_map_figure(
    title: impl Into<Label>,
    (frequencies, frictions): (&[f64], &[f64]),
    cells: &JoinedCells,
    limit: Vec<Point>,
    scales: &Scales,
) -> Figure {
    let (across, up) = (AxisCells::of(frequencies), AxisCells::of(frictions));
    let count = frequencies.len();
    let places = || {
        let rows = up.places.iter();
        rows.flat_map(|row| across.places.iter().map(move |column| row * count + column))
    };
    let cells = match cells {
        JoinedCells::Regimes(regimes) => classes(places().map(|place| regimes.get(place))),
        JoinedCells::Values(label, values) => {
            let cells: Vec<f64> = places()
                .map(|place| values.get(place).copied().unwrap_or(f64::NAN))
                .collect();
            let (end, _) = upper(&cells);
            Cells::Values {
                bar: Axis::new(label.clone(), 0.0, end),
                cells,
            }
        }
    };
    let (x, y) = (across.ends, up.ends);
    let panel = Panel::new(
        "",
        Axis::new(scales.frequency_label(), x.0, x.1),
        Axis::new(scales.friction_label(), y.0, y.1),
    );
    let columns = across.places.len();
    let raster = Raster {
        x,
        y,
        columns,
        cells,
    };
    let name = scales.limit_name("^*", "stuck state above");
    let line = Line::new(name, Colour::Black, Stroke::Dashed, vec![limit]);
    Figure::new("", title, 1, vec![panel.with(raster).with(line)])
}

/// Returns the cells of a map with a colour for each class. A cell that is `None` stays empty.
fn classes<'c>(cells: impl Iterator<Item = Option<&'c JoinedClasses>>) -> Cells {
    let first = [
        JoinedClasses::Slide,
        JoinedClasses::Stick,
        JoinedClasses::Stuck,
    ];
    let mut known: Vec<String> = first.iter().map(JoinedClasses::name).collect();
    let mut places = Vec::new();
    for cell in cells {
        places.push(cell.map(|cell| {
            let mut name = cell.name();
            let is_new = !known.contains(&name);
            if is_new && CLASSES < known.len() && matches!(cell, JoinedClasses::Held(_)) {
                name = "other contacts never slide".to_owned();
            }
            let found = known.iter().position(|known| *known == name);
            found.unwrap_or_else(|| {
                known.push(name);
                known.len() - 1
            })
        }));
    }
    let classes = known
        .into_iter()
        .enumerate()
        .map(|(index, name)| (Label::verbatim(&name), Fill::Class(index)));
    Cells::Classes {
        classes: classes.collect(),
        cells: places,
    }
}

//! Layers of a panel.

use crate::axis::Axis;
use crate::geometry::Point;
use crate::label::Label;
use crate::palette::{Colour, Fill};
use crate::stroke::{Marker, Stroke};

/// One layer of a panel.
#[derive(Clone, Debug, PartialEq)]
pub enum Layer {
    /// A curve.
    Line(Line),
    /// Separate points.
    Markers(Markers),
    /// A shaded area.
    Region(Region),
    /// A map of cells.
    Raster(Raster),
    /// A text.
    Note(Note),
    /// A straight line across the panel.
    Guide(Guide),
}

/// A curve in pieces, which are never joined. A value that is not finite ends a piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name in the legend.
    pub name: Option<Label>,
    /// Colour of the curve.
    pub colour: Colour,
    /// Stroke of the curve.
    pub stroke: Stroke,
    /// Pieces of the curve.
    pub pieces: Vec<Vec<Point>>,
}

impl Line {
    /// Makes a curve that the legend names.
    #[must_use]
    pub fn new(
        name: impl Into<Label>,
        colour: Colour,
        stroke: Stroke,
        pieces: Vec<Vec<Point>>,
    ) -> Self {
        let name = Some(name.into());
        Self {
            name,
            colour,
            stroke,
            pieces,
        }
    }

    /// Makes a curve that the legend leaves out.
    #[must_use]
    pub const fn unnamed(colour: Colour, stroke: Stroke, pieces: Vec<Vec<Point>>) -> Self {
        Self {
            name: None,
            colour,
            stroke,
            pieces,
        }
    }
}

/// Separate points.
#[derive(Clone, Debug, PartialEq)]
pub struct Markers {
    /// Name in the legend.
    pub name: Option<Label>,
    /// Colour of the markers.
    pub colour: Colour,
    /// Shape of the markers.
    pub marker: Marker,
    /// Positions of the markers.
    pub points: Vec<Point>,
}

impl Markers {
    /// Makes points that the legend names.
    #[must_use]
    pub fn new(name: impl Into<Label>, colour: Colour, marker: Marker, points: Vec<Point>) -> Self {
        let name = Some(name.into());
        Self {
            name,
            colour,
            marker,
            points,
        }
    }

    /// Makes points that the legend leaves out.
    #[must_use]
    pub const fn unnamed(colour: Colour, marker: Marker, points: Vec<Point>) -> Self {
        Self {
            name: None,
            colour,
            marker,
            points,
        }
    }
}

/// A shaded area, named inside the panel or in the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Name of the area.
    pub name: Label,
    /// Position of the name; `None` puts it in the legend.
    pub at: Option<Point>,
    /// Colour of the area.
    pub fill: Fill,
    /// Outlines of the area. Where two overlap there is a hole.
    pub outlines: Vec<Vec<Point>>,
}

impl Region {
    /// Makes an area that the legend names.
    #[must_use]
    pub fn new(name: impl Into<Label>, fill: Fill, outlines: Vec<Vec<Point>>) -> Self {
        Self {
            name: name.into(),
            at: None,
            fill,
            outlines,
        }
    }

    /// Makes the area between two curves from points (x, lower, upper).
    #[must_use]
    pub fn between(name: impl Into<Label>, fill: Fill, places: &[(f64, f64, f64)]) -> Self {
        let finite = |place: &&(f64, f64, f64)| {
            [place.0, place.1, place.2]
                .iter()
                .all(|value| value.is_finite())
        };
        let lower = places.iter().filter(finite).map(|place| (place.0, place.1));
        let upper = places
            .iter()
            .filter(finite)
            .rev()
            .map(|place| (place.0, place.2));
        Self::new(name, fill, vec![lower.chain(upper).collect()])
    }

    /// Returns the area with its name at a position inside the panel.
    #[must_use]
    pub const fn named_at(mut self, at: Point) -> Self {
        self.at = Some(at);
        self
    }
}

/// Cells over a rectangle, all of one size on paper. Rows go from low to high y, and cells of a row from low to high x.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Range of x.
    pub x: (f64, f64),
    /// Range of y.
    pub y: (f64, f64),
    /// Number of cells in a row.
    pub columns: usize,
    /// Contents of the cells.
    pub cells: Cells,
}

impl Raster {
    /// Returns the number of rows.
    pub(crate) fn rows(&self) -> usize {
        let cells = match &self.cells {
            Cells::Classes { cells, .. } => cells.len(),
            Cells::Values { cells, .. } => cells.len(),
        };
        cells / self.columns.max(1)
    }
}

/// Contents of the cells of a map.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// A class in each cell, or none.
    Classes {
        /// The classes with their names in the legend.
        classes: Vec<(Label, Fill)>,
        /// Index of each cell's class.
        cells: Vec<Option<usize>>,
    },
    /// A value in each cell. A cell without a finite value stays empty.
    Values {
        /// The axis of the colour bar.
        bar: Axis,
        /// The values.
        cells: Vec<f64>,
    },
}

/// Alignment of a text relative to its position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Anchor {
    /// The text begins at the position.
    #[default]
    Start,
    /// The text is centred at the position.
    Middle,
    /// The text ends at the position.
    End,
}

/// A text in a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// Position of the text.
    pub at: Point,
    /// The text.
    pub text: Label,
    /// Alignment relative to the position.
    pub anchor: Anchor,
    /// Colour of the text.
    pub colour: Colour,
}

impl Note {
    /// Makes a black text.
    #[must_use]
    pub fn new(text: impl Into<Label>, at: Point, anchor: Anchor) -> Self {
        Self {
            at,
            text: text.into(),
            anchor,
            colour: Colour::Black,
        }
    }
}

/// Position of a straight line across a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Across {
    /// A vertical line at this x.
    X(f64),
    /// A horizontal line at this y.
    Y(f64),
}

/// A straight line across a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// Name in the legend.
    pub name: Option<Label>,
    /// Position of the line.
    pub across: Across,
    /// Colour of the line.
    pub colour: Colour,
    /// Stroke of the line.
    pub stroke: Stroke,
}

impl Guide {
    /// Makes a thin grey line that the legend leaves out.
    #[must_use]
    pub const fn new(across: Across) -> Self {
        Self {
            name: None,
            across,
            colour: Colour::Grey,
            stroke: Stroke::Thin,
        }
    }
}

macro_rules! layer_from {
    ($($kind:ident),*) => {
        $(impl From<$kind> for Layer {
            fn from(kind: $kind) -> Self {
                Self::$kind(kind)
            }
        })*
    };
}
layer_from!(Line, Markers, Region, Raster, Note, Guide);

//! Layers of a panel: curves, markers, areas, maps, texts and straight lines.

use crate::axis::Axis;
use crate::geometry::Point;
use crate::label::Label;
use crate::palette::{Colour, Fill};
use crate::stroke::{Marker, Stroke};

/// One layer of a panel, drawn over the layers before it.
#[derive(Clone, Debug, PartialEq)]
pub enum Layer {
    /// A curve, drawn as a line.
    Line(Line),
    /// Separate points, drawn as markers.
    Markers(Markers),
    /// A shaded area.
    Region(Region),
    /// A map of coloured cells.
    Raster(Raster),
    /// A text inside the panel.
    Note(Note),
    /// A straight line across the panel.
    Guide(Guide),
}

/// A curve of one or more pieces. No line connects two pieces. A value that is not finite ends a piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name of the curve in the legend. With `None` the legend omits the curve.
    pub name: Option<Label>,
    /// Colour of the curve.
    pub colour: Colour,
    /// Stroke of the curve, such as solid or dashed.
    pub stroke: Stroke,
    /// Pieces of the curve, each a list of points.
    pub pieces: Vec<Vec<Point>>,
}

impl Line {
    /// Creates a curve with a name in the legend.
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

    /// Creates a curve without an entry in the legend.
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

/// Separate points, drawn as markers of one shape and colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Markers {
    /// Name of the points in the legend. With `None` the legend omits the points.
    pub name: Option<Label>,
    /// Colour of the markers.
    pub colour: Colour,
    /// Shape of the markers.
    pub marker: Marker,
    /// Positions of the markers, in data units.
    pub points: Vec<Point>,
}

impl Markers {
    /// Creates points with a name in the legend.
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

    /// Creates points without an entry in the legend.
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

/// A shaded area with a name, inside the panel or in the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Name of the area.
    pub name: Label,
    /// Position of the name inside the panel, in data units. With `None` the name is in the legend.
    pub at: Option<Point>,
    /// Colour of the area.
    pub fill: Fill,
    /// Outlines of the area. The overlap of two outlines is a hole.
    pub outlines: Vec<Vec<Point>>,
}

impl Region {
    /// Creates an area with a name in the legend.
    #[must_use]
    pub fn new(name: impl Into<Label>, fill: Fill, outlines: Vec<Vec<Point>>) -> Self {
        Self {
            name: name.into(),
            at: None,
            fill,
            outlines,
        }
    }

    /// Creates the area between two curves. Each item of `places` gives x, the lower y and the upper y.
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

    /// Returns this area with its name at a position inside the panel.
    #[must_use]
    pub const fn named_at(mut self, at: Point) -> Self {
        self.at = Some(at);
        self
    }
}

/// A map of rectangular cells, which have equal size on paper. The rows begin at the lowest y, and the cells of a row
/// at the lowest x.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Range of x that the cells cover.
    pub x: (f64, f64),
    /// Range of y that the cells cover.
    pub y: (f64, f64),
    /// Number of cells in a row.
    pub columns: usize,
    /// Contents of the cells: classes or values.
    pub cells: Cells,
}

impl Raster {
    /// Returns the number of rows of cells.
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
    /// Each cell belongs to a class. A cell without a class stays empty.
    Classes {
        /// Each class: its name in the legend, and its colour.
        classes: Vec<(Label, Fill)>,
        /// Index of each cell's class in `classes`. `None` for an empty cell.
        cells: Vec<Option<usize>>,
    },
    /// Each cell has a value. A cell without a finite value stays empty.
    Values {
        /// The axis of the colour bar, which shows the values of the colours.
        bar: Axis,
        /// The value of each cell.
        cells: Vec<f64>,
    },
}

/// Horizontal alignment of a text relative to its position.
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

/// A text inside a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// Position of the text in data units.
    pub at: Point,
    /// The text.
    pub text: Label,
    /// The point of the text that is at the position `at`: its start, middle or end.
    pub anchor: Anchor,
    /// Colour of the text.
    pub colour: Colour,
}

impl Note {
    /// Creates a black text at a position.
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

/// Direction and position of a straight line across a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Across {
    /// A vertical line at this value of x.
    X(f64),
    /// A horizontal line at this value of y.
    Y(f64),
}

/// A straight line across a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// Name of the line in the legend. With `None` the legend omits the line.
    pub name: Option<Label>,
    /// Direction and position of the line.
    pub across: Across,
    /// Colour of the line.
    pub colour: Colour,
    /// Stroke of the line.
    pub stroke: Stroke,
}

impl Guide {
    /// Creates a thin grey line without an entry in the legend.
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

//! What is drawn in a panel.

use crate::axis::Axis;
use crate::geometry::Point;
use crate::label::Label;
use crate::palette::{Colour, Fill};
use crate::stroke::{Marker, Stroke};

/// One thing in a panel.
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
    /// Words.
    Note(Note),
    /// A straight line across the panel.
    Guide(Guide),
}

/// A curve in pieces, which are never joined.  A value that is not finite ends a piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its name in the legend.
    pub name: Option<Label>,
    /// Its colour.
    pub colour: Colour,
    /// How it is dashed.
    pub stroke: Stroke,
    /// Its pieces.
    pub pieces: Vec<Vec<Point>>,
}

impl Line {
    /// A curve that the legend names.
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

    /// A curve that the legend leaves out.
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
    /// Their name in the legend.
    pub name: Option<Label>,
    /// Their colour.
    pub colour: Colour,
    /// Their shape.
    pub marker: Marker,
    /// Where they are.
    pub points: Vec<Point>,
}

impl Markers {
    /// Points that the legend names.
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

    /// Points that the legend leaves out.
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

/// A shaded area, named where it lies or in the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Its name.
    pub name: Label,
    /// Where the name stands; in the legend if nowhere.
    pub at: Option<Point>,
    /// Its colour.
    pub fill: Fill,
    /// Its outlines; where two overlap there is a hole.
    pub outlines: Vec<Vec<Point>>,
}

impl Region {
    /// An area that the legend names.
    #[must_use]
    pub fn new(name: impl Into<Label>, fill: Fill, outlines: Vec<Vec<Point>>) -> Self {
        Self {
            name: name.into(),
            at: None,
            fill,
            outlines,
        }
    }

    /// The area between two curves over the same places: (x, lower, upper).
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

    /// With its name where it lies.
    #[must_use]
    pub const fn named_at(mut self, at: Point) -> Self {
        self.at = Some(at);
        self
    }
}

/// Cells over a rectangle, all of one size on paper: row after row from low y, each from low x.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// From where to where it reaches in x.
    pub x: (f64, f64),
    /// From where to where it reaches in y.
    pub y: (f64, f64),
    /// How many cells a row has.
    pub columns: usize,
    /// What the cells hold.
    pub cells: Cells,
}

/// What the cells of a map hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// A class each, or nothing.
    Classes {
        /// The classes, as the legend names them.
        classes: Vec<(Label, Fill)>,
        /// Which class each cell is of.
        cells: Vec<Option<usize>>,
    },
    /// A value each; a cell without a finite value stays empty.
    Values {
        /// The axis of the colour bar.
        bar: Axis,
        /// The values.
        cells: Vec<f64>,
    },
}

/// On which side of its place a text stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Anchor {
    /// The text begins there.
    #[default]
    Start,
    /// The text is centred there.
    Middle,
    /// The text ends there.
    End,
}

/// Words in a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// Where they stand.
    pub at: Point,
    /// What they say.
    pub text: Label,
    /// On which side of their place.
    pub anchor: Anchor,
    /// Their colour.
    pub colour: Colour,
}

impl Note {
    /// Black words.
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

/// Where a straight line crosses a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Across {
    /// Upright, at an x.
    X(f64),
    /// Level, at a y.
    Y(f64),
}

/// A straight line across a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// Its name in the legend.
    pub name: Option<Label>,
    /// Where it is.
    pub across: Across,
    /// Its colour.
    pub colour: Colour,
    /// How it is dashed.
    pub stroke: Stroke,
}

impl Guide {
    /// A thin grey line that the legend leaves out.
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

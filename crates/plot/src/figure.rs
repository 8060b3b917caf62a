//! Figures and their panels.

use crate::axis::Axis;
use crate::label::Label;
use crate::layer::Layer;
use crate::palette::{Colour, Fill};
use crate::sketch::Sketch;
use crate::stroke::{Marker, Stroke};

/// The width of the page that a figure fills.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Page {
    /// A wide page: 900 pixels for two columns, 640 pixels for one.
    #[default]
    Wide,
    /// A narrow page of 400 pixels with one column, for a telephone.
    Narrow,
}

/// A picture with a title, panels in rows, a legend, a caption, and a sketch of the system.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Number of the figure, such as 3.14. It may be empty.
    pub number: String,
    /// Title of the figure.
    pub title: Label,
    /// Caption, for example with the parameters.
    pub caption: Label,
    /// Number of panels in a row of the figure: one or two.
    pub columns: usize,
    /// The panels of the figure, row after row.
    pub panels: Vec<Panel>,
    /// Sketch of the mechanical system. `None` for a figure without a sketch.
    pub sketch: Option<Sketch>,
    /// Additional legend entries, which belong to no layer of a panel. They explain, for example, the strokes.
    pub keys: Vec<Key>,
    /// Width of the page that the figure fills.
    pub page: Page,
}

impl Figure {
    /// Creates a figure for a wide page, without caption, sketch and additional legend entries.
    #[must_use]
    pub fn new(number: &str, title: impl Into<Label>, columns: usize, panels: Vec<Panel>) -> Self {
        Self {
            number: number.to_owned(),
            title: title.into(),
            columns,
            panels,
            ..Self::default()
        }
    }

    /// Returns this figure with a caption.
    #[must_use]
    pub fn with_caption(mut self, caption: impl Into<Label>) -> Self {
        self.caption = caption.into();
        self
    }

    /// Returns this figure with a sketch of the system.
    #[must_use]
    pub fn with_sketch(mut self, sketch: Sketch) -> Self {
        self.sketch = Some(sketch);
        self
    }

    /// Returns this figure with additional entries in the legend.
    #[must_use]
    pub fn with_keys(mut self, keys: impl IntoIterator<Item = Key>) -> Self {
        self.keys.extend(keys);
        self
    }

    /// Returns this figure for a narrow page, in one column.
    #[must_use]
    pub fn narrow(mut self) -> Self {
        self.page = Page::Narrow;
        self
    }
}

/// Position of a panel's frame in a picture, and the values at its sides. Positions are in the units of the SVG's
/// `viewBox`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelFrame {
    /// Horizontal position of the left edge of the frame.
    pub left: f64,
    /// Vertical position of the upper edge of the frame, counted downwards.
    pub top: f64,
    /// Width of the panel's frame.
    pub width: f64,
    /// Height of the panel's frame.
    pub height: f64,
    /// Values of the horizontal axis at the left and right edges of the frame. [`Axis::scale`] of this axis gives the
    /// scale between the two values.
    pub x: (f64, f64),
    /// Values of the vertical axis at the lower and upper edges of the frame.
    pub y: (f64, f64),
}

/// A pair of axes, and the layers that the figure draws in these axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Title above the panel.
    pub title: Label,
    /// Horizontal axis of the panel.
    pub x: Axis,
    /// Vertical axis of the panel.
    pub y: Axis,
    /// Layers of the panel, from the bottom to the top. The grid is drawn above regions and maps, and under all other
    /// layers.
    pub layers: Vec<Layer>,
    /// Smaller panels inside this panel.
    pub insets: Vec<Inset>,
    /// Height of the panel's frame in pixels. `None` gives the usual height. All panels of a row get the height of the
    /// highest panel in the row.
    pub height: Option<f64>,
}

impl Panel {
    /// Creates an empty panel from its title and its axes.
    #[must_use]
    pub fn new(title: impl Into<Label>, x: Axis, y: Axis) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            layers: Vec::new(),
            insets: Vec::new(),
            height: None,
        }
    }

    /// Returns this panel with another layer on top.
    #[must_use]
    pub fn with(mut self, layer: impl Into<Layer>) -> Self {
        self.layers.push(layer.into());
        self
    }

    /// Returns this panel with a smaller panel inside.
    #[must_use]
    pub fn with_inset(mut self, inset: Inset) -> Self {
        self.insets.push(inset);
        self
    }
}

/// A smaller panel inside another panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Inset {
    /// Left edge, upper edge, width and height of the inset's frame, as fractions of the outer panel's frame.
    pub place: (f64, f64, f64, f64),
    /// True if a rectangle in the outer panel marks the area that the inset shows.
    pub marked: bool,
    /// The panel that is drawn inside the outer panel.
    pub panel: Panel,
}

/// A legend entry that belongs to no layer of a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// Text of the entry.
    pub name: Label,
    /// Sample that is drawn before the text.
    pub sample: LegendSample,
}

/// The sample in a legend entry, which precedes the text of the entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LegendSample {
    /// A short line, drawn in this colour and stroke.
    Line(Colour, Stroke),
    /// A marker of this colour and shape.
    Marker(Colour, Marker),
    /// A patch, filled with this colour.
    Fill(Fill),
}

impl Key {
    /// Creates a legend entry that explains a stroke, such as dashed. The sample is black.
    #[must_use]
    pub fn stroke(name: impl Into<Label>, stroke: Stroke) -> Self {
        let sample = LegendSample::Line(Colour::Black, stroke);
        Self {
            name: name.into(),
            sample,
        }
    }

    /// Creates a legend entry that explains the shape of a marker. The sample is black.
    #[must_use]
    pub fn marker(name: impl Into<Label>, marker: Marker) -> Self {
        let sample = LegendSample::Marker(Colour::Black, marker);
        Self {
            name: name.into(),
            sample,
        }
    }

    /// Creates a legend entry that explains the colour of an area.
    #[must_use]
    pub fn fill(name: impl Into<Label>, fill: Fill) -> Self {
        let sample = LegendSample::Fill(fill);
        Self {
            name: name.into(),
            sample,
        }
    }
}

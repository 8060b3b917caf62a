//! Figures and their panels.

use crate::axis::Axis;
use crate::label::Label;
use crate::layer::Layer;
use crate::palette::{Colour, Fill};
use crate::sketch::Sketch;
use crate::stroke::{Marker, Stroke};

/// The width for which a figure is laid out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Page {
    /// 900 pixels for two columns, 640 for one.
    #[default]
    Wide,
    /// 400 pixels and one column, for a telephone.
    Narrow,
}

/// A picture: panels in rows, a legend, a sketch of the system.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Number of the figure, such as 3.14; may be empty.
    pub number: String,
    /// Title of the figure.
    pub title: Label,
    /// Caption, for example with the parameters.
    pub caption: Label,
    /// Number of panels in a row: one or two.
    pub columns: usize,
    /// The panels, row after row.
    pub panels: Vec<Panel>,
    /// Sketch of the system.
    pub sketch: Option<Sketch>,
    /// Legend entries that no layer has, such as the meaning of strokes.
    pub keys: Vec<Key>,
    /// The width for which the figure is laid out.
    pub page: Page,
}

impl Figure {
    /// Makes a figure without caption, sketch and keys.
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

    /// Returns the figure with a caption.
    #[must_use]
    pub fn with_caption(mut self, caption: impl Into<Label>) -> Self {
        self.caption = caption.into();
        self
    }

    /// Returns the figure with a sketch of the system.
    #[must_use]
    pub fn with_sketch(mut self, sketch: Sketch) -> Self {
        self.sketch = Some(sketch);
        self
    }

    /// Returns the figure with more entries in the legend.
    #[must_use]
    pub fn with_keys(mut self, keys: impl IntoIterator<Item = Key>) -> Self {
        self.keys.extend(keys);
        self
    }

    /// Returns the figure in one narrow column, for a telephone.
    #[must_use]
    pub fn narrow(mut self) -> Self {
        self.page = Page::Narrow;
        self
    }
}

/// Position of a panel's frame in a picture, in the units of its `viewBox`, and the values at its sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelFrame {
    /// Left edge of the frame.
    pub left: f64,
    /// Upper edge of the frame.
    pub top: f64,
    /// Width of the frame.
    pub width: f64,
    /// Height of the frame.
    pub height: f64,
    /// Values at the left and right edges. [`Axis::scale`] gives the spacing between them.
    pub x: (f64, f64),
    /// Values at the lower and upper edges.
    pub y: (f64, f64),
}

/// A pair of axes with the layers that are drawn over them.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Title above the panel.
    pub title: Label,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Layers, the first at the bottom. Regions and maps are under the grid.
    pub layers: Vec<Layer>,
    /// Smaller panels inside this one.
    pub insets: Vec<Inset>,
    /// Height of the frame in pixels. A row is as high as its highest panel.
    pub height: Option<f64>,
}

impl Panel {
    /// Makes an empty panel.
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

    /// Returns the panel with a layer on top.
    #[must_use]
    pub fn with(mut self, layer: impl Into<Layer>) -> Self {
        self.layers.push(layer.into());
        self
    }

    /// Returns the panel with a smaller panel inside.
    #[must_use]
    pub fn with_inset(mut self, inset: Inset) -> Self {
        self.insets.push(inset);
        self
    }
}

/// A smaller panel inside another.
#[derive(Clone, Debug, PartialEq)]
pub struct Inset {
    /// Left edge, upper edge, width and height of the inset's frame, as fractions of the outer frame.
    pub place: (f64, f64, f64, f64),
    /// True if the outer panel marks the area that the inset shows.
    pub marked: bool,
    /// Contents of the inset.
    pub panel: Panel,
}

/// A legend entry that no layer has.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// Text of the entry.
    pub name: Label,
    /// Sample before the text.
    pub sample: Sample,
}

/// The sample before a legend entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sample {
    /// A short line.
    Line(Colour, Stroke),
    /// A marker.
    Marker(Colour, Marker),
    /// A filled patch.
    Fill(Fill),
}

impl Key {
    /// Makes an entry for the meaning of a stroke, whatever its colour.
    #[must_use]
    pub fn stroke(name: impl Into<Label>, stroke: Stroke) -> Self {
        let sample = Sample::Line(Colour::Black, stroke);
        Self {
            name: name.into(),
            sample,
        }
    }

    /// Makes an entry for the meaning of a marker, whatever its colour.
    #[must_use]
    pub fn marker(name: impl Into<Label>, marker: Marker) -> Self {
        let sample = Sample::Marker(Colour::Black, marker);
        Self {
            name: name.into(),
            sample,
        }
    }

    /// Makes an entry for the meaning of a filled patch.
    #[must_use]
    pub fn fill(name: impl Into<Label>, fill: Fill) -> Self {
        let sample = Sample::Fill(fill);
        Self {
            name: name.into(),
            sample,
        }
    }
}

//! Figures and their panels.

use crate::axis::Axis;
use crate::label::Label;
use crate::layer::Layer;
use crate::palette::{Colour, Fill};
use crate::sketch::Sketch;
use crate::stroke::{Marker, Stroke};

/// For what width a figure is laid out.
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
    /// Its number, such as 3.14; may be empty.
    pub number: String,
    /// What it shows.
    pub title: Label,
    /// What a reader has to know, such as parameters.
    pub caption: Label,
    /// How many panels stand side by side: one or two.
    pub columns: usize,
    /// The panels, row after row.
    pub panels: Vec<Panel>,
    /// The system.
    pub sketch: Option<Sketch>,
    /// Entries of the legend beyond the names of layers, such as what strokes mean.
    pub keys: Vec<Key>,
    /// For what width it is laid out.
    pub page: Page,
}

impl Figure {
    /// A figure without caption, sketch and keys.
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

    /// With a caption.
    #[must_use]
    pub fn with_caption(mut self, caption: impl Into<Label>) -> Self {
        self.caption = caption.into();
        self
    }

    /// With a sketch of the system.
    #[must_use]
    pub fn with_sketch(mut self, sketch: Sketch) -> Self {
        self.sketch = Some(sketch);
        self
    }

    /// With more entries in the legend.
    #[must_use]
    pub fn with_keys(mut self, keys: impl IntoIterator<Item = Key>) -> Self {
        self.keys.extend(keys);
        self
    }

    /// The same in one narrow column, for a telephone.
    #[must_use]
    pub fn narrow(mut self) -> Self {
        self.page = Page::Narrow;
        self
    }
}

/// Where the frame of a panel is in a picture, in the units of its `viewBox`, and what its sides stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelFrame {
    /// Its left edge.
    pub left: f64,
    /// Its upper edge.
    pub top: f64,
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
    /// The values at its left and right edges, between which [`Axis::scale`] spreads the others.
    pub x: (f64, f64),
    /// The values at its lower and upper edges.
    pub y: (f64, f64),
}

/// A pair of axes with what is drawn over them.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What stands over it.
    pub title: Label,
    /// The axis to the right.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
    /// What is drawn, the first at the bottom.  Regions and maps lie under the grid.
    pub layers: Vec<Layer>,
    /// Smaller panels within.
    pub insets: Vec<Inset>,
    /// The height of its frame, in pixels; a row is as high as its highest panel.
    pub height: Option<f64>,
}

impl Panel {
    /// An empty panel.
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

    /// With a layer on top.
    #[must_use]
    pub fn with(mut self, layer: impl Into<Layer>) -> Self {
        self.layers.push(layer.into());
        self
    }

    /// With a smaller panel within.
    #[must_use]
    pub fn with_inset(mut self, inset: Inset) -> Self {
        self.insets.push(inset);
        self
    }
}

/// A smaller panel within another.
#[derive(Clone, Debug, PartialEq)]
pub struct Inset {
    /// Its frame's left and upper edge, its width and its height, as shares of the outer frame.
    pub place: (f64, f64, f64, f64),
    /// Whether the outer panel shows what part of it is seen within.
    pub marked: bool,
    /// What it shows.
    pub panel: Panel,
}

/// An entry of the legend that no layer gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// What it says.
    pub name: Label,
    /// What stands before it.
    pub sample: Sample,
}

/// What stands before an entry of the legend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sample {
    /// A piece of a line.
    Line(Colour, Stroke),
    /// A marker.
    Marker(Colour, Marker),
    /// A patch.
    Fill(Fill),
}

impl Key {
    /// What a stroke means, whatever its colour.
    #[must_use]
    pub fn stroke(name: impl Into<Label>, stroke: Stroke) -> Self {
        let sample = Sample::Line(Colour::Black, stroke);
        Self {
            name: name.into(),
            sample,
        }
    }

    /// What a marker means, whatever its colour.
    #[must_use]
    pub fn marker(name: impl Into<Label>, marker: Marker) -> Self {
        let sample = Sample::Marker(Colour::Black, marker);
        Self {
            name: name.into(),
            sample,
        }
    }

    /// What a patch means.
    #[must_use]
    pub fn fill(name: impl Into<Label>, fill: Fill) -> Self {
        let sample = Sample::Fill(fill);
        Self {
            name: name.into(),
            sample,
        }
    }
}

//! Draws figures as in a paper, as SVG and PNG: curves, maps, insets, legends and sketches of mass-spring chains.
//!
//! Equal data give equal bytes on every host. The files contain numbers with two decimals of a pixel. The crate uses no
//! system library and no system font. A value that is not finite ends a line, and never appears in a file.
//!
//! ```
//! use frictiongen_plot::{Axis, Colour, Figure, Line, Panel, Stroke};
//!
//! let response: Vec<(f64, f64)> = (0..=200)
//!     .map(|i| f64::from(i) * 0.0125)
//!     .map(|r| (r, 1.0 / (1.0 - r * r).abs()))
//!     .collect();
//! let panel = Panel::new("", Axis::new("frequency ratio *r*", 0.0, 2.5), Axis::new("*X̄*_1", 0.0, 5.0))
//!     .with(Line::new("*β* = 0", Colour::Series(0), Stroke::Solid, vec![response]));
//! let figure = Figure::new("2.4", "amplitude of the mass", 1, vec![panel]);
//! assert!(figure.svg().starts_with("<svg"));
//! ```

mod axis;
#[cfg(feature = "desk")]
pub mod desk;
mod draw;
mod drawing;
mod face;
mod figure;
mod frame;
mod geometry;
mod label;
mod layer;
mod legend;
mod markup;
mod metrics;
mod number;
mod palette;
mod panel;
mod pen;
mod plan;
#[cfg(feature = "png")]
mod png;
mod raster;
mod sketch;
mod stroke;
mod svg;
mod text;
mod ticks;
mod xml;

pub use axis::{Axis, Scale, TickUnit};
pub use face::{Face, Level};
pub use figure::{Figure, Inset, Key, LegendSample, Page, Panel, PanelFrame};
pub use geometry::Point;
pub use label::{Label, Span};
pub use layer::{Across, Anchor, Cells, Guide, Layer, Line, Markers, Note, Raster, Region};
pub use palette::{Colour, Fill};
#[cfg(feature = "png")]
pub use png::PlotError;
pub use sketch::{
    ConstantArrow, End, Excitation, Sketch, SketchContact, Slider, SliderType, Spring,
};
pub use stroke::{Marker, Stroke};

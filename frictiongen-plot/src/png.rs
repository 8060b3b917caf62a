//! PNG: the SVG drawn by resvg with the fonts embedded here, and with no others.

use resvg::{tiny_skia, usvg};
use std::sync::Arc;
use thiserror::Error;

const FONTS: [&[u8]; 4] = [
    include_bytes!("../fonts/PlotSerif-Regular.ttf"),
    include_bytes!("../fonts/PlotSerif-Italic.ttf"),
    include_bytes!("../fonts/PlotSerif-Bold.ttf"),
    include_bytes!("../fonts/PlotSymbols-Regular.otf"),
];
const LARGEST: f32 = 16384.0;

/// Why there is no PNG.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PlotError {
    /// A scale that is not a positive number.
    #[error("the scale {0} is not a positive number")]
    Scale(f32),
    /// A picture of too many pixels.
    #[error("the picture would have {0} by {1} pixels; {LARGEST} is the most")]
    TooLarge(f32, f32),
    /// What cannot be drawn or written.
    #[error("the picture cannot be drawn: {0}")]
    Drawing(String),
}

pub(crate) fn render(svg: &str, scale: f32) -> Result<Vec<u8>, PlotError> {
    if !scale.is_finite() || scale <= 0.0 {
        return Err(PlotError::Scale(scale));
    }
    let mut fonts = usvg::fontdb::Database::new();
    for font in FONTS {
        fonts.load_font_data(font.to_vec());
    }
    fonts.set_serif_family("Plot Serif");
    let options = usvg::Options {
        fontdb: Arc::new(fonts),
        font_family: "Plot Serif".to_owned(),
        ..usvg::Options::default()
    };
    let drawing = |error: &dyn std::fmt::Display| PlotError::Drawing(error.to_string());
    let tree = usvg::Tree::from_str(svg, &options).map_err(|error| drawing(&error))?;
    let (width, height) = (
        (tree.size().width() * scale).round(),
        (tree.size().height() * scale).round(),
    );
    if !(width <= LARGEST && height <= LARGEST) {
        return Err(PlotError::TooLarge(width, height));
    }
    let mut pixels = tiny_skia::Pixmap::new(width.max(1.0) as u32, height.max(1.0) as u32)
        .ok_or_else(|| drawing(&"no room"))?;
    let transform = tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(&tree, transform, &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| drawing(&error))
}

//! Writes PNG pictures: resvg draws the SVG with the embedded fonts only.

use resvg::{tiny_skia, usvg};
use std::sync::Arc;
use thiserror::Error;

/// The embedded fonts, as files in the TrueType format.
const FONTS: [&[u8]; 4] = [
    include_bytes!("../fonts/PlotSerif-Regular.ttf"),
    include_bytes!("../fonts/PlotSerif-Italic.ttf"),
    include_bytes!("../fonts/PlotSerif-Bold.ttf"),
    include_bytes!("../fonts/PlotSymbols-Regular.otf"),
];
/// Largest width and height of a PNG picture, in pixels.
const LARGEST: f32 = 16384.0;

/// The reason why no PNG picture can be made.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PlotError {
    /// The scale is not a positive number.
    #[error("the scale {0} is not a positive number")]
    Scale(f32),
    /// The picture would be too large. The two numbers are the width and the height of the picture in pixels.
    #[error("the picture would have {0} by {1} pixels; {LARGEST} is the most")]
    TooLarge(f32, f32),
    /// The picture cannot be drawn or written. The field contains the message of the library.
    #[error("the picture cannot be drawn: {0}")]
    Drawing(String),
}

pub(crate) fn render(svg: &str, scale: f32) -> Result<Vec<u8>, PlotError> {
    if !scale.is_finite() || scale <= 0.0 {
        return Err(PlotError::Scale(scale));
    }
    let drawing = |error: &dyn std::fmt::Display| PlotError::Drawing(error.to_string());
    let tree = usvg::Tree::from_str(svg, &options()).map_err(|error| drawing(&error))?;
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

/// Returns rendering options in which every font family means the embedded fonts.
fn options() -> usvg::Options<'static> {
    let mut fonts = usvg::fontdb::Database::new();
    for font in FONTS {
        fonts.load_font_source(usvg::fontdb::Source::Binary(Arc::new(font)));
    }
    fonts.set_serif_family("Plot Serif");
    usvg::Options {
        fontdb: Arc::new(fonts),
        font_family: "Plot Serif".to_owned(),
        ..usvg::Options::default()
    }
}

#[cfg(test)]
mod tests {
    use super::{FONTS, PlotError, options, render, usvg};
    use crate::face::Face;
    use crate::metrics::advance;

    /// Returns the width that the renderer gives to one character, or `None` if the renderer draws nothing.
    fn set(character: char, style: &str) -> Option<f64> {
        let text = character
            .to_string()
            .replace('&', "&amp;")
            .replace('<', "&lt;");
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='99' height='99'>\
             <text y='50' font-size='50' font-family='serif' {style}>{text}</text></svg>"
        );
        let tree = usvg::Tree::from_str(&svg, &options()).unwrap();
        let text = tree.root().children().first()?.bounding_box();
        Some(f64::from(text.width()) / 50.0)
    }

    #[test]
    fn widths_are_those_of_the_embedded_fonts() {
        let faces = [
            (Face::Regular, ""),
            (Face::Italic, "font-style='italic'"),
            (Face::Bold, "font-weight='bold'"),
        ];
        let mut compared = 0;
        for (face, style) in faces {
            for character in ('!'..='~').chain('α'..='ω').chain(['Δ', 'Φ', 'Ω']) {
                let wide = set(character, style).unwrap();
                let listed = f64::from(advance(face, character)) * 1e-3;
                assert!(
                    (wide - listed).abs() < 0.002,
                    "{character} {style}: {wide}, {listed}"
                );
                compared += 1;
            }
        }
        assert_eq!(compared, 3 * (94 + 25 + 3));
    }

    #[test]
    fn every_symbol_of_the_figures_has_a_glyph() {
        let mut fonts = usvg::fontdb::Database::new();
        assert_eq!(
            FONTS
                .iter()
                .map(|font| fonts
                    .load_font_source(usvg::fontdb::Source::Binary(std::sync::Arc::new(*font)))
                    .len())
                .sum::<usize>(),
            4
        );
        // The fonts lack this character. The renderer draws such a character as nothing, or as a box of a fixed width.
        let lost = set('\u{4e00}', "");
        for character in "−×°±≤≥≈≠→←∞√∂∑≪≫≅∼·…–—′‘’“”".chars()
        {
            assert!(
                set(character, "") != lost && set(character, "").is_some(),
                "{character}"
            );
        }
    }

    #[test]
    fn an_impossible_picture_is_an_error() {
        let svg = crate::Figure::default().svg();
        for scale in [0.0, -1.0, f32::INFINITY] {
            assert_eq!(render(&svg, scale), Err(PlotError::Scale(scale)));
        }
        assert!(matches!(render(&svg, f32::NAN), Err(PlotError::Scale(_))));
        assert!(matches!(render(&svg, 1e3), Err(PlotError::TooLarge(..))));
        assert!(matches!(render("<svg", 1.0), Err(PlotError::Drawing(_))));
    }
}

//! The legend: one entry for each name, in columns.

use crate::figure::LegendSample;
use crate::geometry::Rect;
use crate::label::Label;
use crate::layer::Anchor;
use crate::palette::{Colour, FRAME, Fill};
use crate::stroke::{Marker, Stroke};
use crate::svg::Canvas;
use crate::text::TextStyle;

/// Text size of the legend, in pixels.
const SIZE: f64 = 14.0;
/// Height of a row of the legend, in pixels.
const ROW: f64 = 21.0;
/// Length of the sample before an entry's text, in pixels.
const SAMPLE: f64 = 34.0;
/// Distance between a sample and its text, in pixels.
const SPACE: f64 = 8.0;
/// Distance between two columns of the legend, in pixels.
const GAP: f64 = 24.0;

/// A legend entry with its samples. Curves and markers of the same name share one entry.
#[derive(Debug)]
struct LegendEntry {
    name: Label,
    line: Option<(Colour, Stroke)>,
    /// True if lines of this name have different strokes. The sample of the entry then shows the colour without a
    /// stroke.
    mixed: bool,
    marker: Option<(Colour, Marker)>,
    fill: Option<Fill>,
}

/// The legend of a figure: one entry for each name in any panel.
#[derive(Debug, Default)]
pub(crate) struct Legend {
    entries: Vec<LegendEntry>,
}

impl Legend {
    /// Adds a sample to the legend entry of a name, or creates the entry. The first sample of each type (line, marker
    /// or fill) stays.
    pub(crate) fn add(&mut self, name: &Label, sample: LegendSample) {
        if name.is_empty() {
            return;
        }
        let known = self.entries.iter().position(|entry| entry.name == *name);
        let place = known.unwrap_or_else(|| {
            self.entries.push(LegendEntry {
                name: name.clone(),
                line: None,
                mixed: false,
                marker: None,
                fill: None,
            });
            self.entries.len() - 1
        });
        let Some(entry) = self.entries.get_mut(place) else {
            return;
        };
        match sample {
            LegendSample::Line(colour, stroke) => {
                let (_, first) = *entry.line.get_or_insert((colour, stroke));
                entry.mixed |= first != stroke;
            }
            LegendSample::Marker(colour, marker) => {
                _ = entry.marker.get_or_insert((colour, marker))
            }
            LegendSample::Fill(fill) => _ = entry.fill.get_or_insert(fill),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Returns the names of all entries, for readers who cannot see the figure.
    pub(crate) fn names(&self) -> Vec<String> {
        self.entries
            .iter()
            .map(|entry| entry.name.plain())
            .collect()
    }

    /// Returns the least width in pixels that the legend needs, which is the width of a single column.
    pub(crate) fn least(&self) -> f64 {
        self.widths(1).iter().sum()
    }

    /// Draws the legend within the width `width` in pixels, and returns the height of the legend. Without a canvas, the
    /// function only computes the height.
    pub(crate) fn draw(
        &self,
        canvas: Option<&mut Canvas>,
        (left, top): (f64, f64),
        width: f64,
    ) -> f64 {
        let most = self.entries.len().max(1);
        // The legend uses fewer columns than fit into the width if this does not need more rows. The rows are then
        // evenly filled.
        let fits = |columns: &usize| self.widths(*columns).iter().sum::<f64>() - GAP <= width;
        let columns = (1..=most).rev().find(fits).unwrap_or(1);
        let columns = most.div_ceil(most.div_ceil(columns));
        let widths = self.widths(columns);
        let mut y = top;
        let mut sheet = canvas;
        for row in self.entries.chunks(columns) {
            let mut x = left;
            let mut lines = 1;
            for (entry, column) in row.iter().zip(&widths) {
                let wrapped = entry.name.wrapped(SIZE, (width - SAMPLE - SPACE).max(60.0));
                if let Some(canvas) = sheet.as_deref_mut() {
                    entry.sample(canvas, (x, y + 0.5 * ROW));
                    for (index, line) in wrapped.iter().enumerate() {
                        let baseline = y + 0.5 * ROW + 0.33 * SIZE + ROW * index as f64;
                        canvas.text(
                            line,
                            (x + SAMPLE + SPACE, baseline),
                            TextStyle::new(SIZE, Anchor::Start),
                        );
                    }
                }
                lines = lines.max(wrapped.len());
                x += column;
            }
            y += ROW * lines as f64;
        }
        y - top
    }

    /// Returns the widths of the legend's columns in pixels, each with the gap after the column.
    fn widths(&self, columns: usize) -> Vec<f64> {
        let mut widths = vec![0.0_f64; columns];
        for row in self.entries.chunks(columns) {
            for (width, entry) in widths.iter_mut().zip(row) {
                // The browser's font may be slightly wider than the embedded font. The width therefore has a margin of
                // 4 %.
                *width = width.max(SAMPLE + SPACE + 1.04 * entry.name.width(SIZE) + GAP);
            }
        }
        widths
    }
}

impl LegendEntry {
    fn sample(&self, canvas: &mut Canvas, (x, y): (f64, f64)) {
        if let Some(fill) = self.fill {
            let rect = Rect {
                left: x + 4.0,
                top: y - 6.5,
                width: SAMPLE - 8.0,
                height: 13.0,
            };
            canvas.rect(rect, Some(fill.rgb()), Some((FRAME, 0.6)));
        }
        if let Some((colour, _)) = self.line.filter(|_| self.mixed) {
            let rect = Rect {
                left: x,
                top: y - 3.0,
                width: SAMPLE,
                height: 6.0,
            };
            canvas.rect(rect, Some(colour.rgb()), None);
        } else if let Some((colour, stroke)) = self.line {
            canvas.lines(&[vec![(x, y), (x + SAMPLE, y)]], colour.rgb(), stroke);
        }
        if let Some((colour, marker)) = self.marker {
            canvas.markers(&[(x + 0.5 * SAMPLE, y)], colour.rgb(), marker);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Legend, ROW};
    use crate::figure::LegendSample;
    use crate::palette::Colour;
    use crate::stroke::{Marker, Stroke};
    use crate::svg::Canvas;

    #[test]
    fn a_name_has_one_entry() {
        let mut legend = Legend::default();
        for series in 0..3 {
            legend.add(
                &"a".into(),
                LegendSample::Line(Colour::Series(series), Stroke::Solid),
            );
            legend.add(
                &"b".into(),
                LegendSample::Marker(Colour::Series(series), Marker::Circle),
            );
            legend.add(
                &"a".into(),
                LegendSample::Marker(Colour::Series(series), Marker::Cross),
            );
            legend.add(
                &"".into(),
                LegendSample::Marker(Colour::Black, Marker::Cross),
            );
        }
        assert_eq!(legend.names(), ["a", "b"]);
        assert_eq!(
            legend.entries[0].line,
            Some((Colour::Series(0), Stroke::Solid))
        );
        assert_eq!(
            legend.entries[0].marker,
            Some((Colour::Series(0), Marker::Cross))
        );
    }

    #[test]
    fn a_name_of_several_strokes_shows_its_colour() {
        let sample = |strokes: &[Stroke]| {
            let mut legend = Legend::default();
            for stroke in strokes {
                legend.add(&"a".into(), LegendSample::Line(Colour::Series(0), *stroke));
            }
            let mut canvas = Canvas::default();
            legend.draw(Some(&mut canvas), (0.0, 0.0), 100.0);
            canvas.body
        };
        let dashed = sample(&[Stroke::DashDot, Stroke::DashDot]);
        assert!(dashed.contains("stroke-dasharray") && !dashed.contains("<rect"));
        let mixed = sample(&[Stroke::DashDot, Stroke::Solid, Stroke::DashDot]);
        assert!(!mixed.contains("stroke-dasharray") && mixed.contains("<rect"));
    }

    #[test]
    fn it_is_as_high_as_its_rows() {
        let mut legend = Legend::default();
        for name in ["one", "two", "three", "four"] {
            legend.add(
                &name.into(),
                LegendSample::Line(Colour::Black, Stroke::Solid),
            );
        }
        assert_eq!(legend.draw(None, (0.0, 0.0), 1000.0), ROW);
        // Three columns would fit, but two rows of two columns are evenly filled.
        assert_eq!(legend.draw(None, (0.0, 0.0), 290.0), 2.0 * ROW);
        assert_eq!(legend.draw(None, (0.0, 0.0), 1.0), 4.0 * ROW);
        assert!(legend.least() < 120.0);
    }
}

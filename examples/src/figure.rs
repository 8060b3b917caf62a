//! Figures: panels of curves, as SVG, with their data as CSV.

use crate::album::Album;
use crate::curve::{Pieces, thin};
use crate::svg::joined;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::fmt::Write as _;

const PANEL: (u32, u32) = (760, 540);
/// What a panel leaves to its axes.
const PLOT: (f64, f64) = (670.0, 440.0);
const LEGEND_ROW: u32 = 30;
const MARGIN: u32 = 12;
const LETTER: usize = 10;
const COLOURS: [RGBColor; 9] = [
    RGBColor(0x1f, 0x4e, 0x9e),
    RGBColor(0xd6, 0x5f, 0x0e),
    RGBColor(0x2a, 0x8c, 0x3c),
    RGBColor(0xb8, 0x22, 0x2c),
    RGBColor(0x7b, 0x4f, 0xa8),
    RGBColor(0x7a, 0x55, 0x3a),
    RGBColor(0xd0, 0x4f, 0xa6),
    RGBColor(0x6f, 0x6f, 0x6f),
    RGBColor(0x12, 0x96, 0xa6),
];

/// An axis with its range.
#[derive(Clone, Debug)]
pub struct Axis {
    pub label: String,
    pub low: f64,
    pub high: f64,
}

impl Axis {
    #[must_use]
    pub fn new(label: &str, low: f64, high: f64) -> Self {
        let label = label.to_owned();
        Self { label, low, high }
    }

    /// Where on the axis a value lies, 0 to 1; a little outside for all that lies outside.
    #[must_use]
    pub fn share(&self, value: f64) -> f64 {
        ((value - self.low) / (self.high - self.low)).clamp(-0.1, 1.1)
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A response.
    Solid,
    /// A limit.
    Dashed,
    /// A stuck response.
    Dotted,
    /// The event-driven simulation.
    Circles,
}

/// The colour of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    Black,
    Series(usize),
}

impl Colour {
    fn rgb(self) -> RGBColor {
        match self {
            Self::Black => BLACK,
            Self::Series(index) => COLOURS[index % COLOURS.len()],
        }
    }
}

/// A named curve.
#[derive(Clone, Debug)]
pub struct Curve {
    pub name: String,
    pub colour: Colour,
    pub stroke: Stroke,
    pub pieces: Pieces,
}

/// One pair of axes.
#[derive(Clone, Debug)]
pub struct Panel {
    pub title: String,
    pub x: Axis,
    pub y: Axis,
    pub curves: Vec<Curve>,
}

/// A figure of the thesis.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Its number, such as 3.14.
    pub number: String,
    pub title: String,
    pub columns: usize,
    pub panels: Vec<Panel>,
}

impl Figure {
    #[must_use]
    pub fn new(number: &str, title: &str, columns: usize, panels: Vec<Panel>) -> Self {
        Self {
            number: number.to_owned(),
            title: title.to_owned(),
            columns: columns.max(1),
            panels,
        }
    }

    /// Leaves to each line the points that its picture shows, and hands the figure to an album.
    ///
    /// # Errors
    /// Where drawing or writing fails.
    pub fn save(mut self, album: &mut Album) -> Result<(), Box<dyn Error>> {
        for panel in &mut self.panels {
            for curve in panel
                .curves
                .iter_mut()
                .filter(|curve| curve.stroke != Stroke::Circles)
            {
                for piece in &mut curve.pieces {
                    *piece = thin(piece, (&panel.x, PLOT.0), (&panel.y, PLOT.1));
                }
            }
        }
        album.add(&self.number, &self.svg()?, &self.csv()?)
    }

    fn csv(&self) -> Result<String, std::fmt::Error> {
        let mut text = String::from("panel,curve,piece,x,y\n");
        for panel in &self.panels {
            for curve in &panel.curves {
                for (index, piece) in curve.pieces.iter().enumerate() {
                    for (x, y) in piece {
                        writeln!(
                            text,
                            "\"{}\",\"{}\",{index},{x:.6},{y:.6}",
                            panel.title, curve.name
                        )?;
                    }
                }
            }
        }
        Ok(text)
    }

    fn svg(&self) -> Result<String, Box<dyn Error>> {
        let columns = self.columns.min(self.panels.len().max(1));
        let rows = self.panels.len().div_ceil(columns);
        let width = PANEL.0 * columns as u32;
        let legend = self.legend(width);
        let above = PANEL.1 * rows as u32 + 44;
        let height = above + LEGEND_ROW * legend.len() as u32 + MARGIN;
        let mut text = String::new();
        {
            let root = SVGBackend::with_string(&mut text, (width, height)).into_drawing_area();
            root.fill(&WHITE)?;
            let (top, bottom) = root.split_vertically(above);
            let title = format!("Figure {}: {}", self.number, self.title);
            let top = top.titled(&title, ("sans-serif", 24))?;
            for (panel, area) in self.panels.iter().zip(top.split_evenly((rows, columns))) {
                panel.draw(&area)?;
            }
            for (row, entries) in legend.iter().enumerate() {
                draw_legend(&bottom, row, entries)?;
            }
            root.present()?;
        }
        Ok(joined(&text))
    }

    /// The different curves of all panels, in rows that fit the width.
    fn legend(&self, width: u32) -> Vec<Vec<(u32, &Curve)>> {
        let mut rows: Vec<Vec<(u32, &Curve)>> = vec![Vec::new()];
        let mut seen: Vec<&str> = Vec::new();
        let mut place = MARGIN;
        for curve in self.panels.iter().flat_map(|panel| &panel.curves) {
            let empty = curve.pieces.iter().all(Vec::is_empty);
            if empty || seen.contains(&curve.name.as_str()) {
                continue;
            }
            seen.push(&curve.name);
            let needed = (64 + LETTER * curve.name.chars().count()) as u32;
            if width < place + needed {
                rows.push(Vec::new());
                place = MARGIN;
            }
            if let Some(row) = rows.last_mut() {
                row.push((place, curve));
            }
            place += needed;
        }
        rows
    }
}

impl Panel {
    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let mut chart = ChartBuilder::on(area)
            .margin(MARGIN)
            .caption(&self.title, ("sans-serif", 20))
            .x_label_area_size(48)
            .y_label_area_size(66)
            .build_cartesian_2d(self.x.low..self.x.high, self.y.low..self.y.high)?;
        chart
            .configure_mesh()
            .x_labels(8)
            .y_labels(8)
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .label_style(("sans-serif", 17))
            .axis_desc_style(("sans-serif", 19))
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .draw()?;
        for curve in &self.curves {
            let colour = curve.colour.rgb();
            for piece in &curve.pieces {
                let points = piece.iter().copied();
                match curve.stroke {
                    Stroke::Solid => {
                        chart.draw_series(LineSeries::new(points, colour.stroke_width(2)))?;
                    }
                    Stroke::Dashed => {
                        let style = colour.stroke_width(2);
                        chart.draw_series(DashedLineSeries::new(points, 12, 7, style))?;
                    }
                    Stroke::Dotted => {
                        let style = colour.stroke_width(2);
                        chart.draw_series(DashedLineSeries::new(points, 3, 8, style))?;
                    }
                    Stroke::Circles => {
                        let shown = points.filter(|(x, y)| {
                            (self.x.low..=self.x.high).contains(x)
                                && (self.y.low..=self.y.high).contains(y)
                        });
                        chart.draw_series(shown.map(|point| Circle::new(point, 4, colour)))?;
                    }
                }
            }
        }
        Ok(())
    }
}

fn draw_legend<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    row: usize,
    entries: &[(u32, &Curve)],
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    let y = (LEGEND_ROW * row as u32 + LEGEND_ROW / 2) as i32;
    for (place, curve) in entries {
        let (start, end) = (*place as i32, *place as i32 + 40);
        let colour = curve.colour.rgb();
        let dash =
            |from: i32, to: i32| PathElement::new([(from, y), (to, y)], colour.stroke_width(3));
        match curve.stroke {
            Stroke::Solid => area.draw(&dash(start, end))?,
            Stroke::Dashed => {
                for from in (start..end).step_by(14) {
                    area.draw(&dash(from, end.min(from + 9)))?;
                }
            }
            Stroke::Dotted => {
                for from in (start..end).step_by(11) {
                    area.draw(&dash(from, end.min(from + 3)))?;
                }
            }
            Stroke::Circles => area.draw(&Circle::new((start + 20, y), 4, colour))?,
        }
        area.draw(&Text::new(
            curve.name.clone(),
            (end + 8, y - 9),
            ("sans-serif", 18),
        ))?;
    }
    Ok(())
}

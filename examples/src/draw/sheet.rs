//! Saves a figure as a picture file and a data file.

use crate::album::Album;
use frictiongen_plot::{Cells, Colour, Figure, Label, Layer, Line, Panel, Point, Raster, Stroke};
use std::error::Error;
use std::fmt::Write as _;

/// Adds a figure to an album: its picture, and all of its data.
///
/// # Errors
/// Fails if a file cannot be written.
pub fn save(figure: &Figure, album: &mut Album) -> Result<(), Box<dyn Error>> {
    #[cfg(feature = "png")]
    album.picture(&figure.number, &figure.png(2.0)?)?;
    if figure.panels.is_empty() {
        return album.add_picture(&figure.number, &figure.svg());
    }
    album.add(&figure.number, &figure.svg(), &csv(figure)?)
}

/// Formats every point of a figure's lines, markers and maps as CSV, with nine digits.
///
/// # Errors
/// Never fails in practice, because writing to a string always succeeds.
pub fn csv(figure: &Figure) -> Result<String, std::fmt::Error> {
    let mut text = String::from("panel,curve,drawn,piece,x,y\n");
    for (index, panel) in figure.panels.iter().enumerate() {
        let title = if panel.title.is_empty() {
            (index + 1).to_string()
        } else {
            panel.title.plain()
        };
        write_panel(&mut text, &title, panel)?;
        for inset in &panel.insets {
            let mut within = inset.panel.clone();
            // Layers that the outer panel already has are not written twice.
            within.layers.retain(|layer| !panel.layers.contains(layer));
            write_panel(&mut text, &format!("{title}, inset"), &within)?;
        }
    }
    Ok(text)
}

fn write_panel(text: &mut String, title: &str, panel: &Panel) -> std::fmt::Result {
    // A layer without a name belongs to the curve of the same colour.
    let mut known: Vec<(Colour, String)> = Vec::new();
    let mut name = |name: &Option<Label>, colour: Colour| match name {
        Some(label) => {
            known.retain(|(other, _)| *other != colour);
            known.push((colour, label.plain()));
            label.plain()
        }
        None => {
            let same = known.iter().find(|(other, _)| *other == colour);
            same.map(|(_, name)| name.clone()).unwrap_or_default()
        }
    };
    for layer in &panel.layers {
        match layer {
            Layer::Line(Line {
                name: label,
                colour,
                stroke,
                pieces,
            }) => {
                let name = name(label, *colour);
                for (index, piece) in pieces.iter().enumerate() {
                    write_points(text, (title, &name, drawn(*stroke), index), piece)?;
                }
            }
            Layer::Markers(markers) => {
                let name = name(&markers.name, markers.colour);
                write_points(text, (title, &name, "marker", 0), &markers.points)?;
            }
            Layer::Raster(raster) => write_cells(text, title, raster)?,
            Layer::Region(_) | Layer::Note(_) | Layer::Guide(_) => {}
        }
    }
    Ok(())
}

const fn drawn(stroke: Stroke) -> &'static str {
    match stroke {
        Stroke::Solid => "solid",
        Stroke::DashDot => "dash-dot",
        Stroke::Dotted => "dotted",
        Stroke::Dashed => "dashed",
        Stroke::Thin => "thin",
    }
}

fn write_points(
    text: &mut String,
    (title, name, drawn, piece): (&str, &str, &str, usize),
    points: &[Point],
) -> std::fmt::Result {
    for (x, y) in points {
        let (x, y) = (digits(*x), digits(*y));
        writeln!(text, "\"{title}\",\"{name}\",{drawn},{piece},{x},{y}")?;
    }
    Ok(())
}

/// Writes the lower and the upper bound of every run of equal cells in a column.
fn write_cells(text: &mut String, title: &str, raster: &Raster) -> std::fmt::Result {
    let Cells::Classes { classes, cells } = &raster.cells else {
        return Ok(());
    };
    let rows = cells.len() / raster.columns.max(1);
    let place = |ends: (f64, f64), share: f64| ends.0 + (ends.1 - ends.0) * share;
    for column in 0..raster.columns {
        let x = place(raster.x, (column as f64 + 0.5) / raster.columns as f64);
        let of = |row: usize| cells.get(row * raster.columns + column).copied().flatten();
        let mut start = 0;
        for row in 1..=rows {
            if row < rows && of(row) == of(start) {
                continue;
            }
            if let Some((name, _)) = of(start).and_then(|class| classes.get(class)) {
                let ends = [start, row].map(|row| (x, place(raster.y, row as f64 / rows as f64)));
                write_points(text, (title, &name.plain(), "cells", column), &ends)?;
            }
            start = row;
        }
    }
    Ok(())
}

/// Formats a number with nine digits, without trailing zeros.
fn digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 {
            "0".to_owned()
        } else {
            String::new()
        };
    }
    let text = format!("{value:.8e}");
    // The value is rounded to nine digits, then written as shortly as that number allows.
    text.parse::<f64>()
        .map_or(text, |rounded| rounded.to_string())
}

#[cfg(test)]
mod tests {
    use super::{csv, digits};
    use frictiongen_plot::{Axis, Colour, Figure, Line, Marker, Markers, Panel, Stroke};

    #[test]
    fn numbers_have_nine_digits() {
        let written = [0.0, -0.0, 1.0 / 3.0, -1e-7, 2.5, 123_456_789.4, f64::NAN].map(digits);
        let expected = [
            "0",
            "0",
            "0.333333333",
            "-0.0000001",
            "2.5",
            "123456789",
            "",
        ];
        assert_eq!(written, expected);
    }

    #[test]
    fn all_points_are_written_under_their_curves_name() {
        let line = |stroke| {
            Line::unnamed(
                Colour::Series(1),
                stroke,
                vec![vec![(1.0, 2.0), (2.0, 3.0)]],
            )
        };
        let named = Line {
            name: Some("*β*_lim".into()),
            ..line(Stroke::Solid)
        };
        let marker = Markers::unnamed(Colour::Series(1), Marker::Circle, vec![(0.5, 0.25)]);
        let panel = Panel::new("(a)", Axis::new("x", 0.0, 1.0), Axis::new("y", 0.0, 1.0));
        let panel = panel.with(named).with(line(Stroke::Dotted)).with(marker);
        let text = csv(&Figure::new("1", "", 1, vec![panel])).expect("text");
        let expected = "panel,curve,drawn,piece,x,y\n\
            \"(a)\",\"βlim\",solid,0,1,2\n\"(a)\",\"βlim\",solid,0,2,3\n\
            \"(a)\",\"βlim\",dotted,0,1,2\n\"(a)\",\"βlim\",dotted,0,2,3\n\
            \"(a)\",\"βlim\",marker,0,0.5,0.25\n";
        assert_eq!(text, expected);
    }
}

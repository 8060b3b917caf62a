//! Draws `elastic-trade.svg`, the error against the time of a steady state with an elastic contact, from
//! `elastic.csv` alone.

use frictiongen_plot::{Anchor, Axis, Colour, Figure, Line, Marker, Markers, Note, Panel, Stroke};
use std::path::Path;

const CAPTION: &str = "Down and to the left is better.  The error is the relative error of the contact's amplitude.  The \
    reference is the same solver in double-double.  Numbers beside marks are the odd harmonics of harmonic balance, and \
    the change between cycles at which the event stepper ends.";

/// Smallest error that the picture shows: half a rounding unit of a double.
const ROUNDING: f64 = 1.1e-16;

/// Position of the note beside a mark: two factors on time and error of the mark, and the end of the note that is at
/// this position.
type Place = (f64, f64, Anchor);

/// Appearance of each method in the picture: name in the table, name in the picture, colour, mark and place of its
/// notes.
const LOOKS: [(&str, &str, usize, Marker, Place); 3] = [
    (
        "frictiongen",
        "ours, at run time",
        0,
        Marker::Dot,
        (1.0, 3.0, Anchor::Start),
    ),
    (
        "event stepper",
        "event stepper in C",
        7,
        Marker::Triangle,
        (0.8, 0.2, Anchor::End),
    ),
    (
        "harmonic balance",
        "harmonic balance in C",
        3,
        Marker::Cross,
        (1.15, 0.2, Anchor::Start),
    ),
];

/// Formats the setting of a method for a note, such as 10⁻³ for 1e-3.
fn words(setting: &str) -> String {
    match setting {
        "1e-3" => "10⁻³".to_owned(),
        "1e-6" => "10⁻⁶".to_owned(),
        "1e-9" => "10⁻⁹".to_owned(),
        other => other.to_owned(),
    }
}

/// A row of the table: the time and the error of one method with one setting.
#[derive(Debug, PartialEq)]
struct Row {
    scene: String,
    by: String,
    setting: String,
    /// Time of a steady state, in ms.
    time: f64,
    error: f64,
}

fn rows(table: &str) -> Result<Vec<Row>, Box<dyn std::error::Error>> {
    let mut rows = Vec::new();
    for line in table.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let [scene, by, setting, _, time, _, error] = cells.as_slice() else {
            return Err(format!("not a row of the table: {line}").into());
        };
        rows.push(Row {
            scene: (*scene).to_owned(),
            by: (*by).to_owned(),
            setting: (*setting).to_owned(),
            time: time.parse::<f64>()? / 1e3,
            error: error.parse::<f64>()?.max(ROUNDING),
        });
    }
    Ok(rows)
}

/// Draws a table as a picture, and writes it to a folder.
///
/// # Errors
/// Fails if the table cannot be read, or if the folder cannot be written to.
pub fn write(table: &str, folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    std::fs::write(
        folder.join("elastic-trade.svg"),
        figure(&rows(table)?).svg(),
    )?;
    Ok(())
}

fn figure(rows: &[Row]) -> Figure {
    let mut scenes: Vec<&str> = Vec::new();
    for row in rows {
        if !scenes.contains(&row.scene.as_str()) {
            scenes.push(&row.scene);
        }
    }
    // The axis goes on to the right of the slowest method, for its note.
    let times = rows.iter().flat_map(|row| [row.time, row.time * 3.0]);
    let times = Axis::fitted_log("time of a steady state, ms  (← faster)", times);
    let errors = Axis::fitted_log(
        "relative error  (← more exact)",
        rows.iter().map(|row| row.error),
    );
    let panels = scenes.into_iter().map(|scene| {
        let mut panel = Panel::new(scene, times.clone(), errors.clone());
        panel.height = Some(320.0);
        for (by, name, series, marker, place) in LOOKS {
            let own = rows.iter().filter(|row| row.scene == scene && row.by == by);
            let own: Vec<&Row> = own.collect();
            let points: Vec<(f64, f64)> = own.iter().map(|row| (row.time, row.error)).collect();
            let colour = Colour::Series(series);
            panel = panel.with(Line::new(name, colour, Stroke::Thin, vec![points.clone()]));
            panel = panel.with(Markers::new(name, colour, marker, points));
            for row in own.into_iter().filter(|row| !row.setting.is_empty()) {
                let (beside, above, anchor) = place;
                let at = (row.time * beside, row.error * above);
                let note = Note::new(words(&row.setting), at, anchor);
                panel.layers.push(Note { colour, ..note }.into());
            }
        }
        panel
    });
    Figure::new(
        "",
        "A steady state with an elastic contact",
        2,
        panels.collect(),
    )
    .with_caption(CAPTION)
}

#[cfg(test)]
mod tests {
    use super::{LOOKS, figure, rows};

    #[test]
    fn the_stored_picture_is_of_the_stored_table() {
        let rows = rows(include_str!("../../../docs/data/elastic.csv")).unwrap();
        assert!(
            rows.iter()
                .all(|row| LOOKS.iter().any(|look| look.0 == row.by))
        );
        assert!(figure(&rows).svg() == include_str!("../../../docs/elastic-trade.svg"));
    }
}

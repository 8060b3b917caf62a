//! Draws `docs/trade.svg`, the error against the time of each method, from `trade.csv` alone.

mod pools;
mod questions;

use frictiongen_plot::{Axis, Colour, Figure, Line, Marker, Markers, Note, Panel, Stroke};
use pools::{Pool, pools};
use questions::{ALL, Beside, Question};
use std::path::Path;

const CAPTION: &str = "Down and to the left is better.  A mark is one way with one number of masses; a line joins \
    1, 2, 5 and 10 masses, in (f) 1, 2 and 5, as the numbers along some say.  Pooled in a mark: the scenes with a \
    contact to the wall, to the base and between a pair of masses, undamped and with *ζ* = 0.02, as far as measured; \
    its time is the middle one of theirs, its error the largest of theirs.  A scene's error is relative, against the \
    exact answer in double-double, and what 99 of 100 usual points stay within; the stepper has one point.  Per \
    mode, monoharmonic and fundamental are shown compiled to f64 alone, per mode without one mass, where it is exact; \
    the stepper without a damped base, which is another scene to it.";

/// Smallest ratio of the upper to the lower end of an error axis.
const LEAST_SPAN: f64 = 40.0;

/// Appearance of a method in the picture: its name and its mark.
struct Look {
    /// First characters of the method's name in the table.
    by: &'static str,
    name: &'static str,
    series: usize,
    marker: Marker,
}

/// Looks of all methods. Methods of this library have round marks in cool colours. Other methods have angular marks in
/// warm colours.
const LOOKS: [Look; 9] = [
    Look::new("emitted f64", "ours: compiled, f64", 0, Marker::Dot),
    Look::new("emitted f32", "ours: compiled, f32", 5, Marker::Circle),
    Look::new("System f64", "ours: at run time, f64", 6, Marker::Circle),
    Look::new("table 1e-", TABLES, 2, Marker::Dot),
    Look::new("System's table 1e-", TABLES, 2, Marker::Dot),
    Look::new("C by hand", "C by hand", 1, Marker::Square),
    Look::new(
        "eigenproblem at each r",
        "eigenproblem at each *r*",
        4,
        Marker::Triangle,
    ),
    Look::new(
        "harmonic balance ",
        "harmonic balance to *n*",
        3,
        Marker::Cross,
    ),
    Look::new("C event stepper", "event stepper in C", 7, Marker::Triangle),
];
const TABLES: &str = "ours: tables of 10^{−2} to 10^{−12}";

impl Look {
    const fn new(by: &'static str, name: &'static str, series: usize, marker: Marker) -> Self {
        Self {
            by,
            name,
            series,
            marker,
        }
    }

    fn is_of(&self, by: &str) -> bool {
        by.starts_with(self.by)
    }

    fn colour(&self) -> Colour {
        Colour::Series(self.series)
    }
}

/// Draws a table as a picture for a wide and for a narrow page, and writes both to a folder.
///
/// # Errors
/// Fails if the table cannot be read, or if the folder cannot be written to.
pub fn write(table: &str, folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let figure = figure(&pools(table)?);
    std::fs::write(folder.join("trade.svg"), figure.svg())?;
    std::fs::write(folder.join("trade-narrow.svg"), figure.narrow().svg())?;
    Ok(())
}

fn figure(pools: &[Pool]) -> Figure {
    let mut panels = Vec::new();
    for row in ALL.chunks(2) {
        // Panels side by side share a time axis, so that their times can be compared.
        let times = row.iter().flat_map(|question| shown(question, pools));
        let times = Axis::fitted_log("time of a call, ns  (← faster)", times.map(|p| p.time));
        let with = row.iter().map(|question| panel(question, &times, pools));
        panels.extend(with);
    }
    Figure::new("", "What each step of speed costs in accuracy", 2, panels).with_caption(CAPTION)
}

fn shown<'a>(question: &Question, pools: &'a [Pool]) -> impl Iterator<Item = &'a Pool> {
    let shows = question.shows;
    pools
        .iter()
        .filter(move |pool| shows(&pool.by, &pool.answer, pool.masses))
}

fn panel(question: &Question, times: &Axis, pools: &[Pool]) -> Panel {
    let inside: Vec<&Pool> = shown(question, pools).collect();
    let errors = errors(inside.iter().map(|pool| pool.error));
    let mut panel = Panel::new(question.title, times.clone(), errors);
    panel.height = Some(question.height);
    let mut ways: Vec<(&Look, Vec<(f64, f64)>)> = Vec::new();
    for look in &LOOKS {
        let mut names: Vec<(&str, &str)> = Vec::new();
        for pool in inside.iter().filter(|pool| look.is_of(&pool.by)) {
            if !names.contains(&(&pool.by, &pool.answer)) {
                names.push((&pool.by, &pool.answer));
            }
        }
        for name in names {
            let of_name = inside.iter().filter(|p| (&*p.by, &*p.answer) == name);
            ways.push((look, of_name.map(|p| (p.time, p.error)).collect()));
        }
    }
    for (look, points) in &ways {
        let pieces = vec![points.clone()];
        panel = panel.with(Line::new(look.name, look.colour(), Stroke::Thin, pieces));
    }
    // Dots are drawn after circles, so that a circle around a dot stays visible.
    ways.sort_by_key(|(look, _)| look.marker == Marker::Dot);
    for (look, points) in ways {
        panel = panel.with(Markers::new(look.name, look.colour(), look.marker, points));
    }
    for beside in question.notes {
        panel.layers.extend(note(beside, &inside).map(Into::into));
    }
    panel
}

/// Returns an axis that shows all given errors. Its ends have at least the ratio [`LEAST_SPAN`], so that similar
/// errors look similar.
fn errors(all: impl Iterator<Item = f64>) -> Axis {
    let mut axis = Axis::fitted_log("relative error  (← more exact)", all);
    let missing = (LEAST_SPAN / (axis.high / axis.low)).max(1.0).sqrt();
    axis.low /= missing;
    axis.high *= missing;
    axis
}

/// Returns the note beside a mark, or `None` if the panel does not show the mark.
fn note(beside: &Beside, inside: &[&Pool]) -> Option<Note> {
    let (by, answer, masses) = beside.of;
    let mark = inside
        .iter()
        .find(|pool| pool.by == by && pool.answer == answer && pool.masses == masses)?;
    let at = (mark.time * beside.off.0, mark.error * beside.off.1);
    let look = LOOKS.iter().find(|look| look.is_of(by))?;
    let note = Note::new(beside.text, at, beside.anchor);
    let colour = if beside.coloured {
        look.colour()
    } else {
        note.colour
    };
    Some(Note { colour, ..note })
}

#[cfg(test)]
mod tests {
    use super::{ALL, LOOKS, figure, note, pools, shown};

    const TABLE: &str = include_str!("../../../../docs/data/trade.csv");

    #[test]
    fn the_stored_pictures_are_of_the_stored_table() {
        let figure = figure(&pools(TABLE).unwrap());
        assert!(figure.svg() == include_str!("../../../../docs/trade.svg"));
        assert!(figure.narrow().svg() == include_str!("../../../../docs/trade-narrow.svg"));
    }

    #[test]
    fn every_answer_is_asked_for_and_all_words_have_a_mark() {
        let pools = pools(TABLE).unwrap();
        for pool in pools.iter().filter(|pool| pool.by == "emitted f64") {
            let asked = |question| shown(question, &pools).any(|shown| shown == pool);
            let exact = pool.answer == "limits per mode" && pool.masses == 1;
            assert_eq!(ALL.iter().filter(|q| asked(q)).count(), usize::from(!exact));
        }
        for question in &ALL {
            let inside: Vec<_> = shown(question, &pools).collect();
            assert!(
                inside
                    .iter()
                    .all(|p| LOOKS.iter().any(|look| look.is_of(&p.by)))
            );
            for beside in question.notes {
                assert!(note(beside, &inside).is_some(), "{}", beside.text);
            }
        }
    }
}

//! Selects the columns of a printed table that fit into the width of a terminal. The requested quantities come first.
//! The columns r and β appear only on request.

use crate::layout::Layout;
use crate::table;
use frictiongen::study::columns::{Column, ColumnAxis};
use std::io::{self, IsTerminal as _, Write};

/// Width of a table on a terminal, in characters.
const WIDTH: usize = 100;
/// Number of blanks before the second and all later lines of a wrapped text.
const INDENT: usize = 29;
/// Number of blanks between two columns of a table.
const GAP: usize = 2;

/// Available width of a printed table, and the choice of its optional columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TableLayout {
    /// Largest width of the table in characters. `None` for a table of any width.
    pub width: Option<usize>,
    /// True if the table contains the columns r and β next to the columns in Hz and N.
    pub groups: bool,
}

impl TableLayout {
    /// Returns the available width on standard output: 100 characters on a terminal, otherwise any width.
    pub fn of_output(groups: bool) -> Self {
        let width = io::stdout().is_terminal().then_some(WIDTH);
        Self { width, groups }
    }

    /// Returns the columns that fit into the width, and the names of the columns that do not fit.
    pub fn chosen<'a, R>(
        self,
        columns: Vec<Column<'a, R>>,
        layout: Layout,
    ) -> (Vec<Column<'a, R>>, Vec<String>) {
        let Some(width) = self.width else {
            return (columns, Vec::new());
        };
        let ranks: Vec<Option<usize>> = self.ranks(&columns);
        let mut kept: Vec<bool> = columns.iter().map(|column| !column.is_in_text()).collect();
        let mut places: Vec<usize> = (0..columns.len()).collect();
        places.sort_by_key(|place| ranks.get(*place).copied().flatten().unwrap_or(usize::MAX));
        let mut used = 0;
        for place in places {
            let (Some(column), Some(Some(rank))) = (columns.get(place), ranks.get(place)) else {
                continue;
            };
            let wide = if layout == Layout::Lines && column.part.is_some() {
                own_width(&columns, column)
            } else {
                let title = heading(column, layout);
                let title: Vec<&str> = title.iter().map(String::as_str).collect();
                table::PrintedColumn::of(column, &title).width() + GAP
            };
            if (used + wide <= width || *rank == 0)
                && let Some(kept) = kept.get_mut(place)
            {
                *kept = true;
                used += wide;
            }
        }
        if layout == Layout::Lines {
            follow_first(&columns, &mut kept);
        }
        let (mut shown, mut left) = (Vec::new(), Vec::new());
        for (column, kept) in columns.into_iter().zip(kept) {
            if kept {
                shown.push(column);
            } else {
                let name = match layout {
                    Layout::Lines => column.name_in_part(),
                    _ => column.key(),
                };
                if !left.contains(&name) {
                    left.push(name);
                }
            }
        }
        (shown, left)
    }

    /// Returns the rank of each column, which decides whether a table of limited width contains the column. A table
    /// always contains the columns of rank 0. The table takes columns of higher rank in ascending order, as long as
    /// they fit into the width. A table never contains a column without a rank (`None`).
    fn ranks<R>(self, columns: &[Column<'_, R>]) -> Vec<Option<usize>> {
        let mut part: Option<&str> = None;
        let mut place = 0;
        let mut ranks = Vec::with_capacity(columns.len());
        for column in columns {
            let own = column.part.as_deref();
            place = if own.is_some() && own == part {
                place + 1
            } else {
                0
            };
            part = own;
            ranks.push(match own {
                _ if !column.is_in_text() => None,
                None if is_group(columns, column) => self.groups.then_some(1),
                None if column.axis != ColumnAxis::Row => Some(0),
                None if is_answer(column.name()) => Some(2),
                None => Some(4),
                // The amplitude of each motion comes before all other numbers, and its phase before most other numbers.
                Some(_) if place == 0 || column.name().starts_with("largest") => Some(1),
                Some(_) if column.name().starts_with("phase") => Some(3),
                Some(_) => Some(4 + place),
            });
        }
        ranks
    }

    /// Writes a text, and breaks its lines at blanks so that they fit into the width.
    pub fn wrapped(self, text: &str, out: &mut dyn Write) -> io::Result<()> {
        let Some(width) = self.width else {
            return out.write_all(text.as_bytes());
        };
        for line in text.lines() {
            let mut rest = line;
            let mut indent = "";
            while width < indent.len() + rest.chars().count() {
                let room = width.saturating_sub(indent.len());
                let end = rest
                    .char_indices()
                    .nth(room)
                    .map_or(rest.len(), |(end, _)| end);
                let head = rest.get(..end).unwrap_or(rest);
                let Some(cut) = head.trim_end().rfind(' ').filter(|cut| *cut > room / 3) else {
                    break;
                };
                writeln!(
                    out,
                    "{indent}{}",
                    head.get(..cut).unwrap_or(head).trim_end()
                )?;
                rest = rest.get(cut..).unwrap_or_default().trim_start();
                indent = BLANKS.get(..INDENT).unwrap_or_default();
            }
            writeln!(out, "{indent}{rest}")?;
        }
        Ok(())
    }

    /// Writes a line with the names of the columns that a table leaves out.
    pub fn note(self, left: &[String], out: &mut dyn Write) -> io::Result<()> {
        if left.is_empty() {
            return Ok(());
        }
        let groups = left.iter().any(|name| name == "r" || name == "beta");
        let more = if groups {
            "--groups has r and beta; "
        } else {
            ""
        };
        let names = left.join(", ");
        let width = self.width.unwrap_or(WIDTH);
        let text = format!(
            "\nleft out to fit {width} columns: {names}\n{more}--width 0, --csv and --json have every column\n"
        );
        self.wrapped(&text, out)
    }
}

/// A string of blanks, from which the code copies the indentation of wrapped lines.
const BLANKS: &str = "                                        ";

/// Returns true if a column contains r or β, and another column contains the same quantity in Hz or N.
fn is_group<R>(columns: &[Column<'_, R>], column: &Column<'_, R>) -> bool {
    let physical = match column.name() {
        "r" => "frequency_Hz".to_owned(),
        "beta" => "friction_N".to_owned(),
        name => format!("{name}_N"),
    };
    let rad = "omega_rad_s";
    let mut others = columns.iter();
    others.any(|other| other.name() == physical || (column.name() == "r" && other.name() == rad))
}

/// Returns true for a column that a reader needs to interpret the numbers of a row.
fn is_answer(name: &str) -> bool {
    let starts = [
        "regime",
        "state",
        "friction",
        "amplitude",
        "feature",
        "what",
    ];
    name == "of" || starts.iter().any(|start| name.starts_with(start))
}

/// Returns the lines of a column's heading in this layout.
fn heading<R>(column: &Column<'_, R>, layout: Layout) -> Vec<String> {
    let part = column.part.iter().filter(|_| layout != Layout::Lines);
    part.chain(&column.title).cloned().collect()
}

/// Keeps the same columns for every motion as for the first motion. `kept` has a flag for each column, which is true
/// if the table contains the column.
fn follow_first<R>(columns: &[Column<'_, R>], kept: &mut [bool]) {
    let first = columns.iter().find_map(|column| column.part.as_ref());
    let of_first: Vec<(String, bool)> = columns
        .iter()
        .zip(&*kept)
        .filter(|(column, _)| column.part.is_some() && column.part.as_ref() == first)
        .map(|(column, kept)| (column.name_in_part(), *kept))
        .collect();
    let others = columns.iter().zip(kept.iter_mut());
    for (column, kept) in others.filter(|(column, _)| column.part.is_some()) {
        let name = column.name_in_part();
        if let Some((_, own)) = of_first.iter().find(|(other, _)| *other == name) {
            *kept = *own;
        }
    }
}

/// Returns the width, in characters, that a column adds to a table with one line for each motion. Only the columns of
/// the first motion add a width, because the lines of all motions share these columns. The first column also adds the
/// width of the column with the names.
fn own_width<R>(columns: &[Column<'_, R>], column: &Column<'_, R>) -> usize {
    let first = columns.iter().find_map(|other| other.part.as_ref());
    if column.part.as_ref() != first {
        return 0;
    }
    let title: Vec<&str> = column.title.iter().map(String::as_str).collect();
    let names = columns.iter().filter_map(|other| other.part.as_deref());
    let own = columns.iter().find(|other| other.part.as_ref() == first);
    let is_first = own.is_some_and(|own| own.key() == column.key());
    let name = if is_first {
        table::PrintedColumn::words(&["motion"], names).width() + GAP
    } else {
        0
    };
    table::PrintedColumn::of(column, &title).width() + GAP + name
}

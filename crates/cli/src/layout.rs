//! Arranges the cells of a table row for the output: as lines of text, or as JSON objects.

use crate::number::{Cell, Lossless as _};
use crate::table;
use frictiongen::study::columns::{Column, ColumnKind};
use serde_json::{Map, Value as Json};

/// Arrangement of the motions of the contact and masses in a table row, for text and for JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Text has one line for each row, and JSON has a field for each column.
    Flat,
    /// Text has one line for each row. JSON has a list of the contacts and a list of the masses.
    Lists,
    /// Text has one line for each moving contact or mass. JSON is the same as for [`Layout::Lists`].
    Lines,
}

/// Heading of the column that contains the name of the moving contact or mass.
const MOTION: &str = "motion";

impl Layout {
    /// Returns the columns of the printed table in this layout.
    pub fn titles<R>(self, columns: &[Column<'_, R>]) -> Vec<table::PrintedColumn> {
        let first = columns.iter().find_map(|column| column.part.as_ref());
        let shown = columns.iter().filter(|column| column.is_in_text());
        let mut titles = Vec::new();
        let mut parts = false;
        for column in shown {
            let title = column.title.iter().map(String::as_str);
            match (&column.part, self) {
                (None, _) => {
                    titles.push(table::PrintedColumn::of(column, &title.collect::<Vec<_>>()))
                }
                (part, Self::Lines) => {
                    if !parts {
                        let names = columns.iter().filter_map(|column| column.part.as_deref());
                        titles.push(table::PrintedColumn::words(&[MOTION], names));
                        parts = true;
                    }
                    if part.as_ref() == first {
                        titles.push(table::PrintedColumn::of(column, &title.collect::<Vec<_>>()));
                    }
                }
                (Some(part), _) => {
                    let title: Vec<&str> = std::iter::once(part.as_str()).chain(title).collect();
                    titles.push(table::PrintedColumn::of(column, &title));
                }
            }
        }
        titles
    }

    /// Returns the lines of the printed table for one row.
    pub fn lines<'r, R>(self, columns: &'r [Column<'_, R>], row: &'r R) -> Vec<Vec<Cell<'r>>> {
        let shown = || columns.iter().filter(|column| column.is_in_text());
        if self != Self::Lines {
            return vec![shown().map(|column| column.read(row)).collect()];
        }
        let once = shown().filter(|column| column.part.is_none());
        let once: Vec<Cell<'r>> = once.map(|column| column.read(row)).collect();
        let mut lines: Vec<Vec<Cell<'r>>> = Vec::new();
        let mut name = None;
        for column in shown() {
            let Some(part) = &column.part else { continue };
            if name != Some(part) {
                name = Some(part);
                let mut line = vec![Cell::Missing; once.len()];
                line.push(part.as_str().into());
                lines.push(line);
            }
            if let Some(line) = lines.last_mut() {
                line.push(column.read(row));
            }
        }
        // A contact or mass whose amplitude is missing does not move, so the table has no line for it.
        let amplitude = once.len() + 1;
        lines.retain(|line| line.get(amplitude) != Some(&Cell::Missing));
        match lines.first_mut() {
            Some(line) => line
                .iter_mut()
                .zip(once)
                .for_each(|(cell, value)| *cell = value),
            None => lines.push(once),
        }
        lines
    }

    /// Returns a table row as a JSON object. If `motions` is false, the object contains neither motions nor lists.
    pub fn json<R>(self, columns: &[Column<'_, R>], row: &R, motions: bool) -> Json {
        let mut fields = Map::new();
        let mut parts: Vec<(&str, bool, Map<String, Json>)> = Vec::new();
        for column in columns.iter().filter(|column| column.is_in_json()) {
            let is_list = matches!(column.kind, ColumnKind::Complex | ColumnKind::Intervals);
            if !motions && (is_list || column.part.is_some()) {
                continue;
            }
            let value = column.read(row).json();
            let Some(part) = column.part.as_deref().filter(|_| self != Self::Flat) else {
                fields.insert(column.key(), value);
                continue;
            };
            if parts.iter().all(|(name, ..)| *name != part) {
                parts.push((part, column.is_contact, Map::new()));
            }
            let Some((.., own)) = parts.iter_mut().find(|(name, ..)| *name == part) else {
                continue;
            };
            match column.order {
                Some(order) => harmonic(own, order, column.name(), value),
                None => drop(own.insert(column.name_in_part(), value)),
            }
        }
        if self != Self::Flat && motions {
            let (mut contacts, mut masses) = (Vec::new(), Vec::new());
            for (name, is_contact, mut own) in parts {
                leave_out_missing(&mut own);
                own.insert("name".to_owned(), name.into());
                let list = if is_contact {
                    &mut contacts
                } else {
                    &mut masses
                };
                list.push(Json::Object(own));
            }
            fields.insert("contacts".to_owned(), Json::Array(contacts));
            fields.insert("masses".to_owned(), Json::Array(masses));
        }
        Json::Object(fields)
    }
}

/// Name of the JSON field with the list of harmonics.
const HARMONICS: &str = "harmonics";
/// Name of the JSON field with the order, in an entry of the list of harmonics.
const ORDER: &str = "n";

/// Adds a value to the list of harmonics, in the entry for the harmonic of this order.
fn harmonic(fields: &mut Map<String, Json>, order: u32, name: &str, value: Json) {
    let list = fields
        .entry(HARMONICS)
        .or_insert_with(|| Json::Array(Vec::new()));
    let Json::Array(list) = list else { return };
    let is_new = list
        .last()
        .and_then(|last| last.get(ORDER))
        .and_then(Json::as_u64)
        .is_none_or(|known| known != u64::from(order));
    if is_new {
        let entry = Map::from_iter([(ORDER.to_owned(), Json::from(order))]);
        list.push(Json::Object(entry));
    }
    if let Some(Json::Object(entry)) = list.last_mut() {
        entry.insert(name.to_owned(), value);
    }
}

/// Replaces a list of harmonics by null if no entry has a value.
fn leave_out_missing(fields: &mut Map<String, Json>) {
    let is_empty = |entry: &Json| {
        let entry = entry.as_object().into_iter().flatten();
        let mut values = entry.filter(|(name, _)| *name != ORDER);
        values.all(|(_, value)| value.is_null())
    };
    if let Some(Json::Array(list)) = fields.get(HARMONICS)
        && list.iter().all(is_empty)
    {
        fields.insert(HARMONICS.to_owned(), Json::Null);
    }
}

//! Formats the printed and computed numbers as CSV.

use super::row::Row;

const HEAD: &str =
    "row,scene and quantity,place in the thesis,number,printed,computed,agrees,reason\n";

/// Formats a cell. A cell with a comma or a quotation mark is quoted.
fn cell(text: &str) -> String {
    if text.contains([',', '"']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}

/// Formats the rows as CSV, with one line for each number.
#[must_use]
pub fn table(rows: &[Row]) -> String {
    let mut text = String::from(HEAD);
    for row in rows {
        for entry in &row.entries {
            let (agrees, reason) = if entry.agrees {
                ("yes", "")
            } else {
                ("no", row.reason)
            };
            let cells = [
                row.id,
                row.claim,
                row.place,
                &entry.what,
                &entry.printed,
                &entry.computed,
                agrees,
                reason,
            ];
            text.push_str(&cells.map(cell).join(","));
            text.push('\n');
        }
    }
    text
}

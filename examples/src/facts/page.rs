//! Formats the table of printed and computed numbers as Markdown.

use super::row::{Entry, Row, Verdict};

const HEAD: &str = "# Numbers that the thesis prints, and computed numbers

The table compares the numbers that the thesis prints with the numbers that this library computes. The
command is `cargo run --release --example facts`. A row agrees if each computed number, rounded to the
digits of the printed number, is the printed number. If the thesis prints no number, the table has the
computed number alone. [corrections.md](corrections.md) lists the equations that are misprinted.

| row | scene and quantity | place in the thesis | printed | computed | verdict |
|---|---|---|---|---|---|
";

/// Returns the verdict of a row in words.
#[must_use]
pub fn verdict(verdict: Verdict) -> String {
    match verdict {
        Verdict::Agrees => "agrees to the printed digits".into(),
        Verdict::Corrected(reason) => format!("corrected: {reason}"),
        Verdict::Unexplained => "differs, unexplained".into(),
    }
}

fn printed(entry: &Entry) -> String {
    match (entry.what.as_str(), entry.printed.as_str()) {
        ("", printed) => printed.into(),
        (what, "") => what.into(),
        (what, printed) => format!("{what}: {printed}"),
    }
}

/// Formats the rows as a Markdown table. Each number has its own line in a cell.
#[must_use]
pub fn page(rows: &[Row]) -> String {
    let lines = |row: &Row, cell: fn(&Entry) -> String| {
        let cells: Vec<String> = row.entries.iter().map(cell).collect();
        cells.join("<br>")
    };
    let mut text = String::from(HEAD);
    for row in rows {
        let computed = lines(row, |entry| entry.computed.clone());
        let cells = [
            row.id,
            row.claim,
            row.place,
            &lines(row, printed),
            &computed,
            &verdict(row.verdict()),
        ];
        text.push_str(&format!("| {} |\n", cells.join(" | ")));
    }
    let count = |like: fn(&Verdict) -> bool| rows.iter().filter(|row| like(&row.verdict())).count();
    text.push_str(&format!(
        "\n{} of {} rows agree, {} are corrected.\n",
        count(|verdict| *verdict == Verdict::Agrees),
        rows.len(),
        count(|verdict| matches!(verdict, Verdict::Corrected(_)))
    ));
    text
}

//! Ours against ours: the run-time `System`, and what a call must cost at least.

use super::{of, shown};
use crate::measure::{By, Row};
use crate::methods::Method;
use std::fmt::{Result as Written, Write};

/// What a run-time system's time may be of the emitted scene's.
const RUN_TIME: f64 = 1.2;

/// The run-time `System` over emitted scenes.
pub fn run_time(rows: &[Row], text: &mut String) -> Written {
    let (mut all, mut missed) = (0, 0);
    let mut table = String::from(
        "| scene | ζ | answer | emitted | `System` | ratio of medians | of minima | aim at most | reached |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    for system in rows.iter().filter(|row| row.by == By::RunTime) {
        if !matches!(
            system.method,
            Method::Limits | Method::WithoutSearch | Method::Amplitude
        ) {
            continue;
        }
        let Some(emitted) = of(rows, system, By::Double, system.method) else {
            continue;
        };
        let ratio = system.time.median / emitted.time.median;
        let reached = ratio <= RUN_TIME;
        all += 1;
        missed += usize::from(!reached);
        writeln!(
            table,
            "| {} | {} | {} | {} | {} | {ratio:.2} | {:.2} | {RUN_TIME} | {} |",
            system.label.name,
            system.label.zeta,
            system.method.name(),
            shown(emitted.time.median),
            shown(system.time.median),
            system.time.least / emitted.time.least,
            if reached { "yes" } else { "**missed**" },
        )?;
    }
    writeln!(
        text,
        "## The run-time `System` over emitted scenes\n\n{missed} of {all} ratios are missed.\n\n{table}"
    )
}

/// What limits without search cost, and the operations that they cannot do without.
pub fn floor(rows: &[Row], text: &mut String) -> Written {
    text.push_str("## The floor of limits without search\n\n");
    text.push_str("| scene | ζ | a call | C | operations | ÷ | √ | sin and cos | exp and its like |\n|---|---|---|---|---|---|---|---|---|\n");
    for row in rows {
        let (Some(count), By::Double, Method::WithoutSearch) = (row.operations, row.by, row.method)
        else {
            continue;
        };
        let hand = of(rows, row, By::Hand, row.method);
        writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            row.label.name,
            row.label.zeta,
            shown(row.time.median),
            hand.map_or(String::new(), |hand| shown(hand.time.median)),
            count.total,
            count.divisions,
            count.roots,
            count.circular,
            count.exponential,
        )?;
    }
    text.push('\n');
    Ok(())
}

//! Sections that compare this library with itself: the earlier searches, the slowest calls, the run-time `System`, and
//! the least possible cost of a call.

use super::table::{Table, Tally, cell, verdict};
use super::{of, shown};
use crate::measure::{By, Row};
use crate::methods::Method;
use crate::tails::{RANGE, Tail};
use std::fmt::{Result as Written, Write};

/// Largest ratio that is allowed, of the time of a run-time `System` to that of the emitted scene.
const RUN_TIME: f64 = 1.2;
/// Largest ratios that are allowed, of the time of a call to the median time. The first holds for all but a
/// thousandth of the calls, the second for all calls.
const TAILS: [f64; 2] = [10.0, 40.0];

/// Returns the smallest ratio that is aimed for, of the time of the earlier searches to that of the present searches.
/// `None` if there is no aim.
fn aim_against_before(masses: usize, method: Method) -> Option<f64> {
    match (method, masses) {
        (Method::Limits, 1) => Some(4.0),
        (Method::Limits, 5) => Some(6.0),
        (Method::Limits, 10) => Some(8.0),
        _ => None,
    }
}

/// Writes the section that compares the earlier searches with the present searches.
pub fn before(rows: &[Row], text: &mut String) -> Written {
    text.push_str("## Against the searches before\n\n");
    if !rows.iter().any(|row| row.by == By::Before) {
        text.push_str("SKIPPED: the code of that commit was not there.\n\n");
        return Ok(());
    }
    let mut aims = Tally::default();
    let mut table =
        Table::of_scenes("answer | before | now | ratio of medians | of minima | aim | reached");
    for before in rows.iter().filter(|row| row.by == By::Before) {
        let Some(now) = of(rows, before, By::Double, before.method) else {
            continue;
        };
        let ratio = before.time.median / now.time.median;
        let aim = aim_against_before(before.label.masses, before.method);
        table.scene(
            &before.label,
            &[
                &before.method.name(),
                &shown(before.time.median),
                &shown(now.time.median),
                &format!("{ratio:.2}"),
                &format!("{:.2}", before.time.least / now.time.least),
                &cell(aim),
                &cell(aim.map(|aim| aims.judge(ratio >= aim))),
            ],
        );
    }
    writeln!(
        text,
        "A ratio is the earlier time divided by the present time.  {aims} ratios are below their aim.\n\n{table}"
    )
}

/// Writes the section that compares the run-time `System` with emitted scenes.
pub fn run_time(rows: &[Row], text: &mut String) -> Written {
    let mut aims = Tally::default();
    let mut table = Table::of_scenes(
        "answer | emitted | `System` | ratio of medians | of minima | aim at most | reached",
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
        table.scene(
            &system.label,
            &[
                &system.method.name(),
                &shown(emitted.time.median),
                &shown(system.time.median),
                &format!("{ratio:.2}"),
                &format!("{:.2}", system.time.least / emitted.time.least),
                &RUN_TIME,
                &aims.judge(ratio <= RUN_TIME),
            ],
        );
    }
    writeln!(
        text,
        "## The run-time `System` over emitted scenes\n\nA ratio is the time of a `System` divided by that of emitted code.  {aims} ratios are above their aim.\n\n{table}"
    )
}

/// Writes the section on the slowest calls that compute exact limits.
pub fn tails(tails: &[Tail], text: &mut String) -> Written {
    let points = tails.first().map_or(0, |tail| tail.points);
    let [low, high] = RANGE;
    writeln!(
        text,
        "## The slowest calls of exact limits\n\nCalls of the exact limits are timed one by one, at {points} frequency ratios, log-uniform from r = {low} to {high}.  The time at an r is the shortest of 3 calls, or of 20 calls at the slowest 100 values of r.  It does not include the time of reading the clock.  A ratio is a time divided by the median time, with aims of at most {} and {}.  The column of evaluations has the largest number of evaluations in one search, as `limits_searched` returns it.  The number in brackets counts the searches that stopped at their bound.\n",
        TAILS[0], TAILS[1],
    )?;
    let mut table = Table::of_scenes(
        "median | 99 of 100 | 999 of 1000 | slowest | at r | ratio of 999 | reached | of slowest | reached | evaluations",
    );
    for tail in tails {
        let [thousandth, slowest] = [tail.thousandth, tail.slowest].map(|t| t / tail.median);
        table.scene(
            &tail.label,
            &[
                &shown(tail.median),
                &shown(tail.hundredth),
                &shown(tail.thousandth),
                &shown(tail.slowest),
                &format!("{:.4}", tail.r),
                &format!("{thousandth:.1}"),
                &verdict(thousandth <= TAILS[0]),
                &format!("{slowest:.1}"),
                &verdict(slowest <= TAILS[1]),
                &format!("{} ({})", tail.evaluations, tail.exceeded),
            ],
        );
    }
    writeln!(text, "{table}")
}

/// Writes the section on the operations and the time of limits without search, which are closed formulas.
pub fn floor(rows: &[Row], text: &mut String) -> Written {
    let mut table =
        Table::of_scenes("a call | C | operations | ÷ | √ | sin and cos | exp and its like");
    for row in rows {
        let (Some(count), By::Double, Method::WithoutSearch) = (row.operations, row.by, row.method)
        else {
            continue;
        };
        let hand = of(rows, row, By::Hand, row.method);
        table.scene(
            &row.label,
            &[
                &shown(row.time.median),
                &cell(hand.map(|hand| shown(hand.time.median))),
                &count.total,
                &count.divisions,
                &count.roots,
                &count.circular,
                &count.exponential,
            ],
        );
    }
    writeln!(text, "## The floor of limits without search\n\n{table}")
}

//! Writes the page `docs/trade.md` from the measurements.

mod declared;
mod ours;
mod table;

use crate::measure::{By, Measure, Row};
use crate::methods::Method;
use crate::scenes::Label;
use crate::tables::pools;
use std::fmt::{Result as Written, Write};
use table::{Table, Tally, cell, verdict};

/// Smallest ratio that is aimed for, of the time of C to the time of this library. At a ratio of 1, C and this library
/// are equally fast.
const EVEN: f64 = 1.0;
/// Smallest ratios that are aimed for, of the time of the event stepper to that of the closed form: without search,
/// and with search.
const STEPPER: [f64; 2] = [1e4, 1e3];

/// Returns the text of the page: tables of the measurements, with the texts around them.
pub fn page(measure: &Measure, firmware: &str) -> Result<String, std::fmt::Error> {
    let rows = &measure.rows;
    let mut text = String::from(include_str!("page_head.md"));
    against_hand(rows, &mut text)?;
    ours::before(rows, &mut text)?;
    declared::declared(measure, &mut text)?;
    ours::tails(&measure.tails, &mut text)?;
    ours::floor(rows, &mut text)?;
    ours::run_time(rows, &mut text)?;
    against_stepper(rows, &mut text)?;
    every_way(rows, &mut text)?;
    on_device(firmware, &mut text)?;
    text.push_str(include_str!("page_tail.md"));
    Ok(text)
}

fn of(rows: &[Row], like: &Row, by: By, method: Method) -> Option<Row> {
    let same =
        |row: &&Row| row.label.text == like.label.text && row.by == by && row.method == method;
    rows.iter().find(same).cloned()
}

fn shown(ns: f64) -> String {
    match ns {
        ns if ns < 100.0 => format!("{ns:.1} ns"),
        ns if ns < 1e4 => format!("{ns:.0} ns"),
        ns if ns < 1e6 => format!("{:.1} µs", ns / 1e3),
        ns if ns < 1e9 => format!("{:.1} ms", ns / 1e6),
        ns => format!("{:.1} s", ns / 1e9),
    }
}

/// Returns the smallest ratio that is aimed for, of the time of C to the time of this library.
fn aim_against_hand(label: &Label, method: Method) -> f64 {
    match (method, label.masses, label.zeta > 0.0) {
        (Method::WithoutSearch, 1, false) => 1.1,
        (Method::WithoutSearch, 1, true) => 1.7,
        (Method::WithoutSearch, ..) => 1.5,
        (Method::Limits, ..) => 15.0,
        (_, 1, _) => 1.0,
        _ => 7.0,
    }
}

fn against_hand(rows: &[Row], text: &mut String) -> Written {
    text.push_str("\n## Against C by hand\n\n");
    if !rows.iter().any(|row| row.by == By::Hand) {
        text.push_str("SKIPPED: there was no C compiler.\n");
        return Ok(());
    }
    let (mut aims, mut slower) = (Tally::default(), 0);
    let mut table =
        Table::of_scenes("answer | ours | C | ratio of medians | of minima | aim | reached");
    for hand in rows.iter().filter(|row| row.by == By::Hand) {
        let Some(ours) = of(rows, hand, By::Double, hand.method) else {
            continue;
        };
        let ratio = hand.time.median / ours.time.median;
        let aim = aim_against_hand(&hand.label, hand.method);
        slower += usize::from(!(ratio >= EVEN));
        table.scene(
            &hand.label,
            &[
                &hand.method.name(),
                &shown(ours.time.median),
                &shown(hand.time.median),
                &format!("{ratio:.2}"),
                &format!("{:.2}", hand.time.least / ours.time.least),
                &aim,
                &aims.judge(ratio >= aim),
            ],
        );
    }
    writeln!(
        text,
        "A ratio is the time of C divided by the time of this library.  {aims} ratios are below their aim.  C is faster in {slower} rows.\n\n{table}"
    )
}

fn against_stepper(rows: &[Row], text: &mut String) -> Written {
    let mut table =
        Table::of_scenes("answer | ours | stepper | ratio | aim | reached | stepper's error");
    for stepper in rows.iter().filter(|row| row.by == By::Stepper) {
        let ways: &[(Method, Option<f64>)] = if stepper.method == Method::Orbit {
            &[(Method::Orbit, None)]
        } else {
            &[
                (Method::Fundamental, Some(STEPPER[0])),
                (Method::Amplitude, Some(STEPPER[1])),
            ]
        };
        for (method, aim) in ways {
            let Some(ours) = of(rows, stepper, By::Double, *method) else {
                continue;
            };
            let ratio = stepper.time.median / ours.time.median;
            table.scene(
                &stepper.label,
                &[
                    &method.name(),
                    &shown(ours.time.median),
                    &shown(stepper.time.median),
                    &format!("{ratio:.0}"),
                    &cell(*aim),
                    &cell(aim.map(|aim| verdict(ratio >= aim))),
                    &format!("{:.1e}", stepper.error.worst()),
                ],
            );
        }
    }
    writeln!(text, "## Against the event stepper in C\n\n{table}")
}

fn every_way(rows: &[Row], text: &mut String) -> Written {
    text.push_str("## Every way\n\nA row combines all contacts and dampings with one number of masses.  The time is the median of the scenes' median times.  Errors are relative to the exact answer.  \"no answer\" counts the points at which the method gave no number.  Operations are those of the emitted function for limits without search.  For other answers they are those of the sums and functions that depend on r alone.\n\n");
    let mut table = Table::new(
        "masses | answer | by | a call | operations | 99 of 100 usual points within | 99 of 100 of all | worst | no answer",
    );
    for pool in pools(rows) {
        let operations = match pool.operations {
            Some((least, most)) if pool.method == Method::WithoutSearch => {
                format!("{least} to {most}")
            }
            Some((least, most)) => format!("{least} to {most} and the search"),
            None => String::new(),
        };
        table.row(&[
            &pool.masses,
            &pool.method.name(),
            &pool.by.name(),
            &shown(pool.time),
            &operations,
            &format!("{:.1e}", pool.usual.percentile()),
            &format!("{:.1e}", pool.error.percentile()),
            &format!("{:.1e}", pool.error.worst()),
            &pool.error.none,
        ]);
    }
    writeln!(text, "{table}")
}

fn on_device(firmware: &str, text: &mut String) -> Written {
    text.push_str("## On a Cortex-M\n\nThe table gives the instructions of a call on the emulated processors, from `firmware/figures.txt` (`scripts/firmware`).\n\n");
    let mut table = Table::new("scene | call | M4F | M7");
    let lines = || {
        firmware
            .lines()
            .map(|line| line.split('|').collect::<Vec<_>>())
    };
    for line in lines() {
        let ["m4", scene, call, count, _] = line[..] else {
            continue;
        };
        if scene == "image" {
            continue;
        }
        let other = lines().find_map(|line| match line[..] {
            ["m7", s, c, count, _] if (s, c) == (scene, call) => Some(count),
            _ => None,
        });
        table.row(&[&scene, &call, &count, &cell(other)]);
    }
    writeln!(text, "{table}")
}

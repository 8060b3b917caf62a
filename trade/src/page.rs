//! `docs/trade.md`.

mod declared;
mod ours;

use crate::measure::{By, Measure, Row};
use crate::methods::Method;
use crate::scenes::Label;
use crate::tables::pools;
use std::fmt::{Result as Written, Write};

/// Where C's time falls below ours.
const EVEN: f64 = 1.0;
/// By what the event stepper's time is to exceed the closed form's: without search, with.
const STEPPER: [f64; 2] = [1e4, 1e3];

/// The page: what was measured, with the texts around it.
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

fn verdict(ratio: f64, aim: f64) -> &'static str {
    if ratio >= aim { "yes" } else { "**missed**" }
}

/// By what C's time is to exceed ours.
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
    let (mut all, mut missed, mut slower) = (0, 0, 0);
    let mut table = String::from(
        "| scene | ζ | answer | ours | C | ratio of medians | of minima | aim | reached |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    for hand in rows.iter().filter(|row| row.by == By::Hand) {
        let Some(ours) = of(rows, hand, By::Double, hand.method) else {
            continue;
        };
        let ratio = hand.time.median / ours.time.median;
        let aim = aim_against_hand(&hand.label, hand.method);
        all += 1;
        missed += usize::from(!(ratio >= aim));
        slower += usize::from(!(ratio >= EVEN));
        writeln!(
            table,
            "| {} | {} | {} | {} | {} | {ratio:.2} | {:.2} | {aim} | {} |",
            hand.label.name,
            hand.label.zeta,
            hand.method.name(),
            shown(ours.time.median),
            shown(hand.time.median),
            hand.time.least / ours.time.least,
            verdict(ratio, aim),
        )?;
    }
    writeln!(
        text,
        "{missed} of {all} ratios are missed; in {slower} the C is faster.\n\n{table}"
    )
}

fn against_stepper(rows: &[Row], text: &mut String) -> Written {
    text.push_str("## Against the event stepper in C\n\n");
    text.push_str("| scene | ζ | answer | ours | stepper | ratio | aim | reached | stepper's error |\n|---|---|---|---|---|---|---|---|---|\n");
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
            writeln!(
                text,
                "| {} | {} | {} | {} | {} | {ratio:.0} | {} | {} | {:.1e} |",
                stepper.label.name,
                stepper.label.zeta,
                method.name(),
                shown(ours.time.median),
                shown(stepper.time.median),
                aim.map_or(String::new(), |aim| aim.to_string()),
                aim.map_or("", |aim| verdict(ratio, aim)),
                stepper.error.worst(),
            )?;
        }
    }
    text.push('\n');
    Ok(())
}

fn every_way(rows: &[Row], text: &mut String) -> Written {
    text.push_str("## Every way\n\nAll contacts and dampings of a number of masses together: the middle one of the scenes' median times; errors against the exact answer; \"no answer\" counts points where the way gave no number; operations are those of the emitted function without search, or of the frequency stage.\n\n");
    text.push_str("| masses | answer | by | a call | operations | 99 of 100 usual points within | 99 of 100 of all | worst | no answer |\n|---|---|---|---|---|---|---|---|---|\n");
    for pool in pools(rows) {
        let operations = match pool.operations {
            Some((least, most)) if pool.method == Method::WithoutSearch => {
                format!("{least} to {most}")
            }
            Some((least, most)) => format!("{least} to {most} and the search"),
            None => String::new(),
        };
        writeln!(
            text,
            "| {} | {} | {} | {} | {operations} | {:.1e} | {:.1e} | {:.1e} | {} |",
            pool.masses,
            pool.method.name(),
            pool.by.name(),
            shown(pool.time),
            pool.usual.percentile(),
            pool.error.percentile(),
            pool.error.worst(),
            pool.error.none,
        )?;
    }
    text.push('\n');
    Ok(())
}

fn on_device(firmware: &str, text: &mut String) -> Written {
    text.push_str("## On a Cortex-M\n\nInstructions a call on the emulated processors, from `firmware/figures.txt` (`scripts/firmware`).\n\n| scene | call | M4F | M7 |\n|---|---|---|---|\n");
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
            ["m7", s, c, count, _] if (s, c) == (scene, call) => Some(count.to_owned()),
            _ => None,
        });
        writeln!(
            text,
            "| {scene} | {call} | {count} | {} |",
            other.unwrap_or_default()
        )?;
    }
    text.push('\n');
    Ok(())
}

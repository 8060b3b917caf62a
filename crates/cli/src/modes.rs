//! Damped modes of a scene with several contacts or dashpots, for `check` and for the report.

use crate::number::computed;
use frictiongen::System;
use frictiongen::study::columns::words_of_set;
use frictiongen::study::joined::{DampedMode, DampedModes};
use frictiongen::study::units::hertz;
use serde_json::{Value as Json, json};
use std::io::{self, Write};

/// Largest number of masses for which the commands compute damped modes. The time grows with the cube of this number.
const MOST_MASSES: usize = 64;
/// Largest number of modes that a table has for each set of stuck contacts.
const MOST_SHOWN: usize = 8;

/// Returns the damped modes of a scene whose modes differ from the modal numbers: a scene with several contacts, with
/// dashpots, or with masses without a support. Returns `None` for any other scene, and for a long chain.
pub fn of(system: &System) -> Option<Vec<DampedModes>> {
    let scene = system.scene();
    if !scene.is_joined() || MOST_MASSES < scene.masses.len() {
        return None;
    }
    system.damped_modes().ok()
}

/// Returns the cells of the table: the set of stuck contacts, the frequency in Hz, and the damping ratio. A mode that
/// decays without oscillation has its decay rate in place of the frequency. The last line of a long set has the number
/// of its modes.
pub fn rows(sets: &[DampedModes], number: impl Fn(f64) -> String) -> Vec<[String; 3]> {
    let one = |mode: &DampedMode| match mode.damping_ratio {
        Some(zeta) => [number(hertz(mode.frequency)), number(zeta)],
        None => [
            "decay".to_owned(),
            format!("{} 1/s", number(mode.decay_rate)),
        ],
    };
    let mut rows = Vec::new();
    for set in sets {
        let name = words_of_set(&set.stuck);
        if set.modes.is_empty() {
            rows.push([name.clone(), "no mode".to_owned(), String::new()]);
        }
        for mode in set.modes.iter().take(MOST_SHOWN) {
            let [frequency, zeta] = one(mode);
            rows.push([name.clone(), frequency, zeta]);
        }
        if MOST_SHOWN < set.modes.len() {
            let count = format!("... ({} in all)", set.modes.len());
            rows.push([name, count, String::new()]);
        }
    }
    rows
}

/// Writes the table of damped modes.
pub fn write(sets: &[DampedModes], out: &mut dyn Write) -> io::Result<()> {
    let rows = rows(sets, |value| match value {
        value if (1e-3..1e5).contains(&value) => format!("{value:.6}"),
        value => computed(value),
    });
    let widest = |column: usize, least: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        let widths = cells.map(|cell| cell.chars().count());
        widths.max().unwrap_or_default().max(least)
    };
    let [width, hertz, ratio] = [widest(0, 25), widest(1, 12), widest(2, 12)];
    writeln!(
        out,
        "{:<width$}  {:>hertz$}  {:>ratio$}",
        "damped modes", "f (Hz)", "zeta"
    )?;
    let mut last = String::new();
    for [name, frequency, zeta] in rows {
        let shown = if name == last { "" } else { &name };
        let line = format!("{shown:<width$}  {frequency:>hertz$}  {zeta:>ratio$}");
        writeln!(out, "{}", line.trim_end())?;
        last = name;
    }
    Ok(())
}

/// Returns the damped modes as JSON.
pub fn json(sets: &[DampedModes]) -> Json {
    let one = |mode: &DampedMode| {
        json!({
            "frequency_Hz": hertz(mode.frequency),
            "damping_ratio": mode.damping_ratio,
            "decay_rate_per_s": mode.decay_rate,
        })
    };
    let set = |set: &DampedModes| {
        let modes: Vec<Json> = set.modes.iter().map(one).collect();
        json!({ "stuck": set.stuck, "modes": modes })
    };
    sets.iter().map(set).collect()
}

//! Measures speed against accuracy: every method of this library and of others, in the same run.
//!
//! `scripts/trade` runs this program. `trade FOLDER` writes `trade.csv`, `trade.md` and the pictures to a folder.
//! `trade --quick FOLDER` measures less, with up to two masses, in seconds. `--before PROGRAM` names the program with
//! the earlier searches (`before/`). `picture/` draws from `trade.csv` alone.

#[macro_use]
mod chains;

mod before;
mod clock;
mod measure;
mod methods;
mod operations;
mod page;
mod peers;
mod points;
mod scenes;
mod tabled;
mod tables;
mod tails;
mod without_search;

use before::Before;
use measure::Measure;
use points::Extent;
use std::path::{Path, PathBuf};

const FULL: Extent = Extent {
    timed: 128,
    usual: 80,
    rounds: 11,
    orbits: 9,
    stepped: 1,
    tail: 100_000,
    masses: 10,
};
const QUICK: Extent = Extent {
    timed: 32,
    usual: 20,
    rounds: 3,
    orbits: 2,
    stepped: 1,
    tail: 10_000,
    masses: 2,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let quick = arguments.first().is_some_and(|word| word == "--quick");
    if quick {
        arguments.remove(0);
    }
    let (before, folder) = match arguments.as_slice() {
        [folder] => (None, folder),
        [word, program, folder] if word == "--before" => {
            (Some(Before::start(Path::new(program))?), folder)
        }
        _ => return Err("trade [--quick] [--before PROGRAM] FOLDER".into()),
    };
    let folder = PathBuf::from(folder);
    if cfg!(not(with_c)) {
        eprintln!("SKIPPED: no C compiler; the peers in C are left out");
    }
    let extent = if quick { QUICK } else { FULL };
    let mut measure = Measure {
        extent,
        before,
        rows: Vec::new(),
        tails: Vec::new(),
        refused: Vec::new(),
    };
    scenes::visit(&mut measure);
    let table = tables::csv(&measure.rows)?;
    std::fs::write(folder.join("trade.csv"), &table)?;
    let figures = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../firmware/figures.txt"
    ))?;
    std::fs::write(folder.join("trade.md"), page::page(&measure, &figures)?)?;
    trade_picture::write(&table, &folder)?;
    Ok(())
}

//! Speed against accuracy: every way to an answer, ours and others', in the same run.
//!
//! `scripts/trade` runs it: `trade FOLDER` writes `trade.csv`, `trade.md` and `trade.svg` there;
//! `trade --quick FOLDER` measures less, in seconds.

mod clock;
mod measure;
mod methods;
mod operations;
mod peers;
mod points;
mod scenes;
mod tables;

use measure::Measure;
use points::Extent;
use std::path::PathBuf;

const FULL: Extent = Extent { timed: 256, generic: 400, rounds: 25, orbits: 24, stepped: 3 };
const QUICK: Extent = Extent { timed: 64, generic: 50, rounds: 3, orbits: 4, stepped: 1 };

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let quick = arguments.first().is_some_and(|word| word == "--quick");
    if quick {
        arguments.remove(0);
    }
    let [folder] = arguments.as_slice() else {
        return Err("trade [--quick] FOLDER".into());
    };
    let folder = PathBuf::from(folder);
    if cfg!(not(with_c)) {
        eprintln!("SKIPPED: no C compiler; the peers in C are left out");
    }
    let extent = if quick { QUICK } else { FULL };
    let mut measure = Measure { extent, rows: Vec::new() };
    scenes::visit(&mut measure);
    std::fs::write(folder.join("trade.csv"), tables::csv(&measure.rows)?)?;
    Ok(())
}

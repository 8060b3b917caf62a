//! Measures speed against accuracy: every method of this library and of others, in the same run.
//!
//! `scripts/trade` runs this program. `trade FOLDER` writes `trade.csv` and `slow-calls.csv` to a folder. `trade --quick
//! FOLDER` measures less, with up to two masses, in seconds. `picture/` draws from `trade.csv` alone.

#[macro_use]
mod chains;

mod clock;
mod measure;
mod methods;
mod peers;
mod points;
mod scenes;
mod tabled;
mod tables;
mod tails;

use measure::Measure;
use points::Extent;
use std::path::Path;

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
    let [folder] = arguments.as_slice() else {
        return Err("trade [--quick] FOLDER".into());
    };
    let folder = Path::new(folder);
    if cfg!(not(with_c)) {
        eprintln!("SKIPPED: no C compiler; the peers in C are left out");
    }
    let extent = if quick { QUICK } else { FULL };
    let mut measure = Measure {
        extent,
        rows: Vec::new(),
        tails: Vec::new(),
    };
    scenes::visit(&mut measure);
    std::fs::write(folder.join("trade.csv"), tables::calls(&measure.rows)?)?;
    std::fs::write(folder.join("slow-calls.csv"), tables::slow(&measure.tails)?)?;
    Ok(())
}

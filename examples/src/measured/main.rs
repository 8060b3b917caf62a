//! Chapters 4 and 6 with measurements: recordings that are simulated with noise of 40 dB.
//! `cargo run --release --example measured` writes the recordings of the page to docs/measure.

mod recordings;

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/measure");
    std::fs::create_dir_all(&folder)?;
    recordings::write(&folder)
}

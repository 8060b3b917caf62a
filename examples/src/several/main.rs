//! Computes four scenes with several contacts: coupled clutches, a robot joint, a bolted joint, and a frame of five
//! storeys in an earthquake.
//!
//! `cargo run --release --example several [FOLDER]` prints the results, and writes the pictures of the bolted joint and
//! of the frame.

use frictiongen_examples::several::{clutches, frame, iwan, robot};
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", clutches::report()?);
    println!("{}", robot::report(1_000_000)?);
    println!("{}", iwan::report()?);
    let design = frame::design()?;
    println!("{}", frame::report(&design));
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        return Ok(());
    };
    std::fs::write(folder.join("iwan.svg"), iwan::picture()?.svg())?;
    std::fs::write(folder.join("storeys.svg"), frame::picture(&design).svg())?;
    Ok(())
}

//! Chapter 4 in method: theory of the one-storey rig, compared with recordings that are simulated with noise.
//! `cargo run --release --example chapter4`

mod forced;
mod prepared;
mod processed;
mod sticking;
mod times;

use frictiongen::study::scene::Node;
use frictiongen::{Of, System};
use frictiongen_examples::album::Album;
use frictiongen_examples::draw::{block, save};
use frictiongen_plot::Sketch;
use frictiongen_plot::desk::sketch;
use std::error::Error;

const PLATE: Of = Of::Mass(0);

/// Returns the one-storey rig whose plate rubs on a fixed disc.
fn fixed(stiction: f64) -> System {
    block("wall", "base", &format!("stiction: {stiction:?},"))
}

/// Returns the one-storey rig whose disc moves with the base.
fn joined() -> System {
    block("base", "base", "")
}

fn drawn(system: &System) -> Sketch {
    sketch(system.scene(), false)
}

fn on_wall(system: &System) -> bool {
    system.scene().contact.to == Node::Wall
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(12)?;
    for figure in [
        prepared::frictionless,
        prepared::free_decay,
        prepared::disc_on_the_wall,
        prepared::disc_on_the_base,
        processed::spectra,
        forced::fixed_wall,
        forced::fixed_wall_slow,
        forced::joined_wall,
        forced::inversion,
        sticking::stuck_at_last,
        times::motions,
        times::harmonics,
    ] {
        save(&figure()?, &mut album)?;
    }
    album.close()
}

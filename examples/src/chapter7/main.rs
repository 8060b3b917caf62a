//! Chapter 7: modal damping and friction together. `cargo run --release --example chapter7`

mod peaks;
mod responses;
mod times;

use frictiongen_examples::album::Album;
use frictiongen_examples::draw::save;
use frictiongen_plot::Figure;
use std::error::Error;

type Drawing = fn() -> Result<Figure, Box<dyn Error>>;

fn main() -> Result<(), Box<dyn Error>> {
    let figures: [Drawing; 10] = [
        times::low_contact,
        times::middle_contact,
        responses::one,
        responses::one_regimes,
        responses::lower,
        responses::upper,
        responses::two_regimes,
        peaks::over_damping,
        peaks::over_friction,
        times::slow,
    ];
    let mut album = Album::open(figures.len())?;
    for figure in figures {
        save(&figure()?, &mut album)?;
    }
    album.close()
}

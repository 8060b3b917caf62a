//! Chapter 6: chains of two, three and five masses.  `cargo run --release --example chapter6`

mod fives;
mod moving;
mod points;
mod rigs;
mod storeys;
mod systems;
mod walls;

use frictiongen_examples::album::Album;
use frictiongen_examples::draw::save;
use frictiongen_plot::Figure;
use std::error::Error;

type Drawing = fn() -> Result<Figure, Box<dyn Error>>;

fn main() -> Result<(), Box<dyn Error>> {
    let figures: [Drawing; 32] = [
        walls::system_of_three,
        walls::stuck_three,
        walls::invariant_points,
        walls::lower_system,
        walls::lower_cycles,
        walls::lower_responses,
        walls::lower_regimes,
        fives::low_amplitudes,
        fives::low_phases,
        fives::low_motion,
        fives::low_regimes,
        walls::upper_system,
        walls::upper_cycles,
        walls::upper_responses,
        walls::upper_regimes,
        fives::middle_amplitudes,
        fives::middle_phases,
        fives::middle_motion,
        fives::middle_regimes,
        storeys::disc_on_the_lower,
        storeys::disc_on_the_upper,
        storeys::without_friction,
        rigs::lower,
        rigs::upper,
        moving::system_between,
        moving::system_joined,
        moving::between_responses,
        moving::between_regimes,
        moving::joined_responses,
        moving::joined_regimes,
        rigs::joined,
        rigs::relative,
    ];
    let mut album = Album::open(figures.len())?;
    for figure in figures {
        save(&figure()?, &mut album)?;
    }
    album.close()
}

//! The systems of chapter 6.

use frictiongen::{Of, System};
use frictiongen_examples::draw::{chain, part_colour};
use frictiongen_plot::Colour;

pub const M1: Of = Of::Mass(0);
pub const M2: Of = Of::Mass(1);
pub const M3: Of = Of::Mass(2);
pub const FIVE: [Of; 5] = [M1, M2, M3, Of::Mass(3), Of::Mass(4)];

/// Returns three equal masses. The middle one is in contact with a wall.
pub fn three() -> System {
    chain(&[1.0; 3], &[1.0; 3], "m2 - wall", "m1", "")
}

/// Returns two equal masses. The lower one is loaded, and one of them rubs on a wall with the ratio μ of static to
/// kinetic friction.
pub fn two(contact: usize, stiction: f64) -> System {
    chain(
        &[1.0; 2],
        &[1.0; 2],
        &format!("m{contact} - wall"),
        "m1",
        &format!("stiction: {stiction:?},"),
    )
}

/// Returns five equal masses. The lowest one is loaded, and one of them rubs on a wall.
pub fn five(contact: usize) -> System {
    let contact = format!("m{contact} - wall");
    chain(&[1.0; 5], &[1.0; 5], &contact, "m1", "")
}

/// Returns the rig of section 6.4 on its moving base, γ = 0.9772, κ = 1.1119.
pub fn rig(contact: &str) -> System {
    chain(&[1.0, 0.9772], &[1.0, 1.1119], contact, "base", "")
}

/// Returns two masses that rub on each other, γ = κ = 0.5.
pub fn between() -> System {
    chain(&[1.0, 0.5], &[1.0, 0.5], "m1 - m2", "m1", "")
}

/// Returns two equal masses. The lower one rubs on a wall that moves with the base.
pub fn joined() -> System {
    chain(&[1.0; 2], &[1.0; 2], "m1 - base", "base", "")
}

/// Returns names, motions and colours of masses, for a figure over time.
pub fn motions(names: &[&'static str]) -> Vec<(&'static str, Of, Colour)> {
    let named = names.iter().enumerate();
    named
        .map(|(index, name)| (*name, Of::Mass(index), part_colour(index)))
        .collect()
}

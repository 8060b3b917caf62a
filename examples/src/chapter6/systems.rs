//! The systems of chapter 6 as run-time systems.

use frictiongen::{Of, System};
use frictiongen_examples::draw::{chain, part_colour};
use frictiongen_plot::Colour;

pub const M1: Of = Of::Mass(0);
pub const M2: Of = Of::Mass(1);
pub const M3: Of = Of::Mass(2);
pub const FIVE: [Of; 5] = [M1, M2, M3, Of::Mass(3), Of::Mass(4)];

/// Returns a chain of three equal masses. The first mass is loaded, and the middle mass rubs on a wall.
pub fn three() -> System {
    chain(&[1.0; 3], &[1.0; 3], "m2 - wall", "m1", "")
}

/// Returns two equal masses. The lower one is loaded, and the mass with the number `contact` rubs on a wall.
/// `stiction` is the ratio μ of static to kinetic friction.
pub fn two(contact: usize, stiction: f64) -> System {
    chain(
        &[1.0; 2],
        &[1.0; 2],
        &format!("m{contact} - wall"),
        "m1",
        &format!("stiction: {stiction:?},"),
    )
}

/// Returns five equal masses. The lowest one is loaded, and the mass with the number `contact` rubs on a wall.
pub fn five(contact: usize) -> System {
    let contact = format!("m{contact} - wall");
    chain(&[1.0; 5], &[1.0; 5], &contact, "m1", "")
}

/// Returns the two-storey rig of section 6.4 on its moving base, with the mass ratio γ = 0.9772 and the stiffness
/// ratio κ = 1.1119.
pub fn rig(contact: &str) -> System {
    chain(&[1.0, 0.9772], &[1.0, 1.1119], contact, "base", "")
}

/// Returns two masses that rub on each other. The mass ratio γ and the stiffness ratio κ are 0.5.
pub fn between() -> System {
    chain(&[1.0, 0.5], &[1.0, 0.5], "m1 - m2", "m1", "")
}

/// Returns two equal masses. The lower one rubs on a wall that moves with the base.
pub fn joined() -> System {
    chain(&[1.0; 2], &[1.0; 2], "m1 - base", "base", "")
}

/// Returns the name, the motion and the colour of each mass, for a figure over time. `names` is in the order of masses.
pub fn motions(names: &[&'static str]) -> Vec<(&'static str, Of, Colour)> {
    let named = names.iter().enumerate();
    named
        .map(|(index, name)| (*name, Of::Mass(index), part_colour(index)))
        .collect()
}

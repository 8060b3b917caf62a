//! Generates random scenes of 1 to 16 masses. They are chains and graphs, undamped to overdamped.

use fuzzing::Random;
use std::fmt::Write as _;

/// Returns a random scene in which the base moves, and in which damping acts on velocities relative to the base.
pub fn damped_from_base(random: &mut Random) -> String {
    loop {
        let text = scene(random);
        if text.contains("excitation: base") && text.contains("damping: ") {
            return text.replace("excitation: base", "excitation: base, damping_from: base");
        }
    }
}

/// Returns a random scene whose masses and stiffnesses lie within a factor of ten of each other.
pub fn scene(random: &mut Random) -> String {
    let count = 1 + random.below(16);
    let mut text = String::from("struct Random { masses: { ");
    for mass in 0..count {
        write!(text, "m{mass}: {:e}, ", random.power(-0.5, 0.5)).unwrap();
    }
    text.push_str("}, springs: { ");
    write!(text, "base - m0: {:e}, ", random.power(-0.5, 0.5)).unwrap();
    for mass in 1..count {
        // The springs form a tree: each mass is joined to the previous mass, or to any earlier mass.
        let from = if random.once_in(4) {
            random.below(mass)
        } else {
            mass - 1
        };
        write!(text, "m{from} - m{mass}: {:e}, ", random.power(-0.5, 0.5)).unwrap();
    }
    if random.once_in(3) {
        write!(
            text,
            "wall - m{}: {:e}, ",
            random.below(count),
            random.power(-0.5, 0.5)
        )
        .unwrap();
    }
    text.push_str("}, ");
    let mass = random.below(count);
    match random.below(if count > 1 { 3 } else { 2 }) {
        0 => write!(text, "contact: m{mass} - wall, ").unwrap(),
        1 => write!(text, "contact: m{mass} - base, ").unwrap(),
        _ => {
            let other = (mass + 1 + random.below(count - 1)) % count;
            write!(text, "contact: m{mass} - m{other}, ").unwrap();
        }
    }
    if random.once_in(3) {
        text.push_str("excitation: base, ");
    } else {
        write!(text, "excitation: m{}, ", random.below(count)).unwrap();
    }
    match random.below(4) {
        0 => {}
        1 => write!(text, "damping: modal({:e}), ", random.power(-3.0, -0.5)).unwrap(),
        2 => {
            text.push_str("damping: modal[");
            for _ in 0..count {
                write!(text, "{:e}, ", random.power(-3.0, 0.3)).unwrap();
            }
            text.push_str("], ");
        }
        _ => {
            let (mass, stiffness) = (random.power(-2.0, 0.0), random.power(-2.0, 0.0));
            write!(text, "damping: rayleigh({mass:e}, {stiffness:e}), ").unwrap();
        }
    }
    write!(text, "stiction: {} }}", [1.0, 1.2, 2.0][random.below(3)]).unwrap();
    text
}

//! Defines chains of 1, 2, 5 and 10 equal masses and springs with every contact, undamped and damped, with μ = 1 and
//! μ = 1.2.

use std::fmt::Write as _;

/// Returns the 44 scenes, each as its name and its description.
pub fn scenes(scalar: &str) -> Vec<(String, String)> {
    let mut scenes = Vec::new();
    for count in [1_usize, 2, 5, 10] {
        for damping in ["none", "modal(0.02)"] {
            for stiction in ["1", "1.2"] {
                for kind in ["Wall", "Base", "Pair"] {
                    if kind == "Pair" && count == 1 {
                        continue;
                    }
                    let name = format!("{kind}{count}, {damping}, {stiction}");
                    scenes.push((name, scene(kind, count, damping, stiction, scalar)));
                }
            }
        }
    }
    scenes
}

/// Returns the description of a scene. For `Wall` the last mass rubs on a wall, and the load acts on the first mass.
/// For `Base` the base moves, and the first mass rubs on it. For `Pair` the first two masses rub on each other, and
/// the load acts on the last mass.
pub fn scene(kind: &str, count: usize, damping: &str, stiction: &str, scalar: &str) -> String {
    let mut text = format!("struct {kind}{count} {{ masses: {{ ");
    for mass in 0..count {
        write!(text, "m{mass}: 1, ").unwrap();
    }
    text.push_str("}, springs: { base - m0: 1, ");
    for mass in 1..count {
        write!(text, "m{} - m{mass}: 1, ", mass - 1).unwrap();
    }
    let last = count - 1;
    let (contact, excitation) = match kind {
        "Wall" => (format!("m{last} - wall"), "m0".to_owned()),
        "Base" => ("m0 - base".to_owned(), "base".to_owned()),
        _ => ("m0 - m1".to_owned(), format!("m{last}")),
    };
    write!(
        text,
        "}}, contact: {contact}, excitation: {excitation}, damping: {damping}, stiction: {stiction}, scalar: {scalar} }}"
    )
    .unwrap();
    text
}

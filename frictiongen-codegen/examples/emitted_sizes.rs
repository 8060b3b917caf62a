//! Prints the sizes of the emitted Rust of seven scenes: the lines, the bytes, and the fraction of the bytes that the
//! scenes have in common. The program then makes one spring 1 % stiffer, and prints how many lines of the emitted files
//! differ.
//!
//! `scripts/emitted-sizes [FOLDER]` runs this program. With a folder, the program also writes the emitted files into
//! this folder.

use frictiongen_codegen::{SizeLimits, parse_text, pretty};
use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

/// Names of the seven scenes, each with its number of masses and with the text of the fields after masses and
/// springs.
const SCENES: [(&str, usize, &str); 7] = [
    (
        "One",
        1,
        "contact: m1 - wall, excitation: m1, damping: modal(0.05)",
    ),
    (
        "Two",
        2,
        "contact: m1 - m2, excitation: base, damping: modal(0.02)",
    ),
    (
        "Three",
        3,
        "contact: m3 - wall, excitation: m1, damping: modal(0.01), stiction: 1.2",
    ),
    (
        "Tables",
        3,
        "contact: m3 - wall, excitation: m1, damping: modal(0.02), scalar: f32, provide: [limits], accuracy: 1e-3, range: { r: 0.2..2.5 }",
    ),
    (
        "Orbits",
        5,
        "contact: m2 - m4, excitation: base, damping: modal(0.01), provide: [limits, orbit]",
    ),
    (
        "Steps",
        5,
        "contact: m5 - wall, excitation: base, damping: modal(0.01), provide: [stepper], step: 1e-3",
    ),
    (
        "Ten",
        10,
        "contact: m10 - wall, excitation: m1, damping: modal(0.01)",
    ),
];

fn text((name, masses, fields): (&str, usize, &str), stiffness: f64) -> String {
    let mut text = format!("pub struct {name} {{ masses: {{");
    for mass in 1..=masses {
        let _ = write!(text, " m{mass}: {},", 3.0 + 0.1 * (mass * 7 % 10) as f64);
    }
    let _ = write!(text, " }}, springs: {{ base - m1: {stiffness},");
    for mass in 2..=masses {
        let _ = write!(
            text,
            " m{} - m{mass}: {},",
            mass - 1,
            1190 + 50 * (mass * 3 % 10)
        );
    }
    let _ = write!(text, " }}, {fields} }}");
    text
}

fn emitted(scene: (&str, usize, &str), stiffness: f64) -> Result<String, Box<dyn Error>> {
    let description = parse_text(&text(scene, stiffness), &SizeLimits::MACRO)
        .map_err(|errors| format!("{}: {errors}", scene.0))?;
    Ok(pretty(&description)?)
}

/// Returns the number of lines that a line diff removes and adds.
fn changed(old: &str, new: &str) -> usize {
    let (old, new): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    // Lengths of longest common subsequences: entry j compares the lines of `old` so far with the lines of `new` up to
    // line j.
    let mut common = vec![0_usize; new.len()];
    for line in &old {
        let (mut diagonal, mut left) = (0, 0);
        for (above, other) in common.iter_mut().zip(&new) {
            let length = if line == other {
                diagonal + 1
            } else {
                left.max(*above)
            };
            (diagonal, left) = (*above, length);
            *above = length;
        }
    }
    old.len() + new.len() - 2 * common.last().copied().unwrap_or(0)
}

/// Returns the lines of an emitted file, with the scene's name and scalar type replaced by those that all scenes
/// share.
fn neutral(name: &str, source: &str) -> Vec<String> {
    let source = source.replace(name, "Scene").replace("f32", "f64");
    source.lines().map(|line| line.trim().to_owned()).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).map(PathBuf::from);
    let mut sources = Vec::new();
    for scene in SCENES {
        let source = emitted(scene, 1190.0)?;
        if let Some(folder) = &folder {
            std::fs::create_dir_all(folder)?;
            std::fs::write(folder.join(format!("{}.rs", scene.0)), &source)?;
        }
        sources.push((scene, source));
    }
    let lines: Vec<BTreeSet<String>> = sources
        .iter()
        .map(|(scene, source)| neutral(scene.0, source).into_iter().collect())
        .collect();
    println!("scene    lines   bytes  in common  lines of the diff");
    for (scene, source) in &sources {
        // A line counts as common if at least six of the seven scenes have it. The seventh scene may be the scene with
        // the stepper.
        let bytes: Vec<(usize, bool)> = neutral(scene.0, source)
            .iter()
            .map(|line| {
                let with = lines.iter().filter(|lines| lines.contains(line)).count();
                (line.len(), with + 1 >= SCENES.len())
            })
            .collect();
        let all: usize = bytes.iter().map(|(length, _)| length).sum();
        let common: usize = bytes
            .iter()
            .filter(|(_, common)| *common)
            .map(|(length, _)| length)
            .sum();
        println!(
            "{:8} {:5} {:7} {:8.0} % {:6}",
            scene.0,
            source.lines().count(),
            source.len(),
            100.0 * common as f64 / all as f64,
            changed(source, &emitted(*scene, 1190.0 * 1.01)?)
        );
    }
    Ok(())
}

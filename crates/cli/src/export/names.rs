//! Names of a scene's items in C.

use super::face::{FieldType, StructField};
use crate::failure::Failure;
use frictiongen::study::scene::Scene;
use frictiongen_codegen::standalone::c_name;

/// Headers of the C library. An exported header with one of these names would hide the header of the C library.
const TAKEN: [&str; 24] = [
    "assert", "complex", "ctype", "errno", "fenv", "float", "inttypes", "iso646", "limits",
    "locale", "math", "setjmp", "signal", "stdarg", "stdbool", "stddef", "stdint", "stdio",
    "stdlib", "string", "tgmath", "time", "wchar", "wctype",
];

/// Returns the prefix of all names in C: the value of --name, or the scene's name in snake case.
pub fn prefix(scene: &Scene, given: Option<&str>) -> Result<String, Failure> {
    let name = given.map_or_else(|| c_name(scene), str::to_owned);
    let is_letter = |letter: char| letter.is_ascii_alphabetic();
    let rest = |letter: char| is_letter(letter) || letter.is_ascii_digit() || letter == '_';
    if !(name.starts_with(is_letter) && name.chars().all(rest)) {
        let origin = if given.is_some() {
            "--name is"
        } else {
            "the scene's name gives"
        };
        return Err(Failure::new(format_args!(
            "{origin} `{name}`, which cannot begin a name in C; write --name with letters, digits and underscores, for example --name frame"
        )));
    }
    Ok(name)
}

/// Fails if the exported header would hide a header of the C library.
pub fn check_header(name: &str) -> Result<(), Failure> {
    if TAKEN.contains(&name) {
        return Err(Failure::new(format_args!(
            "{name}.h is a header of the C library; give the files another name, for example --name my_{name}"
        )));
    }
    Ok(())
}

/// Returns the name of a struct field for a mass. It is `start` and the name of the mass. If the name has letters
/// outside ASCII, the number of the mass replaces the name.
pub fn field(scene: &Scene, index: usize, start: &str) -> String {
    format!("{start}_{}", ascii(mass(scene, index), index))
}

/// Returns a name in the scene description, or its number if it has letters outside ASCII.
pub fn ascii(name: &str, index: usize) -> String {
    if name.is_ascii() {
        name.to_owned()
    } else {
        (index + 1).to_string()
    }
}

/// Returns the name of a mass in the scene description.
pub fn mass(scene: &Scene, index: usize) -> &str {
    scene.masses.get(index).map_or("", |mass| &mass.name)
}

/// Returns one text for each mass. `text` creates the text from two names of the mass: as a struct field, and in the
/// scene description.
pub fn of_masses(scene: &Scene, text: impl Fn(&str, &str) -> String) -> Vec<String> {
    (0..scene.masses.len())
        .map(|index| text(&field(scene, index, "mass"), mass(scene, index)))
        .collect()
}

/// Returns a struct field for a mass. The field contains the struct `record`.
pub fn mass_field(scene: &Scene, index: usize, record: &'static str) -> StructField {
    let about = format!("mass {}", mass(scene, index));
    StructField::new(
        field(scene, index, "mass"),
        FieldType::Record(record),
        about,
    )
}

/// Returns one struct field for each mass. Each field contains the struct `record`.
pub fn mass_fields(scene: &Scene, record: &'static str) -> Vec<StructField> {
    let masses = 0..scene.masses.len();
    masses
        .map(|index| mass_field(scene, index, record))
        .collect()
}

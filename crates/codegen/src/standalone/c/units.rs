//! The constants of the header: their names in C, their numbers and their checksum.

use super::super::units::unit_numbers;
use super::super::{Language, NumberFormat, Source, checksum};
use super::constant;
use frictiongen_kernel::Float;

/// Returns the checksum of the constants in the header, including the reference frequency.
pub(super) fn checksum_of_units<S: Float>(source: &Source<'_, S>) -> u32 {
    let numbers = NumberFormat::of::<S>(Language::C);
    checksum::of_numbers(numbers, unit_numbers(source))
}

/// Returns the names of the constants of the header, in the order of their checksum.
pub(super) fn unit_names<S: Float>(source: &Source<'_, S>, name: &str) -> Vec<String> {
    let of = |of: &str| constant(name, of);
    let modes = source.scene.masses.len();
    let mut names = vec![of("K1"), of("M1"), "REFERENCE".to_owned()];
    names.extend((1..=modes).map(|mode| of(&format!("NATURAL_FREQUENCY_{mode}_HZ"))));
    names.extend((1..=modes).map(|mode| of(&format!("RESONANCE_{mode}"))));
    names.extend([of("R_MIN"), of("R_MAX")]);
    if source.tables.moves() {
        names.extend([of("BETA_MIN"), of("BETA_MAX")]);
    }
    names
}

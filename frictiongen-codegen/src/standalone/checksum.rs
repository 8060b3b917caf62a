//! Checksum of emitted numbers, with the same algorithm as in the emitted code.

use super::NumberFormat;
pub(super) use frictiongen_kernel::emitted::check::{MULTIPLIER, TURN};
use frictiongen_kernel::emitted::check::{mixed, with};

/// Explanation of the checksum's form, for the emitted files.
pub(super) const ABOUT: &str = "A change of one word always changes the checksum.  A change of several words goes unnoticed in one of 2^32 cases.";

/// Returns the checksum of numbers in the precision of a file. An `f32` enters as its 32 bits. An `f64` enters as two
/// halves of 32 bits, the low half first.
#[allow(clippy::cast_possible_truncation, reason = "the scalar is f32")]
pub(super) fn of_numbers(numbers: NumberFormat, values: impl IntoIterator<Item = f64>) -> u32 {
    // The files write no negative zero.
    values
        .into_iter()
        .map(|value| value + 0.0)
        .fold(0, |sum, value| {
            if numbers.single {
                return mixed(sum, (value as f32).to_bits());
            }
            with(sum, value)
        })
}

/// Returns the checksum of indices. Each index enters as one word.
#[allow(
    clippy::cast_possible_truncation,
    reason = "an index of a piece has at most 16 bits"
)]
pub(super) fn of_indices(indices: &[usize]) -> u32 {
    indices
        .iter()
        .fold(0, |sum, index| mixed(sum, *index as u32))
}

//! The checksum of emitted numbers, as the emitted code computes it.

use super::Numbers;

/// Multiplier of a step: 2³² over the golden ratio, odd.
pub(super) const MULTIPLIER: u32 = 0x9e37_79b1;
/// Bits by which a step rotates the sum.
pub(super) const TURN: u32 = 5;

/// Why the checksum has this form, for the emitted files.
pub(super) const ABOUT: &str = "A step is a bijection of the sum, so one changed word always changes the result.  Several changed words go unseen in one of 2^32 cases.";

/// Adds a word of 32 bits to a sum.
pub(super) fn step(sum: u32, word: u32) -> u32 {
    (sum.rotate_left(TURN) ^ word).wrapping_mul(MULTIPLIER)
}

/// Returns the checksum of numbers in the precision of a file: the bits of an `f32`, or the low and the high half of
/// those of an `f64`.
#[allow(
    clippy::cast_possible_truncation,
    reason = "halves of the bits, or an f32"
)]
pub(super) fn of_numbers(numbers: Numbers, values: impl IntoIterator<Item = f64>) -> u32 {
    // The files write no negative zero.
    values
        .into_iter()
        .map(|value| value + 0.0)
        .fold(0, |sum, value| {
            if numbers.single {
                return step(sum, (value as f32).to_bits());
            }
            let bits = value.to_bits();
            step(step(sum, bits as u32), (bits >> u32::BITS) as u32)
        })
}

/// Returns the checksum of indices, one word each.
#[allow(
    clippy::cast_possible_truncation,
    reason = "an index of a piece has at most 16 bits"
)]
pub(super) fn of_indices(indices: &[usize]) -> u32 {
    indices
        .iter()
        .fold(0, |sum, index| step(sum, *index as u32))
}

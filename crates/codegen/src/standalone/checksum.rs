//! Checksum of emitted numbers, with the same algorithm as in the emitted code.

use super::NumberFormat;
use crate::emit::about_numbers;
use crate::graph::literal::literal;
use frictiongen_kernel::Float;
pub(super) use frictiongen_kernel::emitted::check::{MULTIPLIER, TURN};
use frictiongen_kernel::emitted::check::{mixed, with};
use frictiongen_model::scene::Precision;
use frictiongen_model::table::Tables;
use proc_macro2::Literal;

/// Sentences for the emitted files about the changes that a checksum detects.
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

/// Returns the documentation line with the checksum of the constant `TABLE`, which the macro emits from `tables`. Files
/// in C and Rust contain the same line, so that a reader can compare a file with the macro's code.
pub(super) fn about_table<S: Float>(tables: &Tables<S>) -> String {
    let precision = if S::EPSILON > f64::EPSILON {
        Precision::F32
    } else {
        Precision::F64
    };
    let number = |value: &S| literal(value.to_f64() + 0.0, precision);
    let index = &tables.index;
    let (low, density) = (number(&index.low), number(&index.density));
    let halvings = Literal::u32_unsuffixed(index.halvings);
    let buckets = index.buckets.iter();
    let buckets = buckets.map(|place| Literal::usize_unsuffixed(*place));
    let pieces = tables.pieces.iter().flat_map(|piece| {
        let coefficients = piece.coefficients.iter().flatten();
        [&piece.from, &piece.origin].into_iter().chain(coefficients)
    });
    let pieces = pieces.map(number);
    about_numbers(&code!(#low, #density, #halvings, #(#buckets,)* #(#pieces),*))
}

//! Self-check of emitted code. The self-check compares the checksums of the emitted constants with known checksums. It
//! also compares computed results with known results.

mod known;
mod listed;

pub use known::{Known, KnownMotion};
pub use listed::Listed;

use crate::number::scalar::Float;
use core::fmt;

/// First constant or result that a self-check finds wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Fault {
    /// The numbers of a constant, or of a group of constants, differ from those that the generator wrote. The field is
    /// the name of the constant or group.
    Numbers(&'static str),
    /// A result differs from the known result. The field is the name of the method that computes the result, or of the
    /// mass whose motion is the result.
    Answer(&'static str),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Numbers(name) => write!(
                f,
                "self-check: the checksum of {name} is wrong; emit the scene anew"
            ),
            Self::Answer(name) => write!(
                f,
                "self-check: the answer of {name} is not the known one; emit and compile the scene anew"
            ),
        }
    }
}

impl core::error::Error for Fault {}

/// Multiplier of one step of the checksum: 2³² divided by the golden ratio, as an odd integer.
pub const MULTIPLIER: u32 = 0x9e37_79b1;
/// Number of bits by which a step of the checksum rotates the sum.
pub const TURN: u32 = 5;

/// Adds a word of 32 bits to a checksum. For a given word, different checksums give different results. For a given
/// checksum, different words give different results. A change of a single word therefore always changes the checksum.
#[must_use]
pub const fn mixed(sum: u32, word: u32) -> u32 {
    (sum.rotate_left(TURN) ^ word).wrapping_mul(MULTIPLIER)
}

/// Adds a number to a checksum. The function adds the low half of the number's bits in double precision first, and then
/// the high half.
#[must_use]
#[allow(clippy::cast_possible_truncation, reason = "halves of the bits")]
pub const fn with(sum: u32, number: f64) -> u32 {
    let bits = number.to_bits();
    mixed(mixed(sum, bits as u32), (bits >> u32::BITS) as u32)
}

/// Returns the checksum of all numbers in a constant.
#[must_use]
pub fn sum<S: Float>(numbers: &(impl Listed<S> + ?Sized)) -> u32 {
    let mut sum = 0;
    numbers.list(&mut |number: S| sum = with(sum, number.to_f64()));
    sum
}

/// Compares the checksum of a constant with the known checksum. The function `black_box` hides the numbers from the
/// compiler, which could otherwise compute the checksum at compile time.
///
/// # Errors
/// [`Fault::Numbers`] with the name of the constant, if the two checksums differ.
pub fn compare<S: Float>(
    name: &'static str,
    numbers: &(impl Listed<S> + ?Sized),
    known: u32,
) -> Result<(), Fault> {
    if sum(core::hint::black_box(numbers)) == known {
        Ok(())
    } else {
        Err(Fault::Numbers(name))
    }
}

#[cfg(test)]
mod tests {
    use super::{compare, mixed, sum, with};

    /// Checks that a change of any bit in one word changes the checksum, whatever words come after it.
    #[test]
    fn one_changed_word_is_seen() {
        for bit in 0..u32::BITS {
            let (one, other) = (mixed(17, 5), mixed(17, 5 ^ (1 << bit)));
            assert_ne!(one, other);
            assert_ne!(mixed(one, 3), mixed(other, 3));
        }
    }

    #[test]
    fn a_changed_last_digit_is_seen() {
        let numbers = [1.5, -0.25, 3.0_f64.sqrt()];
        let known = sum::<f64>(&numbers);
        assert_eq!(compare::<f64>("N", &numbers, known), Ok(()));
        for place in 0..numbers.len() {
            let mut other = numbers;
            other[place] = other[place].next_up();
            assert!(compare::<f64>("N", &other, known).is_err());
        }
        assert_ne!(sum::<f64>(&[0.0]), sum::<f64>(&[-0.0]));
    }

    /// Checks that a number has the same checksum in `f32` and in `f64`. A generator can therefore compute the
    /// checksums of `f32` in `f64`.
    #[test]
    fn single_precision_has_the_sums_of_double() {
        let numbers = [1.5_f32, 0.1, 1e-40];
        assert_eq!(sum::<f32>(&numbers), sum::<f64>(&numbers.map(f64::from)));
        assert_eq!(sum::<f32>(&[3_u8, 7]), sum::<f64>(&[3_usize, 7]));
        assert_eq!(sum::<f32>(&u64::MAX), sum::<f64>(&u64::MAX));
        assert_eq!(sum::<f64>(&2.0), with(0, 2.0));
    }
}

//! Buckets by which a piece is found.

use super::fit::Fitted;
use frictiongen_kernel::Float;

/// The fewest buckets: these are never too many.
const FEWEST: usize = 8;
/// The numbers of buckets that are tried: powers of two, so that a lookup finds one without a comparison.
const BUCKETS: [usize; 8] = [FEWEST, 16, 32, 64, 128, 256, 512, 1024];
/// There are no more buckets than this for each number in the pieces: they would outweigh what they save.
const CROWDED: usize = 1;
/// So many halvings are cheap enough for more buckets not to pay.
const FEW: u32 = 2;

/// Buckets over a range.
#[derive(Clone, Debug)]
pub struct Index<S> {
    /// Where the first bucket begins.
    pub low: S,
    /// Buckets to a unit of r.
    pub density: S,
    /// How many comparisons find a piece among those of a bucket.
    pub halvings: u32,
    /// The piece in which each bucket begins.
    pub buckets: Vec<usize>,
}

impl<S: Float> Index<S> {
    /// The least index with few halvings; else the one with the fewest.
    pub(super) fn of(pieces: &[Fitted<S>], (low, high): (S, S)) -> Self {
        let mut best: Option<Self> = None;
        let numbers: usize = pieces.iter().map(Fitted::numbers).sum();
        for count in BUCKETS {
            if count > FEWEST && count > CROWDED * numbers {
                break;
            }
            let index = Self::with(pieces, (low, high), count);
            if best
                .as_ref()
                .is_none_or(|best| index.halvings < best.halvings)
            {
                best = Some(index);
            }
            if best.as_ref().is_some_and(|best| best.halvings <= FEW) {
                break;
            }
        }
        best.unwrap_or_else(|| Self::with(pieces, (low, high), 1))
    }

    fn with(pieces: &[Fitted<S>], (low, high): (S, S), count: usize) -> Self {
        let mut density = S::constant(count as f64 / (high - low).to_f64());
        // As a lookup computes it: rising with r, whatever the rounding, and the end within the last bucket.
        while ((high - low) * density).to_index() >= count {
            density = S::constant(density.to_f64() * (1.0 - S::EPSILON));
        }
        let bucket_of = |r: S| ((r - low) * density).to_index();
        let mut begins = vec![0_usize; count];
        let mut within = vec![0_usize; count];
        for (place, piece) in pieces.iter().enumerate().skip(1) {
            let bucket = bucket_of(piece.from);
            if let Some(within) = within.get_mut(bucket) {
                *within += 1;
            }
            for begins in begins.iter_mut().skip(bucket + 1) {
                *begins = place;
            }
        }
        let most = within.into_iter().max().unwrap_or(0);
        Self {
            low,
            density,
            halvings: usize::BITS - most.leading_zeros(),
            buckets: begins,
        }
    }
}

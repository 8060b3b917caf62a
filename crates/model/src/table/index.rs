//! Buckets of equal width, by which a lookup finds the polynomial piece that contains r.

use super::fit::Fitted;
use frictiongen_kernel::Float;

/// Smallest number of buckets of r, by which a lookup finds a piece. Even a table with few pieces has this number of
/// buckets.
const FEWEST: usize = 8;
/// Numbers of buckets of r that `Index::of` tries, in this order. With a power of two, a lookup computes its bucket
/// without a comparison.
const BUCKETS: [usize; 8] = [FEWEST, 16, 32, 64, 128, 256, 512, 1024];
/// Largest number of buckets of r, as a multiple of the count of numbers in the polynomial pieces. More buckets would
/// save too few comparisons for their memory.
const CROWDED: usize = 1;
/// Number of comparisons in a lookup that is small enough. More buckets would reduce this number further, but would
/// need too much memory.
const FEW: u32 = 2;

/// Buckets that divide a range of r into equal parts, by which a lookup finds the polynomial piece that contains r.
#[derive(Clone, Debug)]
pub struct Index<S> {
    /// The r at which the first bucket begins.
    pub low: S,
    /// Number of buckets per unit of r.
    pub density: S,
    /// Number of comparisons by which a lookup finds the polynomial piece within a bucket.
    pub halvings: u32,
    /// Index of the polynomial piece that contains the start of each bucket.
    pub buckets: Vec<usize>,
}

impl<S: Float> Index<S> {
    /// Returns the smallest set of buckets with which a lookup needs at most `FEW` comparisons. If no tried number of
    /// buckets suffices, returns the set that needs the fewest comparisons.
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
        // The code computes the bucket as a lookup does. Despite rounding, the bucket number does not fall as r
        // rises. The upper bound of the range must be in the last bucket.
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

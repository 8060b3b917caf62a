//! Piecewise polynomials, found by a bucket and a few halvings.

use crate::number::scalar::Float;

/// One piece: `F` functions as polynomials of degree `C` − 1 in r − origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece<S, const F: usize, const C: usize> {
    /// The smallest r of the piece; it ends where the next one begins.
    pub from: S,
    /// From where r is counted.  Beside a zero it is the zero: relative accuracy then holds up to it.
    pub origin: S,
    /// Of each function the coefficients, from the constant on.
    pub coefficients: [[S; C]; F],
}

/// Functions of r over a range, by pieces.
///
/// A lookup has no branch that depends on r: a bucket names a first piece, and `halvings` comparisons the right one.
#[derive(Clone, Copy, Debug)]
pub struct Table<'a, S, B, const F: usize, const C: usize> {
    /// Where the first bucket begins.
    pub low: S,
    /// Buckets to a unit of r.
    pub density: S,
    /// How many comparisons find a piece among those of a bucket: at most 2^halvings − 1 begin within one.
    pub halvings: u32,
    /// The piece in which each bucket begins.
    pub buckets: &'a [B],
    /// The pieces, ascending.
    pub pieces: &'a [Piece<S, F, C>],
}

impl<S: Float, B: Copy + Into<usize>, const F: usize, const C: usize> Table<'_, S, B, F, C> {
    /// The piece that holds r: the first or the last one outside the range, none if there are no pieces.
    #[inline]
    #[must_use]
    pub fn piece(&self, r: S) -> Option<&Piece<S, F, C>> {
        let bucket = ((r - self.low) * self.density).to_index();
        let bucket = bucket.min(self.buckets.len().saturating_sub(1));
        let mut index: usize = self.buckets.get(bucket).copied().map_or(0, Into::into);
        let mut halving = self.halvings;
        while halving > 0 {
            halving -= 1;
            let further = index + (1 << halving);
            let begins = self
                .pieces
                .get(further)
                .is_some_and(|piece| piece.from <= r);
            index = if begins { further } else { index };
        }
        self.pieces.get(index)
    }

    /// All functions at r; NaN if there are no pieces.
    #[inline]
    #[must_use]
    pub fn values(&self, r: S) -> [S; F] {
        match self.piece(r) {
            Some(piece) => piece
                .coefficients
                .map(|of| polynomial(&of, r - piece.origin)),
            None => [S::constant(f64::NAN); F],
        }
    }

    /// The first function at r; NaN if there are no pieces.
    #[inline]
    #[must_use]
    pub fn first(&self, r: S) -> S {
        let piece = self.piece(r);
        let first = piece.and_then(|piece| Some((piece.coefficients.first()?, piece.origin)));
        match first {
            Some((of, origin)) => polynomial(of, r - origin),
            None => S::constant(f64::NAN),
        }
    }
}

/// Σ c_k t^k: pairs c_2k + c_2k+1·t, then by t² from the highest pair down.
#[inline]
#[must_use]
pub fn polynomial<S: Float>(coefficients: &[S], t: S) -> S {
    let square = t * t;
    let (pairs, last) = coefficients.as_chunks::<2>();
    let mut sum = last.first().copied();
    for [even, odd] in pairs.iter().rev() {
        let pair = *even + *odd * t;
        sum = Some(match sum {
            Some(higher) => pair + higher * square,
            None => pair,
        });
    }
    sum.unwrap_or(S::constant(0.0))
}

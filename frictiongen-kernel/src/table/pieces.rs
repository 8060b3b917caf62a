//! Piecewise polynomials. A bucket and a few halvings find the piece that contains r.

use crate::number::scalar::Float;

/// One piece, with `F` functions as polynomials of degree `C` − 1 in r − origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece<S, const F: usize, const C: usize> {
    /// Smallest r of the piece. The piece ends where the next one begins.
    pub from: S,
    /// Origin from which r is counted. Near a zero of a function it is the zero, so that the relative accuracy is kept
    /// up to the zero.
    pub origin: S,
    /// Coefficients of each function, from the constant term upwards.
    pub coefficients: [[S; C]; F],
}

/// Functions of r over a range, in pieces.
///
/// A lookup has no branch that depends on r. A bucket names a first piece, and `halvings` comparisons find the right
/// one.
#[derive(Clone, Copy, Debug)]
pub struct Table<'a, S, B, const F: usize, const C: usize> {
    /// Start of the first bucket.
    pub low: S,
    /// Number of buckets per unit of r.
    pub density: S,
    /// Number of comparisons that find a piece among those of a bucket. At most 2^halvings − 1 pieces begin within one
    /// bucket.
    pub halvings: u32,
    /// Index of the piece in which each bucket begins. The number of buckets is a power of two.
    pub buckets: &'a [B],
    /// Pieces in ascending order.
    pub pieces: &'a [Piece<S, F, C>],
}

impl<S: Float, B: Copy + Into<usize>, const F: usize, const C: usize> Table<'_, S, B, F, C> {
    /// Returns the piece that contains r. Outside the range it is an arbitrary piece. Returns `None` if there are no
    /// pieces.
    #[inline(always)]
    #[must_use]
    pub fn piece(&self, r: S) -> Option<&Piece<S, F, C>> {
        let bucket = ((r - self.low) * self.density).to_index();
        let bucket = bucket & self.buckets.len().wrapping_sub(1);
        let first: usize = self.buckets.get(bucket).copied().map_or(0, Into::into);
        // Where the number of halvings is a constant, the compiler keeps one of these arms, without branches.
        match self.halvings {
            0 => self.pieces.get(first),
            1 => self.among::<2>(first, r),
            2 => self.among::<4>(first, r),
            3 => self.among::<8>(first, r),
            4 => self.among::<16>(first, r),
            5 => self.among::<32>(first, r),
            _ => self.onwards(first, r),
        }
    }

    /// Returns the piece that contains r, among the `W` pieces from `first` on, or among the last `W` if fewer follow.
    #[inline(always)]
    fn among<const W: usize>(&self, first: usize, r: S) -> Option<&Piece<S, F, C>> {
        let first = first.min(self.pieces.len().saturating_sub(W));
        let window = self.pieces.get(first..first + W);
        match window.and_then(<[_]>::first_chunk::<W>) {
            Some(window) if cfg!(target_pointer_width = "32") => halved(window, r),
            Some(window) => window.get(counted(window, r)),
            None => self.onwards(first, r),
        }
    }

    /// Returns the piece that contains r, from `first` on, with `halvings` halvings in a loop.
    fn onwards(&self, first: usize, r: S) -> Option<&Piece<S, F, C>> {
        let mut index = first;
        let mut halving = self.halvings;
        while halving > 0 {
            halving -= 1;
            let further = index + (1 << halving);
            let begins = self
                .pieces
                .get(further)
                .is_some_and(|piece| piece.from.at_most(r));
            index = if begins { further } else { index };
        }
        self.pieces.get(index)
    }

    /// Returns all functions at r; NaN if there are no pieces.
    #[inline(always)]
    #[must_use]
    pub fn values(&self, r: S) -> [S; F] {
        let mut values = [S::constant(f64::NAN); F];
        if let Some(piece) = self.piece(r) {
            // Written out instead of a loop, so that the compiler removes a function whose value is not used.
            let t = r - piece.origin;
            put(&mut values, piece, 0, t);
            put(&mut values, piece, 1, t);
            put(&mut values, piece, 2, t);
            put(&mut values, piece, 3, t);
            put(&mut values, piece, 4, t);
            for function in 5..F {
                put(&mut values, piece, function, t);
            }
        }
        values
    }

    /// Returns the first function at r; NaN if there are no pieces.
    #[inline(always)]
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

/// Returns the piece of a window that contains r, by halving. This takes the fewest instructions.
#[inline(always)]
fn halved<S: Float, const F: usize, const C: usize, const W: usize>(
    window: &[Piece<S, F, C>; W],
    r: S,
) -> Option<&Piece<S, F, C>> {
    let mut pieces: &[Piece<S, F, C>] = window;
    if W > 16 {
        pieces = half(pieces, r);
    }
    if W > 8 {
        pieces = half(pieces, r);
    }
    if W > 4 {
        pieces = half(pieces, r);
    }
    if W > 2 {
        pieces = half(pieces, r);
    }
    half(pieces, r).first()
}

/// Returns the half of the given pieces that contains r.
#[inline(always)]
fn half<S: Float, const F: usize, const C: usize>(
    pieces: &[Piece<S, F, C>],
    r: S,
) -> &[Piece<S, F, C>] {
    match pieces.split_at_checked(pieces.len() / 2) {
        Some((left, right)) => {
            let begins = right.first().is_some_and(|piece| piece.from.at_most(r));
            if begins { right } else { left }
        }
        None => pieces,
    }
}

/// Returns the index in a window of the piece that contains r, by counting in quarters the pieces that begin at or
/// below r.
///
/// A compiler turns halving into branches. A large processor cannot predict such branches for an arbitrary r, and each
/// waits for the one before. The comparisons of a count do not wait for one another.
#[inline(always)]
fn counted<S: Float, const F: usize, const C: usize, const W: usize>(
    window: &[Piece<S, F, C>; W],
    r: S,
) -> usize {
    let begun = |place: usize| {
        let piece = window.get(place);
        usize::from(piece.is_some_and(|piece| piece.from.at_most(r)))
    };
    let quarters = |from: usize, step: usize| {
        step * (begun(from + step) + begun(from + 2 * step) + begun(from + 3 * step))
    };
    match W {
        32 => {
            let coarse = quarters(0, 8);
            let fine = coarse + quarters(coarse, 2);
            fine + begun(fine + 1)
        }
        16 => {
            let coarse = quarters(0, 4);
            coarse + quarters(coarse, 1)
        }
        8 => {
            let coarse = quarters(0, 2);
            coarse + begun(coarse + 1)
        }
        4 => quarters(0, 1),
        _ => begun(1),
    }
}

/// Evaluates one function of the piece, if it has a function with this index.
#[inline(always)]
fn put<S: Float, const F: usize, const C: usize>(
    values: &mut [S; F],
    piece: &Piece<S, F, C>,
    function: usize,
    t: S,
) {
    if let (Some(value), Some(of)) = (values.get_mut(function), piece.coefficients.get(function)) {
        *value = polynomial(of, t);
    }
}

/// Returns Σ c_k t^k. It forms the pairs c_2k + c_2k+1·t, and multiplies by t² from the highest pair downwards.
///
/// Up to degree 9 it is written out without a loop, so that code compiled for size has no loop.
#[inline(always)]
#[must_use]
pub fn polynomial<S: Float>(coefficients: &[S], t: S) -> S {
    let square = t * t;
    let mut sum = None;
    if coefficients.len() > 10 {
        for first in (5..coefficients.len().div_ceil(2)).rev() {
            sum = below(coefficients, 2 * first, t, square, sum);
        }
    }
    sum = below(coefficients, 8, t, square, sum);
    sum = below(coefficients, 6, t, square, sum);
    sum = below(coefficients, 4, t, square, sum);
    sum = below(coefficients, 2, t, square, sum);
    sum = below(coefficients, 0, t, square, sum);
    sum.unwrap_or(S::constant(0.0))
}

/// Returns the pair that begins at the coefficient `first`, plus t² times the sum of the higher pairs.
#[inline(always)]
fn below<S: Float>(
    coefficients: &[S],
    first: usize,
    t: S,
    square: S,
    higher: Option<S>,
) -> Option<S> {
    let Some(even) = coefficients.get(first) else {
        return higher;
    };
    let pair = match coefficients.get(first + 1) {
        Some(odd) => *even + *odd * t,
        None => *even,
    };
    Some(match higher {
        Some(higher) => pair + higher * square,
        None => pair,
    })
}

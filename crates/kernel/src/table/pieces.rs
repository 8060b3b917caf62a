//! Tables of piecewise polynomials in the frequency ratio r. Each table divides its range of r into buckets of equal
//! width. A lookup first finds the bucket of r. A few comparisons of r with the starts of the bucket's pieces then
//! select the polynomial that is valid at r.

use crate::number::scalar::Float;

/// One interval of the frequency ratio r. In this interval `F` functions are polynomials of degree `C` − 1 in r −
/// `origin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece<S, const F: usize, const C: usize> {
    /// Smallest frequency ratio r of the interval. The interval ends where the next interval begins.
    pub from: S,
    /// Origin of the polynomials, which are polynomials in r − `origin`. Near a zero of a function the origin is this
    /// zero, so that the polynomial has full relative accuracy close to the zero.
    pub origin: S,
    /// Polynomial coefficients of each function, starting with the constant term.
    pub coefficients: [[S; C]; F],
}

/// Table of `F` functions of the frequency ratio r over a range of r, as piecewise polynomials.
///
/// A lookup makes the same number of comparisons for every r. It takes the index of a first piece from the bucket of
/// r. The piece that contains r is one of the 2^`halvings` pieces from this index on.
#[derive(Clone, Copy, Debug)]
pub struct Table<'a, S, B, const F: usize, const C: usize> {
    /// Smallest frequency ratio r of the table, at which the first bucket starts.
    pub low: S,
    /// Number of buckets per unit of the frequency ratio r. All buckets have the same width.
    pub density: S,
    /// Number of times that a lookup halves the list of a bucket's polynomial pieces until one piece is left. At most
    /// 2^halvings − 1 pieces begin in one bucket. On processors with other than 32-bit pointers, the lookup may count
    /// pieces instead of halving.
    pub halvings: u32,
    /// For each bucket, the index of the polynomial piece that contains the start of the bucket. The number of buckets
    /// is a power of two.
    pub buckets: &'a [B],
    /// Polynomial pieces in the order of increasing r.
    pub pieces: &'a [Piece<S, F, C>],
}

impl<S: Float, B: Copy + Into<usize>, const F: usize, const C: usize> Table<'_, S, B, F, C> {
    /// Returns the polynomial piece that contains the frequency ratio r. For an r outside the range of the table, the
    /// result is an arbitrary piece. Returns `None` if the table has no pieces.
    #[inline(always)]
    #[must_use]
    pub fn piece(&self, r: S) -> Option<&Piece<S, F, C>> {
        let bucket = ((r - self.low) * self.density).to_index();
        let bucket = bucket & self.buckets.len().wrapping_sub(1);
        let first: usize = self.buckets.get(bucket).copied().map_or(0, Into::into);
        // If the number of halvings is known at compile time, the compiler keeps only the match arm for this number,
        // without branches.
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

    /// Returns the polynomial piece that contains the frequency ratio r. The function searches among the `W` pieces
    /// that start at the index `first`. If the table ends earlier, it searches among the last `W` pieces of the table.
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

    /// Returns the polynomial piece that contains the frequency ratio r. The function halves the list of pieces from
    /// the index `first` on, in `halvings` steps.
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

    /// Returns the values of all functions of the table at the frequency ratio r. All values are NaN if the table has
    /// no pieces.
    #[inline(always)]
    #[must_use]
    pub fn values(&self, r: S) -> [S; F] {
        let mut values = [S::constant(f64::NAN); F];
        if let Some(piece) = self.piece(r) {
            // The code makes these calls without a loop. The compiler then removes each function whose value is not
            // used.
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

    /// Returns the value of the table's first function at the frequency ratio r, or NaN if the table has no pieces.
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

/// Returns the polynomial piece that contains the frequency ratio r, among `W` consecutive pieces. The function halves
/// the list in each step. Halving takes fewer instructions than counting the pieces below r.
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

/// Returns the half of the given polynomial pieces that contains the frequency ratio r. The result is the first half or
/// the second half.
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

/// Returns the index of the polynomial piece that contains the frequency ratio r, in a window of `W` pieces. The
/// function counts the pieces that begin at or below r, first in coarse steps and then in fine steps.
///
/// A compiler turns halving into branches. A large processor cannot predict these branches for an arbitrary r, and each
/// branch waits for the previous branch. In counting, the comparisons do not wait for one another.
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

/// Evaluates one function of a polynomial piece at t = r − `origin`. Writes the value into `values` at the index
/// `function`. If the piece has no function at this index, `values` does not change.
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

/// Returns the polynomial Σ c_k t^k. The function computes the pairs c_2k + c_2k+1·t. It starts with the highest pair,
/// multiplies the sum by t² and adds the next lower pair.
///
/// For a degree of up to 9 the code contains no loop, even if it is compiled for size.
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

/// Makes one step in the evaluation of a polynomial. Returns c_k + c_k+1·t + t²·`higher`, where `higher` is the result
/// for the higher coefficients and k is `first`. If the polynomial has no coefficient c_k, the result is `higher`.
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

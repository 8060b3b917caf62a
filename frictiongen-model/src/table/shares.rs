//! What fit, check and rounding take of an accuracy.

use super::cover::Cover;
use super::errors::Comparison;
use super::exact::Exact;
use super::fit::Form;
use super::request::Request;
use super::split::Landmarks;
use super::worst::Worst;
use crate::scene::Side;
use frictiongen_kernel::Float;
use frictiongen_kernel::table::Quotient;

/// Of the accuracy the fit takes this share: the rest is for the points between those that it looks at.
const SHARE: f64 = 0.75;
/// The check allows this share: between its points an error may be larger.
const CHECKED: f64 = 0.9;
/// With `side: safe` a table lies half the accuracy off, and strays by less than this share.
const SAFE_SHARE: f64 = 0.4;
/// Of the accuracy the decimals of a coefficient may take this share.
const ROUNDING: f64 = 1e-3;
/// No table has more pieces.
const MOST_PIECES: usize = 20_000;

/// A cover before its first piece.
pub(super) fn cover<'a, 'm, S: Float>(
    exact: &'a mut Exact<'m>,
    landmarks: Landmarks,
    request: &Request,
    (functions, terms): (usize, usize),
    excitation: Option<Quotient<'a, S>>,
) -> Cover<'a, 'm, S> {
    let accuracy = request.accuracy;
    // Safe: β_lim from below, half the accuracy off.
    let (side_factor, share, whole) = match request.side {
        Side::Near => (1.0, SHARE, CHECKED * accuracy),
        Side::Safe => (1.0 - 0.5 * accuracy, SAFE_SHARE, 0.5 * CHECKED * accuracy),
    };
    Cover {
        comparison: Comparison {
            exact,
            landmarks,
            form: Form {
                functions,
                terms,
                side_factor,
                rounding: ROUNDING * accuracy,
            },
            limit: share * accuracy,
            motion: SHARE * accuracy,
            excitation,
        },
        kinks: Vec::new(),
        whole: (whole, CHECKED * accuracy),
        most_pieces: MOST_PIECES,
        last: 0.0,
    }
}

/// An error over what the check allows, as a relative error.
pub(super) fn relative(worst: Worst, request: &Request) -> Worst {
    let error = match request.side {
        Side::Near => worst.error * CHECKED * request.accuracy,
        Side::Safe => 0.5 * request.accuracy * (1.0 + CHECKED * worst.error),
    };
    Worst { error, ..worst }
}

//! Fractions of the requested accuracy that the fit, the check and the rounding of a table may take.

use super::cover::Cover;
use super::errors::Comparison;
use super::exact::Exact;
use super::fit::FitSettings;
use super::request::Request;
use super::split::Landmarks;
use super::worst::Worst;
use crate::scene::Side;
use frictiongen_kernel::Float;
use frictiongen_kernel::table::Quotient;

/// Fraction of the accuracy that the error of a fitted polynomial may take at the points of the fit. The rest is for
/// frequency ratios between these points.
const SHARE: f64 = 0.75;
/// Fraction of the accuracy that the error of a table may take at the points of the check. The rest is for larger
/// errors between these points.
const CHECKED: f64 = 0.9;
/// Fraction of the accuracy that the fit may take with `side: safe`. The fit then aims at a value that is below the
/// exact limit by half the accuracy.
const SAFE_SHARE: f64 = 0.4;
/// Fraction of the accuracy that may be lost if a coefficient is rounded to decimals.
const ROUNDING: f64 = 1e-3;
/// Largest number of polynomial pieces in a table.
const MOST_PIECES: usize = 20_000;

/// Returns the settings for polynomial pieces that meet a request: the allowed errors, the number of functions and the
/// number of coefficients. The result contains no pieces yet.
pub(super) fn cover<'a, 'm, S: Float>(
    exact: &'a mut Exact<'m>,
    landmarks: Landmarks,
    request: &Request,
    (functions, terms): (usize, usize),
    excitation: Option<Quotient<'a, S>>,
) -> Cover<'a, 'm, S> {
    let accuracy = request.accuracy;
    // With `side: safe`, the fit aims half the accuracy below β_lim.
    let (side_factor, share, whole) = match request.side {
        Side::Near => (1.0, SHARE, CHECKED * accuracy),
        Side::Safe => (1.0 - 0.5 * accuracy, SAFE_SHARE, 0.5 * CHECKED * accuracy),
    };
    Cover {
        comparison: Comparison {
            exact,
            landmarks,
            form: FitSettings {
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

/// Converts an error, given as a multiple of the error that the check allows, to a relative error.
pub(super) fn relative(worst: Worst, request: &Request) -> Worst {
    let error = match request.side {
        Side::Near => worst.error * CHECKED * request.accuracy,
        Side::Safe => 0.5 * request.accuracy * (1.0 + CHECKED * worst.error),
    };
    Worst { error, ..worst }
}

//! Searches an interval by golden sections, without derivatives.

/// Larger of the two fractions into which a golden section divides an interval.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Returns the position and the value of the minimum of the function `of` between `low` and `high`. The search takes
/// at most `steps` golden sections, and ends earlier if the interval is shorter than `width`.
///
/// # Errors
/// The first error that the function `of` returns.
pub(crate) fn smallest<E>(
    (mut low, mut high): (f64, f64),
    (steps, width): (usize, f64),
    mut of: impl FnMut(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    let (mut left, mut right) = (high - (high - low) * GOLDEN, low + (high - low) * GOLDEN);
    let (mut at_left, mut at_right) = (of(left)?, of(right)?);
    for _ in 0..steps {
        if high - low < width {
            break;
        }
        if at_right < at_left {
            (low, left, at_left) = (left, right, at_right);
            right = low + (high - low) * GOLDEN;
            at_right = of(right)?;
        } else {
            (high, right, at_right) = (right, left, at_left);
            left = high - (high - low) * GOLDEN;
            at_left = of(left)?;
        }
    }
    Ok(if at_right < at_left {
        (right, at_right)
    } else {
        (left, at_left)
    })
}

/// Searches for a position between `low` and `high` whose value is `enough`, and goes towards the larger value. Returns
/// `None` if `steps` golden sections find no such position.
pub(super) fn reached(
    [mut low, mut high]: [f64; 2],
    steps: usize,
    value: impl Fn(f64) -> f64,
    enough: impl Fn(f64) -> bool,
) -> Option<f64> {
    for _ in 0..steps {
        let (left, right) = (high - (high - low) * GOLDEN, low + (high - low) * GOLDEN);
        let (at_left, at_right) = (value(left), value(right));
        match (enough(at_left), enough(at_right)) {
            (true, _) => return Some(left),
            (_, true) => return Some(right),
            _ if at_left < at_right => low = left,
            _ => high = right,
        }
    }
    None
}

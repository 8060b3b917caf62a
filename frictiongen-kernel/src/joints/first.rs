//! The first instant at which a power series becomes negative.

use super::{ORDERS, Series, whole};
use crate::number::scalar::Float;

/// Halvings of the stretch after which two zeros count as a touch.
const HALVINGS: usize = 30;
/// Steps of the iteration for a zero. Each step at least halves the bracket every second time.
const REFINEMENTS: usize = 128;
/// Number of coefficients of the series that are known for every event.
const KNOWN: usize = ORDERS;
/// Roundings of the largest coefficient below which a leading coefficient of a fresh event is 0.
const ROUNDINGS: f64 = 256.0;

type Points<T> = [T; KNOWN];

/// Returns the first u in [0, `most`] at which the series becomes negative.
///
/// A series of a contact that has just had an event starts at 0.  Its leading coefficients are zeros with roundings.
/// With `fresh`, rounding errors of its first three coefficients and of
/// all that follow, they count as zeros.
pub(super) fn first_negative<T: Float>(
    series: &Series<T>,
    most: T,
    fresh: Option<[T; 3]>,
) -> Option<T> {
    let zero = T::constant(0.0);
    let mut powers = [zero; KNOWN];
    let mut factor = T::constant(1.0);
    for (power, &term) in powers.iter_mut().zip(series) {
        *power = term * factor;
        factor = factor * most;
    }
    if let Some(floors) = fresh {
        let scale = series
            .iter()
            .take(KNOWN)
            .fold(zero, |scale, term| scale.max(term.abs()));
        let least = scale * T::constant(ROUNDINGS * T::EPSILON);
        let later = core::iter::repeat(floors.last().copied().unwrap_or(zero));
        let floors = floors.into_iter().chain(later);
        for ((power, term), floor) in powers.iter_mut().zip(series).zip(floors) {
            if least.max(floor) < term.abs() {
                break;
            }
            *power = zero;
        }
    }
    let first = powers.first().copied()?;
    let others = powers
        .iter()
        .skip(1)
        .fold(zero, |sum, power| sum + power.abs());
    if others < first {
        return None;
    }
    let mut points = powers;
    for (k, point) in points.iter_mut().enumerate() {
        *point = *point / binomial(KNOWN - 1, k);
    }
    for round in 1..KNOWN {
        let mut earlier = zero;
        for (index, point) in points.iter_mut().enumerate() {
            let here = *point;
            if index >= round {
                *point = here + earlier;
            }
            earlier = here;
        }
    }
    search(&powers, &points, (zero, T::constant(1.0)), HALVINGS).map(|u| u * most)
}

/// Returns the number of ways to choose `k` of `n`.
fn binomial<T: Float>(n: usize, k: usize) -> T {
    (0..k).fold(T::constant(1.0), |product, i| {
        product * whole(n - i) / whole(i + 1)
    })
}

/// Searches the part (start, width) of the stretch, whose Bernstein coefficients are `points`.
fn search<T: Float>(
    powers: &Points<T>,
    points: &Points<T>,
    (start, width): (T, T),
    halvings: usize,
) -> Option<T> {
    let zero = T::constant(0.0);
    let negative = |point: &T| *point < zero;
    if points.first().is_some_and(negative) {
        return Some(start);
    }
    if !points.iter().any(negative) {
        return None;
    }
    let pairs = points.iter().zip(points.iter().skip(1));
    let changes = pairs.filter(|&(a, b)| negative(a) != negative(b)).count();
    if changes == 1 {
        return Some(zero_between(powers, start, start + width));
    }
    let halvings = match halvings.checked_sub(1) {
        Some(halvings) => halvings,
        None => return points.last().is_some_and(negative).then_some(start),
    };
    let half = T::constant(0.5);
    let left = first_half(points);
    let mut right = *points;
    right.reverse();
    let mut right = first_half(&right);
    right.reverse();
    let middle = start + half * width;
    search(powers, &left, (start, half * width), halvings)
        .or_else(|| search(powers, &right, (middle, half * width), halvings))
}

/// Returns the Bernstein coefficients of the first half, by de Casteljau's scheme.
fn first_half<T: Float>(points: &Points<T>) -> Points<T> {
    let (zero, half) = (T::constant(0.0), T::constant(0.5));
    let (mut found, mut rest) = ([zero; KNOWN], *points);
    for place in &mut found {
        *place = rest.first().copied().unwrap_or(zero);
        let mut before: Option<&mut T> = None;
        for point in &mut rest {
            if let Some(before) = before {
                *before = half * (*before + *point);
            }
            before = Some(point);
        }
    }
    found
}

/// Returns the zero between `low`, where the polynomial is at least 0, and `high`, where it is negative.
fn zero_between<T: Float>(powers: &Points<T>, mut low: T, mut high: T) -> T {
    let zero = T::constant(0.0);
    let half = T::constant(0.5);
    let mut u = half * (low + high);
    for round in 0..REFINEMENTS {
        let (mut value, mut slope) = (zero, zero);
        for &power in powers.iter().rev() {
            slope = slope * u + value;
            value = value * u + power;
        }
        if value < zero {
            high = u
        } else {
            low = u
        }
        let newton = u - value / slope;
        let inside = low < newton && newton < high;
        let next = if inside && round % 3 != 2 {
            newton
        } else {
            half * (low + high)
        };
        if (next - u).abs() <= T::constant(T::EPSILON) * (next.abs() + T::constant(T::EPSILON)) {
            return next;
        }
        if inside && (newton - u).abs() <= T::constant(T::EPSILON) * newton.abs() {
            return newton;
        }
        u = next;
    }
    u
}

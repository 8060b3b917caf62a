//! The kinetic friction force as a function of the sliding speed: straight lines between points.

use crate::number::scalar::Float;

/// One straight line of the friction law, between two speeds. On this line the friction force divided by F is level +
/// slope·|v|, where v is the relative velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KineticLine<S> {
    pub level: S,
    pub slope: S,
    /// Sliding speed at which this line of the friction law starts.
    pub low: S,
    /// Sliding speed at which this line of the friction law ends, or `None` for the last line.
    pub high: Option<S>,
}

/// Returns the straight line of the friction law with the index `place`. A law without points (Coulomb's law) has one
/// line.
#[inline(always)]
pub(crate) fn line<S: Float>(points: &[[S; 2]], place: usize) -> KineticLine<S> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    if points.is_empty() {
        return KineticLine {
            level: one,
            slope: zero,
            low: zero,
            high: None,
        };
    }
    between(points, place)
}

/// Returns the straight line with the index `place` of a friction law that has points.
fn between<S: Float>(points: &[[S; 2]], place: usize) -> KineticLine<S> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let [low, first] = match place.checked_sub(1) {
        None => [zero, one],
        Some(before) => points.get(before).copied().unwrap_or([zero, one]),
    };
    match points.get(place) {
        None => KineticLine {
            level: first,
            slope: zero,
            low,
            high: None,
        },
        Some([high, last]) => {
            let slope = (*last - first) / (*high - low);
            KineticLine {
                level: first - slope * low,
                slope,
                low,
                high: Some(*high),
            }
        }
    }
}

/// Returns the index of the straight line of the friction law that contains a sliding speed.
pub(crate) fn place<S: Float>(points: &[[S; 2]], speed: S) -> usize {
    points.iter().take_while(|[v, _]| *v <= speed).count()
}

/// Returns the largest absolute slope of the friction law.
pub(crate) fn steepest<S: Float>(points: &[[S; 2]]) -> S {
    let slopes = (0..points.len()).map(|place| line(points, place).slope.abs());
    slopes.fold(S::constant(0.0), S::max)
}

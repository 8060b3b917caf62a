//! Frequencies at which friction does not change a motion, ranges in which it enlarges the motion, and frequencies at
//! which the motion vanishes without friction. All three exist only for chains without damping.

use super::functions::Target;
use super::isolate::{Crowded, Function, Zero};
use super::sensed::Sensed;
use super::{FeatureError, Features, check_range};
use crate::Of;
use frictiongen_kernel::number::dd::Dd;

/// The quantity of a motion that friction may leave unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measured {
    /// The amplitude. For the contact's motion it is exact (6.9), for another mass it is the estimate (5.50, 6.10).
    Amplitude,
    /// The fundamental component, exact. It is the frequency-based transmissibility (4.4).
    Fundamental,
}

/// The equation that makes a point invariant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Condition {
    /// U = 0 or U_k = 0 (6.9).
    Quadrature,
    /// V U_k = 2 V_k U (6.10).
    Estimate,
    /// H_k = 0. The mass does not respond to a harmonic force in the contact.
    Receptance,
    /// V_k U = −(2/π) H_k V. For the contact, U = −(2/π)H.
    Balance,
}

/// A frequency at which every friction with a continuously sliding contact gives the same value.
#[derive(Clone, Debug, PartialEq)]
pub struct InvariantPoint {
    /// Frequency ratio r.
    pub r: f64,
    /// Frequency, in Hz under a load.
    pub frequency: Sensed,
    /// Equation that the point satisfies.
    pub condition: Condition,
    /// True if the phase is invariant too. The phase of the contact's motion at U = 0 is 0 or π.
    pub phase_too: bool,
    /// The amplitude |V_k| at the point, in m under a load.
    pub amplitude: f64,
    /// β_lim at the point, in N under a load. The point is invariant up to this friction.
    pub continuous_limit: f64,
    /// True if the function of the condition crosses 0. False if it touches 0, or if two points are within 1e-9.
    pub simple: bool,
}

/// The kind of bound of a range in which friction enlarges a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// The bound of the requested range.
    Range,
    /// An invariant point.
    Invariant,
    /// A pole of the damping function or of the response.
    Pole,
    /// V = 0. Without friction the contact does not move, and any friction stops it.
    Still,
}

/// A range in which more friction enlarges a motion, as long as the contact slides all the time.
#[derive(Clone, Debug, PartialEq)]
pub struct Inversion {
    /// Lower bound, as frequency ratio r.
    pub from: f64,
    /// Kind of the lower bound.
    pub from_edge: Edge,
    /// Upper bound, as frequency ratio r.
    pub to: f64,
    /// Kind of the upper bound.
    pub to_edge: Edge,
}

/// A frequency at which a motion vanishes without friction. The thesis calls it ω₀ for a mass and ω_z0 for the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Antiresonance {
    /// Frequency ratio r.
    pub r: f64,
    /// Frequency, in Hz under a load.
    pub frequency: Sensed,
}

/// If β_lim is below this value, V is 0 to rounding, and no friction lets the contact slide.
const STILL: f64 = 1e-10;
/// Points of two conditions within this relative distance count as one.
const SAME: f64 = 1e-13;

fn targets(measured: Measured, is_contact: bool) -> &'static [(Condition, Target<Dd>)] {
    match (measured, is_contact) {
        (Measured::Amplitude, true) => &[(Condition::Quadrature, Target::Quadrature)],
        (Measured::Amplitude, false) => &[
            (Condition::Quadrature, Target::Quadrature),
            (Condition::Estimate, Target::Estimate),
        ],
        (Measured::Fundamental, _) => &[
            (Condition::Receptance, Target::Receptance),
            (Condition::Balance, Target::Fundamental),
        ],
    }
}

impl Features<'_> {
    /// Returns all frequencies at which the motion vanishes without friction, ascending. V_k = 0 there, or V = 0 for
    /// the contact.
    ///
    /// # Errors
    /// [`FeatureError::Damped`], because a damped motion is only smallest there, not 0. [`FeatureError::Range`],
    /// [`FeatureError::UnknownMass`], [`FeatureError::Crowded`].
    pub fn antiresonances(
        &self,
        of: Of,
        range: [f64; 2],
    ) -> Result<Vec<Antiresonance>, FeatureError> {
        let function = self.function(of, range, Target::Free)?;
        let zeros = function.zeros(range)?;
        let of = |zero: Zero| Antiresonance {
            r: zero.r(),
            frequency: self.variations.of_zero(&function, &zero, None),
        };
        Ok(zeros.into_iter().map(of).collect())
    }

    /// Returns all invariant points of a motion in the range, ascending. At each of them `measured` does not depend on
    /// friction, as long as the contact slides all the time. The list is empty for a motion that friction does not
    /// reach.
    ///
    /// # Errors
    /// [`FeatureError::Damped`]: for a damped chain see the [`crossings`](Self::crossings) of two frictions.
    /// [`FeatureError::Range`], [`FeatureError::UnknownMass`], [`FeatureError::Crowded`].
    pub fn invariant_points(
        &self,
        of: Of,
        measured: Measured,
        range: [f64; 2],
    ) -> Result<Vec<InvariantPoint>, FeatureError> {
        let mass = self.mass_of(of)?;
        let free = self.function(of, range, Target::Free)?;
        let mut points = Vec::new();
        for (condition, target) in targets(measured, mass.is_none()) {
            let function = self.function(of, range, *target)?;
            for zero in function.zeros(range)? {
                let r = zero.r();
                let limit = self.continuous_limit(r);
                if !(STILL < limit) {
                    continue;
                }
                points.push(InvariantPoint {
                    r,
                    frequency: self.variations.of_zero(&function, &zero, None),
                    condition: *condition,
                    phase_too: mass.is_none() && measured == Measured::Amplitude,
                    // In the function's sums the amplitude has a factor r².
                    amplitude: self.variations.length(free.at(r).abs() / (r * r)),
                    continuous_limit: self.variations.friction(limit),
                    simple: zero.crosses,
                });
            }
        }
        points.sort_by(|a, b| a.r.total_cmp(&b.r));
        // For a mass in contact with the moving base U_k = U, so (6.10) is satisfied wherever (6.9) is.
        points.dedup_by(|b, a| {
            let same = a.condition != b.condition && (b.r - a.r).abs() <= SAME * a.r;
            if same && b.condition == Condition::Quadrature {
                a.condition = b.condition;
            }
            same
        });
        Ok(points)
    }

    /// Returns all ranges in which more friction enlarges `measured`, ascending. The contact slides all the time.
    ///
    /// A range may contain single frequencies at which no friction lets the contact slide all the time. They are poles
    /// of U, with β_lim = 0.
    ///
    /// # Errors
    /// Same errors as [`invariant_points`](Self::invariant_points).
    pub fn inversions(
        &self,
        of: Of,
        measured: Measured,
        range: [f64; 2],
    ) -> Result<Vec<Inversion>, FeatureError> {
        let mass = self.mass_of(of)?;
        let function = |target| self.function(of, range, target);
        let (free, own) = (function(Target::Free)?, function(Target::FreeContact)?);
        let all = targets(measured, mass.is_none());
        let mut functions = Vec::new();
        for (_, target) in all {
            functions.push(function(*target)?);
        }
        if functions.iter().any(Function::vanishes) {
            return Ok(Vec::new());
        }
        let mut edges: Vec<(f64, Edge)> = Vec::new();
        for function in &functions {
            edges.extend(places(function, range)?.map(|r| (r, Edge::Invariant)));
            let poles = function.poles(range)?;
            edges.extend(poles.iter().map(|pole| (1.0 / pole.y, Edge::Pole)));
        }
        edges.extend(places(&own, range)?.map(|r| (r, Edge::Still)));
        for pole in free.poles(range)? {
            edges.push((1.0 / pole.y, Edge::Pole));
        }
        let [from, to] = range;
        edges.retain(|(r, _)| from < *r && *r < to);
        edges.extend([(from, Edge::Range), (to, Edge::Range)]);
        // If two edges coincide, the one that prevents the motion counts.
        let rank = |edge: &Edge| match edge {
            Edge::Still => 0,
            Edge::Pole => 1,
            Edge::Range => 2,
            Edge::Invariant => 3,
        };
        edges.sort_by(|a, b| a.0.total_cmp(&b.0).then(rank(&a.1).cmp(&rank(&b.1))));
        // Zeros of two functions at one place differ by roundings, in either order.
        edges.dedup_by(|b, a| {
            let same = (b.0 - a.0).abs() <= SAME * a.0;
            if same && rank(&b.1) < rank(&a.1) {
                a.1 = b.1;
            }
            same
        });
        let growth = |r: f64| {
            let first = functions
                .first()
                .map_or(f64::NAN, |function| function.at(r));
            let second = functions.get(1).map(|function| function.at(r));
            match (measured, second) {
                // The growth is −U².
                (Measured::Amplitude, None) => -1.0,
                // The growth is U_k (V U_k − 2 V_k U)/V.
                (Measured::Amplitude, Some(second)) => first * second / own.at(r),
                // The growth is H_k (V_k U + (2/π) H_k V)/V, for the contact H (U + (2/π) H).
                (Measured::Fundamental, Some(second)) if mass.is_some() => {
                    first * second / own.at(r)
                }
                (Measured::Fundamental, Some(second)) => first * second,
                (Measured::Fundamental, None) => f64::NAN,
            }
        };
        let mut found: Vec<Inversion> = Vec::new();
        for pair in edges.windows(2) {
            let &[(from, from_edge), (to, to_edge)] = pair else {
                continue;
            };
            if !(0.0 < growth(0.5 * (from + to))) {
                continue;
            }
            match found.last_mut() {
                // The motion grows with friction on both sides of the edge.
                Some(last) if last.to == from => {
                    (last.to, last.to_edge) = (to, to_edge);
                }
                _ => found.push(Inversion {
                    from,
                    from_edge,
                    to,
                    to_edge,
                }),
            }
        }
        Ok(found)
    }

    /// Returns a function of a motion. Checks the range and that the chain is undamped.
    fn function(
        &self,
        of: Of,
        range: [f64; 2],
        target: Target<Dd>,
    ) -> Result<Function<'_>, FeatureError> {
        check_range(range)?;
        let mass = self.mass_of(of)?;
        let modal = self.system.modal();
        if modal.is_damped() {
            return Err(FeatureError::Damped);
        }
        Ok(Function::new(modal, mass, target))
    }
}

/// Returns the frequency ratios of a function's zeros.
fn places(function: &Function<'_>, range: [f64; 2]) -> Result<impl Iterator<Item = f64>, Crowded> {
    Ok(function.zeros(range)?.into_iter().map(|zero| zero.r()))
}

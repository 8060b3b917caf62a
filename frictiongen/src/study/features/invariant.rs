//! Frequencies at which friction does not change a motion, ranges in which it enlarges it, and those at which the motion
//! vanishes without friction.  All without damping.

use super::functions::Target;
use super::isolate::{Crowded, Function, Zero};
use super::sensed::Sensed;
use super::{FeatureError, Features, check_range};
use crate::Of;
use frictiongen_kernel::number::dd::Dd;

/// What is measured of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measured {
    /// The amplitude: of the contact's motion exact (6.9), of another mass the estimate (5.50, 6.10).
    Amplitude,
    /// The fundamental component, exact: the frequency-based transmissibility (4.4).
    Fundamental,
}

/// What makes a point invariant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Condition {
    /// U = 0 or U_k = 0 (6.9).
    Quadrature,
    /// V U_k = 2 V_k U (6.10).
    Estimate,
    /// H_k = 0: the mass does not answer to a harmonic force in the contact.
    Receptance,
    /// V_k U = −(2/π) H_k V; of the contact U = −(2/π)H.
    Balance,
}

/// A frequency at which every friction that lets the contact slide all the time gives the same.
#[derive(Clone, Debug, PartialEq)]
pub struct InvariantPoint {
    /// r.
    pub r: f64,
    /// In Hz under a load.
    pub frequency: Sensed,
    /// Why.
    pub condition: Condition,
    /// Whether the phase is invariant too: of the contact's motion at U = 0 it is 0 or π.
    pub phase_too: bool,
    /// |V_k|, the amplitude there: in m under a load.
    pub amplitude: f64,
    /// β_lim there, up to which it holds: in N under a load.
    pub continuous_limit: f64,
    /// Whether the condition's function crosses 0 there; otherwise it touches it, or two points are 1e-9 apart.
    pub simple: bool,
}

/// What is at the end of a range in which friction enlarges a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// The end of the range asked for.
    Range,
    /// An invariant point.
    Invariant,
    /// A pole of the damping function or of the response.
    Pole,
    /// V = 0: the contact is still without friction, and stops with any.
    Still,
}

/// A range in which more friction enlarges a motion, as long as the contact slides all the time.
#[derive(Clone, Debug, PartialEq)]
pub struct Inversion {
    /// Its lower end, r.
    pub from: f64,
    /// What is there.
    pub from_edge: Edge,
    /// Its upper end, r.
    pub to: f64,
    /// What is there.
    pub to_edge: Edge,
}

/// A frequency at which a motion vanishes without friction: the thesis's ω₀ of a mass, ω_z0 of the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Antiresonance {
    /// r.
    pub r: f64,
    /// In Hz under a load.
    pub frequency: Sensed,
}

/// Below this β_lim no friction at all lets the contact slide: V is 0 to rounding.
const STILL: f64 = 1e-10;
/// Points of two conditions nearer to each other than this share of r are one.
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
    /// Where V_k = 0 (of the contact V = 0): without friction the motion vanishes.  Ascending, all of them.
    ///
    /// # Errors
    /// [`FeatureError::Damped`]: then it is smallest, not 0.  [`FeatureError::Range`], [`FeatureError::UnknownMass`],
    /// [`FeatureError::Crowded`].
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

    /// Where what is measured of a motion does not depend on friction, as long as the contact slides all the time:
    /// ascending, all of them in the range.  None for a motion that friction does not reach.
    ///
    /// # Errors
    /// [`FeatureError::Damped`]: see [`crossings`](Self::crossings) for two frictions.  [`FeatureError::Range`],
    /// [`FeatureError::UnknownMass`], [`FeatureError::Crowded`].
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
                    // Over r² in the function's own terms.
                    amplitude: self.variations.length(free.at(r).abs() / (r * r)),
                    continuous_limit: self.variations.friction(limit),
                    simple: zero.crosses,
                });
            }
        }
        points.sort_by(|a, b| a.r.total_cmp(&b.r));
        // U_k = U of a mass that rubs on the moving base: then (6.10) holds wherever (6.9) does.
        points.dedup_by(|b, a| {
            let same = a.condition != b.condition && (b.r - a.r).abs() <= SAME * a.r;
            if same && b.condition == Condition::Quadrature {
                a.condition = b.condition;
            }
            same
        });
        Ok(points)
    }

    /// The ranges in which more friction enlarges what is measured of a motion, as long as the contact slides all the time:
    /// ascending, all of them.  Within a range may lie single frequencies at which nothing slides all the time, poles of U:
    /// β_lim is 0 there.
    ///
    /// # Errors
    /// As of [`invariant_points`](Self::invariant_points).
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
        // Of two at one place the one that keeps the motion from being there counts.
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
                // −U².
                (Measured::Amplitude, None) => -1.0,
                // U_k (V U_k − 2 V_k U)/V.
                (Measured::Amplitude, Some(second)) => first * second / own.at(r),
                // H_k (V_k U + (2/π) H_k V)/V; of the contact H (U + (2/π) H).
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
                // It grows on both sides.
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

    /// A function of a motion over a range.
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

/// The places of a function's zeros.
fn places(function: &Function<'_>, range: [f64; 2]) -> Result<impl Iterator<Item = f64>, Crowded> {
    Ok(function.zeros(range)?.into_iter().map(|zero| zero.r()))
}

//! Finds three features of chains without damping. Invariant points are frequencies at which friction does not change a
//! motion. Inversions are ranges of frequency in which more friction makes a motion larger. Antiresonances are
//! frequencies at which a motion vanishes without friction.

use super::functions::Target;
use super::isolate::{Crowded, FunctionZero, MotionFunction};
use super::sensed::Sensed;
use super::{FeatureError, Features, check_range};
use crate::Of;
use frictiongen_kernel::number::dd::Dd;

/// The quantity of a motion that does not depend on friction at an invariant point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum InvariantQuantity {
    /// At the invariant point the amplitude does not depend on friction. For the contact's motion the point is exact
    /// (6.9). For another mass the point follows from the monoharmonic estimate of the amplitude (5.50, 6.10).
    Amplitude,
    /// At the invariant point the fundamental component does not depend on friction. The point is exact. The amplitude
    /// of the fundamental component is the frequency-based transmissibility (4.4).
    Fundamental,
}

/// The equation that holds at an invariant point, a frequency at which friction does not change a motion. V is the
/// complex amplitude without friction. H is the response to a harmonic force in the contact. U is the velocity at a
/// reversal, in response to a square wave of friction. V, H and U belong to the contact, and V_k, H_k and U_k to mass
/// k.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Condition {
    /// The invariant point satisfies U = 0 for the contact, or U_k = 0 for mass k (6.9). U and U_k are the velocities
    /// of the contact and of mass k at a reversal, in response to a square wave of friction.
    Quadrature,
    /// The invariant point of mass k satisfies V U_k = 2 V_k U, from the monoharmonic estimate of the amplitude (6.10).
    /// V is the amplitude of the contact without friction. U is the velocity of the contact at a reversal, in response
    /// to a square wave of friction. V_k and U_k are the same quantities of mass k.
    Estimate,
    /// The invariant point of mass k satisfies H_k = 0. Mass k then does not respond to a harmonic force in the
    /// contact.
    Receptance,
    /// The invariant point satisfies V_k U = −(2/π) H_k V for mass k, or U = −(2/π) H for the contact. V and V_k are
    /// the responses of the contact and of mass k to the load. H and H_k are their responses to a harmonic contact
    /// force. U is the velocity of the contact at a reversal, in response to a square wave of friction.
    Balance,
}

/// A frequency at which a motion does not depend on the friction force, provided that the contact slides all the time.
#[derive(Clone, Debug, PartialEq)]
pub struct InvariantPoint {
    /// Frequency ratio r of the invariant point.
    pub r: f64,
    /// Frequency of the invariant point, in Hz under a load.
    pub frequency: Sensed,
    /// Equation that the invariant point satisfies.
    pub condition: Condition,
    /// True if the phase of the motion does not depend on friction either. The phase of the contact's motion at U = 0
    /// is 0 or π.
    pub phase_too: bool,
    /// Amplitude of the motion without friction, at the invariant point. It is in m under a load, and otherwise divided
    /// by P/k₁ (by Y for base motion).
    pub amplitude: f64,
    /// β_lim at the invariant point, in N under a load. The motion does not depend on friction up to this value.
    pub continuous_limit: f64,
    /// True if the function whose zero is the invariant point crosses 0. False if the function only touches 0, or if
    /// two of its zeros are within a relative distance of 1e-9.
    pub simple: bool,
}

/// Reason why the range of an [`Inversion`] begins or ends at a frequency.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// The requested range of frequencies begins or ends at this frequency.
    Range,
    /// Invariant point: a frequency ratio at which friction does not change the motion.
    Invariant,
    /// Pole of the response without friction, or of the response to a square wave of friction.
    Pole,
    /// Frequency at which the contact does not move without friction. With any friction the contact stops.
    Still,
}

/// A range of frequencies in which more friction makes a motion larger, provided that the contact slides all the time.
#[derive(Clone, Debug, PartialEq)]
pub struct Inversion {
    /// Lower bound of the range, as frequency ratio r.
    pub from: f64,
    /// Reason why the range begins at its lower bound.
    pub from_edge: Edge,
    /// Upper bound of the range, as frequency ratio r.
    pub to: f64,
    /// Reason why the range ends at its upper bound.
    pub to_edge: Edge,
}

/// A frequency at which a motion vanishes without friction. The thesis calls it ω₀ for a mass and ω_z0 for the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Antiresonance {
    /// Frequency ratio r at which the motion vanishes.
    pub r: f64,
    /// Frequency at which the motion vanishes, in Hz under a load.
    pub frequency: Sensed,
}

/// Largest β_lim at which the contact is treated as unable to slide. The contact's motion V without friction is then
/// zero apart from rounding.
const STILL: f64 = 1e-10;
/// Largest relative distance at which the code treats two invariant points with different [`Condition`]s as one point.
const SAME: f64 = 1e-13;

fn targets(measured: InvariantQuantity, is_contact: bool) -> &'static [(Condition, Target<Dd>)] {
    match (measured, is_contact) {
        (InvariantQuantity::Amplitude, true) => &[(Condition::Quadrature, Target::Quadrature)],
        (InvariantQuantity::Amplitude, false) => &[
            (Condition::Quadrature, Target::Quadrature),
            (Condition::Estimate, Target::Estimate),
        ],
        (InvariantQuantity::Fundamental, _) => &[
            (Condition::Receptance, Target::Receptance),
            (Condition::Balance, Target::Fundamental),
        ],
    }
}

impl Features<'_> {
    /// Returns all frequencies in the range at which the motion vanishes without friction, in ascending order.
    ///
    /// # Errors
    /// [`FeatureError::Damped`] for a damped chain, because its motion has a minimum but does not vanish.
    /// [`FeatureError::Range`], [`FeatureError::UnknownMass`], [`FeatureError::Crowded`].
    pub fn antiresonances(
        &self,
        of: Of,
        range: [f64; 2],
    ) -> Result<Vec<Antiresonance>, FeatureError> {
        let function = self.function(of, range, Target::Free)?;
        let zeros = function.zeros(range)?;
        let of = |zero: FunctionZero| Antiresonance {
            r: zero.r(),
            frequency: self.variations.of_zero(&function, &zero, None),
        };
        Ok(zeros.into_iter().map(of).collect())
    }

    /// Returns all invariant points of a motion in the range, in ascending order. At an invariant point the quantity
    /// `measured` does not depend on friction, provided that the contact slides all the time. The list is empty for a
    /// motion that friction does not influence, and for an elastic contact.
    ///
    /// # Errors
    /// [`FeatureError::Damped`] for a damped chain. For a damped chain, call [`crossings`](Self::crossings) with two
    /// friction ratios. [`FeatureError::Range`], [`FeatureError::UnknownMass`], [`FeatureError::Crowded`].
    pub fn invariant_points(
        &self,
        of: Of,
        measured: InvariantQuantity,
        range: [f64; 2],
    ) -> Result<Vec<InvariantPoint>, FeatureError> {
        let mass = self.mass_of(of)?;
        let free = self.function(of, range, Target::Free)?;
        if self.system.modal().compliance.is_some() {
            return Ok(Vec::new());
        }
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
                    phase_too: mass.is_none() && measured == InvariantQuantity::Amplitude,
                    // The sums of the function leave out the factor 1/r². The division adds this factor.
                    amplitude: self.variations.length(free.at(r).abs() / (r * r)),
                    continuous_limit: self.variations.friction(limit),
                    simple: zero.crosses,
                });
            }
        }
        points.sort_by(|a, b| a.r.total_cmp(&b.r));
        // If mass k slides on the moving base, it responds to a square wave of friction as the contact does. Then U_k =
        // U, where U_k and U are the velocities of mass k and of the contact at a reversal in this response. Every
        // point that satisfies (6.9) then also satisfies (6.10).
        points.dedup_by(|b, a| {
            let same = a.condition != b.condition && (b.r - a.r).abs() <= SAME * a.r;
            if same && b.condition == Condition::Quadrature {
                a.condition = b.condition;
            }
            same
        });
        Ok(points)
    }

    /// Returns all ranges of the frequency ratio r in which more friction makes the quantity `measured` larger, in
    /// ascending order. In these ranges the contact slides all the time. The list is empty for an elastic contact.
    ///
    /// A range may contain single frequencies at which the contact cannot slide all the time with any friction. These
    /// frequencies are poles of U, where β_lim = 0.
    ///
    /// # Errors
    /// Same errors as [`invariant_points`](Self::invariant_points).
    pub fn inversions(
        &self,
        of: Of,
        measured: InvariantQuantity,
        range: [f64; 2],
    ) -> Result<Vec<Inversion>, FeatureError> {
        let mass = self.mass_of(of)?;
        let function = |target| self.function(of, range, target);
        let (free, own) = (function(Target::Free)?, function(Target::FreeContact)?);
        if self.system.modal().compliance.is_some() {
            return Ok(Vec::new());
        }
        let all = targets(measured, mass.is_none());
        let mut functions = Vec::new();
        for (_, target) in all {
            functions.push(function(*target)?);
        }
        if functions.iter().any(MotionFunction::vanishes) {
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
        // If two bounds of ranges coincide, the code keeps the bound at which the contact cannot slide all the time.
        let rank = |edge: &Edge| match edge {
            Edge::Still => 0,
            Edge::Pole => 1,
            Edge::Range => 2,
            Edge::Invariant => 3,
        };
        edges.sort_by(|a, b| a.0.total_cmp(&b.0).then(rank(&a.1).cmp(&rank(&b.1))));
        // Two functions may be zero at the same frequency. Because of rounding, the two computed zeros differ, and
        // either may be the smaller.
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
                // The change of the contact's amplitude with friction has the sign of −U². U is the velocity of the
                // contact at a reversal, in response to a square wave of friction.
                (InvariantQuantity::Amplitude, None) => -1.0,
                // The change of mass k's amplitude with friction has the sign of U_k (V U_k − 2 V_k U)/V. V is the
                // motion of the contact without friction, and U its velocity at a reversal, in response to a square
                // wave of friction. V_k and U_k belong to mass k.
                (InvariantQuantity::Amplitude, Some(second)) => first * second / own.at(r),
                // The change of the fundamental component with friction has the sign of H_k (V_k U + (2/π) H_k V)/V for
                // mass k. For the contact, the change has the sign of H (U + (2/π) H). V and H are the responses of the
                // contact to the load and to a harmonic contact force. U is its velocity at a reversal, in response to
                // a square wave of friction. V_k and H_k belong to mass k.
                (InvariantQuantity::Fundamental, Some(second)) if mass.is_some() => {
                    first * second / own.at(r)
                }
                (InvariantQuantity::Fundamental, Some(second)) => first * second,
                (InvariantQuantity::Fundamental, None) => f64::NAN,
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
                // The motion grows with friction on both sides of this bound. The two ranges therefore become one
                // range.
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

    /// Returns the function whose zeros are the features of a motion. Fails for an invalid range and for a damped
    /// chain.
    fn function(
        &self,
        of: Of,
        range: [f64; 2],
        target: Target<Dd>,
    ) -> Result<MotionFunction<'_>, FeatureError> {
        check_range(range)?;
        let mass = self.mass_of(of)?;
        let modal = self.system.modal();
        if modal.is_damped() {
            return Err(FeatureError::Damped);
        }
        Ok(MotionFunction::new(modal, mass, target))
    }
}

/// Returns the frequency ratios r at which a function of the motion is zero.
fn places(
    function: &MotionFunction<'_>,
    range: [f64; 2],
) -> Result<impl Iterator<Item = f64>, Crowded> {
    Ok(function.zeros(range)?.into_iter().map(|zero| zero.r()))
}

//! Words for regimes, results, events and features. Tables, files and bindings for other programming languages use
//! the same words.

use super::joined::{BranchEnd, BranchEvent, FoundBy, JoinedOrbit};
use super::{
    StudyError, SystemAt,
    features::{Certainty, Condition, Edge, InvariantPoint, InvariantQuantity},
    optimum::{OptimumEnd, OptimumKind},
    orbit::SystemOrbit,
    response::SystemResponse,
    sensitivity::NoDerivative,
};
#[cfg(feature = "desk")]
use super::{
    curve::{CurvePoint, CurveStart},
    map::Pattern,
};
use crate::{Error, Given, NoOrbit, NotContinuous, OutOfDomain, Regime, Unsupported};
use frictiongen_kernel::simulation::{Contact, Event};
#[cfg(feature = "desk")]
use std::borrow::Cow;

/// Returns the word for a regime, for example `stick-slip`.
#[must_use]
pub fn regime(regime: Regime) -> &'static str {
    match regime {
        Regime::Continuous => "continuous",
        Regime::StickSlip => "stick-slip",
        Regime::Stuck => "stuck",
        Regime::Bistable => "bistable",
        _ => "",
    }
}

/// Returns the word that replaces the regime if there is no response.
#[must_use]
pub fn regime_without(error: Error) -> &'static str {
    match error {
        Error::NoOrbit(_) => regime(Regime::StickSlip),
        _ => "unbounded",
    }
}

/// Returns the word that replaces the regime if there is no steady state.
///
/// # Errors
/// [`OutOfDomain`] for a friction ratio that is negative or NaN.
pub fn regime_without_orbit(at: &SystemAt<'_>, beta: f64) -> Result<&'static str, OutOfDomain> {
    Ok(match at.motion(beta) {
        Ok(_) => regime(Regime::Continuous),
        Err(NotContinuous::StickSlip) => regime(Regime::StickSlip),
        Err(NotContinuous::Stuck) if at.stuck().is_ok() => regime(Regime::Stuck),
        // The frequency is an undamped resonance of the chain with a free or with a stuck contact.
        Err(NotContinuous::Stuck | NotContinuous::Unbounded) => "unbounded",
        Err(_) => return Err(OutOfDomain::FrictionRatio(Given::of(beta))),
    })
}

/// Returns the word for the symmetry of a periodic motion. A symmetric motion repeats with the opposite sign after half
/// a period.
#[must_use]
pub fn symmetry(symmetric: bool) -> &'static str {
    if symmetric { "symmetric" } else { "asymmetric" }
}

/// Returns the words for the reason why there is no response.
#[must_use]
pub fn no_answer(error: Error) -> &'static str {
    match error {
        Error::NoOrbit(error) => reason(error),
        Error::NotContinuous(_) | Error::StuckResonance(_) => "unbounded",
        _ => "no cycle",
    }
}

/// Returns the words for the reason why there is no steady state.
#[must_use]
pub fn reason(error: NoOrbit) -> &'static str {
    match error {
        NoOrbit::OutOfDomain(OutOfDomain::Unsupported(Unsupported::CriticalDamping)) => "no digits",
        NoOrbit::OutOfDomain(_) => "no cycle",
        NoOrbit::TooManyEvents => "crowded",
        NoOrbit::Unbounded => "unbounded",
        NoOrbit::Undamped(_) => "undamped",
        NoOrbit::Unstable => "unstable",
        NoOrbit::Unsettled => "unsettled",
        _ => "none",
    }
}

/// Returns the word for the method that computed a response, as tables print it.
#[must_use]
pub fn answer(response: &SystemResponse<'_>) -> &'static str {
    match response {
        SystemResponse::StickSlip(orbit) => found(orbit),
        other if !other.is_from_rest() => "closed form: not from rest",
        _ => "closed form",
    }
}

/// Returns the words for a steady state that was computed from event to event, such as stable, marginal or subharmonic.
#[must_use]
pub fn found(orbit: &SystemOrbit<'_>) -> &'static str {
    match (orbit.is_marginal(), orbit.is_stable()) {
        _ if !orbit.is_settled() => "last 64 cycles",
        _ if !orbit.is_from_rest() => "orbit: not from rest",
        (true, _) => "orbit: marginal",
        (false, true) if orbit.period() > 1 => "subharmonic",
        (false, true) => "orbit: stable",
        (false, false) => "orbit: unstable",
    }
}

/// Returns the word for the method that computed a point of a curve. If there is no point, returns the reason.
#[cfg(feature = "desk")]
#[must_use]
pub fn on_curve(point: Result<&CurvePoint, Error>) -> &'static str {
    match point {
        Err(error) => no_answer(error),
        Ok(point) if !point.settled => "last 64 cycles",
        Ok(point) if !point.from_rest && point.regime == Regime::StickSlip => {
            "orbit: not from rest"
        }
        Ok(point) if !point.from_rest => "closed form: not from rest",
        Ok(point) if point.regime == Regime::StickSlip => "orbit",
        Ok(_) => "closed form",
    }
}

/// Returns the word for the initial state of the motions of a curve.
#[cfg(feature = "desk")]
#[must_use]
pub fn start(start: CurveStart) -> &'static str {
    match start {
        CurveStart::Rest => "rest",
        CurveStart::Up => "up",
        CurveStart::Down => "down",
    }
}

/// Returns the word for the stability of a steady state.
#[must_use]
pub fn state(orbit: &SystemOrbit<'_>) -> &'static str {
    match (orbit.is_marginal(), orbit.is_stable()) {
        _ if !orbit.is_settled() => reason(NoOrbit::Unsettled),
        (true, _) => "marginal",
        (false, true) => "stable",
        (false, false) => "unstable",
    }
}

/// Returns the name of a region of a map.
#[cfg(feature = "desk")]
#[must_use]
pub fn region(found: Result<Pattern, Error>) -> Cow<'static, str> {
    let pattern = match found {
        Ok(pattern) => pattern,
        Err(error) => return no_answer(error).into(),
    };
    match (pattern.regime, pattern.period, pattern.stops) {
        (Regime::Continuous, ..) => "continuous".into(),
        (Regime::Stuck, ..) => "stuck".into(),
        (_, 0, _) => "unsettled".into(),
        (_, 1, 0) => "sliding reversals".into(),
        (_, 1, 1) => "1 stop".into(),
        (_, 1, stops) => format!("{stops} stops").into(),
        _ => "subharmonic".into(),
    }
}

/// Returns the word for the state of the contact: stuck, or its direction of sliding.
#[must_use]
pub fn contact(contact: Contact) -> &'static str {
    match contact {
        Contact::Stuck => "stuck",
        Contact::Forward => "forward",
        Contact::Backward => "backward",
    }
}

/// Returns the word for an event of the contact: stop, break-away or reversal.
#[must_use]
pub fn event(event: Event) -> &'static str {
    match event {
        Event::Stop => "stop",
        Event::Slip => "break-away",
        Event::Reversal => "reversal",
    }
}

/// Returns the words for the reason why no other friction gives a smaller amplitude than the best friction.
#[must_use]
pub fn kind(kind: OptimumKind) -> &'static str {
    match kind {
        OptimumKind::EqualPeaks => "two equal peaks",
        OptimumKind::SinglePeak => "one peak at its least",
        OptimumKind::NoFriction => "friction only does harm",
        OptimumKind::Stuck => "stuck: more friction changes nothing",
        OptimumKind::Flat => "flat: the same over an interval of friction",
        OptimumKind::Bounded => "a bound on another quantity",
        OptimumKind::Balanced => "balance: more friction raises one quantity, less raises another",
        OptimumKind::Trivial => "trivial: nothing that is asked for moves or acts",
    }
}

/// Returns the words for the event that ended the search for the best friction.
#[must_use]
pub fn end(end: OptimumEnd) -> &'static str {
    match end {
        OptimumEnd::Converged => "converged",
        OptimumEnd::Jump => "at a jump to a larger steady state",
        OptimumEnd::Unconfirmed => {
            "the best so far: each finer scan of the band found a higher peak"
        }
        OptimumEnd::WorkSpent => {
            "the best so far: the work of one search was done before it converged"
        }
        OptimumEnd::Stopped => "the best so far: the search was stopped",
    }
}

/// Returns the words for the reason why a response has no derivative. Returns `None` if the request itself is invalid.
#[must_use]
pub fn no_derivative(error: &StudyError) -> Option<&'static str> {
    Some(match error {
        StudyError::NoDerivative(error) => match error {
            NoDerivative::Marginal => "marginal",
            NoDerivative::Unsettled => "unsettled",
            NoDerivative::Degenerate => "degenerate",
            _ => "bend",
        },
        StudyError::Solver(error) => no_answer(*error),
        _ => return None,
    })
}

/// Returns the word for the quantity that is independent of friction at an invariant point.
#[must_use]
pub fn measured(measured: InvariantQuantity) -> &'static str {
    match measured {
        InvariantQuantity::Amplitude => "amplitude",
        InvariantQuantity::Fundamental => "fundamental",
    }
}

/// Returns the condition under which the motion at an invariant point does not depend on friction.
#[must_use]
pub fn condition(point: &InvariantPoint) -> &'static str {
    match point.condition {
        Condition::Quadrature if point.phase_too => "U = 0 and phase too",
        Condition::Quadrature => "estimate: U_k = 0",
        Condition::Estimate => "estimate",
        Condition::Receptance => "H_k = 0",
        Condition::Balance => "balance",
    }
}

/// Returns the words for the reason why an inversion ends. An inversion is a range of the frequency ratio r in which
/// more friction makes a motion larger.
#[must_use]
pub fn edge(edge: Edge) -> &'static str {
    match edge {
        Edge::Range => "end of the range",
        Edge::Invariant => "invariant point",
        Edge::Pole => "pole",
        Edge::Still => "contact still",
    }
}

/// Returns the word for the completeness of a list of features: proven, or sampled.
#[must_use]
pub fn certainty(certainty: Certainty) -> &'static str {
    match certainty {
        Certainty::Proven => "all",
        Certainty::Sampled { .. } => "sampled",
    }
}

/// Returns the word for the stability of a steady state of several contacts.
pub fn joined_state(orbit: &JoinedOrbit<'_>) -> &'static str {
    if !orbit.is_settled() {
        reason(NoOrbit::Unsettled)
    } else if orbit.is_unstable() {
        "unstable"
    } else if orbit.is_marginal() || !orbit.is_stable() {
        "marginal"
    } else {
        "stable"
    }
}

/// Returns the word for how a search has found a steady state.
pub fn found_by(found: FoundBy) -> &'static str {
    match found {
        FoundBy::Rest => "rest",
        FoundBy::Stuck => "stuck",
        FoundBy::Linear => "linear",
        FoundBy::Spread => "spread",
        FoundBy::Newton => "newton",
        FoundBy::Mirror => "mirror",
    }
}

/// Returns the words for an event on a branch. `contacts` has the names of the contacts.
pub fn branch_event(event: BranchEvent, contacts: &[String]) -> String {
    let name = |index: usize| contacts.get(index).map_or("", String::as_str);
    let word = match event {
        BranchEvent::Fold => "fold",
        BranchEvent::PeriodDoubling => "period doubling",
        BranchEvent::SymmetryBreaking => "symmetry breaking",
        BranchEvent::Crossing => "crossing of branches",
        BranchEvent::Torus => "torus",
        BranchEvent::Jump => "jump of stability",
        BranchEvent::Stops(contact) => return format!("stops of {} change", name(contact)),
        BranchEvent::Slides(contact) => {
            return format!("{} begins or ceases to slide", name(contact));
        }
    };
    word.to_owned()
}

/// Returns the words for the reason why a branch ends.
pub fn branch_end(end: BranchEnd) -> &'static str {
    match end {
        BranchEnd::Bound => "bound of the parameter",
        BranchEnd::Closed => "closed",
        BranchEnd::Symmetric => "meets symmetric states",
        BranchEnd::Lost => "no further state",
        BranchEnd::Points => "largest number of points",
    }
}

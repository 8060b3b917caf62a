//! One segment of the motion, from one event to the next.

use super::contact::{Contact, ContactState, End, Event, Outcome, Sought};
use super::dynamics::rotated;
use super::oscillator::Part;
use super::series::Sum;
use super::setting::Setting;
use super::walk::{Start, Walk, first_reach, first_zero};
use crate::number::complex::{self, Complex};
use crate::number::phase::within_cycle;
use crate::number::scalar::Float;
use crate::oscillator::decay::Turn;

/// Rounding bound of a velocity that vanishes, in roundings of the sum of its terms' sizes.
const ROUNDINGS: f64 = 8.0;

/// Sine and cosine of the excitation's angle.
pub(crate) fn phase<S: Float>(t: S) -> (S, S) {
    t.sin_cos_pi()
}

/// The phase τ after the phase `t`, in half-turns, in [0, 2).
pub(crate) fn moved<S: Float>(t: S, tau: S) -> S {
    let two = S::constant(2.0);
    let t = within_cycle(t + tau * S::inverse_pi());
    if t < two { t } else { t - two }
}

impl<S: Float> Setting<'_, S> {
    /// Derives the contact's state from the motion alone.
    pub(crate) fn contact_state(&self, parts: &[Part<S>], t: S) -> ContactState<S> {
        let at = phase(t);
        let (velocity, size) = self.relative_velocity(parts, at);
        let mut contact_state = ContactState {
            t,
            contact: Contact::along(velocity),
            departing: None,
            wedged: false,
        };
        if velocity.abs() <= size * S::constant(ROUNDINGS * S::EPSILON) {
            let force = self.holding(parts, at);
            if force.abs() <= self.grip() {
                contact_state.contact = Contact::Stuck;
            } else {
                contact_state.contact = Contact::along(force);
                contact_state.departing = Some(self.acceleration(force.abs() - self.beta));
            }
        }
        contact_state
    }

    /// Sets the oscillators of the modes to sliding, and returns the function z̄′ times its sign.
    pub(crate) fn slide<'p>(
        &self,
        modes: &'p mut [Part<S>],
        contact_state: &ContactState<S>,
        reach: S,
    ) -> Sum<'p, S> {
        let at = phase(contact_state.t);
        let sign: S = contact_state.contact.sign();
        let zero = S::constant(0.0);
        let mut fundamental = Complex::new(zero, -(self.base * sign));
        for (part, mode) in modes.iter_mut().zip(self.dynamics.driven()) {
            let lambda = mode.resonance * mode.resonance;
            part.centre = -(sign * self.beta * mode.contact / lambda);
            part.start(at);
            part.weight = [zero, sign * mode.contact * part.x];
            part.aim();
            fundamental = complex::add(fundamental, part.fundamental());
        }
        let driven = self.dynamics.in_contact().min(modes.len());
        let (modes, others) = modes.split_at_mut(driven);
        for part in others {
            part.start(at);
        }
        let (sine, cosine) = at;
        let cosines = rotated(fundamental, sine, cosine);
        let sines = -(fundamental.re * sine) - fundamental.im * cosine;
        Sum::new(modes, zero, (cosines, sines), at, reach)
    }

    /// Sets the oscillators of the stuck chain from the state of the modes, and returns the contact force and z̄.
    pub(crate) fn stick<'p>(
        &self,
        modes: &mut [Part<S>],
        held: &'p mut [Part<S>],
        contact_state: &ContactState<S>,
        reach: S,
    ) -> (Sum<'p, S>, S) {
        let at = phase(contact_state.t);
        let (sine, cosine) = at;
        let offset = self.relative(modes, at);
        let lifted = self.lifted(offset, at);
        self.project(modes.iter().map(|part| [part.y, part.u]), lifted, held);
        let zero = S::constant(0.0);
        let (constant, mut fundamental) = self.held_force(offset);
        for (part, mode) in held.iter_mut().zip(self.dynamics.held) {
            part.start(at);
            part.weight = [-mode.force, zero];
            part.aim();
            fundamental = complex::add(fundamental, part.fundamental());
        }
        let driven = self.dynamics.in_contact();
        for part in modes.iter_mut().skip(driven) {
            part.start(at);
        }
        let cosines = rotated(fundamental, sine, cosine);
        let sines = -(fundamental.re * sine) - fundamental.im * cosine;
        (
            Sum::new(held, constant, (cosines, sines), at, reach),
            offset,
        )
    }
}

/// Advances all oscillators by τ from the segment's start.
pub(crate) fn advanced<S: Float>(parts: &mut [Part<S>], tau: S, from: (S, S), to: (S, S)) {
    let t = tau * S::inverse_pi();
    for part in parts {
        let turn: Turn<S> = part.turn(t, tau);
        let [y, u] = part.at(&turn, t, from, to);
        (part.y, part.u) = (y, u);
    }
}

/// Searches for the next event from a contact state, as far as `reach`, and sets the oscillators to the segment.
pub(crate) fn seek<S: Float>(
    setting: &Setting<'_, S>,
    modes: &mut [Part<S>],
    held: &mut [Part<S>],
    contact_state: ContactState<S>,
    reach: S,
) -> Sought<S> {
    let zero = S::constant(0.0);
    let mut sought = Sought::none(contact_state);
    if contact_state.contact == Contact::Stuck {
        let (sum, offset) = setting.stick(modes, held, &contact_state, reach);
        let start = if contact_state.wedged {
            Start::Wedged
        } else {
            Start::Anywhere
        };
        let walk = first_reach(&sum, setting.grip(), zero, start, &mut sought.steps);
        (sought.tau, sought.outcome) = match walk {
            Walk::Zero(tau, negative) => (tau, Outcome::Breaks(negative)),
            Walk::Until(tau) => (tau, Outcome::Goes),
            Walk::NoStart => (reach, Outcome::Goes),
        };
        sought.offset = offset;
        if S::CARRIES {
            let level = match sought.outcome {
                Outcome::Breaks(negative) if negative => Some(-setting.grip()),
                Outcome::Breaks(_) => Some(setting.grip()),
                _ => None,
            };
            sought.tau = carried(&sum, sought.tau, level);
        }
        sought.slope = sum.local(sought.tau).slope;
    } else {
        let sum = setting.slide(modes, &contact_state, reach);
        let start = contact_state.departing.map_or(Start::Anywhere, Start::Zero);
        (sought.tau, sought.outcome) = match first_zero(&sum, start, &mut sought.steps) {
            Walk::Zero(tau, _) => (tau, Outcome::Halts),
            Walk::Until(tau) => (tau, Outcome::Goes),
            Walk::NoStart => (zero, Outcome::Holds),
        };
        if S::CARRIES {
            let level = (sought.outcome == Outcome::Halts).then_some(zero);
            sought.tau = carried(&sum, sought.tau, level);
        }
    }
    sought
}

/// Adds derivatives to the instant at which a sum meets its level, for a scalar that carries derivatives.  One step of
/// Newton's method from the walk's instant gives them.  Without a level no event ends the segment.  The reach then
/// keeps its own derivatives, and an instant short of the reach has none.
fn carried<S: Float>(sum: &Sum<'_, S>, tau: S, level: Option<S>) -> S {
    let Some(level) = level else {
        return if tau < sum.reach {
            tau.primal()
        } else {
            sum.reach
        };
    };
    let local = sum.local(tau.primal());
    let gap = local.value - level;
    tau.primal() - (gap - gap.primal()) / local.slope.primal()
}

/// Sets the oscillators to their state τ after the segment's start.  `to` is the excitation's phase then.
pub(crate) fn place<S: Float>(
    setting: &Setting<'_, S>,
    modes: &mut [Part<S>],
    held: &mut [Part<S>],
    sought: &Sought<S>,
    tau: S,
    to: (S, S),
) {
    let from = phase(sought.contact_state.t);
    if sought.contact_state.contact != Contact::Stuck {
        return advanced(modes, tau, from, to);
    }
    advanced(held, tau, from, to);
    let driven = setting.dynamics.in_contact().min(modes.len());
    let (modes, others) = modes.split_at_mut(driven);
    advanced(others, tau, from, to);
    let states = modes.iter_mut().map(|part| (&mut part.y, &mut part.u));
    setting.release(held, setting.lifted(sought.offset, to), states);
}

/// Derives the end of a segment after the oscillators have been set to it.
pub(crate) fn ended<S: Float>(
    setting: &Setting<'_, S>,
    modes: &[Part<S>],
    sought: &Sought<S>,
    to: (S, S),
) -> End<S> {
    let zero = S::constant(0.0);
    let mut end = quiet(sought.tau, sought.contact_state, sought.steps);
    match sought.outcome {
        Outcome::Goes => {}
        Outcome::Holds => {
            end.contact_state.contact = Contact::Stuck;
            end.contact_state.wedged = true;
        }
        Outcome::Breaks(negative) => {
            let contact = if negative {
                Contact::Backward
            } else {
                Contact::Forward
            };
            let sign: S = contact.sign();
            let excess = setting.grip() - setting.beta;
            end.event = Some(Event::Slip);
            end.contact_state.contact = contact;
            end.contact_state.departing = Some(setting.acceleration(excess));
            end.slope = sought.slope;
            end.jump = sign * excess;
        }
        Outcome::Halts => {
            let sign: S = sought.contact_state.contact.sign();
            let force = setting.holding(modes, to);
            end.slope = setting.acceleration(force - sign * setting.beta);
            if force.abs() <= setting.grip() {
                end.event = Some(Event::Stop);
                end.contact_state.contact = Contact::Stuck;
                end.jump = sign * setting.beta - force;
            } else if zero < force * sign {
                // The velocity touched zero, and the contact continues in the same direction.
                end.contact_state.departing =
                    Some(setting.acceleration(force.abs() - setting.beta));
            } else {
                end.event = Some(Event::Reversal);
                end.contact_state.contact = sought.contact_state.contact.reversed();
                end.contact_state.departing =
                    Some(setting.acceleration(force.abs() - setting.beta));
                end.jump = (sign + sign) * setting.beta;
            }
        }
    }
    end
}

/// Distance from a contact state to the next event, at most `reach`.  It is 0 where the contact cannot leave zero
/// velocity.
pub(crate) fn span<S: Float>(
    setting: &Setting<'_, S>,
    modes: &mut [Part<S>],
    held: &mut [Part<S>],
    contact_state: ContactState<S>,
    reach: S,
) -> S {
    let sought = seek(setting, modes, held, contact_state, reach);
    if sought.holds() {
        return S::constant(0.0);
    }
    sought.tau
}

/// Advances from a contact state to the next event, or as far as `reach`.
pub(crate) fn leap<S: Float>(
    setting: &Setting<'_, S>,
    modes: &mut [Part<S>],
    held: &mut [Part<S>],
    contact_state: ContactState<S>,
    reach: S,
) -> End<S> {
    let sought = seek(setting, modes, held, contact_state, reach);
    let to = phase(moved(contact_state.t, sought.tau));
    if sought.outcome != Outcome::Holds {
        place(setting, modes, held, &sought, sought.tau, to);
    }
    ended(setting, modes, &sought, to)
}

/// Returns the [`End`] of a segment of length `tau` in which no event occurs.
fn quiet<S: Float>(tau: S, contact_state: ContactState<S>, steps: u32) -> End<S> {
    let zero = S::constant(0.0);
    End {
        tau,
        event: None,
        contact_state: ContactState {
            t: moved(contact_state.t, tau),
            departing: None,
            wedged: false,
            ..contact_state
        },
        slope: zero,
        jump: zero,
        steps,
    }
}

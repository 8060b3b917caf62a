//! Sliding motion under a kinetic friction force that changes with the speed.
//!
//! On one straight line of the friction law the force is level + slope·velocity. The slope couples the modes. The code
//! divides the motion into short pieces, and computes each piece as a power series. The length of a piece, times the
//! rate of the fastest oscillation plus the rate due to the friction law, is at most a radian.

use super::line::KineticLine;
use super::lines::{LineCrossing, Lines};
use crate::errors::OutOfDomain;
use crate::motion::clock::phase;
use crate::motion::contact::law::{ContactChain, Law};
use crate::motion::contact::state::{ContactState, SegmentOutcome, Sought};
use crate::motion::oscillator::{Part, advanced};
use crate::motion::series::{Power, ROUNDINGS, TERMS};
use crate::motion::setting::MotionSetting;
use crate::motion::walk::{WalkResult, WalkStart, first_zero};
use crate::number::scalar::Float;

/// Upper bound on the rate at which the friction law changes the motion, divided by the rate of the fastest mode.
pub const MAX_STEEPNESS: u32 = 4096;

/// Length of a piece of motion, in rounding units, below which the code treats the piece as one of length zero.
const STILL: f64 = 64.0;

impl<S: Float, K: ContactChain<S>> MotionSetting<'_, S, K> {
    /// Returns an upper bound on the rates at which modes and excitation oscillate, in rad per rad of the excitation.
    fn turning(&self, modes: &[Part<S>]) -> S {
        let one = S::constant(1.0);
        let driven = modes.iter().take(self.dynamics.in_contact());
        driven.fold(one, |rate, part| {
            rate.max(part.x * (one + part.zeta + part.zeta))
        })
    }

    /// Returns an error if the friction law is too steep for the power series.
    pub(crate) fn check_lines(
        &self,
        modes: &[Part<S>],
        lines: &Lines<'_, S>,
    ) -> Result<(), OutOfDomain> {
        let steep = self.acceleration(self.law().level() * lines.steepest());
        let most = self.turning(modes) * S::constant(f64::from(MAX_STEEPNESS));
        if steep <= most {
            Ok(())
        } else {
            Err(OutOfDomain::Steepness)
        }
    }

    /// Returns the length, in rad of the excitation (τ), of the longest piece in which a power series is valid.
    fn stretch(&self, modes: &[Part<S>], line: &KineticLine<S>) -> S {
        let steep = self.acceleration(self.law().level() * line.slope.abs());
        S::constant(1.0) / (self.turning(modes) + steep)
    }

    /// Returns the relative velocity z̄′ in a piece of motion as a power series in s, where s runs from 0 to 1.
    /// Advances the modes from the start of the piece to s = `to`.
    fn velocity_series(
        &self,
        modes: &mut [Part<S>],
        start: &ContactState<S>,
        (line, stretch): (&KineticLine<S>, S),
        to: S,
    ) -> Power<S> {
        let (zero, one, two) = (S::constant(0.0), S::constant(1.0), S::constant(2.0));
        let [level, slope] = self.law().kinetic_on(line, start.contact);
        let driven = self.dynamics.driven();
        for part in modes.iter_mut().take(driven.len()) {
            // The field `value` is the current term of the series, and `slope` the sum of all terms so far.
            (part.value, part.slope) = (part.free, [zero; 2]);
        }
        let mut velocity = Power::zero(TERMS);
        let (mut sine, mut cosine) = phase(start.t);
        let (mut order, mut power, mut size) = (one, to, zero);
        for (place, slot) in velocity.slots().enumerate() {
            let mut sum = self.base * sine;
            let mut sizes = sum.abs();
            for (mode, part) in driven.iter().zip(&*modes) {
                let [_, u] = part.value;
                let term = mode.contact * part.x * u;
                (sum, sizes) = (sum + term, sizes + term.abs());
            }
            *slot = sum;
            if place < 4 {
                size = size + sizes;
            }
            let force = slope * sum + if place == 0 { level } else { zero };
            let inverse = one / order;
            for (index, (mode, part)) in driven.iter().zip(&mut *modes).enumerate() {
                let [y, u] = part.value;
                let angle = part.x * stretch;
                let per_force = stretch / (self.r * mode.resonance);
                let mut load = mode.load * cosine;
                if !self.quadrature.vanishes() {
                    load = load - self.dynamics.load(index, self.r).im * sine;
                }
                let drive = per_force * (load - mode.contact * force);
                let rates = [angle * u, drive - angle * (y + two * part.zeta * u)];
                part.value = rates.map(|rate| rate * inverse);
                for (sum, term) in part.slope.iter_mut().zip(part.value) {
                    *sum = *sum + term * power;
                }
            }
            (sine, cosine) = (cosine * stretch * inverse, -(sine * stretch * inverse));
            (order, power) = (order + one, power * to);
        }
        for part in modes.iter_mut().take(driven.len()) {
            let ([y, u], [more_y, more_u]) = (part.free, part.slope);
            (part.y, part.u) = (y + more_y, u + more_u);
        }
        velocity.size = size;
        velocity
    }
}

/// Searches for the end of a piece of sliding motion on one line of the friction law. The end is an event, the start of
/// another line, or the end of the series.
pub(crate) fn seek<S: Float, K: ContactChain<S>>(
    setting: &MotionSetting<'_, S, K>,
    modes: &mut [Part<S>],
    lines: &mut Lines<'_, S>,
    start: ContactState<S>,
    reach: S,
) -> Sought<S> {
    let line = lines.line();
    let one = S::constant(1.0);
    let mut sought = Sought::none(start);
    let (length, (at, crossing)) = match line.high {
        Some(high) => {
            let stretch = setting.stretch(modes, &line);
            let Some(end) = setting.slope(modes, &mut sought, (&line, high), stretch) else {
                sought.outcome = SegmentOutcome::Holds;
                return sought;
            };
            (stretch, end)
        }
        None => (one, setting.plateau(modes, &mut sought, &line, reach)),
    };
    sought.tau = at * length;
    if crossing == LineCrossing::Slower && line.low.is_zero() {
        sought.outcome = SegmentOutcome::Halts;
        lines.leads_to(LineCrossing::None, true);
    } else if let Some(short) = lines.leads_to(crossing, S::constant(STILL * S::EPSILON) < at) {
        sought.tau = length * short.min(one);
    }
    sought
}

impl<S: Float, K: ContactChain<S>> MotionSetting<'_, S, K> {
    /// Finds the end of a piece of motion on any line of the friction law except the last. The result contains the
    /// length of the piece divided by `stretch`, the length of the longest piece. Returns `None` if the contact cannot
    /// start to move from zero velocity.
    fn slope(
        &self,
        modes: &mut [Part<S>],
        sought: &mut Sought<S>,
        (line, high): (&KineticLine<S>, S),
        stretch: S,
    ) -> Option<(S, LineCrossing)> {
        let start = sought.contact_state;
        let (zero, one, sign) = (S::constant(0.0), S::constant(1.0), start.contact.sign());
        let driven = self.dynamics.in_contact().min(modes.len());
        let (driven, others) = modes.split_at_mut(driven);
        for part in driven {
            part.free = [part.y, part.u];
        }
        for part in others {
            part.start(phase(start.t));
        }
        let velocity = self.velocity_series(modes, &start, (line, stretch), zero);
        let leaving = |slope| WalkStart::Zero(slope * stretch);
        let from = start.memory.map_or(WalkStart::Anywhere, leaving);
        let falls = velocity.seen(sign, line.low, one);
        let (at, crossing) = match first_zero(&falls, from, &mut sought.steps) {
            WalkResult::Zero(at, _) => (at, LineCrossing::Slower),
            WalkResult::Until(at) => (at, LineCrossing::None),
            WalkResult::NoStart => return None,
        };
        if !(zero < at) {
            // A piece of motion of length zero cannot contain a crossing to the next line of the friction law.
            return Some((at, crossing));
        }
        let rises = velocity.seen(-sign, -high, at);
        let met = first_zero(&rises, WalkStart::Anywhere, &mut sought.steps);
        Some(match met {
            WalkResult::Zero(place, _) => (place, LineCrossing::Faster),
            WalkResult::Until(place) if place < at => (place, LineCrossing::None),
            _ => (at, crossing),
        })
    }

    /// Finds the end of a piece of motion, in τ, on the last line of the friction law. On this line the kinetic
    /// friction is constant.
    fn plateau(
        &self,
        modes: &mut [Part<S>],
        sought: &mut Sought<S>,
        line: &KineticLine<S>,
        reach: S,
    ) -> (S, LineCrossing) {
        let mut constant = *self;
        constant.beta = self.beta * line.level;
        let mut sum = constant.start_sliding(modes, &sought.contact_state, reach);
        sum.constant = -line.low;
        sum.noise = sum.noise + line.low * S::constant(ROUNDINGS * S::EPSILON);
        match first_zero(&sum, WalkStart::Anywhere, &mut sought.steps) {
            WalkResult::Zero(at, _) => (at, LineCrossing::Slower),
            WalkResult::Until(at) => (at, LineCrossing::None),
            WalkResult::NoStart => (reach, LineCrossing::None),
        }
    }
}

/// Sets the modes to their state a time τ after the start of a piece of motion. `to` is sine and cosine of the
/// excitation's phase at that instant.
pub(crate) fn place<S: Float, K: ContactChain<S>>(
    setting: &MotionSetting<'_, S, K>,
    modes: &mut [Part<S>],
    lines: &Lines<'_, S>,
    (start, tau): (&ContactState<S>, S),
    to: (S, S),
) {
    let line = lines.line();
    let from = phase(start.t);
    if line.high.is_none() {
        return advanced(modes, tau, from, to);
    }
    let stretch = setting.stretch(modes, &line);
    setting.velocity_series(modes, start, (&line, stretch), tau / stretch);
    let driven = setting.dynamics.in_contact().min(modes.len());
    advanced(modes.split_at_mut(driven).1, tau, from, to);
}

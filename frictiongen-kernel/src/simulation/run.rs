//! A run in time, segment by segment.

use super::clock::{Clock, Total};
use super::lines::{Constant, Level, Lines};
use super::segment::{self, ContactState, Sought, ended, place, seek};
use super::{Contact, Dynamics, Event, Part, Setting, coupled};
use crate::errors::OutOfDomain;
use crate::number::scalar::{Float, Plain};

/// A segment of the motion: the contact sticks, or slides one way.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Segment<S> {
    /// τ at its start, within the excitation's cycle: [0, 2π).
    pub start: S,
    /// Its length in τ.
    pub length: S,
    /// What the contact does.
    pub contact: Contact,
    /// What ends it; none if it goes on.
    pub event: Option<Event>,
}

/// A mass at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Moment<S> {
    displacement: S,
    velocity: S,
}

impl<S: Float> Moment<S> {
    /// x̄.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// dx̄/dτ.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

/// An exact run in time, from event to event.  An iterator over its segments; one in which nothing
/// happens for a cycle is given in pieces of a cycle.
///
/// `P` holds the parts: an array in emitted code, a vector at run time.  `L` is the kinetic level: [`Constant`], or
/// [`Lines`] over the speed.
#[derive(Clone, Debug)]
pub struct Simulation<'a, S, P, L = Constant> {
    setting: Setting<'a, S>,
    parts: P,
    level: L,
    /// How the contact stands at the start of the segment.
    contact_state: ContactState<S>,
    /// The excitation at the start of the segment, and now.
    start: Clock<S>,
    now: Clock<S>,
    /// The segment, once it has been looked through, and how much of it is over.  It is looked through once,
    /// whatever steps it is passed in: a search that began anew beside an event would see it again.
    sought: Option<Sought<S>>,
    passed: Total<S>,
}

/// Where the kinetic level changes with the speed a run goes from line to line: no more stretches than this are followed
/// at once, then it goes on as another segment.
pub const MAX_STRETCHES: u32 = 4096;

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>> Simulation<'a, S, P> {
    /// From a state at a maximum of the excitation, τ = 0: the displacements x̄ of the masses and
    /// their velocities dx̄/dτ.  From rest where there are none.  `parts` has one
    /// [`Part::empty`] for each mode and each held mode.
    ///
    /// # Errors
    /// [`OutOfDomain`] for r that is not positive and finite, for β as everywhere, for a state that is
    /// not one finite number for each mass, and for another number of parts.
    pub fn new(
        dynamics: Dynamics<'a, S>,
        r: S,
        beta: S,
        state: Option<(&[S], &[S])>,
        parts: P,
    ) -> Result<Self, OutOfDomain>
    where
        S: Plain,
    {
        Self::of(dynamics, (r, beta, Constant), state, parts)
    }
}

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>> Simulation<'a, S, P, Lines<'a, S>> {
    /// The same with a kinetic level that changes with the speed.
    ///
    /// # Errors
    /// [`OutOfDomain`] as of [`new`](Simulation::new); ("amplitude") for a load under which the law's speeds leave the
    /// scalar's range; and ("steepness") for a level that changes the motion more than
    /// [`MAX_STEEPNESS`](super::MAX_STEEPNESS) times as fast as the fastest mode does.
    pub fn along(
        dynamics: Dynamics<'a, S>,
        r: S,
        beta: S,
        lines: Lines<'a, S>,
        state: Option<(&[S], &[S])>,
        parts: P,
    ) -> Result<Self, OutOfDomain>
    where
        S: Plain,
    {
        // What is wrong with r is told of it, not of the speeds that follow from it.
        let mut run = Self::of(dynamics, (r, beta, lines), state, parts)?;
        lines.check()?;
        run.setting.check_lines(run.parts.as_ref(), &lines)?;
        let at = segment::phase(S::constant(0.0));
        let (velocity, _) = run.setting.relative_velocity(run.parts.as_ref(), at);
        run.level.start(velocity.abs());
        Ok(run)
    }
}

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>, L: Level<'a, S>>
    Simulation<'a, S, P, L>
{
    fn of(
        dynamics: Dynamics<'a, S>,
        (r, beta, level): (S, S, L),
        state: Option<(&[S], &[S])>,
        mut parts: P,
    ) -> Result<Self, OutOfDomain> {
        let setting = Setting::new(dynamics, r, beta, parts.as_mut())?;
        if let Some((displacements, velocities)) = state {
            setting.check_state((displacements, velocities))?;
            setting.load_state(displacements, velocities, parts.as_mut());
        }
        let contact_state = setting.contact_state(parts.as_ref(), S::constant(0.0));
        Ok(Self {
            setting,
            parts,
            level,
            contact_state,
            start: Clock::start(),
            now: Clock::start(),
            sought: None,
            passed: Total::zero(),
        })
    }

    /// How many cycles of the excitation are over.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.now.cycles
    }

    /// τ within the excitation's cycle, [0, 2π).
    #[must_use]
    pub fn phase(&self) -> S {
        self.now.t * S::pi()
    }

    /// What the contact does from now on.
    #[must_use]
    pub fn contact(&self) -> Contact {
        self.contact_state.contact
    }

    /// A mass now, by its place in the description; at rest if there is no such mass.
    #[must_use]
    pub fn mass(&self, index: usize) -> Moment<S> {
        let shape = self.setting.dynamics.shape(index);
        Moment {
            displacement: self.sum(shape, |part| part.y),
            velocity: self.sum(shape, |part| part.x * part.u),
        }
    }

    /// z̄ and dz̄/dτ, the relative motion in the contact, now.
    #[must_use]
    pub fn relative(&self) -> (S, S) {
        let at = segment::phase(self.now.t);
        let velocity = if self.contact_state.contact == Contact::Stuck {
            S::constant(0.0)
        } else {
            self.setting.relative_velocity(self.parts.as_ref(), at).0
        };
        (self.setting.relative(self.parts.as_ref(), at), velocity)
    }

    /// The friction force in the contact now, over P: the kinetic one while it slides, what holds it while it
    /// sticks; positive against positive sliding.
    #[must_use]
    pub fn friction(&self) -> S {
        match self.contact_state.contact {
            Contact::Stuck => self
                .setting
                .holding(self.parts.as_ref(), segment::phase(self.now.t)),
            sliding => sliding.sign::<S>() * self.kinetic(),
        }
    }

    /// The kinetic friction force now, over P.
    fn kinetic(&self) -> S {
        let Some(lines) = self.level.lines() else {
            return self.setting.beta;
        };
        let at = segment::phase(self.now.t);
        let (velocity, _) = self.setting.relative_velocity(self.parts.as_ref(), at);
        let line = lines.line();
        // Rounding may leave a speed a little beyond the line.
        let speed = velocity.abs().max(line.low);
        let speed = line.high.map_or(speed, |high| speed.min(high));
        self.setting.beta * (line.level + line.slope * speed)
    }

    fn sum(&self, shape: &[S], of: impl Fn(&Part<S>) -> S) -> S {
        let parts = self.parts.as_ref().iter().zip(shape);
        parts.fold(S::constant(0.0), |sum, (part, component)| {
            sum + *component * of(part)
        })
    }

    /// Moves on to the next event, at most by `reach` in τ; by 0 it does nothing.
    ///
    /// In whatever steps a run is passed, its events are the same, and neither its phase nor its motion
    /// collects the rounding of the steps.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a reach that is negative, infinite or NaN, which changes nothing.
    pub fn advance(&mut self, reach: S) -> Result<Segment<S>, OutOfDomain> {
        if !(S::constant(0.0) <= reach && reach.is_finite()) {
            return Err(OutOfDomain { argument: "reach" });
        }
        Ok(self.moved(reach))
    }

    /// Moves on by a reach that is finite and not negative.
    fn moved(&mut self, reach: S) -> Segment<S> {
        let zero = S::constant(0.0);
        let mut segment = Segment {
            start: self.phase(),
            length: zero,
            contact: self.contact_state.contact,
            event: None,
        };
        if !(zero < reach) {
            return segment;
        }
        let known = self.sought.is_some();
        segment.contact = self.look(reach).contact_state.contact;
        let (length, mut ended) = self.pass(reach);
        segment.length = length;
        // What was looked through before may end, without an event, short of the reach.
        if known && ended == Some(None) && length < reach {
            let (more, next) = self.pass(reach - length);
            segment.length = length + more;
            ended = next;
        }
        if self.level.lines().is_some() {
            for _ in 0..MAX_STRETCHES {
                if ended != Some(None) || !(segment.length < reach) {
                    break;
                }
                let (more, next) = self.pass(reach - segment.length);
                segment.length = segment.length + more;
                ended = next;
            }
        }
        segment.event = ended.flatten();
        segment
    }

    /// The segment, looked through for a cycle at least.
    fn look(&mut self, reach: S) -> Sought<S> {
        if let Some(sought) = self.sought {
            return sought;
        }
        let reach = reach.max(S::pi() + S::pi());
        let (modes, held) = self.setting.split(self.parts.as_mut());
        let slides = self.contact_state.contact != Contact::Stuck;
        let mut sought = match self.level.lines_mut() {
            Some(lines) if slides => {
                coupled::seek(&self.setting, modes, lines, self.contact_state, reach)
            }
            _ => seek(&self.setting, modes, held, self.contact_state, reach),
        };
        if sought.holds() {
            // The contact could not leave after all: it goes on sticking.
            let contact_state =
                ended(&self.setting, modes, &sought, segment::phase(self.now.t)).contact_state;
            sought = seek(&self.setting, modes, held, contact_state, reach);
        }
        self.contact_state = sought.contact_state;
        self.sought = Some(sought);
        sought
    }

    /// Moves on within the segment; its length, and what ends the segment if it is over.
    fn pass(&mut self, reach: S) -> (S, Option<Option<Event>>) {
        let sought = self.look(reach);
        let (modes, held) = self.setting.split(self.parts.as_mut());
        let rest = self.passed.short_of(sought.tau).max(S::constant(0.0));
        if reach < rest {
            self.passed = self.passed.plus(reach);
            self.now = self.now.moved(Total::zero().plus(reach));
            let to = segment::phase(self.now.t);
            put(
                &self.setting,
                (modes, held),
                &self.level,
                &sought,
                (self.passed.value, to),
            );
            return (reach, None);
        }
        self.now = self.start.moved(Total::zero().plus(sought.tau));
        let to = segment::phase(self.now.t);
        put(
            &self.setting,
            (modes, held),
            &self.level,
            &sought,
            (sought.tau, to),
        );
        let end = ended(&self.setting, modes, &sought, to);
        if let Some(lines) = self.level.lines_mut() {
            lines.pass(end.event.is_some() || end.contact_state.contact == Contact::Stuck);
        }
        self.contact_state = ContactState {
            t: self.now.t,
            ..end.contact_state
        };
        self.start = self.now;
        self.passed = Total::zero();
        self.sought = None;
        (rest, Some(end.event))
    }
}

/// Puts the parts where they are so long after the segment's start.
fn put<'a, S: Float>(
    setting: &Setting<'_, S>,
    (modes, held): (&mut [Part<S>], &mut [Part<S>]),
    level: &impl Level<'a, S>,
    sought: &Sought<S>,
    (tau, to): (S, (S, S)),
) {
    match level.lines() {
        Some(lines) if sought.contact_state.contact != Contact::Stuck => {
            coupled::place(setting, modes, lines, (&sought.contact_state, tau), to);
        }
        _ => place(setting, modes, held, sought, tau, to),
    }
}

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>, L: Level<'a, S>> Iterator
    for Simulation<'a, S, P, L>
{
    type Item = Segment<S>;

    fn next(&mut self) -> Option<Segment<S>> {
        Some(self.moved(S::pi() + S::pi()))
    }
}

impl<S: Float> Setting<'_, S> {
    /// The modes' state for displacements and velocities of the masses.
    pub(crate) fn load_state(&self, displacements: &[S], velocities: &[S], parts: &mut [Part<S>]) {
        let masses = displacements.len().max(1);
        let weights = self.dynamics.weights.chunks(masses);
        for (part, weights) in parts.iter_mut().zip(weights) {
            let product = |values: &[S]| {
                let terms = weights.iter().zip(values);
                terms.fold(S::constant(0.0), |sum, (weight, value)| {
                    sum + *weight * *value
                })
            };
            part.y = product(displacements);
            part.u = product(velocities) / part.x;
        }
    }
}

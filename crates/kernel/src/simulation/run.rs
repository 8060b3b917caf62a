//! Simulation that advances in time, segment by segment.

use crate::contact::sums::Chain;
use crate::errors::{Given, OutOfDomain};
use crate::motion::{
    Clock, Constant, Contact, ContactChain, ContactState, Dynamics, Event, KineticLaw, Lines,
    MotionSetting, Part, Sought, Total, ended, phase, seek,
};
use crate::number::scalar::{Float, Plain};

/// A segment of the motion, in which the contact sticks or slides in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Segment<S> {
    /// Phase τ of the excitation at the start of the segment, in rad, in [0, 2π).
    pub start: S,
    /// Length of the segment in rad of the excitation (τ).
    pub length: S,
    /// State of the contact during the segment.
    pub contact: Contact,
    /// Event that ends the segment. `None` if the same motion continues after the segment.
    pub event: Option<Event>,
}

/// Displacement and velocity of a mass at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Moment<S> {
    displacement: S,
    velocity: S,
}

impl<S: Float> Moment<S> {
    /// Returns the displacement x̄ of the mass at this instant.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Returns the velocity dx̄/dτ of the mass at this instant, where x̄ is the displacement.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

/// Displacements and velocities of all masses.
type GivenState<'s, S> = (&'s [S], &'s [S]);

/// An exact simulation in time, from event to event. A simulation is an iterator over the segments of the motion. If a
/// cycle passes without an event, the iterator returns pieces that are one cycle long.
///
/// `P` owns the oscillators, and is an array in emitted code and a vector at run time. `L` is the law of kinetic
/// friction. `L` is either [`Constant`], or consists of straight [`Lines`] that give the force as a function of the
/// speed. `K` contains the constants of the chain, and says whether the contact is rigid or elastic.
#[derive(Clone, Debug)]
pub struct Simulation<'a, S, P, L = Constant, K = Chain<S>> {
    setting: MotionSetting<'a, S, K>,
    parts: P,
    level: L,
    /// Unit of the numbers in `setting` and `parts`, a power of two. Only so large a motion that its square would overflow
    /// has another unit than 1.
    unit: S,
    /// State of the contact at the start of the current segment.
    contact_state: ContactState<S>,
    /// Phase of the excitation at the start of the current segment (`start`), and at the present instant (`now`).
    start: Clock<S>,
    now: Clock<S>,
    /// The current segment after the search for its end. `passed` is the time in rad of the excitation (τ) since the
    /// start of the segment. The simulation searches only once for each segment, even if the caller advances in many
    /// short steps. A second search close to an event would find the same event again.
    sought: Option<Sought<S>>,
    passed: Total<S>,
}

/// A simulation in an emitted solver. Its data are in arrays.
pub type FixedSimulation<S, const PARTS: usize, K = Chain<S>> =
    Simulation<'static, S, [Part<S>; PARTS], Constant, K>;
/// A simulation in an emitted solver whose kinetic friction depends on the speed. Its data are in arrays.
pub type FixedLinesSimulation<S, const PARTS: usize> =
    Simulation<'static, S, [Part<S>; PARTS], Lines<'static, S>>;

/// Size from which on the simulation divides all displacements and forces by powers of this number, 2³². The searches
/// for events multiply derivatives of the motion with each other.
const LARGE: f64 = 4_294_967_296.0;

/// Largest number of pieces of motion that one call follows if the kinetic friction depends on the speed. A piece ends
/// at an event, or when the speed reaches the next straight line of the friction law. A piece also ends where the power
/// series of the motion no longer converges. If a call reaches this number, the call returns, and the motion continues
/// in another segment.
pub const MAX_STRETCHES: u32 = 4096;

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>, K: ContactChain<S>>
    Simulation<'a, S, P, Constant, K>
{
    /// Creates a simulation from a state at a maximum of the excitation, τ = 0. The state consists of the displacements
    /// x̄ and the velocities dx̄/dτ of the masses. Without a state the motion starts from rest. `parts` must contain a
    /// [`Part::empty`] for each mode of the chain, and for each mode of the chain with its contact stuck.
    ///
    /// # Errors
    /// [`OutOfDomain`] if r is not positive and finite, or if β or μβ is NaN, negative or infinite. The error also
    /// occurs if the state does not have one finite displacement and velocity for each mass, or if the number of
    /// `parts` is wrong.
    pub fn new(
        dynamics: Dynamics<'a, S, K>,
        r: S,
        beta: S,
        state: Option<(&[S], &[S])>,
        parts: P,
    ) -> Result<Self, OutOfDomain>
    where
        S: Plain,
    {
        let start = (S::constant(1.0), state);
        Self::under(dynamics, (r, beta, Constant), start, parts)
    }
}

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>, K: ContactChain<S>>
    Simulation<'a, S, P, Lines<'a, S>, K>
{
    /// Creates a simulation whose kinetic friction depends on the speed. The straight `lines` give the friction as a
    /// function of the speed.
    ///
    /// # Errors
    /// The errors of [`new`](Simulation::new). [`OutOfDomain::LoadAmplitude`] if the load makes the law's speeds
    /// overflow or underflow in the number type. [`OutOfDomain::Steepness`] if the law is too steep. The law is too
    /// steep if it changes the motion more than [`MAX_STEEPNESS`](super::MAX_STEEPNESS) times as fast as the fastest
    /// mode does.
    pub fn along(
        dynamics: Dynamics<'a, S, K>,
        r: S,
        beta: S,
        lines: Lines<'a, S>,
        state: Option<(&[S], &[S])>,
        parts: P,
    ) -> Result<Self, OutOfDomain>
    where
        S: Plain,
    {
        // The speeds of the law depend on r. The code checks r first, so that the error gives the true cause.
        let run = Self::under(dynamics, (r, beta, lines), (S::constant(1.0), state), parts)?;
        run.on_lines()
    }

    /// Creates a free vibration: a motion from a given state without a load. `r` sets the unit of time: τ = ωt, where ω
    /// is the angular frequency at the frequency ratio r. β and the state have a common unit of force.
    ///
    /// # Errors
    /// The errors of [`along`](Self::along).
    pub fn free(
        dynamics: Dynamics<'a, S, K>,
        (r, beta): (S, S),
        lines: Lines<'a, S>,
        state: (&[S], &[S]),
        parts: P,
    ) -> Result<Self, OutOfDomain> {
        let start = (S::constant(0.0), Some(state));
        Self::under(dynamics, (r, beta, lines), start, parts)?.on_lines()
    }

    /// Selects the line of the friction law on which the motion starts.
    fn on_lines(mut self) -> Result<Self, OutOfDomain> {
        self.level.check()?;
        self.setting.check_lines(self.parts.as_ref(), &self.level)?;
        let at = phase(S::constant(0.0));
        let (velocity, _) = self.setting.relative_velocity(self.parts.as_ref(), at);
        self.level.start(velocity.abs());
        Ok(self)
    }
}

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>, L: KineticLaw<'a, S>, K: ContactChain<S>>
    Simulation<'a, S, P, L, K>
{
    /// Creates a simulation from a state, or from rest. `load` multiplies the load: it is 1, or 0 without a load.
    fn under(
        dynamics: Dynamics<'a, S, K>,
        (r, beta, mut level): (S, S, L),
        (load, state): (S, Option<GivenState<'_, S>>),
        mut parts: P,
    ) -> Result<Self, OutOfDomain> {
        let (one, large) = (S::constant(1.0), S::constant(LARGE));
        let mut setting = MotionSetting::new(dynamics, r, beta, parts.as_mut())?;
        let mut size = beta;
        if let Some((displacements, velocities)) = state {
            setting.check_state((displacements, velocities))?;
            setting.load_state(displacements, velocities, parts.as_mut());
            let numbers = displacements.iter().chain(velocities);
            size = numbers.fold(size, |size, number| size.max(number.abs()));
        }
        let mut unit = one;
        while large < size / unit {
            unit = unit * large;
        }
        if one < unit || !(load - one).is_zero() {
            setting.scale(parts.as_mut(), one / unit, load / unit);
            if let Some(lines) = level.lines_mut() {
                lines.scale(one / unit);
            }
        }
        let contact_state = setting.contact_state(parts.as_ref(), S::constant(0.0));
        Ok(Self {
            setting,
            parts,
            level,
            unit,
            contact_state,
            start: Clock::start(),
            now: Clock::start(),
            sought: None,
            passed: Total::zero(),
        })
    }

    /// Returns the number of excitation cycles that the simulation has completed.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.now.cycles
    }

    /// Returns the present phase τ of the excitation in its cycle, in rad, in [0, 2π).
    #[must_use]
    pub fn phase(&self) -> S {
        self.now.t * S::pi()
    }

    /// Returns the state of the contact just after the present instant.
    #[must_use]
    pub fn contact(&self) -> Contact {
        self.contact_state.contact
    }

    /// Returns the present displacement and velocity of a mass. `index` is the index of the mass in the scene
    /// description. For an invalid index, displacement and velocity are 0.
    #[must_use]
    pub fn mass(&self, index: usize) -> Moment<S> {
        let shape = self.setting.dynamics.shape(index);
        Moment {
            displacement: self.unit * self.sum(shape, |part| part.y),
            velocity: self.unit * self.sum(shape, |part| part.x * part.u),
        }
    }

    /// Returns the present relative displacement z̄ of the contact, and its derivative dz̄/dτ.
    #[must_use]
    pub fn relative(&self) -> (S, S) {
        let at = phase(self.now.t);
        let velocity = if self.contact_state.contact == Contact::Stuck {
            K::stuck_velocity(&self.setting, self.parts.as_ref(), at)
        } else {
            self.setting.relative_velocity(self.parts.as_ref(), at).0
        };
        let displacement = self.setting.relative(self.parts.as_ref(), at);
        (self.unit * displacement, self.unit * velocity)
    }

    /// Returns the present contact force, divided by P. While the contact slides, the force is the kinetic friction.
    /// While the contact sticks, the force keeps the contact at rest. A positive force opposes positive sliding.
    #[must_use]
    pub fn friction(&self) -> S {
        let (at, parts) = (phase(self.now.t), self.parts.as_ref());
        let setting = &self.setting;
        self.unit * setting.contact_force(&self.level, parts, &self.contact_state, at)
    }

    fn sum(&self, shape: &[S], of: impl Fn(&Part<S>) -> S) -> S {
        let parts = self.parts.as_ref().iter().zip(shape);
        parts.fold(S::constant(0.0), |sum, (part, component)| {
            sum + *component * of(part)
        })
    }

    /// Advances the simulation to the next event, but by at most `reach` in rad of the excitation (τ). A `reach` of 0
    /// changes nothing.
    ///
    /// The events of a simulation do not depend on the values of `reach`. Rounding errors do not accumulate over many
    /// short calls.
    ///
    /// # Errors
    /// [`OutOfDomain`] if `reach` is negative, infinite or NaN. The simulation then keeps its state.
    pub fn advance(&mut self, reach: S) -> Result<Segment<S>, OutOfDomain> {
        if !(S::constant(0.0) <= reach && reach.is_finite()) {
            return Err(OutOfDomain::Duration(Given::of(reach)));
        }
        Ok(self.advance_by(reach))
    }

    /// Advances the simulation to the next event, but by at most `reach`. The caller has checked that `reach` is finite
    /// and not negative.
    fn advance_by(&mut self, reach: S) -> Segment<S> {
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
        segment.contact = self.find_end(reach).contact_state.contact;
        let (length, mut ended) = self.advance_within(reach);
        segment.length = length;
        // An earlier call searched for the end of this segment, perhaps with a shorter reach. If the segment ends
        // without an event before `reach`, the motion continues in another segment.
        if known && ended == Some(None) && length < reach {
            let (more, next) = self.advance_within(reach - length);
            segment.length = length + more;
            ended = next;
        }
        if self.level.lines().is_some() {
            for _ in 0..MAX_STRETCHES {
                if ended != Some(None) || !(segment.length < reach) {
                    break;
                }
                let (more, next) = self.advance_within(reach - segment.length);
                segment.length = segment.length + more;
                ended = next;
            }
        }
        segment.event = ended.flatten();
        segment
    }

    /// Returns the current segment with its end. If the end is unknown, the function searches for it within `reach`,
    /// but at least within one cycle.
    fn find_end(&mut self, reach: S) -> Sought<S> {
        if let Some(sought) = self.sought {
            return sought;
        }
        let reach = reach.max(S::pi() + S::pi());
        let parts = self.parts.as_mut();
        let level = &mut self.level;
        let mut sought = self
            .setting
            .seek_under(level, parts, self.contact_state, reach);
        if sought.holds() {
            // The contact cannot leave zero velocity. The contact therefore continues to stick.
            let (modes, held) = self.setting.split(parts);
            let oscillators = (&*modes, &*held);
            let end = ended(&self.setting, oscillators, &sought, phase(self.now.t));
            sought = seek(&self.setting, modes, held, end.contact_state, reach);
        }
        self.contact_state = sought.contact_state;
        self.sought = Some(sought);
        sought
    }

    /// Advances the simulation within the current segment, by at most `reach`. The first result is the time advanced.
    /// The second result is `None` if the segment has not ended. If the segment ends at an event, the second result
    /// contains this event. If the segment ends without an event, the second result is `Some(None)`.
    fn advance_within(&mut self, reach: S) -> (S, Option<Option<Event>>) {
        let sought = self.find_end(reach);
        let parts = self.parts.as_mut();
        let rest = self.passed.short_of(sought.tau).max(S::constant(0.0));
        if reach < rest {
            self.passed = self.passed.plus(reach);
            self.now = self.now.moved(Total::zero().plus(reach));
            let at = (self.passed.value, phase(self.now.t));
            self.setting.place_under(&self.level, parts, &sought, at);
            if self.contact_state.contact == Contact::Stuck {
                let (_, held) = self.setting.split(parts);
                self.contact_state.memory = K::memory_at(&self.setting, held, sought.offset, at.1);
            }
            return (reach, None);
        }
        self.now = self.start.moved(Total::zero().plus(sought.tau));
        let to = phase(self.now.t);
        self.setting
            .place_under(&self.level, parts, &sought, (sought.tau, to));
        let (modes, held) = self.setting.split(parts);
        let end = ended(&self.setting, (&*modes, &*held), &sought, to);
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

impl<'a, S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>, L: KineticLaw<'a, S>, K: ContactChain<S>>
    Iterator for Simulation<'a, S, P, L, K>
{
    type Item = Segment<S>;

    fn next(&mut self) -> Option<Segment<S>> {
        Some(self.advance_by(S::pi() + S::pi()))
    }
}

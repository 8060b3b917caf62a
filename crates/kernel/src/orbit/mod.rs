//! Searches for the steady state of a chain in any regime. A steady state is a motion that repeats after one or
//! several cycles of the excitation. An [`Orbit`] contains the motion, the stops of the contact and the Floquet
//! multipliers.
//!
//! The search first follows the motion ([`motion`](crate::motion)) from the start, until the pattern of events repeats
//! from cycle to cycle. Newton's method then converges in a few steps. A symmetric steady state is a fixed point of the
//! half-period map times −1. Other steady states are fixed points of the period map.
//!
//! A period consists of segments. In a segment the contact either sticks, or slides in one direction. A stored steady
//! state is a list of *marks*. A mark is the start of a segment, with the contact's state, the phase and the relative
//! displacement z̄. The *stuck chain* is the chain with its contact stuck.

mod build;
mod candidate;
mod carrying;
mod closed;
mod continuum;
mod cycle_map;
mod extent;
mod gauss;
mod hold;
mod motion;
mod newton;
mod provides;
mod question;
mod rates;
mod record;
mod relaxed;
mod scene;
mod segments;
mod shooting;
mod start;
mod states;
mod types;
mod wander;

pub use candidate::MAX_PERIOD;
pub use carrying::{CarryingStorage, NoDerivative};
pub use motion::OrbitMotion;
pub use question::OrbitQuestion;
pub use scene::{KnownState, ProvidesOrbit};
pub use start::Start;
pub use states::States;
pub use types::{MAX_CYCLES, MAX_SEGMENTS, MAX_STEPS, Orbit};
pub use wander::MAX_CYCLES_FOLLOWED;

use crate::combination::Combination;
use crate::contact::sums::Chain;
use crate::motion::{Contact, ContactChain, Law, Part};
use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;
use segments::Segments;
use types::SegmentStart;

/// Returns the number of scalars of memory that an orbit (steady state) of a scene with a rigid contact needs. `modes`
/// is the number of modes of the scene, and `driven` the number of modes that the contact drives.
#[must_use]
pub const fn numbers(modes: usize, driven: usize) -> usize {
    numbers_of(modes, 2 * driven)
}

/// Returns the number of scalars of memory that an orbit (steady state) needs, for a scene with `modes` modes. `size`
/// is the number of scalars in a state: two for each mode that the contact drives, and one more if the contact is
/// elastic.
#[must_use]
pub const fn numbers_of(modes: usize, size: usize) -> usize {
    MAX_SEGMENTS * 2 * modes + size * size + 2 * size
}

/// A steady state in an emitted solver. Its data are in arrays.
pub type FixedOrbit<
    S,
    const PARTS: usize,
    const NUMBERS: usize,
    const MULTIPLIERS: usize,
    K = Chain<S>,
> = Orbit<'static, S, [Part<S>; PARTS], [S; NUMBERS], [Complex<S>; MULTIPLIERS], K>;

/// The steady motion of the contact or of a mass in a [`FixedOrbit`] (a steady state in an emitted solver).
pub type FixedOrbitMotion<
    'o,
    S,
    const PARTS: usize,
    const NUMBERS: usize,
    const MULTIPLIERS: usize,
    K = Chain<S>,
> = OrbitMotion<'o, 'static, S, [Part<S>; PARTS], [S; NUMBERS], [Complex<S>; MULTIPLIERS], K>;

impl<'a, S, P, V, C, K> Orbit<'a, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    fn marks(&self) -> &[SegmentStart<S>] {
        self.marks.get(..self.count).unwrap_or_default()
    }

    /// Returns an iterator over the segments of the period, in the order of time.
    fn segments(&self) -> Segments<'_, 'a, S, P, V, C, K> {
        Segments::from(self, 0)
    }

    /// Returns the friction ratio β of this steady state: F/P, or F/(k₁Y) for base motion.
    #[must_use]
    pub fn beta(&self) -> S {
        self.setting.beta
    }

    /// Returns the period of the steady state, in cycles of the excitation. The period is 1, or up to [`MAX_PERIOD`]
    /// for a subharmonic state.
    #[must_use]
    pub fn period(&self) -> u32 {
        self.period
    }

    /// Returns true if the motion repeats. If the result is false, the motion did not settle in [`MAX_CYCLES`] cycles,
    /// and the orbit contains only its last [`MAX_PERIOD`] cycles. An amplitude is then the largest amplitude in these
    /// last cycles, and a harmonic is the mean over the last cycles.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.settled
    }

    /// Returns the number of stops of the contact in a period of the steady state.
    #[must_use]
    pub fn stops(&self) -> usize {
        self.stops
    }

    /// Returns the number of reversals in a period of the steady state. A reversal is a change of the sliding direction
    /// without a stop.
    #[must_use]
    pub fn reversals(&self) -> usize {
        self.reversals
    }

    /// Returns the fraction of the period during which the contact sticks.
    #[must_use]
    pub fn stuck_fraction(&self) -> S {
        let stuck = self.sticking_intervals();
        let sum = stuck.fold(S::constant(0.0), |sum, (_, length)| sum + length);
        sum * S::inverse_pi() * S::constant(0.5) / self.cycles()
    }

    /// Returns the distance that the contact slides in a period, ∮|dz̄|, in units of P/k₁ (of the base amplitude Y for
    /// base motion). The work of friction in a period is β times this distance.
    #[must_use]
    pub fn sliding_distance(&self) -> S {
        let zero = S::constant(0.0);
        let slid = |from: &SegmentStart<S>, to: &SegmentStart<S>| {
            // A stuck contact does not slide, even if its own spring lets it move.
            if from.contact_state.contact == Contact::Stuck {
                zero
            } else {
                (to.relative - from.relative).abs()
            }
        };
        let mut distance = zero;
        let mut last: Option<SegmentStart<S>> = None;
        // Within a segment the sliding direction does not change. The sliding distance is therefore the distance
        // between the displacements at both ends.
        for mark in self.segments() {
            if let Some(last) = last {
                distance = distance + slid(&last, &mark);
            }
            last = Some(mark);
        }
        let around = last.zip(self.marks().first());
        let closing = around.map_or(zero, |(last, first)| slid(&last, first));
        distance + closing
    }

    /// Returns the period of the steady state in cycles of the excitation, as a scalar.
    fn cycles(&self) -> S {
        S::constant(f64::from(self.period))
    }

    /// Returns the phase `t` within the period of the motion. The function subtracts whole periods. Both phases are in
    /// half-turns (π rad).
    fn within(&self, t: S) -> S {
        let whole = self.cycles() * S::constant(2.0);
        t - (t / whole).floor() * whole
    }

    /// Returns the phase of the excitation at the start of a segment, in half-turns (π rad). The phase is 0 at the
    /// maximum of the excitation closest to τ = 0. At τ = 0 the contact leaves its largest relative displacement.
    fn angle(&self, mark: &SegmentStart<S>) -> S {
        let one = S::constant(1.0);
        let past = if one < self.origin {
            one
        } else {
            S::constant(0.0)
        };
        mark.contact_state.t + S::constant(2.0) * (mark.cycle - self.origin_cycle - past)
    }

    /// Returns the intervals in which the contact sticks. Each item contains the start and the length of an interval,
    /// both in rad of the excitation. The start is the excitation's phase, from 0 to 2π times the number of cycles in
    /// the period. The phase is 0 at a maximum of the excitation. A subharmonic state has several maxima in a period.
    /// Phase 0 is then the maximum closest to τ = 0 (see [`origin`](Self::origin)).
    pub fn sticking_intervals(&self) -> impl Iterator<Item = (S, S)> + '_ {
        let stuck = |contact: &Contact| *contact == Contact::Stuck;
        let intervals = self
            .intervals()
            .filter(move |(_, _, contact)| stuck(contact));
        intervals.map(|(start, length, _)| (start, length))
    }

    /// Returns all intervals of the period, in the order of time. In an interval the contact either sticks, or slides
    /// in one direction. Each item contains the start of the interval, its length and the contact state. The start is a
    /// phase as [`sticking_intervals`](Self::sticking_intervals) describes it. The last and the first interval may have
    /// the same contact state, because the period may begin in the middle of an interval.
    pub fn intervals(&self) -> impl Iterator<Item = (S, S, Contact)> + '_ {
        self.segments().map(|mark| {
            let start = self.within(self.angle(&mark)) * S::pi();
            (start, mark.length, mark.contact_state.contact)
        })
    }

    /// Returns the contact state and the friction force at the phase τ in rad. The force is divided by P (by k₁Y for
    /// base motion). At τ = 0 the contact leaves its largest relative displacement. While the contact slides, the
    /// force is β times the sign of the velocity. While a rigid contact sticks, it is the force that keeps the contact
    /// at rest. While an elastic contact sticks, it is the force of the contact's spring. A positive force opposes
    /// positive sliding.
    pub fn friction(&self, tau: S) -> (Contact, S) {
        let Some((mut segments, mark, since)) = Segments::at(self, tau) else {
            return (Contact::Stuck, S::constant(0.0));
        };
        let contact = mark.contact_state.contact;
        if contact != Contact::Stuck {
            return (contact, self.setting.law().kinetic(contact));
        }
        let (modes, stuck_modes) = self.setting.split(segments.parts());
        let (force, _) =
            self.setting
                .start_sticking(modes, stuck_modes, &mark.contact_state, mark.length);
        (contact, force.local(since).value)
    }

    /// Returns true if the motion of the contact and of every mass repeats with the opposite sign after half a period.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// Returns the Floquet multipliers of the steady state: the factors by which small deviations from it grow in a
    /// period. The list includes only deviations of modes that the contact drives. The slice is empty if the motion
    /// does not repeat.
    #[must_use]
    pub fn multipliers(&self) -> &[Complex<S>] {
        if self.settled {
            self.multipliers.as_ref()
        } else {
            &[]
        }
    }

    fn largest_multiplier(&self) -> S {
        let moduli = self.multipliers().iter();
        moduli.fold(S::constant(0.0), |most, value| {
            most.max(complex::modulus(*value, true))
        })
    }

    /// Returns true if no small deviation from the steady state grows. A state in a continuum of steady states is
    /// stable in this sense.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.settled
            && self.largest_multiplier() <= S::constant(1.0 + candidate::ON_CIRCLE * S::EPSILON)
    }

    /// Returns true if some small deviation does not decay exponentially. The steady state then belongs to a continuum
    /// of steady states, or lies at the end of one.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        self.marginal
    }

    /// Returns the largest absolute offset of the contact in the continuum of steady states, in units of P/k₁ (of the
    /// base amplitude Y for base motion). Every state of the continuum has an offset between minus and plus this
    /// bound. A bound exists for a stuck contact, and for a chain without damping at r = 1/(2n), with n = 1, 2, ….
    /// Returns `None` for other states, or if the bound is unknown.
    #[must_use]
    pub fn offset_range(&self) -> Option<S> {
        self.offset_range
    }

    /// Returns the phase of the excitation at τ = 0, in rad. At τ = 0 the contact's relative motion leaves its maximum.
    /// The load is proportional to cos(τ + origin).
    #[must_use]
    pub fn origin(&self) -> S {
        let angle = self.origin * S::pi();
        if S::pi() < angle {
            angle - S::pi() - S::pi()
        } else {
            angle
        }
    }

    /// Returns the steady motion of the contact: its relative displacement z̄ as a function of time.
    pub fn contact(&self) -> OrbitMotion<'_, 'a, S, P, V, C, K> {
        OrbitMotion::of_contact(self)
    }

    /// Returns the steady motion of a mass. `index` is the index of the mass in the scene description. An invalid index
    /// returns a motion at rest.
    pub fn mass(&self, index: usize) -> OrbitMotion<'_, 'a, S, P, V, C, K> {
        let dynamics = &self.setting.dynamics;
        if dynamics.moves_as_contact(index) {
            self.contact()
        } else {
            let combination = Combination {
                shape: dynamics.shape(index),
                base: S::constant(0.0),
            };
            OrbitMotion::of_combination(self, combination)
        }
    }

    /// Returns the steady motion of the contact's relative displacement with the opposite sign, −z̄.
    pub fn reversed_contact(&self) -> OrbitMotion<'_, 'a, S, P, V, C, K> {
        OrbitMotion::of_reversed_contact(self)
    }

    /// Returns the mode shapes of all masses in one slice, and the number of modes. The components of the first mass
    /// in all modes come first, then those of the second mass, and so on. The modes are those of the
    /// [`Dynamics`](crate::motion::Dynamics) data.
    pub fn shapes(&self) -> (&'a [S], usize) {
        let dynamics = &self.setting.dynamics;
        (dynamics.shapes, dynamics.modes.len())
    }

    /// Returns the steady motion of a linear combination of masses and base. `combination` contains the components of
    /// the combination in the modes of the [`Dynamics`](crate::motion::Dynamics) data.
    pub fn combination<'o>(
        &'o self,
        combination: Combination<'o, S>,
    ) -> OrbitMotion<'o, 'a, S, P, V, C, K> {
        OrbitMotion::of_combination(self, combination)
    }

    /// Returns the steady motion of a mass. `index` is the index of the mass in the scene description. An invalid index
    /// returns `None`.
    pub fn mass_at(&self, index: usize) -> Option<OrbitMotion<'_, 'a, S, P, V, C, K>> {
        let known = !self.setting.dynamics.shape(index).is_empty();
        known.then(|| self.mass(index))
    }
}

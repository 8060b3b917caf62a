//! The steady state in any regime: the motion that repeats after one cycle of the excitation or after several, its
//! stops, and how deviations from it grow.
//!
//! Some cycles are followed from the start, exactly ([`simulation`](crate::simulation)), until their
//! pattern of events repeats; then Newton's method on the half-period map times −1, whose fixed point
//! is a symmetric steady state, or on the period map, finishes in a few steps.

mod build;
mod candidate;
mod carrying;
mod closed;
mod continuum;
mod cycle_map;
mod extent;
mod gauss;
mod hold;
mod matrix;
mod motion;
mod newton;
mod provides;
mod rates;
mod record;
mod relaxed;
mod segments;
mod shooting;
mod start;
mod states;
mod variational;

pub use candidate::MAX_PERIOD;
pub use carrying::NoDerivative;
pub use motion::OrbitMotion;
pub use provides::ProvidesOrbit;
pub use shooting::{MAX_CYCLES, MAX_STEPS};
pub use start::Start;
pub use states::{Known, States};

use crate::number::complex::{self, Complex};
use crate::number::scalar::Float;
use crate::simulation::{Contact, ContactState, Part, Setting};
use segments::Segments;

/// A cycle of more segments than this is not reported; a period of several cycles may have so many for each.
pub const MAX_SEGMENTS: usize = 64;

/// How many numbers an orbit of a scene works in: `modes` of which the contact drives `driven`.
#[must_use]
pub const fn numbers(modes: usize, driven: usize) -> usize {
    MAX_SEGMENTS * 2 * modes + 4 * driven * driven + 4 * driven
}

/// A segment of the period.
#[derive(Clone, Copy, Debug)]
struct SegmentStart<S> {
    /// How the contact stands at its start, and the excitation within its cycle.
    contact_state: ContactState<S>,
    /// Which cycle that is, counted from the first mark's.
    cycle: S,
    /// Its length in τ.
    length: S,
    /// z̄ at its start.
    relative: S,
    /// So many segments after it are not kept: they are followed anew from this one.
    more: u32,
}

impl<S: Float> SegmentStart<S> {
    /// What an array of them starts from.
    fn empty() -> Self {
        let zero = S::constant(0.0);
        Self {
            contact_state: ContactState {
                t: zero,
                contact: Contact::Stuck,
                departing: None,
                wedged: false,
            },
            cycle: zero,
            length: zero,
            relative: zero,
            more: 0,
        }
    }

    /// z̄ at its end, if it sticks: what it was at the start, to the last digit.
    fn stuck_at(&self) -> Option<S> {
        (self.contact_state.contact == Contact::Stuck).then_some(self.relative)
    }
}

/// How much longer than a period a segment may seem to be.
fn slack<S: Float>() -> S {
    newton::agreement()
}

/// A steady state: a motion that repeats after one cycle of the excitation, or after [`Orbit::period`] of them.
///
/// `P` holds parts, `V` numbers ([`numbers`]) and `C` multipliers (two for each mode that the
/// contact drives): arrays in emitted code, vectors at run time.
#[derive(Clone, Debug)]
pub struct Orbit<'a, S, P, V, C> {
    setting: Setting<'a, S>,
    parts: P,
    numbers: V,
    multipliers: C,
    marks: [SegmentStart<S>; MAX_SEGMENTS],
    count: usize,
    /// In cycles of the excitation.
    period: u32,
    stops: usize,
    reversals: usize,
    symmetric: bool,
    marginal: bool,
    settled: bool,
    /// Of a continuum: how far off its centre the contact's motion may be.
    offset_range: Option<S>,
    /// The excitation's phase in half-turns where τ = 0: a maximum of z̄, at its end; and its cycle, as in [`SegmentStart`].
    origin: S,
    origin_cycle: S,
}

/// A steady state in arrays: of an emitted solver.
pub type FixedOrbit<S, const PARTS: usize, const NUMBERS: usize, const MULTIPLIERS: usize> =
    Orbit<'static, S, [Part<S>; PARTS], [S; NUMBERS], [Complex<S>; MULTIPLIERS]>;

/// The steady motion of the contact or of a mass in a [`FixedOrbit`].
pub type FixedOrbitMotion<
    'o,
    S,
    const PARTS: usize,
    const NUMBERS: usize,
    const MULTIPLIERS: usize,
> = OrbitMotion<'o, 'static, S, [Part<S>; PARTS], [S; NUMBERS], [Complex<S>; MULTIPLIERS]>;

impl<'a, S, P, V, C> Orbit<'a, S, P, V, C>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
{
    fn marks(&self) -> &[SegmentStart<S>] {
        self.marks.get(..self.count).unwrap_or_default()
    }

    /// The segments of the period, one after the other.
    fn segments(&self) -> Segments<'_, 'a, S, P, V, C> {
        Segments::from(self, 0)
    }

    /// β = F/P.
    #[must_use]
    pub fn beta(&self) -> S {
        self.setting.beta
    }

    /// After how many cycles of the excitation the motion repeats: 1, or up to [`MAX_PERIOD`] for a subharmonic state.
    #[must_use]
    pub fn period(&self) -> u32 {
        self.period
    }

    /// Whether the motion repeats.  Otherwise this is what it does in its last [`MAX_PERIOD`] cycles, after it has gone
    /// through [`MAX_CYCLES`] without settling: an amplitude is the largest that was seen in those, a harmonic the mean
    /// over them.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.settled
    }

    /// How often the contact stops in a period.
    #[must_use]
    pub fn stops(&self) -> usize {
        self.stops
    }

    /// How often the direction of sliding changes in a period without a stop.
    #[must_use]
    pub fn reversals(&self) -> usize {
        self.reversals
    }

    /// The part of the period for which the contact sticks.
    #[must_use]
    pub fn stuck_fraction(&self) -> S {
        let stuck = self.sticking_intervals();
        let sum = stuck.fold(S::constant(0.0), |sum, (_, length)| sum + length);
        sum * S::inverse_pi() * S::constant(0.5) / self.cycles()
    }

    /// How far the contact slides in a period, ∮|dz̄|.  The friction force takes β times as much work out of the motion.
    #[must_use]
    pub fn sliding_distance(&self) -> S {
        let zero = S::constant(0.0);
        let mut distance = zero;
        let mut last: Option<SegmentStart<S>> = None;
        // Within a segment the direction of sliding does not change.
        for mark in self.segments() {
            if let Some(last) = last {
                distance = distance + (mark.relative - last.relative).abs();
            }
            last = Some(mark);
        }
        let around = last.zip(self.marks().first());
        let closing = around.map_or(zero, |(last, first)| (first.relative - last.relative).abs());
        distance + closing
    }

    /// The period, in cycles.
    fn cycles(&self) -> S {
        S::constant(f64::from(self.period))
    }

    /// A phase of the period, in half-turns, between 0 and its end.
    fn within(&self, t: S) -> S {
        let whole = self.cycles() * S::constant(2.0);
        t - (t / whole).floor() * whole
    }

    /// The excitation's angle at a mark, in half-turns: 0 at the maximum of the excitation next to τ = 0.
    fn angle(&self, mark: &SegmentStart<S>) -> S {
        let one = S::constant(1.0);
        let past = if one < self.origin {
            one
        } else {
            S::constant(0.0)
        };
        mark.contact_state.t + S::constant(2.0) * (mark.cycle - self.origin_cycle - past)
    }

    /// The intervals for which the contact sticks: start and length.  The start is τ of the excitation, between 0 and 2π
    /// times the period.  It is 0 at a maximum of the excitation; of several, at the one next to
    /// [`origin`](Self::origin).
    pub fn sticking_intervals(&self) -> impl Iterator<Item = (S, S)> + '_ {
        let stuck = |contact: &Contact| *contact == Contact::Stuck;
        let intervals = self
            .intervals()
            .filter(move |(_, _, contact)| stuck(contact));
        intervals.map(|(start, length, _)| (start, length))
    }

    /// What the contact does, one interval after the other, all around the period: start, as of
    /// [`sticking_intervals`](Self::sticking_intervals), length, and whether it sticks or which way it slides.  What
    /// the contact does where the last one ends and the first one begins may be the same.
    pub fn intervals(&self) -> impl Iterator<Item = (S, S, Contact)> + '_ {
        self.segments().map(|mark| {
            let start = self.within(self.angle(&mark)) * S::pi();
            (start, mark.length, mark.contact_state.contact)
        })
    }

    /// What the contact does at τ, counted from where the relative motion leaves its maximum, and the friction force in
    /// it over P: β while it slides, what holds it while it sticks; positive against positive sliding.
    pub fn friction(&self, tau: S) -> (Contact, S) {
        let Some((mut segments, mark, since)) = Segments::at(self, tau) else {
            return (Contact::Stuck, S::constant(0.0));
        };
        let contact = mark.contact_state.contact;
        if contact != Contact::Stuck {
            return (contact, contact.sign::<S>() * self.setting.beta);
        }
        let (modes, held) = self.setting.split(segments.parts());
        let (force, _) = self
            .setting
            .stick(modes, held, &mark.contact_state, mark.length);
        (contact, force.local(since).value)
    }

    /// Whether every motion repeats with the opposite sign after half a period.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// The Floquet multipliers: by what small deviations of the modes that the contact drives are
    /// multiplied in a period.  None where nothing repeats.
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

    /// Whether no small deviation grows.  A marginal state is stable in this sense.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.settled
            && self.largest_multiplier() <= S::constant(1.0 + candidate::ON_CIRCLE * S::EPSILON)
    }

    /// Whether some deviation stays for good, or dies more slowly than any power: the state is a
    /// member of a continuum, or at its end.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        self.marginal
    }

    /// How far off its centre the contact may come to rest or slide, |offset| over P/k₁, for base motion over Y: every state
    /// of a continuum is between −this and this.  A stuck contact has one, and a chain without damping at r = 1/2n; none
    /// elsewhere, and where it is not known.
    #[must_use]
    pub fn offset_range(&self) -> Option<S> {
        self.offset_range
    }

    /// The excitation's angle at τ = 0, where the relative motion in the contact leaves its maximum:
    /// the load is cos(τ + origin).
    #[must_use]
    pub fn origin(&self) -> S {
        let angle = self.origin * S::pi();
        if S::pi() < angle {
            angle - S::pi() - S::pi()
        } else {
            angle
        }
    }

    /// The relative motion in the contact.
    pub fn contact(&self) -> OrbitMotion<'_, 'a, S, P, V, C> {
        OrbitMotion::of_contact(self)
    }

    /// The motion of a mass, by its place in the description; rest if there is no such mass.
    pub fn mass(&self, index: usize) -> OrbitMotion<'_, 'a, S, P, V, C> {
        let dynamics = &self.setting.dynamics;
        if dynamics.moves_as_contact(index) {
            self.contact()
        } else {
            OrbitMotion::of_mass(self, dynamics.shape(index))
        }
    }

    /// The same; none if there is no such mass.
    pub fn mass_at(&self, index: usize) -> Option<OrbitMotion<'_, 'a, S, P, V, C>> {
        let known = !self.setting.dynamics.shape(index).is_empty();
        known.then(|| self.mass(index))
    }
}

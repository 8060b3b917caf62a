//! The steady state in any regime: the motion that repeats from cycle to cycle, its stops, and how
//! deviations from it grow.
//!
//! Some cycles are followed from the start, exactly ([`simulation`](crate::simulation)), until their
//! pattern of events repeats; then Newton's method on the half-period map times −1, whose fixed point
//! is a symmetric steady state, or on the period map, finishes in a few steps.

mod build;
mod closed;
mod continuum;
mod flow;
mod gauss;
mod matrix;
mod motion;
mod solve;
mod tangent;

pub use motion::OrbitMotion;
pub use solve::{MAX_CYCLES, MAX_STEPS};

use crate::complex::{self, Complex};
use crate::scalar::Float;
use crate::simulation::{Contact, Event, Part, Setting};

/// A cycle of more segments than this is not reported.
pub const MAX_SEGMENTS: usize = 64;

/// How many numbers an orbit of a scene works in: `modes` of which the contact drives `driven`.
#[must_use]
pub const fn numbers(modes: usize, driven: usize) -> usize {
    MAX_SEGMENTS * 2 * modes + 4 * driven * driven + 4 * driven
}

/// A segment of the cycle.
#[derive(Clone, Copy, Debug)]
struct Mark<S> {
    /// The excitation's phase at its start, in half-turns.
    t: S,
    /// Its length in τ.
    length: S,
    contact: Contact,
    departing: Option<S>,
    event: Option<Event>,
    /// z̄ at its start.
    relative: S,
}

/// A steady state: a motion that repeats after one cycle of the excitation.
///
/// `P` holds parts, `V` numbers ([`numbers`]) and `C` multipliers (two for each mode that the
/// contact drives): arrays in emitted code, vectors at run time.
#[derive(Clone, Debug)]
pub struct Orbit<'a, S, P, V, C> {
    setting: Setting<'a, S>,
    parts: P,
    numbers: V,
    multipliers: C,
    marks: [Mark<S>; MAX_SEGMENTS],
    count: usize,
    symmetric: bool,
    marginal: bool,
    /// The excitation's phase in half-turns where τ = 0: a maximum of z̄, at its end.
    origin: S,
}

impl<'a, S, P, V, C> Orbit<'a, S, P, V, C>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
{
    fn marks(&self) -> &[Mark<S>] {
        self.marks.get(..self.count).unwrap_or_default()
    }

    fn count(&self, event: Event) -> usize {
        let marks = self.marks().iter();
        marks.filter(|mark| mark.event == Some(event)).count()
    }

    /// How often the contact stops in a cycle.
    #[must_use]
    pub fn stops(&self) -> usize {
        self.count(Event::Stop)
    }

    /// How often the direction of sliding changes in a cycle without a stop.
    #[must_use]
    pub fn reversals(&self) -> usize {
        self.count(Event::Reversal)
    }

    /// The part of the cycle for which the contact sticks.
    #[must_use]
    pub fn stuck_fraction(&self) -> S {
        let stuck = self.sticking_intervals();
        let sum = stuck.fold(S::constant(0.0), |sum, (_, length)| sum + length);
        sum * S::inverse_pi() * S::constant(0.5)
    }

    /// The intervals for which the contact sticks: start, as τ of the excitation (0 at its maximum,
    /// below 2π), and length.
    pub fn sticking_intervals(&self) -> impl Iterator<Item = (S, S)> + '_ {
        let marks = self.marks().iter();
        marks
            .filter(|mark| mark.contact == Contact::Stuck)
            .map(|mark| (mark.t * S::pi(), mark.length))
    }

    /// Whether every motion repeats with the opposite sign after half a cycle.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// The Floquet multipliers: by what small deviations of the modes that the contact drives are
    /// multiplied in a cycle.
    #[must_use]
    pub fn multipliers(&self) -> &[Complex<S>] {
        self.multipliers.as_ref()
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
        self.largest_multiplier() <= S::constant(1.0 + solve::ON_CIRCLE * S::EPSILON)
    }

    /// Whether some deviation stays for good, or dies more slowly than any power: the state is a
    /// member of a continuum, or at its end.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        self.marginal
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
        OrbitMotion::of_mass(self, self.setting.dynamics.shape(index))
    }
}

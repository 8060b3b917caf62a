//! Interface between the motion of a chain and the law of its contact.
//!
//! The type of the chain's constants selects the law. For example, [`Chain`] selects the law of a rigid contact.
//! Motion, simulation and steady states have this type as a type parameter. A scene therefore contains only the code
//! of its own law.

use super::kinetic::KineticLine;
use super::state::{Contact, ContactState, SegmentEnd};
use crate::contact::sums::Chain;
use crate::motion::oscillator::Part;
use crate::motion::setting::MotionSetting;
use crate::number::complex::Complex;
use crate::number::scalar::Float;
use core::fmt::Debug;

/// Friction law of a contact: its forces, and the decision between sticking and sliding. All forces have the same
/// unit.
pub trait Law<S: Float>: Copy + Debug {
    /// Returns the kinetic friction force at zero sliding speed.
    fn level(self) -> S;

    /// Returns the largest contact force at which the contact sticks (static friction force).
    fn grip(self) -> S;

    /// Returns true if the distance between two motions never grows, for any two initial states.
    fn is_contraction(self) -> bool;

    /// Decides what the contact does at zero relative velocity. `force` is the force that would keep the contact at
    /// rest. Returns the start of sliding, or `None` if the contact sticks.
    fn leave_rest(self, force: S) -> Option<SlideStart<S>>;

    /// Returns the start of sliding in the direction of `contact`, at the instant at which the force in the stuck
    /// contact reaches the static friction force.
    fn break_away(self, contact: Contact) -> SlideStart<S>;

    /// Returns the start of sliding in the direction of `contact`. `force` is the force that would keep the contact at
    /// rest.
    #[inline]
    fn slide(self, contact: Contact, force: S) -> SlideStart<S> {
        SlideStart {
            contact,
            excess: force.abs() - self.level(),
        }
    }

    /// Returns the force in a stuck contact, limited to the static friction force (the largest force at which the
    /// contact sticks).
    fn limited(self, force: S) -> S {
        force.abs().min(self.grip()).copysign(force)
    }

    /// Returns true if `force` is so close to the static friction force that rounding decides whether a stuck contact
    /// slides. `share` is the largest difference that counts as close, divided by the static friction force.
    fn is_marginal(self, force: S, share: S) -> bool {
        let grip = self.grip();
        (force.abs() - grip).abs() <= grip * share
    }

    /// Returns the contact force while the contact slides under constant kinetic friction.
    #[inline]
    fn kinetic(self, contact: Contact) -> S {
        contact.sign::<S>() * self.level()
    }

    /// Returns the coefficients [level, slope] of the contact force on a line of the friction law. The force is level +
    /// slope·velocity, where the velocity is the relative velocity of the contact.
    #[inline]
    fn kinetic_on(self, line: &KineticLine<S>, contact: Contact) -> [S; 2] {
        let sign: S = contact.sign();
        [sign * self.level() * line.level, self.level() * line.slope]
    }

    /// Returns the contact force while the contact slides at `speed`, on a line of the friction law that contains this
    /// speed.
    #[inline]
    fn kinetic_at(self, line: &KineticLine<S>, contact: Contact, speed: S) -> S {
        contact.sign::<S>() * (self.level() * (line.level + line.slope * speed))
    }
}

/// Constants of a chain and of the law of its contact.
pub trait ContactChain<S: Float>: Copy + Debug {
    /// Type of the law that gives the contact's force.
    type Law: Law<S>;

    /// Returns the number of modes of the chain minus the number of modes of the chain with its contact stuck.
    fn lost_modes(&self) -> usize;

    /// Returns the number of scalars that the contact stores in addition to the states of the modes, while it sticks.
    #[inline]
    fn remembered(&self) -> usize {
        0
    }

    /// Returns the Floquet multipliers of a contact that never slides. The list contains two multipliers for each mode
    /// that the stuck chain lacks, and one multiplier for each stored scalar.
    ///
    /// `true` stands for the multiplier 1 and `false` for 0. Numbers in `f64` would add double-precision arithmetic to
    /// the program of an `f32` scene.
    fn stuck_multipliers(&self) -> &'static [bool];

    /// Returns the compliance of a spring in series with the contact: its displacement per unit of contact force.
    #[inline]
    fn compliance(&self) -> S {
        S::constant(0.0)
    }

    /// Derives the state of the contact (stuck, or its direction of sliding) from the states of the modes at the phase
    /// `t`.
    fn contact_state(
        setting: &MotionSetting<'_, S, Self>,
        parts: &[Part<S>],
        t: S,
    ) -> ContactState<S>;

    /// Derives the state of the contact from the states of the modes, if the contact has been sliding until this
    /// instant.
    #[inline]
    fn sliding_state(
        setting: &MotionSetting<'_, S, Self>,
        parts: &[Part<S>],
        contact_state: &ContactState<S>,
    ) -> ContactState<S> {
        Self::contact_state(setting, parts, contact_state.t)
    }

    /// Returns the number that the contact stores when it stops, or `None` if the law stores nothing. The argument of
    /// type `Contact` is the direction in which the contact slid.
    #[inline]
    fn memory_at_stop(_: &MotionSetting<'_, S, Self>, _: Contact) -> Option<S> {
        None
    }

    /// Returns the number that the contact stores while it sticks at the displacement `place`, or `None` if the law
    /// stores nothing. `stuck_modes` are the oscillators of the chain with its contact stuck. `at` is sine and cosine
    /// of the excitation's phase at this instant.
    #[inline]
    fn memory_at(_: &MotionSetting<'_, S, Self>, _: &[Part<S>], _: S, _: (S, S)) -> Option<S> {
        None
    }

    /// Changes the oscillators of the chain with its contact stuck, so that they agree with the number that the contact
    /// stores. `lifted` is the displacement of the stuck contact, including the displacement of the base.
    #[inline]
    fn adapt(_: &MotionSetting<'_, S, Self>, _: &mut [Part<S>], _lifted: S, _: &ContactState<S>) {}

    /// Returns the constants of the chain that do not depend on the law of the contact.
    fn chain(&self) -> &Chain<S>;

    /// Returns the law with the kinetic friction force `level` and the ratio μ = `stiction` of the static to the
    /// kinetic force.
    fn law_with(&self, level: S, stiction: S) -> Self::Law;

    /// Returns the law with the kinetic friction force `level` and the ratio μ of the chain.
    #[inline]
    fn law(&self, level: S) -> Self::Law {
        self.law_with(level, self.chain().stiction)
    }

    /// Returns the displacement that stays constant while the contact sticks. `contact_state` is the state of the
    /// contact at the start of the segment. `at` is sine and cosine of the excitation's phase at that instant.
    fn stuck_place(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S;

    /// Returns the relative velocity z̄′ while the contact sticks. `at` is sine and cosine of the excitation's phase.
    fn stuck_velocity(setting: &MotionSetting<'_, S, Self>, modes: &[Part<S>], at: (S, S)) -> S;

    /// Returns the contact force, divided by P, while the contact sticks. `contact_state` is the state of the contact
    /// at the start of the segment.
    fn stuck_force(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S;

    /// Returns two components of the contact force while the contact sticks at the displacement `place`: the constant,
    /// and the complex amplitude of the fundamental. The two components do not include the contribution of the modes.
    fn steady_stuck_force(setting: &MotionSetting<'_, S, Self>, place: S) -> (S, Complex<S>);

    /// Completes the record `end` of a segment that ends because the relative velocity vanishes. Sets the slope, the
    /// event, the jump of the force and the next state.
    fn halt(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        at: (S, S),
        end: &mut SegmentEnd<S>,
    );

    /// Completes the record `end` of a segment that ends because the stuck contact breaks away. Sets the event, the
    /// jump of the force and the next state.
    fn break_away(setting: &MotionSetting<'_, S, Self>, contact: Contact, end: &mut SegmentEnd<S>);

    /// Advances small deviations of the state through a segment (the motion between two events), one column after
    /// another. A column contains the displacement y and the scaled velocity u of each mode. `modes` and `stuck_modes`
    /// are the oscillators after the segment. The function overwrites the states in `stuck_modes`.
    fn carry_deviations(
        setting: &MotionSetting<'_, S, Self>,
        oscillators: (&[Part<S>], &mut [Part<S>]),
        contact_state: &ContactState<S>,
        end: &SegmentEnd<S>,
        columns: &mut [S],
    );
}

/// Direction and excess force with which a contact starts to slide.
#[derive(Clone, Copy, Debug)]
pub struct SlideStart<S> {
    /// Direction in which the contact slides.
    pub contact: Contact,
    /// Force that would keep the contact at rest, minus the kinetic friction force.
    pub excess: S,
}

//! Elastic contact of a chain at one frequency ratio: its force while it sticks, and its events.

use super::{ElasticChain, derivative};
use crate::contact::sums::Chain;
use crate::motion::contact::law::{ContactChain, Law};
use crate::motion::contact::rigid::Rigid;
use crate::motion::contact::state::{Contact, ContactState, Event, SegmentEnd};
use crate::motion::oscillator::Part;
use crate::motion::setting::MotionSetting;
use crate::number::complex::Complex;
use crate::number::scalar::Float;

impl<S: Float> ContactChain<S> for ElasticChain<S> {
    type Law = Rigid<S>;

    /// Returns 0. The chain with its contact stuck has as many modes as the contact drives, because the contact can
    /// still move with its spring.
    #[inline]
    fn lost_modes(&self) -> usize {
        0
    }

    /// Returns 1, because a stuck elastic contact stores one number: its force.
    #[inline]
    fn remembered(&self) -> usize {
        1
    }

    /// Returns the Floquet multiplier 1. A deviation of the slider's displacement neither grows nor decays.
    fn stuck_multipliers(&self) -> &'static [bool] {
        &[true]
    }

    #[inline]
    fn compliance(&self) -> S {
        self.compliance
    }

    #[inline]
    fn chain(&self) -> &Chain<S> {
        &self.chain
    }

    #[inline]
    fn law_with(&self, level: S, stiction: S) -> Rigid<S> {
        Rigid { level, stiction }
    }

    /// Returns the state of a stuck contact without force. If β is 0, returns the state of a rigid contact instead.
    fn contact_state(
        setting: &MotionSetting<'_, S, Self>,
        parts: &[Part<S>],
        t: S,
    ) -> ContactState<S> {
        if setting.law().grip().is_zero() {
            return Chain::contact_state(&setting.with(setting.dynamics.chain.chain), parts, t);
        }
        ContactState {
            memory: Some(S::constant(0.0)),
            ..ContactState::stuck(t)
        }
    }

    /// Returns the state of a contact that has been sliding until this instant. If the relative velocity still has the
    /// sign of this sliding, or is zero, the contact continues to slide. If the velocity has the opposite sign, the
    /// contact sticks, and its force is the kinetic friction force of this sliding.
    fn sliding_state(
        setting: &MotionSetting<'_, S, Self>,
        parts: &[Part<S>],
        contact_state: &ContactState<S>,
    ) -> ContactState<S> {
        let contact = contact_state.contact;
        let (velocity, _) = setting.relative_velocity(parts, contact_state.t.sin_cos_pi());
        if contact.sign::<S>() * velocity < S::constant(0.0) {
            return ContactState {
                memory: Self::memory_at_stop(setting, contact),
                ..ContactState::stuck(contact_state.t)
            };
        }
        ContactState {
            memory: None,
            ..*contact_state
        }
    }

    fn memory_at_stop(setting: &MotionSetting<'_, S, Self>, contact: Contact) -> Option<S> {
        Some(setting.law().kinetic(contact))
    }

    fn memory_at(
        setting: &MotionSetting<'_, S, Self>,
        stuck_modes: &[Part<S>],
        place: S,
        at: (S, S),
    ) -> Option<S> {
        let (lifted, _) = setting.lifted(place, at);
        Some(setting.elastic_force(stuck_modes, lifted))
    }

    fn adapt(
        setting: &MotionSetting<'_, S, Self>,
        stuck_modes: &mut [Part<S>],
        lifted: S,
        contact_state: &ContactState<S>,
    ) {
        if let Some(force) = contact_state.memory {
            setting.set_elastic_force(stuck_modes, lifted, force);
        }
    }

    /// Returns the displacement q = z̄ − ρf of the slider. z̄ is the relative displacement of the contact, ρ is the
    /// compliance of the spring, and f is the contact force.
    fn stuck_place(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S {
        let force = contact_state.memory.unwrap_or(S::constant(0.0));
        setting.relative(modes, at) - setting.dynamics.chain.compliance * force
    }

    fn stuck_velocity(setting: &MotionSetting<'_, S, Self>, modes: &[Part<S>], at: (S, S)) -> S {
        setting.relative_velocity(modes, at).0
    }

    fn stuck_force(
        _: &MotionSetting<'_, S, Self>,
        _: &[Part<S>],
        contact_state: &ContactState<S>,
        _: (S, S),
    ) -> S {
        contact_state.memory.unwrap_or(S::constant(0.0))
    }

    fn steady_stuck_force(setting: &MotionSetting<'_, S, Self>, place: S) -> (S, Complex<S>) {
        let receptance = setting.receptance;
        (
            -(place / receptance),
            Complex::new(-(setting.base / receptance), S::constant(0.0)),
        )
    }

    /// Stops the slider. If there is no friction, the spring has no force, and the contact reverses as a rigid contact
    /// does.
    fn halt(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        at: (S, S),
        end: &mut SegmentEnd<S>,
    ) {
        let law = setting.law();
        let before = end.contact_state.contact;
        let force = setting.holding(modes, at);
        end.slope = setting.acceleration(force - law.kinetic(before));
        let free = law.grip().is_zero();
        if let Some(slide) = law.leave_rest(force).filter(|_| free) {
            end.event = (slide.contact != before).then_some(Event::Reversal);
            end.contact_state = setting.sliding_away(end.contact_state.t, slide);
            return;
        }
        end.event = Some(Event::Stop);
        end.contact_state.contact = Contact::Stuck;
        end.contact_state.memory = Self::memory_at_stop(setting, before);
    }

    /// Starts the motion of the slider with the velocity of the contact. With μ > 1 the force falls to the kinetic
    /// force.
    fn break_away(setting: &MotionSetting<'_, S, Self>, contact: Contact, end: &mut SegmentEnd<S>) {
        end.event = Some(Event::Slip);
        end.contact_state.contact = contact;
        end.jump = contact.sign::<S>() * setting.law().break_away(contact).excess;
    }

    fn carry_deviations(
        setting: &MotionSetting<'_, S, Self>,
        oscillators: (&[Part<S>], &mut [Part<S>]),
        contact_state: &ContactState<S>,
        end: &SegmentEnd<S>,
        columns: &mut [S],
    ) {
        derivative::carry(setting, oscillators, contact_state, end, columns);
    }
}

impl<S: Float> MotionSetting<'_, S, ElasticChain<S>> {
    /// Returns the contact force from the oscillators of the chain with its contact stuck. `lifted` is the displacement
    /// of the slider, including the displacement of the base.
    pub(super) fn elastic_force(&self, stuck_modes: &[Part<S>], lifted: S) -> S {
        let modes = stuck_modes.iter().zip(self.dynamics.held);
        modes.fold(-(lifted / self.receptance), |force, (part, mode)| {
            force - mode.force * part.y
        })
    }

    /// Sets the contact force to `force` by a small change of one oscillator of the chain with its contact stuck. This
    /// oscillator is the mode with the largest force per unit of displacement. The change corrects rounding errors:
    /// with a stiff spring, the force that follows from the oscillators is a small difference of large numbers.
    pub(super) fn set_elastic_force(&self, stuck_modes: &mut [Part<S>], lifted: S, force: S) {
        let excess = self.elastic_force(stuck_modes, lifted) - force;
        let modes = stuck_modes.iter_mut().zip(self.dynamics.held);
        let stiffest = modes.reduce(|a, b| {
            if a.1.force.abs() < b.1.force.abs() {
                b
            } else {
                a
            }
        });
        if let Some((part, mode)) = stiffest {
            part.y = part.y + excess / mode.force;
        }
    }
}

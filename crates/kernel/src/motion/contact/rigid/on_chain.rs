//! Rigid contact of a chain at one frequency ratio: its force while it sticks, and its events.

use super::{LOST_MODES, Rigid, derivative};
use crate::contact::sums::Chain;
use crate::motion::clock::phase;
use crate::motion::contact::law::{ContactChain, Law};
use crate::motion::contact::state::{Contact, ContactState, Event, SegmentEnd};
use crate::motion::oscillator::Part;
use crate::motion::setting::MotionSetting;
use crate::number::complex::Complex;
use crate::number::scalar::Float;

impl<S: Float> ContactChain<S> for Chain<S> {
    type Law = Rigid<S>;

    #[inline]
    fn lost_modes(&self) -> usize {
        LOST_MODES
    }

    /// Returns the Floquet multipliers of a contact that never slides: 1 and 0. A deviation of the contact's
    /// displacement stays constant. A deviation of its velocity vanishes immediately.
    fn stuck_multipliers(&self) -> &'static [bool] {
        &[true, false]
    }

    #[inline]
    fn chain(&self) -> &Chain<S> {
        self
    }

    #[inline]
    fn law_with(&self, level: S, stiction: S) -> Rigid<S> {
        Rigid { level, stiction }
    }

    fn contact_state(setting: &MotionSetting<'_, S>, parts: &[Part<S>], t: S) -> ContactState<S> {
        let at = phase(t);
        if let Some(contact) = setting.direction(parts, at) {
            return ContactState {
                contact,
                ..ContactState::stuck(t)
            };
        }
        match setting.law().leave_rest(setting.holding(parts, at)) {
            Some(slide) => setting.sliding_away(t, slide),
            None => ContactState::stuck(t),
        }
    }

    /// Returns the relative displacement z̄ at which the rigid contact sticks.
    fn stuck_place(
        setting: &MotionSetting<'_, S>,
        modes: &[Part<S>],
        _: &ContactState<S>,
        at: (S, S),
    ) -> S {
        setting.relative(modes, at)
    }

    fn stuck_velocity(_: &MotionSetting<'_, S>, _: &[Part<S>], _: (S, S)) -> S {
        S::constant(0.0)
    }

    /// Returns the force that keeps the contact stuck, divided by P.
    fn stuck_force(
        setting: &MotionSetting<'_, S>,
        modes: &[Part<S>],
        _: &ContactState<S>,
        at: (S, S),
    ) -> S {
        setting.holding(modes, at)
    }

    /// Returns the constant and the complex amplitude of the force in a contact that sticks at the relative
    /// displacement z̄ = `place`. This force belongs to the displacement wᵀx̄ = `place` + s cos τ_e, where w is the
    /// direction vector of the contact. s is 1 if the contact rubs on the moving base, otherwise 0. The result does not
    /// contain the contribution of the modes.
    fn steady_stuck_force(setting: &MotionSetting<'_, S>, place: S) -> (S, Complex<S>) {
        let inverse_mass = setting.dynamics.chain.inverse_mass;
        let base = setting.base;
        let mut sine = -(setting.r * setting.drag * base / inverse_mass);
        if !setting.quadrature.vanishes() {
            sine = sine + setting.quadrature / inverse_mass;
        }
        let cosine = setting.load / inverse_mass - base / setting.receptance;
        (-(place / setting.receptance), Complex::new(cosine, sine))
    }

    fn halt(
        setting: &MotionSetting<'_, S>,
        modes: &[Part<S>],
        at: (S, S),
        end: &mut SegmentEnd<S>,
    ) {
        let law = setting.law();
        let before = end.contact_state.contact;
        let force = setting.holding(modes, at);
        end.slope = setting.acceleration(force - law.kinetic(before));
        let Some(slide) = law.leave_rest(force) else {
            end.event = Some(Event::Stop);
            end.contact_state.contact = Contact::Stuck;
            end.jump = law.kinetic(before) - force;
            return;
        };
        // If the contact continues in its direction of sliding, the velocity has only touched zero, and there is no
        // event.
        if slide.contact != before {
            end.event = Some(Event::Reversal);
            end.jump = law.kinetic(before) - law.kinetic(slide.contact);
        }
        end.contact_state = setting.sliding_away(end.contact_state.t, slide);
    }

    fn break_away(setting: &MotionSetting<'_, S>, contact: Contact, end: &mut SegmentEnd<S>) {
        let slide = setting.law().break_away(contact);
        end.event = Some(Event::Slip);
        end.contact_state = setting.sliding_away(end.contact_state.t, slide);
        end.jump = contact.sign::<S>() * slide.excess;
    }

    fn carry_deviations(
        setting: &MotionSetting<'_, S>,
        (modes, stuck_modes): (&[Part<S>], &mut [Part<S>]),
        contact_state: &ContactState<S>,
        end: &SegmentEnd<S>,
        columns: &mut [S],
    ) {
        derivative::carry(setting, (modes, stuck_modes), contact_state, end, columns);
    }
}

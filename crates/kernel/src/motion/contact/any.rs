//! A contact whose law is known only at run time. The contact is rigid or elastic.

use super::elastic::ElasticChain;
use super::law::ContactChain;
use super::rigid::Rigid;
use super::state::{Contact, ContactState, SegmentEnd};
use crate::contact::sums::Chain;
use crate::motion::oscillator::Part;
use crate::motion::setting::MotionSetting;
use crate::number::complex::Complex;
use crate::number::scalar::Float;

/// Constants of a chain and of its contact, which is rigid or elastic.
#[derive(Clone, Copy, Debug)]
pub enum AnyContact<S> {
    /// The contact is rigid. The field contains the constants of the chain.
    Rigid(Chain<S>),
    /// The contact is elastic. The field contains the constants of the chain and of the contact.
    Elastic(ElasticChain<S>),
}

/// Calls a method of the contact's law. If the method takes a *setting* (a scene at one frequency ratio and one
/// friction ratio), the macro passes the setting with the constants of this law.
macro_rules! of_law {
    ($chain:expr, $name:ident($($argument:expr),*)) => {
        match $chain {
            AnyContact::Rigid(chain) => chain.$name($($argument),*),
            AnyContact::Elastic(chain) => chain.$name($($argument),*),
        }
    };
    ($setting:expr => $name:ident($($argument:expr),*)) => {
        match $setting.dynamics.chain {
            AnyContact::Rigid(chain) => <Chain<S> as ContactChain<S>>::$name(&$setting.with(chain), $($argument),*),
            AnyContact::Elastic(chain) => <ElasticChain<S> as ContactChain<S>>::$name(&$setting.with(chain), $($argument),*),
        }
    };
}

impl<S: Float> ContactChain<S> for AnyContact<S> {
    type Law = Rigid<S>;

    fn lost_modes(&self) -> usize {
        of_law!(self, lost_modes())
    }

    fn remembered(&self) -> usize {
        of_law!(self, remembered())
    }

    fn stuck_multipliers(&self) -> &'static [bool] {
        of_law!(self, stuck_multipliers())
    }

    fn compliance(&self) -> S {
        of_law!(self, compliance())
    }

    fn chain(&self) -> &Chain<S> {
        of_law!(self, chain())
    }

    fn law_with(&self, level: S, stiction: S) -> Rigid<S> {
        of_law!(self, law_with(level, stiction))
    }

    fn contact_state(
        setting: &MotionSetting<'_, S, Self>,
        parts: &[Part<S>],
        t: S,
    ) -> ContactState<S> {
        of_law!(setting => contact_state(parts, t))
    }

    fn sliding_state(
        setting: &MotionSetting<'_, S, Self>,
        parts: &[Part<S>],
        contact_state: &ContactState<S>,
    ) -> ContactState<S> {
        of_law!(setting => sliding_state(parts, contact_state))
    }

    fn memory_at_stop(setting: &MotionSetting<'_, S, Self>, contact: Contact) -> Option<S> {
        of_law!(setting => memory_at_stop(contact))
    }

    fn memory_at(
        setting: &MotionSetting<'_, S, Self>,
        stuck_modes: &[Part<S>],
        place: S,
        at: (S, S),
    ) -> Option<S> {
        of_law!(setting => memory_at(stuck_modes, place, at))
    }

    fn adapt(
        setting: &MotionSetting<'_, S, Self>,
        stuck_modes: &mut [Part<S>],
        lifted: S,
        contact_state: &ContactState<S>,
    ) {
        of_law!(setting => adapt(stuck_modes, lifted, contact_state));
    }

    fn stuck_place(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S {
        of_law!(setting => stuck_place(modes, contact_state, at))
    }

    fn stuck_velocity(setting: &MotionSetting<'_, S, Self>, modes: &[Part<S>], at: (S, S)) -> S {
        of_law!(setting => stuck_velocity(modes, at))
    }

    fn stuck_force(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S {
        of_law!(setting => stuck_force(modes, contact_state, at))
    }

    fn steady_stuck_force(setting: &MotionSetting<'_, S, Self>, place: S) -> (S, Complex<S>) {
        of_law!(setting => steady_stuck_force(place))
    }

    fn halt(
        setting: &MotionSetting<'_, S, Self>,
        modes: &[Part<S>],
        at: (S, S),
        end: &mut SegmentEnd<S>,
    ) {
        of_law!(setting => halt(modes, at, end));
    }

    fn break_away(setting: &MotionSetting<'_, S, Self>, contact: Contact, end: &mut SegmentEnd<S>) {
        of_law!(setting => break_away(contact, end));
    }

    fn carry_deviations(
        setting: &MotionSetting<'_, S, Self>,
        oscillators: (&[Part<S>], &mut [Part<S>]),
        contact_state: &ContactState<S>,
        end: &SegmentEnd<S>,
        columns: &mut [S],
    ) {
        of_law!(setting => carry_deviations(oscillators, contact_state, end, columns));
    }
}

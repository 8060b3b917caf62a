//! Computes the state of a steady motion with two reversals and no stops, from the closed form.
//!
//! Near a resonance, rounding errors of the period map change its fixed point strongly. The closed form loses no
//! precision near a resonance.

use super::cycle_map::CycleMap;
use crate::contact::dominant::Partner;
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::modal_sum::wave::Sum;
use crate::motion::{Contact, ContactChain, Dynamics};
use crate::number::phase::within_cycle;
use crate::number::scalar::Float;
use crate::oscillator::decay::Damped;
use crate::oscillator::mode::Mode;

/// Modes that the contact drives, with their response functions at one frequency ratio.
struct DrivenChain<'a, S> {
    chain: Chain<S>,
    modes: &'a [Mode<S>],
    quadratures: &'a [[S; 2]],
    inverse_r: S,
    scale: S,
    single: bool,
}

impl<'a, S: Float> DrivenChain<'a, S> {
    fn new<K: ContactChain<S>>(dynamics: &Dynamics<'a, S, K>, inverse_r: S) -> Self {
        let modes = dynamics.driven();
        Self {
            chain: *dynamics.chain(),
            modes,
            quadratures: dynamics.quadratures(),
            inverse_r,
            scale: Chain::scale_at(modes, inverse_r),
            single: modes.len() == 1,
        }
    }

    fn at(&self, mode: &Mode<S>) -> ModeAt<S> {
        let response = mode.response(self.inverse_r, 0);
        self.chain.scaled(&response, self.scale, self.single, 0)
    }

    fn contact(&self) -> ContactAt<S> {
        let modes = (self.modes, self.quadratures);
        self.chain
            .loaded_in_turn::<true>(modes, self.inverse_r, |_| ())
    }
}

/// Sets the cycle map to the steady motion that the closed form gives at the friction ratio `beta`. The instant is a
/// maximum of the contact's relative displacement.
pub(super) fn set<S: Float, K: ContactChain<S>>(cycle_map: &mut CycleMap<'_, '_, S, K>, beta: S) {
    let one = S::constant(1.0);
    let dynamics = &cycle_map.setting.dynamics;
    let driven = DrivenChain::new(dynamics, one / cycle_map.setting.r);
    let contact = driven.contact();
    let friction = dynamics.chain().friction(&contact, driven.inverse_r, beta);
    let known = driven.modes.iter().map(|mode| (mode, driven.at(mode)));
    let loaded = (known.clone(), driven.quadratures);
    let dominant = dynamics
        .chain()
        .dominant_sums(loaded, Partner::U, &contact, driven.inverse_r);
    for (index, (part, (mode, at))) in cycle_map.modes.iter_mut().zip(known).enumerate() {
        let alone = core::iter::once((index, one, mode, at));
        let fundamental = dynamics.chain().fundamental_of(
            (alone, driven.quadratures),
            &dominant,
            &contact,
            &friction,
        );
        let wave = dynamics.chain().mass_wave::<Damped<S>>(
            mode,
            one,
            &at,
            &contact,
            &friction,
            driven.inverse_r,
        );
        let sum = Sum {
            waves: core::slice::from_ref(&wave),
            cosine: fundamental.cosine,
            sine: fundamental.sine,
        };
        let (y, slope) = sum.start();
        (part.y, part.u) = (y, slope / part.x);
    }
    let t = within_cycle(friction.phase * S::inverse_pi());
    cycle_map.contact_state = cycle_map
        .setting
        .sliding_off(cycle_map.modes, t, Contact::Backward);
}

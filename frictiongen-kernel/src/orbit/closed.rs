//! A steady state that never stops and reverses twice is the closed form's: its state from there.
//!
//! Beside a resonance the fixed point is badly conditioned, while the closed form loses nothing.

use super::flow::Flow;
use crate::contact::dominant::Partner;
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::modal_sum::wave::Sum;
use crate::number::scalar::Float;
use crate::oscillator::decay::Damped;
use crate::oscillator::mode::Mode;
use crate::simulation::{Contact, Dynamics, Stance};

/// The sums over all modes that the contact drives.
struct Sums<'a, S> {
    chain: Chain<S>,
    modes: &'a [Mode<S>],
    inverse_r: S,
    scale: S,
    single: bool,
}

impl<'a, S: Float> Sums<'a, S> {
    fn new(dynamics: &Dynamics<'a, S>, inverse_r: S) -> Self {
        let modes = dynamics.driven();
        let mut scale: Option<S> = None;
        for mode in modes {
            let size = mode.response(inverse_r, 0).size;
            scale = Some(scale.map_or(size, |scale| scale.min(size)));
        }
        Self {
            chain: dynamics.chain,
            modes,
            inverse_r,
            scale: scale.unwrap_or(S::constant(1.0)),
            single: modes.len() == 1,
        }
    }

    fn at(&self, mode: &Mode<S>) -> ModeAt<S> {
        let response = mode.response(self.inverse_r, 0);
        self.chain.scaled(&response, self.scale, self.single, 0)
    }

    fn contact(&self) -> ContactAt<S> {
        let mut sum = ContactAt::zero(self.scale);
        for mode in self.modes {
            let response = mode.response(self.inverse_r, 0);
            let at = self.chain.scaled(&response, self.scale, self.single, 0);
            sum = self
                .chain
                .joined_by(&sum, mode, &response, &at, self.single);
        }
        self.chain.completed(&sum, self.inverse_r)
    }
}

/// Sets the flow to the closed form's state at a maximum of the relative motion.
pub(super) fn set<S: Float>(flow: &mut Flow<'_, '_, S>) {
    let one = S::constant(1.0);
    let dynamics = &flow.setting.dynamics;
    let sums = Sums::new(dynamics, one / flow.setting.r);
    let contact = sums.contact();
    let friction = dynamics
        .chain
        .friction(&contact, sums.inverse_r, flow.setting.beta);
    let known = sums.modes.iter().map(|mode| (mode, sums.at(mode)));
    let apart = dynamics
        .chain
        .apart(known.clone(), Partner::U, &contact, sums.inverse_r);
    for (index, (part, (mode, at))) in flow.modes.iter_mut().zip(known).enumerate() {
        let alone = core::iter::once((index, one, mode, at));
        let carrier = dynamics
            .chain
            .carrier_of(alone, &apart, &contact, &friction);
        let wave = dynamics.chain.mass_wave::<Damped<S>>(
            mode,
            one,
            &at,
            &contact,
            &friction,
            sums.inverse_r,
        );
        let sum = Sum {
            waves: core::slice::from_ref(&wave),
            cosine: carrier.cosine,
            sine: carrier.sine,
        };
        let (y, slope) = sum.start();
        (part.y, part.u) = (y, slope / part.x);
    }
    let turns = friction.phase * S::inverse_pi();
    let two = S::constant(2.0);
    let t = turns - (turns * S::constant(0.5)).floor() * two;
    let force = flow.setting.holding(flow.modes, t.sin_cos_pi());
    let excess = force.abs() - flow.setting.beta;
    flow.stance = Stance {
        t,
        contact: Contact::Backward,
        departing: Some(flow.setting.acceleration(excess)),
        wedged: false,
    };
}

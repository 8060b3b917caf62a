//! A contact that takes hold for good: above β*_lim motion may end with the contact stuck, at the centre or off it.
//!
//! A stuck contact carries three forces: V/H of the forced motion, a constant one if it is held off its centre, and what
//! is left of the held chain's free vibration.  It never slides again where their sum cannot exceed μβ.

use super::cycle_map::{CycleMap, Pattern};
use super::shooting::MAX_CYCLES;
use crate::number::scalar::Float;
use crate::simulation::{Contact, phase};

/// Half cycles without an event after which a contact counts as stuck although its free vibration might add up with the
/// other forces: without damping it never dies, and with damping it can only fall.
const QUIET: u32 = 256;
/// Cycles after which, with μ = 1 and without damping, the offset is taken as it is: what slips remain are smaller than
/// any before, and never end.
const UNDYING: u32 = 64;
/// Roundings of the forces in a contact that only just holds.
const ROUNDINGS: f64 = 64.0;
/// With μ = 1 slips shrink without end, and the offset tends to where the contact just holds.  It does so from one side
/// where a cycle's slip and the free vibration are less than this share of what the offset is too large by.
const ONE_SIDED: f64 = 0.1;

/// Watches a motion above β*_lim for the moment from which on the contact sticks for ever.
pub(super) struct Hold<S> {
    /// |V/H|, the amplitude of the force that the forced motion needs.
    steady: S,
    /// Whether μ = 1, so that slips shrink.
    monotone: bool,
    /// Half cycles in a row without an event.
    quiet: u32,
    /// Half cycles altogether.
    halves: u32,
    /// The constant force half a cycle ago and a cycle ago.
    before: [S; 2],
}

impl<S: Float> Hold<S> {
    pub(super) fn new(steady: S, monotone: bool) -> Self {
        let far = S::constant(f64::MAX);
        Self {
            steady,
            monotone,
            quiet: 0,
            halves: 0,
            before: [far; 2],
        }
    }

    /// Notes another half cycle.
    pub(super) fn note(&mut self, half: Pattern) {
        self.halves = self.halves.saturating_add(1);
        let calm = half == Pattern::default();
        self.quiet = if calm { self.quiet + 1 } else { 0 };
    }

    /// z̄ of a contact that sticks and never slides again, if that is certain or [as good as certain](QUIET).
    pub(super) fn held(&mut self, cycle_map: &mut CycleMap<'_, '_, S>) -> Option<S> {
        let setting = cycle_map.setting;
        let contact_state = cycle_map.contact_state;
        let far = S::constant(f64::MAX);
        if contact_state.contact != Contact::Stuck {
            self.before = [far, self.before[0]];
            return None;
        }
        let (sum, offset) = setting.stick(
            cycle_map.modes,
            cycle_map.held,
            &contact_state,
            S::constant(0.0),
        );
        let constant = sum.constant.abs();
        let at = phase(contact_state.t);
        let free = cycle_map.held.iter().fold(S::constant(0.0), |free, part| {
            free + part.free_amplitude(at)
        });
        let before = self.before[1];
        self.before = [constant, self.before[0]];
        let spare = setting.grip() - self.steady;
        let noise = S::constant(ROUNDINGS * S::EPSILON) * setting.grip();
        if constant + free <= spare + noise || QUIET <= self.quiet {
            return Some(offset);
        }
        let excess = constant - spare;
        let share = S::constant(ONE_SIDED) * excess;
        let slipped = before - constant;
        let one_sided = S::constant(0.0) < slipped && slipped < share && free < share;
        let undying =
            2 * UNDYING <= self.halves && cycle_map.held.iter().any(|part| part.is_undamped());
        let last = 2 * MAX_CYCLES <= self.halves + 1;
        let tends = self.monotone && (one_sided || undying || last);
        tends.then(|| constant.min(spare).copysign(offset) * setting.receptance)
    }
}

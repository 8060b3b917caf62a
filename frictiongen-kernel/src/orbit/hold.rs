//! Detects a contact that sticks for ever.  For β ≥ β*_lim a motion may end with the contact stuck, with or without an
//! offset.
//!
//! Three forces act in a stuck contact: V/H of the forced motion, the constant force of an offset, and the force of the
//! stuck chain's free vibration.  The contact never slides again where their sum cannot exceed μβ.

use super::cycle_map::{CycleMap, EventPattern};
use super::types::MAX_CYCLES;
use crate::motion::{Contact, ContactChain, Law, phase};
use crate::number::scalar::Float;

/// Number of half cycles without an event after which a contact counts as stuck.  Without damping the free vibration
/// never decays, and the test of the forces alone might never succeed.  With damping the free vibration can only fall.
const QUIET: u32 = 256;
/// Number of cycles after which the present offset counts as final, with μ = 1 and without damping.  The slips become
/// ever smaller, and never end.
const UNDYING: u32 = 64;
/// Rounding error of the forces in a contact that only just sticks, in roundings of μβ.
const ROUNDINGS: f64 = 64.0;
/// Ratio below which the offset counts as approaching its limit from one side.  With μ = 1 the slips become ever
/// smaller, and the offset tends to the value at which the contact just sticks.  The slip of a cycle and the free
/// vibration are compared with the distance of the offset from that limit.  All three are expressed as forces.
const ONE_SIDED: f64 = 0.1;

/// Watches a motion with β ≥ β*_lim for the instant from which on the contact sticks for ever.
pub(super) struct Hold<S> {
    /// |V/H|, the amplitude of the contact force in the forced motion of the stuck chain.
    steady: S,
    /// True if μ = 1, so that the slips become smaller.
    monotone: bool,
    /// Number of successive half cycles without an event, up to now.
    quiet: u32,
    /// Number of all half cycles.
    halves: u32,
    /// Constant contact force, from the offset, half a cycle ago and a cycle ago.
    before: [S; 2],
    /// z̄ of a contact that sticks, as computed first after it slid.  A stuck contact does not move, but z̄ computed anew
    /// from the modes would drift by roundings.
    resting: Option<S>,
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
            resting: None,
        }
    }

    /// Counts another half cycle.
    pub(super) fn note(&mut self, half: EventPattern) {
        self.halves = self.halves.saturating_add(1);
        let calm = half == EventPattern::default();
        self.quiet = if calm { self.quiet + 1 } else { 0 };
    }

    /// Returns z̄ of a contact that sticks and never slides again.  Returns `None` as long as that is neither certain
    /// nor [counts as certain](QUIET).
    pub(super) fn lasting_offset<K: ContactChain<S>>(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
    ) -> Option<S> {
        let setting = cycle_map.setting;
        let contact_state = cycle_map.contact_state;
        let far = S::constant(f64::MAX);
        if contact_state.contact != Contact::Stuck {
            self.before = [far, self.before[0]];
            return None;
        }
        let (sum, computed) = setting.start_sticking(
            cycle_map.modes,
            cycle_map.stuck_modes,
            &contact_state,
            S::constant(0.0),
        );
        let constant = sum.constant.abs();
        let resting = self.resting.filter(|_| !cycle_map.slid);
        let offset = resting.unwrap_or(computed);
        (self.resting, cycle_map.slid) = (Some(offset), false);
        let at = phase(contact_state.t);
        let free = cycle_map
            .stuck_modes
            .iter()
            .fold(S::constant(0.0), |free, part| {
                free + part.free_amplitude(at)
            });
        let before = self.before[1];
        self.before = [constant, self.before[0]];
        let grip = setting.law().grip();
        let spare = grip - self.steady;
        let noise = S::constant(ROUNDINGS * S::EPSILON) * grip;
        if constant + free <= spare + noise || QUIET <= self.quiet {
            return Some(offset);
        }
        let excess = constant - spare;
        let share = S::constant(ONE_SIDED) * excess;
        let slipped = before - constant;
        let one_sided = S::constant(0.0) < slipped && slipped < share && free < share;
        let undying = 2 * UNDYING <= self.halves
            && cycle_map.stuck_modes.iter().any(|part| part.is_undamped());
        let last = 2 * MAX_CYCLES <= self.halves + 1;
        let tends = self.monotone && (one_sided || undying || last);
        tends.then(|| constant.min(spare).copysign(offset) * setting.receptance)
    }
}

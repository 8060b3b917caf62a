//! Detects a contact that sticks for ever. A motion may end in this way if β ≥ β*_lim, the limit of sliding. The
//! contact then sticks with or without an offset.
//!
//! The force in a stuck contact is the sum of three parts. The first part is V/H, the force of the forced motion. The
//! second part is a constant force due to the offset. The third part is the force of the chain's free vibration. If
//! this sum can never exceed μβ (the static friction force divided by P or k₁Y), the contact never slides again.

use super::cycle_map::{CycleMap, EventPattern};
use super::types::MAX_CYCLES;
use crate::motion::{Contact, ContactChain, Law, phase};
use crate::number::scalar::Float;

/// Number of half cycles without an event after which the contact is assumed to stick for ever. This rule is necessary
/// because an undamped free vibration never decays, so that the test of the forces may never succeed.
const QUIET: u32 = 256;
/// Number of cycles after which the present offset is assumed to be final, with μ = 1 and without damping. In this case
/// the slips become smaller from cycle to cycle, but never end.
const UNDYING: u32 = 64;
/// Rounding error of the force in a contact that barely sticks, in rounding units of μβ.
const ROUNDINGS: f64 = 64.0;
/// Largest ratio at which the offset is assumed to approach its limit from one side. With μ = 1 the slips become ever
/// smaller, and the offset converges to a limit at which the contact barely sticks. The distance of the offset from
/// this limit corresponds to a force. The code divides two other forces by this force: the decrease of the contact
/// force by one cycle's slips, and the force of the free vibration. Both ratios must be less than `ONE_SIDED`.
const ONE_SIDED: f64 = 0.1;

/// Observer of a motion with β ≥ β*_lim. It detects when the contact starts to stick for ever.
pub(super) struct Hold<S> {
    /// |V/H|, the amplitude of the contact force while the contact sticks and the chain is in its forced motion.
    steady: S,
    /// True if the stiction μ is 1, so that the slips become smaller from cycle to cycle.
    monotone: bool,
    /// Number of successive half cycles without an event, up to the present half cycle.
    quiet: u32,
    /// Number of half cycles since the start of the motion.
    halves: u32,
    /// Absolute value of the constant force in the contact, which the offset causes, half a cycle ago and one cycle
    /// ago.
    before: [S; 2],
    /// Relative displacement z̄ of a stuck contact, computed once after the contact stopped. A stuck contact does not
    /// move, but rounding would change z̄ if the code recomputed it from the modes.
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

    /// Updates the counters after one more half cycle. `half` contains the events of this half cycle.
    pub(super) fn note(&mut self, half: EventPattern) {
        self.halves = self.halves.saturating_add(1);
        let calm = half == EventPattern::default();
        self.quiet = if calm { self.quiet + 1 } else { 0 };
    }

    /// Returns the offset z̄ of a contact that sticks for ever. Returns `None` until permanent sticking is proven or
    /// [assumed](QUIET).
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

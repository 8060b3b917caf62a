//! Records a steady state, segment by segment.
//!
//! In a segment the contact either sticks, or slides in one direction. A mark is the stored start of a segment. A
//! record has room for [`MAX_SEGMENTS`] marks. If a period has more segments, the record keeps every second mark, then
//! every fourth, and so on. The code recomputes a segment without a mark when it needs the segment.

use super::cycle_map::CycleMap;
use super::newton::agreement;
use super::types::{MAX_SEGMENTS, SegmentStart};
use crate::errors::NoOrbit;
use crate::motion::{ContactChain, ContactState, Event, leap};
use crate::number::scalar::Float;

/// Record of a steady state, while the code fills it.
pub(super) struct OrbitRecord<'s, S> {
    marks: &'s mut [SegmentStart<S>; MAX_SEGMENTS],
    count: usize,
    /// States of the oscillators at the marks (starts of segments).
    states: &'s mut [S],
    /// Number of scalars in a state of the oscillators.
    size: usize,
    /// Largest number of segments in a cycle.
    most: usize,
    /// Number of segments from one mark to the next.
    stride: u32,
    segments: usize,
    stops: usize,
    reversals: usize,
    /// Relative displacement z̄ at the end of the last recorded segment. `None` if the contact does not stick in that
    /// segment.
    stuck_at: Option<S>,
    /// Start of the segment in which the relative displacement z̄ begins to fall from its largest value.
    top: Option<SegmentStart<S>>,
}

/// Data of a steady state after the recording of its period.
pub(super) struct RecordedPeriod<S> {
    pub count: usize,
    pub stops: usize,
    pub reversals: usize,
    /// Phase of the excitation at τ = 0 in half-turns (π rad), and the number of the excitation's cycle at τ = 0.
    pub origin: (S, S),
}

impl<'s, S: Float> OrbitRecord<'s, S> {
    /// Creates an empty record. `size` is the number of scalars in a state. `most` is the largest number of segments in
    /// a cycle.
    pub(super) fn new(
        marks: &'s mut [SegmentStart<S>; MAX_SEGMENTS],
        states: &'s mut [S],
        size: usize,
        most: usize,
    ) -> Self {
        Self {
            marks,
            count: 0,
            states,
            size,
            most,
            stride: 1,
            segments: 0,
            stops: 0,
            reversals: 0,
            stuck_at: None,
            top: None,
        }
    }

    /// Records a steady state in which the contact sticks during the whole cycle. `offset` is the relative displacement
    /// z̄ of a rigid contact.
    pub(super) fn stuck<K: ContactChain<S>>(
        &mut self,
        cycle_map: &CycleMap<'_, '_, S, K>,
        offset: S,
    ) {
        let elastic = 0 < cycle_map.remembered();
        if let Some(first) = self.marks.first_mut() {
            first.length = S::pi() + S::pi();
            first.relative = offset;
            if elastic {
                let at = cycle_map.contact_state.t.sin_cos_pi();
                first.contact_state = cycle_map.contact_state;
                first.relative = cycle_map.setting.relative(cycle_map.modes, at);
            }
        }
        self.save(cycle_map, 0);
        self.count = 1;
    }

    /// Follows the motion from event to event through a period of `period` cycles, and records the segments of the
    /// period.
    pub(super) fn follow<K: ContactChain<S>>(
        &mut self,
        cycle_map: &mut CycleMap<'_, '_, S, K>,
        period: u32,
    ) -> Result<(), NoOrbit> {
        let zero = S::constant(0.0);
        let mut left = (S::pi() + S::pi()) * S::constant(f64::from(period));
        let most = self.most * period as usize;
        let mut cycle = zero;
        while slack::<S>() < left {
            if self.segments == most {
                return Err(NoOrbit::TooManyEvents);
            }
            let mut mark = self.begin(cycle_map, cycle);
            let end = leap(
                cycle_map.setting,
                cycle_map.modes,
                cycle_map.stuck_modes,
                cycle_map.contact_state,
                left + slack(),
            );
            cycle_map.spend(end.steps)?;
            mark.length = within(end.tau, left);
            left = left - mark.length;
            // In a segment of length zero the contact fails to start sliding from zero velocity.
            if zero < mark.length {
                self.note(mark, end.event);
            }
            cycle = cycle + passed(&cycle_map.contact_state, end.tau, &end.contact_state);
            cycle_map.contact_state = end.contact_state;
        }
        Ok(())
    }

    /// Returns the start of the segment that now begins. If the record keeps this start as a mark, the function stores
    /// the state of the oscillators.
    fn begin<K: ContactChain<S>>(
        &mut self,
        cycle_map: &CycleMap<'_, '_, S, K>,
        cycle: S,
    ) -> SegmentStart<S> {
        if self.is_due() {
            if self.count == MAX_SEGMENTS {
                self.thin();
            }
            self.save(cycle_map, self.count);
        }
        let contact_state = cycle_map.contact_state;
        let found = || {
            cycle_map
                .setting
                .relative(cycle_map.modes, contact_state.t.sin_cos_pi())
        };
        SegmentStart {
            contact_state,
            cycle,
            length: S::constant(0.0),
            relative: self.stuck_at.unwrap_or_else(found),
            more: 0,
        }
    }

    /// Returns true if the record must keep the start of the next segment as a mark.
    fn is_due(&self) -> bool {
        let last = self.count.checked_sub(1);
        let last = last.and_then(|last| self.marks.get(last));
        last.is_none_or(|last| self.stride <= last.more + 1)
    }

    fn note(&mut self, mark: SegmentStart<S>, event: Option<Event>) {
        if self.is_due() {
            if let Some(place) = self.marks.get_mut(self.count) {
                *place = mark;
            }
            self.count += 1;
        } else if let Some(last) = self.marks.get_mut(self.count.wrapping_sub(1)) {
            last.more += 1;
        }
        self.segments += 1;
        self.stuck_at = mark.stuck_at();
        self.stops += usize::from(event == Some(Event::Stop));
        self.reversals += usize::from(event == Some(Event::Reversal));
        let higher = |top: &SegmentStart<S>| top.relative < mark.relative;
        if mark.leaves_top() && self.top.as_ref().is_none_or(higher) {
            self.top = Some(mark);
        }
    }

    /// Removes every second mark from a full record, so that half of the record is free again.
    fn thin(&mut self) {
        let (half, size) = (MAX_SEGMENTS / 2, self.size);
        for index in 0..half {
            let pair = (self.marks.get(2 * index), self.marks.get(2 * index + 1));
            if let (Some(first), Some(second)) = pair {
                let kept = SegmentStart {
                    more: first.more + second.more + 1,
                    ..*first
                };
                if let Some(place) = self.marks.get_mut(index) {
                    *place = kept;
                }
            }
            // The numbers are copied one by one, because a copy within a slice can panic.
            let (from, to) = (2 * index * size, index * size);
            for offset in 0..size {
                let value = self.states.get(from + offset).copied();
                if let (Some(value), Some(place)) = (value, self.states.get_mut(to + offset)) {
                    *place = value;
                }
            }
        }
        self.count = half;
        self.stride += self.stride;
    }

    fn save<K: ContactChain<S>>(&mut self, cycle_map: &CycleMap<'_, '_, S, K>, index: usize) {
        let size = self.size;
        if let Some(state) = self.states.get_mut(index * size..(index + 1) * size) {
            cycle_map.save(state);
        }
    }

    pub(super) fn done(self) -> RecordedPeriod<S> {
        let zero = S::constant(0.0);
        if let (Some(first), Some(stuck_at)) = (self.marks.first_mut(), self.stuck_at) {
            first.relative = stuck_at;
        }
        RecordedPeriod {
            count: self.count,
            stops: self.stops,
            reversals: self.reversals,
            origin: self
                .top
                .map_or((zero, zero), |top| (top.contact_state.t, top.cycle)),
        }
    }
}

/// Returns the tolerance for the end of the period: the largest time by which rounding may make a segment longer than
/// the rest of the period. The time is in rad of the excitation (τ).
pub(super) fn slack<S: Float>() -> S {
    agreement()
}

/// Returns the length of a segment. `left` is the remaining length of the period. If the segment ends at the end of the
/// period apart from rounding, the result is exactly `left`.
pub(super) fn within<S: Float>(length: S, left: S) -> S {
    if left - slack() < length {
        left
    } else {
        length
    }
}

/// Returns the number of excitation cycles that begin between the contact states `from` and `to`. `to` is a time τ
/// later than `from`.
pub(super) fn passed<S: Float>(from: &ContactState<S>, tau: S, to: &ContactState<S>) -> S {
    let half = S::constant(0.5);
    let turns = (from.t + tau * S::inverse_pi() - to.t) * half;
    (turns + half).floor()
}

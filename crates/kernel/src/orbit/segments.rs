//! Iterates over the segments of a steady state.
//!
//! In a segment the contact either sticks, or slides in one direction. A *mark* is the stored start of a segment. If a
//! period has many segments, only some of them have a mark. The iterator recomputes the segments between two marks.

use super::cycle_map::MOST_EVENTS;
use super::record::{passed, slack, within};
use super::types::{Orbit, SegmentStart};
use crate::motion::{ContactChain, Part, leap, span};
use crate::number::complex::Complex;
use crate::number::pairs::pairs;
use crate::number::scalar::Float;

/// Iterator over the segments of a steady state.
pub(super) struct Segments<'o, 'a, S, P, V, C, K> {
    orbit: &'o Orbit<'a, S, P, V, C, K>,
    /// Oscillators of the segment that the iterator has returned last. `None` until the caller has requested their
    /// states.
    parts: Option<P>,
    /// True if the oscillators have their state at the start of the segment `last`.
    placed: bool,
    /// Segment that the iterator has returned last.
    last: Option<SegmentStart<S>>,
    /// Index of the next mark. The field `more` is the number of segments that the iterator computes before that mark.
    next: usize,
    more: u32,
}

impl<'o, 'a, S, P, V, C, K> Segments<'o, 'a, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    /// Creates an iterator that starts at the mark with the index `mark`.
    pub(super) fn from(orbit: &'o Orbit<'a, S, P, V, C, K>, mark: usize) -> Self {
        Self {
            orbit,
            parts: None,
            placed: false,
            last: None,
            next: mark,
            more: 0,
        }
    }

    /// Returns the segment that contains the instant τ, with an iterator that has just returned it. The third result
    /// is the time from the start of the segment to τ, in rad of the excitation. At τ = 0 the contact leaves its
    /// largest relative displacement.
    pub(super) fn at(
        orbit: &'o Orbit<'a, S, P, V, C, K>,
        tau: S,
    ) -> Option<(Self, SegmentStart<S>, S)> {
        let two = S::constant(2.0);
        let t = orbit.origin + tau * S::inverse_pi();
        // `found` is the last mark before the instant τ.
        let mut found: Option<(usize, S)> = None;
        for (index, mark) in orbit.marks().iter().enumerate() {
            let since =
                orbit.within(t - mark.contact_state.t - two * (mark.cycle - orbit.origin_cycle));
            if found.is_none_or(|(_, best)| since < best) {
                found = Some((index, since));
            }
        }
        let (index, mut since) = found?;
        let mut segments = Self::from(orbit, index);
        while let Some(mark) = segments.next() {
            let turns = mark.length * S::inverse_pi();
            if since < turns || !segments.follows() {
                return Some((segments, mark, since * S::pi()));
            }
            since = since - turns;
        }
        None
    }

    /// Returns the oscillators of the segment that the iterator has returned last. The oscillators have their state at
    /// the start of this segment.
    pub(super) fn parts(&mut self) -> &mut [Part<S>] {
        let orbit = self.orbit;
        let parts = self.parts.get_or_insert_with(|| orbit.parts.clone());
        if !self.placed {
            self.placed = true;
            let size = 2 * orbit.setting.dynamics.modes.len();
            let index = self.next.wrapping_sub(1);
            let from = index.wrapping_mul(size);
            let state = orbit.numbers.as_ref();
            let state = state.get(from..from.wrapping_add(size));
            let state = pairs(state.unwrap_or_default());
            for (part, state) in parts.as_mut().iter_mut().zip(state) {
                if let [y, u] = state {
                    (part.y, part.u) = (*y, *u);
                }
            }
        }
        parts.as_mut()
    }

    /// Returns true if the next segment has no mark (stored start). The iterator then computes the segment from the
    /// one that it has returned last.
    pub(super) fn follows(&self) -> bool {
        0 < self.more
    }

    /// Returns the segment that starts at the next mark, or `None` after the last mark.
    fn next_mark(&mut self) -> Option<SegmentStart<S>> {
        let mark = *self.orbit.marks().get(self.next)?;
        self.placed = false;
        self.next += 1;
        self.more = mark.more;
        Some(mark)
    }

    /// Computes the segment that follows the segment `last`.
    fn compute_next(&mut self, last: &SegmentStart<S>) -> Option<SegmentStart<S>> {
        let zero = S::constant(0.0);
        let orbit = self.orbit;
        let setting = &orbit.setting;
        let end = orbit.marks().first()?.contact_state.t + S::constant(2.0) * orbit.cycles();
        let (modes, stuck_modes) = setting.split(self.parts());
        let mut mark = *last;
        // The first pass of the loop advances through the segment `last`. Further passes skip segments of length zero,
        // in which the contact fails to start sliding from zero velocity.
        for _ in 0..MOST_EVENTS {
            let left = (end - mark.contact_state.t - S::constant(2.0) * mark.cycle) * S::pi();
            let reach = left + slack();
            let length = span(setting, modes, stuck_modes, mark.contact_state, reach);
            if zero < length && !(zero < mark.length) {
                mark.length = within(length, left);
                let found = || setting.relative(modes, mark.contact_state.t.sin_cos_pi());
                mark.relative = last.stuck_at().unwrap_or_else(found);
                self.more -= 1;
                return Some(mark);
            }
            if !(zero < left) {
                return None;
            }
            let next = leap(setting, modes, stuck_modes, mark.contact_state, reach);
            mark = SegmentStart {
                contact_state: next.contact_state,
                cycle: mark.cycle + passed(&mark.contact_state, next.tau, &next.contact_state),
                length: zero,
                ..mark
            };
        }
        None
    }
}

impl<S, P, V, C, K> Iterator for Segments<'_, '_, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    type Item = SegmentStart<S>;

    fn next(&mut self) -> Option<SegmentStart<S>> {
        self.last = match self.last {
            Some(last) if self.follows() => self.compute_next(&last),
            _ => self.next_mark(),
        };
        self.last
    }
}

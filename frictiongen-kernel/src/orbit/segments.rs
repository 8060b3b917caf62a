//! The segments of a steady state, one after the other.
//!
//! A period of many segments keeps the state at the start of some of them only; the others are followed anew.

use super::record::{passed, within};
use super::{Orbit, SegmentStart, slack};
use crate::number::complex::Complex;
use crate::number::pairs::pairs;
use crate::number::scalar::Float;
use crate::simulation::{Part, leap, span};

/// Goes through the segments of a steady state.
pub(super) struct Segments<'o, 'a, S, P, V, C> {
    orbit: &'o Orbit<'a, S, P, V, C>,
    /// The state at the start of the segment given last, once it has been asked for.
    parts: Option<P>,
    /// Whether it is there.
    placed: bool,
    /// The segment given last.
    last: Option<SegmentStart<S>>,
    /// The mark that is next, and how many segments are to be followed first.
    next: usize,
    more: u32,
}

impl<'o, 'a, S, P, V, C> Segments<'o, 'a, S, P, V, C>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
{
    /// From a mark on.
    pub(super) fn from(orbit: &'o Orbit<'a, S, P, V, C>, mark: usize) -> Self {
        Self {
            orbit,
            parts: None,
            placed: false,
            last: None,
            next: mark,
            more: 0,
        }
    }

    /// The segment that holds an instant τ after the orbit's own, and how far into it that is.
    pub(super) fn at(
        orbit: &'o Orbit<'a, S, P, V, C>,
        tau: S,
    ) -> Option<(Self, SegmentStart<S>, S)> {
        let two = S::constant(2.0);
        let t = orbit.origin + tau * S::inverse_pi();
        // The mark that stands last before it.
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

    /// The state at the start of the segment given last.
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

    /// Whether the next segment has to be followed.
    pub(super) fn follows(&self) -> bool {
        0 < self.more
    }

    /// The segment of the next mark.
    fn kept(&mut self) -> Option<SegmentStart<S>> {
        let mark = *self.orbit.marks().get(self.next)?;
        self.placed = false;
        self.next += 1;
        self.more = mark.more;
        Some(mark)
    }

    /// The segment after the last one, followed from there.
    fn followed(&mut self, last: &SegmentStart<S>) -> Option<SegmentStart<S>> {
        let zero = S::constant(0.0);
        let orbit = self.orbit;
        let setting = &orbit.setting;
        let end = orbit.marks().first()?.contact_state.t + S::constant(2.0) * orbit.cycles();
        let (modes, held) = setting.split(self.parts());
        let mut mark = *last;
        // Over the last one; then over attempts to leave that come to nothing.
        loop {
            let left = (end - mark.contact_state.t - S::constant(2.0) * mark.cycle) * S::pi();
            let reach = left + slack();
            let length = span(setting, modes, held, mark.contact_state, reach);
            if zero < length && !(zero < mark.length) {
                mark.length = within(length, left);
                let found = || setting.relative(modes, mark.contact_state.t.sin_cos_pi());
                mark.relative = last.stuck_at().unwrap_or_else(found);
                break;
            }
            if !(zero < left) {
                return None;
            }
            let next = leap(setting, modes, held, mark.contact_state, reach);
            mark = SegmentStart {
                contact_state: next.contact_state,
                cycle: mark.cycle + passed(&mark.contact_state, next.tau, &next.contact_state),
                length: zero,
                ..mark
            };
        }
        self.more -= 1;
        Some(mark)
    }
}

impl<S, P, V, C> Iterator for Segments<'_, '_, S, P, V, C>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
{
    type Item = SegmentStart<S>;

    fn next(&mut self) -> Option<SegmentStart<S>> {
        self.last = match self.last {
            Some(last) if self.follows() => self.followed(&last),
            _ => self.kept(),
        };
        self.last
    }
}

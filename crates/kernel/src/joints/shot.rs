//! One shot of the shooting method. A shot is the motion over a period or half a period, with its derivatives.

use super::neutral::neutral;
use super::run::{Motion, Observe};
use super::size::{Size, add, at};
use super::slid::Slips;
use super::state::FREE;
use super::steady::{BOUNDS, Search};
use super::tangent::{Both, ShotSpan, Tangent};
use crate::Float;
use crate::errors::Halt;

/// Result of a shot: the motion at its end, and the derivatives.
pub(super) struct Shot<S: Float, Z: Size> {
    pub(super) end: Motion<S, Z>,
    /// True for each contact that slides during the shot.
    pub(super) moving: Z::Contacts<bool>,
    /// Derivatives of the unknowns at the end of the shot with respect to those at its start, column by column. `None`
    /// if the code has not computed them together with the motion.
    pub(super) derivatives: Option<Z::Square<S>>,
}

impl<S: Float, Z: Size> Search<S, Z> {
    /// Returns the duration of a shot: half a cycle of the load if possible, otherwise a period. Half a cycle is
    /// enough for a motion that repeats with the opposite sign after half a cycle.
    ///
    /// The function assumes this symmetry under three conditions. The period is one cycle, and half a cycle later the
    /// equations are the same with all signs changed. All contacts are elastic with μ = 1. No part of the chain can
    /// move without a force.
    pub(super) fn span(&self, motion: &Motion<S, Z>, period: usize) -> ShotSpan {
        let model = motion.model();
        let mut loads = model.loads.as_ref().iter();
        let is_odd =
            loads.all(|(_, load)| load.is_odd(self.omega)) && model.base.is_odd(self.omega);
        let halves = period == 1 && is_odd && Tangent::follows(model);
        if halves && neutral(model, |_| false) == 0 {
            ShotSpan::Half
        } else {
            ShotSpan::Cycles(period)
        }
    }

    /// Returns true if the slider of each contact that does not slide in the period is at the position 0. If a slider
    /// is at another position, the motion does not repeat with the opposite sign.
    pub(super) fn is_centred(&self, motion: &Motion<S, Z>) -> bool {
        let contacts = motion.model().contacts().iter().enumerate();
        let mut still = contacts.filter(|(j, _)| !self.unknowns().moves(*j));
        still.all(|(j, contact)| {
            let Some(stiffness) = contact
                .stiffness
                .filter(|_| motion.state().phase(j) != FREE)
            else {
                return true;
            };
            let force = at(motion.state().forces.as_ref(), j);
            let shift = stiffness * motion.relative(j).1 - force;
            shift.abs() <= S::constant(1e3 * S::EPSILON) * contact.level.constant
        })
    }

    /// Advances the motion from a state to the end of one shot. If `derives` is true and all contacts are elastic with
    /// μ = 1, the function also computes the derivatives.
    pub(super) fn shoot(
        &self,
        start: &Motion<S, Z>,
        span: ShotSpan,
        derives: bool,
    ) -> Result<Shot<S, Z>, Halt> {
        let model = start.model();
        let mut slips = Slips::new(model);
        let mut end = start.clone();
        let mut tangent = (derives && Tangent::follows(model))
            .then(|| Tangent::new(model, start.state(), &self.unknowns()));
        match &mut tangent {
            Some(tangent) => self.pass(&mut end, span, &mut Both(&mut slips, tangent))?,
            None => self.pass(&mut end, span, &mut slips)?,
        }
        let moving = slips.slides(model);
        let unknowns = self.unknowns().of(&moving);
        let derivatives = tangent.map(|tangent| tangent.derivatives(&unknowns, span));
        Ok(Shot {
            end,
            derivatives,
            moving,
        })
    }

    /// Advances a motion to the end of a shot of the shooting method. A shot lasts `span`.
    fn pass(
        &self,
        motion: &mut Motion<S, Z>,
        span: ShotSpan,
        watch: &mut impl Observe<S, Z>,
    ) -> Result<(), Halt> {
        match span {
            ShotSpan::Cycles(cycles) => self.advance(motion, cycles, watch),
            ShotSpan::Half => {
                let state = motion.state().clone();
                motion.restart(state);
                motion.run(S::constant(0.5) * self.cycle, BOUNDS, watch)?;
                let state = motion.state().opposite();
                motion.restart(state);
                Ok(())
            }
        }
    }

    /// Returns the derivatives of the unknowns after a shot with respect to the unknowns before the shot. The matrix is
    /// stored column by column.
    pub(super) fn derivatives(
        &self,
        start: &Motion<S, Z>,
        to: &Z::Unknowns<S>,
        span: ShotSpan,
    ) -> Result<Z::Square<S>, Halt> {
        if Tangent::follows(start.model())
            && let Some(derivatives) = self.shoot(start, span, true)?.derivatives
        {
            return Ok(derivatives);
        }
        let unknowns = self.unknowns();
        let step = self.tolerances.step;
        let from = unknowns.read(start);
        let mut matrix = start.model().size.square(S::constant(0.0));
        let size = from.as_ref().len().max(1);
        let columns = matrix.as_mut().chunks_exact_mut(size).enumerate();
        for (index, column) in columns.filter(|(index, _)| unknowns.uses(start, *index)) {
            let mut moved = from.clone();
            add(moved.as_mut(), index, step);
            let mut end = unknowns.write(start, &moved);
            self.pass(&mut end, span, &mut ())?;
            let end = unknowns.read(&end);
            for (row, entry) in column.iter_mut().enumerate() {
                *entry = (at(end.as_ref(), row) - at(to.as_ref(), row)) / step;
            }
        }
        Ok(matrix)
    }
}

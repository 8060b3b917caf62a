//! One shot of the shooting method. A shot is the motion over a period or half a period, with its derivatives.

use super::model::{Contact, Model};
use super::run::{Motion, Observe};
use super::size::Size;
use super::slid::Slips;
use super::steady::Search;
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
    /// Returns true if half a cycle later the equations are the same with all signs changed. A steady state can then
    /// repeat with the opposite sign after half a cycle.
    pub(super) fn is_odd(&self, model: &Model<S, Z>) -> bool {
        let mut loads = model.loads.as_ref().iter();
        let mut contacts = model.contacts().iter();
        let is_odd = !model.has_stops() && !model.has_belts();
        is_odd
            && loads.all(|(_, load)| load.is_odd(self.omega))
            && model.base.is_odd(self.omega)
            && contacts.all(Contact::has_constant_level)
    }

    /// Advances the motion from a state to the end of one shot. If `derives` is true, the function also computes the
    /// derivatives.
    pub(super) fn shoot(
        &mut self,
        start: &Motion<S, Z>,
        span: ShotSpan,
        derives: bool,
    ) -> Result<Shot<S, Z>, Halt> {
        let model = start.model();
        let mut slips = Slips::new(model);
        let mut end = start.clone();
        let all = model.size.contacts(true);
        let every = self.unknowns().of(&all);
        let mut tangent = derives.then(|| Tangent::new(start, &every));
        match &mut tangent {
            Some(tangent) => self.pass(&mut end, span, &mut Both(&mut slips, tangent))?,
            None => self.pass(&mut end, span, &mut slips)?,
        }
        let moving = slips.slides(model);
        let unknowns = match span {
            ShotSpan::Half => every,
            ShotSpan::Cycles(_) => self.unknowns().of(&moving),
        };
        let derivatives = tangent.map(|tangent| tangent.derivatives(&end, &unknowns, span));
        Ok(Shot {
            end,
            derivatives,
            moving,
        })
    }

    /// Advances a motion to the end of a shot of the shooting method. A shot lasts `span`.
    pub(super) fn pass(
        &mut self,
        motion: &mut Motion<S, Z>,
        span: ShotSpan,
        watch: &mut impl Observe<S, Z>,
    ) -> Result<(), Halt> {
        match span {
            ShotSpan::Cycles(cycles) => self.advance(motion, cycles, watch),
            ShotSpan::Half => {
                self.advance_half(motion, watch)?;
                let state = motion.state().opposite();
                motion.restart(state);
                Ok(())
            }
        }
    }
}

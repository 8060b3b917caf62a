//! Rows and columns of the table of responses over frequency and friction.

use super::{MotionGroups, is_stuck};
use crate::study::columns::builder::Columns;
use crate::study::columns::column::{Column, Head, Shown};
use crate::study::columns::measure::PhysicalQuantity;
use crate::study::columns::motion::{MotionColumns, MotionRow, PartMotion, motions};
use crate::study::columns::setting::{AtFriction, Frequency, FrictionSetting, Setting, at};
use crate::study::{SystemAt, words};
use crate::{Limits, Of, OutOfDomain};

/// A row of the table: the response at one frequency and one friction.
#[derive(Clone, Debug)]
pub struct ResponseRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Friction in the contact, as ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// Regime of the contact: continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// Margin β/min(β_lim, β*_lim) − 1. If the margin is negative, a motion in which the contact slides all the time
    /// exists, and no stuck state exists.
    pub margin: f64,
    /// Method that computed the motion, or the reason why there is none.
    pub answer: &'static str,
    /// The offset of the contact's motion, and two flags. The first flag is true for a marginal response. The second
    /// flag is true if the motion from rest ends in this response. `None` if there is no response.
    known: Option<(f64, bool, bool)>,
    motions: Vec<MotionGroups>,
}

/// The table of responses over frequency and friction.
#[derive(Clone, Copy)]
pub struct ResponseTable<'a> {
    /// System, units, and the contact or masses whose motions the table contains.
    pub setting: Setting<'a>,
    /// Orders n of the harmonics that the table contains.
    pub orders: &'a [u32],
    /// True if rows with a stuck contact contain all motions. If false, rows with a stuck contact contain no harmonics
    /// and no motion of a rigid contact, which is at rest.
    pub stuck: bool,
}

at!(ResponseRow);

impl AtFriction for ResponseRow {
    fn friction(&self) -> FrictionSetting {
        self.friction
    }
}

impl MotionRow for ResponseRow {
    fn motion(&self, part: usize) -> Option<PartMotion<'_>> {
        self.motions.get(part).map(MotionGroups::view)
    }
}

impl<'a> ResponseTable<'a> {
    /// Computes the table rows at one frequency, one for each friction.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a frequency or a friction outside the domain.
    pub fn rows(
        &self,
        frequency: Frequency,
        frictions: impl Iterator<Item = FrictionSetting>,
    ) -> Result<Vec<ResponseRow>, OutOfDomain> {
        let at = self.setting.system.at(frequency.r)?;
        // The limits do not depend on β. One search for the limits therefore suffices for all rows.
        let limits = at.limits();
        frictions
            .map(|friction| friction.at(&self.setting.measure, frequency))
            .map(|friction| self.row(&at, &limits, frequency, friction))
            .collect()
    }

    fn row(
        &self,
        at: &SystemAt<'_>,
        limits: &Limits<f64>,
        frequency: Frequency,
        friction: FrictionSetting,
    ) -> Result<ResponseRow, OutOfDomain> {
        let margin = limits.margin(friction.beta)?;
        let response = at.response(friction.beta);
        let (regime, answer) = match &response {
            Ok(response) => (words::regime(response.regime()), words::answer(response)),
            Err(error) => (words::regime_without(*error), words::no_answer(*error)),
        };
        let response = response.ok();
        let measure = &self.setting.measure;
        let rigid = self.setting.system.scene().stiffness.is_none();
        let motions = self.setting.parts.iter().map(|part| {
            let Some(response) = &response else {
                return MotionGroups::default();
            };
            let mut motion = MotionGroups::of_response(response, part, self.orders);
            if measure.turns(part.of) {
                motion.turn(response.reversed_contact_phase());
            }
            if frequency.r.is_infinite() {
                motion.settle();
            }
            match self.stuck {
                true if frequency.r.is_infinite() => motion.leave_out_phase(),
                false if is_stuck(response) => {
                    motion.leave_out_stuck(rigid && part.of == Of::Contact)
                }
                _ => {}
            }
            motion
        });
        Ok(ResponseRow {
            frequency,
            friction,
            regime,
            margin,
            answer,
            motions: motions.collect(),
            known: response.map(|response| {
                let offset = measure.sign() * response.offset();
                (offset, response.is_marginal(), response.is_from_rest())
            }),
        })
    }

    /// Returns the columns of the table, from left to right.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, ResponseRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("regime", "continuous", |row: &ResponseRow| Some(row.regime));
        columns.number("margin", |row| Some(row.margin));
        columns.word("answer", "orbit: marginal", |row| Some(row.answer));
        columns.number(Head::of("offset", PhysicalQuantity::Length), |row| {
            Some(row.known?.0)
        });
        columns.show(Shown::Files);
        columns.flag("marginal", |row| Some(row.known?.1));
        columns.flag("from_rest", |row| Some(row.known?.2));
        columns.show(Shown::Everywhere);
        let extent = MotionColumns {
            monoharmonic: true,
            rates: false,
            orders: self.orders,
            complex: true,
        };
        motions(&mut columns, self.setting.parts, extent);
        columns.done()
    }
}

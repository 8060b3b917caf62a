//! Tables of branches of steady states along a parameter.

use super::builder::Columns;
use super::column::{Column, Head};
use super::joined::{JoinedRow, JoinedTable};
use super::setting::{Frequency, FrictionSetting};
use crate::study::joined::{AnswerUnits, BranchEvent, BranchRequest, JoinedBranch, JoinedError};
use crate::study::sensitivity::OperatingPoint;
use crate::study::words;

/// The place of a row on a branch.
#[derive(Clone, Debug)]
pub struct BranchPlace {
    /// Index of the branch.
    pub branch: usize,
    /// Value of the parameter in its own unit.
    pub value: f64,
    /// True if no small deviation grows.
    pub is_stable: bool,
    /// True if the motion repeats with the opposite sign after half a cycle.
    pub is_symmetric: bool,
    /// Names of the events at this point. The text is empty at an ordinary point.
    pub events: String,
}

impl<'a> JoinedTable<'a> {
    /// Follows branches, and computes the table row of each of their points. The list has one entry for each branch.
    ///
    /// # Errors
    /// Same errors as [`branches`](crate::study::joined::Joined::branches).
    pub fn branches(
        &self,
        request: &BranchRequest,
    ) -> Result<Vec<(JoinedBranch<'a>, Vec<JoinedRow>)>, JoinedError> {
        let names = self.joined.contact_names();
        let branches = self.joined.branches(request)?.into_iter().enumerate();
        let branches = branches.map(|(index, branch)| {
            let rows = branch.points.iter().map(|point| {
                let system = self.setting.system;
                let omega = point.orbit.omega();
                let frequency = Frequency::at(system, omega / system.angular_frequency(1.0));
                let scale = self.setting.measure.scale_at(omega);
                // The table has results in groups, which its columns convert to the units of the load.
                let orbit = match scale {
                    Some(scale) => &point.orbit.clone().in_units(AnswerUnits {
                        force: scale.force(),
                        length: scale.length(),
                        speed: omega * scale.length(),
                    }),
                    None => &point.orbit,
                };
                let friction = match (point.point, scale) {
                    (OperatingPoint::Physical { friction, .. }, Some(scale)) => {
                        FrictionSetting::of_force(friction, scale)
                    }
                    (OperatingPoint::Groups { beta, .. }, scale) => {
                        FrictionSetting::of_ratio(beta, scale)
                    }
                    (OperatingPoint::Physical { friction, .. }, None) => {
                        FrictionSetting::of_ratio(friction, None)
                    }
                };
                let events = point
                    .events
                    .iter()
                    .map(|event| words::branch_event(*event, &names));
                let place = BranchPlace {
                    branch: index,
                    value: point.value,
                    is_stable: !orbit.is_unstable(),
                    is_symmetric: point.is_symmetric,
                    events: events.collect::<Vec<_>>().join("; "),
                };
                self.of_orbit((frequency, friction), orbit, Some(place))
            });
            let rows: Result<Vec<JoinedRow>, JoinedError> = rows.collect();
            Ok((branch, rows?))
        });
        branches.collect()
    }

    /// Returns the columns of the table of branches. `parameter` is the symbol of the parameter, with its unit.
    #[must_use]
    pub fn branch_columns(
        &self,
        (symbol, unit): (&str, &'static str),
    ) -> Vec<Column<'a, JoinedRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        columns.count("branch", |row: &JoinedRow| Some(row.branch()?.branch));
        let head = Head::new("value").titled(&[symbol, unit]);
        columns.number(head, |row| Some(row.branch()?.value));
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("state", "unstable", |row| Some(row.state));
        columns.word("event", "symmetry breaking", |row| {
            Some(row.branch()?.events.as_str())
        });
        columns.word("symmetry", "asymmetric", |row| {
            Some(words::symmetry(row.branch()?.is_symmetric))
        });
        self.state_columns(&mut columns);
        self.part_columns(&mut columns);
        columns.done()
    }
}

impl BranchEvent {
    /// Returns true for a change of the number or the stability of states, and false for a change of the motion only.
    #[must_use]
    pub fn is_bifurcation(self) -> bool {
        !matches!(self, Self::Stops(_) | Self::Slides(_))
    }
}

//! Tables of branches of steady states along a parameter.

use super::builder::Columns;
use super::column::{Column, Head, TableRow};
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

/// The parameter along which a branch goes, and the first and the last value of it, as the user gives them.
#[derive(Clone, Copy, Debug)]
pub struct Along<'n> {
    /// Name of the parameter: `r`, `hz`, `omega`, `beta`, `friction`, or a symbol of the scene.
    pub name: &'n str,
    /// First and last value of the parameter, in the unit of its name.
    pub interval: (f64, f64),
}

impl Along<'_> {
    /// Returns true if the frequency varies.
    #[must_use]
    pub fn is_frequency(&self) -> bool {
        ["hz", "r", "omega"].contains(&self.name)
    }

    /// Returns true if the friction varies.
    #[must_use]
    pub fn is_friction(&self) -> bool {
        ["friction", "beta"].contains(&self.name)
    }

    /// Returns the question for branches from an operating point.
    ///
    /// # Errors
    /// [`JoinedError::UnknownParameter`] if there is no such parameter.
    pub fn request(
        &self,
        table: &JoinedTable<'_>,
        frequency: Frequency,
        friction: FrictionSetting,
    ) -> Result<BranchRequest, JoinedError> {
        let setting = &table.setting;
        let point = setting.point(frequency, friction);
        let symbol = match point {
            OperatingPoint::Physical { .. } if self.is_frequency() => "hz",
            OperatingPoint::Groups { .. } if self.is_frequency() => "r",
            _ if self.is_friction() => "friction",
            _ => self.name,
        };
        let parameter = table.joined.parameter_named(symbol, point)?;
        let load = setting.measure.scale();
        let converted = |value: f64| match load {
            _ if self.is_frequency() => {
                let frequency = setting.frequency.given(setting.system, value);
                load.map_or(frequency.r, |_| frequency.hertz)
            }
            Some(load) if self.name == "beta" => load.friction(value),
            _ => value,
        };
        let (from, to) = self.interval;
        let interval = (converted(from), converted(to));
        Ok(BranchRequest::new(point, parameter, interval))
    }
}

/// Row of the table of branches: where a branch begins and ends.
#[derive(Clone, Copy, Debug)]
pub struct BranchEndRow {
    /// Number of points on the branch.
    pub points: usize,
    /// Words for the reason why the branch ends.
    pub end: &'static str,
    /// Index of the branch on which the branch begins, or `None` if it begins at the first value of the parameter.
    pub parent: Option<usize>,
}

impl TableRow for BranchEndRow {}

impl BranchEndRow {
    /// Returns the row of a branch.
    #[must_use]
    pub fn of(branch: &JoinedBranch<'_>) -> Self {
        Self {
            points: branch.points.len(),
            end: words::branch_end(branch.end),
            parent: branch.parent.map(|parent| parent.branch),
        }
    }
}

impl<'a> JoinedTable<'a> {
    /// Returns the columns of the table that has one row for each branch.
    #[must_use]
    pub fn branch_end_columns(&self) -> Vec<Column<'a, BranchEndRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        columns.count("points", |row: &BranchEndRow| Some(row.points));
        columns.word("end", "bound of the parameter", |row| Some(row.end));
        columns.count("parent", |row| row.parent);
        columns.done()
    }

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

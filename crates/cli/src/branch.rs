//! `frictiongen branch`: follows steady states, stable or not, along a parameter.

use crate::args::{BranchArguments, FrequencyArguments, FrictionArguments};
use crate::asked;
use crate::destination::Destination;
#[cfg(feature = "pictures")]
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::from;
use crate::layout::Layout;
use crate::measure;
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
#[cfg(feature = "pictures")]
use crate::{joined::in_unit, picture};
use frictiongen::System;
use frictiongen::study::columns::{Along, BranchEndRow, Column, JoinedRow, JoinedTable, Setting};
use frictiongen::study::joined::{BranchRequest, JoinedBranch};
use frictiongen_codegen::SizeLimits;
#[cfg(feature = "pictures")]
use frictiongen_plot::{
    Label,
    desk::{BranchCurve, branch_figure},
};
use serde_json::{Value as Json, json};
use std::io::Write;

/// Runs `frictiongen branch`.
pub fn run(arguments: &BranchArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let (path, output) = (arguments.file.path(), arguments.output.as_deref());
    let destination = Destination::of(output, path, &arguments.format, true)?;
    let along = AlongOption::of(arguments)?;
    let frequencies = Frequencies::parse(&along.frequency(arguments)?, true)?;
    let frictions = Frictions::parse(&along.friction(arguments)?, Some(&frequencies))?;
    let system = System::try_from(arguments.file.any(&SizeLimits::RUN_TIME)?.scene);
    let system = system.map_err(Failure::new)?;
    frequencies.check(&system)?;
    let measure = measure::of(&arguments.load, &system)?;
    let system = from::started(arguments.start.from.as_deref(), system, &measure)?;
    let parts = asked::motions(&system, &arguments.of)?;
    let (frequencies, frictions) = (frequencies.under(&measure), frictions.under(&measure)?);
    let joined = system.joined().map_err(Failure::new)?;
    let table = JoinedTable {
        setting: Setting {
            frequencies: frequencies.given(),
            frictions: frictions.given(),
            forces: frictions.are_forces(),
            parts: &parts,
            ..Setting::new(&system, measure, frequencies.unit())
        },
        joined: &joined,
        orders: None,
    };
    let (frequency, friction) = (frequencies.only(&system)?, frictions.only()?);
    let request = along.parameter.request(&table, frequency, friction);
    let request = BranchRequest {
        all_states: arguments.states,
        switches: arguments.switch,
        most: arguments.points,
        ..request.map_err(|error| along.wrong(error))?
    };
    let (point, parameter) = (request.point, request.along);
    let report = BranchReport {
        table: &table,
        name: parameter.symbol(system.scene(), &point),
        unit: parameter.unit(&point),
        branches: table.branches(&request).map_err(Failure::new)?,
    };
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    destination.write(out, |out| {
        #[cfg(feature = "pictures")]
        if destination.form.is_picture() {
            return draw(&report, frequencies.are_physical(), destination.form, out);
        }
        output::write(&report, &summary, destination.form, out)
    })
}

/// The option `--along PARAMETER a:b`.
struct AlongOption<'t> {
    parameter: Along<'t>,
}

impl<'t> AlongOption<'t> {
    fn of(arguments: &'t BranchArguments) -> Result<Self, Failure> {
        let [name, interval] = arguments.along.as_slice() else {
            return Err(Failure::new(
                "--along: give a parameter and an interval a:b",
            ));
        };
        let name = name.trim();
        let wrong =
            |problem: &str| Failure::new(format_args!("--along {name} {interval}: {problem}"));
        let ends = interval.split_once(':');
        let (from, to) = ends.ok_or_else(|| wrong("an interval a:b is needed"))?;
        let [from, to] =
            [from, to].map(|end| end.trim().parse::<f64>().ok().filter(|end| end.is_finite()));
        let (Some(from), Some(to)) = (from, to) else {
            return Err(wrong("a and b must be numbers"));
        };
        if from == to {
            return Err(wrong("a and b must differ"));
        }
        let interval = (from, to);
        Ok(Self {
            parameter: Along { name, interval },
        })
    }

    fn wrong(&self, error: impl std::fmt::Display) -> Failure {
        Failure::new(format_args!("--along {}: {error}", self.parameter.name))
    }

    /// Returns the option of the frequency, or the first frequency of the interval.
    fn frequency(&self, arguments: &BranchArguments) -> Result<FrequencyArguments, Failure> {
        let [r, hz, omega] = self.options(
            (
                self.parameter.is_frequency(),
                "frequency",
                "--r, --hz and --omega",
            ),
            [
                ("r", &arguments.r),
                ("hz", &arguments.hz),
                ("omega", &arguments.omega),
            ],
        )?;
        Ok(FrequencyArguments { r, hz, omega })
    }

    /// Returns the option of the friction, or the first friction of the interval.
    fn friction(&self, arguments: &BranchArguments) -> Result<FrictionArguments, Failure> {
        let [beta, friction] = self.options(
            (
                self.parameter.is_friction(),
                "friction",
                "--beta and --friction",
            ),
            [("beta", &arguments.beta), ("friction", &arguments.friction)],
        )?;
        Ok(FrictionArguments { beta, friction })
    }

    /// Returns the options of a quantity, of which the user gives one, or none if the quantity varies. The option of a
    /// quantity that varies has the first value of the interval.
    fn options<const N: usize>(
        &self,
        (varies, quantity, names): (bool, &str, &str),
        given: [(&str, &Option<String>); N],
    ) -> Result<[Option<String>; N], Failure> {
        let count = given.iter().filter(|(_, text)| text.is_some()).count();
        match (varies, count) {
            (true, 0) => {
                let Along {
                    name: own,
                    interval: (from, _),
                } = self.parameter;
                Ok(given.map(|(name, _)| (own == name).then(|| format!("{from:?}"))))
            }
            (true, _) => Err(self.wrong(format_args!("the {quantity} varies; leave {names} out"))),
            (false, 1) => Ok(given.map(|(_, text)| text.clone())),
            (false, _) => Err(Failure::new(format_args!("give one of {names}"))),
        }
    }
}

/// Draws the amplitude of each motion over the parameter.
#[cfg(feature = "pictures")]
fn draw(
    report: &BranchReport<'_>,
    in_hertz: bool,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let setting = &report.table.setting;
    let scales = picture::scales(setting.system, in_hertz, &setting.measure);
    let contacts = report.table.joined.contact_names().len();
    let titles = setting.parts.iter().map(|part| {
        let label = scales.showing(part.of).size_label(part.size);
        (Label::verbatim(&part.name), label)
    });
    let titles: Vec<(Label, Label)> = titles.collect();
    let curves = report.branches.iter().enumerate();
    let curves = curves.map(|(index, (branch, rows))| {
        let values = setting.parts.iter().enumerate().map(|(place, part)| {
            let sizes = rows.iter().map(|row| {
                let size = row.amplitude(contacts + place).unwrap_or(f64::NAN);
                in_unit(size, part, (row.frequency.r, &scales))
            });
            sizes.collect()
        });
        let points = branch.points.iter().enumerate();
        let marked = points.filter(|(_, point)| {
            let mut events = point.events.iter();
            events.any(|event| event.is_bifurcation())
        });
        BranchCurve {
            name: Label::verbatim(&format!("branch {index}")),
            places: branch.points.iter().map(|point| point.value).collect(),
            stable: rows
                .iter()
                .map(|row| row.branch().is_some_and(|at| at.is_stable))
                .collect(),
            bifurcations: marked.map(|(place, _)| place).collect(),
            values: values.collect(),
        }
    });
    let curves: Vec<BranchCurve> = curves.collect();
    let parameter = match report.unit {
        "" => report.name.clone(),
        unit => format!("{} ({unit})", report.name),
    };
    let title = Label::verbatim(&setting.system.scene().name);
    let figure = branch_figure(title, &Label::verbatim(&parameter), &titles, &curves);
    let figure = picture::under_load(figure, &setting.measure, "");
    picture::write(figure, setting.system, form, out)
}

/// Branches of steady states, with the options for the output.
struct BranchReport<'s> {
    table: &'s JoinedTable<'s>,
    /// Symbol of the parameter.
    name: String,
    unit: &'static str,
    branches: Vec<(JoinedBranch<'s>, Vec<JoinedRow>)>,
}

impl BranchReport<'_> {
    /// Returns a row about the points and the end of each branch.
    fn rows(&self) -> impl Iterator<Item = BranchEndRow> + '_ {
        self.branches
            .iter()
            .map(|(branch, _)| BranchEndRow::of(branch))
    }

    /// Returns a sentence about where each branch begins and ends.
    fn ends(&self) -> String {
        let all = self.rows().enumerate().map(|(index, row)| {
            let begins = row.parent.map_or(String::new(), |parent| {
                format!(" begins on branch {parent}")
            });
            format!(
                "branch {index}:{begins} {} points, ends: {}",
                row.points, row.end
            )
        });
        all.collect::<Vec<_>>().join("; ")
    }
}

impl ResultTable for BranchReport<'_> {
    type Row = JoinedRow;

    fn len(&self) -> usize {
        self.branches.iter().map(|(_, rows)| rows.len()).sum()
    }

    fn each(&self, visit: Visitor<'_, JoinedRow>) -> Result<(), Failure> {
        let mut rows = self.branches.iter().flat_map(|(_, rows)| rows);
        rows.try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, JoinedRow>> {
        self.table.branch_columns((&self.name, self.unit))
    }

    fn layout(&self) -> Layout {
        Layout::Lines
    }

    fn head(&self) -> Vec<(String, Json)> {
        let branches = self
            .rows()
            .map(|row| json!({ "points": row.points, "end": row.end, "parent": row.parent }));
        vec![
            ("along".to_owned(), json!(self.name)),
            ("branches".to_owned(), branches.collect()),
        ]
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        vec![("branches", self.ends())]
    }
}

//! `frictiongen limits`: both limits over the frequency ratio.

use crate::args::LimitsArguments;
use crate::failure::Failure;
use crate::grid::{self, Quantity};
use crate::number::Value;
use crate::output::{self, Report, Visitor};
use crate::summary::Summary;
use crate::table::Column;
use frictiongen::System;
use frictiongen_codegen::Limits;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &LimitsArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let r = grid::parse(&arguments.r, Quantity::FrequencyRatio).map_err(Failure::new)?;
    let description = arguments.file.description(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let summary = Summary::of(&system);
    output::print(
        &LimitsReport { system, r },
        &summary,
        &arguments.format,
        out,
    )
}

struct LimitsReport {
    system: System,
    r: Vec<f64>,
}

/// The limits at one frequency ratio.
struct Point {
    r: f64,
    continuous: f64,
    without_search: f64,
    per_mode: f64,
    sliding: f64,
}

impl Point {
    fn values(&self) -> Vec<Value<'static>> {
        let values = [
            self.r,
            self.continuous,
            self.without_search,
            self.per_mode,
            self.sliding,
        ];
        values.map(Value::from).to_vec()
    }
}

impl Report for LimitsReport {
    type Point = Point;

    fn len(&self) -> usize {
        self.r.len()
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        for &r in &self.r {
            let at = self.system.at(r).map_err(Failure::new)?;
            let limits = at.limits();
            visit(&Point {
                r,
                continuous: limits.continuous,
                without_search: at.continuous_limit_without_search(),
                per_mode: at.continuous_limit_per_mode(),
                sliding: limits.sliding,
            })?;
        }
        Ok(())
    }

    fn columns(&self, _: &Summary) -> Vec<Column> {
        vec![
            Column::given(&["r"], &self.r),
            Column::computed(&["continuous limit", "beta_lim"]),
            Column::computed(&["without search", "beta_lim"]),
            Column::computed(&["per mode", "beta_lim"]),
            Column::computed(&["sliding limit", "beta*_lim"]),
        ]
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Value<'a>>> {
        vec![point.values()]
    }

    fn names(&self) -> Vec<String> {
        let names = [
            "r",
            "continuous_limit",
            "continuous_limit_without_search",
            "continuous_limit_per_mode",
            "sliding_limit",
        ];
        names.map(str::to_owned).to_vec()
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Value<'a>> {
        point.values()
    }

    fn json(&self, point: &Point) -> serde_json::Value {
        let names = self.names().into_iter();
        names
            .zip(point.values())
            .map(|(name, value)| (name, value.json()))
            .collect()
    }
}

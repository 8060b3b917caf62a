//! `frictiongen optimum`: finds the friction with which the largest amplitude over a band of frequencies is smallest.

mod keep;
mod shares;
mod valued;
mod weigh;

use crate::args::OptimumArguments;
use crate::asked::{self, MovingPart};
use crate::failure::Failure;
use crate::frequency::Band;
use crate::from;
use crate::interrupt;
use crate::measure::{self, Measure};
use crate::output::{self, ResultTable, Visitor};
use crate::progress::Progress;
use crate::summary::Summary;
use crate::vary::Vary;
use frictiongen::System;
use frictiongen::study::columns::{Column, OptimumLine, OptimumTable, Setting, Tuned};
use frictiongen::study::joined::JoinedError;
use frictiongen::study::optimum::{
    FrequencyBand, OptimumError, OptimumRequest, Tunable, TunedOptimum,
};
use frictiongen_codegen::SizeLimits;
use std::io::Write;
use std::sync::Mutex;
use valued::QuantityArgument;

/// Runs `frictiongen optimum`.
pub fn run(arguments: &OptimumArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let description = arguments.file.any(&SizeLimits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let band = Band::parse(&arguments.frequency, &system)?;
    if band.widest.is_some() {
        return Err(Failure::new(
            "a band is a:b, without a step, because the search covers all its frequencies",
        ));
    }
    let measure = measure::of(&arguments.load, &system)?;
    // Without a spring the ratios r and β are not defined.
    if system.scene().springs.is_empty() && !(band.is_physical() && measure.scale().is_some()) {
        return Err(Failure::new(JoinedError::NoSpring));
    }
    let system = from::started(arguments.start.from.as_deref(), system, &measure)?;
    let several = arguments.several(&system, &measure)?;
    let part = arguments.first(&system, &several)?;
    let band = band.under(&measure);
    let request = OptimumRequest {
        of: part.of,
        size: part.size,
        band: FrequencyBand::Ratio(band.from, band.to),
        load: measure.load(),
    };
    let table_of = |part| OptimumTable {
        setting: Setting {
            parts: std::slice::from_ref(part),
            ..Setting::new(&system, measure, band.unit())
        },
    };
    let table = table_of(&part);
    let kept = keep::parsed(&system, &arguments.keep, &measure)?;
    let ranges = arguments
        .vary
        .as_deref()
        .map(|text| shares::ranges(&system, text));
    let ranges = ranges.transpose()?.flatten();
    if ranges.is_some() && !kept.is_empty() {
        return Err(Failure::new(
            "--keep does not work with --vary share; leave one of them out",
        ));
    }
    interrupt::watch();
    let progress = Mutex::new(Progress::search());
    let watch = || {
        if let Ok(mut progress) = progress.lock() {
            progress.step();
        }
        !interrupt::pressed()
    };
    let lines = match (&arguments.vary, &ranges) {
        (_, Some(ranges)) => shares::lines(&table, &request, ranges, &watch)?,
        (..) if !several.is_empty() => weigh::lines(&table_of, &request, &several, &watch)?,
        (None, _) if !kept.is_empty() => keep::lines(&table, &request, &kept, &watch)?,
        (None, _) => {
            let found = system.optimum_watched(&request, &watch);
            table.lines(&found.map_err(Failure::new)?, None)
        }
        (Some(text), _) if !kept.is_empty() => {
            keep::varied_lines(&table, &request, &kept, text, &watch)?
        }
        (Some(text), _) => {
            let (of, found) = tuned(&system, &request, text, &watch)?;
            let tuned = Tuned { of, found: &found };
            table.lines(&tuned.optimum(), Some(&tuned))
        }
    };
    drop(progress);
    let summary = Summary::of(&system, band.is_physical(), measure);
    let report = OptimumReport { table, lines };
    output::write(&report, &summary, arguments.format.checked()?, out)?;
    if interrupt::pressed() {
        return Err(interrupt::search_stopped());
    }
    Ok(())
}

impl OptimumArguments {
    /// Parses the quantities of `--of`, if the user gives several. The list is empty for a single quantity.
    fn several(
        &self,
        system: &System,
        measure: &Measure,
    ) -> Result<Vec<QuantityArgument>, Failure> {
        if self.of.len() < 2 {
            return Ok(Vec::new());
        }
        let other = [
            (self.vary.is_some(), "--vary"),
            (!self.keep.is_empty(), "--keep"),
        ];
        if let Some((_, option)) = other.iter().find(|(given, _)| *given) {
            return Err(Failure::new(format_args!(
                "{option} needs a single quantity; give --of once"
            )));
        }
        weigh::parsed(system, &self.of, measure)
    }

    /// Returns the quantity of `--of`, or the first quantity if the user gives several.
    fn first(&self, system: &System, several: &[QuantityArgument]) -> Result<MovingPart, Failure> {
        match several.first() {
            Some(valued) => Ok(valued.part.clone()),
            None => asked::part(system, self.of.first().map_or("", String::as_str)),
        }
    }
}

/// Finds the best friction together with the best value of the number in the scene description that `--vary` names.
fn tuned(
    system: &System,
    request: &OptimumRequest,
    text: &str,
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<(Tunable, TunedOptimum), Failure> {
    let vary = Vary::parsed(text)?;
    let tuning = vary.tuning(system)?;
    let found = system.tuned_optimum_watched(request, &tuning, watch);
    let found = found.map_err(|error| match error {
        OptimumError::Interval | OptimumError::Scene(_) => vary.wrong(&error),
        _ => Failure::new(error),
    })?;
    Ok((tuning.of, found))
}

struct OptimumReport<'a> {
    table: OptimumTable<'a>,
    lines: Vec<OptimumLine>,
}

impl ResultTable for OptimumReport<'_> {
    type Row = OptimumLine;

    fn len(&self) -> usize {
        self.lines.len()
    }

    fn each(&self, visit: Visitor<'_, OptimumLine>) -> Result<(), Failure> {
        self.lines.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, OptimumLine>> {
        self.table.line_columns(&self.lines)
    }
}

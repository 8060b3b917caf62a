//! `frictiongen optimum`: finds the friction with which the largest amplitude over a band of frequencies is smallest.

mod valued;

use crate::args::OptimumArguments;
use crate::asked::{self, MovingPart};
use crate::failure::Failure;
use crate::frequency::Band;
use crate::from;
use crate::interrupt;
use crate::measure::{self, Measure};
use crate::number::computed;
use crate::output::{self, ResultTable, Visitor};
use crate::progress::Progress;
use crate::summary::Summary;
use crate::vary::Vary;
use frictiongen::System;
use frictiongen::study::columns::{Column, OptimumLine, OptimumTable, Setting};
use frictiongen::study::joined::JoinedError;
use frictiongen::study::optimum::{
    FrequencyBand, OptimumError, OptimumOptions, OptimumRequest, Tuning,
};
use frictiongen_codegen::SizeLimits;
use std::io::Write;
use std::sync::Mutex;
use valued::{QuantityArgument, values};

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
    let bounds = valued::bounds(&system, &arguments.keep, &measure)?;
    let vary = arguments.vary.as_deref().map(Vary::parsed).transpose()?;
    let tunings = match &vary {
        Some(vary) => vary.tunings(&system)?,
        None => Vec::new(),
    };
    interrupt::watch();
    let progress = Mutex::new(Progress::search());
    let watch = || {
        if let Ok(mut progress) = progress.lock() {
            progress.step();
        }
        !interrupt::pressed()
    };
    let options = OptimumOptions {
        kept: &values(&bounds),
        weighted: &values(&several),
        vary: &tunings,
        watch: Some(&watch),
        ..OptimumOptions::default()
    };
    let found = system.optimum_with(&request, &options);
    drop(progress);
    let setting = Setting {
        parts: std::slice::from_ref(&part),
        ..Setting::new(&system, measure, band.unit())
    };
    let found = found.map_err(|error| match (&vary, error) {
        (Some(vary), error @ (OptimumError::Interval | OptimumError::Scene(_))) => {
            vary.wrong(&error)
        }
        (_, error) => failure(&setting, &bounds, (tunings.first(), error)),
    })?;
    let part = several.get(found.decisive).map_or(&part, |one| &one.part);
    let table = OptimumTable {
        setting: Setting {
            parts: std::slice::from_ref(part),
            ..setting
        },
        kept: &valued::parts(&bounds),
        weighted: &valued::parts(&several),
    };
    let summary = Summary::of(&system, band.is_physical(), measure);
    let lines = table.lines(&found);
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
        valued::quotients(system, &self.of, measure)
    }

    /// Returns the quantity of `--of`, or the first quantity if the user gives several.
    fn first(&self, system: &System, several: &[QuantityArgument]) -> Result<MovingPart, Failure> {
        match several.first() {
            Some(valued) => Ok(valued.part.clone()),
            None => asked::part(system, self.of.first().map_or("", String::as_str)),
        }
    }
}

/// Returns the failure for an error of the search. If no friction keeps a quantity within its bound, the failure names
/// this bound.
fn failure(
    setting: &Setting<'_>,
    bounds: &[QuantityArgument],
    (tuning, error): (Option<&Tuning>, OptimumError),
) -> Failure {
    let (system, measure) = (setting.system, &setting.measure);
    let OptimumError::Unreachable {
        index,
        least,
        beta,
        value,
    } = error
    else {
        return Failure::new(error);
    };
    let Some(bound) = bounds.get(index) else {
        return Failure::new(error);
    };
    let dimension = bound.part.dimension();
    let reference = system.angular_frequency(1.0);
    let before = match index {
        0 => "",
        _ => " together with the bounds before it",
    };
    let friction = format!(
        "a friction of {} {}",
        computed(measure.force(beta)),
        match measure.scale() {
            Some(_) => "N",
            None => "(beta)",
        }
    );
    let (any, at) = match tuning.zip(value) {
        None => (String::new(), friction),
        Some((tuning, value)) => {
            let name = tuning.of.symbol(system.scene());
            let value = format!("{} {}", computed(value), tuning.of.unit());
            let at = format!("{friction} and with {name} = {}", value.trim_end());
            (format!(" at any value of {name}"), at)
        }
    };
    let unit = measure.unit_or_reference(dimension);
    let least = format!(
        "{} {unit}",
        computed(measure.convert(dimension, least, reference))
    );
    Failure::new(format_args!(
        "--keep `{} <= {}`: no friction holds this bound{before}{any}; the least value is {}, with {at}",
        bound.name,
        bound.text,
        least.trim_end(),
    ))
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

//! `frictiongen optimum`: finds the friction that keeps the largest amplitude over a band smallest.

use crate::args::OptimumArguments;
use crate::asked::{self, Part};
use crate::failure::Failure;
use crate::frequency::Band;
use crate::measure::{self, Dimension, Measure};
use crate::number::{Cell, Exact as _};
use crate::output::{self, Report, Visitor};
use crate::summary::Summary;
use crate::table::Column;
use frictiongen::System;
use frictiongen::study::{
    FrequencyBand, OperatingPoint, Optimum, OptimumEnd, OptimumError, OptimumRequest, TunedPoint,
    Tuning, words,
};
use frictiongen_codegen::Limits;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &OptimumArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let description = arguments.file.constant_level(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let band = Band::parse(&arguments.frequency, &system)?;
    if band.widest.is_some() {
        return Err(Failure::new(
            "a band is a:b, without a step, because the search covers all its frequencies",
        ));
    }
    let part = asked::part(&system, &arguments.of)?;
    let measure = measure::of(&arguments.load, &system)?;
    let band = band.under(&measure);
    let request = OptimumRequest {
        of: part.of,
        band: FrequencyBand::Ratio(band.from, band.to),
        load: measure.load(),
    };
    let (optimum, tuned) = match &arguments.vary {
        None => (system.optimum(&request).map_err(Failure::new)?, None),
        Some(text) => {
            let (optimum, tuned) = tuned(&system, &request, text)?;
            (optimum, Some(tuned))
        }
    };
    let summary = Summary::of(&system, band.is_physical(), measure);
    let report = OptimumReport {
        optimum,
        tuned,
        band,
        measure,
        part,
        system,
    };
    output::print(&report, &summary, arguments.format.checked()?, out)
}

/// Finds the best friction together with the number that `--vary` names.
fn tuned(
    system: &System,
    request: &OptimumRequest,
    text: &str,
) -> Result<(Optimum, Tuned), Failure> {
    let wrong =
        |problem: &dyn std::fmt::Display| Failure::new(format_args!("--vary `{text}`: {problem}"));
    let (name, interval) = text.rsplit_once('=').ok_or_else(|| {
        wrong(&"a number of the description and an interval are needed, NAME=a:b")
    })?;
    let of = system.tunable_named(name).map_err(|error| wrong(&error))?;
    let (from, to) = interval
        .split_once(':')
        .ok_or_else(|| wrong(&"an interval a:b is needed"))?;
    let [from, to] = [from, to].map(|end| {
        let number = end.trim().parse::<f64>();
        number.map_err(|_| wrong(&format_args!("`{}` is not a number", end.trim())))
    });
    let (from, to) = (from?, to?);
    let found = system.tuned_optimum(request, &Tuning { of, from, to });
    let found = found.map_err(|error| match error {
        OptimumError::Interval | OptimumError::Scene(_) => wrong(&error),
        _ => Failure::new(error),
    })?;
    let tuned = Tuned {
        name: of.symbol(system.scene()),
        unit: of.unit(),
        value: found.value,
        at_end: found.at_end,
        scan: found.scan,
        evaluations: found.evaluations,
    };
    Ok((found.optimum, tuned))
}

/// The number that was chosen together with friction.
struct Tuned {
    name: String,
    unit: &'static str,
    value: f64,
    at_end: bool,
    scan: Vec<TunedPoint>,
    evaluations: usize,
}

struct OptimumReport {
    optimum: Optimum,
    tuned: Option<Tuned>,
    band: Band,
    measure: Measure,
    part: Part,
    system: System,
}

/// A line of the output: a number with its name.
struct Line {
    name: String,
    value: Cell<'static>,
    unit: &'static str,
}

impl OptimumReport {
    fn lines(&self) -> Vec<Line> {
        let optimum = &self.optimum;
        let mut lines = Vec::new();
        let mut add = |name: String, value: Cell<'static>, unit: &'static str| {
            lines.push(Line { name, value, unit });
        };
        let physical = self.measure.load().is_some();
        let length = match (physical, self.measure.title(Dimension::Length)) {
            (true, _) => "m",
            (false, "(of Y)") => "Y",
            (false, _) => "P/k1",
        };
        let size = |amplitude: f64| Cell::from(self.measure.length(amplitude));
        let friction = |beta: f64| -> (f64, &'static str) {
            match self.measure.scale() {
                Some(scale) => (scale.friction(beta), "N"),
                None => (beta, ""),
            }
        };
        if let Some(tuned) = &self.tuned {
            add(tuned.name.clone(), tuned.value.into(), tuned.unit);
            if tuned.at_end {
                let end = "a bound of the interval; a value beyond it may be better";
                add("which is".to_owned(), end.into(), "");
            }
        }
        let (force, unit) = friction(optimum.beta);
        add("friction".to_owned(), force.into(), unit);
        if physical {
            add("beta".to_owned(), optimum.beta.into(), "");
        }
        add(
            format!("largest amplitude of {}", self.part.name),
            size(optimum.amplitude),
            length,
        );
        let kind = words::kind(optimum.kind);
        add("what limits it".to_owned(), kind.into(), "");
        let end = words::end(optimum.end);
        add("how the search ended".to_owned(), end.into(), "");
        if optimum.end != OptimumEnd::Converged {
            let [from, to] = optimum.bracket.map(friction);
            add("the least lies from".to_owned(), from.0.into(), from.1);
            add("the least lies to".to_owned(), to.0.into(), to.1);
        }
        for peak in &optimum.peaks {
            let at = if peak.at_end {
                "peak at the end of the band at"
            } else {
                "peak at"
            };
            let frequency = self.band.frequency(&self.system, peak.r);
            if self.band.tells_hertz() {
                add(at.to_owned(), frequency.hertz(&self.system).into(), "Hz");
            }
            add(format!("{at} r"), peak.r.into(), "");
            add("  amplitude".to_owned(), size(peak.amplitude), length);
            add("  regime".to_owned(), words::regime(peak.regime).into(), "");
        }
        for tolerance in &optimum.tolerances {
            let percent = format!("{:.0} % above the best", tolerance.excess * 100.0);
            let (from, unit) = friction(tolerance.from);
            add(format!("{percent}: friction from"), from.into(), unit);
            let (to, unit) = friction(tolerance.to);
            add(format!("{percent}: friction to"), to.into(), unit);
        }
        if 0.0 < optimum.unbounded_to {
            let (force, unit) = friction(optimum.unbounded_to);
            add(
                "unbounded at a resonance up to".to_owned(),
                force.into(),
                unit,
            );
        }
        for (name, beta) in [
            ("nothing sticks up to", optimum.free_of_sticking),
            ("stuck over the whole band from", optimum.locked),
        ] {
            let (force, unit) = friction(beta);
            add(name.to_owned(), force.into(), unit);
        }
        add(
            "largest amplitude without friction".to_owned(),
            size(optimum.without_friction),
            length,
        );
        add(
            "largest amplitude with the contact stuck".to_owned(),
            size(optimum.with_contact_locked),
            length,
        );
        if let Some(load) = self.measure.load() {
            let point = OperatingPoint::Physical {
                hertz: 1.0,
                friction: 1.0,
                load,
            };
            for (parameter, relative) in &optimum.sensitivities {
                let symbol = parameter.symbol(self.system.scene(), &point);
                add(
                    format!("per cent of it for one per cent of {symbol}"),
                    (*relative).into(),
                    "",
                );
            }
        }
        if let Some(Tuned {
            name, unit, scan, ..
        }) = &self.tuned
        {
            for point in scan {
                add(format!("at {name}"), point.value.into(), unit);
                let (force, unit) = friction(point.beta);
                add("  best friction".to_owned(), force.into(), unit);
                let amplitude = size(point.amplitude);
                add("  largest amplitude".to_owned(), amplitude, length);
            }
        }
        let tuned = self.tuned.as_ref();
        let evaluations = tuned.map_or(optimum.evaluations, |tuned| tuned.evaluations);
        add("amplitudes computed".to_owned(), evaluations.into(), "");
        if optimum.unanswered > 0 {
            add(
                "of these without an answer".to_owned(),
                optimum.unanswered.into(),
                "",
            );
        }
        lines
    }
}

fn cells(line: &Line) -> Vec<Cell<'_>> {
    vec![
        line.name.as_str().into(),
        line.value.clone(),
        line.unit.into(),
    ]
}

impl Report for OptimumReport {
    type Point = Line;

    fn len(&self) -> usize {
        self.lines().len()
    }

    fn each(&self, visit: Visitor<'_, Line>) -> Result<(), Failure> {
        self.lines().iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column> {
        let lines = self.lines();
        vec![
            Column::words(&["quantity"], lines.iter().map(|line| line.name.as_str())),
            Column::computed(&["value"]),
            Column::words(&["unit"], ["P/k1"]),
        ]
    }

    fn rows<'a>(&'a self, line: &'a Line) -> Vec<Vec<Cell<'a>>> {
        vec![cells(line)]
    }

    fn names(&self) -> Vec<String> {
        ["quantity", "value", "unit"].map(str::to_owned).to_vec()
    }

    fn record<'a>(&'a self, line: &'a Line) -> Vec<Cell<'a>> {
        cells(line)
    }

    fn json(&self, line: &Line) -> serde_json::Value {
        let names = self.names().into_iter();
        names
            .zip(cells(line))
            .map(|(name, value)| (name, value.json()))
            .collect()
    }
}

//! `frictiongen sensitivity`: computes derivatives of a response and of both limits, one line for each parameter.

use crate::args::SensitivityArguments;
use crate::asked::{self, Part};
use crate::failure::Failure;
use crate::frequency::{Frequencies, Frequency};
use crate::friction::{Friction, Frictions};
use crate::measure::{self, Dimension, Measure};
use crate::number::{Cell, Exact as _};
use crate::output::{self, Report, Visitor};
use crate::summary::Summary;
use crate::table::Column;
use frictiongen::System;
use frictiongen::study::{OperatingPoint, ParameterSensitivity, Slope, words};
use frictiongen_codegen::Limits;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &SensitivityArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let frequencies = Frequencies::parse(&arguments.point.frequency, true)?;
    let frictions = Frictions::parse(&arguments.point.friction, Some(&frequencies))?;
    let description = arguments.point.file.constant_level(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let part = asked::part(&system, &arguments.of)?;
    frequencies.check(&system)?;
    let measure = measure::of(&arguments.point.load, &system)?;
    let frequencies = frequencies.under(&measure);
    let frictions = frictions.under(&measure)?;
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let report = SensitivityReport {
        system,
        frequencies,
        frictions,
        measure,
        part,
    };
    output::print(&report, &summary, arguments.format.checked()?, out)
}

struct SensitivityReport {
    system: System,
    frequencies: Frequencies,
    frictions: Frictions,
    measure: Measure,
    part: Part,
}

/// The derivatives with respect to one parameter at one point, or the reason why there are none.
struct Point {
    frequency: Frequency,
    friction: Friction,
    regime: &'static str,
    /// The reason why there are no derivatives.
    answer: &'static str,
    first: bool,
    found: Option<Found>,
}

struct Found {
    symbol: String,
    unit: &'static str,
    sensitivity: ParameterSensitivity,
}

/// Answers: the names of their cells, and their headings.
const ANSWERS: [(&str, &str); 4] = [
    ("amplitude", "amplitude"),
    ("phase", "phase"),
    ("continuous_limit", "continuous limit"),
    ("sliding_limit", "sliding limit"),
];

/// Name of the line with the answers themselves.
const ITSELF: &str = "the answer";

impl Found {
    fn answers(&self) -> [Option<Slope>; 4] {
        let of = &self.sensitivity;
        [
            Some(of.amplitude),
            of.phase,
            of.continuous_limit,
            of.sliding_limit,
        ]
    }

    /// Returns for each answer its derivative, and p/X times the derivative. For the phase the second is p times the
    /// derivative.
    fn derivatives(&self, measure: &Measure) -> Vec<Cell<'static>> {
        let parameter = self.sensitivity.value;
        let cells = self.answers().into_iter().enumerate();
        cells
            .flat_map(|(place, slope)| match slope {
                None => [Cell::Missing, Cell::Missing],
                Some(slope) if place == 1 => {
                    let derivative = measure.angle(slope.derivative);
                    [derivative.into(), (parameter * derivative).into()]
                }
                Some(slope) => [slope.derivative.into(), slope.relative(parameter).into()],
            })
            .collect()
    }

    /// Returns the answers themselves.
    fn values(&self, measure: &Measure) -> [Cell<'static>; 4] {
        let [amplitude, phase, continuous, sliding] =
            self.answers().map(|slope| slope.map(|slope| slope.value));
        [
            amplitude.into(),
            phase.map(|phase| measure.angle(phase)).into(),
            continuous.into(),
            sliding.into(),
        ]
    }
}

impl SensitivityReport {
    fn point(&self, frequency: &Frequency, friction: &Friction) -> OperatingPoint {
        match self.measure.load() {
            Some(load) => OperatingPoint::Physical {
                hertz: frequency.hertz(&self.system),
                friction: friction.force(),
                load,
            },
            None => OperatingPoint::Groups {
                r: frequency.r,
                beta: friction.beta,
            },
        }
    }

    fn heading<'a>(&self, point: &'a Point) -> Vec<Cell<'a>> {
        let mut values: Vec<Cell<'a>> = point.frequency.values();
        values.extend(point.friction.values());
        values.extend([point.regime.into(), point.answer.into()]);
        values
    }

    fn parameter(found: &Found) -> [Cell<'_>; 3] {
        [
            found.symbol.as_str().into(),
            found.sensitivity.value.into(),
            found.unit.into(),
        ]
    }

    /// Returns the units of the answers, for headings.
    fn units(&self) -> [&'static str; 4] {
        let force = if self.measure.load().is_some() {
            "(N)"
        } else {
            "(beta)"
        };
        [
            self.measure.title(Dimension::Length),
            self.measure.title(Dimension::Angle),
            force,
            force,
        ]
    }
}

impl Report for SensitivityReport {
    type Point = Point;

    fn len(&self) -> usize {
        self.frequencies.len() * self.frictions.len()
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        for frequency in self.frequencies.iter(&self.system) {
            for friction in self.frictions.iter() {
                let asked = self.point(&frequency, &friction);
                let empty = Point {
                    frequency,
                    friction,
                    regime: "",
                    answer: "",
                    first: true,
                    found: None,
                };
                let known = match self.system.response_sensitivities(asked, self.part.of) {
                    Ok(known) => known,
                    Err(error) => {
                        let answer =
                            words::no_derivative(&error).ok_or_else(|| Failure::new(&error))?;
                        visit(&Point { answer, ..empty })?;
                        continue;
                    }
                };
                let regime = words::regime(known.regime);
                for (place, sensitivity) in known.parameters.into_iter().enumerate() {
                    let parameter = sensitivity.parameter;
                    visit(&Point {
                        regime,
                        answer: "exact",
                        first: place == 0,
                        found: Some(Found {
                            symbol: parameter.symbol(self.system.scene(), &asked),
                            unit: parameter.unit(&asked),
                            sensitivity,
                        }),
                        ..empty
                    })?;
                }
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column> {
        let scene = self.system.scene();
        let masses = scene.masses.iter().map(|mass| mass.name.len() + 2);
        let springs = scene.springs.iter().map(|spring| {
            scene.node_name(spring.from).len() + scene.node_name(spring.to).len() + 5
        });
        let widest = masses.chain(springs).max().unwrap_or(0);
        let widest = "-".repeat(widest.max(ITSELF.len()));
        let mut columns = self.frequencies.columns();
        columns.extend(self.frictions.columns());
        columns.extend([
            Column::words(&["regime"], ["continuous", "stick-slip"]),
            Column::words(&["answer"], ["degenerate"]),
            Column::words(&["parameter", "p"], [widest.as_str()]),
            Column::computed(&["value"]),
            Column::words(&["unit"], ["N/m"]),
        ]);
        for ((place, (_, title)), unit) in ANSWERS.iter().enumerate().zip(self.units()) {
            let relative = if place == 1 { "p d/dp" } else { "(p/X) d/dp" };
            let title = if place == 0 {
                format!("{title} {}", self.part.name)
            } else {
                (*title).to_owned()
            };
            columns.extend([
                Column::computed(&[&title, &format!("X {unit}, d/dp")]),
                Column::computed(&["", relative]),
            ]);
        }
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Cell<'a>>> {
        let Some(found) = &point.found else {
            return vec![self.heading(point)];
        };
        let mut rows = Vec::new();
        if point.first {
            let mut row = self.heading(point);
            row.extend([ITSELF.into(), Cell::Missing, Cell::Missing]);
            for value in found.values(&self.measure) {
                row.extend([value, Cell::Missing]);
            }
            rows.push(row);
        }
        let mut row = self.heading(point);
        row.extend(Self::parameter(found));
        row.extend(found.derivatives(&self.measure));
        rows.push(row);
        rows
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<String> = [self.frequencies.names(), self.frictions.names()]
            .concat()
            .into_iter()
            .map(str::to_owned)
            .collect();
        names.extend(["regime", "answer", "parameter", "value", "unit"].map(str::to_owned));
        let physical = self.measure.load().is_some();
        let named = |place: usize, name: &str| match place {
            0 => self.measure.name(name, Dimension::Length),
            1 => self.measure.name(name, Dimension::Angle),
            _ if physical => format!("{name}_N"),
            _ => name.to_owned(),
        };
        for (place, (name, _)) in ANSWERS.iter().enumerate() {
            let name = named(place, name);
            names.extend([
                name.clone(),
                format!("{name}.derivative"),
                format!("{name}.relative"),
            ]);
        }
        names
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Cell<'a>> {
        let mut cells = self.heading(point);
        let Some(found) = &point.found else {
            cells.resize(self.names().len(), Cell::Missing);
            return cells;
        };
        cells.extend(Self::parameter(found));
        let derivatives = found.derivatives(&self.measure);
        for (value, both) in found
            .values(&self.measure)
            .into_iter()
            .zip(derivatives.chunks(2))
        {
            cells.push(value);
            cells.extend(both.iter().cloned());
        }
        cells
    }

    fn json(&self, point: &Point) -> serde_json::Value {
        let names = self.names().into_iter();
        names
            .zip(self.record(point))
            .map(|(name, value)| (name, value.json()))
            .collect()
    }
}

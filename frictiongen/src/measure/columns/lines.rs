//! Results of measurements as lines of a table. A line has a key for programs, a quantity in words, its value with an
//! interval, and its unit.

use super::drive;
use super::once::scaled;
use crate::measure::{
    Estimate, Explained, FreeDecay, Identified, MotionFit, Observation, SweepFit, Unknown,
};
use crate::study::columns::{Cell, Column, ColumnKind, Columns, Head, Measure, Shown, TableRow};
use crate::study::sensitivity::Quantity;
use crate::study::units::{hertz, polar};
use crate::study::{System, words};
use std::f64::consts::TAU;

/// Row of the table of results: one quantity with its value, interval and unit.
#[derive(Clone, Debug)]
pub struct QuantityLine {
    /// Number of the recording to which the quantity belongs, counted from 1.
    pub recording: Option<usize>,
    /// Key by which programs find the quantity. It is unique among the quantities of a recording.
    pub key: String,
    /// Name of the quantity, in words for people.
    pub label: String,
    /// The value of the quantity, in the unit `unit`.
    pub value: Cell<'static>,
    /// Lower and upper bound of the 95 % confidence interval of the quantity's value.
    pub interval: Option<(f64, f64)>,
    /// Unit of the quantity's value.
    pub unit: &'static str,
}

impl TableRow for QuantityLine {}

/// A list of result lines, to which the functions of this module add lines.
#[derive(Default)]
struct QuantityLines {
    recording: Option<usize>,
    all: Vec<QuantityLine>,
}

impl QuantityLines {
    fn number(&mut self, key: &str, label: &str, value: f64, unit: &'static str) {
        self.add((key, label), value.into(), None, unit);
    }

    fn word(&mut self, key: &str, label: &str, word: &'static str) {
        self.add((key, label), word.into(), None, "");
    }

    fn estimate(&mut self, key: &str, label: &str, found: Estimate, unit: &'static str) {
        let interval = (found.from, found.to);
        self.add((key, label), found.value.into(), Some(interval), unit);
    }

    fn add(
        &mut self,
        (key, label): (&str, &str),
        value: Cell<'static>,
        interval: Option<(f64, f64)>,
        unit: &'static str,
    ) {
        self.all.push(QuantityLine {
            recording: self.recording,
            key: key.to_owned(),
            label: label.to_owned(),
            value,
            interval,
            unit,
        });
    }
}

/// Returns the columns of a table whose rows are quantities.
#[must_use]
pub fn line_columns<'a>(system: &System, lines: &[QuantityLine]) -> Vec<Column<'a, QuantityLine>> {
    let widest = lines.iter().map(|line| line.label.as_str());
    let widest = widest.max_by_key(|label| label.chars().count());
    let mut columns = Columns::new(&Measure::si(system));
    columns.show(Shown::Json);
    columns.count("recording", |line: &QuantityLine| line.recording);
    columns.word("key", "", |line| Some(&line.key));
    columns.show(Shown::Everywhere);
    columns.word("quantity", widest.unwrap_or_default(), |line| {
        Some(&line.label)
    });
    columns.cell("value", ColumnKind::Number, |line| line.value.borrowed());
    columns.number(Head::new("from").titled(&["from", "(95 %)"]), |line| {
        Some(line.interval?.0)
    });
    columns.number(Head::new("to").titled(&["to", "(95 %)"]), |line| {
        Some(line.interval?.1)
    });
    columns.word("unit", "rad/s", |line| Some(line.unit));
    columns.done()
}

/// Returns the result of a fit to a free vibration, as lines of a table.
#[must_use]
pub fn decay_lines(found: &FreeDecay) -> Vec<QuantityLine> {
    let mut lines = QuantityLines::default();
    lines.estimate("friction_N", "friction force", found.friction, "N");
    lines.estimate("length_m", "F/k", found.length, "m");
    let label = "F/k by the linear decrement";
    lines.number("linear_decrement_m", label, found.linear_decrement, "m");
    lines.estimate("frequency_Hz", "natural frequency", found.hertz, "Hz");
    lines.estimate("damping", "zeta", found.damping, "");
    let count = found.extremes.len() as f64;
    lines.number("extremes", "extremes used", count, "");
    lines.number("misfit", "misfit (1 is noise)", found.misfit, "");
    lines.all
}

/// Returns the result of a fit to `points` points of a frequency sweep, as lines of a table.
#[must_use]
pub fn fit_lines(system: &System, found: &SweepFit, points: usize) -> Vec<QuantityLine> {
    let mut lines = QuantityLines::default();
    let scene = system.scene();
    lines.estimate("reference_Hz", "sqrt(k1/m1)", found.reference, "Hz");
    // The next two lines of the table are the quotients r/f and r/ω, with f in Hz and ω in rad/s.
    let inverse = Estimate {
        value: 1.0 / found.reference.value,
        from: 1.0 / found.reference.to,
        to: 1.0 / found.reference.from,
    };
    lines.estimate("r_per_Hz", "r per Hz", inverse, "s");
    let per_omega = scaled(inverse, 1.0 / TAU);
    lines.estimate("r_per_rad_s", "r per rad/s", per_omega, "s");
    for (mass, gamma) in scene.masses.iter().skip(1).zip(&found.masses) {
        let name = &mass.name;
        let (key, label) = (format!("gamma.{name}"), format!("gamma {name}"));
        lines.estimate(&key, &label, *gamma, "");
    }
    for (spring, kappa) in scene.springs.iter().skip(1).zip(&found.springs) {
        let (from, to) = (scene.node_name(spring.from), scene.node_name(spring.to));
        let label = format!("kappa {from} - {to}");
        lines.estimate(&format!("kappa.{from}-{to}"), &label, *kappa, "");
    }
    if let Some(damping) = found.damping {
        lines.estimate("damping", "zeta", damping, "");
    }
    for (mode, natural) in (1..).zip(&found.natural) {
        natural_frequency(&mut lines, mode, *natural);
    }
    lines.number("points", "points", points as f64, "");
    lines.number("scatter", "relative scatter", found.scatter, "");
    if let Some(misfit) = found.misfit {
        lines.number("misfit", "misfit (1 is noise)", misfit, "");
    }
    lines.number("condition", "condition", found.condition, "");
    described(&mut lines, &found.system);
    lines.all
}

/// Returns the result of a fit to the whole motion in a recording, as lines of a table.
#[must_use]
pub fn motion_lines(system: &System, found: &MotionFit) -> Vec<QuantityLine> {
    let mut lines = QuantityLines::default();
    if let Some(friction) = found.friction {
        lines.estimate("friction_N", "friction force", friction, "N");
    }
    for (number, estimate) in &found.numbers {
        let symbol = number.symbol(system.scene());
        let key = symbol.replace(" - ", "-").replace(' ', ".");
        lines.estimate(&key, &symbol, *estimate, number.unit());
    }
    lines.number("scatter", "relative scatter", found.scatter, "");
    lines.number("condition", "condition", found.condition, "");
    lines.number("runs", "runs", found.runs as f64, "");
    let label = "runs with exact derivatives";
    lines.number("exact_derivatives", label, found.derivatives as f64, "");
    let label = "derivatives by differences";
    lines.number("differences", label, found.differences as f64, "");
    lines.all
}

fn natural_frequency(lines: &mut QuantityLines, mode: usize, found: Estimate) {
    let key = format!("natural_frequency_{mode}_Hz");
    lines.estimate(&key, &format!("natural frequency {mode}"), found, "Hz");
}

/// Adds the masses and springs of the fitted description as lines. The fit does not change the first mass.
fn described(lines: &mut QuantityLines, system: &System) {
    let scene = system.scene();
    for mass in &scene.masses {
        let name = &mass.name;
        let label = format!("mass {name} of the description");
        lines.number(&format!("m.{name}"), &label, mass.value, "kg");
    }
    for spring in &scene.springs {
        let (from, to) = (scene.node_name(spring.from), scene.node_name(spring.to));
        let label = format!("spring {from} - {to} of the description");
        lines.number(&format!("k.{from}-{to}"), &label, spring.stiffness, "N/m");
    }
}

/// Returns the result of an identification of the friction force, as lines of a table.
#[must_use]
pub fn identify_lines(
    system: &System,
    observations: &[Observation],
    found: &Identified,
) -> Vec<QuantityLine> {
    let mut lines = QuantityLines::default();
    lines.word("verdict", "friction force is", found.verdict.word());
    if 1 < found.levels.len() {
        for (index, level) in (1..).zip(&found.levels) {
            let (key, label): (String, String) = (
                format!("friction_{index}_N"),
                format!("friction force {index}"),
            );
            lines.estimate(&key, &label, *level, "N");
        }
    } else {
        lines.estimate("friction_N", "friction force", found.friction, "N");
    }
    for (unknown, estimate) in &found.unknowns {
        let symbol = unknown.symbol(system);
        match unknown {
            Unknown::Frequencies => {
                for (mode, omega) in (1..).zip(system.natural_frequencies()) {
                    natural_frequency(&mut lines, mode, scaled(*estimate, hertz(omega)));
                }
            }
            Unknown::Damping => lines.estimate("damping", &symbol, *estimate, ""),
            Unknown::Stiction => lines.estimate("stiction", &symbol, *estimate, ""),
            Unknown::Quantity(Quantity::ContactStiffness) => {
                lines.estimate("stiffness", &symbol, *estimate, "N/m");
            }
            _ => lines.estimate(&symbol, &symbol, *estimate, ""),
        }
    }
    lines.number("condition", "condition", found.condition, "");
    if 0 < found.differences {
        let count = found.differences as f64;
        lines.number("differences", "derivatives by differences", count, "");
    }
    if let Some(misfit) = found.misfit {
        lines.number("misfit", "misfit (1 is noise)", misfit, "");
    }
    for (index, (seen, point)) in observations.iter().zip(&found.explained).enumerate() {
        lines.recording = Some(index + 1);
        recording(&mut lines, system, (seen, point));
        let residuals = found.residuals(observations, index);
        motions(&mut lines, system, (seen, point), &residuals);
    }
    lines.all
}

/// Adds the table lines that describe one recording.
fn recording(
    lines: &mut QuantityLines,
    system: &System,
    (seen, point): (&Observation, &Explained),
) {
    let number = lines.recording.unwrap_or_default();
    let label = format!("recording {number}: frequency");
    lines.number("frequency_Hz", &label, seen.hertz, "Hz");
    let (what, dimension) = drive(system);
    let measure = Measure::si(system);
    let key = measure.name(&format!("{what}.amplitude"), dimension);
    let size = seen.load.amplitude();
    let label = format!("  {what} amplitude");
    lines.number(&key, &label, size, measure.unit(dimension));
    lines.number("r", "  r", point.r, "");
    lines.number("beta", "  beta", point.beta, "");
    lines.word("regime", "  regime", words::regime(point.regime));
}

/// Adds the table lines with the measured motions of one recording.
fn motions(
    lines: &mut QuantityLines,
    system: &System,
    (seen, point): (&Observation, &Explained),
    residuals: &[crate::Complex<f64>],
) {
    let each = seen.motions.iter().zip(point.model.iter().zip(residuals));
    for (datum, (model, residual)) in each {
        let mass = system.scene().masses.get(datum.mass);
        let name = mass.map_or("", |mass| mass.name.as_str());
        let (key, label) = match datum.harmonic {
            1 => (name.to_owned(), name.to_owned()),
            order => (format!("{name}.X{order}"), format!("{name} X_{order}")),
        };
        let (measured, computed) = (polar(datum.value), polar(*model));
        let both = [("measured", measured), ("computed", computed)];
        for (what, (amplitude, _)) in both {
            let label = format!("  {label}: amplitude {what}");
            lines.number(&format!("{key}.amplitude_{what}"), &label, amplitude, "");
        }
        for (what, (_, lag)) in both {
            let label = format!("  {label}: lag {what}");
            let key = format!("{key}.lag_{what}_deg");
            lines.number(&key, &label, lag.to_degrees(), "deg");
        }
        let label = format!("  {label}: residual over deviation");
        let over = residual.norm() / datum.deviation;
        lines.number(&format!("{key}.residual_over_deviation"), &label, over, "");
    }
}

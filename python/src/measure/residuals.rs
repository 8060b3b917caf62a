//! Compares each measured motion with that of the scene.

use super::observed::{Known, Observed};
use super::transmissibility::drive;
use crate::columns::{Columns, Words, cell};
use frictiongen::measure::{Datum, Explained, Identified, Observation};
use frictiongen::study::units::polar;
use frictiongen::study::{Load, words};
use frictiongen::{Complex, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// One motion at one frequency.
struct Line<'a> {
    place: usize,
    seen: &'a Observation,
    point: &'a Explained,
    datum: &'a Datum,
    model: Complex<f64>,
    residual: Complex<f64>,
    known: Known,
}

impl Line<'_> {
    /// Returns the residual over its deviation: of the complex value, of the amplitude or of the phase, whichever was
    /// measured.
    fn over_deviation(&self) -> f64 {
        let apart = match self.known {
            Known::Both => self.residual.norm(),
            Known::Amplitude => (self.datum.value.norm() - self.model.norm()).abs(),
            Known::Phase => polar(self.datum.value * self.model.conj()).1.abs(),
        };
        apart / self.datum.deviation
    }
}

/// Returns measured and computed motions as columns, with one row for each motion of each observation.
pub fn table<'py>(
    py: Python<'py>,
    system: &System,
    observed: &Observed,
    found: &Identified,
) -> PyResult<Bound<'py, PyDict>> {
    let mut lines = Vec::new();
    let each = observed.all.iter().zip(&observed.known);
    for (place, ((seen, known), point)) in each.zip(&found.explained).enumerate() {
        let residuals = found.residuals(&observed.all, place);
        let motions = seen.motions.iter().zip(&point.model).zip(residuals);
        lines.extend(motions.map(|((datum, model), residual)| Line {
            place,
            seen,
            point,
            datum,
            model: *model,
            residual,
            known: *known,
        }));
    }
    let mut columns = Columns::new(py, &[lines.len()]);
    let all = |of: &dyn Fn(&Line<'_>) -> Option<f64>| -> Vec<f64> {
        lines.iter().map(|line| cell(of(line))).collect()
    };
    let places = lines.iter().map(|line| line.place as i64 + 1);
    columns.counts("recording", places.collect())?;
    columns.numbers("frequency_Hz", all(&|line| Some(line.seen.hertz)))?;
    let (name, unit) = drive(system);
    columns.numbers(
        format!("{name}.amplitude_{unit}"),
        all(&|line| {
            let (Load::Base(size) | Load::Force(size)) = line.seen.load;
            Some(size)
        }),
    )?;
    columns.numbers("r", all(&|line| Some(line.point.r)))?;
    columns.numbers("beta", all(&|line| Some(line.point.beta)))?;
    let regimes = lines.iter().map(|line| words::regime(line.point.regime));
    columns.words("regime", regimes.collect::<Words>())?;
    let names = lines.iter().map(|line| {
        let mass = system.scene().masses.get(line.datum.mass);
        mass.map_or_else(String::new, |mass| mass.name.clone())
    });
    columns.words("of", names.collect::<Words>())?;
    let orders = lines.iter().map(|line| i64::from(line.datum.harmonic));
    columns.counts("harmonic", orders.collect())?;
    let sized = |line: &Line<'_>| (line.known != Known::Phase).then_some(());
    let turned = |line: &Line<'_>| (line.known != Known::Amplitude).then_some(());
    columns.numbers(
        "amplitude_measured",
        all(&|line| sized(line).map(|()| polar(line.datum.value).0)),
    )?;
    columns.numbers("amplitude_computed", all(&|line| Some(polar(line.model).0)))?;
    columns.numbers(
        "lag_measured_deg",
        all(&|line| turned(line).map(|()| polar(line.datum.value).1.to_degrees())),
    )?;
    columns.numbers(
        "lag_computed_deg",
        all(&|line| Some(polar(line.model).1.to_degrees())),
    )?;
    columns.numbers(
        "residual_over_deviation",
        all(&|line| Some(line.over_deviation())),
    )?;
    for (name, part) in [
        (
            "residual_real",
            (|value| value.re) as fn(Complex<f64>) -> f64,
        ),
        ("residual_imaginary", |value| value.im),
    ] {
        columns.numbers(
            name,
            all(&|line| {
                let both = line.known == Known::Both;
                both.then(|| part(line.residual) / line.datum.deviation)
            }),
        )?;
    }
    Ok(columns.done())
}

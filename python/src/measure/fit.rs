//! Fits a scene's parameters to a sweep without friction.

use super::estimate::{Interval, interval};
use crate::asked::numbers;
use crate::columns::Columns;
use crate::errors::{domain, measurement};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::measure::{SweepFit, SweepPoint};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A mass with its amplitudes over the excitation and, if they are known, their standard deviations.
type Swept<'py> = (String, Bound<'py, PyAny>, Option<Bound<'py, PyAny>>);

/// The single values, the points, and the fitted system.
type Answer<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>, NativeSystem);

/// Reads a row of numbers as long as the frequencies. If `gaps`, NaN marks a missing number.
fn row(argument: &str, given: &Bound<'_, PyAny>, count: usize, gaps: bool) -> PyResult<Vec<f64>> {
    let given = numbers(argument, given)?;
    if given.values.len() != count {
        return Err(domain(format_args!(
            "{argument}: {count} numbers are needed, one for each frequency, but these are {}",
            given.values.len()
        )));
    }
    for (index, value) in given.values.iter().enumerate() {
        let sound = 0.0 < *value && value.is_finite();
        if !(sound || gaps && value.is_nan()) {
            return Err(domain(format_args!(
                "{} is {value:?}: frequencies, transmissibilities and deviations must be above 0 and finite",
                given.place(argument, index)
            )));
        }
    }
    Ok(given.values)
}

/// Returns the points of a sweep in the order of its table.
fn points(
    system: &System,
    hertz: &Bound<'_, PyAny>,
    masses: Vec<Swept<'_>>,
    gaps: bool,
) -> PyResult<Vec<SweepPoint>> {
    let count = numbers("hz", hertz)?.values.len();
    let hertz = row("hz", hertz, count, false)?;
    let mut columns = Vec::new();
    for (name, amplitudes, deviations) in masses {
        let mass = match system.motion_named(&name) {
            Ok(frictiongen::Of::Mass(mass)) => mass,
            Ok(frictiongen::Of::Contact) => {
                return Err(domain("a sweep contains masses, not the contact"));
            }
            Err(error) => return Err(domain(error)),
        };
        let amplitudes = row(
            &format!("transmissibility[{name:?}]"),
            &amplitudes,
            count,
            gaps,
        )?;
        let deviations = deviations
            .map(|given| row(&format!("deviation[{name:?}]"), &given, count, gaps))
            .transpose()?;
        columns.push((mass, amplitudes, deviations));
    }
    let mut points = Vec::new();
    for (place, hertz) in hertz.into_iter().enumerate() {
        for (mass, amplitudes, deviations) in &columns {
            let at = |values: &Vec<f64>| values.get(place).copied().filter(|value| !value.is_nan());
            if let Some(amplitude) = at(amplitudes) {
                points.push(SweepPoint {
                    hertz,
                    mass: *mass,
                    amplitude,
                    deviation: deviations.as_ref().and_then(at),
                });
            }
        }
    }
    Ok(points)
}

fn answer<'py>(
    py: Python<'py>,
    system: &System,
    points: &[SweepPoint],
    (damping, source): (bool, Option<&str>),
) -> PyResult<Answer<'py>> {
    let found = without_lock(py, |_| system.fit_sweep(points, damping))?;
    let found = found.map_err(|error| measurement(py, source, &error))?;
    let once = PyDict::new(py);
    once.set_item("reference_Hz", interval(found.reference))?;
    let scene = system.scene();
    let masses = scene.masses.iter().skip(1).zip(&found.masses);
    let masses: Vec<(&str, Interval)> = masses
        .map(|(mass, ratio)| (mass.name.as_str(), interval(*ratio)))
        .collect();
    once.set_item("mass_ratios", masses)?;
    let springs = scene.springs.iter().skip(1).zip(&found.springs);
    let springs: Vec<(String, Interval)> = springs
        .map(|(spring, ratio)| {
            let (from, to) = (scene.node_name(spring.from), scene.node_name(spring.to));
            (format!("{from} - {to}"), interval(*ratio))
        })
        .collect();
    once.set_item("stiffness_ratios", springs)?;
    once.set_item("damping", found.damping.map(interval))?;
    let natural = found.natural.iter().copied().map(interval);
    once.set_item("natural_frequencies_Hz", natural.collect::<Vec<_>>())?;
    once.set_item("misfit", found.misfit)?;
    once.set_item("freedom", found.freedom)?;
    once.set_item("is_explained", found.is_explained())?;
    once.set_item("scatter", found.scatter)?;
    once.set_item("condition", found.condition)?;
    let columns = compared(py, system, points, &found)?;
    let fitted = NativeSystem {
        system: found.system,
    };
    Ok((once, columns, fitted))
}

/// Returns the measured and the computed amplitudes.
fn compared<'py>(
    py: Python<'py>,
    system: &System,
    points: &[SweepPoint],
    found: &SweepFit,
) -> PyResult<Bound<'py, PyDict>> {
    let mut columns = Columns::new(py, &[points.len()]);
    let all = |of: &dyn Fn(&SweepPoint) -> f64| points.iter().map(of).collect::<Vec<f64>>();
    columns.numbers("frequency_Hz", all(&|point| point.hertz))?;
    let masses = &system.scene().masses;
    let names = points.iter().map(|point| {
        let mass = masses.get(point.mass);
        mass.map_or_else(String::new, |mass| mass.name.clone())
    });
    columns.words("of", names.collect())?;
    columns.numbers("transmissibility", all(&|point| point.amplitude))?;
    columns.numbers(
        "deviation",
        all(&|point| point.deviation.unwrap_or(f64::NAN)),
    )?;
    columns.numbers("residual", found.residuals.clone())?;
    Ok(columns.done())
}

/// Fits a sweep given as arrays. If `gaps`, NaN marks a point that was not measured.
#[pyfunction]
pub fn fit<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    hertz: Bound<'py, PyAny>,
    masses: Vec<Swept<'py>>,
    gaps: bool,
    damping: bool,
) -> PyResult<Answer<'py>> {
    let system = &system.system;
    let points = points(system, &hertz, masses, gaps)?;
    answer(py, system, &points, (damping, None))
}

/// Fits a sweep given as the text of a table.
#[pyfunction]
pub fn fit_text<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    text: &str,
    source: Option<&str>,
    damping: bool,
) -> PyResult<Answer<'py>> {
    let system = &system.system;
    let points = SweepPoint::read(text, system).map_err(|error| measurement(py, source, &error))?;
    answer(py, system, &points, (damping, source))
}

//! Computes features of a scene's responses without a sweep: thresholds, invariant points, ranges and peaks.

use crate::asked::{
    FrequencyKeywords, FrequencyRange, FrictionKeywords, FrictionValues, LoadKeywords, Optional,
    measure, parts, setting,
};
use crate::columns::{NamedArrays, cell};
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::study::columns::{
    Column, FeatureLists, FeatureTable, FeatureVisitor, Measure, MovingPart, TableRow,
};
use frictiongen::study::{features::Sensed, sensitivity::Parameter};
use frictiongen::{Of, System};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::sync::Arc;

/// Largest number of frictions in one call of `features`. The command has the same limit.
const MOST_FRICTIONS: usize = 16;

/// Returns every list of features by name, such as peaks. Each list has its columns, and the derivatives of its numbers
/// with respect to every parameter. A scene with several contacts or dashpots has one list, `lines`.
#[pyfunction]
pub fn features<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: LoadKeywords<'py>,
    of: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let measure = measure::constant(system, &load)?;
    let band = FrequencyRange::of_or_usual(system, &frequency, &measure)?;
    let frictions = match friction {
        (None, None) => Vec::new(),
        given => FrictionValues::listed(&given, &measure)?.beta,
    };
    if MOST_FRICTIONS < frictions.len() {
        return Err(domain(format_args!(
            "at most {MOST_FRICTIONS} frictions are possible, because each has its own list"
        )));
    }
    let mut parts = parts(system, "of", of.as_ref())?;
    if system.scene().is_joined() {
        if !frictions.is_empty() {
            return Err(domain(
                "a scene with several `contacts` or `dampers` has no features at one friction; leave beta and friction out",
            ));
        }
        parts.retain(|part| of.is_some() || matches!(part.of, Of::Mass(_)));
        return joined(py, system, (measure, &band), parts);
    }
    if of.is_none() && !system.modal().on_moving_base {
        // A mass that rubs on a fixed support has the same motion as the contact. The answer therefore lists this
        // motion only once.
        let rubbing = system.modal().rubbing().map(Of::Mass);
        parts.retain(|part| Some(part.of) != rubbing);
    }
    let range = [band.from, band.to];
    let (owned, named) = (Arc::clone(system), parts.clone());
    let found = left_at_interrupt(py, move |_| {
        let features = owned.features(measure.load()).map_err(domain)?;
        FeatureLists::of(&features, &named, &frictions, range).map_err(domain)
    })??;
    let setting = setting(system, measure, band.unit(&measure), &parts);
    let mut lists = Lists {
        table: FeatureTable { setting },
        all: PyDict::new(py),
    };
    found.visit(&setting, &mut lists)?;
    Ok(lists.all)
}

/// Returns the features of a scene with several contacts or dashpots as one list, `lines`, without derivatives.
fn joined<'py>(
    py: Python<'py>,
    system: &Arc<System>,
    (measure, band): (Measure, &FrequencyRange),
    parts: Vec<MovingPart>,
) -> PyResult<Bound<'py, PyDict>> {
    let unit = band.unit(&measure);
    let range = [band.from, band.to];
    let (owned, named) = (Arc::clone(system), parts.clone());
    let rows = left_at_interrupt(py, move |_| {
        let setting = setting(&owned, measure, unit, &named);
        FeatureTable { setting }.joined_rows(range).map_err(domain)
    })??;
    let setting = setting(system, measure, unit, &parts);
    let mut lists = Lists {
        table: FeatureTable { setting },
        all: PyDict::new(py),
    };
    let columns = lists.table.columns(&rows);
    lists.list("lines", &columns, &rows)?;
    Ok(lists.all)
}

/// The lists of features for Python, by name. Each list has its columns, and the derivatives of its numbers.
struct Lists<'a, 'py> {
    table: FeatureTable<'a>,
    all: Bound<'py, PyDict>,
}

impl FeatureVisitor for Lists<'_, '_> {
    type Error = PyErr;

    fn list<R: TableRow>(
        &mut self,
        name: &'static str,
        columns: &[Column<'_, R>],
        rows: &[R],
    ) -> PyResult<()> {
        let mut arrays = NamedArrays::new(self.all.py(), &[rows.len()]);
        arrays.table(columns, rows)?;
        let derivatives = PyDict::new(self.all.py());
        for column in columns.iter().filter(|column| column.has_derivatives()) {
            derivatives.set_item(column.key(), self.derivatives(column, rows)?)?;
        }
        self.all.set_item(name, (arrays.done(), derivatives))
    }
}

impl<'py> Lists<'_, 'py> {
    /// Returns the parameters on which the numbers of a column depend. Two arrays follow each parameter: the
    /// derivatives, and the changes in % if the parameter increases by 1 %.
    fn derivatives<R>(&self, column: &Column<'_, R>, rows: &[R]) -> PyResult<Bound<'py, PyList>> {
        let py = self.all.py();
        let sensed: Vec<Option<&Sensed>> = rows.iter().map(|row| column.derivatives(row)).collect();
        let mut parameters: Vec<Parameter> = Vec::new();
        for slope in sensed.iter().flatten().flat_map(|sensed| &sensed.slopes) {
            if !parameters.contains(&slope.parameter) {
                parameters.push(slope.parameter);
            }
        }
        let array = |of: &dyn Fn(&Sensed) -> Option<f64>| {
            let values = sensed.iter().map(|sensed| cell(sensed.and_then(of)));
            PyArray1::from_vec(py, values.collect())
        };
        let all = PyList::empty(py);
        for parameter in parameters {
            let derivative = array(&|sensed| {
                let mut slopes = sensed.slopes.iter();
                let slope = slopes.find(|slope| slope.parameter == parameter)?;
                Some(slope.derivative)
            });
            let relative = array(&|sensed| sensed.relative(parameter));
            all.append((self.table.symbol(parameter), derivative, relative))?;
        }
        Ok(all)
    }
}

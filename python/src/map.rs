//! Maps over frequency and friction.

use crate::asked::{
    Frequencies, FrequencyArguments, FrictionArguments, Frictions, LoadArguments, Optional,
    check_size, measure, parts,
};
use crate::columns::{Columns, Words, cell, count};
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::Error;
use frictiongen::Limits;
use frictiongen::study::columns::Dimension;
use frictiongen::study::{MapPoint, MapRequest, words};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Computes the regime of the contact over frequency and friction.
#[pyfunction]
pub fn map<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyArguments<'py>,
    friction: FrictionArguments<'py>,
    load: LoadArguments<'py>,
    of: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let frequencies = Frequencies::of(system, &frequency, false)?;
    if let Some(index) = frequencies.r.iter().position(|r| r.is_infinite()) {
        return Err(domain(format_args!(
            "the frequency with the index {index} is infinite, but a map needs finite frequencies"
        )));
    }
    let measure = measure::of(system, &load)?;
    let frictions = Frictions::of(&friction, &measure)?;
    let parts = parts(system, "of", of.as_ref())?;
    check_size(
        frequencies.r.len().saturating_mul(frictions.beta.len()),
        11 + 2 * parts.len(),
    )?;
    let request = MapRequest {
        r: frequencies.r.clone(),
        beta: frictions.beta.clone(),
        of: parts.iter().map(|part| part.of).collect(),
    };
    let map = without_lock(py, |stop| system.map(&request, |_| stop.goes_on()))?.map_err(domain)?;

    let mut columns = Columns::new(py, &frequencies.shape());
    frequencies.put(&mut columns, system, &measure)?;
    let limit = |name: &str, read: fn(&Limits<f64>) -> f64, columns: &mut Columns<'_>| {
        let limits = map.columns.iter().map(|column| read(&column.limits));
        let limits = limits.map(|limit| cell(Some(measure.force(limit))));
        columns.numbers(measure.name(name, Dimension::Force), limits.collect())
    };
    limit("continuous_limit", |limits| limits.continuous, &mut columns)?;
    limit("sliding_limit", |limits| limits.sliding, &mut columns)?;
    columns.reshape(&frictions.shape());
    frictions.put(&mut columns)?;
    columns.reshape(&[frequencies.shape(), frictions.shape()].concat());

    let found = || map.points().map(|(_, _, found)| found);
    let pattern = |found: &Result<MapPoint, Error>| {
        found
            .as_ref()
            .map(|point| point.pattern)
            .map_err(|error| *error)
    };
    let regimes =
        found().map(|point| pattern(point).map_or("", |pattern| words::regime(pattern.regime)));
    columns.words("regime", regimes.collect::<Words>())?;
    columns.words(
        "region",
        found()
            .map(|point| words::region(pattern(point)))
            .collect::<Words>(),
    )?;
    // A motion that does not repeat has no counts.
    let counted = || found().map(|point| pattern(point).ok().filter(|pattern| 0 < pattern.period));
    columns.counts(
        "period",
        counted()
            .map(|of| count(of.map(|of| of.period as usize)))
            .collect(),
    )?;
    columns.counts(
        "stops",
        counted().map(|of| count(of.map(|of| of.stops))).collect(),
    )?;
    columns.counts(
        "reversals",
        counted()
            .map(|of| count(of.map(|of| of.reversals)))
            .collect(),
    )?;
    let fractions =
        found().map(|point| cell(point.as_ref().ok().map(|point| point.stuck_fraction)));
    columns.numbers("stuck_fraction", fractions.collect())?;
    let point = || found().map(|point| point.as_ref().ok());
    let sign = measure.sign();
    columns.numbers(
        measure.name("offset", Dimension::Length),
        point()
            .map(|point| cell(point.map(|point| measure.length(sign * point.offset))))
            .collect(),
    )?;
    columns.flags(
        "marginal",
        point()
            .map(|point| point.is_some_and(|point| point.marginal))
            .collect(),
    )?;
    columns.flags(
        "from_rest",
        point()
            .map(|point| point.is_some_and(|point| point.from_rest))
            .collect(),
    )?;
    for (place, part) in parts.iter().enumerate() {
        for what in ["amplitude", "centred"] {
            let sizes = point().map(|point| {
                let size = point.and_then(|point| {
                    let sizes = match what {
                        "amplitude" => &point.amplitudes,
                        _ => &point.centred,
                    };
                    sizes.get(place).copied()
                });
                cell(size.map(|size| measure.length(size)))
            });
            columns.numbers(
                measure.name(&format!("{}.{what}", part.name), Dimension::Length),
                sizes.collect(),
            )?;
        }
    }
    Ok(columns.done())
}

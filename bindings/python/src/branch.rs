//! Follows steady states along a parameter, and finds limit cycles.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, Measure,
    Optional, setting, start, whole,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::joined::{JoinedQuestion, motions};
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::System;
use frictiongen::study::InitialState;
use frictiongen::study::columns::{
    Along, BranchEndRow, FrequencyUnit, FrictionSetting, JoinedRow, JoinedTable,
};
use frictiongen::study::joined::{BranchRequest, JoinedError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat};
use std::sync::Arc;

/// Largest depth of branches that begin on other branches.
const MOST_DEPTH: u32 = 100;
/// Largest number of points on a branch.
const MOST_POINTS: u32 = 1_000_000;

/// The Python arguments `along` and `over`, and the depth, a flag for all states at the first value, and the largest
/// number of points.
type AlongKeywords<'py> = (
    String,
    (f64, f64),
    (Bound<'py, PyAny>, bool, Bound<'py, PyAny>),
);

/// Columns of the points, columns of the branches, and the symbol of the parameter with its unit.
type BranchAnswer<'py> = (
    Bound<'py, PyDict>,
    Bound<'py, PyDict>,
    (String, &'static str),
);

/// Branches that were found: the rows of all points, a row for each branch, and the symbol and the unit of the parameter.
struct Found {
    points: Vec<JoinedRow>,
    ends: Vec<BranchEndRow>,
    parameter: (String, &'static str),
}

/// Returns a copy of a value in the arguments of a quantity that varies. All other arguments must be missing.
fn varying<'py, const N: usize>(
    py: Python<'py>,
    (along, quantity): (&Along<'_>, &str),
    given: [(&str, Optional<'py>); N],
) -> PyResult<[Optional<'py>; N]> {
    if given.iter().any(|(_, value)| value.is_some()) {
        let names: Vec<&str> = given.iter().map(|(name, _)| *name).collect();
        return Err(domain(format_args!(
            "along: the {quantity} varies; leave {} out",
            names.join(", ")
        )));
    }
    let (first, _) = along.interval;
    Ok(given.map(|(name, _)| (along.name == name).then(|| PyFloat::new(py, first).into_any())))
}

/// Reads the operating point at the first value of the parameter.
fn question<'py>(
    py: Python<'py>,
    system: &Arc<System>,
    along: &Along<'_>,
    (frequency, friction): (FrequencyKeywords<'py>, FrictionKeywords<'py>),
    (load, of): (&DrivenKeywords<'py>, Option<&Bound<'py, PyAny>>),
) -> PyResult<JoinedQuestion> {
    let (mut frequency, mut friction) = (frequency, friction);
    if along.is_frequency() {
        let (r, hz, omega) = frequency;
        let given = [("r", r), ("hz", hz), ("omega", omega)];
        let [r, hz, omega] = varying(py, (along, "frequency"), given)?;
        frequency = (r, hz, omega);
    }
    if along.is_friction() {
        let (beta, force) = friction;
        let given = [("beta", beta), ("friction", force)];
        let [beta, force] = varying(py, (along, "friction"), given)?;
        friction = (beta, force);
    }
    let frequencies = FrequencyValues::of(system, &frequency, true)?;
    JoinedQuestion::of(system, frequencies, &friction, load, of)
}

/// Follows steady states, stable or not, along a parameter.
#[pyfunction]
pub fn branch<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    along: AlongKeywords<'py>,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
) -> PyResult<BranchAnswer<'py>> {
    let (name, interval, (depth, all_states, points)) = along;
    let (from, to) = interval;
    if !(from.is_finite() && to.is_finite() && from != to) {
        return Err(domain(format_args!(
            "over is ({from:?}, {to:?}): two finite numbers that differ are needed"
        )));
    }
    let along = Along {
        name: name.trim(),
        interval,
    };
    let switches = whole("switch", &depth, 0..=MOST_DEPTH)? as usize;
    let most = whole("points", &points, 1..=MOST_POINTS)? as usize;
    let given = (frequency, friction);
    let question = question(py, &system.system, &along, given, (&load, of.as_ref()))?;
    let point = (
        question.frequencies.only(&question.system)?,
        question.frictions.only()?,
    );
    let (owned, own_name) = (question.clone(), name.clone());
    let found = left_at_interrupt(py, move |_| {
        let along = Along {
            name: own_name.trim(),
            interval,
        };
        let joined = owned.system.joined()?;
        let table = owned.table(&joined);
        let request = BranchRequest {
            all_states,
            switches,
            most,
            ..along.request(&table, point.0, point.1)?
        };
        let branches = table.branches(&request)?;
        Ok(Found {
            ends: branches
                .iter()
                .map(|(branch, _)| BranchEndRow::of(branch))
                .collect(),
            points: branches.into_iter().flat_map(|(_, rows)| rows).collect(),
            parameter: (
                request.along.symbol(joined.scene(), &request.point),
                request.along.unit(&request.point),
            ),
        })
    })?;
    let found = found.map_err(|error: JoinedError| match error {
        JoinedError::UnknownParameter(..) => domain(format_args!("along: {error}")),
        _ => domain(error),
    })?;
    let joined = question.system.joined().map_err(domain)?;
    let table = question.table(&joined);
    let (symbol, unit) = found.parameter;
    let mut arrays = NamedArrays::new(py, &[found.points.len()]);
    arrays.table(&table.branch_columns((&symbol, unit)), &found.points)?;
    let mut ends = NamedArrays::new(py, &[found.ends.len()]);
    ends.table(&table.branch_end_columns(), &found.ends)?;
    Ok((arrays.done(), ends.done(), (symbol, unit)))
}

/// Finds the limit cycle that motion without a load reaches, at each friction force. Returns the columns of the cycles,
/// and the forces in N without a cycle.
#[pyfunction]
pub fn limit_cycle<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    friction: Bound<'py, PyAny>,
    start: Optional<'py>,
    of: Optional<'py>,
) -> PyResult<(Bound<'py, PyDict>, Vec<f64>)> {
    let mut system = Arc::clone(&system.system);
    let measure = Measure::si(&system);
    let frictions = FrictionValues::listed(&(None, Some(friction)), &measure)?.all();
    if let Some(given) = start
        && !start::is_rest(&given)?
    {
        let state = start::state(&given, &system, (None, 1.0))?;
        system = Arc::new(System::clone(&system).starting_from(InitialState::groups(state)));
    }
    let parts = motions(&system, of.as_ref())?;
    let (owned, own_parts) = (Arc::clone(&system), parts.clone());
    let found = left_at_interrupt(py, move |stop| {
        let joined = owned.joined()?;
        let table = JoinedTable {
            setting: setting(&owned, measure, FrequencyUnit::Hertz, &own_parts),
            joined: &joined,
            orders: None,
        };
        let found = frictions.into_iter().take_while(|_| stop.goes_on());
        let found = found.map(|friction| Ok((friction, table.cycle(friction)?)));
        found.collect::<Result<Vec<(FrictionSetting, Option<JoinedRow>)>, JoinedError>>()
    })?;
    let found = found.map_err(domain)?;
    let without = found.iter().filter(|(_, cycle)| cycle.is_none());
    let without = without.map(|(friction, _)| friction.force()).collect();
    let rows: Vec<JoinedRow> = found.into_iter().filter_map(|(_, cycle)| cycle).collect();
    let joined = system.joined().map_err(domain)?;
    let table = JoinedTable {
        setting: setting(&system, measure, FrequencyUnit::Hertz, &parts),
        joined: &joined,
        orders: None,
    };
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&table.cycle_columns(), &rows)?;
    Ok((arrays.done(), without))
}

//! Computes responses over a frequency range, with more points where a curve bends.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyRange, FrequencyValues, FrictionKeywords,
    FrictionValues, MOST_POINTS, MovingPart, Optional, check_size, driven, harmonics, one,
    quantities, setting, without,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::joined::JoinedQuestion;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::Of;
use frictiongen::study::columns::CurveTable;
use frictiongen::study::{
    curve::{CurveError, CurveRequest, CurveStart},
    words,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Python arguments of a curve: accuracy, largest step, highest order of harmonics, a flag for velocities and
/// accelerations, and initial states.
type Fineness<'py> = (
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    bool,
    Vec<String>,
);

/// Reads the initial states of the motions on a curve from Python: rest, or the state at a neighbouring frequency.
fn starts(names: &[String]) -> PyResult<Vec<CurveStart>> {
    let all = [CurveStart::Rest, CurveStart::Up, CurveStart::Down];
    let start = |name: &String| {
        let known = all.into_iter().find(|start| words::start(*start) == name);
        known.ok_or_else(|| {
            domain(format_args!(
                "start: `{name}` is none of \"rest\", \"up\" and \"down\""
            ))
        })
    };
    let starts: Vec<CurveStart> = names.iter().map(start).collect::<PyResult<_>>()?;
    if starts.is_empty() {
        return Err(domain(format_args!(
            "start: the list is empty; give rest, up or down"
        )));
    }
    Ok(starts)
}

/// Computes responses over a frequency range, one curve for each friction.
#[pyfunction]
pub fn curve<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
    fineness: Fineness<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let (accuracy, step, highest, rates, starts_of) = fineness;
    let starts = starts(&starts_of)?;
    if system.system.scene().has_joined_states() {
        without(&[
            (accuracy.is_some(), "accuracy"),
            (step.is_some(), "step"),
            (highest.is_some(), "harmonics"),
            (rates, "rates"),
            (starts != [CurveStart::Rest], "start=\"up\" or \"down\""),
        ])?;
        let frequencies = FrequencyValues::spread(&system.system, &frequency)?;
        let of = of.as_ref();
        return JoinedQuestion::of(&system.system, frequencies, &friction, &load, of)?.grid(py);
    }
    let band = FrequencyRange::of(&system.system, &frequency)?;
    let (measure, system) = driven(&system.system, &load)?;
    let system = &*system;
    let frictions = FrictionValues::listed(&friction, &measure)?;
    let parts: Vec<MovingPart> = quantities(system, "of", of.as_ref())?;
    let of: Vec<Of> = parts.iter().map(|part| part.of).collect();
    let mut request = CurveRequest::new(band.from, band.to, &of);
    if let Some(accuracy) = &accuracy {
        request.accuracy = one("accuracy", accuracy)?;
    }
    request.widest = step.map(|step| band.step(system, &step)).transpose()?;
    request.harmonics = (1..=harmonics(highest.as_ref())?).collect();
    request.rates = rates || parts.iter().any(MovingPart::has_rate);
    request.turned = measure.turns(Of::Contact);
    (request.rise, request.fall) = (measure.fall(), measure.fall());
    let table = CurveTable {
        setting: setting(system, measure, band.unit(&measure), &parts),
        starts: starts != [CurveStart::Rest],
        rates,
        orders: &request.harmonics,
    };
    let columns = table.columns();
    let frictions = frictions.all();
    // The refinement determines the number of points. Before the computation, the check therefore assumes 1000 points
    // for each curve.
    check_size(
        frictions.len().saturating_mul(1000 * starts.len()),
        columns.len(),
    )?;
    let found = without_lock(py, |stop| {
        let mut found = Vec::new();
        for friction in &frictions {
            if !stop.goes_on() || MOST_POINTS < found.len() {
                break;
            }
            // Each sweep computes its points in sequence. The code therefore runs several sweeps in parallel.
            let asked = starts.iter().map(|start| (friction.beta, *start));
            for curve in system.curves(&request, &asked.collect::<Vec<_>>())? {
                found.extend(table.rows(*friction, &curve));
            }
        }
        Ok::<_, CurveError>(found)
    })?
    .map_err(domain)?;
    check_size(found.len(), columns.len())?;
    let mut arrays = NamedArrays::new(py, &[found.len()]);
    arrays.table(&columns, &found)?;
    Ok(arrays.done())
}

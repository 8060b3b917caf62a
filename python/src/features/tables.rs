//! Lists of features as tables.

use super::found::{At, Found, Named};
use super::sheet::{Counted, Sheet};
use frictiongen::study::{
    Certainty, Crossing, InvariantPoint, Inversion, Measured, RegimeEnd, RegimeRange, ResonantPeak,
    words,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Columns of a list, and their derivatives with respect to every parameter.
pub type Table<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>);

/// Tables by their names.
pub type Tables<'py> = Vec<(&'static str, Table<'py>)>;

/// Returns the lists that do not depend on the friction.
pub fn whole<'py>(py: Python<'py>, counted: Counted<'_>, found: &Found) -> PyResult<Tables<'py>> {
    let modes: Vec<_> = (1..).zip(&found.resonances).collect();
    let mut resonances = Sheet::new(py, counted, &modes);
    resonances.counts("mode", |(mode, _)| *mode)?;
    resonances.places("", |(_, it)| Some(it.r))?;
    resonances.places_move("", |(_, it)| Some(&it.frequency))?;
    resonances.numbers("damping_ratio", |(_, it)| Some(it.damping_ratio))?;
    resonances.forces("threshold", |(_, it)| Some(it.threshold.as_ref()?.value))?;
    resonances.forces_move("threshold", |(_, it)| it.threshold.as_ref())?;
    resonances.forces("continuous_limit", |(_, it)| Some(it.continuous_limit))?;

    let mut held = Sheet::new(py, counted, &found.held);
    held.places("", |it| Some(it.r))?;
    held.places_move("", |it| Some(&it.frequency))?;
    held.numbers("damping_ratio", |it| Some(it.damping_ratio))?;
    held.flags("new", |it| it.new)?;
    held.forces("sliding_limit", |it| Some(it.sliding_limit))?;

    let mut ends = Sheet::new(py, counted, &found.ends);
    ends.numbers("r", |(r, _)| Some(*r))?;
    ends.forces("continuous_limit", |(_, it)| Some(it.continuous.value))?;
    ends.forces_move("continuous_limit", |(_, it)| Some(&it.continuous))?;
    ends.forces("sliding_limit", |(_, it)| Some(it.sliding.value))?;
    ends.forces_move("sliding_limit", |(_, it)| Some(&it.sliding))?;

    let mut antiresonances = Sheet::new(py, counted, &found.antiresonances);
    antiresonances.words("of", |zero| &zero.of)?;
    antiresonances.places("", |zero| Some(zero.it.r))?;
    antiresonances.places_move("", |zero| Some(&zero.it.frequency))?;
    Ok(vec![
        ("resonances", resonances.done()),
        ("held_resonances", held.done()),
        ("ends", ends.done()),
        ("antiresonances", antiresonances.done()),
        (
            "invariant_points",
            invariant(py, counted, &found.invariant)?,
        ),
        ("inversions", inversions(py, counted, &found.inversions)?),
    ])
}

fn invariant<'py>(
    py: Python<'py>,
    counted: Counted<'_>,
    found: &[Named<(Measured, InvariantPoint)>],
) -> PyResult<Table<'py>> {
    let mut sheet = Sheet::new(py, counted, found);
    sheet.words("of", |point| &point.of)?;
    sheet.words("measured", |point| words::measured(point.it.0))?;
    sheet.words("condition", |point| words::condition(&point.it.1))?;
    sheet.places("", |point| Some(point.it.1.r))?;
    sheet.places_move("", |point| Some(&point.it.1.frequency))?;
    sheet.lengths("amplitude", |point| Some(point.it.1.amplitude))?;
    sheet.forces("continuous_limit", |point| {
        Some(point.it.1.continuous_limit)
    })?;
    sheet.flags("simple", |point| point.it.1.simple)?;
    Ok(sheet.done())
}

fn inversions<'py>(
    py: Python<'py>,
    counted: Counted<'_>,
    found: &[Named<(Measured, Inversion)>],
) -> PyResult<Table<'py>> {
    let mut sheet = Sheet::new(py, counted, found);
    sheet.words("of", |range| &range.of)?;
    sheet.words("measured", |range| words::measured(range.it.0))?;
    sheet.places("", |range| Some(range.it.1.from))?;
    sheet.words("edge", |range| words::edge(range.it.1.from_edge))?;
    sheet.places("to_", |range| Some(range.it.1.to))?;
    sheet.words("to_edge", |range| words::edge(range.it.1.to_edge))?;
    Ok(sheet.done())
}

/// Returns the lists that depend on the friction.
pub fn of_frictions<'py>(
    py: Python<'py>,
    counted: Counted<'_>,
    found: &Found,
) -> PyResult<Tables<'py>> {
    let mut starts = Sheet::new(py, counted, &found.starts);
    starts.friction(|start| start.beta)?;
    starts.words("of", |start| &start.it.of)?;
    starts.flags("stuck", |start| start.it.it.is_none())?;
    starts.lengths("amplitude", |start| Some(start.it.it.as_ref()?.value))?;
    starts.lengths_move("amplitude", |start| start.it.it.as_ref())?;

    let mut sliding = Sheet::new(py, counted, &found.sliding);
    sliding.friction(|range| range.beta)?;
    sliding.places("", |range| Some(range.it.from))?;
    sliding.places_move("", |range| range.it.from_frequency.as_ref())?;
    sliding.places("to_", |range| Some(range.it.to))?;
    sliding.places_move("to_", |range| range.it.to_frequency.as_ref())?;
    Ok(vec![
        ("starts", starts.done()),
        ("sliding_ranges", sliding.done()),
        ("regimes", regimes(py, counted, &found.regimes)?),
        ("peaks", peaks(py, counted, &found.peaks)?),
        ("crossings", crossings(py, counted, &found.crossings)?),
    ])
}

fn regimes<'py>(
    py: Python<'py>,
    counted: Counted<'_>,
    found: &[At<(Certainty, RegimeRange)>],
) -> PyResult<Table<'py>> {
    let mut sheet = Sheet::new(py, counted, found);
    sheet.friction(|range| range.beta)?;
    sheet.words("regime", |range| words::regime(range.it.1.regime))?;
    sheet.places("", |range| Some(range.it.1.from))?;
    sheet.places("to_", |range| Some(range.it.1.to))?;
    sheet.places_move("to_", |range| match &range.it.1.end {
        RegimeEnd::Continuous(sensed) | RegimeEnd::Sliding(sensed) => Some(sensed),
        _ => None,
    })?;
    sheet.words("found", |range| words::certainty(range.it.0))?;
    Ok(sheet.done())
}

fn peaks<'py>(
    py: Python<'py>,
    counted: Counted<'_>,
    found: &[At<Named<ResonantPeak>>],
) -> PyResult<Table<'py>> {
    let mut sheet = Sheet::new(py, counted, found);
    sheet.friction(|peak| peak.beta)?;
    sheet.words("of", |peak| &peak.it.of)?;
    sheet.counts("mode", |peak| peak.it.it.mode + 1)?;
    sheet.places("resonance_", |peak| Some(peak.it.it.resonance))?;
    sheet.lengths("estimate", |peak| Some(peak.it.it.estimate.as_ref()?.value))?;
    sheet.lengths_move("estimate", |peak| peak.it.it.estimate.as_ref())?;
    sheet.places("", |peak| Some(peak.it.it.peak.as_ref()?.r))?;
    sheet.lengths("amplitude", |peak| {
        Some(peak.it.it.peak.as_ref()?.amplitude.value)
    })?;
    sheet.lengths_move("amplitude", |peak| {
        Some(&peak.it.it.peak.as_ref()?.amplitude)
    })?;
    sheet.words("regime", |peak| match &peak.it.it.peak {
        Some(found) => found.regime.map_or("unbounded", words::regime),
        None => "",
    })?;
    Ok(sheet.done())
}

fn crossings<'py>(
    py: Python<'py>,
    counted: Counted<'_>,
    found: &[At<Named<(f64, Crossing)>>],
) -> PyResult<Table<'py>> {
    let mut sheet = Sheet::new(py, counted, found);
    sheet.friction(|crossing| crossing.beta)?;
    let measure = counted.measure;
    let other = if measure.scale().is_some() {
        "other_friction_N"
    } else {
        "other_beta"
    };
    sheet.numbers(other, |crossing| Some(measure.force(crossing.it.it.0)))?;
    sheet.words("of", |crossing| &crossing.it.of)?;
    sheet.places("", |crossing| Some(crossing.it.it.1.r))?;
    sheet.places_move("", |crossing| Some(&crossing.it.it.1.frequency))?;
    sheet.lengths("amplitude", |crossing| Some(crossing.it.it.1.amplitude))?;
    Ok(sheet.done())
}

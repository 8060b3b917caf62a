//! Responses along frequency, with more points where a curve bends.

use crate::asked::{
    Band, FrequencyArguments, FrictionArguments, Frictions, LoadArguments, MOST_POINTS, Measure,
    Optional, Part, check_size, harmonics, one, parts,
};
use crate::columns::{Columns, Words, cell, count};
use crate::errors::domain;
use crate::motion::{self, Extent, Movement};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::{Curve, CurveError, CurvePoint, CurveRequest, CurveStart, words};
use frictiongen::{Error, Of};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A line of the answer: a point of a piece, or an end point of a gap.
struct Line {
    /// Index of the friction.
    friction: usize,
    start: CurveStart,
    r: f64,
    piece: Option<usize>,
    found: Result<CurvePoint, Error>,
}

/// Returns the lines of one curve, with ascending frequency.
fn lines(friction: usize, curve: Curve) -> Vec<Line> {
    let (start, mut lines) = (curve.start, Vec::new());
    for (piece, found) in (1..).zip(curve.pieces) {
        lines.extend(found.points.into_iter().map(|point| Line {
            friction,
            start,
            r: point.r,
            piece: Some(piece),
            found: Ok(point),
        }));
    }
    for gap in curve.gaps {
        let ends = [gap.from, gap.to].into_iter();
        lines.extend(
            ends.take(if gap.from < gap.to { 2 } else { 1 })
                .map(|r| Line {
                    friction,
                    start,
                    r,
                    piece: None,
                    found: Err(gap.reason),
                }),
        );
    }
    lines.sort_by(|a, b| a.r.total_cmp(&b.r));
    lines
}

/// Accuracy, largest step, highest harmonic, whether velocities are asked for, and the starts.
type Fineness<'py> = (
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    bool,
    Vec<String>,
);

/// Reads the starts of the motions of each curve.
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

/// Computes responses along frequency, one curve for each friction.
#[pyfunction]
pub fn curve<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyArguments<'py>,
    friction: FrictionArguments<'py>,
    load: LoadArguments<'py>,
    of: Optional<'py>,
    fineness: Fineness<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let (accuracy, step, highest, rates, starts_of) = fineness;
    let starts = starts(&starts_of)?;
    let system = &system.system;
    let band = Band::of(system, &frequency)?;
    let measure = Measure::of(system, &load)?;
    let frictions = Frictions::listed(&friction, &measure)?;
    let parts: Vec<Part> = parts(system, "of", of.as_ref())?;
    let of: Vec<Of> = parts.iter().map(|part| part.of).collect();
    let mut request = CurveRequest::new(band.from, band.to, &of);
    if let Some(accuracy) = &accuracy {
        request.accuracy = one("accuracy", accuracy)?;
    }
    request.widest = step.map(|step| band.step(system, &step)).transpose()?;
    request.harmonics = (1..=harmonics(highest.as_ref())?).collect();
    request.rates = rates;
    request.turned = measure.turns(Of::Contact);
    let extent = Extent {
        monoharmonic: false,
        rates,
        orders: &request.harmonics,
    };
    // The number of points is not known before the refinement.
    check_size(
        frictions.beta.len().saturating_mul(1000 * starts.len()),
        11 + parts.len() * extent.numbers(),
    )?;
    let found = without_lock(py, |stop| {
        let mut found = Vec::new();
        for (place, beta) in frictions.beta.iter().enumerate() {
            if !stop.goes_on() || MOST_POINTS < found.len() {
                break;
            }
            // A sweep goes from point to point, so that several sweeps run in parallel.
            let asked: Vec<_> = starts.iter().map(|start| (*beta, *start)).collect();
            for curve in system.curves(&request, &asked)? {
                found.extend(lines(place, curve));
            }
        }
        Ok::<_, CurveError>(found)
    })?
    .map_err(domain)?;
    check_size(found.len(), 11 + parts.len() * extent.numbers())?;

    let points = || found.iter().map(|line| line.found.as_ref().ok());
    let mut columns = Columns::new(py, &[found.len()]);
    let places: Vec<usize> = found.iter().map(|line| line.friction).collect();
    frictions.put_places(&mut columns, &places)?;
    band.put(
        &mut columns,
        (system, &measure),
        found.iter().map(|line| line.r).collect(),
    )?;
    if starts != [CurveStart::Rest] {
        columns.words(
            "start",
            found
                .iter()
                .map(|line| words::start(line.start))
                .collect::<Words>(),
        )?;
    }
    columns.counts(
        "piece",
        found.iter().map(|line| count(line.piece)).collect(),
    )?;
    let regimes = points().map(|point| point.map_or("", |point| words::regime(point.regime)));
    columns.words("regime", regimes.collect::<Words>())?;
    columns.words(
        "answer",
        found
            .iter()
            .map(|line| words::on_curve(line.found.as_ref().map_err(|error| *error)))
            .collect::<Words>(),
    )?;
    columns.counts(
        "stops",
        points()
            .map(|point| count(point.map(|point| point.stops)))
            .collect(),
    )?;
    columns.counts(
        "period",
        points()
            .map(|point| count(point.map(|point| point.period as usize)))
            .collect(),
    )?;
    let omegas: Vec<f64> = found
        .iter()
        .map(|line| system.angular_frequency(line.r))
        .collect();
    let force =
        |point: Option<&CurvePoint>| cell(point.map(|point| measure.force(point.contact_force)));
    columns.numbers(
        measure.name("contact_force", "_N"),
        points().map(force).collect(),
    )?;
    let work = points().zip(&omegas);
    let work = work
        .map(|(point, omega)| cell(point.map(|point| measure.power(point.friction_work, *omega))));
    let name = if measure.scale().is_some() {
        "friction_power_W"
    } else {
        "friction_work"
    };
    columns.numbers(name, work.collect())?;
    let sign = measure.sign();
    let offset =
        |point: Option<&CurvePoint>| cell(point.map(|point| measure.length(sign * point.offset)));
    columns.numbers(measure.name("offset", "_m"), points().map(offset).collect())?;
    columns.flags(
        "marginal",
        points()
            .map(|point| point.is_some_and(|point| point.marginal))
            .collect(),
    )?;
    columns.flags(
        "from_rest",
        points()
            .map(|point| point.is_some_and(|point| point.from_rest))
            .collect(),
    )?;
    for (place, part) in parts.iter().enumerate() {
        let movements = points().zip(&omegas).map(|(point, omega)| {
            let movement = point.and_then(|point| point.movements.get(place));
            let movement = movement.map(|movement| Movement {
                swing: Some(movement.swing),
                centred: Some(movement.centred),
                fundamental_phase: movement.fundamental_phase,
                monoharmonic: None,
                rates: movement.rates,
                harmonics: movement.harmonics.clone(),
            });
            (movement.unwrap_or_default(), *omega)
        });
        let movements: Vec<_> = movements.collect();
        motion::put(&mut columns, (&part.name, &measure), extent, &movements)?;
    }
    Ok(columns.done())
}

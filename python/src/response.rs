//! The response over frequency and friction, in every regime.

use crate::asked::{
    Frequencies, FrequencyArguments, FrictionArguments, Frictions, LoadArguments, Optional, Part,
    check_size, harmonics, measure, parts,
};
use crate::columns::{Columns, Words, cell};
use crate::errors::domain;
use crate::motion::{self, Extent, Movement};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::columns::Dimension;
use frictiongen::study::words;
use frictiongen::{OutOfDomain, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

/// The question at every point.
struct Question<'a> {
    system: &'a System,
    measure: &'a crate::asked::Measure,
    parts: &'a [Part],
    orders: &'a [u32],
}

/// The response at one point.
struct Point {
    regime: &'static str,
    margin: f64,
    answer: &'static str,
    offset: Option<f64>,
    marginal: bool,
    from_rest: bool,
    movements: Vec<Movement>,
}

impl Question<'_> {
    /// Computes the points at one frequency.
    fn column(&self, r: f64, frictions: &[f64]) -> Result<Vec<Point>, OutOfDomain> {
        let at = self.system.at(r)?;
        // One search for the limits serves all β.
        let limits = at.limits();
        let point = |beta: &f64| {
            let margin = limits.margin(*beta)?;
            Ok(match at.response(*beta) {
                Ok(response) => {
                    let movements = self.parts.iter();
                    let movements = movements.map(|part| {
                        let mut movement = Movement::of(&response, part, self.orders, self.measure);
                        if r.is_infinite() {
                            movement.settle();
                        }
                        movement
                    });
                    Point {
                        regime: words::regime(response.regime()),
                        margin,
                        answer: words::answer(&response),
                        offset: Some(response.offset()),
                        marginal: response.is_marginal(),
                        from_rest: response.is_from_rest(),
                        movements: movements.collect(),
                    }
                }
                Err(error) => Point {
                    regime: words::regime_without(error),
                    margin,
                    answer: words::no_answer(error),
                    offset: None,
                    marginal: false,
                    from_rest: false,
                    movements: vec![Movement::default(); self.parts.len()],
                },
            })
        };
        frictions.iter().map(point).collect()
    }
}

/// Computes the response over frequency and friction.
#[pyfunction]
pub fn response<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyArguments<'py>,
    friction: FrictionArguments<'py>,
    load: LoadArguments<'py>,
    of: Optional<'py>,
    highest: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let frequencies = Frequencies::of(system, &frequency, false)?;
    let measure = measure::of(system, &load)?;
    let frictions = Frictions::of(&friction, &measure)?;
    let parts = parts(system, "of", of.as_ref())?;
    let orders: Vec<u32> = (1..=harmonics(highest.as_ref())?).step_by(2).collect();
    let extent = Extent {
        monoharmonic: true,
        rates: false,
        orders: &orders,
    };
    let points = frequencies.r.len().saturating_mul(frictions.beta.len());
    check_size(points, 7 + parts.len() * extent.numbers())?;
    let question = Question {
        system,
        measure: &measure,
        parts: &parts,
        orders: &orders,
    };
    let found = without_lock(py, |stop| {
        let ratios = frequencies.r.par_iter().with_max_len(16);
        let found = ratios.map(|r| {
            if stop.goes_on() {
                question.column(*r, &frictions.beta)
            } else {
                Ok(Vec::new())
            }
        });
        found.collect::<Result<Vec<Vec<Point>>, OutOfDomain>>()
    })?
    .map_err(domain)?;
    let mut found: Vec<Point> = found.into_iter().flatten().collect();

    let mut columns = Columns::new(py, &frequencies.shape());
    frequencies.put(&mut columns, system, &measure)?;
    columns.reshape(&frictions.shape());
    frictions.put(&mut columns)?;
    columns.reshape(&[frequencies.shape(), frictions.shape()].concat());
    columns.words("regime", found.iter().map(|point| point.regime).collect())?;
    columns.numbers(
        "margin",
        found.iter().map(|point| cell(Some(point.margin))).collect(),
    )?;
    columns.words(
        "answer",
        found.iter().map(|point| point.answer).collect::<Words>(),
    )?;
    let sign = measure.sign();
    let offset = |point: &Point| cell(point.offset.map(|offset| measure.length(sign * offset)));
    columns.numbers(
        measure.name("offset", Dimension::Length),
        found.iter().map(offset).collect(),
    )?;
    columns.flags(
        "marginal",
        found.iter().map(|point| point.marginal).collect(),
    )?;
    columns.flags(
        "from_rest",
        found.iter().map(|point| point.from_rest).collect(),
    )?;
    for (place, part) in parts.iter().enumerate() {
        let movements = found
            .iter_mut()
            .filter_map(|point| point.movements.get_mut(place));
        let movements: Vec<_> = movements
            .map(|movement| (std::mem::take(movement), f64::NAN))
            .collect();
        motion::put(&mut columns, (&part.name, &measure), extent, &movements)?;
    }
    Ok(columns.done())
}

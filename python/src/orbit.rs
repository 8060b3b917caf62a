//! The steady state at one point, stops included.

use crate::asked::{
    Frequencies, FrequencyArguments, FrictionArguments, Frictions, LoadArguments, Measure,
    Optional, harmonics, parts,
};
use crate::columns::{Columns, Words, cell, count};
use crate::errors::domain;
use crate::motion::{self, Extent, Movement};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::words;
use frictiongen::{Complex, NoOrbit, Of};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// What there is of a steady state.
struct Steady {
    state: &'static str,
    symmetry: &'static str,
    period: Option<usize>,
    stops: Option<usize>,
    reversals: Option<usize>,
    stuck_fraction: f64,
    sticking: Vec<(f64, f64)>,
    multipliers: Vec<Complex<f64>>,
    movements: Vec<Movement>,
}

/// The steady state from rest at one frequency and one friction.
#[pyfunction]
pub fn orbit<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyArguments<'py>,
    friction: FrictionArguments<'py>,
    load: LoadArguments<'py>,
    of: Optional<'py>,
    highest: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let frequencies = Frequencies::of(system, &frequency, true)?;
    let measure = Measure::of(system, &load)?;
    let frictions = Frictions::of(&friction, &measure)?;
    let (r, (beta, _)) = (frequencies.only()?, frictions.only()?);
    let parts = parts(system, "of", of.as_ref())?;
    let orders: Vec<u32> = match highest {
        None => Vec::new(),
        highest => (0..=harmonics(highest.as_ref())?).collect(),
    };
    let (regime, found) = without_lock(py, |_| {
        let at = system.at(r)?;
        let regime = match at.response(beta) {
            Ok(response) => words::regime(response.regime()),
            Err(error) => words::regime_without(error),
        };
        let orbit = match at.orbit_or_last_cycles(beta) {
            Ok(orbit) => orbit,
            Err(NoOrbit::OutOfDomain(error)) => return Err(error),
            Err(error) => return Ok((regime, Err(words::reason(error)))),
        };
        let movements = parts.iter().map(|part| match part.of {
            Of::Contact => {
                let mut movement = Movement::of_orbit(&orbit.contact(), &orders);
                if measure.turns(part.of) {
                    movement.turn(Some(orbit.reversed_contact_phase()));
                }
                movement
            }
            Of::Mass(index) => {
                let motion = orbit.mass_at(index);
                motion.map_or_else(Movement::default, |motion| {
                    Movement::of_orbit(&motion, &orders)
                })
            }
        });
        let counted = orbit.is_settled();
        Ok((
            regime,
            Ok(Steady {
                state: words::state(&orbit),
                symmetry: match (counted, orbit.is_symmetric()) {
                    (false, _) => "",
                    (true, true) => "symmetric",
                    (true, false) => "asymmetric",
                },
                period: counted.then(|| orbit.period() as usize),
                stops: counted.then(|| orbit.stops()),
                reversals: counted.then(|| orbit.reversals()),
                stuck_fraction: orbit.stuck_fraction(),
                sticking: orbit.sticking_intervals().collect(),
                multipliers: orbit.multipliers().to_vec(),
                movements: movements.collect(),
            }),
        ))
    })?
    .map_err(domain)?;

    let mut columns = Columns::new(py, &[]);
    frequencies.put(&mut columns, system, &measure)?;
    frictions.put(&mut columns)?;
    columns.words("regime", Words::from_iter([regime]))?;
    let state = found
        .as_ref()
        .map_or_else(|reason| *reason, |steady| steady.state);
    let steady = found.as_ref().ok();
    columns.words("state", Words::from_iter([state]))?;
    columns.words(
        "symmetry",
        Words::from_iter([steady.map_or("", |steady| steady.symmetry)]),
    )?;
    columns.counts(
        "period",
        vec![count(steady.and_then(|steady| steady.period))],
    )?;
    columns.counts("stops", vec![count(steady.and_then(|steady| steady.stops))])?;
    columns.counts(
        "reversals",
        vec![count(steady.and_then(|steady| steady.reversals))],
    )?;
    columns.numbers(
        "stuck_fraction",
        vec![cell(steady.map(|steady| steady.stuck_fraction))],
    )?;
    let tells = frequencies.tell_hertz(&measure);
    let seconds = |angle: f64| angle / system.angular_frequency(r);
    if tells {
        let lengths = steady.map(|steady| steady.sticking.iter().map(|(_, length)| *length));
        let longest = lengths.and_then(|lengths| lengths.reduce(f64::max));
        columns.numbers("longest_stop_s", vec![cell(longest.map(seconds))])?;
    }
    let moduli = steady.map(|steady| {
        steady
            .multipliers
            .iter()
            .map(|value| value.re.hypot(value.im))
    });
    let largest = moduli.and_then(|moduli| moduli.reduce(f64::max));
    columns.numbers("largest_multiplier", vec![cell(largest)])?;
    let extent = Extent {
        monoharmonic: false,
        rates: false,
        orders: &orders,
    };
    for (place, part) in parts.iter().enumerate() {
        let movement = steady
            .and_then(|steady| steady.movements.get(place))
            .cloned();
        let movements = [(movement.unwrap_or_default(), f64::NAN)];
        motion::put(&mut columns, (&part.name, &measure), extent, &movements)?;
    }
    let (multipliers, sticking) = found.map_or_else(
        |_| (Vec::new(), Vec::new()),
        |steady| (steady.multipliers, steady.sticking),
    );
    columns.reshape(&[multipliers.len()]);
    columns.complex("multipliers", multipliers)?;
    columns.reshape(&[sticking.len(), 2]);
    let ends = sticking
        .into_iter()
        .flat_map(|(start, length)| [start, length]);
    let ends: Vec<f64> = ends.collect();
    if tells {
        let ends = ends.iter().map(|angle| seconds(*angle));
        columns.numbers("sticking_intervals_s", ends.collect())?;
    }
    columns.numbers("sticking_intervals", ends)?;
    Ok(columns.done())
}

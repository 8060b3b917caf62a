//! The steady state at one point, with its stops.

use crate::asked::{
    Frequencies, FrequencyArguments, FrictionArguments, Frictions, LoadArguments, Optional, Part,
    harmonics, measure, parts,
};
use crate::columns::{Columns, Words, cell, count};
use crate::errors::domain;
use crate::motion::{self, Extent, Movement};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::columns::Dimension;
use frictiongen::study::{SystemAt, SystemOrbit, words};
use frictiongen::{Complex, NoOrbit, Of, OutOfDomain, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Data of a steady state.
struct Steady {
    regime: &'static str,
    state: &'static str,
    symmetry: &'static str,
    period: Option<usize>,
    stops: Option<usize>,
    reversals: Option<usize>,
    stuck_fraction: f64,
    offset: f64,
    marginal: bool,
    from_rest: bool,
    sticking: Vec<(f64, f64)>,
    multipliers: Vec<Complex<f64>>,
    movements: Vec<Movement>,
}

/// A question at one frequency and one friction.
struct Question<'a> {
    system: &'a System,
    frequencies: Frequencies,
    frictions: Frictions,
    measure: crate::asked::Measure,
    parts: Vec<Part>,
    orders: Vec<u32>,
}

/// A steady state, or the regime and the reason why there is none.
type Found = Result<Steady, [&'static str; 2]>;

impl<'a> Question<'a> {
    fn of<'py>(
        system: &'a System,
        frequency: &FrequencyArguments<'py>,
        friction: &FrictionArguments<'py>,
        load: &LoadArguments<'py>,
        of: Option<&Bound<'py, PyAny>>,
        highest: Optional<'py>,
    ) -> PyResult<Self> {
        let measure = measure::of(system, load)?;
        Ok(Self {
            system,
            frequencies: Frequencies::of(system, frequency, true)?,
            frictions: Frictions::of(friction, &measure)?,
            measure,
            parts: parts(system, "of", of)?,
            orders: match highest {
                None => Vec::new(),
                highest => (0..=harmonics(highest.as_ref())?).collect(),
            },
        })
    }

    fn steady(&self, at: &SystemAt<'_>, orbit: &SystemOrbit<'_>) -> Steady {
        let movements = self.parts.iter().map(|part| match part.of {
            Of::Contact => {
                let mut movement = Movement::of_orbit(&orbit.contact(), &self.orders);
                if self.measure.turns(part.of) {
                    movement.turn(Some(orbit.reversed_contact_phase()));
                }
                movement
            }
            Of::Mass(index) => {
                let motion = orbit.mass_at(index);
                motion.map_or_else(Movement::default, |motion| {
                    Movement::of_orbit(&motion, &self.orders)
                })
            }
        });
        let counted = orbit.is_settled();
        Steady {
            regime: words::regime(at.regime_of(orbit)),
            state: words::state(orbit),
            symmetry: match (counted, orbit.is_symmetric()) {
                (false, _) => "",
                (true, true) => "symmetric",
                (true, false) => "asymmetric",
            },
            period: counted.then(|| orbit.period() as usize),
            stops: counted.then(|| orbit.stops()),
            reversals: counted.then(|| orbit.reversals()),
            stuck_fraction: orbit.stuck_fraction(),
            offset: orbit.offset(),
            marginal: orbit.is_marginal(),
            from_rest: orbit.is_from_rest(),
            sticking: orbit.sticking_intervals().collect(),
            multipliers: orbit.multipliers().to_vec(),
            movements: movements.collect(),
        }
    }

    /// Returns the steady state that motion from rest reaches.
    fn found_from_rest(&self, at: &SystemAt<'_>, beta: f64) -> Result<Found, OutOfDomain> {
        match at.orbit_or_last_cycles(beta) {
            Ok(orbit) => {
                let mut steady = self.steady(at, &orbit);
                // Where the motion does not settle, `response` answers with another state, whose regime is written
                // here.
                if !orbit.is_settled()
                    && let Ok(response) = at.response(beta)
                {
                    steady.regime = words::regime(response.regime());
                }
                Ok(Ok(steady))
            }
            Err(NoOrbit::OutOfDomain(error)) => Err(error),
            Err(error) => {
                let regime = match at.response(beta) {
                    Ok(response) => words::regime(response.regime()),
                    Err(error) => words::regime_without(error),
                };
                Ok(Err([regime, words::reason(error)]))
            }
        }
    }

    fn columns<'py>(&self, py: Python<'py>, found: Found) -> PyResult<Bound<'py, PyDict>> {
        let (r, measure, system) = (self.frequencies.only()?, &self.measure, self.system);
        let (frequencies, frictions) = (&self.frequencies, &self.frictions);
        let (parts, orders) = (&self.parts, &self.orders);
        let [regime, state] = match &found {
            Ok(steady) => [steady.regime, steady.state],
            Err(words) => *words,
        };
        let mut columns = Columns::new(py, &[]);
        frequencies.put(&mut columns, system, measure)?;
        frictions.put(&mut columns)?;
        columns.words("regime", Words::from_iter([regime]))?;
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
        let tells = frequencies.tell_hertz(measure);
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
        let offset = steady.map(|steady| measure.length(measure.sign() * steady.offset));
        columns.numbers(
            measure.name("offset", Dimension::Length),
            vec![cell(offset)],
        )?;
        columns.flags(
            "marginal",
            vec![steady.is_some_and(|steady| steady.marginal)],
        )?;
        columns.flags(
            "from_rest",
            vec![steady.is_some_and(|steady| steady.from_rest)],
        )?;
        let extent = Extent {
            monoharmonic: false,
            rates: false,
            orders,
        };
        for (place, part) in parts.iter().enumerate() {
            let movement = steady
                .and_then(|steady| steady.movements.get(place))
                .cloned();
            let movements = [(movement.unwrap_or_default(), f64::NAN)];
            motion::put(&mut columns, (&part.name, measure), extent, &movements)?;
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
}

/// Computes the steady state that motion from rest reaches, at one frequency and one friction.
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
    let question = Question::of(system, &frequency, &friction, &load, of.as_ref(), highest)?;
    let (r, (beta, _)) = (question.frequencies.only()?, question.frictions.only()?);
    let found =
        without_lock(py, |_| question.found_from_rest(&system.at(r)?, beta))?.map_err(domain)?;
    question.columns(py, found)
}

/// Computes every steady state that can be found at one frequency and one friction.
#[pyfunction]
pub fn states<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyArguments<'py>,
    friction: FrictionArguments<'py>,
    load: LoadArguments<'py>,
    of: Optional<'py>,
    highest: Optional<'py>,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let system = &system.system;
    let question = Question::of(system, &frequency, &friction, &load, of.as_ref(), highest)?;
    let (r, (beta, _)) = (question.frequencies.only()?, question.frictions.only()?);
    let found = without_lock(py, |_| {
        let at = system.at(r)?;
        let states = at.states(beta)?;
        let states = states.map(|orbit| question.steady(&at, &orbit));
        Ok::<_, OutOfDomain>(states.collect::<Vec<_>>())
    })?
    .map_err(domain)?;
    let found = found.into_iter();
    found
        .map(|steady| question.columns(py, Ok(steady)))
        .collect()
}

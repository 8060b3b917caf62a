//! Both limits over frequency.

use crate::asked::{Frequencies, FrequencyArguments, LoadArguments, check_size, measure};
use crate::columns::{Columns, cell};
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::{Stop, without_lock};
use frictiongen::{OutOfDomain, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

/// Names of the limits, the same as those of the command.
const NAMES: [&str; 4] = [
    "continuous_limit",
    "continuous_limit_without_search",
    "continuous_limit_per_mode",
    "sliding_limit",
];

/// Number of limits that are computed between two checks for an interrupt.
const PORTION: usize = 4096;

/// The requested limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// The limits β_lim and β*_lim, exact.
    Exact,
    /// Also the estimates of β_lim.
    All,
    /// The limit β*_lim, and β_lim with S at its start value τ → 0.
    WithoutSearch,
}

impl Kind {
    /// Returns the indices of its columns.
    fn places(self) -> &'static [usize] {
        match self {
            Self::Exact => &[0, 3],
            Self::All => &[0, 1, 2, 3],
            Self::WithoutSearch => &[1, 3],
        }
    }

    /// Returns the limits by their indices, with NaN for a limit that the caller did not request.
    fn at(self, system: &System, r: f64) -> Result<[f64; 4], OutOfDomain> {
        let none = f64::NAN;
        Ok(match self {
            Self::WithoutSearch => {
                let limits = system.limits_without_search(r)?;
                [none, limits.continuous, none, limits.sliding]
            }
            Self::Exact => {
                let limits = system.at(r)?.limits();
                [limits.continuous, none, none, limits.sliding]
            }
            Self::All => {
                let at = system.at(r)?;
                let limits = at.limits();
                [
                    limits.continuous,
                    at.continuous_limit_without_search(),
                    at.continuous_limit_per_mode(),
                    limits.sliding,
                ]
            }
        })
    }
}

fn all(
    system: &System,
    ratios: &[f64],
    kind: Kind,
    stop: &Stop,
) -> Result<Vec<[f64; 4]>, OutOfDomain> {
    let portions = ratios.par_chunks(PORTION).map(|portion| {
        if !stop.goes_on() {
            return Ok(Vec::new());
        }
        portion.iter().map(|r| kind.at(system, *r)).collect()
    });
    let portions: Vec<Vec<[f64; 4]>> = portions.collect::<Result<_, OutOfDomain>>()?;
    Ok(portions.into_iter().flatten().collect())
}

/// Computes both limits over frequency: exact, with their estimates, or without search.
#[pyfunction]
pub fn limits<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyArguments<'py>,
    load: LoadArguments<'py>,
    estimates: bool,
    search: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let frequencies = Frequencies::of(system, &frequency, false)?;
    let measure = measure::of(system, &load)?;
    let kind = match (search, estimates) {
        (false, _) => Kind::WithoutSearch,
        (true, false) => Kind::Exact,
        (true, true) => Kind::All,
    };
    check_size(frequencies.r.len(), 2 * NAMES.len())?;
    let found =
        without_lock(py, |stop| all(system, &frequencies.r, kind, stop))?.map_err(domain)?;
    let mut columns = Columns::new(py, &frequencies.shape());
    frequencies.put(&mut columns, system, &measure)?;
    let column = |place: usize, convert: &dyn Fn(f64) -> f64| -> Vec<f64> {
        let values = found.iter().filter_map(|limits| limits.get(place));
        values.map(|limit| cell(Some(convert(*limit)))).collect()
    };
    let named = || {
        kind.places()
            .iter()
            .filter_map(|place| Some((*place, *NAMES.get(*place)?)))
    };
    if let Some(scale) = measure.scale() {
        for (place, name) in named() {
            columns.numbers(
                format!("{name}_N"),
                column(place, &|limit| scale.friction(limit)),
            )?;
        }
    }
    for (place, name) in named() {
        columns.numbers(name, column(place, &|limit| limit))?;
    }
    Ok(columns.done())
}

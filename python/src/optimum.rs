//! The friction that keeps the largest amplitude over a band smallest.

use crate::asked::{Band, FrequencyArguments, LoadArguments, measure, part};
use crate::columns::{Columns, Words, cell};
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::columns::Dimension;
use frictiongen::study::{FrequencyBand, OperatingPoint, OptimumRequest, words};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Finds the best friction. Returns it with the peaks, the tolerances and the sensitivities.
#[pyfunction]
pub fn optimum<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    of: Bound<'py, PyAny>,
    frequency: FrequencyArguments<'py>,
    load: LoadArguments<'py>,
) -> PyResult<[Bound<'py, PyDict>; 4]> {
    let system = &system.system;
    let part = part(system, "of", &of)?;
    let band = Band::of(system, &frequency)?;
    let measure = measure::of(system, &load)?;
    let request = OptimumRequest {
        of: part.of,
        band: FrequencyBand::Ratio(band.from, band.to),
        load: measure.load(),
    };
    let optimum = without_lock(py, |_| system.optimum(&request))?.map_err(domain)?;

    let mut once = Columns::new(py, &[]);
    if let Some(scale) = measure.scale() {
        once.numbers("friction_N", vec![scale.friction(optimum.beta)])?;
    }
    once.numbers("beta", vec![optimum.beta])?;
    let length = |name: &str| measure.name(name, Dimension::Length);
    once.numbers(length("amplitude"), vec![measure.length(optimum.amplitude)])?;
    once.words("kind", Words::from_iter([words::kind(optimum.kind)]))?;
    once.words("end", Words::from_iter([words::end(optimum.end)]))?;
    let [from, to] = optimum.bracket;
    for (name, beta) in [
        ("bracket_from", from),
        ("bracket_to", to),
        ("unbounded_to", optimum.unbounded_to),
        ("free_of_sticking", optimum.free_of_sticking),
        ("locked", optimum.locked),
    ] {
        once.numbers(
            measure.name(name, Dimension::Force),
            vec![measure.force(beta)],
        )?;
    }
    once.numbers(
        length("without_friction"),
        vec![measure.length(optimum.without_friction)],
    )?;
    once.numbers(
        length("with_contact_locked"),
        vec![measure.length(optimum.with_contact_locked)],
    )?;
    once.other("evaluations", optimum.evaluations)?;
    once.other("unanswered", optimum.unanswered)?;

    let mut peaks = Columns::new(py, &[optimum.peaks.len()]);
    let all = || optimum.peaks.iter();
    band.put(
        &mut peaks,
        (system, &measure),
        all().map(|peak| peak.r).collect(),
    )?;
    peaks.numbers(
        length("amplitude"),
        all().map(|peak| measure.length(peak.amplitude)).collect(),
    )?;
    peaks.words(
        "regime",
        all()
            .map(|peak| words::regime(peak.regime))
            .collect::<Words>(),
    )?;
    peaks.flags("at_end", all().map(|peak| peak.at_end).collect())?;

    let mut tolerances = Columns::new(py, &[optimum.tolerances.len()]);
    let all = || optimum.tolerances.iter();
    tolerances.numbers("excess", all().map(|tolerance| tolerance.excess).collect())?;
    let name = if measure.scale().is_some() {
        "friction"
    } else {
        "beta"
    };
    tolerances.numbers(
        measure.name(&format!("{name}_from"), Dimension::Force),
        all()
            .map(|tolerance| measure.force(tolerance.from))
            .collect(),
    )?;
    tolerances.numbers(
        measure.name(&format!("{name}_to"), Dimension::Force),
        all().map(|tolerance| measure.force(tolerance.to)).collect(),
    )?;

    let mut sensitivities = Columns::new(py, &[optimum.sensitivities.len()]);
    if let Some(load) = measure.load() {
        // Names and units do not depend on the operating point, so that any point will do.
        let point = OperatingPoint::Physical {
            hertz: 1.0,
            friction: 1.0,
            load,
        };
        let symbols = optimum.sensitivities.iter();
        let symbols = symbols.map(|(parameter, _)| parameter.symbol(system.scene(), &point));
        sensitivities.words("parameter", symbols.collect::<Words>())?;
        let relative = optimum
            .sensitivities
            .iter()
            .map(|(_, relative)| cell(Some(*relative)));
        sensitivities.numbers("relative", relative.collect())?;
    }
    Ok([
        once.done(),
        peaks.done(),
        tolerances.done(),
        sensitivities.done(),
    ])
}

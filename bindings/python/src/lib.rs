//! `frictiongen._native`: the functions that the Python package calls, with one file for each group of functions.
//!
//! This crate contains no mechanics. `asked` converts Python arguments to numbers. `frictiongen::System` computes the
//! answers, and `work` releases Python's global lock during the computation. `columns` returns the answers as arrays
//! by name. Names, units and words of the answers are those of the library's tables (`frictiongen::study::columns`).
//! The Python classes in `frictiongen/` call these functions.
#![forbid(unsafe_code)]

mod asked;
mod branch;
mod columns;
mod curve;
mod errors;
mod features;
mod follow;
mod joined;
mod limits;
mod map;
mod measure;
mod optimum;
mod orbit;
mod periodic;
mod response;
mod sensitivities;
mod simulate;
mod step;
mod system;
mod work;

/// The compiled module of the package.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use crate::branch::{branch, limit_cycle};
    #[pymodule_export]
    use crate::curve::curve;
    #[pymodule_export]
    use crate::errors::{DomainError, MeasureError, SceneError};
    #[pymodule_export]
    use crate::features::features;
    #[pymodule_export]
    use crate::follow::NativeStepState;
    #[pymodule_export]
    use crate::joined::by_contact;
    #[pymodule_export]
    use crate::limits::limits;
    #[pymodule_export]
    use crate::map::map;
    #[pymodule_export]
    use crate::measure::decay::free_decay;
    #[pymodule_export]
    use crate::measure::drive::{drive, drive_peaks};
    #[pymodule_export]
    use crate::measure::fit::{fit, fit_motion, fit_text};
    #[pymodule_export]
    use crate::measure::identify::identify;
    #[pymodule_export]
    use crate::measure::recording::NativeRecording;
    #[pymodule_export]
    use crate::measure::spectrum::response_spectrum;
    #[pymodule_export]
    use crate::measure::transmissibility::transmissibility;
    #[pymodule_export]
    use crate::optimum::optimum;
    #[pymodule_export]
    use crate::orbit::{orbit, states};
    #[pymodule_export]
    use crate::periodic::periodic;
    #[pymodule_export]
    use crate::response::response;
    #[pymodule_export]
    use crate::sensitivities::sensitivities;
    #[pymodule_export]
    use crate::simulate::simulate;
    #[pymodule_export]
    use crate::step::step;
    #[pymodule_export]
    use crate::system::NativeSystem;
}

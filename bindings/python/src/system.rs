//! Creates a system from a scene description, and returns the data of the system.

use crate::errors::{domain, scene};
use frictiongen::System;
use frictiongen::scalar::Dd;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyList;
use std::sync::Arc;

/// A scene with its modal analysis.
#[pyclass(frozen, module = "frictiongen._native", name = "System")]
pub struct NativeSystem {
    /// The system, as a type of the Rust library. It is shared, because a computation may continue after its Python
    /// call has ended.
    pub system: Arc<System>,
}

impl From<System> for NativeSystem {
    fn from(system: System) -> Self {
        Self {
            system: Arc::new(system),
        }
    }
}

#[pymethods]
impl NativeSystem {
    /// Reads a scene description.
    #[new]
    fn new(py: Python<'_>, text: &str) -> PyResult<Self> {
        match py.detach(|| text.parse::<System>()) {
            Ok(system) => Ok(system.into()),
            Err(diagnostics) => Err(scene(py, &diagnostics)),
        }
    }

    /// Returns the scene of the system as a description.
    fn description(&self) -> String {
        self.system.description()
    }

    /// Returns true if both systems have equal scenes.
    fn equals(&self, other: &Self) -> bool {
        self.system.scene() == other.system.scene()
    }

    /// Returns the system with other values of some numbers. A symbol selects each number, as in the lists of
    /// derivatives.
    fn with_values(&self, py: Python<'_>, values: Vec<(String, f64)>) -> PyResult<Self> {
        py.detach(|| {
            let mut system = System::clone(&self.system);
            for (symbol, value) in values {
                let tunable = system.tunable_named(&symbol).map_err(domain)?;
                let changed = system.with_value(tunable, value);
                system = changed.map_err(|error| domain(format_args!("{symbol}: {error}")))?;
            }
            Ok(system.into())
        })
    }

    /// Returns the names of the masses, in the order of the scene description.
    #[getter]
    fn masses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let masses = self.system.scene().masses.iter();
        PyList::new(
            py,
            masses.map(|mass| mass.name.as_str()).collect::<Vec<_>>(),
        )
    }

    /// Returns the values of the masses, kg.
    #[getter]
    fn mass_values<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let masses = self.system.scene().masses.iter();
        PyArray1::from_vec(py, masses.map(|mass| mass.value).collect())
    }

    /// Returns the springs, each with the names of its two nodes and its stiffness in N/m.
    #[getter]
    fn springs(&self) -> Vec<(String, String, f64)> {
        let scene = self.system.scene();
        let name = |node| scene.node_name(node).to_owned();
        let springs = scene.springs.iter();
        springs
            .map(|spring| (name(spring.from), name(spring.to), spring.stiffness))
            .collect()
    }

    /// Returns the contacts, each with its name and the names of the two nodes that rub on each other.
    #[getter]
    fn contacts(&self) -> Vec<(String, String, String)> {
        let scene = self.system.scene();
        let node = |node| scene.node_name(node).to_owned();
        let contacts = scene.named_contacts().into_iter();
        contacts
            .map(|contact| {
                let sides = contact.sides;
                (contact.name, node(sides.from), node(sides.to))
            })
            .collect()
    }

    /// Returns the names of the two nodes between which friction acts.
    #[getter]
    fn contact(&self) -> (String, String) {
        let scene = self.system.scene();
        let contact = scene.contact;
        (
            scene.node_name(contact.from).to_owned(),
            scene.node_name(contact.to).to_owned(),
        )
    }

    /// Returns the name of the mass on which the force acts. Returns `None` if the base moves instead.
    #[getter]
    fn driven_mass(&self) -> Option<String> {
        match self.system.scene().excitation {
            frictiongen::study::scene::Excitation::Force(index) => self
                .system
                .scene()
                .masses
                .get(index)
                .map(|mass| mass.name.clone()),
            _ => None,
        }
    }

    /// Returns true if the solver for several contacts computes the steady states of the scene.
    #[getter]
    fn is_joined(&self) -> bool {
        self.system.scene().has_joined_states()
    }

    /// Returns the undamped natural frequencies, rad/s.
    #[getter]
    fn natural_frequencies<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.system.natural_frequencies())
    }

    /// Returns the frequency ratios of the undamped resonances.
    #[getter]
    fn resonances<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.system.resonances())
    }

    /// Returns the damping ratio ζ of each mode.
    #[getter]
    fn damping_ratios<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let ratios = self.system.modal().damping_ratios.iter();
        PyArray1::from_vec(py, ratios.map(|ratio: &Dd| ratio.hi).collect())
    }

    /// Returns the mode shapes, with one row for each mode and one column for each mass.
    #[getter]
    fn mode_shapes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(PyArray2::from_vec2(py, &self.system.mode_shapes())?)
    }

    /// Converts a frequency in Hz to the frequency ratio r.
    fn frequency_ratio_at_hertz(&self, hertz: f64) -> f64 {
        self.system.frequency_ratio_at_hertz(hertz)
    }

    /// Converts a frequency ratio r to Hz.
    fn hertz(&self, r: f64) -> f64 {
        self.system.hertz(r)
    }
}
